#!/usr/bin/env bash
# The real advisor over udpm://, driven by log time: advice arrives and is that of a replay of the same log;
# nonsense packets are refused and do not stop it; killed and started again it has its inputs back.
#   live_process.sh ADVISOR SIM SOURCE_DIR
# Run it under tests/support/with_loopback_multicast.sh.
set -euo pipefail
advisor=$1 sim=$2 source=$3
work=$(mktemp -d)
pid=
cleanup() {
  [ -z "$pid" ] || kill -9 "$pid" 2>/dev/null || true
  rm -rf "$work"
}
trap cleanup EXIT
fail() {
  echo "FAILED: $*" >&2
  cat "$work"/journal* >&2 2>/dev/null || true
  exit 1
}

start_advisor() {  # start_advisor JOURNAL [OPTION ...]; returns when it listens
  local journal=$1
  shift
  # One member a cycle: under a sanitizer a whole ensemble takes longer than the replay waits for an answer.
  "$advisor" --hull "$source/sim/hulls/s175.hull.toml" --clock log --cycle-s 3600 --state "$work/state.log" \
    --ensemble-per-cycle 1 \
    "$@" 2>"$journal" &
  pid=$!
  for _ in $(seq 300); do
    grep -q '^quickstrip-advisor' "$journal" && return
    kill -0 "$pid" 2>/dev/null || fail "the advisor did not start"
    sleep 0.1
  done
  fail "the advisor does not listen"
}

digests() {  # of each advice of a log
  "$sim" story "$1" --csv | tail -n +2 | awk -F, '{ print $1, $NF }'
}

cat >"$work/short.voyage.toml" <<'VOYAGE'
schema = 1
name = "six hours"
end_utc = 2019-09-02T06:00:00Z
[[leg]]
from_utc = 2019-09-02T00:00:00Z
heading_deg = 75.0
speed_kn = 16.0
VOYAGE
"$sim" log --sea "$source/sim/storms/dorian_41010.sea" --voyage "$work/short.voyage.toml" --out "$work/in.log"
"$sim" replay "$work/in.log" --hull "$source/sim/hulls/s175.hull.toml" --out "$work/replayed.log"

start_advisor "$work/journal1"
"$sim" replay "$work/in.log" --publish --out "$work/live.log"
digests "$work/replayed.log" >"$work/replayed"
digests "$work/live.log" >"$work/live"
[ "$(wc -l <"$work/live")" -ge 6 ] || fail "fewer than six advices came"
diff "$work/replayed" "$work/live" || fail "live and replay differ"

# Not LCM at all; LCM with a body that is not an own_ship_t; LCM of a type cut short.
for i in $(seq 20); do
  printf 'nonsense %d' "$i" >/dev/udp/239.255.76.67/7667
  printf 'LC02\0\0\0\1QS_OWN_SHIP\0garbage %d' "$i" >/dev/udp/239.255.76.67/7667
  printf 'LC02\0\0\0\1QS_WAVE_SPECTRUM\0' >/dev/udp/239.255.76.67/7667
done
"$sim" replay "$work/in.log" --publish --out "$work/again.log"
kill -0 "$pid" 2>/dev/null || fail "nonsense ended the advisor"
grep -q 'a message was refused' "$work/journal1" || fail "nonsense was not counted"
[ "$(digests "$work/again.log" | wc -l)" -ge 6 ] || fail "no advice after nonsense"

sleep 0.5 # the keeper looks five times a second
kill -9 "$pid"
wait "$pid" 2>/dev/null || true
start_advisor "$work/journal2"
grep -q '2 inputs restored' "$work/journal2" || fail "the last inputs were not restored"
kill -TERM "$pid"
wait "$pid" || fail "SIGTERM ended it with $?, not 0"
! grep -q 'limits changed' "$work"/journal* || fail "limits changed, and nobody did it"
start_advisor "$work/journal3" --limits "$source/firmware/profiles/quickstrip_cargo.limits.toml" --author "2nd mate"
grep -q 'limits changed by 2nd mate: "NORDFORSK 1987, merchant ships" -> "Quickstrip cargo"' "$work/journal3" ||
  fail "a change of limits was not told"
kill -TERM "$pid"
code=0
wait "$pid" || code=$?
[ "$code" = 0 ] || fail "SIGTERM ended it with $code, not 0"
pid=
echo "live process: as it should be"
