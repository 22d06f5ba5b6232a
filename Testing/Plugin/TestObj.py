"""The Named OBJ Reader reads what ParaView's reader reads, bit for bit: files of vertices, faces and groups, which it reads on
all threads, and all others."""

import math
import pathlib
import random
import tempfile

from paraview import simple

from pipeline import arrays, contents, output

OWN = {"BoundaryId", "BoundaryIds", "BoundaryNames"}  # of named groups


def check(what, text):
    """Returns the cells' numbers of boundaries, or nothing if no group has a name."""
    path = folder / "surface.obj"
    path.write_bytes(text.encode())
    named, plain = (output(reader(FileName=str(path))) for reader in
        (simple.NamedOBJReader, simple.WavefrontOBJReader))
    own, expected = arrays(named), arrays(plain)
    for name, array in expected.items():
        same = (own[name] is None) == (array is None) and (array is None or
            (own[name].GetDataType() == array.GetDataType() and contents(own[name]) == contents(array)))
        assert same, f"{what}: {name} differs"
    boundaries = named.GetCellData().GetArray("BoundaryId")
    return boundaries and [int(boundaries.GetTuple1(i)) for i in range(boundaries.GetNumberOfTuples())]


def grid(size, corner=str, end="\n"):
    """A bumpy square of 2 size^2 triangles, in groups of rows; larger than what one thread takes at once."""
    numbers = random.Random(1)
    lines = ["# a grid", "", "s off"]
    for y in range(size + 1):
        lines += [f"v {x / 3} {y * 1.1e-3:.7g}\t {math.sin(x * y) * 10.0 ** numbers.randint(-9, 9)} " for x in range(size + 1)]
    for y in range(size):
        lines += [f"o row {y}", f"g  part_{y // 7}"] if y % 3 == 0 else []
        for x in range(size):
            p = 1 + x + y * (size + 1)
            quad = [corner(n) for n in (p, p + 1, p + size + 2, p + size + 1)]
            lines += [f"f {' '.join(quad)}"] if x % 5 == 0 else \
                [f"f {quad[0]}  {quad[1]} {quad[2]}", f"  f\t{quad[0]} {quad[2]} {quad[3]} "]
    return end.join(lines) + end


CUBE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    found = check("a grid", grid(120))
    assert set(found) == set(range(17)), set(found)  # part_0 to part_16, numbered as they come
    assert check("line ends of Windows", grid(60, end="\r\n")) == check("of Unix", grid(60))
    # Numbers of groups: whether faces or a group come first; groups without a name, or twice.
    check("no groups", CUBE + "f 1 2 3\nf 1 2 4\n")
    check("a face first", CUBE + "f 1 2 3\ng a\nf 1 2 4\ng b\ng b\nf 1 3 4\ng\nf 2 3 4")
    check("a group first", CUBE + "g a\nf 1 2 3\ng a\nf 1 2 4\n")
    check("two groups first", "g a\n" + CUBE + "g b\nf 1 2 3\n")
    check("vertices last", "f 1 2 3\nf 1 2 4\n" + CUBE)
    # What only ParaView's reads.
    check("from the end", CUBE + "g a\nf -1 -2 -3\nf -1 -2 -4\n")
    check("texture", CUBE + "vt 0 0\nvt 1 0\nvt 0 1\ng a\nf 1/1 2/2 3/3\nf 1/1 2/2 4/3\n")
    check("normals", grid(20, corner=lambda n: f"{n}//1").replace("s off", "vn 0 0 1"))
    check("materials", CUBE + "usemtl red\nf 1 2 3\nusemtl blue\nf 1 2 4\n")
    check("lines", CUBE + "l 1 2 3\nf 1 2 3\n")
    check("colours", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\ng a\nf 1 2 3\n")
    check("signs", "v +0 0 0\nv 1 0 0\nv 0 1 0\ng a\nf 1 2 3\n")
    check("lines that go on", CUBE + "g a\nf 1 2 \\\n3\nf 1 2 4\n")
    check("comments that go on", CUBE + "# and \\\nf 1 2 3\nf 1 2 4\n")
