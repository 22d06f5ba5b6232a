"""Domain Outside: a box around bodies, from the panel's properties; its sides are boundaries by name."""

import math
import pathlib
import subprocess
import sys
import tempfile

import cartesianmesher.vtkCartesianMesherFilters  # or filters show their base class only
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkFiltersCore import vtkCellCenters

import foam
import scenes
from pipeline import Messages, error_code, polydata, producer

PROGRAM = sys.argv[2]
SIDES = ["xMin", "xMax", "yMin", "yMax", "zMin", "zMax"]


def strings(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def areas(boundary):
    """{name of a boundary: its area}."""
    area = vtk_to_numpy(boundary.GetCellData().GetArray("FaceArea"))
    number = vtk_to_numpy(boundary.GetCellData().GetArray("BoundaryId"))
    ids = vtk_to_numpy(boundary.GetFieldData().GetArray("BoundaryIds"))
    return {name: float(((area[number == i] ** 2).sum(axis=1) ** 0.5).sum())
        for i, name in zip(ids, strings(boundary, "BoundaryNames"))}


def expect(mesher, expected):
    mesher.UpdatePipeline()
    filter = mesher.GetClientSideObject()
    assert filter.GetErrorCode() == 0, filter.GetErrorCode()
    actual = areas(filter.GetOutputDataObject(1))
    for name, area in expected.items():
        assert math.isclose(actual[name], area, rel_tol=1e-6), f"{name}: {actual}"
    assert "no_surface" not in actual, actual


# A cube on the ground, with the flow towards -y: 8 lengths along y, 5 high, 6 wide.
cube = simple.Triangulate(Input=simple.Box())
mesher = simple.CartesianMesher(Input=cube, Domain="Outside", FlowDirection="Minus Y",
    LengthsBefore=2, LengthsBehind=5, LengthsBeside=2.5, Ground="zMin", CellSize=0.4, BoxesAlongBody=0,
    SideNames="Axes", PatchMethod="Exact Fit")
expect(mesher, {"xMin": 28, "xMax": 28, "yMin": 21, "yMax": 21, "zMin": 47, "zMax": 48,
    "boundary_0": 5})
mesher.SideNames = "Flow"
expect(mesher, {"inlet": 21, "outlet": 21, "ground": 47, "sides": 28 + 28 + 48, "boundary_0": 5})
assert strings(mesher.GetClientSideObject().GetOutputDataObject(0), "BoundaryTypes") == ["", "patch", "patch", "patch", "wall"], \
    strings(mesher.GetClientSideObject().GetOutputDataObject(0), "BoundaryTypes")
mesher.SideNames = "Axes"
mesher.UpdatePipeline()
bounds = mesher.GetClientSideObject().GetOutputDataObject(0).GetBounds()
for actual, expected in zip(bounds, [-3, 3, -5.5, 2.5, -0.5, 3]):
    assert math.isclose(actual, expected, abs_tol=1e-6), bounds

# Half of it is symmetric.
mesher.Half = "Across X"
expect(mesher, {"xMin": 27, "xMax": 28, "zMax": 24, "boundary_0": 2.5})
mesh = mesher.GetClientSideObject().GetOutputDataObject(0)
types = dict(zip(strings(mesh, "BoundaryNames"), strings(mesh, "BoundaryTypes")))
assert [types[side] for side in SIDES] == ["symmetryPlane"] + 3 * ["patch"] + ["wall", "patch"], types

# A box by its bounds, which cuts the body off.
mesher.Half = "None"
mesher.Ground = "None"
mesher.BoxFrom = "Bounds"
mesher.DomainBounds = [-2, 2, -2, 2, 0, 2]
expect(mesher, {"zMin": 15, "zMax": 16, "boundary_0": 3})

# A side continues the surface's boundary of its name: its area is not compared with the surface's.
corners, triangles = scenes.box([-0.5] * 3, [0.5] * 3)
body = polydata(corners, triangles)
names = vtkStringArray()
names.SetName("Name")
for triangle in triangles:
    names.InsertNextValue("inlet" if all(corners[i][0] < 0 for i in triangle) else "body")
body.GetCellData().AddArray(names)
with Messages() as said:
    expect(simple.CartesianMesher(Input=producer(body), BoundaryArray="Name", Domain="Outside", BoxFrom="Bounds",
        DomainBounds=[-2, 2, -2, 2, -2, 2], CellSize=0.4, BoxesAlongBody=0, PatchMethod="Exact Fit"),
        {"inlet": 16 + 1, "outlet": 16, "sides": 4 * 16, "body": 5})
assert "area" not in str(said), said

# With nothing but a surface: at least 60 boxes along the longest side, at most twice as large ones around it, four times
# in the wake; with an explicit depth, or with shapes, what these say. The domain is 5.5 long, a box far away 0.11.
def levels(**options):
    """Of cells, (middle, how often their boxes are halved)."""
    tunnel = simple.CartesianMesher(Input=simple.Triangulate(Input=simple.Sphere(ThetaResolution=32, PhiResolution=16)),
        Domain="Outside", LengthsBefore=1.5, LengthsBehind=3, LengthsBeside=1.5, **options)
    tunnel.UpdatePipeline()
    data = tunnel.GetClientSideObject().GetOutputDataObject(0)
    assert list(data.GetFieldData().GetArray("FlowDirection").GetTuple(0)) == [1, 0, 0]
    level = vtk_to_numpy(data.GetCellData().GetArray("Level")).min(axis=1)
    centers = vtkCellCenters()
    centers.SetInputDataObject(data)
    centers.Update()
    return list(zip(vtk_to_numpy(centers.GetOutput().GetPoints().GetData()).tolist(), level.tolist()))


automatic = levels()
assert {depth for at, depth in automatic if math.dist(at, (0, 0, 0)) < 0.52} == {3}
assert {depth for at, depth in automatic if max(map(abs, at)) < 0.74} == {2, 3}
assert min(depth for at, depth in automatic if 0 < at[0] < 2.4 and max(map(abs, at[1:])) < 0.7) == 1
assert min(depth for _, depth in automatic) == 0
assert max(depth for _, depth in levels(RefinementDepth=1)) == 1
shapes = {"RefinementShapes": ["box"], "RefinementPositions": [1, 1, 1], "RefinementLengths": [0.1, 0.1, 0.1],
          "RefinementShapeDepths": [1]}
assert min(depth for at, depth in levels(**shapes) if 1.5 < at[0] < 2.4 and max(map(abs, at[1:])) < 0.7) == 0

# The panel tells of these zones.
block = simple.Triangulate(Input=simple.Box(XLength=4, YLength=2))
block.UpdatePipeline()
zones = simple.CartesianMesher(Input=block, Domain="Outside", Ground="zMin", LengthsBefore=1, LengthsBehind=3,
    LengthsBeside=1, CellSize=1)
assert list(zones.FlowZones) == ["Where", "Depth", "From", "To", "at the surface", "4", "", "",
    "around it", "3", "-3, -2, -0.5", "3, 2, 1.5", "in its wake", "2", "-3, -2, -0.5", "10, 2, 1.5"], list(zones.FlowZones)
zones.RefinementDepth = 1
zones.UpdatePipelineInformation()
assert list(zones.FlowZones) == [], list(zones.FlowZones)

# A pattern concerns the surface's boundaries: sides of the domain keep their types unless a row names them; so does one
# that continues a boundary of the surface.
def typed(surface, names, types, **options):
    wind = simple.CartesianMesher(Input=surface, Domain="Outside", LengthsBefore=1, LengthsBehind=1, LengthsBeside=1, CellSize=0.5,
        BoxesAlongBody=0, Ground="zMin", BoundaryNames=names, BoundaryTypes=types, **options)
    with Messages() as said:
        wind.UpdatePipeline()
    if error_code(wind) != 0:
        return str(said)
    data = wind.GetClientSideObject().GetOutputDataObject(0)
    return dict(zip(strings(data, "BoundaryNames"), strings(data, "BoundaryTypes")))


SIDES_TYPED = {"inlet": "patch", "outlet": "patch", "sides": "patch", "ground": "wall"}
assert typed(cube, ["*"], ["symmetry"]) == {"boundary_0": "symmetry", **SIDES_TYPED}, typed(cube, ["*"], ["symmetry"])
assert typed(cube, ["*", "outlet"], ["wall", "empty"]) == {"boundary_0": "wall", **SIDES_TYPED, "outlet": "empty"}
assert typed(producer(body), ["*"], ["wall"], BoundaryArray="Name") == {"body": "wall", **SIDES_TYPED}
for pattern, sides in ("in*", "inlet"), ("*let", "inlet, outlet"):
    said = typed(cube, [pattern], ["wall"])
    assert f'"{pattern}", which only sides of the domain match' in said and f"own: {sides}." in said, said
assert "which is not a boundary" in typed(cube, ["x*"], ["wall"])
# So are depths, where sides are refused; a side may have a row when pieces are estimated.
assert "" in typed(cube, ["*"], ["automatic"], BoundaryDepths=[1]).values()
assert "has no boundary 1" in typed(cube, ["inlet"], ["automatic"], BoundaryDepths=[1])
named = simple.CartesianMesher(Input=cube, Domain="Outside", CellSize=0.5, BoxesAlongBody=0, BoundaryNames=["inlet"],
    BoundaryDepths=[-1])
with Messages() as said:
    assert named.SMProxy.GetClientSideObject().EstimateNumberOfPieces() > 0, said

# The same by a task file, as an OpenFOAM case.
with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    simple.SaveData(str(folder / "cube.stl"), proxy=cube)
    (folder / "task.toml").write_text("""
[surface]
file = "cube.stl"
[domain]
domain = "Outside"
ground = "zMin"
half = "Across Y"
side_names = "Axes"
boxes_along_body = 8
[grid]
cell_size = 0.5
[output]
mesh = "case/case.foam"
""")
    subprocess.run([PROGRAM, str(folder / "task.toml")], check=True, capture_output=True)
    text = (folder / "case" / "constant" / "polyMesh" / "boundary").read_text()
    for side in SIDES:
        assert side in text, text
    assert "symmetryPlane" in text, text
    check = foam.CheckMesh(folder / "case")
    assert check.ok, check.text

# A gap between a body and the floor, across which boxes have to fit: 0.1 high.
above = simple.CartesianMesher(Input=cube, Domain="Outside", BoxFrom="Bounds",
    DomainBounds=[-2, 2, -2, 2, -0.6, 1.5], CellSize=0.2, CellsAcrossGaps=4, LargestDepth=4,
    SideNames="Axes", BoxesAlongBody=0, TransitionLayers=1, PatchMethod="Exact Fit")
expect(above, {"zMin": 16, "boundary_0": 6})
boxes = above.GetClientSideObject().GetOutputDataObject(0)
level = vtk_to_numpy(boxes.GetCellData().GetArray("Level")).min(axis=1)
middles = [[sum(boxes.GetCell(cell).GetBounds()[i:i + 2]) / 2 for i in (0, 2, 4)]
    for cell in range(boxes.GetNumberOfCells())]
inGap = [abs(x) < 0.45 and abs(y) < 0.45 and z < -0.5 for x, y, z in middles]
assert level[inGap].min() >= 3 and level.min() == 0, level[inGap].min()

# More boxes along the body than halving gives: told, with what to do.
few = simple.CartesianMesher(Input=cube, Domain="Outside", BoxFrom="Bounds", DomainBounds=[-800, 800] * 3, CellSize=800,
    BoxesAlongBody=60)
with Messages() as said:
    few.UpdatePipeline()
assert "Boxes Along Body is 60, but only" in str(said) and "Choose a Cell Size of" in str(said), said
few.CellSize = 0.5
with Messages() as said:
    few.UpdatePipeline()
assert "Boxes Along Body" not in str(said), said

# A hollow cube: the air around it, or in it, alone. On the surface, or in pieces: refused.
hollow = simple.AppendGeometry(Input=[cube, simple.Triangulate(Input=simple.Box(XLength=0.6, YLength=0.6, ZLength=0.6))])
kept = simple.CartesianMesher(Input=hollow, Domain="Outside", LengthsBefore=1, LengthsBehind=1, LengthsBeside=1,
    CellSize=0.4, SideNames="Axes", BoxesAlongBody=0, PatchMethod="Exact Fit")
expect(kept, {"xMin": 9, "boundary_0": 6 + 6 * 0.36})
kept.KeepPoints = [1, 0, 0]
expect(kept, {"xMin": 9, "boundary_0": 6})
left_out = kept.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray("PartsLeftOut")
assert left_out.GetValue(0) == 1, left_out.GetValue(0)
kept.Domain = "Around Points"
kept.KeepPoints = [0.1, 0.1, 0.1]
expect(kept, {"boundary_0": 6 * 0.36})
for points, words in (([0, 0, -0.5], "lies on the surface"), ([9, 0, 0], "outside the grid")):
    kept.KeepPoints = points
    with Messages() as said:
        kept.UpdatePipeline()
    assert error_code(kept) == 40008 and words in str(said), said
