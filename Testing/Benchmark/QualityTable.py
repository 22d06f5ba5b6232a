"""Prints how good our meshes are for solvers, one line a mesh:

    pvpython QualityTable.py [--across 12 25 60] [--depth 0 2] [--ratio 1e-3] SURFACE...

A SURFACE is a file, or "sphere". Cells are as long as the surface's longest side by `across`, halved
`depth` times along the surface. The volume's error is relative to the surface's own; angles are those
of section 3, with the number of cells that fail; OpenFOAM's are numbers of cells that checkMesh
complains about (-allGeometry, true concavity apart).
"""

import argparse
import pathlib
import sys
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
    proxy.UpdatePipeline(), proxy.GetDataInformation()
    return proxy.SMProxy.GetClientSideObject().GetOutputDataObject(port)


def volume_of(surface):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(output(surface))
    properties = vtkMassProperties()
    properties.SetInputConnection(triangles.GetOutputPort())
    return properties.GetVolume()


def measure(name, surface, across, depth, ratio):
    bounds = surface.GetDataInformation().GetBounds()
    longest = max(bounds[i + 1] - bounds[i] for i in (0, 2, 4))
    start = time.time()
    mesher = simple.CartesianMesher(Input=surface, CellSize=longest / across,
        RefinementDepth=depth, SmallCellRatio=ratio)
    mesher.UpdatePipeline()
    seconds = time.time() - start
    field = output(simple.FiniteVolumeQuality(Input=mesher)).GetFieldData()
    value = {field.GetArrayName(i): field.GetArray(i).GetValue(0)
             for i in range(field.GetNumberOfArrays()) if field.GetArray(i).GetNumberOfTuples() == 1}
    true_volume = volume_of(surface)
    error = abs(value["TotalVolume"] / true_volume - 1)

    def angle(which):
        return f"{value['Max' + which]:6.1f} {value[which + 'Failures']:7.0f}"

    def failures(which):
        return f"{value[which + 'Failures']:.0f}"

    print(f"{name:25} {across:6} {depth:5} {value['Cells']:8.0f} {seconds:7.2f}  "
          f"{value['MaxNonOrthogonality']:9.1f} {value['MaxSkewness']:8.3g} {error:8.1e}  "
          f"{angle('BoundaryAngle')} {angle('InnerAngle')}  {value['ConcaveCells']:7.0f} "
          f"{failures('Skewness'):>4} {failures('FaceWeight'):>6} {failures('VolumeRatio'):>6} "
          f"{failures('Determinant'):>5} {failures('TetQuality'):>5}", flush=True)
    simple.Delete(mesher)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="+", metavar="SURFACE")
    parser.add_argument("--across", type=int, nargs="+", default=[12, 25, 60])
    parser.add_argument("--depth", type=int, nargs="+", default=[0, 2])
    parser.add_argument("--ratio", type=float, default=1e-3)
    options = parser.parse_args()
    print(HEAD)
    for name in options.surfaces:
        surface = read(name)
        surface.UpdatePipeline()
        for across in options.across:
            for depth in options.depth:
                measure(pathlib.Path(name).stem, surface, across, depth, options.ratio)


main()
