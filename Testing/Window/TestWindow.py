"""ParaView's window under Xvfb: a surface is opened, meshed and refined by menus and tables, undone and
redone; what is seen is as in Testing/Baseline. The trace of it, run by pvpython, its saved state and a
task file give the same mesh, bit for bit.

A picture that differs is left in the current folder; look at it, and copy it to Testing/Baseline if
it is right.
"""

import pathlib
import shutil
import subprocess
import sys

from paraview import simple

from events import advanced, apply, boundary_row, look, macro, meshing_menu, number, open_file, redo, rows, script, table_row, undo
from window import Screen

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Testing" / "Plugin"))
from pictures import BASELINE, difference  # noqa: E402
from pipeline import DATA, assert_identical, output  # noqa: E402

SURFACE = DATA / "kcl_exhaust_header_lumens.stl"
PROGRAM = sys.argv[2]
MOST = 300  # of 120000 pixels: lines and light depend on the driver

TRACE = "from paraview import smtrace\nsmtrace.start_trace()\n"
# The trace ends before the rest, or it would tell of that too.
SAVE = """
from paraview import simple, smtrace
trace = smtrace.stop_trace()
open("{folder}/trace.py", "w").write(trace)
simple.SaveState("{folder}/state.pvsm")
mesher = simple.FindSource("CartesianMesher1")
simple.SaveData("{folder}/mesh.vtu", proxy=simple.OutputPort(mesher, 0), DataMode="Binary")
simple.SaveData("{folder}/boundary.vtp", proxy=simple.OutputPort(mesher, 1), DataMode="Binary")
"""
PICTURES = "WindowFirst", "WindowRefined"
PICTURE = """
import pathlib
from paraview import simple
names = {names!r}
name = next(name for name in names if not pathlib.Path("{folder}", name + ".png").exists())
simple.SaveScreenshot("{folder}/" + name + ".png", simple.GetActiveView(), ImageResolution=[400, 300],
    OverrideColorPalette="WhiteBackground")
""".replace("{names!r}", repr(PICTURES))
NOTE = """
from paraview import simple
mesher = simple.FindSource("CartesianMesher1")
open("{folder}/notes.txt", "a").write(
    repr([mesher.GetProperty(name).GetData() for name in ("CellSize", "BoundaryRefinement")]) + "\\n")
"""
TASK = f"""
[surface]
file = "{SURFACE}"
[grid]
cell_size = 20.5
[refinement]
boundary_refinement = [{{ boundary = "inlet_1", depth = 2, blending_distance = 1, blend_to_depth_1 = 0 }}]
[[boundaries]]
name = "outlet_1"
type = "symmetry"
small_cell_ratio = 0.3
[[boundaries]]
name = "wall_2"
type = "patch"
small_cell_ratio = 1e-100
[output]
mesh = "task.vtu"
"""


def same(what, mesher, folder):
    for port, file, reader in ((0, "mesh.vtu", simple.XMLUnstructuredGridReader),
                               (1, "boundary.vtp", simple.XMLPolyDataReader)):
        expected = output(reader(FileName=[str(folder / file)]))
        assert expected.GetNumberOfCells() > 500
        assert_identical(what, output(mesher, port), expected)
    print(f"{what}: {output(mesher).GetNumberOfCells()} cells")


with Screen() as screen:
    for name, text in ("begin", TRACE), ("save", SAVE), ("note", NOTE), ("picture", PICTURE):
        screen.add_macro(name, text.replace("{folder}", str(screen.folder)))
    said = screen.play(script(macro("begin"), open_file(SURFACE, choose_reader=True), apply(),
        meshing_menu("CartesianMesher"), advanced(), number("CellSize", 20.5), apply(), macro("note"), macro("picture"),
        table_row("BoundaryRefinement", 0, [1, 2, 1, 0]), apply(), rows("BoundaryRefinement", 1),
        undo(), rows("BoundaryRefinement", 0), redo(), rows("BoundaryRefinement", 1), apply(), macro("note"),
        boundary_row(2, "symmetry", 0.3), boundary_row(3, "patch", 1e-100), apply(),
        look("PositiveX"), macro("picture"), macro("save")))
    assert "ERR|" not in said, said
    notes = (screen.folder / "notes.txt").read_text().splitlines()
    assert notes == ["[20.5, []]", "[20.5, [1.0, 2.0, 1.0, 0.0]]"], notes

    for name in PICTURES:
        for baseline in PICTURES:
            error = difference(screen.folder / f"{name}.png", BASELINE / f"{baseline}.png")
            print(f"{name} against {baseline}: {error}")
            if (error > MOST) == (name == baseline):
                copy = shutil.copy(screen.folder / f"{name}.png", pathlib.Path.cwd())
                raise AssertionError(f"{copy} against {baseline}: {error}")

    trace = (screen.folder / "trace.py").read_text()
    for part in "BoundaryNames = ['outlet_1', 'wall_2']", "NamedSTLReader(", "CartesianMesher(", "CellSize = 20.5", "BoundaryRefinement = [1.0, 2.0":
        assert part.replace(" ", "") in trace.replace(" ", ""), f"no '{part}' in: {trace}"
    exec(compile(trace, "trace", "exec"), {})
    same("trace", simple.FindSource("CartesianMesher1"), screen.folder)

    simple.ResetSession()
    simple.LoadState(str(screen.folder / "state.pvsm"))
    same("state", simple.FindSource("CartesianMesher1"), screen.folder)

    (screen.folder / "task.toml").write_text(TASK)
    subprocess.run([PROGRAM, "--quiet", str(screen.folder / "task.toml")], check=True)
    assert_identical("task", output(simple.XMLUnstructuredGridReader(FileName=[str(screen.folder / "task.vtu")])),
        output(simple.XMLUnstructuredGridReader(FileName=[str(screen.folder / "mesh.vtu")])))
