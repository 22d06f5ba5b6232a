#!/bin/sh
# ./demo.sh [SURFACE] [CELL_SIZE]
#
# Meshes a surface (STL, OBJ, PLY, VTP, STEP, IGES or BREP), prints the statistics, and writes the mesh (.vtu) and a
# picture of it cut open (.png) into the current folder. CELL_SIZE is a length in the surface's
# units; without it, 1/50 of the longest side of the surface's bounding box.
set -eu
here=$(dirname "$(readlink -f "$0")")
surface=${1:-$here/Data/kcl_exhaust_header_lumens.stl}
cell_size=${2:-0}

"$here/.ci/install"
(
  cd "$here"
  cmake --preset release --log-level=WARNING
  cmake --build --preset release --target CartesianMesher vtkCartesianMesherFiltersPython
)
for plugins in "$here"/build/release/lib/paraview-*/plugins; do
  export PV_PLUGIN_PATH="$plugins"
done
exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  pvpython "$here/Plugin/demo.py" "$surface" "$cell_size"
