"""Length Unit: a body in metres and in millimetres, by property or by the surface's field data, gets the same layers and the same
case; the panel says how long it is, and how thick and many the layers will be, also with Cell Size 0 and with depths."""

import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray

import foam
from pipeline import error_code, output, producer

PROGRAM = sys.argv[2]
FLOW = dict(Layers=-1, TargetYPlus=1, FlowSpeed=20, FlowViscosity=1e-5, NumberOfThreads=1)


def body(metres, says=False):
    """A box of 0.4 by 0.2 by 0.2 m, in units of so many metres."""
    surface = output(simple.Triangulate(Input=simple.Box(XLength=0.4 / metres, YLength=0.2 / metres, ZLength=0.2 / metres)))
    if says:
        field = vtkDoubleArray()
        field.SetName("MetresPerUnit")
        field.InsertNextValue(metres)
        surface.GetFieldData().AddArray(field)
    return producer(surface)


def shown(mesher, name):
    property = mesher.SMProxy.GetProperty(name)
    mesher.Input.UpdatePipeline()
    mesher.UpdateVTKObjects()
    mesher.SMProxy.UpdatePropertyInformation(property)
    return [property.GetElement(i) for i in range(property.GetNumberOfElements())]


def field(mesher, name):
    array = output(mesher).GetFieldData().GetArray(name)
    return array.GetValue(0) if array else None


metre = simple.CartesianMesher(Input=body(1), CellSize=0.04, **FLOW)
said = simple.CartesianMesher(Input=body(1e-3, True), CellSize=40, **FLOW)
told = simple.CartesianMesher(Input=body(1e-3), CellSize=40, LengthUnit="Millimetre", **FLOW)
inch = simple.CartesianMesher(Input=body(0.0254), CellSize=0.04 / 0.0254, LengthUnit="Inch", **FLOW)
silent = simple.CartesianMesher(Input=body(1e-3), CellSize=40, **FLOW)
assert field(metre, "MetresPerUnit") is None and field(silent, "MetresPerUnit") is None
assert field(metre, "LayersOfAStack") > 10
for mesher, unit in (said, 1e-3), (told, 1e-3), (inch, 0.0254):
    assert field(mesher, "MetresPerUnit") == unit
    assert field(mesher, "LayersOfAStack") == field(metre, "LayersOfAStack")
    for name, power in ("MeanLayerThickness", 1), ("FlowSpeed", 1), ("FlowViscosity", 2):
        assert np.isclose(field(mesher, name) * unit ** power, field(metre, name), rtol=1e-6), name
# As before there were units: 20 mm/s.
assert field(silent, "LayersOfAStack") != field(metre, "LayersOfAStack") and field(silent, "FlowSpeed") == 20

# What the panel shows, before anything is applied.
assert shown(metre, "SurfaceSize") == ["0.4 \N{MULTIPLICATION SIGN} 0.2 \N{MULTIPLICATION SIGN} 0.2: 0.4 m long"], shown(metre, "SurfaceSize")
assert shown(said, "SurfaceSize")[0].endswith(": 0.4 m long")
for length, asks in (0.011, False), (0.009, True), (999, False), (1001, True):
    long = simple.CartesianMesher(Input=simple.Triangulate(Input=simple.Box(XLength=length, YLength=length / 2, ZLength=length / 2)))
    assert shown(long, "SurfaceSize")[0].endswith(f"{length} m long" + (". Is Length Unit right?" if asks else "")), length
for mesher, unit in (metre, 1), (told, 1e-3):
    first, number, together = shown(mesher, "ExpectedLayers")[3:]
    assert int(number) == field(mesher, "LayersOfAStack"), number
    value, millimetres = (float(word.strip("(")) for word in first.split()[:2])
    assert np.isclose(millimetres, 1000 * unit * value, rtol=1e-3) and first.endswith(" mm)"), first
    made = vtk_to_numpy(output(mesher, 1).GetCellData().GetArray("LayerThickness")).max()
    assert np.isclose(float(together.split()[0]), made, rtol=0.01), (together, made)
# The size of boxes is what the mesher takes, whoever chooses it.
for options in {}, {"CellSize": 0.05, "RefinementDepth": 1}, {"CellSize": 0.1, "BoundaryNames": ["boundary_0"], "BoundaryDepths": [2]}, \
        {"Domain": "Outside", "RefinementDepth": 1}, {"MeshlinesX": list(np.linspace(-0.2, 0.2, 11)), "MeshlinesY": list(np.linspace(-0.1, 0.1, 6)),
            "MeshlinesZ": list(np.linspace(-0.1, 0.1, 6))}:
    mesher = simple.CartesianMesher(Input=body(1), **FLOW | options)
    assert int(shown(mesher, "ExpectedLayers")[4]) == field(mesher, "LayersOfAStack"), options

with tempfile.TemporaryDirectory() as folder:
    root = pathlib.Path(folder)
    # The writer's Scale follows; given, it counts.
    for name, mesher, scale, length in ("metre", metre, 0, 0.4), ("said", said, 0, 0.4), ("inch", inch, 0, 0.4), ("given", said, 1, 400):
        (root / name).mkdir()
        points = foam.Files(foam.save(mesher, root / name, Scale=scale)).points
        assert np.isclose(np.ptp(points[:, 0]), length, rtol=1e-5), (name, np.ptp(points[:, 0]))
    # A task that has a target y+ and no unit is from before; one saved by the window says the unit.
    simple.SaveData(str(root / "body.vtp"), said.Input)
    layers = '[grid]\ncell_size = 40\n[layers]\nlayers = -1\ntarget_y_plus = 1\nflow_speed = 20\nflow_viscosity = 1e-5\n[output]\nmesh = "mesh.vtu"\n'
    for unit, same in ("", silent), ('length_unit = "From Input"\n', said), ('length_unit = "millimetre"\n', said):
        (root / "task.toml").write_text('[surface]\nfile = "body.vtp"\n' + unit + layers)
        subprocess.run([PROGRAM, str(root / "task.toml")], check=False, capture_output=True)
        mesh = output(simple.OpenDataFile(str(root / "mesh.vtu")))
        assert mesh.GetFieldData().GetArray("LayersOfAStack").GetValue(0) == field(same, "LayersOfAStack"), unit
        (root / "mesh.vtu").unlink()
    opened = simple.CartesianMesher(Input=simple.OpenDataFile(str(root / "body.vtp")), CellSize=40, **FLOW)
    simple.SaveData(str(root / "saved.toml"), opened)
    assert 'length_unit = "From Input"' in (root / "saved.toml").read_text(), (root / "saved.toml").read_text()
assert all(error_code(mesher) == 0 for mesher in (metre, said, told, inch, silent))
