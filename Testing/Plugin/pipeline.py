"""What the tests' scripts share: data in and out of proxies, and the messages on the way."""

import pathlib
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkPoints, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter

from polyhedra import cell_arrays, face_arrays, type_array

DATA = pathlib.Path(sys.argv[1]) / "Data"

READERS = {
    ".stl": lambda path: simple.STLReader(FileNames=[path]),
    ".obj": lambda path: simple.WavefrontOBJReader(FileName=path),
}


def read(name):
    path = DATA / name
    return READERS[path.suffix](str(path))


def output(proxy, port=0):
    """What a proxy made, itself: paraview.servermanager.Fetch makes a copy, and of port 0 only."""
    proxy.UpdatePipeline()
    return proxy.SMProxy.GetClientSideObject().GetOutputDataObject(port)


def redistributes(folder):
    """Whether ParaView's Redistribute DataSet keeps all cells: it sends them as appended XML, of which ParaView 5.11 reads
    a part only since a security fix of libexpat (2.5.0-1+deb12u2), of any data. Tried on hexahedra in this folder. VTK 9.6's
    filter aborts: a point of these meshes is outside of all its blocks."""
    if simple.GetParaViewVersion() >= 6:
        print("Redistribute DataSet aborts on this system: nothing is redistributed")
        return False
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(f"{folder}/appended.vtu")
    writer.SetInputDataObject(output(simple.AppendDatasets(Input=simple.Wavelet())))
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    assert writer.Write()
    with Messages():
        cells = output(simple.XMLUnstructuredGridReader(FileName=[writer.GetFileName()])).GetNumberOfCells()
    if cells == 0:
        print("ParaView reads no appended XML on this system: nothing is redistributed")
    return cells > 0


def error_code(proxy):
    return proxy.SMProxy.GetClientSideObject().GetErrorCode()


def producer(data):
    """A source of data made in Python."""
    source = simple.TrivialProducer()
    source.SMProxy.GetClientSideObject().SetOutput(data)
    return source


def polydata(points, polygons):
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.array(points, float), deep=True))
    cells = vtkCellArray()
    for polygon in polygons:
        cells.InsertNextCell(len(polygon), polygon)
    data = vtkPolyData()
    data.SetPoints(vtk_points)
    data.SetPolys(cells)
    return data


def octahedron(scale=1.0, centre=(0, 0, 0)):
    points = np.concatenate([np.eye(3), -np.eye(3)]) * scale + centre
    return polydata(points, [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2),
                             (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)])


def merged(*datas, turned=()):
    """Several surfaces in one; those whose number is in `turned` inside out."""
    points, polygons, count = [], [], 0
    for number, data in enumerate(datas):
        step = -1 if number in turned else 1
        for i in range(data.GetNumberOfCells()):
            ids = data.GetCell(i).GetPointIds()
            polygons.append([count + ids.GetId(j) for j in range(ids.GetNumberOfIds())][::step])
        points += [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]
        count += data.GetNumberOfPoints()
    return polydata(points, polygons)


class Messages:
    """with Messages() as text: ... ; then str(text) is all that VTK said."""

    def __enter__(self):
        self.before = vtkOutputWindow.GetInstance()
        self.window = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(self.window)
        return self

    def __exit__(self, *_):
        vtkOutputWindow.SetInstance(self.before)

    def __str__(self):
        return self.window.GetOutput()


def arrays(data):
    """Everything in a data object: names and arrays."""
    all = {"points": data.GetPoints() and data.GetPoints().GetData()}
    is_grid = data.IsA("vtkUnstructuredGrid")
    cells = {"cells": data.GetCells()} if is_grid else {
        "verts": data.GetVerts(), "lines": data.GetLines(),
        "polygons": data.GetPolys(), "strips": data.GetStrips()}
    for name, value in cells.items():
        all[name + ", offsets"], all[name] = cell_arrays(value)
    if is_grid:
        all |= dict(zip(("types", "faces", "face locations"), (type_array(data), *face_arrays(data))))
    for where in "PointData", "CellData", "FieldData":
        attributes = getattr(data, "Get" + where)()
        for i in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(i)
            all[f"{where}, {array.GetName()}"] = array
    return all


def contents(array):
    if array.IsA("vtkStringArray"):
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    return vtk_to_numpy(array).tobytes()


def assert_identical(what, left, right):
    """Bit for bit, all arrays in the same order."""
    left, right = arrays(left), arrays(right)
    assert list(left) == list(right), f"{what}: {list(left)} and {list(right)}"
    for name, array in left.items():
        other = right[name]
        if array is None or other is None:
            assert array is other, f"{what}: only one has {name}"
            continue
        assert array.GetDataType() == other.GetDataType(), f"{what}: types of {name} differ"
        same = contents(array) == contents(other)
        assert same and array.GetNumberOfComponents() == other.GetNumberOfComponents(), \
            f"{what}: {name} differ"
