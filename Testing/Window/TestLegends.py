"""Legends have titles in words, and forget names of boundaries that nothing has any more."""

import pathlib
import sys

import numpy as np

from events import apply, macro, meshing_menu, number, open_file, script, text
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "tm_7_8ths_cube.stl"
NOTE = """
from paraview import simple
view = simple.GetActiveView()
titles = [bar.Title for bar in view.Representations if bar.SMProxy.GetXMLName() == "ScalarBarWidgetRepresentation" and bar.Visibility]
names = list(simple.GetColorTransferFunction("BoundaryName").Annotations)[::2]
colours = simple.GetColorTransferFunction("BoundaryName").IndexedColors
open("FOLDER/notes.txt", "a").write(repr((titles, dict(zip(names, zip(*[iter(colours)] * 3))))) + "\\n")
"""

with Screen() as screen:
    screen.add_macro("note", NOTE.replace("FOLDER", str(screen.folder)))
    note = macro("note")
    said = screen.play(script(open_file(SURFACE), apply(), meshing_menu("SplitSurface"), apply(), note,
        text("CapNames", "outlet, inlet"), apply(), note, meshing_menu("CartesianMesher"), number("CellSize", 20), apply(), note))
    assert "ERR|" not in said and "Traceback" not in said, said[-3000:]
    split, named, meshed = map(eval, (screen.folder / "notes.txt").read_text().splitlines())
    assert split[0] == named[0] == meshed[0] == ["Boundary"], (split, named, meshed)
    assert set(split[1]) == {"cap_1", "cap_2", "cap_3", "wall"} and set(named[1]) == {"outlet", "inlet_1", "inlet_2", "wall"}, (split, named)
    assert np.allclose(named[1]["wall"], split[1]["wall"], atol=1e-3), "colours stay"
    assert meshed[1] == named[1] and len({tuple(np.round(colour, 2)) for colour in named[1].values()}) == 4, "and all differ"
