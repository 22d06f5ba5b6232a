"""Potential flow in the ducts of the exhaust header."""

import foam

SPEED = 1.0
# The file's solids: a wall, an inlet and an outlet for each duct.
DUCTS = [[f"{part}_{duct}" for part in ("wall", "inlet", "outlet")] for duct in range(1, 5)]


def prepare(folder, pieces=1, tolerance=1e-10):
    """The fields of a case, of each of its pieces if there are several, and what potentialFoam wants."""
    every = {"velocity": {}, "pressure": {}}
    for wall, inlet, outlet in DUCTS:
        every["velocity"] |= {wall: "fixedValue; value uniform (0 0 0);",
            inlet: f"surfaceNormalFixedValue; refValue uniform {-SPEED};", outlet: "zeroGradient;"}
        every["pressure"] |= {wall: "zeroGradient;", inlet: "zeroGradient;",
            outlet: "fixedValue; value uniform 0;"}
    for n in range(pieces):
        place = folder / f"processor{n}" if pieces > 1 else folder
        for field in every.values() if pieces > 1 else ():
            field['"procBoundary.*"'] = "processor;"
        foam.write_field(place, "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", every["velocity"])
        foam.write_field(place, "p", "[0 2 -2 0 0 0 0]", "0", every["pressure"])
    foam.write(folder, "system/fvSolution",
        f"solvers {{ Phi {{ solver PCG; preconditioner DIC; tolerance {tolerance}; relTol 0; }} }}\n"
        "potentialFlow { nNonOrthogonalCorrectors 10; }")
    foam.control(folder, 1)


def solve(folder):
    """Flow through each patch, out of the mesh; velocities of the cells."""
    prepare(folder)
    foam.run(folder, "potentialFoam", "-writephi")
    return foam.read_flows(folder, 0), foam.read_field(folder, 0, "U")
