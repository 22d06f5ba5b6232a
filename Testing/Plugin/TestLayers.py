"""Boundary layers: of the thickness asked, on walls only, and a mesh that checkMesh finds OK; none: as before."""

import tempfile

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.util.numpy_support import vtk_to_numpy

import foam
import slab

SIZE = 0.1
COUNT = 5
FIRST = SIZE / 20


def array(data, name):
    return vtk_to_numpy(data.GetArray(name))


def outputs(mesher):
    mesher.UpdatePipeline()
    filter = mesher.GetClientSideObject()
    assert filter.GetErrorCode() == 0, filter.GetErrorCode()
    return filter.GetOutputDataObject(0), filter.GetOutputDataObject(1)


def statistic(mesh, name):
    return float(array(mesh.GetFieldData(), name)[0])


class Warnings(list):
    """Collects the texts of warnings from entering to leaving."""

    def __enter__(self):
        self.output = vtkOutputWindow.GetInstance()
        self.collector = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.collector)
        return self

    def __exit__(self, *_):
        vtkOutputWindow.SetInstance(self.output)
        self += self.collector.GetOutput().split("Warning: ")[1:]


def expect_layers(mesher, walls):
    """All layers on all of the walls, by their boundary numbers, and nowhere else."""
    mesh, boundary = outputs(mesher)
    layer = array(mesh.GetCellData(), "Layer")
    made = array(boundary.GetCellData(), "LayersMade")
    on_wall = np.isin(array(boundary.GetCellData(), "BoundaryId"), walls)
    assert (made[on_wall] == COUNT).all()
    assert (made[~on_wall] == 0).all()
    assert [int((layer == k).sum()) for k in range(1, COUNT + 1)] == COUNT * [int(on_wall.sum())]
    asked = FIRST * sum(1.2 ** k for k in range(COUNT))
    thickness = array(boundary.GetCellData(), "LayerThickness")
    assert (abs(thickness[on_wall] / asked - 1) < 0.05).all(), thickness[on_wall]
    assert statistic(mesh, "LayerCoverage") == 1
    assert statistic(mesh, "Cells") == mesh.GetNumberOfCells()
    assert statistic(mesh, "Points") == mesh.GetNumberOfPoints()
    found = foam.CheckMesh(foam.save(mesher, tempfile.mkdtemp()))
    assert found.ok, found.failures


sphere = simple.Sphere(Radius=1, ThetaResolution=48, PhiResolution=24)
layers = {"Layers": COUNT, "FirstLayerThickness": FIRST}
expect_layers(simple.CartesianMesher(Input=sphere, CellSize=SIZE, **layers), [0])

# On a body in a flow domain, but not on the sides of the domain.
expect_layers(simple.CartesianMesher(Input=sphere, CellSize=SIZE, Domain="Outside", LengthsBefore=0.15,
    LengthsBehind=0.15, LengthsBeside=0.15, BoxesAlongBody=0, **layers), [0])

# Boundaries have layers of their own thickness, whatever their type.
thicknesses = {"inlet cold": 0.01, "hot": -1, "side": 0.03}
mesh, boundary = outputs(simple.CartesianMesher(Input=slab.box([0, 0, 0], [3, 1, 1]), BoundaryArray="Wall", CellSize=SIZE,
    Layers=2, LayersThickness=0.02, BoundaryNames=list(thicknesses), BoundaryLayersThickness=list(thicknesses.values())))
names = mesh.GetFieldData().GetAbstractArray("BoundaryNames")
names = dict(zip((names.GetValue(i) for i in range(names.GetNumberOfValues())), array(mesh.GetFieldData(), "BoundaryIds")))
for name, asked in thicknesses.items():
    on = array(boundary.GetCellData(), "BoundaryId") == names[name]
    thickness = np.median(array(boundary.GetCellData(), "LayerThickness")[on])
    assert abs(thickness - (asked if asked > 0 else 0.02)) < 1e-9, (name, thickness)

# A first layer of any thickness is none if there are none.
plain = outputs(simple.CartesianMesher(Input=sphere, CellSize=SIZE))[0]
without = outputs(simple.CartesianMesher(Input=sphere, CellSize=SIZE, FirstLayerThickness=FIRST))[0]
assert not plain.GetCellData().HasArray("Layer")
assert (vtk_to_numpy(plain.GetPoints().GetData()) == vtk_to_numpy(without.GetPoints().GetData())).all()

# Those of a body in a flow domain are as thick as its small boxes allow, whatever the size of those far away.
cube = simple.Transform(Input=simple.Box())
cube.Transform.Rotate = [20, 20, 0]
body = dict(Input=cube, CellSize=0.2, Domain="Outside", LengthsBefore=0.5, LengthsBehind=0.5, LengthsBeside=0.5,
    RefinementDepth=3, Layers=3)
with Warnings() as warnings:
    mesh, boundary = outputs(simple.CartesianMesher(**body))
assert statistic(mesh, "LayerCoverage") > 0.9, statistic(mesh, "LayerCoverage")
assert 0.25 < statistic(mesh, "MeanLayerThickness") / (0.2 / 8) < 0.34, statistic(mesh, "MeanLayerThickness")
assert not [text for text in warnings if "half the requested thickness" in text], warnings

# Where they are not, a warning names the boundaries and what they have.
with Warnings() as warnings:
    mesh, boundary = outputs(simple.CartesianMesher(**body, LayersThickness=0.2 / 3))
assert statistic(mesh, "LayerCoverage") < 0.5
told = [text for text in warnings if "half the requested thickness" in text]
assert len(told) == 1, warnings
named = mesh.GetFieldData().GetAbstractArray("BoundaryNames").GetValue(0)
coverage = array(mesh.GetFieldData(), "BoundaryLayerCoverages")[0]
assert f"{named} ({np.floor(100 * coverage) / 100:.2f})" in told[0], told
