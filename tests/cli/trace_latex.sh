#!/bin/sh
# usage: trace_latex.sh MORPHCL SOURCES PDFLATEX
# What `morphcl trace --latex` prints compiles by itself, in every convention, for long chains and hostile names.
set -eu
tool=$1 sources=$2 pdflatex=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > odd.toml <<'SHOT'
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[[object]]
name = "a_b#c$d%e&f{g}h~i^j\\k<l>\"m é"
mesh = "cube"
[[object.transform]]
scale = [1e-9, 0, 1e12]
SHOT
compile() {
  "$tool" trace "$@" --latex > trace.tex
  "$pdflatex" -interaction=nonstopmode -halt-on-error trace.tex > log.txt || { cat log.txt; exit 1; }
  test -s trace.pdf
  rm trace.pdf
}
compile "$sources/demos/pyramid_to_cube.toml" --frame 37 --vertex 4
compile "$sources/demos/pyramid_to_cube.toml" --frame 37 --vectors row --handedness left --ndc-depth zero_to_one
compile "$sources/docs/seven_steps.toml" --object "box after 7" --frame 7
compile "$sources/demos/teapots.toml"
compile "$sources/demos/floor_plan.toml" --pixel 640,360
compile "$sources/demos/pyramid_to_cube.toml" --frame 50 --size 640x360 --pixel 320,180
compile odd.toml
compile odd.toml --point 0,0,1e-10
