"""From a STEP file of three solids that touch to a case of conjugate heat transfer that OpenFOAM runs, in ten actions: nine
here, the tenth is Allrun. And what the window shows of a STEP file and of one that cannot be read."""

import pathlib
import re
import sys

from events import PROPERTIES, apply, choose, event, macro, meshing_menu, open_file, save_as, script
from window import Screen

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Testing" / "Plugin"))
import foam  # noqa: E402

PIPE = pathlib.Path(sys.argv[1]) / "Data" / "heated_pipe.step"
DIALOG = "pqClientMainWindow/WriterSettingsDialog"
IN_DIALOG = f"{DIALOG}/scrollArea/qt_scrollarea_viewport/Container/ProxyWidget"
UNGLUED = event(f"{PROPERTIES}/GlueSolids/CheckBox", "set_boolean", "false")

TOLD = """
from paraview import simple
pipe = simple.FindSource("heated_pipe.step")
print("solids", list(pipe.GetProperty("FoundSolids"))[6::6])
print("findings", list(pipe.GetProperty("Findings")))
print("legend", sorted(list(simple.GetColorTransferFunction("BoundaryName").Annotations)[::2]))
print("colours", simple.GetDisplayProperties().ColorArrayName[1])
"""

with Screen() as screen:
    case = screen.folder / "case"
    case.mkdir()
    actions = [
        open_file(PIPE), apply(),
        meshing_menu("CartesianMesher"), choose("RegionsFrom", "Blocks"), apply(),
        save_as(case / "case.foam"),
        event(f"{IN_DIALOG}/SolverSetup/ComboBox", "set_string", "Conjugate Heat"),
        event(f"{DIALOG}/widget/OKButton", "activate")]
    assert len(actions) == 8
    said = screen.play(script(*actions))
    assert "ERR|" not in said and "WARN|" not in said, said
    regions = (case / "constant" / "regionProperties").read_text()
    assert re.search(r"fluid\s*\(\s*fluid\s*\)", regions) and re.search(r"solid\s*\(\s*pipe heater\s*\)", regions), regions
    control = case / "system" / "controlDict"
    control.write_text(re.sub(r"(endTime|writeInterval) +\d+;", r"\1 5;", control.read_text()))
    allrun = case / "Allrun"  # heat stops after its first part
    allrun.write_text(re.sub(r"(last \+ 100\)\)) -gt \d+", r"\1 -gt 102", allrun.read_text()))
    assert "-gt 102" in allrun.read_text(), allrun.read_text()
    foam.run(case, "./Allrun")
    steps = re.findall(r"^Time = (\d+)$", (case / "log.chtMultiRegionSimpleFoam").read_text(), re.M)
    assert steps == ["1", "2", "3", "4", "5"], steps
    for region, patches in ("fluid", {"inlet", "outlet", "fluid_to_pipe"}), ("pipe", {"pipe", "pipe_to_fluid", "pipe_to_heater"}), \
            ("heater", {"heater", "heater_to_pipe"}):
        text = (case / "constant" / region / "polyMesh" / "boundary").read_text()
        assert set(re.findall(r"^    (\w+)\n    {", text, re.M)) == patches, text

    screen.add_macro("told", TOLD)
    said = screen.play(script(open_file(PIPE), UNGLUED, apply(), macro("told")))
    assert "ERR|" not in said and "WARN|" not in said, said
    assert "solids ['fluid', 'pipe', 'heater']" in said, said
    assert re.search("findings .*Glue Solids is off.*may touch", said), said
    assert "legend ['fluid', 'heater', 'inlet', 'outlet', 'pipe']" in said and "colours BoundaryName" in said, said

    text = screen.folder / "text.step"
    text.write_text("no STEP\n")
    said = screen.play(script(open_file(text), apply()))
    assert f"{text} cannot be read as STEP" in said, said
