"""A large decomposed case: two ranks write it, OpenFOAM accepts it and solves on it as on the whole mesh, and puts the pieces
together to that; a rank has at most 0.6 of the memory that one alone has. On demand, as 5 million cells (0.8) take an hour;
that much less memory a rank has from about there on:

    pvpython Testing/Plugin/large.py REPOSITORY COMMAND FOLDER [CELL_SIZE]
"""

import os
import pathlib
import resource
import sys
import time

import numpy as np

import decomposed
import foam
from ducts import prepare

SOLVER = "solvers { Phi { solver GAMG; smoother DIC; tolerance 1e-12; relTol 0; } }\n" \
         "potentialFlow { nNonOrthogonalCorrectors 3; }"


def timed(what, work):
    begin = time.time()
    result = work()
    print(f"{what}: {time.time() - begin:.0f} s", flush=True)
    return result


def peak(folder, *command):
    """Gigabytes that the largest process had."""
    child = os.fork()
    if child == 0:
        foam.run(folder, *command)
        os._exit(0)
    _, status, _ = os.wait4(child, 0)
    assert status == 0, command
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1e6


def mesh(folder, name, command, size, *options):
    """The case, and the memory of the largest process."""
    (folder / f"{name}.toml").write_text(
        f'[surface]\nfile = "{pathlib.Path(sys.argv[1]).resolve()}/Data/kcl_exhaust_header_lumens.stl"\n'
        f'[grid]\ncell_size = {size}\n[output]\nmesh = "{name}/case.foam"\n' + "\n".join(options))
    memory = timed(name, lambda: peak(folder, *command, f"{name}.toml"))
    print(f"{name}: {memory:.2f} GB", flush=True)
    return folder / name, memory


def compare_flows(case, whole):
    """Of potentialFoam, face by face."""
    for folder, pieces in (case, 2), (whole, 1):
        prepare(folder, pieces)
        foam.write(folder, "system/fvSolution", SOLVER)
    timed("potentialFoam", lambda: foam.run(whole, "potentialFoam", "-writephi"))
    timed("potentialFoam -parallel", lambda: foam.run_parallel(case, 2, "potentialFoam", "-writephi"))
    alone = foam.read_field(whole, 0, "phi")
    worst = 0
    for number in range(2):
        piece = decomposed.Piece(case, number)
        flux = foam.read_field(case / f"processor{number}", 0, "phi")
        worst = max(worst, np.abs(flux - alone[piece.faces[:len(flux)]]).max())
    worst /= np.abs(alone).max()
    print(f"largest difference of fluxes: {worst:.1e} of the largest", flush=True)
    assert worst < 1e-6


if __name__ == "__main__":
    command, folder = sys.argv[2], pathlib.Path(sys.argv[3])
    size = float(sys.argv[4]) if len(sys.argv) > 4 else 0.8
    folder.mkdir(parents=True, exist_ok=True)
    # The smaller one first: what is measured is the largest so far.
    case, of_rank = mesh(folder, "ranks", [*foam.MPIRUN, "--bind-to", "none", "-n", "2", command, "--quiet"], size, "pieces = 2")
    whole, alone = mesh(folder, "whole", [command, "--quiet"], size)
    files = foam.Files(whole)
    print(f"{files.cells} cells, memory of a rank {of_rank / alone:.2f}", flush=True)
    text = timed("checkMesh -parallel", lambda: foam.run_parallel(case, 2, "checkMesh"))
    assert "\nMesh OK." in text and "Coupled point location match (average 0) OK" in text, text
    compare_flows(case, whole)
    timed("reconstructParMesh", lambda: foam.run(case, "reconstructParMesh", "-constant", "-mergeTol", "1e-9"))
    again = foam.Files(case)
    assert again.cells == files.cells and len(again.points) == len(files.points) and len(again.owner) == len(files.owner)
    assert abs(again.volumes().sum() / files.volumes().sum() - 1) < 1e-12
    assert of_rank < 0.6 * alone or files.cells < 4e6, "memory"
