"""What holds for the mesh of every closed surface: it is a finite-volume mesh, its volume is the
surface's, and so are its areas, boundary by boundary. What is measured, and how: measure.py."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import measure
from pipeline import error_code, merged, octahedron, output, producer, read


def with_array(data, name, values):
    array = numpy_to_vtk(np.array(values), deep=True)
    array.SetName(name)
    data.GetCellData().AddArray(array)
    return data


def check(name, source, cells, boundary_array="", **properties):
    """Meshes with `cells` boxes along the longest side, measures, compares with the surface."""
    surface = output(source)
    bounds = surface.GetBounds()
    size = max(high - low for low, high in zip(bounds[0::2], bounds[1::2])) / cells
    mesher = simple.CartesianMesher(Input=source, CellSize=size, SmallCellRatio=1e-9,
        PatchMethod="Exact Fit", BoundaryArray=boundary_array, **properties)
    try:
        mesh = measure.Mesh(output(mesher), output(mesher, 1))
        measure.Surface(surface, boundary_array or "STLSolidLabeling").check(mesh.volume, mesh.areas)
        assert error_code(mesher) == 0, f"error code {error_code(mesher)}"
        if not properties:
            spread = np.abs(mesh.volumes / size**3 - mesh.fractions).max()
            assert spread < 1e-5, f"VolumeFraction is {spread} off"
    except AssertionError as error:
        raise AssertionError(f"{name}, {cells} cells along the longest side: {error}") from error
    print(f"{name}, {cells}: {mesh.cells} cells")
    simple.Delete(mesher)


round_shapes = {
    "sphere": simple.Sphere(ThetaResolution=40, PhiResolution=30),
    "coarse sphere": simple.Sphere(),
    "ring": simple.Superquadric(Toroidal=1, ThetaRoundness=0.3, PhiRoundness=0.3),
    "cone": simple.Cone(Resolution=7),
    "capped cylinder": simple.Clean(Input=simple.Cylinder(Resolution=24)),
}
for name, source in round_shapes.items():
    for cells in 3, 12, 25:
        check(name, source, cells)

# Faces on the planes between boxes, edges along edges or diagonals of boxes, corners on planes.
flat_shapes = {
    "box": simple.Box(),
    "box turned by 45 degrees": simple.Transform(Input=simple.Box(), Transform="Transform"),
    "octahedron": producer(octahedron()),
    "octahedra nested": producer(merged(octahedron(), octahedron(0.5), turned=[1])),
    "box with a cavity": producer(merged(output(simple.Box()),
        output(simple.Sphere(Radius=0.2)), turned=[1])),
    "octahedron inside out": producer(merged(octahedron(), turned=[0])),
    "octahedra that touch in a corner": producer(merged(octahedron(), octahedron(1, (2, 0, 0)))),
    "a million units away": producer(octahedron(1, (1e6, -1e6, 3e6))),
    "a millionth of a unit wide": producer(octahedron(1e-6)),
}
flat_shapes["box turned by 45 degrees"].Transform.Rotate = [0, 0, 45]
for name, source in flat_shapes.items():
    for cells in 1, 2, 3, 4, 15:
        check(name, source, cells)
half = np.linspace(-0.5, 0.5, 5)
check("box on its own meshlines", flat_shapes["box"], 4,
    MeshlinesX=half, MeshlinesY=half, MeshlinesZ=half)
check("box between uneven meshlines", flat_shapes["box"], 4,
    MeshlinesX=[-0.7, -0.5, -0.499, 0.1, 0.5], MeshlinesZ=[-2, 2])

sides = producer(with_array(output(simple.Box(YLength=2)), "Side", [7, 3, 3, 0, 9, 11]))
for cells in 1, 4, 15:
    check("box of five boundaries", sides, cells, "Side")

# A thousand triangles in a box, and a triangle a thousand times larger than a box.
check("fine sphere", simple.Sphere(ThetaResolution=100, PhiResolution=100), 2)
slab = simple.Box(XLength=1000, YLength=1, ZLength=1)
check("slab", slab, 1000)

for name in ("kcl_exhaust_header_lumens.stl", "tm_featuretype_occ.stl", "tm_7_8ths_cube.stl",
             "cino_spot.obj"):
    for cells in 12, 25:
        check(name, read(name), cells)

# Without its small cells it is a smaller mesh, and still one. No edit: one that makes a cell smaller afterwards is allowed.
for name, source in (round_shapes | {"spot": read("cino_spot.obj")}).items():
    volumes = []
    for ratio in 1e-9, 0.3:
        mesher = simple.CartesianMesher(Input=source, SmallCells="Remove", SmallCellRatio=ratio, CollapseRatio=0, OptimiseNodes=0,
            SplitConcaveCells=0, RefusedCellRatio=0)
        mesh = measure.Mesh(output(mesher), output(mesher, 1))
        volumes.append(mesh.volume)
        # Cells without a boundary face stay: they would leave a hole.
        faces = vtk_to_numpy(output(mesher).GetFieldData().GetArray("BoundaryOfFaces"))
        smallest = mesh.fractions[np.unique(faces[:, 0])].min()
        assert smallest >= ratio * (1 - 1e-6), f"{name}: a cell of {smallest} of its box"
    assert volumes[1] < volumes[0], f"{name}: volumes {volumes}"
