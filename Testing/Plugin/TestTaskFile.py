"""Cartesian Mesher's settings saved as a task file: cartesian-mesher reads every property back from it, makes the same mesh, bit
for bit, and what a task cannot say is refused with the reason."""

import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

from paraview import servermanager, simple

from pipeline import DATA, Messages, assert_identical, output

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Plugin" / "Task"))
from parameters import LEAST_INT, collections, parameters  # noqa: E402
from task import MESHER, read_task  # noqa: E402

PROGRAM = sys.argv[2]
HEADER, CUBE = (DATA / name for name in ("kcl_exhaust_header_lumens.stl", "tm_7_8ths_cube.stl"))
folder = pathlib.Path(tempfile.mkdtemp())
(folder / "below").mkdir()


def opened(file):
    reader = simple.OpenDataFile(str(file))
    reader.UpdatePipeline()
    return reader


def saved(name, mesher, port=0):
    with Messages() as said:
        writer = servermanager.writers.CartesianMesherTaskWriter(Input=simple.OutputPort(mesher, port), FileName=str(folder / name))
        writer.UpdatePipeline()
    assert "ERR|" not in str(said), str(said)
    return folder / name


# Every property, each with a value that is not its default.
def other(parameter, i=0):
    if parameter.choices:
        return parameter.choices[(parameter.choices.index(parameter.default) + 1 + i) % len(parameter.choices)]
    if parameter.kind is str:
        return f'{i} "\\\t# é'
    if parameter.kind is bool:
        return not parameter.default
    least, most = parameter.limits()
    start = least if math.isfinite(least) and least > LEAST_INT else 0
    value = min(most, start + 2 + i) if parameter.kind is int else min(most, start + (1 + i) / 3)
    return least if value == parameter.default else value


def others(parameter):
    count = parameter.count * (3 if parameter.rows else 1)
    return other(parameter) if count == 1 else [other(parameter, i) for i in range(count)]


mesher = simple.CartesianMesher(Input=opened(CUBE))
expected = {parameter.name: others(parameter) for parameter in parameters(MESHER)}
for collection in collections(MESHER):
    for column in collection.columns:
        expected[column.name] = [other(column, i) for i in range(3 * column.count)]
for name, value in expected.items():
    setattr(mesher, name, value)
file = saved("all.toml", mesher)
found = read_task(file).properties
assert set(found) == set(expected), set(found) ^ set(expected)
for name, value in expected.items():
    assert found[name] == value, f"{name} is {found[name]}, not {value}, in {file.read_text()}"
print(len(expected), "properties")

# None: only the surface.
mesher = simple.CartesianMesher(Input=opened(CUBE))
assert read_task(saved("none.toml", mesher)).properties == {}


# The same meshes.
def zone(source, **properties):
    return simple.RefinementRegion(Input=source, **properties)


ball = folder / "below" / "ball.vtp"
simple.SaveData(str(ball), proxy=simple.Sphere(Center=[70, 200, -100], Radius=20), DataMode="Binary")
field = folder / "field.vtu"
header = opened(HEADER)
coarse = simple.CartesianMesher(Input=header, CellSize=40)
simple.SaveData(str(field), proxy=simple.Calculator(Input=coarse, AttributeType="Cell Data", Function="14", ResultArrayName="size"),
    DataMode="Binary")
SCENES = {
    "tables": (header, dict(CellSize=18.3, BoundaryNames=["inlet_*", "outlet_1"], BoundaryTypes=["automatic", "symmetry"],
        BoundaryDepths=[1, -1], BoundaryMergedNames=["in", ""], BoundaryRefinement=[2, 1, 1, 0], FeatureAngle=100 / 3,
        RefinementShapes=["sphere"], RefinementPositions=[50, 180, -120], RefinementLengths=[40, 40, 40], RefinementShapeDepths=[1])),
    "zones": (header, dict(CellSize=21, RegionDepth=0, SizeField=opened(field), SizeArray="size", PatchMethod="Exact Fit",
        RefinementRegions=[zone(header, Depth=1), zone(header, Shape="Sphere", Depth=2), zone(opened(ball), Shape="Input")])),
    "outside": (opened(CUBE), dict(Domain="Outside", Ground="zMin", Half="Across Y", LengthsBehind=2, BoxesAlongBody=6, CellSize=9)),
    "layers": (opened(CUBE), dict(CellSize=1.5, Layers=2, Domain="Around Points", KeepPoints=[-10, -10, -10])),
    "blocks": (simple.GroupDatasets(Input=[opened(CUBE), opened(ball)], BlockNames=["a block", "ball"]),
        dict(RegionsFrom="Blocks", CellSize=4)),
    "split": (simple.SplitSurface(SplitBy="Feature Angle", FeatureAngle=50, BoundaryNames=["inlet_*"], BoundaryMergedNames=["in"],
            Input=simple.SplitSurface(Input=opened(CUBE), CapNames="inlet", SelectedCells=[0], SelectionName="picked")),
        dict(CellSize=1.6, BoundaryNames=["in"], BoundaryDepths=[1])),
    "one block": (simple.GroupDatasets(Input=[opened(CUBE)], BlockNames=["only"]), dict(CellSize=1.6)),
}
for name, (surface, properties) in SCENES.items():
    with Messages():
        mesher = simple.CartesianMesher(Input=surface, **properties)
        expected = output(mesher)
    file = saved(f"{name}.toml", mesher, port=1)
    code = subprocess.run([PROGRAM, "--quiet", str(file)], stderr=subprocess.PIPE, text=True)
    assert code.returncode in (0, 3), code.stderr
    assert expected.GetNumberOfCells() > 100
    assert_identical(name, output(simple.XMLUnstructuredGridReader(FileName=[str(file.with_suffix(".vtu"))])), expected)
    print(f"{name}: {expected.GetNumberOfCells()} cells")
# Files below the task's folder are relative: it may move.
assert 'file = "below/ball.vtp"' in (folder / "zones.toml").read_text()


# What a task cannot say; then what is there stays.
def refused(mesher, *parts):
    file = folder / "kept.toml"
    file.write_text("kept")
    with Messages() as said:
        simple.SaveData(str(file), proxy=mesher)
    for part in (str(file), *parts):
        assert part in str(said), f"no '{part}' in: {said}"
    assert file.read_text() == "kept" and not list(folder.glob("*.new"))


cube = opened(CUBE)
moved = simple.Transform(registrationName="moved", Input=cube)
grouped = simple.GroupDatasets(Input=[cube], OutputType="vtkPartitionedDataSetCollection")
for surface, *parts in (
        (moved, "moved (Transform)", "save its output", "make it the Input of"),
        (simple.Sphere(registrationName="ball"), "ball (Sphere)"),
        (simple.STLReader(FileNames=[str(HEADER)]), "STL Reader", "Named STL Reader"),
        (grouped, "Output Type")):
    refused(simple.CartesianMesher(Input=surface, CellSize=19), *parts)
refused(simple.CartesianMesher(Input=cube, CellSize=9, RefinementRegions=[zone(moved, Shape="Input")]), "moved (Transform)", "RefinementRegion")
refused(simple.CartesianMesher(Input=cube, CellSize=9, RefinementRegions=[moved]), "moved (Transform)", "Refinement Regions of")
picked = simple.SplitSurface(registrationName="picked", Input=cube, SelectionName="one",
    Selection=simple.servermanager.sources.IDSelectionSource(IDs=[-1, 0], FieldType="CELL"))
refused(simple.CartesianMesher(Input=picked, CellSize=9), "picked (Split Surface)", "Selection")
refused(simple.CartesianMesher(Input=cube, CellSize=9, SizeField=moved), "moved (Transform)", "Size Field of")
refused(simple.CartesianMesher(Input=cube, CellSize=9, BoundaryNames=["a"], BoundaryDepths=[1, 2]), "Boundary Depths", "2 values")
with Messages() as said:
    simple.SaveData(str(folder / "nowhere" / "task.toml"), proxy=simple.CartesianMesher(Input=cube, CellSize=9))
assert "cannot be written" in str(said), str(said)
# Other filters have no such file.
try:
    with Messages():
        simple.SaveData(str(folder / "no.toml"), proxy=cube)
    raise AssertionError("a reader has been written as a task")
except AttributeError:
    assert not (folder / "no.toml").exists()
shutil.rmtree(folder)
