"""TestDamaged.py FOLDER: of damaged CAD files the CAD Reader makes a sound surface or one clear error, never a crash, and
does not outlast its Time Limit."""

import pathlib
import sys
import tempfile
import time

import numpy as np

import mutants
from cadfiles import Content

COUNT, SEED = 40, 5  # fuzz.py tries more of them
LIMIT = 5  # seconds


def check(path):
    """Whether it was read."""
    start = time.monotonic()
    content = Content(path, TimeLimit=LIMIT, GlueSolids=True, MergeCoplanar=True)
    assert time.monotonic() - start < LIMIT + 10, f"{path.name}: the time limit is not kept"
    if content.is_error:
        assert not content.blocks and content.said.count("ERROR") == 1, f"{path.name}: {content.said}"
        assert path.name in content.said, f"{path.name}: {content.said}"
        return False
    assert content.solids, f"{path.name}: neither a surface nor an error"
    for solid in content.solids:
        assert len(solid.triangles) > 0, f"{path.name}: an empty block"
        assert np.isfinite(solid.points).all(), f"{path.name}: points nowhere"
        assert solid.triangles.min() >= 0 and solid.triangles.max() < len(solid.points), path.name
        assert all(solid.boundaries), f"{path.name}: a boundary without a name"
    return True


def main(folder):
    sources = mutants.sources([folder])
    read, failures = 0, []
    with tempfile.TemporaryDirectory() as scratch:
        for number in range(COUNT):
            name, content = mutants.mutant(sources, SEED, number)
            path = pathlib.Path(scratch) / name
            path.write_bytes(content)
            try:
                read += check(path)
            except AssertionError as failure:
                failures.append(str(failure))
    print(f"{read} of {COUNT} were read, the others refused")
    assert not failures, "\n".join(failures)
    assert 0 < read < COUNT, "damage does nothing, or all is refused"


main(sys.argv[1])
