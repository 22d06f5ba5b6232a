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


class Case:
    """`sizes`: of boxes, from coarse to fine. `measured(files, turn)` gives {figure: value}, errors that should be 0, of a mesh of
    the surface turned by `turn`, a matrix. `depth`: of refinement at the surface; `outside`: as wallmeshes.make has it, and
    then nothing is turned."""

    def __init__(self, name, title, text, surface, sizes, measured, **mesh):
        self.name, self.title, self.text, self.surface, self.sizes, self.measured = name, title, text, surface, sizes, measured
        self.depth, self.outside = mesh.get("depth", 0), mesh.get("outside", False)

    def jobs(self, quick):
        for mesher in MESHERS:
            for size in self.sizes[:-1] if quick else self.sizes:
                yield mesher, size, AS_IT_IS
            if not quick and not self.outside:
                for variant in *TURNS, *([MOVED] if mesher == OURS else []):
                    yield mesher, self.sizes[len(self.sizes) // 2], variant

    def row(self, mesher, size, variant):
        turn = rotation(TURNS.get(variant, 0))
        surface = turned(self.surface, turn)
        began = seconds_used()
        with tempfile.TemporaryDirectory() as folder:
            meshed = make(mesher, surface, size, self.depth, folder, grid_moved(surface, size) if variant == MOVED else None,
                          outside=self.outside)
            files = foam.Files(folder)
            figures = self.measured(files, turn)
            return {"mesher": mesher, "size": size, "variant": variant, "cells": int(files.cells), "figures": figures,
                    "seconds of the mesh": round(meshed.seconds, 2), "seconds": round(seconds_used() - began, 2)}


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
        path.write_text(json.dumps({"title": case.title, "text": case.text, "rows": known}, indent=1) + "\n")
    return known


def order(rows, figure, mesher=OURS):
    """How fast it falls with the size of boxes, between the coarsest and the finest as the geometry is."""
    of = sorted((row["size"], abs(row["figures"][figure])) for row in rows
                if row["mesher"] == mesher and row["variant"] == AS_IT_IS)
    return np.log(of[-1][1] / of[0][1]) / np.log(of[-1][0] / of[0][0]) if len(of) > 1 else float("nan")
