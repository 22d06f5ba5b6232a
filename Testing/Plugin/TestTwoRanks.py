"""On two ranks the mesh is made once, and it is that of one rank."""

from cartesianmesher.vtkCartesianMesherFilters import vtkCartesianMesher
from paraview import servermanager, simple
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from pipeline import DATA, read

assert vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses() == 2


def counts(mesher):
    """Cells of mesh and boundary, points of the mesh."""
    mesh, boundary = (mesher.GetOutputDataObject(port) for port in (0, 1))
    return mesh.GetNumberOfCells(), boundary.GetNumberOfCells(), mesh.GetNumberOfPoints()


def on_one_rank(source):
    mesher = vtkCartesianMesher()
    mesher.SetInputConnection(source.GetOutputPort())
    mesher.Update()
    return counts(mesher)


def on_two_ranks(filter):
    filter.UpdatePipeline()
    mesh, boundary = (servermanager.OutputPort(filter, port).GetDataInformation() for port in (0, 1))
    return mesh.GetNumberOfCells(), boundary.GetNumberOfCells(), mesh.GetNumberOfPoints()


path = str(DATA / "kcl_exhaust_header_lumens.stl")
stl = vtkSTLReader()
stl.SetFileName(path)
stl.ScalarTagsOn()
# A file that the first rank reads, and a sphere that every rank makes a piece of.
for source, alone in (read("kcl_exhaust_header_lumens.stl"), stl), (simple.Sphere(), vtkSphereSource()):
    expected = on_one_rank(alone)
    boxer = simple.CartesianBoxer(Input=source)
    patcher = simple.Patcher(Input=source, Boxes=boxer)
    for filter in simple.CartesianMesher(Input=source), simple.CellAssembler(Input=boxer, Patches=patcher):
        found = on_two_ranks(filter)
        assert found == expected, f"{filter.GetXMLLabel()}: {found} instead of {expected}"
        print(filter.GetXMLLabel(), found)

    # Asked for its second output only.
    faces = simple.Threshold(Input=simple.OutputPort(simple.CartesianMesher(Input=source), "Boundary"),
        Scalars=["CELLS", "OwnerCell"], LowerThreshold=0, UpperThreshold=1e9)
    faces.UpdatePipeline()
    found = faces.GetDataInformation().GetNumberOfCells()
    assert found == expected[1], f"Boundary alone: {found} faces instead of {expected[1]}"

# Each rank measures its part of the mesh; the sums are of all of them.
mesher = simple.CartesianMesher(Input=simple.Sphere())
summaries = []
for mesh in mesher, simple.RedistributeDataSet(Input=mesher):
    quality = simple.FiniteVolumeQuality(Input=mesh)
    quality.UpdatePipeline()
    data = quality.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    summaries.append([data.GetFieldData().GetArray(name).GetValue(0)
                      for name in ("Cells", "TotalVolume", "MinVolume", "MaxConcavity")])
whole, parts = summaries
assert data.GetNumberOfCells() < parts[0] == on_two_ranks(mesher)[0], parts
assert all(abs(a - b) <= 1e-12 * abs(a) for a, b in zip(whole, parts)), summaries
