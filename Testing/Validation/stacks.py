# SPDX-License-Identifier: BSD-3-Clause
"""Layers at y+ 1: the share of the walls with whole stacks, what checkMesh says, and the mesher's seconds.

pvpython stacks.py [CASE...] [--layers 12,20] [--first 1e-2,1e-3,1e-4] [--keep FOLDER] [--set PROPERTY=NUMBER...]

First heights are by the box at the wall. A whole stack has all of its layers, the first within 5 % of its height."""

import argparse
import pathlib
import tempfile
import time

import harness  # noqa: F401 before what it finds
import numpy as np
from paraview import simple

import bodies
import foam
import walllayers
from wallmeasures import Mesh

RATIO = 1.2


def meshed(case, folder, properties):
    """Seconds of CPU, layers of a stack, and the share of the walls without any; the case is in the folder."""
    _, surface, size, _, _, named = case
    path = pathlib.Path(folder) / "surface.stl"
    surface.write(path)
    reader = simple.NamedSTLReader(FileName=str(path))
    named = {key: value(surface.names) if callable(value) else value for key, value in named.items()}
    mesher = simple.CartesianMesher(Input=reader, CellSize=size, NumberOfThreads=1, **named | properties)
    mesher.UpdateVTKObjects()
    filter = mesher.SMProxy.GetClientSideObject()
    begin = time.process_time()
    filter.Update()
    seconds = time.process_time() - begin
    arrays = filter.GetOutputDataObject(0).GetFieldData()
    layers, bare = (arrays.GetArray(name) for name in ("LayersOfAStack", "BoundaryBareAreas"))
    asked = [i for i in range(bare.GetNumberOfTuples()) if arrays.GetArray("BoundaryLayersAsked").GetTuple1(i)] if bare else []
    shares = sum(bare.GetTuple1(i) for i in asked) / sum(arrays.GetArray("BoundaryAreas").GetTuple1(i) for i in asked) if asked else 0
    layers = int(layers.GetTuple1(0)) if layers else 0
    foam.save(mesher, folder)
    for proxy in mesher, reader:
        simple.Delete(proxy)
    return seconds, layers, shares


def walls_of(mesh, case):
    from fnmatch import fnmatch
    return np.concatenate([np.r_[mesh.of_patch(name)] for name in mesh.patches if any(fnmatch(name, w) for w in case[4])])


def whole(mesh, walls, layers, first):
    walk = walllayers.Walk(mesh)
    is_whole = np.zeros(len(walls), bool)
    last = []
    for i, face in enumerate(walls):
        heights = walk.heights(face, layers)
        is_whole[i] = len(heights) == layers and abs(heights[0] / first - 1) <= walllayers.NEAR and heights[-1] > 0.5 * first
    area = mesh.sizes[walls]
    return (area * is_whole).sum() / area.sum()


def chosen_properties(texts):
    return {name: float(value) if "." in value else int(value) for name, value in (one.split("=") for one in texts)}


def check(folder):
    out = foam.run(folder, "checkMesh")
    text = out if isinstance(out, str) else getattr(out, "stdout", "")
    return [line.strip() for line in text.splitlines() if "***" in line or "Mesh OK" in line or "Failed" in line]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cases", nargs="*")
    parser.add_argument("--layers", default="0,12,20")
    parser.add_argument("--first", default="1e-2,1e-3,1e-4")
    parser.add_argument("--keep")
    parser.add_argument("--set", nargs="*", default=[])
    options = parser.parse_args()
    chosen = chosen_properties(options.set)
    for case in bodies.cases():
        if options.cases and case[0] not in options.cases:
            continue
        for layers in options.layers.split(","):
            for first in options.first.split(",") if layers != "0" else ["0"]:
                with tempfile.TemporaryDirectory() as scratch:
                    folder = pathlib.Path(options.keep) / f"{case[0]}-{layers}-{first}" if options.keep else pathlib.Path(scratch)
                    folder.mkdir(parents=True, exist_ok=True)
                    height = float(first) * case[3]
                    named = {"Layers": int(layers) if layers != "auto" else -1, "LayerExpansionRatio": RATIO, "FirstLayerThickness": height}
                    seconds, made, bare = meshed(case, folder, chosen | (named if layers != "0" else {}))
                    mesh = Mesh(folder)
                    walls = walls_of(mesh, case)
                    share = whole(mesh, walls, made, height) if made else float("nan")
                    print(f"{case[0]:12} {made:4} layers, first {first:>5}: {mesh.cells:8} cells {seconds:6.1f} s "
                          f"{1e6 * seconds / mesh.cells:6.1f} us/cell  whole {share:.4f} bare {bare:.4f}  {' | '.join(check(folder))}", flush=True)


if __name__ == "__main__":
    main()
