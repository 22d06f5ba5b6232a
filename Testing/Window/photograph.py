"""pvpython photograph.py REPOSITORY: makes the pictures of the window in the help pages."""

import pathlib
import sys

from paraview import simple

from events import PANEL as WHOLE_PANEL
from events import PROPERTIES, advanced, apply, boundary, boundary_row, choose, copy_selection, event, look, macro, meshing_menu, number, \
    open_file, script, select_boundaries, select_cells, table_row, text
from window import Screen

REPOSITORY = pathlib.Path(sys.argv[1])
HELP = REPOSITORY / "Plugin" / "Help"
SURFACE = REPOSITORY / "Data" / "kcl_exhaust_header_lumens.stl"
BEGIN = [open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher")]
PANEL = {"rows": slice(172, 3040), "columns": slice(296)}

with Screen(1400, 900) as screen:
    screen.photograph(script(*BEGIN, number("CellSize", 12), apply(),
        look("PositiveX")), HELP / "window.png")

# The same surface without names, divided; and with one end picked.
with Screen(1400, 900) as screen:
    plain = screen.folder / "header.stl"
    simple.SaveData(str(plain), proxy=simple.PassArrays(Input=simple.OpenDataFile(str(SURFACE)), CellDataArrays=[],
        PointDataArrays=[], FieldDataArrays=[]))
    split = [open_file(plain), apply(), meshing_menu("SplitSurface"), apply(), look("NegativeY")]
    screen.photograph(script(*split), HELP / "split.png")
    screen.photograph(script(*split, select_cells(0.53, 0.67), copy_selection(), text("SelectionName", "inlet"), apply()),
        HELP / "splitpick.png")

# The surface's boundaries in the panel: four rows are selected and lit, and a pattern below refines walls.
with Screen(1400, 900) as screen:
    screen.photograph(script(*BEGIN, number("CellSize", 12), event("pqClientMainWindow/pipelineBrowserDock/qt_dockwidget_closebutton", "activate"),
        event(f"{WHOLE_PANEL}/SearchBox/SearchLineEdit", "set_string", "Boundar"), boundary(12, 0, "wall_*"), boundary(12, 6, 1),
        select_boundaries((1, 2), (4, 5)), boundary(1, 3, "patch"), look("NegativeY")), HELP / "patchlist.png")

# Solids of a STEP file, glued.
OBLIQUE = """
from paraview import simple
view = simple.GetActiveView()
view.CameraViewUp, view.CameraFocalPoint, view.CameraPosition = [0, 1, 0], [0, 0, 0.05], [0.1, 0.08, 0.15]
simple.ResetCamera(view)
simple.GetActiveCamera().Zoom(1.3)
simple.Render(view)
"""
with Screen(1400, 1050) as screen:
    screen.add_macro("oblique", OBLIQUE)
    screen.photograph(
        script(open_file(REPOSITORY / "Data" / "heated_pipe.step"), apply(), macro("oblique")), HELP / "cad.png")

# A car in its flow domain, not applied yet.
CAMERA = """
from paraview import simple
view = simple.GetActiveView()
view.CameraViewUp, view.CameraFocalPoint, view.CameraPosition = [0, 0, 1], [0, 0, 0], [1.3, -0.6, 0.5]
simple.ResetCamera(view)
simple.GetActiveCamera().Zoom(1.4)
simple.Render(view)
"""
with Screen(1400, 1000) as screen:
    screen.add_macro("camera", CAMERA)
    screen.photograph(script(open_file(REPOSITORY / "Data" / "prius_hybrid_body.obj", choose_reader=True), apply(),
        meshing_menu("CartesianMesher"), event(f"{PROPERTIES}/LargestDepth/IntRangeWidget/LineEdit", "set_string", 6),
        event(f"{PROPERTIES}/CurvatureAngle/DoubleRangeWidget/DoubleLineEdit", "set_string", 15), choose("Domain", "Outside"),
        choose("FlowDirection", "Plus Y"), choose("Ground", "zMin"), *[number(f"Lengths{side}", length) for side, length in
            (("Before", 1.5), ("Behind", 3), ("Beside", 1))], macro("camera")), HELP / "look.png")

STRICT = """
from paraview import simple
quality = simple.FindSource("FiniteVolumeQuality1")
quality.NonOrthogonalityLimit = 40
simple.SetActiveSource(quality)
"""

with Screen(1400, 900) as screen:
    screen.add_macro("strict", STRICT)
    screen.photograph(script(*BEGIN, number("CellSize", 12), apply(), meshing_menu("FiniteVolumeQuality"), apply(), macro("strict"),
        event(f"{PROPERTIES}/ShowFailingCells/Button", "activate")), HELP / "quality.png")
    screen.photograph(script(*BEGIN, number("CellSize", 12), apply(), meshing_menu("QualityHistogram"), apply()), HELP / "histogram.png")

with Screen(1400, 3700) as screen:
    screen.photograph(script(*BEGIN, advanced(), table_row("RefinementBlocks", 0, [0, 4, 0, 9, 2, 2, 3, 1]),
        table_row("BoundaryRefinement", 0, [1, 2, 1, 0]), table_row("BoundaryRefinement", 1, [2, 2, 1, 0]),
        boundary_row(1, "patch", 1e-100), boundary_row(2, "patch", 1e-100),
        event("pqClientMainWindow/pipelineBrowserDock/qt_dockwidget_closebutton", "activate")), HELP / "panel.png", **PANEL)
