"""Boundaries have names: of blocks, of strings in a cell array, of solids in an STL file, of the
surface's field data. Names, numbers of faces and areas are on the mesh and its boundary."""

import math
import pathlib
import re
import struct
import tempfile

import cartesianmesher.vtkCartesianMesherFilters as filters
from paraview import simple
from vtkmodules.vtkCommonCore import vtkIntArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import (vtkCompositeDataSet, vtkImageData, vtkMultiBlockDataSet,
                                           vtkPartitionedDataSet, vtkPartitionedDataSetCollection, vtkPolyData)

from pipeline import (Messages, assert_identical, error_code, octahedron, output, polydata, producer,
                      read)

EXACT = {"PatchMethod": "Exact Fit", "SmallCells": "Remove", "SmallCellRatio": 0}
FACE = math.sqrt(3) / 2  # area of one of an octahedron's eight
points = [octahedron().GetPoint(i) for i in range(6)]
triangles = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]


def boundaries(data):
    """{number: (name, faces, area)}"""
    fields = data.GetFieldData()
    arrays = [fields.GetAbstractArray(name) for name in
        ("BoundaryIds", "BoundaryNames", "BoundaryFaceCounts", "BoundaryAreas")]
    rows = zip(*([array.GetValue(i) for i in range(array.GetNumberOfValues())] for array in arrays))
    return {number: rest for number, *rest in rows}


def names(data):
    return {number: name for number, (name, *_) in boundaries(data).items()}


def listed(source, boundary_array="Automatic"):
    """What the panel lists before there is a mesh, in rows of texts: the name, the area and the number of triangles."""
    boundaries = filters.vtkSurfaceBoundaries()
    boundaries.SetInputConnection(source.SMProxy.GetClientSideObject().GetOutputPort())
    boundaries.SetBoundaryArray(boundary_array)
    boundaries.Update()
    texts = [boundaries.GetList().GetValue(i) for i in range(boundaries.GetList().GetNumberOfValues())]
    return list(zip(*[iter(texts)] * 3))


def check(source, expected, **properties):
    """`expected`: for each number a name and how many of the octahedron's triangles are its."""
    rows = [(name, f"{count * FACE:.3g}" if count else "", str(count or "")) for _, (name, count) in sorted(expected.items())]
    assert listed(source, properties.get("BoundaryArray", "Automatic")) == rows, (listed(source), rows)
    mesher = simple.CartesianMesher(Input=source, CellSize=0.3, **EXACT, **properties)
    mesh, skin = output(mesher, 0), output(mesher, 1)
    assert error_code(mesher) == 0
    found = boundaries(mesh)
    assert found == boundaries(skin)
    assert names(mesh) == {number: name for number, (name, _) in expected.items()}, found
    ids = skin.GetCellData().GetArray("BoundaryId")
    ids = [ids.GetValue(i) for i in range(ids.GetNumberOfTuples())]
    for number, (name, count) in expected.items():
        _, faces, area = found[number]
        assert faces == ids.count(number), f"{name}: {faces} faces, in truth {ids.count(number)}"
        assert abs(area - count * FACE) < 1e-8, f"{name}: area {area}, in truth {count * FACE}"
    boxer = simple.CartesianBoxer(Input=source, CellSize=0.3,
        **{name: value for name, value in properties.items() if name == "BoundaryArray"})
    patcher = simple.Patcher(Input=source, Boxes=boxer, PatchMethod="Exact Fit", **properties)
    assembler = simple.CellAssembler(Input=boxer, Patches=patcher, SmallCells="Remove", SmallCellRatio=0)
    for port in 0, 1:
        assert_identical("in three steps", output(assembler, port), output(mesher, port))
    return mesh


def strings(values, name="Zone"):
    array = vtkStringArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    return array


def numbers(values, name):
    array = vtkIntArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    return array


# No names.
whole = check(producer(octahedron()), {0: ("boundary_0", 8)})

# Blocks, nested, one without a name, one empty; what the mesh is does not depend on them.
low, high = polydata(points, triangles[:3]), polydata(points, triangles[3:7])
last = polydata(points, triangles[7:])
inner = vtkMultiBlockDataSet()
inner.SetBlock(0, high)
inner.GetMetaData(0).Set(vtkCompositeDataSet.NAME(), "high")
inner.SetBlock(1, last)
outer = vtkMultiBlockDataSet()
outer.SetBlock(0, low)
outer.SetBlock(1, vtkPolyData())
outer.SetBlock(2, None)
outer.SetBlock(3, inner)
mesh = check(producer(outer), {0: ("block_0", 3), 1: ("high", 4), 2: ("block_2", 1)})
assert mesh.GetNumberOfCells() == whole.GetNumberOfCells()

outer.GetMetaData(3).Set(vtkCompositeDataSet.NAME(), "outside")
check(producer(outer), {0: ("block_0", 3), 1: ("high", 4), 2: ("outside", 1)})
outer.GetMetaData(0).Set(vtkCompositeDataSet.NAME(), "high")
check(producer(outer), {0: ("high", 7), 1: ("outside", 1)})

collection = vtkPartitionedDataSetCollection()
collection.SetNumberOfPartitionedDataSets(2)
collection.SetPartition(0, 0, last)
collection.SetPartition(0, 1, high)
collection.SetPartition(1, 0, low)
for i, name in enumerate(["first", "second"]):
    collection.GetMetaData(i).Set(vtkCompositeDataSet.NAME(), name)
check(producer(collection), {0: ("first", 5), 1: ("second", 3)})
partitions = vtkPartitionedDataSet()
for i, part in enumerate((low, high, last)):
    partitions.SetPartition(i, part)
check(producer(partitions), {0: ("block_0", 3), 1: ("block_1", 4), 2: ("block_2", 1)})
check(simple.GroupDatasets(Input=[producer(low), producer(high), producer(last)],
    BlockNames=["x", "y", "z"]), {0: ("x", 3), 1: ("y", 4), 2: ("z", 1)})

# An array wins over blocks where it is asked for.
for part, value in (low, 7), (high, 7), (last, -4):
    part.GetCellData().AddArray(numbers([value] * part.GetNumberOfCells(), "Part"))
check(producer(collection), {-4: ("no_surface", 1), 7: ("boundary_7", 7)}, BoundaryArray="Part")

# Strings.
named = octahedron()
named.GetCellData().AddArray(strings(["wall", "inlet", "wall", "wall", "outlet", "inlet", "wall", "wall"]))
check(producer(named), {0: ("wall", 5), 1: ("inlet", 2), 2: ("outlet", 1)}, BoundaryArray="Zone")

# Numbers that field data names; one has no name, one name no boundary.
named.GetCellData().AddArray(numbers([5, 5, 5, 5, 9, 9, 9, 11], "Part"))
named.GetFieldData().AddArray(numbers([9, 5, 20], "BoundaryIds"))
named.GetFieldData().AddArray(strings(["nine", "five", "twenty"], "BoundaryNames"))
check(producer(named), {5: ("five", 4), 9: ("nine", 3), 11: ("boundary_11", 1), 20: ("twenty", 0)},
    BoundaryArray="Part")

# An array that is called as the mesher's own needs not to be chosen: its output is its input.
numbered = octahedron()
numbered.GetCellData().AddArray(numbers([3] * 5 + [4] * 3, "BoundaryId"))
check(producer(numbered), {3: ("boundary_3", 5), 4: ("boundary_4", 3)})
check(producer(numbered), {3: ("boundary_3", 5), 4: ("boundary_4", 3)}, BoundaryArray="Automatic")
check(producer(numbered), {3: ("boundary_3", 5), 4: ("boundary_4", 3)}, BoundaryArray="")
numbered.GetFieldData().AddArray(numbers([3, 4], "BoundaryIds"))
numbered.GetFieldData().AddArray(strings(["three", "four"], "BoundaryNames"))
again = simple.CartesianMesher(Input=producer(numbered), CellSize=0.3, **EXACT)
again = simple.CartesianMesher(Input=simple.OutputPort(again, 1), CellSize=0.4, **EXACT)
assert {3: "three", 4: "four"}.items() <= names(output(again)).items()

# Blocks lose the suffixes of their files, and nothing else.
check(simple.GroupDatasets(Input=[producer(low), producer(high), producer(last)],
    BlockNames=["x.stl", "y.1", ".obj"]), {0: ("x", 3), 1: ("y.1", 4), 2: (".obj", 1)})

# Groups of an OBJ file: of several words, twice, without a name, without faces, faces before all groups.
corners = "".join("v %g %g %g\n" % point for point in points)
with tempfile.TemporaryDirectory() as folder:
    def groups(*lines):
        path = pathlib.Path(folder) / "groups.obj"
        faces = iter(triangles)
        path.write_text(corners + "".join(
            "f %d %d %d\n" % tuple(i + 1 for i in next(faces)) if line == "f" else line + "\r\n" for line in lines))
        return str(path)

    several = simple.OpenDataFile(groups("f", "g in let", "f", "usemtl red", "f", "g empty", "g wall", "f", "f",
        "g", "f", "  g in let ", "f", "g wall", "f"))
    assert several.GetXMLName() == "NamedOBJReader"
    check(several, {0: ("unnamed", 2), 1: ("in let", 3), 2: ("wall", 3)})
    for lines in (["f"] * 8, ["g"] + ["f"] * 8):
        assert simple.OpenDataFile(groups(*lines)).GetXMLName() != "NamedOBJReader", lines
    check(simple.OpenDataFile(groups("g one", "f", "g one", *["f"] * 7)), {0: ("one", 8)})
    # Objects, unless groups have names.
    check(simple.OpenDataFile(groups("o in let", *["f"] * 3, "o rest", *["f"] * 5)), {0: ("in let", 3), 1: ("rest", 5)})
    check(simple.OpenDataFile(groups("o a", "g one", *["f"] * 3, "o b", *["f"] * 5)), {0: ("one", 8)})

# Names in an STL file. Its own reader is the one that opens it, but only where there are names.
facets = ["facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % points[i] for i in face)
    + "endloop\nendfacet\n" for face in triangles]


def write(path, *solids):
    path.write_bytes(b"".join(f"solid {name}\n{''.join(parts)}endsolid {name}\n".encode("utf-8", "surrogateescape")
        for name, parts in solids))
    return str(path)


def nameless(data):
    copy = data.NewInstance()
    copy.DeepCopy(data)
    copy.GetFieldData().RemoveArray("BoundaryNames")
    return copy


with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "solids.stl"
    several = write(path, ("in let", facets[:3]), ("", facets[3:5]), ("empty", []), ("in let", facets[5:]),
        ("", []))
    reader = simple.OpenDataFile(several)
    assert reader.GetXMLName() == "NamedSTLReader"
    check(reader, {0: ("in let", 6), 1: ("unnamed", 2), 2: ("empty", 0)})
    for solids in [("", facets)], [("Visualization Toolkit generated SLA File", facets)], [("", facets[:3]), ("", facets[3:])]:
        assert simple.OpenDataFile(write(path, *solids)).GetXMLName() == "stlreader"
    # One solid has its name too.
    path = pathlib.Path(folder) / "duct.stl"
    check(simple.OpenDataFile(write(path, ("duct", facets))), {0: ("duct", 8)})

    # Words in other lines than vtkSTLReader expects, or left out.
    usual = pathlib.Path(write(path, ("in let", facets[:3]), ("wall", facets[3:]))).read_text()
    for number, text in enumerate((usual.replace("endloop", "end loop").replace("endfacet", "end facet"), usual.replace("\n", " "),
            usual.replace("\n", "\r"), usual.replace("\n", "\r\n"), usual.replace("endsolid wall\n", ""),
            re.sub("endsolid.*\n", "", usual), re.sub("end(loop|facet)\n", "", usual), usual.upper().replace("IN LET", "in let").replace("WALL", "wall"))):
        path = pathlib.Path(folder) / f"dialect{number}.stl"
        path.write_text(text, newline="")
        check(simple.OpenDataFile(str(path)), {0: ("in let", 3), 1: ("wall", 5)})

    # Names of any characters and length: in UTF-8, in Latin-1, in neither.
    plain = output(simple.OpenDataFile(write(path, ("one", facets[:3]), ("two", facets[3:]))))
    for number, (first, second, *read_as) in enumerate((
        ("Einlaß", "Auslaß"),
        ("流入口側の境界面の名前", "流出口側の境界面の名前"),
        ("Einla\udcdf", "\udcc4u\udcdferes", "Einlaß", "Äußeres"),
        ("\udcff\udcfe", "cut \udce2\udc82", "ÿþ", "cut â\x82"),
        ("x" * 900, "two"),
        ("x" * 247, "x" * 248),
        ("x" * 60000, "ß"),
        ('a"b\\c\x01;{}', "two"),
    )):
        # Of the same name, ParaView takes the file for the one before.
        path = pathlib.Path(folder) / f"named{number}.stl"
        reader = simple.OpenDataFile(write(path, (first, facets[:3]), (second, facets[3:])))
        expected_names = read_as or (first, second)
        mesh = check(reader, {0: (expected_names[0], 3), 1: (expected_names[1], 5)})
        assert_identical("but for its names", nameless(output(reader)), nameless(plain))
        case = pathlib.Path(folder) / f"case{number}" / "case.foam"
        simple.SaveData(str(case), proxy=simple.CartesianMesher(Input=reader, CellSize=0.3))
        (case.parent / "constant" / "polyMesh" / "boundary").read_text(encoding="utf-8")
    # One solid too, if its name is what VTK's reader does not take.
    path = pathlib.Path(folder) / "one.stl"
    check(simple.OpenDataFile(write(path, ("流入口側の境界面の名前", facets))), {0: ("流入口側の境界面の名前", 8)})
    # Without an end in sight it is refused, with its place.
    for number, solids in enumerate(([("n" * 70000, facets)], [("short", facets[:3]), ("n" * 70000, facets[3:])])):
        path = pathlib.Path(folder) / f"long{number}.stl"
        reader = simple.OpenDataFile(write(path, *solids))
        with Messages() as said:
            reader.UpdatePipeline()
        line = 1 if number == 0 else 2 + 7 * 3 + 1
        assert f"Line {line} of {path} has more than 65535 characters" in str(said), str(said)[:500]
    # A binary file may begin with "solid", and with anything.
    for number, head in enumerate((b"solid binary", b"solid a\nsolid b\nfacet", b"solid COLOR=\x80\xff\x01\xff", bytes([200]) * 80)):
        path = pathlib.Path(folder) / f"binary{number}.stl"
        facet = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in face for x in points[i]), 0) for face in triangles)
        path.write_bytes(head.ljust(80, b" ") + struct.pack("<I", 8) + facet)
        assert output(simple.OpenDataFile(str(path))).GetNumberOfCells() == 8
        # One that is cut off is told.
        path = path.with_name(f"cut{number}.stl")
        path.write_bytes(head.ljust(80, b" ") + struct.pack("<I", 8) + facet[:5 * 50 + 20])
        with Messages() as said:
            assert output(simple.OpenDataFile(str(path))).GetNumberOfCells() == 5
        assert "its header says 8 triangles, but there are 5" in str(said), said
exhaust = simple.OpenDataFile(read("kcl_exhaust_header_lumens.stl").FileNames[0])
assert list(names(output(simple.CartesianMesher(Input=exhaust, CellSize=30))).values()) == [
    f"{kind}_{i}" for i in range(1, 5) for kind in ("wall", "inlet", "outlet")]

# Refined Boundaries, which older scripts have, are refined as a row of the table does, with a warning; a row wins.
def refined(**properties):
    return simple.CartesianMesher(Input=exhaust, CellSize=30, **properties)


for chosen, rows in (([], []), (["inlet_1"], [1, 2, 0, 0]), (["outlet_1", "inlet_1"], [1, 2, 0, 0, 2, 2, 0, 0])):
    chooser = refined(RefinedBoundaries=chosen, RefinedBoundaryDepth=2)
    with Messages() as said:
        output(chooser)
    assert ("Refined Boundaries is deprecated" in str(said)) == bool(chosen), said
    expected_cells = output(refined(BoundaryRefinement=rows)).GetNumberOfCells()
    assert output(chooser).GetNumberOfCells() == expected_cells, chosen
chooser.RefinedBoundaries = []
assert_identical("no longer chosen", output(chooser), output(refined()))
row_and_name = refined(BoundaryRefinement=[1, 1, 0, 0], RefinedBoundaries=["inlet_1"], RefinedBoundaryDepth=3)
assert_identical("a row wins", output(row_and_name), output(refined(BoundaryRefinement=[1, 1, 0, 0])))
with Messages() as said:
    wrong = refined(RefinedBoundaries=["nobody"])
    output(wrong)
assert "nobody" in str(said) and error_code(wrong) == 40008, said

# A ratio of a boundary's own is that of its cells, and of no others: those removed or not are the ones
# that meshes with one ratio for all remove or not.
SETTINGS = {"BoundaryNames": ["outlet_1", "wall_2"], "BoundarySmallCellRatios": [0.9, 1e-100]}


def cut(**properties):
    return simple.CartesianMesher(Input=exhaust, CellSize=12, SmallCells="Remove",
        CollapseRatio=0, SplitConcaveCells=0, **properties)


def cells(mesher):
    """{(global box, volume fraction): its main boundary, by area, or None}"""
    mesh, skin = output(mesher), output(simple.CellSize(Input=simple.OutputPort(mesher, 1)))
    owners, boundaries, sizes = (skin.GetCellData().GetArray(name) for name in ("OwnerCell", "BoundaryId", "Area"))
    areas = {}
    for face in range(skin.GetNumberOfCells()):
        of_cell = areas.setdefault(owners.GetValue(face), {})
        boundary = boundaries.GetValue(face)
        of_cell[boundary] = of_cell.get(boundary, 0) + sizes.GetValue(face)
    boxes, fractions, ids = (mesh.GetCellData().GetArray(name) for name in ("GlobalBox", "VolumeFraction", "CellId"))
    return {(boxes.GetTuple(place), fractions.GetValue(place)): areas.get(cell)
        and max(sorted(areas[cell]), key=areas[cell].get)
        for place, cell in enumerate(ids.GetValue(i) for i in range(mesh.GetNumberOfCells()))}


numbers_of = {name: number for number, name in names(output(cut())).items()}
outlet, wall = numbers_of["outlet_1"], numbers_of["wall_2"]
every, usual, own = cells(cut(SmallCellRatio=0)), cells(cut(SmallCellRatio=0.2)), cells(cut(SmallCellRatio=0.2, **SETTINGS))
# Where something flows through nothing that has a volume is left out, unless the user says so.
ratios = {number: 1e-100 for name, number in numbers_of.items() if not name.startswith("wall")}
assert set(usual) == {cell for cell, boundary in every.items() if cell[1] >= ratios.get(boundary, 0.2)}
ratios |= {outlet: 0.9, wall: 1e-100}
expected_own = {cell for cell, boundary in every.items() if cell[1] >= ratios.get(boundary, 0.2)}
assert set(own) == expected_own, set(own) ^ expected_own
for more, less in (own, usual), (usual, own):
    assert set(more) - set(less), f"no cell between {len(own)}, {len(usual)}, {len(every)}"
boxer = simple.CartesianBoxer(Input=exhaust, CellSize=12)
in_steps = simple.CellAssembler(Input=boxer, Patches=simple.Patcher(Input=exhaust, Boxes=boxer),
    SmallCells="Remove", CollapseRatio=0, SplitConcaveCells=0, SmallCellRatio=0.2, **SETTINGS)
for port in 0, 1:
    assert_identical("with ratios, in three steps", output(in_steps, port), output(cut(SmallCellRatio=0.2, **SETTINGS), port))

for wrong, part in (
    ({"BoundaryNames": ["nobody"]}, "Choose from wall_1, inlet_1"),
    ({"BoundaryNames": ["wall_1", "inlet_1", "wall_1"]}, '"wall_1" twice'),
    ({"BoundaryNames": ["wall_1"], "BoundarySmallCellRatios": [1]}, "from 0 to less than 1"),
    ({"BoundaryNames": ["wall_1"], "BoundarySmallCellRatios": [0.1, 0.2]}, "one for each name"),
    ({"BoundaryNames": ["wall_1"], "BoundaryTypes": ["cyclic"]}, "choose one of automatic, patch, wall"),
    ({"BoundaryTypes": ["wall"]}, "one for each name"),
):
    with Messages() as said:
        refused = cut(**wrong)
        output(refused)
    assert part in str(said) and error_code(refused) == 40008, f"no '{part}' in {said}"

# A pattern is a row for several: a boundary's own name goes before it, and the first of several patterns.
NAMES = list(names(output(refined())).values())
INLETS = [name for name in NAMES if name.startswith("inlet")]


def types(mesher):
    fields = output(mesher).GetFieldData()
    array = fields.GetAbstractArray("BoundaryTypes")
    return dict(zip(names(output(mesher)).values(), (array.GetValue(i) for i in range(array.GetNumberOfValues()))))


typed = refined(BoundaryNames=["inlet*", "inlet_2", "*let_?", "wall_*"], BoundaryTypes=["patch", "wall", "symmetry", "automatic"])
for name, type in types(typed).items():
    assert type == ("wall" if name == "inlet_2" else "patch" if name in INLETS else "symmetry" if name.startswith("outlet") else ""), (name, type)
deep = refined(BoundaryNames=["inlet*", "wall_1"], BoundaryDepths=[2, -1])
assert_identical("depths by pattern", output(deep), output(refined(RefinedBoundaries=INLETS, RefinedBoundaryDepth=2)))
row_and_depth = refined(BoundaryRefinement=[1, 1, 0, 0], BoundaryNames=["inlet_1"], BoundaryDepths=[3])
assert_identical("a row wins", output(row_and_depth), output(refined(BoundaryRefinement=[1, 1, 0, 0])))

# Boundaries become one, with a name of their own, and with another that has the name.
merged = refined(BoundaryNames=["inlet*", "outlet_1", "wall_3"], BoundaryTypes=["patch", "automatic", "automatic"],
    BoundaryMergedNames=["inflow", "wall_2", ""], BoundaryDepths=[2, -1, -1])
left = [name for name in NAMES if name not in INLETS and name != "outlet_1"]
assert sorted(names(output(merged)).values()) == sorted(["inflow", *left]), names(output(merged))
assert types(merged)["inflow"] == "patch"
area = {name: area for name, _, area in boundaries(output(merged)).values()}
apart = {name: area for name, _, area in boundaries(output(refined())).values()}
assert abs(area["inflow"] - sum(apart[name] for name in INLETS)) < 1e-3 * area["inflow"]
assert abs(area["wall_2"] - apart["wall_2"] - apart["outlet_1"]) < 1e-2 * area["wall_2"]
for name in "inflow", "wall_2":
    assert output(refined(BoundaryNames=["inlet*", "outlet_1"], BoundaryMergedNames=["inflow", "wall_2"],
        RefinedBoundaries=[name])).GetNumberOfCells() > 0
for wrong, part in (
    ({"BoundaryNames": ["nobody*"], "BoundaryTypes": ["wall"]}, '"nobody*", which is not a boundary'),
    ({"BoundaryNames": ["nobody*"], "BoundaryMergedNames": ["one"]}, '"nobody*", which is not a boundary'),
    ({"BoundaryNames": ["inlet*"], "BoundaryMergedNames": []}, ""),
    ({"BoundaryNames": ["inlet*"], "BoundaryMergedNames": ["one", "two"]}, "one for each name"),
    ({"BoundaryNames": ["inlet*"], "BoundaryDepths": [13]}, "0 to 12"),
    ({"BoundaryNames": ["inlet_1"], "BoundaryMergedNames": ["in"], "RefinedBoundaries": ["inlet_1"]}, "inlet_1"),
):
    with Messages() as said:
        refused = refined(**wrong)
        output(refused)
    assert part in str(said) and error_code(refused) == (40008 if part else 0), f"no '{part}' in {said}"

# What is no surface.
image = vtkImageData()
image.SetDimensions(2, 2, 2)
inner.SetBlock(1, image)
inner.GetMetaData(1).Set(vtkCompositeDataSet.NAME(), "picture")
for source, part in (outer, 'Block "picture" is a vtkImageData'), (vtkMultiBlockDataSet(), "no polygons"):
    with Messages() as said:
        mesher = simple.CartesianMesher(Input=producer(source))
        mesh = output(mesher)
    assert part in str(said) and error_code(mesher) == 40001, said
    assert mesh.GetNumberOfCells() == 0
