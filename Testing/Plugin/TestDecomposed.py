"""One rank writes a decomposed case piece by piece, and OpenFOAM takes it."""

import pathlib
import sys
import tempfile

import numpy as np
from paraview import simple

import decomposed
import foam
from pipeline import read

with tempfile.TemporaryDirectory() as temporary:
    folder = pathlib.Path(temporary)
    mesher = simple.CartesianMesher(Input=read("kcl_exhaust_header_lumens.stl"), CellSize=12)
    whole = foam.Files(foam.save(mesher, folder / "whole"))
    case = foam.save(mesher, folder / "pieces", Pieces=4)
    pieces = decomposed.check(case, whole, 4)
    assert not list(case.glob("*.unfinished"))
    print([piece.files.cells for piece in pieces], "cells")
