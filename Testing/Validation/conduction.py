# SPDX-License-Identifier: BSD-3-Clause
"""Conduction with the exact temperatures on all walls, by laplacianFoam: a Poisson problem of which all is known.

Gradients are of leastSquares, and a wall has the temperature of the foot of the cell's centre on the face's plane: OpenFOAM
takes it for there. So linear temperatures are exact on any mesh; with Gauss linear, or at the face's centre, on none."""

import numpy as np

import foam

SCHEMES = """ddtSchemes { default steadyState; } gradSchemes { default leastSquares; } divSchemes { default none; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }"""
SOLUTION = """solvers { T { solver PCG; preconditioner DIC; tolerance 1e-11; relTol 0; } }
SIMPLE { nNonOrthogonalCorrectors 20; }"""
FIXED = "fixedValue; value {};"


class Walls:
    """Of the faces at the boundary, or of a patch: their `owner`, `at` (centres), `sizes` and `normals`, and the `feet` of the
    cells' centres on their planes, in a `height` below these."""

    def __init__(self, files, patch=None):
        faces = files.of_patch(patch) if patch else slice(len(files.neighbour), None)
        self.at, vectors = (of[faces] for of in files.face_centres())
        self.owner, self.sizes = files.owner[faces], np.linalg.norm(vectors, axis=1)
        self.normals = vectors / self.sizes[:, None]
        cells = files.centres()[self.owner]
        self.height = np.einsum("ij,ij->i", self.at - cells, self.normals)
        self.feet = cells + self.height[:, None] * self.normals


def exact(files, patches, temperature):
    """The conditions of these patches."""
    return {name: FIXED.format(foam.items(temperature(Walls(files, name).feet))) for name in patches}


def solve(files, conditions, solution=SOLUTION, start=None):
    """The cells' temperatures, and what the solver said. `start`: temperatures, if not 0."""
    folder = files.folder.parents[1]
    foam.write_field(folder, "T", "[0 0 0 1 0 0 0]", "0", conditions)
    if start is not None:
        path = folder / "0/T"
        path.write_text(path.read_text().replace("internalField uniform 0", f"internalField {foam.items(start)}"))
    foam.write(folder, "constant/transportProperties", "DT [0 2 -1 0 0 0 0] 1;")
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", solution)
    foam.control(folder, 1)
    said = foam.run(folder, "laplacianFoam")
    return foam.read_field(folder, 1, "T"), said


def errors(files, temperature, gradient):
    """Of temperatures at the cells' centres and of their gradients across the walls, by the means of what is exact; for
    functions of points (n, 3)."""
    (found, _), walls = solve(files, exact(files, files.patches, temperature)), Walls(files)
    on_walls = temperature(walls.feet)
    error = np.abs(found - temperature(files.centres())) / np.ptp(on_walls)
    across = np.einsum("ij,ij->i", gradient(walls.at), walls.normals)
    steep = (on_walls - found[walls.owner]) / walls.height
    off, mean = (np.average(np.abs(values), weights=walls.sizes) for values in (steep - across, across))
    return {"mean error": float(np.average(error, weights=files.volumes())), "largest error": float(error.max()),
            "wall gradient": float(off / mean)}
