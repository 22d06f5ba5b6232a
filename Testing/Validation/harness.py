# SPDX-License-Identifier: BSD-3-Clause
"""What all cases share: meshes by each mesher at each size, results that stay from run to run.

A case is a script: pvpython CASE.py RESULTS [--quick]. What it has measured is in RESULTS/CASE.json; started again, it
measures what is missing there. --quick: the coarser sizes alone, as the geometry is."""

import argparse
import json
import pathlib
import resource
import sys
import tempfile

import numpy as np

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / folder) for folder in ("Benchmark", "Plugin")]
import foam  # noqa: E402
from wallmeshes import MESHERS, OURS, make  # noqa: E402

AS_IT_IS = "as it is"
# About z, and then by the same angle about x: no wall stays along the grid.
TURNS = {"turned by 17": 17, "turned by 45": 45}
MOVED = "moved by a third of a box"
LAYERED = "with layers"
LAYERS = 3, 1.3, 0.15  # how many, each by the one below it, and the first by the box at the wall


class Case:
    """`sizes`: of boxes, from coarse to fine. `measured(files, turn)` gives {figure: value} of a mesh of the surface turned by
    `turn`, a matrix. `kind`, of the figures: errors, which should be 0; values, which have a limit; or costs. `layers`: whether
    there are meshes with layers, too. `domain`: a body and the box around it, (low, high), that are meshed where nothing is
    turned or moved: there snappyHexMesh's background would be that box, too. `mesh`: what wallmeshes.make takes besides; what
    stands on ground is not turned."""

    def __init__(self, name, title, text, surface, sizes, measured, layers=True, kind="errors", domain=None, **mesh):
        self.name, self.title, self.text, self.surface, self.sizes, self.measured = name, title, text, surface, sizes, measured
        self.layers, self.kind, self.domain, self.mesh = layers, kind, domain, {"depth": 0} | mesh

    def jobs(self, quick):
        """What is wanted most comes first."""
        sizes = self.sizes[:-1] if quick else self.sizes
        yield from ((mesher, size, AS_IT_IS) for size in sizes for mesher in MESHERS)
        if self.layers and not quick:
            yield from ((mesher, size, LAYERED) for size in sizes for mesher in MESHERS)
        if not quick and "ground" not in self.mesh:
            middle = self.sizes[(len(self.sizes) - 1) // 2]
            yield from ((mesher, middle, variant) for variant in TURNS for mesher in MESHERS)
            yield OURS, middle, MOVED

    def row(self, mesher, size, variant):
        turn = rotation(TURNS.get(variant, 0))
        surface, domain = turned(self.surface, turn), {}
        if self.domain and variant in (AS_IT_IS, LAYERED):
            surface, domain = self.domain[0], {"outside": self.domain[1], "fine": ()}
        began = seconds_used()
        with tempfile.TemporaryDirectory() as folder:
            meshed = make(mesher, surface, size, folder=folder, properties=grid_moved(surface, size) if variant == MOVED else None,
                          layers=self.layers_at(size) if variant == LAYERED else None, **self.mesh | domain)
            files = foam.Files(folder)
            figures = tried(lambda: self.measured(files, turn))
            return {"mesher": mesher, "size": size, "variant": variant, "cells": int(files.cells), "figures": figures,
                    "seconds of the mesh": round(meshed.seconds, 2), "seconds": round(seconds_used() - began, 2)}

    def layers_at(self, size):
        count, ratio, first = LAYERS
        return count, ratio, first * size / 2 ** self.mesh["depth"]


def tried(measured):
    """The figures, or which program has died: such a mesh stays in the table."""
    try:
        return measured()
    except (AssertionError, OSError) as error:
        return {"failed": str(error).strip().partition("\n")[0].rstrip(":")}


def seconds_used():
    """Of CPU, by this program and those that it has run."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(of.ru_utime + of.ru_stime for of in used)


def rotation(degrees):
    angle = np.radians(degrees)
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]]) @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def turned(surface, turn):
    return type(surface)(surface.name, surface.corners @ turn.T, surface.solids, surface.names)


def grid_moved(surface, size):
    """Meshlines that begin a third of a box below the surface."""
    low, high = surface.bounds()
    return {f"Meshlines{axis}": (low[i] - size / 3 + size * np.arange(int((high[i] - low[i]) / size) + 3)).tolist()
            for i, axis in enumerate("XYZ")}


def run(case):
    parser = argparse.ArgumentParser()
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    options.results.mkdir(parents=True, exist_ok=True)
    path = options.results / f"{case.name}.json"
    known = json.loads(path.read_text())["rows"] if path.exists() else []
    done = {(row["mesher"], row["size"], row["variant"]) for row in known}
    for job in case.jobs(options.quick):
        if job in done:
            continue
        known.append(case.row(*job))
        print(f"{case.name}: {', '.join(map(str, job))}: {known[-1]['cells']} cells, {known[-1]['figures']}", flush=True)
        path.write_text(json.dumps({"title": case.title, "text": case.text, "kind": case.kind, "rows": known}, indent=1) + "\n")
    return known


def order(rows, figure, mesher=OURS):
    """How fast it falls with the size of boxes, between the coarsest and the finest as the geometry is."""
    of = sorted((row["size"], abs(row["figures"][figure])) for row in rows
                if row["mesher"] == mesher and row["variant"] == AS_IT_IS and figure in row["figures"])
    return np.log(of[-1][1] / of[0][1]) / np.log(of[-1][0] / of[0][0]) if len(of) > 1 else float("nan")
