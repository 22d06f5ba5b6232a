"""On ranks, a Size Field asks for the same boxes on all; what needs the whole mesh is made on each, and cut."""

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

RANKS = vtkMultiProcessController.GetGlobalController()
RANK, COUNT = RANKS.GetLocalProcessId(), RANKS.GetNumberOfProcesses()

cube = simple.Triangulate(Input=simple.Box())
image = simple.Transform(Input=simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4]))
image.Transform.Scale = [0.125, 0.125, 0.125]
field = simple.Calculator(Input=image, AttributeType="Point Data", ResultArrayName="Wanted",
    Function="0.15 - 0.2 * coordsX")


def cells(pieces=True, **properties):
    """Of this rank's piece, and of all by the statistics; the error code."""
    mesher = simple.CartesianMesher(Input=cube, CellSize=0.2, InPieces=pieces, **properties)
    filter = mesher.SMProxy.GetClientSideObject()
    filter.UpdatePiece(RANK, COUNT, 0)
    mesh = filter.GetOutputDataObject(0)
    total = mesh.GetFieldData().GetArray("Cells")
    return mesh.GetNumberOfCells(), int(total.GetValue(0)) if total else 0, filter.GetErrorCode()


mine, total, code = cells(SizeField=field, SizeArray="Wanted")
whole, _, _ = cells(pieces=False, SizeField=field, SizeArray="Wanted")
print(f"rank {RANK}: {mine} of {total} cells, {whole} in one piece")
assert code == 0 and 0 < mine < total and (RANK > 0 or whole == total)

for needed in {"KeepPoints": [0, 0, 0]}, {"CellBudget": 500}, {"Layers": 2}:
    mine, total, code = cells(**needed)
    whole, _, _ = cells(pieces=False, **needed)
    assert code == 0 and 0 < mine < total and (RANK > 0 or whole == total), (needed, mine, total, whole)
