#!/usr/bin/env bash
# other_mattes.sh MORPHCL OIIOTOOL: OpenImageIO's tool reads a Cryptomatte as its specification says, and finds for each
# object the share of each pixel that the object has when it is unlit white and all others are black: to the last bit,
# by the reference renderer.
set -euo pipefail
tool=$1 oiiotool=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# shot FILE [WHITE]: four objects before and behind each other, lit, or one of them white and the others black.
shot() {
  cat <<'SHOT'
[image]
size = [160, 90]
samples = 8
channels = ["RGBA", "crypto_object"]
[camera]
eye = [2.2, 1.6, 3.4]
target = [0, 0, 0]
SHOT
  local name mesh place
  while IFS='|' read -r name mesh place; do
    printf '[[object]]\nname = "%s"\nmesh = "%s"\ntransform = [{ translate = [%s] }]\n' "$name" "$mesh" "$place"
    [[ $# -eq 0 ]] || printf 'shading = "unlit"\ncolor = %s\n' "$([[ $1 == "$name" ]] && echo '[1, 1, 1]' || echo '[0, 0, 0]')"
  done <<'OBJECTS'
ball|sphere|0, 0, 0
box|cube|0.9, 0.1, -0.3
ring|torus|-0.8, 0.2, 0.4
far box|cube|0.2, 0.6, -1.4
OBJECTS
}

# The first channel of an EXR file, as numbers.
numbers() { "$oiiotool" --dumpdata "$1" | sed -nE 's/^ *Pixel \([0-9, ]+\): *//p' | cut -d ' ' -f 1; }

shot >all.toml
"$tool" render all.toml --device reference --quiet -o 'all.#.exr'
manifest=$("$oiiotool" --info -v all.0000.exr | sed -nE 's/^ *cryptomatte\/[0-9a-f]{7}\/manifest: "(.*)"$/\1/p')
while IFS='|' read -r name bits; do
  id=$(python3 -c "import struct; print(repr(struct.unpack('>f', bytes.fromhex('$bits'))[0]))")
  # The sum over six ranks of the coverage where the rank's number is the object's.
  ranks=()
  for layer in 0 1 2; do
    for pair in R,G B,A; do
      ranks+=(all.0000.exr --ch "crypto_object0$layer.${pair%,*}" --subc "$id" --abs --mulc 1e38 --clamp:min=0:max=1 --mulc -1
        --addc 1 all.0000.exr --ch "crypto_object0$layer.${pair#*,}" --mul)
      [[ ${#ranks[@]} -lt 20 ]] || ranks+=(--add)
    done
  done
  "$oiiotool" "${ranks[@]}" --chnames Y -d float -o matte.exr
  shot "$name" >white.toml
  "$tool" render white.toml --channels RGBA --device reference --quiet -o 'white.#.exr'
  "$oiiotool" white.0000.exr --ch R --chnames Y -d float -o share.exr
  rm white.0000.exr
  diff <(numbers matte.exr) <(numbers share.exr) >/dev/null || { echo "the matte of \"$name\" is another one"; exit 1; }
  shares=$(numbers matte.exr | sort -u | wc -l)
  echo "$name: $shares different shares"
  [[ $shares -ge 5 ]] || { echo "\"$name\" has hardly an edge"; exit 1; }
done < <(python3 -c 'import json, sys; [print(*pair, sep="|") for pair in json.loads(sys.argv[1]).items()]' "$manifest")
