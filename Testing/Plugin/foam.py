"""OpenFOAM cases: saving a mesh as one, running programs in it, reading what they find."""

import os
import pathlib
import re
import subprocess

import numpy as np
from paraview import simple

import measure

MPIRUN = "mpirun", "--allow-run-as-root", "--oversubscribe"
CONFIGURATION = "/usr/share/openfoam"  # of Debian's package; the programs need nothing else

FIGURES = {
    "cells": r"^ +cells: +(\S+)",
    "non-orthogonality": r"non-orthogonality Max: (\S+)",
    "skewness": r"[Mm]ax skewness = ([^\s,]+)",
    "determinant": r"determinant.* (?:minimum|min)\w*: ([^\s,]+)",
    "weight": r"interpolation weight.* minimum: ([^\s,]+)",
    "volume ratio": r"[Ff]ace volume ratio.* minimum: ([^\s,]+)",
    "steep faces": r"severely non-orthogonal.*faces: (\d+)",
    "skew faces": r", (\d+) highly skew faces",
    "wrong faces": r"face pyramids: (\d+) faces",
    "concave cells": r"Concave cells.*: (\d+)",
    "smallest volume": r"[Mm]in(?:imum)? volume\S* = ([^\s,]+)",
}


def save(proxy, folder, **properties):
    """Writes the case; a mesh of an earlier case there is replaced."""
    case = pathlib.Path(folder) / "case.foam"
    case.unlink(missing_ok=True)
    simple.SaveData(str(case), proxy, **properties)
    assert case.exists(), f"{case} was not written, for the reason above"
    return case.parent


def run(folder, *command):
    """What the program prints; an error if it fails."""
    # Started by a program that is of MPI itself, mpirun refuses.
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    environment |= {"WM_PROJECT_DIR": CONFIGURATION, "PWD": str(folder)}
    done = subprocess.run(command, cwd=folder, env=environment, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, f"{' '.join(command)} failed:\n{done.stdout[-3000:]}"
    return done.stdout


def run_parallel(folder, ranks, *command):
    """The same in a decomposed case."""
    return run(folder, *MPIRUN, "-n", str(ranks), *command, "-parallel")


class CheckMesh:
    """checkMesh's verdict: `ok`, `failures` (its lines with three stars) and `figures` by name."""

    def __init__(self, folder, *options):
        self.text = run(folder, "checkMesh", *options)
        self.ok = "\nMesh OK." in self.text
        self.failures = re.findall(r"^ *\*\*\*(.*)$", self.text, re.MULTILINE)
        self.figures = {}
        for name, pattern in FIGURES.items():
            found = re.search(pattern, self.text, re.MULTILINE)
            if found:
                self.figures[name] = float(found[1].rstrip("."))


def refused(folder):
    """What checkMesh refuses in the meshes of a case, of several regions too; empty: nothing."""
    regions = sorted(mesh.parent.name for mesh in pathlib.Path(folder).glob("constant/*/polyMesh"))
    checked = [CheckMesh(folder, "-region", region) for region in regions] or [CheckMesh(folder)]
    return [failure for check in checked for failure in check.failures or ([] if check.ok else ["no verdict"])]


def dictionary(name, text, kind="dictionary"):
    """A file that OpenFOAM reads."""
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n{text}\n"


def write(folder, path, text, kind="dictionary"):
    path = pathlib.Path(folder) / path
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(dictionary(path.name, text, kind))


class Files:
    """constant/polyMesh, of the case or a region, ours or what OpenFOAM's programs write, read without the code
    that wrote it."""

    def __init__(self, folder, region=""):
        self.folder = pathlib.Path(folder) / "constant" / region / "polyMesh"
        self.points = self.lists("points", np.float64)[0].reshape(-1, 3)
        self.owner = self.lists("owner", np.int32)[0]
        self.neighbour = self.lists("neighbour", np.int32)[0]
        self.cells = max(self.owner.max(initial=-1), self.neighbour.max(initial=-1)) + 1
        start, corners = self.lists("faces", np.int32)
        self.faces = measure.Faces(corners, np.diff(start), self.owner)
        text = (self.folder / "boundary").read_text()
        self.patches = {}
        for name, entries in re.findall(r"(\S+)\s*\{([^{}]*nFaces[^{}]*)\}", text):
            numbers = [int(re.search(key + r"\s+(\d+);", entries)[1])
                       for key in ("startFace", "nFaces")]
            self.patches[name] = (re.search(r"type\s+(\w+);", entries)[1], *numbers)

    def lists(self, name, kind):
        data = (self.folder / name).read_bytes()
        header, _, body = data.partition(b"\n}\n")
        body = re.sub(rb"\A(\s*//[^\n]*\n)*\s*", b"", body)
        if b"binary" in header:
            return list(self.binary_lists(body, kind))
        body = re.sub(rb"\s*//[^\n]*\s*\Z", b"\n", body)
        same = re.fullmatch(rb"(\d+)\{(\S+)\}\s*", body)
        if same:
            return [np.full(int(same[1]), same[2]).astype(kind)]
        count, _, items = body.partition(b"(")
        if b"faceList" not in header:
            words = items.translate(bytes.maketrans(b"()", b"  ")).split()
            found = [np.array(words).astype(kind)]
        else:
            rows = re.findall(rb"(\d+)\s*\(([\d\s]*)\)", items)
            assert all(int(size) == len(row.split()) for size, row in rows)
            sizes = [int(size) for size, _ in rows]
            found = [np.concatenate([[0], np.cumsum(sizes)]).astype(int),
                     np.array(b" ".join(row for _, row in rows).split()).astype(kind)]
        items_found = len(found[0]) - 1 if len(found) == 2 else len(found[0])
        assert int(count) * (3 if name == "points" else 1) == items_found, name
        return found

    @staticmethod
    def binary_lists(body, kind):
        width = np.dtype(kind).itemsize * (3 if kind == np.float64 else 1)
        while body.strip():
            count, _, body = body.partition(b"\n")
            size = int(count) * width
            if size:
                assert body[:1] == b"(" and body[size + 1:size + 2] == b")"
                yield np.frombuffer(body[1:size + 1], kind)
                body = body[size + 2:]
            else:
                yield np.zeros(0, kind)
            body = body[1:]

    def check(self):
        """What OpenFOAM asks of the order of faces and cells; patches of no faces are a piece's only."""
        inner = len(self.neighbour)
        owner = self.owner[:inner]
        assert (owner < self.neighbour).all(), "an owner is above its neighbour"
        pairs = owner.astype(np.int64) * self.cells + self.neighbour
        assert (np.diff(pairs) >= 0).all(), "inner faces are not in upper triangular order"
        assert (self.folder / "faceProcAddressing").exists() or all(self.patches[name][2] for name in self.patches)
        next = inner
        for name, (kind, start, count) in self.patches.items():
            assert start == next, name
            # Two patches of the same faces have one order.
            paired = kind in ("mappedWall", "cyclic", "cyclicAMI", "processor")
            assert paired or (np.diff(self.owner[start:start + count]) >= 0).all(), name
            next += count
        assert next == len(self.owner)

    def faces_of_cells(self):
        """Of each cell, its faces as sets of points."""
        cells = [set() for _ in range(self.cells)]
        for i, owner in enumerate(self.owner):
            face = frozenset(self.faces.corners[self.faces.start[i]:self.faces.start[i + 1]].tolist())
            cells[owner].add(face)
            if i < len(self.neighbour):
                cells[self.neighbour[i]].add(face)
        return cells

    def volumes(self):
        """Of the cells, each about one of its points."""
        cells, inner = self.cells, len(self.neighbour)
        first = self.points[self.faces.corners[self.faces.start[:-1]]]
        origin = np.empty((cells, 3))
        origin[self.owner] = first
        origin[self.neighbour] = first[:inner]
        _, _, volume = self.faces.measure(self.points, origin)
        result = np.bincount(self.owner, volume, cells)
        turned = measure.Faces(self.faces.corners[:self.faces.start[inner]],
                               self.faces.size[:inner], self.neighbour)
        _, _, volume = turned.measure(self.points, origin)
        return result - np.bincount(self.neighbour, volume, cells)

    def areas(self):
        """Of the patches, by name."""
        _, area, _ = self.faces.measure(self.points, np.zeros((self.cells, 3)))
        return {name: area[start:start + count].sum()
                for name, (_, start, count) in self.patches.items()}

    def centres(self):
        """Of the cells, as OpenFOAM finds them: of the pyramids on their faces."""
        inner = len(self.neighbour)
        face_centres, vectors = self.face_centres()
        owner = np.concatenate([self.owner, self.neighbour])
        at = np.concatenate([face_centres, face_centres[:inner]])
        out = np.concatenate([vectors, -vectors[:inner]])

        def sums(values):
            return np.stack([np.bincount(owner, v, self.cells) for v in values.T], axis=1)

        guess = sums(at) / np.bincount(owner, minlength=self.cells)[:, None]
        pyramids = np.einsum("ij,ij->i", out, at - guess[owner])[:, None]
        return sums(pyramids * (0.75 * at + 0.25 * guess[owner])) / sums(pyramids)

    def face_centres(self):
        """Centres and area vectors of the faces: of the triangles around the corners' mean."""
        faces = self.faces
        p = self.points[faces.corners]
        q = self.points[faces.corners[faces.next]]
        middle = (faces.sums(p) / faces.size[:, None])[faces.face]
        triangles = np.cross(p - middle, q - middle) / 2
        vectors = faces.sums(triangles)
        sizes = np.linalg.norm(triangles, axis=1)[:, None]
        return faces.sums(sizes * (p + q + middle) / 3) / faces.sums(sizes), vectors

    def of_patch(self, name):
        _, start, count = self.patches[name]
        return slice(start, start + count)


def items(values):
    """A field's values as OpenFOAM reads them, scalars or vectors."""
    values = np.asarray(values)
    kind = "scalar" if values.ndim == 1 else "vector"
    rows = "\n".join(f"{v!r}" if values.ndim == 1 else "({!r} {!r} {!r})".format(*v)
                     for v in values.tolist())
    return f"nonuniform List<{kind}> {len(values)}\n(\n{rows}\n)"


def write_field(folder, name, dimensions, start, patches):
    """0/name: `start` everywhere, and for each patch the type of its condition and its entries."""
    conditions = "\n".join(f"{patch} {{ type {text} }}" for patch, text in patches.items())
    kind = "volVectorField" if start.startswith("(") else "volScalarField"
    write(folder, f"0/{name}", f"dimensions {dimensions};\ninternalField uniform {start};\n"
          f"boundaryField\n{{\n{conditions}\n}}", kind)


def control(folder, end, text=""):
    """system/controlDict: steps of 1 to `end`, which alone is written."""
    write(folder, "system/controlDict",
          f"startFrom startTime; startTime 0; stopAt endTime; endTime {end}; deltaT 1;\n"
          f"writeControl timeStep; writeInterval {end}; writeFormat ascii; writePrecision 12;\n{text}")


def read_field(folder, time, name):
    """The cells' values."""
    text = (pathlib.Path(folder) / str(time) / name).read_text()
    found = re.search(r"internalField\s+nonuniform List<(\w+)>\s*\d+\s*\(\s(.*?)\n\)", text, re.DOTALL)
    values = np.array(found[2].replace("(", " ").replace(")", " ").split(), float)
    return values.reshape(-1, 3) if found[1] == "vector" else values


def read_flows(folder, time):
    """Out of the mesh through each patch: the sum of the field phi over its faces."""
    text = (pathlib.Path(folder) / str(time) / "phi").read_text()
    found = re.findall(r"\n    (\S+)\n    \{[^{}]*?value\s+(\w+) ([^{};]*);",
                       text[text.index("boundaryField"):])
    flows = {}
    for patch, kind, values in found:
        numbers = values.partition("(")[2].rstrip(")\n ") if kind == "nonuniform" else values
        flows[patch] = np.array(numbers.split(), float).sum()
        assert kind == "nonuniform" or flows[patch] == 0, values
    return flows
