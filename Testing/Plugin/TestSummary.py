"""Mesh Summary: its numbers are those of the mesh's arrays, the worst cells are the worst, and the view shows the text."""

import re

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid

from pipeline import Messages, error_code, octahedron, output, polydata, producer

cube = simple.Triangulate(Input=simple.Box())
ball = simple.Transform(Input=simple.Sphere(ThetaResolution=24, PhiResolution=16))
ball.Transform.Translate = [0.3, 0.2, 0.1]
tunnel = simple.CartesianMesher(Input=ball, Domain="Outside", LengthsBefore=1, LengthsBehind=1, LengthsBeside=1,
    CellSize=0.25, RefinementDepth=1)
mesh = output(tunnel)
summary = simple.MeshSummary(Input=tunnel, Measure="Non Orthogonality", NumberOfWorstCells=7)
text = output(summary).GetColumnByName("Text").GetValue(0)
print(text)
quality = output(simple.FiniteVolumeQuality(Input=tunnel))


def field(name):
    return quality.GetFieldData().GetArray(name).GetValue(0)


assert re.search(rf"^Cells: {mesh.GetNumberOfCells()} \(hexahedra: \d+\), points: {mesh.GetNumberOfPoints()}$", text, re.M)
assert f"Volume: {field('TotalVolume'):.6g}, boundary: {field('BoundaryArea'):.6g}\n" in text
volume_error = 100 * (field("TotalVolume") / field("SurfaceVolume") - 1)
assert 0 < abs(volume_error) < 0.1 and f"Volume error: {volume_error:.6g} % of" in text
names = mesh.GetFieldData().GetAbstractArray("BoundaryNames")
areas = mesh.GetFieldData().GetArray("BoundaryAreas")
assert names.GetNumberOfValues() == 4
for i in range(4):
    assert f"  {names.GetValue(i)}: area {areas.GetValue(i):.6g}\n" in text
value = vtk_to_numpy(quality.GetCellData().GetArray("NonOrthogonality"))
found = re.search(r"Non Orthogonality: (\S+) of at most 70 at \((\S+), (\S+), (\S+)\)", text)
assert found[1] == f"{value.max():.6g}", found[0]
bounds = np.reshape(quality.GetCell(int(value.argmax())).GetBounds(), (3, 2)).mean(axis=1)
assert np.allclose([float(x) for x in found.groups()[1:]], bounds, atol=1e-5), (found[0], bounds)
# What a solver makes of it comes first.
refused = np.zeros(mesh.GetNumberOfCells(), bool)
for name, limit in ("Openness", 1e-6), ("OpenEdges", 1), ("Skewness", 4), ("AspectRatio", 1000), \
        ("BoundaryAngle", 90), ("InnerAngle", 90), ("NonOrthogonality", 90):
    refused |= vtk_to_numpy(quality.GetCellData().GetArray(name)) >= limit
assert text.splitlines()[0] == "OpenFOAM accepts all cells" and not refused.any(), text
for name, words in ("NonOrthogonality", "Non-orthogonality"), ("Skewness", "Skewness"), ("FaceWeight", "Face weight"):
    assert bool(re.search(rf"^  {words}.*: \d+ cells?$", text, re.M)) == (field(f"{name}Failures") > 0), name

worst = output(summary, 1)
assert worst.GetNumberOfCells() == 7
rank = vtk_to_numpy(worst.GetCellData().GetArray("Rank"))
own = vtk_to_numpy(worst.GetCellData().GetArray("NonOrthogonality"))
assert (own[np.argsort(rank)] == np.sort(value)[::-1][:7]).all(), own
summary.Measure = "Volume"
own = vtk_to_numpy(output(summary, 1).GetCellData().GetArray("Volume"))
assert (np.sort(own) == np.sort(vtk_to_numpy(quality.GetCellData().GetArray("Volume")))[:7]).all()
summary.NumberOfWorstCells = 0
assert output(summary, 1).GetNumberOfCells() == 0 and error_code(summary) == 0

# What checkMesh refuses is counted; cells that stand on their heads.
points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (5, 0, 0), (6, 0, 0), (5, 1, 0), (5, 0, 1)]
tetrahedra = vtkUnstructuredGrid()
tetrahedra.SetPoints(vtkPoints())
for point in points:
    tetrahedra.GetPoints().InsertNextPoint(point)
for corners in (0, 1, 2, 3), (4, 6, 5, 7):
    tetrahedra.InsertNextCell(VTK_TETRA, 4, corners)
told = output(simple.MeshSummary(Input=producer(tetrahedra))).GetColumnByName("Text").GetValue(0)
assert told.splitlines()[:2] == ["OpenFOAM's checkMesh fails: 1 cell", "  No volume: 1 cell"], told

# Of many boundaries the ten largest, and of layers how many there are.
ball = output(simple.Sphere(ThetaResolution=24, PhiResolution=24))
label = vtkIntArray()
label.SetName("Label")
for i in range(ball.GetNumberOfCells()):
    label.InsertNextValue(i % 13)
ball.GetCellData().AddArray(label)
layered = simple.CartesianMesher(Input=producer(ball), BoundaryArray="Label", CellSize=0.1, Layers=2,
    BoundaryNames=["boundary_3", "boundary_5"], BoundaryTypes=["patch", "automatic"], BoundaryLayersThickness=[-1, 0])
told = output(simple.MeshSummary(Input=layered)).GetColumnByName("Text").GetValue(0)
coverage = output(layered).GetFieldData().GetArray("LayerCoverage").GetValue(0)
lines = told.splitlines()
listed = [float(re.search(r": area (\S+?)(,|$)", line)[1]) for line in lines[lines.index("Boundaries:") + 1:][:10]]
areas = sorted(vtk_to_numpy(output(layered).GetFieldData().GetArray("BoundaryAreas")), reverse=True)
assert np.allclose(listed, areas[:10], rtol=1e-5), told
assert "  and 3 more" in lines and f"Layers on {np.floor(1000 * coverage) / 10:.6g} % of the walls" in lines, told
assert "No layers asked on boundary_3, boundary_5" in lines, told
# Thin prisms have small determinants and are long, without harm: nothing fails, and nothing is painted.
thin = simple.CartesianMesher(Input=producer(ball), CellSize=0.1, Layers=-1, FirstLayerThickness=2e-5)
measured = output(simple.FiniteVolumeQuality(Input=thin))
prisms = vtk_to_numpy(measured.GetCellData().GetArray("Layer")) > 0
assert (vtk_to_numpy(measured.GetCellData().GetArray("Determinant"))[prisms] < 1e-3).any()
assert not (vtk_to_numpy(measured.GetCellData().GetArray("Failures"))[prisms] & (1024 | 2048)).any()
told = output(simple.MeshSummary(Input=thin)).GetColumnByName("Text").GetValue(0)
assert not re.search("^  (Cell determinant|Aspect ratio).*: ", told, re.M) and "Determinant: 0." in told, told

# What was repaired: one triangle is missing, one is there twice, one is turned over.
whole = octahedron()
triangles = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 5, 1), (4, 3, 5), (0, 1, 2)]
flawed = simple.CartesianMesher(Input=producer(polydata([whole.GetPoint(i) for i in range(6)], triangles)), CellSize=0.2)
with Messages():
    told = output(simple.MeshSummary(Input=flawed)).GetColumnByName("Text").GetValue(0)
for line in "Triangles of the surface reoriented: 1", "Duplicate triangles left out: 1", "Holes wider than a box closed: 1":
    assert f"\n{line}\n" in told, told
assert "reoriented" not in text and "closed:" not in text
# ParaView colours by strings in categories, with the strings as its legend.
boundary, defects = (output(flawed, port).GetCellData() for port in (1, 2))
names = {boundary.GetArray("BoundaryId").GetValue(i): boundary.GetAbstractArray("BoundaryName").GetValue(i)
    for i in range(boundary.GetNumberOfTuples())}
assert names == {-1: "no_surface", 0: "boundary_0"}, names
kinds = {defects.GetArray("DefectKind").GetValue(i): defects.GetAbstractArray("DefectName").GetValue(i)
    for i in range(defects.GetNumberOfTuples())}
assert kinds[5] == "DuplicateTriangles" and kinds[11] == "Leaks", kinds

# What fails is the user's choice.
strict = simple.FiniteVolumeQuality(Input=tunnel, NonOrthogonalityLimit=float(np.median(value)))
failing = output(strict).GetFieldData().GetArray("NonOrthogonalityFailures").GetValue(0)
assert failing == (value >= np.median(value)).sum() > field("NonOrthogonalityFailures"), failing

# Any other grid, too.
plain = simple.MeshSummary(Input=simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[0, 2, 0, 2, 0, 2])))
assert "\nVolume: 8, boundary: 24\n" in output(plain).GetColumnByName("Text").GetValue(0)

# As a text, in a view that needs no screen.
view = simple.servermanager.ProxyManager().GetPrototypeProxy("views", "RenderView")
assert view.GetRepresentationType(summary.SMProxy, 0) == "TextSourceRepresentation"
