"""Runs task files: what cartesian-mesher starts under pvpython or, within mpirun, under pvbatch."""

import argparse
import itertools
import json
import os
import pathlib
import signal
import sys
import time
import traceback

import cartesianmesher.vtkCartesianMesherFilters  # without it, filters show their base class only
from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOParallelXML import vtkXMLPPolyDataWriter, vtkXMLPUnstructuredGridWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from parameters import names, parameters
from task import MESHER, TaskError, read_task
from template import template

# Exit codes; FAULT is one of the program.
SUCCESS, FAULT, REFUSED, WARNINGS = 0, 1, 2, 3
STOPPED = 128 + signal.SIGINT

VTK_WRITERS = {".vtu": vtkXMLUnstructuredGridWriter, ".vtp": vtkXMLPolyDataWriter}
PIECE_WRITERS = {".pvtu": vtkXMLPUnstructuredGridWriter, ".pvtp": vtkXMLPPolyDataWriter}


class Listener:
    """Prints what a filter says while it works, and keeps it; stops it on Ctrl-C."""

    def __init__(self, filter, quiet):
        self.warnings, self.errors, self.stage, self.quiet = [], [], "", quiet
        self.interrupted = False
        self.algorithm = filter.SMProxy.GetClientSideObject()
        signal.signal(signal.SIGINT, self.interrupt)
        for event, hear in (("WarningEvent", self.warn), ("ErrorEvent", self.fail)):
            hear.__func__.CallDataType = "string0"
            self.algorithm.AddObserver(event, hear)
        self.algorithm.AddObserver("ProgressEvent", self.progress)

    def interrupt(self, *_):
        self.interrupted = True

    def warn(self, caller, event, text):
        self.keep("warning:", message(text), self.warnings)

    def fail(self, caller, event, text):
        self.keep("error:", message(text), self.errors)

    def keep(self, kind, text, texts):
        """Once, if several steps say the same; in one piece, as ranks write at the same time."""
        if text not in texts:
            texts.append(text)
            print(f"{kind} {text}", file=sys.stderr)

    def progress(self, algorithm, event):
        if self.interrupted:
            algorithm.SetAbortExecute(1)
        stage = algorithm.GetProgressText()
        if stage and stage != self.stage and not self.quiet:
            self.stage = stage
            print(f"{100 * algorithm.GetProgress():3.0f} %  {stage}", flush=True)


def message(text):
    """Without the place in the source and the object's address that VTK puts in front."""
    return text.partition("): ")[2].strip() or text.strip()


def surface(files):
    """A source of all files; several are blocks that have the files' names."""
    readers = [simple.OpenDataFile(str(file.resolve())) for file in files]
    for file, reader in zip(files, readers):
        if reader is None:
            raise TaskError(f"{file}: ParaView knows no reader for it")
    if len(readers) == 1:
        return readers[0]
    return simple.GroupDatasets(Input=readers, BlockNames=[file.stem for file in files])


def boundary_numbers(mesher):
    """{name: number} of the boundaries of the surface."""
    described = vtkDataObject()
    mesher.SMProxy.GetClientSideObject().DescribeBoundaries(described)
    numbers, texts = (described.GetFieldData().GetAbstractArray(name)
        for name in ("BoundaryIds", "BoundaryNames"))
    return {texts.GetValue(i): numbers.GetValue(i) for i in range(texts.GetNumberOfValues())} \
        if texts else {}


def set_properties(mesher, task):
    """Sets all but what names boundaries, looks those up, sets the rest."""
    named = {parameter.name: parameter for parameter in parameters(MESHER)
        if "boundary" in parameter.columns}
    for name, value in task.properties.items():
        if name not in named:
            setattr(mesher, name, value)
    numbers = None
    for name in set(named) & set(task.properties):
        values = list(task.properties[name])
        for i in range(named[name].columns.index("boundary"), len(values), named[name].count):
            if isinstance(values[i], str):
                numbers = boundary_numbers(mesher) if numbers is None else numbers
                if values[i] not in numbers:
                    raise TaskError(f"{task.path}: {named[name].table}.{named[name].key}: the surface "
                        f"has no boundary {values[i]!r}, only {', '.join(numbers) or 'unnamed ones'}")
                values[i] = numbers[values[i]]
        setattr(mesher, name, values)


def build(task):
    """The pipeline of a task, not yet run."""
    source = surface(task.surfaces)
    regions = [simple.RefinementRegion(Input=surface([region.file]) if region.file else source,
                   **({"Shape": "Input"} if region.file else {}) | region.properties)
        for region in task.regions]
    mesher = simple.CartesianMesher(Input=source, RefinementRegions=regions)
    set_properties(mesher, task)
    # One file of VTK's holds the whole mesh: then the first rank has to have it.
    if any(file.suffix in VTK_WRITERS for file in task.mesh + task.boundary):
        mesher.InPieces = 0
    return mesher


def write(mesher, task):
    for port, files in enumerate([task.mesh, task.boundary]):
        for file in files:
            file.parent.mkdir(parents=True, exist_ok=True)
            if file.suffix in VTK_WRITERS:
                write_whole(mesher, port, file)
            else:
                save(mesher, port, file)


def write_whole(mesher, port, file):
    """On any number of ranks one file: the first rank has the whole mesh."""
    writer = VTK_WRITERS[file.suffix]()
    writer.SetFileName(str(file))
    # ParaView 5.11 on Debian 12 can't read back appended data, the default.
    writer.SetDataModeToBinary()
    writer.SetInputDataObject(mesher.SMProxy.GetClientSideObject().GetOutputDataObject(port))
    if not writer.Write():
        raise TaskError(f"{file}: could not be written")


def save(mesher, port, file):
    try:
        simple.SaveData(str(file.resolve()), proxy=servermanager.OutputPort(mesher, port))
    except AttributeError:  # that is how ParaView says that it has no writer
        raise TaskError(f"{file}: ParaView has no writer for {file.suffix or 'no extension'}") from None
    if not file.exists():
        raise TaskError(f"{file}: could not be written")


def write_pieces(mesher, task, pieces):
    """Makes and writes one piece after the other; the fields of each."""
    Pipeline = vtkStreamingDemandDrivenPipeline
    algorithm = mesher.SMProxy.GetClientSideObject()
    fields = []
    for piece in range(pieces):
        for port in range(algorithm.GetNumberOfOutputPorts()):
            request = algorithm.GetOutputInformation(port)
            request.Set(Pipeline.UPDATE_PIECE_NUMBER(), piece)
            request.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), pieces)
            request.Set(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
        algorithm.UpdatePiece(piece, pieces, 0)
        fields.append(field_arrays(algorithm))
        if algorithm.GetErrorCode() != 0 and fields[-1].get("Cells", [0]) == [0]:
            break
        for port, files in enumerate([task.mesh, task.boundary]):
            for file in files:
                write_piece(algorithm.GetOutputDataObject(port), file, piece, pieces)
    return fields


def write_piece(data, file, piece, pieces):
    """Of several files, and the one that names them all."""
    file.parent.mkdir(parents=True, exist_ok=True)
    writer = PIECE_WRITERS[file.suffix]()
    writer.SetFileName(str(file))
    writer.SetDataModeToBinary()
    writer.SetNumberOfPieces(pieces)
    writer.SetStartPiece(piece)
    writer.SetEndPiece(piece)
    writer.SetWriteSummaryFile(piece == 0)
    writer.SetInputDataObject(data)
    if not writer.Write():
        raise TaskError(f"{file}: could not be written")


def pieces_needed(mesher, task):
    """In how many pieces to make the mesh, one after the other, to keep to the memory limit."""
    alone = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses() == 1
    files = task.mesh + task.boundary
    if not alone or not files or not all(file.suffix in PIECE_WRITERS for file in files):
        return 1
    return mesher.SMProxy.GetClientSideObject().EstimateNumberOfPieces()


def field_arrays(algorithm):
    """{name: numbers or names} of a mesh."""
    fields = algorithm.GetOutputDataObject(0).GetFieldData()
    return {array.GetName(): [array.GetValue(j) for j in range(array.GetNumberOfValues())]
        for array in (fields.GetAbstractArray(i) for i in range(fields.GetNumberOfArrays()))
        if array.GetNumberOfComponents() == 1}


def statistics(mesher, listener, seconds, fields):
    """What a mesh is like, for people and programs. `fields`: of each piece of it."""
    mesh, boundaries = {}, {}
    for arrays in fields:
        rows = [arrays.pop(name, []) for name in
            ("BoundaryIds", "BoundaryNames", "BoundaryFaceCounts", "BoundaryAreas")]
        types = arrays.pop("BoundaryTypes", [])
        for number, name, faces, area, type in itertools.zip_longest(*rows, types, fillvalue=""):
            row = boundaries.setdefault(number,
                {"number": number, "name": name, "type": type, "faces": 0, "area": 0})
            row["faces"] += faces
            row["area"] += area
        for name, values in arrays.items():
            if len(values) == 1:
                mesh[name] = mesh.get(name, 0) + values[0]
    return {
        "error_code": listener.algorithm.GetErrorCode(),
        "errors": listener.errors,
        "warnings": listener.warnings,
        "seconds": round(seconds, 3),
        "parameters": {name: mesher.GetProperty(name).GetData() for name in names(MESHER)},
        "mesh": {name: whole(value) for name, value in mesh.items()},
        "boundaries": [boundaries[number] for number in sorted(boundaries)],
    }


def whole(value):
    return int(value) if isinstance(value, float) and value.is_integer() else value


def report(summary):
    for name, value in summary["mesh"].items():
        print(f"{name:32} {value}")
    for row in summary["boundaries"]:
        print(f"boundary {row['number']:3}  {row['name']:24} {row['faces']:9} faces, area {row['area']:.9g}")


def run(task, quiet):
    """Meshes, writes, and returns the exit code."""
    begin = time.monotonic()
    mesher = build(task)
    listener = Listener(mesher, quiet)
    pieces = pieces_needed(mesher, task)
    if pieces > 1:
        fields = write_pieces(mesher, task, pieces)
    else:
        if pieces == 1:
            mesher.UpdatePipeline()
        fields = [field_arrays(listener.algorithm)]
    summary = statistics(mesher, listener, time.monotonic() - begin, fields)
    has_mesh = summary["mesh"].get("Cells", 0) > 0
    if has_mesh:
        if pieces == 1:
            write(mesher, task)
        if not quiet:
            report(summary)
    for file in task.statistics:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(summary, indent=2) + "\n")
    if listener.interrupted:
        return STOPPED
    return REFUSED if not has_mesh else WARNINGS if listener.warnings or listener.errors else SUCCESS


def check(task):
    """Says how large a mesh would be; returns the exit code."""
    mesher = build(task)
    listener = Listener(mesher, quiet=True)
    boxes = listener.algorithm.EstimateNumberOfBoxes()
    print(f"about {boxes:.3g} boxes, at refinement depth {mesher.RefinementDepth}")
    return REFUSED if boxes == 0 else WARNINGS if listener.warnings else SUCCESS


def main(arguments):
    parser = argparse.ArgumentParser(prog="cartesian-mesher",
        description="Meshes the inside of a closed surface as a task file says.",
        epilog="Exit codes: 0 success; 2 refused, the messages say why; 3 a mesh, but with warnings; "
            f"{STOPPED} stopped by Ctrl-C; 1 a fault of the program.")
    parser.add_argument("task", nargs="?", type=pathlib.Path, help="a task file (TOML)")
    parser.add_argument("--quiet", action="store_true", help="print warnings and errors only")
    parser.add_argument("--check", action="store_true", help="check task and surface and estimate the number of boxes, do not mesh")
    parser.add_argument("--template", action="store_true",
        help="print a task file with all keys, their defaults and what they mean")
    options = parser.parse_args(arguments)
    if options.template:
        print(template())
        return SUCCESS
    if options.task is None:
        parser.error("a task file is missing")
    try:
        task = read_task(options.task)
        return check(task) if options.check else run(task, options.quiet)
    except TaskError as error:
        print(f"error: {error}", file=sys.stderr)
        return REFUSED


def leave(code):
    """Exits; within mpirun, where all ranks must end well, cartesian-mesher does so with the code."""
    if "CARTESIAN_MESHER_CODE" not in os.environ:
        sys.exit(code)
    if code != SUCCESS:
        pathlib.Path(os.environ["CARTESIAN_MESHER_CODE"]).write_text(str(code))


if __name__ == "__main__":
    try:
        code = main(sys.argv[1:])
    except SystemExit as ended:  # by argparse
        code = ended.code
    except Exception:
        traceback.print_exc()
        code = FAULT
    leave(code)
