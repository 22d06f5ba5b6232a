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


def lofted(sections):
    """Triangles around closed sections of as many points each, and across both ends, out of the body where sections are
    anticlockwise as seen against the way from the first to the last."""
    corners = []
    for low, high in zip(sections[:-1], sections[1:]):
        for a, b, c, d in zip(low, np.roll(low, -1, 0), np.roll(high, -1, 0), high):
            corners += [(a, b, c), (a, c, d)]
    for section, outwards in (sections[0], -1), (sections[-1], 1):
        middle = section.mean(0)
        corners += [(middle, a, b)[::outwards] for a, b in zip(section, np.roll(section, -1, 0))]
    corners = np.array(corners)
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return corners[areas > 0]


def body(name, *parts):
    corners = np.concatenate(parts)
    return Surface(name, corners, np.zeros(len(corners), int), [name])


def aerofoils(stations, points=60):
    """NACA 0012 at (span, chord, twist in degrees, sweep): in the plane of x and z, along y."""
    outline = naca0012(points) - (0.25, 0)
    sections = []
    for span, chord, twist, sweep in stations:
        c, s = np.cos(np.radians(twist)), np.sin(np.radians(twist))
        x, z = chord * (outline @ np.array([[c, -s], [s, c]])).T
        sections.append(np.column_stack([x + sweep, np.full(len(x), span), z])[::-1])
    return sections


def wing():
    """Swept and tapered, with a cut trailing edge and a cut tip, through the symmetry plane y = 0."""
    return body("wing", lofted(aerofoils([(y, 1 - 0.5 * y / 1.5, 0, 0.3 * y) for y in np.linspace(-0.2, 1.5, 18)])))


def blade():
    """Of a rotor: its chord falls from 0.25 to 0.1, its twist from 40 to 6 degrees."""
    return body("blade", lofted(aerofoils(
        [(r, 0.25 - 0.15 * (r - 0.2) / 0.8, 40 - 34 * ((r - 0.2) / 0.8) ** 0.6, 0) for r in np.linspace(0.2, 1, 33)])))


def car(points=72):
    """A body of oval sections, rounder at the ends, and four wheels that stand on the ground, z = 0."""
    angle = 2 * np.pi * np.arange(points) / points
    sections = []
    for x in np.concatenate([1 - np.cos(np.linspace(0, np.pi, 61))]) * 2:
        along = abs(x / 2 - 1)
        thick = (1 - along ** 4) ** 0.5
        if thick < 0.02:
            continue
        roof = 0.55 * np.exp(-((x - 2.2) / 0.9) ** 4)
        y = 0.85 * thick * np.sign(np.cos(angle)) * np.abs(np.cos(angle)) ** 0.5
        z = np.sign(np.sin(angle)) * np.abs(np.sin(angle)) ** 0.5 * 0.33 * thick
        z = 0.55 + z + np.where(z > 0, roof * z / 0.33, 0)
        sections.append(np.column_stack([np.full(points, x), y, z]))
    wheels = []
    for x in 0.8, 3.2:
        for y in (-0.8, -0.58), (0.58, 0.8):
            circle = [np.column_stack([x + 0.3 * np.sin(angle), np.full(points, at), 0.28 + 0.3 * np.cos(angle)]) for at in y]
            wheels.append(lofted(circle))
    return body("car", lofted(sections), *wheels)


def propeller(blades=3, points=48):
    """Of a ship: broad twisted blades with round tips in a hub with round ends. Its axis is y."""
    stations = []
    for r in 1 - (1 - np.linspace(0, 1, 25) ** 1.5) * 0.85:
        chord = 0.45 * np.sqrt(max(1 - ((r - 0.55) / 0.455) ** 2, 0.02))
        stations.append((r, chord, np.degrees(np.arctan2(0.9, 2 * np.pi * r)), -0.25 * chord))
    one = lofted(aerofoils(stations, 40))[:, :, [0, 2, 1]]  # span along z
    one = one[:, ::-1]
    parts = []
    for k in range(blades):
        c, s = np.cos(2 * np.pi * k / blades), np.sin(2 * np.pi * k / blades)
        # The chord of a blade without twist lies in the plane of rotation: x is across the axis.
        parts.append(one @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T)
    angle = 2 * np.pi * np.arange(points) / points
    along = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 33))[1:-1]
    hub = [np.column_stack([0.22 * (1 - a ** 4) ** 0.5 * np.cos(angle), np.full(points, 0.35 * a), 0.22 * (1 - a ** 4) ** 0.5 * np.sin(angle)])
           for a in along]
    return body("propeller", lofted([h[::-1] for h in hub]), *parts)


def tee(points=96):
    """Two pipes that meet at 60 degrees, of radius 0.5 and 0.35: what flows inside."""
    angle = 2 * np.pi * np.arange(points) / points
    unit = np.column_stack([np.zeros(points), np.cos(angle), np.sin(angle)])
    main = lofted([0.5 * unit + (x, 0, 0) for x in (-2, 2)])
    c, s = np.cos(np.radians(60)), np.sin(np.radians(60))
    turn = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    branch = lofted([(0.35 * unit + (x, 0, 0)) @ turn for x in (0, 2.2)])
    corners = np.concatenate([main, branch])
    ends = [len(main) - 2 * points, len(main) - points, len(corners) - 2 * points, len(corners) - points]
    boundary = np.zeros(len(corners), int)
    for at, first in ((1, ends[0]), (2, ends[1]), (0, ends[2]), (3, ends[3])):
        boundary[first:first + points] = at
    return Surface("tee", corners, boundary, ["wall", "inlet", "outlet", "inlet_branch"])


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
    yield "wing", wing(), 0.5, 0.5 / 32, ["wing"], outside | {
        "DomainBounds": (-4.0, 8.0, 0.0, 5.0, -4.0, 4.0), "RefinementDepth": 5, "TransitionLayers": 3}
    yield "blade", blade(), 0.1, 0.1 / 16, ["blade"], outside | {
        "DomainBounds": (-1.0, 1.0, -0.3, 1.7, -1.0, 1.0), "RefinementDepth": 4, "TransitionLayers": 3}
    yield "propeller", propeller(), 0.5, 0.5 / 32, ["propeller"], outside | {
        "DomainBounds": (-3.0, 3.0, -3.0, 5.0, -3.0, 3.0), "RefinementDepth": 5, "TransitionLayers": 3}
    yield "car", car(), 1.0, 1.0 / 32, ["car"], outside | {
        "DomainBounds": (-6.0, 16.0, 0.0, 6.0, 0.0, 6.0), "RefinementDepth": 5, "TransitionLayers": 3, "Ground": "zMin"}
    yield "tee", tee(), 0.07, 0.07, ["wall"], {}
