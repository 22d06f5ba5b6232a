#!/bin/sh
# Testing/Benchmark/record.sh [TABLE...]
#
# Measures what README.md and the Help pages say in figures: a line each in RECORD.md, and the output in record/, with command, commit, date and
# machine. Without a TABLE: all that have no record of this commit; ten to forty minutes each, on a machine that has nothing
# else to do. Needs the preset release, built. Scans are read from $SURFACES, by default ../shared/surfaces: none are
# measured where there is no such folder.
set -eu
cd "$(dirname "$(readlink -f "$0")")/../.."
surfaces=${SURFACES:-$(pwd)/../shared/surfaces}
scans="vtk_lucy.ply vtk_turbineblade.ply elmer_femur.ply"
motorbike=/usr/share/doc/openfoam-examples/examples/resources/geometry/motorBike.obj.gz
bin=build/release/bin
for plugins in build/release/lib/paraview-*/plugins; do
  export PV_PLUGIN_PATH="$PWD/$plugins"
done

tables="growth stages surfaces scaling depth memory boxes compare fidelity tying merging quality scans walls conduction examples-header
  examples-jacket adaptation pieces"

# As ASCII STL, for Benchmark: the scans, or why there are none.
scans_as_stl() {
  mkdir -p build/scans
  for scan in $scans; do
    if [ -e "$surfaces/$scan" ]; then
      stl=build/scans/${scan%.*}.stl
      [ -e "$stl" ] || pvpython -c "from paraview.simple import *
SaveData('$stl', proxy=PLYReader(FileNames=['$surfaces/$scan']), FileType='Ascii')" >&2
      echo "$stl"
    else
      echo "$scan is not in $surfaces: not measured" >&2
    fi
  done
}

# boundary_off SIZES PROPERTY VALUE...: how far the boundary is from smooth surfaces, for each value.
boundary_off() {
  sizes=$1 property=$2
  shift 2
  for value in "$@"; do
    echo "$property = $value"
    pvpython Testing/Benchmark/wallcells.py fidelity sphere torus Data/cino_spot.obj --sizes "$sizes" --turns 1 --domains inside \
      --meshers 0 --set SmallCellRatio=1e-9 --set "$property=$value"
  done
}

do_table() {
  case $1 in
    growth | memory) $bin/Benchmark "$1" 1 ;;
    stages) $bin/Benchmark stages 1 2 ;;
    boxes) $bin/Benchmark refinement ;;
    depth) $bin/Benchmark depth ;;
    scaling)
      mkdir -p build/scaling
      gunzip -c "$motorbike" > build/scaling/motorBike.obj
      cp Testing/Benchmark/motorBike.toml build/scaling
      $bin/Benchmark scaling
      $bin/Benchmark scaling build/scaling/motorBike.toml
      head=$surfaces/wallaby_cylinder_head_r80.stl
      [ ! -e "$head" ] || $bin/Benchmark scaling "$head"
      ;;
    surfaces)
      # shellcheck disable=SC2046 # a list of words
      set -- $(scans_as_stl 2> build/scans.txt)
      cat build/scans.txt
      $bin/Benchmark surfaces 1
      [ $# -eq 0 ] || $bin/Benchmark surfaces 1 "$@"
      ;;
    compare) pvpython Testing/Benchmark/compare.py --cells 500000 ;;
    fidelity) boundary_off 1/12,1/24,1/48 PatchMethod Automatic "Marching Cubes" ;;
    tying) boundary_off 1/25,1/60 Tying "Keep Nodes" "Move Nodes" ;;
    merging) boundary_off 1/40 MergeAngle 0 5 10 15 20 30 ;;
    quality) pvpython Testing/Benchmark/QualityTable.py sphere Data/*.stl Data/*.obj --across 12 25 60 ;;
    scans)
      for scan in wallaby_cylinder_head_r80.stl elmer_femur.ply vtk_lucy.ply; do
        [ ! -e "$surfaces/$scan" ] || set -- "$@" "$surfaces/$scan"
      done
      shift
      pvpython Testing/Benchmark/QualityTable.py "$@" --across 25 80
      ;;
    walls) pvpython Testing/Benchmark/wallcells.py cells sphere Data/kcl_exhaust_header_lumens.stl Data/tm_featuretype_occ.stl --size 1/25 ;;
    conduction) pvpython Testing/Plugin/TestHeat.py . "$bin/cartesian-mesher" ;;
    examples-header) pvpython Testing/Plugin/header.py "$surfaces" 3 1 ;;
    examples-jacket) pvpython Testing/Plugin/jacket.py . build/jacket ;;
    adaptation) pvpython Testing/Plugin/TestLoop.py . "$bin/cartesian-mesher" ;;
    pieces) pvpython Testing/Plugin/large.py . "$PWD/$bin/cartesian-mesher" build/large ;;
    *) echo "There is no table $1, only $tables" >&2 && return 2 ;;
  esac
}

if [ "${1:-}" = --here ]; then
  do_table "$2"
  exit
fi
all=$#
# shellcheck disable=SC2086 # a list of words
[ $# -gt 0 ] || set -- $tables
result=0
for table in "$@"; do
  if [ "$all" -gt 0 ] || ! .ci/record --has "$table"; then
    .ci/record "$table" Testing/Benchmark/record.sh --here "$table" || result=1
  fi
done
exit $result
