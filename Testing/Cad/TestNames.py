"""TestNames.py FOLDER: names of solids in files as other programs write them: in bytes of their system, and of products that
hold more than their solid."""

import pathlib
import re
import sys
import tempfile

from cadfiles import Content, run

FOLDER = pathlib.Path(sys.argv[1])
SCRATCH = pathlib.Path(tempfile.mkdtemp())
STEP = (FOLDER / "partly_named.step").read_text(encoding="ascii")
IGES = (FOLDER / "colours.igs").read_text(encoding="ascii")
UTF8, WESTERN, CENTRAL, CYRILLIC, GREEK, TURKISH, CHINA, TAIWAN, JAPAN, KOREA = range(1, 11)


def solids(name, content, **properties):
    path = SCRATCH / name
    path.write_bytes(content)
    read = Content(path, **properties)
    assert not read.is_error, read.said
    return read


def assert_name(name, encoding, **properties):
    read = solids("named.step", STEP.replace("cuboid", name).encode(encoding), **properties)
    found = [solid.name for solid in read.solids]
    assert found == [name], f"{name} in {encoding}: {found}"
    assert set(read.areas()) == {"inlet", "outlet", name}, read.areas()
    assert_told = any("UTF-8" in finding for finding in read.findings())
    assert assert_told == (encoding != "utf-8" and not properties), read.findings()


def test_guessed():
    for name, encoding in (("Gehäuse", "latin-1"), ("Größe 90° Ø20", "latin-1"), ("Mänty", "latin-1"), ("pièce forgée", "cp1252"),
                           ("bride “A” d’entrée", "cp1252"), ("轴承座", "gb18030"), ("轴", "gb18030"), ("M6螺栓", "gb18030"),
                           ("ボルト", "cp932"), ("ねじ", "cp932"), ("不鏽鋼軸承座", "big5"), ("Корпус насоса", "cp1251"),
                           ("Gehäuse", "utf-8"), ("轴承座", "utf-8")):
        assert_name(name, encoding)


def test_chosen():
    """What guessing cannot know."""
    for name, encoding, choice in (("볼트", "cp949", KOREA), ("Łożysko", "cp1250", CENTRAL), ("κορμός", "cp1253", GREEK),
                                   ("gövde şaft", "cp1254", TURKISH), ("轴承座", "gb18030", CHINA), ("螺絲", "big5", TAIWAN),
                                   ("Ã¤", "cp1252", WESTERN), ("Вал", "cp1251", CYRILLIC), ("軸受", "cp932", JAPAN)):
        assert_name(name, encoding, NameEncoding=choice)
    assert "NameEncoding is 11" in Content(FOLDER / "colours.step", NameEncoding=11).said.replace("Name Encoding", "NameEncoding")


def test_iges():
    for name, encoding in ("Gehäus", "latin-1"), ("轴承座", "gb18030"):
        field = name.encode(encoding)
        assert len(field) == len("cuboid")
        read = solids("named.igs", IGES.encode("ascii").replace(b"cuboid", field), BoundaryNamesFrom=5)
        assert [solid.name for solid in read.solids] == [name], [solid.name for solid in read.solids]


# A line, and a disc of radius 5 above the cuboid.
LINE = """#9010=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#9011),{units});
#9011=GEOMETRIC_CURVE_SET('',(#9012));
#9012=TRIMMED_CURVE('',#9013,(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(9.)),.T.,.PARAMETER.);
#9013=LINE('',#9014,#9015);
#9014=CARTESIAN_POINT('',(50.,0.,0.));
#9015=VECTOR('',#9016,1.);
#9016=DIRECTION('',(1.,0.,0.));
"""
DISC = """#9010=MANIFOLD_SURFACE_SHAPE_REPRESENTATION('',(#9011),{units});
#9011=SHELL_BASED_SURFACE_MODEL('',(#9012));
#9012=OPEN_SHELL('',(#9013));
#9013=ADVANCED_FACE('',(#9014),#9024,.T.);
#9014=FACE_BOUND('',#9015,.T.);
#9015=EDGE_LOOP('',(#9016));
#9016=ORIENTED_EDGE('',*,*,#9017,.T.);
#9017=EDGE_CURVE('',#9018,#9018,#9020,.T.);
#9018=VERTEX_POINT('',#9019);
#9019=CARTESIAN_POINT('',(5.,0.,50.));
#9020=CIRCLE('',#9021,5.);
#9021=AXIS2_PLACEMENT_3D('',#9022,$,$);
#9022=CARTESIAN_POINT('',(0.,0.,50.));
#9024=PLANE('',#9021);
"""


def with_more(more, how):
    """The cuboid's product with another representation: related to its own, both to a common one, or by itself."""
    part, solid = re.search(r"SHAPE_DEFINITION_REPRESENTATION\((#\d+),(#\d+)\)", STEP).groups()
    units = re.search(r"SHAPE_REPRESENTATION\('',\([^)]*\),(#\d+)\)", STEP).group(1)
    relation = "#{}=SHAPE_REPRESENTATION_RELATIONSHIP('','',{},{});\n".format
    text = STEP
    more = more.format(units=units)
    if how == "related":
        more += relation(9001, solid, "#9010")
    elif how == "both":
        text = text.replace(f"SHAPE_DEFINITION_REPRESENTATION({part},{solid})", f"SHAPE_DEFINITION_REPRESENTATION({part},#9000)")
        axes = re.search(r"(#\d+) = AXIS2_PLACEMENT_3D", STEP).group(1)
        more += f"#9000=SHAPE_REPRESENTATION('',({axes}),{units});\n" + relation(9001, "#9000", solid) \
            + relation(9002, "#9000", "#9010")
    else:
        more += f"#9001=SHAPE_DEFINITION_REPRESENTATION({part},#9010);\n"
    return text.replace("ENDSEC;\nEND-ISO", more + "ENDSEC;\nEND-ISO").encode("ascii")


def test_product_that_holds_more():
    for more, sheets in (LINE, []), (DISC, ["cuboid_sheet"]):
        for how in "related", "both", "alone":
            read = solids("more.step", with_more(more, how))
            assert [solid.name for solid in read.solids] == ["cuboid", *sheets], (how, [solid.name for solid in read.solids])
            assert read.solids[0].open_edges == 0 and abs(read.solids[0].volume - 6000) < 1e-6


def test_counted_instances():
    """Numbers that an assembly gives to instances of products without a name are no names."""
    text = (FOLDER / "bolted_plates.step").read_text(encoding="ascii")
    text = re.sub(r"PRODUCT\('\w+','\w+'", "PRODUCT('Open CASCADE STEP translator 6.3 1','Open CASCADE STEP translator 6.3 1'", text)
    text, count = re.subn(r"(NEXT_ASSEMBLY_USAGE_OCCURRENCE\('\d+',)'\w+'", r"\1''", text)
    read = solids("joint.step", text.encode("ascii"))
    assert count == 5 and [solid.name for solid in read.solids] == [f"joint_{n}" for n in (1, 2, 3, 4)], \
        [solid.name for solid in read.solids]


if __name__ == "__main__":
    run(globals())
