"""Pictures against those in Testing/Baseline."""

import pathlib
import sys

from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader

BASELINE = pathlib.Path(sys.argv[1]) / "Testing" / "Baseline"


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def difference(left, right):
    """VTK's thresholded error of two files: about as many pixels of another colour; 1000 or more where
    the sizes differ."""
    compare = vtkImageDifference()
    compare.SetInputData(pixels(left))
    compare.SetImageData(pixels(right))
    compare.Update()
    return compare.GetThresholdedError()
