"""pvpython photograph.py REPOSITORY: makes the pictures of the window in the help pages."""

import pathlib
import sys

from events import PROPERTIES, advanced, apply, boundary_row, event, look_along_x, macro, meshing_menu, number, open_file, script, table_row
from window import Screen

REPOSITORY = pathlib.Path(sys.argv[1])
HELP = REPOSITORY / "Plugin" / "Help"
SURFACE = REPOSITORY / "Data" / "kcl_exhaust_header_lumens.stl"
BEGIN = [open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher")]
PANEL = {"rows": slice(172, 3040), "columns": slice(296)}

with Screen(1400, 900) as screen:
    screen.photograph(script(*BEGIN, number("CellSize", 12), apply(),
        look_along_x()), HELP / "window.png")

STRICT = """
from paraview import simple
quality = simple.FindSource("FiniteVolumeQuality1")
quality.NonOrthogonalityLimit = 40
simple.SetActiveSource(quality)
"""

with Screen(1400, 900) as screen:
    screen.add_macro("strict", STRICT)
    screen.photograph(script(*BEGIN, number("CellSize", 12), apply(), meshing_menu("FiniteVolumeQuality"), apply(), macro("strict"),
        event(f"{PROPERTIES}/ShowFailingCells/1QPushButton0", "activate")), HELP / "quality.png")
    screen.photograph(script(*BEGIN, number("CellSize", 12), apply(), meshing_menu("QualityHistogram"), apply()), HELP / "histogram.png")

with Screen(1400, 3700) as screen:
    screen.photograph(script(*BEGIN, advanced(), table_row("RefinementBlocks", 0, [0, 4, 0, 9, 2, 2, 3, 1]),
        table_row("BoundaryRefinement", 0, [1, 2, 1, 0]), table_row("BoundaryRefinement", 1, [2, 2, 1, 0]),
        boundary_row(0, "inlet_1", "patch", 1e-100), boundary_row(1, "outlet_1", "patch", 1e-100),
        event("pqClientMainWindow/pipelineBrowserDock/qt_dockwidget_closebutton", "activate")), HELP / "panel.png", **PANEL)
