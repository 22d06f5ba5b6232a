"""What OpenFOAM's checkMesh says about the meshes of surfaces.

    export PV_PLUGIN_PATH=$PWD/build/release/lib/paraview-5.11/plugins
    pvpython Testing/Plugin/checkmesh.py [options] SURFACE...

  --sizes 12,25,60   cells along the longest side of the surface's bounding box
  --depths 0,2       RefinementDepth
  --set Name=Value   any other property of Cartesian Mesher, as in Python; may be repeated
  --all              checkMesh -allGeometry -allTopology
  --keep FOLDER      keep the cases in FOLDER/surface_size_depth
  --verbose          each failure, as checkMesh words it

A line for each mesh: OK or FAILS, seconds, cells, and the worst figures; at the end, how many are
OK. The exit code is 1 if any fails.
"""

import argparse
import ast
import pathlib
import sys
import tempfile
import time

from paraview import simple

import foam


def numbers(text):
    return [int(n) for n in text.split(",")]


def options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="+", type=pathlib.Path, metavar="SURFACE")
    parser.add_argument("--sizes", type=numbers, default=[12, 25, 60])
    parser.add_argument("--depths", type=numbers, default=[0, 2])
    parser.add_argument("--set", action="append", default=[], metavar="Name=Value")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--verbose", action="store_true")
    return parser.parse_args()


def value(text):
    try:
        return ast.literal_eval(text)
    except (SyntaxError, ValueError):
        return text  # an enumeration's name


def longest_side(surface):
    bounds = surface.GetDataInformation().GetBounds()
    return max(b - a for a, b in zip(bounds[0::2], bounds[1::2]))


def check(surface, size, depth, folder, chosen):
    """Prints the line of one mesh; whether it is OK."""
    properties = {name: value(text) for name, _, text in (s.partition("=") for s in chosen.set)}
    began = time.time()
    mesher = simple.CartesianMesher(Input=surface, CellSize=longest_side(surface) / size,
                                    RefinementDepth=depth, **properties)
    mesher.UpdatePipeline()
    seconds = time.time() - began
    if mesher.GetDataInformation().GetNumberOfCells() == 0:
        print("NO MESH", flush=True)
        return False
    try:
        foam.save(mesher, folder)
        simple.Delete(mesher)
        found = foam.CheckMesh(folder, *["-allGeometry", "-allTopology"] if chosen.all else [])
    except AssertionError as failure:
        print("FAILS", str(failure).splitlines()[-1], flush=True)
        return False
    print("OK   " if found.ok else "FAILS", f"{seconds:6.1f} s",
          "  ".join(f"{name} {figure:g}" for name, figure in found.figures.items()), flush=True)
    if chosen.verbose:
        for failure in found.failures:
            print("     ", failure)
    return found.ok


def main():
    chosen = options()
    verdicts = []
    with tempfile.TemporaryDirectory() as temporary:
        for path in chosen.surfaces:
            surface = simple.OpenDataFile(str(path))
            surface.UpdatePipeline()
            for size in chosen.sizes:
                for depth in chosen.depths:
                    print(f"{path.stem:30} 1/{size:<3} depth {depth} ", end="")
                    name = f"{path.stem}_{size}_{depth}"
                    folder = (chosen.keep or pathlib.Path(temporary)) / name
                    verdicts.append(check(surface, size, depth, folder, chosen))
            simple.Delete(surface)
    print(f"{sum(verdicts)} of {len(verdicts)} OK")
    sys.exit(0 if all(verdicts) else 1)


main()
