"""On several ranks each makes its part of the mesh; together they are that of one rank."""

import pathlib
import tempfile

import numpy as np
from cartesianmesher.vtkCartesianMesherFilters import vtkCartesianMesher
from paraview import servermanager, simple
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkMultiBlockDataGroupFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import pieces
from pipeline import DATA, read, redistributes

RANKS = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
assert RANKS > 1


def on_one_rank(source, size, depth, regions=0, layers=0):
    mesher = vtkCartesianMesher()
    mesher.SetLayers(layers)
    mesher.SetRegionsFrom(regions)
    mesher.SetInputConnection(source.GetOutputPort())
    mesher.SetCellSize(size)
    mesher.SetRefinementDepth(depth)
    mesher.Update()
    return mesher


def field(proxy, name):
    """A number of the mesh's field data: the same on all ranks."""
    proxy.UpdatePipeline()
    data = proxy.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    return data.GetFieldData().GetArray(name).GetValue(0)


def boundary_faces(mesher):
    mesher.UpdatePipeline()
    return servermanager.OutputPort(mesher, 1).GetDataInformation().GetNumberOfCells()


def assert_same(mesher, alone):
    whole = alone.GetOutputDataObject(0)
    fields = whole.GetFieldData()
    for name in "Cells", "Points", "BoundaryFaces", "Polyhedra", "Patches":
        assert field(mesher, name) == fields.GetArray(name).GetValue(0), name
    assert boundary_faces(mesher) == alone.GetOutputDataObject(1).GetNumberOfCells()
    with tempfile.TemporaryDirectory() as folder:
        simple.SaveData(f"{folder}/mesh.pvtu", proxy=mesher, DataMode="Binary")
        files = sorted(pathlib.Path(folder).glob("**/*.vtu"))
        parts = [pieces.load(file) for file in files]
        cells = [pieces.own_cells(part).sum() for part in parts]
        assert len(parts) == RANKS and min(cells) > 0.4 * max(cells), f"uneven: {cells}"
        pieces.assert_union(whole, parts)


path = str(DATA / "kcl_exhaust_header_lumens.stl")
stl = vtkSTLReader()
stl.SetFileName(path)
stl.ScalarTagsOn()
# A file that the first rank reads, and a sphere that every rank makes a piece of.
for source, alone, size in ((read("kcl_exhaust_header_lumens.stl"), stl, 10.0),
                            (simple.Sphere(), vtkSphereSource(), 0.08)):
    for depth in 0, 1:
        mesher = simple.CartesianMesher(Input=source, CellSize=size, RefinementDepth=depth)
        expected = on_one_rank(alone, size, depth)
        assert_same(mesher, expected)

    # The three filters are left to the first rank.
    boxer = simple.CartesianBoxer(Input=source, CellSize=size, RefinementDepth=depth)
    patcher = simple.Patcher(Input=source, Boxes=boxer)
    assembler = simple.CellAssembler(Input=boxer, Patches=patcher)
    assert field(assembler, "Cells") == field(mesher, "Cells")

    # Asked for its second output only.
    faces = simple.Threshold(Input=simple.OutputPort(
            simple.CartesianMesher(Input=source, CellSize=size, RefinementDepth=depth),
            "Boundary"),
        Scalars=["CELLS", "OwnerCell"], LowerThreshold=0, UpperThreshold=1e9)
    faces.UpdatePipeline()
    found = faces.GetDataInformation().GetNumberOfCells()
    assert found == boundary_faces(mesher), f"Boundary alone: {found} faces"

# Layers: each rank makes the whole mesh, and keeps its part.
assert_same(simple.CartesianMesher(Input=read("kcl_exhaust_header_lumens.stl"), CellSize=10, Layers=2),
            on_one_rank(stl, 10.0, 0, layers=2))

# Several regions: a ball in a box.
block = simple.Triangulate(Input=simple.Box(XLength=0.7, YLength=0.8, ZLength=2))
both = simple.GroupDatasets(Input=[simple.Sphere(Radius=0.3), block], BlockNames=["ball", "block"])
group, ball, box, divided = vtkMultiBlockDataGroupFilter(), vtkSphereSource(), vtkCubeSource(), vtkTriangleFilter()
ball.SetRadius(0.3)
box.SetXLength(0.7), box.SetYLength(0.8), box.SetZLength(2)
divided.SetInputConnection(box.GetOutputPort())
group.AddInputConnection(ball.GetOutputPort())
group.AddInputConnection(divided.GetOutputPort())
expected = on_one_rank(group, 0.05, 0, 1)
mesher = simple.CartesianMesher(Input=both, RegionsFrom="Blocks", CellSize=0.05)
assert_same(mesher, expected)
volumes = [filter.GetOutputDataObject(0).GetFieldData().GetArray("RegionVolumes")
           for filter in (mesher.SMProxy.GetClientSideObject(), expected)]
assert np.allclose(*([array.GetValue(i) for i in range(2)] for array in volumes), rtol=1e-12)
between = servermanager.OutputPort(mesher, 3).GetDataInformation().GetNumberOfCells()
assert between == expected.GetOutputDataObject(3).GetNumberOfCells() > 0

# A surface that each rank has a part of; its triangles come in another order.
spread = simple.ProgrammableFilter(Input=read("cino_spot.obj"), OutputDataSetType="vtkPolyData", Script="""
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController
ranks = vtkMultiProcessController.GetGlobalController()
mine = vtkCellArray()
polygons = inputs[0].VTKObject.GetPolys()
for i in range(ranks.GetLocalProcessId(), polygons.GetNumberOfCells(), ranks.GetNumberOfProcesses()):
    ids = vtkIdList()
    polygons.GetCellAtId(i, ids)
    mine.InsertNextCell(ids)
output.VTKObject.SetPoints(inputs[0].VTKObject.GetPoints())
output.VTKObject.SetPolys(mine)
""")
parts = simple.CartesianMesher(Input=spread)
whole = simple.CartesianMesher(Input=read("cino_spot.obj"))
for name in "Cells", "BoxesInside", "BoxesIntersected":
    assert field(parts, name) == field(whole, name), name

# What one rank would say is wrong all say, and none waits for another.
refused = simple.CartesianMesher(Input=simple.Sphere(), CellSize=-1)
refused.UpdatePipeline()
assert refused.GetDataInformation().GetNumberOfCells() == 0

obj = vtkOBJReader()
obj.SetFileName(str(DATA / "cino_spot.obj"))
# Ghost cells close the gaps between parts: the quality is that of the mesh on one rank.
MEASURES = "Cells", "TotalVolume", "MinVolume", "MaxConcavity", "MaxNonOrthogonality", "MinFaceWeight"
mesher = simple.CartesianMesher(Input=read("cino_spot.obj"), CellSize=0.05)
with tempfile.TemporaryDirectory() as folder:
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(f"{folder}/mesh.vtu")
    writer.SetDataModeToBinary()
    writer.SetInputDataObject(on_one_rank(obj, 0.05, 0).GetOutputDataObject(0))
    writer.Write()
    meshes = [simple.OpenDataFile(writer.GetFileName()), mesher]
    if redistributes(folder):
        meshes.append(simple.RedistributeDataSet(Input=mesher))
    summaries = [[field(simple.FiniteVolumeQuality(Input=mesh), name) for name in MEASURES] for mesh in meshes]
assert np.allclose(summaries, summaries[0], rtol=1e-9, atol=0), summaries
print(RANKS, "ranks:", summaries[0])
