#!/usr/bin/env bash
# demo.sh SCENE …: runs the main job on each scene, into out/. `make demo` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

step() { $EXE "$@" || { echo "demo: failed: $EXE $*" >&2; exit 1; }; }

start=$SECONDS
for scene in "$@"; do
  name=$(basename "$scene")
  out=out/${name%.*}
  mkdir -p "$out"
  step info "$scene" > "$out/info.txt"
  step graph "$scene" > "$out/graph.txt"
  step factors "$scene" --digits 17 > "$out/factors.csv"
  step draw scene "$scene" -o "$out/scene.svg"
  step draw dual "$scene" -o "$out/dual.svg"
  step draw matrix "$scene" -o "$out/matrix.svg"
  step complex "$scene" > "$out/complex.json"
  step verify "$scene" > "$out/verify.txt"
  step draw view "$scene" --corner 0.0 -o "$out/view.svg"
  step draw mesh "$scene" -o "$out/mesh.svg"
  step draw radiosity "$scene" --mesh sides -o "$out/radiosity.svg"
  printf '%-28s %7d visible pairs  %7d form factors  %s  %s\n' "$out" \
    "$(wc -l < "$out/graph.txt")" "$(($(wc -l < "$out/factors.csv") - 1))" "$(tail -n 1 "$out/verify.txt")" \
    'scene.svg  dual.svg  view.svg  matrix.svg  mesh.svg  radiosity.svg'
done
echo
echo "$# scenes in $((SECONDS - start)) s. Look at out/*/scene.svg, dual.svg, view.svg, matrix.svg, mesh.svg and" \
  "radiosity.svg; numbers are in graph.txt, factors.csv, complex.json and info.txt beside them."
