"""Legends have titles in words, forget names of boundaries that nothing has any more, have one label for one value, and lie apart."""

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
THREE = """
from paraview import simple
view, mesh = simple.GetActiveView(), simple.OutputPort(simple.FindSource("CartesianMesher1"), 0)
for source, array in (simple.FindSource("SplitSurface1"), ("CELLS", "BoundaryName")), (mesh, ("CELLS", "RefinementLevel")), \\
        (simple.Elevation(Input=mesh), ("POINTS", "Elevation")):
    shown = simple.Show(source, view)
    simple.ColorBy(shown, array)
    shown.SetScalarBarVisibility(view, True)
"""
CORNERS = """
from paraview import simple
places = [shown.WindowLocation for shown in simple.GetActiveView().Representations
    if "WindowLocation" in shown.ListProperties() and shown.Visibility]
labels = simple.GetScalarBar(simple.GetColorTransferFunction("RefinementLevel"), simple.GetActiveView()).CustomLabels
open("FOLDER/notes.txt", "a").write(repr((places, list(labels))) + "\\n")
"""

with Screen() as screen:
    for name, text_of in ("note", NOTE), ("three", THREE), ("corners", CORNERS):
        screen.add_macro(name, text_of.replace("FOLDER", str(screen.folder)))
    note = macro("note")
    said = screen.play(script(open_file(SURFACE), apply(), meshing_menu("SplitSurface"), apply(), note,
        text("CapNames", "outlet, inlet"), apply(), note, meshing_menu("CartesianMesher"), number("CellSize", 20), apply(), note,
        meshing_menu("MeshSummary"), apply(), macro("three"), macro("corners")))
    assert "ERR|" not in said and "Traceback" not in said, said[-3000:]
    split, named, meshed, (places, labels) = map(eval, (screen.folder / "notes.txt").read_text().splitlines())
    assert split[0] == named[0] == meshed[0] == ["Boundary"], (split, named, meshed)
    assert set(split[1]) == {"cap_1", "cap_2", "cap_3", "wall"} and set(named[1]) == {"outlet", "inlet_1", "inlet_2", "wall"}, (split, named)
    assert np.allclose(named[1]["wall"], split[1]["wall"], atol=1e-3), "colours stay"
    assert meshed[1] == named[1] and len({tuple(np.round(colour, 2)) for colour in named[1].values()}) == 4, "and all differ"
    assert len(places) == len(set(places)) == 4 and labels == [0], (places, labels)
