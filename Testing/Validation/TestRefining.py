# SPDX-License-Identifier: BSD-3-Clause
"""dynamicRefineFvMesh in cases of ours: hexahedra away from walls are refined, and that is undone, all of them in a fluid at rest, and
where a ball of fluid is that moves past a sphere."""

import tempfile

import harness  # noqa: F401, finds the other modules
from paraview import simple

import foam
import refining
from pipeline import read

BALL = simple.Sphere(ThetaResolution=40, PhiResolution=40)
AROUND = {"Domain": "Outside", "BoxFrom": "Bounds", "DomainBounds": [-3, 3, -2, 2, -2, 2], "CellSize": 0.5, "RefinementDepth": 2}
ISOTROPIC = {"IsotropicLevels": 1}

# With the least share of cells that can be refined: most others are cut by walls, or beside such that are.
CASES = [(0.29, BALL, {"CellSize": 0.2, "RefinementDepth": 2} | ISOTROPIC),
         (0.15, read("cino_spot.obj"), {"CellSize": 0.2, "RefinementDepth": 2} | ISOTROPIC),
         (0.15, read("kcl_exhaust_header_lumens.stl"), {"CellSize": 16, "RefinementDepth": 2} | ISOTROPIC),
         (0.8, BALL, AROUND | {"BoxFrom": "Surface", "CellSize": 0.4} | ISOTROPIC),
         (0.4, BALL, AROUND | {"Layers": 2} | ISOTROPIC)]


def is_valid(folder, *options):
    check = foam.CheckMesh(folder, *options)
    assert check.ok and not check.failures, check.failures
    return check.figures["cells"]


for share, surface, properties in CASES:
    with tempfile.TemporaryDirectory() as folder:
        foam.save(simple.CartesianMesher(Input=surface, **properties), folder)
        is_valid(folder)
        cells, refined, undone, protected = refining.refine_all(folder, 1 if properties.get("Domain") is None else 0)
        print(f"{cells} cells, {protected} protected; refined {refined}, undone {undone}")
        assert undone == cells == is_valid(folder, "-latestTime"), undone
        assert refined > cells and 1 - protected / cells > share, protected / cells

with tempfile.TemporaryDirectory() as folder:
    foam.save(simple.CartesianMesher(Input=BALL, **AROUND | ISOTROPIC), folder)
    moved, cells, refined, undone = refining.drop(folder, (-1.8, 0.6, 0), 0.5, 1.0, 1.6, 0.04)
    print(f"ball: {cells} cells, with it {refined}, at the end {undone}")
    assert moved and refined > cells and undone == cells == is_valid(folder, "-latestTime")
