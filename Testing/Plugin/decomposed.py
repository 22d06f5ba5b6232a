"""Decomposed OpenFOAM cases, compared with the whole mesh face by face."""

import pathlib

import numpy as np

import foam


def addressing(files, name):
    return files.lists(name + "ProcAddressing", np.int32)[0]


def corners(files, face):
    return files.faces.corners[files.faces.start[face]:files.faces.start[face + 1]]


class Piece:
    """One folder processorN, and what its addressing says."""

    def __init__(self, case, number, region=""):
        self.number = number
        self.files = foam.Files(pathlib.Path(case) / f"processor{number}", region)
        self.points, self.cells, self.patches, labels = (
            addressing(self.files, name) for name in ("point", "cell", "boundary", "face"))
        assert (labels != 0).all()
        self.turned = labels < 0
        self.faces = np.abs(labels) - 1

    def compare(self, whole):
        """All of the piece is in the whole mesh, where the addressing says."""
        files = self.files
        assert np.array_equal(files.points, whole.points[self.points])
        assert len(self.faces) == len(files.owner) and len(self.cells) == files.cells
        inner = len(files.neighbour)
        assert not self.turned[:inner].any()
        assert np.array_equal(self.cells[files.neighbour], whole.neighbour[self.faces[:inner]])
        owners = np.where(self.turned, np.append(whole.neighbour, np.zeros_like(whole.owner))[self.faces],
                          whole.owner[self.faces])
        assert np.array_equal(self.cells[files.owner], owners)
        for face, (number, turned) in enumerate(zip(self.faces, self.turned)):
            mine, theirs = self.points[corners(files, face)], corners(whole, number)
            expected = np.concatenate([theirs[:1], theirs[:0:-1]]) if turned else theirs
            assert np.array_equal(mine, expected), (face, mine, theirs)

    def shared(self):
        """{other piece: the numbers of the faces in common, negative ones turned}."""
        result = {}
        for name, (kind, start, count) in self.files.patches.items():
            if kind == "processor":
                mine, other = (int(x) for x in name[len("procBoundary"):].split("to"))
                assert mine == self.number and count > 0
                result[other] = self.faces[start:start + count], self.turned[start:start + count]
        return result


def check(case, whole, count, region=""):
    """The pieces are the whole mesh, and patches between them are alike from both sides."""
    pieces = [Piece(case, n, region) for n in range(count)]
    assert not (pathlib.Path(case) / f"processor{count}").exists()
    for piece in pieces:
        piece.files.check()
        piece.compare(whole)
        names = [name for name, (kind, *_) in piece.files.patches.items() if kind != "processor"]
        assert names == list(whole.patches), names
        expected = [*range(len(names)), *[-1] * (len(piece.files.patches) - len(names))]
        assert piece.patches.tolist() == expected
        for name in names:
            faces = piece.faces[piece.files.of_patch(name)]
            of_whole = whole.of_patch(name)
            assert ((of_whole.start <= faces) & (faces < of_whole.stop)).all(), name
            assert piece.files.patches[name][0] == whole.patches[name][0]
        for other, (faces, turned) in piece.shared().items():
            theirs, turned_there = pieces[other].shared()[piece.number]
            assert np.array_equal(faces, theirs) and (np.diff(faces) > 0).all()
            assert (turned == (other < piece.number)).all() and (turned_there != turned).all()
    cells = np.concatenate([piece.cells for piece in pieces])
    assert np.array_equal(np.sort(cells), np.arange(whole.cells))
    assert np.array_equal(np.unique(np.concatenate([piece.points for piece in pieces])),
                          np.arange(len(whole.points)))
    times = np.bincount(np.concatenate([piece.faces for piece in pieces]), minlength=len(whole.owner))
    shared = np.zeros(len(whole.owner), bool)
    for piece in pieces:
        for faces, _ in piece.shared().values():
            shared[faces] = True
    assert (times == 1 + shared).all()
    assert shared.any() and not shared[len(whole.neighbour):].any()
    return pieces
