"""Surfaces that know their sharp edges: lines in the cell array SharpEdge; and solids, blocks with boundaries of their own."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPolyData

from pipeline import arrays, contents, error_code, output, polydata, producer
from solids import CORNERS, LINES, SIDES, blocks, box, cylinder, knowing, numbered


def shape(source, angle, **settings):
    """All points, cells and faces of a mesh, bit for bit."""
    mesher = simple.CartesianMesher(Input=source, FeatureAngle=angle, **{"CellSize": 0.17, **settings})
    found = [contents(array) for port in (0, 1) for name, array in arrays(output(mesher, port)).items()
             if array is not None and "Data, " not in name]
    assert error_code(mesher) == 0 and output(mesher).GetNumberOfCells() > 100
    return found


def copy(data):
    result = vtkPolyData()
    result.DeepCopy(data)
    return result


plain, known = producer(box()), producer(box(known=True))
by_angle = shape(plain, 30)
assert shape(known, 180) == by_angle != shape(plain, 180)

# A coarse cylinder: its strips turn by 30 degrees, and are one smooth side nevertheless.
strips, side = producer(cylinder()), producer(cylinder(known=True))
smooth = shape(side, 20)
assert smooth != shape(strips, 20)
for angle in 5, 29:
    assert shape(side, angle, PatchMethod="Exact Fit") == shape(side, 20, PatchMethod="Exact Fit")


def rim_nodes(source, angle):
    points = vtk_to_numpy(output(simple.CartesianMesher(Input=source, CellSize=0.17, FeatureAngle=angle), 1)
                          .GetPoints().GetData())
    ends = np.abs(points[:, 2, None] - [0, 2]).min(axis=1) < 1e-6
    turn = np.arctan2(points[:, 1], points[:, 0]) % (np.pi / 6) - np.pi / 12
    return np.count_nonzero(ends & (np.abs(np.hypot(points[:, 0], points[:, 1]) * np.cos(turn) - np.cos(np.pi / 12)) < 1e-6))


# The rims are sharp as long as lines say so: as those that the angle finds.
assert min(rim_nodes(side, angle) for angle in (180, 20)) > 0.95 * rim_nodes(strips, 20) > 2 * rim_nodes(strips, 180)

# In three steps it is the same mesh.
boxer = simple.CartesianBoxer(Input=side, CellSize=0.17)
patcher = simple.Patcher(Input=side, Boxes=boxer, FeatureAngle=20)
steps = output(simple.CellAssembler(Input=boxer, Patches=patcher))
whole = output(simple.CartesianMesher(Input=side, CellSize=0.17, FeatureAngle=20))
for name in "points", "cells", "types", "faces":
    assert contents(arrays(steps)[name]) == contents(arrays(whole)[name]), name


def moved(source):
    transform = simple.Transform(Input=source)
    transform.Transform.Translate, transform.Transform.Rotate = [3, -1, 7], [10, 20, 30]
    return transform


# Filters on the way keep what is known.
for make in (lambda source: simple.Triangulate(Input=source),
             lambda source: simple.SplitSurface(Input=source),
             lambda source: simple.AppendGeometry(Input=[source, moved(source)]),
             moved, lambda source: simple.GroupDatasets(Input=[source, moved(source)]),
             lambda source: simple.SplitSurface(Input=simple.GroupDatasets(Input=[source]))):
    assert shape(make(known), 180) == shape(make(plain), 30)

# Polygons with more corners: what divides them is smooth, also where they are warped.
quads, warped = (polydata(points, SIDES) for points in (CORNERS, [(x, y, z - 0.3 * x * y) for x, y, z in CORNERS]))
assert shape(producer(knowing(copy(quads), LINES)), 180) == shape(producer(quads), 30)
assert shape(producer(knowing(copy(warped), LINES)), 5) != shape(producer(warped), 5)

# A block that knows its edges beside one that does not.
far = box((3, 0, 0), (4, 1, 1))
mixed = [producer(blocks({"known": box(known=is_known), "other": far})) for is_known in (True, False)]
assert shape(mixed[0], 30) == shape(mixed[1], 30)
partly = shape(mixed[0], 180)
assert partly not in (shape(mixed[1], 180), shape(mixed[1], 30))
assert shape(simple.SplitSurface(Input=mixed[0], SplitBy="Boundaries"), 180) == partly

# Hidden lines are none.
hidden = box(known=True)
ghost = numpy_to_vtk(np.where(np.arange(hidden.GetNumberOfCells()) < hidden.GetNumberOfLines(),
                              vtkDataSetAttributes.DUPLICATECELL, 0).astype(np.uint8), deep=True)
ghost.SetName(vtkDataSetAttributes.GhostArrayName())
hidden.GetCellData().AddArray(ghost)
assert shape(producer(hidden), 180) == shape(plain, 180) != by_angle

# Split Surface: lines are of a boundary beside them.
divided = output(simple.SplitSurface(Input=side, SplitBy="Feature Angle", FeatureAngle=40))
assert divided.GetNumberOfLines() == 24
names = divided.GetCellData().GetAbstractArray("BoundaryName")
assert {names.GetValue(i) for i in range(24)} < {names.GetValue(i) for i in range(24, divided.GetNumberOfCells())}


# Solids have boundaries of their own, by name; other blocks are one each.
def solid(low, high, first, name):
    ids = {first: "floor", first + 1: name + " walls"}
    return numbered(box(low, high, known=True), ids, lambda middle: first + int(middle[2] != low[2]), name)


def boundaries(source, **settings):
    data = output(simple.CartesianMesher(Input=source, CellSize=0.17, **settings), 1)
    fields = data.GetFieldData()
    return [fields.GetAbstractArray("BoundaryNames").GetValue(i)
            for i in range(fields.GetAbstractArray("BoundaryNames").GetNumberOfValues())], \
        vtk_to_numpy(fields.GetArray("BoundaryAreas"))


pair = {"a.step": solid((0, 0, 0), (1, 1, 1), 0, "a"), "b": solid((2, 0, 0), (3, 1, 1), 2, "b")}
both = producer(blocks(pair))
found, areas = boundaries(both)
assert sorted(found) == ["a walls", "b walls", "floor"], found
assert np.allclose(areas[found.index("floor")], 2, rtol=1e-6) and np.allclose(sum(areas), 12, rtol=1e-6)
assert sorted(boundaries(both, RegionsFrom="Blocks")[0]) == sorted(found)
assert sorted(boundaries(both, BoundaryArray="BoundaryId")[0]) == [f"boundary_{i}" for i in range(4)]
nameless = {name: copy(part) for name, part in pair.items()}
for part in nameless.values():
    part.GetFieldData().RemoveArray("SolidName")
assert boundaries(producer(blocks(nameless)))[0] == ["a.step", "b"]
mixed = producer(blocks({"a": pair["a.step"], "far": nameless["b"]}))
assert sorted(boundaries(mixed)[0]) == ["a walls", "far", "floor"]

# Others that name the boundaries of a surface call them the same.
boxer = simple.CartesianBoxer(Input=both, CellSize=0.17)
for other in simple.SplitSurface(Input=both, SplitBy="Boundaries"), simple.Patcher(Input=both, Boxes=boxer):
    names = output(other).GetFieldData().GetAbstractArray("BoundaryNames")
    assert [names.GetValue(i) for i in range(names.GetNumberOfValues())] == found
assert boundaries(simple.SplitSurface(Input=both, SplitBy="Boundaries"))[0] == found
refined = boundaries(both, BoundaryNames=["floor"], BoundaryDepths=[1])
assert refined[0] == found
