"""cartesian-mesher: what it writes, what it refuses, and that it knows every property of the panel."""

import contextlib
import importlib.util
import json
import os
import resource
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import tomllib

from paraview import simple
from vtkmodules.vtkIOGeometry import vtkSTLWriter

import foam
from pipeline import DATA, assert_identical, octahedron, output, polydata

PROGRAM = sys.argv[2]
sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Plugin" / "Task"))
from parameters import collections, key_of, names, parameters  # noqa: E402
from task import FLAT, MESHER, PERIODIC, REGION, TaskError, case_parameters, lines_of, read_task, shape_parameters  # noqa: E402
from template import template  # noqa: E402
RUN = importlib.util.spec_from_file_location("run",
    pathlib.Path(PROGRAM).parents[1] / "share" / "cartesianmesher" / "run.py")
program = importlib.util.module_from_spec(RUN)
RUN.loader.exec_module(program)

SUCCESS, REFUSED, WARNINGS = 0, 2, 3
# Not in files: Open MPI 5 would die of the limit that some get here (of_limited_size).
SHARED_MEMORY = {"OMPI_MCA_shmem": "sysv"}
EXHAUST = DATA / "kcl_exhaust_header_lumens.stl"
folder = pathlib.Path(tempfile.mkdtemp())


def start(*arguments, ranks=0, code=SUCCESS, codes=None, **more):
    """What the program says, on stdout and stderr; it must end with the code, or one of these."""
    mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)] if ranks else []
    # Started by a program that is of MPI itself, mpirun refuses.
    environment = {name: value for name, value in os.environ.items()
        if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))} | SHARED_MEMORY
    done = subprocess.run([*mpi, PROGRAM, *map(str, arguments)], capture_output=True, text=True,
        timeout=300, env=environment, **more)
    said = done.stdout + done.stderr
    assert done.returncode in (codes or (code,)), f"exit code {done.returncode} instead of {codes or code}: {said}"
    return said


def run(text, *arguments, **more):
    path = folder / "task.toml"
    path.write_text(text)
    return start(path, *arguments, **more)


def here(text, *arguments, code=REFUSED):
    """What the program says of a task on stderr, run in this process, as starting it takes two seconds."""
    (folder / "task.toml").write_text(text)
    with open(folder / "said.txt", "wb") as file, into(file):
        ended = program.main([str(folder / "task.toml"), *arguments])
    said = (folder / "said.txt").read_text()
    assert ended == code, f"exit code {ended} instead of {code}: {said}"
    return said


@contextlib.contextmanager
def into(file):
    """There goes what is written to stderr, by VTK too."""
    kept = os.dup(2)
    os.dup2(file.fileno(), 2)
    try:
        yield
    finally:
        sys.stderr.flush()
        os.dup2(kept, 2)
        os.close(kept)


def read(name, reader=simple.XMLUnstructuredGridReader):
    return output(reader(FileName=[str(folder / name)]))


# Every property of the panel is a key, and has its default: the template says all keys, and read
# back, it is what a new filter has.
mesher = simple.CartesianMesher(Input=simple.Sphere())
assert set(names(MESHER)) == \
    set(mesher.ListProperties()) - {"Input", "RefinementRegions", "SizeField", "LegendInfo", "ExpectedBoxes", "SurfaceSize", "FlowZones", "ExpectedLayers", "Made",
        "DomainNote", "Preview"}
region = simple.RefinementRegion(Input=simple.Sphere())
assert {parameter.name for parameter in parameters(REGION)} == set(region.ListProperties()) - {"Input"}
for parameter in parameters(MESHER):
    assert parameter.table, f"{parameter.name} is in no group of the panel, so in no table of a task"
    assert len(parameter.documentation) > 20, f"{parameter.name} has no documentation"
    assert not parameter.columns or len(parameter.columns) == parameter.count, parameter
    assert mesher.GetProperty(parameter.name).GetData() == parameter.default, parameter

for collection in collections(MESHER):
    for column in collection.columns:
        assert len(column.documentation) > 20, f"{column.name} has no documentation"

full = tomllib.loads(start("--template"))
assert {(table, key) for table in full for key in full[table]} == \
    {(parameter.table, parameter.key) for parameter in parameters(MESHER) if not parameter.deprecated} \
    | {("surface", "file")} \
    | {("case", parameter.key) for parameter in case_parameters()}
(folder / "surface.stl").symlink_to(EXHAUST)
(folder / "full.toml").write_text(template())
task = read_task(folder / "full.toml")
assert task.properties == {parameter.name: parameter.default for parameter in parameters(MESHER) if not parameter.deprecated}
assert task.case == {parameter.name: parameter.default for parameter in case_parameters()}
for heading, name in ("[flat]", FLAT), ("[[periodic]]", PERIODIC):  # commented: without them there are no such filters
    table = template().split(f"\n# {heading}\n")[1].split("\n# [")[0]
    assert all(f"\n# {parameter.key} = " in table for parameter in shape_parameters(name)), table
assert key_of("Blend to depth - 1") == "blend_to_depth_1"

# A task gives the mesh that the filter gives, bit for bit, on any number of ranks.
TASK = f"""
[surface]
file = "{EXHAUST}"
[grid]
cell_size = 24
meshlines_z = [-400, -150.5, -100, -50, 0, 400]
[refinement]
boundary_refinement = [
  {{ boundary = "inlet_1", depth = 2, blending_distance = 1, blend_to_depth_1 = true }},
  [2, 1, 0, 0],
]
[[boundaries]]
name = "inlet_2"
small_cell_ratio = 0.02
[[boundaries]]
name = "outlet_1"
type = "wall"
[[regions]]
shape = "Sphere"
center = [70, 200, -100]
radius = 30
depth = 2
[[regions]]
shape = "Box"
position = [0, 0, -100]
length = [40, 50, 60]
[cells]
small_cells = "Remove"
small_cell_ratio = 0.001
refused_cell_ratio = 0
true_volume = false
[output]
mesh = "out/mesh.vtu"
boundary = ["out/boundary.vtp"]
defects = "out/defects.vtp"
statistics = "out/statistics.json"
"""
source = simple.OpenDataFile(str(EXHAUST))
regions = [simple.RefinementRegion(Input=source, Shape="Sphere", Center=[70, 200, -100], Radius=30, Depth=2),
           simple.RefinementRegion(Input=source, Position=[0, 0, -100], Length=[40, 50, 60])]
mesher = simple.CartesianMesher(Input=source, CellSize=24, MeshlinesZ=[-400, -150.5, -100, -50, 0, 400],
    BoundaryRefinement=[1, 2, 1, 1, 2, 1, 0, 0], RefinementRegions=regions, SmallCells="Remove", SmallCellRatio=0.001, RefusedCellRatio=0, TrueVolume=0,
    BoundaryNames=["inlet_2", "outlet_1"], BoundaryTypes=["automatic", "wall"], BoundarySmallCellRatios=[0.02, -1])
expected = output(mesher)
assert expected.GetNumberOfCells() > 500
said = run(TASK, code=WARNINGS)  # boxes this coarse lose volume
assert "less than the surface encloses" in said, said
for stage in "Boxes", "Patches", "Cells", "Writing the mesh":
    assert f"%  {stage}" in said, said
assert "inlet_1" in said
assert_identical("from a task", read("out/mesh.vtu"), expected)
assert_identical("its boundary", read("out/boundary.vtp", simple.XMLPolyDataReader), output(mesher, 1))
assert_identical("its defects", read("out/defects.vtp", simple.XMLPolyDataReader), output(mesher, 2))
statistics = json.loads((folder / "out" / "statistics.json").read_text())
assert statistics["mesh"]["Cells"] == expected.GetNumberOfCells()
assert [row["name"] for row in statistics["boundaries"]][:3] == ["wall_1", "inlet_1", "outlet_1"]
assert [row["type"] for row in statistics["boundaries"]][:3] == ["", "", "wall"]
assert statistics["parameters"]["BoundarySmallCellRatios"] == [0.02, -1]
assert statistics["parameters"]["BoundaryRefinement"] == [1, 2, 1, 1, 2, 1, 0, 0]
assert not statistics["errors"] and statistics["error_code"] == 0
assert len(statistics["warnings"]) == 1 and "less than the surface encloses" in statistics["warnings"][0]
alone = (folder / "out" / "mesh.vtu").read_bytes()
said = run(TASK, "--quiet", ranks=2, code=WARNINGS)
assert said.startswith("warning: The mesh holds ") and "% less" in said and said.count("warning") == 1, said
assert (folder / "out" / "mesh.vtu").read_bytes() == alone
shutil.rmtree(folder / "out")
boxes, cells = map(int, re.fullmatch(r"about (\d+) boxes, (\d+) cells, [0-9.]+ GiB of memory\n", run(TASK, "--check")).groups())
made = statistics["mesh"]["BoxesInside"] + statistics["mesh"]["BoxesIntersected"]
assert 0.8 < boxes / made < 1.25, f"{boxes} estimated, {made} made"
assert 0.7 < cells / statistics["mesh"]["Cells"] < 1.4, f"{cells} estimated, {statistics['mesh']['Cells']} made"
assert not (folder / "out").exists()
said = run(f'[surface]\nfile = "{EXHAUST}"\n[domain]\ndomain = "Outside"\n', "--check")  # with a note, which is no warning
assert re.search(r"\nThe body is 387\.\d* long along y, but 191\.\d* along x, where the flow goes\.", said), said

# Several files are boundaries of their names.
points, triangles = [octahedron().GetPoint(i) for i in range(6)], [
    (0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
for name, part in ("floor", triangles[4:]), ("roof", triangles[:4]):
    writer = vtkSTLWriter()
    writer.SetFileName(str(folder / f"{name}.stl"))
    writer.SetInputData(polydata(points, part))
    writer.Write()
FILES = '[surface]\nfile = ["roof.stl", "floor.stl"]\n'
assert "Cell Size is 1e+09" in here(FILES + "[grid]\ncell_size = 1e9\n", "--check")
said = here(FILES + "[grid]\ncell_size = 1e-9\n", "--check")
assert "about" not in said and "choose a larger Cell Size" in said, said
here(FILES + '[[regions]]\nfile = ["roof.stl"]\n')
here(FILES + '[output]\nstatistics = "s.json"\nmesh = "m.vtu"\n', code=SUCCESS)
assert [row["name"] for row in json.loads((folder / "s.json").read_text())["boundaries"]] == ["roof", "floor"]

# What a row leaves out is as without it. Boundaries on which no layers are asked are listed.
cube = output(simple.Triangulate(Input=simple.Box()))
corners = [cube.GetPoint(i) for i in range(cube.GetNumberOfPoints())]
sides = [[cube.GetCell(i).GetPointId(j) for j in range(3)] for i in range(cube.GetNumberOfCells())]
for name, part in ("end", sides[:2]), ("rest", sides[2:]):
    writer = vtkSTLWriter()
    writer.SetFileName(str(folder / f"{name}.stl"))
    writer.SetInputData(polydata(corners, part))
    writer.Write()
LAYERS = """
[surface]
file = ["end.stl", "rest.stl"]
[grid]
cell_size = 0.2
[layers]
layers = 2
[output]
mesh = "m.vtu"
statistics = "s.json"
[[boundaries]]
name = "end"
"""
for row, ends in ("", [1, 1]), ('type = "wall"', [1, 1]), ("depth = 0", [1, 1]), ("layers_thickness = 0", [0, 1]), ('type = "patch"', [0, 1]):
    said = run(LAYERS + row)
    assert ("no layers asked on end\n" in said) == (ends[0] == 0), said
    made = json.loads((folder / "s.json").read_text())
    assert [made["mesh"]["LayerCoverage"], *(boundary["layer_coverage"] for boundary in made["boundaries"])] == [1, *ends], made
    assert [boundary["layers_asked"] for boundary in made["boundaries"]] == ends, made
    assert made["parameters"]["BoundarySmallCellRatios"] == [-1]

# Then one cell across and periodic: the mesh alone. What these filters say names the table, and ends the task as the mesher's errors do.
rod = simple.Transform(Input=simple.Cylinder(Radius=0.4, Height=4, Resolution=40))
rod.Transform.Rotate = [90, 0, 0]
simple.SaveData(str(folder / "rod.stl"), proxy=rod)
PAIRS = """
[surface]
file = "rod.stl"
[grid]
cell_size = 0.1
[domain]
domain = "Outside"
side_names = "Axes"
box_from = "Bounds"
domain_bounds = [-1.0, 1.0, -1.0, 1.0, -0.2, 0.2]
boxes_along_body = 0
[refinement]
periodic_sides = "X and Y"
[flat]
across = "Z"
[[periodic]]
first_boundary = "xMin"
second_boundary = "xMax"
motion = "translation"
[[periodic]]
first_boundary = "yMin"
second_boundary = "{second}"
[case]
solver_setup = "Incompressible"
turbulence = "Laminar"
[output]
mesh = ["{folder}/case.foam", "{folder}/mesh.vtu"]
boundary = "{folder}/boundary.vtp"
statistics = "{folder}/statistics.json"
"""
said = run(PAIRS.format(second="left", folder="wrong"), code=REFUSED)
assert 'task.toml:20: periodic[1]: There is no boundary "left"' in said, said
failed = json.loads((folder / "wrong" / "statistics.json").read_text())
assert failed["error_code"] != 0 and "periodic[1]: There is no boundary" in failed["errors"][0], failed["errors"]
assert [path.name for path in (folder / "wrong").iterdir()] == ["statistics.json"]
run(PAIRS.format(second="yMax", folder="pairs"))
checked = foam.CheckMesh(folder / "pairs")
assert checked.ok and "2 solution (non-empty) directions" in checked.text, checked.text[-2000:]
assert "meanVelocityForce" in (folder / "pairs" / "constant" / "fvOptions").read_text()
flat, whole = read("pairs/mesh.vtu"), json.loads((folder / "pairs" / "statistics.json").read_text())
assert flat.GetFieldData().GetArray("PeriodicPairs").GetNumberOfTuples() == 2
assert flat.GetNumberOfCells() == checked.figures["cells"] < whole["mesh"]["Cells"] / 2, (checked.figures, whole["mesh"])
sides = read("pairs/boundary.vtp", simple.XMLPolyDataReader).GetBounds()
assert abs(sides[4] + 0.2) < 1e-6 and abs(sides[5] - 0.2) < 1e-6, sides
# Both need the mesh in one piece.
said = run(PAIRS.format(second="yMax", folder="ranks"), ranks=2, code=REFUSED)
assert "task.toml:14: flat: needs the mesh in one piece: start the program without mpirun" in said, said
said = here(PAIRS.format(second="yMax", folder="pieces") + "pieces = 2\n")
assert ":30: output.pieces: flat and periodic meshes are written in one piece" in said, said
said = here(FILES + "[[periodic]]\nfirst_boundary = 'a'\nsecond_boundary = 'b'\n[grid]\ncell_size = 0.02\n[performance]\n"
    "memory_limit = 0.1\n[cells]\nsmall_cells = 'Remove'\nsplit_concave_cells = false\ncollapse_ratio = 0\n[output]\nmesh = 'limit.pvtu'\n")
assert ":3: periodic[0]: needs the mesh in one piece, but by memory_limit it would be made in " in said, said

# A mesh with warnings.
said = here('[surface]\nfile = "roof.stl"\n[grid]\ncell_size = 0.1\n[output]\nstatistics = "s.json"\n', code=WARNINGS)
assert "warning: The surface has 4 open edges" in said, said
said = here('[surface]\nfile = "roof.stl"\n[grid]\ncell_size = 0.1\n', "--check", code=WARNINGS)
assert "warning: The surface has 4 open edges" in said, said
statistics = json.loads((folder / "s.json").read_text())
assert statistics["error_code"] == 0 and "open edges" in statistics["warnings"][0]
# In pieces too, where it is said while files are open.
run('[surface]\nfile = "roof.stl"\n[grid]\ncell_size = 0.1\n[output]\nmesh = "w.pvtu"\npieces = 2\n', code=WARNINGS)
assert (folder / "w.pvtu").exists()
said = here(FILES + "[grid]\nmeshlines_x = [-0.5, 0, 0.5]\n", code=WARNINGS)
assert "warning: The surface extends beyond Meshlines X" in said, said

(folder / "noise.vtp").write_bytes(bytes(range(256)))
(folder / "noise.stl").write_bytes(bytes(80) + (10**9).to_bytes(4, "little") + bytes(range(256)))
(folder / "table.csv").write_text("a,b\n1,2\n")
for name in "full.vtu", "full.vtp":
    (folder / name).symlink_to("/dev/full")

# All that is wrong is told at once, in the file and, where that is well, in what it names.
for text, *parts in (
    (FILES + "[grid]\ncell_size = -1\nsize = 1\n[layers]\nlayers = 'many'\n[[boundaries]]\ndepth = 1\n[[regions]]\nshape = 'Cone'\n"
        "[case]\nspeed = -1\n[output]\npieces = 0\nmesh = 'roof.stl'\n[mesh]\n", ":4: grid.cell_size", ":5: grid.size", ":7: layers.layers",
        ":8: boundaries[0]: needs the key name", ":11: regions[0].shape", ":13: case.speed", ":15: output.pieces", ":16: output.mesh",
        ":17: mesh: is not a known key"),
    (FILES + "[refinement]\nboundary_refinement = [\n" + "".join(f'["{name}", 1, 1, 0],\n' for name in ("wall", "roof", "lid")) + "]\n"
        "[case]\nsolver_setup = 'Incompressible'\n[output]\nmesh = 'm.foam'\n", "no boundary 'wall', only roof, floor", "no boundary 'lid'",
        ":10: case.solver_setup: no boundary is an inlet, as Incompressible needs one, only roof, floor: give one a name"),
    ('[surface]\nfile = "noise.vtp"\n[[regions]]\nfile = "table.csv"\ndepth = 1\n', ":2: surface.file: ParaView cannot read", ":4: regions[0].file"),
):
    for arguments in ((), ("--check",)):
        said = here(text, *arguments)
        assert said.count("error: ") == len(parts) and all(part in said for part in parts), said
# What names an inlet: a solid, a new name, a side of the domain; and only a case needs one.
SOLVER = FILES + "[case]\nsolver_setup = 'Incompressible'\n"
for more in ("[[boundaries]]\nname = 'roof'\nmerged_name = 'inlet_top'\n[output]\nmesh = 'm.foam'\n",
        "[domain]\ndomain = 'Outside'\n[output]\nmesh = 'm.foam'\n", "[output]\nmesh = 'm.vtu'\n"):
    assert "about" in run(SOLVER + more, "--check")
# Or a periodic pair drives the flow, unless turned.
PAIR = "[output]\nmesh = 'm.foam'\n[[periodic]]\nfirst_boundary = 'roof'\nsecond_boundary = 'floor'\n"
for motion in "", "motion = 'Translation'\n":
    here(SOLVER + PAIR + motion, "--check", code=SUCCESS)
assert "no boundary is an inlet" in here(SOLVER + PAIR + "motion = 'Rotation'\n", "--check")
# Choices in any case.
here(FILES + "[patches]\npatch_method = 'exact fit'\n[[refinement_shapes]]\nshape = 'Box'\n[[regions]]\nshape = 'sphere'\n", "--check", code=SUCCESS)

# Refusals name the line and the key.
for text, *parts in (
    (FILES + "[grid]\ncell_size = -1\n", "task.toml:4: grid.cell_size", "out of range: 0 or more"),
    (FILES + "[grid]\ncell_size = 'big'\n", "task.toml:4: grid.cell_size", "'big' is not a number"),
    (FILES + "[grid]\n\nsize = 1\n", "task.toml:5: grid.size", "not a known key", "cell_size"),
    (FILES + "[grid]\nmeshlines_x = 3\n", "task.toml:4: grid.meshlines_x", "must be a list"),
    (FILES + "grid.cell_size = true\n[mesh]\n", "task.toml:4: mesh", "not a known key", "refinement"),
    (FILES + "[refinement]\nrefinement_depth = 1.5\n", ":4: refinement.refinement_depth", "not a whole number"),
    (FILES + "[refinement]\nrefinement_depth = 13\n", ":4: refinement.refinement_depth", "at most 12"),
    (FILES + "[refinement]\nrefinement_blocks = [[1, 2, 3]]\n", ":4:", "row 0: must have 8 values", "i_first"),
    (FILES + "[refinement]\nboundary_refinement = [{ boundary = 1 }]\n", ":4:", "depth is missing"),
    (FILES + "[refinement]\nboundary_refinement = [{ boundry = 1 }]\n", ":4:", "there is no boundry"),
    (FILES + '[refinement]\nboundary_refinement = [["walls", 1, 0, 0]]\n', "refinement.boundary_refinement",
        "no boundary 'walls', only roof, floor"),
    (FILES + '[patches]\npatch_method = "Best"\n', ":4: patches.patch_method", "'Exact Fit'"),
    (FILES + '[[regions]]\ndepth = 1\n[[regions]]\nradius = -1\nfile = "roof.stl"\n', ":6: regions[1].radius",
        "cannot be combined with file"),
    (FILES + '[cells]\nsplit_concave_cells = "no"\n', ":4: cells.split_concave_cells", "neither true nor false"),
    (FILES + '[[regions]]\nshape = "Cone"\n', ":4: regions[0].shape", "'Sphere'"),
    (FILES + '[[regions]]\nfile = "none.stl"\n', ":4: regions[0].file", "there is no file"),
    (FILES + "[regions]\ndepth = 1\n", ":3: regions", "[[regions]]"),
    (FILES + '[[boundaries]]\nname = "roof"\n\ntype = "fence"\n', ":6: boundaries[0].type", "'symmetryPlane'"),
    (FILES + '[[boundaries]]\ntype = "wall"\n', ":3: boundaries[0]: needs the key name"),
    (FILES + '[boundaries]\nname = "roof"\n', ":3: boundaries: must be written [[boundaries]]"),
    (FILES + '[[boundaries]]\nname = "walls"\n', 'Boundary Names has "walls"', "Choose from roof, floor."),
    (FILES + "[flat]\nacross = 'W'\n[[periodic]]\nfirst_boundary = 'roof'\nfaces = 1\n", ":4: flat.across", "'X', 'Y', 'Z'",
        ":5: periodic[0]: needs the key second_boundary", ":7: periodic[0].faces", "'Same', 'Own'"),
    (FILES + "[[flat]]\n[periodic]\n", "flat: must be a table", ":4: periodic: must be written [[periodic]]"),
    (FILES + "[flat]\nnumber_of_threads = 1\n", ":4: flat.number_of_threads", "not a known key", "wedge_angle"),
    (FILES + "[output]\nmesh = 1\n", ":4: output.mesh", "name of a file"),
    (FILES + '[[boundaries]]\nname = "roof"\n\ntype = "fence"\n', ":6: boundaries[0].type", "'symmetryPlane'"),
    (FILES + '[[boundaries]]\ntype = "wall"\n', ":3: boundaries[0]: needs the key name"),
    (FILES + '[boundaries]\nname = "roof"\n', ":3: boundaries: must be written [[boundaries]]"),
    (FILES + '[[boundaries]]\nname = "walls"\n', 'Boundary Names has "walls"', "Choose from roof, floor."),
    (FILES + '[output]\nmesh = "m.nonsense"\n', "no writer for .nonsense"),
    ("[grid]\ncell_size = 1\n", "surface", "needs the key file"),
    ('[surface]\nfile = "none.stl"\n', ":2: surface.file", "there is no file"),
    (FILES + f"[grid]\ncell_size = {'9' * 400}\n", ":4: grid.cell_size", "9... is too large for a number"),
    (FILES + f"[grid]\n\ncell_size = {'9' * 5000}\n", ":5: grid.cell_size", "more digits", "in line 5"),
    (FILES + f"[grid]\ncell_size = 0x{'f' * 5000}\n", ":4: grid.cell_size", "too large for a number"),
    (FILES + "[refinement]\nrefinement_depth = inf\n", ":4: refinement.refinement_depth", "not a whole number"),
    (FILES + "[refinement]\nrefinement_depth = nan\n", ":4: refinement.refinement_depth", "not a whole number"),
    (FILES + "[refinement]\nrefinement_depth = 1e400\n", ":4: refinement.refinement_depth", "not a whole number"),
    (FILES + "[performance]\nnumber_of_threads = 4000000000\n", ":4: performance.number_of_threads",
        "at most 2147483647"),
    (FILES + f"[grid]\nmeshlines_x = [\n{'[' * 10000}{']' * 10000}]\n", ":4: grid.meshlines_x", "in line 5"),
    (FILES + "[grid]\nmeshlines_x = [nan]\n", ":4: grid.meshlines_x", "nan is not a number"),
    (FILES + "[refinement]\nrefinement_blocks = [[0, inf, 0, 1, 0, 1, 1, 1]]\n", "inf is not a whole number"),
    (FILES + '[refinement]\nrefined_boundaries = ["nope"]\n', 'Refined Boundaries has "nope"'),
    (FILES + "[" + 30000 * " " + "!\n", "not valid TOML"),
    (FILES + '[grid]\n"a\\u0000" = 1\n', ":3: grid.a\\x00", "not a known key"),
    (FILES + '[[boundaries]]\nname = "roof\\u0000"\n', ":4: boundaries[0].name", "'roof\\x00' contains the character NUL"),
    ('[surface]\nfile = "roof\\u0000.stl"\n', ":2: surface.file", "NUL"),
    (f'[surface]\nfile = "{5000 * "s"}.stl"\n', ":2: surface.file", "cannot be read: File name too long"),
    ("[surface]\nfile = []\n", ":2: surface.file", "name of a file"),
    # Nobody can read this one, not even root.
    ('[surface]\nfile = "/proc/self/mem"\n', ":2: surface.file", "cannot be read: Input/output error"),
    ('[surface]\nfile = "noise.vtp"\n', ":2: surface.file", "ParaView cannot read"),
    ('[surface]\nfile = "table.csv"\n', ":2: surface.file", "not a surface", "vtkTable"),
    (FILES + '[[regions]]\nfile = "table.csv"\n', ":4: regions[0].file", "not a surface", "vtkTable"),
    ('[surface]\nfile = "noise.stl"\n', "1000000000 triangles", "damaged, or not an STL"),
    (FILES + '[output]\nmesh = "m\\u0000.vtu"\n', ":4: output.mesh", "NUL"),
    (FILES + f'[output]\nmesh = "{5000 * "m"}.vtu"\n', ":4: output.mesh", "cannot be written: File name too long"),
    (FILES + '[output]\nmesh = "."\n', ":4: output.mesh", "is a folder"),
    (FILES + '[output]\nmesh = "roof.stl/m.vtu"\n', ":4: output.mesh", "could not be written"),
    (FILES + '[output]\nmesh = "m.vtp"\n', ":4: output.mesh", "no writer for .vtp"),
    (FILES + '[output]\nboundary = "m.vtu"\n', ":4: output.boundary", "no writer for .vtu"),
    (FILES + '[output]\nmesh = "m.vtu"\nstatistics = "m.vtu"\n', ":5: output.statistics", "already an output"),
    (FILES + '[output]\nmesh = ["m.vtm", "m.vtpc"]\n', ":4: output.mesh", "m is already an output"),
    (FILES + '[output]\nstatistics = "roof.stl"\n', ":4: output.statistics", "is an input of the task"),
    (FILES + '[output]\nstatistics = "task.toml"\n', ":4: output.statistics", "is an input of the task"),
    # A full device.
    (FILES + '[output]\nmesh = "full.vtu"\n', ":4: output.mesh", "No space left on device"),
    (FILES + '[output]\nboundary = "full.vtp"\n', ":4: output.boundary", "No space left on device"),
    (FILES + '[output]\nstatistics = "/dev/full"\n', ":4: output.statistics", "No space left on device"),
    ("[surface\n", "not valid TOML", "line 1"),
    (FILES + '[surface]\nfile = "roof.stl"\n', "not valid TOML", "line 3"),
    (FILES + "[grid]\ncell_size = 1e9\n", "error: Cell Size is 1e+09", "smaller"),
    (FILES + '[surface.more]\n', ":3: surface.more", "not a known key"),
):
    said = here(text, "--quiet")
    for part in parts:
        assert part in said, f"no '{part}' in: {said}"
assert "cannot be read" in start(folder / "nothing.toml", code=REFUSED)

# A file that cannot be written whole leaves what was there: files, pieces, a case.
OLD, NEW = FILES + "[grid]\ncell_size = 0.1\n[output]\n", FILES + "[grid]\ncell_size = 0.02\n[output]\n"
MOST_BYTES = 5000000


def of_limited_size():
    resource.setrlimit(resource.RLIMIT_FSIZE, (MOST_BYTES, MOST_BYTES))


def contents():
    return {path: path.read_bytes() for path in (folder / "kept").rglob("*") if path.is_file()}


MESHES = "mesh.vtu", "mesh.pvtu", "mesh.vtk", "mesh.foam"
# VTK's writer of pieces may crash when one cannot be written (seen twice, in vtkXMLUnstructuredDataWriter's
# DeletePositionArrays): even then what was there stays.
ENDS = {"mesh.pvtu": (REFUSED, -signal.SIGSEGV, -signal.SIGABRT)}
here(OLD + f"mesh = {[f'kept/{mesh}' for mesh in MESHES]}\n", "--quiet", code=SUCCESS)
before = contents()
for mesh in MESHES:
    said = run(NEW + f'mesh = "kept/{mesh}"\n', "--quiet", codes=ENDS.get(mesh, (REFUSED,)),
        preexec_fn=of_limited_size)
    assert ":6: output.mesh" in said and "could not be written" in said or "DeletePositionArrays" in said, said
    after = contents()
    assert {path: after.get(path) for path in before} == before, f"{mesh} was lost: {set(after)}"
shutil.rmtree(folder / "kept")
# A new set of pieces leaves nothing of the one before.
for _ in range(2):
    here(OLD + 'mesh = "kept/a.b.pvtu"\nboundary = "kept/a.b.pvtp"\n', "--quiet", code=SUCCESS)
    assert len(contents()) == 4, set(contents())
    assert not any(b'"appended"' in data for data in contents().values()), "ParaView 5.11 may not read them back"
    assert read("kept/a.b.pvtu", simple.XMLPartitionedUnstructuredGridReader).GetNumberOfCells() > 1000
for text, *arguments in (FILES + "[grid]\ncell_size = 1e9\n",), (FILES, "--nonsense"):
    said = run(text, *arguments, ranks=2, code=REFUSED)
    assert "error: " in said and "Stack trace" not in said and "SIGTERM" not in said, said
assert "usage" in start(code=REFUSED) and "Exit codes" in start("--help")

assert lines_of("a = 1\n[b.c]\nd.e = 2\n[[f]]\ng = [\n 1,\n]\n[[f]]\n'g h' = 3 # x\n") == {("a",): 1,
    ("b", "c"): 2, ("b", "c", "d", "e"): 3, ("f", 0): 4, ("f", 0, "g"): 5, ("f", 1): 8, ("f", 1, "g h"): 9}
shutil.rmtree(folder)
