"""Size Array: of the surface's points or cells, of data of any kind, in pieces, and by a task; every box is as small as
is asked for where it is."""

import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from pipeline import Messages, assert_identical, error_code, output, producer

PROGRAM = sys.argv[2]
MISSING_ARRAY = 40006
CELL_SIZE = 0.2

cube = simple.Triangulate(Input=simple.Box())


def with_array(source, attribute, function):
    return simple.Calculator(Input=source, AttributeType=attribute, ResultArrayName="Wanted", Function=function)


def mesher(surface=cube, **properties):
    return simple.CartesianMesher(Input=surface, CellSize=CELL_SIZE, SizeArray="Wanted", PatchMethod="Exact Fit",
        **properties)


def boxes(mesher):
    """Low ends and edges of the cells, which are boxes or parts of boxes."""
    mesh = output(mesher)
    assert error_code(mesher) == 0
    bounds = np.array([mesh.GetCell(i).GetBounds() for i in range(mesh.GetNumberOfCells())])
    level = vtk_to_numpy(mesh.GetCellData().GetArray("Level")).min(axis=1)
    return bounds[:, ::2], bounds[:, 1::2], CELL_SIZE / 2.0**level


def check(mesher, wanted):
    """`wanted`: of cells, from their low and high ends, the least that is asked for there."""
    low, high, edge = boxes(mesher)
    least = wanted(low, high)
    assert (edge <= least * (1 + 1e-6)).all(), (edge / least).max()
    assert len(set(edge)) > 2, "all boxes have one size"


# On the surface: where x is high. Boxes that touch it there are small.
fine = "if(coordsX > 0.4, 0.03, 1)"
corner = lambda low, high: np.where(high[:, 0] > 0.5 - 1e-6, 0.03, 1)  # noqa: E731
check(mesher(with_array(cube, "Point Data", fine)), corner)
of_cells = simple.PointDatatoCellData(Input=with_array(cube, "Point Data", "if(coordsX > 0, 0.03, -1)"))
least = mesher(of_cells)
low, high, edge = boxes(least)  # means of corners: 0.03 only where all three have it
assert (edge[high[:, 0] > 0.5 - 1e-6] <= 0.03).all()

# Fields of several kinds, that ask for less from the left to the right.
image = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
small = simple.Transform(Input=image)
small.Transform.Scale = [0.25, 0.25, 0.25]
ramp = "0.15 - 0.2 * coordsX"
asked = lambda low, high: 0.15 - 0.2 * np.ceil((high[:, 0] - 1e-6) * 4) / 4  # noqa: E731
for kind in small, simple.Tetrahedralize(Input=small), simple.GroupDatasets(Input=[small, small]):
    check(mesher(SizeField=with_array(kind, "Point Data", ramp), LargestDepth=2), asked)
points = simple.PointSource(NumberOfPoints=20, Radius=0.5)
field = with_array(points, "Point Data", "0.04 + 0 * coordsX")
at = vtk_to_numpy(output(field).GetPoints().GetData())


def at_points(low, high):
    has = ((at[None] > low[:, None] + 1e-6) & (at[None] < high[:, None] - 1e-6)).all(axis=2).any(axis=1)
    return np.where(has, 0.04, 1)


check(mesher(SizeField=field), at_points)
few = simple.PointSource(NumberOfPoints=2, Radius=0.2)
assert len(boxes(mesher(SizeField=with_array(few, "Point Data", "0.04 + 0 * coordsX")))[0]) < 600

# In pieces: the same boxes.
one = mesher(SizeField=field)
whole = output(one).GetNumberOfCells()
filter = one.GetClientSideObject()
cells = 0
for piece in range(3):
    filter.UpdatePiece(piece, 3, 0)
    cells += filter.GetOutputDataObject(0).GetNumberOfCells()
assert cells == whole, (cells, whole)

# Infinite values, as of a gradient of 0, ask for nothing.
array = np.full(len(at), np.inf)
array[::2] = np.nan
nothing = output(field).NewInstance()
nothing.DeepCopy(output(field))
wished = numpy_to_vtk(array, deep=True)
wished.SetName("Wanted")
nothing.GetPointData().AddArray(wished)
plain = simple.CartesianMesher(Input=cube, CellSize=CELL_SIZE, PatchMethod="Exact Fit")
assert_identical("nothing asked", output(mesher(SizeField=producer(nothing))), output(plain))

for wrong, words in (mesher(), "of the surface"), (mesher(SizeField=image), "of the Size Field"):
    with Messages() as said:
        wrong.UpdatePipeline()
    assert error_code(wrong) == MISSING_ARRAY, error_code(wrong)
    assert 'Size Array "Wanted" is not a point or cell array ' + words in str(said), said

# A budget: fewer cells, and a message about it; in pieces, too.
varied = with_array(simple.PointSource(NumberOfPoints=400, Radius=0.5), "Point Data", "0.03 + 0.2 * abs(coordsX)")
budget = output(mesher(SizeField=varied)).GetNumberOfCells() // 2
limited = mesher(SizeField=varied, CellBudget=budget)
with Messages() as said:
    mesh = output(limited)
assert abs(mesh.GetNumberOfCells() / budget - 1) < 0.05, (mesh.GetNumberOfCells(), budget)
relaxed = mesh.GetFieldData().GetArray("SizesRelaxed").GetValue(0)
assert relaxed > 0 and f"multiplied by {1 + relaxed:.6g}" in str(said), said
limited = mesher(SizeField=varied, CellBudget=budget).GetClientSideObject()
with Messages() as said:
    limited.UpdatePiece(0, 2, 0)
assert 0 < limited.GetOutputDataObject(0).GetNumberOfCells() < mesh.GetNumberOfCells()
assert f"multiplied by {1 + relaxed:.6g}" in str(said), said

with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    simple.SaveData(str(folder / "cube.stl"), proxy=cube)
    simple.SaveData(str(folder / "field.vtp"), proxy=field, DataMode="Binary")
    (folder / "task.toml").write_text(f"""
[surface]
file = "cube.stl"
[grid]
cell_size = {CELL_SIZE}
[refinement]
size_array = "Wanted"
size_field = "field.vtp"
[patches]
patch_method = "Exact Fit"
[output]
mesh = "mesh.vtu"
""")
    # Boxes this coarse lose more than 1 % of the volume between bodies, which is a warning.
    assert subprocess.run([PROGRAM, str(folder / "task.toml")], capture_output=True).returncode in (0, 3)
    mesh = simple.XMLUnstructuredGridReader(FileName=[str(folder / "mesh.vtu")])
    assert output(mesh).GetNumberOfCells() == whole
