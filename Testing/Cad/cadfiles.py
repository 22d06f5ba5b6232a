"""CAD files read by vtkCADReader, as NumPy arrays."""

import json
import pathlib

import numpy as np
from cartesianmesher.vtkCartesianMesherFilters import vtkCADReader
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

from alltests import run  # noqa: F401 (for the tests of CAD files)

UNITS = {"m": 1000.0, "cm": 10.0, "mm": 1.0, "in": 25.4, "ft": 304.8}  # millimetres


class Solid:
    """A block: its triangles, sharp edges (pairs of points), and what the reader says of it."""

    def __init__(self, block):
        fields, cells = block.GetFieldData(), block.GetCellData()
        line_count, count = block.GetNumberOfLines(), block.GetNumberOfPolys()
        assert block.GetNumberOfCells() == line_count + count
        self.name = fields.GetAbstractArray("SolidName").GetValue(0)
        self.volume, self.area, self.volume_of_triangles, self.open_edges = (
            fields.GetArray(name).GetValue(0) for name in ("Volume", "Area", "VolumeOfTriangles", "OpenEdges"))
        self.points = vtk_to_numpy(block.GetPoints().GetData())
        self.triangles = corners(block.GetPolys(), count, 3)
        self.lines = corners(block.GetLines(), line_count, 2)
        names = cells.GetAbstractArray("BoundaryName")
        self.boundaries = np.array([names.GetValue(i) for i in range(line_count, line_count + count)])
        self.ids = vtk_to_numpy(cells.GetArray("BoundaryId"))[line_count:]
        self.sharp = vtk_to_numpy(cells.GetArray("SharpEdge")) if cells.HasArray("SharpEdge") else None
        self.names = {fields.GetArray("BoundaryIds").GetValue(i): fields.GetAbstractArray("BoundaryNames").GetValue(i)
                      for i in range(fields.GetArray("BoundaryIds").GetNumberOfTuples())}

    def corners(self):
        return self.points[self.triangles]

    def areas(self):
        a, b, c = self.corners().transpose(1, 0, 2)
        return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2

    def own_volume(self):
        a, b, c = (self.corners() - self.points[0]).transpose(1, 0, 2)
        return np.einsum("ij,ij->", a, np.cross(b, c)) / 6

    def centre(self):
        """Of gravity, of the triangles' inside."""
        origin = self.points[0]
        a, b, c = (self.corners() - origin).transpose(1, 0, 2)
        volumes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
        return origin + volumes @ (a + b + c) / 4 / volumes.sum()

    def own_open_edges(self):
        """Edges that triangles do not pass as often in one direction as in the other."""
        passes = {}
        for triangle in self.triangles.tolist():
            for a, b in zip(triangle, triangle[1:] + triangle[:1]):
                edge = min(a, b), max(a, b)
                passes[edge] = passes.get(edge, 0) + (1 if a < b else -1)
        return sum(balance != 0 for balance in passes.values())

    def length_of_sharp_edges(self):
        ends = self.points[self.lines]
        return np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum()

    def set_of_triangles(self):
        """By the coordinates of their corners, whichever way they turn."""
        return {frozenset(map(tuple, triangle)) for triangle in self.corners().tolist()}


def corners(cells, count, size):
    if count == 0:
        return np.empty((0, size), int)
    return vtk_to_numpy(cells.GetConnectivityArray()).reshape(count, size)


class Content:
    """What the reader gave, and what it said."""

    def __init__(self, path, unit="mm", **properties):
        self.reader = vtkCADReader()
        self.reader.SetFileName(str(path))
        self.reader.SetLengthUnit(list(UNITS).index(unit))
        for name, value in properties.items():
            getattr(self.reader, "Set" + name)(value)
        window = vtkStringOutputWindow()
        before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(window)
        self.reader.Update()
        vtkOutputWindow.SetInstance(before)
        self.said = window.GetOutput()
        self.is_error = self.reader.GetErrorCode() != 0
        blocks = self.reader.GetOutput()
        self.blocks = [blocks.GetBlock(i) for i in range(blocks.GetNumberOfBlocks())]
        self.solids = [Solid(block) for block in self.blocks]

    def findings(self):
        found = self.reader.GetFindings()
        return [found.GetValue(i) for i in range(found.GetNumberOfValues())]

    def areas(self):
        """Of each boundary."""
        result = {}
        for solid in self.solids:
            for name, area in zip(solid.boundaries, solid.areas()):
                result[str(name)] = result.get(str(name), 0) + area
        return result


def facts_of(folder):
    return json.loads((pathlib.Path(folder) / "facts.json").read_text(encoding="utf-8"))
