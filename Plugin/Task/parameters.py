"""Properties of a filter, from its server-manager XML: the panel and the task files share
names, defaults, ranges and documentation, because both read them there."""

import dataclasses
import itertools
import math
import re

from paraview import servermanager


def key_of(label):
    """A label as a key of a task file: "Cell Size" is cell_size."""
    return re.sub(r"[^a-z0-9]+", "_", label.lower()).strip("_")


def name_of(label):
    """A label as a name in Python: without its spaces, also those that do not break."""
    return "".join(label.split())


# Whole numbers go to the server as a C int.
LEAST_INT, MOST_INT = -2**31, 2**31 - 1

LONGEST_SHOWN = 60  # characters of a value in a message


class BadValue(Exception):
    """A value that a parameter cannot have; says which are allowed."""


def shown(value):
    """A value as Python writes it, shortened if long."""
    try:
        text = repr(value)
    except ValueError:  # whole numbers of more than 4300 digits
        return "a number of thousands of digits"
    return text if len(text) <= LONGEST_SHOWN else text[:LONGEST_SHOWN] + "..."


@dataclasses.dataclass
class Parameter:
    name: str  # in Python: the label without its spaces
    table: str  # of a task file: the panel's group, or "" where there are no groups
    key: str
    kind: type  # int, float, bool or str
    count: int  # how many values; of a row, where there are rows
    rows: bool  # any number of rows
    columns: list  # keys of the values in a row, or empty; of "boundary" a name will do
    choices: list  # texts of which a value must be one, or empty
    least: float
    most: float
    with_least: bool  # whether `least` itself is allowed
    default: object
    deprecated: bool  # older tasks have it; no panel and no template shows it
    documentation: str

    def check(self, value):
        """`value` in the property's form: a number, a text, or a list of them in one row."""
        if self.rows:
            if not isinstance(value, list):
                raise BadValue(f"must be a list{' of rows' if self.count > 1 else ''}")
            rows = [self._row(row, f"row {i}: " if self.count > 1 else "") for i, row in enumerate(value)]
            return [part for row in rows for part in row]
        if self.count == 1:
            return self._one(value, "")
        return self._row(value, "")

    def _row(self, row, where):
        if self.columns and isinstance(row, dict):
            for key in row:
                if key not in self.columns:
                    raise BadValue(f"{where}there is no {key}, only {', '.join(self.columns)}")
            for key in self.columns:
                if key not in row:
                    raise BadValue(f"{where}{key} is missing")
            row = [row[key] for key in self.columns]
        if self.count == 1 and not isinstance(row, list):
            row = [row]
        if not isinstance(row, list) or len(row) != self.count:
            raise BadValue(f"{where}must have {self.count} values"
                + (f": {', '.join(self.columns)}" if self.columns else ""))
        return [value if column == "boundary" and isinstance(value, str) else self._one(value, where)
            for column, value in itertools.zip_longest(self.columns, row)]

    def _one(self, value, where):
        if self.choices:
            for choice in self.choices:  # "Box" in one table of the panel is "box" in another
                if isinstance(value, str) and value.casefold() == choice.casefold():
                    return choice
            raise BadValue(f"{where}{shown(value)} is not one of {', '.join(map(repr, self.choices))}")
        if self.kind is str:
            if not isinstance(value, str):
                raise BadValue(f"{where}{shown(value)} is not a text")
            if "\0" in value:
                raise BadValue(f"{where}{shown(value)} contains the character NUL, which names cannot have")
            return value
        if self.kind is bool:
            if value not in (True, False):
                raise BadValue(f"{where}{shown(value)} is neither true nor false")
            return int(value)
        return self._number(value, where)

    def _number(self, value, where):
        whole = self.kind is int
        if not isinstance(value, (int, float)) or value != value or (
                whole and isinstance(value, float) and not value.is_integer()):
            raise BadValue(f"{where}{shown(value)} is not a {'whole ' if whole else ''}number")
        least, most = self.limits()
        if not least <= value <= most or value == least and not self.with_least:
            raise BadValue(f"{where}{shown(value)} is out of range: {self.range()}")
        try:
            return self.kind(value)
        except OverflowError:
            raise BadValue(f"{where}{shown(value)} is too large for a number") from None

    def limits(self):
        if self.kind is int:
            return max(self.least, LEAST_INT), min(self.most, MOST_INT)
        return self.least, self.most

    def range(self):
        least, most = self.limits()
        above = f"{least:.10g} or more" if self.with_least else f"more than {least:.10g}"
        ends = (above if math.isfinite(least) else "",
            f"at most {most:.10g}" if math.isfinite(most) else "")
        return " and ".join(end for end in ends if end)


@dataclasses.dataclass
class Collection:
    """Lists that the panel shows as one table, and a task file has in tables [[key]]."""
    key: str
    columns: list  # parameters; the first, a name, is never left out


def _domain(property, wanted):
    """The first domain of a class, or None."""
    domains = property.NewDomainIterator()
    domains.UnRegister(None)
    domains.Begin()
    while not domains.IsAtEnd():
        if domains.GetDomain().IsA(wanted):
            return domains.GetDomain()
        domains.Next()
    return None


def _columns(property):
    hints = property.GetHints()
    labels = hints and hints.FindNestedElementByName("ShowComponentLabels")
    return [key_of(labels.GetNestedElement(i).GetAttribute("label"))
        for i in range(labels.GetNumberOfNestedElements())] if labels else []


def _has_hint(property, name):
    hints = property.GetHints()
    return bool(hints and hints.FindNestedElementByName(name))


def _range(property):
    least, most = -math.inf, math.inf
    for kind in "vtkSMDoubleRangeDomain", "vtkSMIntRangeDomain":
        domain = _domain(property, kind)
        # Of data, such as bounds: where a value starts, no limit.
        if domain and not domain.IsA("vtkSMBoundsDomain"):
            least = domain.GetMinimum(0) if domain.GetMinimumExists(0) else least
            most = domain.GetMaximum(0) if domain.GetMaximumExists(0) else most
    return least, most


def _parameter(property, table):
    label = property.GetXMLLabel()
    rows = bool(property.GetRepeatable())
    count = property.GetNumberOfElementsPerCommand() if rows else property.GetNumberOfElements()
    if _domain(property, "vtkSMArraySelectionDomain"):
        count = 1  # names of those chosen; to the server they go with a number each
    kind = {"vtkSMIntVectorProperty": int, "vtkSMDoubleVectorProperty": float,
            "vtkSMStringVectorProperty": str}[property.GetClassName()]
    elements = [property.GetElement(i) for i in range(property.GetNumberOfElements())]
    choices = _domain(property, "vtkSMEnumerationDomain")
    strings = _domain(property, "vtkSMStringListDomain")
    if strings and strings.GetClassName() != "vtkSMStringListDomain":
        strings = None  # of data: any text will do
    texts = [choices.GetEntryText(i) for i in range(choices.GetNumberOfEntries())] if choices else []
    if choices:
        values = [choices.GetEntryValue(i) for i in range(choices.GetNumberOfEntries())]
        elements = [texts[values.index(element)] for element in elements]
    elif strings:
        texts = [strings.GetString(i) for i in range(strings.GetNumberOfStrings())]
    elif _domain(property, "vtkSMBooleanDomain"):
        kind = bool
        elements = [bool(element) for element in elements]
    least, most = _range(property)
    return Parameter(name=name_of(label), table=table, key=key_of(label), kind=kind,
        count=count, rows=rows, columns=_columns(property) if count > 1 else [], choices=texts, least=least, most=most,
        with_least=not _has_hint(property, "MoreThanMinimum"),
        default=elements if rows or count > 1 else elements[0],
        deprecated=property.GetPanelVisibility() == "never",
        documentation=" ".join(property.GetDocumentation().GetDescription().split()))


def _prototype(group, name):
    return servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy(group, name)


def _groups(prototype):
    """The panel's groups: (key, {name of a property: what it is in the prototype of a table's row},
    that prototype or None)."""
    for i in range(prototype.GetNumberOfPropertyGroups()):
        group = prototype.GetPropertyGroup(i)
        members = [group.GetProperty(j) for j in range(group.GetNumberOfProperties())]
        hint = group.GetHints() and group.GetHints().FindNestedElementByName("PropertyCollectionWidgetPrototype")
        row = _prototype(hint.GetAttribute("group"), hint.GetAttribute("name")) if hint else None
        table = group.GetHints() and group.GetHints().FindNestedElementByName("TaskTable")
        yield (table.GetAttribute("name") if table else key_of(group.GetXMLLabel()),
            {prototype.GetPropertyName(member): group.GetFunction(member) for member in members}, row)


def collections(name, group="filters"):
    """All tables of the filter with that XML name, or of another group's proxy, that are several lists in Python."""
    prototype = _prototype(group, name)
    return [Collection(key, [
                dataclasses.replace(_parameter(row.GetProperty(function), key),
                    name=name_of(prototype.GetProperty(name).GetXMLLabel()))
                for name, function in functions.items()])
        for key, functions, row in _groups(prototype) if row]


def parameters(name, group="filters"):
    """All other parameters of that filter, or of another group's proxy, in the order of its panel's groups."""
    prototype = _prototype(group, name)
    tables = {name: key for key, functions, row in _groups(prototype) for name in functions if not row}
    columns = {name for _, functions, row in _groups(prototype) for name in functions if row}
    found = {}
    properties = prototype.NewPropertyIterator()
    properties.UnRegister(None)
    properties.Begin()
    while not properties.IsAtEnd():
        property = properties.GetProperty()
        # Inputs and buttons have no values.
        if property.IsA("vtkSMVectorProperty") and not property.GetInformationOnly() and \
                not property.GetIsInternal() and not _has_hint(property, "PanelOnly") and properties.GetKey() not in columns:
            found[properties.GetKey()] = _parameter(property, tables.get(properties.GetKey(), ""))
        properties.Next()
    return [found.pop(name) for name in tables if name in found] + list(found.values())


def extensions(name):
    """Of the files that this reader opens, without dots."""
    return _prototype("sources", name).GetHints().FindNestedElementByName("ReaderFactory").GetAttribute("extensions").split()


def names(name):
    """Their names in Python."""
    return [parameter.name for parameter in parameters(name)] + \
        [column.name for collection in collections(name) for column in collection.columns]
