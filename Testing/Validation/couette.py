# SPDX-License-Identifier: BSD-3-Clause
"""Taylor and Couette's flow between two cylinders of which the inner one turns, slowly: torques and velocity are exact."""

import numpy as np

import harness  # before what it finds
from laminar import SLIP, STILL, Flow, along, given, wall_gradient
from prisms import circle, prism

INNER, OUTER, DEPTH, TURNING, VISCOSITY = 0.5, 1.0, 0.28, 2.0, 0.02  # Reynolds number of the gap 25; vortices begin at 68
TORQUE = 4 * np.pi * VISCOSITY * TURNING / (INNER ** -2 - OUTER ** -2)  # by depth


def measured(files, turn):
    axis = turn[:, 2]
    moving = along(files, "inner", TURNING * np.cross(axis, files.face_centres()[0][files.of_patch("inner")]))
    flow = Flow(files, {"inner": given(moving), "outer": STILL, "symmetry": SLIP}, VISCOSITY, iterations=1000)
    ahead = np.cross(axis, files.centres())
    # A wall that turns feels what velocity changes less what turns with it.
    torques = {"torque inside": -torque(axis, *wall_gradient(files, "inner", flow.velocity - TURNING * ahead)),
               "torque outside": torque(axis, *wall_gradient(files, "outer", flow.velocity))}
    radius = np.linalg.norm(ahead, axis=1)
    exact = TURNING * (1 / radius - radius / OUTER ** 2) / (INNER ** -2 - OUTER ** -2)
    error = np.abs(np.einsum("ij,ij->i", flow.velocity, ahead) / radius - exact)
    return {name: float(found / TORQUE - 1) for name, found in torques.items()} | {
        "velocity": float(np.average(error, weights=files.volumes()) / (TURNING * INNER)), "iterations": flow.iterations}


def torque(axis, gradient, centres, sizes):
    return VISCOSITY / DEPTH * np.einsum("ij,ij,i->", np.cross(axis, centres), gradient, sizes)


def loop(radius):
    return circle(radius, 360, equal_area=True)


CASE = harness.Case("couette", "Laminar flow between cylinders, the inner one rotating",
    "Radii 0.5 and 1, gap Reynolds number 25; simpleFoam, with no prescribed pressure. Torque on each cylinder, and the "
    "mean error of the tangential velocity relative to that of the inner cylinder.",
    prism("gap", [(loop(OUTER), "outer"), (loop(INNER)[::-1], "inner")], 0, DEPTH), (0.12, 0.06, 0.03), measured)

if __name__ == "__main__":
    harness.run(CASE)
