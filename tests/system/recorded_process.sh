#!/usr/bin/env bash
# Replay is the live process: what Debian's own lcm-logger hears of a live advisor, replayed, gives the recorded
# advice and grids bit for bit; with the machine's clock and with log time, and from the middle of a run.
#   recorded_process.sh ADVISOR SIM LCM_LOGGER SOURCE_DIR
# Run it under tests/support/with_loopback_multicast.sh.
set -euo pipefail
advisor=$1 sim=$2 logger=$3 source=$4
hull=$source/sim/hulls/s175.hull.toml
port=$((20000 + $$ % 20000)) # of this run alone
url="udpm://239.255.76.67:$port?ttl=0"
work=$(mktemp -d)
advisor_pid='' logger_pid=''
cleanup() {
  for pid in $advisor_pid $logger_pid; do kill -9 "$pid" 2>/dev/null || true; done
  rm -rf "$work"
}
trap cleanup EXIT
fail() {
  echo "FAILED: $*" >&2
  cat "$work"/*.journal "$work"/*.err >&2 2>/dev/null || true
  exit 1
}

start_advisor() { # start_advisor NAME [OPTION ...]; returns when it listens
  local journal=$work/$1.journal
  shift
  "$advisor" --hull "$hull" --ensemble-per-cycle 1 --url "$url" "$@" 2>"$journal" &
  advisor_pid=$!
  for _ in $(seq 600); do
    grep -q '^quickstrip-advisor' "$journal" && return
    kill -0 "$advisor_pid" 2>/dev/null || fail "the advisor did not start"
    sleep 0.1
  done
  fail "the advisor does not listen"
}

start_logger() { # start_logger LOG; returns when it hears: a channel of nobody's until then
  "$logger" --quiet --force --lcm-url="$url" --flush-interval=50 "$1" >/dev/null 2>"$work/logger.err" &
  logger_pid=$!
  for _ in $(seq 200); do
    printf 'LC02\0\0\0\1PROBE\0.' >"/dev/udp/239.255.76.67/$port" || true
    [ -s "$1" ] && return
    sleep 0.05
  done
  fail "lcm-logger hears nothing"
}

stop() { # stop PID: as from the keyboard
  kill -INT "$1"
  wait "$1" 2>/dev/null || true
}

check_recorded() { # check_recorded LOG LEAST: replays it and compares
  "$sim" replay "$1" --hull "$hull" --out "$1.again" 2>"$1.err" || fail "the replay of $(basename "$1") differs"
  local line
  line=$(grep 'reproduced bit for bit' "$1.err") || fail "nothing is said of the recorded advice"
  echo "$(basename "$1"): $line"
  # By the digests too, which the messages carry themselves: every one recorded, none missing, none else.
  for log in "$1" "$1.again"; do
    "$sim" story "$log" --csv | tail -n +2 | awk -F, '{ print $1, $NF }' >"$log.digests"
  done
  tail -n "$(wc -l <"$1.again.digests")" "$1.digests" | diff - "$1.again.digests" >/dev/null ||
    fail "digests of $(basename "$1") differ"
  [ "$(wc -l <"$1.again.digests")" -ge "$2" ] || fail "fewer than $2 advice messages"
}

sea_of_two_spectra() { # sea_of_two_spectra FIRST SECOND: the storm's highest two, at other times
  local highest
  sed -n 1,3p "$source/sim/storms/dorian_41010.sea"
  highest=$(grep -n '^hour 2019-09-04T12:40' "$source/sim/storms/dorian_41010.sea" | cut -d: -f1)
  sed -n "$highest,$((highest + 11))p" "$source/sim/storms/dorian_41010.sea" |
    awk -v first="$1" -v second="$2" '/^hour/ { $2 = ++n == 1 ? first : second } { print }'
}

utc() { date -u -d "@$1" +%Y-%m-%dT%H:%M:%SZ; }

voyage() { # voyage START TURN END: seconds since the epoch
  printf 'schema = 1\nname = "test"\nend_utc = %s\n' "$(utc "$3")"
  printf '[[leg]]\nfrom_utc = %s\nheading_deg = 75.0\nspeed_kn = 16.0\n' "$(utc "$1")"
  printf '[[leg]]\nfrom_utc = %s\nheading_deg = 110.0\nspeed_kn = 12.0\n' "$(utc "$2")"
}

send_now() { # send_now SECONDS: inputs of now, by the machine's clock; another course half-way, another sea later
  local now
  now=$(($(date +%s) + 1))
  voyage "$now" $((now + $1 / 2)) $((now + $1)) >"$work/now.voyage.toml"
  sea_of_two_spectra "$(utc "$now")" "$(utc $((now + $1 * 2 / 3)))" >"$work/now.sea"
  "$sim" log --sea "$work/now.sea" --voyage "$work/now.voyage.toml" --own-ship-period-s 0.7 --out "$work/now.in"
  "$sim" replay "$work/now.in" --publish --speed 1 --url "$url" 2>"$work/publish.err"
  sleep 1
}

# The machine's clock: a cycle each 0.4 s whatever comes; the ages are the live ones.
start_advisor system --clock system --cycle-s 0.4
start_logger "$work/system.log"
send_now 9
stop "$logger_pid"
check_recorded "$work/system.log" 6
grep -q 'without advice' "$work/system.log.err" || fail "no figures"

# Begun in the middle of a run: until the inputs that it holds have been sent again, what the advisor says rests on
# what the log does not have.
start_logger "$work/middle.log"
send_now 6
stop "$logger_pid"
logger_pid=
check_recorded "$work/middle.log" 3
stop "$advisor_pid"
advisor_pid=

# Log time: one cycle for each QS_TIME.
start_advisor log --clock log --cycle-s 3600
start_logger "$work/log.log"
start=$(date -u -d 2019-09-02T00:00:00Z +%s)
voyage "$start" $((start + 9000)) $((start + 21600)) >"$work/short.voyage.toml"
"$sim" log --sea "$source/sim/storms/dorian_41010.sea" --voyage "$work/short.voyage.toml" --out "$work/short.in"
"$sim" replay "$work/short.in" --publish --url "$url" 2>"$work/publish.err"
sleep 0.5
stop "$logger_pid"
logger_pid=
stop "$advisor_pid"
advisor_pid=
check_recorded "$work/log.log" 6

# It can fail: another method gives other advice, the first difference is named; follow does not compare.
code=0
"$sim" replay "$work/log.log" --hull "$hull" --method modified 2>"$work/other.err" || code=$?
[ "$code" = 1 ] || fail "another method: exit $code, not 1"
grep -q 'first difference: cycle' "$work/other.err" || fail "the first difference is not named"
"$sim" replay "$work/log.log" --hull "$hull" --method modified --recorded follow 2>/dev/null ||
  fail "--recorded follow compares"
echo "recorded process: replay is the live process"
