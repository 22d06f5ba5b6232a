"""Whatever is wrong with the input: a message that says what, where and what to do, an error code,
an output that is empty or valid, and no crash."""

import math
import pathlib
import tempfile

from cartesianmesher.vtkCartesianMesherFilters import vtkCartesianMesher
from paraview import simple
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPolyData

import measure
from pipeline import (DATA, Messages, assert_identical, error_code, merged, octahedron, output, polydata,
                      producer, read)

EMPTY_SURFACE, BAD_COORDINATE, BAD_CELL_SIZE, BAD_MESHLINES, TOO_MANY_BOXES, MISSING_ARRAY, \
    FLAWED_SURFACE, BAD_PARAMETER = range(40001, 40009)

clean = octahedron()
points = [clean.GetPoint(i) for i in range(6)]
triangles = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
surface = producer(clean)


def check(filter, code, *parts):
    """One message, that has all the parts in it, or none where nothing is wrong."""
    with Messages() as said:
        data = output(filter)
    text = str(said)
    found = error_code(filter)
    assert found == code, f"error code {found} instead of {code}: {text}"
    assert text or not (code or parts), "no message"
    assert code or parts or not text, text
    for part in parts:
        assert part in text, f"no '{part}' in: {text}"
    print(code, text.partition("): ")[2].strip().partition("\n")[0])
    return data


def refused(source, code, *parts, **properties):
    mesher = simple.CartesianMesher(Input=source, **properties)
    mesh = check(mesher, code, *parts)
    assert mesh.GetNumberOfCells() == 0 and mesh.GetNumberOfPoints() == 0
    assert output(mesher, 1).GetNumberOfCells() == 0


def partial(source, *parts, code=0, **properties):
    # Merged cells are larger than their boxes, and corners that move change boxes.
    mesher = simple.CartesianMesher(Input=source, SmallCells="Remove", CollapseRatio=0, **properties)
    mesh = check(mesher, code, *parts)
    assert mesh.GetNumberOfCells() > 0
    return measure.Mesh(mesh, output(mesher, 1))


# No surface.
refused(producer(vtkPolyData()), EMPTY_SURFACE, "no polygons", "connect")
refused(producer(polydata(points, [])), EMPTY_SURFACE, "no polygons")
refused(producer(polydata(points, [(0, 1), (1, 2)])), EMPTY_SURFACE, "no triangles")
refused(producer(polydata([(1, 2, 3)] * 3, [(0, 1, 2)])), EMPTY_SURFACE, "coincide")
# ... but something else: one error, of our own.
for wrong, name in (simple.Wavelet(), "vtkImageData"), (simple.CartesianMesher(Input=surface), "vtkUnstructuredGrid"):
    refused(wrong, EMPTY_SURFACE, f"The input is a {name}, not a surface", "Extract Surface")
with Messages() as said:
    output(simple.CartesianMesher(Input=simple.Wavelet()))
assert str(said).count("ERROR") == 1, said
with Messages() as said:
    vtkCartesianMesher().Update()
assert "has 0 connections but is not optional" in str(said), said

# Coordinates.
for bad in math.nan, math.inf, -math.inf, 1e300:
    points_of_bad = list(points)
    points_of_bad[4] = (0, bad, 0)
    refused(producer(polydata(points_of_bad, triangles)), BAD_COORDINATE, "Point 4", "cell 2")
# ... of a point that no triangle uses do no harm.
idle = producer(polydata(points + [(math.nan, 0, 0)], triangles))
assert_identical("idle point", output(simple.CartesianMesher(Input=idle)),
    output(simple.CartesianMesher(Input=surface)))

# Cell size.
for bad in -1, math.nan, math.inf:
    refused(surface, BAD_CELL_SIZE, f"Cell Size is {bad}", "positive", CellSize=bad)
refused(surface, BAD_CELL_SIZE, "only 2", "smaller", CellSize=1e9)
refused(surface, BAD_CELL_SIZE, "Cell Size 40 is larger than the surface", CellSize=40, SmallCells="Remove")
refused(surface, TOO_MANY_BOXES, "1.335e+12 boxes", "GiB", "larger Cell Size", CellSize=1e-4)
refused(surface, TOO_MANY_BOXES, "2e+300 x 2e+300", "larger", CellSize=1e-300)
refused(surface, TOO_MANY_BOXES, "2e+07 x 2e+07", CellSize=1e-7)
# ... and the panel does not keep the row of the mesh before.
mesher = simple.CartesianMesher(Input=surface)
output(mesher)
assert mesher.SMProxy.GetClientSideObject().GetMade().GetNumberOfValues() == 8
mesher.CellSize = 1e9
check(mesher, BAD_CELL_SIZE, "only 2")
assert mesher.SMProxy.GetClientSideObject().GetMade().GetNumberOfValues() == 0
refused(surface, TOO_MANY_BOXES, "Memory Limit of 0.001 GiB", MemoryLimit=1e-3)

# Meshlines.
refused(surface, BAD_MESHLINES, "Meshlines X", "at least two", MeshlinesX=[0])
for bad in [0, 0], [0.5, -0.5], [0, math.nan]:
    refused(surface, BAD_MESHLINES, "Meshlines Y must increase", "position 1", MeshlinesY=bad)
refused(surface, BAD_MESHLINES, "Meshlines Z must increase", "position 0",
    MeshlinesZ=[-math.inf, 0])
for bad in [3, 4], [-9, -1]:
    refused(surface, BAD_MESHLINES, "Meshlines X", "miss the surface", "between -1", MeshlinesX=bad)
refused(surface, BAD_MESHLINES, "along X are closer than", MeshlinesX=[0, 1e-12])
# The surface reaches beyond the meshlines: a warning, not an error.
cut_off = partial(surface, "Meshlines X", "the mesh is cut off", MeshlinesX=[-0.5, 0, 0.5],
    PatchMethod="Exact Fit")
assert abs(cut_off.volume - 7 / 6) < 1e-8, cut_off.volume
assert sorted(cut_off.areas) == [-1, 0]

# An array of the wrong length, a file that ends in the middle.
short = polydata(points, triangles)
numbers = vtkIntArray()
numbers.SetName("Boundaries")
numbers.SetNumberOfTuples(3)
short.GetCellData().AddArray(numbers)
refused(producer(short), MISSING_ARRAY, 'Boundary Array "Boundaries"', BoundaryArray="Boundaries")
whole = (DATA / "HD_airframe_aileron_gap.stl").read_bytes()
with tempfile.TemporaryDirectory() as folder:
    for part in 2, 100:
        path = pathlib.Path(folder) / f"cut{part}.stl"
        path.write_bytes(whole[:len(whole) // part])
        with Messages() as said:
            cut = simple.CartesianMesher(Input=simple.STLReader(FileNames=[str(path)]))
            output(cut)
        # VTK 9.6 reads nothing of a file that is cut off, older ones what is there.
        assert any(words in str(said) for words in ("remature", "open edges", "file length bad")), said

# Other properties.
refused(surface, MISSING_ARRAY, 'Boundary Array "Nope"', "choose another", BoundaryArray="Nope")
for bad in -0.1, 1, math.nan:
    refused(surface, BAD_PARAMETER, f"Small Cell Ratio is {bad}", "less than 1", SmallCellRatio=bad)

# Flaws of the surface, and what is left of the mesh.
for name, flawed, parts in (
    ("open", polydata(points, triangles[:-1]), ["3 open edges", "of cell 6", "(0, -1, 0)",
        "1 hole is wider than a box", "a lid", "hole 0.81"]),
    ("doubled", merged(clean, clean), ["8 duplicate triangles are left out, such as cell 14 at (-0.333333, -0.333333, -0.333333)"]),
    ("overlapping", merged(clean, octahedron(1, (0.3, 0.4, 0.1))), ["pairs of triangles intersect.\n  cells ", " at ("]),
):
    mesh = partial(producer(flawed), *parts, CellSize=0.2)
    assert 0.5 < mesh.volume < 4 / 3 * 2, f"{name}: volume {mesh.volume}"
# Triangles may be turned either way: shells in shells are cavities.
for name, turned, volume, parts in (
    ("inconsistent", polydata(points, triangles[:-1] + [(0, 5, 4)]), 4 / 3, []),
    ("nested", merged(clean, octahedron(0.5)), 4 / 3 * 7 / 8, ["checkMesh will fail"]),  # small cells stay
):
    mesh = partial(producer(turned), *parts, CellSize=0.2, PatchMethod="Exact Fit", SmallCellRatio=0)
    assert abs(mesh.volume - volume) < 1e-8, f"{name}: volume {mesh.volume}"
partial(read("tm_not_convex.obj"), "12 edges shared by more than two triangles", "non-manifold edge")
refused(producer(polydata(points, triangles[:1])), FLAWED_SURFACE, "nothing to mesh", "3 open edges")
refused(producer(polydata(points, [(0, 1, 2), (0, 2, 1)])), FLAWED_SURFACE, "encloses no volume")
refused(simple.Plane(XResolution=4), FLAWED_SURFACE, "open sheet", "10 open edges", "Domain to Outside")
refused(producer(polydata(points, [(0, 1, 1)])), FLAWED_SURFACE, "encloses no volume")
wing = simple.CartesianMesher(Input=read("HD_airframe_aileron_gap.stl"))
assert check(wing, 0, "8 open edges", "does not close").GetNumberOfCells() > 500

# Polygons that are no triangles.
box = simple.Box()
assert_identical("polygons", output(simple.CartesianMesher(Input=box)),
    output(simple.CartesianMesher(Input=simple.Triangulate(Input=box))))

# Polygons that cross or touch themselves: VTK's triangles leave them out, or a part of them. Concave ones are
# as good as others, and those without area no loss.
floor = [(0, 0, 0), (3, 0, 0), (3, 2, 0), (0, 2, 0)]
roof = [(x, y, 1) for x, y, _ in floor]
walls = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
crossing = "1 polygon, cell 4, crosses or touches itself"
divided = simple.GetParaViewVersion() >= 6  # VTK 9.6 makes triangles of a bow tie, which then fold
for name, top, parts in (
    ("bow tie", (4, 6, 5, 7), ["4 open edges", "folded back"] if divided else [crossing]),
    ("touches itself", (4, 5, 6, 7, 4, 8, 9, 10, 8), [crossing]),
    ("concave", (4, 8, 5, 6, 7), []),
    ("doubled corner", (4, 5, 5, 6, 7), []),
):
    inner = [(1, 0.5, 1), (1, 1.5, 1), (2, 1.5, 1)]
    box_of = polydata(floor + roof + inner, [*walls, top, (3, 2, 1, 0)])
    mesher = simple.CartesianMesher(Input=producer(box_of), CellSize=0.5)
    with Messages() as said:
        output(mesher)
    assert all(part in str(said) for part in parts) and ("touches itself" in str(said)) == (crossing in parts), (name, str(said))
    assert error_code(mesher) == 0, name
    # The same as the surface of a region.
    region = simple.RefinementRegion(Input=producer(box_of), Shape="Input", Depth=1)
    mesher = simple.CartesianMesher(Input=box, RefinementRegions=[region], CellSize=0.5)
    with Messages() as said:
        output(mesher)
    assert crossing not in parts or "In a refinement region: " + crossing in str(said), (name, str(said))

# What vtkGhostType hides is not there: the rest is meshed as if it were alone.
pair = merged(octahedron(), octahedron(1, (5, 0, 0)))
for where, value, which in (
    ("CellData", vtkDataSetAttributes.HIDDENCELL, range(8, 16)),
    ("CellData", vtkDataSetAttributes.DUPLICATECELL, range(8, 16)),
    ("PointData", vtkDataSetAttributes.HIDDENPOINT, range(6, 12)),
):
    ghosts = vtkUnsignedCharArray()
    ghosts.SetName(vtkDataSetAttributes.GhostArrayName())
    for i in range(16 if where == "CellData" else 12):
        ghosts.InsertNextValue(value if i in which else 0)
    hiding = polydata([pair.GetPoint(i) for i in range(12)],
        [[pair.GetCell(i).GetPointId(j) for j in range(3)] for i in range(16)])
    getattr(hiding, "Get" + where)().AddArray(ghosts)
    assert_identical(f"hidden by {where}, {value}",
        check(simple.CartesianMesher(Input=producer(hiding), CellSize=0.3), 0),
        output(simple.CartesianMesher(Input=surface, CellSize=0.3)))
hiding = octahedron()
ghosts = vtkUnsignedCharArray()
ghosts.SetName(vtkDataSetAttributes.GhostArrayName())
for _ in range(8):
    ghosts.InsertNextValue(vtkDataSetAttributes.HIDDENCELL)
hiding.GetCellData().AddArray(ghosts)
refused(producer(hiding), EMPTY_SURFACE, "no triangles")

# Boxes and patches that do not belong together.
boxer = simple.CartesianBoxer(Input=surface, CellSize=0.3)
coarser = simple.CartesianBoxer(Input=surface, CellSize=0.5)
patcher = simple.Patcher(Input=surface, Boxes=boxer)
other = simple.Patcher(Input=simple.Sphere(), Boxes=boxer)


def assembled(boxes, patches, code, *parts):
    assembler = simple.CellAssembler(Input=boxes, Patches=patches, SmallCells="Remove", CollapseRatio=0)
    mesh = check(assembler, code, *parts)
    if code == MISSING_ARRAY:
        assert mesh.GetNumberOfCells() == 0
    elif mesh.GetNumberOfCells():
        measure.Mesh(mesh, output(assembler, 1))


def without(filter, name, where="CellData"):
    data = output(filter)
    copy = data.NewInstance()
    copy.ShallowCopy(data)
    getattr(copy, "Get" + where)().RemoveArray(name)
    return producer(copy)


assembled(boxer, patcher, 0)
assembled(coarser, patcher, MISSING_ARRAY, "Patch ", "same Cartesian Boxer")
assembled(boxer, surface, MISSING_ARRAY, '"BoundaryId"', "Patcher")
for name in "GlobalBox", "Status", "CornerStatus":
    assembled(without(boxer, name), patcher, MISSING_ARRAY, f'"{name}"', "Cartesian Boxer")
for name in "BoundaryId", "BoxId":
    assembled(boxer, without(patcher, name), MISSING_ARRAY, f'"{name}"', "Patcher")
for name in "LatticeOrigin", "LatticeStep", "PlanesX", "PlanesY", "PlanesZ":
    bare = without(boxer, name, "FieldData")
    assembled(bare, patcher, MISSING_ARRAY, f'"{name}"', "Cartesian Boxer")
    check(simple.Patcher(Input=surface, Boxes=bare), MISSING_ARRAY, f'"{name}"')
# Another unit of offsets, and deeper boxes than it has.
for parts in 32, 100, 2**13:
    copy = output(boxer).NewInstance()
    copy.ShallowCopy(output(boxer))
    unit = vtkDoubleArray()
    unit.SetName("PartsPerBox")
    unit.InsertNextValue(parts)
    copy.GetFieldData().AddArray(unit)
    assembled(producer(copy), patcher, MISSING_ARRAY, '"PartsPerBox"', str(parts), "Cartesian Boxer")
# Some boxes taken away.
for status in 1, 2:
    some = simple.Threshold(Input=boxer, Scalars=["CELLS", "Status"], LowerThreshold=status,
        UpperThreshold=status)
    assembled(some, patcher, MISSING_ARRAY, "does not belong", "same Cartesian Boxer")
# The patches of another surface in the same boxes.
assembled(boxer, other, 0, "does not close")
for elsewhere in octahedron(1, (100, 0, 0)), octahedron(1e-3, (0.95, 0.95, 0.95)):
    check(simple.Patcher(Input=producer(elsewhere), Boxes=boxer), MISSING_ARRAY, "does not lie in the boxes")
