#!/usr/bin/env bash
# example.sh: builds and runs the examples, which are packages of their own that depend on this one.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build toy-graph
"$(built toy-graph)"
