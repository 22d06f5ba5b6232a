# SPDX-License-Identifier: BSD-3-Clause
"""Conduction in two solids of conductivities 1 and 10 that touch: concentric spheres, and a slab along nothing of the grid."""

import numpy as np
from paraview import simple

import harness
from regions import INTERFACE, REGIONS, Case
from wallsurfaces import Surface, from_proxy

CONDUCTIVITIES = np.array([1.0, 10.0])
HOLE, MIDDLE, RADIUS = 0.4, 0.7, 1.0
WHAT = "chtMultiRegionSimpleFoam, non-orthogonal corrections in full. Errors of temperature relative to its range, of the heat flow through the interface, and the mean over its faces."


def joined(name, inner, outer, interface):
    parts = inner, outer, interface
    return Surface(name, np.concatenate(parts), np.repeat(range(3), [len(part) for part in parts]), [*REGIONS, INTERFACE])


def ball(radius):
    return from_proxy("ball", simple.Sphere(Radius=radius, ThetaResolution=200, PhiResolution=100)).corners


def in_shells(p):
    """Heat flow 1 / r^2, by conductivity: temperatures of each solid's point source are equal where they meet."""
    r = np.linalg.norm(p, axis=1)
    return 1 / r - 1 / MIDDLE


SHELLS = Case("conjugate", "Two solids: concentric spheres",
    f"Conductivity 1 between radii 0.4 and 0.7, 10 between 0.7 and 1; {WHAT}",
    joined("shells", ball(HOLE)[:, ::-1], ball(RADIUS), ball(MIDDLE)), (0.1, 0.07, 0.05),
    places=((0.55, 0.02, 0.03), (0.85, 0.02, 0.03)), conductivities=CONDUCTIVITIES,
    temperatures=[lambda p, k=k: in_shells(p) / k for k in CONDUCTIVITIES],
    flow=lambda p: p / np.linalg.norm(p, axis=1)[:, None] ** 3)


def slab():
    """1 wide inside, 2 outside, across x."""
    box = from_proxy("box", simple.Triangulate(Input=simple.Box())).corners
    left, right = box + [0.5, 0, 0], box * [2, 1, 1] + [2, 0, 0]
    at_interface = [(part[:, :, 0] == 1).all(axis=1) for part in (left, right)]
    return joined("slab", left[~at_interface[0]], right[~at_interface[1]], left[at_interface[0]])


SLANT = harness.rotation(30)
AHEAD = SLANT[:, 0]
SLAB = Case("slab", "Two solids: a slab",
    f"Conductivity 1 and width 1, then 10 and width 2, temperatures linear across it; rotated by 30 degrees about two axes; {WHAT}",
    harness.turned(slab(), SLANT), (0.2, 0.1, 0.05),
    places=np.array([(0.52, 0.02, 0.03), (2.02, 0.02, 0.03)]) @ SLANT.T, conductivities=CONDUCTIVITIES,
    temperatures=[lambda p, k=k: (1 - p @ AHEAD) / k for k in CONDUCTIVITIES], flow=lambda p: np.broadcast_to(AHEAD, p.shape))
CASES = SHELLS, SLAB

if __name__ == "__main__":
    for case in CASES:
        harness.run(case)
