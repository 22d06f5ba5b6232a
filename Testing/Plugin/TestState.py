"""Saved states, as XML and as Python, keep every property and give the same mesh again."""

import pathlib
import re
import tempfile

from paraview import simple, smstate, smtrace

from pipeline import Messages, assert_identical, output, read

# Boxes not much wider than the pipes: in wider ones, thousands of triangles each, a mesh takes ten times as long.
GRID = {"CellSize": 9.5, "MeshlinesX": [*range(-30, 190, 10), 200.25], "MeshlinesY": [],
        "MeshlinesZ": [*range(-300, 10, 10), 20.5]}
OTHERS = {"NumberOfThreads": 1, "MemoryLimit": 2.5, "BoundaryArray": "STLSolidLabeling",
          "PatchMethod": "Exact Fit", "SmallCellRatio": 0.01,
          "BoundaryNames": ["boundary_1", "boundary_3"], "BoundaryTypes": ["patch", "symmetry"],
          "BoundarySmallCellRatios": [1e-100, 0.25]}
SETTINGS = ["BoundaryNames", "BoundaryTypes", "BoundarySmallCellRatios"]
FILTERS = {"CartesianBoxer": ["NumberOfThreads", "MemoryLimit", *GRID],
           "Patcher": ["NumberOfThreads", "BoundaryArray", "PatchMethod"],
           "CellAssembler": ["NumberOfThreads", *SETTINGS, "SmallCellRatio"],
           "CartesianMesher": [*GRID, *OTHERS]}


def build():
    def make(name, **inputs):
        values = {property: (GRID | OTHERS)[property] for property in FILTERS[name]}
        return getattr(simple, name)(registrationName=name, **inputs, **values)

    source = read("kcl_exhaust_header_lumens.stl")
    boxer = make("CartesianBoxer", Input=source)
    patcher = make("Patcher", Input=source, Boxes=boxer)
    make("CellAssembler", Input=boxer, Patches=patcher)
    make("CartesianMesher", Input=source)


def check(mesh):
    """All is there again, in a session that was emptied or is new."""
    for filter, properties in FILTERS.items():
        proxy = simple.FindSource(filter)
        assert proxy, f"there is no {filter}"
        for name in properties:
            value = proxy.GetPropertyValue(name)
            value = list(value) if isinstance((GRID | OTHERS)[name], list) else value
            assert value == (GRID | OTHERS)[name], f"{name} of {filter} is {value}"
    for filter in "CartesianMesher", "CellAssembler":
        assert_identical(filter, output(simple.FindSource(filter)), mesh)


build()
mesh = output(simple.FindSource("CartesianMesher"))
assert mesh.GetNumberOfCells() > 50
check(mesh)
with tempfile.TemporaryDirectory() as folder:
    state, script = (pathlib.Path(folder) / name for name in ("state.pvsm", "state.py"))
    simple.SaveState(str(state))
    script.write_text(smstate.get_state())

    simple.ResetSession()
    simple.LoadState(str(state))
    check(mesh)
    # Columns of tables that the state has not are as those of new rows: the panel would show no rows.
    mesher = simple.FindSource("CartesianMesher")
    assert list(mesher.BoundaryDepths) == list(mesher.BoundaryLayersThickness) == [-1, -1], list(mesher.BoundaryDepths)
    assert list(mesher.BoundaryMergedNames) == ["", ""] and list(mesher.RefinementShapeDepths) == [], list(mesher.BoundaryMergedNames)


    # A state from before properties were there keeps the mesh that it had.
    simple.ResetSession()
    text = state.read_text()
    for name in "SideNames", "BoxesAlongBody", "TransitionLayers", "LengthUnit":
        text, found = re.subn(rf'<Property name="{name}".*?</Property>', "", text, flags=re.S)
        assert found >= 1, name
    state.write_text(text)
    simple.LoadState(str(state))
    mesher = simple.FindSource("CartesianMesher")
    assert (mesher.SideNames, mesher.BoxesAlongBody, mesher.TransitionLayers, mesher.LengthUnit) == ("Axes", 0, 1, "Metre"), mesher.SideNames
    assert simple.FindSource("CartesianBoxer").TransitionLayers == 1

    # Refined Boundaries become rows of the table of boundaries, unless it has patterns.
    for names, depths, rows in (
            (["boundary_3", "boundary_1"], [1, -1], {"boundary_3": 1, "boundary_1": 2, "boundary_2": 2}),
            ([], [], {"boundary_1": 2, "boundary_2": 2}),
            (["boundary_3*"], [1], {"boundary_3*": 1})):
        simple.ResetSession()
        older = output(simple.CartesianMesher(registrationName="older", Input=read("kcl_exhaust_header_lumens.stl"), CellSize=20,
            BoundaryArray="STLSolidLabeling", BoundaryNames=names, BoundaryDepths=depths,
            RefinedBoundaries=["boundary_1", "boundary_2"], RefinedBoundaryDepth=2))
        simple.SaveState(str(state))
        simple.ResetSession()
        with Messages() as said:
            simple.LoadState(str(state))
        mesher = simple.FindSource("older")
        assert ("rows of the table Boundaries" in str(said)) == ("boundary_3*" not in rows), said
        assert dict(zip(mesher.BoundaryNames, mesher.BoundaryDepths)) == rows, list(mesher.BoundaryNames)
        assert len(mesher.BoundaryTypes) == len(rows), "the panel shows no rows where columns differ in length"
        assert list(mesher.RefinedBoundaries) == (["boundary_1", "boundary_2"] if "boundary_3*" in rows else [])
        assert_identical("with Refined Boundaries", output(mesher), older)

    simple.ResetSession()
    exec(compile(script.read_text(), script, "exec"), {})
    check(mesh)

# What the window's Start Trace records.
simple.ResetSession()
smtrace.start_trace()
build()
trace = smtrace.stop_trace()
simple.ResetSession()
exec(compile(trace, "trace", "exec"), {})
check(mesh)
