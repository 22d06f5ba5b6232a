# SPDX-License-Identifier: BSD-3-Clause
"""Laminar flow between two parallel walls: plane Poiseuille's fall of pressure and shear at the walls."""

import numpy as np

import harness  # before what it finds
from laminar import OUTFLOW, SLIP, STILL, Flow, given, in_middle_half
from prisms import prism

HEIGHT, LENGTH, DEPTH, SPEED, VISCOSITY = 1.0, 4.0, 0.4, 1.0, 0.1  # the mean speed: Reynolds number 10
CORNERS = np.array([(0, 0), (LENGTH, 0), (LENGTH, HEIGHT), (0, HEIGHT)])


def measured(files, turn):
    ahead = turn[:, 0]
    centres, vectors = (of[files.of_patch("inlet")] for of in files.face_centres())
    y = centres @ turn[:, 1]
    inflow = np.maximum(6 * SPEED * y * (HEIGHT - y) / HEIGHT ** 2, 0)[:, None] * ahead
    flow = Flow(files, {"wall": STILL, "symmetry": SLIP, "inlet": given(inflow), "outlet": OUTFLOW}, VISCOSITY)
    mean = -np.einsum("ij,ij->", inflow, vectors) / (HEIGHT * DEPTH)
    fall, shear = in_middle_half(files, flow, ahead, LENGTH)
    return {"pressure": float(fall / (12 * VISCOSITY * mean / HEIGHT ** 2) - 1), "wall shear": float(shear / (6 * mean / HEIGHT) - 1),
            "iterations": flow.iterations}


CASE = harness.Case("channel", "Laminar flow between parallel walls",
    "Height 1, length 4, Reynolds number 10; simpleFoam. Pressure drop and wall shear in the middle half, against Poiseuille's. A "
    "grid of N boxes across loses 2 / N^2 of the pressure on either mesh.",
    prism("channel", [(CORNERS, ["wall", "outlet", "wall", "inlet"])], 0, DEPTH), (0.15, 0.075, 0.0375), measured)

if __name__ == "__main__":
    harness.run(CASE)
