"""From an STL file without names to a duct that OpenFOAM runs, in ten actions: nine here, the tenth is Allrun. And a boundary
picked in the view."""

import pathlib
import re
import sys

from paraview import simple

from events import apply, copy_selection, event, look, macro, meshing_menu, open_file, save_as, script, select_cells, text
from window import Screen

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Testing" / "Plugin"))
import foam  # noqa: E402

DIALOG = "pqClientMainWindow/WriterSettingsDialog"
IN_DIALOG = f"{DIALOG}/scrollArea/qt_scrollarea_viewport/Container/ProxyWidget"


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

    # A click on the outlet, seen from its side, names it all; the panel and the legend have the new name.
    screen.add_macro("told", """
from paraview.simple import *
split = FindSource("SplitSurface1")
print("boundaries", list(split.GetProperty("FoundBoundaries"))[4::4])
print("legend", list(GetColorTransferFunction("BoundaryName").Annotations)[::2])
""")
    said = screen.play(script(open_file(duct), apply(), meshing_menu("SplitSurface"), apply(), look("NegativeY"),
        select_cells(0.5, 0.5), copy_selection(), text("SelectionName", "gate"), apply(), macro("told")))
    assert "ERR|" not in said, said
    assert "boundaries ['cap_1', 'wall', 'gate']" in said, said
    assert "legend ['cap_1', 'wall', 'gate']" in said, said
    assert "the flat ends cap_1, cap_2 will be walls" in said and "the flat ends cap_1, gate will be walls" not in said, said
