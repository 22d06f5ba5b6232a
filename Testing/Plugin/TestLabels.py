"""Labels without spaces are the filters' and properties' names in Python: users' scripts and
saved states depend on them and on the defaults."""

from paraview import simple

grid = {"CellSize": 0.0, "MeshlinesX": [], "MeshlinesY": [], "MeshlinesZ": []}
refinement = {"RefinementDepth": 0, "RefinementBlocks": [], "BoundaryRefinement": [],
              "RegionDepth": 1}
boundaries = {"BoundaryArray": ""}
patches = {"PatchMethod": "Exact Fit"}
cells = {"SmallCells": "Merge", "MergeRatio": 0.1, "SmallCellRatio": 0.001,
         "SplitConcaveCells": 1}
threads = {"NumberOfThreads": 0}
memory = {"MemoryLimit": 0.0}

surface = simple.Sphere()
boxer = simple.CartesianBoxer(Input=surface)
patcher = simple.Patcher(Input=surface, Boxes=boxer)
assembler = simple.CellAssembler(Input=boxer, Patches=patcher)
mesher = simple.CartesianMesher(Input=surface)

expected = {
    boxer: ("Cartesian Boxer", ["Input", "RefinementRegions"],
            boundaries | grid | refinement | threads | memory),
    patcher: ("Patcher", ["Input", "Boxes"], boundaries | patches | threads),
    assembler: ("Cell Assembler", ["Input", "Patches"], cells | threads),
    mesher: ("Cartesian Mesher", ["Input", "RefinementRegions"],
             boundaries | grid | refinement | patches | cells | threads | memory),
}
for proxy, (label, inputs, properties) in expected.items():
    assert proxy.GetXMLLabel() == label, proxy.GetXMLLabel()
    names = sorted(proxy.ListProperties())
    assert names == sorted(inputs + list(properties)), f"{label} has the properties {names}"
    for name, default in properties.items():
        value = proxy.GetPropertyValue(name)
        value = list(value) if isinstance(default, list) else value
        assert value == default, f"the default of {name} of {label} is {value!r}"

for proxy in assembler, mesher:
    ports = [proxy.GetOutputPortName(i) for i in range(proxy.GetNumberOfOutputPorts())]
    assert ports == ["Mesh", "Boundary"], ports
