"""README.md: its scripts and its task run as they are written, its files are there; the page that maps
the paper to the kernel names every file of it."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

from paraview import simple

from readme import README, block

REPOSITORY, PROGRAM = pathlib.Path(sys.argv[1]), sys.argv[2]

for page, folder in (README, REPOSITORY), ((REPOSITORY / "Filters/Kernel/README.md").read_text(), ""):
    for file in re.findall(r"\]\(([^)#:]+)\)|<img src=\"([^\"]+)\"", page):
        name = "".join(file)
        assert (REPOSITORY / name).is_file(), f"README.md names {name}, which is not there"
for header in (REPOSITORY / "Filters/Kernel").glob("*.h"):
    assert f"`{header.stem}`" in page, f"Filters/Kernel/README.md does not name {header.stem}"

folder = pathlib.Path(tempfile.mkdtemp())
for part in "Data",:
    (folder / part).symlink_to(REPOSITORY / part)
os.chdir(folder)

(folder / "mesh.py").write_text(block("python", "sys.argv[1]"))
said = subprocess.run(["pvpython", "mesh.py", "Data/kcl_exhaust_header_lumens.stl"], check=True,
    capture_output=True, text=True).stdout
assert re.match(r"\d+ cells, \d+ points", said), said
for file in "mesh.vtu", "boundary.vtp":
    assert (folder / file).stat().st_size > 10000

(folder / "task.toml").write_text(block("toml", "[surface]"))
said = subprocess.run([PROGRAM, "task.toml"], check=True, capture_output=True, text=True).stdout
assert "inlet_1" in said
for file in "header.vtu", "case/header.foam", "case/constant/polyMesh/faces", "header.vtp", "header.json":
    assert (folder / file).is_file(), f"{file} was not written"

exec(block("python", "BoundarySmallCellRatios"), vars(simple).copy())
patches = (folder / "header" / "constant" / "polyMesh" / "boundary").read_text()
assert re.search(r"outlet_1\s*{\s*type\s+symmetry;", patches), patches

names = vars(simple).copy()
exec(block("python", "RefinementBlocks"), names)
mesh = names["mesher"]
mesh.UpdatePipeline()
assert mesh.SMProxy.GetClientSideObject().GetErrorCode() == 0
assert mesh.GetDataInformation().GetNumberOfCells() > 1000
