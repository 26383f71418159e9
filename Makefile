# `make` lists the targets.

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.ONESHELL:
.DELETE_ON_ERROR:
.DEFAULT_GOAL := help
MAKEFLAGS += --no-print-directory

# GHC reads its sources in the encoding of the locale.
export LANG := C.UTF-8
export LC_ALL := C.UTF-8

# What a caller may set.
BUILDDIR ?= dist-newstyle
CABAL_FLAGS ?=
# QuickCheck cases of each property in the run at -O0, which is slow.
O0_CASES ?= 20
# Scenes that `demo` runs; for `soak`, how many random ones.
SCENES ?= $(sort $(wildcard scenes/*.json scenes/*.geojson scenes/*.wkt))
# The first of two seeds of `soak`.
SEED ?= 1
# Passed to the benchmark.
BENCH_ARGS ?=

EXE := bin/viscomplex

# The Debian packages, and the same by the names and bounds of package.yaml.
PACKAGES := ghc cabal-install hpack hspec-discover \
  libghc-aeson-dev libghc-criterion-dev libghc-diagrams-lib-dev libghc-diagrams-svg-dev \
  libghc-hspec-dev libghc-optparse-applicative-dev libghc-primitive-dev \
  libghc-quickcheck2-dev libghc-splitmix-dev libghc-svg-builder-dev libghc-temporary-dev \
  libghc-vector-dev libghc-vector-algorithms-dev libghc-weigh-dev
FIGURE_PACKAGES := librsvg2-bin
PEER_PACKAGES := g++ libcgal-dev

# All state of cabal lies in the checkout. Where the installed packages suffice, cabal knows no other source and never
# looks for a network.
define CABAL
cabal() {
  if [ -e dist-newstyle/from-hackage ]; then command cabal "$$@"
  else CABAL_DIR="$$PWD/dist-newstyle/cabal" CABAL_CONFIG="$$PWD/cabal.offline.config" command cabal "$$@"
  fi
}
# Where DESCRIBED is set, viscomplex.cabal has been written: two builds at once must not both do it.
build() {
  [ -n "$${DESCRIBED-}" ] || hpack --silent --force || return 1
  cabal build --builddir=$(BUILDDIR) $(CABAL_FLAGS) "$$@"
}
endef

# True if dpkg has all of the packages named.
define INSTALLED
installed() {
  command -v dpkg-query >/dev/null &&
  [ "$$(dpkg-query -W -f='$${db:Status-Status}\n' "$$@" 2>/dev/null | grep -cx installed)" = "$$#" ]
}
install() {
  local sudo=
  if [ "$$(id -u)" != 0 ]; then sudo=sudo; command -v sudo >/dev/null || return 1; fi
  $$sudo apt-get update && $$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "$$@"
}
endef

.PHONY: help
help: ## this list
	@echo 'viscomplex: targets'
	sed -nE 's/^([a-z]+):.*## (.*)/  make \1\t\2/p' Makefile | expand -t 18

.PHONY: setup
setup: ## install what is missing (Debian 12: apt; elsewhere it says what is needed)
	@$(INSTALLED)
	$(CABAL)
	mkdir -p dist-newstyle
	marker=dist-newstyle/from
	if installed $(PACKAGES); then rm -f $$marker-*; exit 0; fi
	if [ -e $$marker-hackage ] || [ -e $$marker-system ]; then exit 0; fi
	if command -v apt-get >/dev/null && install $(PACKAGES); then exit 0; fi
	{
	  if command -v apt-get >/dev/null; then
	    echo 'The packages could not be installed from here. As root:'
	    echo
	    echo 'apt-get update && apt-get install $(PACKAGES)' | fold -s -w 90 | sed -e 's/^/    /' -e '$$!s/$$/\\/'
	    echo
	    echo 'Without them, viscomplex needs'
	  else
	    echo 'There is no apt-get here, so nothing is installed. viscomplex needs'
	  fi
	  echo
	  echo '    GHC     9.0 to 9.4 (base >= 4.15 && < 4.18)'
	  echo '    cabal   3.4 or later'
	  echo '    hpack   0.34.6 or later'
	  echo '    gcc, make, bash, awk'
	  echo
	  echo 'and these Haskell packages; cabal fetches those that are not installed from Hackage (cabal update, once):'
	  echo
	  sed -nE 's/^  - &[a-z0-9-]+ +/    /p' package.yaml
	  echo
	  missing=
	  for tool in ghc cabal hpack; do
	    if path=$$(type -P $$tool); then echo "    $$tool is $$path"
	    else echo "    $$tool is not on PATH"; missing="$$missing $$tool"; fi
	  done
	  echo
	  if [ -n "$$missing" ]; then echo "Missing:$$missing. Install and run make again."; exit 1; fi
	  hpack --silent --force
	  if type -P hspec-discover >/dev/null && cabal build --dry-run all >/dev/null 2>&1; then
	    touch $$marker-system
	    echo 'All three are here, and the installed Haskell packages suffice: going on without Hackage.'
	  else
	    touch $$marker-hackage
	    echo 'All three are here: going on with Hackage.'
	  fi
	} >&2

.PHONY: build
build: setup ## build bin/viscomplex
	@$(CABAL)
	build exe:viscomplex
	mkdir -p $(dir $(EXE))
	built=$$(cabal list-bin --builddir=$(BUILDDIR) $(CABAL_FLAGS) exe:viscomplex)
	cmp -s "$$built" $(EXE) || install -m 755 "$$built" $(EXE)

.PHONY: demo
demo: build ## run the main job on scenes/, into out/
	@mkdir -p out
	start=$$SECONDS
	for scene in $(SCENES); do
	  name=$$(basename "$$scene")
	  out=out/$${name%.*}
	  mkdir -p "$$out"
	  step() { "$(EXE)" "$$@" || { echo "demo: failed: $(EXE) $$*" >&2; exit 1; }; }
	  step info "$$scene" > "$$out/info.txt"
	  step graph "$$scene" > "$$out/graph.txt"
	  step factors "$$scene" --digits 17 > "$$out/factors.csv"
	  step draw scene "$$scene" -o "$$out/scene.svg"
	  step draw dual "$$scene" -o "$$out/dual.svg"
	  step draw matrix "$$scene" -o "$$out/matrix.svg"
	  step complex "$$scene" > "$$out/complex.json"
	  step verify "$$scene" > "$$out/verify.txt"
	  step draw view "$$scene" --corner 0.0 -o "$$out/view.svg"
	  step draw mesh "$$scene" -o "$$out/mesh.svg"
	  step draw radiosity "$$scene" --mesh sides -o "$$out/radiosity.svg"
	  printf '%-28s %7d visible pairs  %7d form factors  %s  scene.svg  dual.svg  view.svg  matrix.svg  mesh.svg  radiosity.svg\n' "$$out" \
	    "$$(wc -l < "$$out/graph.txt")" "$$(($$(wc -l < "$$out/factors.csv") - 1))" "$$(tail -n 1 "$$out/verify.txt")"
	done
	echo
	echo "$(words $(SCENES)) scenes in $$((SECONDS - start)) s. Look at out/*/scene.svg, dual.svg, view.svg, matrix.svg, mesh.svg and radiosity.svg; numbers are in graph.txt, factors.csv, complex.json and info.txt beside them."

# The figures of docs/degeneracies.md that show more than the scene with its free bitangents.
define FIGURE_OF
figure_of() {
  case "$$1" in
    wall-alone|parallel|verticals|aligned-walls|separated|wall-straight) echo dual ;;
    behind-ends|behind-goes-on) echo view --corner 0.0 ;;
    tips-apart|tips-touch|grazing-a-contact) echo view --corner 2.0 ;;
    corner-on-side|side-overhang) echo view --side 0.2 ;;
    wall-along-side) echo view --side 0.0 ;;
    several-contacts) echo view --corner 0.3 ;;
    fan|walls-L) echo view --corner 0.0 ;;
    ring-of-three) echo view --from 1,1/2 ;;
    divided-room) echo view --corner E.0 ;;
    *) echo scene ;;
  esac
}
endef

.PHONY: degenerate
degenerate: build ## draw the figures of docs/degeneracies.md anew, from scenes/degenerate
	@$(FIGURE_OF)
	mkdir -p docs/figures/degenerate
	for scene in scenes/degenerate/*.json; do
	  name=$$(basename "$$scene" .json)
	  "$(EXE)" draw $$(figure_of "$$name") "$$scene" -o "docs/figures/degenerate/$$name.svg"
	done

.PHONY: gallery
gallery: build ## draw the figures of docs/gallery.md anew
	@out=docs/figures/gallery
	mkdir -p "$$out"
	draw() { "$(EXE)" draw "$${@:2}" -o "$$out/$$1.svg"; }
	draw ordp-9-radiosity radiosity scenes/ordp-9.json --mesh discontinuity --profile E.1 --profile 4.3
	draw ordp-9-dual dual scenes/ordp-9.json
	draw ordp-9-matrix matrix scenes/ordp-9.json
	draw ordp-9-mesh mesh scenes/ordp-9.json --breaks shadow-limits --lines
	draw flat-radiosity radiosity scenes/flat.json --mesh discontinuity --profile 1.2
	draw flat-dual dual scenes/flat.json
	draw flat-matrix matrix scenes/flat.json
	draw flat-mesh mesh scenes/flat.json

# hspec's summary is "N examples, N failures[, N pending]". A pending test counts as failed, and so does a run that
# ends without a summary or without a single test.
define COUNT
passed=0; failed=0
count() {
  local line examples failures pending
  line=$$(grep -E '^[0-9]+ examples?, [0-9]+ failures?' "$$1" | tail -n 1) || { failed=$$((failed + 1)); return; }
  examples=$$(sed -E 's/^([0-9]+) example.*/\1/' <<< "$$line")
  failures=$$(sed -E 's/.*, ([0-9]+) failure.*/\1/' <<< "$$line")
  pending=$$(sed -nE 's/.*, ([0-9]+) pending.*/\1/p' <<< "$$line")
  pending=$${pending:-0}
  passed=$$((passed + examples - failures - pending))
  failed=$$((failed + failures + pending))
  if [ "$$examples" = 0 ] || { [ "$$2" != 0 ] && [ "$$failures" = 0 ]; }; then failed=$$((failed + 1)); fi
}
verdict() { echo "$$passed passed, $$failed failed"; [ "$$failed" = 0 ]; }
endef

# Both levels are built and run at the same time, each by one thread: on two cores that is faster than one after the
# other by two threads.
.PHONY: test
test: setup ## all tests, at -O2 and once at -O0; the last line is "N passed, N failed"
	@$(CABAL)
	$(COUNT)
	logs=$$(mktemp -d); beside=
	trap '[ -z "$$beside" ] || kill -- "-$$beside" 2>/dev/null || true; rm -rf "$$logs"' EXIT
	# hspec-discover runs only when Spec.hs is compiled, so a new spec must touch it.
	specs=$$(find test -name '*Spec.hs' | sort)
	mkdir -p $(BUILDDIR)
	if [ "$$specs" != "$$(cat $(BUILDDIR)/specs 2>/dev/null)" ]; then touch test/Spec.hs; echo "$$specs" > $(BUILDDIR)/specs; fi
	hpack --silent --force
	export DESCRIBED=yes
	run() { # level, executable, that of the suite, options of hspec
	  echo; echo "== tests at $$1"
	  VISCOMPLEX_EXE="$$2" "$${@:3}" 2>&1 | tee "$$logs/$$1"
	}
	unbuilt() { echo "The tests could not be built at $$1."; touch "$$logs/$$1-unbuilt"; return 1; }
	optimised() {
	  { $(MAKE) build CABAL_FLAGS='$(CABAL_FLAGS) --ghc-options=-j1' && build --ghc-options=-j1 test:spec; } || unbuilt -O2 || return
	  run -O2 "$$PWD/$(EXE)" "$$(cabal list-bin --builddir=$(BUILDDIR) $(CABAL_FLAGS) --ghc-options=-j1 test:spec)"
	}
	unoptimised() {
	  local o0=(--builddir=$(BUILDDIR)/O0 -O0 --ghc-options='-O0 -j1')
	  bin() { cabal list-bin "$${o0[@]}" $(CABAL_FLAGS) "$$1"; }
	  build "$${o0[@]}" exe:viscomplex test:spec || unbuilt -O0 || return
	  run -O0 "$$(bin exe:viscomplex)" "$$(bin test:spec)" --qc-max-success=$(O0_CASES)
	}
	judge() { # level, status of its suite
	  if [ -e "$$logs/$$1-unbuilt" ]; then failed=$$((failed + 1)); else count "$$logs/$$1" "$$2"; fi
	}
	# A process group of its own, so that all of it can be stopped.
	set -m; unoptimised > "$$logs/beside" 2>&1 & beside=$$!; set +m
	status=0; optimised || status=$$?
	judge -O2 "$$status"
	status=0; wait "$$beside" || status=$$?
	beside=
	cat "$$logs/beside"
	judge -O0 "$$status"
	verdict

.PHONY: soak
soak: SCENES = 1000000
soak: setup ## the sweeps against brute force on SCENES=1000000 random scenes, in two processes
	@$(CABAL)
	build bench:soak
	soak=$$(cabal list-bin --builddir=$(BUILDDIR) $(CABAL_FLAGS) bench:soak)
	logs=$$(mktemp -d); trap 'rm -rf "$$logs"' EXIT
	half=$$(($(SCENES) / 2))
	"$$soak" $$half $(SEED) > "$$logs/1" & first=$$!
	"$$soak" $$(($(SCENES) - half)) $$(($(SEED) + 1)) > "$$logs/2" & second=$$!
	status=0
	wait $$first || status=1
	wait $$second || status=1
	# Scenes that fail first, then the figures of both processes by family, added up.
	figures='^(.*): ([0-9]+) scenes, ([0-9]+) failed$$'
	cat "$$logs"/* | grep -Ev "$$figures" || true
	cat "$$logs"/* | sed -nE "s/$$figures/\2\t\3\t\1/p" | awk -F '\t' '
	  !($$3 in scenes) { order[++count] = $$3 }
	  { scenes[$$3] += $$1; failed[$$3] += $$2; all += $$1; wrong += $$2 }
	  END {
	    for (i = 1; i <= count; i++) printf "%-28s %9d scenes %5d failed\n", order[i], scenes[order[i]], failed[order[i]]
	    printf "%-28s %9d scenes %5d failed\n", "all", all, wrong
	  }'
	exit $$status

.PHONY: bench
bench: build ## time and space of the parts and of whole commands, beside bench/baseline
	@$(CABAL)
	build bench:time bench:space
	bin() { cabal list-bin --builddir=$(BUILDDIR) $(CABAL_FLAGS) "$$1"; }
	out=dist-newstyle/bench
	mkdir -p "$$out"
	rm -f "$$out"/*.csv
	VISCOMPLEX_EXE="$$PWD/$(EXE)" "$$(bin bench:time)" --time-limit 1 --csv "$$out/time.csv" > "$$out/time.log"
	"$$(bin bench:space)" > "$$out/space.csv"
	bash bench/ratios.sh bench/baseline "$$out"

.PHONY: ladder
ladder: build ## the sweeps on scenes of all families and sizes; BENCH_ARGS names families
	@$(CABAL)
	build bench:ladder
	"$$(cabal list-bin --builddir=$(BUILDDIR) $(CABAL_FLAGS) bench:ladder)" $(BENCH_ARGS)

.PHONY: bench-peers
bench-peers: build ## time the visibility graph against CGAL's, on the same scenes
	@$(INSTALLED)
	if ! installed $(PEER_PACKAGES); then
	  { command -v apt-get >/dev/null && install $(PEER_PACKAGES); } || { echo 'bench-peers needs CGAL and a C++ compiler (Debian: $(PEER_PACKAGES)).' >&2; exit 1; }
	fi
	mkdir -p dist-newstyle/peers
	peer=dist-newstyle/peers/visibility_graph
	[ "$$peer" -nt bench/peers/visibility_graph.cpp ] ||
	  g++ -O3 -DNDEBUG -std=c++17 bench/peers/visibility_graph.cpp -o "$$peer" -lgmp -lmpfr
	bash bench/peers/run.sh "$(EXE)" "$$peer" dist-newstyle/peers $(BENCH_ARGS)

.PHONY: figures
figures: ## turn the SVG in out/ into PNG, 800 pixels wide
	@$(INSTALLED)
	if ! command -v rsvg-convert >/dev/null; then
	  { command -v apt-get >/dev/null && install $(FIGURE_PACKAGES); } || { echo 'figures needs rsvg-convert (Debian: $(FIGURE_PACKAGES)).' >&2; exit 1; }
	fi
	shopt -s nullglob globstar
	figures=(out/**/*.svg)
	[ $${#figures[@]} -gt 0 ] || { echo 'There is no SVG in out/. Run make demo first.' >&2; exit 1; }
	for svg in "$${figures[@]}"; do rsvg-convert --width 800 --keep-aspect-ratio --background-color white "$$svg" -o "$${svg%.svg}.png"; done
	echo "$${#figures[@]} figures turned into PNG beside their SVG."

.PHONY: clean
clean: ## remove all that was built
	@rm -rf dist-newstyle bin out viscomplex.cabal
