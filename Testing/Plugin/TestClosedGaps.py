"""Close Gaps: the window of a box becomes a wall called gap_1, at four turns and three sizes of boxes, with settings by its name;
layers grow on it. Gaps between houses in a row are closed likewise. The car of Data, wide open, is closed. A smaller width leaves the window to no_surface."""

import math
import pathlib
import sys
import tempfile

from paraview import simple

import foam
from pipeline import Messages, output, polydata, producer

ROOT = pathlib.Path(sys.argv[1])
temporary = tempfile.TemporaryDirectory()
LINES = (0, 0.3, 0.7, 1)


def windowed():
    """A cube in rectangles, without the middle one of its upper side: 0.4 x 0.4."""
    points, polygons = [], []
    for axis in range(3):
        for side in 0, 1:
            for i in range(3):
                for j in range(3):
                    if (axis, side, i, j) == (2, 1, 1, 1):
                        continue
                    corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                    for u, v in corners if side else corners[::-1]:
                        place = [0.0, 0.0, 0.0]
                        place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = side, LINES[u], LINES[v]
                        points.append(place)
                    polygons.append(range(len(points) - 4, len(points)))
    return producer(polydata(points, polygons))


def areas_of(mesher):
    data = output(mesher).GetFieldData()
    names, areas = data.GetAbstractArray("BoundaryNames"), data.GetArray("BoundaryAreas")
    return {names.GetValue(i): areas.GetValue(i) for i in range(names.GetNumberOfValues())}


def houses():
    """Three boxes beside each other: .05 apart, where 1 x .5 and 1 x 1 face each other."""
    points, polygons = [], []
    for low, high in ((0, 0, 0), (1, 1, 1)), ((1.05, 0, 0), (2, 1, 0.5)), ((2.05, 0, 0), (3, 1, 1)):
        first = len(points)
        points += [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]
        polygons += [[first + i for i in side] for side in
                     ([0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6])]
    return producer(polydata(points, polygons))


# Gaps between closed parts: their volume is added, of the walls what faces the other goes.
for number, turn in enumerate(([0, 0, 0], [0, 0, 45], [30, 0, 0], [17, 29, 41])):
    for size in 0.21, 0.11, 0.06:
        turned = simple.Transform(Input=simple.Triangulate(Input=houses()), Transform="Transform")
        turned.Transform.Rotate = turn
        with Messages() as said:
            mesher = simple.CartesianMesher(Input=turned, CellSize=size, CloseGaps=0.1, PatchMethod="Exact Fit")
            areas = areas_of(mesher)
        assert "2 gaps were closed:\n  gap_1, 0.05 wide" in str(said), str(said)
        assert all(math.isclose(areas[gap], 0.15, rel_tol=1e-7) for gap in ("gap_1", "gap_2")), (turn, size, areas)
        assert math.isclose(sum(areas.values()), 6 + 3.85 + 5.8 - 4 * 0.5 + 0.3, rel_tol=1e-8), (turn, size, sum(areas.values()))
        usual = simple.CartesianMesher(Input=turned, CellSize=size, CloseGaps=0.1)
        folder = f"{temporary.name}/houses-{number}-{size}"
        foam.save(simple.OutputPort(usual, "Mesh"), folder)
        assert foam.CheckMesh(folder).ok, (turn, size)

body = windowed()
for number, turn in enumerate(([0, 0, 0], [0, 0, 45], [30, 0, 0], [17, 29, 41])):
    for size in 0.21, 0.11, 0.06:
        turned = simple.Transform(Input=simple.Triangulate(Input=body), Transform="Transform")
        turned.Transform.Rotate = turn
        with Messages() as said:
            mesher = simple.CartesianMesher(Input=turned, CellSize=size, CloseGaps=0.5, PatchMethod="Exact Fit")
            mesher.UpdatePipeline()
            areas = areas_of(mesher)
        assert "1 gap was closed:\n  gap_1, 0.4 wide" in str(said) and "open edge" not in str(said), str(said)
        assert math.isclose(areas["gap_1"], 0.16, rel_tol=1e-8), (turn, size, areas)
        assert math.isclose(sum(areas.values()), 6, rel_tol=1e-9) and "no_surface" not in areas, (turn, size, areas)
        usual = simple.CartesianMesher(Input=turned, CellSize=size, CloseGaps=0.5)
        areas = areas_of(usual)
        assert abs(areas["gap_1"] / 0.16 - 1) < 0.01 and abs(sum(areas.values()) / 6 - 1) < 0.003, (turn, size, areas)
        folder = f"{temporary.name}/{number}-{size}"
        foam.save(simple.OutputPort(usual, "Mesh"), folder)
        assert foam.CheckMesh(folder).ok, (turn, size)

# Its rim is listed as a defect, and nothing else.
defects = output(mesher, 2)
assert defects.GetNumberOfCells() == 1 and defects.GetCellData().GetArray("DefectKind").GetTuple1(0) == 19
assert defects.GetCellData().GetAbstractArray("DefectName").GetValue(0) == "Gaps"
assert math.isclose(defects.GetCellData().GetArray("Width").GetTuple1(0), 0.4)

# Settings by name, layers, pieces.
settings = {"BoundaryNames": ["gap_*"], "BoundaryTypes": ["patch"], "BoundaryLayersThickness": [0]}
walls = simple.CartesianMesher(Input=body, CellSize=0.11, CloseGaps=0.5, Layers=3)
bare = simple.CartesianMesher(Input=body, CellSize=0.11, CloseGaps=0.5, Layers=3, **settings)
for mesher, are in (walls, True), (bare, False):
    data = output(mesher).GetFieldData()
    names = data.GetAbstractArray("BoundaryNames")
    gap = next(i for i in range(names.GetNumberOfValues()) if names.GetValue(i) == "gap_1")
    assert (data.GetArray("BoundaryLayerCoverages").GetValue(gap) > 0.9) == are, (are, data.GetArray("BoundaryLayerCoverages").GetValue(gap))
    assert data.GetAbstractArray("BoundaryTypes") is None or data.GetAbstractArray("BoundaryTypes").GetValue(gap) == ("" if are else "patch")

with Messages() as said:
    left = areas_of(simple.CartesianMesher(Input=body, CellSize=0.11, CloseGaps=0.39))
assert "gap_1" not in left and math.isclose(left["no_surface"], 0.16, rel_tol=1e-6), left
assert "Close Gaps" in str(said), str(said)

# Its panes are walls with two sides, its floor is open.
car = simple.NamedOBJReader(FileName=str(ROOT / "Data" / "prius_hybrid_body.obj"))
with Messages() as said:
    areas = areas_of(simple.CartesianMesher(Input=car, Domain="Outside", FlowDirection="Plus Y", Ground="zMin", CellSize=200,
                                            BoxesAlongBody=40, CloseGaps=200))
print({name: round(area) for name, area in areas.items()})
assert "no_surface" not in areas and areas["gap_2"] > 11000 and areas["Hybrid_Windows"] > 60000, areas
assert "triangles that close holes between other walls" in str(said), str(said)
