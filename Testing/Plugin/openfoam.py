"""OpenFOAM's checkMesh (Debian's package openfoam), as an independent judge of meshes."""

import os
import re
import subprocess

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

HEAD = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"

SYSTEM = {
    "controlDict": """application checkMesh; startFrom startTime; startTime 0; stopAt endTime;
        endTime 1; deltaT 1; writeControl timeStep; writeInterval 1; writePrecision 17;""",
    "fvSchemes": """ddtSchemes {} gradSchemes {} divSchemes {} laplacianSchemes {}
        interpolationSchemes {} snGradSchemes {} wallDist { method meshWave; }""",
    "fvSolution": "",
}


def write_case(folder, faces):
    """The least that checkMesh reads; `faces` is the second output of Finite Volume Quality."""
    for part in "system", "constant/polyMesh":
        (folder / part).mkdir(parents=True)
    for name, text in SYSTEM.items():
        (folder / "system" / name).write_text(HEAD.format("dictionary", name) + text)
    points = vtk_to_numpy(faces.GetPoints().GetData()).astype(float)
    polygons = faces.GetPolys()
    corners = np.split(vtk_to_numpy(polygons.GetConnectivityArray()),
        vtk_to_numpy(polygons.GetOffsetsArray())[1:-1])
    owner, neighbour = (vtk_to_numpy(faces.GetCellData().GetArray(name))
                        for name in ("Owner", "Neighbour"))
    inner = np.count_nonzero(neighbour >= 0)
    boundary = f"walls {{ type wall; nFaces {len(owner) - inner}; startFace {inner}; }}"
    lists = {
        "points": ("vectorField", ["({!r} {!r} {!r})".format(*map(float, p)) for p in points]),
        "faces": ("faceList", [f"{len(c)}({' '.join(map(str, c))})" for c in corners]),
        "owner": ("labelList", map(str, owner)),
        "neighbour": ("labelList", map(str, neighbour[:inner])),
        "boundary": ("polyBoundaryMesh", [boundary]),
    }
    for name, (kind, rows) in lists.items():
        rows = list(rows)
        (folder / "constant/polyMesh" / name).write_text(
            HEAD.format(kind, name) + f"{len(rows)}\n(\n" + "\n".join(rows) + "\n)\n")


def check_mesh(folder, *options):
    """What it says."""
    done = subprocess.run(["checkMesh", "-case", str(folder), *options], check=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        env={"WM_PROJECT_DIR": "/usr/share/openfoam"} | os.environ)
    return done.stdout


def read_field(folder, name, cells):
    """Of the cells, as checkMesh -writeAllFields wrote it."""
    text = (folder / "constant" / name).read_text()
    uniform = re.search(r"internalField\s+uniform\s+(\S+);", text)
    if uniform:
        return np.full(cells, float(uniform[1]))
    values = re.search(r"internalField\s+nonuniform[^(]*\(([^)]*)\)", text)[1]
    values = np.array(values.split(), float)
    assert len(values) == cells, f"{name} has {len(values)} values"
    return values


def read_set(folder, name):
    """Numbers of the faces or cells in a set that checkMesh made, if it did."""
    path = folder / "constant/polyMesh/sets" / name
    if not path.exists():
        return set()
    body = path.read_text().split("\n}\n", 1)[1]
    return set(map(int, re.search(r"\(([^)]*)\)", body)[1].split()))
