"""Meshes as EnSight Gold files: ParaView's reader and, where it is installed, Code_Saturne find the mesh that we write
for OpenFOAM, to the 7 digits that the format has."""

import pathlib
import re
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import foam
from pieces import loops
from pipeline import DATA, Messages
from polyhedra import face_streams
from slab import slab

SURFACE = DATA / "kcl_exhaust_header_lumens.stl"
SATURNE = pathlib.Path("/usr/lib/code_saturne")


def parts(file):
    """{name: grid}, in order."""
    reader = simple.EnSightReader(CaseFileName=str(file))
    reader.UpdatePipeline()
    data = reader.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    return {data.GetMetaData(i).Get(data.NAME()): data.GetBlock(i) for i in range(data.GetNumberOfBlocks())}


def points(grid):
    return vtk_to_numpy(grid.GetPoints().GetData())


def rounded(whole):
    return whole.points.astype(np.float32)


def assert_cells(grid, whole):
    """The same cells in the same order, of the same points."""
    assert np.array_equal(points(grid), rounded(whole))
    stream, starts = (array.tolist() for array in face_streams(grid))
    expected = whole.faces_of_cells()
    assert grid.GetNumberOfCells() == len(expected)
    for cell, start in enumerate(starts):
        assert {frozenset(face) for face in loops(grid, cell, stream, start)} == expected[cell], cell


def assert_patch(grid, whole, name):
    """The same polygons in the same order, seen from outside."""
    faces, at, place = whole.of_patch(name), points(grid), rounded(whole)
    assert grid.GetNumberOfCells() == faces.stop - faces.start
    for cell, face in enumerate(range(faces.start, faces.stop)):
        ids = grid.GetCell(cell).GetPointIds()
        found = at[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]]
        assert np.array_equal(found, place[whole.faces.corners[whole.faces.start[face]:whole.faces.start[face + 1]]]), cell


def check_in_saturne(file, whole):
    """It joins the parts by the points' numbers, and its groups are the parts' numbers."""
    if not SATURNE.exists():
        return
    foam.run(file.parent, str(SATURNE / "cs_preprocess"), file.name)
    foam.run(file.parent, str(SATURNE / "cs_solver"), "--quality")
    text = (file.parent / "run_solver.log").read_text()
    numbers = {name: float(found) for name, found in re.findall(r"^ +(Number of [a-z ]+?|Total [a-z ]+?) *[:=] +(\S+)$", text, re.M)}
    inner = len(whole.neighbour)
    assert numbers["Number of cells"] == whole.cells and numbers["Number of vertices"] == len(whole.points), numbers
    assert numbers["Number of interior faces"] == inner and numbers["Number of boundary faces"] == len(whole.owner) - inner
    centres, areas = whole.face_centres()  # as Code_Saturne has them too
    volume = np.einsum("ij,ij->", centres[inner:], areas[inner:]) / 3
    assert abs(numbers["Total volume for the domain"] / volume - 1) < 1e-7, numbers
    groups = {int(part): int(count) for part, count in re.findall(r'"(\d+)"\n +boundary faces: +(\d+)', text)}
    assert groups == {part: count for part, (_, _, count) in enumerate(whole.patches.values(), 2)}, groups


with tempfile.TemporaryDirectory() as temporary:
    folder = pathlib.Path(temporary)
    mesher = simple.CartesianMesher(Input=simple.OpenDataFile(str(SURFACE)), CellSize=12)
    whole = foam.Files(foam.save(mesher, folder / "case"))
    simple.SaveData(str(folder / "exhaust header.case"), mesher)
    found = parts(folder / "exhaust header.case")
    assert list(found) == ["cells", *whole.patches], list(found)
    assert_cells(found["cells"], whole)
    for name in whole.patches:
        assert_patch(found[name], whole, name)

    task = folder / "task.toml"
    task.write_text(f'[surface]\nfile = "{SURFACE}"\n[grid]\ncell_size = 12.0\n[output]\nmesh = "task.case"\n')
    for ranks in 1, 2:
        foam.run(folder, *foam.MPIRUN, "-n", str(ranks), sys.argv[2], "--quiet", task.name)
        assert (folder / "task.geo").read_bytes() == (folder / "exhaust_header.geo").read_bytes()
        assert "model: task.geo\n" in (folder / "task.case").read_text()
    check_in_saturne(folder / "task.case", whole)

    # Two regions are two parts; a boundary of both is one.
    mesher = slab(0.23)
    simple.SaveData(str(folder / "regions.case"), mesher)
    case = foam.save(mesher, folder / "regions")
    both = foam.Files(foam.save(mesher, folder / "both", RegionsAs="Zones"))
    found = parts(folder / "regions.case")
    assert list(found) == ["left", "right", *both.patches], list(found)
    for region in "left", "right":
        assert_cells(found[region], foam.Files(case, region))
    for name in both.patches:
        assert_patch(found[name], both, name)

    # What stood there stays, and nothing else, where the new one cannot be written.
    (folder / "folder.geo").mkdir()
    with Messages() as said:
        simple.SaveData(str(folder / "folder.case"), mesher)
    assert "folder.geo (Is a directory): choose another name" in str(said), said
    assert not list(folder.glob("*.unfinished")) and not (folder / "folder.case").exists()
    print(whole.cells, "cells")
