#!/usr/bin/env bash
# bench.sh: time and space of the parts and of whole commands, beside bench/baseline. `make bench` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build bench:time bench:space
out=dist-newstyle/bench
mkdir -p $out
rm -f $out/*.csv
VISCOMPLEX_EXE="$PWD/$EXE" "$(built bench:time)" --time-limit 1 --csv $out/time.csv > $out/time.log
"$(built bench:space)" > $out/space.csv
bash bench/ratios.sh bench/baseline $out
