#!/usr/bin/env bash
# gallery.sh: draws the figures of docs/gallery.md anew. `make gallery` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

out=docs/figures/gallery
mkdir -p "$out"
draw() { $EXE draw "${@:2}" -o "$out/$1.svg"; }
draw ordp-9-radiosity radiosity scenes/ordp-9.json --mesh discontinuity --profile E.1 --profile 4.3
draw ordp-9-dual dual scenes/ordp-9.json
draw ordp-9-matrix matrix scenes/ordp-9.json
draw ordp-9-mesh mesh scenes/ordp-9.json --breaks shadow-limits --lines
draw flat-radiosity radiosity scenes/flat.json --mesh discontinuity --profile 1.2
draw flat-dual dual scenes/flat.json
draw flat-matrix matrix scenes/flat.json
draw flat-mesh mesh scenes/flat.json
