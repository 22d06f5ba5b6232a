"""Sharp edges, areas and volumes of meshes of CAD files beside those of STL files of the same triangles: what no angle shows
is kept by CAD Reader.

pvpython TestCadEdges.py REPOSITORY PROGRAM PRINT_OPTIONS FOLDER [FILE CELL_SIZE ...]: FOLDER has the files of
make-cad-parts; other files are measured too, for the table in Help/cad.md. Lengths are millimetres."""

import json
import pathlib
import re
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator

from pipeline import output

PARTS = pathlib.Path(sys.argv[4])
ON_EDGE = 0.02  # of the cell size
SAMPLES = 7  # of a line


def blocks(data):
    """Of nested blocks, the surfaces."""
    if data.IsA("vtkPolyData"):
        return [data]
    return [surface for i in range(data.GetNumberOfBlocks()) for surface in blocks(data.GetBlock(i))]


def samples(surface):
    """Points inside the sharp edges: not at their ends, through which others pass."""
    lines = vtk_to_numpy(surface.GetLines().GetConnectivityArray()).reshape(-1, 2)
    points = vtk_to_numpy(surface.GetPoints().GetData())
    begin, end = points[lines[:, 0]], points[lines[:, 1]]
    weights = (np.arange(SAMPLES) + 0.5)[:, None, None] / SAMPLES
    lengths = np.repeat(np.linalg.norm(end - begin, axis=1)[None], SAMPLES, 0) / SAMPLES
    return (begin * (1 - weights) + end * weights).reshape(-1, 3), lengths.ravel()


def edges_of(boundary):
    """The edges of all faces, as lines."""
    polygons = boundary.GetPolys()
    corners, begins = (vtk_to_numpy(array).copy() for array in (polygons.GetConnectivityArray(), polygons.GetOffsetsArray()))
    following = np.arange(1, len(corners) + 1)
    following[begins[1:] - 1] = begins[:-1]
    lines = vtkCellArray()
    for a, b in np.unique(np.sort(np.stack([corners, corners[following]], 1), 1), axis=0):
        lines.InsertNextCell(2, [a, b])
    found = vtkPolyData()
    found.SetPoints(boundary.GetPoints())
    found.SetLines(lines)
    return found


def kept(solids, boundary, size):
    """The share of the sharp edges' length that are edges of the mesh."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(edges_of(boundary))
    locator.BuildLocator()
    closest, cell, part, square = [0, 0, 0], reference(0), reference(0), reference(0.0)
    found = total = 0
    for solid in solids:
        for point, length in zip(*samples(solid)):
            locator.FindClosestPoint(point, closest, cell, part, square)
            total += length
            found += length * (square.get() <= (ON_EDGE * size) ** 2)
    return found / total


def measured(surface, size, solids):
    mesher = simple.CartesianMesher(Input=surface, CellSize=size)
    boundary = output(mesher, 1)
    assert mesher.SMProxy.GetClientSideObject().GetErrorCode() == 0
    fields = output(mesher).GetFieldData()
    names = fields.GetAbstractArray("BoundaryNames")
    areas = vtk_to_numpy(fields.GetArray("BoundaryAreas"))
    return {"kept": kept(solids, boundary, size), "volume": fields.GetArray("MeshVolume").GetValue(0),
        "areas": {names.GetValue(i): area for i, area in enumerate(areas)}}


def compare(file, size, **properties):
    """By CAD Reader, from a named STL file, and from one without names."""
    cad = simple.CADReader(FileName=str(file), LengthUnit="Millimetre", **properties)
    solids = blocks(output(cad))
    with tempfile.TemporaryDirectory() as folder:
        named, plain = pathlib.Path(folder, "named.stl"), pathlib.Path(folder, "plain.stl")
        simple.SaveData(str(named), proxy=simple.MergeBlocks(Input=cad, OutputDataSetType="Polygonal Mesh", MergePoints=0))
        plain.write_text(re.sub(r"endsolid.*\nsolid.*\n", "", named.read_text()))
        results = {"CAD": measured(cad, size, solids), "named STL": measured(simple.NamedSTLReader(FileName=str(named)), size, solids),
            "STL": measured(simple.STLReader(FileNames=[str(plain)]), size, solids)}
    enclosed = sum(solid.GetFieldData().GetArray("VolumeOfTriangles").GetValue(0) for solid in solids)
    for name, result in results.items():
        print(f"{file.name} {name}: edges {100 * result['kept']:.2f} %, volume {100 * (result['volume'] / enclosed - 1):+.3f} %", flush=True)
    areas, others = results["CAD"]["areas"], results["named STL"]["areas"]
    print(f"areas of {len(areas)} boundaries differ by {100 * max(abs(others[name] / areas[name] - 1) for name in areas):.4f} %")
    return results


FACTS = json.loads((PARTS / "facts.json").read_text())
crease = compare(PARTS / "crease.step", 2.1)
assert crease["CAD"]["kept"] > 0.9999 and crease["named STL"]["kept"] > 0.9999, crease
assert crease["STL"]["kept"] < 0.93, crease  # of 260 mm of edges, 20 are the crease
area = FACTS["crease.step"]["area"]
assert abs(sum(crease["CAD"]["areas"].values()) / area - 1) < 1e-6, crease

junction = compare(PARTS / "junction_mm.step", 5, Deflection=4e-4)
exact = FACTS["junction_mm.step"]["boundaries"]
assert junction["CAD"]["areas"].keys() == exact.keys(), junction
for name in "inlet_1", "inlet_2", "outlet":
    assert abs(junction["CAD"]["areas"][name] / exact[name] - 1) < 1e-4, (name, junction)

for file, size in zip(sys.argv[5::2], sys.argv[6::2]):
    compare(pathlib.Path(file), float(size))
