# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces for wallcells.py: triangles of named solids, from files or generated."""

import math
import pathlib

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

SHARP = 30  # degrees: Feature Angle's default
TURNS = {"as it is": (), "by 20": ((2, 20),), "by 10, 20, 30": ((0, 10), (1, 20), (2, 30)),
         "by any angles": ((0, 17.3), (1, 41.9), (2, 63.7))}  # about axes, as in Mesher/TestFidelity.cpp
DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
HEADER = DATA / "kcl_exhaust_header_lumens.stl"
TILTED = np.array([1, 0.6, 0.35]) / np.linalg.norm([1, 0.6, 0.35])
# Not along anything.
RAY = np.array([0.3127, 0.5171, 0.7969]) / np.linalg.norm([0.3127, 0.5171, 0.7969])


class Triangles:
    """Corners of triangles (n, 3, 3), and the nearest of them to any points."""

    def __init__(self, corners):
        self.corners = corners
        vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
        self.areas = np.linalg.norm(vectors, axis=1)
        self.normals = vectors / np.maximum(self.areas, 1e-300)[:, None]
        self.locator = None

    def volume(self):
        """Signed: positive if the normals point outward."""
        a, b, c = np.moveaxis(self.corners - self.corners.mean(axis=(0, 1)), 1, 0)
        return np.einsum("ij,ij->", a, np.cross(b, c)) / 6

    def nearest(self, points):
        """Distance of each point, and the triangle that is nearest to it."""
        if self.locator is None:
            self.data = polydata(self.corners.reshape(-1, 3),
                                 np.arange(3 * len(self.corners)).reshape(-1, 3))
            self.locator = vtkStaticCellLocator()
            self.locator.SetDataSet(self.data)
            self.locator.BuildLocator()
        at, cell, part, square = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
        squares, cells = np.empty(len(points)), np.empty(len(points), int)
        for i, point in enumerate(points.tolist()):
            self.locator.FindClosestPoint(point, at, cell, part, square)
            squares[i], cells[i] = square.get(), cell.get()
        return np.sqrt(squares), cells

    def contain(self, point):
        """By the parity of a ray's hits."""
        a, b, c = np.moveaxis(self.corners, 1, 0)
        across = np.cross(RAY, c - a)
        size = np.einsum("ij,ij->i", b - a, across)
        size = np.where(size == 0, np.inf, size)
        turned = np.cross(point - a, b - a)
        u = np.einsum("ij,ij->i", point - a, across) / size
        v = turned @ RAY / size
        hits = (u >= 0) & (v >= 0) & (u + v <= 1) & (np.einsum("ij,ij->i", c - a, turned) / size > 0)
        return np.count_nonzero(hits) % 2 == 1


class Surface(Triangles):
    """Triangles of solids with names: `solids[i]` is the number of triangle i's solid in `names`."""

    ahead = None  # the direction of the flow at the inlet, if not straight in

    def __init__(self, name, corners, solids, names):
        # STL readers keep single precision: so both meshers and the measures have the same surface.
        super().__init__(np.asarray(corners, np.float32).astype(float))
        self.name, self.solids, self.names = name, solids, [foam_word(solid) for solid in names]
        if self.volume() < 0:
            super().__init__(self.corners[:, ::-1])

    def of(self, names, title):
        """These solids alone."""
        chosen = np.isin(self.solids, [self.names.index(name) for name in names])
        numbers = np.array([names.index(name) if name in names else -1 for name in self.names])
        return Surface(title, self.corners[chosen], numbers[self.solids[chosen]], names)

    def turned(self, turns):
        """By degrees about axes, one after the other."""
        corners = self.corners
        for axis, degrees in turns:
            u, v, angle = (axis + 1) % 3, (axis + 2) % 3, math.radians(degrees)
            matrix = np.eye(3)
            matrix[[u, v], [u, v]] = math.cos(angle)
            matrix[u, v], matrix[v, u] = -math.sin(angle), math.sin(angle)
            corners = corners @ matrix.T
        return Surface(self.name, corners, self.solids, self.names)

    def sharp_edges(self, degrees):
        """Ends of those at which it turns by more (n, 2, 3)."""
        points, ids = np.unique(self.corners.reshape(-1, 3), axis=0, return_inverse=True)
        ids = ids.reshape(-1, 3)
        edges = np.stack([ids, np.roll(ids, -1, axis=1)], axis=2).reshape(-1, 2)
        return points[sharp_edges(edges, np.repeat(self.normals, 3, axis=0), degrees)]

    def area_of(self, name):
        return self.areas[self.solids == self.names.index(name)].sum()

    def bounds(self):
        points = self.corners.reshape(-1, 3)
        return points.min(axis=0), points.max(axis=0)

    def write(self, path):
        """ASCII STL with the names of the solids."""
        path.parent.mkdir(parents=True, exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            for number, name in enumerate(self.names):
                file.write(f"solid {name}\n")
                for corners in self.corners[self.solids == number]:
                    rows = "".join("vertex %.9g %.9g %.9g\n" % tuple(corner) for corner in corners)
                    file.write(f"facet normal 0 0 0\nouter loop\n{rows}endloop\nendfacet\n")
                file.write(f"endsolid {name}\n")

    def parts(self):
        """The number of each triangle's connected part."""
        _, ids = np.unique(self.corners.reshape(-1, 3), axis=0, return_inverse=True)
        ids = ids.reshape(-1, 3)
        lowest = np.arange(ids.max() + 1)  # point known to be of the same part
        while True:
            before = lowest.copy()
            np.minimum.at(lowest, ids.ravel(), np.repeat(lowest[ids].min(axis=1), 3))
            lowest = lowest[lowest]
            if (lowest == before).all():
                return np.unique(lowest[ids[:, 0]], return_inverse=True)[1]

    def points_inside(self, size):
        """A point in each part that is no void, as far from the surface as some tens of trials get."""
        parts, found = self.parts(), []
        random = np.random.default_rng(1)
        for part in range(parts.max() + 1):
            those = np.flatnonzero(parts == part)
            if Triangles(self.corners[those]).volume() < 0:
                continue
            some = random.choice(those, 30, p=self.areas[those] / self.areas[those].sum())
            weights = random.dirichlet([1, 1, 1], len(some))
            starts = np.einsum("ij,ijk->ik", weights, self.corners[some])
            trials = np.concatenate([starts - step * size * self.normals[some]
                                     for step in (0.37, 1.13, 2.29, 4.71, 9.41)])
            trials = np.array([p for p in trials if self.contain(p)])
            assert len(trials), f"no point inside part {part} of {self.name}"
            distances, nearest = self.nearest(trials)
            mine = np.where(parts[nearest] == part, distances, -1)
            found.append(trials[mine.argmax()].tolist())
        return found


def sharp_edges(edges, normals, degrees):
    """The edges (pairs of points), each once, that have not two faces, or at which these turn by more. `normals`: of
    the face that has the edge."""
    unique, number, count = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True, return_counts=True)
    order = np.argsort(number.ravel(), kind="stable")
    first = np.cumsum(count) - count
    one, other = normals[order[first]], normals[order[np.minimum(first + 1, len(order) - 1)]]
    turns = np.einsum("ij,ij->i", one, other) < math.cos(math.radians(degrees + 1e-4))
    return unique[(count != 2) | turns]


def distances_to_edges(ends, places):
    """Of each place, to the nearest of the edges (n, 2, 3)."""
    if len(ends) == 0:
        return np.full(len(places), np.inf)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(polydata(ends.reshape(-1, 3), np.arange(2 * len(ends)).reshape(-1, 2)))
    locator.BuildLocator()
    at, cell, part, square = [0.0] * 3, mutable(0), mutable(0), mutable(0.0)
    squares = np.empty(len(places))
    for i, place in enumerate(places.tolist()):
        locator.FindClosestPoint(place, at, cell, part, square)
        squares[i] = square.get()
    return np.sqrt(squares)


def foam_word(name):
    """The name as our writer makes a word of it for OpenFOAM."""
    word = "".join(c if c.isalnum() or c in "_-.:" or ord(c) > 127 else "_" for c in name)
    return "_" + word if not word or word[0] in "-.:0123456789" else word


def polydata(points, cells):
    """Of VTK, from arrays: triangles, or lines."""
    holder, array, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    holder.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    corners = cells.shape[1]
    offsets = np.arange(0, corners * len(cells) + 1, corners, dtype=np.int64)
    array.SetData(numpy_to_vtk(offsets, deep=True),
                  numpy_to_vtk(cells.astype(np.int64).ravel(), deep=True))
    data.SetPoints(holder)
    (data.SetPolys if corners == 3 else data.SetLines)(array)
    return data


def from_proxy(name, proxy):
    proxy.UpdatePipeline()
    source = proxy.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    filter = vtkTriangleFilter()
    filter.SetInputData(source)
    filter.PassVertsOff()
    filter.PassLinesOff()
    filter.Update()
    data = filter.GetOutput()
    corners = vtk_to_numpy(data.GetPoints().GetData())[
        vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    names = data.GetFieldData().GetAbstractArray("BoundaryNames")
    ids, solids = data.GetFieldData().GetArray("BoundaryIds"), np.zeros(len(corners), int)
    if not names:
        return Surface(name, corners, solids, ["surface"])
    labels = next(array for array in map(data.GetCellData().GetArray, ("BoundaryId", "STLSolidLabeling"))
                  if array)
    order = [ids.GetValue(i) for i in range(ids.GetNumberOfTuples())] if ids else \
        range(names.GetNumberOfValues())
    for number, label in enumerate(order):
        solids[vtk_to_numpy(labels) == label] = number
    return Surface(name, corners, solids, [names.GetValue(i) for i in range(names.GetNumberOfValues())])


def sphere(facets=100, radius=0.5):
    return from_proxy("sphere", simple.Sphere(Radius=radius, ThetaResolution=2 * facets, PhiResolution=facets))


def torus():
    return from_proxy("torus", simple.Clean(Input=simple.Superquadric(
        Toroidal=1, ThetaRoundness=1, PhiRoundness=1, ThetaResolution=400, PhiResolution=200)))


def tube(name, rings):
    """A pipe through the rings of points (steps, facets, 3): inlet and outlet are fans about their means."""
    following, facets = np.roll(rings, -1, axis=1), rings.shape[1]
    a, b, c, d = (corners.reshape(-1, 3) for corners in
                  (rings[:-1], following[:-1], following[1:], rings[1:]))
    first, last = (np.broadcast_to(ring.mean(axis=0), (facets, 3)) for ring in (rings[0], rings[-1]))
    triangles = [np.stack([a, c, b], axis=1), np.stack([a, d, c], axis=1),
                 np.stack([first, rings[0], following[0]], axis=1),
                 np.stack([last, following[-1], rings[-1]], axis=1)]
    solids = np.repeat([0, 0, 1, 2], [len(part) for part in triangles])
    return Surface(name, np.concatenate(triangles), solids, ["wall", "inlet", "outlet"])


def circles(path, tangents, across, radius, facets):
    """Rings about the points of a path in the plane normal to `across`."""
    angle = np.arange(facets)[:, None] * 2 * math.pi / facets
    return np.array([p + radius * (np.cos(angle) * np.cross(across, t) + np.sin(angle) * across)
                     for p, t in zip(path, tangents)])


def tilted_pipe(radius=15.0, length=150.0, facets=96, level=True):
    """`level`: the ends are at constant x, else across the pipe. (With those, flow with plain schemes diverges
    on snappyHexMesh's mesh, too.)"""
    across = np.cross(TILTED, [0, 0, 1]) / np.linalg.norm(np.cross(TILTED, [0, 0, 1]))
    rings = circles(np.outer([0, length], TILTED), [TILTED] * 2, across, radius, facets)
    if level:
        ends = np.array([0, length])[:, None] * TILTED[0]
        rings -= ((rings[:, :, 0] - ends) / TILTED[0])[:, :, None] * TILTED
    pipe = tube("tilted_pipe", rings)
    pipe.ahead = TILTED
    return pipe


def bend(radius=15.0, turn=45.0, straight=40.0, degrees=60, steps=32):
    """Along x, turned aside, and back along x; in a plane that is along no other axis."""
    ahead, aside = np.array([1, 0, 0]), np.array([0, math.cos(0.6), math.sin(0.6)])
    angles = np.linspace(0, math.radians(degrees), steps + 1)
    angles = np.concatenate([[0], angles, angles[::-1], [0]])
    tangents = np.cos(angles)[:, None] * ahead + np.sin(angles)[:, None] * aside
    step = np.full(len(angles) - 1, turn * math.radians(degrees) / steps)
    step[[0, steps + 1, -1]] = straight
    middle = tangents[1:] + tangents[:-1]
    middle /= np.linalg.norm(middle, axis=1)[:, None]
    path = np.concatenate([np.zeros((1, 3)), np.cumsum(step[:, None] * middle, axis=0)])
    return tube("bend", circles(path, tangents, np.cross(ahead, aside), radius, 96))


def load(name):
    """A surface by name: sphere, torus, tilted_pipe, bend, runner_1 to runner_4 (of the exhaust header), or a file."""
    if name in ("sphere", "torus", "tilted_pipe", "bend"):
        return globals()[name]()
    if name in (f"runner_{i}" for i in range(1, 5)):
        solids = [f"{part}_{name[-1]}" for part in ("wall", "inlet", "outlet")]
        return load(str(HEADER)).of(solids, name)
    path = pathlib.Path(name)
    return from_proxy(path.stem, simple.OpenDataFile(str(path)))
