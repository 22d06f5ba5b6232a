"""Boundaries of type zone: a rotor whose blade and shaft pass through its border, at four turns and three sizes of boxes: volumes and
areas are known, cells fit; checkMesh accepts faceZones and cyclicAMI patches. Zones without bodies, and two of them; what does not fit is told."""

import math
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import foam
from pipeline import Messages, output

temporary = tempfile.TemporaryDirectory()
CORNERS, RADIUS = 24, 0.8  # of the rotor, which is 1 long
DISC = CORNERS / 2 * math.sin(2 * math.pi / CORNERS) * RADIUS ** 2
SIDES = CORNERS * 2 * RADIUS * math.sin(math.pi / CORNERS)
ROTOR = DISC - 0.08 - 0.2 ** 2 * 0.6  # without blade and shaft
BORDER = 2 * (DISC - 0.2 ** 2) + SIDES
BODIES = 0.08 + 0.2 ** 2 * (2 - 0.4)


def box(x, y, z):
    return simple.Triangulate(Input=simple.Box(XLength=x, YLength=y, ZLength=z))


def turned(source, angles):
    result = simple.Transform(Input=source, Transform="Transform")
    result.Transform.Rotate = angles
    return result


def rotor():
    return turned(simple.Triangulate(Input=simple.Cylinder(Radius=RADIUS, Height=1, Resolution=CORNERS)), [90, 0, 0])


def mesher(parts, turn=(0, 0, 0), **properties):
    blocks = simple.GroupDatasets(Input=[turned(part, turn) for part in parts.values()], BlockNames=list(parts))
    zones = [name for name in parts if name.startswith("zone")]
    return simple.CartesianMesher(Input=blocks, **{**dict(Domain="Outside", BoxFrom="Bounds", DomainBounds=[-2, 2] * 3, BoxesAlongBody=0,
        BoundaryNames=zones, BoundaryTypes=["zone"] * len(zones)), **properties})


def volumes(mesh):
    """Of each region."""
    quality = simple.FiniteVolumeQuality(Input=mesh)
    quality.UpdatePipeline()
    data = servermanager.Fetch(quality).GetCellData()
    return np.bincount(vtk_to_numpy(data.GetArray("Region")), vtk_to_numpy(data.GetArray("Volume")))[1:]


def border_area(mesh):
    faces = servermanager.Fetch(mesh, idx=3)
    points = vtk_to_numpy(faces.GetPoints().GetData())
    total = 0
    for i in range(faces.GetNumberOfCells()):
        ids = faces.GetCell(i).GetPointIds()
        corners = points[[ids.GetId(k) for k in range(ids.GetNumberOfIds())]]
        corners = corners - corners[0]
        total += np.linalg.norm(np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)) / 2
    return total


PARTS = {"blade": box(1, 0.2, 0.4), "shaft": box(0.2, 0.2, 2), "zone_rotor": rotor()}
for number, turn in enumerate(((0, 0, 0), (0, 0, 45), (30, 0, 0), (17, 29, 41))):
    for size in 0.4, 0.25, 0.15:
        with Messages():
            exact = mesher(PARTS, turn, CellSize=size, PatchMethod="Exact Fit")
            assert np.allclose(volumes(exact), [64 - BODIES - ROTOR, ROTOR], rtol=1e-7), (turn, size, volumes(exact))
            assert math.isclose(border_area(exact), BORDER, rel_tol=1e-6), (turn, size, border_area(exact), BORDER)
    with Messages() as said:
        usual = mesher(PARTS, turn, CellSize=0.1, Layers=3)
        usual.UpdatePipeline()
    assert "less than the surface encloses" not in str(said), str(said)
    assert np.allclose(volumes(usual), [64 - BODIES - ROTOR, ROTOR], rtol=3e-4), (turn, volumes(usual))
    assert math.isclose(border_area(usual), BORDER, rel_tol=3e-3), (turn, border_area(usual), BORDER)
    for borders in "Face Zones", "Cyclic AMI":
        folder = f"{temporary.name}/{number}-{borders[0]}"
        foam.save(simple.OutputPort(usual, "Mesh"), folder, ZoneRegions=["zone_rotor"], ZoneBorders=borders)
        check = foam.CheckMesh(folder)
        assert check.ok, (turn, borders, check.failures)
patches = foam.Files(folder).patches
assert patches["fluid_to_zone_rotor"][0] == patches["zone_rotor_to_fluid"][0] == "cyclicAMI", patches
assert {"blade", "shaft", "inlet", "outlet", "sides"} < set(patches), patches

# Zones alone, and two.
alone = mesher({"zone_rotor": rotor()}, CellSize=0.3, PatchMethod="Exact Fit")
assert np.allclose(volumes(alone), [64 - DISC, DISC], rtol=1e-7), volumes(alone)
far = simple.Transform(Input=box(0.5, 0.5, 0.5), Transform="Transform")
far.Transform.Translate = [1.3, 1.3, 1.3]
two = mesher({"zone_box": far, "blade": box(1, 0.2, 0.4), "zone_rotor": rotor()}, CellSize=0.3, PatchMethod="Exact Fit")
names = output(two).GetFieldData().GetAbstractArray("RegionNames")
assert [names.GetValue(i) for i in range(3)] == ["fluid", "zone_box", "zone_rotor"]
assert np.allclose(volumes(two), [64 - DISC - 0.125, 0.125, DISC - 0.08], rtol=1e-7), volumes(two)

# What does not fit is told.
for properties in dict(Domain="Inside"), dict(KeepPoints=[1.5, 1.5, 1.5]), dict(CloseGaps=0.1):
    with Messages() as said:
        mesher(PARTS, CellSize=0.4, **properties).UpdatePipeline()
    assert "Boundaries of type zone need the Domain Outside" in str(said), (properties, str(said))
