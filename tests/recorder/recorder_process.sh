#!/usr/bin/env bash
# Any moment can be replayed: a live advisor recorded into segments of seconds. A segment alone holds every input that
# its advice rests on, and gives its grids bit for bit; with the segments before it, which hold what the advisor
# remembers, its advice too. And the same of a recorder that was killed without warning.
#   recorder_process.sh ADVISOR SIM RECORDER SOURCE_DIR
# Run it under tests/support/with_loopback_multicast.sh.
set -euo pipefail
advisor=$1 sim=$2 recorder=$3 source=$4
hull=$source/sim/hulls/s175.hull.toml
port=$((20000 + $$ % 20000)) # of this run alone
url="udpm://239.255.76.67:$port?ttl=0"
work=$(mktemp -d)
pids=''
cleanup() {
  for pid in $pids; do kill -9 "$pid" 2>/dev/null || true; done
  rm -rf "$work"
}
trap cleanup EXIT
fail() {
  echo "FAILED: $*" >&2
  cat "$work"/*.err >&2 2>/dev/null || true
  exit 1
}
wait_for() { # wait_for FILE WORDS
  for _ in $(seq 600); do
    grep -q "$2" "$1" 2>/dev/null && return
    sleep 0.05
  done
  fail "$1: no $2"
}

start_advisor() { # start_advisor NAME
  "$advisor" --hull "$hull" --ensemble-per-cycle 1 --url "$url" --cycle-s 0.4 2>"$work/$1.err" &
  advisor_pid=$!
  pids="$pids $advisor_pid"
  wait_for "$work/$1.err" '^quickstrip-advisor'
}

start_recorder() { # start_recorder FOLDER
  mkdir "$1"
  "$recorder" --folder "$1" --url "$url" --segment-min 0.07 --segment-mb 5 --quota-mb 20 --flush-s 0.2 2>"$1.err" &
  recorder_pid=$!
  pids="$pids $recorder_pid"
  wait_for "$1.err" '^quickstrip-recorder'
}

utc() { date -u -d "@$1" +%Y-%m-%dT%H:%M:%SZ; }
send_now() { # send_now SECONDS: inputs of now by the machine's clock, another course half-way
  local now
  now=$(($(date +%s) + 1))
  printf 'schema = 1\nname = "test"\nend_utc = %s\n' "$(utc $((now + $1)))" >"$work/now.voyage.toml"
  printf '[[leg]]\nfrom_utc = %s\nheading_deg = 75.0\nspeed_kn = 16.0\n' "$(utc "$now")" >>"$work/now.voyage.toml"
  printf '[[leg]]\nfrom_utc = %s\nheading_deg = 110.0\nspeed_kn = 12.0\n' "$(utc $((now + $1 / 2)))" \
    >>"$work/now.voyage.toml"
  local highest
  highest=$(grep -n '^hour 2019-09-04T12:40' "$source/sim/storms/dorian_41010.sea" | cut -d: -f1)
  { sed -n 1,3p "$source/sim/storms/dorian_41010.sea"
    sed -n "$highest,$((highest + 5))p" "$source/sim/storms/dorian_41010.sea" |
      awk -v at="$(utc "$now")" '/^hour/ { $2 = at } { print }'; } >"$work/now.sea"
  # Far enough apart that a cycle under a sanitizer is not overtaken by two of them: a segment holds the last two.
  "$sim" log --sea "$work/now.sea" --voyage "$work/now.voyage.toml" --own-ship-period-s 1.5 --out "$work/now.in"
  "$sim" replay "$work/now.in" --publish --speed 1 --url "$url" 2>"$work/publish.err"
}

check() { # check NAME LOG ...: everything in it that is advice is repeated, and rests on nothing from before it
  local name=$1
  shift
  "$sim" replay "$@" --hull "$hull" 2>"$work/$name.err" || fail "the replay of $name differs"
  grep 'reproduced bit for bit' "$work/$name.err" | sed "s/^/$name: /"
  ! grep -q 'rest on inputs from before' "$work/$name.err" || fail "$name does not hold what its advice rests on"
}

check_alone() { # check_alone NAME LOG: the grids, and that nothing rests on inputs from before
  "$sim" replay "$2" --hull "$hull" 2>"$work/$1.err" || true
  local line grids
  line=$(grep 'reproduced bit for bit' "$work/$1.err") || fail "nothing of $1 could be repeated"
  echo "$1: $line"
  ! grep -q 'rest on inputs from before' "$work/$1.err" || fail "$1 does not hold what its advice rests on"
  grids=$(sed -E 's/.*bit for bit, ([0-9]+) of ([0-9]+) grids.*/\1 \2/' <<<"$line")
  [ "${grids% *}" = "${grids#* }" ] && [ "${grids% *}" -ge 3 ] || fail "grids of $1: $grids"
}

start_recorder "$work/whole"
start_advisor first
send_now 14
kill -INT "$recorder_pid"
wait "$recorder_pid" || fail "SIGINT ended the recorder with $?"
segments=("$work"/whole/*.log)
[ "${#segments[@]}" -ge 3 ] || fail "only ${#segments[@]} segments"
middle=$((${#segments[@]} / 2))
check_alone middle "${segments[$middle]}"
check_alone last_but_one "${segments[-2]}"
check up_to_the_middle "${segments[@]:0:$((middle + 1))}"
check all "$work/whole"
kill -INT "$advisor_pid"
wait "$advisor_pid" || fail "the advisor ended with $?"

start_recorder "$work/cut"
start_advisor second
send_now 6
kill -9 "$recorder_pid"
wait "$recorder_pid" 2>/dev/null || true
check killed "$work/cut"
echo "recorder process: any moment is the live run"
