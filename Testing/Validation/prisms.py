# SPDX-License-Identifier: BSD-3-Clause
"""Closed surfaces of a plane figure extruded along z: what most cases with an exact solution need."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkContourTriangulator

from wallsurfaces import Surface

ENDS = "symmetry"  # of both caps; no wall by this name


def circle(radius, facets, at=(0, 0), equal_area=False):
    """Anticlockwise. `equal_area`: corners lie outside of the circle, so that the polygon is as large."""
    angle = 2 * np.pi * np.arange(facets) / facets
    if equal_area:
        radius = radius * np.sqrt(2 * np.pi / facets / np.sin(2 * np.pi / facets))
    return np.array(at) + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


def prism(name, loops, low, high, ends=ENDS):
    """From z = low to high. `loops`: each an (n, 2) array of corners, the outer one first and anticlockwise, holes clockwise, and
    the name of all its sides or one for each, which begin at its corners."""
    corners, solids, names = [], [], [ends]
    for points, sides in loops:
        following = np.roll(points, -1, axis=0)
        sides = [sides] * len(points) if isinstance(sides, str) else sides
        names += [side for side in dict.fromkeys(sides) if side not in names]
        a, b, c, d = (lifted(p, z) for p, z in ((points, low), (following, low), (following, high), (points, high)))
        corners += [np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]
        solids += 2 * [names.index(side) for side in sides]
    cap = triangles([points for points, _ in loops])
    corners += [lifted(cap.reshape(-1, 2), low).reshape(-1, 3, 3)[:, ::-1], lifted(cap.reshape(-1, 2), high).reshape(-1, 3, 3)]
    solids += 2 * len(cap) * [names.index(ends)]
    return Surface(name, np.concatenate(corners), np.array(solids), names)


def lifted(points, z):
    return np.column_stack([points, np.full(len(points), z)])


def triangles(loops):
    """Of the figure, anticlockwise: (n, 3, 2)."""
    points, lines = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for loop in loops:
        ids = [points.InsertNextPoint(x, y, 0) for x, y in loop]
        for a, b in zip(ids, ids[1:] + ids[:1]):
            lines.InsertNextCell(2, (a, b))
    data, filter = vtkPolyData(), vtkContourTriangulator()
    data.SetPoints(points)
    data.SetLines(lines)
    filter.SetInputData(data)
    filter.Update()
    found = filter.GetOutput()
    corners = vtk_to_numpy(found.GetPoints().GetData())[vtk_to_numpy(found.GetPolys().GetConnectivityArray()).reshape(-1, 3), :2]
    sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return np.where(sides[:, None, None] < 0, corners[:, ::-1], corners)
