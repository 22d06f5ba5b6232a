"""Regions From: cells of two regions share the faces between them; names, volumes, interfaces."""

import math

import pathlib
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet


def box(low, high):
    source = simple.Box(XLength=high[0] - low[0], YLength=high[1] - low[1],
                        ZLength=high[2] - low[2],
                        Center=[(a + b) / 2 for a, b in zip(low, high)])
    return simple.Triangulate(Input=source)


def outputs(mesher):
    mesher.UpdatePipeline()
    filter = mesher.GetClientSideObject()
    return [filter.GetOutputDataObject(port) for port in (0, 1, 3)]


def texts(data, name):  # not "strings": a ProgrammableFilter puts all of NumPy here, and NumPy 2 has that
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def volumes(data):
    return vtk_to_numpy(data.GetFieldData().GetArray("RegionVolumes"))


# Blocks: a duct whose ends are flush with the solid around it. The first region keeps the volume.
assembly = simple.GroupDatasets(Input=[box([-0.25, -0.25, -1], [0.25, 0.25, 1]),
                                       box([-1, -1, -1], [1, 1, 1])],
                                BlockNames=["gas", "solid"])
mesher = simple.CartesianMesher(Input=assembly, RegionsFrom="Blocks", CellSize=0.17,
                                PatchMethod="Exact Fit")
mesh, boundary, interfaces = outputs(mesher)
assert texts(mesh, "RegionNames") == ["gas", "solid"], texts(mesh, "RegionNames")
for actual, expected in zip(volumes(mesh), [0.5, 7.5]):
    assert math.isclose(actual, expected, rel_tol=1e-8), volumes(mesh)
region = vtk_to_numpy(mesh.GetCellData().GetArray("Region"))
number = vtk_to_numpy(mesh.GetCellData().GetArray("CellId"))
regionOf = dict(zip(number, region))
assert set(region) == {1, 2}

data = interfaces.GetCellData()
assert interfaces.GetNumberOfCells() > 0
assert texts(interfaces, "InterfaceNames") == ["gas_to_solid"]
for side in "Owner", "Neighbour":
    cells = vtk_to_numpy(data.GetArray(side + "Cell"))
    regions = vtk_to_numpy(data.GetArray(side + "Region"))
    assert [regionOf[cell] for cell in cells] == list(regions), side
assert set(vtk_to_numpy(data.GetArray("OwnerRegion"))) == {1}
assert set(vtk_to_numpy(data.GetArray("NeighbourRegion"))) == {2}

# As files with a block for each region: its cells, in their order, and the same points on both sides.
with tempfile.TemporaryDirectory() as folder:
    for suffix in "vtm", "vtpc":
        file = f"{folder}/{suffix}/mesh.{suffix}"
        pathlib.Path(file).parent.mkdir()
        simple.SaveData(file, simple.OutputPort(mesher, "Mesh"))
        reader = simple.OpenDataFile(file)
        reader.UpdatePipeline()
        blocks = reader.GetClientSideObject().GetOutputDataObject(0)
        assert blocks.IsA("vtkMultiBlockDataSet" if suffix == "vtm" else "vtkPartitionedDataSetCollection")
        points = []
        for i, name in enumerate(("gas", "solid")):
            assert blocks.GetMetaData(i).Get(vtkCompositeDataSet.NAME()) == name
            block = blocks.GetBlock(i) if suffix == "vtm" else blocks.GetPartition(i, 0)
            assert np.array_equal(vtk_to_numpy(block.GetCellData().GetArray("CellId")), number[region == i + 1])
            points.append(set(map(tuple, vtk_to_numpy(block.GetPoints().GetData()))))
        assert points[0] & points[1] == set(map(tuple, vtk_to_numpy(interfaces.GetPoints().GetData())))

# None of them is exterior, and boundary faces tell whose they are.
exterior = {tuple(sorted(boundary.GetPointData().GetArray("MeshPointId").GetValue(
    boundary.GetCell(i).GetPointId(k)) for k in range(boundary.GetCell(i).GetNumberOfPoints())))
    for i in range(boundary.GetNumberOfCells())}
for i in range(interfaces.GetNumberOfCells()):
    cell = interfaces.GetCell(i)
    points = tuple(sorted(interfaces.GetPointData().GetArray("MeshPointId").GetValue(
        cell.GetPointId(k)) for k in range(cell.GetNumberOfPoints())))
    assert points not in exterior
owners = vtk_to_numpy(boundary.GetCellData().GetArray("OwnerCell"))
assert [regionOf[cell] for cell in owners] == list(
    vtk_to_numpy(boundary.GetCellData().GetArray("Region")))
areas = dict(zip(texts(mesh, "BoundaryNames"),
                 vtk_to_numpy(mesh.GetFieldData().GetArray("BoundaryAreas"))))
assert math.isclose(areas["gas"], 0.5, rel_tol=1e-8), areas
assert math.isclose(areas["solid"], 23.5, rel_tol=1e-8), areas

# Array: the same bodies as one surface.
whole = simple.MergeBlocks(Input=assembly, OutputDataSetType="Polygonal Mesh", MergePoints=0)
marked = simple.ProgrammableFilter(Input=whole, Script="""
import numpy
part = numpy.arange(inputs[0].GetNumberOfCells()) >= 12
output.CellData.append(numpy.where(part, 40, 7), "Part")
""")
other = simple.CartesianMesher(Input=marked, RegionsFrom="Array", RegionArray="Part",
                               CellSize=0.17, PatchMethod="Exact Fit")
same = outputs(other)[0]
assert texts(same, "RegionNames") == ["region_7", "region_40"], texts(same, "RegionNames")
assert (volumes(same) == volumes(mesh)).all()
assert same.GetNumberOfCells() == mesh.GetNumberOfCells()

# In pieces it is the same.
wholeCells = mesh.GetNumberOfCells()
for pieces in 2, 3:
    cells = 0
    for piece in range(pieces):
        filter = mesher.GetClientSideObject()
        filter.UpdatePiece(piece, pieces, 0)
        part = filter.GetOutputDataObject(0)
        ids = vtk_to_numpy(part.GetCellData().GetArray("CellId"))
        regions = vtk_to_numpy(part.GetCellData().GetArray("Region"))
        assert [regionOf[i] for i in ids] == list(regions), (pieces, piece)
        cells += part.GetNumberOfCells()
    assert cells == wholeCells, (cells, wholeCells)

# Of bodies that pass through each other, the first keeps the volume.
mixed = simple.GroupDatasets(Input=[box([0, 0, 0], [1, 1, 1]), box([0.5, 0.3, 0.2], [2, 2, 2])],
                             BlockNames=["a", "b"])
crossing = simple.CartesianMesher(Input=mixed, RegionsFrom="Blocks", CellSize=0.3)
crossing.UpdatePipeline()
assert crossing.GetClientSideObject().GetErrorCode() == 0
volumes = vtk_to_numpy(crossing.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray("RegionVolumes"))
expected = 1, 1.5 * 1.7 * 1.8 - 0.5 * 0.7 * 0.8
assert max(abs(volumes - expected)) < 1e-5, volumes


# Curved walls of other triangles become one within the tolerance, and are listed as defects.
def cylinder(corners, radius, height=2):
    source = simple.Cylinder(Resolution=corners, Radius=radius, Height=height)
    return simple.Triangulate(Input=simple.Clean(Input=source))


rod, ball = cylinder(24, 0.5), simple.Sphere(Radius=0.25, ThetaResolution=16, PhiResolution=16)
outer = simple.Sphere(Radius=0.25, ThetaResolution=23, PhiResolution=13)
hollow = simple.AppendGeometry(Input=[rod, outer])
two = simple.GroupDatasets(Input=[ball, hollow], BlockNames=["ball", "rod"])
mesher = simple.CartesianMesher(Input=two, RegionsFrom="Blocks", CellSize=0.1, ContactTolerance=0.02)
mesh = outputs(mesher)[0]
defects = mesher.GetClientSideObject().GetOutputDataObject(2)
data = defects.GetCellData()
assert set(vtk_to_numpy(data.GetArray("DefectKind"))) == {12}
count = outer.GetDataInformation().GetNumberOfCells()
assert defects.GetNumberOfCells() == count, (defects.GetNumberOfCells(), count)
width = vtk_to_numpy(data.GetArray("Width"))
assert (width == width[0]).all() and 0.001 < width[0] < 0.02, width
assert defects.GetFieldData().GetArray("TrianglesOfClosedContacts").GetValue(0) == count
first = ball.GetDataInformation().GetNumberOfCells()
rodCells = rod.GetDataInformation().GetNumberOfCells()
assert set(vtk_to_numpy(data.GetArray("SurfaceCell"))) == set(
    range(first + rodCells, first + rodCells + count))
assert mesh.GetNumberOfCells() > 0
# Without one they are cut along each other, and slivers are left outside of both.
loose = simple.CartesianMesher(Input=two, RegionsFrom="Blocks", CellSize=0.1, PatchMethod="Exact Fit")
assert outputs(loose)[0].GetNumberOfCells() > 0 and loose.GetClientSideObject().GetErrorCode() == 0
