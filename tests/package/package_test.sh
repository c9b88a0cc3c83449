#!/usr/bin/env bash
# The package, its units and its configuration files, without installing anything here.
#   package_test.sh BUILD CMAKE SOURCE
# Says what it could not look at: without dpkg-deb, lintian or systemd-analyze a part is left out.
set -euo pipefail
build=$1 cmake=$2 source=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
have() { command -v "$1" >/dev/null || { echo "left out: no $1 here"; return 1; }; }

# --- what cmake --install puts down
DESTDIR=$work/root "$cmake" --install "$build" --prefix /usr >"$work/install.log"
root=$work/root
for program in advisor display nmea recorder hull sim; do
  "$root/usr/bin/quickstrip-$program" --version >/dev/null || fail "quickstrip-$program does not run"
done
for file in usr/share/quickstrip/msgs/advice_t.lcm usr/share/quickstrip/hulls/s175.hull.toml \
  usr/share/quickstrip/limits/quickstrip_cargo.limits.toml usr/lib/sysusers.d/quickstrip.conf; do
  [ -f "$root/$file" ] || fail "$file is missing"
done

# --- a manual page for each program, from its own --help
if have help2man; then
  for page in man8/quickstrip-advisor.8 man8/quickstrip-display.8 man8/quickstrip-nmea.8 man8/quickstrip-recorder.8 \
    man1/quickstrip-hull.1 man1/quickstrip-sim.1; do
    file=$root/usr/share/man/$page.gz
    [ -f "$file" ] || fail "$page is missing"
    for section in NAME SYNOPSIS OPTIONS FILES 'SEE ALSO'; do
      zcat "$file" | grep -qE "^\.SH \"?$section\"?$" || fail "$page has no $section"
    done
  done
  # (with options as groff writes them: \-\-hull)
  zcat "$root/usr/share/man/man8/quickstrip-advisor.8.gz" | tr -d '\\' | grep -q -- '--hull' || fail "no --hull in the advisor's page"
fi

# --- configuration: the same options as --help, none missing, none that is no more; and as shipped they are read
options_of_help() { # but those that make no sense in a file
  "$1" --help | grep -oE '^ +(-h,)?--[a-z0-9-]+' | tr -d ' ' | sed 's/.*--//' | grep -vE '^(help|version|config)$' | sort -u
}
keys_of_file() { grep -oE '^#?[a-z0-9-]+ = ' "$1" | tr -d '#= ' | sort; }
for program in advisor display nmea recorder; do
  file=$root/etc/quickstrip/$program.toml
  keys_of_file "$file" | uniq -d | grep . && fail "$program.toml names an option twice"
  diff <(options_of_help "$root/usr/bin/quickstrip-$program") <(keys_of_file "$file") ||
    fail "$program.toml (right) and --help (left) differ"
  # Each option that is commented out is one that the program takes, by itself.
  grep -E '^#[a-z0-9-]+ = ' "$file" | sed 's/^#//' | while read -r line; do
    case $line in at\ =*) continue ;; esac # only with replay
    printf '%s\n' "$line" >"$work/one.toml"
    code=0
    case $program in # an input that is not there stops each before the bus; 2 would be wrong use
      advisor) wrong=(--hull "$work/none") ;;
      display) wrong=(--hull "$work/none") ;;
      nmea) wrong=(--file "$work/none") ;;
      recorder) wrong=(--folder "$work/none") ;;
    esac
    timeout 20 "$root/usr/bin/quickstrip-$program" --config "$work/one.toml" "${wrong[@]}" >"$work/out" 2>&1 || code=$?
    if [ "$code" != 1 ] || grep -q 'no such option' "$work/out"; then
      cat "$work/out" >&2
      fail "$program.toml: $line: exit $code"
    fi
  done
  printf 'hul = "x"\n' >"$work/bad.toml"
  code=0
  "$root/usr/bin/quickstrip-$program" --config "$work/bad.toml" "${wrong[@]:-}" >/dev/null 2>&1 || code=$?
  [ "$code" != 0 ] || fail "$program: a key that is no option is not refused"
done
code=0
"$root/usr/bin/quickstrip-advisor" --config "$root/etc/quickstrip/advisor.toml" >"$work/out" 2>&1 || code=$?
if [ "$code" != 1 ] || ! grep -q 'ship.hull.toml' "$work/out"; then
  cat "$work/out" >&2
  fail "advisor.toml as shipped: exit $code"
fi

# --- units
if have systemd-analyze; then
  mkdir -p "$root/bin" "$root/lib/systemd/system"
  for unit in "$root"/usr/lib/systemd/system/quickstrip-*.service; do
    name=$(basename "$unit")
    # Programs and documents are looked for on this machine: those of the folder are put in their place.
    sed "s#=/usr/bin/quickstrip#=$root/usr/bin/quickstrip#; /^Documentation=/d" "$unit" >"$work/$name"
  done
  systemd-analyze verify "$work"/quickstrip-*.service 2>&1 | grep -i quickstrip | grep . && fail "units"
  for name in advisor display nmea recorder; do
    systemd-analyze security --offline=true --threshold=25 "$work/quickstrip-$name.service" >"$work/security" 2>&1 ||
      { tail -n 3 "$work/security" >&2; fail "quickstrip-$name.service is more exposed than 2.5 of 10"; }
    grep 'Overall exposure' "$work/security"
  done
fi

# --- the Debian package
if have dpkg-deb && have dpkg-shlibdeps && have cpack; then
  (cd "$work" && cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work/deb" >"$work/cpack.log" 2>&1) ||
    { cat "$work/cpack.log" >&2; fail "cpack"; }
  deb=$(ls "$work"/deb/*.deb)
  dpkg-deb --info "$deb" | grep -E '^ (Package|Version|Architecture|Installed-Size|Depends):'
  grep -q 'Depends:.*liblcm' <<<"$(dpkg-deb --info "$deb")" || fail "the package does not depend on LCM's library"
  dpkg-deb --info "$deb" conffiles | diff - <(cd "$root" && find etc -type f | sed 's#^#/#' | sort) ||
    fail "conffiles are not the files in /etc"
  for script in postinst prerm postrm; do
    dpkg-deb --info "$deb" "$script" | sh -n || fail "$script"
  done
  if have lintian; then
    lintian --fail-on error "$deb" || fail "lintian"
  fi
  dpkg -x "$deb" "$work/unpacked"
  "$source/tests/package/first_advice.sh" "$work/unpacked" "$source/firmware/README.md"
fi
echo "package: as it should be"
