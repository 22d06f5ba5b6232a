"""Finite Volume Quality says of meshes what OpenFOAM's checkMesh says, cell by cell."""

import pathlib
import re
import tempfile

import foam
import numpy as np
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


def write_case(folder, faces):
    """Not with our writer: it would turn cells and refuse faces that do not fit."""
    points = vtk_to_numpy(faces.GetPoints().GetData())
    corners = np.split(vtk_to_numpy(faces.GetPolys().GetConnectivityArray()),
        vtk_to_numpy(faces.GetPolys().GetOffsetsArray())[1:-1])
    owner, neighbour = values(faces, "Owner"), values(faces, "Neighbour")
    inner = np.count_nonzero(neighbour >= 0)
    for name, kind, rows in (
            ("points", "vectorField", ["({!r} {!r} {!r})".format(*p) for p in points.tolist()]),
            ("faces", "faceList", [f"{len(c)}({' '.join(map(str, c))})" for c in corners]),
            ("owner", "labelList", map(str, owner)),
            ("neighbour", "labelList", map(str, neighbour[:inner])),
            ("boundary", "polyBoundaryMesh",
             [f"walls {{ type wall; nFaces {len(owner) - inner}; startFace {inner}; }}"])):
        rows = list(rows)
        foam.write(folder, f"constant/polyMesh/{name}",
            f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)", kind)
    foam.control(folder, 1, "writePrecision 17;")
    foam.write(folder, "system/fvSchemes", """ddtSchemes {} gradSchemes {} divSchemes {}
        laplacianSchemes {} interpolationSchemes {} snGradSchemes {}
        wallDist { method meshWave; }""")
    foam.write(folder, "system/fvSolution", "")


def read_set(folder, name):
    """Numbers of the faces or cells in a set that checkMesh made, if it did."""
    path = folder / "constant/polyMesh/sets" / name
    if not path.exists():
        return set()
    body = path.read_text().split("\n}\n", 1)[1]
    return set(map(int, re.search(r"\(([^)]*)\)", body)[1].split()))


def compare(name, mesh):
    quality = simple.FiniteVolumeQuality(Input=mesh)
    cells, faces = output(quality, 0), output(quality, 1)
    with tempfile.TemporaryDirectory() as folder:
        case = pathlib.Path(folder)
        write_case(case, faces)
        said = foam.CheckMesh(case, "-allGeometry", "-allTopology", "-writeAllFields").text
        for measure, field, tolerance in FIELDS:
            # Beyond a billion, an aspect ratio is one of rounding errors.
            ours = np.minimum(values(cells, measure), 1e9)
            theirs = np.minimum(foam.read_field(case, "constant", field), 1e9)
            error = np.max(np.abs(ours - theirs) / (1 + np.abs(theirs)))
            print(f"{name}: {measure} up to {np.max(theirs):.6g}, differs by {error:.2g}")
            assert error <= tolerance, f"{name}: {measure} differs from {field} by {error}"
        for port, measure, members in SETS:
            failures = values(cells if port == "Mesh" else faces, "Failures")
            ours = set(np.flatnonzero(failures & CODES[measure]))
            theirs = read_set(case, members)
            print(f"{name}: {len(theirs)} {members}")
            assert ours == theirs, f"{name}: {len(theirs)} {members}, {len(ours)} by {measure}"
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
