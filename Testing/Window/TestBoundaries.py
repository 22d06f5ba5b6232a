"""The table Boundaries: it lists the surface's boundaries before Apply, a value goes to all selected rows, patterns and names
that nothing has are told apart, what is set arrives in the mesh, which one Apply makes once; selected rows are lit in the view, and
a click there, which a drag is not, selects a row; undo, reset and states have the table as they should."""

import json
import pathlib
import re
import sys

from events import BOUNDARIES, PANEL, PROPERTIES, apply, boundary, click, event, look, macro, meshing_menu, number, open_file, redo, script, \
    select_boundaries, shows_boundary, undo
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "kcl_exhaust_header_lumens.stl"
TYPE, DEPTH = 3, 6

# What the table has set and what it lights.
NOTE = """
import json
from paraview import simple
mesher = simple.FindSource("CartesianMesher1")
def typed(name):
    property = mesher.SMProxy.GetProperty(name)
    return [property.GetUncheckedElement(i) for i in range(property.GetNumberOfUncheckedElements())]
note = {name: typed("Boundary" + name) for name in ("Names", "Types", "Depths", "MergedNames")}
view = simple.GetActiveView()
hidden = view.SMProxy.GetProperty("HiddenRepresentations")
inputs = [hidden.GetProxy(i).GetProperty("Input") for i in range(hidden.GetNumberOfProxies())]
lit = [input.GetProxy(0) for input in inputs if input and input.GetProxy(0).GetXMLName() == "SurfaceBoundaries"]
note["lit"] = [proxy.GetProperty("Shown").GetElement(i) for proxy in lit for i in range(proxy.GetProperty("Shown").GetNumberOfElements())]
note["triangles"] = sum(proxy.GetDataInformation(0).GetNumberOfCells() for proxy in lit)
note["camera"] = list(view.CameraPosition)
note["sources"] = len(simple.GetSources())
open("FOLDER/notes.txt", "a").write(json.dumps(note) + "\\n")
"""
MADE = """
import json
from paraview import simple
mesh = simple.FindSource("CartesianMesher1").SMProxy.GetClientSideObject().GetOutputDataObject(0)
names, types = (mesh.GetFieldData().GetAbstractArray("Boundary" + name) for name in ("Names", "Types"))
open("FOLDER/made.txt", "w").write(json.dumps({names.GetValue(i): types.GetValue(i) for i in range(names.GetNumberOfValues())}))
"""
SAVE = """
from paraview import simple
simple.SaveState("FOLDER/state.pvsm")
"""
SELECT = """
from paraview import simple
simple.SetActiveSource(simple.FindSource("OTHER"))
"""
DELETE = event(BOUNDARIES, "key", 16777223)
CONTROL = 67108864


with Screen(1000, 800) as screen:
    screen.variables["PARAVIEW_LOG_EXECUTION_VERBOSITY"] = "INFO"
    for name, text in (("note", NOTE), ("made", MADE), ("save", SAVE), ("surface", SELECT.replace("OTHER", SURFACE.name)),
            ("mesher", SELECT.replace("OTHER", "CartesianMesher1"))):
        screen.add_macro(name, text.replace("FOLDER", str(screen.folder)))

    def notes():
        path = screen.folder / "notes.txt"
        lines = path.read_text().splitlines()
        path.unlink()
        return [json.loads(line) for line in lines]

    note = macro("note")
    begin = [open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher"), number("CellSize", 25),
        event(f"{PROPERTIES}/Preview/CheckBox", "set_boolean", "false")]  # TestApply has both

    # In the view: a place of outlet_1, another with Control, a drag, a place beside the part; rows; another source.
    # Then several rows, a pattern, one mesh, an own value besides a pattern; reset, undo.
    said = screen.play(script(*begin, look("NegativeY"), click(.635, .78), note, click(.55, .78, modifiers=CONTROL), note,
        click(.635, .78, to=(.7, .7)), note, click(.05, .05), note, select_boundaries((0, 0)), note, macro("surface"), note, macro("mesher"),
        shows_boundary(0, 0, "wall_1"), shows_boundary(0, 1, "6.68e+04"), shows_boundary(0, 2, 1606),
        shows_boundary(2, 0, "outlet_1"), shows_boundary(2, TYPE, "automatic"), shows_boundary(12, 0, ""),
        boundary(2, TYPE, "patch"), boundary(2, TYPE, "automatic"), note,
        select_boundaries((1, 2), (4, 5)), boundary(4, TYPE, "patch"), note,
        boundary(12, 0, "wall_*"), boundary(12, DEPTH, 1), shows_boundary(0, DEPTH, 1), shows_boundary(1, DEPTH, ""), note,
        apply(), macro("made"), macro("save"), boundary(0, DEPTH, 0), note, event(f"{PANEL}/Reset", "activate"), note,
        select_boundaries((1, 1)), DELETE, apply(), undo(), shows_boundary(1, TYPE, "patch"), redo(), shows_boundary(1, TYPE, "automatic"),
        note))  # ParaView 5.13 undoes nothing after a macro
    assert "ERR|" not in said and "Traceback" not in said, said
    one, two, dragged, none, row, elsewhere, untouched, several, pattern, own, reset, redone = notes()
    assert one["lit"] == ["outlet_1"] and one["triangles"] == 2 * 19, one
    assert two["lit"] == dragged["lit"] == ["outlet_1", "outlet_2"] and two["camera"] == one["camera"] != dragged["camera"], (two, dragged)
    assert none["lit"] == elsewhere["lit"] == [] and row["lit"] == ["wall_1"] and row["triangles"] == 2 * 1606, (none, row, elsewhere)
    assert untouched["Names"] == [] and untouched["sources"] == 2, untouched
    assert several["Names"] == ["inlet_1", "outlet_1", "inlet_2", "outlet_2"] and several["Types"] == ["patch"] * 4, several
    assert several["Depths"] == [] and several["lit"] == several["Names"] and several["triangles"] == 2 * 4 * 19, several
    assert pattern["Names"][4:] == ["wall_*"] and pattern["Depths"] == [-1] * 4 + [1], pattern
    assert own["Names"][4:] == ["wall_*", "wall_1"] and own["Depths"] == [-1] * 4 + [1, 0], own
    assert reset["Names"] == pattern["Names"], reset
    assert redone["Names"] == ["outlet_1", "inlet_2", "outlet_2", "wall_*"], redone
    made = json.loads((screen.folder / "made.txt").read_text())
    assert made["inlet_1"] == made["outlet_2"] == "patch" and made["inlet_3"] != "patch", made
    assert len(re.findall(r"\{ CartesianMesher1: execute", said)) == 4, "one mesh for each Apply, undo and redo"

    # A state.
    said = screen.play(script(macro("surface"), macro("mesher"), shows_boundary(1, TYPE, "patch"), shows_boundary(12, 0, "wall_*"),
        shows_boundary(0, DEPTH, 1)), f"--state={screen.folder / 'state.pvsm'}")
    assert "ERR|" not in said, said
