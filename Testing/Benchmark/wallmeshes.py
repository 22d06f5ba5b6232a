# SPDX-License-Identifier: BSD-3-Clause
"""A surface meshed by Cartesian Mesher and by snappyHexMesh at equal boxes, for wallcells.py: both from the
same file, both on one thread, both saved as an OpenFOAM case."""

import pathlib
import resource
import shutil
import time

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import foam
import snappy
from wallmeasures import Mesh

OURS, THEIRS = "Cartesian Mesher", "snappyHexMesh"
MESHERS = (OURS, THEIRS) if shutil.which("snappyHexMesh") else (OURS,)

MARGIN = 0.3  # of the surface's longest side, around it


class Meshed:
    """A case, the volume of each cell's box, and the mesher's seconds of CPU."""

    def __init__(self, folder, boxes, seconds):
        self.folder, self.boxes, self.seconds = pathlib.Path(folder), boxes, seconds
        self.mesh = Mesh(folder)


def make(mesher, surface, size, depth, folder, properties=None, layers=None, outside=False, fine=(), between=(0, 1), ground=False,
         zone=None):
    """A Meshed; AssertionError if there is no mesh. `layers`: how many, their ratio, the first one's height. `outside`:
    around the surface, in a box; or (low, high), in that one, whose sides are inlet (low x), outlet and sides, and with
    `ground` the one below ground. `fine`: of which solids boxes are refined to `depth`, if not of all; `between`: our
    Transition Layers, each of which is a pair of boxes or nearly so, and their nCellsBetweenLevels; `zone`: a box (low, high) and its depth."""
    if mesher == OURS:
        named = dict(zip(("Layers", "LayerExpansionRatio", "FirstLayerThickness"), layers or ()))
        if outside:
            low, high = box_around(surface) if outside is True else map(np.array, outside)
            named |= {"Domain": "Outside", "BoxFrom": "Bounds", "DomainBounds": np.stack([low, high], axis=1).ravel().tolist()}
        if fine:
            named["BoundaryRefinement"] = [entry for name in fine for entry in (surface.names.index(name), depth, 0, 0)]
        named |= {"RefinementDepth": 0 if fine else depth, "TransitionLayers": between[0], "Ground": "zMin" if ground else "None"}
        if zone:
            low, high = map(np.array, zone[:2])
            named |= {"RefinementShapes": ["box"], "RefinementPositions": low.tolist(),
                      "RefinementLengths": (high - low).tolist(), "RefinementShapeDepths": [zone[2]]}
        return make_ours(surface, size, folder, named | (properties or {}))
    return make_theirs(surface, size, depth, folder, layers, outside, fine, between[1], ground, zone)


def box_around(surface):
    low, high = surface.bounds()
    margin = MARGIN * (high - low).max()
    return low - margin, high + margin


def make_ours(surface, size, folder, properties):
    path = pathlib.Path(folder) / "constant" / "triSurface" / "surface.stl"
    surface.write(path)
    reader = simple.NamedSTLReader(FileName=str(path))
    reader.UpdatePipeline()
    mesher = simple.CartesianMesher(Input=reader, CellSize=size, NumberOfThreads=1, **properties)
    mesher.UpdateVTKObjects()
    filter = mesher.SMProxy.GetClientSideObject()
    begin = time.process_time()
    filter.Update()
    seconds = time.process_time() - begin
    grid = filter.GetOutputDataObject(0)
    assert grid.GetNumberOfCells(), f"no mesh of {surface.name}, for the reason above"
    level, number = (vtk_to_numpy(grid.GetCellData().GetArray(name)) for name in ("Level", "CellId"))
    level = level[np.argsort(number)].sum(axis=1)  # in the order of OpenFOAM's cells
    foam.save(mesher, folder)
    simple.Delete(mesher)
    simple.Delete(reader)
    return Meshed(folder, size ** 3 / 2.0 ** level, seconds)


def make_theirs(surface, size, depth, folder, layers, outside, fine, between, ground, zone):
    path = pathlib.Path(folder) / "constant" / "triSurface" / "surface.stl"
    surface.write(path)
    isBox = isinstance(outside, tuple)
    low, high = map(np.array, outside) if isBox else box_around(surface) if outside else surface.bounds()
    cells = np.ceil((high - low) / size - 1e-6).astype(int) if isBox else ((high - low) / size).astype(int) + 2
    low, high = (low, high) if isBox else (low - size / 2, low - size / 2 + size * cells)
    inside = [(low + 0.37 * size).tolist()] if outside else surface.points_inside(size)
    names = surface.names if len(surface.names) > 1 else []
    snappy.write_case(folder, low.tolist(), high.tolist(), cells.tolist(), inside, depth, names, features=True, layers=layers,
        fine=fine, between=between, zone=zone,
        sides=("inlet", "outlet", "sides", "sides", "ground" if ground else "sides", "sides") if isBox else ())
    foam.run(folder, "blockMesh")
    foam.run(folder, "surfaceFeatureExtract")
    begin = children_time()
    foam.run(folder, "snappyHexMesh", "-overwrite")
    seconds = children_time() - begin
    meshed = Meshed(folder, size ** 3, seconds)
    if (meshed.mesh.folder / "cellLevel").exists():
        level = meshed.mesh.lists("cellLevel", np.int32)[0]
        meshed.boxes = size ** 3 / 8.0 ** level
    return meshed


def children_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
