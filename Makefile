# `make` lists the targets. What takes more than a few lines is a script in tools/.

SHELL := /bin/bash
.DEFAULT_GOAL := help
MAKEFLAGS += --no-print-directory

# What a caller may set: where cabal builds, and its options;
export BUILDDIR ?= dist-newstyle
export CABAL_FLAGS ?=
# the scenes that `demo` runs, or for `soak`, how many random ones;
SCENES ?= $(sort $(wildcard scenes/*.json scenes/*.geojson scenes/*.wkt))
# the seed of `test` and `mutants`, otherwise a fixed one, and of `soak` and `fuzz`, otherwise a random one;
SEED ?=
# the QuickCheck cases of each property of `test` at -O0;
export O0_CASES ?=
# the arguments of the benchmarks;
BENCH_ARGS ?=
# and where it is not empty, `report` measures less.
QUICK ?=

.PHONY: help
help: ## this list
	@echo 'viscomplex: targets'
	@sed -nE 's/^([a-z-]+):.*## (.*)/  make \1\t\2/p' Makefile | expand -t 20

.PHONY: setup
setup: ## install what is missing (Debian 12: apt; elsewhere it says what is needed)
	@tools/setup.sh

.PHONY: build
build: setup ## build bin/viscomplex
	@tools/build.sh

.PHONY: demo
demo: build ## run the main job on scenes/, into out/
	@tools/demo.sh $(SCENES)

.PHONY: degenerate
degenerate: build ## draw the figures of docs/degeneracies.md anew, from scenes/degenerate
	@tools/degenerate.sh

.PHONY: gallery
gallery: build ## draw the figures of docs/gallery.md and docs/sweep.md anew
	@tools/gallery.sh
	@tools/sweep.sh

.PHONY: test
test: setup ## all tests, at -O2 and once at -O0; the last line is "N passed, N failed"
	@tools/test.sh $(SEED)

.PHONY: test-bare
test-bare: ## demo and test in a bare Debian 12, made for it (as root)
	@tools/bare.sh

.PHONY: soak
soak: SCENES = 1000000
soak: setup ## the sweeps against brute force on SCENES=1000000 random scenes, in two processes
	@tools/soak.sh $(SCENES) $(SEED)

.PHONY: fuzz
fuzz: MINUTES = 10
fuzz: setup ## change the files of test/corpus at random for MINUTES=10, looking for one that is treated wrongly
	@tools/fuzz.sh $(MINUTES) $(SEED)

.PHONY: mutants
mutants: COUNT = 30
mutants: GROUPS = predicates roots sweep boundary
mutants: setup ## COUNT=30 small faults in each of GROUPS="roots sweep …", looking for one that no test notices
	@tools/mutants.sh $(COUNT) $(or $(SEED),1) $(GROUPS)

.PHONY: bench
bench: build ## time and space of the parts and of whole commands, beside bench/baseline
	@tools/bench.sh

.PHONY: report
report: build ## speed against error, into docs/report (minutes); QUICK=1: within one, into dist-newstyle/report
	@. tools/common.sh; build bench:report; "$$(built bench:report)" $$EXE $(if $(QUICK),dist-newstyle/report quick,docs/report)

.PHONY: ladder
ladder: build ## the sweeps, and growth of all commands, on scenes of all kinds and sizes; BENCH_ARGS names kinds
	@. tools/common.sh; build bench:ladder; "$$(built bench:ladder)" $(BENCH_ARGS)

.PHONY: bench-peers
bench-peers: build ## time the visibility graph against CGAL's, on the same scenes
	@tools/peers.sh $(BENCH_ARGS)

.PHONY: figures
figures: ## turn the SVG in out/ into PNG, 800 pixels wide
	@tools/png.sh

.PHONY: man
man: build ## write the manual page, out/viscomplex.1
	@mkdir -p out && bin/viscomplex --man > out/viscomplex.1 && echo out/viscomplex.1

.PHONY: clean
clean: ## remove all that was built
	@rm -rf dist-newstyle bin out
