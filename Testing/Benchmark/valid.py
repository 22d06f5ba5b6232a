# SPDX-License-Identifier: BSD-3-Clause
"""Does checkMesh accept the meshes of all surfaces that we have?

    export PV_PLUGIN_PATH=$PWD/build/release/lib/paraview-5.11/plugins
    pvpython Testing/Benchmark/valid.py [options]

  --surfaces FOLDER...  files that are not in the repository: STL, OBJ, PLY
  --only PATTERN        the cases (kind: name) that this regular expression is found in
  --sample              some of each kind, in a minute
  --list                the cases alone
  --results FILE        what was found, a line each (default: valid.tsv in the build's folder)
  --keep FOLDER         keep the OpenFOAM cases there
  --limit SECONDS       of a case (default: 900)

Each surface is meshed on one thread, in a process of its own, written as an OpenFOAM case, and checked. A line for
each: ok; refused (by checkMesh); error (no mesh, and the mesher says why); crash (neither). Then seconds of CPU for the mesh,
cells, whether the mesher told of failing cells, with their places, and what checkMesh says.
Results are kept by the last commit of the plugin's sources: run again after a stop, it goes on where it was. Where
sources have changed since that commit, and with --sample without --results, all is run.
At the end the sums of each kind, and what is refused; the exit code is 1 if that is more than 1 in 200 meshes.
"""

import argparse
import collections
import json
import os
import pathlib
import re
import resource
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import traceback

from paraview import simple

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "Plugin")]
import foam  # noqa: E402
import hashes  # noqa: E402
import validcases  # noqa: E402

ACCEPTED = 200  # meshes, of which one may be refused
OK, REFUSED, ERROR, CRASH = VERDICTS = "ok", "refused", "error", "crash"
WARNED = "checkMesh will fail"
UNMARKED = re.compile(r"^ *(Illegal cells .*)$", re.MULTILINE)  # a failure to which checkMesh gives no stars
Result = collections.namedtuple("Result", "verdict seconds cells told faults")
COLUMNS = "commit", "case", *Result._fields


def key(case):
    return f"{case.kind}: {case.name}"


# ---- A mesh

def properties_of(case, surface):
    """With those that depend on the surface's size."""
    bounds = surface.GetDataInformation().GetBounds()
    longest = max(high - low for low, high in zip(bounds[0::2], bounds[1::2]))
    found = dict(case.properties)
    if case.parts:
        found["CellSize"] = longest / case.parts
    if case.margin:
        margin = validcases.MARGIN * longest
        found |= {"Domain": "Outside", "BoxFrom": "Bounds",
                  "DomainBounds": [end + (margin if i % 2 else -margin) for i, end in enumerate(bounds)]}
    return found


def regions_of(folder):
    """checkMesh's options for each region of a case."""
    if (folder / "constant" / "polyMesh").exists():
        return [()]
    return [("-region", path.parent.name) for path in sorted((folder / "constant").glob("*/polyMesh"))]


def faults_of(folder):
    """What checkMesh says, in short; nothing if the mesh is OK."""
    faults = []
    for region in regions_of(folder):
        try:
            checked = foam.CheckMesh(folder, *region)
        except AssertionError as error:
            faults.append(f"checkMesh died: {str(error).splitlines()[-1]}")
            continue
        if not checked.ok:
            failures = checked.failures or UNMARKED.findall(checked.text) or ["no verdict"]
            faults += [" ".join([*region[1:], fault.strip()]) for fault in failures]
    return faults


def reason(messages):
    """The first error, or the first of all messages."""
    texts = [text for text in messages if text.startswith("ERROR")] or messages
    return " ".join(texts[0].split())[:300] if texts else ""


def mesh(case, folder):
    """A Result."""
    with hashes.Messages() as said:
        surface = case.read(folder)
        surface.UpdatePipeline()
        if surface.GetDataInformation().GetNumberOfCells() == 0:
            why = reason(said.texts())
            return Result(ERROR if why else CRASH, 0, 0, "", why or "nothing read, and no reason")
        mesher = simple.CartesianMesher(Input=surface, NumberOfThreads=1, **properties_of(case, surface))
        begin = time.process_time()
        mesher.UpdatePipeline()
        seconds = time.process_time() - begin
        messages = said.texts()
        cells = mesher.GetDataInformation().GetNumberOfCells()
        if cells == 0:
            why = reason(messages) if mesher.SMProxy.GetClientSideObject().GetErrorCode() else ""
            return Result(ERROR if why else CRASH, seconds, 0, "", why or "no mesh, and no reason")
        try:
            foam.save(simple.OutputPort(mesher, "Mesh"), folder)
        except AssertionError:
            return Result(CRASH, seconds, cells, "", reason(said.texts()[len(messages):]) or "not written")
    faults = faults_of(folder)
    return Result(REFUSED if faults else OK, seconds, cells, told(mesher, messages), "; ".join(faults))


def told(mesher, messages):
    """How many cells the mesher says that checkMesh refuses, and where it says so."""
    fields = mesher.SMProxy.GetClientSideObject().GetOutputDataObject(2).GetFieldData()
    listed = fields.GetArray("FailingCells")
    count = int(listed.GetValue(0)) if listed else 0
    warned = any(WARNED in text for text in messages)
    return " and ".join([f"{count} cells in Defects"] * (count > 0) + ["a message"] * warned)


# ---- A process for it

def run(case, options):
    """A Result, whatever happens to the process."""
    folder = pathlib.Path(tempfile.mkdtemp(dir=options.folder))
    begin = resource.getrusage(resource.RUSAGE_CHILDREN)
    readable, writable = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(readable)
        in_child(case, folder, writable)
    os.close(writable)
    try:
        text = wait_for(readable, options.limit)
    finally:
        stop(child)
        os.close(readable)
        if options.keep:
            shutil.copytree(folder, options.keep / re.sub(r"\W+", "_", key(case)), dirs_exist_ok=True)
        shutil.rmtree(folder)
    if text:
        return Result(*json.loads(text))
    end = resource.getrusage(resource.RUSAGE_CHILDREN)
    return Result(CRASH, end.ru_utime - begin.ru_utime, 0, "", "the process died" if text == b"" else
                  f"took more than {options.limit:g} seconds")


def in_child(case, folder, writable):
    """Never returns."""
    os.setsid()  # so that checkMesh ends with it
    try:
        result = mesh(case, folder)
    except Exception as error:  # of whatever kind: of this case alone
        traceback.print_exc()
        result = Result(CRASH, time.process_time(), 0, "", f"{type(error).__name__}: {error}"[:300])
    os.write(writable, json.dumps(result).encode())
    os._exit(0)


def wait_for(readable, limit):
    """What the child writes: nothing if it dies, None if it takes too long."""
    found, _, _ = select.select([readable], [], [], limit)
    if not found:
        return None
    parts = iter(lambda: os.read(readable, 1 << 16), b"")
    return b"".join(parts)


def stop(child):
    try:
        os.killpg(child, signal.SIGKILL)
    except ProcessLookupError:
        pass
    os.waitpid(child, 0)


# ---- Results

def commit_of(folder):
    """The last one of the sources of the plugin in this folder; with + if they have changed since."""
    def git(*words):
        return subprocess.run(["git", "-C", folder, *words, "--", ":/Filters", ":/Plugin"], check=True, capture_output=True,
                              text=True).stdout.strip()
    try:
        return git("log", "-1", "--format=%h") + ("+" if git("status", "--porcelain") else "")
    except (OSError, subprocess.CalledProcessError):
        return "unknown+"


class Results:
    """Of this commit, by case; kept in a file, if there is one."""

    def __init__(self, path, commit):
        self.path, self.commit, self.found = path, commit, {}
        if path and path.exists() and not commit.endswith("+"):
            for line in path.read_text(encoding="utf-8").splitlines()[1:]:
                row = dict(zip(COLUMNS, line.split("\t")))
                if row["commit"] == commit and set(row) == set(COLUMNS):
                    self.found[row["case"]] = Result(*(row[name] for name in Result._fields))

    def add(self, name, result):
        result = Result(result.verdict, f"{result.seconds:.2f}", str(result.cells), result.told,
                        " ".join(result.faults.split()))
        self.found[name] = result
        if self.path:
            isNew = not self.path.exists()
            with open(self.path, "a", encoding="utf-8") as file:
                file.write(("\t".join(COLUMNS) + "\n" if isNew else "") + "\t".join([self.commit, name, *result]) + "\n")


def print_line(name, result):
    told_so = f"told: {result.told}" if result.told else "not told" if result.verdict == REFUSED else ""
    print(f"{result.verdict:8}{float(result.seconds):7.1f} s{int(result.cells):9}  {name:55}  "
          f"{'; '.join(text for text in (told_so, result.faults) if text)}".rstrip(), flush=True)


def print_sums(cases, results):
    """Of kinds, and the cases that have no good mesh; whether few enough are refused."""
    print(f"\n{'kind':10}{'cases':>7}" + "".join(f"{verdict:>9}" for verdict in VERDICTS) + f"{'CPU':>10}")
    found = [(case.kind, results.found[key(case)]) for case in cases]
    for kind in [*dict.fromkeys(kind for kind, _ in found), "all"]:
        own = [result for of, result in found if kind in (of, "all")]
        counts = collections.Counter(result.verdict for result in own)
        print(f"{kind:10}{len(own):7}" + "".join(f"{counts[verdict]:9}" for verdict in VERDICTS) +
              f"{sum(float(result.seconds) for result in own):8.0f} s")
    for verdict in ERROR, CRASH, REFUSED:
        print(f"\n{verdict}:")
        for case in cases:
            if results.found[key(case)].verdict == verdict:
                print_line(key(case), results.found[key(case)])
    untold = sum(result.verdict == REFUSED and not result.told for _, result in found)
    refused, meshed = counts[REFUSED] + counts[CRASH], len(found) - counts[ERROR]
    print(f"\n{refused} of {meshed} refused or crashed; at most 1 in {ACCEPTED} may be. Not told by the mesher: {untold}")
    return refused * ACCEPTED <= meshed


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--surfaces", type=pathlib.Path, nargs="+", default=[], metavar="FOLDER")
    parser.add_argument("--only", type=re.compile, default=re.compile(""), metavar="PATTERN")
    parser.add_argument("--sample", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--results", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--limit", type=float, default=900, metavar="SECONDS")
    options = parser.parse_args()
    if not hasattr(simple, "CartesianMesher"):
        parser.error("set PV_PLUGIN_PATH to the folder of the plugin")
    plugin = pathlib.Path(os.environ["PV_PLUGIN_PATH"].split(os.pathsep)[0]).resolve()
    options.build = next((folder for folder in plugin.parents if (folder / "CMakeCache.txt").exists()), plugin)
    if not options.sample and not options.results:
        options.results = options.build / "valid.tsv"
    return options


def main():
    options = arguments()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("stopped"))
    with tempfile.TemporaryDirectory() as temporary:
        options.folder = pathlib.Path(temporary)
        cases = [case for case in validcases.all_cases(options)
                 if options.only.search(key(case)) and (case.isSample or not options.sample)]
        if options.list:
            print(*map(key, cases), sep="\n")
            return 0
        results = Results(options.results, commit_of(options.build))
        for case in cases:
            if key(case) not in results.found:
                results.add(key(case), run(case, options))
                print_line(key(case), results.found[key(case)])
        return 0 if print_sums(cases, results) else 1


if __name__ == "__main__":
    sys.exit(main())
