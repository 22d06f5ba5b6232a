# SPDX-License-Identifier: BSD-3-Clause
"""Laminar flow through a pipe that is along nothing of the grid: Poiseuille's fall of pressure and shear at the wall."""

import numpy as np

import harness  # before what it finds
from laminar import OUTFLOW, STILL, Flow, given, in_middle_half
from wallsurfaces import TILTED, tilted_pipe

RADIUS, LENGTH, SPEED, VISCOSITY = 15.0, 150.0, 1.0, 3.0  # the mean speed: Reynolds number 10


def measured(files, turn):
    axis = TILTED @ turn.T
    centres, vectors = (of[files.of_patch("inlet")] for of in files.face_centres())
    square = ((centres - (centres @ axis)[:, None] * axis) ** 2).sum(axis=1)
    inflow = np.maximum(2 * SPEED * (1 - square / RADIUS ** 2), 0)[:, None] * axis
    flow = Flow(files, {"wall": STILL, "inlet": given(inflow), "outlet": OUTFLOW}, VISCOSITY)
    mean = -np.einsum("ij,ij->", inflow, vectors) / (np.pi * RADIUS ** 2)
    fall, shear = in_middle_half(files, flow, axis, LENGTH)
    return {"pressure": float(fall / (8 * VISCOSITY * mean / RADIUS ** 2) - 1), "wall shear": float(shear / (4 * mean / RADIUS) - 1),
            "iterations": flow.iterations}


CASE = harness.Case("pipe", "Laminar flow through a pipe",
    "Radius 15, along (1, 0.6, 0.35), Reynolds number 10; simpleFoam. Pressure drop and wall shear in the middle half, against "
    "Poiseuille's.",
    tilted_pipe(level=False), (5.0, 2.5, 1.25), measured)

if __name__ == "__main__":
    print("order of the pressure:", harness.order(harness.run(CASE), "pressure"))
