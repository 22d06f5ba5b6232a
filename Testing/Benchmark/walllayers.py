# SPDX-License-Identifier: BSD-3-Clause
"""Boundary layers of a mesh in constant/polyMesh, whoever made it, counted cell by cell from the wall."""

import numpy as np
from vtkmodules.vtkCommonCore import mutable

THICK = 3          # boxes to the wall that lies opposite
LEAST, MOST = 0.5, 1.5  # of the height asked: others are no layer, or none of that number
NEAR = 0.05        # the first height, from what was asked


class Walk:
    """From a face at the wall through the cells above it, by opposite faces."""

    def __init__(self, mesh):
        self.mesh = mesh
        order = np.argsort(np.concatenate([mesh.owner, mesh.neighbour]), kind="stable")
        self.faces = np.concatenate([np.arange(len(mesh.owner)), np.arange(mesh.inner)])[order]
        count = np.bincount(np.concatenate([mesh.owner, mesh.neighbour]), minlength=mesh.cells)
        self.start = np.concatenate([[0], np.cumsum(count)])

    def corners(self, face):
        return self.mesh.faces.corners[self.mesh.faces.start[face]:self.mesh.faces.start[face + 1]].tolist()

    def opposite(self, cell, face):
        """The one face of the cell that has as many corners and none in common; or None."""
        corners = set(self.corners(face))
        found = [f for f in self.faces[self.start[cell]:self.start[cell + 1]]
                 if len(self.corners(f)) == len(corners) and corners.isdisjoint(self.corners(f))]
        return found[0] if len(found) == 1 else None

    def heights(self, face, layers):
        """Of the cells above it, along its normal; fewer where there is no opposite face."""
        mesh, found = self.mesh, []
        normal = mesh.vectors[face] / (mesh.sizes[face] + 1e-300)
        cell = mesh.owner[face]
        while len(found) < layers:
            other = self.opposite(cell, face)
            if other is None:
                break
            found.append(normal @ (mesh.face_at[face] - mesh.face_at[other]))
            if other >= mesh.inner:
                break
            face, cell = other, mesh.neighbour[other] if mesh.owner[other] == cell else mesh.owner[other]
        return found


def is_thick(surface, at, inwards, way):
    """Whether nothing lies opposite within the way."""
    surface.nearest(np.empty((0, 3)))  # makes the locator
    near, parameter, hit, coordinates, part = 1e-3 * way, mutable(0.0), [0.0] * 3, [0.0] * 3, mutable(0)
    return not surface.locator.IntersectWithLine(
        at + near * inwards, at + way * inwards, 1e-9, parameter, hit, coordinates, part)


def coverage(mesh, surface, asked, box, walls=None):
    """Shares of the walls' area. `asked`: the height of each layer from the wall; `walls`: the faces, by default
    all of the boundary. A face has its layers only if all are there, each at least half as thick as asked."""
    walk = Walk(mesh)
    faces = np.arange(mesh.inner, len(mesh.owner)) if walls is None else walls
    has, first, thick = (np.zeros(len(faces), bool) for _ in range(3))
    for i, face in enumerate(faces):
        heights = np.array(walk.heights(face, len(asked)))
        enough = len(heights) == len(asked)
        has[i] = enough and ((heights >= LEAST * asked) & (heights <= MOST * asked)).all()
        first[i] = enough and abs(heights[0] / asked[0] - 1) <= NEAR
        inwards = -mesh.vectors[face] / (mesh.sizes[face] + 1e-300)
        thick[i] = is_thick(surface, mesh.face_at[face], inwards, THICK * box)
    area = mesh.sizes[faces]

    def share(where, of):
        return (area * where * of).sum() / max((area * of).sum(), 1e-300)

    return {
        "layers": share(has, np.ones(len(faces))),
        "... three boxes from opposite": share(has, thick),
        "first height within 5 %, there": share(first, thick),
        "area there": share(thick, np.ones(len(faces))),
    }
