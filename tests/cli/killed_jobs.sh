#!/usr/bin/env bash
# Kills jobs at random moments, resumes them, and compares what they leave with a job that nobody killed.
#
#   tests/cli/killed_jobs.sh TOOL KILLS [OPTION...]     options of `morphcl render`, as --device reference
#
# Every run is a PID namespace of its own, where that is allowed, so that process numbers come again as in a container
# that is restarted. Prints one line; exit code 1 when a pixel hash differs or anything is left behind.
set -euo pipefail
tool=$(realpath "$1")
kills=$2
shift 2
shot=$(realpath "$(dirname "$0")/../../demos/pyramid_to_cube.toml")

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/tmp"
export TMPDIR=$folder/tmp
namespace=(unshare --pid --fork --kill-child)
"${namespace[@]}" true 2>/dev/null || namespace=(unshare --user --map-root-user --pid --fork --kill-child)
"${namespace[@]}" true 2>/dev/null || namespace=()

# job OUTPUT LIMIT OPTION...: the exit code is 137, or 124 from `timeout` itself, when the limit, in seconds, has killed it
job() {
  local output=$1 limit=$2
  shift 2
  "${namespace[@]}" timeout -s KILL "$limit" "$tool" render "$shot" --frames 0-60 --size 320x180 --resume --json --quiet \
    -o "$output/cube.####.exr" "$@"
}
hashes() { grep '"type":"frame"' | sed -E 's/.*"frame":(-?[0-9]+).*"hash":"([0-9a-f]+)".*/\1 \2/' | sort -n; }
fail() {
  echo "killed_jobs: $*" >&2
  exit 1
}

start=$(date +%s%N)
job "$folder/whole" 300 "$@" | hashes > "$folder/whole.txt" || fail "the job that nobody kills fails"
[[ $(wc -l < "$folder/whole.txt") == 61 ]] || fail "the job that nobody kills does not end"
milliseconds=$((($(date +%s%N) - start) / 1000000))

killed=0 rounds=0
while ((killed < kills)); do
  rounds=$((rounds + 1))
  output=$folder/round
  while :; do
    limit=0.$(printf %03d $((RANDOM % (milliseconds < 900 ? milliseconds + 100 : 999))))
    ((killed < kills)) || limit=300
    code=0
    job "$output" "$limit" "$@" > "$folder/round.txt" 2> "$folder/errors.txt" || code=$?
    ((code == 137 || code == 124)) || break
    killed=$((killed + 1))
  done
  ((code == 0)) || fail "a resumed job ended with $code: $(cat "$folder/errors.txt")"
  hashes < "$folder/round.txt" | cmp -s - "$folder/whole.txt" || fail "pixel hashes differ after $killed kills"
  left=$(find "$output" "$TMPDIR" -mindepth 1 ! -name 'cube.[0-9]*.exr')
  [[ -z $left ]] || fail "left behind after $killed kills: $left"
  rm -rf "$output"
done
if [[ -n ${MORPHCL_CACHE_DIR:-} && -d $MORPHCL_CACHE_DIR ]]; then
  left=$(find "$MORPHCL_CACHE_DIR" -name '*.morphcl-tmp')
  [[ -z $left ]] || fail "left behind in the kernel cache: $left"
fi
echo "$killed kills in $rounds rounds: 61 equal hashes each, nothing left behind"
