#!/usr/bin/env bash
# video_commands.sh MORPHCL SOURCE_DIR: runs every command of docs/video.md, with small pictures, in a folder of its own;
# each has to leave a file that ffmpeg decodes whole.
set -euo pipefail
tool=$1 source=$2
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
mkdir out bin
ln -s "$tool" bin/morphcl
ln -s "$source/demos" demos
export PATH=$folder/bin:$PATH

# The lines that are indented by four or six blanks and begin with a command.
commands=$(sed -nE 's/^(    |      )((morphcl|ffmpeg) .*)$/\2/p' "$source/docs/video.md")
count=0
while read -r command; do
  echo "$command"
  if [[ $command == morphcl* ]]; then
    eval "$command --frames 0-9 --size 63x35 --device reference --quiet" </dev/null
  else
    eval "${command/ffmpeg/ffmpeg -nostdin -loglevel error}"
    film=${command##* }
    [[ $(ffmpeg -nostdin -loglevel error -i "$film" -map 0:v -f framemd5 - | grep -vc '^#') -eq 10 ]] ||
      { echo "$film does not have the 10 frames"; exit 1; }
  fi
  count=$((count + 1))
done <<<"$commands"
[[ $count -ge 8 ]] || { echo "only $count commands were found"; exit 1; }
