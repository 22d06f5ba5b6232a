# SPDX-License-Identifier: BSD-3-Clause
"""Conduction with the exact temperatures on all walls, by laplacianFoam: a Poisson problem of which all is known."""

import numpy as np

import foam

SOLUTION = """solvers { T { solver PCG; preconditioner DIC; tolerance 1e-11; relTol 0; } }
SIMPLE { nNonOrthogonalCorrectors 20; }"""


def errors(files, temperature, gradient):
    """Of temperatures at the cells' centres and of their gradients across the walls, by the means of what is exact; for
    functions of points (n, 3)."""
    folder = files.folder.parents[1]
    centres, vectors = files.face_centres()
    foam.write_field(folder, "T", "[0 0 0 1 0 0 0]", "0", {
        name: f"fixedValue; value {foam.items(temperature(centres[files.of_patch(name)]))};" for name in files.patches})
    foam.write(folder, "constant/transportProperties", "DT [0 2 -1 0 0 0 0] 1;")
    foam.write(folder, "system/fvSchemes", "ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }\n"
        "divSchemes { default none; } laplacianSchemes { default Gauss linear corrected; }\n"
        "interpolationSchemes { default linear; } snGradSchemes { default corrected; }")
    foam.write(folder, "system/fvSolution", SOLUTION)
    foam.control(folder, 1)
    foam.run(folder, "laplacianFoam")
    found, cells, volumes = foam.read_field(folder, 1, "T"), files.centres(), files.volumes()
    error = np.abs(found - temperature(cells))
    span = np.ptp(temperature(centres[len(files.neighbour):]))
    walls = slice(len(files.neighbour), None)
    owner, sizes = files.owner[walls], np.linalg.norm(vectors[walls], axis=1)
    normals = vectors[walls] / sizes[:, None]
    across = np.einsum("ij,ij->i", centres[walls] - cells[owner], normals)
    exact = np.einsum("ij,ij->i", gradient(centres[walls]), normals)
    steep = (temperature(centres[walls]) - found[owner]) / across
    return {"mean error": float(np.average(error, weights=volumes) / span),
            "largest error": float(error.max() / span),
            "wall gradient": float(np.average(np.abs(steep - exact), weights=sizes) / np.average(np.abs(exact), weights=sizes))}
