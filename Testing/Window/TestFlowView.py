"""The first picture of external flow: the body fills the view, upright, seen from upstream; the sides of the box are invisible, the
ground is not; cells are seen in the middle plane; defects are hidden without a legend until they are asked for, then coloured by name."""

import json
import pathlib
import sys

import numpy as np

from events import apply, choose, macro, meshing_menu, number, open_file, script
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "prius_hybrid_body.obj"
NOTE = """
import json
from paraview import simple
view = simple.GetActiveView()
mesher = simple.FindSource("CartesianMesher1")
defects = simple.GetRepresentation(simple.OutputPort(mesher, 2), view)
boundary = simple.GetRepresentation(simple.OutputPort(mesher, 1), view)
colours = boundary.LookupTable
note = {
    "up": list(view.CameraViewUp), "position": list(view.CameraPosition), "focus": list(view.CameraFocalPoint), "angle": view.CameraViewAngle,
    "defects": [defects.Visibility, defects.ColorArrayName[1] or ""],
    "legends": [bar.Title for bar in view.Representations if bar.SMProxy.GetXMLName() == "ScalarBarWidgetRepresentation" and bar.Visibility],
    "slice": [simple.GetRepresentation(simple.FindSource("MiddleSlice"), view).Visibility, list(simple.FindSource("MiddleSlice").Normal)],
    "active": simple.GetActiveSource() == mesher,
    "opacity": dict(zip(colours.Annotations[::2], colours.IndexedOpacities)),
}
open("FOLDER/notes.txt", "a").write(json.dumps(note) + "\\n")
"""
SHOW = """
from paraview import simple
simple.Show(simple.OutputPort(simple.FindSource("CartesianMesher1"), 2), simple.GetActiveView())
"""
BODY = np.array([[-100.6, -226.9, 14.5], [100.6, 234.9, 153.0]])

with Screen() as screen:
    for name, text in ("note", NOTE), ("show", SHOW):
        screen.add_macro(name, text.replace("FOLDER", str(screen.folder)))
    said = screen.play(script(open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher"), choose("Domain", "Outside"),
        choose("FlowDirection", "Plus Y"), choose("Ground", "zMin"), number("CellSize", 150), apply(), macro("note"),
        macro("show"), macro("note")))
    assert "ERR|" not in said and "Traceback" not in said, said[-3000:]
    first, shown = (json.loads(line) for line in (screen.folder / "notes.txt").read_text().splitlines())
    assert first["up"] == [0, 0, 1] and np.allclose(first["focus"], BODY.mean(axis=0), atol=1), first
    away = np.array(first["position"]) - first["focus"]
    assert away[1] < 0 and away[2] > 0, "upstream, from above"
    half = np.linalg.norm(BODY[1] - BODY[0]) / 2
    assert 0.5 < half / (np.linalg.norm(away) * np.sin(np.radians(first["angle"] / 2))) < 1.2, "the body fills the view"
    assert first["slice"] == [1, [1, 0, 0]] and first["active"], "the panel stays the mesher's"
    opacity = first["opacity"]
    assert opacity["inlet"] == opacity["outlet"] == opacity["sides"] == 0 and opacity["ground"] == opacity["Hybrid"] == 1, opacity
    assert first["defects"] == [0, ""] and "DefectName" not in str(first["legends"]).replace(" ", ""), first
    assert shown["defects"] == [1, "DefectName"], shown
