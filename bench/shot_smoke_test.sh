#!/usr/bin/env bash
# shot_smoke_test.sh SHOT DRAW PICTURE TOOL SCENE: the last of 3 frames of the scene, drawn by the tool from the printed
# shot and by the benchmark, covers as many pixels, but for 4 whose centre lies on an edge that is rounded apart.
set -euo pipefail
shot=$1 draw=$2 picture=$3 tool=$4 scene=$5
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

options=("$scene" --frames 3 --size 160x120)
"$shot" "${options[@]}" >"$folder/scene.toml"
"$tool" render "$folder/scene.toml" --frames 2 --device 0 --quiet -o "$folder/frame.####.exr"
covered() { grep -oE '"covered": ?[0-9]+' | grep -oE '[0-9]+'; }
drawn=$("$draw" "${options[@]}" | covered)
written=$("$picture" "$folder/frame.0002.exr" | covered)
echo "$scene: $drawn pixels drawn, $written written"
((drawn > 0 && drawn - written <= 4 && written - drawn <= 4))
