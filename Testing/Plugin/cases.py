"""On demand: the three tasks of the guide's page Three Cases, each with its solver to the end.

    pvpython Testing/Plugin/cases.py REPOSITORY PROGRAM

That checkMesh refuses none of their meshes, what each takes, the last residuals of its flow, and what its user looks at.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import foam
from pages import HELP, REPOSITORY, blocks

PROGRAM = sys.argv[2]
MESHED = 0, 3  # without or with warnings


def timed(*command):
    began = time.monotonic()
    done = subprocess.run(command, capture_output=True, text=True)
    return done, time.monotonic() - began


folder = pathlib.Path(tempfile.mkdtemp())
(folder / "Data").symlink_to(REPOSITORY / "Data")
os.chdir(folder)
tasks = blocks(HELP / "cases.md", "toml")
assert len(tasks) == 3
for task in tasks:
    assert len([line for line in task.splitlines() if line and not line.startswith("[")]) <= 15
    name = re.search(r'mesh = "(\w+)/case.foam"', task)[1]
    pathlib.Path("task.toml").write_text(task)
    meshed, seconds = timed(PROGRAM, "task.toml")
    assert meshed.returncode in MESHED, meshed.stderr
    cells = re.search(r"^Cells +(\d+)", meshed.stdout, re.M)[1]
    assert not (failures := foam.refused(folder / name)), failures
    began = time.monotonic()
    foam.run(folder / name, "./Allrun")
    print(f"{name}: {cells} cells in {seconds:.0f} s, solved in {time.monotonic() - began:.0f} s")
    log = next((folder / name).rglob("log.simpleFoam")).read_text()
    residuals = re.findall(r"Solving for p, Initial residual = ([^,]+)", log)
    assert len(residuals) == 200 and float(residuals[-1]) < 0.01, residuals[-1]
    print(f"  residual of p {residuals[-1]}")
    for file in sorted((folder / name).rglob("postProcessing/*/0/*.dat")):
        print(f"  {file.parent.parent.name}: {file.read_text().splitlines()[-1].split()[1]}")
    heat = folder / name / "log.chtMultiRegionSimpleFoam"
    if heat.exists():
        print("  temperatures", *re.findall(r"Min/max T:(\S+ \S+)", heat.read_text())[-2:], sep="\n    ")
