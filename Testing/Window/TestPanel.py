"""What the panel says: an unset Boundary Array has a text, Expected Boxes have a tooltip, follow what is typed before it is
applied, with one row until then, and are there after Load State, Keep Points and what layers have show where they count,
a row of Refinement Shapes has fields and a box with handles in the view, which cannot be turned, and the menu Meshing begins with
what a user needs."""

import pathlib
import sys

from events import PROPERTIES, apply, check, choose, event, macro, meshing_menu, number, open_file, script
from paraview import servermanager, simple  # noqa: F401: connects
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "tm_7_8ths_cube.stl"
SAVE = """
from paraview import simple
simple.SaveState("{folder}/state.pvsm")
"""
SELECT = """
from paraview import simple
simple.SetActiveSource(simple.FindSource("{other}"))
"""
# Without asking for the information anew, as simple.FindSource(...).ExpectedBoxes would.
NOTE = """
from paraview import simple
property = simple.FindSource("CartesianMesher1").SMProxy.GetProperty("ExpectedBoxes")
open("{folder}/notes.txt", "a").write(repr([property.GetElement(i) for i in range(property.GetNumberOfElements())]) + "\\n")
"""

SHAPES = """
from paraview import simple
mesher = simple.FindSource("CartesianMesher1")
shapes = [list(mesher.GetPropertyValue("Refinement" + name)) for name in ("Shapes", "Positions", "Lengths", "ShapeDepths")]
open("{folder}/shapes.txt", "w").write(repr(shapes))
hidden = simple.GetActiveView().SMProxy.GetProperty("HiddenRepresentations")
widgets = [hidden.GetProxy(i) for i in range(hidden.GetNumberOfProxies()) if hidden.GetProxy(i).GetXMLName().startswith("BoxWidget")]
open("{folder}/widgets.txt", "w").write(repr([
    [widget.GetProperty(name).GetElement(0) for name in ("Visibility", "Enabled", "RotationEnabled", "TranslationEnabled")]
    for widget in widgets]))
"""
MESHED = """
from paraview import simple
bodies = [simple.Triangulate(Input=simple.Box(Center=[i, 0, 0])) for i in range({bodies})]
mesher = simple.CartesianMesher(Input=simple.GroupDatasets(Input=bodies), CellSize=0.25, RegionsFrom="Blocks")
mesher.UpdatePipeline()
simple.SetActiveSource(mesher)
"""
DIALOG = "pqClientMainWindow/WriterSettingsDialog"
ONE, TWO = (MESHED.replace("{bodies}", str(bodies)) for bodies in (1, 2))
# By a macro: events cannot tell this table from Boundaries, which has a widget of the same name.
ROW = """
from paraview import simple
mesher = simple.FindSource("CartesianMesher1")
mesher.RefinementShapes, mesher.RefinementPositions, mesher.RefinementLengths = ["cylinderX"], [0, 0, 0], [9, 1, 1]
mesher.RefinementShapeDepths = [1]
"""


expected = servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy("filters", "CartesianMesher").GetProperty("ExpectedBoxes")
told = " ".join(expected.GetDocumentation().GetDescription().split())

def whole(text):
    return int(text.replace(",", ""))


def layers(count):
    return event(f"{PROPERTIES}/Layers/IntRangeWidget/LineEdit", "set_string", count)


def tip(text):
    """As a version of ParaView writes it."""
    return f"<html><head/><body><table width='500'><tr><td>{text}</td></tr></table></body></html>" \
        if simple.GetParaViewVersion() >= 6 else f"<html><head/><body><p align=\"justify\">{text}</p></body></html>"


with Screen() as screen:
    for name, text in (("save", SAVE), ("note", NOTE), ("surface", SELECT.replace("{other}", SURFACE.name)),
            ("mesher", SELECT.replace("{other}", "CartesianMesher1")), ("row", ROW), ("shapes", SHAPES)):
        screen.add_macro(name, text.replace("{folder}", str(screen.folder)))
    screen.play(script(open_file(SURFACE), apply(), meshing_menu("CartesianMesher"),
        check(f"{PROPERTIES}/BoundaryArray/ComboBox", "currentText", "Automatic"),
        check(f"{PROPERTIES}/ExpectedBoxes", "toolTip", tip(told)),
        check(f"{PROPERTIES}/KeepPoints", "visible", "false"), check(f"{PROPERTIES}/KeepOut", "visible", "false"), check(f"{PROPERTIES}/FirstLayerThickness", "visible", "false"),
        macro("note"), number("CellSize", 2), macro("note"), layers(3), macro("note"), choose("Domain", "Outside"), macro("note"),
        check(f"{PROPERTIES}/KeepPoints", "visible", "true"), check(f"{PROPERTIES}/KeepOut", "visible", "true"), check(f"{PROPERTIES}/FirstLayerThickness", "visible", "true"),
        choose("Domain", "Inside"), layers(0), number("CellSize", 0), macro("note"),
        apply(), macro("note"), macro("save"), number("CellSize", 2), macro("note"), apply(), macro("note"),
        macro("row"), apply(), macro("shapes")))
    shapes = eval((screen.folder / "shapes.txt").read_text())
    assert shapes == [["cylinderX"], [0, 0, 0], [9, 1, 1], [1]], shapes
    assert eval((screen.folder / "widgets.txt").read_text()) == [[1, 1, 0, 1]], (screen.folder / "widgets.txt").read_text()
    screen.play(script(macro("surface"), macro("mesher"), macro("note")), f"--state={screen.folder / 'state.pvsm'}")
    at_first, typed, with_layers, outside, as_before, applied, again, applied_again, loaded = map(eval, (screen.folder / "notes.txt").read_text().splitlines())
    assert at_first == as_before == applied == loaded and "→ " in str(applied), (at_first, as_before, applied, loaded)
    first, other, layered, around = (rows[rows.index(next(text for text in rows if text.startswith("→ "))):][:4]
        for rows in (at_first, typed, with_layers, outside))
    assert other[0] == "→ 2" and first[:2] != other[:2], (first, other)
    assert [len(rows) for rows in (at_first, typed, with_layers, outside, again, applied_again)] == [20, 8, 8, 8, 8, 24], \
        "while values are not applied, there is one row"
    assert typed == again and typed[4:] == applied_again[4:8], (typed, again, applied_again)
    assert layered[:2] == other[:2] and whole(layered[2]) > 1.5 * whole(other[2]), (other, layered)
    assert around[0] == "→ 2" and whole(around[1]) > 10 * whole(layered[1]), (layered, around)

    # The writer of OpenFOAM cases asks about regions where there are several.
    for make, several in (ONE, "false"), (TWO, "true"):
        screen.add_macro("make", make)
        screen.play(script(macro("make"), event("pqClientMainWindow/menubar/menu_File", "activate", "actionFileSaveData"),
            event("pqClientMainWindow/FileSaveDialog", "filesSelected", screen.folder / "case.foam"),
            *(check(f"{DIALOG}/scrollArea/qt_scrollarea_viewport/Container/ProxyWidget/{name}", "visible", several)
                for name in ("RegionsAs", "ZoneRegions", "ZoneBorders")),
            event(f"{DIALOG}/widget/CancelButton", "activate")))

    # The steps of the mesher are in a menu of their own. (Patcher and Cell Assembler would ask for inputs.)
    screen.play(script(open_file(SURFACE), apply(), meshing_menu("CartesianBoxer", "Meshing in Steps"), apply()))
