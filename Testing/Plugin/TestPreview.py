"""What a preview shows is what is meshed then: the depths of boxes along the surface, where the grid ends, and the names of its
sides."""

import cartesianmesher.vtkCartesianMesherFilters as filters
import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

from pipeline import error_code, output

body = simple.Triangulate(Input=simple.Sphere(ThetaResolution=40, PhiResolution=30))
block = simple.Triangulate(Input=simple.Box(XLength=1, YLength=3, ZLength=1))


def preview(source):
    """Of a filter's values: the four outputs, and the depths and sizes of the legend."""
    proxy = servermanager.ProxyManager().NewProxy("internal_filters", "MeshPreview")
    properties = source.SMProxy.NewPropertyIterator()
    properties.UnRegister(None)
    properties.Begin()
    while not properties.IsAtEnd():
        if proxy.GetProperty(properties.GetKey()):
            proxy.GetProperty(properties.GetKey()).Copy(properties.GetProperty())
        properties.Next()
    proxy.UpdateVTKObjects()
    proxy.UpdatePipeline()
    filter = proxy.GetClientSideObject()
    legend = [filter.GetBoxSizes().GetValue(i) for i in range(filter.GetBoxSizes().GetNumberOfValues())]
    return [filter.GetOutputDataObject(i) for i in range(4)], dict(zip(map(int, legend[::2]), legend[1::2]))


def arrays(surface):
    return [vtk_to_numpy(surface.GetCellData().GetArray(name)) for name in ("Depth", "BoxSize")]


def centres(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData())
    return points[vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)].mean(axis=1)


def compare(several, **properties):
    """Box by box, with Cartesian Boxer's. `several`: boxes beside smaller ones may be smaller than shown, for the transition, but most
    are not."""
    source = simple.CartesianBoxer(Input=body, **properties)
    boxes = output(source)
    assert error_code(source) == 0
    (surface, lines, labels, _), legend = preview(source)
    assert lines.GetNumberOfCells() == labels.GetNumberOfCells() == 0, "there is no flow domain"
    locator = vtkStaticCellLocator()
    locator.SetDataSet(boxes)
    locator.BuildLocator()
    cells = np.array([locator.FindCell(point) for point in centres(surface)])
    assert (cells >= 0).all()
    levels = vtk_to_numpy(boxes.GetCellData().GetArray("Level")).max(axis=1)[cells].astype(int)
    edges = np.array([max(high - low for low, high in zip(*[iter(boxes.GetCell(int(i)).GetBounds())] * 2)) for i in np.unique(cells)])
    edges = edges[np.unique(cells, return_inverse=True)[1]]
    depths, sizes = arrays(surface)
    same = levels == depths
    assert (levels >= depths).all() and (same.mean() > 0.5 if several else same.all()), (properties, same.mean())
    assert np.allclose(sizes[same], edges[same], rtol=1e-6), properties
    assert set(depths) <= set(legend) and (len(set(depths)) > 1) == several, (properties, set(depths), legend)
    return depths


compare(False, CellSize=0.1)
compare(False)  # the default size
compare(False, CellSize=0.2, RefinementDepth=2)
compare(False, CellSize=0.2, RefinementDepth=1, BoundaryNames=["*"], BoundaryDepths=[3])
compare(True, CellSize=0.1, RefinementBlocks=[0, 4, 0, 9, 0, 9, 2, 0])
shape = {"RefinementShapes": ["sphere"], "RefinementPositions": [0.1, -0.3, -0.3], "RefinementLengths": [0.6, 0.6, 0.6],
    "RefinementShapeDepths": [3]}
(_, _, _, zones), legend = preview(simple.CartesianBoxer(Input=body, CellSize=0.2, **shape))
assert zones.GetNumberOfLines() == zones.GetNumberOfCells() > 0 and legend[3] == "0.025", legend
assert np.allclose(zones.GetBounds(), [0.1, 0.7, -0.3, 0.3, -0.3, 0.3], atol=0.01), zones.GetBounds()  # of a sphere, sections
depths = compare(True, CellSize=0.2, **shape)
assert set(depths) <= {0, 1, 2, 3} and {0, 3} <= set(depths)
compare(True, CellSize=0.25, RefinementRegions=[simple.RefinementRegion(Input=body, Shape="Sphere", Center=[0.4, 0, 0], Radius=0.2, Depth=2)])
compare(True, CellSize=0.2, CurvatureAngle=12, LargestDepth=2, **shape)

# The domain: the box is where the mesh ends, to the last bit, and its sides' names are those of the mesh there.
for properties in ({}, {"Ground": "zMin"}, {"Half": "Across X", "FlowDirection": "Minus Y"}, {"SideNames": "Axes", "Ground": "yMax"},
        {"BoxFrom": "Bounds", "DomainBounds": [-2, 3, -4, 4, -2, 2.5]}, {"MeshlinesX": [-3, -2, -1, 0, 1, 2.5, 4]},
        {"FlowDirection": "Plus Z", "LengthsBefore": 0.5, "CellSize": 0.37}):
    mesher = simple.CartesianMesher(Input=block, **({"Domain": "Outside", "CellSize": 0.5, "LengthsBefore": 1, "LengthsBehind": 1,
        "LengthsBeside": 1, "BoxesAlongBody": 24} | properties))
    mesh, boundary = output(mesher), output(mesher, 1)
    assert error_code(mesher) == 0
    (surface, lines, labels, zones), legend = preview(mesher)
    corners = np.array([lines.GetPoint(i) for i in range(8)])  # of the box; an arrow follows
    box = [end(corners[:, axis]) for axis in range(3) for end in (min, max)]
    assert tuple(box) == mesh.GetBounds(), (properties, box, mesh.GetBounds())
    names = boundary.GetCellData().GetAbstractArray("BoundaryName")
    faces = np.array([boundary.GetCell(i).GetBounds() for i in range(boundary.GetNumberOfCells())])
    for i in range(6):
        axis, text = i // 2, labels.GetPointData().GetAbstractArray("Label").GetValue(i)
        plane = box[i]
        assert labels.GetPoint(i)[axis] == plane, (properties, text)
        there = {names.GetValue(j) for j in np.nonzero((faces[:, 2 * axis] == plane) & (faces[:, 2 * axis + 1] == plane))[0]}
        assert text in there, (properties, text, there)
    arrow = np.array([lines.GetPoint(i) for i in range(8, lines.GetNumberOfPoints())])
    along = vtk_to_numpy(mesh.GetFieldData().GetArray("FlowDirection"))[0]
    inlet = min(np.array(box).reshape(3, 2)[np.argmax(np.abs(along))] * along.sum())
    assert ((arrow @ along) < inlet).all(), (properties, "the arrow is upstream of the box")
    depths, sizes = arrays(surface)
    assert sizes.max() * 24 <= 3 * (1 + 1e-7), (properties, sizes.max())
    mesher.UpdatePipelineInformation()
    told = list(mesher.FlowZones)[8:]  # rows of four: after the titles, and what is along the surface
    shown = vtk_to_numpy(zones.GetCellData().GetArray("Depth")) if zones.GetNumberOfCells() > 0 else []
    assert list(shown) == [int(depth) for depth in told[1::4] for _ in range(12)], (properties, shown, told)
    assert set(shown) <= set(legend), (properties, shown, legend)
    assert int(list(mesher.FlowZones)[5]) == depths.max() == depths.min(), properties

# A note where the body lies across the flow, unless it stands there or no flow is named; no warning of it.
for properties, noted in (({}, True), ({"FlowDirection": "Plus Y"}, False), ({"FlowDirection": "Minus Z"}, True), ({"Ground": "yMin"}, False),
        ({"Domain": "Inside"}, False), ({"SideNames": "Axes"}, True),
        ({"SideNames": "Axes", "BoxFrom": "Bounds", "DomainBounds": [-9, 9, -9, 9, -9, 9]}, False)):
    mesher = simple.CartesianMesher(Input=block, **({"Domain": "Outside"} | properties))
    mesher.UpdatePipelineInformation()
    text = mesher.DomainNote
    assert bool(text) == noted and (not noted or "Plus Y or Minus Y" in text and "3 long along y" in text), (properties, text)

# What cannot be meshed has no preview, and no message.
bad = filters.vtkMeshPreview()
bad.SetInputData(output(block))
bad.SetCellSize(-1)
bad.SetDomainToOutside()
bad.Update()
assert bad.GetErrorCode() == 0 and not bad.GetOutputDataObject(0).GetCellData().GetArray("Depth")
assert bad.GetOutputDataObject(1).GetNumberOfCells() > 0, "the domain does not depend on the cell size"
