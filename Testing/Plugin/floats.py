"""Surfaces that are the same in all versions of VTK."""

from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints


def in_floats(source):
    """What was read, its points in single precision: from VTK 9.3 on, the reader of OBJ has them in double."""
    source.UpdatePipeline()
    surface = source.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    points = vtkPoints()
    points.SetDataTypeToFloat()
    points.DeepCopy(surface.GetPoints())
    surface.SetPoints(points)
    rounded = simple.TrivialProducer()
    rounded.SMProxy.GetClientSideObject().SetOutput(surface)
    return rounded
