"""The pages in ParaView's Help: one for each filter, reader and writer, under the name that the ? button opens, with all
properties of its panel, their defaults, ranges and units; links, anchors and pictures, and the table of contents, lead
somewhere."""

import pathlib
import re
import sqlite3
import sys
import zlib

from pages import HELP, REPOSITORY

sys.path.insert(0, str(HELP))
from convert import contents, html_name, panel, proxies  # noqa: E402

BUILT = pathlib.Path(sys.argv[2]).parents[1] / "Plugin"


def read_help(path):
    """{name: content} of the files in a .qch, which is a database of SQLite; what they are found under."""
    with sqlite3.connect(f"file:{path}?mode=ro", uri=True) as database:
        (namespace,), = database.execute("SELECT Name FROM NamespaceTable")
        (folder,), = database.execute("SELECT Name FROM FolderTable")
        rows = database.execute("SELECT Name, Data FROM FileNameTable, FileDataTable "
            "WHERE FileNameTable.FileId = FileDataTable.Id AND Name != ''")
        # As qCompress writes it: the size, then zlib's stream.
        return {name: zlib.decompress(data[4:]) for name, data in rows}, namespace, folder


files, namespace, folder = read_help(BUILT / "paraview_help" / "CartesianMesher.qch")
# The button looks for qthelp://NAMESPACE/FOLDER/GROUP.NAME.html, where FOLDER is NAMESPACE up to its dot.
assert (namespace, folder) == ("CartesianMesher.org", "CartesianMesher"), (namespace, folder)
pages = {name: data.decode() for name, data in files.items() if name.endswith(".html")}
ours = {html_name(page.name) for page in HELP.glob("*.md")}
assert ours <= set(pages), f"not in the Help: {ours - set(pages)}"

# Labels of numbers that have a unit.
OF_UNITS = r"Size|Meshlines|Points|Bounds|Lengths?|Thickness|Tolerance|Positions?|Center|Radius|Rotation(?! Axes)|Angle|Orthogonality|Speed|" \
    "Viscosity|Temperature|Memory"

known = proxies()


def check_property(property, page, where):
    """On the page, a line below the documentation says what the property may be."""
    found = re.search(rf"<strong>{property.label}</strong>(?:(?!<p>).)*?<em>(Type: .*?)</em>", page, re.S)
    assert found, f"{property.label} is not in {where}"
    facts = dict(re.findall(r"(Type|Default|Range|Choices|Unit): (.+?)\.(?= [A-Z]|$)", found[1]))
    if property.is_information or facts["Type"] == "button":
        return
    assert "Default" in facts, f"{where} does not say the default of {property.label}"
    if property.is_input:
        return
    assert "Range" in facts or "Choices" in facts, f"{where} does not say what {property.label} may be"
    if property.kind is float and re.search(rf"\b({OF_UNITS})\b", property.label):
        assert "Unit" in facts, f"{where} does not say the unit of {property.label}"


for name, proxy in known.items():
    if name.startswith(("misc.", "internal_")):
        continue
    assert f"{name}.html" in ours, f"{proxy.get('label')} has no page in {HELP.relative_to(REPOSITORY)}"
    page = pages[f"{name}.html"]
    assert f"{proxy.get('label')}</h1>" in page, f"{name}.html is not our page"
    for members in panel(proxy, known).values():
        for property in members:
            check_property(property, page, f"{name}.html")


def check(target, where):
    name, _, anchor = target.partition("#")
    name = name or where
    assert name in files, f"{where}: {target} does not exist"
    assert not anchor or f'name="{anchor}"' in pages[name], f"{where}: {target}: no such heading"


for name in ours:
    for target in re.findall(r'(?:href|src)="([^"]+)"', pages[name]):
        if not re.match(r"[a-z]+:", target):
            check(target, name)
for target in re.findall(r'ref="([^"]+)"', contents()):
    check(target, "contents")
