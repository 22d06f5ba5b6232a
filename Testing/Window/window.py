"""ParaView's window on a screen that nobody sees: started, played upon, photographed."""

import contextlib
import os
import pathlib
import struct
import subprocess
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

class Screen:
    """An X server in memory, with a folder for it and for ParaView's settings."""

    def __init__(self, width=1500, height=1200):
        self.size = f"{width}x{height}"
        self.variables = {}  # of the environment

    def __enter__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="window"))
        reading, writing = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{self.size}x24",
            "-fbdir", str(self.folder), "-nolisten", "tcp"],
            pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as display:
            self.display = f":{display.readline().strip()}"
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()

    def environment(self):
        return os.environ | {"DISPLAY": self.display, "HOME": str(self.folder),
            "XDG_RUNTIME_DIR": str(self.folder), "QT_QPA_PLATFORM": "xcb"} | self.variables

    def paraview(self, *arguments):
        """The window, started; `geometry` fills the screen: there is no window manager."""
        self.log = open(self.folder / "log.txt", "w+")
        return subprocess.Popen(["paraview", "--dr", "-geometry", f"{self.size}+0+0", *arguments],
            env=self.environment(), stdout=self.log, stderr=subprocess.STDOUT)

    def add_macro(self, name, text):
        """A Python script that the window has in its menu Macros from its next start on."""
        folder = self.folder / ".config" / "ParaView" / "Macros"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{name}.py").write_text(text)

    def said(self):
        return (self.folder / "log.txt").read_text()

    def play(self, events, *arguments, timeout=240):
        """Plays what a user does (see events.py) and waits for the window to close; what it said."""
        path = self.folder / "events.xml"
        path.write_text(events)
        window = self.paraview(f"--test-script={path}", "--exit", *arguments)
        try:
            code = window.wait(timeout)
        finally:
            with contextlib.suppress(ProcessLookupError):
                window.kill()
        assert code == 0, self.said()
        return self.said()

    def pixels(self):
        """The screen now, as rows of red, green and blue from the top."""
        data = (self.folder / "Xvfb_screen0").read_bytes()
        header = struct.unpack(">25I", data[:100])
        size, width, height, row, colours = header[0], header[4], header[5], header[12], header[19]
        start = size + 12 * colours
        image = np.frombuffer(data, np.uint8, row * height, start).reshape(height, row)
        return image[:, :4 * width].reshape(height, width, 4)[:, :, 2::-1]

    def photograph(self, events, path, rows=slice(None), columns=slice(None), timeout=60):
        """Plays events and writes what is on the screen after them: all of it or a part."""
        script = self.folder / "events.xml"
        script.write_text(events)
        window = self.paraview(f"--test-script={script}")
        try:
            end = time.monotonic() + timeout
            while "is finished. Success" not in self.said():
                assert time.monotonic() < end and window.poll() is None, self.said()
                time.sleep(0.2)
            assert "Success =  true" in self.said(), self.said()
            write_png(self.settled(timeout)[rows, columns], path)
        finally:
            window.kill()
            window.wait()

    def settled(self, timeout):
        """The screen once it has not changed for two seconds."""
        before, since, end = None, time.monotonic(), time.monotonic() + timeout
        while time.monotonic() < end:
            now = self.pixels()
            if before is None or not np.array_equal(now, before):
                before, since = now.copy(), time.monotonic()
            elif time.monotonic() - since > 2:
                return before
            time.sleep(0.2)
        raise TimeoutError("the screen does not come to rest")


def write_png(pixels, path):
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(pixels[::-1].reshape(-1, 3).copy(), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()
