"""A mesh saved as an OpenFOAM case is the same mesh: in its files, and read back by ParaView; with
its boundaries, from whatever filter it comes; and nothing of the user's in the case is lost."""

import pathlib
import tempfile

import numpy as np
from cartesianmesher.vtkCartesianMesherFilters import vtkPolyMeshWriter
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_TETRA, vtkFieldData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter

import foam
import measure
from pipeline import Messages, merged, octahedron, output, producer, read
from polyhedra import keep_polyhedra

BAD_MESH, CANNOT_WRITE = 40011, 40012
NO_FILE_NAME = 20006
SINGLE = np.finfo(np.float32).eps  # ParaView's reader keeps coordinates in single precision

temporary = tempfile.TemporaryDirectory()
cases = (pathlib.Path(temporary.name) / str(i) for i in range(1000))


def corners_by_cell(faces):
    """The distinct points of each cell, cell after cell."""
    pairs = np.stack([faces.owner[faces.face], faces.corners], axis=1)
    return np.unique(pairs, axis=0)


def read_back(folder):
    """The mesh and the patches by name, as ParaView reads them."""
    case = simple.OpenFOAMReader(FileName=str(folder / "case.foam"))
    case.MeshRegions = case.MeshRegions.Available
    keep_polyhedra(case)
    blocks = output(case)
    mesh, boundary = blocks.GetBlock(0), blocks.GetBlock(1)
    names = [boundary.GetMetaData(i).Get(boundary.NAME()) for i in range(boundary.GetNumberOfBlocks())]
    return mesh, {name: boundary.GetBlock(i) for i, name in enumerate(names)}


def check_read_back(folder, files):
    grid, patches = read_back(folder)
    error = np.abs(measure.points_of(grid) - files.points).max()
    assert error <= SINGLE * np.abs(files.points).max(), error
    inner = len(files.neighbour)
    assert grid.GetNumberOfCells() == files.cells
    both = np.concatenate([files.owner, files.neighbour])
    of_cells = np.concatenate([files.faces.face, files.faces.face[:files.faces.start[inner]]])
    of_cells[len(files.faces.face):] += len(files.owner)
    ids = np.concatenate([files.faces.corners, files.faces.corners[:files.faces.start[inner]]])
    expected = np.unique(np.stack([both[of_cells], ids], axis=1), axis=0)
    cells = np.repeat(np.arange(grid.GetNumberOfCells()),
                      np.diff(vtk_to_numpy(grid.GetCells().GetOffsetsArray())))
    found = np.stack([cells, vtk_to_numpy(grid.GetCells().GetConnectivityArray())], axis=1)
    # The reader takes any two triangles and three quadrilaterals for a wedge.
    five = np.bincount(both, minlength=files.cells) == 5
    found, expected = (pairs[~five[pairs[:, 0]]] for pairs in (np.unique(found, axis=0), expected))
    assert np.array_equal(found, expected), "cells have other points"
    assert {name: data.GetNumberOfCells() for name, data in patches.items()} == \
        {name: count for name, (_, _, count) in files.patches.items()}


def patch_name(boundary):
    return "no_surface" if boundary < 0 else f"boundary_{boundary}"


def check_equal(mesh, boundary, files, name=patch_name):
    """The files against the mesher's two outputs, in double precision."""
    files.check()
    expected = measure.Mesh(mesh, boundary)
    assert (files.points == expected.xyz).all(), "points differ"
    volumes = files.volumes()
    # Of slivers and of faces that are not flat, which OpenFOAM measures in another way.
    assert np.abs(volumes / expected.volumes - 1).max() < 1e-2
    assert abs(volumes.sum() / expected.volume - 1) < 1e-4
    inner = len(files.neighbour)
    assert np.array_equal(
        corners_by_cell(files.faces.select(np.arange(len(files.owner)) >= inner)),
        corners_by_cell(expected.once)), "boundary faces differ"
    areas = files.areas()
    assert set(areas) == {name(id) for id in expected.areas}, list(areas)
    for id, area in expected.areas.items():
        assert abs(areas[name(id)] / area - 1) < 1e-12


def saved(proxy, **properties):
    folder = foam.save(proxy, next(cases), **properties)
    return folder, foam.Files(folder)


# Equal, in both formats.
two = merged(octahedron(), octahedron(0.3, (2, 0, 0)))
for source, properties in (
    (read("kcl_exhaust_header_lumens.stl"), {"CellSize": 8}),
    (read("cino_spot.obj"), {"CellSize": 0.2, "RefinementDepth": 1}),
    (producer(two), {"CellSize": 0.1, "MeshlinesX": [-0.5, 0, 0.5, 1, 2]}),
    (simple.Box(), {"CellSize": 1}),
):
    mesher = simple.CartesianMesher(Input=source, **properties)
    contents = {}
    for kind in "Ascii", "Binary":
        folder, files = saved(mesher, FileType=kind)
        check_equal(output(mesher), output(mesher, 1), files)
        check_read_back(folder, files)
        contents[kind] = files
    assert (contents["Ascii"].points == contents["Binary"].points).all()

# OpenFOAM's programs write it anew with all digits.
foam.run(folder, "transformPoints", "-scale", "(1 1 1)")
assert (foam.Files(folder).points == files.points).all()


def types(files):
    return {name: type for name, (type, _, _) in files.patches.items()}


def write(grid, folder, **properties):
    """Writes without ParaView; the messages and the error code."""
    writer = vtkPolyMeshWriter()
    writer.SetInputData(grid)
    if folder:
        writer.SetFileName(str(folder / "case.foam"))
    with Messages() as said:
        writer.Write()
    return str(said), writer.GetErrorCode()


# After filters that leave cells as they are: the same patches.
exhaust = simple.CartesianMesher(Input=read("kcl_exhaust_header_lumens.stl"), CellSize=8)
_, whole = saved(exhaust)
metres = simple.Transform(Input=exhaust)
metres.Transform.Scale = [1e-3] * 3
mirrored = simple.Transform(Input=exhaust)
mirrored.Transform.Scale = [-1, 1, 1]
for changed, length in (metres, 1e-3), (mirrored, 1):
    folder, files = saved(changed)
    files.check()
    assert list(files.patches) == list(whole.patches)
    assert abs(files.volumes().sum() / whole.volumes().sum() / length**3 - 1) < 1e-9
    for name, area in whole.areas().items():
        assert abs(files.areas()[name] / area / length**2 - 1) < 1e-9
    assert "Boundary openness" in foam.CheckMesh(folder).text
# ... a part of the cells: what was inside is no_surface.
half = simple.Threshold(Input=exhaust, Scalars=["CELLS", "CellId"], LowerThreshold=0,
                        UpperThreshold=3000)
_, files = saved(half)
files.check()
areas = files.areas()
assert areas["no_surface"] > 0 and set(areas) <= {"no_surface", *whole.patches}
assert all(areas[name] <= whole.areas()[name] * (1 + 1e-9) for name in areas if name in whole.patches)
_, files = saved(simple.Threshold(Input=exhaust, Scalars=["CELLS", "CellId"], LowerThreshold=0))
assert files.patches == whole.patches

# Two meshes in one: one patch, and a warning.
folder = next(cases)
said, code = write(output(simple.AppendDatasets(Input=[exhaust, metres])), folder)
files = foam.Files(folder)
assert "one patch" in said and code == 0 and list(files.patches) == ["boundary"], said
files.check()

# Grids from elsewhere, of all kinds of cells: one patch, and cells outward as OpenFOAM wants them.
wavelet = simple.Wavelet(WholeExtent=[0, 4, 0, 3, 0, 2])
for grid, cells in (
    (simple.AppendDatasets(Input=wavelet), 24),  # voxels
    (simple.Tetrahedralize(Input=wavelet), 24 * 5),
    (simple.Tetrahedralize(Input=simple.Cone(Resolution=5)), None),
    (simple.UnstructuredCellTypes(CellType="Wedge"), None),
    (simple.UnstructuredCellTypes(CellType="Pyramid"), None),
):
    if cells is None and grid.GetXMLName() == "DataSetTriangleFilter":
        assert "no cells with a volume" in write(output(grid), next(cases))[0]
        continue
    folder, files = saved(grid)
    files.check()
    assert list(files.patches) == ["boundary"]
    assert files.volumes().min() > 0 and cells in (None, files.cells)
    assert foam.CheckMesh(folder).ok

# Names of boundaries.
named = vtkUnstructuredGrid()
named.ShallowCopy(output(exhaust))
names, ids = vtkStringArray(), vtkIntArray()
names.SetName("BoundaryNames")
ids.SetName("BoundaryIds")
for id, name in enumerate(["wall a/b", "inlet", "inlet", "", "1st", "Wände", "{}"]):
    names.InsertNextValue(name)
    ids.InsertNextValue(id)
named.GetFieldData().AddArray(names)
named.GetFieldData().AddArray(ids)
folder = next(cases)
assert write(named, folder) == ("", 0)
files = foam.Files(folder)
assert list(files.patches) == ["wall_a_b", "inlet", "inlet_2", "boundary_3", "_1st", "Wände", "__",
    *(f"boundary_{i}" for i in range(7, 12))], list(files.patches)
assert [name for name, type in types(files).items() if type != "wall"] == ["inlet", "inlet_2"]
assert list(read_back(folder)[1]) == list(files.patches)
foam.CheckMesh(folder)

# What is in the case stays there.
folder, files = saved(exhaust)
poly_mesh = folder / "constant" / "polyMesh"
others = [folder / "0" / "U", folder / "system" / "controlDict", folder / "constant" / "transport"]
for path in others:
    path.parent.mkdir(exist_ok=True)
    path.write_text(path.name)
(folder / "case.foam").write_text("mine")
# ... edited types of patches too, when a finer mesh takes the place of this one.
boundary = poly_mesh / "boundary"
boundary.write_text(boundary.read_text().replace("wall;", "symmetry;", 1))
finer = simple.CartesianMesher(Input=exhaust.Input, CellSize=6)
assert write(output(finer), folder) == ("", 0)
files = foam.Files(folder)
check_equal(output(finer), output(finer, 1), files)
assert list(types(files).values()) == ["symmetry"] + 11 * ["wall"]
assert not list(folder.glob("**/polyMesh?*"))
# ... but what the user says of types wins, and other entries stay.
boundary.write_text(boundary.read_text().replace("symmetry;", "symmetry; // type of mine ;\n  inGroups 1(type);", 1))
typed = simple.CartesianMesher(Input=exhaust.Input, CellSize=10,
    BoundaryNames=["boundary_0", "boundary_3", "boundary_5"], BoundaryTypes=["empty", "symmetryPlane", "automatic"])
assert write(output(typed), folder) == ("", 0)
assert list(types(foam.Files(folder)).values()) == ["empty", "wall", "wall", "symmetryPlane"] + 8 * ["wall"]
assert "empty; // type of mine ;\n  inGroups 1(type);" in boundary.read_text()
assert write(output(exhaust), folder) == ("", 0)
assert list(types(foam.Files(folder)).values()) == ["empty", "wall", "wall", "symmetryPlane"] + 8 * ["wall"]
# ... a new case has them too, whatever keeps the cells comes between.
assert list(types(saved(simple.Threshold(Input=typed, Scalars=["CELLS", "Region"]))[1]).values()) == \
    ["empty", "wall", "wall", "symmetryPlane"] + 8 * ["wall"]
# ... the zones of the mesh that was replaced are put aside.
(poly_mesh / "cellZones").write_text("zones")
said, code = write(output(exhaust), folder)
assert "polyMesh.old" in said and code == 0
assert [path.name for path in (folder / "constant" / "polyMesh.old").iterdir()] == ["cellZones"]
# ... all of a mesh that somebody else wrote, or that has other patches.
before = (poly_mesh / "points").read_bytes()
assert "polyMesh.old2" in write(output(mesher), folder)[0]
assert (folder / "constant" / "polyMesh.old2" / "points").read_bytes() == before
(poly_mesh / "owner").write_text("not ours")
assert "polyMesh.old3" in write(output(mesher), folder)[0]
assert (folder / "constant" / "polyMesh.old3" / "owner").read_text() == "not ours"
assert all(path.read_text() == path.name for path in others)
assert (folder / "case.foam").read_text() == "mine"

# Errors; the mesh that was there stays.
before = {path: path.read_bytes() for path in poly_mesh.iterdir()}
curved = vtkUnstructuredGrid()
curved.SetPoints(named.GetPoints())
curved.Allocate(1)
curved.InsertNextCell(VTK_QUADRATIC_TETRA, 10, range(10))
empty = vtkUnstructuredGrid()
append = vtkAppendFilter()
append.MergePointsOn()
append.AddInputData(named)
append.AddInputData(named)
append.Update()
doubled = append.GetOutput()
clipped = output(simple.Clip(Input=exhaust))
for grid, part in ((curved, "Tessellate"), (clipped, "such as Clip"), (empty, "no cells"), (doubled, "cells overlap")):
    said, code = write(grid, folder)
    assert part in said and code == BAD_MESH, said
assert {path: path.read_bytes() for path in poly_mesh.iterdir()} == before

# A name that OpenFOAM could not read is cut off, and that is told.
long = vtkUnstructuredGrid()
long.ShallowCopy(named)
texts = vtkStringArray()
texts.SetName("BoundaryNames")
given = named.GetFieldData().GetAbstractArray("BoundaryNames")
for i in range(given.GetNumberOfValues()):
    texts.InsertNextValue("x" * 1200 if i == 0 else given.GetValue(i))
long.SetFieldData(vtkFieldData())
long.GetFieldData().ShallowCopy(named.GetFieldData())
long.GetFieldData().AddArray(texts)
long_names = next(cases)
said, code = write(long, long_names)
assert "has 1200 characters" in said and code == 0, said
assert "x" * 1000 in foam.Files(long_names).patches
said, code = write(named, None)
assert "file name" in said and code == NO_FILE_NAME, said
said, code = write(named, folder / "case.foam")
assert "choose another folder" in said and code == CANNOT_WRITE, said
