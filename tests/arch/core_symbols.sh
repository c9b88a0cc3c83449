#!/usr/bin/env bash
# Link evidence: what the core archive asks of the world, and what it writes to.
#   core_symbols.sh undefined NM      ARCHIVE   every undefined symbol is the core's own or on the list below
#   core_symbols.sh writable  OBJDUMP ARCHIVE   no writable static storage but the check handler
# An allow-list, so that malloc, operator new, __cxa_throw, __cxa_guard_*, printf, std::string, locales and
# everything nobody thought of are refused alike.
set -euo pipefail
mode=$1 tool=$2 archive=$3

# The C maths library; plain memory; what compilers add on their own account.
allowed='^(
  (a?(sin|cos|tan)h?|atan2|sincos|exp|exp2|expm1|log|log2|log10|log1p|pow|sqrt|cbrt|hypot|fabs|fmod|remainder|remquo|
   floor|ceil|trunc|round|lround|llround|rint|lrint|nearbyint|ldexp|frexp|modf|scalbn|logb|ilogb|copysign|fma|fmin|fmax|fdim|nextafter|
   erf|erfc|tgamma|lgamma|j0|j1|jn|y0|y1|yn)f?|
  c(abs|arg|exp|log|pow|sqrt|sin|cos|tan|sinh|cosh|tanh|proj)f?|
  mem(cpy|set|move|cmp|chr)|__mem(cpy|set|move)_chk|strlen|strcmp|strncmp|
  __stack_chk_fail|_GLOBAL_OFFSET_TABLE_
)$'
allowed=$(tr -d ' \n' <<<"$allowed")

case $mode in
  undefined)
    defined=$("$tool" --defined-only --extern-only "$archive" | awk 'NF >= 3 {print $3}' | sort -u)
    [ -n "$defined" ] || { echo "$archive defines nothing: wrong file?" >&2; exit 1; }
    asked=$("$tool" --undefined-only "$archive" | awk '$1 == "U" || $1 == "w" {print $2}' | sort -u)
    outside=$(comm -23 <(printf '%s\n' "$asked") <(printf '%s\n' "$defined") | grep -v '^$' || true)
    echo "asked of the world: $(tr '\n' ' ' <<<"$outside")"
    bad=$(grep -vE "$allowed" <<<"$outside" | grep -v '^$' || true)
    ;;
  writable)
    # .data.rel.ro is read-only after loading: constant tables of pointers in position-independent code.
    table=$("$tool" -t "$archive")
    bad=$(grep -E ' O \.(data|bss|tdata|tbss)' <<<"$table" | grep -vE ' O \.data\.rel\.ro' |
      awk '{print $NF}' | grep -vE '12_GLOBAL__N_19g_handlerE$' || true)
    ;;
  *) echo "usage: core_symbols.sh undefined|writable TOOL ARCHIVE" >&2; exit 2 ;;
esac

if [ -n "$bad" ]; then
  echo "$archive, $mode, not allowed:" >&2
  c++filt <<<"$bad" >&2
  exit 1
fi
echo "$mode: clean"
