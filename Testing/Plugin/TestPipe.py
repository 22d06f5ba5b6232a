"""Laminar flow through a circular pipe at an angle to the grid, 20 cells across: simpleFoam's pressure
falls along the pipe as Poiseuille says, within 3 %."""

import math
import pathlib
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk

import foam
from pipeline import polydata, producer

CELLS_ACROSS = 20
FACETS = 180  # they take a 2500th of the cross-section
RADIUS, LENGTH = 0.5, 2.0
AXIS = np.array([1, 0.6, 0.35]) / np.linalg.norm([1, 0.6, 0.35])
VISCOSITY, SPEED = 0.1, 1.0  # the mean one: Reynolds number 10
WALL, INLET, OUTLET = range(3)


def pipe():
    u = np.cross(AXIS, [0, 0, 1]) / np.linalg.norm(np.cross(AXIS, [0, 0, 1]))
    v = np.cross(AXIS, u)
    angle = np.arange(FACETS) * 2 * math.pi / FACETS
    circle = RADIUS * (np.cos(angle)[:, None] * u + np.sin(angle)[:, None] * v)
    points = np.concatenate([circle, circle + LENGTH * AXIS, [0 * AXIS, LENGTH * AXIS]])
    polygons, boundaries = [], []
    for i in range(FACETS):
        j = (i + 1) % FACETS
        polygons += [(i, j, FACETS + j), (i, FACETS + j, FACETS + i), (j, i, 2 * FACETS),
                     (FACETS + i, FACETS + j, 2 * FACETS + 1)]
        boundaries += [WALL, WALL, INLET, OUTLET]
    surface = polydata(points, polygons)
    ids = numpy_to_vtk(np.array(boundaries, np.int32), deep=True)
    ids.SetName("Part")
    surface.GetCellData().AddArray(ids)
    return producer(surface)


def velocity(p):
    along = p @ AXIS
    square = ((p - along[:, None] * AXIS)**2).sum(axis=1)
    return np.maximum(2 * SPEED * (1 - square / RADIUS**2), 0)[:, None] * AXIS


def solve(folder):
    """Fall of pressure along the pipe, per length, where the flow is the same all along it; and the
    mean speed through the outlet."""
    files = foam.Files(folder)
    wall, inlet, outlet = (f"boundary_{i}" for i in (WALL, INLET, OUTLET))
    face_centres, vectors = files.face_centres()
    given = velocity(face_centres[files.of_patch(inlet)])
    foam.write_field(folder, "U", "[0 1 -1 0 0 0 0]", "({} {} {})".format(*AXIS), {
        wall: "noSlip;", inlet: f"fixedValue; value {foam.items(given)};", outlet: "zeroGradient;"})
    foam.write_field(folder, "p", "[0 2 -2 0 0 0 0]", "0", {
        wall: "zeroGradient;", inlet: "zeroGradient;", outlet: "fixedValue; value uniform 0;"})
    foam.write(folder, "constant/transportProperties",
               f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {VISCOSITY};")
    foam.write(folder, "constant/turbulenceProperties", "simulationType laminar;")
    foam.write(folder, "system/fvSchemes",
        "ddtSchemes { default steadyState; }\ngradSchemes { default cellLimited Gauss linear 1; }\n"
        "divSchemes { default none; div(phi,U) bounded Gauss linearUpwind grad(U);\n"
        "div((nuEff*dev2(T(grad(U))))) Gauss linear; }\n"
        "laplacianSchemes { default Gauss linear limited corrected 0.5; }\n"
        "interpolationSchemes { default linear; }\nsnGradSchemes { default limited corrected 0.5; }")
    foam.write(folder, "system/fvSolution",
        "solvers { p { solver PCG; preconditioner DIC; tolerance 1e-9; relTol 0.05; }\n"
        "U { solver PBiCGStab; preconditioner DILU; tolerance 1e-9; relTol 0.1; } }\n"
        "SIMPLE { consistent yes; nNonOrthogonalCorrectors 1;\n"
        "residualControl { p 1e-5; U 1e-5; } }\n"
        "relaxationFactors { equations { U 0.9; } fields { p 0.9; } }")
    foam.control(folder, 1000)
    foam.run(folder, "simpleFoam")
    last = max(int(path.name) for path in pathlib.Path(folder).glob("[1-9]*"))
    pressure = foam.read_field(folder, last, "p")
    along = files.centres() @ AXIS
    middle = (along > 0.25 * LENGTH) & (along < 0.75 * LENGTH)
    slope, _ = np.polyfit(along[middle], pressure[middle], 1, w=np.sqrt(files.volumes()[middle]))
    flow = -np.einsum("ij,ij->", given, vectors[files.of_patch(inlet)])
    print(f"{files.cells} cells, {last} iterations")
    return -slope, flow / (math.pi * RADIUS**2)


mesher = simple.CartesianMesher(Input=pipe(), CellSize=2 * RADIUS / CELLS_ACROSS, BoundaryArray="Part")
with tempfile.TemporaryDirectory() as temporary:
    fall, speed = solve(foam.save(mesher, temporary))
expected = 8 * VISCOSITY * speed / RADIUS**2
print(f"pressure falls by {fall:.5g} a length, expected {expected:.5g} ({fall / expected - 1:+.2%})")
assert abs(fall / expected - 1) < 0.03
