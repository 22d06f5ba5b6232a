"""Boundaries whose names begin with symmetry are symmetries: told once, of a type that OpenFOAM takes, without layers."""

import pathlib
import tempfile

from paraview import simple
from vtkmodules.vtkCommonCore import vtkStringArray

import foam
import scenes
from pipeline import Messages, error_code, polydata, producer

NAMES = ["symmetry_x", "outlet", "wall", "top", "Symmetry Z", "inlet"]
WORDS = [name.replace(" ", "_") for name in NAMES]


def box(low=-0.5, rise=0):
    """A box with a boundary for each side; of that of low x one corner is moved inwards."""
    corners, triangles = scenes.box([low] * 3, [0.5] * 3)
    corners[0][0] += rise
    data = polydata(corners, triangles)
    names = vtkStringArray()
    names.SetName("Name")
    for i in range(len(triangles)):
        names.InsertNextValue(NAMES[i // 2])
    data.GetCellData().AddArray(names)
    return producer(data)


def mesher(surface, **options):
    return simple.CartesianMesher(Input=surface, BoundaryArray="Name", CellSize=0.13, **options)


def types(folder):
    return {name: row[0] for name, row in foam.Files(folder).patches.items()}


def expect(made, folder, symmetries, told, **options):
    with Messages() as said:
        foam.save(made, folder, **options)
    assert error_code(made) == 0
    assert str(said).count("these boundaries are symmetries, which have no layers: " + told) == (1 if told else 0), said
    assert told or "symmetries" not in str(said), said
    expected = {"wall": "wall", "top": "wall", "outlet": "patch", "inlet": "patch", **symmetries}
    assert types(folder) == expected, types(folder)
    assert foam.CheckMesh(folder).ok


with tempfile.TemporaryDirectory() as temporary:
    folder = pathlib.Path(temporary)
    both = "symmetry_x, Symmetry Z."
    expect(mesher(box()), folder / "flat", {"symmetry_x": "symmetryPlane", "Symmetry_Z": "symmetryPlane"}, both)
    # Turned, points lie on the lattice, not in the plane.
    turned = simple.Transform(Input=box())
    turned.Transform.Rotate = [20, 30, 40]
    expect(mesher(turned), folder / "turned", {"symmetry_x": "symmetry", "Symmetry_Z": "symmetry"}, both)
    expect(mesher(box(rise=0.05)), folder / "bent", {"symmetry_x": "symmetry", "Symmetry_Z": "symmetryPlane"}, both)
    # Who gives a type is told nothing of that boundary, and an edited case keeps its types.
    typed = {"BoundaryNames": ["symmetry_x", "Sym*"], "BoundaryTypes": ["symmetryPlane", "wall"]}
    expect(mesher(box(), **typed), folder / "typed", {"symmetry_x": "symmetryPlane", "Symmetry_Z": "wall"}, "")
    expect(mesher(box(low=-0.7)), folder / "typed", {"symmetry_x": "symmetryPlane", "Symmetry_Z": "wall"}, both)
    # With layers on the walls alone, and a solver on it.
    layered = mesher(box(), Layers=2)
    expect(layered, folder / "layers", {"symmetry_x": "symmetryPlane", "Symmetry_Z": "symmetryPlane"}, both,
        SolverSetup="Incompressible", Iterations=5)
    coverage = layered.SMProxy.GetClientSideObject().GetOutputDataObject(0).GetFieldData().GetArray("BoundaryLayerCoverages")
    assert [coverage.GetValue(i) > 0 for i in range(6)] == [False, False, True, True, False, False]
    foam.run(folder / "layers", "./Allrun")
    # In pieces, none of which knows all of a patch, and in Fluent's files.
    with Messages():
        foam.save(mesher(box()), folder / "pieces", Pieces=2)
        simple.SaveData(str(folder / "box.msh"), mesher(box()))
    for piece in 0, 1:
        text = (folder / "pieces" / f"processor{piece}" / "constant" / "polyMesh" / "boundary").read_text()
        assert text.count("symmetry;") == 2, text
    assert "symmetry symmetry_x)" in (folder / "box.msh").read_text()
