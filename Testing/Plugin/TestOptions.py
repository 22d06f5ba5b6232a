"""The panel, the filters in C++ and the template of task files have the defaults, ranges and choices that
the kernel has (Kernel/Mesher/OptionTable.h)."""

import json
import math
import pathlib
import subprocess
import sys
import tomllib

import cartesianmesher.vtkCartesianMesherFilters as filters
from paraview import simple  # noqa: F401: connects

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Plugin" / "Task"))
from parameters import collections, key_of, parameters  # noqa: E402
from task import MESHER  # noqa: E402
from template import template  # noqa: E402

PRINT_OPTIONS = sys.argv[3]
PROXIES = ("CartesianBoxer", "Patcher", "CellAssembler", "CartesianMesher", "SurfaceInspector",
           "FiniteVolumeQuality", "RefinementRegion")
ONLY_IN_FILTERS = {"LengthUnit", "InPieces"}

options = {option["name"].replace(" ", ""): option
    for option in json.loads(subprocess.check_output([PRINT_OPTIONS], text=True))}


def default_of(option):
    """As the panel and task files write it."""
    return option["choices"][int(option["initial"])] if option["choices"] else option["initial"]


def check_panel(where, parameter):
    option = options[parameter.name]
    what = f"{parameter.name} of {where}"
    assert parameter.default == default_of(option), \
        f"the default of {what} is {parameter.default!r}, the kernel's {default_of(option)!r}"
    assert parameter.choices == option["choices"], f"{what} is one of {parameter.choices}"
    assert option["unit"] in parameter.documentation, f"{what} is not in {option['unit']}"
    if parameter.kind is bool or parameter.choices:
        return
    # A panel cannot say "less than".
    most = option.get("most", math.inf) if option["with_most"] else math.inf
    assert (parameter.least, parameter.most) == (option["least"], most), \
        f"{what} is from {parameter.least} to {parameter.most}, the kernel's from {option['least']} to {most}"


def check_filter(kind, name, option):
    filter = kind()
    value = getattr(filter, "Get" + name)()
    assert value == option["initial"], \
        f"{kind.__name__} has {name} {value}, the kernel {option['initial']}"
    for number, choice in enumerate(option["choices"]):
        getattr(filter, f"Set{name}To{choice.replace(' ', '')}")()
        assert getattr(filter, "Get" + name)() == number, f"{kind.__name__}: {choice}"
    if option["choices"]:
        for wrong, right in (-1, 0), (len(option["choices"]), len(option["choices"]) - 1):
            getattr(filter, "Set" + name)(wrong)
            assert getattr(filter, "Get" + name)() == right, f"{kind.__name__}.{name}: {wrong}"


seen = set()
for proxy in PROXIES:
    for parameter in parameters(proxy):
        if parameter.name in options:
            check_panel(proxy, parameter)
            seen.add(parameter.name)
    kind = getattr(filters, "vtk" + proxy)
    for name, option in options.items():
        if hasattr(kind, "Get" + name):
            check_filter(kind, name, option)
            seen.add("vtk" + name)
    # What the panel has, the filter has.
    missing = {parameter.name for parameter in parameters(proxy)} & set(options) - \
        {name for name in options if hasattr(kind, "Get" + name)}
    assert not missing, f"vtk{proxy} has no {missing}"
assert seen == set(options) | {"vtk" + name for name in options}, set(options) - seen

unknown = {parameter.name for parameter in parameters(MESHER)
    if parameter.count == 1 and not parameter.rows and parameter.kind is not str} - set(options)
assert unknown == ONLY_IN_FILTERS, f"the kernel does not know {unknown - ONLY_IN_FILTERS}"

# A new row of a table changes nothing by itself.
for collection in collections(MESHER):
    for column in collection.columns:
        if column.key in map(key_of, ("Small Cell Ratio", "Layers Thickness")) or (collection.key, column.key) == ("boundaries", "depth"):
            assert column.default == -1, f"{column.key} of [[{collection.key}]] is {column.default}"

keys = {key: value for table in tomllib.loads(template()).values() if isinstance(table, dict)
    for key, value in table.items()}
for parameter in parameters(MESHER):
    if parameter.name in options and not parameter.deprecated:
        said = keys[parameter.key]
        assert said == default_of(options[parameter.name]), f"the template says {parameter.key} = {said}"

print(len(options), "options")
