"""All scripts and tasks in README.md and the help pages run as they are written, and do what the pages say."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

from paraview import simple

import foam
from pages import HELP, PAGES, REPOSITORY, blocks, reads_cad

PROGRAM = sys.argv[2]

folder = pathlib.Path(tempfile.mkdtemp())
(folder / "Data").symlink_to(REPOSITORY / "Data")
os.chdir(folder)


def run(*arguments, allowed=(0,)):
    done = subprocess.run(arguments, capture_output=True, text=True)
    assert done.returncode in allowed, done.stderr
    return done.stdout


def expect(*files):
    for file in files:
        assert pathlib.Path(file).stat().st_size > 0 or file.endswith(".foam"), f"{file} is empty"


def run_page(page):
    """Runs what the page has in it, each script with the variables of those before it; these variables."""
    names = vars(simple).copy()
    for script in blocks(page, "python"):
        if "sys.argv" in script:
            pathlib.Path("mesh.py").write_text(script)
            names["said"] = run("pvpython", "mesh.py", "Data/kcl_exhaust_header_lumens.stl")
        else:
            exec(script, names)
    for task in blocks(page, "toml"):
        pathlib.Path("task.toml").write_text(task)
        names["said"] = run(PROGRAM, "task.toml", allowed=(0, 3))  # 3: with warnings, of surfaces as they are
    mesher = names.get("mesher")
    if mesher:
        mesher.UpdatePipeline()
        assert mesher.SMProxy.GetClientSideObject().GetErrorCode() == 0, page
        assert mesher.GetDataInformation().GetNumberOfCells() > 1000, page
    print(page.relative_to(REPOSITORY))
    return names


ran = {page.relative_to(REPOSITORY).as_posix(): run_page(page) for page in PAGES
    if page.name != "cases.md" and (page.name != "cad.md" or reads_cad(PROGRAM))}

# The meshes of the three cases are what their page says, and checkMesh refuses none.
cases = HELP / "cases.md"
for task, part in zip(blocks(cases, "toml"), cases.read_text().split("\n## ")[1:]):
    pathlib.Path("task.toml").write_text(task)
    cells = int(re.search(r"^Cells +(\d+)", run(PROGRAM, "task.toml", allowed=(0, 3)), re.M)[1])
    told = int(re.search(r"\(([\d,]+) cells\)", part)[1].replace(",", ""))
    assert abs(cells - told) < 0.03 * told, f"{cells} cells, not {told}"
    assert not (failures := foam.refused(re.search(r'mesh = "(\w+)/case.foam"', task)[1])), failures

said = ran["README.md"]["said"]
assert re.match(r"\d+ cells, \d+ points", said), said
expect("mesh.vtu", "boundary.vtp", "case/case.foam")
assert "inlet_1" in ran["Plugin/Help/batch.md"]["said"]
expect("header.vtu", "case/header.foam", "case/constant/polyMesh/faces", "header.vtp", "header.json")
patches = pathlib.Path("header/constant/polyMesh/boundary").read_text()
assert re.search(r"outlet_1\s*{\s*type\s+symmetry;", patches), patches
expect("pipe/case.foam", "pipe/constant/polyMesh/boundary", "pipe/system/controlDict")
ran["Plugin/Help/quality.md"]["failing"].UpdatePipeline()

# The reference has all that the outputs have.
reference = (HELP / "reference.md").read_text()
mesher = ran["Plugin/Help/quality.md"]["mesher"]
for port in 0, 1, 2:
    data = mesher.SMProxy.GetClientSideObject().GetOutputDataObject(port)
    for arrays in data.GetPointData(), data.GetCellData(), data.GetFieldData():
        for i in range(arrays.GetNumberOfArrays()):
            name = arrays.GetAbstractArray(i).GetName()
            assert f"`{name}`" in reference, f"reference.md does not say what {name} is"
