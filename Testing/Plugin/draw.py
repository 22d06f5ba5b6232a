"""xvfb-run -a pvpython draw.py REPOSITORY PROGRAM: makes two pictures of the help pages, of the mesh of
their task cut open, and of a flow that OpenFOAM computed. PROGRAM is cartesian-mesher; the others are made by
demo.sh, TestImages.py and Window/photograph.py."""

import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk

import foam
from ducts import solve
from pipeline import DATA, output, producer
from pages import HELP, block

PROGRAM = sys.argv[2]


def show(source, view, array):
    display = simple.Show(source, view)
    display.Representation = "Surface With Edges"
    display.EdgeColor = [0.3, 0.3, 0.3]
    display.Ambient = 0.25
    simple.ColorBy(display, ("CELLS", array))
    return display


def half(source, origin, normal):
    clip = simple.Clip(Input=source, ClipType="Plane", Crinkleclip=1, Invert=1)
    clip.ClipType.Origin, clip.ClipType.Normal = origin, normal
    return clip


def picture(name, view, towards, zoom=1.4):
    view.ViewSize = [1000, 600]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [0, 0, 0], towards, [0, 0, 1]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(zoom)
    simple.SaveScreenshot(str(HELP / name), view)


def draw_task(folder):
    (folder / "Data").symlink_to(DATA)
    (folder / "task.toml").write_text(block("toml", "[surface]"))
    subprocess.run([PROGRAM, "--quiet", str(folder / "task.toml")], check=True)
    view = simple.CreateView("RenderView")
    mesh = simple.XMLUnstructuredGridReader(FileName=[str(folder / "header.vtu")])
    display = show(half(mesh, [70, 200, -100], [1, 0, 0]), view, "Level")
    display.SetScalarBarVisibility(view, False)
    picture("batch.png", view, [1, -0.25, 0.35])


def draw_flow(folder):
    surface = simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl"))
    mesher = simple.CartesianMesher(Input=surface, CellSize=6)
    speeds = np.linalg.norm(solve(foam.save(mesher, folder))[1], axis=1)
    mesh = output(mesher)
    array = numpy_to_vtk(speeds, deep=True)
    array.SetName("Speed")
    mesh.GetCellData().AddArray(array)
    view = simple.CreateView("RenderView")
    show(half(producer(mesh), [70, 0, 0], [1, 0, 0]), view, "Speed").SetScalarBarVisibility(view, True)
    colours = simple.GetColorTransferFunction("Speed")
    colours.RescaleTransferFunction(0.5, 1.5)
    bar = simple.GetScalarBar(colours, view)
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    picture("flow.png", view, [1, -0.25, 0.35])


for draw in draw_task, draw_flow:
    with tempfile.TemporaryDirectory() as folder:
        draw(pathlib.Path(folder))
