#!/usr/bin/env bash
# build.sh: builds bin/viscomplex. `make build` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build exe:viscomplex
mkdir -p bin
program=$(built exe:viscomplex)
cmp -s "$program" $EXE || install -m 755 "$program" $EXE
