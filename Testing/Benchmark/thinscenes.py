# SPDX-License-Identifier: BSD-3-Clause
"""Thin things by rule, to be meshed: sheets whose rims end in the flow (RIMS), and random scenes of plates, fins, slots,
bent metal, rods, wedges and sheets, thinner than boxes, as thick, and wider (thin). Each is a Scene."""

import math

import numpy as np

RIM_BOX = 0.25  # of which the gaps and strips of RIMS are parts
THIN_BOX = 0.05  # of which thicknesses of random scenes are parts
PARTS_OF_BOX = 0.05, 0.2, 0.5, 1, 1.5, 2.5  # from what vanishes in a box to what has boxes in it
CORNERS = (0, 0), (1, 0), (1, 1), (0, 1)
SIDES = (0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)


class Scene:
    """Polygons, each of a boundary."""

    def __init__(self):
        self.points, self.polygons = [], {}

    def add(self, points, polygons, wall, by=None):
        """`by`: a matrix that turns them first."""
        first = len(self.points)
        self.points += list(np.asarray(points, float) @ (np.eye(3) if by is None else by).T)
        self.polygons.setdefault(wall, []).extend([first + i for i in polygon] for polygon in polygons)

    def sheet(self, points, wall="sheet", by=None):
        """A flat one: its outline, for each side; in the same triangles."""
        first, *others = range(len(points))
        self.add(points, [[first, *others], [first, *others[::-1]]], wall, by)

    def rectangle(self, u, v, at=(0, 0, 0), parts=1, by=None):
        """A sheet about a point, along two vectors; in parts x parts rectangles."""
        for i, k in np.ndindex(parts, parts):
            corners = (np.array(CORNERS) + (i, k)) / parts - 0.5
            self.sheet(corners @ np.array([u, v], float) + at, by=by)

    def box(self, centre, lengths, by=None, wall="body"):
        corners = np.array([[k >> axis & 1 for axis in range(3)] for k in range(8)]) - 0.5
        self.add(corners * lengths + centre, SIDES, wall, by)

    def turned(self, by):
        self.points = [by @ point for point in self.points]
        return self

    def write(self, path):
        """As OBJ, in triangles."""
        with open(path, "w", encoding="utf-8") as file:
            file.writelines("v %.9g %.9g %.9g\n" % tuple(point) for point in self.points)
            for wall, polygons in self.polygons.items():
                file.write(f"g {wall}\n")
                for first, *others in polygons:
                    file.writelines(f"f {first + 1} {a + 1} {b + 1}\n" for a, b in zip(others, others[1:]))


def rotation(axis, degrees):
    angle = math.radians(degrees)
    u, v, matrix = (axis + 1) % 3, (axis + 2) % 3, np.eye(3)
    matrix[[u, v], [u, v]] = math.cos(angle)
    matrix[u, v], matrix[v, u] = -math.sin(angle), math.sin(angle)
    return matrix


def rotations(turns):
    """By degrees about axes, one after the other."""
    matrix = np.eye(3)
    for axis, degrees in turns:
        matrix = rotation(axis, degrees) @ matrix
    return matrix


# ---- Rims of sheets

ASKEW = (2, 25), (0, 40)
WIDE = (3, 0, 0), (0, 2, 0)


def rims(*rectangles, turns=ASKEW, cube=False):
    """Sheets: each the arguments of rectangle()."""
    scene = Scene()
    if cube:
        scene.box((0, 0, -1), (2, 2, 2), wall="cube")
    for rectangle in rectangles:
        scene.rectangle(*rectangle)
    return scene.turned(rotations(turns))


def disc():
    scene, angles = Scene(), np.arange(64) * 2 * math.pi / 64
    scene.sheet(1.2 * np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1))
    return scene.turned(rotations(ASKEW))


def above(boxes):
    return (0, 0, boxes * RIM_BOX)


UPRIGHT = (3, 0, 0), (0, 0, 1)
RIMS = {
    "flat": lambda: rims(WIDE, turns=()),
    "between planes": lambda: rims((*WIDE, (0.07, 0.03, 0.06)), turns=()),
    "turned": lambda: rims(WIDE),
    "turned little": lambda: rims(WIDE, turns=((2, 8), (0, 5))),
    "disc": disc,
    "tee": lambda: rims((*WIDE, (0, 0, 0), 2), (*UPRIGHT, (0, 0, 0.5), 2)),
    "tee with gap": lambda: rims(WIDE, (*UPRIGHT, (0, 0, 0.5 + 0.3 * RIM_BOX))),
    "parallel, 0.3 boxes apart": lambda: rims(WIDE, (*WIDE, above(0.3))),
    "parallel, 0.8 boxes apart": lambda: rims(WIDE, (*WIDE, above(0.8))),
    "strip of 0.3 boxes": lambda: rims(((3, 0, 0), (0, 0.3 * RIM_BOX, 0))),
    "strip of 0.8 boxes": lambda: rims(((3, 0, 0), (0, 0.8 * RIM_BOX, 0))),
    "ends near a wall": lambda: rims((*UPRIGHT, (0, 0.3, 0.5 + 0.3 * RIM_BOX)), cube=True),
    "through a wall": lambda: rims(((1.5, 0, 0), (0, 0, 1), (0, 0.3, 0.4)), cube=True),
    "crossing": lambda: rims(WIDE, ((2, 0.3, 0.4), (0, 0.2, 1.5))),
    "wedge": lambda: rims(WIDE, ((3, 0, 0), (0, 1.7, 0.8), above(0.1))),
}


# ---- Random scenes

def any_turn(random):
    q, _ = np.linalg.qr(random.standard_normal((3, 3)))
    return q * np.sign(np.linalg.det(q))


def thickness(random):
    return THIN_BOX * random.choice(PARTS_OF_BOX)


def plate_with_fins(random, scene, by):
    scene.box((0, 0, 0), (1, 0.7, thickness(random)), by)
    for i in range(4):
        scene.box((-0.4 + 0.27 * i, 0, 0.15), (thickness(random), random.uniform(0.3, 0.7), 0.3), by)


def slots(random, scene, by):
    gap = min(thickness(random), 0.15)
    for i in range(3):
        scene.box((0, 0, 0.2 * i), (1, 0.6, 0.2 - gap), by)
    scene.box((-0.45, 0, 0.2), (0.1, 0.6, 0.6), by)


def tee_and_cross(random, scene, by):
    scene.box((0, 0, 0), (1, 0.8, thickness(random)), by)
    scene.box((0.1, 0, 0.25), (thickness(random), 0.6, 0.5), by)
    scene.box((0, 0.1, 0.1), (0.7, thickness(random), 0.6), by)


def arc(radius, degrees, steps):
    angles = np.radians(np.linspace(0, degrees, steps + 1))
    return np.stack([radius * np.cos(angles), radius * np.sin(angles)], axis=1)


def bent_metal(random, scene, by, steps=24):
    """An arc of a pipe's wall."""
    radius, degrees = random.uniform(0.2, 0.6), random.uniform(45, 260)
    inner, outer = (arc(r, degrees, steps) for r in (radius, radius + thickness(random)))
    # Of each step: inner and outer, low and high.
    points = [(*p, z) for a, b in zip(inner, outer) for p in (a, b) for z in (-0.3, 0.3)]
    sides = (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)
    ends = [(0, 2, 3, 1), [4 * steps + i for i in (0, 1, 3, 2)]]
    scene.add(points, ends + [[4 * step + i for i in side] for step in range(steps) for side in sides], "body", by)


def rods(random, scene, _):
    for _ in range(4):
        lengths = random.uniform(0.4, 1), thickness(random), thickness(random)
        scene.box(random.uniform(-0.3, 0.3, 3), lengths, any_turn(random))


def wedge_of_plates(random, scene, by):
    scene.box((0.3, 0, 0), (0.9, 0.5, thickness(random)), by)
    scene.box((0.3, 0.02, 0), (0.8, 0.5, thickness(random)), by @ rotation(1, random.uniform(5, 30)))


def sheets(random, scene, by):
    """Which cross each other, end in each other, or are near."""
    for _ in range(random.integers(1, 4)):
        at = by @ random.uniform(-0.3, 0.3, 3)
        own = by if random.random() < 0.4 else any_turn(random)
        if random.random() < 0.3:
            outline = np.column_stack([arc(random.uniform(0.1, 0.5), 360, 32)[:-1], np.zeros(32)])
            scene.sheet(outline @ own.T + at)
        else:
            width = random.choice([thickness(random), random.uniform(0.2, 0.8)])
            scene.rectangle(own @ (random.uniform(0.5, 1), 0, 0), own @ (0, width, 0), at)


def bent_sheet(random, scene, by, steps=16):
    """And a flat one beside it."""
    line = arc(random.uniform(0.2, 0.6), random.uniform(45, 260), steps)
    points = [(*p, z) for p in line for z in (-0.3, 0.3)]
    quads = [[2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1] for i in range(steps)]
    scene.add(points, quads + [quad[::-1] for quad in quads], "sheet", by)
    if random.random() < 0.5:
        scene.rectangle(by @ (0.6, 0, 0), by @ (0, 0, 0.6), by @ (0, -thickness(random), 0))


def body_with_sheets(random, scene, by):
    """They stand on it, end in it, or end beside it."""
    scene.box((0, 0, -0.2), (0.8, 0.6, 0.4), by)
    for x in (-0.2, 0.15):
        height = random.uniform(0.1, 0.5)
        foot = random.choice([-0.05, 0, thickness(random)])
        scene.rectangle(by @ (0, random.uniform(0.2, 0.8), 0), by @ rotation(1, random.uniform(-20, 20)) @ (0, 0, height),
                        by @ (x, 0, foot + height / 2))


CLOSED = plate_with_fins, slots, tee_and_cross, bent_metal, rods, wedge_of_plates
OPEN = sheets, bent_sheet, body_with_sheets
KINDS = CLOSED + OPEN


def thin(number):
    """The kind's name, the scene, and whether it is to be meshed inside: the same for the same number."""
    random = np.random.default_rng(number)
    kind = KINDS[number % len(KINDS)]
    scene = Scene()
    kind(random, scene, any_turn(random) if random.random() < 0.75 else np.eye(3))
    return kind.__name__.replace("_", " "), scene, kind in CLOSED and random.random() < 0.5
