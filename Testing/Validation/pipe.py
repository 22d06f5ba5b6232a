# SPDX-License-Identifier: BSD-3-Clause
"""Laminar flow through a pipe that is along nothing of the grid: Poiseuille's fall of pressure and shear at the wall."""

import numpy as np

import harness  # before what it finds
import foam
from wallsurfaces import TILTED, tilted_pipe

RADIUS, LENGTH, SPEED, VISCOSITY = 15.0, 150.0, 1.0, 3.0  # the mean speed: Reynolds number 10
ITERATIONS = 400


def measured(files, turn):
    folder, axis = files.folder.parents[1], TILTED @ turn.T
    centres, vectors = files.face_centres()

    def velocity(p):
        square = ((p - (p @ axis)[:, None] * axis) ** 2).sum(axis=1)
        return np.maximum(2 * SPEED * (1 - square / RADIUS ** 2), 0)[:, None] * axis

    given = velocity(centres[files.of_patch("inlet")])
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", "({!r} {!r} {!r})".format(*axis.tolist()), {
        "wall": "noSlip;", "inlet": f"fixedValue; value {foam.items(given)};", "outlet": "zeroGradient;"})
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0", {
        "wall": "zeroGradient;", "inlet": "zeroGradient;", "outlet": "fixedValue; value uniform 0;"})
    foam.write(folder, "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {VISCOSITY};")
    foam.write(folder, "constant/turbulenceProperties", "simulationType laminar;")
    foam.write(folder, "system/fvSchemes", "ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }\n"
        "divSchemes { default none; div(phi,U) bounded Gauss linearUpwind grad(U); div((nuEff*dev2(T(grad(U))))) Gauss linear; }\n"
        "laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }\n"
        "snGradSchemes { default corrected; }")
    foam.write(folder, "system/fvSolution",
        "solvers { p { solver GAMG; smoother GaussSeidel; tolerance 1e-10; relTol 0.01; }\n"
        "U { solver PBiCGStab; preconditioner DILU; tolerance 1e-10; relTol 0.05; } }\n"
        "SIMPLE { consistent yes; nNonOrthogonalCorrectors 1; residualControl { p 1e-6; U 1e-6; } }\n"
        "relaxationFactors { equations { U 0.9; } fields { p 0.9; } }")
    foam.control(folder, ITERATIONS)
    foam.run(folder, "simpleFoam")
    last = max(int(path.name) for path in folder.glob("[1-9]*"))
    flow = -np.einsum("ij,ij->", given, vectors[files.of_patch("inlet")]) / (np.pi * RADIUS ** 2)
    return {"pressure": fall(files, foam.read_field(folder, last, "p"), axis) / (8 * VISCOSITY * flow / RADIUS ** 2) - 1,
            "wall shear": shear(files, foam.read_field(folder, last, "U"), centres, vectors, axis) / (4 * flow / RADIUS) - 1,
            "iterations": last}


def fall(files, pressure, axis):
    """Of pressure by length, in the middle half of the pipe."""
    along, volumes = files.centres() @ axis, files.volumes()
    middle = (along > 0.25 * LENGTH) & (along < 0.75 * LENGTH)
    return float(-np.polyfit(along[middle], pressure[middle], 1, w=np.sqrt(volumes[middle]))[0])


def shear(files, velocity, centres, vectors, axis):
    """The gradient of speed at the wall there, as the solver has it."""
    wall = files.of_patch("wall")
    owner, sizes = files.owner[wall], np.linalg.norm(vectors[wall], axis=1)
    across = np.einsum("ij,ij->i", centres[wall] - files.centres()[owner], vectors[wall] / sizes[:, None])
    along = centres[wall] @ axis
    middle = (along > 0.25 * LENGTH) & (along < 0.75 * LENGTH)
    return float(np.average((velocity[owner] @ axis / across)[middle], weights=sizes[middle]))


CASE = harness.Case("pipe", "Laminar flow through a pipe",
    "Radius 15, along (1, 0.6, 0.35), Reynolds number 10; simpleFoam, second order, without limiters. Fall of pressure and shear at the "
    "wall in the middle half, against Poiseuille's.",
    tilted_pipe(level=False), (5.0, 2.5, 1.25), measured)

if __name__ == "__main__":
    print("order of the pressure:", harness.order(harness.run(CASE), "pressure"))
