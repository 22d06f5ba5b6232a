# SPDX-License-Identifier: BSD-3-Clause
"""DFG 3D-1Z: laminar flow around a cylinder across a square channel (Schaefer, Turek and others, 1996; the figures are
FEATFLOW's)."""

import numpy as np

import harness  # before what it finds
from laminar import OUTFLOW, STILL, Flow, given
from prisms import circle, prism

HEIGHT, LENGTH, DIAMETER, MIDDLE = 0.41, 2.5, 0.1, (0.5, 0.2)
FASTEST, VISCOSITY = 0.45, 1e-3
MEAN = 4 / 9 * FASTEST  # Reynolds number 20
DRAG, LIFT = 6.18533, 0.009401


CIRCLE = circle(DIAMETER / 2, 200, MIDDLE, equal_area=True)


def channel():
    corners = np.array([(0, 0), (LENGTH, 0), (LENGTH, HEIGHT), (0, HEIGHT)])
    return prism("channel", [(corners, ["sides", "outlet", "sides", "inlet"]), (CIRCLE[::-1], "cylinder")], 0, HEIGHT, ends="sides")


def body():
    """Longer than the channel is wide: it ends in its walls."""
    return prism("cylinder", [(CIRCLE, "cylinder")], -HEIGHT / 2, 1.5 * HEIGHT, ends="cylinder")


def measured(files, turn):
    centres = files.face_centres()[0][files.of_patch("inlet")]
    _, y, z = (centres @ turn).T
    speed = np.maximum(16 * FASTEST * y * z * (HEIGHT - y) * (HEIGHT - z) / HEIGHT ** 4, 0)
    along, up, _ = (f"({x!r} {y!r} {z!r})" for x, y, z in turn.T.tolist())
    body = next(name for name in files.patches if name not in ("inlet", "outlet", "sides"))
    flow = Flow(files, {body: STILL, "sides": STILL, "inlet": given(speed[:, None] * turn[:, 0]), "outlet": OUTFLOW},
        VISCOSITY, functions=f"""functions {{ forces {{ type forceCoeffs; libs (forces); patches ({body}); rho rhoInf; rhoInf 1;
        magUInf {MEAN}; lRef {DIAMETER}; Aref {DIAMETER * HEIGHT}; dragDir {along}; liftDir {up}; pitchAxis (0 0 1); CofR (0 0 0);
        writeControl timeStep; writeInterval 1; }} }}""")
    file = next((flow.folder / "postProcessing" / "forces" / "0").iterdir())
    last = file.read_text().splitlines()[-1].split()
    return {"drag": float(last[1]) / DRAG - 1, "lift": float(last[3]) - LIFT, "iterations": flow.iterations}


CASE = harness.Case("cylinder", "DFG 3D-1Z: a cylinder across a channel, Reynolds number 20",
    "A channel of 2.5 x 0.41 x 0.41 with a cylinder of diameter 0.1 across it; boxes at the cylinder are halved twice, with three "
    "transition layers; simpleFoam. Drag against 6.18533; lift minus 0.009401.",
    channel(), (HEIGHT / 16, HEIGHT / 24, HEIGHT / 36), measured, depth=2, fine=("cylinder",), between=(3, 3),
    domain=(body(), ((0.0, 0.0, 0.0), (LENGTH, HEIGHT, HEIGHT))))

if __name__ == "__main__":
    harness.run(CASE)
