# SPDX-License-Identifier: BSD-3-Clause
"""The motorbike and its rider, of OpenFOAM's tutorial: its flow, its domain, its zone of smaller cells."""

import gzip
import pathlib
import tempfile

from paraview import simple

import harness  # before what it finds
from external import forces
from laminar import FIXED
from wallsurfaces import from_proxy

FILE = "/usr/share/doc/openfoam-examples/examples/resources/geometry/motorBike.obj.gz"
SPEED, ITERATIONS = 20.0, 300


def bike():
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "motorBike.obj")
        path.write_bytes(gzip.open(FILE).read())
        return from_proxy("motorbike", simple.NamedOBJReader(FileName=str(path)))


def measured(files, _):
    mean, deviation = forces(files, SPEED, 0.24, 1.78, FIXED.format(f"uniform ({SPEED} 0 0)"), ITERATIONS)
    return {"drag": float(mean[0]), "lift": float(mean[2]), "deviation of drag": float(deviation[0])}


CASE = harness.Case("motorbike", "A motorbike and its rider",
    "OpenFOAM's tutorial motorBike, 20 m/s: boxes of one metre, halved five times at the surface, four times in the tutorial's zone; "
    f"kOmegaSST; no reference except the other mesher. Forces in N for a density of 1 kg/m3, mean of the last quarter of {ITERATIONS} "
    "iterations.",
    bike(), (4 / 3, 1.0), measured, layers=False, kind="values", depth=5, between=(3, 3), ground=True, outside=((-5.0, -4.0, 0.0), (15.0, 4.0, 8.0)),
    zone=((-1.0, -0.7, 0.0), (8.0, 0.7, 2.5), 4))

if __name__ == "__main__":
    harness.run(CASE)
