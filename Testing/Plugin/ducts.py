"""Potential flow in the ducts of the exhaust header."""

import foam

SPEED = 1.0
# The file's solids: a wall, an inlet and an outlet for each duct.
DUCTS = [[f"{part}_{duct}" for part in ("wall", "inlet", "outlet")] for duct in range(1, 5)]


def solve(folder):
    """Flow through each patch, out of the mesh; velocities of the cells."""
    every = {"velocity": {}, "pressure": {}}
    for wall, inlet, outlet in DUCTS:
        every["velocity"] |= {wall: "fixedValue; value uniform (0 0 0);",
            inlet: f"surfaceNormalFixedValue; refValue uniform {-SPEED};", outlet: "zeroGradient;"}
        every["pressure"] |= {wall: "zeroGradient;", inlet: "zeroGradient;",
            outlet: "fixedValue; value uniform 0;"}
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", every["velocity"])
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0", every["pressure"])
    foam.write(folder, "system/fvSolution",
        "solvers { Phi { solver PCG; preconditioner DIC; tolerance 1e-10; relTol 0; } }\n"
        "potentialFlow { nNonOrthogonalCorrectors 10; }")
    foam.control(folder, 1)
    foam.run(folder, "potentialFoam", "-writephi")
    return foam.read_flows(folder, 0), foam.read_field(folder, 0, "U")
