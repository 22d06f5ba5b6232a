"""Finite Volume Quality of our meshes: its numbers are those of its arrays and of the mesher's own
statistics, cells that fail can be selected, and any reader's mesh will do."""

import pathlib
import tempfile

import foam
import numpy as np
from measure import faces_of_polydata, points_of
from paraview import simple
from pipeline import Messages, output, read
from polyhedra import keep_polyhedra
from vtkmodules.util.numpy_support import vtk_to_numpy

CODES = {"Volume": 1, "Openness": 2, "OpenEdges": 4, "BoundaryAngle": 8, "InnerAngle": 16,
         "StarTriangulation": 32, "NonOrthogonality": 64, "Skewness": 128, "FaceWeight": 256,
         "VolumeRatio": 512, "Determinant": 1024, "AspectRatio": 2048, "TetQuality": 4096}
SMALL_IS_WORSE = {"Volume", "StarTriangulation", "FaceWeight", "VolumeRatio", "Determinant",
                  "TetQuality"}


def values(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def field(data, name):
    return data.GetFieldData().GetArray(name).GetValue(0)


def check(name, mesher):
    quality = simple.FiniteVolumeQuality(Input=mesher)
    mesh, faces = output(quality, 0), output(quality, 1)
    made = output(mesher)
    for measure in "BoundaryAngle", "InnerAngle", "Openness", "Volume":
        said, found = (field(data, measure + "Failures") for data in (made, mesh))
        assert said == found, f"{name}: the mesher says {said} {measure}Failures, it is {found}"
    failures = values(mesh, "Failures")
    for measure, code in CODES.items():
        found = values(mesh, measure)
        worst = "Min" + measure if measure in SMALL_IS_WORSE else "Max" + measure
        assert field(mesh, worst) == (found.min() if worst.startswith("Min") else found.max()), worst
        assert field(mesh, measure + "Failures") == np.count_nonzero(failures & code), measure
    neighbour = values(faces, "Neighbour")
    inner = neighbour >= 0
    for measure in "StarTriangulation", "NonOrthogonality", "Skewness", "FaceWeight", "VolumeRatio":
        worse = np.minimum if measure in SMALL_IS_WORSE else np.maximum
        worst = np.full(len(failures), np.inf if measure in SMALL_IS_WORSE else -np.inf)
        worse.at(worst, values(faces, "Owner"), values(faces, measure))
        worse.at(worst, neighbour[inner], values(faces, measure)[inner])
        assert (worst == values(mesh, measure)).all(), f"{name}: {measure} is not the faces' worst"
    assert field(mesh, "FailingCells") == np.count_nonzero(failures)
    assert field(mesh, "Cells") == mesh.GetNumberOfCells()
    assert np.count_nonzero(~inner) == field(made, "BoundaryFaces")
    print(name, {m: int(field(mesh, m + "Failures")) for m in CODES})

    failing = simple.Threshold(Input=quality, Scalars=["CELLS", "Failures"],
        ThresholdMethod="Above Upper Threshold", UpperThreshold=1)
    assert output(failing).GetNumberOfCells() == field(mesh, "FailingCells")
    return mesh


cow = read("cino_spot.obj")
plain = check("cow, not shaped", simple.CartesianMesher(Input=cow, CellSize=0.1,
    SmallCells="Remove", SplitConcaveCells=0))
assert field(plain, "BoundaryAngleFailures") > 0
mesh = check("cow", simple.CartesianMesher(Input=cow, CellSize=0.1))

# The same mesh, from OpenFOAM's files, in single precision.
with tempfile.TemporaryDirectory() as folder:
    case = foam.save(simple.CartesianMesher(Input=cow, CellSize=0.1), pathlib.Path(folder))
    reader = simple.OpenFOAMReader(FileName=str(case / "case.foam"))
    keep_polyhedra(reader)
    again = output(simple.FiniteVolumeQuality(Input=simple.MergeBlocks(Input=reader)))
order = np.argsort(values(mesh, "CellId"))  # of the files
for measure, tolerance in ("Volume", 1e-6), ("OpenEdges", 0), ("NonOrthogonality", 0.01):
    difference = np.abs(values(again, measure) - values(mesh, measure)[order]).max()
    assert difference <= tolerance, f"{measure} differs by {difference}"

# IP patches: faces that met at an angle are one in cells that nothing else mended. With them the boundary
# still is closed (equation 2), and its vectors and centres are those of its polygons.
mesher = simple.CartesianMesher(Input=read("tm_featuretype_occ.stl"), CellSize=4)
boundary = output(mesher, 1)
centres, areas, joined = (values(boundary, name) for name in ("FaceCentre", "FaceArea", "IPPatch"))
assert joined.any(), "there are no IP patches"
assert np.abs(areas.sum(axis=0)).max() < 1e-9 * np.linalg.norm(areas, axis=1).sum()
sizes = output(simple.CellSize(Input=simple.OutputPort(mesher, 1), ComputeLength=0, ComputeVolume=0))
assert (np.linalg.norm(areas, axis=1) <= values(sizes, "Area") * (1 + 1e-9)).all()
assert field(output(mesher), "BoundaryAngleFailures") == 0
faces = faces_of_polydata(boundary, np.zeros(len(joined), int))
points = points_of(boundary)[faces.corners]
middles = (faces.sums(points) / faces.size[:, None])[faces.face]
following = points_of(boundary)[faces.corners[faces.next]]
triangles = np.cross(points - middles, following - middles) / 2
weights = np.linalg.norm(triangles, axis=1)[:, None]
lengths = np.sqrt(np.linalg.norm(areas, axis=1))
assert (np.abs(areas - faces.sums(triangles)).max(axis=1) < 1e-9 * lengths**2).all()
own_centres = faces.sums(weights * (points + following + middles) / 3) / faces.sums(weights)
assert (np.abs(centres - own_centres).max(axis=1) < 1e-9 * lengths).all()
print(int(joined.sum()), "IP patches of", len(joined), "boundary faces")

# A mesher that has refused its surface has no cells to measure.
box = simple.Triangulate(Input=simple.Box())
refused = simple.CartesianMesher(Input=box, CellSize=-1)
with Messages():
    assert output(simple.FiniteVolumeQuality(Input=simple.OutputPort(refused, 0))).GetNumberOfCells() == 0
