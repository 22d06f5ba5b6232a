"""A round vent in the floor of a room keeps its area in boxes of one to five of its radii, at four turns and three sizes."""

import numpy as np
from paraview import simple
from vtkmodules.vtkCommonCore import vtkStringArray

import scenes
from pipeline import Messages, output, polydata, producer

RADIUS, CORNERS = 0.05, 48
SIDES = np.array([1, 0.8, 0.6])


def room(by, scale):
    """Its floor is a ring around the vent; the area of the vent."""
    points, triangles = scenes.box([0, 0, 0], SIDES)
    triangles = [t for t in triangles if not all(points[i][2] == 0 for i in t)]
    middle = np.array([0.37, 0.41, 0])
    angles = np.arange(CORNERS) * 2 * np.pi / CORNERS
    rim = middle + RADIUS * np.stack([np.cos(angles), np.sin(angles), 0 * angles], 1)
    first = len(points)
    points = np.concatenate([points, rim, [middle]])
    corners = 3, 2, 0, 1  # of the floor, around it
    nearest = (4 * np.arange(CORNERS) // CORNERS).tolist()  # the corner that each edge sees
    names = ["wall"] * len(triangles)
    for i in range(CORNERS):
        k = (i + 1) % CORNERS
        triangles.append((first + k, first + i, first + CORNERS))
        names.append("vent")
        triangles.append((first + i, first + k, corners[nearest[i]]))
        names.append("wall")
        if nearest[i] != nearest[k]:
            triangles.append((first + k, corners[nearest[k]], corners[nearest[i]]))
            names.append("wall")
    data = polydata(scale * points @ by.T, triangles)
    array = vtkStringArray()
    array.SetName("Wall")
    for name in names:
        array.InsertNextValue(name)
    data.GetCellData().AddArray(array)
    return data, CORNERS * RADIUS ** 2 * np.sin(2 * np.pi / CORNERS) / 2


random = np.random.default_rng(3)
around_x = np.array([[1, 0, 0], [0, 0.5 ** 0.5, -0.5 ** 0.5], [0, 0.5 ** 0.5, 0.5 ** 0.5]])
worst = 0
for turn in np.eye(3), around_x, scenes.turn(random), scenes.turn(random):
    for scale in 0.01, 1, 100:
        surface, area = room(turn, scale)
        for boxes in 1, 1.7, 2.6, 3.5, 5:
            with Messages() as said:
                mesher = simple.CartesianMesher(Input=producer(surface), BoundaryArray="Wall",
                                                CellSize=boxes * RADIUS * scale)
                fields = output(mesher).GetFieldData()
            names = fields.GetAbstractArray("BoundaryNames")
            areas = {names.GetValue(i): fields.GetArray("BoundaryAreas").GetValue(i) / scale ** 2
                     for i in range(names.GetNumberOfValues())}
            error = areas["vent"] / area - 1
            worst = max(worst, abs(error))
            if abs(error) > 0.003:
                print(scale, boxes, turn.round(2).tolist(), areas, f"{error:.2%}", flush=True)
            assert abs(fields.GetArray("MeshVolume").GetValue(0) / scale ** 3 / SIDES.prod() - 1) < 1e-3, str(said)
            assert abs(error) < 0.01, (scale, boxes, turn, areas)
            simple.Delete(mesher)
print(f"{worst:.2%} off at most")
