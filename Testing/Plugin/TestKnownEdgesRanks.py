"""On ranks that have a part each, lines are sharp edges and solids keep their boundaries, as on one rank."""

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from pipeline import producer
from solids import blocks, cylinder, numbered

RANKS = vtkMultiProcessController.GetGlobalController()
RANK, COUNT = RANKS.GetLocalProcessId(), RANKS.GetNumberOfProcesses()
assert COUNT > 1


def part_of(data):
    """Every second line and polygon, with its values."""
    part = vtkPolyData()
    part.SetPoints(data.GetPoints())
    part.SetFieldData(data.GetFieldData())
    part.GetCellData().CopyAllocate(data.GetCellData())
    kinds, cell, own = {"Lines": vtkCellArray(), "Polys": vtkCellArray()}, 0, 0
    for kind, mine in kinds.items():
        all = getattr(data, "Get" + kind)()
        for i in range(all.GetNumberOfCells()):
            if i % COUNT == RANK:
                ids = vtkIdList()
                all.GetCellAtId(i, ids)
                mine.InsertNextCell(ids)
                part.GetCellData().CopyData(data.GetCellData(), cell, own)
                own += 1
            cell += 1
    part.SetLines(kinds["Lines"]), part.SetPolys(kinds["Polys"])
    return part


def mesh_of(data, pieces, **settings):
    mesher = simple.CartesianMesher(Input=producer(data), CellSize=0.17, FeatureAngle=20, InPieces=pieces, **settings)
    filter = mesher.SMProxy.GetClientSideObject()
    filter.UpdatePiece(RANK, COUNT, 0)
    assert filter.GetErrorCode() == 0
    return filter.GetOutputDataObject(0)


def statistics(mesh):
    """Of the whole mesh, on every rank: exact sums."""
    fields = mesh.GetFieldData()
    names = fields.GetAbstractArray("BoundaryNames")
    return [[fields.GetArray(name).GetValue(i) for i in range(fields.GetArray(name).GetNumberOfTuples())]
            for name in ("Cells", "Points", "Polyhedra", "Patches", "BoundaryFaceCounts")] + \
        [names.GetValue(i) for i in range(names.GetNumberOfValues())]


def solid(known):
    names = {3: "inlet", 4: "outlet", 5: "wall"}
    return numbered(cylinder(known), names, lambda middle: {0: 3, 2: 4}.get(middle[2], 5), "pipe")


for wrap in (lambda data: data), (lambda data: blocks({"a block": data})):
    distributed = statistics(mesh_of(wrap(part_of(solid(True))), True))
    whole = statistics(mesh_of(wrap(solid(True)), True))
    other = statistics(mesh_of(wrap(solid(False)), True))
    assert distributed == whole != other, (distributed, whole, other)
    assert sorted(whole[-3:]) == ["inlet", "outlet", "wall"], whole

# The points of this rank's piece are among those of the whole mesh.
alone = mesh_of(solid(True), False)
mine = vtk_to_numpy(mesh_of(part_of(solid(True)), True).GetPoints().GetData())
if RANK == 0:
    points = {tuple(point) for point in vtk_to_numpy(alone.GetPoints().GetData())}
    assert len(mine) > 100 and all(tuple(point) in points for point in mine)
print(f"rank {RANK}:", whole)
