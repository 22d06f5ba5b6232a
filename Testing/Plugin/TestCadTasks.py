"""Tasks that name CAD files: they are read with the properties in [cad], also where the window wrote these, and what is
wrong with the table or with a file is told with its line.

pipe.step, written by Open CASCADE 7.6: the fluid in a pipe, radius 5 mm, length 30 mm, with faces called inlet and
outlet, and the pipe around it, radius 7 mm, with a face called heater."""

import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib

from paraview import servermanager, simple

import foam
from pipeline import Messages, assert_identical, octahedron, output, producer

PROGRAM = sys.argv[2]
ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "Plugin" / "Task"))
from task import cad_parameters, read_task  # noqa: E402
from template import template  # noqa: E402

SUCCESS, REFUSED, WARNINGS, STOPPED = 0, 2, 3, 130
folder = pathlib.Path(tempfile.mkdtemp())
PIPE = folder / "pipe.step"
shutil.copy(ROOT / "Testing" / "Plugin" / PIPE.name, PIPE)
VOLUMES = {"fluid": math.pi * 25 * 30, "pipe": math.pi * 24 * 30}


def task(text):
    path = folder / "task.toml"
    path.write_text(text)
    return path


def start(path, *arguments, code=SUCCESS, ranks=0, **environment):
    """What the program says; it must end with the code."""
    mpi = [*foam.MPIRUN, "-n", str(ranks)] if ranks else []
    clean = {name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    done = subprocess.run([*mpi, PROGRAM, *arguments, str(path)], text=True, timeout=300, env=clean | environment,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == code, f"exit code {done.returncode} instead of {code}: {done.stdout}"
    return done.stdout


def opened(file, registrationName=None, **properties):
    reader = simple.OpenDataFile(str(file))
    if registrationName:
        simple.RenameSource(registrationName, reader)
    for name, value in properties.items():
        setattr(reader, name, value)
    return reader


def mesh(name):
    return output(simple.XMLUnstructuredGridReader(FileName=[str(folder / name)]))


def boundaries(name):
    return [row["name"] for row in json.loads((folder / name).read_text())["boundaries"]]


# The template has all properties with their defaults.
lines = template().partition("# [cad]\n")[2].splitlines()
commented = tomllib.loads("\n".join(line[2:] for line in lines if re.match(r"# \w+ = ", line)))
assert commented == {parameter.key: parameter.default for parameter in cad_parameters()}, commented
assert set(commented) == {"angle", "boundary_names_from", "deflection", "glue_solids", "heal_tolerance", "keep_damaged_faces", "length_unit",
    "merge_coplanar", "name_encoding", "scale", "time_limit"}

# Deflection is a hundredth of the cell size, unless there is another one, or no cell size.
SURFACE = f'[surface]\nfile = "{PIPE.name}"\n'
for text, expected in (
    ("[grid]\ncell_size = 3\n", {"Deflection": 0.03}),
    ("[grid]\ncell_size = 3\n[cad]\ndeflection = 0\nangle = 20\n", {"Deflection": 0.03, "Angle": 20}),
    ("[grid]\ncell_size = 3\n[cad]\ndeflection = 0.5\n", {"Deflection": 0.5}),
    ("[grid]\ncell_size = 0\n", {}),
    ("[grid]\ncell_size = 3\nmeshlines_y = [0, 1]\n", {}),
    ('[cad]\nlength_unit = "inch"\nglue_solids = true\n', {"LengthUnit": "Inch", "GlueSolids": 1}),
):
    found = read_task(task(SURFACE + text)).cad
    assert found == expected, (text, found)

# Solids are regions, with the same faces on both sides, and boundaries are called as in the file; on several ranks too.
REGIONS = SURFACE + """
[domain]
regions_from = "Blocks"
[cad]
length_unit = "Millimetre"
glue_solids = true
[grid]
cell_size = 1.3
[case]
scale = 0.001
[output]
mesh = ["regions.vtu", "case/regions.foam"]
statistics = "regions.json"
"""
said = start(task(REGIONS))
assert "%  Reading the CAD file" in said, said
reader = opened(PIPE, LengthUnit="Millimetre", GlueSolids=1, Deflection=0.013)
mesher = simple.CartesianMesher(Input=reader, CellSize=1.3, RegionsFrom="Blocks")
expected = output(mesher)
assert expected.GetNumberOfCells() > 1000
assert_identical("regions", mesh("regions.vtu"), expected)
fields = expected.GetFieldData()
names, volumes = fields.GetAbstractArray("RegionNames"), fields.GetArray("RegionVolumes")
assert [names.GetValue(i) for i in range(2)] == list(VOLUMES)
for i, exact in enumerate(VOLUMES.values()):
    assert abs(volumes.GetValue(i) / exact - 1) < 0.02, (volumes.GetValue(i), exact)
assert {"inlet", "outlet", "heater"} < set(boundaries("regions.json"))
fluid, pipe = (foam.Files(folder / "case", region) for region in VOLUMES)
assert {"inlet", "outlet", "fluid_to_pipe"} <= set(fluid.patches) and {"heater", "pipe_to_fluid"} <= set(pipe.patches)
assert fluid.patches["fluid_to_pipe"][2] == pipe.patches["pipe_to_fluid"][2] > 100
assert re.search(r"fluid \( fluid \)\s+solid \( pipe \)", (folder / "case/constant/regionProperties").read_text())
for region in VOLUMES:
    check = foam.CheckMesh(folder / "case", "-region", region)
    assert check.ok, (region, check.failures)
before = (folder / "regions.vtu").read_bytes()
assert start(task(REGIONS), ranks=2).count("Reading the CAD file") == 1
assert (folder / "regions.vtu").read_bytes() == before

# Of a list of files, a CAD file keeps its boundaries, and regions are called as files. Zones and fields are read alike.
simple.SaveData(str(folder / "ball.vtp"), proxy=producer(octahedron(8, (0, 0, 50))), DataMode="Binary")
LIST = '[surface]\nfile = ["pipe.step", "ball.vtp"]\nnames = ["part", "lump"]\n[grid]\ncell_size = 2.3\n' \
    '[cad]\nlength_unit = "Millimetre"\n'
start(task(LIST + '[output]\nmesh = "list.vtu"\nstatistics = "list.json"\n'), code=WARNINGS)
assert boundaries("list.json") == ["fluid", "outlet", "inlet", "heater", "pipe", "lump"], boundaries("list.json")
start(task(LIST + '[domain]\nregions_from = "Blocks"\n[output]\nmesh = "list.vtu"\n'), code=WARNINGS)
names = mesh("list.vtu").GetFieldData().GetAbstractArray("RegionNames")
assert [names.GetValue(i) for i in range(names.GetNumberOfValues())] == ["part", "lump"]
ZONE = '[surface]\nfile = "ball.vtp"\n[grid]\ncell_size = 2\n[[regions]]\nfile = "pipe.step"\ndepth = 2\n' \
    '[output]\nmesh = "zone.vtu"\n[cad]\nlength_unit = "Millimetre"\n'
start(task(ZONE), "--quiet")
apart = mesh("zone.vtu").GetNumberOfCells()
start(task(ZONE + "scale = 1.7\n"), "--quiet")  # up to z = 51
assert mesh("zone.vtu").GetNumberOfCells() > 2 * apart > 200

# What is wrong is told with its line.
(folder / "noise.step").write_bytes(bytes(range(256)))
for text, *parts in (
    ('[surface]\nfile = "ball.vtp"\n[cad]\nscale = 0\nangle = 46\nfile_name = "a"\n\nboundary_names_from = "Numbers"\n',
        ":3: cad: is for files that end in .brep, .iges, .igs, .step, .stp, and the task has none", ":4: cad.scale: 0 is out of range",
        ":5: cad.angle: 46 is out of range: 1 or more and at most 45", ":6: cad.file_name: is not a known key; choose from angle,",
        ":8: cad.boundary_names_from: 'Numbers' is not one of 'Automatic', 'Faces'"),
    ("cad = 1\n" + SURFACE, ":1: cad: must be a table"),
    ('[surface]\nfile = "noise.step"\n[[regions]]\nfile = "noise.step"\ndepth = 1\n', ":2: surface.file: ", "noise.step cannot be read as STEP",
        ":4: regions[0].file: "),
):
    for arguments in ((), ("--check",)):
        said = start(task(text), *arguments, code=REFUSED)
        assert said.count("error: ") == len([part for part in parts if part.startswith(":")]), said
        assert all(part in said for part in parts), said

# The program that reads them is beside the library: here is another library.
other = folder / "other"
LIBRARY = pathlib.Path(PROGRAM).parents[1] / "lib" / "libvtkCartesianMesherFilters.so"
if not LIBRARY.exists():  # called as the version
    LIBRARY = next(LIBRARY.parent.glob("libvtkCartesianMesherFilters*.so"))
(other / "lib").mkdir(parents=True)
shutil.copy(LIBRARY.resolve(), other / "lib" / LIBRARY.name)
ELSEWHERE = {"LD_LIBRARY_PATH": str(other / "lib")}
MESH = SURFACE + "[grid]\ncell_size = 0.0023\n"
for arguments in ((), ("--check",)):
    said = start(task(MESH), *arguments, code=REFUSED, **ELSEWHERE)
    assert ":2: surface.file: CAD files are read by the program" in said and "install the package cartesianmesher-cad" in said, said


def stand_in(text):
    """Another program takes the place of the one that reads CAD files."""
    file = other / "libexec" / "cartesianmesher" / "read-cad"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)
    file.chmod(0o755)


# Its warnings are the task's, and signals stop it.
REAL = pathlib.Path(PROGRAM).parents[1] / "libexec" / "cartesianmesher" / "read-cad"
stand_in(f"""#!/usr/bin/python3
import os, sys
text = b"A face is left out."
os.write(1, b"W" + (8 + len(text)).to_bytes(8, sys.byteorder) + len(text).to_bytes(8, sys.byteorder) + text)
os.execv("{REAL}", ["{REAL}", *sys.argv[1:]])
""")
said = start(task(MESH + '[output]\nstatistics = "warned.json"\n'), "--quiet", code=WARNINGS, **ELSEWHERE)
assert said.startswith("warning: A face is left out.\nwarning: ") and said.count("A face") == 1, said
assert json.loads((folder / "warned.json").read_text())["warnings"][0] == "A face is left out."
said = start(task(MESH), "--check", code=WARNINGS, **ELSEWHERE)
assert "warning: A face is left out.\n" in said and "about" in said, said
stand_in("#!/bin/sh\nexec sleep 100\n")
for sent, code in (signal.SIGINT, STOPPED), (signal.SIGTERM, -signal.SIGTERM):
    running = subprocess.Popen([PROGRAM, str(task(MESH))], stdout=subprocess.PIPE, text=True, env=os.environ | ELSEWHERE)
    try:
        assert "Reading the CAD file" in running.stdout.readline()
        time.sleep(0.5)
        running.send_signal(sent)
        ended = running.wait(20)
    finally:
        running.kill()
    assert ended == code, (sent, ended)


# The window's settings as a task make the same mesh, bit for bit.
def saved(name, mesher):
    with Messages() as said:
        servermanager.writers.CartesianMesherTaskWriter(Input=mesher, FileName=str(folder / name)).UpdatePipeline()
    assert "ERR|" not in str(said), str(said)
    return folder / name


def cad_of(file):
    return tomllib.loads(file.read_text()).get("cad", {})


default = opened(PIPE)
glued = opened(PIPE, LengthUnit="Millimetre", Angle=15, BoundaryNamesFrom="Solids")
fine = opened(PIPE, LengthUnit="Inch", GlueSolids=0, Scale=1.1, Deflection=0.0123456789)
ball = opened(folder / "ball.vtp")
SCENES = {
    "default": (default, dict(CellSize=0.0013), {"deflection": 3e-5}),
    "glued": (glued, dict(CellSize=1.3, RegionsFrom="Blocks"),
        {"angle": 15, "boundary_names_from": "Solids", "deflection": 0.03, "length_unit": "Millimetre"}),
    "fine": (fine, dict(CellSize=0.07), {"deflection": 0.0123456789, "glue_solids": False, "length_unit": "Inch", "scale": 1.1}),
    "lines": (default, dict(CellSize=0.0013, MeshlinesX=[-0.007, -0.003, 0, 0.002, 0.007]), {}),
    "zone": (ball, dict(CellSize=2, RefinementRegions=[simple.RefinementRegion(Input=opened(PIPE, LengthUnit="Millimetre", Scale=1.7), Shape="Input"),
            simple.RefinementRegion(Input=default, Shape="Sphere", Center=[0, 0, 50], Radius=1)]),
        {"deflection": 0.051, "length_unit": "Millimetre", "scale": 1.7}),
    "list": (simple.GroupDatasets(Input=[glued, ball], BlockNames=["part", "lump"]), dict(CellSize=2.3),
        {"angle": 15, "boundary_names_from": "Solids", "deflection": 0.03, "length_unit": "Millimetre"}),
    "split": (simple.SplitSurface(Input=glued, SplitBy="Feature Angle"), dict(CellSize=1.3),
        {"angle": 15, "boundary_names_from": "Solids", "deflection": 0.03, "length_unit": "Millimetre"}),
}
for name, (surface, properties, table) in SCENES.items():
    with Messages():
        mesher = simple.CartesianMesher(Input=surface, **properties)
        expected = output(mesher)
    assert expected.GetNumberOfCells() > 100
    found = cad_of(saved(f"{name}.toml", mesher))
    assert found.keys() == table.keys() and all(
        math.isclose(found[key], value, rel_tol=1e-6) if isinstance(value, float) else found[key] == value
        for key, value in table.items()), (name, found)
    done = subprocess.run([PROGRAM, "--quiet", str(folder / f"{name}.toml")], stderr=subprocess.PIPE, text=True)
    assert done.returncode in (SUCCESS, WARNINGS), done.stderr
    assert_identical(name, mesh(f"{name}.vtu"), expected)
    print(f"{name}: {expected.GetNumberOfCells()} cells")

# One table for all CAD files: others are refused, and what is there stays.
large = folder / "large.step"
large.write_text(PIPE.read_text().replace("30.", "60."))
for first, second, *parts in (
    (simple.CADReader(registrationName="one", FileName=str(PIPE)), simple.CADReader(registrationName="two", FileName=str(PIPE), Angle=20),
        "two (CAD Reader) has another Angle than one (CAD Reader)"),
    (opened(PIPE), opened(large), "another Deflection (its default depends on the size) than"),
):
    both = simple.CartesianMesher(Input=first, CellSize=0.001, RefinementRegions=[second])
    (folder / "kept.toml").write_text("kept")
    with Messages() as said:
        servermanager.writers.CartesianMesherTaskWriter(Input=both, FileName=str(folder / "kept.toml")).UpdatePipeline()
    assert all(part in str(said) for part in (*parts, "give both the same")), str(said)
    assert (folder / "kept.toml").read_text() == "kept"
shutil.rmtree(folder)
