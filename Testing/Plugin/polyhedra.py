"""The cells of grids and the faces of polyhedra, however this version of VTK stores them.

The faces are one stream of numbers, which has for each polyhedron the number of its faces, then the size and points of each. Up to VTK 9.3
grids hold this stream; from 9.4 on, an array of faces and, for each cell, a list of them.
"""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkCellArray, vtkUnstructuredGrid

STREAMS = not hasattr(vtkUnstructuredGrid, "GetPolyhedronFaces")


def face_streams(grid):
    """The stream, and where in it each cell begins: -1 if that is no polyhedron."""
    stored = grid.GetFaces() if STREAMS else grid.GetPolyhedronFaces()
    if not stored or VTK_POLYHEDRON not in cell_types(grid):
        return np.empty(0, np.int64), np.full(grid.GetNumberOfCells(), -1)
    if STREAMS:
        return vtk_to_numpy(stored), vtk_to_numpy(grid.GetFaceLocations())
    return joined(*offsets_and_values(stored), *offsets_and_values(grid.GetPolyhedronFaceLocations()))


def face_arrays(grid):
    """The same as VTK's arrays; None for each where there is no polyhedron."""
    stream, starts = face_streams(grid)
    return (id_array(stream), id_array(starts)) if len(stream) else (None, None)


def set_face_streams(grid, stream, starts):
    """Gives the grid's cells other faces."""
    types, cells = type_array(grid), grid.GetCells()
    if STREAMS:
        grid.SetCells(types, cells, id_array(starts), id_array(stream))
        return
    faces, of_cells = vtkCellArray(), vtkCellArray()
    for start in starts:
        count, at = (stream[start], start + 1) if start >= 0 else (0, 0)
        of_cells.InsertNextCell(int(count))
        for _ in range(count):
            points = stream[at + 1 : at + 1 + stream[at]]
            of_cells.InsertCellPoint(faces.InsertNextCell(len(points), points.tolist()))
            at += 1 + len(points)
    grid.SetPolyhedralCells(types, cells, of_cells, faces)


def keep_polyhedra(reader):
    """ParaView 5.11's reader of OpenFOAM decomposes them unless told; later ones never do."""
    if "Decomposepolyhedra" in reader.ListProperties():
        reader.Decomposepolyhedra = 0


def cell_types(grid):
    """Of each cell; from VTK 9.6 on, a grid whose cells are all of one type has no array of them."""
    types = grid.GetCellTypesArray()
    if types is None:
        return np.array([grid.GetCellType(cell) for cell in range(grid.GetNumberOfCells())], np.uint8)
    return vtk_to_numpy(types)


def type_array(grid):
    return numpy_to_vtk(cell_types(grid), deep=True)


def cell_arrays(cells):
    """Offsets and points of a vtkCellArray: arrays of one type, as versions of VTK differ in that."""
    return [id_array(numbers) for numbers in offsets_and_values(cells)]


def offsets_and_values(cells):
    return vtk_to_numpy(cells.GetOffsetsArray()), vtk_to_numpy(cells.GetConnectivityArray())


def joined(offsets, points, first_faces, faces):
    """The stream of all faces of all cells, and its starts."""
    counts, sizes = np.diff(first_faces), np.diff(offsets)[faces]
    # Each cell with faces has a number in front of them, each face one in front of its points.
    lengths = np.diff(np.concatenate([[0], np.cumsum(sizes + 1)])[first_faces]) + (counts > 0)
    ends = np.cumsum(lengths)
    starts = np.where(counts > 0, ends - lengths, -1)
    stream = np.empty(ends[-1], np.int64)
    stream[starts[counts > 0]] = counts[counts > 0]
    at = np.cumsum(sizes + 1) - (sizes + 1) + np.repeat(np.cumsum(counts > 0), counts)
    stream[at] = sizes
    within = np.arange(sizes.sum()) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    stream[np.repeat(at + 1, sizes) + within] = points[np.repeat(offsets[faces], sizes) + within]
    return stream, starts


def id_array(numbers):
    return numpy_to_vtkIdTypeArray(np.ascontiguousarray(numbers, np.int64), deep=True)
