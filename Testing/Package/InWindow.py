"""ParaView's window with the installed package, which it loads by itself: a surface is opened and meshed by the menus, and
the screen photographed. Run by Debian's Python: InWindow.py REPOSITORY PICTURE."""

import pathlib
import sys

REPOSITORY = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(REPOSITORY / "Testing" / "Window"))
from events import apply, macro, meshing_menu, number, open_file, script  # noqa: E402
from window import Screen  # noqa: E402

SURFACE = REPOSITORY / "Data" / "kcl_exhaust_header_lumens.stl"
NOTE = """
from paraview import simple
mesher = simple.FindSource("CartesianMesher1")
open("{folder}/cells.txt", "w").write(str(simple.OutputPort(mesher, 0).GetDataInformation().GetNumberOfCells()))
"""

with Screen() as screen:
    screen.add_macro("note", NOTE.replace("{folder}", str(screen.folder)))
    screen.photograph(script(open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher"),
        number("CellSize", 10), apply(), macro("note")), sys.argv[2], timeout=240)
    assert "ERR|" not in screen.said(), screen.said()
    cells = int((screen.folder / "cells.txt").read_text())
    assert cells > 1000, cells
    print(f"{cells} cells")
