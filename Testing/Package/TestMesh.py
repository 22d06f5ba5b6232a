"""cartesianmesher.mesh: of polydata and of arrays alike, with options, and exceptions for what is wrong."""

import pathlib
import re
import sys
import warnings

import cartesianmesher
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLReader

REPOSITORY = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(REPOSITORY / "Plugin" / "Properties"))
from reference import every, proxies  # noqa: E402

# What the panel lets one set, but for the surface, and what only ranks need.
PROPERTIES = [property for property in every(proxies()["filters.CartesianMesher"])
    if not property.is_hidden and not property.is_information and property.name not in ("Input", "InPieces", "Preview")]


class Wrapped(vtkPolyData):
    """What PyVista's meshes are: a class of their own that is a vtkPolyData."""


def triangulated(source):
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def header():
    reader = vtkSTLReader()
    reader.SetFileName(str(REPOSITORY / "Data" / "kcl_exhaust_header_lumens.stl"))
    return reader


def arrays_of(surface):
    return (vtk_to_numpy(surface.GetPoints().GetData()),
        vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def contents(mesh):
    return [vtk_to_numpy(array).tobytes() for array in (mesh.GetPoints().GetData(),
        mesh.GetCells().GetConnectivityArray(), mesh.GetCellData().GetArray("VolumeFraction"))]


def assert_raises(kind, text, *arguments, **options):
    try:
        cartesianmesher.mesh(*arguments, **options)
    except kind as error:
        assert type(error) is kind and text in str(error), repr(error)
        return
    raise AssertionError(f"no {kind.__name__}: {text}")


def assert_alike(surface, cell_size):
    """A class of its own, and arrays in single and double precision, give the same mesh."""
    mesh = cartesianmesher.mesh(surface, cell_size=cell_size)
    assert mesh.IsA("vtkUnstructuredGrid") and mesh.GetNumberOfCells() > 100
    wrapped = Wrapped()
    wrapped.ShallowCopy(surface)
    points, faces = arrays_of(surface)
    for arguments in ((wrapped,), (points, faces), (points.astype(float), faces.astype(np.int32)),
            (points.tolist(), faces.tolist())):
        assert contents(cartesianmesher.mesh(*arguments, cell_size=cell_size)) == contents(mesh), arguments


def words(text):
    return " ".join(text.replace("**", "").split())


def assert_help():
    """What can be set in the panel is an option; its help has a line of facts, then all that the panel says."""
    for property in PROPERTIES:
        name = re.sub(r" ?([A-Z])", r"_\1", property.label).lower().lstrip("_")
        assert name in cartesianmesher.OPTIONS, f"{property.label} is no option"
        entry = re.search(rf"^    {name}: \w.*?(?=\n\n)", cartesianmesher.mesh.__doc__, re.M | re.S)
        assert entry, f"{name} is not in the help"
        text = words(entry[0])
        assert ". Default: " in text, f"the help does not say the default of {name}"
        assert property.is_input or re.search(r"\. (Range|Choices): ", text), f"the help does not say what {name} may be"
        assert text.endswith(words(property.documentation())), f"the help does not say what {name} is"
    assert len(cartesianmesher.OPTIONS) == len(PROPERTIES), "there are options that are not in the panel"
    widest = max(map(len, cartesianmesher.mesh.__doc__.splitlines()))
    assert widest <= 101 and "**" not in cartesianmesher.mesh.__doc__, widest


def assert_defaults():
    """The panel and the help have those of the filter."""
    mesher = cartesianmesher.vtkCartesianMesher()
    for property in PROPERTIES:
        if property.is_input or property.has_rows:
            continue
        value = getattr(mesher, property.element.get("command").replace("Set", "Get", 1))()
        value = list(value) if isinstance(value, tuple) else value
        expected = property.default()
        expected = property.choices().get(expected) if property.choices() else expected
        assert value == expected or value == "" and expected == "Automatic", f"{property.name}: {value}, not {expected}"


warnings.simplefilter("ignore")
ball = vtkSphereSource()
ball.SetThetaResolution(30)
ball.SetPhiResolution(30)
ball.Update()
stl = header()
assert_alike(ball.GetOutput(), 0.1)
assert_alike(triangulated(vtkCubeSource()), 0.15)
assert_alike(triangulated(stl), 15)

# Options change the mesh as the filter's setters do.
points, faces = arrays_of(ball.GetOutput())
coarse = cartesianmesher.mesh(points, faces, cell_size=0.2)
for options in ({"refinement_depth": 1}, {"patch_method": "exact fit"}, {"small_cells": "remove"},
        {"meshlines_x": [-0.6, 0, 0.1, 0.6]}, {"refinement_blocks": [(0, 1, 0, 1, 0, 1, 2, 1)]},
        {"refinement_regions": ball.GetOutput()}, {"boundary_refinement": [(0, 1, 0, 0)]}):
    assert contents(cartesianmesher.mesh(points, faces, cell_size=0.2, **options)) != contents(coarse), options

# Of several lists, which say one thing together.
for options in ({"refinement_shapes": ["sphere"], "refinement_positions": [(0, 0, 0)], "refinement_lengths": [(0.4, 0.4, 0.4)],
        "refinement_shape_depths": [1]}, {"boundary_names": ["*"], "boundary_depths": [1]},
        {"layers": 2, "boundary_names": ["*"], "boundary_layers_thickness": [0.01]}):
    assert contents(cartesianmesher.mesh(points, faces, cell_size=0.2, **options)) != contents(coarse), options
renamed = cartesianmesher.mesh(points, faces, cell_size=0.2, boundary_names=["boundary_0"], boundary_merged_names=["ball"])
assert renamed.GetFieldData().GetAbstractArray("BoundaryNames").GetValue(0) == "ball"
refined = cartesianmesher.mesh(points, faces, cell_size=0.2, refined_boundaries="boundary_0", refined_boundary_depth=1)
assert contents(refined) == contents(cartesianmesher.mesh(points, faces, cell_size=0.2, boundary_names=["*"], boundary_depths=[1]))

assert_help()
assert_defaults()

assert_raises(TypeError, "no option 'cellsize'", points, faces, cellsize=1)
assert_raises(TypeError, "cell_size", points, faces, cell_size="large")
assert_raises(ValueError, "'round' is not one of", points, faces, patch_method="round")
assert_raises(TypeError, "refinement_blocks: row 1", points, faces, refinement_blocks=[(0, 1, 0, 1, 0, 1, 2, 1), (0, 1)])
assert_raises(TypeError, "meshlines_x", points, faces, meshlines_x=3)
assert_raises(TypeError, "boundary_names: 'inlet'", points, faces, boundary_names="inlet")
assert_raises(TypeError, "refinement_regions: None", points, faces, refinement_regions=[None])
assert_raises(TypeError, "has its own", ball.GetOutput(), faces)
assert_raises(ValueError, "differ in length", [[0, 0, 0], [1, 1]], faces)
assert_raises(TypeError, "ndarray", points)
assert_raises(TypeError, "NoneType", None)
assert_raises(ValueError, "(900,)", points[:300].ravel(), faces)
assert_raises(ValueError, "not (n, 3)", points, np.zeros((5, 4), int))
assert_raises(TypeError, "not integers", points, faces.astype(float))
assert_raises(TypeError, "not numbers", points.astype(str), faces)
assert_raises(TypeError, "not numbers", points.astype(complex), faces)
assert_raises(ValueError, "there are", points, faces + 10)
assert_raises(ValueError, "there are", points, faces - 1)
broken = points.copy()
broken[7, 1] = np.nan
assert_raises(ValueError, "point 7", broken, faces)
assert_raises(cartesianmesher.EmptySurface, "", points, faces[:0])
assert_raises(cartesianmesher.BadCellSize, "", points, faces, cell_size=-1)
assert_raises(cartesianmesher.BadParameter, "", points, faces, refinement_depth=70)
assert_raises(cartesianmesher.TooManyBoxes, "", points, faces, cell_size=1e-3, memory_limit=1e-6)
assert_raises(cartesianmesher.MissingArray, "nothing", points, faces, boundary_array="nothing")
assert issubclass(cartesianmesher.BadCellSize, cartesianmesher.Error)
