"""Polyhedral Cartesian meshes of closed surfaces, with VTK alone: no ParaView is needed.

    import cartesianmesher
    mesh = cartesianmesher.mesh(surface, cell_size=0.1)

`mesh` takes a surface and gives a vtkUnstructuredGrid. Options are keywords; help(cartesianmesher.mesh) lists
them. What goes wrong is an exception with the error's name, such as cartesianmesher.EmptySurface. The filters
themselves are in cartesianmesher.vtkCartesianMesherFilters.
"""

import re
import textwrap
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from ._options import HELP, OPTIONS as _OPTIONS
from .vtkCartesianMesherFilters import vtkCartesianAlgorithm, vtkCartesianMesher


class Error(RuntimeError):
    """What the mesher refuses, or cannot do; `code` is the filter's error code."""

    code = None


def _error(name, code):
    return type(name, (Error,), {"__module__": __name__, "code": code, "__doc__": f"Error {code}."})


_ERRORS = {
    code: _error(name, code)
    for name, code in vars(vtkCartesianAlgorithm).items()
    if isinstance(code, int) and code > 40000
}
globals().update({error.__name__: error for error in _ERRORS.values()})

_SEQUENCES = list, tuple, np.ndarray
OPTIONS = sorted(name for name, option in _OPTIONS.items() if not option.get("hidden"))


def mesh(surface, faces=None, **options):
    """The mesh of a closed surface, as a vtkUnstructuredGrid.

    `surface`: a vtkPolyData, or any mesh that is one, such as PyVista's; or an array of points,
    n x 3, with `faces`, an array of triangles, m x 3, that number them from 0. Options that are left
    out have the defaults of ParaView's panel.

    Options are called like the panel's labels, which the texts below use: Cell Size is cell_size,
    the choice Exact Fit is "exact fit". Lists are sequences: boundary_names=["inlet"], and of rows
    refinement_blocks=[(0, 5, 0, 5, 0, 1, 2, 1)].

    Raises TypeError and ValueError for arguments that are no surface and no options, and an Error
    with the name of what went wrong.

{options}
    """
    mesher = vtkCartesianMesher()
    mesher.SetInputDataObject(_surface(surface, faces))
    for name, value in options.items():
        _set(mesher, name, value)
    messages = []
    for event in "ErrorEvent", "WarningEvent":
        mesher.AddObserver(event, _listener(messages, event))
    mesher.Update()
    if mesher.GetErrorCode():
        text = messages[0] if messages else f"error {mesher.GetErrorCode()}"
        raise _ERRORS.get(mesher.GetErrorCode(), Error)(text)
    return mesher.GetOutput()


mesh.__doc__ = mesh.__doc__.format(options=textwrap.indent(HELP, "    "))


def _listener(messages, event):
    """Keeps errors; warnings, of flaws that the mesh survives, are printed by Python."""
    def hear(_caller, _event, text):
        text = re.sub(r"^.*?\(0x[0-9a-f]+\): ", "", text, flags=re.DOTALL).strip()
        if event == "ErrorEvent":
            messages.append(text)
        else:
            warnings.warn(text, stacklevel=4)
    hear.CallDataType = "string0"
    return hear


def _set(mesher, name, value):
    option = _OPTIONS.get(name)
    if option is None:
        raise TypeError(f"There is no option {name!r}. Options are {', '.join(OPTIONS)}.")
    if "port" in option:
        _set_input(mesher, name, option, value)
    elif name == "refined_boundaries":
        for boundary in [value] if isinstance(value, str) else value:
            mesher.SetRefinedBoundaryArrayStatus(boundary, 1)
    elif "resize" in option:
        _set_rows(mesher, name, option, value)
    else:
        _set_one(mesher, name, option, value)


def _set_input(mesher, name, option, value):
    for data in value if option["several"] and isinstance(value, (list, tuple)) else [value]:
        if not _is_data(data):
            raise TypeError(f"{name}: {data!r} is not a {option['kind']}")
        mesher.AddInputDataObject(option["port"], data)


def _set_one(mesher, name, option, value):
    choices = option.get("choices")
    if choices and value not in choices:
        raise ValueError(f"{name}: {value!r} is not one of {', '.join(map(repr, choices))}")
    try:
        getattr(mesher, option["set"])(choices[value] if choices else value)
    except TypeError as error:
        raise TypeError(f"{name}: {value!r}: {error}") from None


def _set_rows(mesher, name, option, rows):
    if not isinstance(rows, _SEQUENCES):
        raise TypeError(f"{name}: {rows!r} is not a sequence of rows")
    getattr(mesher, option["resize"])(len(rows))
    for i, row in enumerate(rows):
        try:
            getattr(mesher, option["set"])(i, *(row if isinstance(row, _SEQUENCES) else (row,)))
        except TypeError:
            raise TypeError(f"{name}: row {i}, {row!r}, does not have the right number and types of values. "
                            f"They must be those of vtkCartesianMesher.{option['set']}, after the row's number.") from None


def _is_data(value):
    return hasattr(value, "IsA") and hasattr(value, "GetCellData")


def _surface(surface, faces):
    if faces is None:
        if not _is_data(surface):
            raise TypeError(f"The surface is a {type(surface).__name__}: give a vtkPolyData or, with faces, an "
                            "array of points.")
        return surface
    if _is_data(surface):
        raise TypeError(f"faces: they are for an array of points; a {type(surface).__name__} has its own")
    points = _array("points", surface, np.floating)
    triangles = _array("faces", faces, np.integer)
    if not np.isfinite(points).all():
        raise ValueError(f"points: point {int(np.argmin(np.isfinite(points).all(axis=1)))} is not finite")
    if triangles.size and not 0 <= triangles.min() <= triangles.max() < len(points):
        raise ValueError(f"faces: they refer to points {triangles.min()} to {triangles.max()}, but there are only {len(points)}")
    return _polydata(points.astype(np.float64), triangles.astype(np.int64))


def _array(what, array, kind):
    try:
        array = np.asarray(array)
    except ValueError:
        raise ValueError(f"{what}: rows differ in length: each must have three numbers") from None
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what}: the shape is {array.shape}, not (n, 3)")
    wanted = kind if kind is np.integer else np.number
    if not np.issubdtype(array.dtype, wanted) or np.issubdtype(array.dtype, np.complexfloating):
        raise TypeError(f"{what}: the type is {array.dtype}, not {'integers' if kind is np.integer else 'numbers'}")
    return array


def _polydata(points, triangles):
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(points, deep=True))
    polygons = vtkCellArray()
    polygons.SetData(
        numpy_to_vtkIdTypeArray(np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles).ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(coordinates)
    data.SetPolys(polygons)
    return data
