"""What the window shows of a mesh's quality: colours by what is worst from the start, with a legend; the failing cells, zoomed to
by a button, or that there are none; a brief summary in a corner and a long one in the panel; a histogram in a chart of its own,
with the limit; and a report by Save Data."""

import pathlib
import re
import sys

from events import PROPERTIES, apply, choose, event, macro, meshing_menu, number, open_file, script
from paraview import servermanager, simple  # noqa: F401: connects
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "kcl_exhaust_header_lumens.stl"
BUTTON = event(f"{PROPERTIES}/ShowFailingCells/Button", "activate")
SELECT = """
from paraview import simple
simple.SetActiveSource(simple.FindSource("{source}"))
"""
STRICT = """
from paraview import simple
simple.FindSource("FiniteVolumeQuality1").NonOrthogonalityLimit = {limit}
"""
NOTE = """
from paraview import simple
views = [view for view in simple.GetViews() if view.SMProxy.GetXMLName() == "RenderView"]
view = views[0]
charts = [view for view in simple.GetViews() if view.SMProxy.GetXMLName() == "XYChartView"]
quality = simple.FindSource("FiniteVolumeQuality1")
shown = {}
for display in view.Representations:
    if hasattr(display, "ColorArrayName") and display.Visibility:
        source = display.Input
        shown[source.SMProxy.GetXMLName(), source.Port] = display
bars = [bar for bar in view.Representations if bar.SMProxy.GetXMLName() == "ScalarBarWidgetRepresentation" and bar.Visibility]
summary = simple.FindSource("MeshSummary1")
note = {
    "shown": {key: (display.ColorArrayName[1], display.Opacity) for key, display in shown.items()},
    "legends": [bar.Title for bar in bars],
    "position": list(view.CameraPosition), "focus": list(view.CameraFocalPoint),
    "worst": quality and quality.WorstMeasure,
    "summary": summary and summary.Summary,
    "charts": [(chart.BottomAxisTitle, chart.LeftAxisTitle, chart.LeftAxisLogScale,
        [(display.XArrayName, display.UseIndexForXAxis, list(display.SeriesVisibility)) for display in chart.Representations])
        for chart in charts],
}
open("{folder}/notes.txt", "a").write(repr(note) + "\\n")
"""


with Screen() as screen:
    for name, text in (("note", NOTE), ("strict", STRICT), ("quality", SELECT.replace("{source}", "FiniteVolumeQuality1")),
            ("mesher", SELECT.replace("{source}", "CartesianMesher1"))):
        screen.add_macro(name, text.replace("{folder}", str(screen.folder)).replace("{limit}", "40"))
    said = screen.play(script(open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher"),
        number("CellSize", 15), apply(), meshing_menu("FiniteVolumeQuality"), apply(), macro("note"),
        BUTTON, macro("note"), macro("strict"), macro("quality"), BUTTON, macro("note"),
        macro("mesher"), meshing_menu("MeshSummary"), apply(), macro("note"),
        macro("mesher"), meshing_menu("QualityHistogram"), apply(), macro("note"),
        choose("Measure", "Volume Fraction"), apply(), macro("note"),
        macro("mesher"), event("pqClientMainWindow/menubar/menu_File", "activate", "actionFileSaveData"),
        event("pqClientMainWindow/FileSaveDialog", "filesSelected", screen.folder / "mesh.html")))
    assert "ERR|" not in said, said
    first, none, cells, summed, charted, shares = map(eval, (screen.folder / "notes.txt").read_text().splitlines())
    MESH, FAILING = ("FiniteVolumeQuality", 0), ("FiniteVolumeQuality", 2)
    assert first["worst"] and first["shown"][MESH] == (first["worst"], 1.0), first
    title = re.sub("(?<=[a-z])(?=[A-Z])", " ", first["worst"])
    assert title in first["legends"] and "Boundary" not in first["legends"], first["legends"]
    assert ("CartesianMesher", 1) not in first["shown"] and FAILING not in first["shown"], first
    # At first no cell fails: nothing changes, and a message says so.
    assert none["shown"] == first["shown"] and none["position"] == first["position"], none
    assert cells["shown"][FAILING] == ("", 1.0) and cells["shown"][MESH][1] < 0.5, cells
    assert cells["legends"] == [title], cells["legends"]
    assert {source for source, _ in cells["shown"]} == {"FiniteVolumeQuality"}, cells["shown"]

    def distance(note):
        return sum((a - b) ** 2 for a, b in zip(note["position"], note["focus"])) ** 0.5

    assert distance(cells) < 0.9 * distance(first), (distance(cells), distance(first))
    assert summed["summary"].startswith("OpenFOAM accepts all cells\n") and "Boundaries:\n" in summed["summary"], summed["summary"]
    (title, left, logarithmic, displays), = charted["charts"]
    assert title == "Skewness (limit: at most 4)" and left == "Cells" and logarithmic == 1, charted["charts"]
    (column, by_index, visible), = displays
    assert column == "Skewness" and not by_index, displays
    assert visible == ["Cells", "limit: at most 4"], visible
    (title, _, _, ((column, _, visible),)), = shares["charts"]
    assert title == column == "Volume Fraction" and "Cells" in visible and column not in visible, shares["charts"]
    report = (screen.folder / "mesh.html").read_text()
    assert report.count("data:image/png;base64,") == 3 and "<td>Cell Size</td><td>15</td>" in report
