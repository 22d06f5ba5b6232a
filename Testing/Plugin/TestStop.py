"""Progress grows through all stages, in small and steady steps, each with its stage's name; work that
is asked to stop by a Python observer does so within a second, wherever it is."""

import time

from paraview import simple

from pipeline import error_code, read

BEFORE = ["Scaling and Dual Levels", "Defects of the surface", "Boxes", "Patches",
          "Common sides of boxes", "Inner faces", "Cells"]
SHAPING, AFTER = ["Short edges", "Shaping of cells"], ["Numbering", "Writing the mesh"]
STOPPED = 40009
LONGEST = 1.0  # seconds of processor time: what else runs on the machine does not count
SILENCE = 0.05  # most of all the time that passes without a report
STEP = 0.1  # most of the whole that is done from one report to the next
LEAD = 0.3  # how far progress and time are apart: shaping depends on how many cells are at fault


class Observer:
    """Notes when the mesher reports what; asks it to stop once it has come to `stop_at`."""

    def __init__(self, stop_at=2.0):
        self.reports, self.asked, self.at, self.stop_at = [], None, None, stop_at

    def __call__(self, algorithm, event):
        self.reports.append((time.process_time(), algorithm.GetProgress(), algorithm.GetProgressText() or ""))
        if self.asked is None and algorithm.GetProgress() >= self.stop_at:
            self.asked, self.at = time.process_time(), algorithm.GetProgress()
            algorithm.SetAbortExecute(1)


def mesh(observer, properties):
    mesher = simple.CartesianMesher(Input=spot, CellSize=0.018, RefinementDepth=1, NumberOfThreads=1, **properties)
    mesher.SMProxy.GetClientSideObject().AddObserver("ProgressEvent", observer)
    mesher.UpdatePipeline()
    return mesher, time.process_time()


spot = read("cino_spot.obj")
spot.UpdatePipeline()
for properties, stages, stops in (
    ({"CollapseRatio": 0, "SmallCells": "Remove", "SplitConcaveCells": 0}, BEFORE + AFTER,
        (0.005, 0.05, 0.25, 0.4, 0.6, 0.7, 0.8, 0.9)),
    ({"SmallCells": "Merge", "SplitConcaveCells": 1}, BEFORE + SHAPING + AFTER, (0.5, 0.92)),
):
    observer = Observer()
    begin = time.process_time()
    mesher, end = mesh(observer, properties)
    assert error_code(mesher) == 0
    times, fractions, texts = zip(*observer.reports)
    assert list(fractions) == sorted(fractions)
    names = [text for i, text in enumerate(texts) if text and (i == 0 or text != texts[i - 1])]
    assert names == stages, names
    pauses = [(later - earlier, texts[i]) for i, (earlier, later)
        in enumerate(zip((begin, *times), (*times, end)), -1)]
    steps = [(later - earlier, texts[i]) for i, (earlier, later)
        in enumerate(zip((0, *fractions), (*fractions, 1)), -1)]
    leads = [(abs(fraction - (now - begin) / (end - begin)), text) for now, fraction, text in observer.reports]
    print(f"{end - begin:.1f} s, longest silence {max(pauses)}, step {max(steps)}, lead {max(leads)}")
    assert end - begin > 1, "too little work to tell"
    assert max(pauses)[0] < SILENCE * (end - begin), max(pauses)
    assert max(steps)[0] < STEP, max(steps)
    assert max(leads)[0] < LEAD, max(leads)

    for stop_at in stops:
        observer = Observer(stop_at)
        stopped, end = mesh(observer, properties)
        assert error_code(stopped) == STOPPED, f"stop at {stop_at}: code {error_code(stopped)}"
        assert end - observer.asked < LONGEST, f"stop at {stop_at}: took {end - observer.asked:.2f} s"
        print(f"stop at {observer.at:.2f}: {end - observer.asked:.3f} s")
        simple.Delete(stopped)
