"""The complete task file: every key with its default and documentation."""

import json
import textwrap

from parameters import collections, parameters
from task import FLAT, MESHER, PERIODIC, REGION, SPLIT, cad_parameters, case_collections, case_parameters, shape_parameters, split_parameters

HEAD = """\
# A task for cartesian-mesher. All keys but surface.file are optional; the values below are the
# defaults. Paths of files are relative to this one. A boundary may be given by its number or by its
# "name"."""

SURFACE_FILE = """
# A closed surface, in any format that ParaView opens; or a list of files: each is a boundary with
# the name of its file.
file = "surface.stl\"

# Of a list of files: other names for their boundaries, or regions.
# names = ["surface"]"""

SPLIT_HEAD = """
# Divides the surface into boundaries, as Split Surface does; or [[surface.split]], once for each time.
# [surface.split]"""

SPLIT_ROWS = """
# [[surface.split.{}]]"""

SIZE_FIELD = """
# Data of any kind, such as a solution on an earlier mesh, with the size_array.
# size_field = "before.vtu\""""

FLAT_MESH = """
# The mesh one cell across, by Flat Mesh. The other outputs are of the mesh before."""

PERIODIC_PAIRS = """
# Pairs of periodic boundaries, by Periodic Boundaries, each in a table [[periodic]] of its own."""

REGIONS = """
# Refinement zones: boxes and spheres, each in a table [[regions]] of its own; or the file of a closed
# surface and a depth."""

ROWS = """
# Any number of tables of this kind, each with the first key; what other keys leave out is as without
# the table."""

OUTPUT = """
# What to write: a file for each key, or a list of files.
[output]
# mesh = ["mesh.vtu", "case/case.foam"]
# pieces = 1               # of the case: more for a decomposed case; on several ranks, as many as ranks
# boundary = "boundary.vtp"
# defects = "defects.vtp"
# statistics = "statistics.json"
# report = "report.html"   # pictures, boundaries, histograms, settings and warnings; of a mesh in one piece"""


CASE = """
# For OpenFOAM cases, .foam.
[case]"""

CAD = """
# How CAD files are read: STEP, IGES and BREP. Only with one of these.
# [cad]"""


def value(parameter):
    """Its default in TOML; JSON writes numbers, texts, lists and booleans alike."""
    return json.dumps(parameter.default)


def entry(parameter, commented=""):
    text = parameter.documentation.replace("**", "")
    if parameter.columns:
        text += f" Rows are [ {{ {', '.join(f'{column} = ...' for column in parameter.columns)} }}, ... ]."
    if parameter.choices:
        text += f" One of: {', '.join(json.dumps(choice) for choice in parameter.choices)}."
    lines = textwrap.wrap(text, 98, initial_indent="# ", subsequent_indent="# ")
    return "\n".join(["", *lines, f"{commented}{parameter.key} = {value(parameter)}"])


def split():
    return [SPLIT_HEAD, *[entry(parameter, "# ") for parameter in split_parameters()],
        *[part for rows in collections(SPLIT) for part in
            (SPLIT_ROWS.format(rows.key), *[entry(column, "# ") for column in rows.columns])]]


def rows(collection):
    return [ROWS, f"# [[{collection.key}]]", *[entry(column, "# ") for column in collection.columns]]


def template():
    parts = [HEAD]
    tables = {}
    for parameter in parameters(MESHER):
        if parameter.deprecated:
            continue
        tables.setdefault(parameter.table, []).append(parameter)
    for name, of in tables.items():
        parts.append(f"\n[{name}]")
        if name == "surface":
            parts.append(SURFACE_FILE)
        parts += [entry(parameter) for parameter in of]
        if name == "surface":
            parts += split()
        if name == "refinement":
            parts.append(SIZE_FIELD)
    for collection in collections(MESHER):
        parts += rows(collection)
    parts += [REGIONS, "# [[regions]]", *[entry(parameter, "# ") for parameter in parameters(REGION)]]
    for comment, table, name in (FLAT_MESH, "[flat]", FLAT), (PERIODIC_PAIRS, "[[periodic]]", PERIODIC):
        parts += [comment, f"# {table}", *[entry(parameter, "# ") for parameter in shape_parameters(name)]]
    return "\n".join([*parts, OUTPUT, CASE, *[entry(parameter) for parameter in case_parameters()],
        *[part for collection in case_collections() for part in rows(collection)],
        CAD, *[entry(parameter, "# ") for parameter in cad_parameters()]])
