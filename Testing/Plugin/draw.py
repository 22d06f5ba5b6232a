"""xvfb-run -a pvpython draw.py REPOSITORY PROGRAM [NAME ...]: makes pictures of the help pages: of the mesh of
their task cut open (task), of a flow that OpenFOAM computed (flow), of a mesh that
follows a solution (adaptation), of layers (layers), of the coolant jacket (jacket), of sections (slices), of
cells around a rim (rims), of gaps that are closed (gaps, houses), of terrain (terrain), of strata, flat and periodic meshes and zones (strata, flat, periodic, zone), of the solids of a STEP file (cad; needs Open CASCADE), and of solid and gas
of the exhaust header (regions; needs the folder of surfaces in SURFACES). PROGRAM is cartesian-mesher; the others are made by
demo.sh, TestImages.py and Window/photograph.py."""

import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

import foam
import jacket
from ducts import solve
from pipeline import DATA, output, polydata, producer
from pages import HELP, REPOSITORY, block, blocks

PROGRAM = sys.argv[2]


def show(source, view, array):
    display = simple.Show(source, view)
    display.Representation = "Surface With Edges"
    display.EdgeColor = [0.3, 0.3, 0.3]
    display.Ambient = 0.25
    simple.ColorBy(display, ("CELLS", array))
    return display


def show_regions(mesh, view, y):
    """A section across y, with the edges of cells before it."""
    section = simple.SlicePolyhedra(Input=mesh, Origin=[0, y, 0], Normal=[0, 1, 0])
    display = show(section, view, "Region")
    display.Representation = "Surface"
    display.SetScalarBarVisibility(view, False)
    edges = simple.Show(simple.ExtractEdges(Input=section), view)
    edges.ColorArrayName, edges.DiffuseColor, edges.Position = ["CELLS", ""], [0.3, 0.3, 0.3], [0, -0.005, 0]


def half(source, origin, normal):
    clip = simple.Clip(Input=source, ClipType="Plane", Crinkleclip=1, Invert=1)
    clip.ClipType.Origin, clip.ClipType.Normal = origin, normal
    return clip


def picture(name, view, towards, zoom=1.4, size=(1000, 600)):
    view.ViewSize = size
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [0, 0, 0], towards, [0, 0, 1]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(zoom)
    simple.SaveScreenshot(str(HELP / name), view)


def draw_task(folder):
    (folder / "Data").symlink_to(DATA)
    (folder / "task.toml").write_text(block("toml", "header.vtu"))
    subprocess.run([PROGRAM, "--quiet", str(folder / "task.toml")], check=True)
    view = simple.CreateView("RenderView")
    mesh = simple.XMLUnstructuredGridReader(FileName=[str(folder / "header.vtu")])
    display = show(half(mesh, [70, 200, -100], [1, 0, 0]), view, "Level")
    display.SetScalarBarVisibility(view, False)
    picture("batch.png", view, [1, -0.25, 0.35])


def draw_flow(folder):
    surface = simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl"))
    mesher = simple.CartesianMesher(Input=surface, CellSize=3)
    speeds = np.linalg.norm(solve(foam.save(mesher, folder))[1], axis=1)
    mesh = output(mesher)
    array = numpy_to_vtk(speeds[vtk_to_numpy(mesh.GetCellData().GetArray("CellId"))], deep=True)
    array.SetName("Speed")
    mesh.GetCellData().AddArray(array)
    view = simple.CreateView("RenderView")
    show(half(producer(mesh), [70, 0, 0], [1, 0, 0]), view, "Speed").SetScalarBarVisibility(view, True)
    colours = simple.GetColorTransferFunction("Speed")
    colours.RescaleTransferFunction(0.5, 1.5)
    bar = simple.GetScalarBar(colours, view)
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    picture("flow.png", view, [1, -0.25, 0.35])


def draw_layers(_):
    surface = simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl"))
    mesher = simple.CartesianMesher(Input=surface, CellSize=4, Layers=5, FirstLayerThickness=0.25)
    view = simple.CreateView("RenderView")
    show(simple.OutputPort(mesher, "Mesh"), view, "Layer").SetScalarBarVisibility(view, False)
    view.CameraParallelProjection = 1
    picture("layers.png", view, [0.35, -1, 0.3])
    camera = simple.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)  # the first inlet
    camera.SetPosition(105, -300, 90)
    view.CameraParallelScale = 19
    simple.SaveScreenshot(str(HELP / "layers.png"), view)


def joined(name, parts):
    """One picture of several, side by side."""
    pictures = [vtkPNGReader() for _ in parts]
    all_ = vtkImageAppend()
    for reader, part in zip(pictures, parts):
        reader.SetFileName(str(part))
        all_.AddInputConnection(reader.GetOutputPort())
    writer = vtkPNGWriter()
    writer.SetFileName(str(HELP / name))
    writer.SetInputConnection(all_.GetOutputPort())
    writer.Write()


def draw_jacket(folder):
    mesh = simple.OutputPort(jacket.mesher(), "Mesh")
    hole = list(jacket.hole_centres())[2]
    parts = []
    for number, (zoom, towards) in enumerate(((1.05, [-0.5, -1, 0.6]), (1, [0, -1, 0]))):
        view = simple.CreateView("RenderView")
        origin = [0, 0, 0] if number == 0 else [0, hole[1], 0]
        shown = half(mesh, origin, [0, -1, 0])
        show(shown, view, "Level").SetScalarBarVisibility(view, False)
        view.CameraParallelProjection = number
        parts.append(folder / f"{number}.png")
        picture(parts[-1], view, towards, zoom, [500, 500])
        if number:
            camera = simple.GetActiveCamera()
            camera.SetFocalPoint(hole[0], hole[1], 0)
            camera.SetPosition(hole[0], hole[1] - 300, 0)
            view.CameraParallelScale = 9
            simple.SaveScreenshot(str(parts[-1]), view)
    joined("jacket.png", parts)


def draw_regions(folder):
    surfaces = pathlib.Path(os.environ["SURFACES"])
    gas, solid = (simple.NamedSTLReader(FileName=str(surfaces / f"kcl_exhaust_header_{name}.stl"))
                  for name in ("lumens", "fused"))
    both = simple.GroupDatasets(Input=[gas, solid], BlockNames=["gas", "solid"])
    mesher = simple.CartesianMesher(Input=both, RegionsFrom="Blocks", ContactTolerance=2, CellSize=6)
    parts = []
    for region in 2, 1:
        view = simple.CreateView("RenderView")
        alone = simple.Threshold(Input=simple.OutputPort(mesher, "Mesh"), Scalars=["CELLS", "Region"],
                                 LowerThreshold=region, UpperThreshold=region)
        display = show(half(alone, [70, 0, 0], [1, 0, 0]), view, "Region")
        simple.ColorBy(display, None)
        display.DiffuseColor = [0.75, 0.75, 0.8] if region == 2 else [0.95, 0.75, 0.45]
        parts.append(folder / f"{region}.png")
        picture(parts[-1], view, [1, -0.25, 0.35], 1.05, [500, 500])
    joined("regions.png", parts)


def draw_adaptation(folder):
    os.chdir(folder)
    names = {}
    for script in blocks(HELP / "adaptation.md", "python"):
        exec(script, names)
    view = simple.CreateView("RenderView")
    names["solution"].Decomposepolyhedra = 0
    merged = simple.MergeBlocks(Input=names["solution"])
    merged.UpdatePipeline(1)
    show(half(merged, [0, 0, 0], [0, 1, 0]), view, "T").SetScalarBarVisibility(view, False)
    simple.GetColorTransferFunction("T").RescaleTransferFunction(0, 0.6)
    view.ViewTime = 1
    picture("adaptation.png", view, [0.2, 1, 0.15])


def close_up(name, view, place, distance, scale):
    """Of a section across y, seen from its front."""
    view.CameraParallelProjection = 1
    picture(name, view, [0, -1, 0], 1, [500, 400])
    camera = simple.GetActiveCamera()
    camera.SetFocalPoint(*place)
    camera.SetPosition(place[0], place[1] - distance, place[2])
    view.CameraParallelScale = scale
    simple.SaveScreenshot(str(name), view)


def draw_slices(folder):
    """The same cells at the header's wall, by ParaView's Slice and by Slice Polyhedra."""
    mesher = simple.CartesianMesher(Input=simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl")), CellSize=8)
    plane = simple.Slice(Input=mesher, SliceType="Plane")
    plane.SliceType.Origin, plane.SliceType.Normal = [0, 100, 0], [0, 1, 0]
    parts = []
    for number, source in enumerate((plane, simple.SlicePolyhedra(Input=mesher, Origin=[0, 100, 0], Normal=[0, 1, 0]))):
        view = simple.CreateView("RenderView")
        display = show(source, view, "Region")
        display.ColorArrayName = ["CELLS", ""]
        display.SetScalarBarVisibility(view, False)
        display.DiffuseColor, display.LineWidth = [0.75, 0.85, 0.95], 2
        parts.append(folder / f"{number}.png")
        close_up(parts[-1], view, CUT, 300, 24)
    joined("slices.png", parts)


def draw_rims(folder):
    """A section across the edge of a thin plate in a flow: cells as the grid cuts them, and as they are meshed."""
    plate = simple.Box(XLength=1.5, YLength=1.2, ZLength=0.012)
    turned = simple.Transform(Input=simple.Triangulate(Input=plate), Transform="Transform")
    turned.Transform.Rotate = [25, 20, 10]
    as_cut = {"CollapseRatio": 0, "OptimiseNodes": 0, "SplitConcaveCells": 0, "SmallCells": "Remove", "PatchMethod": "Exact Fit"}
    parts = []
    for number, options in enumerate((as_cut, {})):
        mesher = simple.CartesianMesher(Input=turned, Domain="Outside", BoxFrom="Bounds", DomainBounds=[-1.5, 1.5] * 3,
                                        CellSize=0.15, BoxesAlongBody=0, **options)
        view = simple.CreateView("RenderView")
        section = simple.SlicePolyhedra(Input=mesher, Origin=[0, 0, 0], Normal=[0, 1, 0])
        filled = simple.Show(simple.Triangulate(Input=section), view)  # concave polygons
        filled.ColorArrayName, filled.DiffuseColor, filled.Ambient = ["CELLS", ""], [0.75, 0.85, 0.95], 0.25
        edges = simple.Show(simple.ExtractEdges(Input=section), view)
        edges.ColorArrayName, edges.DiffuseColor, edges.LineWidth = ["CELLS", ""], [0.3, 0.3, 0.3], 2
        edges.Position = [0, -0.005, 0]  # before it
        parts.append(folder / f"{number}.png")
        close_up(parts[-1], view, RIM, 3, 0.2)
    joined("rims.png", parts)


def draw_gaps(folder):
    car = simple.NamedOBJReader(FileName=str(DATA / "prius_hybrid_body.obj"))
    colours = {"Hybrid": [0.6, 0.75, 0.9], "Hybrid_Windows": [0.85, 0.9, 0.6], "Hybrid_Interior": [0.85, 0.6, 0.85]}
    parts = []
    for width in 0, 200:
        mesher = simple.CartesianMesher(Input=car, Domain="Outside", FlowDirection="Plus Y", Ground="zMin", CellSize=150, CloseGaps=width)
        data = output(mesher).GetFieldData()
        view = simple.CreateView("RenderView")
        for i in range(data.GetArray("BoundaryIds").GetNumberOfTuples()):
            name, number = data.GetAbstractArray("BoundaryNames").GetValue(i), data.GetArray("BoundaryIds").GetValue(i)
            if name in colours or name.startswith("gap_"):
                one = simple.Threshold(Input=simple.OutputPort(mesher, "Boundary"), Scalars=["CELLS", "BoundaryId"],
                                       LowerThreshold=number - 0.1, UpperThreshold=number + 0.1)
                if output(one).GetNumberOfCells():
                    display = show(one, view, "BoundaryId")
                    simple.ColorBy(display, None)
                    display.DiffuseColor = colours.get(name, [0.95, 0.55, 0.25])
        parts.append(folder / f"{width}.png")
        picture(parts[-1], view, [0.8, -0.9, 0.5], 1.3, [560, 400])
    joined("gaps.png", parts)


def row_of_houses():
    """Five boxes on the ground, each beside the one before."""
    points, polygons, x = [], [], 0
    for i in range(5):
        width, depth, height, first = 5 + i * 7 % 5, 8 + i * 3 % 5, 6 + i * 5 % 7, len(points)
        points += [[x + width * (k & 1), depth * (k >> 1 & 1), height * (k >> 2)] for k in range(8)]
        polygons += [[first + k for k in side] for side in
                     ([0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6])]
        x += width + 0.2 * (1 + i % 3)
    return producer(polydata(points, polygons))


def draw_houses(folder):
    parts = []
    for width in 0, 1:
        mesher = simple.CartesianMesher(Input=row_of_houses(), Domain="Outside", BoxFrom="Bounds", DomainBounds=[-20, 60, -20, 30, 0, 30],
                                        Ground="zMin", CellSize=1, CloseGaps=width)
        data = output(mesher).GetFieldData()
        view = simple.CreateView("RenderView")
        for i in range(data.GetArray("BoundaryIds").GetNumberOfTuples()):
            name, number = data.GetAbstractArray("BoundaryNames").GetValue(i), data.GetArray("BoundaryIds").GetValue(i)
            if name == "boundary_0" or name.startswith("gap_"):
                display = show(simple.Threshold(Input=simple.OutputPort(mesher, "Boundary"), Scalars=["CELLS", "BoundaryId"],
                                                LowerThreshold=number - 0.1, UpperThreshold=number + 0.1), view, "BoundaryId")
                simple.ColorBy(display, None)
                display.DiffuseColor = [0.6, 0.75, 0.9] if name == "boundary_0" else [0.95, 0.55, 0.25]
        parts.append(folder / f"{width}.png")
        picture(parts[-1], view, [-0.2, -1, 0.8], 2, [560, 300])
    joined("houses.png", parts)


def draw_terrain(_):
    """The page's mesh, cut open behind the house."""
    names = {}
    example = next(text for text in blocks(HELP / "domain.md", "python") if "Calculator" in text)
    exec(example, names)
    view = simple.CreateView("RenderView")
    walls = show(simple.Threshold(Input=simple.OutputPort(names["air"], "Boundary"), Scalars=["CELLS", "BoundaryId"],
                                  LowerThreshold=-0.1, UpperThreshold=1.1), view, "BoundaryId")
    walls.SetScalarBarVisibility(view, False)
    section = simple.Show(simple.SlicePolyhedra(Input=names["air"], Origin=[0, 6.01, 0], Normal=[0, 1, 0]), view)
    section.Representation, section.EdgeColor, section.Ambient = "Surface With Edges", [0.3, 0.3, 0.3], 0.25
    section.ColorArrayName, section.DiffuseColor = ["CELLS", ""], [0.85, 0.9, 0.97]
    simple.GetColorTransferFunction("BoundaryId").RGBPoints = [0, 0.75, 0.85, 0.6, 1, 0.95, 0.6, 0.4]
    picture("terrain.png", view, [0.5, -1, 0.6], 1.25)


def stratum(low, high):
    """Between two fields of heights, each with as many lines as it likes."""
    points, polygons = [], []
    for heights, up in (low, False), (high, True):
        count, first = len(heights), len(points)
        points += [[2 * i / (count - 1), j / (count - 1), heights[i, j]] for i in range(count) for j in range(count)]
        for i in range(count - 1):
            for j in range(count - 1):
                a, b, c, d = (first + i * count + j for i, j in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
                polygons += [[a, b, c], [a, c, d]] if up else [[a, c, b], [a, d, c]]
    below, above = len(low), len(high)
    at = [lambda i, j: i * below + j, lambda i, j: below * below + i * above + j]
    for side in range(4):
        lines = [[at[k](*((i, 0), (n - 1, i), (n - 1 - i, n - 1), (0, n - 1 - i))[side]) for i in range(n)]
                 for k, n in enumerate((below, above))]
        polygons.append(lines[0] + lines[1][::-1])
    return simple.Triangulate(Input=producer(polydata(points, polygons)))


def draw_strata(folder):
    """Rough interfaces that do not match: as they are, and the mesh."""
    random = np.random.default_rng(3)
    wave = [(lambda n, k=k: 0.25 * k + 0.05 * np.sin(3 * np.linspace(0, 2, n) + k)[:, None] + np.zeros((n, n))) for k in range(6)]
    rough = [[wave[k](n) + 0.02 * random.uniform(-1, 1, (n, n)) for n in (9 + k, 13 - k)] for k in range(6)]
    names = [f"stratum_{k + 1}" for k in range(5)]
    strata = simple.GroupDatasets(Input=[stratum(rough[k][1], rough[k + 1][0]) for k in range(5)], BlockNames=names)
    mesher = simple.CartesianMesher(Input=strata, RegionsFrom="Blocks", ContactTolerance=0.1, CellSize=0.05)
    view = simple.CreateView("RenderView")
    show_regions(mesher, view, 0.51)
    simple.GetColorTransferFunction("Region").RGBPoints = [1, 0.75, 0.65, 0.5, 2, 0.9, 0.85, 0.65, 3, 0.65, 0.8, 0.9, 4, 0.9, 0.7, 0.5, 5, 0.75, 0.85, 0.6]
    picture("strata.png", view, [0, -1, 0], 1.6, [800, 520])


def draw_flat(folder):
    """The page's plane mesh and wedge."""
    parts = []
    examples = blocks(HELP / "filters.FlatMesh.md", "python")
    for number, (name, example, towards, focus, scale) in enumerate((
            ("flat", examples[0].split("SaveData")[0], [0, 0, 10], [0.3, 0, 0], 1.1), ("wedge", examples[2], [-3, -4, 10], [0, 0.5, 0], 1.1))):
        names = {}
        exec(example, names)
        view = simple.CreateView("RenderView")
        display = show(names[name], view, "CellId")
        simple.ColorBy(display, None)
        display.DiffuseColor, display.LineWidth = [0.75, 0.85, 0.95], 1.5
        parts.append(folder / f"{number}.png")
        picture(parts[-1], view, towards, 1, [560, 400])
        camera = simple.GetActiveCamera()
        camera.SetFocalPoint(*focus)
        camera.SetPosition(*(focus[i] + towards[i] for i in range(3)))
        camera.SetViewUp(0, 1, 0)
        view.CameraParallelProjection, view.CameraParallelScale = 1, scale
        simple.SaveScreenshot(str(parts[-1]), view)
    joined("flat.png", parts)


def draw_periodic(_):
    """The page's spheres, and a side of either pair."""
    names = {}
    exec(blocks(HELP / "filters.PeriodicBoundaries.md", "python")[0].split("SaveData")[0], names)
    view = simple.CreateView("RenderView")
    faces = simple.ExtractSurface(Input=names["both"])
    shown = [(simple.Threshold(Input=simple.Calculator(Input=faces, Function=function, ResultArrayName="value"), Scalars=["POINTS", "value"],
                               LowerThreshold=low, UpperThreshold=high), colour)
             for function, low, high, colour in (("coordsX", -1, 1e-6, [0.75, 0.85, 0.95]), ("coordsY", 1 - 1e-6, 2, [0.8, 0.9, 0.8]))]
    wall = simple.Threshold(Input=simple.OutputPort(names["mesher"], "Boundary"), Scalars=["CELLS", "BoundaryId"], LowerThreshold=-0.1,
                            UpperThreshold=0.1)
    for source, colour in (*shown, (wall, [0.95, 0.8, 0.55])):
        display = show(source, view, "CellId" if source is not wall else "BoundaryId")
        simple.ColorBy(display, None)
        display.DiffuseColor = colour
    picture("periodic.png", view, [2, -2.5, 1.5], 1.3, [800, 520])


def draw_zone(_):
    """The page's rotor, cut open."""
    names = {}
    example = next(text for text in blocks(HELP / "regions.md", "python") if "rotor = " in text)
    exec(example.split("SaveData")[0], names)
    view = simple.CreateView("RenderView")
    show_regions(names["mesher"], view, 0.0101)
    simple.GetColorTransferFunction("Region").RGBPoints = [1, 0.75, 0.85, 0.95, 2, 0.95, 0.8, 0.55]
    picture("zone.png", view, [0, -1, 0], 2.2, [800, 520])


def draw_cad(_):
    """A section of the page's regions."""
    names = {}
    os.chdir(REPOSITORY)
    exec(blocks(HELP / "cad.md", "python")[0].split("SaveData")[0], names)
    view = simple.CreateView("RenderView")
    section = simple.SlicePolyhedra(Input=names["mesher"], Origin=[0, 0, 0.0501], Normal=[0, 0, 1])
    display = show(section, view, "Region")
    display.Representation = "Surface"
    display.SetScalarBarVisibility(view, False)
    edges = simple.Show(simple.ExtractEdges(Input=section), view)
    edges.ColorArrayName, edges.DiffuseColor, edges.LineWidth = ["CELLS", ""], [0.3, 0.3, 0.3], 1.5
    simple.GetColorTransferFunction("Region").RGBPoints = [1, 0.55, 0.75, 0.95, 2, 0.85, 0.85, 0.85, 3, 0.95, 0.7, 0.45]
    picture("cadmesh.png", view, [0, -1e-3, 1], 1.3, [560, 560])


RIM = [0.72, 0, -0.3]  # of the plate
CUT = [51, 100, -3]  # in the middle of a tube of the header

DRAWN = {"task": draw_task, "flow": draw_flow, "layers": draw_layers, "adaptation": draw_adaptation,
         "jacket": draw_jacket, "regions": draw_regions, "cad": draw_cad, "slices": draw_slices,
         "rims": draw_rims, "gaps": draw_gaps, "houses": draw_houses, "strata": draw_strata, "flat": draw_flat, "periodic": draw_periodic, "zone": draw_zone, "terrain": draw_terrain}
for name in sys.argv[3:] or DRAWN:
    with tempfile.TemporaryDirectory() as folder:
        DRAWN[name](pathlib.Path(folder))
