"""One rank writes a decomposed case piece by piece. OpenFOAM takes it, solves on it as on the whole mesh, and puts
the pieces together to that."""

import pathlib
import sys
import tempfile

import numpy as np
from paraview import simple

import decomposed
import foam
from ducts import prepare
from pipeline import DATA, Messages


SURFACE = DATA / "kcl_exhaust_header_lumens.stl"


def refused(case, what, proxy, **properties):
    """Nothing is written, and an error says why."""
    before = sorted(case.rglob("*"))
    with Messages() as said:
        simple.SaveData(str(case / "case.foam"), proxy, **properties)
    assert what in str(said), said
    assert sorted(case.rglob("*")) == before


with tempfile.TemporaryDirectory() as temporary:
    folder = pathlib.Path(temporary)
    mesher = simple.CartesianMesher(Input=simple.OpenDataFile(str(SURFACE)), CellSize=12)
    whole = foam.Files(foam.save(mesher, folder / "whole"))
    case = foam.save(mesher, folder / "pieces", Pieces=4)
    pieces = decomposed.check(case, whole, 4)
    assert not list(case.glob("*.unfinished"))

    text = foam.run_parallel(case, 4, "checkMesh")
    assert "\nMesh OK." in text and "Coupled point location match (average 0) OK" in text, text

    # Fluxes: U, which OpenFOAM 1912 reconstructs from them, differs after decomposePar too.
    prepare(case, pieces=4, tolerance=1e-12)
    foam.run_parallel(case, 4, "potentialFoam", "-writephi")
    prepare(folder / "whole", tolerance=1e-12)
    foam.run(folder / "whole", "potentialFoam", "-writephi")
    alone = foam.read_field(folder / "whole", 0, "phi")
    flows = {}
    for piece in pieces:
        place = case / f"processor{piece.number}"
        flux = foam.read_field(place, 0, "phi")
        assert np.abs(flux - alone[piece.faces[:len(flux)]]).max() < 1e-9 * np.abs(alone).max()
        for patch, flow in foam.read_flows(place, 0).items():
            flows[patch] = flows.get(patch, 0) + flow
    for patch, flow in foam.read_flows(folder / "whole", 0).items():
        assert abs(flows[patch] - flow) < 1e-6, patch

    foam.run(case, "reconstructParMesh", "-constant", "-mergeTol", "1e-9")
    again = foam.Files(case)
    assert again.cells == whole.cells and len(again.points) == len(whole.points)
    assert len(again.owner) == len(whole.owner)
    assert abs(again.volumes().sum() / whole.volumes().sum() - 1) < 1e-12

    refused(case, "processor2 exists", mesher, Pieces=2)
    empty = folder / "empty"
    empty.mkdir()
    refused(empty, "has no cells", mesher, Pieces=1000)
    some = simple.Threshold(Input=mesher, Scalars=["CELLS", "VolumeFraction"], LowerThreshold=0.9, UpperThreshold=9)
    refused(empty, "are not numbered consecutively", some, Pieces=2)

    task = folder / "task.toml"
    command = [sys.argv[2], "--quiet", task.name]
    for ranks, pieces_asked in (1, 3), (2, 2):
        task.write_text(f'[surface]\nfile = "{SURFACE}"\n[grid]\ncell_size = 12.0\n'
            f'[output]\nmesh = "case{ranks}/case.foam"\npieces = {pieces_asked}\n')
        foam.run(folder, *foam.MPIRUN, "-n", str(ranks), *command)
        decomposed.check(folder / f"case{ranks}", whole, pieces_asked)
    print([piece.files.cells for piece in pieces], "cells")
