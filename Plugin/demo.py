"""pvpython demo.py SURFACE CELL_SIZE: what ./demo.sh runs; see there."""

import pathlib
import sys

import numpy
from paraview.servermanager import Fetch
from paraview.simple import *
from vtkmodules.util.numpy_support import vtk_to_numpy

READERS = {
    ".stl": lambda name: STLReader(FileNames=[name]),
    ".obj": lambda name: WavefrontOBJReader(FileName=name),
    ".ply": lambda name: PLYReader(FileNames=[name]),
    ".vtp": lambda name: XMLPolyDataReader(FileName=[name]),
    **dict.fromkeys([".step", ".stp", ".iges", ".igs", ".brep"], lambda name: CADReader(FileName=name)),
}


def read(path):
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        sys.exit(f"{path} is none of {', '.join(READERS)}.")
    if not path.is_file():
        sys.exit(f"There is no file {path}.")
    return reader(str(path))


def print_statistics(mesh):
    arrays = mesh.GetFieldData()
    for i in range(arrays.GetNumberOfArrays()):
        array = arrays.GetAbstractArray(i)
        if array.GetNumberOfValues() == 1:
            print(f"{array.GetName():32} {array.GetVariantValue(0).ToString()}")


def largest_layer(mesh, axis):
    """The layer of boxes across `axis` with most cells, and the coordinate of its upper side."""
    layers = vtk_to_numpy(mesh.GetCellData().GetArray("GlobalBox"))[:, axis]
    layer = int(numpy.bincount(layers).argmax())
    tops = [mesh.GetCell(cell).GetBounds()[2 * axis + 1]
        for cell in numpy.flatnonzero(layers == layer)]
    return layer, float(numpy.median(tops))


def draw(mesher, mesh, picture):
    """The layers of boxes up to the largest one across the shortest side, seen at an angle."""
    bounds = mesh.GetBounds()
    low, high = bounds[0::2], bounds[1::2]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    sizes = [b - a for a, b in zip(low, high)]
    across, up, _ = sorted(range(3), key=lambda axis: sizes[axis])
    layer, middle[across] = largest_layer(mesh, across)
    away = [1.0 if axis == across else 0.3 for axis in range(3)]

    view = CreateView("RenderView")
    view.ViewSize = [1400, 1000]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]

    def show(ports, cell):
        of_cell = PythonCalculator(Input=[OutputPort(mesher, port) for port in ports],
            Expression=f"inputs[-1].CellData['GlobalBox'][{cell}, {across}]",
            ArrayName="Layer", ArrayAssociation="Cell Data")
        half = Threshold(Input=of_cell, Scalars=["CELLS", "Layer"], ThresholdMethod="Between",
                         LowerThreshold=0, UpperThreshold=layer)
        display = Show(half, view)
        display.Representation = "Surface With Edges"
        display.EdgeColor = [0.3, 0.3, 0.3]
        display.Ambient = 0.25
        return display

    cells = show(["Mesh"], ":")
    cells.ColorArrayName = ["CELLS", ""]
    cells.AmbientColor = cells.DiffuseColor = [1.0, 0.97, 0.88]
    # Each face of the boundary is shown with its cell.
    boundary = show(["Boundary", "Mesh"], "inputs[1].CellData['CellId'].argsort()[inputs[0].CellData['OwnerCell']]")
    ColorBy(boundary, ("CELLS", "BoundaryId"))
    first, last = (int(n) for n in boundary.Input.CellData["BoundaryId"].GetRange())
    colours = GetColorTransferFunction("BoundaryId")
    colours.InterpretValuesAsCategories = 1
    colours.ApplyPreset("Brewer Qualitative Set3", True)
    colours.Annotations = [str(n) for n in range(first, last + 1) for _ in "ab"]
    boundary.SetScalarBarVisibility(view, False)
    # The boundary's faces are faces of the mesh too: a hair nearer, they win.
    translation = "Translation" if "Translation" in boundary.ListProperties() else "Position"  # ParaView 5.11
    setattr(boundary, translation, [1e-3 * max(sizes) * a for a in away])

    view.CameraFocalPoint = middle
    view.CameraPosition = [m + max(sizes) * a for m, a in zip(middle, away)]
    view.CameraViewUp = [float(axis == up) for axis in range(3)]
    ResetCamera(view)
    GetActiveCamera().Zoom(1.25)
    SaveScreenshot(picture, view)


surface = pathlib.Path(sys.argv[1])
mesher = CartesianMesher(Input=read(surface), CellSize=float(sys.argv[2]))
mesher.UpdatePipeline()
mesh = Fetch(OutputPort(mesher, "Mesh"))
if mesh.GetNumberOfCells() == 0:
    sys.exit("There is no mesh; the messages above say why.")
print_statistics(mesh)

files = [surface.stem + suffix for suffix in (".vtu", ".png")]
# ParaView 5.11 on Debian 12 can't read back the default, appended data.
SaveData(files[0], proxy=OutputPort(mesher, "Mesh"), DataMode="Binary")
draw(mesher, mesh, files[1])
for name in files:
    print("wrote", pathlib.Path(name).absolute())
