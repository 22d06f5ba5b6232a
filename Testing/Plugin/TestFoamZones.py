"""Regions as zones of an OpenFOAM mesh: a porous medium in air, in a casing, is a cellZone in the air's mesh with a
faceZone around it, or has a pair of cyclicAMI patches, through which heat and flow pass as through inner faces."""

import pathlib
import re
import tempfile

import numpy as np
from paraview import simple

import foam
import slab
from pipeline import Messages

temporary = tempfile.TemporaryDirectory()

ENDS = ("inlet", "outlet")
BODIES = {"porous": slab.box([1, 0, 0], [2, 1, 1], ENDS), "air": slab.box([0, 0, 0], [3, 1, 1], ENDS),
          "casing": slab.box([0, -0.5, -0.5], [3, 1.5, 1.5], ENDS)}


def mesh_of(names, size=0.21, method="Automatic"):
    both = simple.GroupDatasets(Input=[BODIES[name] for name in names], BlockNames=list(names))
    return simple.OutputPort(simple.CartesianMesher(
        Input=both, RegionsFrom="Blocks", BoundaryArray="Wall", CellSize=size, PatchMethod=method), "Mesh")


def zone(folder, name, kind):
    """Lists of the entries of a zone."""
    text = (pathlib.Path(folder) / kind).read_text()
    entries = re.search(name + r"\s*\{(.*?)\n\}", text, re.DOTALL)[1]
    return [np.array(numbers.split(), int) for numbers in re.findall(r"\(([\d\s]*)\)", entries)]


def saved(mesh, name, **properties):
    return foam.save(mesh, f"{temporary.name}/{name}", **properties)


def close(a, b):
    return abs(a - b) < 1e-5  # of the lattice


def seen_from_porous(files):
    """Whether the faces of the zone look out of the porous block, and whether some of them are turned over for that."""
    faces, turned = zone(files.folder, "porous_to_air", "faceZones")
    centres, vectors = files.face_centres()
    out = np.where(turned[:, None] == 1, -vectors[faces], vectors[faces])
    for x, direction in (1, -1), (2, 1):
        assert close(out[abs(centres[faces][:, 0] - x) < 1e-3].sum(axis=0)[0], direction)
    assert len(faces) == len(set(faces))
    return turned.any() and not turned.all()


three = mesh_of(BODIES)
folder = saved(three, "mixed", ZoneRegions=["porous"])
assert sorted(p.name for p in (folder / "constant").glob("*/")) == ["air", "casing", "regionProperties"] or \
    not (folder / "constant/porous").exists()
air, casing = (foam.Files(folder, region) for region in ("air", "casing"))
for files, volume in (air, 3), (casing, 9):
    files.check()
    assert close(files.volumes().sum(), volume), files.volumes().sum()
for region in "air", "casing":
    verdict = foam.CheckMesh(folder, "-region", region)
    assert verdict.ok, (region, verdict.failures)
assert close(air.areas()["air_to_casing"], 12) and close(casing.areas()["casing_to_air"], 12)
cells, = zone(air.folder, "porous", "cellZones")
assert close(air.volumes()[cells].sum(), 1)
assert ((1 < air.centres()[cells][:, 0]) & (air.centres()[cells][:, 0] < 2)).all()
seen_from_porous(air)
assert not (casing.folder / "cellZones").exists()

# All regions as zones: every pair that touches has a faceZone.
one = saved(three, "zones", RegionsAs="Zones")
text = (one / "constant/polyMesh/faceZones").read_text()
assert re.findall(r"(\w+)\s*\{\s*type faceZone;", text) == ["porous_to_air", "porous_to_casing", "air_to_casing"]
assert foam.CheckMesh(one).ok

# A single mesh is left: heat goes through its pair of patches as through inner faces, and so does flow.
two = mesh_of(["porous", "air"], 0.25, "Exact Fit")  # cells along the walls
whole = saved(two, "whole", ZoneRegions=["porous"])
fan = saved(two, "fan", ZoneRegions=["porous"], ZoneBorders="Cyclic AMI")
inner, paired = foam.Files(whole), foam.Files(fan)
paired.check()
assert seen_from_porous(inner)
assert len(inner.points) < len(paired.points)
assert list(paired.patches)[-2:] == ["porous_to_air", "air_to_porous"] or \
    list(paired.patches)[-2:] == ["air_to_porous", "porous_to_air"]
for name in "porous_to_air", "air_to_porous":
    assert paired.patches[name][0] == "cyclicAMI" and close(paired.areas()[name], 2)
apart = [set(paired.faces.corners[paired.faces.start[s.start]:paired.faces.start[s.stop]].tolist())
         for s in map(paired.of_patch, ("porous_to_air", "air_to_porous"))]
assert not apart[0] & apart[1]
for case in whole, fan:
    assert foam.CheckMesh(case).ok
    files = foam.Files(case)
    pair = {} if case is whole else {'".*_to_.*"': "cyclicAMI;"}
    foam.write_field(case, "T", "[0 0 0 1 0 0 0]", "1", {
        "inlet": "fixedValue; value uniform 0;", "outlet": "fixedValue; value uniform 3;",
        "side": "zeroGradient;", **pair})
    foam.write(case, "constant/transportProperties", "DT [0 2 -1 0 0 0 0] 1;")
    foam.write(case, "system/fvSolution", "solvers { T { solver PCG; preconditioner DIC; tolerance 1e-14; relTol 0; } }\n"
               "SIMPLE { nNonOrthogonalCorrectors 3; }")
    foam.control(case, 1)
    foam.run(case, "laplacianFoam")
    error = np.abs(foam.read_field(case, 1, "T") - files.centres()[:, 0]).max()
    print(f"{files.cells} cells: largest error {error:.1e}")
    assert error < 1e-4, error

# What cannot be is refused.
for properties, words in (
        ({"ZoneRegions": ["rotor"]}, "the mesh has no region rotor. Choose from porous, air, casing."),
        ({"ZoneRegions": ["porous", "air", "casing"]}, "touches only regions that are zones themselves"),
        ({"ZoneRegions": ["porous"], "RegionsAs": "Meshes", "Pieces": 2}, "In a decomposed case")):
    case = pathlib.Path(temporary.name) / "refused"
    with Messages() as said:
        try:
            simple.SaveData(str(case / "case.foam"), three, **properties)
        except RuntimeError:
            pass
    assert words in str(said), (words, str(said))
    assert not (case / "constant").exists()
