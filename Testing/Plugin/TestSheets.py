"""Sheets: a plate whose triangles are there twice, with a boundary for each side, stands on a body and ends in the flow around
it; each side becomes a patch. Left out, a message names both."""

import tempfile

from paraview import simple
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkFiltersCore import vtkAppendPolyData

import foam
from pipeline import Messages, output, producer

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
