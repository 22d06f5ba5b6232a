"""ParaView's Clip and Slice of a mesh err by no more than the polyhedra in the plane, of which VTK leaves out those that
"cannot be contoured": two halves add up to the whole, and a slice has the area that the boundary encloses in its plane, but for
what these polyhedra hold. A cube's are right. Neither holds where polyhedra come before hexahedra."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_POLYHEDRON

from measure import faces_of_cells, faces_of_polydata, points_of
from pipeline import Messages, octahedron, output, producer, read
from polyhedra import cell_types

SINGLE_PRECISION = 1e-6  # Clip's points are floats


def integral(proxy, name):
    array = output(simple.IntegrateVariables(Input=proxy)).GetCellData().GetArray(name)
    return array.GetValue(0) if array else 0


def enclosed(loops, normal):
    """The area that faces around a volume enclose in a plane through 0, from triangles around the middle of each."""
    area = 0
    for loop in loops:
        above = loop @ normal > 0
        if above.all() or not above.any():
            continue
        for triangle in zip(loop, np.roll(loop, -1, axis=0), [loop.mean(axis=0)] * len(loop)):
            ends = {}
            for a, b in zip(triangle, triangle[1:] + triangle[:1]):
                h, k = a @ normal, b @ normal
                if (h > 0) != (k > 0):
                    ends[h > 0] = a + h / (h - k) * (b - a)
            if ends:
                area += np.cross(ends[True], ends[False]) @ normal / 2
    return abs(area)


def loops_of(boundary, origin):
    faces = faces_of_polydata(boundary, np.zeros(boundary.GetNumberOfPolys(), int))
    return np.split((points_of(boundary) - origin)[faces.corners], faces.start[1:-1])


def in_plane(mesh, types, origin, normal):
    """Of the hexahedra and polyhedra that the plane passes through: {type: volume, area in the plane}."""
    points = points_of(mesh) - origin
    faces = faces_of_cells(mesh)
    owner = faces.owner[faces.face]
    corners, above = np.bincount(owner), np.bincount(owner, points[faces.corners] @ normal > 0)
    _, _, volumes = faces.measure(points, np.zeros((len(types), 3)))
    volumes = np.bincount(faces.owner, volumes)
    crossed = {}
    for kind in VTK_HEXAHEDRON, VTK_POLYHEDRON:
        chosen = (types == kind) & (above > 0) & (above < corners)
        those = faces.select(chosen[faces.owner])
        crossed[kind] = volumes[chosen].sum(), enclosed(np.split(points[those.corners], those.start[1:-1]), normal)
    return crossed


def area_of_type(slice, mesh, types, kind):
    """Of the polygons of a slice that say to be of cells of a type."""
    ids = vtk_to_numpy(mesh.GetCellData().GetArray("CellId"))[types == kind]
    _, areas, _ = faces_of_polydata(slice, np.zeros(slice.GetNumberOfPolys(), int)).measure(points_of(slice), np.zeros((1, 3)))
    return areas[np.isin(vtk_to_numpy(slice.GetCellData().GetArray("CellId")), ids)].sum()


def check(name, source, method, **properties):
    mesher = simple.CartesianMesher(Input=source, PatchMethod=method, **properties)
    mesh, boundary = output(mesher), output(mesher, 1)
    types = cell_types(mesh)
    assert len(set(types)) == 2 and (np.diff(types) >= 0).all(), "hexahedra are not first"
    low, high = np.reshape(mesh.GetBounds(), (3, 2)).T
    whole = integral(mesher, "Volume")
    assert whole > 0, name
    for normal, at in ((1, 0, 0), 0.41), ((0, 0, 1), 0.53), ((0.48, 0.6, 0.64), 0.48):
        origin = low + at * (high - low)
        halves = 0
        with Messages():
            for side in 0, 1:
                clip = simple.Clip(Input=mesher, ClipType="Plane", Invert=side)
                clip.ClipType.Origin, clip.ClipType.Normal = origin.tolist(), normal
                halves += integral(clip, "Volume")
            slice = simple.Slice(Input=mesher, SliceType="Plane", Triangulatetheslice=0)
            slice.SliceType.Origin, slice.SliceType.Normal = origin.tolist(), normal
            area = integral(slice, "Area")
        expected = enclosed(loops_of(boundary, origin), np.array(normal))
        crossed = in_plane(mesh, types, origin, np.array(normal))
        volume, most = crossed[VTK_POLYHEDRON] if name != "cube" else (0, 0)
        lost, missing = abs(halves - whole), abs(area - expected)
        where = f"{name}, {method}, {normal}"
        print(f"{where}: volume {lost:.1e} off of {volume:.1e}, area {missing:.1e} of {most:.1e}")
        assert lost <= volume + SINGLE_PRECISION * whole, f"{where}: halves of {halves}, whole {whole}"
        assert missing <= most + SINGLE_PRECISION * expected, f"{where}: {area}, not {expected}"
        of_hexahedra = area_of_type(output(slice), mesh, types, VTK_HEXAHEDRON)
        assert abs(of_hexahedra - crossed[VTK_HEXAHEDRON][1]) <= SINGLE_PRECISION * expected, \
            f"{where}: {of_hexahedra} in hexahedra, not {crossed[VTK_HEXAHEDRON][1]}"


cube = read("tm_7_8ths_cube.stl")
for method in "Automatic", "Exact Fit":
    check("octahedron", producer(octahedron()), method, CellSize=0.13)
    check("cylinder", simple.Triangulate(Input=simple.Cylinder(Resolution=24)), method, CellSize=0.09)
    check("sphere", simple.Sphere(ThetaResolution=24, PhiResolution=24), method, CellSize=0.08)
    check("refined sphere", simple.Sphere(ThetaResolution=24, PhiResolution=24), method, CellSize=0.12,
        RefinementDepth=1)
    check("spot", read("cino_spot.obj"), method, CellSize=0.08)
    check("cube", cube, method, CellSize=np.ptp(points_of(output(cube)), axis=0).max() / 12)
