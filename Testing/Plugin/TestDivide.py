"""Divide Polyhedra and Slice Polyhedra: what ParaView makes of meshes with them, exactly."""

import pathlib
import random
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter

from pipeline import DATA

folder = pathlib.Path(tempfile.mkdtemp())


def fetched(source, port=0):
    source.UpdatePipeline()
    return servermanager.Fetch(source, idx=port) if port else servermanager.Fetch(source)


def array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def field(data, name):
    return data.GetFieldData().GetArray(name).GetValue(0)


def volumes(source):
    return array(fetched(simple.FiniteVolumeQuality(Input=source)), "Volume")


def sizes(data, what):
    """What VTK takes the cells' sizes for."""
    measure = vtkCellSizeFilter()
    measure.SetInputData(data)
    measure.Update()
    return vtk_to_numpy(measure.GetOutput().GetCellData().GetArray(what))


def areas(data):
    """Of polygons, also concave ones."""
    points, polygons = vtk_to_numpy(data.GetPoints().GetData()), data.GetPolys()
    first, corners = (vtk_to_numpy(part) for part in (polygons.GetOffsetsArray(), polygons.GetConnectivityArray()))
    polygon = np.repeat(np.arange(len(first) - 1), np.diff(first))
    after = np.arange(1, len(corners) + 1)
    after[first[1:] - 1] = first[:-1]
    origin = points[corners[first[:-1]]][polygon]
    parts = np.cross(points[corners] - origin, points[corners[after]] - origin) / 2
    return np.linalg.norm([np.bincount(polygon, parts[:, i], len(first) - 1) for i in range(3)], axis=0)


def sliced(source, origin, normal, **more):
    return fetched(simple.SlicePolyhedra(Input=source, Origin=list(origin), Normal=list(normal), **more))


def by_cell(data, values, count, of=None):
    cells = array(data, "OriginalCellId")
    return np.bincount(cells if of is None else of[cells], values, count)


random.seed(4)
header = simple.CartesianMesher(Input=simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl")), CellSize=14)
box = simple.Triangulate(Input=simple.Box(XLength=2))
layers = simple.CartesianMesher(Input=box, CellSize=0.2, Layers=3, RefinementBlocks=[0, 2, 0, 2, 0, 2, 1])
for mesher in header, layers:
    known = volumes(mesher)
    divided = simple.DividePolyhedra(Input=mesher)
    data = fetched(divided)
    original = array(data, "OriginalCellId")
    assert field(data, "CellsNotStarShaped") == data.GetFieldData().GetArray("NotStarShapedCells").GetNumberOfValues()
    assert {data.GetCellType(i) for i in range(data.GetNumberOfCells())} <= {10, 11, 12, 13, 14}
    parts = np.bincount(original, volumes(divided), len(known))
    assert np.abs(parts - known).max() < 1e-12 * known.sum()
    assert abs(sizes(data, "Volume").sum() / known.sum() - 1) < 1e-12
    # Cell data are those of the cell.
    mesh = fetched(mesher)
    for name in "Level", "Region", "VolumeFraction":
        assert (array(data, name) == array(mesh, name)[original]).all(), name
    # Conforming: its surface is the mesh's; each inner face is in two cells.
    quality = fetched(simple.FiniteVolumeQuality(Input=divided))
    assert field(quality, "OpenEdgesFailures") == 0
    surface = [areas(fetched(simple.Triangulate(Input=simple.ExtractSurface(Input=source)))).sum() for source in (divided,)]
    assert abs(surface[0] / field(quality, "BoundaryArea") - 1) < 1e-9, surface

    # Both halves of a clip; sections have the areas of the parts'.
    bounds = mesh.GetBounds()
    centre = [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]
    for normal in [1, 0, 0], [0.3, 0.5, -0.8]:
        halves = []
        for side in 0, 1:
            clip = simple.Clip(Input=divided, ClipType="Plane", Invert=side)
            clip.ClipType.Origin, clip.ClipType.Normal = centre, normal
            halves.append(sizes(fetched(clip), "Volume").sum())
        assert abs(sum(halves) / known.sum() - 1) < 1e-9, halves
    star = np.ones(len(known), bool)
    star[vtk_to_numpy(data.GetFieldData().GetArray("NotStarShapedCells"))] = False
    for i in range(20):
        point = mesh.GetPoint(random.randrange(mesh.GetNumberOfPoints())) if i % 2 else centre
        normal = [[1, 0, 0], [0, -1, 0], [0, 0, 1]][i % 3] if i < 6 else [random.gauss(0, 1) for _ in range(3)]
        section, of_parts = (sliced(source, point, normal) for source in (mesher, divided))
        if section.GetNumberOfCells() == 0:
            assert of_parts.GetNumberOfCells() == 0
            continue
        mine = by_cell(section, areas(section), len(known))
        theirs = by_cell(of_parts, areas(of_parts), len(known), original)
        assert np.abs(mine - theirs)[star].max() < 1e-12 * known.sum() ** (2 / 3), (point, normal)

# Linear fields stay linear, in the parts and on sections.
low, high = np.array([-900.0, -800, -700]), np.array([900.0, 1000, 600])
raised = simple.Elevation(Input=header, LowPoint=list(low), HighPoint=list(high))
for source in simple.DividePolyhedra(Input=raised), \
        simple.SlicePolyhedra(Input=raised, Origin=[75, 190, -130], Normal=[1, 2, 3]):
    data = fetched(source)
    places = vtk_to_numpy(data.GetPoints().GetData())
    values = vtk_to_numpy(data.GetPointData().GetArray("Elevation"))  # in single precision
    assert np.abs((places - low) @ (high - low) / ((high - low) @ (high - low)) - values).max() < 1e-6

# So contours of them are sections, and a line finds all of its points.
raised_parts = simple.DividePolyhedra(Input=raised)
way = high - low
level = float((np.array([75, 190, -130]) - low) @ way / (way @ way))
contour = simple.Contour(Input=raised_parts, ContourBy=["POINTS", "Elevation"], Isosurfaces=[level])
assert abs(areas(fetched(simple.Triangulate(Input=contour))).sum() / areas(sliced(header, low + level * way, way)).sum() - 1) < 1e-5
line = fetched(simple.PlotOverLine(Input=raised_parts, Point1=[0.1, 3, 0.2], Point2=[0.3, 60, 0.4]))  # in a tube
assert vtk_to_numpy(line.GetPointData().GetArray("vtkValidPointMask")).all()
places, values = vtk_to_numpy(line.GetPoints().GetData()), vtk_to_numpy(line.GetPointData().GetArray("Elevation"))
assert np.abs((places - low) @ way / (way @ way) - values).max() < 1e-6

# Integrate Variables is exact after it.
total = fetched(simple.IntegrateVariables(Input=simple.DividePolyhedra(Input=header)))
assert abs(array(total, "Volume")[0] / volumes(header).sum() - 1) < 1e-9

# Several planes; polygons know theirs. A plane that misses the mesh has none.
many = sliced(layers, [0, 0, 0], [0, 0, 2], Offsets=[-0.25, 0, 0.25, 7])
offsets = array(many, "PlaneOffset")
ends = fetched(layers).GetBounds()
cross_section = (ends[1] - ends[0]) * (ends[3] - ends[2])
assert sorted(set(offsets)) == [-0.25, 0, 0.25]
for offset in set(offsets):
    assert abs(areas(many)[offsets == offset].sum() - cross_section) < 1e-9
assert np.allclose(vtk_to_numpy(many.GetPoints().GetData())[:, 2].min(), -0.25)

# Other grids: VTK's own kinds stay whole, images and structured grids are cut.
wavelet = simple.Wavelet(WholeExtent=[0, 4, 0, 4, 0, 4])
assert abs(areas(sliced(wavelet, [2.5, 2.5, 2.5], [0, 0, 1])).sum() - 16) < 1e-12
whole = simple.AppendDatasets(Input=[wavelet])
assert fetched(simple.DividePolyhedra(Input=whole)).GetNumberOfCells() == 64

# OpenFOAM's own reader.
simple.SaveData(str(folder / "case.foam"), header)
case = simple.OpenFOAMReader(FileName=str(folder / "case.foam"), CaseType="Reconstructed Case")
case.MeshRegions = ["internalMesh"]
if "Decomposepolyhedra" in case.ListProperties():  # before ParaView 5.13
    case.Decomposepolyhedra = 0
case.UpdatePipeline()
read = simple.MergeBlocks(Input=case)
divided = simple.DividePolyhedra(Input=read)
parts = np.bincount(array(fetched(divided), "OriginalCellId"), volumes(divided))
assert np.abs(parts - volumes(read)).max() < 1e-12 * parts.sum()
assert fetched(simple.MergeBlocks(Input=simple.DividePolyhedra(Input=case))).GetNumberOfCells() == \
    fetched(divided).GetNumberOfCells()

# Errors: no direction; too little memory.
filter = simple.SlicePolyhedra(Input=header, Normal=[0, 0, 0])
filter.UpdatePipeline()
assert filter.SMProxy.GetClientSideObject().GetErrorCode() == 40008
filter = simple.DividePolyhedra(Input=header, MemoryLimit=1e-6)
filter.UpdatePipeline()
assert filter.SMProxy.GetClientSideObject().GetErrorCode() == 40005
