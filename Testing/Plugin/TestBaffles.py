"""Baffles: an open sheet across a duct becomes two patches with the same faces, through which nothing passes; one that ends
inside has faces of its own on each side."""

import tempfile

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

import foam
from pipeline import output, producer

temporary = tempfile.TemporaryDirectory()


def duct(lean=0.3, top=1.0):
    """3 x 1 x 1, with a sheet across it: boundaries inlet, outlet, side and plate."""
    box = output(simple.Triangulate(Input=simple.Box(XLength=3, YLength=1, ZLength=1, Center=[1.5, 0.5, 0.5])))
    plate = output(simple.Triangulate(Input=simple.Plane(
        Origin=[1.3, 0, 0], Point1=[1.3 + lean, 1, 0], Point2=[1.3, 0, top], XResolution=3, YResolution=2)))
    both = vtkAppendPolyData()
    both.AddInputData(box)
    both.AddInputData(plate)
    both.Update()
    surface = both.GetOutput()
    names = vtkStringArray()
    names.SetName("Wall")
    for i in range(surface.GetNumberOfCells()):
        first, last = surface.GetCell(i).GetBounds()[:2]
        names.InsertNextValue("plate" if i >= box.GetNumberOfCells() else
                              "inlet" if last == 0 else "outlet" if first == 3 else "side")
    surface.GetCellData().AddArray(names)
    return producer(surface)


def turned(surface, degrees):
    turn = vtkTransform()
    for axis, angle in zip((turn.RotateX, turn.RotateY, turn.RotateZ), degrees):
        axis(angle)
    moved = vtkTransformPolyDataFilter()
    moved.SetTransform(turn)
    moved.SetInputData(output(surface))
    moved.Update()
    return producer(moved.GetOutput())


def mesher(surface, **properties):
    return simple.CartesianMesher(Input=surface, BoundaryArray="Wall", BoundaryNames=["plate"], BoundaryTypes=["baffle"],
                                  **{"CellSize": 0.13, **properties})


AREA = np.hypot(1, 0.3)
made = mesher(duct())
folder = foam.save(simple.OutputPort(made, "Mesh"), f"{temporary.name}/duct")
files = foam.Files(folder)
files.check()
verdict = foam.CheckMesh(folder)
assert verdict.ok, verdict.failures
assert set(files.patches) == {"side", "inlet", "outlet", "plate", "plate_back"}, list(files.patches)
for name in "plate", "plate_back":
    assert files.patches[name][0] == "wall"
    assert abs(files.areas()[name] - AREA) < 1e-4, files.areas()
assert abs(files.volumes().sum() - 3) < 1e-4
centres, vectors = files.face_centres()
sides = [sorted(map(tuple, np.round(centres[files.of_patch(name)], 12))) for name in ("plate", "plate_back")]
assert sides[0] == sides[1]

# The mesh itself: one region, the sheet's faces on the boundary twice, nothing between regions.
mesh, boundary, interfaces = (output(made, port) for port in (0, 1, 3))
assert mesh.GetCellData().GetArray("Region").GetRange() == (1, 1)
owners, ids = (boundary.GetCellData().GetArray(name) for name in ("OwnerCell", "BoundaryId"))
assert boundary.GetNumberOfCells() == len(files.faces.start) - 1 - len(files.neighbour)
assert interfaces.GetNumberOfCells() == 0

# Heat does not pass: each side takes the temperature of its end.
foam.write_field(folder, "T", "[0 0 0 1 0 0 0]", "0.5", {
    "inlet": "fixedValue; value uniform 0;", "outlet": "fixedValue; value uniform 1;", '".*"': "zeroGradient;"})
foam.write(folder, "constant/transportProperties", "DT [0 2 -1 0 0 0 0] 1;")
foam.write(folder, "system/fvSolution", "solvers { T { solver PCG; preconditioner DIC; tolerance 1e-14; relTol 0; } }\n"
           "SIMPLE { nNonOrthogonalCorrectors 8; }")
foam.control(folder, 1)
foam.run(folder, "laplacianFoam")
values, places = foam.read_field(folder, 1, "T"), files.centres()
behind = places[:, 0] > 1.3 + 0.3 * places[:, 1]
assert behind.any() and not behind.all()
assert np.abs(values - behind).max() < 1e-6, np.abs(values - behind).max()

# In pieces, too.
case = foam.save(simple.OutputPort(made, "Mesh"), f"{temporary.name}/pieces", Pieces=3)
for name in "plate", "plate_back":
    area = sum(foam.Files(case / f"processor{n}").areas().get(name, 0) for n in range(3))
    assert abs(area - AREA) < 1e-4, (name, area)
text = foam.run_parallel(case, 3, "checkMesh")
assert "\nMesh OK." in text, text

# One that ends inside, and one with layers: two sides, each with faces of its own.
for share, surface, properties in (0.5, duct(top=0.5), {}), (1, duct(), {"Layers": 2}):
    thin = mesher(surface, **properties)
    case = foam.Files(foam.save(simple.OutputPort(thin, "Mesh"), f"{temporary.name}/thin{share}"))
    case.check()
    assert abs(case.volumes().sum() - 3) < 1e-3
    for name in "plate", "plate_back":
        assert abs(case.areas()[name] / (share * AREA) - 1) < 0.03, (name, case.areas())

# Turned, its cells at the walls are hard to make: none has fewer than four faces.
for turn in (0, 0, 45), (35.26, 0, 45), (54.7356, 0, 45), (17, 17, 17):
    for size in 0.13, 0.1, 0.08:
        few = output(mesher(turned(duct(0.1), turn), CellSize=size)).GetFieldData().GetArray("CellsOfFewFaces")
        assert few.GetTuple1(0) == 0, (turn, size)
print(files.cells, "cells")
