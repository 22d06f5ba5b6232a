"""A mesh of several regions as an OpenFOAM case: a mesh for each, with mappedWall patches of the same faces
in the same order, whole or in pieces; chtMultiRegionSimpleFoam runs on it as it is, and a slab of two conductivities
gets its exact temperature."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from paraview import simple

import decomposed
import foam
from slab import CONDUCTIVITY, box, slab

COLD, HOT = 300.0, 400.0                    # K, at x = 0 and x = 3
TIMES = 400
SOLIDS = "regions ( fluid () solid (left right) );"

temporary = tempfile.TemporaryDirectory()


def corners(files, name):
    """Of each face of a patch, the coordinates from the lowest corner on."""
    part = files.of_patch(name)
    for face in range(part.start, part.stop):
        ids = files.faces.corners[files.faces.start[face]:files.faces.start[face + 1]]
        yield [tuple(p) for p in files.points[ids].tolist()]


def rotated(loop):
    first = loop.index(min(loop))
    return loop[first:] + loop[:first]


mesher = slab(0.23)
folder = foam.save(simple.OutputPort(mesher, "Mesh"), temporary.name + "/case")
constant = folder / "constant"
assert not (constant / "polyMesh").exists()
left, right = (foam.Files(folder, region) for region in CONDUCTIVITY)
for files in left, right:
    files.check()
for files, volume in (left, 1), (right, 2):
    assert abs(files.volumes().sum() - volume) < 1e-5, files.volumes().sum()
cells = mesher.GetDataInformation().GetNumberOfCells()
assert left.cells + right.cells == cells, (left.cells, right.cells, cells)
assert {name: kind for name, (kind, _, _) in left.patches.items() if kind == "mappedWall"} == \
    {"left_to_right": "mappedWall"}, left.patches
assert list(right.patches)[-1] == "right_to_left"
ours, theirs = list(corners(left, "left_to_right")), list(corners(right, "right_to_left"))
assert len(ours) == len(theirs) > 0
for a, b in zip(ours, theirs):
    assert rotated(a) == rotated(b[::-1]), (a, b)
boundary = (constant / "left/polyMesh/boundary").read_text()
for entry in "sampleMode +nearestPatchFace", "sampleRegion +right", "samplePatch +right_to_left":
    assert re.search(entry + ";", boundary), boundary
# A region with a patch that is no wall is fluid.
properties = constant / "regionProperties"
assert re.search(r"fluid \( left \)\s+solid \( right \)", properties.read_text()), properties.read_text()
# ... or is called so; one that is called solid is not.
with tempfile.TemporaryDirectory() as named:
    bodies = simple.GroupDatasets(Input=[simple.Triangulate(Input=simple.Box(Center=[i, 0, 0])) for i in range(3)], BlockNames=["fluidInside", "solid", "air"])
    foam.save(simple.OutputPort(simple.CartesianMesher(Input=bodies, CellSize=0.25, RegionsFrom="Blocks"), "Mesh"), named)
    text = (pathlib.Path(named) / "constant" / "regionProperties").read_text()
    assert re.search(r"fluid \( fluidInside \)\s+solid \( solid air \)", text), text
for region in CONDUCTIVITY:
    check = foam.CheckMesh(folder, "-region", region)
    assert check.ok, (region, check.failures)

# What the user made of them stays when a finer mesh takes the place of this one.
foam.write(folder, "constant/regionProperties", SOLIDS)
mine = properties.read_text()
path = constant / "left/polyMesh/boundary"
path.write_text(path.read_text().replace("left_to_right\n    {", "left_to_right\n    {\n        inGroups 1(mine);"))
for sets in constant.glob("*/polyMesh/sets"):  # of checkMesh
    shutil.rmtree(sets)
foam.save(simple.OutputPort(slab(0.25, "Exact Fit"), "Mesh"), folder)  # cells along the walls
assert properties.read_text() == mine and "1(mine)" in path.read_text()
assert not list(folder.glob("**/*.old*"))

# The solver, from our files and its fields alone.


def prepare(case, places):
    """What the solver needs besides the mesh; the fields are in each of the places."""
    foam.write(case, "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);", "uniformDimensionedVectorField")
    foam.control(case, TIMES)
    foam.write(case, "constant/regionProperties", SOLIDS)
    for region, conductivity in CONDUCTIVITY.items():
        foam.write(case, f"system/{region}/fvSchemes", (case / f"system/{region}/fvSchemes").read_text()
                   .partition("solver.\n")[2])
        foam.write(case, f"system/{region}/fvSolution",
                   "solvers { h { solver PCG; preconditioner DIC; tolerance 1e-13; relTol 0; } }\n"
                   "SIMPLE { nNonOrthogonalCorrectors 1; }\nrelaxationFactors { equations { h 1; } }")
        foam.write(case, f"constant/{region}/thermophysicalProperties", f"""
thermoType
{{
    type heSolidThermo; mixture pureMixture; transport constIso; thermo hConst;
    equationOfState rhoConst; specie specie; energy sensibleEnthalpy;
}}
mixture
{{
    specie {{ molWeight 1; }} transport {{ kappa {conductivity}; }}
    thermodynamics {{ Hf 0; Cp 1; }} equationOfState {{ rho 1; }}
}}""")
        foam.write(case, f"constant/{region}/radiationProperties", "radiation off; radiationModel none;")
        shared = {} if places == [case] else {'"procBoundary.*"': "processor; value uniform {};"}
        for place in places:
            foam.write_field(place, f"{region}/T", "[0 0 0 1 0 0 0]", str(COLD), {
                '".*"': "zeroGradient;", "inlet_cold": f"fixedValue; value uniform {COLD};",
                "hot": f"fixedValue; value uniform {HOT};",
                '".*_to_.*"': "compressible::turbulentTemperatureCoupledBaffleMixed; Tnbr T; "
                              f"kappaMethod solidThermo; value uniform {COLD};",
                **{name: text.format(COLD) for name, text in shared.items()}})
            foam.write_field(place, f"{region}/p", "[1 -1 -2 0 0 0 0]", "1e5", {
                '".*"': "calculated; value uniform 1e5;", **{name: text.format("1e5") for name, text in shared.items()}})


def check_temperatures(place):
    flux = (HOT - COLD) / sum(length / CONDUCTIVITY[name] for name, length in (("left", 1), ("right", 2)))
    for region, start, at in ("left", COLD, 0), ("right", COLD + flux / CONDUCTIVITY["left"], 1):
        files = foam.Files(place, region)
        exact = start + flux / CONDUCTIVITY[region] * (files.centres()[:, 0] - at)
        error = np.abs(foam.read_field(place, TIMES, f"{region}/T") - exact).max() / (HOT - COLD)
        print(f"{region}: {files.cells} cells, largest error {error:.1e} of the difference")
        assert error < 1e-6, (region, error)


prepare(folder, [folder])
foam.run(folder, "chtMultiRegionSimpleFoam")
check_temperatures(folder)

# Where asked, one mesh with zones; of one region alone, that region's.
one = foam.save(simple.OutputPort(mesher, "Mesh"), temporary.name + "/one", RegionsAs="Zones")
assert foam.Files(one).cells == cells and foam.CheckMesh(one).ok
zones = (one / "constant/polyMesh/cellZones").read_text()
assert re.findall(r"(\w+)\s*\{\s*type cellZone;", zones) == list(CONDUCTIVITY), zones[:300]
assert not (one / "constant/regionProperties").exists()
alone = simple.Threshold(Input=simple.OutputPort(mesher, "Mesh"), Scalars=["CELLS", "Region"],
                         LowerThreshold=2, UpperThreshold=2)
folder = foam.save(alone, pathlib.Path(temporary.name) / "alone")
assert foam.Files(folder).cells == right.cells
assert not (folder / "constant/polyMesh/cellZones").exists()

# In pieces, each region's mesh is decomposed as it is written whole: the solver starts at once.
case = foam.save(simple.OutputPort(slab(0.25, "Exact Fit"), "Mesh"), temporary.name + "/parallel", Pieces=2)
assert not (case / "processor0/constant/polyMesh").exists() and not (case / "processor0/constant/regionProperties").exists()
for region in CONDUCTIVITY:
    decomposed.check(case, foam.Files(temporary.name + "/case", region), 2, region)
places = [case / "processor0", case / "processor1"]
prepare(case, places)
foam.run_parallel(case, 2, "chtMultiRegionSimpleFoam")
for place in places:
    check_temperatures(place)

# A piece without cells of a region.
rod = simple.GroupDatasets(Input=[box([0, 0.27, 0.59], [3, 0.71, 0.93]), box([0, 0, 0], [3, 1, 1])],
                           BlockNames=["gas", "solid"])
mesher = simple.CartesianMesher(Input=rod, RegionsFrom="Blocks", BoundaryArray="Wall", CellSize=0.13)
whole = foam.save(simple.OutputPort(mesher, "Mesh"), temporary.name + "/rod")
case = foam.save(simple.OutputPort(mesher, "Mesh"), temporary.name + "/pieces", Pieces=3)
assert not list(case.glob("*.unfinished"))
for region in "gas", "solid":
    pieces = decomposed.check(case, foam.Files(whole, region), 3, region)
    assert (pieces[0].files.cells == 0) == (region == "gas")
    text = foam.run_parallel(case, 3, "checkMesh", "-region", region)
    assert "\nMesh OK." in text and "Coupled point location match (average 0) OK" in text, text

# By a task file the same.
folder = pathlib.Path(temporary.name) / "task"
folder.mkdir()
for name, part in zip(("gas", "solid"), rod.Input):
    simple.SaveData(str(folder / f"{name}.stl"), proxy=part)
TASK = '[surface]\nfile = ["gas.stl", "solid.stl"]\n[domain]\nregions_from = "Blocks"\n[grid]\ncell_size = 0.13\n[output]\n'
for output in 'mesh = "whole/case.foam"', 'mesh = "case/case.foam"\npieces = 3':
    (folder / "task.toml").write_text(TASK + output)
    subprocess.run([sys.argv[2], "--quiet", folder / "task.toml"], check=True)
for region in "gas", "solid":
    decomposed.check(folder / "case", foam.Files(folder / "whole", region), 3, region)

# In pieces of one mesh with zones, OpenFOAM splits that on all ranks into the meshes that are written whole.
case = foam.save(simple.OutputPort(mesher, "Mesh"), temporary.name + "/split", Pieces=3, RegionsAs="Zones")
foam.run_parallel(case, 3, "splitMeshRegions", "-cellZones", "-overwrite")
for region in "gas", "solid":
    text = foam.run_parallel(case, 3, "checkMesh", "-region", region)
    assert "Coupled point location match (average 0) OK" in text, text
    alone, volumes, faces = foam.Files(whole, region), [], {}
    for piece in range(3):
        files = foam.Files(case / f"processor{piece}", region)
        volumes += files.volumes().tolist() if files.cells else []
        for name, (kind, _, count) in files.patches.items():
            if kind != "processor":
                faces[name] = faces.get(name, 0) + count
    assert np.allclose(volumes, alone.volumes(), rtol=1e-12, atol=0)
    assert faces == {name: count for name, (_, _, count) in alone.patches.items()}, (faces, alone.patches)
