"""One Apply makes one mesh, whatever has changed: several values with a preview in the view, a summary of the mesh beside it, and a
box around the body."""

import pathlib
import re
import sys

from events import PROPERTIES, apply, choose, event, macro, meshing_menu, number, open_file, script
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "tm_7_8ths_cube.stl"
# ParaView logs each run of a filter: a marker before each Apply divides them.
MARK = """
import os
os.write(2, b"MARK\\n")
"""
SELECT = """
from paraview import simple
simple.SetActiveSource(simple.FindSource("CartesianMesher1"))
"""


def layers(count):
    return event(f"{PROPERTIES}/Layers/IntRangeWidget/LineEdit", "set_string", count)


with Screen() as screen:
    screen.variables["PARAVIEW_LOG_EXECUTION_VERBOSITY"] = "INFO"
    screen.add_macro("mark", MARK)
    screen.add_macro("select", SELECT)
    mark = macro("mark")
    said = screen.play(script(open_file(SURFACE), apply(), meshing_menu("CartesianMesher"), number("CellSize", 20), layers(1),
        mark, apply(), number("CellSize", 15), layers(2), choose("RegionsFrom", "Blocks"),
        mark, apply(), meshing_menu("MeshSummary"), apply(), macro("select"), number("CellSize", 18), layers(1),
        mark, apply(), choose("Domain", "Outside"), choose("BoxFrom", "Bounds"), number("CellSize", 100), layers(0),
        mark, apply(), mark))
    runs = [len(re.findall(r"\{ CartesianMesher1: execute", part)) for part in said.split("MARK")[1:-1]]
    assert runs == [1, 1, 1, 1], runs
