# SPDX-License-Identifier: BSD-3-Clause
"""A Poisson problem with a made solution in the exhaust header's first duct: what real walls do to orders."""

import numpy as np

import harness
from conduction import errors  # after harness, which finds foam
from wallsurfaces import load

LENGTH = 100.0  # mm: of its waves
ROOT = np.sqrt(2)


def temperature(p):
    x, y, z = p.T / LENGTH
    return np.exp(x) * np.cos(ROOT * y) * np.exp(z)


def gradient(p):
    x, y, z = p.T / LENGTH
    growth = np.exp(x + z)
    return np.stack([growth * np.cos(ROOT * y), -ROOT * growth * np.sin(ROOT * y), growth * np.cos(ROOT * y)], axis=1) / LENGTH


CASE = harness.Case("made", "A made solution in a duct",
    "e^x cos(1.41 y) e^z, with lengths in 100 mm, in the first duct of the exhaust header (37 mm wide, 390 long); "
    "laplacianFoam. Errors by the span of temperatures and the mean gradient at the walls.",
    load("runner_1"), (8.0, 4.0, 2.0), lambda files, turn: errors(files, temperature, gradient))

if __name__ == "__main__":
    print("order of the mean error:", harness.order(harness.run(CASE), "mean error"))
