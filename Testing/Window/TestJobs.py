"""From a file to a case that runs, as a user would do it: a heated pipe, a tee of pipes from a CAD file without names and from an STL
file of one solid, a car. An action is a menu's entry, a file, a field, a choice or a button; the last one is Allrun."""

import pathlib
import re
import subprocess
import sys

from paraview import simple

from events import PROPERTIES, apply, boundary, choose, event, meshing_menu, number, open_file, save_as, script, text
from window import Screen

REPOSITORY = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(REPOSITORY / "Testing" / "Plugin"))
import foam  # noqa: E402

OK = event("pqClientMainWindow/WriterSettingsDialog/widget/OKButton", "activate")
MERGED_NAME = 7  # the column of the table Boundaries
SEVERAL = {meshing_menu: 1, open_file: 2, save_as: 2}  # of these; a menu's entry is one, however deep


def play(screen, name, most, *actions):
    """The folder of the case that these actions and a click on OK make: no more of them than `most`, with Allrun."""
    case = screen.folder / name
    case.mkdir()
    saved = [(save_as, case / f"{name}.foam")]
    made = [action if isinstance(action, str) else action[0](*action[1:]) for action in [*actions, *saved, OK]]
    count = sum(1 if isinstance(action, str) else SEVERAL[action[0]] for action in [*actions, *saved, OK]) + 1
    said = screen.play(script(*made), timeout=600)
    assert "ERR|" not in said and "Traceback" not in said, said
    print(name, count, "actions")
    assert count <= most, (name, count)
    return case


def run(case):
    """Five iterations."""
    control = case / "system" / "controlDict"
    control.write_text(re.sub(r"(endTime|writeInterval) +500;", r"\1 5;", control.read_text()))
    foam.run(case, "./Allrun")
    assert re.findall(r"^Time = (\d+)$", (case / "log.simpleFoam").read_text(), re.M) == ["1", "2", "3", "4", "5"]


with Screen() as screen:
    case = play(screen, "pipe", 10, (open_file, REPOSITORY / "Data" / "heated_pipe.step"), apply(), (meshing_menu, "CartesianMesher"),
        choose("RegionsFrom", "Blocks"), apply())
    assert "chtMultiRegionSimpleFoam" in (case / "Allrun").read_text()

    parts = screen.folder / "parts"
    parts.mkdir()
    subprocess.run([str(pathlib.Path(sys.argv[2]).parent / "make-cad-parts"), str(parts)], check=True)
    tee = simple.CADReader(FileName=str(parts / "tee.step"), LengthUnit="Millimetre")
    merged = simple.MergeBlocks(Input=tee, OutputDataSetType="Polygonal Mesh")
    simple.SaveData(str(parts / "tee.stl"), proxy=simple.Triangulate(Input=simple.PassArrays(Input=merged)))

    # Its ends are 2, 3 and 5 of the list.
    run(play(screen, "step", 14, (open_file, parts / "tee.step"), apply(), (meshing_menu, "CartesianMesher"),
        *[boundary(row, MERGED_NAME, name) for row, name in ((1, "inlet"), (2, "outlet_1"), (4, "outlet_2"))], apply()))

    run(play(screen, "stl", 16, (open_file, parts / "tee.stl"), apply(), (meshing_menu, "SplitSurface"), text("CapNames", "outlet, inlet"), apply(),
        (meshing_menu, "CartesianMesher"), choose("LengthUnit", "Millimetre"), event(f"{PROPERTIES}/Layers/IntRangeWidget/LineEdit", "set_string", -1), number("TargetYPlus", 1), apply()))

    run(play(screen, "car", 13, (open_file, REPOSITORY / "Data" / "prius_hybrid_body.obj", True), apply(), (meshing_menu, "CartesianMesher"),
        choose("Domain", "Outside"), choose("FlowDirection", "Plus Y"), choose("Ground", "zMin"), apply()))
