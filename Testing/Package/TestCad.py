"""The installed tree, moved elsewhere: CAD Reader finds its program in it, and says what to install where that is missing."""

import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

READ = """
import sys
from cartesianmesher.vtkCartesianMesherFilters import vtkCADReader

assert "paraview" not in sys.modules
reader = vtkCADReader()
reader.SetFileName(sys.argv[1])
reader.Update()
blocks = reader.GetOutputDataObject(0)
for i in range(blocks.GetNumberOfBlocks()):
    values = blocks.GetBlock(i).GetFieldData()
    print(values.GetAbstractArray("SolidName").GetValue(0),
        *(values.GetArray(name).GetTuple1(0) for name in ("Volume", "VolumeOfTriangles", "OpenEdges")))
"""


def read(prefix, python_directory, file):
    return subprocess.run([sys.executable, "-c", READ, file], env={"PYTHONPATH": prefix / python_directory},
        text=True, capture_output=True, check=True)


repository, prefix, python_directory, cad_directory = map(pathlib.Path, sys.argv[1:])
part = repository / "Data" / "heated_pipe.step"
with tempfile.TemporaryDirectory() as folder:
    moved = pathlib.Path(folder).resolve() / "moved"
    shutil.copytree(prefix, moved, symlinks=True)
    answer = read(moved, python_directory, part)
    assert not answer.stderr, answer.stderr
    solids = {name: [float(value) for value in values] for name, *values in map(str.split, answer.stdout.splitlines())}
    assert set(solids) == {"fluid", "pipe", "heater"}, solids
    for volume, of_triangles, open_edges in solids.values():
        assert math.isclose(of_triangles, volume, rel_tol=0.02) and open_edges == 0, solids

    shutil.rmtree(moved / cad_directory)
    answer = read(moved, python_directory, part)
    assert not answer.stdout, answer.stdout
    assert f"{moved / cad_directory}/read-cad" in answer.stderr, answer.stderr
    assert "install the package cartesianmesher-cad" in answer.stderr, answer.stderr
