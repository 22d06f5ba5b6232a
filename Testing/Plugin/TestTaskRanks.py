"""cartesian-mesher on ranks: whichever fails to write its piece, or Ctrl-C, ends all of them soon, and leaves what
was there."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

from pipeline import DATA

PROGRAM = sys.argv[2]
SUCCESS, REFUSED, WARNINGS = 0, 2, 3
LONGEST = 10.0  # seconds
TASK = """
[surface]
file = "{surface}"
[grid]
cell_size = {size}
[output]
mesh = "{mesh}"
pieces = {pieces}
"""
# One rank finds the device full, as far as files tell; -1: none.
LIMITED = """if [ "$OMPI_COMM_WORLD_RANK" = "$LIMITED" ]; then trap '' XFSZ; ulimit -f 40; fi; exec "$0" "$@" """
ENVIRONMENT = {name: value for name, value in os.environ.items() if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
# Shared memory that is no file: Open MPI 5 would fail in the limited rank.
ENVIRONMENT["OMPI_MCA_shmem"] = "sysv"
# Memory is 0 at first: where a device is full, VTK 9.2's vtkXMLUnstructuredGridWriter frees a pointer that it never set.
ENVIRONMENT |= {"MALLOC_PERTURB_": "255", "GLIBC_TUNABLES": "glibc.malloc.tcache_count=0"}


class Program:
    """Started on some ranks."""

    def __init__(self, folder, ranks, mesh, size, limited=-1):
        self.task, self.temporary = folder / "task.toml", folder / "tmp"
        self.temporary.mkdir(exist_ok=True)
        pieces = ranks if mesh.endswith(".foam") else 1
        self.task.write_text(TASK.format(surface=DATA / "kcl_exhaust_header_lumens.stl", size=size, mesh=mesh,
            pieces=pieces))
        self.begin = time.monotonic()
        self.process = subprocess.Popen(["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), "sh",
            "-c", LIMITED, PROGRAM, self.task], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            env=ENVIRONMENT | {"LIMITED": str(limited), "TMPDIR": str(self.temporary)})

    def end(self):
        """What it said, its exit code, and the seconds."""
        said = self.process.communicate(timeout=300)[0]
        return said, self.process.returncode, time.monotonic() - self.begin

    def left(self):
        """Its processes, and its temporary files."""
        processes = []
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if str(self.task) in (process / "cmdline").read_text():
                    processes.append(process.name)
            except OSError:  # it has ended
                pass
        return processes, [path for path in self.temporary.iterdir() if path.is_file()]


def contents(folder):
    return {path: path.read_bytes() for path in (folder / "out").rglob("*")
        if path.is_file() and ".unfinished" not in str(path)}


def loses_nothing(ranks, mesh, limited):
    """Of a mesh that was written, when each of these ranks in turn cannot write."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        said, code, usual = Program(folder, ranks, mesh, 24).end()
        assert code in (SUCCESS, WARNINGS), said
        before = contents(folder)
        for failing in limited:
            said, code, seconds = Program(folder, ranks, mesh, 20, failing).end()
            print(f"{mesh}, {ranks} ranks, {failing} fails: {seconds:.1f} s, {usual:.1f} without")
            assert code == REFUSED and "output.mesh" in said and "could not be written" in said, said
            assert contents(folder) == before, "what was there is lost"
            assert seconds < 2 * usual + LONGEST, f"{seconds:.1f} s"


def ends_soon(ranks):
    """After Ctrl-C, with nothing left."""
    with tempfile.TemporaryDirectory() as name:
        program = Program(pathlib.Path(name), ranks, "mesh.pvtu", 2)  # a minute of work
        said = ""
        while "Edits of the wall" not in said:
            line = program.process.stdout.readline()
            assert line, said
            said += line
        program.begin = time.monotonic()
        program.process.send_signal(signal.SIGINT)
        said, code, seconds = program.end()
        print(f"Ctrl-C on {ranks} ranks: code {code} after {seconds:.1f} s")
        assert code != 0 and seconds < LONGEST, f"code {code}, {seconds:.1f} s"
        assert "Loguru" not in said and "Stack trace" not in said, said
        while program.left() != ([], []) and time.monotonic() < program.begin + LONGEST:
            time.sleep(0.1)
        assert program.left() == ([], []), program.left()
        assert not list(pathlib.Path(name).glob("mesh*"))


if sys.argv[-1] == "each":
    for ranks in 2, 3:
        for mesh in "out/mesh.pvtu", "out/mesh.foam":
            loses_nothing(ranks, mesh, range(ranks))
        ends_soon(ranks)
else:
    loses_nothing(2, "out/mesh.pvtu", [0])
    loses_nothing(2, "out/mesh.foam", [1])
    ends_soon(2)
