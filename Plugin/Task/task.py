"""Task files (section 6, step 1): TOML that defines what to mesh, how, and what to write.

    [surface]
    file = "header.stl"        # any that ParaView opens; or a list: each a boundary, called as its file
    split = "Flat Caps"        # into boundaries; or a table of Split Surface's properties, or a list of them, one after the other
    names = ["header"]         # or by these names, one for each file

    [grid]                     # these tables have the groups of Cartesian Mesher's panel, and its
    cell_size = 4.0            # properties: see `cartesian-mesher --template`

    [refinement]
    refinement_depth = 1
    boundary_refinement = [ { boundary = "inlet", depth = 2, blending_distance = 2, blend_to_depth_1 = 0 } ]

    size_array = "size"        # of the surface, or of
    size_field = "before.vtu"  # any file of data that ParaView opens

    [[boundaries]]             # any number: those that differ from the others
    name = "inlet"
    type = "patch"
    small_cell_ratio = 1e-100

    [[regions]]                # any number; those of Refinement Region, or file and depth
    shape = "Sphere"
    center = [0.0, 10.0, 0.0]
    radius = 5.0
    depth = 2

    [flat]                     # then the mesh is one cell across: the properties of Flat Mesh
    across = "Z"

    [[periodic]]               # any number, in this order: pairs of boundaries, the properties of Periodic Boundaries
    first_boundary = "xMin"
    second_boundary = "xMax"

    [output]                   # all optional; files are next to the task file
    mesh = ["header.vtu", "case/header.foam"]
    pieces = 1                 # of the case: more for a decomposed one; on several ranks as many as these
    boundary = "header.vtp"
    defects = "defects.vtp"    # of the surface; of all of it, so not of a mesh in pieces
    statistics = "header.json"
    report = "header.html"     # pictures, boundaries, histograms and settings; of a mesh in one piece

    [case]                     # of .foam files: the properties of their writer
    solver_setup = "Incompressible"

    [[conditions]]             # any number: the tables of that writer's panel, which are these, [[materials]] and [[rotations]]
    boundary = "inlet"
    flow = "mass flow"
    flow_value = 0.02

    [cad]                      # of STEP, IGES and BREP files: the properties of their reader
    length_unit = "Millimetre"
"""

import bisect
import contextlib
import dataclasses
import pathlib
import re
import tomllib

from parameters import BadValue, collections, extensions, parameters, shown

MESHER, REGION, SPLIT, CASE_WRITER, CAD_READER = "CartesianMesher", "RefinementRegion", "SplitSurface", "PolyMeshWriter", "CADReader"
FLAT, PERIODIC = "FlatMesh", "PeriodicBoundaries"
PAIR = ("first_boundary", "second_boundary")
REPORT = ".html"
FILE_KEYS = {"surface": {"file", "names", "split"}, "refinement": {"size_field"}}  # beside the properties, by table
NOT_OF_SPLIT = ("NumberOfThreads",)  # the mesher has it too


def printable(text):
    """Characters that a terminal or VTK stream cannot take are escaped as in Python."""
    return "".join(c if c.isprintable() or c == "\n" else repr(c)[1:-1] for c in text)


class TaskError(Exception):
    """All that is wrong with a task file, each with its line."""

    def __init__(self, *texts):
        super().__init__(*map(printable, texts))


@dataclasses.dataclass
class Region:
    file: pathlib.Path | None  # or a shape
    properties: dict


@dataclasses.dataclass
class Task:
    path: pathlib.Path
    surfaces: list
    names: list  # of the surfaces' blocks; or empty: a single file is no block
    splits: list  # properties of Split Surface, one after the other
    properties: dict  # of Cartesian Mesher, by their names in Python
    regions: list
    size_field: pathlib.Path | None
    flat: dict | None  # properties of Flat Mesh
    periodic: list  # properties of Periodic Boundaries, for each pair
    mesh: list  # files to write
    boundary: list
    defects: list
    statistics: list
    report: list
    pieces: int
    case: dict  # properties of the cases' writer
    cad: dict  # properties of the reader of CAD files
    reader: object  # knows lines

    def error(self, where, what):
        """An error found after the task was read, at a path of keys."""
        return self.reader.error(where, what)


def lines_of(text):
    """{path of keys: line} of a TOML text; a path is a tuple, with numbers for tables in arrays."""
    lines, table, counts = {}, (), {}
    for number, line in enumerate(text.splitlines(), 1):
        head = re.match(r"\s*(\[\[?)([\w.\-\"' ]+)\]\]?\s*(#.*)?$", line)
        key = re.match(r"""\s*((?:[\w.\-]|"[^"]*"|'[^']*')+)\s*=""", line)
        if head:
            table = split_key(head[2])
            if head[1] == "[[":
                counts[table] = counts.get(table, -1) + 1
                table += (counts[table],)
            lines[table] = number
        elif key:
            lines[table + split_key(key[1])] = number
    return lines


def split_key(text):
    return tuple(part.strip().strip("\"'") for part in text.split("."))


def failing_line(text, failure):
    """The first line up to which a text is unreadable for that reason."""
    def fails(count):
        try:
            tomllib.loads("\n".join(lines[:count]))
        except Exception as error:
            return type(error) is failure
        return False
    lines = text.split("\n")
    return bisect.bisect_left(range(1, len(lines)), True, key=fails) + 1


class _Reader:
    def __init__(self, path):
        self.path = path
        self.errors = []
        try:
            text = path.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise TaskError(f"{path}: cannot be read: {error}") from None
        self.lines = lines_of(text)
        try:
            self.content = tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            raise TaskError(f"{path}: is not valid TOML: {error}") from None
        except RecursionError as error:
            raise self.unreadable(text, error, "lists are nested too deeply to be read") from None
        except ValueError as error:
            raise self.unreadable(text, error, "a number has more digits than can be read") from None

    def unreadable(self, text, error, what):
        """The line and its key, where TOML itself does not tell them."""
        line = failing_line(text, type(error))
        where = max((where for where in self.lines if self.lines[where] <= line), key=self.lines.get, default=())
        return self.error(where, f"{what}, in line {line}")

    def error(self, where, what):
        line = next((self.lines[where[:n]] for n in range(len(where), 0, -1)
            if where[:n] in self.lines), None)
        key = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in where)
        return TaskError(f"{self.path}{f':{line}' if line else ''}: {key.lstrip('.')}: {what}")

    def note(self, where, what):
        """Keeps an error, so that all are found at once."""
        self.errors += self.error(where, what).args

    def end(self):
        """When all has been read: throws what was kept."""
        if self.errors:
            raise TaskError(*self.errors)

    def table(self, content, where, known):
        """The table's known keys."""
        if not isinstance(content, dict):
            self.note(where, "must be a table")
            return {}
        for key in content:
            if key not in known:
                self.note(where + (key,), f"is not a known key; choose from {', '.join(sorted(known))}")
        return {key: value for key, value in content.items() if key in known}

    def values(self, content, where, of):
        """{name in Python: value} of the parameters `of` that the table has."""
        found = {}
        for parameter in of:
            if parameter.key in content:
                try:
                    found[parameter.name] = parameter.check(content[parameter.key])
                except BadValue as error:
                    self.note(where + (parameter.key,), error)
        return found

    def collection(self, content, of, within=()):
        """{name in Python: list} of tables [[key]]; what one leaves out is as without it, which the columns' defaults say."""
        first, *others = of.columns
        rows = []
        for i, table in enumerate(self.tables(content, *within, of.key)):
            where = (*within, of.key, i)
            table = self.table(table, where, {column.key for column in of.columns})
            if first.key not in table:
                self.note(where, f"needs the key {first.key}")
            rows.append({column.name: column.default for column in (first, *others)}
                | self.values(table, where, of.columns))
        values = {column.name: [row[column.name] for row in rows] for column in of.columns} if rows else {}
        return {column.name: sum(values[column.name], []) if column.count > 1 else values[column.name]
            for column in of.columns if rows}

    def tables(self, content, *where):
        """The content itself, if it is written [[key]]."""
        if isinstance(content, list):
            return content
        name = ".".join(part for part in where if isinstance(part, str))
        self.note(where, f"must be written [[{name}]], once for each")
        return []

    def splits(self, content):
        """Properties of Split Surface, for each time that it divides the surface."""
        of, rows = split_parameters(), collections(SPLIT)
        where = ("surface", "split")
        several = isinstance(content, list)
        found = []
        for i, table in enumerate(content if several else [content]):
            here = (*where, i) if several else where
            table = {"split_by": table} if isinstance(table, str) else table
            table = self.table(table, here, {parameter.key for parameter in of} | {row.key for row in rows})
            properties = self.values(table, here, of)
            for row in rows:
                properties |= self.collection(table.get(row.key, []), row, here)
            found.append(properties)
        return found

    def files(self, content, where, *, exist):
        """One file or a list of them, relative to the task file."""
        names = [content] if isinstance(content, str) else content
        if not isinstance(names, list) or not names and exist \
                or not all(isinstance(name, str) and name for name in names):
            self.note(where, "must be the name of a file, or a list of names")
            return []
        return [file for name in names if (file := self.file(name, where, exist))]

    def file(self, name, where, exist):
        if "\0" in name:
            self.note(where, f"{shown(name)} contains the character NUL, which file names cannot have")
            return None
        file = self.path.parent / name
        try:
            with contextlib.suppress(FileNotFoundError, NotADirectoryError):
                file.stat()  # other errors, which is_file() hides from Python 3.14 on
            if exist and not file.is_file():
                self.note(where, f"there is no file {file}")
            elif not exist and file.is_dir():
                self.note(where, f"{file} is a folder")
            elif exist:
                with file.open("rb") as stream:
                    stream.read(1)
        except OSError as error:
            self.note(where, f"{shown(name)} cannot be {'read' if exist else 'written'}: {error.strerror}")
        return file

    def region(self, content, where, of):
        known = {parameter.key for parameter in of}
        content = self.table(content, where, known | {"file"})
        properties = self.values(content, where, of)
        if "file" not in content:
            return Region(None, properties)
        for key in content:
            if key not in ("file", "depth"):
                self.note(where + (key,), "cannot be combined with file: give a file or a shape")
        return Region(next(iter(self.files(content["file"], where + ("file",), exist=True)), None), properties)


def block_names(reader, surface, files):
    """What the blocks of several files are called."""
    names = surface.get("names", [file.stem for file in files] if len(files) > 1 else [])
    if not isinstance(names, list) or not all(isinstance(name, str) and name for name in names):
        reader.note(("surface", "names"), "must be a list of names")
    elif "names" in surface and len(names) != len(files):
        reader.note(("surface", "names"), f"must have a name for each file, {len(files)} in all")
    return names


def targets_of(file):
    """The paths written for an output: the file, and the folder of its blocks."""
    return (file, file.with_suffix("")) if file.suffix in (".vtm", ".vtpc") else (file,)


def outputs(reader, content, inputs):
    """Files to write, by kind, none twice and none that is read; and the number of pieces."""
    kinds = ("mesh", "boundary", "defects", "statistics", "report")
    content = reader.table(content, ("output",), {*kinds, "pieces"})
    pieces = content.get("pieces", 1)
    if type(pieces) is not int or pieces < 1:
        reader.note(("output", "pieces"), f"{shown(pieces)} is not a whole number above 0")
    files = {kind: reader.files(content.get(kind, []), ("output", kind), exist=False) for kind in kinds}
    for file in files["report"]:
        if file.suffix != REPORT:
            reader.note(("output", "report"), f"{file} must end in {REPORT}")
    taken = {file.resolve(): "is an input of the task" for file in inputs}
    for kind in kinds:
        for file in files[kind]:
            for target in targets_of(file):
                if target.resolve() in taken:
                    reader.note(("output", kind), f"{target} {taken[target.resolve()]}: choose another name")
                taken[target.resolve()] = "is already an output"
    return files | {"pieces": pieces}


def case_parameters():
    """Those of the case writer, except the keys of [output]."""
    return [parameter for parameter in parameters(CASE_WRITER, "writers") if parameter.name not in ("FileName", "NewFolder", "Pieces")]


def case_collections():
    """Tables of the case writer: conditions, materials and rotations."""
    return collections(CASE_WRITER, "writers")


def cad_parameters():
    """Those of the reader of CAD files, for all of a task."""
    return [parameter for parameter in parameters(CAD_READER, "sources") if parameter.name != "FileName"]


# Triangles as far off the shape do not change a mesh of such cells much.
DEFLECTION_OF_CELL = 0.01


def cad_properties(reader, content, inputs, properties):
    """Of the reader of CAD files, by their names in Python; `properties`: of the mesher."""
    of = cad_parameters()
    found = reader.values(reader.table(content.get("cad", {}), ("cad",), {parameter.key for parameter in of}), ("cad",), of)
    suffixes = {"." + extension for extension in extensions(CAD_READER)}
    if "cad" in content and not any(file.suffix.lower() in suffixes for file in inputs):
        reader.note(("cad",), f"is for files that end in {', '.join(sorted(suffixes))}, and the task has none")
    has_lines = any(properties.get(f"Meshlines{axis}") for axis in "XYZ")
    if not found.get("Deflection") and not has_lines and properties.get("CellSize"):
        found["Deflection"] = DEFLECTION_OF_CELL * properties["CellSize"]
    return found


def split_parameters():
    """Those of Split Surface that tasks have."""
    return [parameter for parameter in parameters(SPLIT) if parameter.name not in NOT_OF_SPLIT]


def shape_parameters(name):
    """Those of a filter that comes after the mesher."""
    return [parameter for parameter in parameters(name) if parameter.name not in NOT_OF_SPLIT]


def shape(reader, content, where, name, needed=()):
    """Properties of such a filter; keys that its table needs."""
    of = shape_parameters(name)
    table = reader.table(content, where, {parameter.key for parameter in of})
    for key in needed if isinstance(content, dict) else ():
        if not table.get(key):
            reader.note(where, f"needs the key {key}")
    return reader.values(table, where, of)


def read_task(path):
    """The task in a file, checked as far as can be without its surface. Throws TaskError."""
    reader = _Reader(pathlib.Path(path))
    mesher, region, rows = parameters(MESHER), parameters(REGION), collections(MESHER)
    tables = {}
    for parameter in mesher:
        tables.setdefault(parameter.table, []).append(parameter)
    content = reader.table(reader.content, (), {*tables, "surface", "regions", "flat", "periodic", "output", "case", "cad",
        *(of.key for of in rows), *(of.key for of in case_collections())})

    properties, known = {}, {}
    for name, of in tables.items():
        keys = {parameter.key for parameter in of} | FILE_KEYS.get(name, set())
        known[name] = reader.table(content.get(name, {}), (name,), keys)
        properties |= reader.values(known[name], (name,), of)
    of_case = case_parameters()
    table = reader.table(content.get("case", {}), ("case",), {parameter.key for parameter in of_case})
    case = reader.values(table, ("case",), of_case)
    if case.get("CaseTemplates"):  # as all files of a task, relative to it
        case["CaseTemplates"] = str(reader.path.absolute().parent / case["CaseTemplates"])
    for of in case_collections():
        case |= reader.collection(content.get(of.key, []), of)
    for of in rows:
        properties |= reader.collection(content.get(of.key, []), of)
    if properties.get("TargetYPlus"):  # as before there were units
        properties.setdefault("LengthUnit", "Metre")
    surfaces = []
    if "file" in known["surface"]:
        surfaces = reader.files(known["surface"]["file"], ("surface", "file"), exist=True)
    else:
        reader.note(("surface",), "needs the key file: a surface to mesh")
    splits = reader.splits(known["surface"].get("split", []))
    names = block_names(reader, known["surface"], surfaces)
    regions = [reader.region(table, ("regions", i), region)
        for i, table in enumerate(reader.tables(content.get("regions", []), "regions"))]
    flat = shape(reader, content["flat"], ("flat",), FLAT) if "flat" in content else None
    periodic = [shape(reader, table, ("periodic", i), PERIODIC, PAIR)
        for i, table in enumerate(reader.tables(content.get("periodic", []), "periodic"))]
    size_field = known["refinement"].get("size_field")
    if size_field is not None and not isinstance(size_field, str):
        reader.note(("refinement", "size_field"), "must be the name of a file")
    elif size_field is not None:
        size_field = reader.file(size_field, ("refinement", "size_field"), True)
    inputs = [file for file in (*surfaces, size_field, *(region.file for region in regions)) if isinstance(file, pathlib.Path)]
    written = outputs(reader, content.get("output", {}), [reader.path, *inputs])
    if written["pieces"] > 1 and (flat is not None or periodic):
        reader.note(("output", "pieces"), "flat and periodic meshes are written in one piece: leave it out, and run decomposePar")
    cad = cad_properties(reader, reader.content, inputs, properties)
    reader.end()
    return Task(path=reader.path, surfaces=surfaces, names=names, splits=splits, properties=properties, regions=regions, size_field=size_field,
        flat=flat, periodic=periodic,
        case=case, cad=cad, reader=reader, **written)
