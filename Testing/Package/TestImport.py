"""The installed Python package, without ParaView's proxies: VTK's own classes and pipelines."""

import math
import sys

from cartesianmesher.vtkCartesianMesherFilters import vtkCartesianMesher, vtkFiniteVolumeQuality
from vtkmodules.vtkFiltersSources import vtkSphereSource

assert "paraview" not in sys.modules

sphere = vtkSphereSource()
sphere.SetRadius(1)
sphere.SetThetaResolution(60)
sphere.SetPhiResolution(60)
mesher = vtkCartesianMesher()
mesher.SetInputConnection(sphere.GetOutputPort())
mesher.SetCellSize(0.1)
quality = vtkFiniteVolumeQuality()
quality.SetInputConnection(mesher.GetOutputPort())
quality.Update()

assert mesher.GetErrorCode() == 0
mesh = quality.GetOutputDataObject(0)
volume = mesh.GetFieldData().GetArray("TotalVolume").GetValue(0)
print(mesh.GetNumberOfCells(), "cells, volume", volume)
assert mesh.GetNumberOfCells() > 4000
assert math.isclose(volume, 4 / 3 * math.pi, rel_tol=0.02)
