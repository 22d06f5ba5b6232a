"""Meshes as Fluent files: OpenFOAM's fluent3DMeshToFoam makes the same mesh of them as we write for OpenFOAM."""

import math
import pathlib
import re
import sys
import tempfile

import numpy as np
from paraview import simple

import foam
from pipeline import DATA, Messages
from rotors import fan
from slab import slab

SURFACE = DATA / "kcl_exhaust_header_lumens.stl"


def converted(file, folder):
    """What OpenFOAM makes of a file, in a case of its own; and the zones that it names."""
    foam.control(folder, 1, "writePrecision 17;")
    text = foam.run(folder, "fluent3DMeshToFoam", str(file))
    assert "Warning" not in text and "FOAM FATAL" not in text, text
    return foam.Files(folder), set(re.findall(r"Zone: \d+ name: (\S+) type: (\S+?)\.", text))


def assert_same(found, whole):
    """The same points, cells and patches; OpenFOAM's names of types are those of the zones."""
    found.check()
    assert np.array_equal(found.points, whole.points)
    assert found.faces_of_cells() == whole.faces_of_cells()
    assert (found.volumes() > 0).all() and np.allclose(found.volumes(), whole.volumes(), rtol=1e-12, atol=0)
    assert found.patches == whole.patches, (found.patches, whole.patches)


with tempfile.TemporaryDirectory() as temporary:
    folder = pathlib.Path(temporary)
    mesher = simple.CartesianMesher(Input=simple.OpenDataFile(str(SURFACE)), CellSize=12)
    whole = foam.Files(foam.save(mesher, folder / "case"))
    simple.SaveData(str(folder / "header.msh"), mesher)
    found, zones = converted(folder / "header.msh", folder / "header")
    assert_same(found, whole)
    kinds = {"wall": "wall", "inlet": "velocity-inlet", "outlet": "pressure-outlet"}
    assert zones == {("cells", "fluid"), ("interior_cells", "interior")} | \
        {(name, kinds[name.partition("_")[0]]) for name in whole.patches}, zones

    task = folder / "task.toml"
    task.write_text(f'[surface]\nfile = "{SURFACE}"\n[grid]\ncell_size = 12.0\n[output]\nmesh = "task.msh"\n')
    for ranks in 1, 2:
        foam.run(folder, *foam.MPIRUN, "-n", str(ranks), sys.argv[2], "--quiet", task.name)
        assert (folder / "task.msh").read_bytes() == (folder / "header.msh").read_bytes()
        (folder / "task.msh").unlink()

    # Two regions: their cells are zones, a wall is between them, and what both have of a boundary is two zones.
    mesher = slab(0.23)
    parts = [foam.Files(foam.save(mesher, folder / "regions"), region) for region in ("left", "right")]
    simple.SaveData(str(folder / "regions.msh"), mesher)
    found, zones = converted(folder / "regions.msh", folder / "zones")
    assert zones == {("left", "fluid"), ("right", "solid"), ("interior_left", "interior"), ("interior_right", "interior"),
        ("left_to_right", "wall"), ("inlet_cold", "velocity-inlet"), ("hot", "wall"), ("side_left", "wall"),
        ("side_right", "wall")}, zones
    volumes = found.volumes()
    for part, cells in zip(parts, (slice(0, parts[0].cells), slice(parts[0].cells, None))):
        assert np.allclose(volumes[cells], part.volumes(), rtol=1e-12, atol=0)

    # A zone of the flow: fluid, as what is around it, with inner faces between them.
    mesher = fan()
    whole = foam.Files(foam.save(simple.OutputPort(mesher, "Mesh"), folder / "fan", RegionsAs="Zones"))
    simple.SaveData(str(folder / "fan.msh"), simple.OutputPort(mesher, "Mesh"))
    found, zones = converted(folder / "fan.msh", folder / "fan_of_fluent")
    assert {("fluid", "fluid"), ("rotor", "fluid"), ("fluid_to_rotor", "interior"), ("interior_rotor", "interior")} < zones, zones
    assert set(found.patches) == set(whole.patches) - {"shaft"} | {"shaft_fluid", "shaft_rotor"}, found.patches  # no wall between the two
    assert math.isclose(found.volumes().sum(), whole.volumes().sum(), rel_tol=1e-9)
    zone = (found.folder / "cellZones").read_text()
    assert set(re.findall(r"(\w+)\s*\{\s*type\s+cellZone", zone)) == {"fluid", "rotor"}, zone[:2000]

    # Names that Fluent does not allow are told, with what the file has.
    mesher = slab(0.23)
    mesher.BoundaryNames, mesher.BoundaryMergedNames = ["hot"], ["\u70ed"]
    with Messages() as said:
        simple.SaveData(str(folder / "named.msh"), mesher)
    assert "\u70ed is u70ed. To choose" in str(said), said
    assert " wall u70ed)" in (folder / "named.msh").read_text()

    # What stood there stays, and nothing else, where the new one cannot be written.
    (folder / "folder.msh").mkdir()
    with Messages() as said:
        simple.SaveData(str(folder / "folder.msh"), mesher)
    assert "folder.msh (Is a directory): choose another name" in str(said), said
    assert not (folder / "folder.msh.unfinished").exists()
    print(whole.cells, "cells")
