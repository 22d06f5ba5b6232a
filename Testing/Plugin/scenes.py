"""Random scenes to mesh: the same for the same number. Bodies in one or several regions, sheets, layers, sizes, turns."""

import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray

from pipeline import polydata


def box(low, high):
    points = [[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)]
    sides = (0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)
    return points, [t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))]


def round_body(rows, columns, radii):
    """An ellipsoid of rings of points."""
    points = [[0, 0, -radii[2]]]
    for i in range(1, rows):
        v = np.pi * (i / rows - 0.5)
        points += [[radii[0] * np.cos(v) * np.cos(u), radii[1] * np.cos(v) * np.sin(u), radii[2] * np.sin(v)]
                   for u in np.arange(columns) * 2 * np.pi / columns]
    points.append([0, 0, radii[2]])
    ring = lambda i, k: 1 + (i - 1) * columns + k % columns
    triangles = []
    for k in range(columns):
        triangles += [(0, ring(1, k + 1), ring(1, k)), (len(points) - 1, ring(rows - 1, k), ring(rows - 1, k + 1))]
        for i in range(1, rows - 1):
            triangles += [(ring(i, k), ring(i, k + 1), ring(i + 1, k + 1)), (ring(i, k), ring(i + 1, k + 1), ring(i + 1, k))]
    return points, triangles


def prism(sides, radius, height, sharpness=1.0):
    """Over a polygon, or over a wedge of it."""
    angles = np.arange(sides) * 2 * np.pi / sides
    outline = np.stack([radius * np.cos(angles), sharpness * radius * np.sin(angles)], 1)
    points = [[x, y, z] for z in (-height / 2, height / 2) for x, y in outline]
    triangles = []
    for i in range(sides):
        k = (i + 1) % sides
        triangles += [(i, k, sides + k), (i, sides + k, sides + i)]
    for i in range(1, sides - 1):
        triangles += [(0, i + 1, i), (sides, sides + i, sides + i + 1)]
    return points, triangles


def sheet(random):
    """An open rectangle through the middle, as it is or turned."""
    reach = random.choice([0.3, 0.8, 1.2])
    points = np.array([[0.03, -reach, -reach], [0.03, reach, -reach], [0.03, reach, reach], [0.03, -reach, reach]])
    return points @ turn(random).T if random.random() < 0.7 else points, [(0, 1, 2), (0, 2, 3)]


def turn(random):
    q, _ = np.linalg.qr(random.standard_normal((3, 3)))
    return q * np.sign(np.linalg.det(q))


def body(random):
    kind = random.integers(4)
    if kind == 0:
        half = random.uniform(0.2, 1, 3)
        return box(-half, half)
    if kind == 1:
        return round_body(int(random.integers(4, 10)), int(random.integers(6, 16)), random.uniform(0.3, 1, 3))
    return prism(int(random.integers(3, 9)), 1, random.uniform(0.1, 1.5), random.uniform(0.2, 1))


class Parts:
    """Surfaces put together, each with a name of its boundary and of its region."""

    def __init__(self):
        self.points, self.triangles, self.walls, self.regions = [], [], [], []

    def add(self, part, wall, region="one", by=np.eye(3), at=(0, 0, 0)):
        points, triangles = part
        first = len(self.points)
        self.points += (np.array(points, float) @ by.T + at).tolist()
        self.triangles += [tuple(first + i for i in t) for t in triangles]
        self.walls += [wall] * len(triangles)
        self.regions += [region] * len(triangles)

    def data(self, scale):
        data = polydata(np.array(self.points) * scale, self.triangles)
        for name, texts in ("Wall", self.walls), ("Part", self.regions):
            array = vtkStringArray()
            array.SetName(name)
            for text in texts:
                array.InsertNextValue(text)
            data.GetCellData().AddArray(array)
        return data


def one_body(random, parts):
    parts.add(body(random), "wall", by=turn(random))
    if random.random() < 0.3:
        parts.add(body(random), "other", by=0.5 * turn(random), at=random.uniform(-0.8, 0.8, 3))
    return {}


def with_baffle(random, parts):
    parts.add(box([-1, -1, -1], [1, 1, 1]) if random.random() < 0.5 else body(random), "wall",
              by=turn(random) if random.random() < 0.7 else np.eye(3))
    parts.add(sheet(random), "plate")
    return {"BoundaryNames": ["plate"], "BoundaryTypes": ["baffle"]}


def with_doubled_sheet(random, parts):
    parts.add(box([-1, -1, -1], [1, 1, 1]), "wall", by=turn(random))
    points, triangles = sheet(random)
    points = np.array(points) * 0.5
    parts.add((points, triangles), "plate")
    parts.add((points, [t[::-1] for t in triangles]), "plate")
    return {}


def nested(random, parts):
    by = turn(random)
    if random.random() < 0.3:  # of two bodies that overlap the first wins
        parts.add(body(random), "third", "third", 0.3 * turn(random), random.uniform(-0.8, 0.8, 3))
    parts.add(body(random), "inner", "fluid", 0.45 * turn(random), random.uniform(-0.1, 0.1, 3))
    parts.add(box([-1, -1, -1], [1, 1, 1]), "outer", "solid", by)
    return {"RegionsFrom": "Array", "RegionArray": "Part"}


def side_by_side(random, parts):
    by = turn(random) if random.random() < 0.7 else np.eye(3)
    cut = random.uniform(-0.9, 0.9)
    if random.random() < 0.4:
        parts.add(body(random), "ball", "ball", 0.5 * turn(random))
    parts.add(box([-1, -1, -1], [cut, 1, 1]), "left", "left", by)
    parts.add(box([cut, -random.uniform(0.5, 1), -1], [1, 1, random.uniform(0.2, 1)]), "right", "right", by)
    return {"RegionsFrom": "Array", "RegionArray": "Part"}


KINDS = one_body, one_body, with_baffle, with_doubled_sheet, nested, side_by_side


def make(number):
    """A surface, and the mesher's properties."""
    random = np.random.default_rng(number)
    parts = Parts()
    properties = {"BoundaryArray": "Wall", **KINDS[number % len(KINDS)](random, parts)}
    scale = random.choice([0.01, 1, 1, 100])
    properties["CellSize"] = scale * random.choice([0.12, 0.18, 0.25, 0.4, 0.7])
    if random.random() < 0.2:
        properties["PatchMethod"] = "Exact Fit"
    elif random.random() < 0.3:
        properties["Layers"] = int(random.integers(1, 4))
    if random.random() < 0.2:
        properties["RefinementDepth"] = 1
    if random.random() < 0.15:
        properties["CollapseRatio"] = 0.0
    return parts.data(scale), properties
