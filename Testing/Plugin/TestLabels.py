"""Labels without spaces are the filters' and properties' names in Python: users' scripts and
saved states depend on them and on the defaults."""

from paraview import simple

grid = {"CellSize": 0.0, "MeshlinesX": [], "MeshlinesY": [], "MeshlinesZ": []}
refinement = {"RefinementDepth": 0, "TransitionLayers": 0, "IsotropicLevels": 0, "PeriodicSides": "None", "RefinementBlocks": [], "BoundaryRefinement": [],
              "RefinedBoundaries": [], "RefinedBoundaryDepth": 1, "RegionDepth": 1,
              "CurvatureAngle": 0.0, "CellsAcrossGaps": 0, "LargestDepth": 3, "FeatureDepth": 0,
              "SizeArray": "", "RefinementShapes": [], "RefinementPositions": [], "RefinementLengths": [],
              "RefinementShapeDepths": [], "BoundaryNames": [], "BoundaryDepths": []}
boundaries = {"BoundaryArray": "Automatic"}
patches = {"PatchMethod": "Automatic", "FeatureAngle": 30.0, "MergeAngle": 10.0,
           "Tying": "Keep Nodes"}
cells = {"CollapseRatio": 0.1, "SmallCells": "Merge", "MergeRatio": 0.3, "SmallCellRatio": 0.001,
         "SplitConcaveCells": 1, "TrueVolume": 1, "OptimiseNodes": 1, "RefusedCellRatio": 4}
layers = {"Layers": 0, "LayerExpansionRatio": 1.2, "FirstLayerThickness": 0.0, "LayersThickness": 0.0,
          "LastLayer": 0.1, "RefineForLayers": 1, "TargetYPlus": 0.0, "LengthUnit": "From Input", "FlowSpeed": 10.0, "FlowViscosity": 1.5e-5, "FlowLength": 0.0,
          "LayerRegions": [], "CellBudget": 0, "BoundaryLayersThickness": [],
          "BoundaryMergedNames": []}
settings = {"BoundaryNames": [], "BoundaryTypes": [], "BoundarySmallCellRatios": []}
threads = {"NumberOfThreads": 0}
memory = {"MemoryLimit": 0.0}
pieces = {"InPieces": 1}
preview = {"Preview": 1}
regions = {"RegionsFrom": "One", "RegionArray": "", "ContactTolerance": 0.0, "CrackWidth": 0.0, "CloseGaps": 0.0, "Sheets": "Automatic"}
domain = {"Domain": "Inside", "BoxFrom": "Surface", "DomainBounds": [0, 1, 0, 1, 0, 1],
          "FlowDirection": "Plus X", "LengthsBefore": 3, "LengthsBehind": 5, "LengthsBeside": 3,
          "Ground": "None", "Half": "None", "SideNames": "Flow", "BoxesAlongBody": 60, "KeepPoints": [], "KeepOut": []}

surface = simple.Sphere()
cube = simple.Box()
cube.UpdatePipeline()
boxer = simple.CartesianBoxer(Input=surface)
patcher = simple.Patcher(Input=surface, Boxes=boxer)
assembler = simple.CellAssembler(Input=boxer, Patches=patcher)
mesher = simple.CartesianMesher(Input=surface)
cad = simple.CADReader()
inspector = simple.SurfaceInspector(Input=surface)
split = simple.SplitSurface(Input=surface)
divided = simple.DividePolyhedra(Input=mesher)
section = simple.SlicePolyhedra(Input=mesher)
flat = simple.FlatMesh(Input=mesher)
periodic = simple.PeriodicBoundaries(Input=mesher)
quality = simple.FiniteVolumeQuality(Input=mesher)
summary = simple.MeshSummary(Input=mesher)
histogram = simple.QualityHistogram(Input=mesher)
region = simple.RefinementRegion(Input=cube)

expected = {
    boxer: ("Cartesian Boxer", ["Input", "RefinementRegions", "SizeField"],
            boundaries | grid | refinement | threads | memory | preview),
    patcher: ("Patcher", ["Input", "Boxes"], boundaries | patches | threads),
    assembler: ("Cell Assembler", ["Input", "Patches"], cells | settings | threads),
    mesher: ("Cartesian Mesher", ["Input", "RefinementRegions", "SizeField"],
             boundaries | grid | refinement | patches | cells | settings | threads | memory
             | pieces | regions | domain | layers | preview),
    cad: ("CAD Reader", [], {"FileName": "", "Deflection": 0.0, "Angle": 10.0, "LengthUnit": "Metre", "Scale": 1.0,
        "BoundaryNamesFrom": "Automatic", "HealTolerance": 0.0, "GlueSolids": 1, "MergeCoplanar": 0,
        "KeepDamagedFaces": 0, "NameEncoding": "Automatic", "TimeLimit": 1800.0}),
    inspector: ("Surface Inspector", ["Input"], grid | threads | memory),
    split: ("Split Surface", ["Input", "Selection"], boundaries | threads | {"SplitBy": "Flat Caps", "FeatureAngle": 30.0,
        "CapNames": "cap", "BoundaryNames": [], "BoundaryMergedNames": [], "SelectedCells": [], "SelectionName": "selected",
        "SelectWholePatches": 1}),
    divided: ("Divide Polyhedra", ["Input"], threads | memory),
    flat: ("Flat Mesh", ["Input"], threads | {"Across": "Z", "Shape": "Plane", "Thickness": 0, "Axis": "X", "AxisOrigin": [0, 0, 0],
        "WedgeAngle": 5}),
    periodic: ("Periodic Boundaries", ["Input"], threads | {"FirstBoundary": "", "SecondBoundary": "", "Motion": "Translation", "Axis": [0, 0, 1],
        "AxisOrigin": [0, 0, 0], "Faces": "Same"}),
    section: ("Slice Polyhedra", ["Input"], threads | {"Origin": [0, 0, 0], "Normal": [1, 0, 0], "Offsets": [0]}),
    quality: ("Finite Volume Quality", ["Input"], threads | {"OpennessLimit": 1e-6, "BoundaryAngleLimit": 90,
        "InnerAngleLimit": 75, "NonOrthogonalityLimit": 70, "SkewnessLimit": 4, "FaceWeightLimit": 0.05,
        "VolumeRatioLimit": 0.01, "DeterminantLimit": 0.001, "AspectRatioLimit": 1000, "ShowFailingCells": None}),
    summary: ("Mesh Summary", ["Input"], threads | {"Measure": "Skewness", "NumberOfWorstCells": 10, "ShowFailingCells": None}),
    histogram: ("Quality Histogram", ["Input"], threads | {"Measure": "Skewness", "Bins": 50}),
    # A box has an eighth of its input's bounding box at first, a sphere a fifth of its length.
    region: ("Refinement Region", ["Input"], {"Shape": "Box", "Position": [0, 0, 0],
        "Rotation": [0, 0, 0], "Length": [0.5, 0.5, 0.5], "Center": [0, 0, 0], "Radius": 0.1,
        "Depth": 1}),
}
for proxy, (label, inputs, properties) in expected.items():
    assert proxy.GetXMLLabel() == label, proxy.GetXMLLabel()
    names = sorted(name for name in proxy.ListProperties()
        if not proxy.GetProperty(name).SMProperty.GetInformationOnly())
    assert names == sorted(inputs + list(properties)), f"{label} has the properties {names}"
    for name, default in properties.items():
        if default is None:
            assert proxy.GetProperty(name).SMProperty.GetClassName() == "vtkSMProperty", f"{name} is no button"
            continue
        value = proxy.GetPropertyValue(name)
        value = list(value) if isinstance(default, list) else value
        assert value == default, f"the default of {name} of {label} is {value!r}"

# All that a panel shows is explained.
for proxy in expected:
    for name in proxy.ListProperties():
        property = proxy.GetProperty(name).SMProperty
        text = property.GetDocumentation().GetDescription() if property.GetDocumentation() else ""
        assert property.GetPanelVisibility() == "never" or len(text) > 20, f"{name} of {proxy} is not explained"

for proxy, names in (
    (assembler, ["Mesh", "Boundary"]), (mesher, ["Mesh", "Boundary", "Defects", "Interfaces"]),
    (quality, ["Mesh", "Faces", "Failing Cells"]), (summary, ["Summary", "Worst Cells", "Failing Cells"]),
    (histogram, ["Histogram", "Bins"]),
):
    ports = [proxy.GetOutputPortName(i) for i in range(proxy.GetNumberOfOutputPorts())]
    assert ports == names, ports

writer = simple.CreateWriter("case.foam", mesher)
assert writer.GetXMLLabel() == "OpenFOAM Mesh Writer", writer.GetXMLLabel()
case = {"NewFolder": 0, "FileType": "Binary", "RegionsAs": "Meshes", "ZoneRegions": [], "ZoneBorders": "Face Zones", "Pieces": 1, "Scale": 0,
        "SolverSetup": "None", "Turbulence": "kOmegaSST", "Speed": 0, "Viscosity": 0, "InletTemperature": 350,
        "Iterations": 0, "OverwriteSetup": 0, "CaseTemplates": "", "Density": 1.2, "EndTime": 1, "WriteInterval": 0, "TimeStep": 0,
        "CourantNumber": 1} | dict.fromkeys((
            "ConditionBoundaries", "ConditionFlows", "ConditionFlowValues", "ConditionHeats", "ConditionHeatValues",
            "ConditionTurbulenceIntensities", "ConditionTurbulenceLengths", "MaterialRegions", "Materials", "MaterialDensities",
            "MaterialHeatCapacities", "MaterialConductivities", "MaterialViscosities", "HeatSources", "RotationZones", "RotationSpeeds",
            "RotationOrigins", "RotationAxes", "StillBoundaries"), [])
assert sorted(writer.ListProperties()) == sorted(["FileName", "Input", "NamesOfRegions", *case])
assert {name: writer.GetPropertyValue(name) for name in case} == case
for suffix, label in (("cgns", "CGNS Mesh"), ("msh", "Fluent Mesh"), ("case", "EnSight Mesh"), ("vtm", "Region Blocks"),
                      ("vtpc", "Region Blocks"), ("html", "Mesh Report")):
    writer = simple.CreateWriter(f"mesh.{suffix}", mesher)
    assert writer.GetXMLLabel() == f"{label} Writer", writer.GetXMLLabel()
    assert sorted(writer.ListProperties()) == ["FileName", "Input"]
