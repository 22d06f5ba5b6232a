"""Every output of every source and filter of the plugin, selected in the pipeline browser and coloured in the toolbar by its arrays
(those whose values have no names once, not for each output), while the editor of colours is open; also after loading a state from before colours had opacity functions."""

import pathlib
import re
import shutil
import sys
from xml.etree import ElementTree

from paraview import simple

from events import colour_by, event, macro, script
from window import Screen

REPOSITORY = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(REPOSITORY / "Testing" / "Plugin"))
from pages import reads_cad  # noqa: E402

PROXIES = {proxy.get("name") for group in ElementTree.fromstring(re.sub("@[A-Za-z]+@", "",
    (REPOSITORY / "Plugin" / "CartesianMesher.xml.in").read_text())) for proxy in group.iter("SourceProxy") if group.get("name") != "internal_filters"}
if not reads_cad(sys.argv[2]):
    PROXIES.remove("CADReader")
IN_CHARTS = {"QualityHistogram"}
NAMED = "BoundaryName", "DefectName", "Region", "InterfaceName"  # arrays whose values have names

# A cube of two named solids, with a triangle missing and another there twice; two regions; and flow around a body whose
# boundaries are those of its surface and the domain's sides.
BUILD = """
from paraview import simple
flawed = simple.NamedSTLReader(FileName="{folder}/flawed.stl")
flawed.UpdatePipeline() # a region takes its size from what has been read; ParaView 6.1 has no size until then
simple.NamedOBJReader(FileName="{folder}/square.obj")
CAD
boxes = [simple.Triangulate(Input=simple.Box(Center=[i, 0, 0])) for i in range(2)]
simple.CartesianMesher(Input=simple.GroupDatasets(Input=boxes), CellSize=0.5, RegionsFrom="Blocks")
mesher = simple.CartesianMesher(Input=flawed, CellSize=0.5)
simple.CartesianMesher(Input=flawed, CellSize=0.5, Domain="Outside", LengthsBefore=1, LengthsBehind=1, LengthsBeside=1, BoxesAlongBody=0)
boxer = simple.CartesianBoxer(Input=flawed, CellSize=0.5)
simple.CellAssembler(Input=boxer, Patches=simple.Patcher(Input=flawed, Boxes=boxer))
simple.SplitSurface(Input=flawed)
simple.SurfaceInspector(Input=flawed)
simple.RefinementRegion(Input=flawed)
simple.FiniteVolumeQuality(Input=simple.OutputPort(mesher, 0))
simple.DividePolyhedra(Input=simple.OutputPort(mesher, 0))
simple.SlicePolyhedra(Input=simple.OutputPort(mesher, 0))
simple.MeshSummary(Input=simple.OutputPort(mesher, 0))
""".replace("CAD", 'simple.CADReader(FileName="{folder}/heated_pipe.step")' if "CADReader" in PROXIES else "")

OUTPUTS = f"""
outputs = [(source, port) for _, source in sorted(simple.GetSources().items()) if source.SMProxy.GetXMLName() in {sorted(PROXIES - IN_CHARTS)}
    for port in range(source.SMProxy.GetNumberOfOutputPorts())]
"""
# Each call shows the next output and selects it: simple.SetActiveSource would select the first output of its filter.
SELECT = """
import pathlib
from paraview import servermanager, simple
count = pathlib.Path("{folder}/selected.txt")
done = int(count.read_text()) if count.exists() else 0
OUTPUTS
source, port = outputs[done]
view = simple.GetActiveViewOrCreate("RenderView")
for display in view.Representations:
    display.Visibility = 0
simple.Show(source[port], view)
proxies = servermanager.ActiveConnection.Session.GetSessionProxyManager()
proxies.GetSelectionModel("ActiveSources").SetCurrentProxy(source.SMProxy.GetOutputPort(port), 3)
count.write_text(str(done + 1))
""".replace("OUTPUTS", OUTPUTS)
BEGIN = """
import os
os.remove("{folder}/selected.txt")
"""
# Colours of names have what the editor needs; and of all that is there, all was selected.
NOTED = """
import pathlib
from paraview import simple
OUTPUTS
assert len(outputs) == int(pathlib.Path("{folder}/selected.txt").read_text())
for array in NAMED:
    assert simple.GetColorTransferFunction(array).ScalarOpacityFunction, array
""".replace("OUTPUTS", OUTPUTS).replace("NAMED", repr(NAMED))
SAVE = """
from paraview import simple
simple.SaveState("{folder}/state.pvsm")
"""


def write_surfaces(folder):
    cube = simple.Triangulate(Input=simple.Box())
    cube.UpdatePipeline()
    data = cube.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    facets = [[data.GetCell(i).GetPoints().GetPoint(j) for j in range(3)] for i in range(data.GetNumberOfCells())]
    with open(folder / "flawed.stl", "w") as file:
        for name, part in ("inlet", facets[:2]), ("wall", facets[3:] + facets[-1:]):
            file.write(f"solid {name}\n")
            for facet in part:
                corners = "".join(f"vertex {x} {y} {z}\n" for x, y, z in facet)
                file.write(f"facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n")
            file.write(f"endsolid {name}\n")
    shutil.copy(REPOSITORY / "Data" / "heated_pipe.step", folder)
    (folder / "square.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng one\nf 1 2 3\ng two\nf 1 3 4\n")


def arrays(output):
    """Those that the toolbar offers for an output, by name: of points and cells."""
    data = output.GetDataInformation().DataInformation
    kinds = [data.GetPointDataInformation(), data.GetCellDataInformation()]
    return list(dict.fromkeys(kind.GetArrayInformation(i).GetName() for kind in kinds for i in range(kind.GetNumberOfArrays())))


def steps():
    """Events that select and colour all that there is in this session."""
    scope = {"simple": simple}
    exec(OUTPUTS, scope)
    missing = PROXIES - IN_CHARTS - {source.SMProxy.GetXMLName() for source, _ in scope["outputs"]}
    assert not missing, missing
    events, done = [], set()
    for source, port in scope["outputs"]:
        source.UpdatePipeline()
        names = [name for name in arrays(source[port]) if name in NAMED or name not in done]
        events += [macro("select"), *map(colour_by, names)]
        done.update(names)
    return events


with Screen(600, 500) as screen:  # drawn quickly
    write_surfaces(screen.folder)
    texts = {name: text.replace("{folder}", str(screen.folder)) for name, text in
        (("build", BUILD), ("select", SELECT), ("save", SAVE), ("begin", BEGIN), ("noted", NOTED))}
    for name, text in texts.items():
        screen.add_macro(name, text)
    exec(texts["build"], {})
    todo = steps()
    assert all(colour_by(array) in todo for array in NAMED)
    show_editor = event("pqClientMainWindow/variableToolbar/actionEditColorMap", "activate")
    said = screen.play(script(show_editor, macro("build"), *todo, macro("noted"), macro("save")))
    assert "ERR|" not in said, said
    print(len(todo), "selected or coloured")

    # As colours of names were saved before they had opacity functions.
    state = screen.folder / "state.pvsm"
    text = state.read_text()
    for array in NAMED:
        colours = re.search(rf'<Item id="(\d+)" name="{array}.PVLookupTable"', text)[1]
        text, found = re.subn(rf'(id="{colours}.ScalarOpacityFunction") number_of_elements="1">.*?</Property>', r"\1/>", text, flags=re.S)
        assert found == 1, array
    state.write_text(text)
    screen.play(script(macro("begin"), *[macro("select")] * todo.count(macro("select")), macro("noted")), f"--state={state}")
