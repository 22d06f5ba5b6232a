"""Slice Polyhedra with the plane's buttons, and a clip of divided polyhedra: areas and volumes of a box, without a warning; and a
hint, once, at a slice of cells as they are."""

import re

from paraview import simple

from events import PROPERTIES, apply, event, macro, meshing_menu, open_file, script
from window import Screen

# VTK's sizes of concave polygons are too large: only those of triangles are exact.
TOLD = """
from paraview import servermanager, simple
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
data = servermanager.Fetch(simple.GetActiveSource())
if data.IsA("vtkPolyData"):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(data)
    triangles.Update()
    data = triangles.GetOutput()
size = vtkCellSizeFilter()
size.SetInputData(data)
size.Update()
print("told", *(sum(size.GetOutput().GetCellData().GetArray(name).GetValue(i) for i in range(data.GetNumberOfCells()))
    for name in ("Area", "Volume")))
"""
CLIP = """
from paraview import simple
simple.SetActiveSource(simple.OutputPort(simple.FindSource("CartesianMesher1"), 0))
"""
SLANTED = """
from paraview import simple
clip = simple.Clip(Input=simple.FindSource("DividePolyhedra1"), ClipType="Plane")
clip.ClipType.Origin, clip.ClipType.Normal = [0, 0, 0], [1, 2, 3]
simple.SetActiveSource(clip)
"""
PLAIN = """
from paraview import simple
for mesh in simple.FindSource("DividePolyhedra1"), simple.OutputPort(simple.FindSource("CartesianMesher1"), 0):
    for filter in simple.Clip, simple.Slice:
        filter(Input=mesh).UpdatePipeline()
"""

with Screen() as screen:
    body = screen.folder / "box.stl"
    # Turned, so that boxes are cut.
    turned = simple.Transform(Input=simple.Triangulate(Input=simple.Box(XLength=2)))
    turned.Transform.Rotate = [0, 0, 30]
    simple.SaveData(str(body), proxy=turned)
    for name, text in ("told", TOLD), ("mesh", CLIP), ("slanted", SLANTED), ("plain", PLAIN):
        screen.add_macro(name, text)
    said = screen.play(script(open_file(body), apply(), meshing_menu("CartesianMesher"), apply(),
        meshing_menu("SlicePolyhedra"), event(f"{PROPERTIES}/InteractivePlane/useZNormal", "activate"), apply(), macro("told"),
        macro("mesh"), meshing_menu("DividePolyhedra"), apply(), macro("slanted"), macro("told"), macro("plain")))
    # VTK may warn of polyhedra that it cannot cut, which the hint is for.
    own = [line for line in said.splitlines() if "WARN|" in line and "vtkPolyhedron" not in line and "vtkTableBasedClipDataSet" not in line]
    assert "ERR|" not in said and not own, said
    areas, volumes = zip(*(map(float, match) for match in re.findall(r"told (\S+) (\S+)", said)))
    # Half of the volume is on each side of a plane through the centre.
    assert abs(areas[0] - 2) < 1e-4 and abs(volumes[1] - 1) < 1e-4, (areas, volumes)
    assert re.findall(r"(\w+) \(\w+\): .*Divide Polyhedra", said) == ["Clip3"], said
