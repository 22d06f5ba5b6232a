"""Meshes as CGNS files: read back by ParaView's reader, and checked by CGNS's cgnscheck where it is new enough."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import foam
from pieces import loops
from pipeline import DATA, Messages
from polyhedra import face_streams
from rotors import fan
from slab import slab


def save(proxy, file):
    file.parent.mkdir(exist_ok=True)
    simple.SaveData(str(file), proxy)
    assert not file.with_name(file.name + ".unfinished").exists()
    check(file)
    return file


def check(file):
    if not shutil.which("cgnscheck"):
        return
    said = subprocess.run(["cgnscheck", str(file)], text=True, capture_output=True)
    text = said.stdout + said.stderr
    if "more recent version of the CGNS library" not in text:
        assert "checking complete" in text and "ERROR" not in text, text


def blocks(file):
    """{name: data} of all that ParaView finds in a file."""
    reader = simple.CGNSSeriesReader(FileNames=[str(file)])
    reader.LoadMesh, reader.LoadPatches, reader.DoublePrecisionMesh = 1, 1, 1
    reader.UpdatePipeline()
    data = reader.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    found, iterator = {}, data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        found.setdefault(iterator.GetCurrentMetaData().Get(data.NAME()), []).append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def compare(mesh, whole):
    """The cells of ParaView's grid are those that OpenFOAM gets, in its order."""
    assert np.array_equal(points(mesh), whole.points)
    stream, starts = (array.tolist() for array in face_streams(mesh))
    expected = whole.faces_of_cells()
    assert mesh.GetNumberOfCells() == len(expected)
    for cell, start in enumerate(starts):
        assert {frozenset(face) for face in loops(mesh, cell, stream, start)} == expected[cell], cell


with tempfile.TemporaryDirectory() as temporary:
    folder = pathlib.Path(temporary)
    mesher = simple.CartesianMesher(Input=simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl")), CellSize=12)
    found = blocks(save(mesher, folder / "header.cgns"))
    whole = foam.Files(foam.save(mesher, folder / "case"))
    assert list(found) == ["Internal", *whole.patches], list(found)
    compare(found["Internal"][0], whole)
    for name in whole.patches:
        part = whole.of_patch(name)
        corners = whole.faces.corners[whole.faces.start[part.start]:whole.faces.start[part.stop]]
        expected = {tuple(point) for point in whole.points[np.unique(corners)].tolist()}
        # ParaView 5.13 has the other points of the zone too.
        assert expected <= {tuple(point) for point in points(found[name][0]).tolist()}, name

    assert simple.CreateWriter("case.cgns", mesher).GetXMLLabel() == "CGNS Mesh Writer", "ParaView's has no boundaries"
    task = folder / "task.toml"
    task.write_text(f'[surface]\nfile = "{DATA / "kcl_exhaust_header_lumens.stl"}"\n[grid]\ncell_size = 12.0\n'
        '[output]\nmesh = "task.cgns"\n')
    for ranks in 1, 2:
        foam.run(folder, *foam.MPIRUN, "-n", str(ranks), sys.argv[2], "--quiet", task.name)
        compare(blocks(folder / "task.cgns")["Internal"][0], whole)
        (folder / "task.cgns").unlink()

    # Two regions, which touch: a zone for each.
    mesher = slab(0.23)
    found = blocks(save(mesher, folder / "regions.cgns"))
    case = foam.save(mesher, folder / "regions")
    for region, mesh in zip(("left", "right"), found["Internal"]):
        compare(mesh, foam.Files(case, region))
    assert set(found) == {"Internal", "inlet_cold", "side", "hot"}, list(found)

    # A zone of the flow is one, too, which flow goes through: no boundary is between it and what is around it.
    mesher = fan()
    mesh = simple.OutputPort(mesher, "Mesh")
    found = blocks(save(mesh, folder / "fan.cgns"))
    case = foam.save(mesh, folder / "fan")
    for region, data in zip(("fluid", "rotor"), found["Internal"]):
        compare(data, foam.Files(case, region))
    assert set(found) == {"Internal", "blade", "shaft", "inlet", "outlet", "sides"}, list(found)
    text = (folder / "fan.cgns").read_bytes()
    assert text.count(b"Abutting1to1") == 2 and b"fluid_to_rotor" in text and b"rotor_to_fluid" in text

    # What stood there stays, and nothing else, where the new one cannot be written.
    (folder / "folder.cgns").mkdir()
    with Messages() as said:
        simple.SaveData(str(folder / "folder.cgns"), mesher)
    assert "folder.cgns (Is a directory): choose another name" in str(said), said
    assert not (folder / "folder.cgns.unfinished").exists()
    print(whole.cells, "cells")
