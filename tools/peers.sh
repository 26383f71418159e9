#!/usr/bin/env bash
# peers.sh [RUNS] [SIZE …]: times the visibility graph against CGAL's, on the same scenes. `make bench-peers` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

need bench-peers 'CGAL and a C++ compiler' g++ libcgal-dev
mkdir -p dist-newstyle/peers
peer=dist-newstyle/peers/visibility_graph
[ $peer -nt bench/peers/visibility_graph.cpp ] ||
  g++ -O3 -DNDEBUG -std=c++17 bench/peers/visibility_graph.cpp -o $peer -lgmp -lmpfr
bash bench/peers/run.sh $EXE $peer dist-newstyle/peers "$@"
