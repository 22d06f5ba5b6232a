"""Writes _options.py, the options of cartesianmesher.mesh and their help, from the properties of the panel.

    make_options.py FILE

Plain Python, for builds without ParaView.
"""

import pathlib
import pprint
import re
import sys
import textwrap

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Plugin" / "Properties"))
from reference import every, panel, proxies  # noqa: E402

MESHER = "filters.CartesianMesher"
NO_OPTIONS = "Input", "InPieces", "Preview"  # an argument; for ranks; for the window
INPUTS = "Inputs"  # which have no group in the panel
WIDTH = 96  # help() indents by 4

NOUNS = {int: ("int", "ints"), float: ("float", "floats"), str: ("str", "str"), bool: ("bool", "bools"),
    "choice": ("str", "str")}


def key(label):
    """A label as Python calls it: "Cell Size" is cell_size."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", label.replace(" ", "")).lower()


def choices(property):
    """{text: number}: "Exact Fit" is "exact fit", "xMin" is "x min". Texts that the filter takes as they are, are theirs."""
    return {key(text).replace("_", " ") if isinstance(value, int) else text: value
        for text, value in property.choices().items()}


def default(property):
    value = property.default()
    return dict(zip(property.choices(), choices(property))).get(value, value) if isinstance(value, str) else value


def option(property):
    """How the filter is told: by setters, of all rows where there are some, or by an input's port."""
    if property.is_input:
        found = {"port": int(property.element.get("port_index")), "kind": property.data_types(),
            "several": property.takes_several}
    else:
        found = {"default": default(property), "set": property.element.get("command")}
        if property.has_rows:
            found["resize"] = property.element.get("set_number_command")
        elif property.choices():
            found["choices"] = choices(property)
    return found | ({"hidden": True} if property.is_hidden else {})


def paragraph(property):
    facts = property.facts(NOUNS, repr, [False, True] if property.kind is bool else choices(property))
    facts.pop("In a new row", None)  # of the panel's table
    if not property.is_input:
        facts["Default"] = repr(default(property))
    head = f"{key(property.label)}: {facts.pop('Type')}. " + " ".join(f"{what}: {text}." for what, text in facts.items())
    text = " ".join(property.documentation().replace("**", "").split())
    return "\n".join(textwrap.wrap(head, WIDTH, subsequent_indent="    ") +
        textwrap.wrap(text, WIDTH, initial_indent="    ", subsequent_indent="    "))


def help_text(groups):
    """All options in the panel's order, but those that are hidden, which older scripts have."""
    parts = []
    for label, members in groups.items():
        members = [property for property in members if property.name not in NO_OPTIONS and not property.is_information]
        parts += [f"{label or INPUTS}\n{'-' * len(label or INPUTS)}"] * bool(members)
        parts += map(paragraph, members)
    return "\n\n".join(parts)


def main(path):
    known = proxies()
    options = {key(property.label): option(property) for property in every(known[MESHER])
        if not property.is_information and property.name not in NO_OPTIONS and property.element.get("is_internal") != "1"}
    pathlib.Path(path).write_text(f"# Made by make_options.py.\nOPTIONS = {pprint.pformat(options, sort_dicts=False)}\n\n"
        f'HELP = """\\\n{help_text(panel(known[MESHER], known))}\n"""\n')


if __name__ == "__main__":
    main(sys.argv[1])
