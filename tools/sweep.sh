#!/usr/bin/env bash
# sweep.sh: draws the figures of docs/sweep.md anew. `make gallery` runs it too.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

out=docs/figures/sweep
mkdir -p "$out"
draw() { $EXE draw sweep scenes/sweep.json --at "$2" -o "$out/$1.svg"; }
draw start 0
draw ready 8
draw chain 26
draw line 12
