#!/usr/bin/env bash
# Runs a command where LCM's udpm:// works and reaches nobody else:
#   with_loopback_multicast.sh COMMAND [ARGUMENT ...]
# In a network namespace of its own, with a multicast route on its loopback, where the kernel permits one;
# (QS_OWN_NETWORK=1 tells it); otherwise on the host's own loopback (ttl 0 keeps packets on the host), and it says so.
set -euo pipefail
[ "$#" -gt 0 ] || { echo "usage: with_loopback_multicast.sh COMMAND [ARGUMENT ...]" >&2; exit 2; }

prepare='ip link set lo up && ip route add 224.0.0.0/4 dev lo'
if unshare -rn bash -c "$prepare" 2>/dev/null; then
  exec env QS_OWN_NETWORK=1 unshare -rn bash -c "$prepare"' && exec "$@"' _ "$@"
fi

echo "with_loopback_multicast: no network namespace permitted here; using this host's own network" >&2
if ! ip route get 239.255.76.67 >/dev/null 2>&1; then
  # Without any multicast route udpm:// does not open. Root may add one; it is left in place.
  if ! { ip link set lo up && ip route add 224.0.0.0/4 dev lo; } 2>/dev/null; then
    echo "with_loopback_multicast: no multicast route, and none could be added: udpm:// will fail. As root:" >&2
    echo "  ip route add 224.0.0.0/4 dev lo" >&2
  fi
fi
exec "$@"
