# SPDX-License-Identifier: BSD-3-Clause
"""Bodies by rule or formula whose walls need thin layers: a section, a hull, half a truck; and how each is meshed."""

import numpy as np

import ahmed
from prisms import prism, triangles
from wallsurfaces import Surface


def naca0012(points=120):
    """Anticlockwise from the upper end of the trailing edge, which is blunt; denser at both ends. Of chord 1."""
    x = 0.5 * (1 - np.cos(np.linspace(0, np.pi, points)))
    half = 0.6 * (0.2969 * np.sqrt(x) - 0.1260 * x - 0.3516 * x ** 2 + 0.2843 * x ** 3 - 0.1015 * x ** 4)
    upper = np.column_stack([x[::-1], half[::-1]])
    lower = np.column_stack([x[1:], -half[1:]])
    return np.concatenate([upper, lower])


def section():
    """A wing section at rest in a channel of 8 by 6 chords, between two symmetry planes."""
    corners = np.array([(-3, -3), (5, -3), (5, 3), (-3, 3)], float)
    return prism("section", [(corners, ["symmetry_sides", "outlet", "symmetry_sides", "inlet"]), (naca0012()[::-1], "aerofoil")], 0, 0.125)


def hull(length=4.0, breadth=0.4, draught=0.25, stations=96, waterlines=24):
    """Wigley's hull, y = B/2 (1 - (2x/L)^2)(1 - (z/T)^2), with vertical sides above the water: a sharp stem, stern and keel."""
    x = np.linspace(-length / 2, length / 2, stations + 1)
    z = np.concatenate([-draught * np.linspace(1, 0, waterlines + 1), [0.3 * draught]])

    def at(i, j, side):
        below = min(z[j], 0.0)
        return (x[i], side * breadth / 2 * (1 - (2 * x[i] / length) ** 2) * (1 - (below / draught) ** 2), z[j])

    corners = []
    for side in (1, -1):
        for i in range(stations):
            for j in range(len(z) - 1):
                a, b, c, d = at(i, j, side), at(i + 1, j, side), at(i + 1, j + 1, side), at(i, j + 1, side)
                corners += [t if side < 0 else t[::-1] for t in ((a, b, c), (a, c, d))]
    top = len(z) - 1
    for i in range(stations):  # the deck
        a, b, c, d = at(i, top, 1), at(i + 1, top, 1), at(i + 1, top, -1), at(i, top, -1)
        corners += [(a, d, c), (a, c, b)]
    corners = np.array(corners)
    thin = [len({tuple(p) for p in t}) < 3 for t in corners.tolist()]
    corners = corners[~np.array(thin)]
    return Surface("hull", corners, np.zeros(len(corners), int), ["hull"])


def box(low, high):
    x, y, z = zip(low, high)
    p = np.array([(x[i], y[j], z[k]) for i in (0, 1) for j in (0, 1) for k in (0, 1)], float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return [p[list(t)] for q in quads for t in ((q[0], q[1], q[2]), (q[0], q[2], q[3]))]


def truck():
    """A cab and a trailer of boxes with sharp edges, joined, 0.3 above the ground; united by the mesher where they touch."""
    corners = box((0, -1.25, 0.3), (2.2, 1.25, 3.0)) + box((2.2, -0.6, 0.5), (3.0, 0.6, 1.1)) + box((3.0, -1.25, 0.9), (12.0, 1.25, 4.0))
    corners += box((3.0, -0.6, 0.5), (12.0, 0.6, 0.9))
    return Surface("truck", np.array(corners), np.zeros(len(corners), int), ["truck"])


# Name: the surface, Cell Size, local box, walls, and the properties besides.
def cases():
    from wallsurfaces import HEADER, load
    outside = {"Domain": "Outside", "BoxFrom": "Bounds"}
    yield "section", section(), 0.25, 0.25 / 32, ["aerofoil"], {
        "BoundaryRefinement": lambda names: (names.index("aerofoil"), 5, 0, 0),
        "BoundaryNames": ["symmetry*"], "BoundaryTypes": ["symmetry"]}
    yield "ahmed half", ahmed.body(), 0.2, 0.2 / 16, ["body"], outside | {
        "DomainBounds": (-2.0, 4.4, 0.0, 1.6, 0.0, 1.6), "RefinementDepth": 4, "TransitionLayers": 3, "Ground": "zMin"}
    yield "hull", hull(), 0.25, 0.25 / 16, ["hull"], outside | {
        "DomainBounds": (-4.0, 6.0, 0.0, 2.0, -2.0, 0.0), "RefinementDepth": 4, "TransitionLayers": 3}
    yield "truck", truck(), 1.0, 1.0 / 16, ["truck"], outside | {
        "DomainBounds": (-12.0, 36.0, 0.0, 10.0, 0.0, 12.0), "RefinementDepth": 4, "TransitionLayers": 3, "Ground": "zMin"}
    yield "duct", load("runner_1"), 3.0, 3.0, ["wall_1"], {}
