#!/usr/bin/env bash
# Installs the Debian packages that are missing, and nothing when none is.
#   .cmake/install_packages.sh build|test|demo|bench|fuzz|arm64|machine ...
# Needs Debian 12, Ubuntu 24.04 or newer (CMake 3.25), and root or sudo when something is missing.
set -euo pipefail

build=(build-essential cmake ninja-build libeigen3-dev libfmt-dev libcli11-dev nlohmann-json3-dev
  libtomlplusplus-dev liblcm-dev liblcm-bin libgtest-dev libcpp-httplib-dev help2man)
# One version of the clang tools everywhere: another formats and warns differently.
test=(gnuplot-nox git clang-format-14 clang-tidy-14 cppcheck iproute2 util-linux chromium chromium-driver
  lintian python3
  gcc-arm-none-eabi libnewlib-arm-none-eabi libstdc++-arm-none-eabi-newlib qemu-system-arm)
demo=(iproute2 util-linux gnuplot-nox chromium)
bench=(libbenchmark-dev)
fuzz=(clang-14 libclang-rt-14-dev)
arm64=(g++-aarch64-linux-gnu qemu-user-static)
machine=(debootstrap qemu-system-x86 e2fsprogs dpkg-dev)

wanted=()
for set in "$@"; do
  case $set in
    build) wanted+=("${build[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    demo) wanted+=("${demo[@]}") ;;
    bench) wanted+=("${bench[@]}") ;;
    fuzz) wanted+=("${fuzz[@]}") ;;
    arm64) wanted+=("${arm64[@]}") ;;
    machine) wanted+=("${machine[@]}") ;;
    *) echo "usage: install_packages.sh build|test|demo|bench|fuzz|arm64|machine ..." >&2; exit 2 ;;
  esac
done

missing_of() {
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
  done
}

if ! command -v dpkg-query >/dev/null; then
  echo "install_packages.sh: this is not Debian or Ubuntu; please install by hand: ${wanted[*]}" >&2
  exit 1
fi
mapfile -t missing < <(missing_of "${wanted[@]}")
[ "${#missing[@]}" -gt 0 ] || exit 0

echo "Missing Debian packages: ${missing[*]}"
if [ "$(id -u)" = 0 ]; then
  as_root=(env)
elif command -v sudo >/dev/null; then
  as_root=(sudo env)
else
  echo "install_packages.sh: neither root nor sudo here. As root:" >&2
  echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
  exit 1
fi
as_root+=(DEBIAN_FRONTEND=noninteractive)
"${as_root[@]}" apt-get update -q </dev/null
"${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}" </dev/null

mapfile -t missing < <(missing_of "${missing[@]}")
if [ "${#missing[@]}" -gt 0 ]; then
  echo "install_packages.sh: still missing after apt-get: ${missing[*]}" >&2
  exit 1
fi
