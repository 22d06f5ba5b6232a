"""pvpython demo.py SURFACE CELL_SIZE: what ./demo.sh runs; see there."""

import pathlib
import sys

from paraview.simple import *
from paraview.servermanager import Fetch

READERS = {
    ".stl": lambda name: STLReader(FileNames=[name]),
    ".obj": lambda name: WavefrontOBJReader(FileName=name),
    ".ply": lambda name: PLYReader(FileNames=[name]),
    ".vtp": lambda name: XMLPolyDataReader(FileName=[name]),
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
        values = [array.GetVariantValue(j).ToString() for j in range(array.GetNumberOfValues())]
        print(f"{array.GetName():32} {' '.join(values)}")


def draw(mesher, picture):
    """The half behind the middle of the shortest side, whole cells only, seen at an angle."""
    bounds = OutputPort(mesher, "Mesh").GetDataInformation().GetBounds()
    low, high = bounds[0::2], bounds[1::2]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    sizes = [b - a for a, b in zip(low, high)]
    across, up, _ = sorted(range(3), key=lambda axis: sizes[axis])
    normal = [float(axis == across) for axis in range(3)]
    away = [1.0 if axis == across else 0.35 for axis in range(3)]

    view = CreateView("RenderView")
    view.ViewSize = [1600, 1000]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]

    def show(port):
        half = Clip(Input=OutputPort(mesher, port), ClipType="Plane", Crinkleclip=1, Invert=1)
        half.ClipType.Origin = middle
        half.ClipType.Normal = normal
        display = Show(half, view)
        display.Representation = "Surface With Edges"
        display.EdgeColor = [0.25, 0.25, 0.25]
        display.Ambient = 0.2
        return display

    mesh = show("Mesh")
    mesh.ColorArrayName = ["CELLS", ""]
    mesh.AmbientColor = mesh.DiffuseColor = [1.0, 0.97, 0.88]
    boundary = show("Boundary")
    ColorBy(boundary, ("CELLS", "BoundaryId"))
    first, last = boundary.Input.CellData["BoundaryId"].GetRange()
    colours = GetColorTransferFunction("BoundaryId")
    colours.ApplyPreset("Rainbow Uniform", True)
    colours.RescaleTransferFunction(first - 0.5, last + 0.5)
    boundary.SetScalarBarVisibility(view, False)
    # The boundary's faces are faces of the mesh too: a hair nearer, they win.
    boundary.Position = [1e-3 * max(sizes) * a for a in away]

    view.CameraFocalPoint = middle
    view.CameraPosition = [m + max(sizes) * a for m, a in zip(middle, away)]
    view.CameraViewUp = [float(axis == up) for axis in range(3)]
    ResetCamera(view)
    GetActiveCamera().Zoom(1.2)
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
draw(mesher, files[1])
for name in files:
    print("wrote", pathlib.Path(name).absolute())
