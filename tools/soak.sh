#!/usr/bin/env bash
# soak.sh SCENES [SEED]: asks of so many random scenes that sweeps and brute force agree, in two processes that have the
# seed and the next one; without a seed it takes a random one. `make soak` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scenes=$1
seed=${2:-$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}
build bench:soak
soak=$(built bench:soak)
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
half=$((scenes / 2))
echo "The seeds are $seed and $((seed + 1)): make soak SCENES=$scenes SEED=$seed does the same again."
"$soak" $half "$seed" > "$logs/1" & first=$!
"$soak" $((scenes - half)) $((seed + 1)) > "$logs/2" & second=$!
status=0
wait $first || status=1
wait $second || status=1
# Scenes that fail first, then the figures of both processes by family, added up.
figures='^(.*): ([0-9]+) scenes, ([0-9]+) failed$'
cat "$logs"/* | grep -Ev "$figures" || true
cat "$logs"/* | sed -nE "s/$figures/\2\t\3\t\1/p" | awk -F '\t' '
  !($3 in scenes) { order[++count] = $3 }
  { scenes[$3] += $1; failed[$3] += $2; all += $1; wrong += $2 }
  END {
    for (i = 1; i <= count; i++) printf "%-28s %9d scenes %5d failed\n", order[i], scenes[order[i]], failed[order[i]]
    printf "%-28s %9d scenes %5d failed\n", "all", all, wrong
  }'
exit $status
