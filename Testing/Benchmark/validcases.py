# SPDX-License-Identifier: BSD-3-Clause
"""The cases of valid.py: surfaces by rule and from files, and how each is meshed."""

import collections
import functools
import glob
import gzip
import hashlib
import json
import pathlib
import subprocess

from paraview import simple

import hashes
import thinscenes
from wallsurfaces import TURNS

EXAMPLES = pathlib.Path("/usr/share/doc/openfoam-examples/examples")
CAD_FOLDERS = "/usr/share/opencascade", "/usr/share/doc/gmsh-doc", "/usr/share/freecad", "/usr/share/doc/netgen-doc"
CAD_SUFFIXES = ".step", ".stp", ".iges", ".igs", ".brep"
MARGIN = 0.3  # of the surface's longest side, around it

EQUAL_BOXES = {"BoxesAlongBody": 0}  # by default they are halved along walls in flows
SHEETS_IN_A_BOX = {"Domain": "Outside", "BoxFrom": "Bounds", "DomainBounds": [-3, 3] * 3, "Sheets": "Keep"}
RIM_SIZES = 0.4, 0.25, 0.15
THIN_SCENES = 300
HEADER_SIZES = 20, 10, 6, 3
PARTS = 20, 30, 40, 60  # boxes along the longest side

# Bodies in the examples: how a file's name begins.
BODIES = ("building_wtc2", "flange", "cyclone", "bullet", "propellerTip", "wigley.stl", "desk", "fan.stl", "wing_5degrees",
          "fixed.obj", "buildings", "rotorBlades", "statorBlades", "stirrer.stl", "sparger", "baffles.stl", "simpleCar",
          "mech_test", "geom.stl", "NACA0012")
AROUND_A_BODY = {"Domain": "Outside", "BoxesAlongBody": 40, "LengthsBefore": 1, "LengthsBehind": 2, "LengthsBeside": 1}
MOTORBIKE = {"CellSize": 1.0, "Domain": "Outside", "BoxFrom": "Bounds", "DomainBounds": [-5, 15, -4, 4, 0, 8],
             "Ground": "zMin", "RefinementDepth": 5, "TransitionLayers": 3, "RefinementShapes": ["box"],
             "RefinementPositions": [-1, -0.7, 0], "RefinementLengths": [9, 1.4, 2.5], "RefinementShapeDepths": [4]}
CAR = {"Domain": "Outside", "FlowDirection": "Plus Y", "Ground": "zMin"}  # the second task of the guide's page Three Cases

# `read`: makes the surface's proxy, given a folder for files. `parts`: boxes along the surface's longest side, if not
# in the properties; `margin`: outside of it, in a box around it. `isSample`: of what CI runs.
Case = collections.namedtuple("Case", "kind name read properties parts margin isSample", defaults=({}, None, False, False))


# ---- Surfaces

def read_file(path, folder):
    path = pathlib.Path(path)
    if path.suffix == ".gz":
        unpacked = folder / path.stem
        unpacked.write_bytes(gzip.decompress(path.read_bytes()))
        path = unpacked
    if path.suffix.lower() in CAD_SUFFIXES:
        return simple.CADReader(FileName=str(path))
    if path.suffix == ".ply":
        return simple.PLYReader(FileNames=[str(path)])
    reader = simple.NamedOBJReader if path.suffix == ".obj" else simple.NamedSTLReader
    return reader(FileName=str(path))


def from_file(path):
    return functools.partial(read_file, path)


def from_scene(make):
    def read(folder):
        make().write(folder / "scene.obj")
        return read_file(folder / "scene.obj", folder)
    return read


def turned_rim(name, turn):
    return thinscenes.RIMS[name]().turned(thinscenes.rotations(TURNS[turn]))


# ---- Kinds. Each gives its cases, or says what is not there.

def rims(_):
    for scene in thinscenes.RIMS:
        for turn in TURNS:
            read = from_scene(functools.partial(turned_rim, scene, turn))
            for size in RIM_SIZES:
                yield Case("rims", f"{scene}, {turn}, {size}", read, SHEETS_IN_A_BOX | EQUAL_BOXES | {"CellSize": size},
                           isSample=turn == "by any angles" and size == 0.25)
            yield Case("rims", f"{scene}, {turn}, halved along it", read, SHEETS_IN_A_BOX | {"CellSize": 0.4})


def thin(_):
    for number in range(THIN_SCENES):
        kind, _, inside = thinscenes.thin(number)
        yield Case("thin", f"{number}, {kind}, {'inside' if inside else 'outside'}",
                   from_scene(lambda number=number: thinscenes.thin(number)[1]),
                   EQUAL_BOXES | {"CellSize": thinscenes.THIN_BOX, "Sheets": "Keep"}, margin=not inside,
                   isSample=number < 2 * len(thinscenes.KINDS))


def header(options):
    files = {path.stem: path for path in hashes.surface_files([hashes.DATA, *options.surfaces])}
    for side in "fused", "lumens":
        path = files.get(f"kcl_exhaust_header_{side}")
        if path is None:
            print(f"header: no side {side} in Data and --surfaces: left out")
            continue
        for size in HEADER_SIZES:
            yield Case("header", f"{side}, {size} mm", from_file(path), {"CellSize": size},
                       isSample=side == "lumens" and size == 20)


@functools.cache
def example_files():
    """Paths by content, of each the first of the shortest."""
    files = {}
    for path in sorted(EXAMPLES.rglob("*"), key=lambda path: (len(str(path)), str(path))):
        if path.name.endswith((".stl", ".obj", ".stl.gz", ".obj.gz")):
            data = path.read_bytes()
            data = gzip.decompress(data) if path.suffix == ".gz" else data
            files.setdefault(hashlib.sha256(data).digest(), path)
    if not files:
        print(f"flow, examples: {EXAMPLES} has no surfaces (Debian's openfoam-examples): left out")
    return list(files.values())


def example(beginning):
    return next(path for path in example_files() if path.name.startswith(beginning))


def flow(_):
    if example_files():
        for body in BODIES:
            yield Case("flow", body, from_file(example(body)), AROUND_A_BODY, isSample=body in ("desk", "rotorBlades"))
        yield Case("flow", "motorBike, all groups", from_file(example("motorBike.obj")), MOTORBIKE)


def examples(_):
    """The others, named after their tutorials."""
    bodies = {example(body) for body in (*BODIES, "motorBike.obj") if example_files()}
    for path in example_files():
        if path not in bodies:
            tutorial = path.relative_to(EXAMPLES).parent.as_posix().partition("/constant")[0].split("/")[-1]
            yield Case("examples", f"{tutorial}: {path.name.partition('.gz')[0]}", from_file(path), parts=30,
                       isSample=tutorial == "opposite_walls")


def surfaces(options):
    if not options.surfaces:
        print("surfaces: of Data alone; --surfaces FOLDER adds others")
    for path in hashes.surface_files([hashes.DATA, *options.surfaces]):
        for domain in "inside", "outside":
            for parts in PARTS:
                yield Case("surfaces", f"{path.stem}, 1/{parts}, {domain}", from_file(path), EQUAL_BOXES, parts, domain == "outside",
                           parts == 20 and domain == "inside" and path.parent == hashes.DATA and "header" not in path.stem)


def car(_):
    body = from_file(hashes.DATA / "prius_hybrid_body.obj")
    yield Case("car", "without layers", body, CAR)
    yield Case("car", "3 layers", body, CAR | {"Layers": 3})
    for layers in 0, 3:
        yield Case("car", f"coarse, {layers} layers", body, CAR | {"Layers": layers, "BoxesAlongBody": 20}, isSample=True)


def cad(options):
    """Files that the tests make, also each with several solids as regions; and Debian's."""
    maker = options.build / "bin" / "make-cad-parts"
    if not hasattr(simple, "CADReader"):
        print("cad: the plugin reads no CAD files: left out")
        return
    if maker.exists():
        parts = options.folder / "parts"
        subprocess.run([maker, parts], check=True, stdout=subprocess.DEVNULL)
        for number, (name, facts) in enumerate(json.loads((parts / "facts.json").read_text(encoding="utf-8")).items()):
            yield Case("cad", f"made: {name}", from_file(parts / name), parts=30, isSample=number % 8 == 0)
            if len(facts["solids"]) > 1:
                yield Case("cad", f"made: {name}, regions", from_file(parts / name), {"RegionsFrom": "Blocks"}, parts=30)
    else:
        print(f"cad: no {maker}: files of the tests are left out")
    found = [path for folder in CAD_FOLDERS for path in sorted(glob.glob(folder + "/**", recursive=True))
             if path.removesuffix(".gz").lower().endswith(CAD_SUFFIXES)]
    if not found:
        print(f"cad: no files in {', '.join(CAD_FOLDERS)}: left out")
    for path in found:
        yield Case("cad", f"Debian's: {path.removeprefix('/usr/share/')}", from_file(path), parts=30)


KINDS = rims, thin, header, flow, examples, surfaces, car, cad


def all_cases(options):
    return [case for kind in KINDS for case in kind(options)]
