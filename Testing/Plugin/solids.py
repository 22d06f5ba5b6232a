"""Surfaces as a CAD reader gives them: triangles, and lines that are their sharp edges; blocks that are solids."""

import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIntArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet

from pipeline import polydata


def knowing(data, lines):
    """The same surface, of which these are the sharp edges: pairs of points, or longer lines."""
    cells = vtkCellArray()
    for line in lines:
        cells.InsertNextCell(len(line), line)
    data.SetLines(cells)
    sharp = numpy_to_vtk(np.repeat(np.array([1, 0], np.uint8), (len(lines), data.GetNumberOfPolys())), deep=True)
    sharp.SetName("SharpEdge")
    data.GetCellData().AddArray(sharp)
    return data


# A cube: its edges are a closed line on the ground and eight more.
CORNERS = [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)]
SIDES = (0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)
LINES = (0, 1, 3, 2, 0), (4, 5), (5, 7), (7, 6), (6, 4), (0, 4), (1, 5), (2, 6), (3, 7)


def box(low=(0, 0, 0), high=(1, 1, 1), known=False):
    """Of 12 triangles."""
    points = np.array(low) + np.array(CORNERS) * (np.array(high) - low)
    data = polydata(points, [side[:1] + side[i:i + 2] for side in SIDES for i in (1, 2)])
    return knowing(data, LINES) if known else data


def cylinder(known=False, sides=12, height=2.0):
    """Its side is of flat strips; the rims are its sharp edges."""
    turns = [2 * math.pi * i / sides for i in range(sides)]
    points = [(math.cos(turn), math.sin(turn), z) for z in (0, height) for turn in turns]
    triangles, lines = [], []
    for i in range(sides):
        j = (i + 1) % sides
        triangles += [(i, j, sides + j), (i, sides + j, sides + i)]
        lines += [(i, j), (sides + i, sides + j)]
        if 0 < i < sides - 1:
            triangles += [(0, j, i), (sides, sides + i, sides + j)]
    data = polydata(points, triangles)
    return knowing(data, lines) if known else data


def numbered(data, names, number_of, solid=None):
    """With BoundaryId for its triangles, by their centres, after the lines; with SolidName, if it is a solid."""
    ids = vtkIntArray()
    ids.SetName("BoundaryId")
    for i in range(data.GetNumberOfCells()):
        low, high = np.reshape(data.GetCell(i).GetBounds(), (3, 2)).T
        ids.InsertNextValue(number_of((low + high) / 2))
    data.GetCellData().AddArray(ids)
    numbers, texts, name = vtkIntArray(), vtkStringArray(), vtkStringArray()
    numbers.SetName("BoundaryIds"), texts.SetName("BoundaryNames"), name.SetName("SolidName")
    for number, text in names.items():
        numbers.InsertNextValue(number), texts.InsertNextValue(text)
    data.GetFieldData().AddArray(numbers), data.GetFieldData().AddArray(texts)
    if solid:
        name.InsertNextValue(solid)
        data.GetFieldData().AddArray(name)
    return data


def blocks(parts):
    """{name: surface}"""
    result = vtkMultiBlockDataSet()
    for i, (name, part) in enumerate(parts.items()):
        result.SetBlock(i, part)
        result.GetMetaData(i).Set(result.NAME(), name)
    return result
