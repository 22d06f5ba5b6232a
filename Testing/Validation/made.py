# SPDX-License-Identifier: BSD-3-Clause
"""A Poisson problem with a manufactured solution in several surfaces: what walls do to orders."""

import numpy as np
from paraview import simple

import harness
from conduction import errors  # after harness, which finds foam
from wallsurfaces import TURNS, from_proxy, load, sphere, torus

ROOT = np.sqrt(2)


def temperature(p):
    x, y, z = p.T
    return np.exp(x) * np.cos(ROOT * y) * np.exp(z)


def gradient(p):
    x, y, z = p.T
    growth = np.exp(x + z)
    return np.stack([growth * np.cos(ROOT * y), -ROOT * growth * np.sin(ROOT * y), growth * np.cos(ROOT * y)], axis=1)


def case(name, where, surface, length, sizes):
    """`length`: of the solution's waves."""
    return harness.Case(name, f"Manufactured solution in {where[0]}",
        f"e^x cos(1.41 y) e^z, lengths in units of {length:g}, in {' '.join(where)}; laplacianFoam. Errors relative to the temperature range "
        "and the mean wall gradient.",
        surface, sizes, lambda files, turn: errors(files, lambda p: temperature(p / length), lambda p: gradient(p / length) / length))


def cube():
    """None of its walls is along the grid."""
    return from_proxy("cube", simple.Triangulate(Input=simple.Box())).turned(TURNS["by any angles"])


CASE = case("made", ("the first duct", "of the exhaust header (37 mm wide, 390 long)"), load("runner_1"), 100.0, (8.0, 4.0, 2.0))
CASES = (CASE, case("sphere", ("a sphere", "of diameter 1"), sphere(), 0.5, (0.1, 0.05, 0.025)),
    case("torus", ("a torus", "1 wide and 0.25 thick"), torus(), 0.5, (0.05, 0.025, 0.0125)),
    case("cube", ("a cube", "of side 1 at an angle to the grid"), cube(), 0.5, (0.1, 0.05, 0.025)))

if __name__ == "__main__":
    for case in CASES:
        print(f"{case.name}: order of the mean error:", harness.order(harness.run(case), "mean error"))
