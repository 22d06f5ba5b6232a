# SPDX-License-Identifier: BSD-3-Clause
"""Writes the guide's page validation.md from results: pvpython page.py RESULTS PAGE."""

import datetime
import json
import pathlib
import subprocess
import sys

HEAD = """# Validation

What a solver gets from these meshes, beside snappyHexMesh's of the same boxes, against references that are not ours. `Testing/Validation/run.sh`
makes this page; each row is one mesh, with default options. Commit {commit}, {date}; {minutes:.0f} minutes of one core for meshes and
solvers. Errors are relative, 0.01 is 1 %, and of all walls without layers. Meshes are also made of the geometry turned, and with the grid moved by a third of a box: a mesher must not care where its grid lies.
"""


def shown(value):
    return str(value) if isinstance(value, int) else f"{value:.2g}"


def table(case):
    figures = list(case["rows"][0]["figures"])
    yield f"## {case['title']}\n\n{case['text']}\n"
    yield "| Mesh | Box | Geometry | Cells | " + " | ".join(figures) + " |"
    yield "|---|---|---|---|" + "---|" * len(figures)
    for row in sorted(case["rows"], key=lambda row: (row["variant"] != "as it is", row["variant"], -row["size"], row["mesher"])):
        yield (f"| {row['mesher']} | {row['size']:.3g} | {row['variant']} | {row['cells']:,} | "
               + " | ".join(shown(row["figures"][figure]) for figure in figures) + " |")
    yield ""


def page(results, folder):
    cases = [json.loads(path.read_text()) for path in sorted(results.glob("*.json"))]
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=folder, capture_output=True, text=True, check=True).stdout.strip()
    minutes = sum(row["seconds"] for case in cases for row in case["rows"]) / 60
    return "\n".join([HEAD.format(commit=commit, date=datetime.date.today(),
        minutes=minutes), *(line for case in cases for line in table(case))])


if __name__ == "__main__":
    results, target = map(pathlib.Path, sys.argv[1:3])
    target.write_text(page(results, target.resolve().parent).rstrip() + "\n")
