"""Closed surfaces to try a mesher on, made by rule: the same for the same numbers.

    pvpython Testing/Plugin/generated.py FOLDER [--count 200] [--cells 25]
    pvpython Testing/Plugin/checkmesh.py --sizes 25 --depths 0 FOLDER/*.stl

Displaced spheres and tori (waves from 2 to 1/10 of a box long), thin plates (2 to 1/10 of a box), wedges
(60 to 2 degrees) and lattices of struts, each turned at random. `--cells`: boxes along the longest side, to
which these lengths belong.
"""

import argparse
import pathlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter
from vtkmodules.vtkIOGeometry import vtkSTLWriter


def polydata(points, triangles):
    data = vtkPolyData()
    at = vtkPoints()
    at.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, dtype=float), deep=True))
    cells = vtkCellArray()
    for triangle in triangles:
        cells.InsertNextCell(3, [int(p) for p in triangle])
    data.SetPoints(at)
    data.SetPolys(cells)
    return data


def turned(points, random):
    """By a random rotation, and scaled to a longest side of 1."""
    q, _ = numpy.linalg.qr(random.standard_normal((3, 3)))
    q[:, 0] *= numpy.sign(numpy.linalg.det(q))
    points = points @ q.T
    return points / numpy.ptp(points, axis=0).max()


def grid_triangles(rows, columns):
    """Of a grid that closes in both directions."""
    def node(i, k):
        return i % rows * columns + k % columns

    for i in range(rows):
        for k in range(columns):
            yield node(i, k), node(i + 1, k), node(i + 1, k + 1)
            yield node(i, k), node(i + 1, k + 1), node(i, k + 1)


def waves(points, length, height, random):
    """At each point the sum of six plane waves, at most `height`."""
    sum_ = numpy.zeros(len(points))
    for _ in range(6):
        direction = random.standard_normal(3)
        direction *= 2 * numpy.pi / length / numpy.linalg.norm(direction)
        sum_ += numpy.sin(points @ direction + random.uniform(0, 2 * numpy.pi))
    return height * sum_ / 6


def sphere(random, length):
    """A cube's six sides of squares, blown up."""
    n = int(min(60, max(16, 4 / length)))
    index, points, triangles = {}, [], []

    def node(at):
        if at not in index:
            index[at] = len(points)
            points.append(numpy.tan((numpy.array(at) / n * 2 - 1) * numpy.pi / 4))
        return index[at]

    for axis in range(3):
        for end in (0, n):
            for i in range(n):
                for k in range(n):
                    square = []
                    for a, b in ((i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1)):
                        at = [0, 0, 0]
                        at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3] = end, a, b
                        square.append(node(tuple(at)))
                    square = square if end else square[::-1]
                    triangles += [square[:3], [square[0], square[2], square[3]]]
    points = numpy.array(points)
    points /= 2 * numpy.linalg.norm(points, axis=1)[:, None]
    return points * (1 + 2 * waves(points, length, length / 4, random))[:, None], triangles


def torus(random, length):
    rows, columns = (int(min(180, max(24, 3 * c / length))) for c in (1.2, 0.6))
    thin = random.uniform(0.08, 0.2)
    u, v = numpy.meshgrid(numpy.arange(rows) * 2 * numpy.pi / rows,
                          numpy.arange(columns) * 2 * numpy.pi / columns, indexing="ij")
    u, v = u.ravel(), v.ravel()
    ring = numpy.stack([numpy.cos(u), numpy.sin(u), 0 * u], 1)
    normal = numpy.cos(v)[:, None] * ring + numpy.sin(v)[:, None] * [0, 0, 1]
    middle = 0.3 * ring
    by = waves(middle + thin * normal, length, min(length / 4, thin / 3), random)
    return middle + (thin + by)[:, None] * normal, grid_triangles(rows, columns)


def prism(outline, height):
    """Over a convex outline in the plane."""
    n = len(outline)
    points = [(x, y, z) for z in (0, height) for x, y in outline]
    triangles = []
    for i in range(n):
        k = (i + 1) % n
        triangles += [(i, k, n + k), (i, n + k, n + i)]
    for i in range(1, n - 1):
        triangles += [(0, i + 1, i), (n, n + i, n + i + 1)]
    return numpy.array(points, dtype=float), triangles


def plate(random, length):
    wide = random.uniform(0.3, 1)
    return prism([(0, 0), (1, 0), (1, wide), (0, wide)], length)


def wedge(random, share):
    angle = numpy.radians(60 * (2 / 60) ** share)
    return prism([(0, 0), (1, 0), (numpy.cos(angle), numpy.sin(angle))], random.uniform(0.2, 1))


def lattice(random, thickness):
    """Struts along a cubic grid, contoured from a field: 3 to 5 cells of it a side."""
    n, cells = 64, int(random.integers(3, 6))
    x = numpy.linspace(-0.05, 1.05, n)
    at = numpy.stack(numpy.meshgrid(x, x, x, indexing="ij"), -1)
    off = numpy.abs(at * cells - numpy.round(at * cells)) / cells
    two_of = numpy.sort(off, axis=-1)[..., :2]
    field = max(thickness, 2.5 * 1.1 / n) / 2 - numpy.linalg.norm(two_of, axis=-1)
    image = vtkImageData()
    image.SetDimensions(n, n, n)
    image.SetSpacing(3 * [1.1 / n])
    inside = numpy.minimum(field, 0.02 - numpy.abs(at - 0.5).max(-1) + 0.5)
    image.GetPointData().SetScalars(numpy_to_vtk(inside.transpose(2, 1, 0).ravel(), deep=True))
    contour = vtkContourFilter()
    contour.SetInputData(image)
    contour.SetValue(0, 0)
    contour.Update()
    data = contour.GetOutput()
    points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    triangles = [[data.GetCell(c).GetPointId(i) for i in (0, 2, 1)]
                 for c in range(data.GetNumberOfCells())]
    return points, triangles


def make(number, cells):
    """The name of a surface, its points and triangles."""
    random = numpy.random.default_rng(number)
    kinds = (sphere, torus, plate, wedge, lattice)
    kind = kinds[number % len(kinds)]
    share = number // len(kinds) % 8 / 7
    size = share if kind is wedge else 2 / cells * 0.05 ** share
    points, triangles = kind(random, size)
    return f"{kind.__name__}_{number:03}", turned(points, random), triangles


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--cells", type=float, default=25)
    chosen = parser.parse_args()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    for number in range(chosen.count):
        name, points, triangles = make(number, chosen.cells)
        writer = vtkSTLWriter()
        writer.SetInputData(polydata(points, triangles))
        writer.SetFileTypeToBinary()
        writer.SetFileName(str(chosen.folder / f"{name}.stl"))
        writer.Write()


main()
