"""Heat conduction: with the exact temperatures on the boundary, laplacianFoam's mean error falls as cells
get smaller: with an order above 1.5 in a shell between spheres, above 1.3 in a cube turned against the
grid. Cells at walls along which the temperature changes have an error of first order (OpenFOAM does not
correct skewness there), but they are a single layer."""

import math
import pathlib
import tempfile

import numpy as np
from paraview import simple

import foam


def around_a_point(p):
    return 1 / np.linalg.norm(p, axis=1)


def exponential(p):
    x, y, z = p.T
    return np.exp(x) * np.cos(math.sqrt(2) * y) * np.exp(z)


def mean_error(folder, temperature):
    files = foam.Files(folder)
    face_centres, _ = files.face_centres()
    foam.write_field(folder, "T", "[0 0 0 1 0 0 0]", "1", {
        name: f"fixedValue; value {foam.items(temperature(face_centres[files.of_patch(name)]))};"
        for name in files.patches})
    foam.write(folder, "constant/transportProperties", "DT [0 2 -1 0 0 0 0] 1;")
    foam.write(folder, "system/fvSolution",
        "solvers { T { solver PCG; preconditioner DIC; tolerance 1e-10; relTol 0; } }\n"
        "SIMPLE { nNonOrthogonalCorrectors 15; }")
    foam.control(folder, 1)
    foam.run(folder, "laplacianFoam")
    error = np.abs(foam.read_field(folder, 1, "T") - temperature(files.centres()))
    volumes = files.volumes()
    print(f"{files.cells} cells: mean error {np.average(error, weights=volumes):.3g}, "
          f"root of mean square {np.average(error**2, weights=volumes)**0.5:.3g}, "
          f"largest {error.max():.3g}", flush=True)
    return np.average(error, weights=volumes)


def check(name, surface, temperature, sizes, least):
    """`least`: order; `temperature`: any without sources, its second derivatives add up to 0."""
    print(name)
    errors = []
    with tempfile.TemporaryDirectory() as temporary:
        for size in sizes:
            mesher = simple.CartesianMesher(Input=surface, CellSize=size)
            folder = foam.save(mesher, pathlib.Path(temporary) / str(size))
            errors.append(mean_error(folder, temperature))
    order = math.log2(errors[0] / errors[-1]) / (len(errors) - 1)
    print(f"order {order:.2f}")
    assert order > least, order


outer = simple.Sphere(Radius=1, ThetaResolution=128, PhiResolution=64)
inner = simple.ReverseSense(Input=simple.Sphere(Radius=0.4, ThetaResolution=64, PhiResolution=32),
                            ReverseCells=1)
check("shell", simple.AppendGeometry(Input=[outer, inner]), around_a_point, (0.21, 0.105, 0.0525), 1.5)

turned = simple.Transform(Input=simple.Box())
turned.Transform.Rotate = [30, 0, 30]
check("cube", turned, exponential, (1 / 8, 1 / 16, 1 / 32), 1.3)
