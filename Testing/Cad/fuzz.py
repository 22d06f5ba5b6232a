"""fuzz.py PROGRAM FOLDER COUNT SEED [KEEP]: runs PROGRAM FILE on COUNT damaged copies of the CAD files in FOLDER.

Prints how many were read, refused, crashed or took too long, by kind of damage, and keeps the files of the latter
two in the folder KEEP. PROGRAM may be several words; "{}" stands for the file.
"""
import collections
import concurrent.futures
import os
import resource
import shlex
import subprocess
import sys
import tempfile

import mutants

SECONDS = 20
BYTES = 4 << 30


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def outcome(program, path):
    """How it ended, and the last that it said."""
    words = shlex.split(program)
    words = [word.replace("{}", path) for word in words] if "{}" in program else words + [path]
    try:
        done = subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=SECONDS,
                              preexec_fn=limit, check=False)
    except subprocess.TimeoutExpired as late:
        return "too long", last_line(late.stderr)
    if done.returncode < 0:
        return f"signal {-done.returncode}", last_line(done.stderr)
    return ("read" if done.returncode == 0 else "refused"), last_line(done.stderr)


def last_line(said):
    lines = (said or b"").decode(errors="replace").strip().splitlines()
    return lines[-1] if lines else ""


def one(program, paths, seed, number, keep):
    name, content = mutants.mutant(paths, seed, number)
    path = os.path.join(keep, name)
    with open(path, "wb") as stream:
        stream.write(content)
    how, said = outcome(program, path)
    if how in ("read", "refused"):
        os.remove(path)
    return name, how, said


def main(program, folder, count, seed, keep=None):
    keep = keep or tempfile.mkdtemp()
    os.makedirs(keep, exist_ok=True)
    paths = mutants.sources(folder.split(os.pathsep))
    totals, kinds, messages = collections.Counter(), collections.Counter(), collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = pool.map(lambda number: one(program, paths, int(seed), number, keep), range(int(count)))
        for name, how, said in results:
            totals[how] += 1
            kinds[how, name.split(".")[1]] += 1
            if how not in ("read", "refused"):
                print(f"{how}: {name}: {said}", flush=True)
            elif how == "refused":
                messages[said[:70]] += 1
    for (how, kind), number in sorted(kinds.items()):
        print(f"{how:12} {kind:18} {number}")
    for said, number in messages.most_common(20):
        print(f"{number:6} refused: {said}")
    print(dict(totals), "kept in", keep)


if __name__ == "__main__":
    main(*sys.argv[1:])
