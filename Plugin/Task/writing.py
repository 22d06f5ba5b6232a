"""Writes files so that whenever the program is killed, each is either entirely old or entirely new:
new ones are written beside, and take the name at once. Where one file names many, as .pvtu does, those of
the new one are in a folder that the old one does not name."""

import contextlib
import os
import re
import shutil

from cartesianmesher.vtkCartesianMesherFilters import vtkPolyMeshWriter
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonMisc import vtkErrorCode
from vtkmodules.vtkIOParallelXML import vtkXMLPPolyDataWriter, vtkXMLPUnstructuredGridWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

# Of the ports of Cartesian Mesher: the mesh, its boundary, the defects of its surface, which no piece has.
WRITERS = ({".vtu": vtkXMLUnstructuredGridWriter}, {".vtp": vtkXMLPolyDataWriter},
           {".vtp": vtkXMLPolyDataWriter})
PIECE_WRITERS = ({".pvtu": vtkXMLPUnstructuredGridWriter}, {".pvtp": vtkXMLPPolyDataWriter}, {})
# File extensions of VTK.
END = b"</VTKFile>\n"
# A case is a folder of files, which its writer swaps itself.
CASE = ".foam"


class NotWritten(Exception):
    """Why a file could not be written."""


@contextlib.contextmanager
def failures():
    """Turns errors of VTK and of the system into one exception."""
    said = []
    def hear(window, event, text):
        said.append(text.partition("): ")[2].partition("\n")[0] or text)
    hear.CallDataType = "string0"
    window = vtkOutputWindow.GetInstance()
    observer = window.AddObserver("ErrorEvent", hear)
    try:
        yield
    except OSError as error:
        raise NotWritten(f"could not be written: {error.strerror}") from None
    finally:
        window.RemoveObserver(observer)
    if said:
        # The pipeline only says that an algorithm failed.
        why = next((f": {text}" for text in said if not text.startswith("Algorithm ")), "")
        raise NotWritten("could not be written" + why)


def created(folder):
    with failures():
        folder.mkdir(parents=True, exist_ok=True)


@contextlib.contextmanager
def replacing(file):
    """The name to write to; the result replaces `file`, after everything that a writer has put beside it."""
    with failures():
        target = file.resolve()
        if target.exists() and not target.is_file():  # a device
            yield target
            return
        folder = target.with_name(f".{target.name}.new")
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        try:
            new = folder / file.name
            with failures():
                yield new
            for path in sorted(folder.iterdir(), key=lambda path: path == new):
                if path.is_dir():
                    shutil.rmtree(target.with_name(path.name), ignore_errors=True)
                os.replace(path, target if path == new else target.with_name(path.name))
        finally:
            shutil.rmtree(folder, ignore_errors=True)


@contextlib.contextmanager
def replacing_pieces(file):
    """The same for a file that names pieces; the given call removes them again. What the mesher says while it makes them is no
    failure: Python's stderr goes the way of VTK's errors."""
    with failures():
        target = file.resolve()
        if target.exists() and not target.is_file():
            raise NotWritten("is not a file that can be replaced")
        old = target.read_text(errors="replace") if target.is_file() else ""
        # ParaView takes what follows the first dot of a name for its extension.
        stem = f"{target.stem}_{file.suffix[1:]}".replace(".", "_")
        folders = [target.with_name(f"{stem}{n}") for n in (1, 2)]
        if f"{folders[0].name}/" in old:
            folders.reverse()
        new = folders[0].with_name(folders[0].name + file.suffix)
        shutil.rmtree(folders[0], ignore_errors=True)
    try:
        yield new
        with failures():
            os.replace(new, target)
    except BaseException:
        new.unlink(missing_ok=True)
        shutil.rmtree(folders[0], ignore_errors=True)
        raise
    shutil.rmtree(folders[1], ignore_errors=True)


@contextlib.contextmanager
def case_pieces(file, pieces, properties):
    """The writer of a decomposed case, which takes the pieces one by one and keeps them until the last."""
    # simple.CreateWriter would make all of the mesh first.
    writer = servermanager.writers.OpenFOAMMeshWriter()
    for name, value in ({"FileName": str(file.absolute())} | of_pieces(pieces) | properties).items():
        setattr(writer, name, value)
    writer.UpdateVTKObjects()
    yield writer.SMProxy.GetClientSideObject()


def of_pieces(pieces):
    """Properties of a case's writer."""
    return {"Pieces": pieces} if pieces > 1 else {}


def write_text(file, text):
    with replacing(file) as new:
        new.write_text(text, encoding="utf-8")


def write_whole(data, port, file):
    """On any number of ranks one file: the first rank has the whole mesh."""
    with replacing(file) as new:
        writer = WRITERS[port][file.suffix]()
        make_safe(writer, data)
        writer.SetFileName(str(new))
        # ParaView 5.11 on Debian 12 can't read back appended data, the default.
        writer.SetDataModeToBinary()
        writer.SetInputDataObject(data)
        run(writer)


def make_safe(writer, data):
    """When a device is full, writers of VTK 9.2 free arrays that only writing appended data has made: after a first such
    write, of nothing, there are none."""
    writer.SetInputDataObject(data.NewInstance())
    writer.WriteToOutputStringOn()
    writer.Write()
    writer.WriteToOutputStringOff()


def write_piece(data, port, file, piece, pieces):
    """Of several files, and the one that names them all; or of a case, by its writer."""
    if isinstance(file, vtkPolyMeshWriter):
        with failures():
            file.WritePiece(data, piece)
        return
    writer = PIECE_WRITERS[port][file.suffix]()
    writer.SetFileName(str(file))
    writer.SetDataModeToBinary()
    writer.SetUseSubdirectory(True)
    writer.SetNumberOfPieces(pieces)
    writer.SetStartPiece(piece)
    writer.SetEndPiece(piece)
    writer.SetWriteSummaryFile(piece == 0)
    writer.SetInputDataObject(data)
    run(writer)


def run(writer):
    try:
        with failures():
            writer.Write()
    except NotWritten:
        code = writer.GetErrorCode()
        if code == vtkErrorCode.NoError:
            raise
        # It says more than the pipeline.
        raise NotWritten(f"could not be written: {vtkErrorCode.GetStringFromErrorCode(code)}") from None


def save(mesher, port, file, pieces, case):
    """By the writer that ParaView has for such files; a case in pieces, with these properties of its writer."""
    if file.suffix == CASE:
        with failures():
            save_as(mesher, port, file.absolute(), **of_pieces(pieces) | case)
        return
    if file.suffix not in PIECE_WRITERS[port]:
        with replacing(file) as new:
            save_as(mesher, port, new)
        return
    with replacing_pieces(file) as new, failures():
        save_as(mesher, port, new, DataMode="Binary")  # as in write_whole
        check_pieces(new, servermanager.OutputPort(mesher, port).GetDataInformation().GetNumberOfCells())


def check_pieces(file, cells):
    """Whether there are as many cells as all ranks have: this rank is not told of another's failure."""
    for piece in (file.parent / name for name in re.findall('Source="([^"]*)"', file.read_text())):
        with piece.open("rb") as text:
            head = next((line for line in text if b"<Piece " in line), b"")
            text.seek(max(0, text.seek(0, os.SEEK_END) - len(END)))
            whole = text.read().endswith(END)
        if not whole:
            raise NotWritten(f"could not be written: the rank of {piece.name} has failed, perhaps because the disk is full")
        cells -= sum(map(int, re.findall(rb'NumberOf(?:Cells|Verts|Lines|Strips|Polys)="(\d+)"', head)))
    if cells != 0:
        raise NotWritten("could not be written: a rank failed before it wrote its piece")


def save_as(mesher, port, file, **properties):
    try:
        simple.SaveData(str(file), proxy=servermanager.OutputPort(mesher, port), **properties)
    except AttributeError:  # ParaView's way to say that it has no writer
        raise NotWritten(f"ParaView has no writer for {file.suffix or 'no extension'}") from None
