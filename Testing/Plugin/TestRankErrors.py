"""An error on any one rank, or Ctrl-C there, ends all within ten seconds, with its code and message."""

import time

from cartesianmesher.vtkCartesianMesherFilters import vtkCartesianMesher
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from pipeline import DATA

TOO_MANY_BOXES, STOPPED = 40005, 40009
LONGEST = 10.0  # seconds
CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()
assert RANKS > 1


class Observer:
    """Stops the mesher in the midst of its work, and keeps what it says."""

    def __init__(self, mesher, stops):
        self.stops, self.errors, self.progress = stops, [], 0.0
        self.hear.__func__.CallDataType = "string0"
        mesher.AddObserver("ErrorEvent", self.hear)
        mesher.AddObserver("ProgressEvent", self.watch)

    def hear(self, algorithm, event, text):
        self.errors.append(text)

    def watch(self, algorithm, event):
        if algorithm.GetProgress() < 1:  # VTK says so in the end, whatever happened
            self.progress = algorithm.GetProgress()
        if self.stops and self.progress > 0.3:
            algorithm.SetAbortExecute(1)


reader = vtkSTLReader()
reader.SetFileName(str(DATA / "kcl_exhaust_header_lumens.stl"))
reader.ScalarTagsOn()
for failing in range(RANKS):
    for stops in False, True:
        mesher = vtkCartesianMesher()
        mesher.SetInputConnection(reader.GetOutputPort())
        mesher.SetCellSize(1.0)  # minutes of work
        observer = Observer(mesher, stops and RANK == failing)
        if RANK == failing and not stops:
            mesher.SetMemoryLimit(1e-6)
        CONTROLLER.Barrier()
        begin = time.monotonic()
        mesher.UpdatePiece(RANK, RANKS, 0)
        seconds = time.monotonic() - begin
        assert mesher.GetErrorCode() == (STOPPED if stops else TOO_MANY_BOXES), mesher.GetErrorCode()
        assert bool(observer.errors) == (RANK == failing and not stops), observer.errors
        assert not stops or observer.progress < 0.6, observer.progress
        assert stops or seconds < LONGEST, f"{seconds:.1f} s"
        print(f"rank {RANK}: {'stopped' if stops else 'error'} on {failing}: {seconds:.1f} s, at {observer.progress:.2f}")
        # Another mesh afterwards is none the worse.
        mesher.SetMemoryLimit(0)
        mesher.SetAbortExecute(0)
        mesher.SetCellSize(20.0)
        observer.stops = False
        mesher.UpdatePiece(RANK, RANKS, 0)
        assert mesher.GetErrorCode() == 0 and mesher.GetOutputDataObject(0).GetNumberOfCells() > 100
