# SPDX-License-Identifier: BSD-3-Clause
"""Conduction between two concentric spheres: the temperature is that of a point's, 1/r."""

import numpy as np
from paraview import simple

import harness
from conduction import errors  # after harness, which finds foam
from wallsurfaces import from_proxy


def temperature(p):
    return 1 / np.linalg.norm(p, axis=1)


def gradient(p):
    return -p / np.linalg.norm(p, axis=1)[:, None] ** 3


def surface():
    outer = simple.Sphere(Radius=1, ThetaResolution=256, PhiResolution=128)
    inner = simple.ReverseSense(Input=simple.Sphere(Radius=0.4, ThetaResolution=128, PhiResolution=64), ReverseCells=1)
    return from_proxy("shell", simple.AppendGeometry(Input=[outer, inner]))


CASE = harness.Case("shell", "Conduction between concentric spheres",
    "Spheres of radius 0.4 and 1 with the temperatures of a point source; laplacianFoam. Errors relative to the temperature range and "
    "the mean wall gradient.",
    surface(), (0.14, 0.07, 0.035), lambda files, turn: errors(files, temperature, gradient))

if __name__ == "__main__":
    print("order of the mean error:", harness.order(harness.run(CASE), "mean error"))
