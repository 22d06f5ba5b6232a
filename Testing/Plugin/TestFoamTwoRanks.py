"""On two ranks the same case is written as on one, and a mesh that both share is whole again."""

import pathlib
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import foam
from pipeline import read, redistributes

processes = vtkMultiProcessController.GetGlobalController()
assert processes.GetNumberOfProcesses() == 2

with tempfile.TemporaryDirectory() as temporary:
    mesher = simple.CartesianMesher(Input=read("kcl_exhaust_header_lumens.stl"), CellSize=8)
    alone = foam.Files(foam.save(mesher, pathlib.Path(temporary) / "alone"))
    alone.check()
    mesher.InPieces = 0
    whole = foam.save(mesher, pathlib.Path(temporary) / "whole")
    mesher.InPieces = 1
    for file in (whole / "constant" / "polyMesh").iterdir():
        other = pathlib.Path(temporary) / "alone" / "constant" / "polyMesh" / file.name
        assert file.read_bytes() == other.read_bytes(), f"{file.name} differs"
    if redistributes(temporary):
        shared = simple.RedistributeDataSet(Input=mesher)
        # Process Ids since ParaView 6.
        numbers = getattr(simple, "ProcessIdScalars", None) or simple.ProcessIds
        ranks = numbers(Input=shared)
        ranks.UpdatePipeline()
        assert ranks.PointData["ProcessId"].GetRange() == (0, 1), "only one rank has cells"
        both = foam.Files(foam.save(shared, pathlib.Path(temporary) / "both"))
        both.check()
        assert alone.cells == both.cells
        assert np.array_equal(np.unique(alone.points, axis=0), np.unique(both.points, axis=0))
        assert np.allclose(np.sort(alone.volumes()), np.sort(both.volumes()), rtol=1e-6)
        assert alone.patches == both.patches
    print(alone.cells, "cells,", len(alone.patches), "patches")
