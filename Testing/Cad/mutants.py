"""Damaged copies of CAD files: always the same for a seed."""
import os
import random
import re

EXTENSIONS = (".step", ".stp", ".igs", ".iges", ".brep")
NUMBERS = [b"0.", b"-1.", b"1.E300", b"-1.E300", b"1.E-300", b"NaN", b"inf", b"1E999", b"99999999999999999999", b"-0."]
NUMBER = re.compile(rb"(?<![#\w.])-?\d+\.\d*(?:E[+-]?\d+)?")
INTEGER = re.compile(rb"(?<![#\w.])\d+(?![\w.])")
REFERENCE = re.compile(rb"#\d+")


def cut(content, draw):
    return content[:draw.randrange(len(content))]


def changed_bytes(content, draw):
    result = bytearray(content)
    for _ in range(draw.choice([1, 3, 30])):
        result[draw.randrange(len(result))] = draw.randrange(256)
    return bytes(result)


def removed_block(content, draw):
    first = draw.randrange(len(content))
    return content[:first] + content[first + draw.randrange(1, 2000):]


def of_lines(content, draw, change):
    lines = content.splitlines(keepends=True)
    for _ in range(draw.choice([1, 3, 10])):
        change(lines, draw.randrange(len(lines)))
    return b"".join(lines)


def deleted_lines(content, draw):
    return of_lines(content, draw, lambda lines, at: lines.__setitem__(at, b""))


def doubled_lines(content, draw):
    return of_lines(content, draw, lambda lines, at: lines.__setitem__(at, lines[at] * 2))


def exchanged_lines(content, draw):
    def exchange(lines, at):
        other = draw.randrange(len(lines))
        lines[at], lines[other] = lines[other], lines[at]

    return of_lines(content, draw, exchange)


def replaced(content, draw, pattern, by):
    """A few of what matches, or all that are the same as one of them."""
    found = list(pattern.finditer(content))
    if not found:
        return cut(content, draw)
    chosen = draw.sample(found, min(len(found), draw.choice([1, 3, 10])))
    if draw.randrange(4) == 0:
        chosen = [match for match in found if match.group() == chosen[0].group()]
    for match in sorted(chosen, key=lambda match: -match.start()):
        content = content[:match.start()] + by(match.group(), found) + content[match.end():]
    return content


def wrong_numbers(content, draw):
    number = draw.choice(NUMBERS)
    return replaced(content, draw, NUMBER, lambda old, found: number)


def scaled_numbers(content, draw):
    def scale(old, found):
        value = float(old) * draw.choice([-1, 1e-12, 0.5, 1.001, 1e6, 1e12])
        return repr(value).upper().encode()

    return replaced(content, draw, NUMBER, scale)


def wrong_integers(content, draw):
    number = draw.choice([b"0", b"1", b"2", b"-1", b"1000000", b"2147483647", b"4294967296"])
    return replaced(content, draw, INTEGER, lambda old, found: number)


def wrong_references(content, draw):
    """To another entity of the file: STEP's as #N, IGES's and BREP's are integers."""
    pattern = REFERENCE if REFERENCE.search(content) else INTEGER
    return replaced(content, draw, pattern, lambda old, found: draw.choice(found).group())


KINDS = [cut, changed_bytes, removed_block, deleted_lines, doubled_lines, exchanged_lines, wrong_numbers,
         scaled_numbers, wrong_integers, wrong_references]


def sources(folders):
    """The CAD files of the folders in the order of their names."""
    found = [os.path.join(folder, name) for folder in folders for name in os.listdir(folder)
             if name.lower().endswith(EXTENSIONS)]
    return sorted(path for path in found if os.path.getsize(path) > 1000)


def mutant(paths, seed, number):
    """Its file name and content; any of them by itself."""
    draw = random.Random(seed * 1000003 + number)
    path = draw.choice(paths)
    kind = draw.choice(KINDS)
    with open(path, "rb") as stream:
        content = stream.read()
    for _ in range(draw.choice([1, 1, 2])):
        content = kind(content, draw) or b" "
    stem, extension = os.path.splitext(os.path.basename(path))
    return f"{number:05d}.{kind.__name__}.{stem.replace(' ', '_')}{extension}", content
