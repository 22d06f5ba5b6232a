"""Split Surface: boundaries of a surface without names, by shape, by selection, by new names; STL files with named solids."""

import math
import pathlib
import subprocess
import sys
import tempfile

from paraview import servermanager, simple

from pipeline import DATA

PROGRAM = sys.argv[2]
HEADER = DATA / "kcl_exhaust_header_lumens.stl"
folder = pathlib.Path(tempfile.mkdtemp())


def boundaries(source):
    """{name: (area, triangles)}"""
    source.UpdatePipeline()
    fields = servermanager.Fetch(source).GetFieldData()
    names, areas, counts = ([fields.GetAbstractArray(name).GetValue(i)
            for i in range(fields.GetAbstractArray(name).GetNumberOfValues())]
        for name in ("BoundaryNames", "BoundaryAreas", "BoundaryFaceCounts"))
    assert len(set(names)) == len(names)
    return dict(zip(names, zip(areas, counts)))


def nameless(file):
    """The triangles alone."""
    return simple.PassArrays(Input=simple.OpenDataFile(str(file)), CellDataArrays=[], PointDataArrays=[], FieldDataArrays=[])


def error_of(filter):
    filter.UpdatePipeline()
    return filter.SMProxy.GetClientSideObject().GetErrorCode()


def area(source):
    source.UpdatePipeline()
    return servermanager.Fetch(simple.CellSize(Input=source, ComputeSum=1)) \
        .GetFieldData().GetArray("Area").GetValue(0)


# The header's inlets and outlets are flat caps, and nothing else is.
known = boundaries(simple.SplitSurface(Input=simple.OpenDataFile(str(HEADER)), SplitBy="Boundaries"))
plain = nameless(HEADER)
split = simple.SplitSurface(Input=plain)
found = boundaries(split)
openings = {name: size for name, size in known.items() if not name.startswith("wall")}
assert sorted(found) == sorted([f"cap_{i}" for i in range(1, 9)] + ["wall"]), found
assert sorted(size for name, size in found.items() if name != "wall") == sorted(openings.values())
assert found["wall"][1] == sum(size[1] for name, size in known.items() if name.startswith("wall"))
assert math.isclose(sum(size[0] for size in found.values()), area(plain), rel_tol=1e-12)
assert sum(size[1] for size in found.values()) == 6400

# Boundaries that are there are not lost: the openings stay, walls with their own name.
named = simple.SplitSurface(Input=simple.OpenDataFile(str(HEADER)))
assert boundaries(named) == known

# By edges each of the header's boundaries is one patch; connected, each tube.
assert len(boundaries(simple.SplitSurface(Input=plain, SplitBy="Feature Angle"))) == 12
assert len(boundaries(simple.SplitSurface(Input=plain, SplitBy="Connected Parts"))) == 4

# A duct: the largest cap has the first name.
cone = simple.Triangulate(Input=simple.Cylinder(Height=6, Radius=0.5, Resolution=32))
wedge = simple.Calculator(Input=cone, Function="coordsX*(1+coordsY/12)*iHat+coordsY*jHat+coordsZ*kHat", CoordinateResults=1)
flow = simple.SplitSurface(Input=wedge, CapNames="outlet, inlet")
sizes = boundaries(flow)
assert sorted(sizes) == ["inlet", "outlet", "wall"] and sizes["outlet"][0] > sizes["inlet"][0], sizes

# New names, by patterns; those of one name become one.
flow.BoundaryNames, flow.BoundaryMergedNames = ["*let"], ["opening"]
merged = boundaries(flow)
assert sorted(merged) == ["opening", "wall"]
assert math.isclose(merged["opening"][0], sizes["inlet"][0] + sizes["outlet"][0], rel_tol=1e-12)
flow.SMProxy.UpdatePropertyInformation()
rows = list(flow.GetProperty("FoundBoundaries"))
assert rows[:4] == ["Boundary", "Before", "Area", "Triangles"] and "outlet, inlet" in rows, rows
flow.BoundaryNames = ["nothing*"]
assert error_of(flow) == 40008
flow.BoundaryNames, flow.BoundaryMergedNames = [], []

# A selected triangle names the whole patch, or itself.
one = servermanager.sources.IDSelectionSource(IDs=[-1, 0], FieldType="CELL")
picked = simple.SplitSurface(Input=plain, Selection=one, SelectionName="picked")
whole = boundaries(picked)
assert len(whole) == 9 and whole["picked"] in found.values(), whole
picked.SelectWholePatches = 0
assert boundaries(picked)["picked"][1] == 1
assert math.isclose(sum(size[0] for size in boundaries(picked).values()), area(plain), rel_tol=1e-12)
by_number = simple.SplitSurface(Input=plain, SelectedCells=[0], SelectWholePatches=0, SelectionName="picked")
assert boundaries(by_number) == boundaries(picked)
by_number.SelectedCells = [0, 10**6]
assert error_of(by_number) == 40008
picked.SelectionName = ""
assert error_of(picked) == 40008
nowhere = simple.SplitSurface(Input=plain, SelectionName="none",
    Selection=servermanager.sources.IDSelectionSource(IDs=[-1, 10**6], FieldType="CELL"))
assert error_of(nowhere) == 40008

# A picked cap leaves no gap in the numbers of the others, whatever it is called.
names = servermanager.Fetch(split).GetCellData().GetAbstractArray("BoundaryName")
second = next(i for i in range(names.GetNumberOfValues()) if names.GetValue(i) == "cap_2")
for name, expected in ("inlet", [1, 2, 3, 4, 5, 6, 7]), ("cap_5", [1, 2, 3, 4, 5, 6, 7]), ("cap_9", [1, 2, 3, 4, 5, 6, 7, 9]):
    gate = boundaries(simple.SplitSurface(Input=plain, SelectionName=name,
        Selection=servermanager.sources.IDSelectionSource(IDs=[-1, second], FieldType="CELL")))
    assert [number for number in range(1, 10) if f"cap_{number}" in gate] == expected, gate

# Saved as STL, each boundary is a solid: the same ones come back. Without names it is ParaView's file.
file = folder / "header.stl"
simple.SaveData(str(file), proxy=split)
back = boundaries(simple.SplitSurface(Input=simple.OpenDataFile(str(file)), SplitBy="Boundaries"))
assert back.keys() == found.keys() and all(back[name][1] == found[name][1] and
    math.isclose(back[name][0], found[name][0], rel_tol=1e-12) for name in found), back
simple.SaveData(str(folder / "plain.stl"), proxy=plain)
assert (folder / "plain.stl").stat().st_size == 84 + 50 * 6400

# Polygons keep their cells; blocks become one piece, each with its boundaries.
box = simple.Box(XLength=5)
assert boundaries(simple.SplitSurface(Input=box, SplitBy="Feature Angle")) and \
    servermanager.Fetch(simple.SplitSurface(Input=box)).GetNumberOfCells() == 6
blocks = simple.GroupDatasets(Input=[box, simple.Sphere(Center=[9, 0, 0])], BlockNames=["duct", "ball"])
assert sorted(boundaries(simple.SplitSurface(Input=blocks))) == ["ball", "cap_1", "cap_2", "duct"]

# The mesher takes them; a task does the same, bit for bit.
mesher = simple.CartesianMesher(Input=simple.SplitSurface(Input=wedge, CapNames="outlet, inlet"), CellSize=0.25)
mesher.UpdatePipeline()
simple.SaveData(str(folder / "wedge.vtp"), proxy=wedge, DataMode="Binary")
(folder / "task.toml").write_text("""
[surface]
file = "wedge.vtp"
[surface.split]
cap_names = "outlet, inlet"
[[surface.split.boundaries]]
name = "wall"
merged_name = "wall"
[grid]
cell_size = 0.25
[output]
mesh = "mesh.vtu"
""")
subprocess.run([PROGRAM, folder / "task.toml", "--quiet"], check=True)
mesh = servermanager.Fetch(mesher)
again = servermanager.Fetch(simple.OpenDataFile(str(folder / "mesh.vtu")))
assert mesh.GetNumberOfCells() == again.GetNumberOfCells() > 100
assert all(mesh.GetPoint(i) == again.GetPoint(i) for i in range(mesh.GetNumberOfPoints()))
for data in mesh, again:
    names = data.GetFieldData().GetAbstractArray("BoundaryNames")
    assert sorted(names.GetValue(i) for i in range(names.GetNumberOfValues())) == ["inlet", "outlet", "wall"]
(folder / "task.toml").write_text('[surface]\nfile = "wedge.vtp"\nsplit = "By Magic"\n')
said = subprocess.run([PROGRAM, folder / "task.toml"], capture_output=True, text=True)
assert said.returncode == 2 and "task.toml:3: surface.split" in said.stderr and "Flat Caps" in said.stderr, said
