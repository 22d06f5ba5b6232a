"""What a user does in ParaView's window, as events that its own test player understands."""

from xml.sax.saxutils import quoteattr

PANEL = "pqClientMainWindow/propertiesDock/propertiesPanel"
PROPERTIES = (f"{PANEL}/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame"
    "/ProxyPanel")
RETURN = "16777220"


def event(object, command, arguments=""):
    return f"<pqevent object={quoteattr(object)} command={quoteattr(command)} " \
        f"arguments={quoteattr(str(arguments))}/>"


def check(object, property, value):
    return f'<pqcheck object="{object}" property="{property}" arguments={quoteattr(value)}/>'


def script(*events):
    return "<?xml version='1.0'?>\n<pqevents>\n" + "\n".join(events) + "\n</pqevents>\n"


def open_file(path, choose_reader=False):
    """`choose_reader`: several can read it; the first of the list is taken."""
    events = [event("pqClientMainWindow/menubar/menu_File", "activate", "actionFileOpen"),
              event("pqClientMainWindow/FileOpenDialog", "filesSelected", path)]
    if choose_reader:
        events.append(event("pqClientMainWindow/pqSelectReaderDialog/okButton", "activate"))
    return "\n".join(events)


def meshing_menu(filter, category="Meshing"):
    """The menu Filters is opened first: ParaView 5.13 fills it only then."""
    return "\n".join([event("pqClientMainWindow/menubar", "activate", "menuFilters"),
        event(f"pqClientMainWindow/menubar/menuFilters/{category}", "activate", filter)])


def apply():
    return event(f"{PANEL}/Accept", "activate")


def advanced():
    return event(f"{PANEL}/SearchBox/AdvancedButton", "set_boolean", "true")


def number(property, value):
    return event(f"{PROPERTIES}/{property}/DoubleLineEdit0", "set_string", value)


def choose(property, text):
    return event(f"{PROPERTIES}/{property}/ComboBox", "set_string", text)


def table_row(property, row, values):
    """Adds a row to a table and types its values."""
    list = f"{PROPERTIES}/{property}/ScalarValueList"
    events = [event(f"{list}/Add", "activate")]
    for column, value in enumerate(values):
        editor = f"{list}/Table/qt_scrollarea_viewport/1QExpandingLineEdit0"
        events += [event(f"{list}/Table", "edit", f"{row}.{column}"),
                   event(editor, "set_string", value), event(editor, "key", RETURN)]
    return "\n".join(events)


def rows(property, count):
    """The table has so many rows. A macro would tell too, but in ParaView 5.13 what undo undoes is then the macro."""
    table = f"{PROPERTIES}/{property}/ScalarValueList/Table"
    return f'<pqcheck object={quoteattr(table)} property="modelRowCount" arguments="{count}"/>'


BOUNDARIES = f"{PROPERTIES}/BoundaryTable/Table"


def boundary(row, column, value):
    """Types a value into a field of the table Boundaries, or chooses it: columns are counted with Area and Triangles."""
    edit = event(BOUNDARIES, "edit", f"{row}.{column}")
    editor = f"{BOUNDARIES}/qt_scrollarea_viewport/1"
    if column == 3:
        return edit + event(f"{editor}QComboBox0", "set_string", value)
    return "\n".join([edit, event(f"{editor}QLineEdit0", "set_string", value), event(f"{editor}QLineEdit0", "key", RETURN)])


def boundary_row(row, type, ratio):
    return boundary(row, 3, type) + boundary(row, 4, ratio)


def shows_boundary(row, column, value):
    return f'<pqcheck object={quoteattr(BOUNDARIES)} property="modelItemData" arguments={quoteattr(f"{row}.{column},{value}")}/>'


def select_boundaries(*ranges):
    """From a row to another each."""
    return event(BOUNDARIES, "setCurrent", f"{ranges[0][0]}.0") + \
        event(BOUNDARIES, "setSelection", ",".join(f"{row}.0" for range in ranges for row in range))


VIEW = ("pqClientMainWindow/centralwidget/MultiViewWidget/CoreWidget/qt_tabwidget_stackedwidget/MultiViewWidget1"
    "/Container/Frame.0")


def look(direction):
    """By a button of the camera's toolbar, such as PositiveX or IsometricView."""
    return event(f"pqClientMainWindow/cameraToolbar/action{direction}", "activate")


VIEWPORT = f"{VIEW}/CentralWidgetFrame/Viewport/1QVTKOpenGLNativeWidget0"


def click(x, y, to=None, modifiers=0):
    """Presses and releases the left button in the view, where places are from 0 to 1; `to`: drags it there."""
    end = to or (x, y)
    return "\n".join([event(VIEWPORT, "mousePress", f"({x},{y},1,1,{modifiers})"),
        *([event(VIEWPORT, "mouseMove", f"({end[0]},{end[1]},0,1,{modifiers})")] if to else []),
        event(VIEWPORT, "mouseRelease", f"({end[0]},{end[1]},1,0,{modifiers})")])


def select_cells(x, y):
    """Those that are seen near a place of the view, from 0 to 1."""
    return event(f"{VIEW}/actionSelectSurfaceCells", "set_boolean", "true") + click(x, y, to=(x + .01, y + .01))


def copy_selection():
    return event(f"{PROPERTIES}/SelectedCells/Copy", "activate")


def text(property, value):
    return event(f"{PROPERTIES}/{property}/{property}", "set_string", value)


def save_as(file):
    """Up to the dialog of the writer."""
    return "\n".join([event("pqClientMainWindow/menubar/menu_File", "activate", "actionFileSaveData"),
                      event("pqClientMainWindow/FileSaveDialog", "filesSelected", file)])


def undo():
    return event("pqClientMainWindow/menubar/menu_Edit", "activate", "actionEditUndo")


def redo():
    return event("pqClientMainWindow/menubar/menu_Edit", "activate", "actionEditRedo")


def macro(name):
    return event("pqClientMainWindow/menubar/menu_Macros", "activate", name)


def colour_by(array):
    """In the toolbar, of what is selected."""
    return event("pqClientMainWindow/variableToolbar/displayColor/Variables", "set_string", array)
