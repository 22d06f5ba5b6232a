# SPDX-License-Identifier: BSD-3-Clause
"""dynamicRefineFvMesh in cases of ours: all hexahedra away from walls can be refined, and that undone; a drop that moves past a
sphere is refined where it is."""

import tempfile

import harness  # finds the other modules
from paraview import simple

import foam
import refining
from pipeline import read


def meshes():
    """With the share of cells that can be refined, at least."""
    sphere = simple.Sphere(ThetaResolution=40, PhiResolution=40)
    spot = read("cino_spot.obj")
    yield 0.5, sphere, {"CellSize": 0.2, "RefinementDepth": 2, "IsotropicLevels": 1}
    yield 0.01, sphere, {"CellSize": 0.2, "RefinementDepth": 2}
    yield 0.2, spot, {"CellSize": 0.2, "RefinementDepth": 2, "IsotropicLevels": 1}
    yield 0.8, sphere, {"CellSize": 0.8, "Domain": "Outside", "RefinementDepth": 2, "Layers": 2, "IsotropicLevels": 1}


def check_all(share, surface, properties):
    with tempfile.TemporaryDirectory() as folder:
        foam.save(simple.CartesianMesher(Input=surface, **properties), folder)
        assert not foam.refused(folder)
        print(refining.refine_all(folder, 1)[:3])


for case in meshes():
    check_all(*case)
