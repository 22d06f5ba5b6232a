"""A slab of two regions, "left" and "right", side by side along x from 0 to 3."""

from paraview import simple
from vtkmodules.vtkCommonCore import vtkStringArray

from pipeline import output, producer

CONDUCTIVITY = {"left": 1.0, "right": 4.0}  # W/(m K)


def box(low, high, ends=("inlet cold", "hot")):
    """The boundary at x = 0 has the first name of the ends, at 3 the second, what is left is "side"."""
    surface = output(simple.Triangulate(Input=simple.Box(
        XLength=high[0] - low[0], YLength=high[1] - low[1], ZLength=high[2] - low[2],
        Center=[(a + b) / 2 for a, b in zip(low, high)])))
    names = vtkStringArray()
    names.SetName("Wall")
    for i in range(surface.GetNumberOfCells()):
        first, last = surface.GetCell(i).GetBounds()[:2]
        names.InsertNextValue(ends[0] if last == 0 else ends[1] if first == 3 else "side")
    surface.GetCellData().AddArray(names)
    return producer(surface)


def slab(size, method="Automatic"):
    both = simple.GroupDatasets(Input=[box([0, 0, 0], [1, 1, 1]), box([1, 0, 0], [3, 1, 1])],
                                BlockNames=list(CONDUCTIVITY))
    return simple.CartesianMesher(Input=both, RegionsFrom="Blocks", BoundaryArray="Wall", CellSize=size,
                                  PatchMethod=method)
