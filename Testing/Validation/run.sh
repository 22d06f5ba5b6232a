#!/bin/sh
# Testing/Validation/run.sh [--quick] [RESULTS [CASE...]]
#
# What a solver gets from our meshes and from snappyHexMesh's, against references that are not ours. Results stay in RESULTS
# (by default build/validation): started again, it measures what is missing there, so take another folder for another
# commit. With --quick the coarse sizes alone; else the guide's page validation.md is written anew at the end.
set -eu
here=$(dirname "$(readlink -f "$0")")
quick=
if [ "${1:-}" = --quick ]; then
  quick=--quick
  shift
fi
results=${1:-$here/../../build/validation}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- shell made pipe cylinder
for plugins in "$here"/../../build/release/lib/paraview-*/plugins; do
  export PV_PLUGIN_PATH="$plugins"
done
export PYTHONDONTWRITEBYTECODE=1
for case in "$@"; do
  pvpython "$here/$case.py" "$results" $quick
done
[ -n "$quick" ] || pvpython "$here/page.py" "$results" "$here/../../Plugin/Help/validation.md"
