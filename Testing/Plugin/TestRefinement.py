"""Refinement through the filters: tables, regions, all kinds together; the mesh stays valid and
exact, and what is wrong in a table is said."""

import cartesianmesher.vtkCartesianMesherFilters  # noqa: F401: for ExpectCellSizeAlone
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import measure
from pipeline import DATA, Messages, assert_identical, error_code, octahedron, output, producer, read

BAD_PARAMETER = 40008


def check(name, source, **properties):
    """Meshes with 6 boxes along the longest side, measures, compares with the surface."""
    surface = output(source)
    bounds = surface.GetBounds()
    size = max(high - low for low, high in zip(bounds[0::2], bounds[1::2])) / 6
    mesher = simple.CartesianMesher(
        Input=source, CellSize=size, SmallCellRatio=1e-9, PatchMethod="Exact Fit", **properties)
    try:
        mesh = measure.Mesh(output(mesher), output(mesher, 1))
        measure.Surface(surface, "STLSolidLabeling").check(mesh.volume, mesh.areas)
    except AssertionError as error:
        raise AssertionError(f"{name}: {error}") from error
    level = vtk_to_numpy(output(mesher).GetCellData().GetArray("Level"))
    print(f"{name}: {mesh.cells} cells, deepest level {level.max()}")
    simple.Delete(mesher)
    return level


exhaust, part, spot = (read(name) for name in (
    "kcl_exhaust_header_lumens.stl", "tm_featuretype_occ.stl", "cino_spot.obj"))
blocks = [0, 2, 0, 3, 0, 1, 2, 2,
          3, 6, 1, 5, 0, 7, 3, 0]
for name, source, depth in ("exhaust", exhaust, 1), ("part", part, 3), ("spot", spot, 2):
    level = check(f"{name}, depth {depth}", source, RefinementDepth=depth)
    assert level.max() == depth
    check(f"{name}, by its shape", source, CurvatureAngle=25, CellsAcrossGaps=3, FeatureDepth=1,
          LargestDepth=2)
    with Messages():  # blocks reach beyond the grid of some
        check(f"{name}, blocks", source, RefinementBlocks=blocks)
        bounds = output(source).GetBounds()
        ball = simple.Sphere(Center=[sum(bounds[i:i + 2]) / 2 for i in (0, 2, 4)],
                             Radius=(bounds[1] - bounds[0]) / 4)
        check(f"{name}, region", source, RefinementRegions=ball, RegionDepth=2)
        check(f"{name}, boundary", source, BoundaryRefinement=[0, 3, 1, 0])
        check(f"{name}, all together", source, RefinementDepth=1, RefinementBlocks=blocks,
              BoundaryRefinement=[0, 2, 2, 1], RefinementRegions=ball, RegionDepth=3)

# A box as a region: the boxes that touch it, and no others, must be halved.
region = simple.Box(XLength=0.6, YLength=0.6, ZLength=0.6)
boxer = simple.CartesianBoxer(Input=producer(octahedron()), CellSize=0.25,
                              RefinementRegions=region, RegionDepth=1)
boxes = output(boxer)
level = vtk_to_numpy(boxes.GetCellData().GetArray("Level"))
bounds = [boxes.GetCell(cell).GetBounds() for cell in range(boxes.GetNumberOfCells())]
touches = [all(low < 0.3 and high > -0.3 for low, high in zip(b[0::2], b[1::2])) for b in bounds]
assert any(touches) and level[touches].min() == 1
# Boxes beside the region are halved only where the others leave no larger box: here along one axis or two,
# and at the corners of the region along all.
beside = level[[not touch for touch in touches]]
assert beside.max() == 1 and beside.min() == 0 and (beside.min(axis=1) == 1).mean() < 0.1


# The same box as a row of the mesher's own panel; and round shapes, which touch fewer.
def shape(name, **changed):
    row = {"RefinementShapes": [name], "RefinementPositions": [-0.4, 0.1, -0.2], "RefinementLengths": [0.3, 0.2, 0.4],
        "RefinementShapeDepths": [2]} | changed
    return simple.CartesianBoxer(Input=spot, CellSize=0.1, **row)


region = simple.RefinementRegion(Input=spot, Position=[-0.4, 0.1, -0.2], Length=[0.3, 0.2, 0.4], Depth=2)
assert_identical("a row", output(shape("box")), output(simple.CartesianBoxer(Input=spot, CellSize=0.1, RefinementRegions=region)))
assert output(shape("CYLINDERx")).GetNumberOfCells() == output(shape("cylinderX")).GetNumberOfCells()  # in any case
counts = {name: output(shape(name)).GetNumberOfCells() for name in ("box", "cylinderX", "cylinderY", "cylinderZ", "sphere")}
plain = output(simple.CartesianBoxer(Input=spot, CellSize=0.1)).GetNumberOfCells()
assert all(plain < counts["sphere"] <= counts[name] < counts["box"] for name in counts if name.startswith("c")), counts
with Messages() as text:
    for wrong in shape("cone"), shape("box", RefinementLengths=[1, 0, 1]), shape("box", RefinementShapeDepths=[]), \
            shape("box", RefinementShapeDepths=[13]):
        assert output(wrong).GetNumberOfCells() == 0 and error_code(wrong) == BAD_PARAMETER


def refused(words, **properties):
    mesher = simple.CartesianMesher(Input=spot, **properties)
    with Messages() as text:
        cells = output(mesher).GetNumberOfCells()
    assert error_code(mesher) == BAD_PARAMETER, (error_code(mesher), str(text))
    assert cells == 0 and words in str(text), str(text)
    simple.Delete(mesher)


refused("no boundary 3", BoundaryRefinement=[3, 1, 0, 0])
refused("runs backward", RefinementBlocks=[4, 2, 0, 3, 0, 1, 1, 1])
refused("must be from 0 to 12", RefinementBlocks=[0, 2, 0, 3, 0, 1, 13, 0])
refused("is not a whole number", RefinementBlocks=[0, 2.5, 0, 3, 0, 1, 1, 0])

mesher = simple.CartesianMesher(Input=spot, RefinementBlocks=[0, 2, 0, 3, 45, 99, 1, 1])
with Messages() as text:
    cells = output(mesher).GetNumberOfCells()
assert cells > 0 and error_code(mesher) == 0
assert "row 0 of Refinement Blocks" in str(text) and "K from 45 to 99" in str(text), str(text)

# How many boxes there will be is known before anything is meshed, and follows the surface and the size.
def expected_rows(mesher):
    """Of the texts of the table: sizes, numbers of boxes and of cells, memory; and the row that is asked for."""
    mesher.UpdatePipelineInformation()
    texts = list(mesher.ExpectedBoxes)
    rows = [texts[i:i + 4] for i in range(0, len(texts), 4)]
    assert rows[0] == ["Cell size", "≈ Boxes", "≈ Cells", "≈ Memory"], rows
    asked, = (row for row in rows if row[0].startswith("→ "))
    return [row[0].removeprefix("→ ") for row in rows[1:]], \
        float(asked[0][2:]), *(float(text.replace(",", "")) for text in asked[1:3]), asked[3]


def expected_boxes(mesher):
    return expected_rows(mesher)[2]


mesher = simple.CartesianMesher(Input=spot)
for size in 0, 0.1:
    for depth in range(3):
        mesher.CellSize, mesher.RefinementDepth = size, depth
        sizes, applied, boxes, cells, memory = expected_rows(mesher)
        assert applied == size or 0.0343 < applied < 0.0345, applied
        made = output(simple.CartesianBoxer(Input=spot, CellSize=applied, RefinementDepth=depth)).GetNumberOfCells()
        assert 0.85 < boxes / made < 1.15, f"{boxes}, in truth {made}"
        assert 0.5 * boxes < cells < boxes and memory.endswith("MiB"), (boxes, cells, memory)
assert sizes == ["0.1", "0.0687", "0.0344", "0.0172", "0.00859"], sizes
assert mesher.SurfaceSize == "0.9489 × 1.717 × 1.668" or mesher.SurfaceSize.count(" × ") == 2, mesher.SurfaceSize
# ... alone, until something changes
rows = expected_rows(mesher)
mesher.GetClientSideObject().ExpectCellSizeAlone()
assert expected_rows(mesher) == (["0.1"], *rows[1:]), rows
mesher.CellSize = 0.0687
assert len(expected_rows(mesher)[0]) == 4
# ... and layers.
mesher = simple.CartesianMesher(Input=spot, CellSize=0.06, Layers=4)
*_, cells, _ = expected_rows(mesher)
assert 0.7 < cells / output(mesher).GetNumberOfCells() < 1.3, cells
# ... and the refinement of boundaries, in rows and by names.
header = simple.OpenDataFile(str(DATA / "kcl_exhaust_header_lumens.stl"))
header.UpdatePipeline()
for properties in ({"BoundaryRefinement": [0, 2, 0, 0, 3, 2, 0, 0]},
                   {"RefinedBoundaries": ["wall_1", "wall_2"], "RefinedBoundaryDepth": 2}):
    mesher = simple.CartesianMesher(Input=header, CellSize=6, **properties)
    expected = expected_boxes(mesher)
    plain, made = (output(simple.CartesianBoxer(Input=header, CellSize=6, **refinement)).GetNumberOfCells()
        for refinement in ({}, properties))
    assert made > 1.5 * plain and 0.8 < expected / made < 1.2, (expected, plain, made)
# ... and what else refines, where it is and where the surface asks for it: of grids where that makes at least half as many boxes
# again.
sphere = simple.RefinementRegion(Input=header, Shape="Sphere", Radius=90, Depth=2)
sphere.UpdatePipeline()
plain = output(simple.CartesianBoxer(Input=header, CellSize=12)).GetNumberOfCells()
for properties in ({"RefinementRegions": sphere}, {"BoundaryRefinement": [0, 2, 2, 0]}, {"FeatureDepth": 2},
                   {"CurvatureAngle": 30, "CellsAcrossGaps": 3}):
    mesher = simple.CartesianBoxer(Input=header, CellSize=12, **properties)
    made = output(mesher).GetNumberOfCells()
    expected = expected_boxes(mesher)
    assert made > 1.5 * plain and 0.7 < expected / made < 1.4, (properties, expected, plain, made)
# Numbers are whole, at least 1, and written with no more digits than they have.
mesher = simple.CartesianMesher(Input=spot, CellSize=1e-10)
for size in 1e-10, 5:
    mesher.CellSize = size
    *_, boxes, cells, _ = expected_rows(mesher)
    assert all(number >= 1 and number == round(number) and float(f"{number:.2g}") == number for number in (boxes, cells)), (boxes, cells)
# Nothing is expected of what would be refused.
mesher.BoundaryNames = ["nobody"]
mesher.BoundaryTypes = ["wall"]
mesher.UpdatePipelineInformation()
assert list(mesher.ExpectedBoxes) == [], list(mesher.ExpectedBoxes)
