#!/usr/bin/env bash
# png.sh: turns the SVG in out/ into PNG, 800 pixels wide. `make figures` runs it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

command -v rsvg-convert > /dev/null || need figures rsvg-convert librsvg2-bin
shopt -s nullglob globstar
figures=(out/**/*.svg)
[ ${#figures[@]} -gt 0 ] || { echo 'There is no SVG in out/. Run make demo first.' >&2; exit 1; }
for svg in "${figures[@]}"; do
  rsvg-convert --width 800 --keep-aspect-ratio --background-color white "$svg" -o "${svg%.svg}.png"
done
echo "${#figures[@]} figures turned into PNG beside their SVG."
