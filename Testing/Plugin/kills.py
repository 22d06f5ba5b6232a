"""kills.py COUNT [SEED]: kill -9 at random moments of writing, over older outputs of the same names.

Two meshes in turn are written as .vtu, as .pvtu in pieces, and as an OpenFOAM case, by what cartesian-mesher
writes with, in a process of its own; COUNT times for each kind it is killed at a random moment. Then what has
the name must be wholly the one mesh or wholly the other. On demand; run it under pvpython, with PYTHONPATH and
PV_PLUGIN_PATH as ctest has them.
"""

import collections
import hashlib
import os
import pathlib
import random
import re
import signal
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
TASKS = pathlib.Path("share") / "cartesianmesher"
BUILD = next(folder for folder in pathlib.Path(os.environ["PV_PLUGIN_PATH"]).parents if (folder / TASKS).is_dir())
sys.path[:0] = str(BUILD / TASKS), str(ROOT / "Testing" / "Plugin")

import run
from task import read_task

COUNT, SEED = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
SIZES = 12.0, 13.0
PIECES = 3
TASK = """
[surface]
file = "{surface}"
[grid]
cell_size = {size}
[output]
mesh = "mesh{suffix}"
"""


def files_of(folder, suffix):
    """What a reader of the output gets to see, in order."""
    file = folder / f"mesh{suffix}"
    if suffix == ".vtu":
        return [file]
    if suffix == ".pvtu":
        return [folder / name for name in re.findall('Source="([^"]*)"', file.read_text())]
    return sorted(path for path in (folder / "constant" / "polyMesh").rglob("*") if path.is_file())


def state(folder, suffix):
    """A digest of an output; None where it is incomplete, as a reader would notice."""
    digest = hashlib.sha256()
    try:
        files = files_of(folder, suffix)
        for path in files:
            digest.update(path.name.encode() + path.read_bytes())
    except FileNotFoundError:
        return None
    return digest.hexdigest() if files else None


def in_child(work):
    child = os.fork()
    if child == 0:
        try:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
            work()
            os._exit(0)
        except BaseException as error:
            print(f"{type(error).__name__}: {error}", file=sys.stderr, flush=True)
            os._exit(1)
    return child


class Output:
    """One kind of output, of either mesh."""

    def __init__(self, folder, suffix):
        self.folder, self.suffix = folder, suffix
        self.jobs, self.states, self.seconds = [], [], 0.0
        for n, size in enumerate(SIZES):
            file = folder / f"task{n}.toml"
            file.write_text(TASK.format(surface=ROOT / "Data" / "kcl_exhaust_header_lumens.stl", size=size,
                suffix=suffix))
            task = read_task(file)
            mesher, _ = run.build(task, quiet=True)
            if suffix != ".pvtu":
                mesher.UpdatePipeline()
            self.jobs.append((mesher, task))
        for n in (0, 1):
            self.states.append(self.whole(n))
        assert None not in self.states and self.states[0] != self.states[1], suffix

    def write(self, n):
        mesher, task = self.jobs[n]
        if self.suffix == ".pvtu":
            run.write_pieces(run.Listener(mesher, quiet=True), task, PIECES)
        else:
            run.write(mesher, task)

    def whole(self, n):
        begin = time.monotonic()
        _, status = os.waitpid(in_child(lambda: self.write(n)), 0)
        assert status == 0, f"{self.suffix}: {status}"
        self.seconds = max(self.seconds, time.monotonic() - begin)
        return state(self.folder, self.suffix)

    def kill(self, n, delay):
        child = in_child(lambda: self.write(n))
        time.sleep(delay)
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        return state(self.folder, self.suffix)


generator = random.Random(SEED)
faults = 0
for suffix in (".vtu", ".pvtu", ".foam"):
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        output = Output(pathlib.Path(folder), suffix)
        now = 1
        found = collections.Counter()
        for _ in range(COUNT):
            after = output.kill(1 - now, generator.uniform(0, 1.1 * output.seconds))
            what = "incomplete" if after is None else \
                ("old", "new")[output.states.index(after) != now] if after in output.states else "mixed"
            found[what] += 1
            if what == "new":
                now = 1 - now
            elif what != "old":
                faults += 1
                output.whole(now)
        left = sorted(path.name for path in pathlib.Path(folder).iterdir())
        assert output.whole(1 - now) == output.states[1 - now], "what kills left is in the way"
        print(f"{suffix}: {output.seconds:.2f} s, {COUNT} kills: {dict(found)}; left: {left}", flush=True)
        os.chdir(ROOT)
sys.exit(1 if faults else 0)
