# SPDX-License-Identifier: BSD-3-Clause
"""Solvers for wallcells.py: turbulent flow with plain schemes through a duct, and conduction across a pipe.

The flow is what asks most of a mesh: kEpsilon or kOmegaSST, linearUpwind with plain Gauss gradients, corrected
Laplacians, from potentialFoam, in simpleFoam. Nothing limits what poor cells do to it."""

import os
import re
import subprocess

import numpy as np

import foam

VISCOSITY = 1.5e-2
K = 0.5  # at the inlet
SCHEMES = """ddtSchemes { default steadyState; }
gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) bounded Gauss linearUpwind grad(U);
    div(phi,k) bounded Gauss limitedLinear 1; div(phi,epsilon) $div(phi,k); div(phi,omega) $div(phi,k);
    div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }
snGradSchemes { default corrected; } wallDist { method meshWave; }"""
SOLUTION = """solvers {
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-9; relTol 0.05; } Phi { $p; relTol 0.01; }
    "(U|k|epsilon|omega)" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-10; relTol 0.1; nSweeps 1; } }
SIMPLE { nNonOrthogonalCorrectors 0; consistent no; } potentialFlow { nNonOrthogonalCorrectors 5; }
relaxationFactors { fields { p 0.3; } equations { U 0.7; k 0.7; epsilon 0.7; omega 0.7; } }"""


class Duct:
    """What flows: names of the ends, all else is wall; velocity at the inlet; the iterations to run, and
    the largest speed that is believed, by the inlet's; the model of turbulence."""

    def __init__(self, surface, inlet, outlet, velocity=None, speed=20.0, iterations=500, limit=3.0,
                 model="kEpsilon"):
        self.inlet, self.outlet, self.iterations, self.limit, self.model = inlet, outlet, iterations, limit, model
        those = surface.solids == surface.names.index(inlet)
        inward = -(surface.areas[those, None] * surface.normals[those]).sum(axis=0)
        ahead = inward / np.linalg.norm(inward) if surface.ahead is None else surface.ahead
        self.velocity = np.array(velocity) if velocity else speed * ahead
        self.diameter = np.sqrt(4 * surface.area_of(inlet) / np.pi)


def set_types(folder, ends):
    """The ends are patches, all others walls."""
    path = folder / "constant" / "polyMesh" / "boundary"
    text = path.read_text()
    for name in foam.Files(folder).patches:
        text = re.sub(rf"(\b{re.escape(name)}\s*\{{\s*type\s+)\w+;(\s*inGroups[^;]*;)?",
                      rf"\g<1>{'patch' if name in ends else 'wall'};", text)
    path.write_text(text)


def write_flow(folder, duct):
    names = list(foam.Files(folder).patches)
    missing = {duct.inlet, duct.outlet} - set(names)
    assert not missing, f"the mesh has no boundary {', '.join(missing)}"
    omega = K ** 0.5 / (0.09 ** 0.25 * 0.07 * duct.diameter)
    rate, units, start = {"kEpsilon": ("epsilon", "[0 2 -3 0 0 0 0]", 0.09 * K * omega),
                          "kOmegaSST": ("omega", "[0 0 -1 0 0 0 0]", omega)}[duct.model]
    velocity = "({!r} {!r} {!r})".format(*duct.velocity.tolist())
    none, fixed, uniform = "zeroGradient;", "fixedValue; value uniform {};", "; value uniform {};"
    back = "inletOutlet; inletValue uniform {0}; value uniform {0};"

    def field(name, dimensions, start, inlet, outlet, wall):
        foam.write_field(folder, name, dimensions, str(start), {
            patch: {duct.inlet: inlet, duct.outlet: outlet}.get(patch, wall) for patch in names})

    zero = "(0 0 0)"
    field("U", "[0 1 -1 0 0 0 0]", zero, fixed.format(velocity), back.format(zero), "noSlip;")
    field("p", "[0 2 -2 0 0 0 0]", 0, none, fixed.format(0), none)
    field("k", "[0 2 -2 0 0 0 0]", K, fixed.format(K), back.format(K), "kqRWallFunction" + uniform.format(K))
    field(rate, units, start, fixed.format(start), back.format(start), rate + "WallFunction" + uniform.format(start))
    field("nut", "[0 2 -1 0 0 0 0]", 0.1, "calculated" + uniform.format(0), "calculated" + uniform.format(0),
          "nutkWallFunction" + uniform.format(0))
    foam.write(folder, "constant/transportProperties",
               f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {VISCOSITY};")
    foam.write(folder, "constant/turbulenceProperties",
               f"simulationType RAS; RAS {{ RASModel {duct.model}; turbulence on; printCoeffs off; }}")
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", SOLUTION)
    foam.control(folder, duct.iterations)


def attempt(folder, program, *options):
    """Whether it ran to its end, and what it said."""
    environment = dict(os.environ, WM_PROJECT_DIR=foam.CONFIGURATION, PWD=str(folder))
    with open(folder / f"log.{program}", "w+", encoding="utf-8", errors="replace") as log:
        code = subprocess.run([program, *options], cwd=folder, env=environment, stdout=log,
                              stderr=subprocess.STDOUT).returncode
        log.seek(0)
        return code == 0, log.read()


def last(pattern, text):
    found = re.findall(pattern, text, re.MULTILINE)
    return float(found[-1]) if found else float("nan")


def results(folder, duct):
    """The largest speed, and the mean pressure over the inlet, where its gradient is 0. (Debian 13's simpleFoam has no
    function objects: it dies of the first.)"""
    files = foam.Files(folder)
    inlet = files.of_patch(duct.inlet)
    _, vectors = files.face_centres()
    pressure = foam.read_field(folder, duct.iterations, "p")[files.owner[inlet]]
    speeds = np.linalg.norm(foam.read_field(folder, duct.iterations, "U"), axis=1)
    return speeds.max(), np.average(pressure, weights=np.linalg.norm(vectors[inlet], axis=1))


def start_potential(folder):
    """Whether potentialFoam ran. Of what it finds, only the flux stays: the velocity that Debian's 1912 makes of it in
    fvc::reconstruct is wrong, by the more the smaller the cell (in `inv(...) & surfaceSum(...)` of fields the result
    shares the vector's memory, and its x is overwritten before y and z are made of it)."""
    start = folder / "0" / "U"
    given = start.read_bytes()
    started, _ = attempt(folder, "potentialFoam", "-writephi")
    start.write_bytes(given)
    return started


def flow(folder, duct):
    """Runs the case in the folder of a mesh. Figures of the run; "OK" if it ran all its iterations and no speed
    is beyond the limit."""
    set_types(folder, (duct.inlet, duct.outlet))
    write_flow(folder, duct)
    started = start_potential(folder)
    ran, log = attempt(folder, "simpleFoam") if started else (False, "")
    iterations, speed = len(re.findall(r"^Time = ", log, re.MULTILINE)), np.linalg.norm(duct.velocity)
    largest, drop = results(folder, duct) if ran else (float("nan"), float("nan"))
    largest /= speed
    return {
        "OK": ran and iterations == duct.iterations and largest < duct.limit,
        "iterations": iterations,
        "residual of p": last(r"Solving for p, Initial residual = ([^,]+)", log),
        "k bounded": log.count("bounding k"),
        "epsilon or omega bounded": log.count("bounding epsilon") + log.count("bounding omega"),
        "speed / inlet's": largest,
        "pressure drop": drop,
    }


def wall_gradient(meshed, radius, wall="wall"):
    """Figures of the error of the wall's gradient, relative to the exact one, where the Laplacian of T is -1, T
    is 0 on the wall, and nothing changes along the pipe."""
    folder, mesh = meshed.folder, meshed.mesh
    foam.write_field(folder, "T", "[0 0 0 1 0 0 0]", "0", {
        name: "fixedValue; value uniform 0;" if name == wall else "zeroGradient;" for name in mesh.patches})
    foam.write(folder, "constant/transportProperties", "DT [0 2 -1 0 0 0 0] 1;")
    foam.write(folder, "system/fvOptions", """source { type scalarSemiImplicitSource; active true;
        scalarSemiImplicitSourceCoeffs { selectionMode all; volumeMode specific;
            injectionRateSuSp { T (1 0); } } }""")
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution",
        "solvers { T { solver PCG; preconditioner DIC; tolerance 1e-10; relTol 0; } }\n"
        "SIMPLE { nNonOrthogonalCorrectors 15; }")
    foam.control(folder, 1)
    foam.run(folder, "laplacianFoam")
    value = foam.read_field(folder, 1, "T")
    faces = mesh.of_patch(wall)
    owner = mesh.owner[faces]
    normals = mesh.vectors[faces] / mesh.sizes[faces, None]
    away = mesh.face_at[faces] - mesh.at[owner]
    # As OpenFOAM has it for fixed values.
    distance = np.maximum(np.einsum("ij,ij->i", normals, away), 0.05 * np.linalg.norm(away, axis=1))
    error = value[owner] / distance / (radius / 2) - 1
    return {
        "faces of the wall": len(error),
        "rms of the error": np.sqrt((error ** 2).mean()),
        "... by area": np.sqrt(np.average(error ** 2, weights=mesh.sizes[faces])),
        "99 % quantile": np.quantile(np.abs(error), 0.99),
        "largest": np.abs(error).max(),
    }
