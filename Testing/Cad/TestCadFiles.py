"""TestCadFiles.py FOLDER: what the CAD Reader makes of files whose volumes, areas and names are known exactly
(make-cad-parts)."""

import math
import pathlib
import sys
import tempfile

import numpy as np

from cadfiles import Content, facts_of, run

FOLDER = pathlib.Path(sys.argv[1])
FACTS = facts_of(FOLDER)
EXACT = 1e-9  # relative: what OCCT's integrals give
ADAPTIVE = 1e-6  # over rational B-splines


def read(file, **properties):
    content = Content(FOLDER / file, **{"GlueSolids": False} | properties)
    assert not content.is_error, content.said
    return content


def assert_near(what, found, expected, relative):
    assert abs(found - expected) <= relative * abs(expected), f"{what}: {found!r} instead of {expected!r}"


def assert_sound(file, solid):
    """What holds of every block."""
    assert np.isfinite(solid.points).all()
    assert set(np.unique(solid.triangles)) | set(np.unique(solid.lines)) == set(range(len(solid.points))), file
    assert (solid.areas() > 0).all(), f"{file}: a triangle without area"
    assert list(solid.sharp) == [1] * len(solid.lines) + [0] * len(solid.triangles)
    assert solid.own_open_edges() == solid.open_edges, f"{file}: {solid.open_edges} open edges"
    assert_near(f"{file}: volume of triangles", solid.volume_of_triangles, solid.own_volume(), EXACT)
    assert [solid.names[i] for i in solid.ids] == list(solid.boundaries), file


def solids_and_sheets(content):
    return ([solid for solid in content.solids if solid.open_edges == 0],
            [solid for solid in content.solids if solid.open_edges > 0])


def check_file(file, facts):
    """Volumes and areas, and as many open edges as the file has."""
    if file in JOINED:
        others = facts["others"]
        closed = {"volume": others["closedVolume"], "area": others.get("closedArea", facts["area"])}
        facts = {**facts, "solids": [closed], "openEdges": others.get("stillOpen", 0)}
    size = math.sqrt(facts["area"])
    deflection = 1e-3 * size
    content = read(file, Deflection=deflection)
    for solid in content.solids:
        assert_sound(file, solid)
    solids, sheets = solids_and_sheets(content)
    assert len(solids) == len(facts["solids"]), f"{file}: {len(solids)} solids"
    for solid, fact in zip(sorted(solids, key=lambda solid: solid.volume),
                           sorted(facts["solids"], key=lambda fact: abs(fact["volume"]))):
        tolerance = ADAPTIVE if file.startswith("splines") else TRANSLATED.get(file, EXACT)
        if file.startswith("hole_at_kink"):
            assert solid.volume == 0, f"{file}: two integrals do not agree on the volume: it is not known"
        else:
            assert_near(f"{file}: volume", solid.volume, abs(fact["volume"]), tolerance)
            assert_near(f"{file}: area", solid.area, fact["area"], tolerance)
        off = abs(solid.volume_of_triangles - abs(fact["volume"]))
        assert off <= 2 * deflection * fact["area"], f"{file}: triangles' volume is off by {off}"
    assert sum(sheet.open_edges for sheet in sheets) == facts["openEdges"], file
    for sheet in sheets:
        assert sheet.volume == 0, f"{file}: an open surface has no volume"


# Faces that touch exactly, which the reader joins unasked.
JOINED = {"six_faces.step", "six_faces.brep", "open_box_beside_cube.brep"}
# IGES in inches, or of parts of 0.1 mm, has fewer digits.
TRANSLATED = {"faces_inch.igs": 1e-8} | {file: 1e-8 for file in FACTS if file.startswith("touching_")}
# What OCCT 7.6 cannot read whole, or triangulate.
DAMAGED = {"quotes.step", "tangled_round.brep"}


def test_every_file():
    failures = []
    for file, facts in FACTS.items():
        try:
            if facts["faces"] > 0 and file not in DAMAGED:
                check_file(file, facts)
        except AssertionError as failure:
            failures.append(str(failure))
    assert not failures, "\n  ".join(failures)


def test_nothing_to_read():
    for file, facts in FACTS.items():
        if facts["faces"] == 0:
            content = Content(FOLDER / file)
            assert content.is_error and not content.blocks, file
            assert file in content.said and content.said.count("ERROR") == 1, content.said
    content = Content(FOLDER / "not there.step")
    assert content.is_error and "not there.step" in content.said, content.said


def test_cut_files():
    """As downloads that were broken off leave them: OCCT would read some for ever."""
    with tempfile.TemporaryDirectory() as scratch:
        for file in "solid.brep", "six_faces.brep", "colours.step", "solid.igs":
            whole = (FOLDER / file).read_bytes()
            for tenths in 3, 6, 9:
                path = pathlib.Path(scratch) / f"{tenths}.{file}"
                path.write_bytes(whole[:len(whole) * tenths // 10])
                content = Content(path, TimeLimit=60)
                assert content.is_error and path.name in content.said, f"{path.name}: {content.said}"
                assert "Time Limit" not in content.said, content.said


def test_lost_face_is_told():
    content = Content(FOLDER / "quotes.step")
    is_whole = not content.is_error and sum(solid.open_edges for solid in content.solids) == 0
    assert is_whole or "quotes.step" in content.said or "#17" in content.said, "a face was lost in silence"


def test_names():
    slices = 360 / 10  # at least so many chords has a circle, by Angle
    polygon = slices / (2 * math.pi) * math.sin(2 * math.pi / slices)  # of the circle's area
    for file in "junction_mm.step", "junction_m.step", "junction_inch.step":
        areas = read(file).areas()
        exact = FACTS[file]["boundaries"]
        assert set(areas) == set(exact), areas
        for cap in "inlet_1", "inlet_2", "outlet":
            assert polygon * exact[cap] <= areas[cap] < exact[cap], f"{file}: {cap} has {areas[cap]}"


def test_sources_of_names():
    def boundaries(file, source):
        return read(file, BoundaryNamesFrom=source).areas()

    automatic, faces, colours, groups, layers, solids = range(6)
    assert_boundaries(boundaries("colours.step", automatic), "colours.step")
    assert_boundaries(boundaries("colours.step", colours), "colours.step")
    assert_boundaries(boundaries("colours.igs", colours), "colours.igs")
    assert_boundaries(boundaries("layers.step", layers), "layers.step")
    for file in "odd_names.step", "encoded_names.step", "partly_named.step":
        for source in automatic, faces:
            assert_boundaries(boundaries(file, source), file, others=1)
    assert len(boundaries("names_none.step", automatic)) == 6  # NONE tells nothing
    assert len(boundaries("rounded_box.step", groups)) == FACTS["rounded_box.step"]["others"]["tangentGroups"]
    assert len(boundaries("rounded_edge.step", groups)) == FACTS["rounded_edge.step"]["others"]["tangentGroups"]
    assert len(boundaries("crease.step", groups)) == 7
    assert len(boundaries("heated_pipe.step", solids)) == 3


def assert_boundaries(areas, file, others=0):
    """All that the facts name, of flat faces, and as many others."""
    exact = FACTS[file]["boundaries"]
    assert set(exact) <= set(areas) and len(areas) == len(exact) + others, f"{file}: {areas}"
    for name, area in exact.items():
        assert_near(f"{file}: {name}", areas[name], area, EXACT)


def test_names_of_solids():
    for file in "heated_pipe.step", "turned_cube.step", "overlap.step":
        assert [solid.name for solid in read(file).solids] == [fact["name"] for fact in FACTS[file]["solids"]], \
            [solid.name for solid in read(file).solids]
    names = [solid.name for solid in read("same_names.step").solids]
    assert len(set(names)) == 2 and all(name.startswith("body") for name in names), names


def test_units():
    """The same part in millimetres and metres, and one file in all units."""
    in_mm = read("junction_mm.step").solids[0]
    in_metres = read("junction_m.step").solids[0]
    assert np.array_equal(in_mm.triangles, in_metres.triangles)
    assert np.abs(in_mm.points - in_metres.points).max() <= 1e-12 * np.abs(in_mm.points).max()
    for unit, millimetres in {"m": 1000, "cm": 10, "in": 25.4, "ft": 304.8}.items():
        other = read("junction_mm.step", unit=unit).solids[0]
        assert np.array_equal(in_mm.triangles, other.triangles), unit
        assert np.abs(in_mm.points - millimetres * other.points).max() <= 1e-12 * np.abs(in_mm.points).max(), unit
        assert_near(unit, other.volume * millimetres**3, in_mm.volume, 1e-12)
    doubled = read("junction_mm.step", Scale=2).solids[0]
    assert_near("Scale", doubled.volume, 8 * in_mm.volume, 1e-12)


def test_places():
    """Instances of parts, moved and turned by two assemblies."""
    for file in "bolted_plates.step", "several_files.step":
        centres = [fact["centre"] for fact in FACTS[file]["solids"]]
        for solid in read(file).solids:
            nearest = min(centres, key=lambda centre: math.dist(centre, solid.centre()))
            assert math.dist(nearest, solid.centre()) < 0.02, f"{file}: {solid.name} is at {solid.centre()}"
            centres.remove(nearest)
        assert not centres


def test_glue():
    """Where solids touch they have the same triangles, and are as large as before."""
    touching = ("turned_cube.step", "cylinder_on_cube.step", "overhang.step", "bolted_plates.step", "heated_pipe.step",
                "several_files.step", *(file for file in FACTS if file.startswith(("bend_", "touching_"))))
    apart = "touch_at_edge.step", "touch_at_corner.step", "apart.step"
    for file in touching + apart:
        content = read(file, GlueSolids=True)
        expected = sorted(fact["volume"] for fact in FACTS[file]["solids"])
        for solid, volume in zip(sorted(content.solids, key=lambda solid: solid.volume), expected):
            assert_sound(file, solid)
            assert solid.open_edges == 0
            assert_near(f"{file}: {solid.name}", solid.volume, volume, TRANSLATED.get(file, EXACT))
        area = area_of_contacts(content.solids)
        exact = FACTS[file]["others"].get("contactArea", 0)
        assert abs(area - exact) <= 0.006 * exact, f"{file}: glued in {area} instead of {exact}"


def test_solids_after_gluing():
    """As many as before, with their names, or it is told which have become others."""
    for file in "bend_10_0.step", "heated_pipe.step":
        content = read(file, GlueSolids=True)
        assert [solid.name for solid in content.solids] == [fact["name"] for fact in FACTS[file]["solids"]], file
        assert not content.said, content.said
    content = read("rod_through_plate.step", GlueSolids=True)
    assert len(content.solids) == 4 and "divided the solid rod into 2 solids" in content.said, content.said


def area_of_contacts(solids):
    """Of triangles that two solids have."""
    seen, area = set(), 0
    for solid in solids:
        own = solid.set_of_triangles()
        assert len(own) == len(solid.triangles)
        keys = [frozenset(map(tuple, triangle)) for triangle in solid.corners().tolist()]
        area += sum(a for key, a in zip(keys, solid.areas()) if key in seen)
        seen |= own
    return area


def test_overlap():
    """Glued, what two solids share is a third one, which is told."""
    content = read("overlap.step", GlueSolids=True)
    others = FACTS["overlap.step"]["others"]
    volumes = sorted(solid.volume for solid in content.solids)
    alone = (others["unionVolume"] - others["commonVolume"]) / 2
    assert np.allclose(volumes, [others["commonVolume"], alone, alone], rtol=EXACT, atol=0), volumes
    assert "overlap" in content.said, content.said


def test_heal():
    """Gaps close at a larger tolerance only."""
    gap = FACTS["gaps.step"]["others"]["gap"]
    assert read("gaps.step", HealTolerance=gap / 2).solids[0].open_edges == FACTS["gaps.step"]["openEdges"]
    healed = read("gaps.step", HealTolerance=2 * gap)
    assert [solid.open_edges for solid in healed.solids] == [0]
    assert_sound("gaps.step", healed.solids[0])
    closed = FACTS["gaps.step"]["others"]["closedVolume"]
    assert abs(healed.solids[0].volume_of_triangles - closed) <= gap * FACTS["gaps.step"]["area"]
    assert set(healed.areas()) == {"top", "rest"}
    for file in "six_faces.step", "six_faces.brep":
        solid, = read(file, HealTolerance=1e-6).solids
        assert solid.open_edges == 0
        assert_near(file, solid.volume, FACTS[file]["others"]["closedVolume"], EXACT)


def test_sharp_edges():
    """Their lengths, where they are straight; roundings have none, but a crease of a few degrees does."""
    x, y, z, radius = 30, 20, 10, 3
    assert_near("cuboid", read("colours.step").solids[0].length_of_sharp_edges(), 4 * (x + y + z), EXACT)
    for file in "rounded_box.step", "sphere.step", "torus.step":
        assert read(file).solids[0].length_of_sharp_edges() == 0, file
    rise = x / 2 * math.tan(math.radians(FACTS["crease.step"]["others"]["creaseDegrees"] / 2))
    crease = 2 * (x + 2 * z + 2 * math.hypot(x / 2, rise)) + 5 * y
    assert_near("crease", read("crease.step").solids[0].length_of_sharp_edges(), crease, EXACT)
    straight = 4 * (x + y + z) - 4 * radius - y
    arcs = math.pi * radius
    edges = read("rounded_edge.step").solids[0].length_of_sharp_edges()
    assert 0.99 * arcs <= edges - straight < arcs, edges
    kinks = 2 * (2 * math.hypot(5, 2) + 2 * math.hypot(5, 3) + 20 + 2 * 10) + (4 + 3) * 8
    assert_near("kinks", read("kinks.step").solids[0].length_of_sharp_edges(), kinks, 1e-3)


def test_points_are_on_the_surface():
    for file in "sphere.step", "sphere_solid.igs", "sphere.igs":
        radii = np.linalg.norm(read(file).solids[0].points, axis=1)
        assert np.abs(radii - 5).max() < 1e-9, file


def test_same_twice():
    """Triangles are made by several threads."""
    one, other = (read("bolted_plates.step", GlueSolids=True) for _ in range(2))
    for a, b in zip(one.solids, other.solids):
        assert np.array_equal(a.points, b.points) and np.array_equal(a.triangles, b.triangles), a.name
        assert np.array_equal(a.lines, b.lines) and np.array_equal(a.ids, b.ids), a.name


def test_time_limit():
    content = Content(FOLDER / "bolted_plates.step", TimeLimit=0.001)
    assert content.is_error and "Time Limit" in content.said and not content.blocks, content.said


if __name__ == "__main__":
    run(globals())
