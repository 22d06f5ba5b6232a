"""Conditions by boundary are rows in the dialog of the OpenFOAM writer: they reach the case, the task that is saved next, and a trace
of it all, of which pvpython makes the same files. A mesh with a zone is proposed as one mesh with a flow,
and its zone turns."""

import filecmp
import pathlib
import subprocess
import sys

from events import apply, event, macro, meshing_menu, number, open_file, save_as, script
from window import Screen

SURFACE = pathlib.Path(sys.argv[1]) / "Data" / "kcl_exhaust_header_lumens.stl"
DIALOG = "pqClientMainWindow/WriterSettingsDialog"
IN_DIALOG = f"{DIALOG}/scrollArea/qt_scrollarea_viewport/Container/ProxyWidget"
CONDITIONS = f"{IN_DIALOG}/PropertyCollection"
ROW = f"{CONDITIONS}/container/1pqProxyWidget0"
SELECT = 'from paraview import simple\nsimple.SetActiveSource(simple.FindSource("CartesianMesher1"))\n'
BEGIN = "from paraview import smtrace\nsmtrace.start_trace()\n"
FAN = """import sys
sys.path.insert(0, {tests!r})
from paraview import simple
import rotors
mesher = rotors.fan()
simple.Show(simple.OutputPort(mesher, "Mesh"))
simple.SetActiveSource(mesher)
"""
END = 'from paraview import smtrace\nopen("{file}", "w").write(smtrace.stop_trace())\n'

with Screen() as screen:
    case, task, traced, again = (screen.folder / name for name in ("case", "task.toml", "trace.py", "again"))
    for name, text in ("select", SELECT), ("begin", BEGIN), ("end", END.replace("{file}", str(traced))):
        screen.add_macro(name, text)
    case.mkdir()
    screen.play(script(macro("begin"), open_file(SURFACE, choose_reader=True), apply(), meshing_menu("CartesianMesher"),
        number("CellSize", 20), apply(), macro("select"), save_as(case / "case.foam"),
        event(f"{IN_DIALOG}/SolverSetup/ComboBox", "set_string", "Transient"), event(f"{CONDITIONS}/addItemButton", "activate"),
        event(f"{ROW}/Boundary/Boundary", "set_string", "inlet_1"), event(f"{ROW}/Flow/ComboBox", "set_string", "mass flow"),
        event(f"{ROW}/FlowValue/DoubleLineEdit0", "set_string", "0.03"), event(f"{DIALOG}/widget/OKButton", "activate"), macro("end"), save_as(task)))
    velocity = (case / "0" / "U").read_text()
    assert "inlet_1 { type flowRateInletVelocity; volumetricFlowRate constant 0.025;" in velocity, velocity
    assert "run pimpleFoam" in (case / "Allrun").read_text()
    assert '[[conditions]]\nboundary = "inlet_1"\nflow = "mass flow"\nflow_value = 0.03\n' in task.read_text(), task.read_text()
    traced.write_text(traced.read_text().replace(str(case), str(again)))
    subprocess.run(["pvpython", traced], check=True, cwd=screen.folder)
    files = [path.relative_to(case) for path in case.rglob("*") if path.is_file()]
    same, other, missing = filecmp.cmpfiles(case, again, files, shallow=False)
    assert len(same) > 15 and not other and not missing, (other, missing)
    rotor = screen.folder / "rotor"
    rotor.mkdir()
    screen.add_macro("fan", FAN.format(tests=str(pathlib.Path(sys.argv[1]) / "Testing" / "Plugin")))
    turning = f"{IN_DIALOG}/PropertyCollection2"
    row = f"{turning}/container/1pqProxyWidget0"
    screen.play(script(macro("fan"), save_as(rotor / "case.foam"), event(f"{turning}/addItemButton", "activate"),
        event(f"{row}/Zone/Zone", "set_string", "rotor"), event(f"{row}/Speed/DoubleLineEdit0", "set_string", "120"),
        event(f"{DIALOG}/widget/OKButton", "activate")))
    zones = (rotor / "constant" / "polyMesh" / "cellZones").read_text()
    assert "fluid" in zones and "rotor" in zones and "run simpleFoam" in (rotor / "Allrun").read_text(), zones
    properties = (rotor / "constant" / "MRFProperties").read_text()
    assert "cellZone        rotor;" in properties and "axis            (0 0 1);" in properties and "// rad/s: 120 rpm" in properties, properties
