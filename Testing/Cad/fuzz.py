"""fuzz.py PROGRAM FOLDER COUNT SEED [KEEP]: runs read-cad on COUNT damaged copies of the CAD files in FOLDER (several
folders: separated by colons).

Prints how many were read, refused with a message, crashed, took too long, or ended without saying why, by kind of damage,
and keeps the files of the latter three in the folder KEEP. CAD Reader makes clear errors of them all (TestDamaged).
"""
import collections
import concurrent.futures
import os
import resource
import struct
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
    """How it ended, and its message."""
    options = ["1", "0", "10", "0", "0", "1", "1", "0", "0"]  # in millimetres, glued, merged
    try:
        done = subprocess.run([program, path, *options], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              timeout=SECONDS, preexec_fn=limit, check=False)
    except subprocess.TimeoutExpired:
        return "too long", ""
    if done.returncode < 0:
        return f"signal {-done.returncode}", ""
    answer = records(done.stdout)
    if b"Z" in answer and b"S" in answer:
        return "read", ""
    return ("refused", text(answer[b"E"], path)) if b"E" in answer else ("silent", "")


def records(output):
    """The last of each kind (Filters/Cad/Stream.h)."""
    result, at = {}, 0
    while at + 9 <= len(output):
        size, = struct.unpack_from("=Q", output, at + 1)
        result[output[at:at + 1]] = output[at + 9:at + 9 + size]
        at += 9 + size
    return result


def text(record, path):
    return record[8:].decode(errors="replace").replace(path, "...")


def one(program, paths, seed, number, keep):
    name, content = mutants.mutant(paths, seed, number)
    path = os.path.join(keep, name)
    with open(path, "wb") as stream:
        stream.write(content)
    how, message = outcome(program, path)
    if how in ("read", "refused"):
        os.remove(path)
    return name, how, message


def main(program, folder, count, seed, keep=None):
    keep = keep or tempfile.mkdtemp()
    os.makedirs(keep, exist_ok=True)
    paths = mutants.sources(folder.split(":"))
    totals, kinds, messages = collections.Counter(), collections.Counter(), collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        results = pool.map(lambda number: one(program, paths, int(seed), number, keep), range(int(count)))
        for name, how, message in results:
            totals[how] += 1
            kinds[how, name.split(".")[1]] += 1
            if how not in ("read", "refused"):
                print(f"{how}: {name}", flush=True)
            elif how == "refused":
                messages[message[:100]] += 1
    for (how, kind), number in sorted(kinds.items()):
        print(f"{how:12} {kind:18} {number}")
    for message, number in messages.most_common(20):
        print(f"{number:6} refused: {message}")
    print(dict(totals), "kept in", keep)


if __name__ == "__main__":
    main(*sys.argv[1:])
