"""From a body's file to a case of OpenFOAM that runs, in ten actions in the window: nine here, the tenth is Allrun."""

import pathlib
import re
import sys

from paraview import simple

from events import apply, choose, event, meshing_menu, open_file, save_as, script
from window import Screen

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Testing" / "Plugin"))
import foam  # noqa: E402

DIALOG = "pqClientMainWindow/WriterSettingsDialog"
IN_DIALOG = f"{DIALOG}/scrollArea/qt_scrollarea_viewport/Container/ProxyWidget"

with Screen() as screen:
    body, case = screen.folder / "body.stl", screen.folder / "case"
    simple.SaveData(str(body), proxy=simple.Triangulate(Input=simple.Box(YLength=0.3, ZLength=0.3)))
    case.mkdir()
    actions = [
        open_file(body), apply(),
        meshing_menu("CartesianMesher"), choose("Domain", "Outside"), choose("Ground", "zMin"), apply(),
        save_as(case / "case.foam"),
        event(f"{IN_DIALOG}/SolverSetup/ComboBox", "set_string", "Incompressible"),
        event(f"{DIALOG}/widget/OKButton", "activate")]
    assert len(actions) == 9
    said = screen.play(script(*actions))
    assert "ERR|" not in said, said
    control = case / "system" / "controlDict"
    control.write_text(re.sub(r"(endTime|writeInterval) +500;", r"\1 5;", control.read_text()))
    foam.run(case, "./Allrun")
    assert re.findall(r"^Time = (\d+)$", (case / "log.simpleFoam").read_text(), re.M) == ["1", "2", "3", "4", "5"]
