"""What ParaView's own filters make of a mesh, against exact figures: a cube turned by 30 degrees about z, whose walls cut
boxes into polyhedra, with fields that are linear in space. TestClip has Clip and Slice. What VTK does with polyhedra that
are not convex is on the page quality, with the example that is here."""

import math

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid

from measure import points_of
from pipeline import Messages, output, producer
from polyhedra import cell_types

ANGLE = math.radians(30)
ALONG = np.array([math.cos(ANGLE), math.sin(ANGLE), 0])  # a side's normal

turned = simple.Transform(Input=simple.Triangulate(Input=simple.Box()))
turned.Transform.Rotate = [0, 0, 30]
mesher = simple.CartesianMesher(Input=turned, CellSize=0.11, PatchMethod="Exact Fit", RefinementDepth=1, CollapseRatio=0,
                                SmallCells="Remove", SmallCellRatio=0, SplitConcaveCells=0)  # convex: VTK cuts them right
mesh = output(mesher)
assert (cell_types(mesh) == VTK_POLYHEDRON).sum() > 300


def close(actual, expected, tolerance, what):
    assert abs(actual - expected) <= tolerance, f"{what}: {actual}, not {expected}"


def integral(proxy, name):
    array = output(simple.IntegrateVariables(Input=proxy)).GetCellData().GetArray(name)
    return array.GetValue(0) if array else 0


def with_field(name, expression):
    """The mesh with a point array that is a function of X, Y and Z."""
    for axis, number in zip("XYZ", "012"):
        expression = expression.replace(axis, f"points[:,{number}]")
    return simple.PythonCalculator(Input=mesher, ArrayName=name, Expression=expression)


def polyhedron(points, faces):
    """A grid of one cell."""
    grid, ids = vtkUnstructuredGrid(), vtkIdList()
    grid.SetPoints(vtkPoints())
    for point in points:
        grid.GetPoints().InsertNextPoint(point)
    ids.InsertNextId(len(faces))
    for face in faces:
        for id in [len(face), *face]:
            ids.InsertNextId(id)
    grid.InsertNextCell(VTK_POLYHEDRON, ids)
    return grid


# Threshold, by an array of the mesh.
level = vtk_to_numpy(mesh.GetCellData().GetArray("Level")).min(axis=1)
whole = simple.PythonCalculator(Input=mesher, ArrayAssociation="Cell Data", ArrayName="depth", Expression="Level[:,0]")
part = output(simple.Threshold(Input=whole, Scalars=["CELLS", "depth"], LowerThreshold=1, UpperThreshold=1))
assert 0 < part.GetNumberOfCells() == (vtk_to_numpy(mesh.GetCellData().GetArray("Level"))[:, 0] == 1).sum() < len(level)

# Contour: planes across the cube, one along the grid's and one along a side, have its area of 1.
for function, value in ("Z", 0.1234), (f"X*{ALONG[0]}+Y*{ALONG[1]}", 0.2345):
    field = with_field("f", function)
    with Messages() as said:
        area = integral(simple.Contour(Input=field, ContourBy=["POINTS", "f"], Isosurfaces=[value]), "Area")
    close(area, 1, 2e-5, f"Contour of {function}, {said}")

# Plot Over Line: linear fields are interpolated exactly. With the tolerance that VTK 9.2 computes by itself, it misses
# points in polyhedra.
field = with_field("f", "1+X+2*Y-3*Z")
for options in {}, {"ComputeTolerance": 0, "Tolerance": 1e-6}:
    line = output(simple.PlotOverLine(Input=field, Point1=[-0.3, -0.3, -0.45], Point2=[0.3, 0.33, 0.45], Resolution=200,
        SamplingPattern="Sample Uniformly", **options))
    valid = vtk_to_numpy(line.GetPointData().GetArray("vtkValidPointMask")) == 1
    expected = 1 + points_of(line) @ [1, 2, -3]
    found = vtk_to_numpy(line.GetPointData().GetArray("f"))
    print(f"Plot Over Line, {options}: {valid.mean():.0%} of the points")
    assert valid.all() or not options, valid.mean()
    close(np.abs(found - expected)[valid].max(), 0, 1e-6, "Plot Over Line")

# Stream Tracer: through a uniform flow to the far side, and in circles in a rotating one.
uniform = with_field("u", f"make_vector({ALONG[0]}+0*X,{ALONG[1]}+0*X,0*X)")
traced = output(simple.StreamTracer(Input=uniform, Vectors=["POINTS", "u"], SeedType="Point Cloud", MaximumStreamlineLength=3,
                                    IntegrationDirection="BOTH"))
along, across = points_of(traced) @ ALONG, points_of(traced) @ [-ALONG[1], ALONG[0], 0]
assert traced.GetNumberOfLines() > 50
for i in range(traced.GetNumberOfCells()):
    ids = traced.GetCell(i).GetPointIds()
    ids = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
    # BOTH makes two lines of each seed: one end is the seed, the other within two boxes of the wall (VTK 9.6).
    assert np.abs(along[ids]).max() > 0.5 - 0.11 and np.ptp(across[ids]) < 1e-6, (along[ids], across[ids])
rotating = with_field("u", "make_vector(-Y,X,0*X)")
seeds = simple.StreamTracer(Input=rotating, Vectors=["POINTS", "u"], SeedType="Line", MaximumStreamlineLength=2)
seeds.SeedType.Point1, seeds.SeedType.Point2, seeds.SeedType.Resolution = [0.1, 0, 0], [0.45, 0, 0.3], 7
traced = output(seeds)
radius = np.linalg.norm(points_of(traced)[:, :2], axis=1)
for i in range(traced.GetNumberOfCells()):
    ids = traced.GetCell(i).GetPointIds()
    on_line = [radius[ids.GetId(k)] for k in range(ids.GetNumberOfIds())]
    assert len(on_line) > 5 and max(on_line) - min(on_line) < 1e-3, (min(on_line), max(on_line))

# Cell Centers: the middle of a polyhedron's bounding box, which is that of a box itself; in ParaView 6.1 its centroid.
middles = points_of(output(simple.CellCenters(Input=mesher)))
off = []
for cell in range(0, mesh.GetNumberOfCells(), 7):
    bounds = mesh.GetCell(cell).GetBounds()
    off.append(np.abs(middles[cell] - [(bounds[i] + bounds[i + 1]) / 2 for i in (0, 2, 4)]).max())
print("Cell Centers: at most", max(off), "from the middles of bounding boxes")
assert max(off) < 1e-6 or simple.GetParaViewVersion() >= (6, 0), max(off)

# Integrate Variables: exact where cells are convex; else VTK takes their convex hull. An L of three cubes is 3.5 to it.
box = polyhedron([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)],
    [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])
close(integral(producer(box), "Volume"), 1, 1e-9, "a cube")
outline = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
ell = polyhedron([(x, y, z) for z in (0, 1) for x, y in outline],
    [tuple(range(5, -1, -1)), tuple(range(6, 12)), *((i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i) for i in range(6))])
volume = integral(producer(ell), "Volume")
quality = output(simple.FiniteVolumeQuality(Input=producer(ell))).GetFieldData()
close(quality.GetArray("TotalVolume").GetValue(0), 3, 1e-9, "the quality of an L")
print("Integrate Variables of an L of volume 3:", volume)
assert volume == 3.5 or simple.GetParaViewVersion() >= (6, 0), volume
convex = simple.CartesianMesher(Input=turned, CellSize=0.11, PatchMethod="Exact Fit", CollapseRatio=0, SmallCells="Remove",
                               SmallCellRatio=0, SplitConcaveCells=0)
close(integral(convex, "Volume"), 1, 1e-3, "a cube")
close(output(simple.FiniteVolumeQuality(Input=convex)).GetFieldData().GetArray("TotalVolume").GetValue(0), 1, 1e-5, "a cube")
