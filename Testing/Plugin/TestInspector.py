"""Surface Inspector: kinds, places, cells and counts; the same as the mesher's Defects output."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from pipeline import (Messages, assert_identical, error_code, merged, octahedron, output, polydata,
                      producer, read)

OPEN_EDGE, DUPLICATE, OVERLAP, INTERSECTION, HOLE, LEAK, LEFT_OUT = 1, 5, 7, 8, 10, 11, 13


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def count(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def places(data, cell):
    ids = data.GetCell(cell).GetPointIds()
    return [data.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())]


def inspected(source, **properties):
    """What the inspector and the mesher's third output both say."""
    inspector = simple.SurfaceInspector(Input=source, **properties)
    mesher = simple.CartesianMesher(Input=source, **properties)
    with Messages():
        defects = output(inspector)
        assert_identical("defects", defects, output(mesher, 2))
    return defects, error_code(inspector)


# Nothing is wrong.
clean = octahedron()
defects, code = inspected(producer(clean), CellSize=0.2)
assert code == 0 and defects.GetNumberOfCells() == 0
assert count(defects, "Components") == 1 and count(defects, "OpenEdges") == 0

# A triangle is missing: a hole for large boxes, a leak for small ones. Another is there twice.
points = [clean.GetPoint(i) for i in range(6)]
triangles = [tuple(clean.GetCell(c).GetPointId(i) for i in range(3)) for c in range(8)]
flawed = producer(polydata(points, triangles[:7] + [triangles[2]]))
for size, kind, name in (0.9, HOLE, "Holes"), (0.2, LEAK, "Leaks"):
    defects, code = inspected(flawed, CellSize=size)
    assert code == 0
    kinds = cell_array(defects, "DefectKind")
    assert sorted(kinds) == [OPEN_EDGE] * 3 + [DUPLICATE, kind], kinds
    assert count(defects, "OpenEdges") == 3 and count(defects, name) == 1
    assert count(defects, "DuplicateTriangles") == 1
    cells = cell_array(defects, "SurfaceCell")
    assert cells[kinds == DUPLICATE] == [7] and cells[kinds == kind] == [-1]
    rim = places(defects, int(np.flatnonzero(kinds == kind)[0]))
    assert len(rim) == 4 and set(rim) == {points[i] for i in triangles[7]}, rim

# Two bodies cross: each pair of cells with the line that they share.
both = merged(clean, octahedron(1, (0.3, 0.4, 0.1)))
defects, code = inspected(producer(both), CellSize=0.19)
kinds = cell_array(defects, "DefectKind")
assert set(kinds) == {INTERSECTION, OVERLAP}, kinds
assert count(defects, "Intersections") == (kinds == INTERSECTION).sum() > 5
first, second = cell_array(defects, "SurfaceCell"), cell_array(defects, "OtherCell")
assert (first[kinds == INTERSECTION] < 8).all() and (second[kinds == INTERSECTION] >= 8).all()
for cell in np.flatnonzero(kinds == INTERSECTION):
    for p in places(defects, int(cell)):
        for body, centre in (first, (0, 0, 0)), (second, (0.3, 0.4, 0.1)):
            assert abs(np.abs(np.subtract(p, centre)).sum() - 1) < 1e-8, p

# Polygons and other cells: the numbers are those of the input.
quads = polydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1)], [(0, 1), (0, 1, 2, 3)])
with Messages():
    defects = output(simple.SurfaceInspector(Input=producer(quads), CellSize=0.1))
assert set(cell_array(defects, "SurfaceCell")) == {1, -1}

# A real one.
with Messages():
    wing = output(simple.SurfaceInspector(Input=read("HD_airframe_aileron_gap.stl")))
assert count(wing, "OpenEdges") == 8 and count(wing, "Intersections") == 1880
assert count(wing, "Holes") + count(wing, "Leaks") == 2

# What a mesh of it lacks: a box for each cell that is left out.
with Messages():
    mesher = simple.CartesianMesher(Input=read("HD_airframe_aileron_gap.stl"), CellSize=327)
    mesher.UpdatePipeline()
mesh, defects = (mesher.GetClientSideObject().GetOutputDataObject(port) for port in (0, 2))
left_out = count(defects, "CellsLeftOut")
assert left_out == sum(count(mesh, kind + "CellsRemoved") for kind in ("Small", "Refused", "Fragment")) > 0
kinds, volumes = cell_array(defects, "DefectKind"), cell_array(defects, "Volume")
assert (kinds == LEFT_OUT).sum() == 6 * left_out
assert ((volumes > 0) <= (kinds == LEFT_OUT)).all() and 0 < volumes.max() < 327 ** 3
assert defects.GetNumberOfCells() == len(kinds)
for side in np.flatnonzero(kinds == LEFT_OUT):
    extent = np.ptp(places(defects, int(side)), axis=0)
    assert sorted(np.round(extent / 327)) == [0, 1, 1], extent
