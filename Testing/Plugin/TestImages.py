"""Pictures of the outputs, against those in Testing/Baseline.

Flat colours, no light and no lines: little depends on the driver. A picture that differs is left
in the current folder; look at it, and copy it to Testing/Baseline if it is right.
"""

import pathlib

from paraview import simple

from floats import in_floats
from pictures import BASELINE, difference
from pipeline import read

MOST = 10  # thresholded error: about as many pixels of another colour
COLOURS = [(0.12, 0.47, 0.71), (1.0, 0.5, 0.05), (0.17, 0.63, 0.17), (0.84, 0.15, 0.16),
           (0.58, 0.4, 0.74), (0.55, 0.34, 0.29), (0.89, 0.47, 0.76), (0.5, 0.5, 0.5),
           (0.74, 0.74, 0.13), (0.09, 0.75, 0.81), (0.68, 0.78, 0.91), (1.0, 0.73, 0.47)]


def draw(name, source, array, values, towards, up):
    """`source` coloured by a cell array: a colour for each of `values`."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [300, 300]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    display = simple.Show(source, view)
    display.Representation = "Surface"
    display.Ambient, display.Diffuse, display.Specular = 1, 0, 0
    simple.ColorBy(display, ("CELLS", array))
    display.SetScalarBarVisibility(view, False)
    table = simple.GetColorTransferFunction(array)
    table.InterpretValuesAsCategories = 1
    table.AnnotationsInitialized = 1
    table.Annotations = [text for value in values for text in (str(value), str(value))]
    table.IndexedColors = [part for i in range(len(values)) for part in COLOURS[i]]
    view.CameraPosition = towards
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = up
    simple.ResetCamera(view)
    simple.SaveScreenshot(name + ".png", view)
    simple.Delete(view)


def half(source, normal, origin=(0, 0, 0)):
    """The cells on one side of a plane, whole."""
    clip = simple.Clip(Input=source, ClipType="Plane", Crinkleclip=1, Invert=1)
    clip.ClipType.Origin = origin
    clip.ClipType.Normal = normal
    return clip


spot, exhaust = in_floats(read("cino_spot.obj")), read("kcl_exhaust_header_lumens.stl")
boxer = simple.CartesianBoxer(Input=spot, CellSize=0.1)
draw("BoxesByStatus", half(boxer, [1, 0, 0]), "Status", [1, 2], [1, 0.3, -0.5], [0, 1, 0])

refined = simple.CartesianBoxer(Input=spot, CellSize=0.2, RefinementDepth=3)
# Boxes by the sum of their levels: how often they were halved in all.
halvings = simple.Calculator(Input=half(refined, [1, 0, 0]), AttributeType="Cell Data",
    ResultArrayName="Halvings", Function="Level_X + Level_Y + Level_Z")
draw("BoxesByLevel", halvings, "Halvings", range(10), [1, 0.3, -0.5], [0, 1, 0])

patcher = simple.Patcher(Input=exhaust, Boxes=simple.CartesianBoxer(Input=exhaust, CellSize=12))
draw("PatchesByBoundary", patcher, "BoundaryId", range(12), [1, 0.6, 0.8], [0, 0, 1])

# Why each box has its patches: grey by Marching Cubes, else the condition for Exact Fit.
part = read("tm_featuretype_occ.stl")
reasons = simple.Patcher(Input=part, Boxes=simple.CartesianBoxer(Input=part, CellSize=4))
draw("PatchesByReason", reasons, "PatchReason", range(7), [1, 0.6, 0.8], [0, 0, 1])

mesher = simple.CartesianMesher(Input=spot, CellSize=0.1)
# Hexahedra have one colour, the small cut cells another, the large ones a third.
kinds = simple.Calculator(Input=half(mesher, [1, 0, 0]), AttributeType="Cell Data",
    ResultArrayName="Kind", Function="(VolumeFraction > 0.999999) + (VolumeFraction > 0.5)")
draw("MeshByFraction", kinds, "Kind", [0, 1, 2], [1, 0.3, -0.5], [0, 1, 0])

cut = simple.CartesianMesher(Input=exhaust, CellSize=12, MeshlinesZ=[-200, -150, -100, -50, 0])
draw("BoundaryCutOff", simple.OutputPort(cut, "Boundary"), "BoundaryId", range(-1, 11),
    [1, 0.6, 0.8], [0, 0, 1])

names = ["BoxesByStatus", "BoxesByLevel", "PatchesByBoundary", "PatchesByReason", "MeshByFraction", "BoundaryCutOff"]
for name in names:
    for baseline in names:
        error = difference(f"{name}.png", BASELINE / f"{baseline}.png")
        print(f"{name} against {baseline}: {error}")
        if name == baseline:
            assert error <= MOST, f"{pathlib.Path(name).absolute()}.png differs by {error}"
        else:
            assert error > MOST, "the comparison sees no difference between two pictures"
for name in names:
    pathlib.Path(f"{name}.png").unlink()
