"""File > Save Data saves the settings in the panel as a task file: cartesian-mesher makes the same mesh from it, bit for bit."""

import pathlib
import subprocess
import sys

from paraview import simple

from events import advanced, apply, boundary_row, event, macro, meshing_menu, number, open_file, script, table_row
from window import Screen

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Testing" / "Plugin"))
from pipeline import DATA, assert_identical, output  # noqa: E402

SURFACE = DATA / "kcl_exhaust_header_lumens.stl"
MESH = """
from paraview import simple
simple.SaveData("{folder}/mesh.vtu", proxy=simple.OutputPort(simple.FindSource("CartesianMesher1"), 0), DataMode="Binary")
"""

with Screen() as screen:
    screen.add_macro("mesh", MESH.replace("{folder}", str(screen.folder)))
    task = screen.folder / "task.toml"
    said = screen.play(script(open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher"), advanced(),
        number("CellSize", 20.5), table_row("BoundaryRefinement", 0, [1, 2, 1, 0]), boundary_row(2, "symmetry", 0.3), apply(),
        event("pqClientMainWindow/menubar/menu_File", "activate", "actionFileSaveData"),
        event("pqClientMainWindow/FileSaveDialog", "filesSelected", task), macro("mesh")))
    assert "ERR|" not in said, said
    print(task.read_text())
    subprocess.run([sys.argv[2], "--quiet", str(task)], check=True)
    mine, expected = (output(simple.XMLUnstructuredGridReader(FileName=[str(screen.folder / name)])) for name in ("task.vtu", "mesh.vtu"))
    assert expected.GetNumberOfCells() > 500
    assert_identical("task", mine, expected)
