"""What the server-manager XML says of a filter's properties: type, default, range or choices, and unit. The pages of the
Help (Help/convert.py) and Python's help() (Filters/Python/make_options.py) have it from here. Without ParaView, too.
"""

import pathlib
import re
import textwrap
from xml.etree import ElementTree

HERE = pathlib.Path(__file__).resolve().parent

KINDS = {"IntVectorProperty": int, "DoubleVectorProperty": float, "StringVectorProperty": str}

# Units of numbers, as documentation names them.
UNITS = {
    r"multiple of the longest side": "the longest side of the surface's bounding box",
    r"units of the surface": "units of the surface",
    r"in Length Unit": "Length Unit",
    r"degrees": "degrees",
    r"in GiB": "GiB",
    r"in m/s": "m/s",
    r"in m2/s": "m2/s",
    r"in K\b": "K",
    r"in kg/m3": "kg/m3",
    r"in J/\(kg K\)": "J/(kg K)",
    r"in W/\(m K\)": "W/(m K)",
    r"in W\b(?!/)": "W",
    r"in m\b(?!2|3|/)": "m",
    r"in s\b": "s",
    r"in rpm": "rpm",
}


def proxies():
    """{group.name: its element} of the plugin's XML, with the shared properties in it as CMake puts them there."""
    text = re.sub(r"^@(\w+)@$", lambda part: (HERE / f"{part[1]}.xml").read_text(),
        (HERE.parent / "CartesianMesher.xml.in").read_text(), flags=re.M)
    return {f"{group.get('name')}.{proxy.get('name')}": proxy
        for group in ElementTree.fromstring(text) for proxy in group}


class Property:
    """`column`: of a list that the panel shows as a column of a table, the property of a row."""

    def __init__(self, element, column=None):
        self.element = element
        self.name = element.get("name")
        self.label = element.get("label", self.name).replace("\N{NO-BREAK SPACE}", " ")
        self.is_input = element.tag == "InputProperty"
        self.takes_several = element.get("multiple_input") == "1"
        self.is_information = element.get("information_only") == "1"
        self.is_hidden = element.get("panel_visibility") == "never" or element.find("Documentation") is None
        self.is_advanced = element.get("panel_visibility") == "advanced"
        self.has_rows = element.get("repeat_command") == "1"
        self.count = int(element.get("number_of_elements_per_command" if self.has_rows else "number_of_elements", 1))
        if element.find("ArraySelectionDomain") is not None:
            self.count = 1  # names; to the server they go with a number each
        self.columns = [label.get("label") for label in element.iter("ComponentLabel")] if self.count > 1 else []
        self.column = Property(column) if column is not None else None
        self.kind = bool if element.find("BooleanDomain") is not None else KINDS.get(element.tag)

    def documentation(self):
        """As Markdown."""
        return textwrap.dedent(self.element.findtext("Documentation", "").strip("\n")).strip()

    def data_types(self):
        """Of an input."""
        return " or ".join(kind.get("value") for kind in self.element.iter("DataType"))

    def choices(self):
        """{text: value}"""
        if self.column:
            return self.column.choices()
        texts = {entry.get("text"): int(entry.get("value")) for entry in self.element.iterfind("EnumerationDomain/Entry")}
        return texts or {entry.get("value"): entry.get("value") for entry in self.element.iterfind("StringListDomain/String")}

    def default(self):
        """A text, a number or a truth, or a list of them."""
        if self.has_rows:
            return []
        texts = self.element.get("default_values", "").split() if self.count > 1 else [self.element.get("default_values", "")]
        values = [bool(int(text)) if self.kind is bool else self.kind(text) for text in texts]
        names = {value: text for text, value in self.choices().items()}
        values = [names.get(value, value) for value in values]
        return values if self.count > 1 else values[0]

    def range(self):
        """Of numbers. What domains cannot say, and what is not limited by its domain but starts there, says a hint."""
        if self.column:
            return self.column.range()
        for hint in self.element.iterfind("Hints/Range"):
            return hint.get("text")
        least, most = (next((domain.get(end) for domain in self.element if domain.tag.endswith("RangeDomain")
            and domain.get(end)), None) for end in ("min", "max"))
        if least and most:
            return f"{least} to {most}"
        if least:
            return f"more than {least}" if self.element.find("Hints/MoreThanMinimum") is not None else f"{least} or more"
        return "any"

    def unit(self):
        """Of numbers, or empty."""
        text = " ".join(self.documentation().split())
        found = [unit for pattern, unit in UNITS.items() if re.search(pattern, text)]
        return found[0] if found and self.kind is float and len(self.columns) in (0, 3) else ""

    def facts(self, nouns, written, choices=None):
        """{what: text}: `nouns` are what one and several of a kind are called; `written` makes a text of a value."""
        if self.element.get("panel_widget") == "UntracedButton":
            return {"Type": "button"}
        if self.is_information:
            return {"Type": "shown only, cannot be set"}
        if self.is_input:
            several = "any number of " if self.takes_several else ""
            needed = "" if self.element.find("Hints/Optional") is not None else ", it is required"
            return {"Type": f"{several}{self.data_types()}", "Default": f"none{needed}"}
        choices = self.choices() if choices is None else choices
        kind = "choice" if choices and self.kind is not bool else self.kind
        found = {"Type": self._type(*nouns[kind])}
        found["Default"] = "from the bounding box of the input" if self.element.find("BoundsDomain") is not None \
            else written(self.default())
        if self.column:
            found["In a new row"] = written(self.column.default())
        if choices:
            found["Choices"] = ", ".join(map(written, choices))
        else:
            found["Range"] = self.range()
        if self.unit():
            found["Unit"] = self.unit()
        return found

    def _type(self, one, several):
        if not self.has_rows:
            return one if self.count == 1 else f"{self.count} {several}"
        if self.count == 1:
            return f"list of {several}"
        return f"list of rows of {self.count} {several}" + \
            (f" ({', '.join(self.columns)})" if self.columns else "")


def panel(proxy, known):
    """{label of a group, or empty: its visible properties}, as the panel shows them."""
    groups = {"": []}
    rows = {}  # the proxies of the tables' rows, by the properties' names
    label = ""
    for group in proxy.iter("PropertyGroup"):
        label = group.get("label") or label  # one without continues the group above
        prototype = group.find("Hints/PropertyCollectionWidgetPrototype")
        for part in group.iter("Property"):
            groups.setdefault(label, []).append(part.get("name"))
            if prototype is not None:
                rows[part.get("name")] = _row_property(known, prototype, part.get("function"))
    shown = {property.name: property for property in every(proxy, rows) if not property.is_hidden}
    grouped = {name for names in groups.values() for name in names}
    groups[""] = [name for name in shown if name not in grouped]
    return {label: [shown[name] for name in names if name in shown] for label, names in groups.items()}


def every(proxy, rows={}):
    """All its properties, those that no panel shows included."""
    return [Property(child, rows.get(child.get("name"))) for child in proxy if child.tag.endswith("Property")]


def _row_property(known, prototype, function):
    name = f"{prototype.get('group')}.{prototype.get('name')}"
    while name in known:
        for property in known[name]:
            if property.get("name") == function:
                return property
        name = f"{known[name].get('base_proxygroup')}.{known[name].get('base_proxyname')}"
    raise LookupError(f"{function} is not in {prototype.attrib}")
