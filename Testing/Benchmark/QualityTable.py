"""Prints how good our meshes are for solvers, one line a mesh:

    pvpython QualityTable.py SURFACE... [--across 12 25 60] [--depth 0 2] [--set Name=Value]

A SURFACE is a file, or "sphere". Cells are as long as the surface's longest side by `across`, halved
`depth` times along the surface; --set gives any other property of Cartesian Mesher. Printed are the
largest non-orthogonality and skewness, the volume's error relative to the surface's own, the largest
angles of section 3, each with the number of cells that fail, and numbers of cells: concave ones, and
those that fail checkMesh -allGeometry by skewness, face weight, volume ratio, determinant and
tetrahedra.
"""

import argparse
import ast
import pathlib
import time

from paraview import simple
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

HEAD = (f"{'surface':25} across depth {'cells':>8} {'seconds':>7}  non-orth. skewness   volume  "
        "boundary angle    inner angle  concave skew weight  ratio  det.  tets")


def read(name):
    if name == "sphere":
        return simple.Sphere(ThetaResolution=64, PhiResolution=64)
    return simple.OpenDataFile(name)


def output(proxy, port=0):
    proxy.UpdatePipeline()
    return proxy.SMProxy.GetClientSideObject().GetOutputDataObject(port)


def volume_of(surface):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(output(surface))
    properties = vtkMassProperties()
    properties.SetInputConnection(triangles.GetOutputPort())
    return properties.GetVolume()


def measure(name, surface, across, depth, properties):
    bounds = surface.GetDataInformation().GetBounds()
    longest = max(bounds[i + 1] - bounds[i] for i in (0, 2, 4))
    start = time.time()
    mesher = simple.CartesianMesher(Input=surface, CellSize=longest / across,
        RefinementDepth=depth, **properties)
    mesher.UpdatePipeline()
    seconds = time.time() - start
    field = output(simple.FiniteVolumeQuality(Input=mesher)).GetFieldData()

    def value(array):
        return field.GetArray(array).GetValue(0)

    error = abs(value("TotalVolume") / volume_of(surface) - 1)

    def angle(which):
        return f"{value('Max' + which):6.1f} {value(which + 'Failures'):7.0f}"

    def failures(which):
        return f"{value(which + 'Failures'):.0f}"

    print(f"{name:25} {across:6} {depth:5} {value('Cells'):8.0f} {seconds:7.2f}  "
          f"{value('MaxNonOrthogonality'):9.1f} {value('MaxSkewness'):8.3g} {error:8.1e}  "
          f"{angle('BoundaryAngle')} {angle('InnerAngle')}  {value('ConcaveCells'):7.0f} "
          f"{failures('Skewness'):>4} {failures('FaceWeight'):>6} {failures('VolumeRatio'):>6} "
          f"{failures('Determinant'):>5} {failures('TetQuality'):>5}", flush=True)
    simple.Delete(mesher)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="+", metavar="SURFACE")
    parser.add_argument("--across", type=int, nargs="+", default=[12, 25, 60])
    parser.add_argument("--depth", type=int, nargs="+", default=[0, 2])
    parser.add_argument("--set", action="append", default=[], metavar="Name=Value")
    options = parser.parse_args()
    properties = {}
    for text in options.set:
        name, _, value = text.partition("=")
        try:
            properties[name] = ast.literal_eval(value)
        except (SyntaxError, ValueError):
            properties[name] = value  # an enumeration's name
    print(HEAD)
    for name in options.surfaces:
        surface = read(name)
        surface.UpdatePipeline()
        for across in options.across:
            for depth in options.depth:
                measure(pathlib.Path(name).stem, surface, across, depth, properties)


main()
