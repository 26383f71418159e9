#!/usr/bin/env bash
# degenerate.sh: draws the figures of docs/degeneracies.md anew, from scenes/degenerate. `make degenerate` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# The figures that show more than the scene with its free bitangents.
figure_of() {
  case "$1" in
    wall-alone | parallel | verticals | aligned-walls | separated | wall-straight) echo dual ;;
    behind-ends | behind-goes-on) echo view --corner 0.0 ;;
    tips-apart | tips-touch | grazing-a-contact) echo view --corner 2.0 ;;
    corner-on-side | side-overhang) echo view --side 0.2 ;;
    wall-along-side) echo view --side 0.0 ;;
    several-contacts) echo view --corner 0.3 ;;
    fan | walls-L) echo view --corner 0.0 ;;
    ring-of-three) echo view --from 1,1/2 ;;
    divided-room) echo view --corner E.0 ;;
    *) echo scene ;;
  esac
}

mkdir -p docs/figures/degenerate
for scene in scenes/degenerate/*.json; do
  name=$(basename "$scene" .json)
  $EXE draw $(figure_of "$name") "$scene" -o "docs/figures/degenerate/$name.svg"
done
