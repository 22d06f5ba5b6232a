"""A mesh made in pieces, one after the other, is the whole mesh; a task keeps to its memory limit."""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from cartesianmesher.vtkCartesianMesherFilters import vtkCartesianMesher
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOParallelXML import vtkXMLPUnstructuredGridWriter

import pieces
from pipeline import DATA

EXHAUST = DATA / "kcl_exhaust_header_lumens.stl"
CELL_SIZE, DEPTH, PIECES = 13.0, 1, 3


def mesher(size=CELL_SIZE, depth=DEPTH, gaps=4, layers=0):
    reader = vtkSTLReader()
    reader.SetFileName(str(EXHAUST))
    reader.ScalarTagsOn()
    mesher = vtkCartesianMesher()
    mesher.SetInputConnection(reader.GetOutputPort())
    mesher.SetCellSize(size)
    mesher.SetRefinementDepth(depth)
    mesher.SetCurvatureAngle(10 * gaps)
    mesher.SetCellsAcrossGaps(gaps)
    mesher.SetLargestDepth(2)
    mesher.SetLayers(layers)
    return mesher


def piece(filter, number):
    """Copies of mesh and boundary."""
    filter.UpdatePiece(number, PIECES, 0)
    mesh, boundary = vtkUnstructuredGrid(), vtkPolyData()
    mesh.DeepCopy(filter.GetOutputDataObject(0))
    boundary.DeepCopy(filter.GetOutputDataObject(1))
    return mesh, boundary


def ids(boundary):
    """The faces of the mesh's boundary: corners and owners by their numbers in the whole mesh."""
    points = vtk_to_numpy(boundary.GetPointData().GetArray("MeshPointId"))
    corners = vtk_to_numpy(boundary.GetPolys().GetConnectivityArray())
    return (points[corners], *(vtk_to_numpy(boundary.GetCellData().GetArray(name))
        for name in ("OwnerCell", "BoundaryId")))


for order, layers in ((0, 1, 2), 0), ((2, 0, 1), 0), ((0, 1, 2), 2):
    alone = mesher(layers=layers)
    alone.Update()
    whole, faces = alone.GetOutputDataObject(0), alone.GetOutputDataObject(1)
    filter = mesher(layers=layers)
    made = dict((number, piece(filter, number)) for number in order)
    parts = [made[number] for number in range(PIECES)]
    pieces.assert_union(whole, [mesh for mesh, _ in parts])
    for mine, expected in zip(zip(*(ids(boundary) for _, boundary in parts)), ids(faces)):
        assert np.array_equal(np.concatenate(mine), expected)

alone = mesher()
alone.Update()
whole = alone.GetOutputDataObject(0)
with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    writer = vtkXMLPUnstructuredGridWriter()
    filter = mesher()
    writer.SetInputConnection(filter.GetOutputPort(0))
    writer.SetFileName(str(folder / "streamed.pvtu"))
    writer.SetDataModeToBinary()
    writer.SetNumberOfPieces(PIECES)
    writer.SetEndPiece(PIECES - 1)
    assert writer.Write()
    pieces.assert_union(whole, [pieces.load(folder / f"streamed_{i}.vtu") for i in range(PIECES)])

    # Cells as they are cut: where walls are edited, each piece has all of the wall.
    size = 4.0
    alone = mesher(size, 0, 0)
    alone.SetSmallCellsToRemove()
    alone.SplitConcaveCellsOff()
    alone.SetCollapseRatio(0)
    alone.Update()
    whole = alone.GetOutputDataObject(0)

    def run(limit):
        (folder / "task.toml").write_text(f"""
            surface.file = "{EXHAUST}"
            grid.cell_size = {size}
            cells.small_cells = "Remove"
            cells.split_concave_cells = false
            cells.collapse_ratio = 0
            performance.memory_limit = {limit}
            output.mesh = "{limit}/mesh.pvtu"
            output.boundary = "{limit}/boundary.pvtp"
            output.statistics = "{limit}/statistics.json"
            """)
        done = subprocess.run([sys.argv[2], "--quiet", str(folder / "task.toml")],
            capture_output=True, text=True)
        files = sorted((folder / str(limit)).glob("mesh_pvtu1/*.vtu"), key=lambda file: int(file.stem.rpartition("_")[2]))
        return done, files

    few, many = (run(limit) for limit in (1.0, 0.05))
    summaries = []
    for limit, (done, files) in (1.0, few), (0.05, many):
        assert done.returncode in (0, 3), done.stderr  # 3: cells as they are cut fail checkMesh
        summaries.append(json.loads((folder / str(limit) / "statistics.json").read_text()))
        assert len(summaries[-1]["boundaries"]) == 12
    assert len(few[1]) == 1 and len(many[1]) > 1, many[1]
    pieces.assert_union(whole, [pieces.load(file) for file in many[1]])
    for name in "VolumeLeftOut", "MeshVolume":  # sums, in another order
        assert np.isclose(*(summary["mesh"].pop(name) for summary in summaries), rtol=1e-12)
    assert [summary["mesh"].pop("Parts", 0) for summary in summaries].count(0) == 1  # of pieces it is not known
    assert summaries[0]["mesh"] == summaries[1]["mesh"]
    for one, other in zip(summaries[0]["boundaries"], summaries[1]["boundaries"]):
        assert one["faces"] == other["faces"] and np.isclose(one["area"], other["area"], rtol=1e-12)

    done, files = run(0.001)
    assert done.returncode == 2 and not files and "Memory Limit of 0.001 GiB" in done.stderr, done.stderr
print(len(many[1]), "pieces of", whole.GetNumberOfCells(), "cells")
