"""Ghost cells are those that VTK's generator finds among all cells. Runs on all ranks (--sym)."""

import numpy as np
import pipeline
from cartesianmesher.vtkCartesianMesherFilters import vtkCartesianMesher
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersParallelDIY2 import vtkGhostCellsGenerator
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import pieces
from polyhedra import cell_types, face_streams

RANKS = vtkMultiProcessController.GetGlobalController()
assert RANKS.GetNumberOfProcesses() > 1


def described(grid):
    """By their ids: the cells with whether they are own, the ids of their points and their arrays;
    the points with their place and whether they are ghosts."""
    names = vtk_to_numpy(grid.GetPointData().GetGlobalIds()).tolist()
    duplicates = vtk_to_numpy(grid.GetPointData().GetArray("vtkGhostType")).tolist()
    places = vtk_to_numpy(grid.GetPoints().GetData()).tolist()
    attributes = grid.GetCellData()
    arrays = [vtk_to_numpy(attributes.GetArray(i)).tolist()
        for i in range(attributes.GetNumberOfArrays())
        if attributes.GetArrayName(i) not in ("vtkGhostType", "vtkGlobalCellIds")]
    ids = vtk_to_numpy(attributes.GetArray("CellId")).tolist()
    own = pieces.own_cells(grid).tolist()
    stream, starts = (array.tolist() for array in face_streams(grid))
    cells = {ids[c]: (own[c], [[names[p] for p in loop]
                for loop in pieces.loops(grid, c, stream, starts[c])],
            [array[c] for array in arrays])
        for c in range(grid.GetNumberOfCells())}
    return cells, dict(zip(names, zip(places, duplicates)))


def mesh_of(source, size, depth, levels):
    mesher = vtkCartesianMesher()
    mesher.SetInputConnection(source.GetOutputPort())
    mesher.SetCellSize(size)
    mesher.SetRefinementDepth(depth)
    mesher.UpdatePiece(RANKS.GetLocalProcessId(), RANKS.GetNumberOfProcesses(), levels)
    return mesher.GetOutput()


def assert_ghosts(source, size, depth, levels):
    mesh = mesh_of(source, size, depth, levels)
    own = mesh_of(source, size, depth, 0)
    generator = vtkGhostCellsGenerator()
    generator.SetInputData(own)
    generator.SetNumberOfGhostLayers(levels)
    generator.BuildIfRequiredOff()
    generator.Update()
    found, expected = described(mesh), described(generator.GetOutputDataObject(0))
    types = cell_types(mesh)
    assert (np.diff(types) >= 0).all(), "hexahedra are not first"
    ghosts = len(found[0]) - own.GetNumberOfCells()
    assert ghosts > 50 * levels, f"{ghosts} ghost cells"
    assert found[0] == expected[0], f"cells: {len(found[0])}, with VTK's ghosts {len(expected[0])}"
    assert found[1] == expected[1], f"points: {len(found[1])}, with VTK's ghosts {len(expected[1])}"
    print(RANKS.GetLocalProcessId(), levels, own.GetNumberOfCells(), "cells", ghosts, "ghosts")


spot = vtkOBJReader()
spot.SetFileName(str(pipeline.DATA / "cino_spot.obj"))
for source, size in (spot, 0.05), (vtkSphereSource(), 0.05):
    for depth in 0, 1:
        for levels in 1, 2:
            assert_ghosts(source, size, depth, levels)
