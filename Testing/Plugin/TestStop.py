"""Progress grows through all stages, in small and steady steps, each with its stage's name; work that
is asked to stop by a Python observer does so at once, wherever it is. Nothing here depends on the clock: how long the
kernel may be silent is measured in Testing/Kernel/Mesher/TestStops.cpp."""

from paraview import simple

from pipeline import error_code, output, read

BEFORE = ["Scaling and Dual Levels", "Defects of the surface", "Boxes", "Patches",
          "Common sides of boxes", "Inner faces", "Cells"]
OPENING, EDITS = ["Opening of the wall"], ["Edits of the wall"]
AFTER = ["Closing of the wall", "Checks of cells", "Numbering", "Writing the mesh"]
STOPPED = 40009
STEP = 0.1  # most of the whole that is done from one report to the next
LEAST = 50  # reports at different progress: one for each 2 % of the work, whatever the clock says
AFTER_ASKING = 0  # reports of progress that come once it has been asked to stop


class Observer:
    """Notes what the mesher reports; asks it to stop once it has come to `stop_at`."""

    def __init__(self, stop_at=2.0):
        self.reports, self.asked, self.stop_at = [], None, stop_at

    def __call__(self, algorithm, event):
        self.reports.append((algorithm.GetProgress(), algorithm.GetProgressText() or ""))
        if self.asked is None and algorithm.GetProgress() >= self.stop_at:
            self.asked = len(self.reports)
            algorithm.SetAbortExecute(1)


def mesh(observer, properties):
    mesher = simple.CartesianMesher(Input=spot, CellSize=0.018, RefinementDepth=1, NumberOfThreads=1, **properties)
    mesher.SMProxy.GetClientSideObject().AddObserver("ProgressEvent", observer)
    mesher.UpdatePipeline()
    return mesher


spot = read("cino_spot.obj")
spot.UpdatePipeline()
for properties, stages, stops in (
    ({"CollapseRatio": 0, "SmallCells": "Remove", "SplitConcaveCells": 0}, BEFORE + OPENING + AFTER,
        (0.005, 0.05, 0.25, 0.4, 0.6, 0.7, 0.8, 0.9)),
    ({"SmallCells": "Merge", "SplitConcaveCells": 1}, BEFORE + OPENING + EDITS + AFTER, (0.5, 0.92)),
):
    observer = Observer()
    mesher = mesh(observer, properties)
    assert error_code(mesher) == 0
    assert output(mesher).GetNumberOfCells() > 10000, "too little work to tell"
    fractions, texts = zip(*observer.reports)
    assert list(fractions) == sorted(fractions)
    names = [text for i, text in enumerate(texts) if text and (i == 0 or text != texts[i - 1])]
    assert names == stages, names
    steps = [(later - earlier, texts[i]) for i, (earlier, later)
        in enumerate(zip((0, *fractions), (*fractions, 1)), -1)]
    print(f"{len(set(fractions))} of {len(fractions)} reports differ, step {max(steps)}")
    assert max(steps)[0] < STEP, max(steps)
    assert len(set(fractions)) >= LEAST, len(set(fractions))

    for stop_at in stops:
        observer = Observer(stop_at)
        stopped = mesh(observer, properties)
        assert error_code(stopped) == STOPPED, f"stop at {stop_at}: code {error_code(stopped)}"
        # To ask for the output by an update would run it again.
        assert stopped.SMProxy.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells() == 0, \
            f"stop at {stop_at}: there is a mesh"
        at, stage = observer.reports[observer.asked - 1]
        later = [report for report in observer.reports[observer.asked:] if 0 < report[0] < 1]  # not VTK's own
        print(f"stop at {at:.2f}, {stage}: {later}")
        assert at < stop_at + STEP, f"stop at {stop_at}: asked at {at}"
        assert len(later) <= AFTER_ASKING, f"stop at {stop_at}: {later}"
        simple.Delete(stopped)
