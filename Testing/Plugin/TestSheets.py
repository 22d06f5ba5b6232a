"""Sheets: a plate whose triangles are there twice, with a boundary for each side, stands on a body and ends in the flow around
it; each side becomes a patch. Left out, a message names both. An open plate in a flow is kept too, and told; a box without one face
is closed."""

import tempfile

from paraview import simple
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

import foam
from pipeline import Messages, output, polydata, producer

temporary = tempfile.TemporaryDirectory()


def body_with_fin():
    """A box of 1 x 1 x 0.4 with a fin through its top: boundaries body, left and right."""
    parts = [("body", simple.Box(XLength=1, YLength=1, ZLength=0.4, Center=[0, 0, 0.2]))]
    for name, second, third in ("left", [0.4, 0.1, 0.3], [-0.3, 0.3, 0.9]), ("right", [-0.3, 0.3, 0.9], [0.4, 0.1, 0.3]):
        parts.append((name, simple.Plane(Origin=[-0.4, 0, 0.3], Point1=second, Point2=third, XResolution=3, YResolution=3)))
    both, names = vtkAppendPolyData(), vtkStringArray()
    names.SetName("Wall")
    for name, source in parts:
        part = output(simple.Triangulate(Input=source))
        both.AddInputData(part)
        for _ in range(part.GetNumberOfCells()):
            names.InsertNextValue(name)
    both.Update()
    both.GetOutput().GetCellData().AddArray(names)
    return producer(both.GetOutput())


def mesher(**properties):
    return simple.CartesianMesher(Input=body_with_fin(), BoundaryArray="Wall", Domain="Outside", BoxFrom="Bounds",
                                  DomainBounds=[-2, 3, -1.5, 1.5, -1, 2], CellSize=0.4, RefinementDepth=2, **properties)


made = mesher()
made.UpdatePipeline()
sheet = foam.Files(foam.save(simple.OutputPort(made, "Mesh"), f"{temporary.name}/kept"))
sheet.check()
areas = sheet.areas()
print({name: round(area, 4) for name, area in areas.items()}, sheet.cells, "cells")
above = (0.06 ** 2 + 0.48 ** 2 + 0.23 ** 2) ** 0.5 * 5 / 6  # what stands in the body goes
for name in "left", "right":
    assert abs(areas[name] / above - 1) < 0.05, (name, areas, above)

with Messages() as said:
    without = mesher(Sheets="Leave Out")
    without.UpdatePipeline()
    bare = foam.Files(foam.save(simple.OutputPort(without, "Mesh"), f"{temporary.name}/left"))
assert "2 boundaries have no faces in the mesh" in str(said) and "left, right" in str(said), str(said)
assert set(bare.patches) == set(sheet.patches) - {"left", "right"}, (bare.patches, sheet.patches)
assert foam.CheckMesh(f"{temporary.name}/left").ok


def in_a_flow(source, turn, **properties):
    """In a box of 8 x 8 x 8, its surface turned about y."""
    turned = simple.Transform(Input=simple.Triangulate(Input=source), Transform="Transform")
    turned.Transform.Rotate = [0, turn, 0]
    return simple.CartesianMesher(Input=turned, Domain="Outside", BoxFrom="Bounds",
                                  DomainBounds=[-4, 4, -4, 4, -4, 4], CellSize=0.8, RefinementDepth=3, **properties)


def meshed(source, turn, **properties):
    """The area of all boundaries but the box's sides, and what was said."""
    with Messages() as told:
        proxy = in_a_flow(source, turn, **properties)
        proxy.UpdatePipeline()
        case = foam.Files(foam.save(simple.OutputPort(proxy, "Mesh"), f"{temporary.name}/{id(proxy)}"))
    areas = case.areas()
    print(turn, properties, {name: round(area, 4) for name, area in areas.items()})
    return sum(area for name, area in areas.items() if name not in {"inlet", "outlet", "sides"}), str(told)


plate = simple.Plane(Origin=[-0.5, -1, 0], Point1=[0.5, -1, 0], Point2=[-0.5, 1, 0], XResolution=8, YResolution=16)
for angle in 0, 7, 30:
    area, told = meshed(plate, angle)
    assert abs(area - 4) < 0.04, area
    assert "1 open surface is kept as a sheet" in told and "baffle" in told and "area 2" in told, told

CORNERS = [[x, y, z] for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
open_box = producer(polydata(CORNERS, [[0, 2, 3, 1], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]))
area, told = meshed(open_box, 30)
assert abs(area - 6) < 0.03 and "sheet" not in told and "closed by a lid" in told, (area, told)
for angle in 0, 30:  # its walls lie in planes that may divide boxes
    area, told = meshed(open_box, angle, Sheets="Keep")
    assert abs(area - 10) < 0.1 and "1 open surface is kept as a sheet" in told, (area, told)
