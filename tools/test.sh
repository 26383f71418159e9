#!/usr/bin/env bash
# test.sh [SEED]: all tests at -O2, and at -O0 those that have to do with optimisation, with one seed; the last line is
# "N passed, N failed", the exit status 0 if nothing failed. `make test` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seed=${1:-1}
# QuickCheck cases of each property in the run at -O0, which is slow, and what that run leaves out: what takes long and
# stands on parts that it keeps. It keeps exact arithmetic, scenes, sweeps and formats.
o0_cases=${O0_CASES:-20}
o0_skipped=()

# hspec's summary is "N examples, N failures[, N pending]". A pending test counts as failed, and so does a run that ends
# without a summary or without a single test.
passed=0 failed=0
count() { # log, status of the run
  local line examples failures pending
  line=$(grep -E '^[0-9]+ examples?, [0-9]+ failures?' "$1" | tail -n 1) || { failed=$((failed + 1)); return; }
  examples=$(sed -E 's/^([0-9]+) example.*/\1/' <<< "$line")
  failures=$(sed -E 's/.*, ([0-9]+) failure.*/\1/' <<< "$line")
  pending=$(sed -nE 's/.*, ([0-9]+) pending.*/\1/p' <<< "$line")
  pending=${pending:-0}
  passed=$((passed + examples - failures - pending))
  failed=$((failed + failures + pending))
  if [ "$examples" = 0 ] || { [ "$2" != 0 ] && [ "$failures" = 0 ]; }; then failed=$((failed + 1)); fi
}

logs=$(mktemp -d) beside=
trap '[ -z "$beside" ] || kill -- "-$beside" 2> /dev/null || true; rm -rf "$logs"' EXIT
mkdir -p "$BUILDDIR"
# hspec-discover runs only when Spec.hs is compiled, so a new spec must touch it.
specs=$(find test -name '*Spec.hs' | sort)
if [ "$specs" != "$(cat "$BUILDDIR/specs" 2> /dev/null)" ]; then touch test/Spec.hs; echo "$specs" > "$BUILDDIR/specs"; fi
describe
export DESCRIBED=yes

# level, options of cabal: builds, and runs the suite with the options of hspec in the array `chosen`.
level() {
  local level=$1 begun=$SECONDS
  shift
  build "$@" exe:viscomplex test:spec ||
    { echo "The tests could not be built at $level."; touch "$logs/$level-unbuilt"; return 1; }
  echo
  echo "== tests at $level, with seed $seed; built in $((SECONDS - begun)) s"
  VISCOMPLEX_EXE=$(built "$@" exe:viscomplex) "$(built "$@" test:spec)" --seed="$seed" "${chosen[@]}" 2>&1 |
    tee "$logs/$level"
}
judge() { # level, status of its run
  if [ -e "$logs/$1-unbuilt" ]; then failed=$((failed + 1)); else count "$logs/$1" "$2"; fi
}

# Both levels are built and run at the same time, each by one thread: on two cores that is faster than one after the
# other by two threads. The one beside is a process group of its own, so that all of it can be stopped.
set -m
(
  BUILDDIR=$BUILDDIR/O0
  chosen=(--qc-max-success="$o0_cases" "${o0_skipped[@]/#/--skip=}")
  level -O0 -O0 --ghc-options='-O0 -j1'
) > "$logs/beside" 2>&1 & beside=$!
set +m
status=0
chosen=(--print-cpu-time)
level -O2 --ghc-options=-j1 || status=$?
judge -O2 "$status"
status=0
wait "$beside" || status=$?
beside=
cat "$logs/beside"
judge -O0 "$status"
echo "The seed was $seed: make test SEED=$seed does the same again."
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
