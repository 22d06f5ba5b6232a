# SPDX-License-Identifier: BSD-3-Clause
"""What wallcells.py measures of a mesh in constant/polyMesh, whoever made it."""

import numpy as np

import foam
from wallsurfaces import SHARP, Triangles, distances_to_edges, sharp_edges

LEANING = np.cos(np.radians(45))
SMOOTH = np.cos(np.radians(30))
COURANT = 0.9
TINY = 1e-3   # boxes
KEPT = 0.1    # likewise
SAMPLE = 0.2  # of edges, likewise


class Mesh(foam.Files):
    """With centres, areas and volumes as OpenFOAM finds them."""

    def __init__(self, folder):
        super().__init__(folder)
        self.inner = len(self.neighbour)
        self.face_at, self.vectors = self.face_centres()
        self.sizes = np.linalg.norm(self.vectors, axis=1)
        self.at = self.centres()
        self.volume = self.pyramids()
        self.at_wall = np.bincount(self.owner[self.inner:], minlength=self.cells) > 0

    def pyramids(self):
        """Of the cells, the volume of those on their faces: where a face is warped, not quite the cell's."""
        def volumes(cells, faces):
            height = dot(self.vectors[faces], self.face_at[faces] - self.at[cells])
            return np.bincount(cells, height / 3, self.cells)
        return volumes(self.owner, slice(None)) - volumes(self.neighbour, slice(self.inner))

    def across(self):
        """From the owner's to the neighbour's centre, through the inner faces."""
        return self.at[self.neighbour] - self.at[self.owner[:self.inner]]

    def non_orthogonality(self):
        way, vectors = self.across(), self.vectors[:self.inner]
        cosine = dot(way, vectors) / (length(way) * self.sizes[:self.inner] + 1e-300)
        return np.degrees(np.arccos(np.clip(cosine, -1, 1)))

    def skewness(self):
        """Of all faces: how far the line of centres misses the face's centre, by the face's size."""
        inside = self.face_at - self.at[self.owner]
        normals = self.vectors / (self.sizes[:, None] + 1e-300)
        way = normals * dot(normals, inside)[:, None]
        way[:self.inner] = self.across()
        off = inside - way * (dot(self.vectors, inside) / (dot(self.vectors, way) + 1e-150))[:, None]
        miss = length(off)
        direction = off / (miss + 1e-150)[:, None]
        faces = self.faces
        corners = self.points[faces.corners] - self.face_at[faces.face]
        reach = np.maximum.reduceat(np.abs(dot(direction[faces.face], corners)), faces.start[:-1])
        least = np.where(np.arange(len(way)) < self.inner, 0.2, 0.4) * length(way) + 1e-150
        return miss / np.maximum(reach, least)

    def weights(self):
        vectors, at = self.vectors[:self.inner], self.face_at[:self.inner]
        mine = np.abs(dot(vectors, at - self.at[self.owner[:self.inner]]))
        other = np.abs(dot(vectors, self.at[self.neighbour] - at))
        return np.minimum(mine, other) / (mine + other + 1e-300)

    def volume_ratios(self):
        mine, other = self.volume[self.owner[:self.inner]], self.volume[self.neighbour]
        return np.minimum(mine, other) / np.maximum(np.maximum(mine, other), 1e-300)

    def determinants(self):
        """Of the cells: of the inner faces' area vectors by their mean, as checkMesh has it."""
        cells = np.concatenate([self.owner[:self.inner], self.neighbour])
        vectors = np.concatenate([self.vectors[:self.inner]] * 2)
        count = np.bincount(cells, minlength=self.cells)
        mean = np.bincount(cells, length(vectors), self.cells) / np.maximum(count, 1)
        vectors = vectors / mean[cells][:, None]
        tensors = np.stack([np.bincount(cells, vectors[:, i] * vectors[:, j], self.cells)
                            for i in range(3) for j in range(3)], axis=1).reshape(-1, 3, 3)
        return np.where(count > 0, np.abs(np.linalg.det(tensors)) / 8, 0)

    def time_step(self):
        """The longest explicit step at COURANT, for speed 1 along each of the axes."""
        flow = np.zeros((self.cells, 3))
        for axis in range(3):
            through = self.vectors[:, axis]
            flow[:, axis] = np.bincount(self.owner, np.maximum(through, 0), self.cells) + \
                np.bincount(self.neighbour, np.maximum(-through[:self.inner], 0), self.cells)
        return COURANT * (self.volume[:, None] / np.maximum(flow, 1e-300)).min(axis=0)

    def worst_of_cells(self, of_faces):
        """The largest value of each cell's faces."""
        worst = np.zeros(self.cells)
        np.maximum.at(worst, self.owner, of_faces)
        np.maximum.at(worst, self.neighbour, of_faces[:self.inner])
        return worst

    def walls(self, surface):
        """The boundary faces on the surface: all but those on the sides of a box around it."""
        return np.concatenate([np.arange(start, start + count) for name, (_, start, count) in self.patches.items()
                               if name in surface.names] or [np.zeros(0, int)])

    def corners_of(self, faces):
        """Positions of the faces' corners in `self.faces`, and the number of each one's face in the list."""
        sizes = self.faces.start[faces + 1] - self.faces.start[faces]
        number = np.repeat(np.arange(len(faces)), sizes)
        return np.arange(sizes.sum()) + (self.faces.start[faces] - np.cumsum(sizes) + sizes)[number], number

    def triangles(self, faces):
        """The faces cut into triangles about their centres."""
        at, number = self.corners_of(faces)
        corners, following = self.faces.corners[at], self.faces.corners[self.faces.next[at]]
        middle = self.face_at[faces[number]]
        return Triangles(np.stack([middle, self.points[corners], self.points[following]], axis=1))

    def sharp_edges(self, faces, degrees):
        """Ends of those at which two of the faces turn by more (n, 2, 3)."""
        at, number = self.corners_of(faces)
        edges = np.stack([self.faces.corners[at], self.faces.corners[self.faces.next[at]]], axis=1)
        normals = self.vectors[faces] / (self.sizes[faces, None] + 1e-300)
        return self.points[sharp_edges(edges, normals[number], degrees)]


def dot(a, b):
    return np.einsum("ij,ij->i", a, b)


def length(a):
    return np.linalg.norm(a, axis=1)


def cells(mesh, boxes):
    """Figures of the cells. `boxes`: the volume of each cell's box."""
    parts, skewness = mesh.volume / boxes, mesh.skewness()
    return {
        "smallest volume by its box": parts.min(),
        "1 % quantile": np.quantile(parts, 0.01),
        "1 % quantile, cells at the wall": np.quantile(parts[mesh.at_wall], 0.01),
        "skewness": skewness.max(),
        "95 % quantile of cells at the wall":
            np.quantile(mesh.worst_of_cells(skewness)[mesh.at_wall], 0.95),
        "non-orthogonality": mesh.non_orthogonality().max(initial=0),
        "face weight": mesh.weights().min(initial=0.5),
        "volume ratio": mesh.volume_ratios().min(initial=1),
        "determinant": mesh.determinants().min(),
    }


def fidelity(mesh, surface, box, outside=False):
    """Figures of the boundary against the surface. `box`: the length of a box along the surface; `outside`: whether
    what is meshed is the space around it, in a box."""
    walls, sign = mesh.walls(surface), -1 if outside else 1
    at, normals = mesh.face_at[walls], sign * mesh.vectors[walls] / (mesh.sizes[walls, None] + 1e-300)
    off, nearest = surface.nearest(at)
    leaning = dot(normals, surface.normals[nearest]) < LEANING
    for way in TINY * box * np.concatenate([np.eye(3), -np.eye(3)]):  # at an edge two are as near
        some = np.flatnonzero(leaning)
        leaning[some] = dot(normals[some], surface.normals[surface.nearest(at[some] + way)[1]]) < LEANING
    smooth = [is_smooth(surface, point, surface.normals[triangle], box)
              for point, triangle in zip(at[leaning], nearest[leaning])]
    used = np.unique(mesh.faces.corners[mesh.corners_of(walls)[0]])
    there = np.concatenate([off, surface.nearest(mesh.points[used])[0]])
    back = np.concatenate([surface.corners.reshape(-1, 3), surface.corners.mean(axis=1)])
    enclosed = sign * dot(mesh.face_at[walls] - surface.corners[0, 0], mesh.vectors[walls]).sum() / 3
    return {
        "volume error": enclosed / surface.volume() - 1,
        "faces leaning over 45 degrees": len(smooth),
        "... where the surface is smooth": sum(smooth),
        "boundary from surface (boxes)": there.max(initial=0) / box,
        "... rms": np.sqrt((there ** 2).mean()) / box,
        "surface from boundary (boxes)":
            mesh.triangles(walls).nearest(np.unique(back, axis=0))[0].max() / box,
        "sharp edges kept": edges_kept(mesh, walls, surface, box),
    }


def edges_kept(mesh, walls, surface, box):
    """The part of the length of the surface's sharp edges that has an edge of the mesh, which turns by more than half as
    much, within a tenth of a box."""
    ends = surface.sharp_edges(SHARP)
    if len(ends) == 0:
        return 1.0
    pieces = np.ceil(length(ends[:, 1] - ends[:, 0]) / (SAMPLE * box)).astype(int)
    number = np.repeat(np.arange(len(ends)), pieces)
    part = (np.arange(pieces.sum()) - (np.cumsum(pieces) - pieces)[number] + 0.5) / pieces[number]
    places = ends[number, 0] + part[:, None] * (ends[number, 1] - ends[number, 0])
    weights = (length(ends[:, 1] - ends[:, 0]) / pieces)[number]
    near = distances_to_edges(mesh.sharp_edges(walls, SHARP / 2), places) <= KEPT * box
    return weights[near].sum() / weights.sum()


def is_smooth(surface, point, normal, box):
    """Whether the surface turns by less than 30 degrees within two boxes: asked at 24 places around."""
    one = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    one /= np.linalg.norm(one)
    other = np.cross(normal, one)
    angles = np.arange(8) * np.pi / 4
    circle = np.outer(np.cos(angles), one) + np.outer(np.sin(angles), other)
    _, nearest = surface.nearest(np.concatenate([point + r * box * circle for r in (0.67, 1.33, 2)]))
    return bool((surface.normals[nearest] @ normal > SMOOTH).all())


def area_errors(mesh, surface):
    """By boundary, relative; -1 for one that the mesh does not have."""
    areas = mesh.areas()
    return {name: areas.get(name, 0) / surface.area_of(name) - 1 for name in surface.names
            if surface.area_of(name) > 0}
