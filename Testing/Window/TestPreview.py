"""The look before Apply: the hidden sources and representations of a preview are in the view while values are not applied,
follow what is typed, are of the mesh that is made then, and leave the state, undo and the view as they were; the box of the
domain can be dragged; a new row of Refinement Shapes begins at the body."""

import json
import pathlib
import re
import sys

from events import PANEL, PROPERTIES, apply, choose, event, macro, meshing_menu, number, open_file, redo, script, undo
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "prius_hybrid_body.obj"
BODY = [-100.61710357666016, 100.61710357666016, -226.91200256347656, 234.91690063476562, 14.482194900512695, 153.04389953613281]

# What the view has that is nobody's in the pipeline.
NOTE = """
import json
from paraview import simple
view = simple.GetActiveView()
hidden = view.SMProxy.GetProperty("HiddenRepresentations")
hidden = [hidden.GetProxy(i) for i in range(hidden.GetNumberOfProxies())]
previews = [proxy.GetProperty("Input").GetProxy(0) for proxy in hidden if proxy.GetProperty("Input")]
boxes = [proxy for proxy in hidden if proxy.GetXMLName() == "BoxWidgetRepresentation"]
note = {"hidden": sorted(proxy.GetXMLName() for proxy in hidden), "sources": sorted(name for name, _ in simple.GetSources())}
if previews:
    output = previews[0].GetClientSideObject().GetOutputDataObject
    note["sizes"] = [previews[0].GetProperty("BoxSizes").GetElement(i) for i in range(previews[0].GetProperty("BoxSizes").GetNumberOfElements())]
    lines = output(1)
    corners = [lines.GetPoint(i) for i in range(8)] if lines.GetNumberOfPoints() else []
    note["box"] = [end([corner[axis] for corner in corners]) for axis in range(3) for end in (min, max)] if corners else []
    labels = output(2).GetPointData().GetAbstractArray("Label")
    note["labels"] = [labels.GetValue(i) for i in range(labels.GetNumberOfValues())]
    note["zones"] = output(3).GetNumberOfCells()
note["widget"] = [[widget.GetProperty(name).GetElement(i) for name in ("Position", "Scale") for i in range(3)] for widget in boxes]
display = simple.GetRepresentation(simple.FindSource(SURFACE), view)
note["surface"] = [display.Visibility, int(display.SMProxy.GetClientSideObject().GetVisibility())]
mesher = simple.FindSource("CartesianMesher1")
if mesher:
    def typed(name):
        property = mesher.SMProxy.GetProperty(name)
        return [property.GetUncheckedElement(i) for i in range(property.GetNumberOfUncheckedElements())]
    note["typed"] = {name: typed(name) for name in ("DomainBounds", "RefinementPositions", "RefinementLengths")}
    note["note"] = mesher.SMProxy.GetProperty("DomainNote").GetElement(0)
open("FOLDER/notes.txt", "a").write(json.dumps(note) + "\\n")
""".replace("SURFACE", repr(SURFACE.name))

# As if the widget's low x had been dragged.
DRAG = """
from paraview import simple
hidden = simple.GetActiveView().SMProxy.GetProperty("HiddenRepresentations")
for widget in [hidden.GetProxy(i) for i in range(hidden.GetNumberOfProxies())]:
    if widget.GetXMLName() == "BoxWidgetRepresentation":
        end = widget.GetProperty("Position").GetElement(0) + widget.GetProperty("Scale").GetElement(0)
        widget.GetProperty("Position").SetElement(0, -1000)
        widget.GetProperty("Scale").SetElement(0, end + 1000)
        widget.InvokeEvent("EndInteractionEvent")
"""
SAVE = """
from paraview import simple
simple.SaveState("FOLDER/state.pvsm")
"""
BEGIN_TRACE = """
from paraview import smtrace
smtrace.start_trace()
"""
END_TRACE = """
from paraview import smtrace
open("FOLDER/trace.py", "w").write(smtrace.stop_trace())
"""
SCENE = ["DataLabelRepresentation"] + ["GeometryRepresentation"] * 3 + ["ScalarBarWidgetRepresentation"]
NEW_SHAPE = event(f"{PROPERTIES}/PropertyCollection/addItemButton", "activate")
NO_PREVIEW = event(f"{PROPERTIES}/Preview/CheckBox", "set_boolean", "false")
RESET = event(f"{PANEL}/Reset", "activate")
DELETE = event(f"{PANEL}/Delete", "activate")


def close(a, b):
    return len(a) == len(b) and all(abs(x - y) < 1e-3 for x, y in zip(a, b))


with Screen() as screen:
    for name, text in ("note", NOTE), ("drag", DRAG), ("save", SAVE), ("begin", BEGIN_TRACE), ("end", END_TRACE):
        screen.add_macro(name, text.replace("FOLDER", str(screen.folder)))

    def play(*steps):
        """What was noted."""
        notes = screen.folder / "notes.txt"
        notes.unlink(missing_ok=True)
        said = screen.play(script(open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher"), *steps))
        assert "ERR|" not in said and "Traceback" not in said, said
        return [json.loads(line) for line in notes.read_text().splitlines()]

    note = macro("note")
    (traced,) = play(macro("begin"), choose("Domain", "Outside"), number("CellSize", 100), choose("BoxFrom", "Bounds"), note, apply(), macro("end"))
    trace = (screen.folder / "trace.py").read_text()
    assert traced["hidden"] == ["BoxWidgetRepresentation"] + SCENE and re.search("CellSize ?= ?100", trace), trace
    assert not any(word in trace for word in ("Preview", "Widget", "PVLookupTable(", "DataLabel")), trace
    first, typed, outside, saved, applied, again, reset = play(note, number("CellSize", 20), note, choose("Domain", "Outside"), note,
        macro("save"), note, number("CellSize", 80), apply(), note, choose("Ground", "zMin"), note, RESET, note)
    for shown in first, typed, outside, saved:
        assert shown["hidden"] == SCENE and shown["surface"] == [1, 1], shown
    assert first["sizes"] == ["0", "9.24"] and typed["sizes"] == ["0", "20"], (first, typed)
    assert not typed["box"] and not typed["labels"] and typed["zones"] == 0, typed
    assert outside["labels"] == ["inlet", "outlet", "sides", "sides", "sides", "sides"] and outside["zones"] > 0, outside
    assert "along y" in outside["note"] and first["note"] == "", outside
    assert outside["sources"] == first["sources"] and len(reset["sources"]) == len(first["sources"]) + 1, "the preview is no source, MiddleSlice is"
    state = (screen.folder / "state.pvsm").read_text()
    assert "CartesianMesher" in state and "MeshPreview" not in state and "BoxWidget" not in state
    for hidden in applied, reset:
        assert hidden["hidden"] == [], hidden
    assert again["zones"] == 24 and again["hidden"] == SCENE and again["labels"][4] == "ground" and abs(again["box"][4] - BODY[4]) < 1e-3, again

    box, dragged, after, row, off = play(choose("Domain", "Outside"), choose("BoxFrom", "Bounds"), note, macro("drag"), note,
        choose("BoxFrom", "Surface"), note, NEW_SHAPE, note, NO_PREVIEW, note)
    assert box["hidden"] == ["BoxWidgetRepresentation"] + SCENE, box
    assert close(box["typed"]["DomainBounds"], [end + side * 461.828903 for end, side in zip(BODY, (-3, 5, -3, 3, -3, 3))]), box
    assert close(box["box"], box["typed"]["DomainBounds"]), box
    low, length = box["typed"]["DomainBounds"][::2], [high - low for low, high in zip(*[iter(box["typed"]["DomainBounds"])] * 2)]
    assert close(box["widget"][0], low + length), box
    assert dragged["typed"]["DomainBounds"] == [-1000] + box["typed"]["DomainBounds"][1:] and dragged["box"][0] < -999.9, dragged
    assert after["widget"] == [] and after["hidden"] == SCENE, after
    position, lengths = row["typed"]["RefinementPositions"], row["typed"]["RefinementLengths"]
    assert close(position, BODY[::2]) and close(lengths, [high - low for low, high in zip(BODY[::2], BODY[1::2])]), row
    assert "GeometryRepresentation" not in off["hidden"] and off["surface"] == [1, 1], off

    # Where sizes differ, the surface has their colours instead of its own.
    alike, differing = play(note, event(f"{PROPERTIES}/FeatureDepth/IntRangeWidget/LineEdit", "set_string", 2), note)
    assert alike["surface"] == [1, 1] and differing["surface"] == [1, 0] and len(differing["sizes"]) > 2, (alike, differing)

    (deleted,) = play(choose("Domain", "Outside"), DELETE, note)
    assert deleted["hidden"] == [] and deleted["surface"] == [1, 1], deleted

    # Undo knows the filter and what was applied only.
    made, undone, redone, boxer = play(number("CellSize", 40), apply(), note, undo(), note, redo(), note,
        meshing_menu("CartesianBoxer", "Meshing in Steps"), number("CellSize", 30), note)  # the window closes with a preview in it
    assert made["hidden"] == undone["hidden"] == redone["hidden"] == [], (made, undone, redone)
    assert boxer["hidden"] == SCENE and boxer["sizes"] == ["0", "30"], boxer
