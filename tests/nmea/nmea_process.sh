#!/usr/bin/env bash
# quickstrip-nmea as a process: the real ship's record becomes a log that quickstrip-sim reads; a flood of malformed
# lines on standard input stops no good one; what is wrong is said in one line.
#   nmea_process.sh NMEA SIM SOURCE_DIR
set -euo pipefail
nmea=$1 sim=$2 source=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "FAILED: $*" >&2
  cat "$work"/*.err >&2 2>/dev/null || true
  exit 1
}

record=$source/tests/golden/nbp1406_s330_2014-08-01.nmea
"$nmea" --file "$record" --clock record --speed max --window-min 3 --out "$work/ship.log" 2>"$work/ship.err"
grep -q 'lines: 900 taken, 540 not used; refused 2: 2 bad time' "$work/ship.err" || fail "the record's counts"
"$sim" inspect "$work/ship.log" >"$work/ship.txt"
grep -q '^QS_OWN_SHIP  *1[78][0-9] ' "$work/ship.txt" || fail "no own ship each second"
grep -q '^QS_MOTION' "$work/ship.txt" || fail "no motion"
! grep -q 'damaged' "$work/ship.txt" || fail "the log is damaged"

# 50,000 malformed lines, and a good pair after each thousand.
awk 'BEGIN { for (i = 0; i < 50000; ++i) { printf "$HEHDT,%d.0,T*00x\r\n", i % 360
       if (i % 1000 == 999) printf "$HEHDT,100.0,T*2E\r\n$VWVHW,,,,,8.0,N,,*20\r\n" } }' >"$work/flood"
"$nmea" --file - --out "$work/flood.log" <"$work/flood" 2>"$work/flood.err"
grep -q '50100 lines: 100 taken, 0 not used; refused 50000: 50000 checksum' "$work/flood.err" || fail "the flood"
[ "$(wc -l <"$work/flood.err")" -le 2 ] || fail "a line for bad sentences"

expect() { # expect CODE WORDS OPTION ...
  local code=0 want=$1 words=$2
  shift 2
  "$nmea" "$@" >/dev/null 2>"$work/wrong.err" || code=$?
  [ "$code" = "$want" ] || fail "$*: exit $code, not $want"
  grep -q -- "$words" "$work/wrong.err" || fail "$*: not said: $words"
}
expect 2 'one of --udp' --out "$work/none.log"
expect 2 'GP,HE' --file "$record" --talker gp
expect 1 'PORT@ADDRESS' --udp 99999
expect 1 'cannot be written\|No such file' --file "$record" --out /nowhere/at/all.log
[ ! -e "$work/none.log" ] || fail "a failed run left a file"
"$nmea" --help >/dev/null
"$nmea" --version | grep -q '^quickstrip-nmea '
echo "nmea process: as it should be"
