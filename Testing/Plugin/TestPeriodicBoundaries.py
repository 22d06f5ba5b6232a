"""Periodic Boundaries: opposite sides of a flow domain's box get the same faces, at four turns and three sizes of boxes, with layers, with
regions, one cell deep, and two cuts through a ring, turned by any angle: points agree, volumes and areas are known, checkMesh accepts the pair, simpleFoam
runs. What does not fit is told."""

import itertools
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import foam
from pipeline import Messages, polydata, producer

temporary = tempfile.TemporaryDirectory()
PROGRAM = sys.argv[2]
numbers = itertools.count()


def volume(mesh):
    quality = simple.FiniteVolumeQuality(Input=mesh)
    quality.UpdatePipeline()
    return vtk_to_numpy(servermanager.Fetch(quality).GetCellData().GetArray("Volume")).sum()


def corners(files, name, i):
    """Of the i-th face of a patch."""
    face = files.patches[name][1] + i
    return files.points[files.faces.corners[files.faces.start[face]:files.faces.start[face + 1]]]


def check(mesh, first="xMin", second="xMax", motion=None, **saved):
    """As OpenFOAM has them; returns the case's files. Without a motion: as wide as the box, which the grid rounds, along the side's axis."""
    folder = f"{temporary.name}/{next(numbers)}"
    foam.save(mesh, folder, **saved)
    checked = foam.CheckMesh(folder)
    assert checked.ok and "Coupled point location match (average" in checked.text, (checked.failures, checked.text[-2000:])
    files = foam.Files(folder)
    files.check()
    assert files.patches[first][0] == files.patches[second][0] == "cyclic", files.patches
    count = files.patches[first][2]
    if not motion:
        width = np.ptp(files.points, axis=0) * [axis == first[0] for axis in "xyz"]
        motion = lambda points: points + width
    assert files.patches[second][2] == count
    for i in range(count):
        own, other = corners(files, first, i), corners(files, second, i)
        shortest = np.linalg.norm(own - np.roll(own, 1, axis=0), axis=1).min()
        far = np.abs(motion(own) - np.roll(other[::-1], 1, axis=0)).max()
        assert far < 1e-6 * shortest, (i, far, shortest)
    return files


def around(bodies, **properties):
    return simple.CartesianMesher(Input=bodies, **{**dict(Domain="Outside", BoxFrom="Bounds", DomainBounds=[0, 2, -1, 1, -1, 1],
                                                          SideNames="Axes", BoxesAlongBody=0), **properties})


def pair(mesh, first="xMin", second="xMax", **properties):
    return simple.PeriodicBoundaries(Input=mesh, FirstBoundary=first, SecondBoundary=second, **properties)


def moved(source, turn=(0, 0, 0), to=(0, 0, 0)):
    result = simple.Transform(Input=source, Transform="Transform")
    result.Transform.Rotate, result.Transform.Translate = turn, to
    return result


# A bar through both sides, and cubes whose halves are on either.
for turn in 0, 45, 30, 17:
    bar = moved(simple.Triangulate(Input=simple.Box(XLength=6, YLength=0.5, ZLength=0.7)), (turn, 0, 0))
    cubes = [moved(simple.Triangulate(Input=simple.Box(XLength=0.6, YLength=0.3, ZLength=0.3)), (turn, 0, 0), (x, 0.65, 0.65)) for x in (0, 2)]
    bodies = simple.GroupDatasets(Input=[bar, *cubes], BlockNames=["bar", "low", "high"])
    for size in 0.4, 0.25, 0.15:
        exact = pair(around(bodies, CellSize=size, PatchMethod="Exact Fit"))
        expected = 8 - 2 * 0.35 - 0.6 * 0.09
        assert math.isclose(volume(exact), expected, rel_tol=1e-8), (turn, size, volume(exact), expected)
        usual = pair(around(bodies, CellSize=size / 2, Layers=3))
        assert math.isclose(volume(usual), expected, rel_tol=2e-3), (turn, size, volume(usual), expected)
        areas = check(usual).areas()
        assert math.isclose(areas["xMin"], 4 - 0.35 - 0.09, rel_tol=2e-3), (turn, size, areas)
        assert math.isclose(areas["xMin"], areas["xMax"], rel_tol=1e-12), areas

# Spheres, half of which are on either side; pairs along two axes; flow.
spheres = simple.AppendGeometry(Input=[simple.Sphere(Center=[x, y, 0], Radius=0.45, ThetaResolution=40, PhiResolution=40)
                                       for x in (0, 2) for y in (-1, 1)])
both = pair(pair(around(spheres, CellSize=0.1)), "yMin", "yMax")
check(both)
files = check(both, "yMin", "yMax")
case = foam.save(both, f"{temporary.name}/flow", SolverSetup="Incompressible", Turbulence="Laminar", Viscosity=0.1, Speed=1, Iterations=40)
assert all(re.search(rf"{side}\s*\{{\s*type\s+cyclic;", (case / "0/U").read_text()) for side in ("xMin", "yMax")), (case / "0/U").read_text()
said = foam.run(case, "simpleFoam")
mean = float(re.findall(r"uncorrected Ubar = (\S+),", said)[-1])
assert abs(mean - 1) < 0.02 and re.search(r"Ubar\s+\(1 0 0\);", (case / "constant/fvOptions").read_text()), said[-2000:]

# A zone that goes through both sides; a mesh one cell deep.
zone = moved(simple.Triangulate(Input=simple.Cylinder(Radius=0.6, Height=6, Resolution=24)), (0, 0, 90))
rod = moved(simple.Triangulate(Input=simple.Box(XLength=6, YLength=0.5, ZLength=0.3)))
named = simple.GroupDatasets(Input=[rod, zone], BlockNames=["rod", "zone"])
zoned = pair(around(named, CellSize=0.15, BoundaryNames=["zone"], BoundaryTypes=["zone"]))
assert "zone" in (pathlib.Path(check(zoned, ZoneRegions=["zone"]).folder) / "cellZones").read_text()
across = moved(simple.Cylinder(Radius=0.4, Height=4, Resolution=40), (90, 0, 0), (1, 0, 0))
flat = pair(simple.FlatMesh(Input=around(across, CellSize=0.1), Thickness=1))
assert len(check(flat).patches) == 7

# Faces of their own, but the same outline.
with Messages() as said:
    ami = pair(around(spheres, CellSize=0.1), Faces="Own")
    folder = foam.save(ami, f"{temporary.name}/ami")
text = (folder / "constant/polyMesh/boundary").read_text()
assert "cyclicAMI" in text and "transform       translational" in text and foam.CheckMesh(folder).ok and not str(said), (text, str(said))
areas = foam.Files(folder).areas()
assert math.isclose(areas["xMin"], areas["xMax"], rel_tol=1e-9), areas

# Other solvers' files.
simple.SaveData(f"{temporary.name}/both.msh", both)
text = pathlib.Path(f"{temporary.name}/both.msh").read_text()
kinds = dict(re.findall(r"\(45 \(\d+ (\S+) (\S+)\)", text))
assert {"periodic", "shadow"} < set(kinds), kinds
for first, count, own, other, rows in re.findall(r"\(18 \((\w+) (\w+) (\w+) (\w+)\)\(([^()]*)\)\)", text):
    assert int(count, 16) == len(rows.split()) // 2 and int(own, 16) + 1 == int(other, 16), (first, count, own, other)
assert len(re.findall(r"\(18 ", text)) == 2
foam.control(f"{temporary.name}/fluent", 1)
assert "FOAM FATAL" not in foam.run(f"{temporary.name}/fluent", "fluent3DMeshToFoam", f"{temporary.name}/both.msh")
with Messages() as said:
    simple.SaveData(f"{temporary.name}/both.cgns", both)
assert 'periodic boundaries "xMin" and "xMax" are ordinary ones' in str(said), str(said)


def ring(angle, parts=24):
    """From a radius of 1 to 2, 1 high, around z: its ends and its walls."""
    profile = np.array([[1, 0, 0], [2, 0, 0], [2, 0, 1], [1, 0, 1]])
    ways = np.radians(np.linspace(0, angle, parts + 1))
    points = np.concatenate([np.stack([profile[:, 0] * np.cos(a), profile[:, 0] * np.sin(a), profile[:, 2]], axis=1) for a in ways])
    last = 4 * parts
    quads = [[4 * i + j, 4 * i + 4 + j, 4 * i + 4 + (j + 1) % 4, 4 * i + (j + 1) % 4] for i in range(parts) for j in range(4)]
    walls = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]
    ends = {"begin": [(0, 1, 2), (0, 2, 3)], "end": [(last, last + 2, last + 1), (last, last + 3, last + 2)], "walls": walls}
    blocks = [producer(polydata(points, triangles)) for triangles in ends.values()]
    return simple.GroupDatasets(Input=blocks, BlockNames=list(ends)), 0.5 * parts * 3 * math.sin(ways[1])


for angle in 90, 40, 30:
    turn = np.radians(angle)
    matrix = np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
    surface, expected = ring(angle)
    exact = pair(simple.CartesianMesher(Input=surface, CellSize=0.2, PatchMethod="Exact Fit"), "begin", "end", Motion="Rotation")
    assert math.isclose(volume(exact), expected, rel_tol=1e-7), (angle, volume(exact), expected)
    usual = pair(simple.CartesianMesher(Input=surface, CellSize=0.1), "begin", "end", Motion="Rotation")
    areas = check(usual, "begin", "end", lambda points: points @ matrix.T).areas()
    assert math.isclose(areas["begin"], 1, rel_tol=1e-6) and math.isclose(areas["end"], 1, rel_tol=1e-6), areas

# By a task file: one cell deep, and periodic; a boundary that is not there.
root = pathlib.Path(temporary.name)
simple.SaveData(str(root / "rods.stl"), proxy=simple.AppendGeometry(Input=[moved(simple.Cylinder(Radius=0.4, Height=4, Resolution=40), (90, 0, 0), (x, 0, 0))
                                                                           for x in (0, 2)]))
TASK = """
[surface]
file = "rods.stl"
[grid]
cell_size = 0.1
[domain]
domain = "Outside"
side_names = "Axes"
box_from = "Bounds"
domain_bounds = [0.0, 2.0, -1.0, 1.0, -0.1, 0.1]
boxes_along_body = 0
[refinement]
periodic_sides = "X"
[flat]
thickness = 1.0
[[periodic]]
first_boundary = "xMin"
second_boundary = "{}"
[case]
solver_setup = "Incompressible"
turbulence = "Laminar"
speed = 1.0
viscosity = 0.1
iterations = 10
[output]
mesh = ["task/case.foam", "task.vtu"]
"""
for second, code in ("xMax", 0), ("left", 2):
    (root / "task.toml").write_text(TASK.format(second))
    done = subprocess.run([PROGRAM, "--quiet", str(root / "task.toml")], capture_output=True, text=True)
    assert done.returncode == code and ('There is no boundary "left"' in done.stderr) == (code == 2), (done.returncode, done.stdout, done.stderr)
assert (root / "task.vtu").exists()
checked = foam.CheckMesh(root / "task")
assert checked.ok and "2 solution (non-empty) directions" in checked.text, checked.text[-2000:]
assert "meanVelocityForce" in (root / "task/constant/fvOptions").read_text()
foam.run(root / "task", "simpleFoam")
(root / "task.toml").write_text(TASK.format("xMax") + "pieces = 2\n")
done = subprocess.run([PROGRAM, str(root / "task.toml")], capture_output=True, text=True)
assert done.returncode == 2 and "written in one piece" in done.stderr, (done.returncode, done.stderr)

# What does not fit is told.
box = around(spheres, CellSize=0.2)
for mesh, properties, words in ((box, dict(FirstBoundary="left", SecondBoundary="xMax"), 'There is no boundary "left"'),
                                (box, dict(FirstBoundary="xMax", SecondBoundary="xMax"), "two different boundaries"),
                                (box, dict(FirstBoundary="xMin", SecondBoundary="boundary_0"), "differ"),
                                (box, dict(FirstBoundary="boundary_0", SecondBoundary="xMin"), "the first is not flat"),
                                (box, dict(FirstBoundary="xMin", SecondBoundary="xMax", Motion="Rotation", Axis=[0, 0, 0]), "Axis is 0"),
                                (around(spheres, CellSize=0.2, DomainBounds=[-0.2, 2, -1, 1, -1, 1]),
                                 dict(FirstBoundary="xMin", SecondBoundary="xMax"), "differ by an area of")):
    with Messages() as said:
        simple.PeriodicBoundaries(Input=mesh, **properties).UpdatePipeline()
    assert words in str(said), (properties, str(said))
with Messages() as said:
    simple.SaveData(f"{temporary.name}/pieces/case.foam", both, Pieces=2)
assert "decomposePar" in str(said), str(said)
