"""Are the meshes of two versions the same, bit for bit?

    pvpython hashes.py --out FILE.json [--surfaces FOLDER...] [--quick]
    python3 hashes.py --compare BEFORE.json AFTER.json [--ignore-renamed]

The first command meshes each surface (STL, OBJ, PLY) of the folders, by default this repository's Data,
in many ways, and writes down for each of these combinations: a hash of every array of every output, the
statistics, the error codes, and the messages. Which version of the plugin that is, PV_PLUGIN_PATH says.
With --quick there are fewer combinations, none of them large. Nothing depends on time or machine load:
two runs of one version write the same file.

The second command compares two such files. It prints a line for each combination that differs, and what
differs in it; then, each once, arrays that only have another name, and messages that only have other
words. Other words are no difference; other names are, but not with --ignore-renamed. The exit code is 1
if anything differs.
"""

import argparse
import collections
import hashlib
import json
import pathlib
import re
import sys
import time

try:
    from paraview import simple
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow

    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Plugin"))
    from floats import in_floats
    from polyhedra import cell_arrays, face_arrays, type_array
except ImportError:  # any Python can compare
    simple = None

DATA = pathlib.Path(__file__).resolve().parent.parent.parent / "Data"
SUFFIXES = ".stl", ".obj", ".ply"
METHODS = "Automatic", "Exact Fit", "Marching Cubes"

# Grids that each surface is meshed in: (cells along its longest side, refinement depth).
GRIDS = (12, 0), (12, 2), (25, 0), (25, 2)
QUICK_GRIDS = (12, 0),
# Where some of those take more than ten seconds, and where a finer one takes little.
OTHER_GRIDS = {
    "elmer_femur": ((12, 2), (25, 2), (40, 0)),
    "vtk_lucy": ((25, 2), (40, 0)),
    "tm_cycloidal": ((12, 0), (25, 0)),
} | dict.fromkeys(("cino_spot", "kcl_exhaust_header_lumens", "tm_7_8ths_cube", "tm_featuretype_occ",
                   "wallaby_cylinder_head_r80"), GRIDS + ((40, 0),))

# Surfaces that Exact Fit takes more than ten seconds for.
NOT_EXACTLY = "tm_cycloidal", "vtk_lucy", "vtk_turbineblade"

# Surfaces that are meshed in all other ways, too, and those of them with --quick.
VARIED = ("as_Spider_ascii", "cino_spot", "kcl_exhaust_header_lumens", "kcl_flange_with_patterns",
          "tm_7_8ths_cube", "tm_featuretype_occ", "tm_not_convex")
QUICKLY_VARIED = "kcl_exhaust_header_lumens", "tm_featuretype_occ"


# ---- Surfaces

class Surface:
    def __init__(self, path):
        self.name = path.stem
        self.source = in_floats(reader(path))
        self.source.UpdatePipeline()
        bounds = self.source.GetDataInformation().GetBounds()
        self.low = bounds[0::2]
        self.lengths = [high - low for low, high in zip(bounds[0::2], bounds[1::2])]

    def cell_size(self, across):
        return max(self.lengths) / across

    def point(self, *fractions):
        """The point at these fractions of the bounding box."""
        return [low + f * length for low, f, length in zip(self.low, fractions, self.lengths)]


def reader(path):
    if path.suffix == ".obj":
        return simple.WavefrontOBJReader(FileName=str(path))
    if path.suffix == ".ply":
        return simple.PLYReader(FileNames=[str(path)])
    if path.read_bytes().count(b"endsolid") > 1:
        return simple.NamedSTLReader(FileName=str(path))
    return simple.STLReader(FileNames=[str(path)])


def surface_files(folders):
    """Sorted by name; one that is in several folders is taken from the first."""
    files = {}
    for folder in folders:
        for path in folder.iterdir():
            if path.suffix in SUFFIXES:
                files.setdefault(path.stem, path)
    return [files[name] for name in sorted(files)]


# ---- Combinations: a name, how to run it, and properties

Combination = collections.namedtuple("Combination", "name run properties")


def ball(surface):
    return simple.RefinementRegion(Input=surface.source, Shape="Sphere", Depth=2,
        Center=surface.point(0.3, 0.4, 0.5), Radius=0.2 * max(surface.lengths))


def turned_box(surface):
    return simple.RefinementRegion(Input=surface.source, Shape="Box", Depth=1,
        Position=surface.point(0.5, 0.4, 0.3), Rotation=[10, 20, 30],
        Length=[0.4 * length for length in surface.lengths])


def meshlines(surface):
    """Uneven along x, and through half of the surface along z."""
    return {"MeshlinesX": [surface.point(f, 0, 0)[0] for f in (-0.1, 0.02, 0.1, 0.3, 0.35, 0.6, 0.9, 1.1)],
            "MeshlinesZ": [surface.point(0, 0, i / 12)[2] for i in range(7)]}


AS_CUT = {"CollapseRatio": 0, "SmallCells": "Remove", "SmallCellRatio": 0, "SplitConcaveCells": 0}
BLOCKS = [0, 5, 0, 5, 0, 1, 2, 1, 2, 3, 1, 1, 0, 0, 3, 0]

# Ways to mesh a surface in cells of a 25th of its length: properties, or what makes them of it.
WAYS = {
    "2 threads": {"NumberOfThreads": 2},
    "3 threads": {"NumberOfThreads": 3},
    "depth 1, 2 threads": {"RefinementDepth": 1, "NumberOfThreads": 2},
    "depth 1, 3 threads": {"RefinementDepth": 1, "NumberOfThreads": 3},
    "small cells removed": {"SmallCells": "Remove", "SmallCellRatio": 0.1},
    "nothing collapsed": {"CollapseRatio": 0},
    "nothing split": {"SplitConcaveCells": 0},
    "nothing refused": {"RefusedCellRatio": 0},
    "as cut": AS_CUT,
    "as cut, Exact Fit": {"PatchMethod": "Exact Fit", **AS_CUT},
    "more merged": {"MergeRatio": 0.1},
    "nodes moved": {"Tying": "Move Nodes"},
    "few features": {"FeatureAngle": 60},
    "flat patches": {"MergeAngle": 0},
    "blocks": {"RefinementBlocks": BLOCKS},
    "boundary": {"BoundaryRefinement": [0, 2, 1, 0]},
    "boundary, blended": {"BoundaryRefinement": [0, 2, 2, 1], "RefinementDepth": 1},
    "ball": lambda surface: {"RefinementRegions": ball(surface)},
    "ball and turned box": lambda surface: {"RefinementRegions": [ball(surface), turned_box(surface)],
                                            "RefinementDepth": 1},
    "meshlines": meshlines,
}

# Of the surface with named boundaries: ways to mesh them, and what is refused, with an error code and
# a message.
NAMED = "kcl_exhaust_header_lumens"
BY_NAME = {
    "boundaries refined by name": {"RefinedBoundaries": ["inlet_1", "outlet_1"]},
    "boundaries with types and ratios": {"BoundaryNames": ["inlet_1", "outlet_1"],
        "BoundaryTypes": ["patch", "symmetry"], "BoundarySmallCellRatios": [1e-100, 0.1]},
    "boundary array": {"BoundaryArray": "STLSolidLabeling"},
}
REFUSED = {
    "negative cell size": {"CellSize": -1},
    "one meshline": {"MeshlinesY": [0]},
    "meshlines that decrease": {"MeshlinesX": [1, 0, 2]},
    "too many boxes": {"MemoryLimit": 1e-6},
    "no such array": {"BoundaryArray": "no such array"},
    "collapse ratio too large": {"CollapseRatio": 0.9},
    "block that ends before it starts": {"RefinementBlocks": [3, 1, 0, 1, 0, 1, 1, 0]},
    "no such boundary": {"BoundaryNames": ["no such boundary"]},
}


def combinations(surface, quick):
    for across, depth in grids(surface, quick):
        for method in METHODS:
            if method != "Exact Fit" or surface.name not in NOT_EXACTLY:
                yield Combination(f"1/{across}, depth {depth}, {method}", run_mesher,
                    {"CellSize": surface.cell_size(across), "RefinementDepth": depth, "PatchMethod": method})
    if surface.name in (QUICKLY_VARIED if quick else VARIED):
        yield from other_filters(surface)
        yield from ways(surface, WAYS)
    if surface.name == NAMED:
        yield from ways(surface, BY_NAME | REFUSED)


def grids(surface, quick):
    every = OTHER_GRIDS.get(surface.name, GRIDS)
    return [grid for grid in every if grid in QUICK_GRIDS] if quick else every


def ways(surface, properties_of):
    for name, way in properties_of.items():
        properties = way(surface) if callable(way) else way
        yield Combination(name, run_mesher, {"CellSize": surface.cell_size(25)} | properties)


def other_filters(surface):
    """The same mesh in pieces and in three steps, and what other filters make of surface and mesh."""
    for across, depth in (12, 2), (25, 0):
        grid = {"CellSize": surface.cell_size(across), "RefinementDepth": depth}
        for name, run in (("3 pieces", run_pieces), ("3 filters", run_three), ("quality", run_quality)):
            yield Combination(f"1/{across}, depth {depth}, {name}", run, grid)
    yield Combination("inspector", run_inspector, {"CellSize": surface.cell_size(25)})


# ---- Runs: each fills a record

def run_mesher(surface, properties, record):
    mesher = simple.CartesianMesher(Input=surface.source, **properties)
    mesher.UpdatePipeline()
    record.add(mesher, "Mesh", "Boundary", "Defects")


def run_pieces(surface, properties, record, count=3):
    mesher = simple.CartesianMesher(Input=surface.source, **properties)
    for number in range(count):
        mesher.SMProxy.GetClientSideObject().UpdatePiece(number, count, 0)
        record.add(mesher, *(f"{output} {number}" for output in ("Mesh", "Boundary", "Defects")))


def run_three(surface, properties, record):
    boxer = simple.CartesianBoxer(Input=surface.source, **properties)
    patcher = simple.Patcher(Input=surface.source, Boxes=boxer, NumberOfThreads=1)
    assembler = simple.CellAssembler(Input=boxer, Patches=patcher, NumberOfThreads=1)
    assembler.UpdatePipeline()
    record.add(boxer, "Boxes")
    record.add(patcher, "Patches")
    record.add(assembler, "Mesh", "Boundary")


def run_quality(surface, properties, record):
    mesher = simple.CartesianMesher(Input=surface.source, **properties)
    quality = simple.FiniteVolumeQuality(Input=mesher)
    quality.UpdatePipeline()
    record.add(quality, "Mesh", "Faces")


def run_inspector(surface, properties, record):
    inspector = simple.SurfaceInspector(Input=surface.source, **properties)
    inspector.UpdatePipeline()
    record.add(inspector, "Defects")


class Record:
    """What is written down of a combination."""

    def __init__(self):
        self.codes, self.arrays, self.statistics = [], {}, {}

    def add(self, proxy, *outputs):
        """Adds all of a filter's outputs, which are called so."""
        filter = proxy.SMProxy.GetClientSideObject()
        self.codes.append(filter.GetErrorCode())
        for port, name in enumerate(outputs):
            for kind, array in arrays(filter.GetOutputDataObject(port)):
                self.arrays[f"{name}, {kind}"] = describe(array)
                if kind.startswith("field ") and is_number(array):
                    self.statistics[f"{name}, {kind}"] = vtk_to_numpy(array).item()

    def as_json(self, messages):
        return {"codes": self.codes, "messages": len(messages), "statistics": self.statistics,
                "arrays": self.arrays, "texts": messages}


def arrays(data):
    """(name, array) of all that makes a data object, in the order in which it has them."""
    yield "points", data.GetPoints() and data.GetPoints().GetData()
    for name, cells in all_cells(data).items():
        offsets, corners = cell_arrays(cells) if cells else (None, None)
        yield f"{name} offsets", offsets
        yield name, corners
    if data.IsA("vtkUnstructuredGrid"):
        faces, places = face_arrays(data)
        yield "types", type_array(data)
        yield "polyhedral faces", faces
        yield "places of polyhedral faces", places
    for kind, attributes in (("point", data.GetPointData()), ("cell", data.GetCellData()),
                             ("field", data.GetFieldData())):
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(i)
            yield f"{kind} {array.GetName()}", array


def all_cells(data):
    if data.IsA("vtkUnstructuredGrid"):
        return {"cells": data.GetCells()}
    return {"verts": data.GetVerts(), "lines": data.GetLines(), "polygons": data.GetPolys(),
            "strips": data.GetStrips()}


def is_number(array):
    return array.IsA("vtkDataArray") and array.GetNumberOfValues() == 1


def describe(array):
    """Its type, its size, and a hash of its values: "double 8x3 6ca1..."."""
    if array is None:
        return "none"
    size = f"{array.GetNumberOfTuples()}x{array.GetNumberOfComponents()}"
    return f"{array.GetDataTypeAsString()} {size} {hashlib.sha256(values(array)).hexdigest()}"


def values(array):
    if array.IsA("vtkStringArray"):
        return "\0".join(array.GetValue(i) for i in range(array.GetNumberOfValues())).encode()
    return vtk_to_numpy(array).tobytes()


class Messages:
    """with Messages() as messages: ... ; then messages.texts() are all that VTK said."""

    # What VTK puts in front: place in the source, sender, its address.
    HEAD = re.compile(r"^(ERROR|Warning): In .*, line \d+\n\w+ \(0x[0-9a-f]+\): ", re.MULTILINE)

    def __enter__(self):
        self.before = vtkOutputWindow.GetInstance()
        self.window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # it would print them, too
        return self

    def __exit__(self, *_):
        vtkOutputWindow.SetInstance(self.before)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_WARNING)

    def texts(self):
        first, *parts = self.HEAD.split(self.window.GetOutput())
        others = [first.strip()] if first.strip() else []
        return others + [f"{kind}: {text.strip()}" for kind, text in zip(parts[0::2], parts[1::2])]


def make_record(surface, combination):
    record, kept = Record(), set(simple.GetSources().values())
    with Messages() as messages:
        combination.run(surface, {"NumberOfThreads": 1} | combination.properties, record)
    for proxy in list(simple.GetSources().values()):
        if proxy not in kept:
            simple.Delete(proxy)
    return record.as_json(messages.texts())


def write_all(out, folders, quick):
    """Writes after each surface, so that a crash leaves those before it."""
    records, start = {}, time.time()
    for path in surface_files(folders):
        surface = Surface(path)
        for combination in combinations(surface, quick):
            began = time.time()
            name = f"{surface.name}: {combination.name}"
            records[name] = make_record(surface, combination)
            print(f"{time.time() - began:6.2f} s  {name}", flush=True)
        simple.Delete(surface.source)
        out.write_text(json.dumps(records, indent=1) + "\n")
    print(f"{len(records)} combinations in {time.time() - start:.0f} s")


# ---- Comparison

def only_in(left, right):
    return [name for name in left if name not in right]


def place(array):
    """Output and kind of an array: "Mesh, field" of "Mesh, field Cells"."""
    output, _, rest = array.partition(", ")
    return output, rest.partition(" ")[0]


def find_renamed(old_records, new_records):
    """{name before: name after} of arrays that are called otherwise, and never have other values."""
    candidates = {}
    for name in only_in(old_records, only_in(old_records, new_records)):
        before, after = old_records[name]["arrays"], new_records[name]["arrays"]
        added = only_in(after, before)
        for array in only_in(before, after):
            same = [other for other in added
                if place(array) == place(other) and before[array] == after[other]]
            candidates[array] = only_in(candidates[array], only_in(candidates[array], same)) \
                if array in candidates else same
    renamed = {}
    for array, others in candidates.items():
        others = only_in(others, renamed.values())
        if others:
            renamed[array] = others[0]
    return renamed


def with_new_names(record, renamed):
    """A record, arrays called as in the other file."""
    return record | {what: {renamed.get(name, name): value for name, value in record[what].items()}
                     for what in ("arrays", "statistics")}


def differences(before, after):
    """Texts that say what differs in a combination."""
    for what in "codes", "messages":
        if before[what] != after[what]:
            yield f"{what} {before[what]} -> {after[what]}"
    yield from (f"{name} is gone" for name in only_in(before["arrays"], after["arrays"]))
    yield from (f"{name} is new" for name in only_in(after["arrays"], before["arrays"]))
    for name, array in before["arrays"].items():
        other = after["arrays"].get(name, array)
        if other != array:
            numbers = [record["statistics"].get(name) for record in (before, after)]
            yield f"{name} {change(array, other, *numbers)}"


def change(array, other, number, other_number):
    """Of a statistic, of type or size, or of values only."""
    if number != other_number and None not in (number, other_number):
        return f"{number:.15g} -> {other_number:.15g}"
    old, new = (text.rpartition(" ")[0] or text for text in (array, other))
    return "has other values" if old == new else f"{old} -> {new}"


class Comparison:
    """Of two files' records."""

    def __init__(self, old_records, new_records, ignore_renamed):
        self.old_records, self.new_records, self.ignore_renamed = old_records, new_records, ignore_renamed
        self.renamed = find_renamed(old_records, new_records)
        self.uses, self.reworded = collections.Counter(), collections.Counter()
        self.same = self.differ = 0

    def run(self):
        """Prints the combinations that differ."""
        for name in [*self.old_records, *only_in(self.new_records, self.old_records)]:
            found = self.compare(name)
            self.same, self.differ = self.same + (not found), self.differ + bool(found)
            if found:
                print(f"{name}: {'; '.join(found)}")

    def compare(self, name):
        """Texts that say what differs in a combination."""
        if name not in self.old_records or name not in self.new_records:
            return ["only in the first file" if name in self.old_records else "only in the second file"]
        before, after = self.old_records[name], self.new_records[name]
        names = {array: other for array, other in self.renamed.items()
                 if array in before["arrays"] and other in after["arrays"]}
        self.uses.update(names.items())
        self.reworded.update((text, other) for text, other in zip(before["texts"], after["texts"])
            if text != other)
        found = list(differences(with_new_names(before, names), after))
        if not self.ignore_renamed:
            found += [f"{array} is called {other}" for array, other in names.items()]
        return found

    def print_summary(self):
        for (array, other), count in self.uses.items():
            print(f"renamed in {count} combinations: {array} -> {other}")
        for (text, other), count in self.reworded.items():
            print(f"said in other words in {count} combinations:\n  - {text}\n  + {other}")
        print(f"{self.same} same, {self.differ} differ")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, metavar="FILE.json")
    parser.add_argument("--surfaces", type=pathlib.Path, nargs="+", default=[DATA], metavar="FOLDER")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--compare", type=pathlib.Path, nargs=2, metavar=("BEFORE.json", "AFTER.json"))
    parser.add_argument("--ignore-renamed", action="store_true")
    options = parser.parse_args()
    if bool(options.out) == bool(options.compare):
        parser.error("give either --out or --compare")
    if options.out:
        if simple is None:
            parser.error("only pvpython can mesh")
        write_all(options.out, options.surfaces, options.quick)
        return 0
    comparison = Comparison(*(json.loads(path.read_text()) for path in options.compare),
        options.ignore_renamed)
    comparison.run()
    comparison.print_summary()
    return 1 if comparison.differ else 0


if __name__ == "__main__":
    sys.exit(main())
