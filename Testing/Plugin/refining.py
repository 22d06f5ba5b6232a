"""Solvers that refine: OpenFOAM's dynamicRefineFvMesh in cases of ours."""

import pathlib
import re

import numpy as np

import foam

SCHEMES = """ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) Gauss upwind; div(phi,s) Gauss upwind;
  div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear limited 0.5; } interpolationSchemes { default linear; } snGradSchemes { default limited 0.5; }"""
SOLUTION = """solvers
{
  "(p|pcorr).*" { solver PCG; preconditioner DIC; tolerance 1e-7; relTol 0.01; }
  "(U|s).*" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-7; relTol 0; }
}
PIMPLE { correctPhi yes; nOuterCorrectors 1; nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0; }"""

FOLLOWED = """functions { s { type scalarTransport; libs (solverFunctionObjects); field s; phi phi; D 1e-6; resetOnStartUp no; } }"""


def refine(folder, field, least, most, deepest):
    """constant/dynamicMeshDict: cells are refined each step where the field is between these values, up to a level, elsewhere that
    is undone."""
    foam.write(folder, "constant/dynamicMeshDict", f"""dynamicFvMesh dynamicRefineFvMesh;
refineInterval 1; field {field}; lowerRefineLevel {least}; upperRefineLevel {most}; unrefineLevel 1e6; nBufferLayers 1;
maxRefinement {deepest}; maxCells 2000000; correctFluxes ((phi none)); dumpLevel false;""")


def prepare(folder):
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", SOLUTION)
    foam.write(folder, "constant/turbulenceProperties", "simulationType laminar;")


def run(folder, solver, end, step, start="latestTime", more=""):
    """The numbers of cells after each step that changes them, refined (True) or undone."""
    foam.write(folder, "system/controlDict", f"startFrom {start}; startTime 0; stopAt endTime; endTime {end}; deltaT {step};\n"
               f"writeControl timeStep; writeInterval {round(end / step)}; writeFormat binary;\n{more}")
    said = foam.run(folder, solver)
    return [(kind == "Refined", int(before), int(after))
            for kind, before, after in re.findall(r"(Refined|Unrefined) from (\d+) to (\d+) cells", said)], said


def rest(folder, patches):
    """A fluid at rest, for pimpleFoam."""
    prepare(folder)
    foam.write(folder, "constant/transportProperties", "transportModel Newtonian; nu 1e-3;")
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", {name: "noSlip;" for name in patches})
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0", {name: "zeroGradient;" for name in patches})


def refine_all(folder, deeper):
    """Refines all cells that may be, up to so much `deeper` than the deepest, then undoes it all. The numbers of cells: of the mesh,
    refined, and at the end; and that of protected cells."""
    files = foam.Files(folder)
    rest(folder, files.patches)
    deepest = int(files.lists("cellLevel", np.int32)[0].max()) + deeper
    refine(folder, "p", -1, 1, deepest)
    changes, said = run(folder, "pimpleFoam", 2 + deeper, 1, "startTime")
    protected = int(re.search(r"Detected (\d+) cells that are protected", said)[1])
    return files.cells, changes[-1][2], undo(folder, "p", deepest, 8 + 2 * deeper, 1), protected


def undo(folder, field, deepest, end, step, more=""):
    """From the last time on, all refinement; the number of cells at the end."""
    refine(folder, field, 1e3, 1e4, deepest)
    changes, _ = run(folder, "pimpleFoam", end, step, more=more)
    return changes[-1][2]


def drop(folder, centre, radius, speed, end, step):
    """A ball of fluid, with 1 as the scalar s, moves along x with pimpleFoam; cells are refined at its surface, in the end none.
    Whether some were refined and some of these undone on the way, and the numbers of cells of the mesh, then, and at the end."""
    files = foam.Files(folder)
    prepare(folder)
    foam.write(folder, "constant/transportProperties", "transportModel Newtonian; nu 1e-2;")
    stream = f"({speed} 0 0)"
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", stream, {name: "inletOutlet; inletValue uniform (0 0 0); value uniform (0 0 0);"
        if name == "outlet" else "noSlip;" if kind == "wall" else f"fixedValue; value uniform {stream};"
        for name, (kind, _, _) in files.patches.items()})
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0",
                     {name: "fixedValue; value uniform 0;" if name == "outlet" else "zeroGradient;" for name in files.patches})
    foam.write_field(folder, "s", "[0 0 0 0 0 0 0]", "0", {name: "zeroGradient;" for name in files.patches})
    path = pathlib.Path(folder) / "0/s"
    inside = (np.linalg.norm(files.centres() - centre, axis=1) < radius).astype(float)
    path.write_text(path.read_text().replace("internalField uniform 0", f"internalField {foam.items(inside)}"))
    deepest = int(files.lists("cellLevel", np.int32)[0].max())
    refine(folder, "s", 0.1, 0.9, deepest)
    changes, _ = run(folder, "pimpleFoam", end, step, "startTime", FOLLOWED)
    kinds = {refined for refined, _, _ in changes}
    return kinds == {True, False}, files.cells, changes[-1][2], undo(folder, "s", deepest, end + 4 * step, step, FOLLOWED)
