#!/usr/bin/env bash
# mutants.sh COUNT SEED GROUP …: makes COUNT small faults in each group of modules that decide, one at a time, and says
# which of them no test notices. `make mutants` runs it; docs/testing.md says what was found.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build bench:mutants
work=dist-newstyle/mutants
# What differs from the copy is copied anew, so that what a run before has compiled serves again.
mkdir -p $work/src $work/objects
(cd $work && find src -type f) | while read -r file; do [ -e "$file" ] || rm "$work/$file"; done
find src -type f | while read -r file; do
  cmp -s "$file" "$work/$file" || { mkdir -p "$work/${file%/*}"; cp "$file" "$work/$file"; }
done
"$(built bench:mutants)" $work "$@"
