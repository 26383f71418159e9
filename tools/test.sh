#!/usr/bin/env bash
# test.sh [SEED]: all tests at -O2, and at -O0 those that have to do with optimisation, with one seed; the last line is
# "N passed, N failed", the exit status 0 if nothing failed. `make test` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

seed=${1:-1}
# QuickCheck cases of each property in the run at -O0, which is slow, and what that run keeps: exact arithmetic, scenes,
# sweeps and formats, but for large scenes and for counts of steps and pairs, which no optimisation changes. The rest
# takes long and stands on these.
o0_cases=${O0_CASES:-20}
o0_kept=(Exact Scene Sweep View Format Sorting Law)
o0_skipped=('up to 2^14 corners' '/Visibility.Sweep/the work/' '/Visibility.Scene.Family/the kinds/')
# The run at -O2 is two processes of about the same length; the tests of the first one.
first=(/Command /Report/ Visibility.Draw Visibility.Radiosity Visibility.Complex)

# hspec's summary is "N examples, N failures[, N pending]". A pending test counts as failed, and so does a run that ends
# without a summary or without a single test.
passed=0 failed=0
count() { # log, status of the run
  local line examples failures pending
  line=$(grep -E '^[0-9]+ examples?, [0-9]+ failures?' "$1" 2> /dev/null | tail -n 1) || { failed=$((failed + 1)); return; }
  examples=$(sed -E 's/^([0-9]+) example.*/\1/' <<< "$line")
  failures=$(sed -E 's/.*, ([0-9]+) failure.*/\1/' <<< "$line")
  pending=$(sed -nE 's/.*, ([0-9]+) pending.*/\1/p' <<< "$line")
  pending=${pending:-0}
  passed=$((passed + examples - failures - pending))
  failed=$((failed + failures + pending))
  if [ "$examples" = 0 ] || { [ "$2" != 0 ] && [ "$failures" = 0 ]; }; then failed=$((failed + 1)); fi
}

logs=$(mktemp -d) beside=()
trap 'for group in ${beside[@]+"${beside[@]}"}; do kill -- "-$group" 2> /dev/null || true; done; rm -rf "$logs"' EXIT
mkdir -p "$BUILDDIR"
# hspec-discover runs only when Spec.hs is compiled, so a new spec must touch it.
specs=$(find test -name '*Spec.hs' | sort)
if [ "$specs" != "$(cat "$BUILDDIR/specs" 2> /dev/null)" ]; then touch test/Spec.hs; echo "$specs" > "$BUILDDIR/specs"; fi
describe
export DESCRIBED=yes

compiled() { # level, options of cabal: sets the executable, and that of the suite
  local begun=$SECONDS
  build "${@:2}" exe:viscomplex test:spec test:readme || { echo "The tests could not be built at $1."; return 1; }
  export VISCOMPLEX_EXE VISCOMPLEX_README
  VISCOMPLEX_EXE=$(built "${@:2}" exe:viscomplex)
  VISCOMPLEX_README=$(built "${@:2}" test:readme)
  suite=$(built "${@:2}" test:spec)
  echo "== built at $1 in $((SECONDS - begun)) s"
}
run() { # log, title, options of hspec
  echo
  echo "== tests $2, with seed $seed"
  "$suite" --seed="$seed" --print-cpu-time "${@:3}" 2>&1 | tee "$logs/$1"
}
apart() { # log, command: in a process group of its own, so that all of it can be stopped
  set -m
  "${@:2}" > "$logs/$1-said" 2>&1 &
  set +m
  beside+=($!)
}
joined() { # log, its place among those apart
  local status=0
  wait "${beside[$2]}" || status=$?
  unset "beside[$2]"
  cat "$logs/$1-said"
  count "$logs/$1" "$status"
}

# Both levels are built at the same time; the one at -O0 takes what time the other one leaves.
unoptimised() {
  BUILDDIR=$BUILDDIR/O0
  renice -n 10 $BASHPID > /dev/null
  compiled -O0 -O0 --ghc-options='-O0 -j1 +RTS -A64m -RTS' || return
  run O0 'at -O0' --qc-max-success="$o0_cases" "${o0_kept[@]/#/--match=Visibility.}" \
    "${o0_skipped[@]/#/--skip=}"
}
apart O0 unoptimised
if compiled -O2 --ghc-options='-j2 +RTS -A64m -RTS'; then
  apart O2-first run O2-first 'at -O2, first half' "${first[@]/#/--match=}"
  status=0
  run O2-second 'at -O2, second half' "${first[@]/#/--skip=}" || status=$?
  count "$logs/O2-second" "$status"
  joined O2-first 1
else
  failed=$((failed + 1))
fi
joined O0 0
echo "The seed was $seed: make test SEED=$seed does the same again."
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
