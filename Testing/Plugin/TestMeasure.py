"""Measuring finds what is wrong: each damage to a good mesh is seen."""

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import measure
from pipeline import octahedron, output, producer
from polyhedra import face_streams, set_face_streams

source = producer(octahedron())
mesher = simple.CartesianMesher(Input=source, CellSize=0.3, PatchMethod="Exact Fit")
surface = measure.Surface(output(source))


def cell_array(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def nothing(mesh, boundary):
    pass


def add_a_point(mesh, boundary):
    mesh.GetPoints().InsertNextPoint(9, 9, 9)


def let_points_coincide(mesh, boundary):
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    points[0] = points[1]


def move_a_point(mesh, boundary):
    middle = boundary.GetNumberOfPoints() // 2
    mesh_point = boundary.GetPointData().GetArray("MeshPointId").GetValue(middle)
    vtk_to_numpy(mesh.GetPoints().GetData())[mesh_point, 0] += 1e-6
    vtk_to_numpy(boundary.GetPoints().GetData())[middle, 0] += 1e-6


def turn_a_face(mesh, boundary):
    stream, starts = face_streams(mesh)
    stream[2 : 2 + stream[1]] = stream[2 : 2 + stream[1]][::-1].copy()
    set_face_streams(mesh, stream, starts)


def swap_corners_of_a_face(mesh, boundary):
    stream, starts = face_streams(mesh)
    stream[2:4] = stream[3:1:-1].copy()
    set_face_streams(mesh, stream, starts)


def turn_a_hexahedron(mesh, boundary):
    cell = next(i for i in range(mesh.GetNumberOfCells()) if mesh.GetCellType(i) == 12)
    first = vtk_to_numpy(mesh.GetCells().GetOffsetsArray())[cell]
    corners = vtk_to_numpy(mesh.GetCells().GetConnectivityArray())[first : first + 8]
    corners[:] = corners[[4, 5, 6, 7, 0, 1, 2, 3]]


def repeat_a_cell(mesh, boundary):
    stream, starts = face_streams(mesh)
    starts[-1] = starts[-2]
    set_face_streams(mesh, stream, starts)


def turn_a_boundary_face(mesh, boundary):
    corners = vtk_to_numpy(boundary.GetPolys().GetConnectivityArray())
    size = boundary.GetPolys().GetOffsetsArray().GetValue(1)
    corners[:size] = corners[:size][::-1].copy()


def give_a_face_to_another_cell(mesh, boundary):
    cell_array(boundary, "OwnerCell")[0] += 1


def give_a_face_to_another_boundary(mesh, boundary):
    cell_array(boundary, "BoundaryId")[0] += 1


def swap_mesh_points(mesh, boundary):
    ids = vtk_to_numpy(boundary.GetPointData().GetArray("MeshPointId"))
    ids[:2] = ids[1::-1].copy()


def change_a_fraction(mesh, boundary):
    cell_array(mesh, "VolumeFraction")[0] = 1.1


def miscount(mesh, boundary):
    vtk_to_numpy(mesh.GetFieldData().GetArray("Cells"))[0] += 1


def is_good(damage):
    copies = []
    for port in 0, 1:
        data = output(mesher, port)
        copies.append(data.NewInstance())
        copies[-1].DeepCopy(data)
    damage(*copies)
    try:
        mesh = measure.Mesh(*copies)
        surface.check(mesh.volume, mesh.areas)
        box = mesh.volumes.sum() / mesh.fractions.sum()  # all are of one size
        assert np.abs(mesh.volumes / box - mesh.fractions).max() < 1e-5, "boxes differ"
    except AssertionError as error:
        print(f"{damage.__name__}: {error}")
        return False
    return True


assert is_good(nothing)
for damage in (add_a_point, let_points_coincide, move_a_point, turn_a_face, swap_corners_of_a_face,
        turn_a_hexahedron, repeat_a_cell, turn_a_boundary_face, give_a_face_to_another_cell,
        give_a_face_to_another_boundary, swap_mesh_points, change_a_fraction, miscount):
    assert not is_good(damage), f"measuring does not see {damage.__name__}"
