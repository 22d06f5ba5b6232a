"""OpenFOAM cases: saving a mesh as one, running programs in it, reading what they find."""

import os
import pathlib
import re
import subprocess

from paraview import simple

# Debian's package keeps its configuration here; the programs ask for nothing else.
ENVIRONMENT = dict(os.environ, WM_PROJECT_DIR="/usr/share/openfoam", FOAM_SIGFPE="true")

FIGURES = {
    "cells": r"^ +cells: +(\S+)",
    "non-orthogonality": r"non-orthogonality Max: (\S+)",
    "skewness": r"[Mm]ax skewness = ([^\s,]+)",
    "determinant": r"determinant.* (?:minimum|min)\w*: ([^\s,]+)",
    "weight": r"interpolation weight.* minimum: ([^\s,]+)",
    "volume ratio": r"[Ff]ace volume ratio.* minimum: ([^\s,]+)",
    "smallest volume": r"[Mm]in(?:imum)? volume\S* = ([^\s,]+)",
}


def save(proxy, folder, **properties):
    """Writes the case; a mesh of an earlier case there is replaced."""
    folder = pathlib.Path(folder)
    simple.SaveData(str(folder / "case.foam"), proxy, **properties)
    return folder


def run(folder, *command):
    """What the program prints; an error if it fails."""
    done = subprocess.run(command, cwd=folder, env=ENVIRONMENT, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, f"{' '.join(command)} failed:\n{done.stdout[-3000:]}"
    return done.stdout


class CheckMesh:
    """checkMesh's verdict: `ok`, `failures` (its lines with three stars) and `figures` by name."""

    def __init__(self, folder, *options):
        self.text = run(folder, "checkMesh", *options)
        self.ok = "\nMesh OK." in self.text
        self.failures = re.findall(r"^ *\*\*\*(.*)$", self.text, re.MULTILINE)
        self.figures = {}
        for name, pattern in FIGURES.items():
            found = re.search(pattern, self.text, re.MULTILINE)
            if found:
                self.figures[name] = float(found[1].rstrip("."))


def dictionary(name, text, kind="dictionary"):
    """A file that OpenFOAM reads."""
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n{text}\n"


def write(folder, path, text, kind="dictionary"):
    path = pathlib.Path(folder) / path
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(dictionary(path.name, text, kind))
