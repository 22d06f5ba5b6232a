"""How near the boundary of the mesh comes to the surface, by method, tying, merge angle and cell size.

usage: pvpython fidelity.py [--cells 12,24,48] [--sweep method|tying|merge] [SURFACE...]

Without surfaces: a sphere and a torus, and the organic ones in Data. Prints a table in Markdown:
volume error over the surface's volume; the largest and the rms distance of the boundary's points
and face centres to the surface, and the largest back from the surface's points, over the cell size;
patches and boxes by Marching Cubes; the shortest edge of a boundary face over the cell size; the most
that a boundary face's star triangle turns away from it (cosine; negative: turned over).
"""

import argparse
import pathlib

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
SWEEPS = {
    "method": [{"PatchMethod": method} for method in ("Automatic", "Marching Cubes")],
    "tying": [{"Tying": tying} for tying in ("Keep Nodes", "Move Nodes")],
    "merge": [{"MergeAngle": angle} for angle in (0, 5, 10, 15, 20, 30)],
}


def output(proxy, port=0):
    proxy.UpdatePipeline()
    return proxy.SMProxy.GetClientSideObject().GetOutputDataObject(port)


def sources(names):
    if not names:
        yield "sphere", simple.Sphere(ThetaResolution=400, PhiResolution=200)
        yield "torus", simple.Clean(Input=simple.Superquadric(Toroidal=1, ThetaRoundness=1,
            PhiRoundness=1, ThetaResolution=400, PhiResolution=200))
        names = [DATA / "cino_spot.obj"]
    for name in map(pathlib.Path, names):
        reader = {".stl": lambda n: simple.STLReader(FileNames=[n]),
                  ".obj": lambda n: simple.WavefrontOBJReader(FileName=n)}[name.suffix.lower()]
        yield name.stem, reader(str(name))


class Polygons:
    """The star triangles of polygons."""

    def __init__(self, data):
        points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        start = vtk_to_numpy(data.GetPolys().GetOffsetsArray())
        corner = vtk_to_numpy(data.GetPolys().GetConnectivityArray())
        following = np.arange(1, len(corner) + 1)
        following[start[1:] - 1] = start[:-1]
        size = np.diff(start)
        face = np.repeat(np.arange(len(size)), size)
        self.points = points
        self.centres = np.add.reduceat(points[corner], start[:-1]) / size[:, None]
        p, q, c = points[corner], points[corner[following]], self.centres[face]
        twice = np.cross(p - c, q - c)
        area = np.add.reduceat(twice, start[:-1])
        lengths = np.linalg.norm(twice, axis=1) * np.linalg.norm(area, axis=1)[face]
        self.star = ((twice * area[face]).sum(1)[lengths > 0] / lengths[lengths > 0]).min()
        self.shortest = np.linalg.norm(q - p, axis=1).min()
        self.volume = (p * np.cross(q, c)).sum() / 6
        triangles = np.stack([corner, corner[following], len(points) + face], axis=1)
        self.surface = polydata(np.concatenate([points, self.centres]), triangles)


def polydata(points, triangles):
    data, vtk_points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.astype(np.int64).ravel(), deep=True))
    data.SetPoints(vtk_points)
    data.SetPolys(cells)
    return data


def distances(points, surface):
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    at, cell, sub, square = [0.0] * 3, reference(0), reference(0), reference(0.0)
    result = []
    for point in points:
        locator.FindClosestPoint(point, at, cell, sub, square)
        result.append(square.get() ** 0.5)
    return np.array(result)


def measure(name, source, cells, properties):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(output(source))
    triangles.Update()
    surface = triangles.GetOutput()
    mass = vtkMassProperties()
    mass.SetInputData(surface)
    bounds = surface.GetBounds()
    size = max(high - low for low, high in zip(bounds[0::2], bounds[1::2])) / cells
    mesher = simple.CartesianMesher(Input=source, CellSize=size, SmallCellRatio=1e-9, **properties)
    boundary = Polygons(output(mesher, 1))
    field = output(mesher).GetFieldData()
    count = {key: field.GetArray(key).GetValue(0)
             for key in ("BoxesIntersected", "BoxesByMarchingCubes", "Patches")}
    there = distances(np.concatenate([boundary.points, boundary.centres]), surface)
    back = distances(vtk_to_numpy(surface.GetPoints().GetData()), boundary.surface)
    simple.Delete(mesher)
    boxes = count["BoxesIntersected"]
    print(f"| {name} | {cells:g} | {' '.join(str(v) for v in properties.values())} "
          f"| {abs(boundary.volume / mass.GetVolume() - 1):.2e} | {there.max() / size:.4f} "
          f"| {np.sqrt((there**2).mean()) / size:.5f} | {back.max() / size:.4f} "
          f"| {count['Patches'] / boxes:.2f} | {100 * count['BoxesByMarchingCubes'] / boxes:.0f} "
          f"| {boundary.shortest / size:.1e} | {boundary.star:.3f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cells", default="12,24,48,96")
    parser.add_argument("--sweep", choices=SWEEPS, default="method")
    parser.add_argument("surfaces", nargs="*")
    arguments = parser.parse_args()
    print("| surface | cells along the longest side | | volume error | largest distance | rms "
          "| largest back | patches a box | % Marching Cubes | shortest edge | star |")
    print("|---" * 11 + "|")
    for name, source in sources(arguments.surfaces):
        for properties in SWEEPS[arguments.sweep]:
            for cells in arguments.cells.split(","):
                measure(name, source, float(cells), properties)


main()
