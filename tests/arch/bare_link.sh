#!/usr/bin/env bash
# Links the whole archive into a C program, without libstdc++, and runs it: the core needs no C++ runtime.
#   bare_link.sh CC BARE_MAIN ARCHIVE
set -euo pipefail
cc=$1 bare_main=$2 archive=$3
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$cc" -o "$out/bare" "$bare_main" -nodefaultlibs -Wl,--no-undefined \
  -Wl,--whole-archive "$archive" -Wl,--no-whole-archive -lm -lc -lgcc
"$out/bare"
echo "linked with libm, libc and libgcc only, and ran"
