"""The coolant jacket of the paper's section 5, by rule: water around the two cylinders of a block and in the head above,
joined by holes through the gasket that are narrower than a box. Checked as an OpenFOAM case, with the paper's settings: boxes
of 3 mm, depth 2, and a refinement block of depth 3 at each hole.

    pvpython Testing/Plugin/jacket.py REPOSITORY FOLDER
"""

import pathlib
import sys
import time

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkContourTriangulator
import foam
from pipeline import output, producer

BORE, PITCH, GAP = 40, 94, 9  # mm: radius of a cylinder's wall, distance of the two, width of the water around them
BLOCK, GASKET, HEAD = (-60, 0), (0, 1.5), (1.5, 30)  # heights
HOLE = 1.2  # radius: narrower than a box
SIZE = 3


def circle(centre, radius, count):
    angles = 2 * np.pi * np.arange(count) / count
    return np.stack([centre[0] + radius * np.cos(angles), centre[1] + radius * np.sin(angles)], axis=1)


def stadium(radius, count):
    """Around both cylinders."""
    angles = np.pi * np.arange(count + 1) / count
    right = np.stack([PITCH / 2 + radius * np.sin(angles), -radius * np.cos(angles)], axis=1)
    return np.concatenate([right, -right])


def hole_centres():
    """Six around each cylinder, in the middle of the water, none between the two."""
    middle = BORE + GAP / 2
    for side in -1, 1:
        for degrees in -100, -60, -20, 20, 60, 100:
            angle = np.radians(degrees)
            yield side * (PITCH / 2 + middle * np.cos(angle)), middle * np.sin(angle)


class Jacket:
    """A closed surface of walls and flat parts between outlines, which are counter-clockwise."""

    def __init__(self):
        self.points, self.triangles, self.names = [], [], []

    def ring(self, outline, height):
        first = len(self.points)
        self.points += [(x, y, height) for x, y in outline]
        return range(first, len(self.points))

    def wall(self, low, high, name, inside=False):
        """Between two rings; `inside`: the water is around it."""
        for i in range(len(low)):
            k = (i + 1) % len(low)
            for triangle in (low[i], low[k], high[k]), (low[i], high[k], high[i]):
                self.add(triangle[::-1] if inside else triangle, name)

    def add(self, triangle, name):
        self.triangles.append(triangle)
        self.names.append(name)

    def flat(self, outer, holes, name, up):
        """Within a ring, around others."""
        lines, points, used = vtkCellArray(), vtkPoints(), []
        points.SetDataTypeToDouble()
        for ring, forward in [(outer, True)] + [(hole, False) for hole in holes]:
            order = list(ring) if forward else list(ring)[::-1]
            lines.InsertNextCell(len(order) + 1)
            for place in [*range(len(used), len(used) + len(order)), len(used)]:
                lines.InsertCellPoint(place)
            for point in order:
                points.InsertNextPoint(self.points[point])
            used += order
        contours = vtkPolyData()
        contours.SetPoints(points)
        contours.SetLines(lines)
        fill = vtkContourTriangulator()
        fill.SetInputData(contours)
        fill.Update()
        polys = fill.GetOutput().GetPolys()
        for i in range(polys.GetNumberOfCells()):
            cell = fill.GetOutput().GetCell(i).GetPointIds()
            triangle = [used[cell.GetId(k)] for k in range(3)]
            a, b, c = (np.array(self.points[point]) for point in triangle)
            upwards = np.cross(b - a, c - a)[2] > 0
            self.add(triangle if upwards == up else triangle[::-1], name)

    def surface(self):
        data, points, cells, names = vtkPolyData(), vtkPoints(), vtkCellArray(), vtkStringArray()
        points.SetDataTypeToDouble()
        names.SetName("Wall")
        for point in self.points:
            points.InsertNextPoint(point)
        for triangle, name in zip(self.triangles, self.names):
            cells.InsertNextCell(3, [int(point) for point in triangle])
            names.InsertNextValue(name)
        data.SetPoints(points)
        data.SetPolys(cells)
        data.GetCellData().AddArray(names)
        return data


def jacket():
    """The surface: boundaries block, head and gasket."""
    made = Jacket()
    holes = [circle(centre, HOLE, 16) for centre in hole_centres()]
    rings = {}
    for name, (low, high), bore in ("block", BLOCK, BORE), ("head", HEAD, BORE - 12):
        outlines = [stadium(BORE + GAP, 48)] + [circle((side * PITCH / 2, 0), bore, 72) for side in (-1, 1)]
        ends = [[made.ring(outline, height) for outline in outlines] for height in (low, high)]
        for k, (bottom, top) in enumerate(zip(*ends)):
            made.wall(bottom, top, name, inside=k > 0)
        rings[name] = ends
    openings = [[made.ring(hole, height) for hole in holes] for height in GASKET]
    for bottom, top in zip(*openings):
        made.wall(bottom, top, "gasket")
    for name, end, cuts, up in (("block", 0, [], False), ("block", 1, openings[0], True),
                                ("head", 0, openings[1], False), ("head", 1, [], True)):
        outer, *bores = rings[name][end]
        made.flat(outer, bores + cuts, name, up)
    return made.surface()


def blocks(surface):
    """The global boxes around each hole, as rows of Refinement Blocks: I, J, K, allowed and forced depth."""
    low = np.array(surface.GetBounds()[::2])
    rows = []
    for x, y in hole_centres():
        first = ((x - HOLE, y - HOLE, GASKET[0]) - low) // SIZE
        last = ((x + HOLE, y + HOLE, GASKET[1]) - low) // SIZE
        rows += [number for pair in zip(first, last) for number in pair] + [3, 0]
    return rows


def mesher(**properties):
    surface = jacket()
    return simple.CartesianMesher(Input=producer(surface), BoundaryArray="Wall", CellSize=SIZE, RefinementDepth=2,
                                  RefinementBlocks=blocks(surface), **properties)


if __name__ == "__main__":
    made = mesher()
    begin = time.process_time()
    mesh = output(made)
    seconds = time.process_time() - begin
    data = mesh.GetFieldData()
    value = {name: data.GetArray(name).GetValue(0) for name in (
        "Cells", "BoxesByMarchingCubes", "BoxesByExactFit")}
    share = value["BoxesByMarchingCubes"] / (value["BoxesByMarchingCubes"] + value["BoxesByExactFit"])
    print(value, f"{seconds:.1f} s of CPU, Marching Cubes in {100 * share:.0f} % of the boxes cut")
    check = foam.CheckMesh(foam.save(simple.OutputPort(made, "Mesh"), pathlib.Path(sys.argv[2]) / "jacket"))
    print(check.figures, *check.failures, "Mesh OK" if check.ok else "FAILED", sep="\n  ")
