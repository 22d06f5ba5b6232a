# SPDX-License-Identifier: BSD-3-Clause
"""wallcells.py measures as checkMesh does, and as simple shapes ask; its commands print their tables, each with
a line or a column for snappyHexMesh where that is installed."""

import contextlib
import io
import pathlib
import re
import sys
import tempfile

import numpy as np
from paraview import simple

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import wallcells  # noqa: E402  (it finds the other modules)
import foam  # noqa: E402
import wallmeasures  # noqa: E402
import wallmeshes  # noqa: E402
import wallsurfaces  # noqa: E402

AS_CHECKMESH = {"skewness": "skewness", "non-orthogonality": "non-orthogonality", "face weight": "weight",
                "volume ratio": "volume ratio", "determinant": "determinant"}


def check_sphere(mesher, folder):
    surface, size = wallsurfaces.sphere(24), 1 / 8
    meshed = wallmeshes.make(mesher, surface, size, 1, folder)
    found, checked = wallmeasures.cells(meshed.mesh, meshed.boxes), foam.CheckMesh(folder, "-allGeometry")
    for ours, theirs in AS_CHECKMESH.items():
        assert abs(found[ours] / checked.figures[theirs] - 1) < 1e-3, f"{mesher}: {ours} {found[ours]}"
    # snappyHexMesh moves inner points, too.
    part = np.median((meshed.mesh.volume / meshed.boxes)[~meshed.mesh.at_wall])
    assert abs(part - 1) < 0.2, f"{mesher}: an inner cell has {part} of its box"
    figures = wallmeasures.fidelity(meshed.mesh, surface, size / 2)
    assert abs(figures["volume error"]) < 0.02 and figures["faces leaning over 45 degrees"] == 0
    assert abs(wallmeasures.area_errors(meshed.mesh, surface)["surface"]) < 0.02
    moved = wallsurfaces.Surface("moved", surface.corners + [size, 0, 0], surface.solids, surface.names)
    figures = wallmeasures.fidelity(meshed.mesh, moved, size / 2)
    for direction in "boundary from surface (boxes)", "surface from boundary (boxes)":
        assert abs(figures[direction] - 2) < 0.1, figures[direction]


def check_cube(folder):
    """Faces of a cube lean from a sphere around it where that is known; a uniform flow needs no more time
    through a box than its length takes."""
    cube = wallsurfaces.from_proxy("cube", simple.Box())
    mesh = wallmeshes.make(wallmeshes.OURS, cube, 1 / 16, 0, folder).mesh
    figures = wallmeasures.fidelity(mesh, wallsurfaces.sphere(60, radius=0.87), 1 / 16)
    at = mesh.face_at[mesh.inner:]
    expected = (np.abs(at).max(axis=1) < 0.69 * np.linalg.norm(at, axis=1)).sum()
    near = (np.abs(at).max(axis=1) < 0.725 * np.linalg.norm(at, axis=1)).sum()
    for name in "faces leaning over 45 degrees", "... where the surface is smooth":
        assert expected <= figures[name] <= near and expected > 0, (name, figures[name], expected, near)
    assert (mesh.time_step() <= wallmeasures.COURANT / 16 * 1.01).all()
    assert cube.contain(np.array([0.4, 0.3, 0.2])) and not cube.contain(np.array([0.6, 0.3, 0.2]))


def check_edges(folder):
    """Exact Fit keeps a cube's edges, inside and outside; a smaller mesh does not have them."""
    cube = wallsurfaces.from_proxy("cube", simple.Box())
    assert np.allclose(wallmeasures.length(np.diff(cube.sharp_edges(30), axis=1)[:, 0]).sum(), 12)
    for outside in False, True:
        mesh = wallmeshes.make(wallmeshes.OURS, cube, 1 / 8, 0, folder / str(outside),
                               {"PatchMethod": "Exact Fit"}, outside=outside).mesh
        figures = wallmeasures.fidelity(mesh, cube, 1 / 8, outside)
        assert abs(figures["volume error"]) < 1e-5 and figures["sharp edges kept"] == 1, figures
        assert figures["faces leaning over 45 degrees"] == 0 and figures["... rms"] < 1e-5, figures
        mesh.points = mesh.points * 0.9
        assert wallmeasures.fidelity(mesh, cube, 1 / 8, outside)["sharp edges kept"] == 0


def check_parts():
    """A point in each of two parts, and none in a void."""
    one = wallsurfaces.sphere(24)
    corners = np.concatenate([one.corners, 0.2 * one.corners[:, ::-1], one.corners + [2, 0, 0]])
    corners = np.random.default_rng(1).permutation(corners)
    three = wallsurfaces.Surface("three", corners, np.zeros(len(corners), int), ["surface"])
    assert np.bincount(three.parts()).tolist() == [len(one.corners)] * 3
    inside = np.array(sorted(three.points_inside(1 / 8)))
    assert inside.shape == (2, 3) and all(three.contain(point) for point in inside)
    assert (np.linalg.norm(inside - [[0, 0, 0], [2, 0, 0]], axis=1) < 0.5).all()


def check_commands():
    for command in ("cells tilted_pipe --size 1/12", "fidelity tilted_pipe --sizes 1/12 --turns 2",
                    "timestep bend --size 8 --depth 0", "pipe --size 0.2",
                    "solvers tilted_pipe --size 8 --depth 0 --iterations 3 --limit 9"):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            wallcells.run(command.split())
        text = said.getvalue()
        print(text)
        assert all(mesher in text for mesher in wallmeshes.MESHERS), command
        assert "FAILED" not in text and not re.search(r"\bnan\b", text), command


with tempfile.TemporaryDirectory() as temporary:
    for number, name in enumerate(wallmeshes.MESHERS):
        check_sphere(name, pathlib.Path(temporary) / str(number))
    check_cube(pathlib.Path(temporary) / "cube")
    check_edges(pathlib.Path(temporary) / "edges")
check_parts()
check_commands()
