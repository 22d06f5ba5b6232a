# SPDX-License-Identifier: BSD-3-Clause
"""Lid-driven cavity at Reynolds number 100, that lies along nothing of the grid: velocities on its centrelines of Marchi, Suero and
Araki (2009, 1024 x 1024 with Richardson's extrapolation). Ghia's (1982) are by up to 0.009 beside those, and where fine grids go."""

import numpy as np

import harness  # before what it finds
from laminar import SLIP, STILL, Flow, along, given
from prisms import prism

DEPTH, VISCOSITY = 0.2, 0.01  # of a cavity of size 1, with a lid that moves by 1
TILT = np.array([[np.sqrt(3) / 2, -0.5], [0.5, np.sqrt(3) / 2]])  # by 30 degrees
CORNERS = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
STATIONS = np.arange(1, 16) / 16
U = np.array([-0.041975, -0.077125, -0.109816, -0.141930, -0.172712, -0.198471, -0.212962, -0.209149, -0.182081, -0.131256, -0.060246,
              0.027874, 0.140425, 0.310557, 0.597467])  # at x = 0.5
V = np.array([0.094808, 0.149243, 0.174343, 0.179243, 0.169132, 0.145730, 0.108776, 0.057537, -0.007749, -0.084067, -0.163010,
              -0.227827, -0.253769, -0.218691, -0.123318])  # at y = 0.5


def measured(files, turn):
    axes = turn[:, :2] @ TILT  # columns: along the lid, and up
    faces, cells = files.face_centres()[0], files.centres() @ axes
    lid = along(files, "lid", np.tile(axes[:, 0], (files.patches["lid"][2], 1)))
    flow = Flow(files, {"wall": STILL, "lid": given(lid), "symmetry": SLIP}, VISCOSITY, iterations=1500)
    walls = np.concatenate([faces[files.of_patch(name)] @ axes for name in ("wall", "lid")])
    at = np.concatenate([cells, walls])
    velocity = np.concatenate([flow.velocity @ axes, np.zeros((len(walls) - len(lid), 2)), lid @ axes])
    reach = 2.5 * np.median(files.volumes()) ** (1 / 3)
    u = [fitted(at, velocity[:, 0], (0.5, y), reach) for y in STATIONS] - U
    v = [fitted(at, velocity[:, 1], (x, 0.5), reach) for x in STATIONS] - V
    return {"mean of u": np.abs(u).mean(), "largest of u": np.abs(u).max(), "mean of v": np.abs(v).mean(),
            "largest of v": np.abs(v).max(), "iterations": flow.iterations}


def fitted(at, values, place, reach):
    """By a polynomial of second degree through what is near, the nearer the better."""
    away = np.linalg.norm(at - place, axis=1)
    near = away < reach
    x, y = ((at - place)[near] / reach).T
    weights = 1 - away[near] / reach
    terms = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=1)
    return float(np.linalg.lstsq(terms * weights[:, None], values[near] * weights, rcond=None)[0][0])


CASE = harness.Case("cavity", "Lid-driven cavity, Reynolds number 100",
    "Size 1, rotated by 30 degrees about z; simpleFoam. Velocities on the centrelines relative to the lid's, minus Marchi, Suero and "
    "Araki's.",
    prism("cavity", [(CORNERS @ TILT.T, ["wall", "wall", "lid", "wall"])], 0, DEPTH), (0.08, 0.045, 0.025), measured)

if __name__ == "__main__":
    harness.run(CASE)
