"""What the mesher tells of a mesh is what OpenFOAM's checkMesh finds in the case written of it, region by region, in
random scenes (scenes.py); and no cell has fewer than four faces. With a first number and a count: those scenes, to be
looked for more."""

import pathlib
import re
import sys
import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import foam
import scenes
from pipeline import Messages, error_code, output, producer

# Ours and how checkMesh words it.
# Layers that are longer than that are told apart, as they do no harm.
ALSO = {"LongCells": "LongLayers"}
COUNTS = {
    "SkewFaces": r", (\d+) highly skew faces",
    "InvertedFaces": r"Error in face pyramids: (\d+) faces",
    "NonOrthogonalFaces": r"non-orthogonality errors: (\d+)",
    "SteepFaces": r"severely non-orthogonal \(> 70 degrees\) faces: (\d+)",
    "OpenCells": r"Open cells found, max cell openness: \S+ number of open cells (\d+)",
    "CellsWithoutVolume": r"Number of negative volume cells: (\d+)",
    "LongCells": r"High aspect ratio cells found, Max aspect ratio: \S+ number of cells (\d+)",
    "CellsOfFewFaces": r"Illegal cells .*number of cells: (\d+)",
}
CLOSE = 1e-6  # to a limit: a value counts on either side

# What is counted beyond which limit: on faces (output 1 of Finite Volume Quality) or in cells (0).
LIMITS = {
    "SkewFaces": (1, "Skewness", 4),
    "NonOrthogonalFaces": (1, "NonOrthogonality", 90),
    "SteepFaces": (1, "NonOrthogonality", 70),
    "OpenCells": (0, "Openness", 1e-6),
    "LongCells": (0, "AspectRatio", 1000),
}


def field(data, name):
    array = data.GetFieldData().GetArray(name)
    return None if array is None else [int(array.GetValue(i)) for i in range(array.GetNumberOfValues())]


def is_close(mesh, index, name):
    """Whether a value that a region's count depends on is at its limit."""
    if name not in LIMITS:
        return False
    port, measure, limit = LIMITS[name]
    part = simple.Threshold(Input=producer(mesh), Scalars=["CELLS", "Region"], ThresholdMethod="Between",
                            LowerThreshold=index + 1, UpperThreshold=index + 1)
    values = vtk_to_numpy(output(simple.FiniteVolumeQuality(Input=part), port).GetCellData().GetArray(measure))
    return bool(np.any(np.abs(values / limit - 1) < CLOSE))


def regions_of(folder):
    """Folders of meshes in a case."""
    constant = pathlib.Path(folder) / "constant"
    return sorted(path.parent.name for path in constant.glob("*/polyMesh")) or [""]


def compare(mesh, warnings, folder):
    """What differs, in words."""
    faults = []
    names = mesh.GetFieldData().GetAbstractArray("RegionNames")
    fails = uncertain = 0
    for region in regions_of(folder):
        said = foam.CheckMesh(folder, *(["-region", region] if region else []))
        index = 0
        if region:
            index = [names.GetValue(n) for n in range(names.GetNumberOfValues())].index(region)
        for name, pattern in COUNTS.items():
            found = re.search(pattern, said.text)
            theirs = int(found[1]) if found else 0
            ours = sum(field(mesh, f"Region{of}" if region else of)[index] for of in (name, ALSO.get(name)) if of)
            if ours != theirs and is_close(mesh, index, name):
                uncertain += 1
            elif ours != theirs:
                faults.append(f"{region} {name} {ours}, checkMesh {theirs}")
        parts = re.search(r"Number of regions: (\d+)", said.text)
        theirs = int(parts[1]) if parts else 1
        ours = field(mesh, "RegionParts" if region else "Parts")[index]
        if ours != theirs:
            faults.append(f"{region} Parts {ours}, checkMesh {theirs}")
        only_long = [text for text in said.failures if "High aspect ratio" not in text] == [] and \
            not field(mesh, "RegionLongCells" if region else "LongCells")[index]
        fails += not said.ok and not only_long
        if "Illegal cells" in said.text:
            faults.append(f"{region} has cells of fewer than four faces")
        if not said.ok and not only_long and not uncertain and "checkMesh will fail" not in warnings:
            faults.append(f"{region} fails without a word: {said.failures}")
    if fails == 0 and not uncertain and "checkMesh will fail" in warnings:
        faults.append("said to fail, but is OK")
    return faults


def try_scene(number, **others):
    surface, properties = scenes.make(number)
    properties.update(others)
    with Messages() as said:
        mesher = simple.CartesianMesher(Input=producer(surface), **properties)
        mesh = output(mesher)
        defects = output(mesher, 2)
    what = f"scene {number}: {surface.GetNumberOfCells()} triangles {properties}"
    if error_code(mesher) != 0:
        return "refused", what, str(said).strip()[-300:]
    with tempfile.TemporaryDirectory() as folder:
        foam.save(simple.OutputPort(mesher, "Mesh"), folder)
        faults = compare(mesh, str(said), folder)
    failing = field(defects, "FailingCells") or [0]
    if ("checkMesh will fail" in str(said)) != (failing[0] > 0):
        faults.append(f"Defects has {failing[0]} cells")
    simple.Delete(mesher)
    return "differs" if faults else "agrees", what, "; ".join(faults)


def main():
    chosen = [int(text) for text in sys.argv[4:]]
    numbers = range(chosen[0], chosen[0] + chosen[1]) if chosen else [*range(0, 24), 145, 193]
    tries = [(number, {}) for number in numbers]
    if not chosen:  # as they are, cells of few faces come out
        tries += [(number, dict(SmallCells="Remove", SmallCellRatio=0.0, SplitConcaveCells=0)) for number in (24, 36, 56)]
    results = []
    for number, others in tries:
        result, what, why = try_scene(number, **others)
        results.append(result)
        if result != "agrees":
            print(result, what, why, flush=True)
    counts = {result: results.count(result) for result in sorted(set(results))}
    print(counts)
    assert "differs" not in counts and 2 * counts.get("refused", 0) <= len(results), counts


main()
