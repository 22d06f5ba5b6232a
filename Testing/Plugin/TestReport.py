"""Quality Histogram and the report of a mesh: numbers of cells add up, limits are those of Finite Volume Quality, failing cells
are those that fail; the HTML is well formed, needs no other file and no screen, and has each boundary with its area, the
pictures, histograms, settings and warnings; it is the same on any number of threads and by a task."""

import base64
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
from xml.etree import ElementTree

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkIOImage import vtkPNGReader

from pipeline import DATA, Messages, error_code, octahedron, output, polydata, producer

os.environ.pop("DISPLAY", None)
PROGRAM = sys.argv[2]
EXHAUST = DATA / "kcl_exhaust_header_lumens.stl"
folder = pathlib.Path(tempfile.mkdtemp())
mesher = simple.CartesianMesher(Input=simple.OpenDataFile(str(EXHAUST)), CellSize=15, Layers=2)
mesh = output(mesher)
quality = simple.FiniteVolumeQuality(Input=mesher)
measured = output(quality)


def values(name):
    return vtk_to_numpy(measured.GetCellData().GetArray(name))


# Numbers of cells add up, and are those that NumPy counts.
histogram = simple.QualityHistogram(Input=mesher, Bins=13)
assert histogram.Measure == "Skewness"
LIMITS = {"Skewness": 4, "Non Orthogonality": 70, "Face Weight": 0.05, "Aspect Ratio": 1000, "Volume Fraction": None, "Concavity": None}
for measure, limit in LIMITS.items():
    histogram.Measure = measure
    drawn, bins = output(histogram), output(histogram, 1)
    column = {bins.GetColumnName(i): vtk_to_numpy(bins.GetColumn(i)) for i in range(3)}
    own = values(measure.replace(" ", ""))
    expected, edges = np.histogram(own, bins=13, range=(own.min(), own.max()))
    assert column["Cells"].sum() == mesh.GetNumberOfCells() and np.allclose(column["Low"], edges[:-1]), measure
    assert np.abs(np.cumsum(column["Cells"]) - np.cumsum(expected)).max() <= 1, (measure, column["Cells"], expected)
    assert drawn.GetColumnName(0) == measure and drawn.GetColumnName(1) == "Cells"
    outline = vtk_to_numpy(drawn.GetColumn(1))[1:1 + 26].reshape(13, 2)
    assert (outline == np.maximum(column["Cells"], 0.5)[:, None]).all(), measure
    if limit is None:
        assert drawn.GetNumberOfColumns() == 2 and not drawn.GetFieldData().GetArray("Limit"), measure
    else:
        assert drawn.GetColumnName(2) in (f"limit: at most {limit}", f"limit: at least {limit}"), drawn.GetColumnName(2)
        line = ~np.isnan(vtk_to_numpy(drawn.GetColumn(2)))
        assert line.sum() == 2 and (vtk_to_numpy(drawn.GetColumn(0))[line] == limit).all(), measure
        assert drawn.GetFieldData().GetArray("Limit").GetValue(0) == limit

# Heights of first layers: most are as thick as all their wall has it.
histogram.Measure = "First Layer Height"
bins = output(histogram, 1)
layer = vtk_to_numpy(mesh.GetCellData().GetArray("Layer"))
assert vtk_to_numpy(bins.GetColumnByName("Cells")).sum() == (layer == 1).sum() > 100
boundary = output(mesher, 1)
total = vtk_to_numpy(boundary.GetCellData().GetArray("LayerThickness"))
first = np.median(total[total > 0]) / (1 + 1.2)
top = int(np.argmax(vtk_to_numpy(bins.GetColumnByName("Cells"))))
assert 0.85 * first < bins.GetColumnByName("High").GetValue(top) and bins.GetColumnByName("Low").GetValue(top) < 1.15 * first
plain = simple.QualityHistogram(Input=simple.Tetrahedralize(Input=simple.Wavelet(WholeExtent=[0, 2, 0, 2, 0, 2])))
assert vtk_to_numpy(output(plain, 1).GetColumnByName("Cells")).sum() == output(plain.Input).GetNumberOfCells()
for measure, array in ("First Layer Height", "Layer"), ("Volume Fraction", "VolumeFraction"):
    plain.Measure = measure
    with Messages() as text:
        output(plain)
    assert error_code(plain) == 40006 and f"no array {array}:" in str(text), str(text)

# Failing cells are those that fail, but not by tetrahedra alone; what is worst is told.
TET_QUALITY = np.uint32(4096)
failures = vtk_to_numpy(measured.GetCellData().GetArray("Failures"))
assert (failures & TET_QUALITY).any()
failing = output(quality, 2)
assert failing.GetNumberOfCells() == (failures & ~TET_QUALITY > 0).sum()
limit = float(np.median(values("NonOrthogonality")))
quality.NonOrthogonalityLimit = limit
assert output(quality, 2).GetNumberOfCells() == ((failures & ~TET_QUALITY > 0) | (values("NonOrthogonality") >= limit)).sum()
quality.UpdatePropertyInformation()
assert quality.WorstMeasure == "NonOrthogonality", quality.WorstMeasure
summary = simple.MeshSummary(Input=mesher)
told = output(summary).GetColumnByName("Text").GetValue(0)
brief = output(summary).GetColumnByName("Brief").GetValue(0)
assert len(brief.splitlines()) <= 16 and told.startswith(brief[:brief.index("Worst values")]), brief
assert f"Skewness: {values('Skewness').max():.6g} of at most 4 at (" in told, told


def save(name, source=mesher, port=0):
    simple.SaveData(str(folder / name), proxy=simple.OutputPort(source, port))
    return (folder / name).read_text()


def parsed(page):
    return ElementTree.fromstring(page.removeprefix("<!DOCTYPE html>\n"))


def texts(root, tag):
    return ["".join(element.itertext()) for element in root.iter(tag)]


page = save("mesh.html")
root = parsed(page)
assert not re.search(r'(?:src|href)="(?!data:)', page) and "<script" not in page
names = mesh.GetFieldData().GetAbstractArray("BoundaryNames")
areas = mesh.GetFieldData().GetArray("BoundaryAreas")
counts = mesh.GetFieldData().GetArray("BoundaryFaceCounts")
rows = [["".join(cell.itertext()) for cell in row] for row in root.iter("tr")]
for i in range(names.GetNumberOfValues()):
    row = next(row for row in rows if row[0] == names.GetValue(i))
    assert row[2] == str(counts.GetValue(i)) and abs(float(row[3]) / areas.GetValue(i) - 1) < 1e-5, row
assert ["Cartesian Mesher", "Cell Size", "15"] in rows and ["Cartesian Mesher", "Layers", "2"] in rows, rows
assert ["Named STL Reader", "File", EXHAUST.name] in rows
assert not any(row[:2] == ["Cartesian Mesher", "Refinement Depth"] for row in rows)
skewness = next(row for row in rows if row[0] == "Skewness")
assert skewness[1] == f"{values('Skewness').max():.6g}" and skewness[2] == "at most 4", skewness
assert root.find("body/p").text == told.splitlines()[0]
pictures = [base64.b64decode(image.get("src").removeprefix("data:image/png;base64,")) for image in root.iter("img")]
assert len(pictures) == len(set(pictures)) == 3
for png in pictures:
    assert png[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", png[16:24]) == (940, 620)
drawings = list(root.iter("svg"))
assert [svg.get("aria-label") for svg in drawings] == ["Skewness", "Non Orthogonality", "Volume Fraction", "First Layer Height"]
for svg, total in zip(drawings, [mesh.GetNumberOfCells()] * 3 + [(layer == 1).sum()]):
    assert sum(int(title.text.rpartition(": ")[2]) for title in svg.iter("title")) == total
    limits = [line for line in svg.iter("line") if line.get("class") == "limit"]
    assert len(limits) == (svg.get("aria-label") in ("Skewness", "Non Orthogonality"))

# The same on one thread; and a report never changes what it is of.
mesher.NumberOfThreads = 1
assert save("one.html") == page

# Names are texts. A mesh that comes from elsewhere has a report too.
solid = simple.CartesianMesher(Input=producer(octahedron()), CellSize=0.4)
copy = output(solid).NewInstance()
copy.ShallowCopy(output(solid))
strange = vtkStringArray()
strange.SetName("BoundaryNames")
strange.InsertNextValue("<script>alert('a & b')</script>")
copy.GetFieldData().AddArray(strange)
other = save("strange.html", producer(copy))
assert "<script" not in other and "<script>alert('a & b')</script>" in texts(parsed(other), "td")
assert any("save the report from the output of Cartesian Mesher" in text for text in texts(parsed(other), "li"))
save("plain.html", plain.Input)
parsed((folder / "plain.html").read_text())

# Warnings are those of the mesher.
whole = octahedron()
holed = simple.CartesianMesher(Input=producer(polydata([whole.GetPoint(i) for i in range(6)],
    [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5)])), CellSize=0.2)
with Messages() as said:
    output(holed)
warned = texts(parsed(save("holed.html", holed)), "li")
warning = re.sub(r"\s+", " ", str(said).partition("): ")[2]).strip()
assert warning and any(re.sub(r"\s+", " ", text).strip()[:60] == warning[:60] for text in warned), (warning, warned)

# Without cells, or a place to write, there is an error.
with Messages() as said:
    simple.SaveData(str(folder / "none.html"), proxy=producer(copy.NewInstance()))
assert "There are no cells to report of" in str(said) and not (folder / "none.html").exists(), str(said)

# Around a body, the pictures show the body, not the sides of the domain.
around = simple.CartesianMesher(Input=producer(octahedron()), Domain="Outside", CellSize=0.4)
(folder / "body.png").write_bytes(base64.b64decode(re.search(r"base64,([^\"]*)", save("around.html", around))[1]))
reader = vtkPNGReader()
reader.SetFileName(str(folder / "body.png"))
reader.Update()
red, green, blue = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int).T
share = ((blue > red + 20) & (blue > green)).mean()  # of the first boundary's colour
assert share > 0.03, share

# By a task, on ranks too: the same file.
TASK = f"""
[surface]
file = "{EXHAUST}"
[grid]
cell_size = 15
[layers]
layers = 2
[output]
report = "out/task.html"
"""
(folder / "task.toml").write_text(TASK)
environment = {name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
for ranks in [], ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2"]:
    done = subprocess.run([*ranks, PROGRAM, "--quiet", str(folder / "task.toml")], env=environment, capture_output=True, text=True,
        timeout=200)
    assert done.returncode in (0, 3), done.stdout + done.stderr
    made = (folder / "out" / "task.html").read_text()
    pattern = r"base64,[^\"]*"
    if not ranks:
        assert made == page, "the task's report is another"
    else:
        # The pieces merged have their cells in another order: sums are rounded otherwise.
        different = [(a, b) for a, b in zip(texts(parsed(made), "tr"), texts(root, "tr")) if a != b and not a.startswith("Openness")]
        assert not different, different
    (folder / "out" / "task.html").unlink()
(folder / "task.toml").write_text(TASK.replace("task.html", "task.pdf"))
done = subprocess.run([PROGRAM, str(folder / "task.toml")], env=environment, capture_output=True, text=True, timeout=100)
assert done.returncode == 2 and "output.report" in done.stderr and "must end in .html" in done.stderr, done.stderr
