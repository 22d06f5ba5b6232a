"""Solvers that refine: OpenFOAM's dynamicRefineFvMesh in cases of ours."""

import pathlib
import re

import numpy as np

import foam

SCHEMES = """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss upwind; div(rhoPhi,U) Gauss upwind; div(phi,alpha) Gauss vanLeer;
  div(phirb,alpha) Gauss linear; div((nuEff*dev2(T(grad(U))))) Gauss linear; div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear limited 0.5; } interpolationSchemes { default linear; } snGradSchemes { default limited 0.5; }"""
SOLUTION = """solvers
{
  "(p|p_rgh|pcorr).*" { solver PCG; preconditioner DIC; tolerance 1e-7; relTol 0.01; }
  "U.*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-7; relTol 0; }
  "alpha.*" { nAlphaCorr 1; nAlphaSubCycles 1; cAlpha 0; }
}
PIMPLE { correctPhi yes; nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }"""


def refine(folder, field, least, most, deepest, fluxes="(phi none)"):
    """constant/dynamicMeshDict: cells are refined each step where the field is between these values, up to a level, elsewhere that
    is undone."""
    foam.write(folder, "constant/dynamicMeshDict", f"""dynamicFvMesh dynamicRefineFvMesh;
refineInterval 1; field {field}; lowerRefineLevel {least}; upperRefineLevel {most}; unrefineLevel 1e6; nBufferLayers 1;
maxRefinement {deepest}; maxCells 2000000; correctFluxes ({fluxes}); dumpLevel true;""")


def prepare(folder):
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", SOLUTION)
    foam.write(folder, "constant/turbulenceProperties", "simulationType laminar;")


def run(folder, solver, end, step, start="latestTime"):
    """The numbers of cells after each step that changes them, refined (True) or undone."""
    foam.write(folder, "system/controlDict", f"startFrom {start}; startTime 0; stopAt endTime; endTime {end}; deltaT {step};\n"
               f"writeControl timeStep; writeInterval {round(end / step)}; writeFormat binary;\n"
               "adjustTimeStep no; maxCo 1; maxAlphaCo 1; maxDeltaT 1;")
    said = foam.run(folder, solver)
    return [(kind == "Refined", int(before), int(after))
            for kind, before, after in re.findall(r"(Refined|Unrefined) from (\d+) to (\d+) cells", said)], said


def rest(folder, patches):
    """A fluid at rest, for pimpleFoam."""
    prepare(folder)
    foam.write(folder, "constant/transportProperties", "transportModel Newtonian; nu 1e-3;")
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", {name: "noSlip;" for name in patches})
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0", {name: "zeroGradient;" for name in patches})


def level_files(folder):
    mesh = pathlib.Path(folder) / "constant/polyMesh"
    return [mesh / name for name in ("cellLevel", "pointLevel", "level0Edge") if (mesh / name).exists()]


def refine_all(folder, deeper=1):
    """Refines all cells that may be, up to so much `deeper` than the deepest, then undoes it all. The numbers of cells: of the mesh,
    refined, and at the end."""
    files = foam.Files(folder)
    levels = files.lists("cellLevel", np.int32)[0]
    rest(folder, files.patches)
    deepest = int(levels.max()) + deeper
    refine(folder, "p", -1, 1, deepest)
    refined, said = run(folder, "pimpleFoam", 2 + deeper, 1, "startTime")
    refine(folder, "p", 10, 11, deepest)
    undone, _ = run(folder, "pimpleFoam", 8 + 2 * deeper, 1)
    return files.cells, refined[-1][2] if refined else files.cells, undone[-1][2] if undone else None, said


def drop(folder, centre, radius, speed, end, step):
    """A drop, of the fluid around it, moves with the stream along x, for interFoam; cells are refined at its surface. `undone`: whether
    some were refined, and some of these undone; the numbers of cells of the mesh and at the end; and what the solver said."""
    files = foam.Files(folder)
    prepare(folder)
    phase = "{ transportModel Newtonian; nu 1e-2; rho 1; }"
    foam.write(folder, "constant/transportProperties", f"phases (water air); water {phase} air {phase} sigma 0;")
    foam.write(folder, "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);", "uniformDimensionedVectorField")
    stream = f"({speed} 0 0)"
    ends = {name: name in ("outlet", "xMax") for name in files.patches}
    bodies = {name for name in files.patches if name.startswith("boundary")}
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", stream, {name: "slip;" if name in bodies else "zeroGradient;" if out
        else f"fixedValue; value uniform {stream};" for name, out in ends.items()})
    foam.write_field(folder, "p_rgh", "[1 -1 -2 0 0 0 0]", "0", {name: "fixedValue; value uniform 0;" if out else
        "fixedFluxPressure; value uniform 0;" for name, out in ends.items()})
    foam.write_field(folder, "alpha.water", "[0 0 0 0 0 0 0]", "0", {name: "zeroGradient;" for name in files.patches})
    path = pathlib.Path(folder) / "0/alpha.water"
    inside = (np.linalg.norm(files.centres() - centre, axis=1) < radius).astype(float)
    path.write_text(path.read_text().replace("internalField uniform 0", f"internalField {foam.items(inside)}"))
    deepest = int(files.lists("cellLevel", np.int32)[0].max()) + 1
    fluxes = "".join(f"({name} none)" for name in ("phi", "nHatf", "rhoPhi", "alphaPhi0.water", "ghf", "alphaPhiUn"))
    refine(folder, "alpha.water", 0.01, 0.99, deepest, fluxes)
    changes, said = run(folder, "interFoam", end, step, "startTime")
    return {kind for kind, _, _ in changes} == {True, False}, files.cells, changes[-1][2], said
