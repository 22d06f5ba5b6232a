# SPDX-License-Identifier: BSD-3-Clause
"""How good the cells at walls are, for solvers; beside snappyHexMesh's at equal boxes, where it is installed.

    pvpython wallcells.py cells SURFACE... [--size 1/40] [--depth 0]
    pvpython wallcells.py fidelity SURFACE... [--sizes 1/10,1/25,1/60] [--domains inside,outside] [--turns 4]
    pvpython wallcells.py solvers [SURFACE...] [--size 2] [--depth 1] [--iterations 500]
    pvpython wallcells.py timestep [SURFACE...] [--size 2] [--depth 1]
    pvpython wallcells.py layers SURFACE... [--size 1/40] [--depth 0] [--layers 5,1.2,0.05]
    pvpython wallcells.py pipe [--size 0.025] [--depth 0]

A SURFACE is a closed one: a file, or sphere, torus, tilted_pipe, bend, or runner_1 to runner_4 of the exhaust header
in Data. --size is the length of a box, or, as 1/40, its part of the surface's longest side. Both meshers run
on one thread; seconds are the processor's. In brackets are the defaults; --help after a command has more.

cells: of the cells, the smallest volume by that of the cell's box, and checkMesh's measures; of the boundary,
the errors of its volume and areas, the faces that lean from the nearest triangle (also: where the surface
turns by less than 30 degrees within two boxes), and the largest distances, over a box at the surface.
fidelity: of each surface turned, inside it and around it: the errors of its volume and of the areas of boundaries, the
largest distances, the part of sharp edges that the mesh has, too, and the faces that lean. The tests' named shapes:
build/release/bin/NamedShapes FOLDER writes them.
solvers: turbulent flow with plain second-order schemes; does it survive the mesh?
timestep: the explicit step at Courant number 0.9 for speed 1 along each axis, the shortest of all cells.
layers: the share of the walls' area that has all layers (--layers: their number, ratio, and the first one's
height by a box), each at least half as thick as asked; the same where the wall opposite is three boxes away.
pipe: the error of the wall's gradient, by the exact one, for conduction across a tilted pipe of diameter 1.
"""

import argparse
import ast
import pathlib
import sys
import tempfile

import numpy as np
from paraview import simple

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "Plugin")]
import foam  # noqa: E402
import wallflow  # noqa: E402
import walllayers  # noqa: E402
import wallmeasures  # noqa: E402
import wallmeshes  # noqa: E402
import wallsurfaces  # noqa: E402

MANY = 12  # boundaries
DUCTS = [*(f"runner_{i}" for i in range(1, 5)), "tilted_pipe", "bend"]
OPEN = "inlet", "outlet"  # boundaries without layers begin so
PIPE_RADIUS, PIPE_LENGTH, PIPE_FACETS = 0.5, 2.0, 180


def box_length(text, surface):
    """Of --size."""
    over, _, under = text.partition("/")
    if not under:
        return float(over)
    low, high = surface.bounds()
    return float(over) / float(under) * (high - low).max()


def each_mesh(surface, options, layers=None, outside=False):
    """The meshers' names, and what they made (an error instead, if they made nothing); in turn."""
    size = box_length(options.size, surface)
    for mesher in options.meshers:
        with tempfile.TemporaryDirectory() as temporary:
            folder = (options.keep or pathlib.Path(temporary)) / f"{surface.name}_{mesher.split()[0]}"
            try:
                made = wallmeshes.make(mesher, surface, size, options.depth, folder, options.set, layers, outside)
            except AssertionError as error:
                made = error
            yield mesher, made


def shown(value):
    if isinstance(value, (bool, np.bool_, str)):
        return value if isinstance(value, str) else "yes" if value else "NO"
    return f"{value}" if isinstance(value, (int, np.integer)) else f"{value:.4g}"


def print_rows(title, columns):
    """A figure a row, a mesher a column. `columns`: dictionaries of figures by mesher."""
    print(f"\n{title:40}" + "".join(f"{mesher:>18}" for mesher in columns))
    figures = dict.fromkeys(name for column in columns.values() for name in column)
    for name in figures:
        row = (shown(column.get(name, "-")) for column in columns.values())
        print(f"  {name:38}" + "".join(f"{text:>18}" for text in row), flush=True)


def print_lines(title, lines):
    """A mesh a line. `lines`: name, mesher, and figures."""
    figures = dict.fromkeys(name for line in lines for name in line[2])
    widths = [max(10, len(name), *(len(shown(line[2].get(name, "-"))) for line in lines)) + 2 for name in figures]
    wide = max(15, *(len(name) for name, _, _ in lines)) + 1
    print(f"\n{title:{wide}}{'mesher':>18}" + "".join(f"{n:>{w}}" for n, w in zip(figures, widths)))
    for name, mesher, found in lines:
        row = (f"{shown(found.get(figure, '-')):>{w}}" for figure, w in zip(figures, widths))
        print(f"{name:{wide}}{mesher:>18}" + "".join(row), flush=True)


def cell_figures(meshed, surface, box):
    found = {"cells": meshed.mesh.cells, "seconds": meshed.seconds,
             "cells a second": meshed.mesh.cells / max(meshed.seconds, 1e-9)}
    found |= wallmeasures.cells(meshed.mesh, meshed.boxes)
    found["time step"] = meshed.mesh.time_step().min()
    found |= wallmeasures.fidelity(meshed.mesh, surface, box)
    checked = foam.CheckMesh(meshed.folder, "-allGeometry")
    plain = foam.CheckMesh(meshed.folder)
    found["checkMesh"] = plain.ok
    found |= {"-allGeometry: " + failure.split(":")[0][:24]: int(failure.rpartition(":")[2])
              for failure in checked.failures if failure.rpartition(":")[2].strip().isdigit()}
    return found


def area_rows(errors):
    """Figures by mesher: how many boundaries are off, and by how much; of many, the worst of each mesher."""
    names = dict.fromkeys(name for found in errors.values() for name in found)
    if len(names) > MANY:
        worst = {name for found in errors.values()
                 for name in sorted(found, key=lambda name: -abs(found[name]))[:MANY // 2]}
        names = [name for name in names if name in worst]
    return {mesher: {"boundaries over 0.1 % off in area": sum(abs(error) > 1e-3 for error in found.values())} |
            {f"area error of {name}"[:38]: found[name] for name in names} for mesher, found in errors.items()}


def cells(options):
    for name in options.surfaces:
        surface, columns, errors = wallsurfaces.load(name), {}, {}
        box = box_length(options.size, surface) / 2 ** options.depth
        for mesher, meshed in each_mesh(surface, options):
            if isinstance(meshed, Exception):
                columns[mesher] = {"cells": "FAILED"}
                print(f"{mesher}: {meshed}", file=sys.stderr)
            else:
                columns[mesher] = cell_figures(meshed, surface, box)
                errors[mesher] = wallmeasures.area_errors(meshed.mesh, surface)
        rows = area_rows(errors)
        print_rows(f"{surface.name}, {options.size}, depth {options.depth}",
                   {mesher: column | rows.get(mesher, {}) for mesher, column in columns.items()})


def fidelity(options):
    for name in options.surfaces:
        whole, lines = wallsurfaces.load(name), []
        for domain in options.domains:
            for options.size in options.sizes:
                for turn in list(wallsurfaces.TURNS)[:options.turns]:
                    surface = whole.turned(wallsurfaces.TURNS[turn])
                    for mesher, meshed in each_mesh(surface, options, outside=domain == "outside"):
                        lines.append((f"{domain} {options.size} {turn}", mesher,
                                      fidelity_figures(meshed, surface, options, domain == "outside")))
        print_lines(whole.name, lines)


def fidelity_figures(meshed, surface, options, outside):
    if isinstance(meshed, Exception):
        return {"cells": "FAILED"}
    box = box_length(options.size, surface) / 2 ** options.depth
    found = wallmeasures.fidelity(meshed.mesh, surface, box, outside)
    errors = wallmeasures.area_errors(meshed.mesh, surface)
    worst = max(errors, key=lambda name: abs(errors[name]))
    return {"cells": meshed.mesh.cells, "volume": found["volume error"],
            "areas off": f"{sum(abs(error) > 1e-3 for error in errors.values())}/{len(errors)}",
            "worst area": errors[worst], "boundary off": found["boundary from surface (boxes)"],
            "rms": found["... rms"], "surface off": found["surface from boundary (boxes)"],
            "edges kept": found["sharp edges kept"], "leaning": found["faces leaning over 45 degrees"],
            "of boundary": worst}


def solvers(options):
    for name in options.surfaces or DUCTS:
        surface, lines = wallsurfaces.load(name), []
        inlet, outlet = (given or next(solid for solid in surface.names if solid.startswith(end))
                         for given, end in ((options.inlet, "inlet"), (options.outlet, "outlet")))
        duct = wallflow.Duct(surface, inlet, outlet, options.velocity, options.speed, options.iterations,
                             options.limit, options.model)
        for mesher, meshed in each_mesh(surface, options):
            found = {"OK": False}
            if not isinstance(meshed, Exception):
                found = {"cells": meshed.mesh.cells, "time step": meshed.mesh.time_step().min()}
                found |= wallflow.flow(meshed.folder, duct)
            lines.append((surface.name, mesher, found))
        print_lines("flow", lines)


def layers(options):
    lines = []
    for name in options.surfaces:
        surface = wallsurfaces.load(name)
        box = box_length(options.size, surface) / 2 ** options.depth
        count, ratio, first = (float(text) for text in options.layers.split(","))
        asked = first * box * ratio ** np.arange(int(count))
        for mesher, meshed in each_mesh(surface, options, (int(count), ratio, first * box)):
            found = {"cells": "FAILED"}
            if not isinstance(meshed, Exception):
                mesh = meshed.mesh
                found = {"cells": mesh.cells, "seconds": meshed.seconds}
                walls = [np.arange(len(mesh.owner))[mesh.of_patch(name)] for name in mesh.patches
                         if not name.startswith(OPEN)]
                found |= walllayers.coverage(mesh, surface, asked, box, np.concatenate(walls))
                found |= {"non-orthogonality": mesh.non_orthogonality().max(initial=0),
                          "skewness": mesh.skewness().max(), "checkMesh": foam.CheckMesh(meshed.folder).ok}
            lines.append((surface.name, mesher, found))
    print_lines("layers", lines)


def timestep(options):
    lines = []
    for name in options.surfaces or DUCTS:
        surface, steps = wallsurfaces.load(name), []
        for mesher, meshed in each_mesh(surface, options):
            if isinstance(meshed, Exception):
                lines.append((surface.name, mesher, {"x": "FAILED"}))
                continue
            steps.append(meshed.mesh.time_step())
            figures = dict(zip("xyz", steps[-1]))
            if len(steps) == 2:  # the first is ours
                lines[-1][2]["over snappyHexMesh's"] = (steps[0] / steps[1]).min()
            lines.append((surface.name, mesher, figures))
    print_lines("time step", lines)


def pipe(options):
    surface = wallsurfaces.tilted_pipe(PIPE_RADIUS, PIPE_LENGTH, PIPE_FACETS, level=False)
    lines = []
    for mesher, meshed in each_mesh(surface, options):
        if isinstance(meshed, Exception):
            raise meshed
        found = {"cells": meshed.mesh.cells} | wallflow.wall_gradient(meshed, PIPE_RADIUS)
        lines.append((surface.name, mesher, found))
    print_lines("wall's gradient", lines)


def properties(texts):
    """Of --set."""
    found = {}
    for text in texts:
        name, _, value = text.partition("=")
        try:
            found[name] = ast.literal_eval(value)
        except (SyntaxError, ValueError):
            found[name] = value  # an enumeration's name
    return found


def arguments(texts):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    for command, size, depth in (("cells", "1/40", 0), ("fidelity", None, 0), ("solvers", "2", 1), ("timestep", "2", 1),
                                 ("layers", "1/40", 0), ("pipe", "0.025", 0)):
        one = commands.add_parser(command)
        if command != "fidelity":
            one.add_argument("--size", default=size, help="length of a box, or its part of the longest side")
        one.add_argument("--depth", type=int, default=depth, help="halvings along the surface")
        one.add_argument("--set", action="append", default=[], metavar="Name=Value",
                         help="any other property of Cartesian Mesher")
        one.add_argument("--keep", type=pathlib.Path, help="a folder for the cases")
        one.add_argument("--meshers", type=lambda text: [wallmeshes.MESHERS[int(i)] for i in text.split(",")],
                         default=wallmeshes.MESHERS, help="0: ours alone; 1: snappyHexMesh alone")
        if command != "pipe":
            one.add_argument("surfaces", nargs="+" if command in ("cells", "fidelity", "layers") else "*", metavar="SURFACE")
        if command == "fidelity":
            one.add_argument("--sizes", type=lambda text: text.split(","), default=["1/10", "1/25", "1/60"])
            one.add_argument("--domains", type=lambda text: text.split(","), default=["inside", "outside"])
            one.add_argument("--turns", type=int, default=len(wallsurfaces.TURNS), help="the first of them")
        if command == "layers":
            one.add_argument("--layers", default="5,1.2,0.05", help="their number, ratio, and first height by a box")
        if command == "solvers":
            one.add_argument("--inlet", help="a boundary (default: the first whose name begins so)")
            one.add_argument("--outlet", help="likewise; all others are walls")
            one.add_argument("--velocity", type=float, nargs=3,
                             help="at the inlet (default: straight in, or along the pipe)")
            one.add_argument("--speed", type=float, default=20.0, help="without --velocity")
            one.add_argument("--iterations", type=int, default=500)
            one.add_argument("--model", choices=("kEpsilon", "kOmegaSST"), default="kEpsilon")
            one.add_argument("--limit", type=float, default=3.0, help="of speeds, by the inlet's")
    options = parser.parse_args(texts)
    if not hasattr(simple, "CartesianMesher"):
        parser.error("set PV_PLUGIN_PATH to the folder of the plugin")
    options.set = properties(options.set)
    return options


def run(texts):
    """As from the command line."""
    options = arguments(texts)
    globals()[options.command](options)


if __name__ == "__main__":
    run(sys.argv[1:])
