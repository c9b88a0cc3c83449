#!/usr/bin/env bash
# The examples against a live advisor: fed by one, heard by the two others, in the same words.
#   examples_test.sh BUILD SOURCE          under tests/support/with_loopback_multicast.sh
set -euo pipefail
build=$1 source=$2
port=$((20000 + $$ % 20000))
url="udpm://239.255.76.67:$port?ttl=0"
work=$(mktemp -d)
pids=()
cleanup() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait
  rm -rf "$work"
}
trap cleanup EXIT
fail() {
  echo "FAILED: $*" >&2
  head -n 20 "$work"/* >&2
  exit 1
}
"$build/firmware/advisor/quickstrip-advisor" --hull "$source/sim/hulls/s175.hull.toml" --url "$url" --cycle-s 0.5 \
  --ensemble-per-cycle 0 2>"$work/advisor" &
pids+=($!)
for _ in $(seq 300); do
  grep -q '^quickstrip-advisor' "$work/advisor" && break
  sleep 0.1
done
"$build/firmware/examples/example_advice_subscriber" "$url" >"$work/cpp" &
pids+=($!)
PYTHONPATH=$build/firmware/examples/python "$source/firmware/examples/advice_subscriber.py" "$port" >"$work/python" &
pids+=($!)

both_say() { # both_say PATTERN
  for _ in $(seq 300); do
    grep -q "$1" "$work/cpp" && grep -q "$1" "$work/python" && return
    sleep 0.1
  done
  fail "not both say '$1'"
}
both_say '^No advice, because the ship'
"$build/firmware/examples/example_sea_publisher" "$url" 60 &
pids+=($!)
both_say '^040'
for said in cpp python; do
  grep -qE '^040 deg, 16.0 kn: (good|caution|limits exceeded); governed by .+, waves may grow by the factor [0-9.]+$' \
    "$work/$said" || fail "$said: no advice"
done
# The same words, wherever each began to listen.
advice=$(grep -m 1 '^040' "$work/cpp")
grep -qxF "$advice" "$work/python" || fail "the two do not say the same"
echo "$advice"
