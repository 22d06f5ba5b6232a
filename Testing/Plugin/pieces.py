"""Pieces of a mesh put together by their global ids, to compare them with the whole."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from polyhedra import face_streams

CELL_ARRAYS = "GlobalBox", "Level", "RefinementLevel", "Region", "VolumeFraction", "CellId"


def load(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def own_cells(grid):
    """Whether each cell is no ghost."""
    ghosts = grid.GetCellData().GetArray("vtkGhostType")
    return np.ones(grid.GetNumberOfCells(), bool) if ghosts is None \
        else vtk_to_numpy(ghosts) & vtkDataSetAttributes.DUPLICATECELL == 0


def loops(grid, cell, stream, start):
    """The points of a cell: of each face, or of the hexahedron."""
    if start < 0:
        ids = grid.GetCell(cell).GetPointIds()
        return [[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
    faces, at = [], start + 1
    for _ in range(stream[start]):
        faces.append(stream[at + 1:at + 1 + stream[at]])
        at += 1 + stream[at]
    return faces


def cells(grid, points):
    """Of each cell by its id: its loops with the numbers `points` for its points, and its arrays."""
    stream, starts = (array.tolist() for array in face_streams(grid))
    arrays = [vtk_to_numpy(grid.GetCellData().GetArray(name)) for name in CELL_ARRAYS]
    own = own_cells(grid)
    return {arrays[-1][c]: ([[points[p] for p in loop] for loop in loops(grid, c, stream, starts[c])],
                            [array[c].tolist() for array in arrays])
        for c in range(grid.GetNumberOfCells()) if own[c]}


def rows(grid):
    """What boundary each face of the mesh is of."""
    return vtk_to_numpy(grid.GetFieldData().GetArray("BoundaryOfFaces")).tolist()


def assert_union(whole, pieces):
    """Together the pieces have the whole's points, bit for bit, its cells and its boundary faces."""
    points = vtk_to_numpy(whole.GetPoints().GetData())
    expected = cells(whole, range(len(points)))
    found, used, boundary = {}, set(), []
    for piece in pieces:
        ids = vtk_to_numpy(piece.GetPointData().GetGlobalIds()).tolist()
        assert np.array_equal(vtk_to_numpy(piece.GetPoints().GetData()), points[ids])
        mine = cells(piece, ids)
        assert not set(mine) & set(found), "a cell is in two pieces"
        found |= mine
        used |= set(ids)
        boundary += rows(piece)
    assert used == set(range(len(points))), f"{len(used)} points instead of {len(points)}"
    assert len(found) == len(expected), f"{len(found)} cells instead of {len(expected)}"
    assert found == expected, "cells differ"
    assert boundary == rows(whole), "boundary faces differ"
