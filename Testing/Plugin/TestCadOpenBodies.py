"""Faces of a CAD file that form no solid enclose nothing: beside solids they are left out and named, never closed by lids. Of type
baffle they are sheets in the region around them. By themselves they are meshed as before.

pvpython TestCadOpenBodies.py REPOSITORY PROGRAM PRINT_OPTIONS FOLDER: FOLDER has the files of make-cad-parts."""

import pathlib
import sys

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from pipeline import Messages, error_code, output

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "Testing" / "Cad"))
from alltests import run  # noqa: E402

PARTS = pathlib.Path(sys.argv[4])
LEFT_OUT = "Open bodies enclose nothing, and are left out beside solids"


class Meshed:
    """Areas by boundary, volume, regions, and what the mesher said; lengths in millimetres times `scale`."""

    def __init__(self, surface, size, **properties):
        surface.UpdatePipeline()
        with Messages() as said:
            mesher = simple.CartesianMesher(Input=surface, CellSize=size, **properties)
            fields = output(mesher).GetFieldData()
        assert error_code(mesher) == 0, str(said)
        self.said = str(said)
        names, areas = fields.GetAbstractArray("BoundaryNames"), vtk_to_numpy(fields.GetArray("BoundaryAreas"))
        self.areas = {names.GetValue(i): area for i, area in enumerate(areas) if area > 0}
        self.volume = fields.GetArray("MeshVolume").GetValue(0)
        regions = fields.GetAbstractArray("RegionNames")
        self.regions = [regions.GetValue(i) for i in range(regions.GetNumberOfValues())] if regions else []


def cad(file, scale=1.0):
    return simple.CADReader(FileName=str(PARTS / file), LengthUnit="Millimetre", Scale=scale)


def assert_near(found, expected):
    assert abs(found / expected - 1) < 1e-5, (found, expected)


def test_left_out():
    for degrees in 0, 10, 30, 45:
        for scale in 1e-3, 1, 1e3:
            made = Meshed(cad(f"stray_tube_{degrees}.step", scale), 1.7 * scale)
            assert_near(made.volume, 20 * 12 * 10 * scale**3)
            assert_near(sum(made.areas.values()), 2 * (240 + 200 + 120) * scale**2)
            assert "tube" not in " ".join(made.areas), made.areas
            assert LEFT_OUT in made.said and "of boundary tube_1" in made.said, made.said


def test_regions():
    """What is left out is no region, nor are sheets."""
    made = Meshed(cad("partition.step"), 1.3, RegionsFrom="Blocks")
    assert made.regions == ["left", "right"], made.regions
    assert LEFT_OUT in made.said and "of boundary splitter" in made.said, made.said
    assert "splitter" not in made.areas, made.areas
    assert_near(made.volume, 2000)


def test_baffle():
    for properties in {}, {"RegionsFrom": "Blocks"}:
        made = Meshed(cad("partition.step"), 1.3, BoundaryNames=["splitter"], BoundaryTypes=["baffle"], **properties)
        assert not properties or made.regions == ["left", "right"], made.regions
        assert_near(made.volume, 2000)
        assert_near(made.areas["splitter"], 100)
        assert_near(made.areas["splitter_back"], 100)
        assert LEFT_OUT not in made.said, made.said


def test_by_itself():
    """A file of faces without solids: lids close them, as those of any surface."""
    tube = simple.ExtractBlock(Input=cad("stray_tube_0.step"), Selectors=["/Root/tube"])
    made = Meshed(tube, 0.9)
    assert_near(made.volume, 4 * 4 * 6)
    assert LEFT_OUT not in made.said, made.said


def test_known_after_split():
    split = simple.SplitSurface(Input=cad("stray_tube_10.step"))
    made = Meshed(split, 1.7)
    assert_near(made.volume, 20 * 12 * 10)
    assert LEFT_OUT in made.said, made.said


def test_size_of_domain():
    """Around bodies, the box is that of the solids."""
    made = Meshed(cad("stray_tube_30.step"), 12, Domain="Outside", RefinementDepth=1)
    assert "tube" not in " ".join(made.areas) and LEFT_OUT in made.said, made.said


if __name__ == "__main__":
    run(globals())
