"""What the window shows after Apply: the clip of a mesh is not covered by its boundary, a mesh that has become large has no edges, and
saving a surface as a case says what to save instead; the next case has the settings of the last one."""

import pathlib
import subprocess
import sys

from events import apply, check, event, macro, meshing_menu, number, open_file, script
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "kcl_exhaust_header_lumens.stl"
NOTE = """
from paraview import simple
mesher, view = simple.FindSource("CartesianMesher1"), simple.GetActiveView()
displays = [simple.GetDisplayProperties(simple.OutputPort(mesher, port), view) for port in range(2)]
open("{folder}/notes.txt", "a").write(repr([displays[0].Visibility, displays[1].Visibility, displays[1].Representation]) + "\\n")
"""
SELECT = """
from paraview import servermanager, simple
proxies = servermanager.ActiveConnection.Session.GetSessionProxyManager()
mesher = simple.FindSource("CartesianMesher1").SMProxy
proxies.GetSelectionModel("ActiveSources").SetCurrentProxy(mesher.GetOutputPort({port}), 3)
"""


DIALOG = "pqClientMainWindow/WriterSettingsDialog"
IN_DIALOG = f"{DIALOG}/scrollArea/qt_scrollarea_viewport/Container/ProxyWidget"


def save(file):
    return [event("pqClientMainWindow/menubar/menu_File", "activate", "actionFileSaveData"),
        event("pqClientMainWindow/FileSaveDialog", "filesSelected", file)]


def filter(category, name):
    return "\n".join([event("pqClientMainWindow/menubar", "activate", "menuFilters"),
        event(f"pqClientMainWindow/menubar/menuFilters/{category}", "activate", name)])


with Screen() as screen:
    screen.add_macro("note", NOTE.replace("{folder}", str(screen.folder)))
    for port in 0, 1:
        screen.add_macro(f"select{port}", SELECT.replace("{port}", str(port)))
    screen.add_macro("surface", f"from paraview import simple\nsimple.SetActiveSource(simple.FindSource('{SURFACE.name}'))")
    screen.add_macro("saved", f"""
from paraview import simple
mesh = simple.OutputPort(simple.FindSource("CartesianMesher2"), "Mesh")
simple.SaveData({str(screen.folder / "scripted.foam")!r}, proxy=mesh)
""")
    begin = [open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher")]
    screen.play(script(*begin, number("CellSize", 12), apply(), macro("note"), number("CellSize", 2), apply(), macro("note"),
        number("CellSize", 12), apply(), macro("note"), macro("select0"), filter("Common", "Clip"), apply(), macro("note")))
    first, large, again, clipped = map(eval, (screen.folder / "notes.txt").read_text().splitlines())
    assert first == again == [1, 1, "Surface With Edges"], (first, again)
    assert large == [1, 1, "Surface"], large
    assert clipped[1] == 0, "the boundary covers the clip"

    # The second case of a mesh has the settings of the first, but Overwrite Setup; another mesh has not. The setup is proposed, as the mesh
    # has inlets and outlets, and a new folder where there are other files. Scripts in the window as well as without it start anew.
    for case in "first", "second":
        (screen.folder / case).mkdir()
    screen.play(script(*begin, number("CellSize", 12), apply(), macro("select0"), *save(screen.folder / "first" / "case.foam"),
        check(f"{IN_DIALOG}/SolverSetup/ComboBox", "currentText", "Incompressible"),
        check(f"{IN_DIALOG}/NewFolder/CheckBox", "checked", "false"), event(f"{IN_DIALOG}/Scale/DoubleLineEdit0", "set_string", "0.001"),
        event(f"{IN_DIALOG}/OverwriteSetup/CheckBox", "set_boolean", "true"), event(f"{DIALOG}/widget/OKButton", "activate"),
        *save(screen.folder / "second" / "case.foam"), check(f"{IN_DIALOG}/SolverSetup/ComboBox", "currentText", "Incompressible"),
        check(f"{IN_DIALOG}/Scale/DoubleLineEdit0", "text", "0.001"), check(f"{IN_DIALOG}/OverwriteSetup/CheckBox", "checked", "false"),
        event(f"{DIALOG}/widget/OKButton", "activate"), *save(screen.folder / "task.toml"),
        macro("surface"), meshing_menu("CartesianMesher"), number("CellSize", 20), apply(), *save(screen.folder / "pipe.foam"),
        check(f"{IN_DIALOG}/Scale/DoubleLineEdit0", "text", "0"), check(f"{IN_DIALOG}/NewFolder/CheckBox", "checked", "true"),
        event(f"{IN_DIALOG}/SolverSetup/ComboBox", "set_string", "None"), event(f"{DIALOG}/widget/OKButton", "activate"), macro("saved")))
    assert (screen.folder / "scripted.foam").exists()
    assert (screen.folder / "pipe" / "pipe.foam").exists() and (screen.folder / "pipe" / "constant" / "polyMesh").exists()
    assert not any((screen.folder / name).exists() for name in ("pipe.foam", "Allrun"))
    assert (screen.folder / "second" / "Allrun").exists()
    # A task has them too.
    subprocess.run([sys.argv[2], "--quiet", str(screen.folder / "task.toml")], check=True)
    for file in "constant/polyMesh/points", "system/controlDict", "0/U":
        assert (screen.folder / "task" / file).read_bytes() == (screen.folder / "second" / file).read_bytes(), file

    # A surface is no mesh: the message says what to save.
    folder = screen.folder / "surface"
    folder.mkdir()
    said = screen.play(script(*begin, number("CellSize", 12), apply(), macro("select1"), *save(folder / "case.foam")))
    assert "the output Boundary of CartesianMesher1 (Cartesian Mesher) is a surface" in said and "Select its output Mesh" in said, said
    assert not list(folder.iterdir())
