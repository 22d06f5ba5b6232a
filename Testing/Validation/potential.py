# SPDX-License-Identifier: BSD-3-Clause
"""Potential flow around a sphere, with the exact potential on all other sides: no blockage. The potential is laplacianFoam's, as
fvc::reconstruct in Debian's OpenFOAM makes potentialFoam's velocities in small cells wrong."""

import numpy as np
from paraview import simple

import harness  # before what it finds
import foam
from conduction import Walls, exact, solve
from wallsurfaces import Surface, from_proxy, sphere

RADIUS, REACH = 0.5, 1.5
SIDES = "inlet", "outlet", "sides"


def potential(p, ahead):
    return p @ ahead * (1 + 0.5 * (RADIUS / np.linalg.norm(p, axis=1)) ** 3)


def velocity(p, ahead):
    r = np.linalg.norm(p, axis=1)[:, None]
    part = 0.5 * (RADIUS / r) ** 3
    return ahead * (1 + part) - 3 * part * (p @ ahead)[:, None] * p / r ** 2


def measured(files, turn):
    ahead = turn[:, 0]
    body = next(name for name in files.patches if name not in SIDES)
    found, _ = solve(files, exact(files, set(files.patches) - {body}, lambda p: potential(p, ahead)) | {body: "zeroGradient;"})
    folder, cells, volumes = files.folder.parents[1], files.centres(), files.volumes()
    foam.run(folder, "postProcess", "-func", "grad(T)", "-time", "1")
    flow = foam.read_field(folder, 1, "grad(T)")
    off, wall = np.linalg.norm(flow - velocity(cells, ahead), axis=1), Walls(files, body)
    return {"potential": float(np.average(np.abs(found - potential(cells, ahead)), weights=volumes) / (2 * REACH)),
            "velocity": float(np.average(off, weights=volumes)),
            "velocity at the sphere": float(np.average(off[wall.owner], weights=wall.sizes)),
            "largest speed": float(np.linalg.norm(flow, axis=1).max() / 1.5 - 1)}


def space():
    """Around the sphere."""
    box = from_proxy("box", simple.Triangulate(Input=simple.Box())).corners * 2 * REACH
    ball = sphere().corners[:, ::-1]
    return Surface("space", np.concatenate([ball, box]), np.repeat([0, 1], [len(ball), len(box)]), ["sphere", "sides"])


CASE = harness.Case("potential", "Potential flow around a sphere",
    "A sphere of radius 0.5 in a cube of side 3 with the exact potential on its sides; boxes at the sphere are halved once, with "
    "three transition layers; laplacianFoam. Mean errors of the potential, relative to its range, and of velocity, over all cells and "
    "over those at the sphere; the largest cell speed against 1.5.",
    space(), (0.25, 0.125, 0.0625), measured, depth=1, fine=("sphere",), between=(3, 3), domain=(sphere(), (3 * (-REACH,), 3 * (REACH,))))

if __name__ == "__main__":
    print("order of the velocity:", harness.order(harness.run(CASE), "velocity"))
