#!/usr/bin/env bash
# agree.sh FINE COARSE: both programs print cells; RMS of the vertical acceleration differs by no more than 2 % of the
# largest, of roll by 8 %, and at most one verdict in thirty differs. The coarse grid has half the directions and
# frequencies: roll resonance of a fast ship in stern-quartering waves is narrower than its 10 degrees.
set -euo pipefail
paste -d' ' <("$1") <("$2") | awk '
  NF != 12 || $1 != $7 || $2 != $8 { print "the programs do not print the same cells: " $0; bad = 1; exit }
  { n++; other += $3 != $9
    for (i = 4; i <= 5; i++) { if ($i > largest[i]) largest[i] = $i
      d = $i - $(i + 6); if (d < 0) d = -d; if (d > worst[i]) worst[i] = d } }
  END {
    if (bad || n != 288) { print n " cells, 288 expected"; exit 1 }
    roll = worst[4] / largest[4]; lift = worst[5] / largest[5]
    printf "%d cells; worst difference, %% of the largest: roll %.2f, vertical acceleration %.2f; %d other verdicts\n", n, 100 * roll, 100 * lift, other
    exit !(roll < 0.08 && lift < 0.02 && other <= n / 30) }'
