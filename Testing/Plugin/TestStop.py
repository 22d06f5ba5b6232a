"""Progress grows through all stages, in small steps, each with its stage's name; work that is asked to
stop by a Python observer does so within a second, wherever it is."""

import time

from paraview import simple

from pipeline import error_code, read

STAGES = ["Scaling and Dual Levels", "Defects of the surface", "Boxes", "Patches",
          "Common sides of boxes", "Inner faces", "Cells", "Shaping of cells", "Numbering",
          "Writing the mesh"]
STOPPED = 40009
LONGEST = 1.0  # seconds of processor time: what else runs on the machine does not count


class Observer:
    """Notes when the mesher reports what; asks it to stop once it has come to `stop_at`."""

    def __init__(self, stop_at=2.0):
        self.reports, self.asked, self.at, self.stop_at = [], None, None, stop_at

    def __call__(self, algorithm, event):
        self.reports.append((time.process_time(), algorithm.GetProgress(), algorithm.GetProgressText()))
        if self.asked is None and algorithm.GetProgress() >= self.stop_at:
            self.asked, self.at = time.process_time(), algorithm.GetProgress()
            algorithm.SetAbortExecute(1)


def mesh(observer):
    mesher = simple.CartesianMesher(Input=spot, CellSize=0.018, RefinementDepth=1, NumberOfThreads=1)
    mesher.SMProxy.GetClientSideObject().AddObserver("ProgressEvent", observer)
    mesher.UpdatePipeline()
    return mesher, time.process_time()


spot = read("cino_spot.obj")
spot.UpdatePipeline()
observer = Observer()
begin = time.process_time()
mesher, end = mesh(observer)
assert error_code(mesher) == 0
times, fractions, texts = zip(*observer.reports)
assert list(fractions) == sorted(fractions)
names = [text for i, text in enumerate(texts) if text and (i == 0 or text != texts[i - 1])]
assert names == STAGES, names
pauses = [(later - earlier, texts[i]) for i, (earlier, later)
    in enumerate(zip((begin, *times), (*times, end)), -1)]
print(f"{end - begin:.1f} s, longest without a report {max(pauses)}")
assert end - begin > 1.5, "too little work to tell"
assert max(pauses)[0] < LONGEST, max(pauses)

for stop_at in 0.005, 0.03, 0.1, 0.25, 0.33, 0.4, 0.6, 0.8, 0.93, 0.96:
    observer = Observer(stop_at)
    mesher, end = mesh(observer)
    assert error_code(mesher) == STOPPED, f"stop at {stop_at}: code {error_code(mesher)}"
    assert end - observer.asked < LONGEST, f"stop at {stop_at}: took {end - observer.asked:.2f} s"
    print(f"stop at {observer.at:.2f}: {end - observer.asked:.3f} s")
    simple.Delete(mesher)
