"""Cartesian Boxer, Patcher and Cell Assembler give what Cartesian Mesher gives, bit for bit."""

from paraview import simple

from pipeline import assert_identical, error_code, octahedron, output, polydata, producer, read


def check(name, source, grid={}, patches={}, cells={}):
    boxer = simple.CartesianBoxer(Input=source, **grid)
    patcher = simple.Patcher(Input=source, Boxes=boxer, **patches)
    assembler = simple.CellAssembler(Input=boxer, Patches=patcher, **cells)
    mesher = simple.CartesianMesher(Input=source, **grid, **patches, **cells)
    for port in 0, 1:
        assert_identical(name, output(assembler, port), output(mesher, port))
    print(f"{name}: {output(mesher).GetNumberOfCells()} cells")
    codes = [error_code(filter) for filter in (boxer, assembler)]
    assert error_code(mesher) == max(codes), f"{name}: {error_code(mesher)} instead of {codes}"


exhaust = read("kcl_exhaust_header_lumens.stl")
check("exhaust", exhaust)
check("exhaust, named array", exhaust, {"CellSize": 15}, {"BoundaryArray": "STLSolidLabeling"})
check("spot, small cells removed", read("cino_spot.obj"), cells={"SmallCellRatio": 0.2})
check("spot, other feature angle", read("cino_spot.obj"), {"CellSize": 0.05}, {"FeatureAngle": 12})
check("part between meshlines", read("tm_featuretype_occ.stl"),
    {"CellSize": 4, "MeshlinesX": [-40, -39, 0, 17, 50], "MeshlinesZ": [-10, 10, 20]})
check("exhaust, refined", exhaust, {"CellSize": 30, "RefinementDepth": 2,
    "RefinementBlocks": [0, 2, 0, 3, 0, 1, 3, 1], "BoundaryRefinement": [2, 3, 1, 0],
    "RefinementRegions": simple.Sphere(Center=[70, 200, -100], Radius=50)})
check("exhaust, by its shape", exhaust,
    {"CellSize": 30, "CurvatureAngle": 30, "CellsAcrossGaps": 4, "FeatureDepth": 1})
check("sphere on 1 thread", simple.Sphere(), {"NumberOfThreads": 1})
check("box", simple.Box())

# Flawed: without its last triangle.
whole = octahedron()
points = [whole.GetPoint(i) for i in range(6)]
open_surface = polydata(points, [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5),
                                 (4, 3, 5)])
check("open octahedron", producer(open_surface), {"CellSize": 0.2})
check("not convex", read("tm_not_convex.obj"))
