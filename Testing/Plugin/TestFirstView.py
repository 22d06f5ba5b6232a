"""What a view shows of the mesher's outputs at first: boundaries, defects and regions in colours by name, one boundary in a
plain colour, sides of a flow domain that one can look through; and that a state keeps the colours it was saved with."""

import pathlib
import tempfile

from paraview import simple
from vtkmodules.vtkCommonCore import vtkIntArray, vtkStringArray

from pipeline import DATA, Messages, octahedron, output, producer, read

folder = pathlib.Path(tempfile.mkdtemp())
view = simple.CreateView("RenderView")


def shown(mesher, port=1):
    with Messages() as text:
        display = simple.Show(simple.OutputPort(mesher, port), view)
        simple.Render(view)
    assert "ERR" not in str(text) and "annotation" not in str(text), str(text)
    return display


def names(table):
    """Of each category its name, and that all have colours of their own."""
    pairs = list(table.Annotations)
    colours = {tuple(table.IndexedColors[i:i + 3]) for i in range(0, len(table.IndexedColors), 3)}
    assert len(colours) == len(pairs) // 2 and table.InterpretValuesAsCategories == 1
    return dict(zip(pairs[::2], pairs[1::2]))


def labelled(count):
    """A ball each of whose triangles is of one of so many boundaries."""
    ball = output(simple.Sphere(ThetaResolution=16, PhiResolution=16))
    label = vtkIntArray()
    label.SetName("Label")
    for i in range(ball.GetNumberOfCells()):
        label.InsertNextValue(i * count // ball.GetNumberOfCells())
    ball.GetCellData().AddArray(label)
    return producer(ball)


# One boundary: no legend, and nothing to say of defects that are not there.
one = simple.CartesianMesher(Input=producer(octahedron()), CellSize=0.3)
display = shown(one)
assert display.ColorArrayName[1] == "" and display.Representation == "Surface With Edges"
assert shown(one, 2).ColorArrayName[1] == ""
assert shown(one, 0).Representation == "Outline"

exhaust = simple.CartesianMesher(Input=simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl")), CellSize=15)
display = shown(exhaust)
expected = {f"{kind}_{i}" for kind in ("inlet", "outlet", "wall") for i in range(1, 5)}
assert list(display.ColorArrayName) == ["CELLS", "BoundaryName"]
assert names(display.LookupTable) == {name: name for name in expected}
display.SetScalarBarVisibility(view, True)
legend = simple.GetScalarBar(display.LookupTable, view)
assert legend.LabelFontSize == 12 and legend.DrawAnnotations == 1
first = list(display.LookupTable.IndexedColors)

# Another mesh in the same colours adds its boundaries: more than ParaView would find by itself.
display = shown(simple.CartesianMesher(Input=labelled(40), BoundaryArray="Label", CellSize=0.1))
assert names(display.LookupTable) == {name: name for name in expected | {f"boundary_{i}" for i in range(40)}}
assert list(display.LookupTable.IndexedColors)[:len(first)] == first

# The body in a flow domain is seen through its sides.
display = shown(simple.CartesianMesher(Input=producer(octahedron()), Domain="Outside", SideNames="Axes", CellSize=0.5))
opacity = dict(zip(names(display.LookupTable), display.LookupTable.IndexedOpacities))
sides = {f"{axis}{end}" for axis in "xyz" for end in ("Min", "Max")}
assert display.LookupTable.EnableOpacityMapping == 1
assert {name for name in opacity if opacity[name] < 1} == sides, opacity
display = shown(simple.CartesianMesher(Input=producer(octahedron()), Domain="Outside", CellSize=0.5))
opacity = dict(zip(names(display.LookupTable), display.LookupTable.IndexedOpacities))
assert {name for name in opacity if opacity[name] < 1} == sides | {"inlet", "outlet", "sides"}, opacity

# Defects have words and thick lines, also those of the surface alone.
flawed = read("HD_airframe_aileron_gap.stl")
with Messages():
    mesher = simple.CartesianMesher(Input=flawed)
    inspector = simple.SurfaceInspector(Input=flawed)
    mesher.UpdatePipeline()
    inspector.UpdatePipeline()
for display in shown(mesher, 2), shown(inspector, 0):
    assert list(display.ColorArrayName) == ["CELLS", "DefectName"] and display.LineWidth == 4
    assert names(display.LookupTable)["NonManifoldEdges"] == "non manifold edges"

# The summary is small, in a corner.
display = shown(simple.MeshSummary(Input=one), 0)
assert display.WindowLocation == "Upper Left Corner" and display.FontSize == 12 and display.Justification == "Left"

# Regions have names too, once somebody asks for them.
def box(size):
    return simple.Triangulate(Input=simple.Box(XLength=size, YLength=size, ZLength=size))


assembly = simple.GroupDatasets(Input=[box(1), box(2)], BlockNames=["gas", "solid"])
mesher = simple.CartesianMesher(Input=assembly, RegionsFrom="Blocks", CellSize=0.3)
display = shown(mesher)
simple.ColorBy(display, ("CELLS", "Region"))
assert names(display.LookupTable) == {"1": "gas", "2": "solid"}
other = simple.GroupDatasets(Input=[box(1), box(2)], BlockNames=["water", "solid"])
shown(simple.CartesianMesher(Input=other, RegionsFrom="Blocks", CellSize=0.3))
assert names(display.LookupTable) == {"1": "water", "2": "solid"}

# Interfaces too, also if there is only one.
display = shown(mesher, 3)
assert list(display.ColorArrayName) == ["CELLS", "InterfaceName"] and display.Representation == "Surface With Edges"
assert names(display.LookupTable) == {"gas_to_solid": "gas_to_solid"}
assert shown(one, 3).ColorArrayName[1] == ""

# So many faces that edges would hide them have none, from the beginning or later; until somebody else chooses.
plate = simple.CartesianMesher(Input=simple.Triangulate(Input=simple.Box(ZLength=0.02)), CellSize=0.0055)
quality = simple.FiniteVolumeQuality(Input=plate)
displays = shown(plate), shown(quality, 0)
for size, representation in (0.0055, "Surface"), (0.02, "Surface With Edges"), (0.0055, "Surface"):
    plate.CellSize = size
    quality.UpdatePipeline()
    assert [display.Representation for display in displays] == [representation] * 2, size
for display, chosen in zip(displays, ("Wireframe", "Surface With Edges")):
    display.Representation = chosen
for size in 0.02, 0.0055:
    plate.CellSize = size
    quality.UpdatePipeline()
    assert [display.Representation for display in displays] == ["Wireframe", "Surface With Edges"]

# Scripts hide what they want (the window hides the boundary behind a clip: TestViews).
boundary, mesh = shown(plate), shown(plate, 0)
assert mesh.ColorArrayName[1] == "" and boundary.Visibility == 1
cells = shown(simple.Clip(Input=simple.OutputPort(plate, 0)), 0)
assert boundary.Visibility == 1 and mesh.Visibility == 1
assert cells.ColorArrayName[1] == "", "nothing is refined"
# Where cells differ, they are coloured by their level, one number.
refined = simple.CartesianMesher(Input=producer(octahedron()), CellSize=0.3, RefinementDepth=1)
display = shown(simple.Clip(Input=simple.OutputPort(refined, 0)), 0)
assert list(display.ColorArrayName) == ["CELLS", "RefinementLevel"], display.ColorArrayName
assert shown(refined, 0).ColorArrayName[1] == ""

# The menu of colours lists the arrays of cells and points, and no statistics; scripts read these as ever.
fields = output(plate).GetFieldData()
assert fields.GetArray("Cells").GetValue(0) == output(plate).GetNumberOfCells() and fields.GetNumberOfArrays() > 40
for port, display in (0, mesh), (1, boundary), (0, cells), (0, shown(quality, 0)):
    arrays = display.SMProxy.GetProperty("ColorArrayName").GetDomain("array_list")
    offered = {arrays.GetString(i) for i in range(arrays.GetNumberOfStrings())}
    assert not offered & {fields.GetArrayName(i) for i in range(fields.GetNumberOfArrays())}, offered
    assert "BoundaryId" in offered if display == boundary else "RefinementLevel" in offered, offered

# A state is as it was saved.
display = simple.GetDisplayProperties(simple.OutputPort(exhaust, 1), view)
simple.ColorBy(display, ("CELLS", "OwnerCell"))
display.Representation = "Wireframe"
simple.SaveState(str(folder / "state.pvsm"))
simple.ResetSession()
simple.LoadState(str(folder / "state.pvsm"))
display = simple.GetDisplayProperties(simple.OutputPort(simple.FindSource("CartesianMesher2"), 1), simple.GetActiveView())
assert list(display.ColorArrayName) == ["CELLS", "OwnerCell"] and display.Representation == "Wireframe"

# Boundaries that are called as colours, as those of CAD files may be, have them.
coloured = octahedron()
colour = vtkStringArray()
colour.SetName("Colour")
for i in range(coloured.GetNumberOfCells()):
    colour.InsertNextValue("FF0000" if i < 4 else "0080FF")
coloured.GetCellData().AddArray(colour)
table = shown(simple.CartesianMesher(Input=producer(coloured), CellSize=0.3, BoundaryArray="Colour")).LookupTable
for name, expected in ("FF0000", [1, 0, 0]), ("0080FF", [0, 128 / 255, 1]):
    at = 3 * list(table.Annotations)[::2].index(name)
    assert list(table.IndexedColors)[at:at + 3] == expected, (name, list(table.IndexedColors))
