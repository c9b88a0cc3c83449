#!/usr/bin/env bash
# The real display beside the real advisor over udpm://: what is entered by hand becomes the advisor's input, and
# what is withdrawn is not; 64 browsers that never read cost the advisor no cycle.
#   live_display.sh ADVISOR DISPLAY SIM SOURCE_DIR
# Run it under tests/support/with_loopback_multicast.sh.
set -euo pipefail
advisor=$1 display=$2 sim=$3 source=$4
hull=$source/sim/hulls/s175.hull.toml
url="udpm://239.255.76.67:$((20000 + $$ % 20000))?ttl=0" # of this run alone
work=$(mktemp -d)
pids=()
cleanup() {
  for pid in "${pids[@]}"; do kill -9 "$pid" 2>/dev/null || true; done
  rm -rf "$work"
}
trap cleanup EXIT
fail() {
  echo "FAILED: $*" >&2
  cat "$work"/*.journal >&2 2>/dev/null || true
  exit 1
}
until_true() { # until_true SECONDS COMMAND ...
  local left=$(($1 * 10))
  shift
  until "$@"; do
    left=$((left - 1))
    [ "$left" -gt 0 ] || return 1
    sleep 0.1
  done
}

ask() { # ask METHOD PATH [BODY]
  local own=""
  if [ "$1" = POST ]; then
    own="Origin: http://127.0.0.1:$port"$'\r\n'"X-Quickstrip-Token: $token"$'\r\n'
    own+="Content-Type: application/json"$'\r\n'"Content-Length: ${#3}"$'\r\n'
  fi
  exec 3<>"/dev/tcp/127.0.0.1/$port"
  printf '%s %s HTTP/1.1\r\nHost: 127.0.0.1:%s\r\nConnection: close\r\n%s\r\n%s' "$1" "$2" "$port" "$own" "${3:-}" >&3
  cat <&3
  exec 3<&-
}
use_of() { # use_of INPUT: advice_t's USE_...
  ask GET /api/state | grep -oP "\"input\":$1,[^}]*\"use\":\K[0-9]" || true
}
is_use() { [ "$(use_of "$1")" = "$2" ]; }
misses() { ask GET /api/state | grep -oP '"deadline_misses":\K[0-9]+'; }
enter() { # enter FORM BODY: read back, then confirmed
  local ticket
  ticket=$(ask POST "/api/$1" "$2" | grep -oP '"ticket":"\K[0-9a-f]+') || fail "$1 is not read back"
  ask POST /api/confirm "{\"ticket\":\"$ticket\"}" | grep -q '200 OK' || fail "$1 is not confirmed"
}

"$advisor" --hull "$hull" --ensemble-per-cycle 1 --url "$url" 2>"$work/advisor.journal" &
pids+=($!)
"$display" --hull "$hull" --url "$url" --port 0 >"$work/address" 2>"$work/display.journal" &
pids+=($!)
until_true 60 grep -q '^quickstrip-advisor' "$work/advisor.journal" || fail "the advisor does not listen"
until_true 60 test -s "$work/address" || fail "the display does not listen"
port=$(grep -oP ':\K[0-9]+(?=/)' "$work/address")
token=$(ask GET / | grep -oP 'quickstrip-token" content="\K[0-9a-f]+')

# A minute of own ship from now on, and one measured spectrum.
now=$(($(date +%s) + 1))
utc() { date -u -d "@$1" +%Y-%m-%dT%H:%M:%SZ; }
printf 'schema = 1\nname = "test"\nend_utc = %s\n[[leg]]\nfrom_utc = %s\nheading_deg = 75.0\nspeed_kn = 12.0\n' \
  "$(utc $((now + 60)))" "$(utc "$now")" >"$work/now.voyage.toml"
{
  sed -n 1,3p "$source/sim/storms/dorian_41010.sea"
  highest=$(grep -n '^hour 2019-09-04T12:40' "$source/sim/storms/dorian_41010.sea" | cut -d: -f1)
  sed -n "$highest,$((highest + 5))p" "$source/sim/storms/dorian_41010.sea" |
    awk -v at="$(utc "$now")" '/^hour/ { $2 = at } { print }'
} >"$work/now.sea"
"$sim" log --sea "$work/now.sea" --voyage "$work/now.voyage.toml" --own-ship-period-s 1 --out "$work/now.log" >/dev/null
"$sim" replay "$work/now.log" --publish --speed 1 --url "$url" >/dev/null 2>&1 &
pids+=($!)

until_true 20 is_use 1 1 || fail "no advice on the measured spectrum"
sleep 1.1 # the entry is newer than the measurement
enter sea '{"author":"A. Mate","systems":[{"kind":"swell","hs_m":2.5,"period_s":12,"period_kind":"tp","dir_from_deg":310}]}'
until_true 10 is_use 0 1 || fail "the entered sea is not used"
ask GET /api/state | grep -q '"dir_from_deg":310.0' || fail "the entered sea is not shown"
ask POST /api/withdraw '{"kind":"sea","author":"A. Mate"}' | grep -q '200 OK' || fail "the sea is not withdrawn"
until_true 10 is_use 1 1 || fail "the withdrawn sea is still used"
is_use 4 3 || fail "the loading is not the hull file's"
enter loading '{"author":"Chief","gm_m":1.4,"measured_roll_period_s":16}'
until_true 10 is_use 4 1 || fail "the entered loading is not used"
ask GET /api/state | grep -q 'Loading entered\|GM with free surfaces 1.40 m' || fail "the entry is not shown"

before=$(misses)
hogs=()
for _ in $(seq 64); do
  exec {hog}<>"/dev/tcp/127.0.0.1/$port"
  printf 'GET /events HTTP/1.1\r\nHost: 127.0.0.1:%s\r\n\r\n' "$port" >&"$hog"
  hogs+=("$hog")
done
sleep 6
after=$(misses)
for hog in "${hogs[@]}"; do exec {hog}>&-; done
echo "deadline misses: $before before, $after with 64 browsers that do not read"
[ "$((after - before))" -le 1 ] || fail "browsers cost the advisor cycles" # one: a loaded machine

kill -TERM "${pids[1]}"
code=0
wait "${pids[1]}" || code=$?
[ "$code" = 0 ] || fail "SIGTERM ended the display with $code, not 0"
echo "live display: as it should be"
