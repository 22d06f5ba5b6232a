"""Cartesian Mesher beside what a user could take instead, in one go, on one thread.

usage: pvpython compare.py [--cells N] [SURFACE...]

For a sphere, and for each surface (STL, OBJ), the same number of cells by: Cartesian Mesher; VTK's
vtkTableBasedClipDataSet of an image by the analytic sphere, and by the distance from the surface;
OpenFOAM's snappyHexMesh, where it is installed, with the same background cells. Each runs in a process
of its own. Prints seconds from surface in memory (snappyHexMesh: from its files) to mesh in memory,
cells a second, peak bytes a cell above what the process took before, the error of the volume, and all
by Cartesian Mesher's. snappyHexMesh meshes one component of a surface: take surfaces of one.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkSphere
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkTableBasedClipDataSet
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader, vtkSTLWriter

HERE = pathlib.Path(__file__).resolve()
sys.path[:0] = [str(HERE.parent), str(HERE.parents[1] / "Plugin")]
import foam  # noqa: E402
from snappy import write_case  # noqa: E402

SPHERE = "sphere"
RADIUS = 0.5
TOOLS = {"Cartesian Mesher": "mesher", "clip by sphere": "clip_by_sphere",
         "clip by distance": "clip_by_distance", "snappyHexMesh": "snappy"}


def surface(name):
    if name == SPHERE:
        source = vtkSphereSource()
        source.SetThetaResolution(200)
        source.SetPhiResolution(100)
    else:
        source = {".stl": vtkSTLReader, ".obj": vtkOBJReader}[pathlib.Path(name).suffix.lower()]()
        source.SetFileName(name)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def volume_of(data):
    """Of what triangles enclose. (vtkMassProperties is up to 0.1 % off.)"""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return abs(np.einsum("ij,ij->", a, np.cross(b, c))) / 6


def memory(key, process="self"):
    """A line of a process's status, in bytes: VmRSS now, VmHWM at its peak."""
    text = pathlib.Path(f"/proc/{process}/status").read_text()
    found = re.search(rf"^{key}:\s+(\d+) kB", text, re.MULTILINE)
    return 1024 * int(found[1]) if found else 0


def measured(algorithm, volume):
    """What the update of a filter takes; what is measured of its output afterwards does not count."""
    pathlib.Path("/proc/self/clear_refs").write_text("5")  # forgets the peak so far
    before, begin = memory("VmRSS"), time.perf_counter()
    algorithm.Update()
    seconds, after = time.perf_counter() - begin, memory("VmHWM")
    mesh = algorithm.GetOutputDataObject(0)
    # What its boundary encloses: VTK's sizes of polyhedra are up to 0.5 % off.
    boundary, triangles = vtkGeometryFilter(), vtkTriangleFilter()
    boundary.SetInputData(mesh)
    triangles.SetInputConnection(boundary.GetOutputPort())
    triangles.Update()
    found = volume_of(triangles.GetOutput())
    return {"cells": mesh.GetNumberOfCells(), "seconds": seconds, "bytes": after - before,
            "error": abs(found - volume) / volume}


def cartesian_mesher(data, size):
    source = simple.TrivialProducer()
    source.SMProxy.GetClientSideObject().SetOutput(data)
    proxy = simple.CartesianMesher(Input=source, CellSize=size, NumberOfThreads=1)
    proxy.UpdateVTKObjects()
    return proxy.SMProxy.GetClientSideObject()


def mesher(name, size):
    data = surface(name)
    return measured(cartesian_mesher(data, size), volume_of(data))


def image(name, size):
    """Cells of the same size around the surface."""
    bounds = surface(name).GetBounds()
    image = vtkImageData()
    image.SetOrigin(*(bounds[2 * axis] - size / 2 for axis in range(3)))
    image.SetSpacing(size, size, size)
    image.SetDimensions(*(int((bounds[2 * axis + 1] - bounds[2 * axis]) / size) + 3 for axis in range(3)))
    return image


def clip(name, size, function, volume):
    filter = vtkTableBasedClipDataSet()
    filter.SetInputData(image(name, size))
    filter.SetClipFunction(function)
    filter.InsideOutOn()
    return measured(filter, volume)


def clip_by_sphere(name, size):
    sphere = vtkSphere()
    sphere.SetRadius(RADIUS)
    return clip(name, size, sphere, 4 / 3 * 3.14159265358979 * RADIUS ** 3)


def clip_by_distance(name, size):
    data = surface(name)
    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(data)
    return clip(name, size, distance, volume_of(data))


def point_inside(name, size):
    """The middle of a cell that no surface passes through."""
    filter = cartesian_mesher(surface(name), size)
    filter.Update()
    mesh = filter.GetOutputDataObject(0)
    fraction = mesh.GetCellData().GetArray("VolumeFraction")
    cells = [c for c in range(mesh.GetNumberOfCells()) if fraction.GetValue(c) == 1]
    low = mesh.GetCell(cells[len(cells) // 2]).GetBounds()
    # Off the middle, where a background cell's side could pass.
    return [low[2 * axis] + 0.37 * (low[2 * axis + 1] - low[2 * axis]) for axis in range(3)]


def snappy(name, size):
    data = surface(name)
    frame = image(name, size)
    low, cells = frame.GetOrigin(), [n - 1 for n in frame.GetDimensions()]
    high = [low[axis] + size * cells[axis] for axis in range(3)]
    with tempfile.TemporaryDirectory() as folder:
        writer = vtkSTLWriter()
        writer.SetInputData(data)
        writer.SetFileTypeToBinary()
        (pathlib.Path(folder) / "constant" / "triSurface").mkdir(parents=True)
        writer.SetFileName(f"{folder}/constant/triSurface/surface.stl")
        writer.Write()
        write_case(folder, low, high, cells, [point_inside(name, size)])
        foam.run(folder, "blockMesh")
        begin, peak = time.perf_counter(), 0
        environment = dict(os.environ, WM_PROJECT_DIR=foam.CONFIGURATION, PWD=folder)
        program = subprocess.Popen(["snappyHexMesh", "-overwrite"], cwd=folder, env=environment,
            stdout=subprocess.DEVNULL)
        while program.poll() is None:
            try:
                peak = max(peak, memory("VmHWM", program.pid))
            except FileNotFoundError:  # it has just ended
                pass
            time.sleep(0.02)
        seconds = time.perf_counter() - begin
        assert program.returncode == 0, "snappyHexMesh failed"
        text = foam.run(folder, "checkMesh")
    found = float(re.search(r"Total volume = (\S+)", text)[1].rstrip("."))
    volume = volume_of(data)
    return {"cells": int(re.search(r"^ +cells: +(\d+)", text, re.MULTILINE)[1]), "seconds": seconds,
            "bytes": peak, "error": abs(found - volume) / volume}


def run(tool, name, size):
    """In a process of its own."""
    done = subprocess.run([shutil.which("pvpython"), str(HERE), "--run", tool, name, repr(size)],
        capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{tool} of {name} failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return json.loads(done.stdout.splitlines()[-1])


def compare(name, cells):
    size = (volume_of(surface(name)) / cells) ** (1 / 3)
    print(f"{pathlib.Path(name).stem:24}{'cells':>10}{'seconds':>9}{'cells/s':>10}{'bytes a cell':>14}"
          f"{'volume error':>14}{'times as long a cell, memory, error':>38}")
    ours = None
    for title, tool in TOOLS.items():
        if (tool == "clip_by_sphere" and name != SPHERE) or \
                (tool == "snappy" and not shutil.which("snappyHexMesh")):
            continue
        found = run(tool, name, size)
        row = [found["seconds"] / found["cells"], found["bytes"] / found["cells"], found["error"]]
        ours = ours or row
        print(f"  {title:22}{found['cells']:10}{found['seconds']:9.2f}{1 / row[0]:10.0f}{row[1]:14.0f}"
              f"{row[2]:14.2e}" + "".join(f"{a / b:12.2f}" for a, b in zip(row, ours)), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--cells", type=float, default=2e5, help="about as many (default: 200 000)")
    parser.add_argument("--run", nargs=3, help=argparse.SUPPRESS)
    parser.add_argument("surfaces", nargs="*")
    options = parser.parse_args()
    if options.run:
        tool, name, size = options.run
        print(json.dumps(globals()[tool](name, float(size))))
        return
    for name in [SPHERE, *options.surfaces]:
        compare(name, options.cells)


main()
