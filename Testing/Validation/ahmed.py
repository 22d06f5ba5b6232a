# SPDX-License-Identifier: BSD-3-Clause
"""Half of Ahmed's body with a slant of 25 degrees, on its stilts (Ahmed, Ramm, Faltin 1984; Lienhart, Stoots, Becker 2000)."""

import numpy as np

import harness  # before what it finds
from external import forces
from laminar import STILL
from prisms import circle, triangles
from wallsurfaces import Surface

LENGTH, WIDTH, HEIGHT, CLEARANCE = 1.044, 0.389, 0.288, 0.05
ROUNDING, SLANT, ANGLE = 0.1, 0.222, np.radians(25)
STILTS, STILT = [(x, y) for x in (0.202, 0.672) for y in (-0.1635, 0.1635)], 0.015
SPEED, ITERATIONS = 40.0, 400
AREA = WIDTH * HEIGHT / 2  # of the half


def body():
    """Of sections across x; the flat part of the underside has holes where stilts begin."""
    round_off = [section(ROUNDING * (1 - np.cos(a)), ROUNDING * (1 - np.sin(a))) for a in np.linspace(0, np.pi / 2, 25)]
    straight = [round_off[-1], section(LENGTH - SLANT * np.cos(ANGLE)), section(LENGTH, drop=SLANT * np.sin(ANGLE))]
    below = [of[0][:2] for of in straight] + [of[1][:2] for of in straight[::-1]]
    feet = [circle(STILT, 48, at) for at in STILTS]
    front, back = round_off[0], straight[-1]
    corners = [*sides(round_off, range(4)), *sides(straight, (1, 2, 3)),
        (front[0], front[2], front[1]), (front[0], front[3], front[2]), (back[0], back[1], back[2]), (back[0], back[2], back[3]),
        *facing_down([np.array(below), *(foot[::-1] for foot in feet)], CLEARANCE)]
    for foot in feet:
        corners += facing_down([foot], 0.0)
        corners += sides([[(*p, z) for p in foot] for z in (0.0, CLEARANCE)], range(len(foot)))
    return Surface("ahmed", np.array(corners), np.zeros(len(corners), int), ["body"])


def section(x, inset=0.0, drop=0.0):
    """A rectangle, whose sides are the underside, that of high y, the top, that of low y."""
    y, low, high = WIDTH / 2 - inset, CLEARANCE + inset, CLEARANCE + HEIGHT - inset - drop
    return [(x, -y, low), (x, y, low), (x, y, high), (x, -y, high)]


def sides(rings, which):
    """Triangles between each ring and the next."""
    for a, b in zip(rings, rings[1:]):
        for i in which:
            j = (i + 1) % len(a)
            yield from ((a[i], a[j], b[j]), (a[i], b[j], b[i]))


def facing_down(loops, z):
    return [[(*p, z) for p in triangle[::-1]] for triangle in triangles(loops)]


def measured(files, _):
    mean, deviation = forces(files, SPEED, 0.24, 100.0, STILL, ITERATIONS)
    by = 0.5 * SPEED ** 2 * AREA
    return {"drag coefficient": float(mean[0] / by), "lift coefficient": float(mean[2] / by), "deviation of drag": float(deviation[0] / by),
            "drag to 0.299": float(mean[0] / by / 0.299 - 1)}


CASE = harness.Case("ahmed", "Ahmed's body, slant 25 degrees",
    "Half the body at 40 m/s, above a stationary ground; boxes of 0.2 m, halved five times at the surface, four times around it and "
    "in the near wake; kOmegaSST. Measured: 0.299 at this speed (Lienhart and others), 0.285 at 60 m/s (Ahmed).",
    body(), (0.2 * 4 / 3, 0.2), measured, layers=False, kind="values", depth=5, between=(3, 3), ground=True, outside=((-2.0, 0.0, 0.0), (4.4, 1.6, 1.6)),
    zone=((-0.1, 0.0, 0.0), (1.6, 0.3, 0.45), 4))

if __name__ == "__main__":
    harness.run(CASE)
