"""Flat Mesh: plane meshes and wedges around prisms and bodies of revolution, whose volumes and areas are known, at four turns
and three sizes of boxes, inside and outside, with layers and regions; checkMesh accepts them, in two directions. What is wrong is told."""

import math
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import foam
from pipeline import Messages, polydata, producer

temporary = tempfile.TemporaryDirectory()


def volumes(source):
    quality = simple.FiniteVolumeQuality(Input=source)
    quality.UpdatePipeline()
    data = servermanager.Fetch(quality).GetCellData()
    return vtk_to_numpy(data.GetArray("Volume")), data.GetArray("Region") and vtk_to_numpy(data.GetArray("Region"))


def check(source, name, directions="Mesh has 2 solution (non-empty) directions (1 1 0)"):
    folder = f"{temporary.name}/{name}"
    foam.save(source, folder)
    checked = foam.CheckMesh(folder)
    assert checked.ok and directions in checked.text, (name, checked.failures, checked.text[-1500:])


def boundaries(source):
    data = servermanager.Fetch(source).GetFieldData()
    names, types = data.GetAbstractArray("BoundaryNames"), data.GetAbstractArray("BoundaryTypes")
    return {names.GetValue(i): types.GetValue(i) for i in range(names.GetNumberOfValues())}


def prism(turn):
    """A square of 1 x 1, longer than the box."""
    body = simple.Transform(Input=simple.Triangulate(Input=simple.Box(XLength=1, YLength=1, ZLength=4)), Transform="Transform")
    body.Transform.Rotate = [0, 0, turn]
    return body


for turn in 0, 45, 30, 17:
    for size in 0.4, 0.25, 0.15:
        around = dict(Domain="Outside", BoxFrom="Bounds", DomainBounds=[-3, 4, -2, 3, 0, 0.1], CellSize=size, BoxesAlongBody=8,
                      SideNames="Axes")
        exact = simple.FlatMesh(Input=simple.CartesianMesher(Input=prism(turn), PatchMethod="Exact Fit", **around), Thickness=2)
        assert math.isclose(volumes(exact)[0].sum(), 2 * (7 * 5 - 1), rel_tol=1e-8), (turn, size, volumes(exact)[0].sum())
        usual = simple.FlatMesh(Input=simple.CartesianMesher(Input=prism(turn), Layers=3, **around), Thickness=2)
        assert math.isclose(volumes(usual)[0].sum(), 2 * (7 * 5 - 1), rel_tol=1e-3), (turn, size, volumes(usual)[0].sum())
        check(usual, f"prism-{turn}-{size}")
assert boundaries(usual) == {"boundary_0": "", "xMin": "patch", "xMax": "patch", "yMin": "patch", "yMax": "patch",
                             "front": "empty", "back": "empty"}, boundaries(usual)

# Around an axis: a cylinder of radius .5, and a sphere.
cylinder = simple.Transform(Input=simple.Cylinder(Radius=0.5, Height=1, Resolution=8, Capping=1), Transform="Transform")
cylinder.Transform.Rotate = [0, 0, 90]
for angle in 1, 5, 60:
    for size in 0.3, 0.2, 0.11:
        around = dict(Domain="Outside", BoxFrom="Bounds", DomainBounds=[-2, 3, 0, 2, 0, 0.1], CellSize=size, BoxesAlongBody=8,
                      SideNames="Axes")
        wedge = simple.FlatMesh(Input=simple.CartesianMesher(Input=cylinder, PatchMethod="Exact Fit", **around), Shape="Wedge", WedgeAngle=angle)
        expected = math.sin(math.radians(angle)) * (5 * 2 ** 2 - 1 * 0.5 ** 2) / 2
        assert math.isclose(volumes(wedge)[0].sum(), expected, rel_tol=1e-6), (angle, size, volumes(wedge)[0].sum(), expected)
        assert "yMin" not in boundaries(wedge) and boundaries(wedge)["front"] == boundaries(wedge)["back"] == "wedge", boundaries(wedge)
        if angle == 5:
            check(wedge, f"wedge-{size}", "Mesh has 2 geometric (non-empty/wedge) directions (1 1 0)")

# Inside an outline: a channel with a bend.
corners = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 2], [0, 2]]
walls = producer(polydata([[x, y, z] for z in (-1, 1) for x, y in corners],
                          [[i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i] for i in range(6)]))
for size in 0.2, 0.11, 0.07:
    inside = simple.CartesianMesher(Input=walls, Domain="Outside", KeepPoints=[0.5, 0.5, 0], BoxFrom="Bounds",
                                    DomainBounds=[-0.1, 3.1, -0.1, 2.1, -0.05, 0.05], CellSize=size)
    flat = simple.FlatMesh(Input=inside, Thickness=1)
    with Messages():
        assert math.isclose(volumes(flat)[0].sum(), 4, rel_tol=1e-5), (size, volumes(flat)[0].sum())
    check(flat, f"inside-{size}")

# Regions: a solid in a fluid.
blocks = [simple.Triangulate(Input=simple.Box(XLength=length, YLength=length, ZLength=0.1)) for length in (0.6, 2)]
regions = simple.CartesianMesher(Input=simple.GroupDatasets(Input=blocks, BlockNames=["solid", "fluid"]), RegionsFrom="Blocks",
                                 CellSize=0.13, PatchMethod="Exact Fit")
flat = simple.FlatMesh(Input=regions, Thickness=1)
volume, region = volumes(flat)
assert np.allclose(np.bincount(region, volume)[1:], [0.36, 4 - 0.36], rtol=1e-7), np.bincount(region, volume)

# What is wrong is told.
for properties, words in ((dict(Shape="Wedge"), "both sides of the axis"),
                          (dict(Shape="Wedge", Axis="Z", AxisOrigin=[0, -9, 0]), "choose another one than Across"),
                          (dict(Shape="Wedge", WedgeAngle=0, AxisOrigin=[0, -9, 0]), "Wedge Angle is 0")):
    with Messages() as said:
        simple.FlatMesh(Input=usual.Input, **properties).UpdatePipeline()
    assert words in str(said), (properties, str(said))
