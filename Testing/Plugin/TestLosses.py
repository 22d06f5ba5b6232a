"""A mesh that holds over 1 % less than its surface encloses says so, by region and with places; also one with faces of no
boundary. Nothing is said where only a part is to be meshed."""

import re

import numpy as np
from paraview import simple

import scenes
from pipeline import Messages, error_code, output, polydata, producer


def told(data, **properties):
    with Messages() as said:
        mesher = simple.CartesianMesher(Input=data, **properties)
        mesh = output(mesher)
    assert error_code(mesher) == 0, str(said)
    return mesh, str(said)


def field(mesh, name):
    array = mesh.GetFieldData().GetArray(name)
    return np.array([array.GetValue(i) for i in range(array.GetNumberOfValues())])


# A ball of about two boxes in a block: each place is told, and what it lacks is what the region lacks.
parts = scenes.Parts()
parts.add(scenes.round_body(8, 12, [0.5, 0.5, 0.5]), "ball", "ball", at=(0.1, 0.05, 0.02))
parts.add(scenes.box([-1, -1, -1], [1, 1, 1]), "block", "block")
points, triangles = scenes.round_body(8, 12, [0.5, 0.5, 0.5])
ball = sum(np.dot(points[a], np.cross(points[b], points[c])) for a, b, c in triangles) / 6
for scale in 0.01, 1, 100:
    mesh, said = told(producer(parts.data(scale)), BoundaryArray="Wall", RegionsFrom="Array", RegionArray="Part",
                      CellSize=0.7 * scale)
    volumes = field(mesh, "RegionVolumes") / scale ** 3
    share = 100 * (1 - volumes[0] / ball)
    assert abs(share) > 1, volumes
    found = re.search(r"Region ball holds (\S+) % (less|more) than the surface encloses", said)
    assert found and abs(float(found[1]) - abs(share)) < 0.02, (share, said)
    places = [float(number) * (1 if kind == "less" else -1) / scale ** 3
              for number, kind in re.findall(r"\n  (\S+) (less|more) from \(", said)]
    assert places and min(abs(p) for p in places) > 1e-4, said

# Thin bodies: told if more than 1 % is missing or too much, and where, however evenly.
random = np.random.default_rng(1)
over = 0
for thickness in 0.3, 0.6, 0.9, 1.2:  # in boxes
    half = 0.04 * thickness
    points, triangles = scenes.round_body(8, 14, [0.5, 0.45, 0.4])
    inner, _ = scenes.round_body(8, 14, [0.5 - 2 * half, 0.45 - 2 * half, 0.4 - 2 * half])
    shell = points + inner, triangles + [tuple(len(points) + i for i in t[::-1]) for t in triangles]
    for body in shell, scenes.box([-0.5, -0.4, -half], [0.5, 0.4, half]), scenes.prism(5, 0.5, 2 * half, 0.7):
        for method in "Automatic", "Marching Cubes":
            mesh, said = told(producer(polydata(np.array(body[0]) @ scenes.turn(random).T, body[1])), CellSize=0.08,
                              PatchMethod=method)
            share = 100 * (1 - field(mesh, "MeshVolume")[0] / field(mesh, "SurfaceVolume")[0])
            found = re.search(r"The mesh holds (\S+) % (less|more) than .*there:\n  \S+ (less|more) from \(", said)
            assert bool(found) == (abs(share) > 1), (thickness, method, share, said)
            if found:
                over += 1
                assert abs(float(found[1]) - abs(share)) < 0.02 and (found[2] == "less") == (share > 0), (share, said)
assert over >= 8, over

# As the surface is: nothing to say, however it is cut off.
sphere = simple.Sphere(ThetaResolution=24, PhiResolution=16)
around = {"Domain": "Outside", "CellSize": 0.5, "RefinementDepth": 2}
for properties in (
        {"CellSize": 0.1}, {"CellSize": 0.1, "Layers": 2}, {"CellSize": 0.1, "PatchMethod": "Exact Fit"}, around,
        {**around, "Half": "Across X"}, {**around, "Ground": "zMin"}, {"CellSize": 0.1, "MeshlinesX": [-0.2, 0, 0.2, 0.3]},
        {**around, "BoxFrom": "Bounds", "DomainBounds": [-0.2, 1, -1, 1, -0.3, 1]}):
    mesh, said = told(sphere, **properties)
    assert "encloses" not in said, (properties, said)
two = scenes.Parts()
two.add(scenes.box([0, 0, 0], [1, 1, 1]), "one")
two.add(scenes.box([2, 0, 0], [3, 1, 1]), "other")
mesh, said = told(producer(two.data(1)), CellSize=0.21, KeepPoints=[0.5, 0.5, 0.5])
assert abs(field(mesh, "MeshVolume")[0] - 1) < 1e-3, field(mesh, "MeshVolume")
assert "encloses" not in said, said

# A hole wider than a box: its lid belongs to no boundary.
points, triangles = scenes.box([0, 0, 0], [1, 1, 1])
mesh, said = told(producer(polydata(points, triangles[2:])), CellSize=0.2)
found = re.search(r"Faces with an area of (\S+) belong to no boundary: they are no_surface", said)
assert found and abs(float(found[1]) - 1) < 1e-3, said
