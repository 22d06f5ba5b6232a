# SPDX-License-Identifier: BSD-3-Clause
"""What the written Allrun makes of thin layers: how far 300 iterations bring it, and y+ on the walls.

pvpython stackflow.py [CASE...] [--layers -1] [--first y1,1e-2] [--keep FOLDER] [--set PROPERTY=NUMBER...]

First heights are by the box at the wall; y1: from a Target Y Plus of 1. -1 layers: automatic."""

import argparse
import pathlib
import re
import tempfile

import harness  # noqa: F401 before what it finds
import numpy as np
from paraview import simple

import bodies
import foam
from stacks import RATIO, chosen_properties, walls_of
from wallmeasures import Mesh

ITERATIONS = 300
# Speed and kinematic viscosity, by the surface's unit of length, and that in metres.
FLOWS = {"section": (50, 1.5e-5, 1), "ahmed half": (40, 1.5e-5, 1), "hull": (2, 1e-6, 1), "truck": (20, 1.5e-5, 1),
         "duct": (30000, 15, 0.001), "wing": (50, 1.5e-5, 1), "blade": (60, 1.5e-5, 1), "propeller": (5, 1e-6, 1), "car": (30, 1.5e-5, 1), "tee": (5, 1.5e-5, 1)}
NEAR = 0.06  # of its first height, a whole stack
MOST = 3  # y+, times the target


def write(case, layers, first, folder, chosen):
    """The first height, by the surface's unit."""
    name, surface, size, local, _, named = case
    speed, viscosity, scale = FLOWS[name]
    path = folder / "surface.stl"
    surface.write(path)
    named = {key: value(surface.names) if callable(value) else value for key, value in named.items()}
    height = {"TargetYPlus": 1, "FlowSpeed": speed, "FlowViscosity": viscosity} if first == "y1" else {"FirstLayerThickness": float(first) * local}
    mesher = simple.CartesianMesher(Input=simple.NamedSTLReader(FileName=str(path)), CellSize=size, Layers=layers, LayerExpansionRatio=RATIO,
                                    **named | height | chosen)
    foam.save(mesher, folder, SolverSetup="Incompressible", Iterations=ITERATIONS, Scale=scale, Speed=speed * scale,
              Viscosity=viscosity * scale ** 2)


def settled(folder):
    """The drag, or the pressure at the inlet, and how much it has changed within the last sixth."""
    file = next(path for pattern in ("forceCoeffs", "pressure*") for path in (folder / "postProcessing").glob(f"{pattern}/0/*.dat"))
    values = [float(line.split()[1]) for line in file.read_text().splitlines() if not line.startswith("#")]
    last = np.array(values[-ITERATIONS // 6:])
    return values[-1], np.ptp(last) / abs(last.mean())


def y_plus(folder, case):
    """Area with whole stacks, the mean of y+ there, and the share of it within a third of 1; of the whole wall, the share with MOST or less."""
    mesh = Mesh(folder)
    files = foam.Files(folder)
    text = (folder / str(ITERATIONS) / "yPlus").read_text()
    text = text[text.index("boundaryField"):]
    walls, values = walls_of(mesh, case), []
    for name in (name for name in mesh.patches if set(np.r_[mesh.of_patch(name)]) <= set(walls)):
        found = re.search(rf"\n    {re.escape(name)}\n.*?List<scalar>\s*\d+\s*\(([^)]*)\)", text, re.DOTALL)
        values += found[1].split()
    values, areas = np.array(values, float), mesh.sizes[walls]
    heights = files.volumes()[files.owner[walls]] / areas
    weights = areas * (np.abs(heights / np.median(heights) - 1) < NEAR)
    return (weights.sum() / areas.sum(), np.average(values, weights=weights), np.average(np.abs(values - 1) < 1 / 3, weights=weights),
            np.average(values <= MOST, weights=areas))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cases", nargs="*")
    parser.add_argument("--layers", default="-1", type=int)
    parser.add_argument("--first", default="y1")
    parser.add_argument("--keep")
    parser.add_argument("--set", nargs="*", default=[])
    options = parser.parse_args()
    for case in bodies.cases():
        for first in options.first.split(",") if not options.cases or case[0] in options.cases else ():
            with tempfile.TemporaryDirectory() as scratch:
                folder = pathlib.Path(options.keep or scratch) / f"{case[0]}-{options.layers}-{first}".replace(" ", "-")
                folder.mkdir(parents=True, exist_ok=True)
                write(case, options.layers, first, folder, chosen_properties(options.set))
                foam.run(folder, "./Allrun")
                log = (folder / "log.simpleFoam").read_text()
                residuals = re.findall(r"Solving for p, Initial residual = ([^,]+)", log)
                value, change = settled(folder)
                area, mean, share, near = y_plus(folder, case)
                print(f"{case[0]:12} {options.layers:3} layers, first {first:>5}: {len(residuals)} iterations, residual of p {float(residuals[-1]):.1e}, "
                      f"value {value:.5g} within {100 * change:.2f} %, y+ {mean:.2f} on {100 * area:.1f} %, {100 * share:.0f} % within a third of 1; "
                      f"at most {MOST} on {100 * near:.1f} % of the wall",
                      flush=True)


if __name__ == "__main__":
    main()
