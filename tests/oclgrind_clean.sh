#!/bin/sh
# Runs PROGRAM ARGS... with Oclgrind as the OpenCL device and fails if it reports anything: an access outside a buffer, a
# data race, a wrong call of the API. (Its search for uninitialised memory takes all that the host writes through mapped
# buffers for uninitialised, up to version 21.10 at least.)
# Usage: oclgrind_clean.sh PROGRAM ARGS...
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# No cached binaries: Oclgrind reads sources. No optimisation: inlining leaves intrinsics behind that it does not know.
MORPHCL_CACHE_DIR=- oclgrind --build-options -cl-opt-disable --check-api --data-races --log "$work/report" "$@"
status=$?
if [ -s "$work/report" ]; then
  cat "$work/report" >&2
  exit 1
fi
exit "$status"
