"""The ? button of the panel opens the filter's page in ParaView's Help."""

import pathlib
import sys

from events import PANEL, apply, event, meshing_menu, open_file, script
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "tm_7_8ths_cube.stl"
PAGE = "pqClientMainWindow/pqHelpWindow/1QTextBrowser0"

with Screen() as screen:
    screen.play(script(open_file(SURFACE), apply(), meshing_menu("CartesianMesher"), event(f"{PANEL}/Help", "activate"),
        f'<pqcheck object="{PAGE}" property="documentTitle" arguments="Cartesian Mesher"/>'))
