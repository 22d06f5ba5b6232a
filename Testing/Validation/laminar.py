# SPDX-License-Identifier: BSD-3-Clause
"""Steady laminar flow by simpleFoam: second order, without limiters."""

import re

import numpy as np

import foam
from wallflow import set_types

SCHEMES = """ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) bounded Gauss linearUpwind grad(U); div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }
snGradSchemes { default corrected; }"""
SOLUTION = """solvers { p { solver GAMG; smoother GaussSeidel; tolerance 1e-10; relTol 0.01; }
U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-11; relTol 0.05; } }
SIMPLE { consistent yes; nNonOrthogonalCorrectors 1; residualControl { p 1e-6; U 1e-7; } pRefCell 0; pRefValue 0; }
relaxationFactors { equations { U 0.9; } }"""
FIXED, OUTFLOW, SLIP, STILL = "fixedValue; value {};", "zeroGradient;", "slip;", "noSlip;"


class Flow:
    """What was found: `velocity` and `pressure` of the cells, `iterations`, and the case's `folder`."""

    def __init__(self, files, velocities, viscosity, iterations=600, functions=""):
        """`velocities`: the condition of each patch. Where it is OUTFLOW, pressure is 0; where it is given, pressure follows."""
        self.folder = files.folder.parents[1]
        set_types(self.folder, [name for name, condition in velocities.items() if condition != STILL])
        foam.write_field(self.folder, "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", velocities)
        foam.write_field(self.folder, "p", "[0 2 -2 0 0 0 0]", "0", {
            name: FIXED.format("uniform 0") if condition == OUTFLOW else OUTFLOW for name, condition in velocities.items()})
        foam.write(self.folder, "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {viscosity};")
        foam.write(self.folder, "constant/turbulenceProperties", "simulationType laminar;")
        foam.write(self.folder, "system/fvSchemes", SCHEMES)
        foam.write(self.folder, "system/fvSolution", SOLUTION)
        foam.control(self.folder, iterations, functions)
        said = foam.run(self.folder, "simpleFoam")
        self.iterations = len(re.findall(r"^Time = ", said, re.M))
        self.velocity, self.pressure = (foam.read_field(self.folder, self.iterations, name) for name in "Up")


def given(velocity):
    """Of each face of a patch."""
    return FIXED.format(foam.items(velocity))


def along(files, patch, velocity):
    """Of the faces of a wall that moves along itself: what of `velocity` (n, 3) is along them, so that nothing flows through."""
    vectors = files.face_centres()[1][files.of_patch(patch)]
    across = np.einsum("ij,ij->i", velocity, vectors) / np.einsum("ij,ij->i", vectors, vectors)
    return velocity - across[:, None] * vectors


def wall_gradient(files, patch, velocity):
    """Of velocity across the faces of a wall that stands still, as the solver has it (n, 3); their centres and sizes."""
    faces = files.of_patch(patch)
    centres, vectors = (of[faces] for of in files.face_centres())
    owner, sizes = files.owner[faces], np.linalg.norm(vectors, axis=1)
    across = np.einsum("ij,ij->i", centres - files.centres()[owner], vectors / sizes[:, None])
    return velocity[owner] / across[:, None], centres, sizes


def in_middle_half(files, flow, ahead, length):
    """Of a duct from 0 to `length` along `ahead`: how fast pressure falls, and the mean shear at its patch "wall" by the viscosity."""

    def is_middle(x):
        return (x > 0.25 * length) & (x < 0.75 * length)

    x = files.centres() @ ahead
    middle = is_middle(x)
    fall = -np.polyfit(x[middle], flow.pressure[middle], 1, w=np.sqrt(files.volumes()[middle]))[0]
    gradient, centres, sizes = wall_gradient(files, "wall", flow.velocity)
    middle = is_middle(centres @ ahead)
    return fall, np.average((gradient @ ahead)[middle], weights=sizes[middle])
