"""Labels without spaces are the filters' and properties' names in Python: users' scripts and
saved states depend on them and on the defaults."""

from paraview import simple

grid = {"CellSize": 0.0, "MeshlinesX": [], "MeshlinesY": [], "MeshlinesZ": []}
refinement = {"RefinementDepth": 0, "RefinementBlocks": [], "BoundaryRefinement": [],
              "RegionDepth": 1}
boundaries = {"BoundaryArray": ""}
patches = {"PatchMethod": "Automatic", "FeatureAngle": 30.0, "MergeAngle": 10.0,
           "Tying": "Keep Nodes"}
cells = {"SmallCellRatio": 0.001}
threads = {"NumberOfThreads": 0}
memory = {"MemoryLimit": 0.0}

surface = simple.Sphere()
boxer = simple.CartesianBoxer(Input=surface)
patcher = simple.Patcher(Input=surface, Boxes=boxer)
assembler = simple.CellAssembler(Input=boxer, Patches=patcher)
mesher = simple.CartesianMesher(Input=surface)
inspector = simple.SurfaceInspector(Input=surface)
quality = simple.FiniteVolumeQuality(Input=mesher)

expected = {
    boxer: ("Cartesian Boxer", ["Input", "RefinementRegions"],
            boundaries | grid | refinement | threads | memory),
    patcher: ("Patcher", ["Input", "Boxes"], boundaries | patches | threads),
    assembler: ("Cell Assembler", ["Input", "Patches"], cells | threads),
    mesher: ("Cartesian Mesher", ["Input", "RefinementRegions"],
             boundaries | grid | refinement | patches | cells | threads | memory),
    inspector: ("Surface Inspector", ["Input"], grid | threads | memory),
    quality: ("Finite Volume Quality", ["Input"], threads),
}
for proxy, (label, inputs, properties) in expected.items():
    assert proxy.GetXMLLabel() == label, proxy.GetXMLLabel()
    names = sorted(proxy.ListProperties())
    assert names == sorted(inputs + list(properties)), f"{label} has the properties {names}"
    for name, default in properties.items():
        value = proxy.GetPropertyValue(name)
        value = list(value) if isinstance(default, list) else value
        assert value == default, f"the default of {name} of {label} is {value!r}"

for proxy, names in (
    (assembler, ["Mesh", "Boundary"]), (mesher, ["Mesh", "Boundary", "Defects"]),
    (quality, ["Mesh", "Faces"]),
):
    ports = [proxy.GetOutputPortName(i) for i in range(proxy.GetNumberOfOutputPorts())]
    assert ports == names, ports

writer = simple.CreateWriter("case.foam", mesher)
assert writer.GetXMLLabel() == "OpenFOAM Mesh Writer", writer.GetXMLLabel()
assert sorted(writer.ListProperties()) == ["FileName", "FileType", "Input"]
assert writer.FileType == "Binary"
