#!/usr/bin/env bash
# unlit.sh … IN OUT: the lines of a Markdown file's ```haskell blocks, others empty, as GHC calls an unlit program: so the
# test `readme` is the program of README.md.
awk '/^```/ { inside = /^```haskell$/; print ""; next } { print inside ? $0 : "" }' "${@: -2:1}" > "${@: -1}"
