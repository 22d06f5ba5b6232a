"""What README.md's script does, with the plugin that ParaView found by itself."""

import sys

from paraview import simple
from paraview.simple import CartesianMesher

from vtkmodules.vtkCommonCore import vtkVersion

mesher = CartesianMesher(Input=simple.OpenDataFile(sys.argv[1]), CellSize=10)
mesher.UpdatePipeline()
assert mesher.SMProxy.GetClientSideObject().GetErrorCode() == 0
cells = simple.OutputPort(mesher, "Mesh").GetDataInformation().GetNumberOfCells()
assert cells > 1000, cells
print(f"ParaView {simple.GetParaViewSourceVersion().split()[-1]}, VTK {vtkVersion.GetVTKVersion()}, "
    f"Python {sys.version.split()[0]}, {cells} cells")
