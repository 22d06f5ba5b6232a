"""Runs task files: started by cartesian-mesher under pvpython or, within mpirun, under pvbatch."""

import signal

# Python's own handler raises exceptions amid the imports below, which VTK does not survive. Until a filter
# listens, Ctrl-C ends the program at once; cartesian-mesher has kept it off up to here.
signal.signal(signal.SIGINT, signal.SIG_DFL)
signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})

import argparse
import contextlib
import itertools
import json
import os
import pathlib
import sys
import time
import traceback

import cartesianmesher.vtkCartesianMesherFilters  # without it, filters show their base class only
from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import writing
from parameters import names, parameters
from task import CAD_READER, MESHER, TaskError, printable, read_task
from template import template

VERSION = (pathlib.Path(__file__).parent / "version.txt").read_text().strip()

# Exit codes; FAULT is an internal error.
SUCCESS, FAULT, REFUSED, WARNINGS = 0, 1, 2, 3
STOPPED = 128 + signal.SIGINT


class Listener:
    """Prints and keeps a filter's messages while it works; stops it on Ctrl-C."""

    def __init__(self, filter, quiet, warnings=()):
        self.warnings, self.errors, self.stage, self.quiet = [*warnings], [], "", quiet
        self.interrupted, self.error_code = False, 0
        self.algorithm = filter.SMProxy.GetClientSideObject()
        signal.signal(signal.SIGINT, self.interrupt)
        for hear in self.warn, self.fail:
            hear.__func__.CallDataType = "string0"
        self.observers = [self.algorithm.AddObserver(event, hear) for event, hear in
            (("WarningEvent", self.warn), ("ErrorEvent", self.fail), ("ProgressEvent", self.progress))]

    def end(self):
        for observer in self.observers:
            self.algorithm.RemoveObserver(observer)
        signal.signal(signal.SIGINT, signal.SIG_DFL)

    def interrupt(self, *_):
        self.interrupted = True

    def warn(self, caller, event, text):
        self.keep("warning:", message(text), self.warnings)

    def fail(self, caller, event, text):
        self.keep("error:", message(text), self.errors)

    def keep(self, kind, text, texts):
        """Once, if several steps print the same; in one piece, as ranks write at the same time."""
        if text not in texts:
            texts.append(text)
            print(f"{kind} {printable(text)}", file=sys.stderr)

    def progress(self, algorithm, event):
        if self.interrupted:
            algorithm.SetAbortExecute(1)
        stage = algorithm.GetProgressText()
        if stage and stage != self.stage and not self.quiet:
            self.stage = stage
            print(f"{100 * algorithm.GetProgress():3.0f} %  {stage}", flush=True)


class ReadingListener(Listener):
    """Of a reader, whose errors are told with the line of the task that names the file."""

    def fail(self, caller, event, text):
        self.errors.append(message(text))


class ShapeListener(Listener):
    """Of a filter after the mesher: adds to the mesher's messages, with the line of the task that has the filter's table."""

    def __init__(self, filter, task, where, mesher):
        super().__init__(filter, mesher.quiet)
        self.task, self.where, self.mesher, self.failed = task, where, mesher, False
        self.warnings, self.errors = mesher.warnings, mesher.errors

    def fail(self, caller, event, text):
        self.failed = True
        super().fail(caller, event, text)

    def keep(self, kind, text, texts):
        super().keep(kind, *self.task.error(self.where, text).args, texts)

    def end(self):
        super().end()
        self.mesher.interrupted |= self.interrupted
        signal.signal(signal.SIGINT, self.mesher.interrupt)


def message(text):
    """Without the place in the source and the object's address that VTK puts in front."""
    return text.partition("): ")[2].strip() or text.strip()


# What surfaces can be: data of a class, or of one derived from it.
SURFACES = "vtkPolyData", "vtkMultiBlockDataSet", "vtkPartitionedDataSet", "vtkPartitionedDataSetCollection"


class Files:
    """Opens the files that a task names."""

    def __init__(self, task, quiet):
        self.task, self.quiet, self.warnings = task, quiet, []

    def opened(self, file, where, kinds=SURFACES):
        """The source of a surface, or of other data, in a file; `where`: it is named in the task."""
        try:
            reader = simple.OpenDataFile(str(file.resolve()))
        except RuntimeError:  # ParaView's way to say that no reader accepts the file
            reader = None
        if reader is None:
            raise self.task.error(where, f"ParaView cannot read {file}: it is damaged, or of an unknown type; "
                "open it in ParaView to see why, or save it as STL")
        kind = reader.SMProxy.GetOutputPort(0).GetDataClassName()
        if kinds and kind not in kinds:
            raise self.task.error(where, f"{file} is not a surface: ParaView reads it as {kind}")
        if reader.SMProxy.GetXMLName() == CAD_READER:
            self.read_cad(reader, where)
        return reader

    def read_cad(self, reader, where):
        """At once: that may take long, and the reader says what is wrong with the file."""
        for name, value in self.task.cad.items():
            setattr(reader, name, value)
        listener = ReadingListener(reader, self.quiet, self.warnings)
        reader.UpdatePipeline()
        listener.end()
        if listener.interrupted:
            raise KeyboardInterrupt
        if listener.errors:
            raise self.task.error(where, listener.errors[0])
        self.warnings = listener.warnings

    def surface(self, files, *where, names=()):
        """A source of all files: of one as it is, or of blocks with these names."""
        readers = [self.opened(file, where) for file in files]
        return simple.GroupDatasets(Input=readers, BlockNames=names) if names else readers[0]


def boundary_numbers(mesher):
    """{name: number} of the boundaries of the surface."""
    described = vtkDataObject()
    mesher.SMProxy.GetClientSideObject().DescribeBoundaries(described)
    numbers, texts = (described.GetFieldData().GetAbstractArray(name)
        for name in ("BoundaryIds", "BoundaryNames"))
    return {texts.GetValue(i): numbers.GetValue(i) for i in range(texts.GetNumberOfValues())} \
        if texts else {}


def set_properties(mesher, task):
    """Sets all properties except those with names of boundaries, looks these up, sets the rest; errors of names that are not there."""
    named = {parameter.name: parameter for parameter in parameters(MESHER)
        if "boundary" in parameter.columns}
    for name, value in task.properties.items():
        if name not in named:
            setattr(mesher, name, value)
    numbers, errors = None, []
    for name in [name for name in named if name in task.properties]:
        values = list(task.properties[name])
        for i in range(named[name].columns.index("boundary"), len(values), named[name].count):
            if isinstance(values[i], str):
                numbers = boundary_numbers(mesher) if numbers is None else numbers
                if values[i] in numbers:
                    values[i] = numbers[values[i]]
                else:
                    errors.append(task.error((named[name].table, named[name].key), "the surface has no "
                        f"boundary {values[i]!r}, only {', '.join(numbers) or 'unnamed ones'}"))
        if not errors:
            setattr(mesher, name, values)
    return errors


def missing_inlet(mesher, task):
    """Why no case could be written for the solver: that is known before the mesh is made."""
    solver = task.case.get("SolverSetup", "None")
    cases = [file for file in task.mesh if file.suffix == writing.CASE]
    if task.case.get("RotationZones") or any(flow != "automatic" for flow in task.case.get("ConditionFlows", [])):  # that drive it
        return []
    if solver == "None" or not cases or task.properties.get("Domain") == "Outside":  # whose sides have an inlet
        return []
    if any(pair.get("Motion", "Translation") == "Translation" for pair in task.periodic):  # which drives the flow
        return []
    names = [*boundary_numbers(mesher), *task.properties.get("BoundaryMergedNames", [])]
    if any(name.startswith("inlet") for name in names):
        return []
    return [task.error(("case", "solver_setup"), f"no boundary is an inlet, as {solver} needs one, only "
        f"{', '.join(filter(None, names)) or 'unnamed ones'}: give one a name that begins with inlet, for example by merged_name in [[boundaries]]")]


def divided(task, source):
    """The surface, with the boundaries that Split Surface makes."""
    for properties in task.splits:
        source = simple.SplitSurface(Input=source, **properties)
    return source


def build(task, quiet):
    """The pipeline of a task, not yet run, and warnings about what it reads. Throws TaskError with all that is wrong."""
    files, errors = Files(task, quiet), []

    def read(action):
        try:
            return action()
        except TaskError as error:
            errors.append(error)

    source = read(lambda: divided(task, files.surface(task.surfaces, "surface", "file", names=task.names)))
    zones = [read(lambda: files.surface([region.file], "regions", i, "file")) if region.file else source
        for i, region in enumerate(task.regions)]
    size_field = task.size_field and read(lambda: files.opened(task.size_field, ("refinement", "size_field"), kinds=()))
    if not errors:
        if task.regions:
            source.UpdatePipeline()  # whose size is that of zones by default
        mesher = simple.CartesianMesher(Input=source, RefinementRegions=[
            simple.RefinementRegion(Input=zone, **({"Shape": "Input"} if region.file else {}) | region.properties)
            for zone, region in zip(zones, task.regions)])
        if size_field:
            mesher.SizeField = size_field
        errors = set_properties(mesher, task) + missing_inlet(mesher, task)
    if errors:
        raise TaskError(*(text for error in errors for text in error.args))
    if is_shaped(task) and vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses() > 1:
        raise task.error(first_shape(task), "needs the mesh in one piece: start the program without mpirun")
    # A VTK file holds the whole mesh: then the first rank must have it.
    if any(file.suffix in writing.WRITERS[port] for _, port, file in files_of(task)):
        mesher.InPieces = 0
    return mesher, files.warnings


# Outputs of a task and the ports of Cartesian Mesher that they are of.
KINDS = {"mesh": 0, "boundary": 1, "defects": 2, "report": 0}


def files_of(task):
    """(kind, port, file) of all that is made of the mesher's outputs."""
    return [(kind, port, file) for kind, port in KINDS.items() for file in getattr(task, kind)]


@contextlib.contextmanager
def outputs_of(task, kind, file):
    """Names the key of an output that cannot be written."""
    try:
        yield
    except writing.NotWritten as error:
        raise task.error(("output", kind), f"{file}: {error}") from None


def create_folders(task):
    """Before the work, so that a run of hours does not end without a place for the mesh."""
    for kind in *KINDS, "statistics":
        for file in getattr(task, kind):
            with outputs_of(task, kind, file):
                writing.created(file.parent)


def is_shaped(task):
    """Whether the mesh to write is not the mesher's own."""
    return task.flat is not None or bool(task.periodic)


def first_shape(task):
    """Where the task has the first table of a filter after the mesher."""
    return ("flat",) if task.flat is not None else ("periodic", 0)


def shaped(mesher, task, listener):
    """The mesh to write: the mesher's, one cell across and with periodic boundaries if asked for; None if that failed."""
    steps = [(simple.FlatMesh, ("flat",), task.flat)] if task.flat is not None else []
    steps += [(simple.PeriodicBoundaries, ("periodic", i), pair) for i, pair in enumerate(task.periodic)]
    mesh = mesher
    for filter, where, properties in steps:
        mesh = filter(Input=mesh, **properties)
        own = ShapeListener(mesh, task, where, listener)
        mesh.UpdatePipeline()
        own.end()
        if own.failed or own.interrupted:
            listener.error_code = own.algorithm.GetErrorCode()
            return None
    return mesh


def write(mesher, mesh, task):
    """`mesh`: of the mesher, or of a filter after it."""
    for kind, port, file in files_of(task):
        source = mesh if kind == "mesh" else mesher
        with outputs_of(task, kind, file):
            if file.suffix in writing.WRITERS[port]:
                data = source.SMProxy.GetClientSideObject().GetOutputDataObject(port)
                writing.write_whole(data, port, file)
            else:
                writing.save(source, port, file, task.pieces, task.case)


def write_pieces(listener, task, pieces):
    """Makes and writes the pieces one by one; the fields of each, or of none if one failed."""
    fields = []
    with contextlib.suppress(NoMesh), contextlib.ExitStack() as stack:
        outputs = []
        for kind, port, file in files_of(task):
            stack.enter_context(outputs_of(task, kind, file))
            opened = writing.case_pieces(file, pieces, task.case) if file.suffix == writing.CASE \
                else writing.replacing_pieces(file)
            outputs.append((port, kind, stack.enter_context(opened)))
        for piece in range(pieces):
            make_piece(listener.algorithm, piece, pieces)
            if listener.errors or listener.interrupted:
                fields.clear()
                raise NoMesh
            fields.append(field_arrays(listener.algorithm))
            for port, kind, file in outputs:
                with outputs_of(task, kind, file):
                    data = listener.algorithm.GetOutputDataObject(port)
                    writing.write_piece(data, port, file, piece, pieces)
    return fields


class NoMesh(Exception):
    """One of the pieces could not be made: the others are discarded."""


def make_piece(algorithm, piece, pieces):
    Pipeline = vtkStreamingDemandDrivenPipeline
    for port in range(algorithm.GetNumberOfOutputPorts()):
        request = algorithm.GetOutputInformation(port)
        request.Set(Pipeline.UPDATE_PIECE_NUMBER(), piece)
        request.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), pieces)
        request.Set(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
    algorithm.UpdatePiece(piece, pieces, 0)


def pieces_needed(mesher, task):
    """The number of pieces to make one by one: that of the case, or what the memory limit requires."""
    ranks = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
    if task.pieces > 1:
        return decomposed_pieces(task, ranks)
    alone = ranks == 1
    takes_pieces = [file.suffix in writing.PIECE_WRITERS[port] for _, port, file in files_of(task)]
    if not alone or not takes_pieces or not all(takes_pieces):
        return 1
    pieces = mesher.SMProxy.GetClientSideObject().EstimateNumberOfPieces()
    if pieces > 1 and is_shaped(task):
        raise task.error(first_shape(task), "needs the mesh in one piece, but by memory_limit it would be made in "
            f"{pieces}: choose a larger cell_size or less refinement, or raise the limit")
    return pieces


def decomposed_pieces(task, ranks):
    """The number of pieces that this rank makes of a decomposed case."""
    if ranks > 1 and ranks != task.pieces:
        raise task.error(("output", "pieces"), f"{task.pieces} on {ranks} ranks, each of which writes one: "
            f"set it to 1 or {ranks}")
    for kind, port, file in files_of(task):
        suffixes = [*writing.PIECE_WRITERS[port], *([writing.CASE] if port == 0 else [])]
        if file.suffix not in suffixes:
            raise task.error(("output", kind), f"{file} cannot be written in pieces" +
                (f", only {' and '.join(suffixes)} can" if suffixes else ""))
    return task.pieces if ranks == 1 else 1


def field_arrays(algorithm):
    """{name: numbers or names} of a mesh."""
    fields = algorithm.GetOutputDataObject(0).GetFieldData()
    return {array.GetName(): [array.GetValue(j) for j in range(array.GetNumberOfValues())]
        for array in (fields.GetAbstractArray(i) for i in range(fields.GetNumberOfArrays()))
        if array.GetNumberOfComponents() == 1}


def statistics(mesher, listener, seconds, fields):
    """A summary of a mesh, for people and programs. `fields`: of each piece of it."""
    mesh, boundaries = {}, {}
    for arrays in fields:
        rows = [arrays.pop(name, []) for name in
            ("BoundaryIds", "BoundaryNames", "BoundaryTypes", "BoundaryFaceCounts", "BoundaryAreas")]
        of_layers = {key: arrays.pop(name) for key, name in (("layer_coverage", "BoundaryLayerCoverages"),
            ("layer_thickness", "BoundaryLayerThicknesses"), ("layers_asked", "BoundaryLayersAsked"),
            ("whole_stacks", "BoundaryWholeStacks"), ("first_layers_kept", "BoundaryFirstLayersKept"),
            ("bare_area", "BoundaryBareAreas"), ("last_layer_ratio", "BoundaryLastLayerRatios")) if name in arrays}
        # Types exist if the user gave some; counts and areas, if there is a mesh.
        for number, name, type, faces, area in itertools.zip_longest(*rows):
            row = boundaries.setdefault(number,
                {"number": number, "name": name, "type": type or "", "faces": 0, "area": 0})
            row["faces"] += faces or 0
            row["area"] += area or 0
        for key, values in of_layers.items():
            for number, value in zip(rows[0], values):
                boundaries[number][key] = max(value, boundaries[number].get(key, 0)) if key == "layers_asked" else value
        for name, values in arrays.items():
            if len(values) == 1 and not isinstance(values[0], str):  # texts of an OBJ file, such as MaterialLibraries
                mesh[name] = mesh.get(name, 0) + values[0]
    return {
        "error_code": listener.error_code or listener.algorithm.GetErrorCode(),
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
        print(f"boundary {row['number']:3}  {printable(row['name']):24} {row['faces']:9} faces, area {row['area']:.9g}")
    if summary["mesh"].get("LongLayers", 0) > 0:
        print("checkMesh will count", summary["mesh"]["LongLayers"], "layers of an aspect ratio above 1000, which do no harm")
    bare = [printable(row["name"]) for row in summary["boundaries"] if row.get("layers_asked") == 0 and row["faces"] > 0]
    if bare:
        print("no layers asked on", ", ".join(bare))


def run(task, quiet):
    """Meshes, writes, and returns the exit code."""
    begin = time.monotonic()
    mesher, warnings = build(task, quiet)
    create_folders(task)
    listener = Listener(mesher, quiet, warnings)
    pieces = pieces_needed(mesher, task)
    if pieces > 1:
        fields = write_pieces(listener, task, pieces)
    else:
        if pieces == 1:
            mesher.UpdatePipeline()
        fields = [field_arrays(listener.algorithm)]
    has_mesh = any(sum(arrays.get("Cells", [])) > 0 for arrays in fields)
    mesh = shaped(mesher, task, listener) if has_mesh and pieces == 1 else None
    has_mesh = has_mesh and (mesh is not None or pieces > 1)
    summary = statistics(mesher, listener, time.monotonic() - begin, fields)
    if has_mesh:
        if pieces == 1:
            write(mesher, mesh, task)
        if not quiet:
            report(summary)
    for file in task.statistics:
        with outputs_of(task, "statistics", file):
            writing.write_text(file, json.dumps(summary, indent=2) + "\n")
    if listener.interrupted:
        return STOPPED
    return REFUSED if not has_mesh else WARNINGS if listener.warnings or listener.errors else SUCCESS


def check(task):
    """Prints the expected size of a mesh; returns the exit code."""
    mesher, warnings = build(task, quiet=True)
    listener = Listener(mesher, True, warnings)
    boxes, cells, bytes_taken = listener.algorithm.EstimateSize()
    if boxes > 0:
        print(f"about {float(f'{boxes:.2g}'):.0f} boxes, {float(f'{cells:.2g}'):.0f} cells, {bytes_taken / 1024 ** 3:.1g} GiB of memory")
        if note := listener.algorithm.GetDomainNote():
            print(note)
    return REFUSED if boxes == 0 else WARNINGS if listener.warnings else SUCCESS


def main(arguments):
    parser = argparse.ArgumentParser(prog="cartesian-mesher",
        description="Meshes the inside of a closed surface as specified in a task file.",
        epilog="Exit codes: 0 success; 2 no mesh, the messages say why; 3 a mesh, but with warnings; "
            f"{STOPPED} stopped by Ctrl-C; 1 an internal error.")
    parser.add_argument("task", nargs="?", type=pathlib.Path, help="a task file (TOML)")
    parser.add_argument("--version", action="version", version=f"cartesian-mesher {VERSION}")
    parser.add_argument("--quiet", action="store_true", help="print warnings and errors only")
    parser.add_argument("--check", action="store_true", help="check the task and the surface and estimate the number of boxes, without meshing")
    parser.add_argument("--template", action="store_true",
        help="print a task file with all keys, their defaults and their meaning")
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
        for text in error.args:
            print(f"error: {text}", file=sys.stderr)
        return REFUSED
    except KeyboardInterrupt:
        return STOPPED


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
