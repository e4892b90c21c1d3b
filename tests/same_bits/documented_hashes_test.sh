#!/usr/bin/env bash
# documented_hashes_test.sh SHOT_HASHES PAGE SHOT...: the reference renderer draws each shot with the hashes that the page
# names, and the page names those of every shot.
set -euo pipefail
program=$1 page=$2
shift 2
documented() { sed -nE 's/^\| ([^ ]+) \| (-?[0-9]+) \| .([0-9a-f]{32}). \|$/\1 \2 \3/p' "$page"; }
drawn=$("$program" reference 160x90 3 "$@")
[[ -n $drawn ]]
diff <(documented | sort) <(sort <<<"$drawn") || {
  echo "< $page, > drawn: pixels changed, or the page is old (scripts/same_bits --write)"
  exit 1
}
