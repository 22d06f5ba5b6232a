# SPDX-License-Identifier: BSD-3-Clause
"""What a mesh costs a solver: the time step that its worst cell allows, and iterations of multigrid."""

import re

import numpy as np

import harness
from conduction import solve  # after harness, which finds foam
from made import temperature
from wallsurfaces import DATA, load, sphere

COURANT, AHEAD = 0.9, np.ones(3) / np.sqrt(3)
SOLUTION = """solvers { T { solver GAMG; smoother GaussSeidel; tolerance 0; relTol 1e-6; maxIter 500; } }
SIMPLE { nNonOrthogonalCorrectors 0; }"""


def measured(files, length, turn):
    flows = np.abs(files.face_centres()[1] @ (turn @ AHEAD))
    through = np.bincount(files.owner, flows, files.cells) + np.bincount(files.neighbour, flows[:len(files.neighbour)], files.cells)
    said = solve(files, {name: "zeroGradient;" for name in files.patches}, SOLUTION, start=temperature(files.centres() / length))[1]
    return {"time step": float((COURANT * 2 * files.volumes() / through).min()),
            "GAMG iterations": int(re.search(r"No Iterations (\d+)", said)[1])}


def case(name, where, surface, length, sizes):
    """`length`: of the waves that multigrid begins with."""
    return harness.Case(f"timestep_{name}", f"Explicit time step and iterations: {where}",
        "The largest time step with a Courant number of at most 0.9, for speed 1 along (1, 1, 1); and GAMG iterations with GaussSeidel to "
        "1e-6 of the residual, laplacianFoam with zero gradient on walls, as for pressure.",
        surface, sizes, lambda files, turn: measured(files, length, turn), kind="costs")


CASES = (case("sphere", "a sphere of diameter 1", sphere(), 0.5, (0.1, 0.05, 0.025)),
    case("duct", "the exhaust header's first duct", load("runner_1"), 100.0, (8.0, 4.0, 2.0)),
    case("spot", "a cow, 1.7 long", load(str(DATA / "cino_spot.obj")), 0.5, (0.1, 0.05, 0.025)))

if __name__ == "__main__":
    for case in CASES:
        harness.run(case)
