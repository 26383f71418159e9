#!/usr/bin/env bash
# Times `viscomplex graph --unsorted` against a visibility graph by CGAL's triangular expansion from every corner, both as
# whole processes on one core, in alternation; prints the medians of processor time in seconds. Both must find the same pairs.
#
#   run.sh VISCOMPLEX PEER FOLDER [RUNS] [SIZE ...]
set -eu -o pipefail
exe=$1 peer=$2 folder=$3 runs=${4:-7}
shift $(($# < 4 ? $# : 4))
sizes=("$@")
[ ${#sizes[@]} -gt 0 ] || sizes=(300 1000 3000)
export LC_ALL=C TIMEFORMAT='%U %S'
mkdir -p "$folder"
seconds() { { time taskset -c 0 "$@" > /dev/null; } 2>&1 | awk '{ printf "%.3f\n", $1 + $2 }'; }
median() { sort -g | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'; }
printf '%10s %10s %12s %12s %8s\n' polygons pairs viscomplex CGAL ratio
for size in "${sizes[@]}"; do
  scene=$folder/random-$size.json
  "$exe" generate random --size "$size" > "$scene"
  "$exe" graph "$scene" | sort > "$folder/ours"
  "$peer" "$scene" | sort > "$folder/theirs"
  cmp -s "$folder/ours" "$folder/theirs" || { echo "the pairs of $scene differ" >&2; exit 1; }
  : > "$folder/a"; : > "$folder/b"
  for ((i = 0; i < runs; i++)); do
    seconds "$exe" graph --unsorted "$scene" >> "$folder/a"
    seconds "$peer" "$scene" >> "$folder/b"
  done
  a=$(median < "$folder/a") b=$(median < "$folder/b")
  printf '%10s %10s %12s %12s %8s\n' "$size" "$(wc -l < "$folder/ours")" "$a" "$b" \
    "$(awk -v a="$a" -v b="$b" 'BEGIN { printf "%.2f", b / a }')"
done
