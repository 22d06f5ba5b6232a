"""TestMessages.py FOLDER: what the CAD Reader says of files that are not as they should be, and what it does not say of those that
are; tessellated solids (AP242), which are triangles."""

import pathlib
import re
import shutil
import sys
import tempfile

import numpy as np
from cartesianmesher.vtkCartesianMesherFilters import vtkCartesianMesher
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow

from cadfiles import Content, run

FOLDER = pathlib.Path(sys.argv[1])
SCRATCH = pathlib.Path(tempfile.mkdtemp())

HEAD = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('');
#3=PRODUCT_CONTEXT('',#1,'mechanical');
#4=PRODUCT('b\\X2\\00FC\\X0\\chse','','',(#3));
#5=PRODUCT_DEFINITION_FORMATION('','',#4);
#6=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#7=PRODUCT_DEFINITION('design','',#5,#6);
#8=PRODUCT_DEFINITION_SHAPE('','',#7);
"""
MILLIMETRES = "#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
METRES = "#10=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n"
INCHES = """#10=(CONVERSION_BASED_UNIT('INCH',#90)LENGTH_UNIT()NAMED_UNIT(#92));
#90=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#91);
#91=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#92=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);
"""
CONTEXT = "#14=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#10))REPRESENTATION_CONTEXT('',''));\n"
CORNERS = [(x, y, z) for z in (0, 3) for y in (0, 2) for x in (0, 1)]  # numbers 1 to 8
QUADS = (1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)  # seen from outside


def coordinates(number, points):
    rows = ",".join("({}.,{}.,{}.)".format(*point) for point in points)
    return f"#{number}=COORDINATES_LIST('',{len(points)},({rows}));\n"


def faces(kind):
    """Of a cuboid of 1 x 2 x 3: triangles, strips and fans, with their own numbers of points, or with their own points."""
    text = "" if kind == "own points" else coordinates(50, CORNERS)
    for i, quad in enumerate(QUADS):
        a, b, c, d = quad
        if kind == "triangles":
            text += f"#{100 + i}=TRIANGULATED_FACE('side {i}',#50,8,(),$,(),(({a},{b},{c}),({a},{c},{d})));\n"
        elif kind == "strips":
            text += f"#{100 + i}=COMPLEX_TRIANGULATED_FACE('side {i}',#50,8,(),$,(),(({a},{b},{d},{c})),());\n"
        elif kind == "fans":
            text += f"#{100 + i}=COMPLEX_TRIANGULATED_FACE('side {i}',#50,8,(),$,(),(),(({a},{b},{c},{d})));\n"
        elif kind == "numbers":
            text += f"#{100 + i}=COMPLEX_TRIANGULATED_FACE('side {i}',#50,4,(),$,({a},{b},{c},{d}),((1,2,4,3)),());\n"
        else:
            text += coordinates(200 + i, [CORNERS[corner - 1] for corner in quad])
            text += f"#{100 + i}=TRIANGULATED_FACE('side {i}',#{200 + i},4,(),$,(),((1,2,3),(1,3,4)));\n"
    return text


def tessellated(kind="triangles", unit=MILLIMETRES, sides=6, more=""):
    links = ",".join(f"#{100 + i}" for i in range(sides))
    text = HEAD + unit + CONTEXT + faces(kind) + f"#60=TESSELLATED_SOLID('',({links}),$);\n" + more \
        + "#61=TESSELLATED_SHAPE_REPRESENTATION('',(#60),#14);\n#62=SHAPE_DEFINITION_REPRESENTATION(#8,#61);\n" \
        "ENDSEC;\nEND-ISO-10303-21;\n"
    path = SCRATCH / "tessellated.stp"
    path.write_text(text, encoding="ascii")
    return Content(path)


def test_tessellated():
    for kind in "triangles", "strips", "fans", "numbers", "own points":
        for unit, size in (MILLIMETRES, 1), (METRES, 1000), (INCHES, 25.4):
            read = tessellated(kind, unit)
            assert not read.is_error and not read.said, f"{kind}: {read.said}"
            solid, = read.solids
            assert solid.name == "büchse" and solid.open_edges == 0 and len(solid.triangles) == 12, (kind, solid.name)
            assert np.allclose([solid.volume, solid.volume_of_triangles, solid.own_volume()], 6 * size**3, rtol=1e-12), kind
            assert np.isclose(solid.area, 22 * size**2, rtol=1e-12), kind
            areas = read.areas()
            assert set(areas) == {f"side {i}" for i in range(6)} and np.isclose(areas["side 0"], 2 * size**2), areas
            assert solid.sharp is None, "angles tell which edges are sharp"


# An assembly in metres of two cuboids in millimetres: moved, and turned so that their x, y and z are y, z and x. Files may name
# either representation first.
ASSEMBLY = """#16=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));
#15=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#16))REPRESENTATION_CONTEXT('',''));
#200=PRODUCT('frame','','',(#3));
#201=PRODUCT_DEFINITION_FORMATION('','',#200);
#202=PRODUCT_DEFINITION('design','',#201,#6);
#203=PRODUCT_DEFINITION_SHAPE('','',#202);
#204=SHAPE_REPRESENTATION('',(#230,#240),#15);
#205=SHAPE_DEFINITION_REPRESENTATION(#203,#204);
#63=SHAPE_REPRESENTATION('',(#220),#14);
#64=SHAPE_REPRESENTATION_RELATIONSHIP('','',#63,#61);
#220=AXIS2_PLACEMENT_3D('',#221,$,$);
#221=CARTESIAN_POINT('',(0.,0.,0.));
#230=AXIS2_PLACEMENT_3D('',#231,$,$);
#231=CARTESIAN_POINT('',(0.1,0.,0.));
#232=NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','left','',#202,#7,$);
#233=PRODUCT_DEFINITION_SHAPE('','',#232);
#234=ITEM_DEFINED_TRANSFORMATION('','',#220,#230);
#235=(REPRESENTATION_RELATIONSHIP('','',#63,#204)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#234)SHAPE_REPRESENTATION_RELATIONSHIP());
#236=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#235,#233);
#240=AXIS2_PLACEMENT_3D('',#241,#248,#249);
#241=CARTESIAN_POINT('',(0.,0.2,0.));
#242=NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','right','',#202,#7,$);
#243=PRODUCT_DEFINITION_SHAPE('','',#242);
#244=ITEM_DEFINED_TRANSFORMATION('','',#240,#220);
#245=(REPRESENTATION_RELATIONSHIP('','',#204,#63)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#244)SHAPE_REPRESENTATION_RELATIONSHIP());
#246=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#245,#243);
#248=DIRECTION('',(1.,0.,0.));
#249=DIRECTION('',(0.,1.,0.));
"""
OWN = "#62=SHAPE_DEFINITION_REPRESENTATION(#8,#61);"


def test_tessellated_in_an_assembly():
    tessellated(more=ASSEMBLY)
    path = SCRATCH / "tessellated.stp"
    text = path.read_text(encoding="ascii")
    path.write_text(text.replace(OWN, OWN.replace("#61", "#63")), encoding="ascii")
    read = Content(path)
    assert not read.said, read.said
    assert [solid.name for solid in read.solids] == ["left", "right"], [solid.name for solid in read.solids]
    for solid, centre in zip(read.solids, ((100.5, 1, 1.5), (1.5, 200.5, 1))):
        assert np.isclose(solid.own_volume(), 6, rtol=1e-9) and solid.open_edges == 0, solid.own_volume()
        assert np.allclose(solid.centre(), centre, rtol=0, atol=1e-9), solid.centre()


def renumbered(path):
    """The entities of a STEP file, for another one."""
    entities = path.read_text(encoding="ascii").partition("DATA;\n")[2].partition("ENDSEC;")[0]
    return re.sub(r"#(\d+)", lambda number: f"#{int(number.group(1)) + 90000}", entities)


def with_more(text, entities):
    return text.replace("ENDSEC;\nEND-ISO", entities + "ENDSEC;\nEND-ISO")


def test_tessellated_beside_exact():
    """A product of its own is read, or named if it cannot be; another form of the exact solid is not."""
    exact = (FOLDER / "colours.step").read_text(encoding="ascii")
    before = Content(FOLDER / "colours.step").solids[0]
    tessellated()
    entities = renumbered(SCRATCH / "tessellated.stp")
    path = SCRATCH / "both.step"

    def read(more):
        path.write_text(with_more(exact, more), encoding="ascii")
        content = Content(path)
        assert not content.is_error, content.said
        assert np.array_equal(content.solids[0].triangles, before.triangles)
        return content

    both = read(entities)
    assert not both.said and [solid.name for solid in both.solids] == [before.name, "büchse"], both.said
    assert np.isclose(both.solids[1].own_volume(), 6, rtol=1e-9) and both.solids[1].sharp is None
    assert any("büchse" in finding and "Triangles instead" in finding for finding in both.findings()), both.findings()
    damaged = read(entities.replace("(1,3,4)", "(1,3,9)"))
    assert len(damaged.solids) == 1 and "left out" in damaged.said and "a corner that is not there" in damaged.said, damaged.said
    linked = read(re.sub(r"(#90060=TESSELLATED_SOLID\([^$]*),\$\)", r"\1,#17)", entities))
    assert len(linked.solids) == 1 and not linked.said, linked.said
    left = read(entities + "#99999=MAPPED_ITEM('',$,$);\n")
    assert len(left.solids) == 1 and "Left out: büchse" in left.said and "MAPPED_ITEM" in left.said, left.said
    shape = re.search(r"SHAPE_DEFINITION_REPRESENTATION\(#\d+,(#\d+)\)", exact).group(1)
    other = re.sub(r"#90062=[^;]*;", f"#90062=SHAPE_REPRESENTATION_RELATIONSHIP('','',{shape},#90061);", entities)
    assert len(read(other).solids) == 1 and not read(other).said


def test_tessellated_that_are_not_whole():
    read = tessellated(sides=5)
    assert "is open" in read.said and "4 of their edges" in read.said and read.solids[0].volume == 0, read.said
    read = tessellated(more="#70=MAPPED_ITEM('',$,$);\n")
    assert read.is_error and "MAPPED_ITEM" in read.said and "tessellated" in read.said, read.said
    for what, by in (",2.,3.)", ",2.)"), ("(1,3,4)", "(1,3,9)"), ("(1,3,4)", "(1,'3,4)"):
        tessellated()
        path = SCRATCH / "tessellated.stp"
        text = path.read_text(encoding="ascii")
        assert what in text
        path.write_text(text.replace(what, by), encoding="ascii")
        read = Content(path)
        assert read.is_error and path.name in read.said and "damaged" in read.said, read.said


def test_parts_in_other_files():
    shutil.copy(FOLDER / "several_files.step", SCRATCH)
    read = Content(SCRATCH / "several_files.step")
    assert read.is_error and "outside_block.stp" in read.said and "other files" in read.said, read.said
    (SCRATCH / "outside_block.stp").write_text("This is no STEP file.\n")
    read = Content(SCRATCH / "several_files.step")
    assert read.is_error and "outside_block.stp" in read.said, read.said
    assert not Content(FOLDER / "several_files.step").said
    both = SCRATCH / "some_in_other_files.step"
    text = (FOLDER / "several_files.step").read_text(encoding="ascii")
    both.write_text(with_more(text, renumbered(FOLDER / "colours.step")), encoding="ascii")
    read = Content(both)
    assert not read.is_error and "Parts are missing" in read.said and "outside_block.stp" in read.said, read.said
    assert len(read.solids) == 1 and np.isclose(read.solids[0].volume, 6000, rtol=1e-9), read.solids


def test_lost_faces_of_iges():
    """A trimmed surface without its surface."""
    text = (FOLDER / "faces.igs").read_text(encoding="ascii")
    path = SCRATCH / "lost.igs"
    path.write_text(re.sub(r"^144,\d+,", lambda found: "144,0,".ljust(len(found.group(0)), " "), text, count=1, flags=re.MULTILINE),
                    encoding="ascii")
    read = Content(path)
    assert not read.is_error and "nothing could be made: there may be holes" in read.said, read.said
    assert "damaged in the file" in read.said and sum(solid.open_edges for solid in read.solids) > 0, read.said
    assert not Content(FOLDER / "faces.igs").said


def test_damage_that_does_no_harm():
    text = (FOLDER / "colours.step").read_text(encoding="ascii")
    colour = re.search(r"(#\d+) = COLOUR_RGB\([^;]*;", text)
    path = SCRATCH / "colour.step"
    path.write_text(text.replace(colour.group(0), f"{colour.group(1)} = COLOUR_RGB('',*,#1);"), encoding="ascii")
    read = Content(path)
    assert not read.said and not any("amage" in finding for finding in read.findings()), (read.said, read.findings())
    assert read.solids[0].open_edges == 0


def test_faces_without_triangles():
    """As B-splines some have triangles; flat ones are made anew from their edges. What stays open is an error, unless asked for."""
    read = Content(FOLDER / "countersunk_10_0.brep")
    assert not read.said and read.solids[0].open_edges == 0, read.said
    read = Content(FOLDER / "tangled_flat_10_0.brep")
    found = [finding for finding in read.findings() if "Made flat" in finding]
    assert not read.said and len(found) == 1 and "face 6 of tangled_flat_10_0 at (15, 10, 10)" in found[0], read.findings()
    solid, = read.solids
    assert solid.open_edges == 0 and np.allclose([solid.volume, solid.own_volume()], 6000, rtol=1e-9), solid.own_volume()
    read = Content(FOLDER / "tangled_round.brep")
    assert read.is_error and "no triangles can be made: number 1 of tangled_round (6 faces) at (-2.5, 2.5, 10)" in read.said, read.said
    assert "Keep Damaged Faces" in read.said and "45 edges stay open" in read.said, read.said
    read = Content(FOLDER / "tangled_round.brep", KeepDamagedFaces=True)
    assert not read.is_error and "45 of their edges are open" in read.said and read.solids[0].open_edges == 45, read.said


def test_gaps_and_sheets():
    read = Content(FOLDER / "gaps.step")
    assert "set a larger Heal Tolerance" in read.said and "up to 0.0001 are" in read.said, read.said
    read = Content(FOLDER / "open_box_beside_cube.brep")
    assert not any("Divided" in finding for finding in read.findings()), read.findings()
    assert [solid.open_edges for solid in read.solids] == [0, 4] and read.solids[1].name.endswith("_sheet")
    assert np.isclose(read.solids[0].volume, 1000, rtol=1e-9)
    for file in "sheet.step", "solid_and_sheet.step":
        read = Content(FOLDER / file)
        assert "is open" in read.said and "Heal Tolerance" not in read.said and "sheet" in read.said, read.said


def test_surface_smaller_than_a_cell():
    read = Content(FOLDER / "colours.step", unit="m")  # 0.03 long

    def said(size, depth=0):
        mesher, window, before = vtkCartesianMesher(), vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
        mesher.SetInputConnection(read.reader.GetOutputPort())
        mesher.SetCellSize(size)
        mesher.SetRefinementDepth(depth)
        vtkOutputWindow.SetInstance(window)
        mesher.Update()
        vtkOutputWindow.SetInstance(before)
        return window.GetOutput()

    text = said(0.36)
    assert "smaller than a cell" in text and "12 times" in text and "Length Unit" in text, text
    assert not said(0.01) and not said(0.36, 4)


if __name__ == "__main__":
    run(globals())
