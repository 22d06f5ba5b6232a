"""Bodies that were cut at a side of the flow domain: all faces there belong to the side, whose area is right, though corners
are off by noise; no face is left without a boundary. At four turns and three sizes."""

import numpy as np
from paraview import simple

import scenes
from pipeline import Messages, error_code, output, polydata, producer

NOISE = 1e-6
TURNS = (0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1)


def wedge(beam):
    """A hull with a keel and a stem without width, 4 long and 0.5 deep: its section at y = 0 is 4 by 0.5, less a corner of
    0.5 by 0.5 at the bow."""
    outline = [(0, -0.5), (3.5, -0.5), (4, 0), (0, 0)]
    return [[x, 0, z] for x, z in outline] + [[0, beam, 0], [0, -beam, 0]], 1.875


def hull(random, part):
    """The whole hull, half of it with a lid, or half of it open; corners of the cut off by noise."""
    points, area = wedge(0.4)
    points = np.array(points, float)
    side = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    if part == "whole":
        triangles = side + [(b, a, 5) for a, b, _ in side]
    else:
        triangles = side + ([(0, 2, 1), (0, 3, 2)] if part == "lid" else [])
        points[:4, 1] = random.uniform(-NOISE, NOISE, 4)
        points[0, 1] = NOISE
    return points, [t[::-1] for t in triangles], area


def half_box(random, part):
    low, high = np.array([0, 0 if part != "whole" else -0.3, -0.5]), np.array([2, 0.3, 0])
    points, triangles = scenes.box(low, high)
    points = np.array(points, float)
    if part != "whole":
        at = points[:, 1] == 0
        points[at, 1] = random.uniform(-NOISE, NOISE, at.sum())
    if part == "open":
        triangles = [t for t in triangles if not at[list(t)].all()]
    return points, triangles, 1.0


def ellipsoid(random, part):
    points, triangles = scenes.round_body(12, 16, [1, 0.5, 0.4])
    points = np.array(points, float)
    mean = points[:, 1] > -1e-9
    if part != "whole":
        kept = [t for t in triangles if mean[list(t)].all()]
        rim = np.abs(points[:, 1]) < 1e-9
        ring = np.flatnonzero(rim)
        points[rim, 1] = random.uniform(-NOISE, NOISE, rim.sum())
        triangles = kept
        if part == "lid":
            order = ring[np.argsort(np.arctan2(points[ring, 2], points[ring, 0]))]
            triangles = kept + [(order[0], order[i + 1], order[i]) for i in range(1, len(order) - 1)]
    v = np.pi * (np.arange(13) / 12 - 0.5)
    x, z = np.cos(v), 0.4 * np.sin(v)
    return points, triangles, float(np.sum((x[1:] + x[:-1]) * np.diff(z)))


def areas(points, triangles, axes, scale, part):
    placed = np.zeros_like(points)
    placed[:, list(axes)] = points
    if axes == (0, 2, 1):
        triangles = [t[::-1] for t in triangles]
    low, high = {0: -1.5, 1: 0, 2: -1.2}, {0: 5.5, 1: 1.2, 2: 1.2}
    bounds = [0] * 6
    for axis, at in enumerate(axes):
        bounds[2 * at:2 * at + 2] = scale * low[axis], scale * high[axis]
    whole = {"Half": "Across " + "XYZ"[axes[1]], "LengthsBefore": 0.3, "LengthsBehind": 0.3, "LengthsBeside": 0.3}
    cut = {"BoxFrom": "Bounds", "DomainBounds": bounds}
    with Messages() as said:
        mesher = simple.CartesianMesher(Input=producer(polydata(placed * scale, triangles)), Domain="Outside",
            SideNames="Axes", FlowDirection="Plus " + "XYZ"[axes[0]], CellSize=0.5 * scale, RefinementDepth=2,
            **(whole if part == "whole" else cut))
        mesh = output(mesher)
    assert error_code(mesher) == 0, str(said)
    fields = mesh.GetFieldData()
    names = fields.GetAbstractArray("BoundaryNames")
    found = {names.GetValue(i): fields.GetArray("BoundaryAreas").GetValue(i) / scale ** 2
             for i in range(names.GetNumberOfValues())}
    bounds = np.array(mesh.GetBounds()).reshape(3, 2) / scale
    side = np.prod([np.ptp(bounds[axis]) for axis in range(3) if axis != axes[1]])
    simple.Delete(mesher)
    return found, side - found["xyz"[axes[1]] + "Min"], str(said)


random = np.random.default_rng(1)
for make, tolerance in (hull, 1e-5), (half_box, 1e-5), (ellipsoid, 4e-3):
    for part in "whole", "lid", "open":
        for axes in TURNS:
            for scale in 0.01, 1, 100:
                points, triangles, area = make(random, part)
                found, section, said = areas(points, triangles, axes, scale, part)
                print(make.__name__, part, axes, scale, "section", section, "of", area, flush=True)
                assert found.get("no_surface", 0) == 0, found
                assert abs(section / area - 1) < tolerance, (section, area)
