#!/usr/bin/env bash
# Beside a baseline: times with their spread, in units of the yardstick of the same run, so that another machine's
# baseline can be compared with; and allocations, which need no unit.
#
#   ratios.sh BASELINE NOW
set -eu -o pipefail
export LC_ALL=C
# Names may hold commas within quotes: they become tabs between fields.
fields() { sed -E ':a; s/^(([^",]|"[^"]*")*),/\1\t/; ta; s/"//g' "$1" | tail -n +2; }
printf '%-58s %11s %8s %11s %8s\n' time now spread baseline ratio
awk -F '\t' '
  NR == FNR { base[$1] = $2; next }
  { now[$1] = $2; spread[$1] = $5; order[++n] = $1 }
  END {
    unit = ("yardstick" in base) ? now["yardstick"] / base["yardstick"] : 1
    for (i = 1; i <= n; i++) {
      k = order[i]
      if (k in base) printf "%-58s %8.3f ms %6.1f %% %8.3f ms %8.2f\n", k, 1e3 * now[k], 100 * spread[k] / now[k], 1e3 * base[k], now[k] / base[k] / unit
      else printf "%-58s %8.3f ms %6.1f %% %11s %8s\n", k, 1e3 * now[k], 100 * spread[k] / now[k], "new", ""
    }
    printf "ratios are in units of the yardstick, which took %.2f times the time of the baseline\n\n", unit
  }' <(fields "$1/time.csv") <(fields "$2/time.csv")
printf '%-58s %11s %11s %8s %11s\n' space allocated baseline ratio "most live"
awk -F '\t' '
  NR == FNR { base[$1] = $2; next }
  $2 > 0 { printf "%-58s %8.2f MB %8s MB %8s %8.2f MB\n", $1, $2 / 1e6, ($1 in base) ? sprintf("%.2f", base[$1] / 1e6) : "new", ($1 in base && base[$1] > 0) ? sprintf("%.2f", $2 / base[$1]) : "", $3 / 1e6 }
' <(fields "$1/space.csv") <(fields "$2/space.csv")
