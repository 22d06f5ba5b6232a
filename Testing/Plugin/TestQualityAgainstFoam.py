"""Finite Volume Quality says of meshes what OpenFOAM's checkMesh says, cell by cell."""

import pathlib
import re
import tempfile

import numpy as np
from openfoam import check_mesh, read_field, read_set, write_case
from paraview import simple
from pipeline import output, producer
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints

# Ours, OpenFOAM's, and by how much they may differ, relative to 1 + the value. An arc cosine near 1
# has half the digits.
FIELDS = [
    ("Volume", "cellVolume", 1e-12),
    ("NonOrthogonality", "nonOrthoAngle", 2e-6),
    ("Skewness", "skewness", 1e-11),
    ("VolumeRatio", "cellVolumeRatio", 1e-12),
    ("Determinant", "cellDeterminant", 1e-12),
    ("AspectRatio", "aspectRatio", 1e-12),
    ("TetQuality", "minTetVolume", 1e-12),
]

SETS = [
    ("Mesh", "Volume", "zeroVolumeCells"),
    ("Mesh", "Determinant", "underdeterminedCells"),
    ("Mesh", "AspectRatio", "highAspectRatioCells"),
    ("Mesh", "Openness", "nonClosedCells"),
    ("Faces", "NonOrthogonality", "nonOrthoFaces"),
    ("Faces", "Skewness", "skewFaces"),
    ("Faces", "FaceWeight", "lowWeightFaces"),
    ("Faces", "VolumeRatio", "lowVolRatioFaces"),
]

CODES = {"Volume": 1, "Openness": 2, "NonOrthogonality": 64, "Skewness": 128, "FaceWeight": 256,
         "VolumeRatio": 512, "Determinant": 1024, "AspectRatio": 2048}


def values(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def shaken(grid, by):
    """The grid with its points moved at random: faces are warped, angles are all different."""
    xyz = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    xyz += np.random.default_rng(1).uniform(-by, by, xyz.shape)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(xyz, deep=True))
    copy = grid.NewInstance()
    copy.ShallowCopy(grid)
    copy.SetPoints(points)
    return producer(copy)


def compare(name, mesh):
    quality = simple.FiniteVolumeQuality(Input=mesh)
    cells, faces = output(quality, 0), output(quality, 1)
    count = cells.GetNumberOfCells()
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder) / "case"
        write_case(case, faces)
        said = check_mesh(case, "-allGeometry", "-allTopology", "-writeAllFields")
        for ours, theirs, tolerance in FIELDS:
            # Beyond a billion, an aspect ratio is one of rounding errors.
            mine, foam = (np.minimum(v, 1e9)
                          for v in (values(cells, ours), read_field(case, theirs, count)))
            error = np.max(np.abs(mine - foam) / (1 + np.abs(foam)))
            print(f"{name}: {ours} up to {np.max(foam):.6g}, differs by {error:.2g}")
            assert error <= tolerance, f"{name}: {ours} differs from {theirs} by {error}"
        for port, measure, theirs in SETS:
            failures = values(cells if port == "Mesh" else faces, "Failures")
            mine = set(np.flatnonzero(failures & CODES[measure]))
            foam = read_set(case, theirs)
            print(f"{name}: {len(foam)} {theirs}")
            assert mine == foam, f"{name}: {theirs} has {len(foam)} members, {measure} {len(mine)}"
    # What is not in a field, as far as it is printed.
    openness = re.search(r"Max cell openness = (\S+) OK", said)
    if openness: # not printed beside high aspect ratios
        assert abs(values(cells, "Openness").max() - float(openness[1])) < 1e-12
    weight = float(re.search(r"Face interpolation weight : minimum: (\S+) ", said)[1])
    assert abs(values(cells, "FaceWeight").min() - weight) < 1e-12


sphere = simple.Sphere(ThetaResolution=24, PhiResolution=16)
compare("sphere", simple.CartesianMesher(Input=sphere, CellSize=0.09))
refined = simple.CartesianMesher(Input=sphere, CellSize=0.3, RefinementDepth=2, SmallCellRatio=0.0)
compare("refined sphere", refined)
compare("shaken sphere", shaken(output(simple.CartesianMesher(Input=sphere, CellSize=0.2)), 0.03))
turned_over = shaken(output(simple.CartesianMesher(Input=sphere, CellSize=0.2)), 0.15)
compare("sphere with cells turned over", turned_over)
for kind in "Tet", "Hex", "Wedge", "Pyramid":
    source = simple.UnstructuredCellTypes(CellType=kind, BlocksDimensions=[4, 3, 3])
    compare(kind, shaken(output(source), 0.1))
