"""Each rank writes its piece of a decomposed case; together they are the mesh that the ranks write whole. So are those of
several regions, and those with layers."""

import pathlib
import tempfile

from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import decomposed
import foam
from pipeline import DATA
from slab import CONDUCTIVITY, slab

processes = vtkMultiProcessController.GetGlobalController()
ranks = processes.GetNumberOfProcesses()

with tempfile.TemporaryDirectory() as temporary:
    mesher = simple.CartesianMesher(Input=simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl")), CellSize=12)
    whole = foam.Files(foam.save(mesher, pathlib.Path(temporary) / "whole"))
    for kind in "Ascii", "Binary":
        case = foam.save(mesher, pathlib.Path(temporary) / kind, Pieces=ranks, FileType=kind)
        pieces = decomposed.check(case, whole, ranks)
    again = foam.save(mesher, case, Pieces=ranks)  # replaces it
    decomposed.check(again, whole, ranks)
    assert not (again / "processor0" / "constant" / "polyMesh.old").exists()
    print([piece.files.cells for piece in pieces], "cells")

    mesher.Layers = 2
    whole = foam.Files(foam.save(mesher, pathlib.Path(temporary) / "layered"))
    decomposed.check(foam.save(mesher, pathlib.Path(temporary) / "layers", Pieces=ranks), whole, ranks)

    mesh = simple.OutputPort(slab(0.25, "Exact Fit"), "Mesh")
    whole = foam.save(mesh, pathlib.Path(temporary) / "slab")
    case = foam.save(mesh, pathlib.Path(temporary) / "regions", Pieces=ranks)
    for region in CONDUCTIVITY:
        decomposed.check(case, foam.Files(whole, region), ranks, region)
    assert (case / "constant/regionProperties").exists()
