#!/bin/sh
# Testing/Validation/run.sh [--quick] [RESULTS [CASE...]]
#
# What a solver gets from our meshes and from snappyHexMesh's, against references that are not ours. Results stay in RESULTS
# (by default build/validation): started again, it measures what is missing there, so take another folder for another
# commit. Two cases run at a time; cases that need more than 100,000 cells come last. With --quick only the coarse sizes of the others
# are measured; else the guide's page validation.md and its picture are written anew at the end.
set -eu
here=$(dirname "$(readlink -f "$0")")
quick=
large="backstep cylinder runners ahmed motorbike"
if [ "${1:-}" = --quick ]; then
  quick=--quick
  large=
  shift
fi
results=${1:-$here/../../build/validation}
[ $# -eq 0 ] || shift
# shellcheck disable=SC2086 # several words
[ $# -gt 0 ] || set -- made shell conjugate potential timestep channel pipe couette cavity $large
for plugins in "$here"/../../build/release/lib/paraview-*/plugins; do
  export PV_PLUGIN_PATH="$plugins"
done
export PYTHONDONTWRITEBYTECODE=1
printf '%s\n' "$@" | xargs -I '{}' -P 2 pvpython "$here/{}.py" "$results" $quick
[ -n "$quick" ] || pvpython "$here/page.py" "$results" "$here/../../Plugin/Help/validation.md"
