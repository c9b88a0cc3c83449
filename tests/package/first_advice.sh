#!/usr/bin/env bash
# The commands of firmware/README.md, one block after the other, as they stand there: with an unpacked package in
# place of the machine, and apt, sudo, systemctl and journalctl played.
#   first_advice.sh UNPACKED README
set -euo pipefail
if [ "${QS_FIRST_INSIDE:-}" != 1 ]; then
  here=$(cd "$(dirname "$0")" && pwd)
  QS_FIRST_INSIDE=1 exec "$here/../support/with_loopback_multicast.sh" "$here/$(basename "$0")" "$@"
fi
root=$1 readme=$2
work=$(mktemp -d)
pids=()
cleanup() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  rm -rf "$work"
}
trap cleanup EXIT
PATH=$root/usr/bin:$PATH
# Every path of the machine is one of the folder.
inside() { sed -E "s#(/etc/quickstrip|/usr/share/quickstrip|/var/lib/quickstrip)#$root\1#g"; }
for file in "$root"/etc/quickstrip/*.toml; do
  inside <"$file" >"$work/file" && cp "$work/file" "$file"
done

sudo() { "$@"; }
apt() { [ "$1" = install ] && [ -d "$root/usr/bin" ]; }
systemctl() { # enable --now UNIT...: what the unit starts, with the folders that it has
  shift 2
  local unit command folder
  for unit in "$@"; do
    file=$(find "$root" -name "$unit.service")
    command=$(sed -n 's/^ExecStart=//p' "$file" | inside)
    folder=$(sed -n 's/^StateDirectory=//p' "$file")
    [ -z "$folder" ] || mkdir -p "$root/var/lib/$folder"
    case $unit in *display) command+=' --port 0' ;; esac # any free one
    # shellcheck disable=SC2086
    "$root"$command >"$work/$unit.out" 2>"$work/$unit.journal" &
    pids+=($!)
  done
  sleep 2
}
journalctl() { cat "$work/$2.journal"; }

cd "$work"
awk '/^```sh$/ { inside = 1; next } /^```$/ { if (inside) print "echo BLOCK"; inside = 0 } inside' "$readme" | inside >"$work/commands"
[ "$(grep -c 'echo BLOCK' "$work/commands")" = 5 ] || { echo "FAILED: not five steps" >&2; exit 1; }
# shellcheck disable=SC1091
. "$work/commands" >"$work/said" 2>"$work/errors" || { cat "$work/said" "$work/errors" "$work"/*.journal >&2; exit 1; }
for line in 'self-test: passed' 'quickstrip-advisor .*: S-175' 'displacement' 'No advice, because|QS_ADVICE' 'QS_ADVICE'; do
  grep -qE "$line" "$work/said" || { cat "$work/said" "$work/errors" >&2; echo "FAILED: '$line' is not said" >&2; exit 1; }
done
for pid in "${pids[@]}"; do
  kill -0 "$pid" || { cat "$work"/*.journal >&2; echo "FAILED: a program has ended" >&2; exit 1; }
done
for pid in "${pids[@]}"; do # and ends as the service manager asks
  kill -TERM "$pid"
  wait "$pid" || { cat "$work"/*.journal >&2; echo "FAILED: SIGTERM: $?" >&2; exit 1; }
done
pids=()
tail -n 8 "$work/said"
echo "five steps: done as written"
