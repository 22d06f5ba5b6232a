"""From an STL file without names to a duct that OpenFOAM runs, in ten actions: nine here, the tenth is Allrun. And a boundary
picked in the view, in a trace."""

import filecmp
import pathlib
import re
import subprocess
import sys

from paraview import simple

from events import PROPERTIES, apply, copy_selection, event, look, macro, meshing_menu, number, open_file, save_as, script, select_cells, text
from window import Screen

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Testing" / "Plugin"))
import foam  # noqa: E402

DIALOG = "pqClientMainWindow/WriterSettingsDialog"
IN_DIALOG = f"{DIALOG}/scrollArea/qt_scrollarea_viewport/Container/ProxyWidget"
FAILING = event(f"{PROPERTIES}/ShowFailingCells/Button", "activate")
BEGIN = "from paraview import smtrace\nsmtrace.start_trace()\n"
END = 'from paraview import smtrace\nopen("{file}", "w").write(smtrace.stop_trace())\n'
SELECT = 'from paraview import simple\nsimple.SetActiveSource(simple.FindSource("CartesianMesher1"))\n'
TOLD = """
from paraview.simple import *
split = FindSource("SplitSurface1")
print("boundaries", list(split.GetProperty("FoundBoundaries"))[4::4])
print("legend", list(GetColorTransferFunction("BoundaryName").Annotations)[::2])
"""


with Screen() as screen:
    duct, case = screen.folder / "duct.stl", screen.folder / "case"
    cone = simple.Triangulate(Input=simple.Cylinder(Height=4, Radius=0.5, Resolution=24))
    simple.SaveData(str(duct), proxy=simple.Calculator(Input=cone, CoordinateResults=1,
        Function="coordsX*(1+coordsY/12)*iHat+coordsY*jHat+coordsZ*kHat"))
    case.mkdir()
    actions = [
        open_file(duct), apply(),
        meshing_menu("SplitSurface"), text("CapNames", "outlet, inlet"), apply(),
        meshing_menu("CartesianMesher"), apply(),
        save_as(case / "case.foam"),
        "\n".join([event(f"{IN_DIALOG}/SolverSetup/ComboBox", "set_string", "Incompressible"),
                   event(f"{DIALOG}/widget/OKButton", "activate")])]
    assert len(actions) == 9
    said = screen.play(script(*actions))
    assert "ERR|" not in said, said
    control = case / "system" / "controlDict"
    control.write_text(re.sub(r"(endTime|writeInterval) +500;", r"\1 5;", control.read_text()))
    foam.run(case, "./Allrun")
    assert re.findall(r"^Time = (\d+)$", (case / "log.simpleFoam").read_text(), re.M) == ["1", "2", "3", "4", "5"]
    patches = (case / "constant" / "polyMesh" / "boundary").read_text()
    assert all(f"{name}\n" in patches for name in ("inlet", "outlet", "wall")), patches

    # A click on the outlet, seen from its side, names it all; the panel and the legend have the new name. The trace of this, of a mesh,
    # its failing cells and its case makes the same case.
    traced, again = screen.folder / "trace.py", screen.folder / "again"
    for name, words in (("begin", BEGIN), ("end", END.replace("{file}", str(traced))), ("told", TOLD), ("mesher", SELECT)):
        screen.add_macro(name, words)
    case = screen.folder / "picked"
    case.mkdir()
    said = screen.play(script(macro("begin"), open_file(duct), apply(), meshing_menu("SplitSurface"), apply(), look("NegativeY"),
        select_cells(0.5, 0.5), copy_selection(), text("CapNames", "wide, narrow"), text("SelectionName", "gate"), apply(), macro("told"),
        meshing_menu("CartesianMesher"), apply(), meshing_menu("FiniteVolumeQuality"), number("NonOrthogonalityLimit", 20), apply(), FAILING,
        macro("mesher"), meshing_menu("MeshSummary"), apply(), macro("mesher"), number("CellSize", 0.11), apply(), save_as(case / "case.foam"),
        event(f"{DIALOG}/widget/OKButton", "activate"), macro("end")))
    assert "ERR|" not in said, said
    assert "boundaries ['narrow', 'wall', 'gate']" in said, said
    assert "legend ['wall', 'narrow', 'gate']" in said, said
    assert "the flat ends cap_1, cap_2 will be walls" in said and "the flat ends narrow, gate will be walls" not in said, said
    assert re.search(r"SelectedCells ?= ?\[\d", traced.read_text()), traced.read_text()
    traced.write_text(traced.read_text().replace(str(case), str(again)))
    subprocess.run(["pvpython", traced], check=True, cwd=screen.folder)
    files = [path.relative_to(case) for path in case.rglob("*") if path.is_file()]
    same, other, missing = filecmp.cmpfiles(case, again, files, shallow=False)
    assert len(same) > 5 and not other and not missing, (same, other, missing)
