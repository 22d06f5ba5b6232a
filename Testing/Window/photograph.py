"""pvpython photograph.py REPOSITORY: makes the pictures of the window in the help pages."""

import pathlib
import sys

from paraview import simple

from events import advanced, apply, boundary_row, copy_selection, event, look, meshing_menu, number, open_file, script, \
    select_cells, table_row, text
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

with Screen(1400, 3700) as screen:
    screen.photograph(script(*BEGIN, advanced(), table_row("RefinementBlocks", 0, [0, 4, 0, 9, 2, 2, 3, 1]),
        table_row("BoundaryRefinement", 0, [1, 2, 1, 0]), table_row("BoundaryRefinement", 1, [2, 2, 1, 0]),
        boundary_row(0, "inlet_1", "patch", 1e-100), boundary_row(1, "outlet_1", "patch", 1e-100),
        event("pqClientMainWindow/pipelineBrowserDock/qt_dockwidget_closebutton", "activate")), HELP / "panel.png", **PANEL)
