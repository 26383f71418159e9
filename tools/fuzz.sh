#!/usr/bin/env bash
# fuzz.sh MINUTES [SEED]: files made from those of test/corpus and scenes/, guided by what they reach in the program, for so
# many minutes. New files that reach more go to dist-newstyle/fuzz/corpus: those worth keeping are copied to test/corpus,
# which `make test` reads. Files that are treated wrongly go to dist-newstyle/fuzz/findings; the exit status is 1 if there
# are any. `make fuzz` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seed=${2:-$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}
build bench:fuzz
rm -rf dist-newstyle/fuzz/corpus dist-newstyle/fuzz/findings dist-newstyle/fuzz/fuzz.tix
mapfile -t files < <(find test/corpus scenes -size -8k \( -name '*.json' -o -name '*.geojson' -o -name '*.wkt' \) | sort)
echo "The seed is $seed."
HPCTIXFILE=dist-newstyle/fuzz/fuzz.tix "$(built bench:fuzz)" $(($1 * 60)) "$seed" dist-newstyle/fuzz "${files[@]}"
