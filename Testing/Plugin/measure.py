"""Measures a mesh, its boundary and a surface, without knowing how they were made.

A face is a row of point ids, and all comparing of faces is exact: two cells share a face where
they name the same points, in opposite order. Only areas and volumes are rounded.
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_POLYHEDRON
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

from polyhedra import cell_types, face_streams

HEXAHEDRON = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
LEVELS = 4.2e9  # of the mesher's lattice, along the longest side
CLOSE = 1e-9


class Faces:
    """Rows of point ids: `corners` from start[i] to start[i + 1], of cell owner[i]."""

    def __init__(self, rows, sizes, owner):
        self.corners, self.owner = rows, owner
        self.start = np.concatenate([[0], np.cumsum(sizes)])
        self.size = sizes
        # Of each corner: its face, and the corner that follows it.
        self.face = np.repeat(np.arange(len(sizes)), sizes)
        self.next = np.arange(1, len(rows) + 1)
        self.next[self.start[1:] - 1] = self.start[:-1]

    def __len__(self):
        return len(self.owner)

    def select(self, chosen):
        inside = np.isin(self.face, np.flatnonzero(chosen))
        return Faces(self.corners[inside], self.size[chosen], self.owner[chosen])

    def sums(self, values):
        return np.add.reduceat(values, self.start[:-1])

    def edges(self):
        """Ends of all edges, lower id first, and +1 or -1 for the direction."""
        a, b = self.corners, self.corners[self.next]
        return np.minimum(a, b), np.maximum(a, b), np.where(a < b, 1, -1)

    def names(self):
        """The same name, a number from 0, for faces of the same edges, all in the same or all in
        the opposite direction; and which of the two it is, +1 or -1."""
        points = self.corners.max() + 1
        ahead = self.corners * points + self.corners[self.next]
        back = self.corners[self.next] * points + self.corners
        name, direction = np.empty(len(self), int), np.empty(len(self), int)
        count = 0
        for size in np.unique(self.size):
            those = np.flatnonzero(self.size == size)
            at = self.start[those][:, None] + np.arange(size)
            rows, turned = np.sort(ahead[at], axis=1), np.sort(back[at], axis=1)
            first = (rows != turned).argmax(axis=1)[:, None]  # where they differ
            smaller = np.take_along_axis(rows < turned, first, axis=1)
            unique, inverse = np.unique(np.where(smaller, rows, turned), axis=0, return_inverse=True)
            name[those] = count + inverse
            direction[those] = np.where(smaller[:, 0], 1, -1)
            count += len(unique)
        return name, direction

    def measure(self, xyz, origin):
        """Area vector and area of each face, and volume of its pyramid from origin[owner]: sums
        over the triangles of a star around the mean of the corners."""
        p = xyz[self.corners]
        centre = self.sums(p) / self.size[:, None]
        star = np.cross(p - centre[self.face], p[self.next] - centre[self.face]) / 2
        vector = self.sums(star)
        volume = np.einsum("ij,ij->i", vector, centre - origin[self.owner]) / 3
        return vector, np.linalg.norm(vector, axis=1), volume


def faces_of_cells(grid):
    """All faces of all cells, as the cells name them."""
    types = cell_types(grid)
    connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    assert np.isin(types, (VTK_HEXAHEDRON, VTK_POLYHEDRON)).all()
    cells = np.flatnonzero(types == VTK_HEXAHEDRON)
    rows = connectivity[offsets[cells][:, None, None] + np.array(HEXAHEDRON)]
    parts = [(rows.ravel(), np.full(6 * len(cells), 4), np.repeat(cells, 6))]
    # The first face of all polyhedra, then the second of all that have one, and so on.
    cells = np.flatnonzero(types == VTK_POLYHEDRON)
    if len(cells):
        stream, starts = face_streams(grid)
        at = starts[cells]
        left = stream[at]
        at = at + 1
        while len(cells):
            sizes = stream[at]
            first = np.cumsum(sizes) - sizes
            rows = stream[np.arange(sizes.sum()) + np.repeat(at + 1 - first, sizes)]
            parts.append((rows, sizes, cells))
            more = left > 1
            at, left, cells = (at + sizes + 1)[more], left[more] - 1, cells[more]
    return Faces(*(np.concatenate(columns) for columns in zip(*parts)))


def faces_of_polydata(data, owner):
    polygons = data.GetPolys()
    return Faces(vtk_to_numpy(polygons.GetConnectivityArray()),
        np.diff(vtk_to_numpy(polygons.GetOffsetsArray())), owner)


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def balanced(keys, direction):
    """True if rows of equal keys run as often in one direction as in the other."""
    _, inverse = np.unique(np.stack(keys, axis=1), axis=0, return_inverse=True)
    return not np.bincount(inverse, direction).any()


class Surface:
    """Volume and areas, and how far a lattice of LEVELS can be from them."""

    def __init__(self, data, boundary_array="STLSolidLabeling"):
        triangles = vtkTriangleFilter()
        triangles.SetInputData(data)
        triangles.PassVertsOff()
        triangles.PassLinesOff()
        triangles.Update()
        data = triangles.GetOutput()
        xyz = points_of(data)
        faces = faces_of_polydata(data, np.zeros(data.GetNumberOfPolys(), int))
        _, area, volume = faces.measure(xyz, xyz.mean(axis=0)[None])
        ids = data.GetCellData().GetArray(boundary_array)
        ids = vtk_to_numpy(ids).astype(int) if ids else np.zeros(len(area), int)
        edges = np.linalg.norm(xyz[faces.corners] - xyz[faces.corners[faces.next]], axis=1)
        self.step = np.ptp(xyz, axis=0).max() / LEVELS
        self.volume, self.area = abs(volume.sum()), area.sum()
        self.areas = {i: area[ids == i].sum() for i in np.unique(ids)}
        self.lengths = {i: edges[ids[faces.face] == i].sum() for i in np.unique(ids)}

    def check(self, volume, areas):
        """Equal to nine digits, or to two steps of the lattice in every point."""
        assert_close("volume", volume, self.volume, 2 * self.step * self.area)
        assert set(areas) == set(self.areas), f"boundaries are {sorted(areas)}"
        for i, area in areas.items():
            assert_close(f"area of boundary {i}", area, self.areas[i],
                2 * self.step * self.lengths[i])


def assert_close(what, value, expected, tolerance):
    error = abs(value - expected)
    assert error <= max(CLOSE * expected, tolerance), f"{what} {value} is {error} off {expected}"


class Mesh:
    """Asserts that the mesh is a finite-volume mesh and that the boundary is its boundary. Cells have
    the numbers of CellId."""

    def __init__(self, grid, boundary):
        self.xyz = points_of(grid)
        self.cells = grid.GetNumberOfCells()
        self.faces = faces_of_cells(grid)
        number = vtk_to_numpy(grid.GetCellData().GetArray("CellId"))
        assert np.array_equal(np.sort(number), np.arange(self.cells)), "numbers of cells"
        self.faces.owner = number[self.faces.owner]
        self.check_points()
        self.check_sharing()
        self.check_closure()
        self.check_boundary(boundary)
        self.check_arrays(grid)

    def check_points(self):
        used = np.bincount(self.faces.corners, minlength=len(self.xyz)) > 0
        assert used.all(), f"{(~used).sum()} points are not used"
        distinct = len(np.unique(self.xyz, axis=0))
        assert distinct == len(self.xyz), f"{len(self.xyz) - distinct} points coincide"
        pairs = np.unique(np.stack([self.faces.face, self.faces.corners], axis=1), axis=0)
        self.repeated = len(self.faces.corners) - len(pairs)
        assert self.faces.size.min() >= 3, "a face has fewer than three points"

    def check_sharing(self):
        name, direction = self.faces.names()
        uses = np.bincount(name)
        assert uses.max() <= 2, f"{(uses > 2).sum()} faces are shared by more than two cells"
        opposite = np.bincount(name, direction) == 0
        assert opposite[uses == 2].all(), "two cells name their face in the same direction"
        inner = np.flatnonzero(uses[name] == 2)
        inner = inner[np.argsort(name[inner])].reshape(-1, 2)
        assert (self.faces.owner[inner[:, 0]] != self.faces.owner[inner[:, 1]]).all(), \
            "a cell has the same face twice"
        self.inner = len(inner)
        self.once = self.faces.select(uses[name] == 1)
        lower, upper, direction = self.once.edges()
        assert balanced((lower, upper), direction), "the boundary has open edges"

    def check_closure(self):
        lower, upper, direction = self.faces.edges()
        assert balanced((self.faces.owner[self.faces.face], lower, upper), direction), \
            "a cell has open edges"
        # About any point inside the cell, for accuracy: the mean of its faces' corners.
        owner = self.faces.owner[self.faces.face]
        weight = np.bincount(owner, minlength=self.cells)
        origin = np.stack([np.bincount(owner, self.xyz[self.faces.corners, axis], self.cells)
                           for axis in range(3)], axis=1) / weight[:, None]
        vector, area, volume = self.faces.measure(self.xyz, origin)
        self.volumes = np.bincount(self.faces.owner, volume, self.cells)
        assert self.volumes.min() > 0, f"{(self.volumes <= 0).sum()} cells have no volume"
        self.volume = self.volumes.sum()
        total = np.bincount(self.faces.owner, area, self.cells)
        for axis in range(3):
            rest = np.bincount(self.faces.owner, vector[:, axis], self.cells)
            assert (np.abs(rest) <= CLOSE * total).all(), "a cell's face vectors do not add up to 0"

    def check_boundary(self, boundary):
        """Face for face, with owner and direction, what only one cell has."""
        mesh_point = vtk_to_numpy(boundary.GetPointData().GetArray("MeshPointId"))
        assert len(np.unique(mesh_point)) == len(mesh_point)
        assert (points_of(boundary) == self.xyz[mesh_point]).all()
        owner = vtk_to_numpy(boundary.GetCellData().GetArray("OwnerCell"))
        shown = faces_of_polydata(boundary, owner)
        shown = Faces(mesh_point[shown.corners], shown.size, shown.owner)
        both = Faces(np.concatenate([self.once.corners, shown.corners]),
            np.concatenate([self.once.size, shown.size]),
            np.concatenate([self.once.owner, shown.owner]))
        name, direction = both.names()
        half = len(self.once)
        mine = np.stack([name, direction, both.owner], axis=1)
        order = [part[np.lexsort(part.T)] for part in (mine[:half], mine[half:])]
        assert np.array_equal(*order), "the boundary is not the faces that one cell has"
        _, area, _ = shown.measure(self.xyz, np.zeros((self.cells, 3)))
        ids = vtk_to_numpy(boundary.GetCellData().GetArray("BoundaryId"))
        self.areas = {i: area[ids == i].sum() for i in np.unique(ids)}

    def check_arrays(self, grid):
        fraction = vtk_to_numpy(grid.GetCellData().GetArray("VolumeFraction"))
        assert 0 < fraction.min()
        self.fractions = fraction[np.argsort(vtk_to_numpy(grid.GetCellData().GetArray("CellId")))]
        types = cell_types(grid)
        assert (np.diff(types) >= 0).all(), "hexahedra are not first"
        assert (vtk_to_numpy(grid.GetCellData().GetArray("Region")) == 1).all()
        global_box = vtk_to_numpy(grid.GetCellData().GetArray("GlobalBox"))
        assert global_box.shape == (self.cells, 3)
        for name, value in (("Cells", self.cells), ("Points", len(self.xyz)),
                ("Hexahedra", (types == VTK_HEXAHEDRON).sum()),
                ("Polyhedra", (types == VTK_POLYHEDRON).sum()),
                ("BoundaryFaces", len(self.once))):
            said = grid.GetFieldData().GetArray(name).GetValue(0)
            assert said == value, f"{name} is {value}, not {said}"
