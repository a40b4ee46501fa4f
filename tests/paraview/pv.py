# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the plugin's tests: the plugin, pictures as numpy, their differences, other processes.
"""

import importlib.util
import json
import os
import pathlib
import re
import subprocess
import sys
import time
import unittest

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

PLUGIN = os.environ["RELIEVO_PLUGIN"]
TOOLS = pathlib.Path(os.environ["RELIEVO_PV_FOLDER"])
OUTPUT = pathlib.Path(os.environ.get("RELIEVO_TEST_OUTPUT", "."))
DATA = pathlib.Path(os.environ.get("RELIEVO_DATA", "."))
# ParaView's version, and the property that moves a representation, which 5.13 gave another name.
VERSION = (
    servermanager.vtkSMProxyManager.GetVersionMajor(),
    servermanager.vtkSMProxyManager.GetVersionMinor(),
)
TRANSLATION = "Translation" if VERSION >= (5, 13) else "Position"
# Beginnings of messages of ParaView and VTK.
MESSAGE = re.compile(r"(ERR|WARN|FATAL)\|.*|(ERROR|Warning): In .*")


def load(**more):
    """Loads the plugin here (remote=False), or as said."""
    simple.LoadPlugin(PLUGIN, **{"remote": False, "ns": simple.__dict__, **more})


def clear():
    """Deletes all views and sources. Much faster than a new session."""
    for view in simple.GetViews():
        for shown in list(view.Representations):
            simple.Delete(shown)
        simple.Delete(view)
    for source in simple.GetSources().values():
        simple.Delete(source)


def pixels(image, channels=3):
    """A vtkImageData's colours as uint8 (rows, columns, channels), the top row first."""
    columns, rows, _ = image.GetDimensions()
    scalars = vtk_to_numpy(image.GetPointData().GetScalars())
    return scalars.reshape(rows, columns, -1)[::-1, :, :channels].copy()


def picture(view):
    """The view's current picture, at full quality."""
    return pixels(view.SMProxy.CaptureWindow(1))


def stage(view, name):
    """The stage's entry in the report of the last picture."""
    view.SMProxy.UpdatePropertyInformation()
    report = json.loads(view.GetProperty("RelievoFrameReport").GetElement(0))
    return next(each for each in report["stages"] if each["name"] == name)


def restore(path, picture_path):
    """Loads a state file as a user does, saves the picture of its view, and returns the view."""
    if path.endswith(".py"):
        with open(path) as state:
            exec(compile(state.read(), path, "exec"), {})
    else:
        simple.LoadState(path)
    view = simple.GetActiveView()
    # Neither kind of state holds these two, for their values are application settings.
    view.MultiSamples, view.UseFXAA = 0, 0
    numpy.save(picture_path, picture(view))
    return view


class UndoStack:
    """ParaView's undo, as its menu has it, for one test."""

    def __init__(self, test, depth=10):
        manager = servermanager.vtkSMProxyManager.GetProxyManager()
        self.builder = servermanager.vtkSMUndoStackBuilder()
        self.stack = servermanager.vtkSMUndoStack()
        self.builder.SetUndoStack(self.stack)
        self.stack.SetStackDepth(depth)
        manager.SetUndoStackBuilder(self.builder)
        test.addCleanup(manager.SetUndoStackBuilder, None)

    def change(self, proxy, name, value):
        """One change that can be undone."""
        self.builder.Begin(name)
        setattr(proxy, name, value)
        self.builder.End()
        self.builder.PushToStack()

    def undo(self):
        self._go(self.stack.Undo)

    def redo(self):
        self._go(self.stack.Redo)

    def _go(self, step):
        self.builder.SetIgnoreAllChanges(True)
        step()
        session = servermanager.ActiveConnection.Session
        session.GetSessionProxyManager().UpdateRegisteredProxies(1)
        self.builder.SetIgnoreAllChanges(False)


def read(path, channels=3):
    """A PNG file's colours."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return pixels(reader.GetOutput(), channels)


def write(path, colours):
    """Writes colours as pixels() gives them into a PNG file."""
    rows, columns, _ = colours.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    flat = numpy.ascontiguousarray(colours[::-1]).reshape(rows * columns, -1).astype(numpy.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def unlike(first, second, level=0):
    """Where two pictures differ by more than `level` grey levels in any channel."""
    return (numpy.abs(first.astype(int) - second.astype(int)) > level).any(axis=2)


# Messages that ParaView 6.1 also prints without the plugin: at exit after several views, and for a
# state saved after a selection.
OWN = re.compile(
    "There are still active textures|Leaked for texture object"
    "|vtkAppendSelection .* has 0 connections but is not optional"
)


# Names of C++ in a message for readers of menus and panels: classes, except the one that ParaView
# itself writes first, and methods.
NAMES_OF_CODE = re.compile(r"\): .*(\bvtk[A-Z]|\b(Set|Get|Add|Clear)[A-Z]\w+)")


def messages(text):
    """The errors and warnings in a process's output, without times and places."""
    found = [message.group(0) for message in MESSAGE.finditer(text)]
    return [each for each in found if VERSION < (6, 1) or not OWN.search(each)]


class Test(unittest.TestCase):
    """Comparisons that leave their pictures in the test's folder on failure."""

    def same(self, first, second, what):
        """Two pictures are equal, bit for bit."""
        self.near(first, second, what, level=0, share=0.0)

    def near(self, first, second, what, level=1, share=0.001):
        """No more than a share of the pixels differ by more than a number of grey levels."""
        self.assertEqual(first.shape, second.shape, f"{what}: sizes")
        mismatches = unlike(first, second, level)
        if mismatches.mean() > share:
            difference = numpy.abs(first.astype(int) - second.astype(int))
            shown = numpy.clip(difference * 10, 0, 255)
            self.leave(what, first=first, second=second, differs=shown)
            self.fail(
                f"{what}: {mismatches.sum()} of {mismatches.size} pixels differ by more than"
                f" {level}, {share:g} of them may; at most by {difference.max()},"
                f" mean {difference.mean():.4f}"
            )

    def differ(self, first, second, what, share=0.01):
        """At least a share of the pixels differ: that something happened at all."""
        self.assertEqual(first.shape, second.shape, f"{what}: sizes")
        if unlike(first, second, 2).mean() < share:
            self.leave(what, first=first, second=second)
            self.fail(f"{what}: the pictures are alike")

    def traced(self, trace, name, value):
        """A trace sets the property: in a line of its own, or since 6.0 with others in one call."""
        self.assertRegex(trace, rf"\b{name} ?= ?{re.escape(repr(value))}")

    def leave(self, what, **pictures):
        """Writes pictures to look at into the test's folder."""
        stem = re.sub(r"\W+", "-", f"{self._testMethodName} {what}")
        for name, colours in pictures.items():
            write(OUTPUT / f"{stem}-{name}.png", colours)


class PluginTest(Test):
    """With the plugin, and without views and sources at the start of each case."""

    @classmethod
    def setUpClass(cls):
        load()

    def setUp(self):
        clear()


def values(proxy, properties):
    """The values of properties as Python's own objects, of the kinds of their defaults, which
    come first in the lists of `properties`, by name."""
    found = {}
    for name, (default, *_) in properties.items():
        value = getattr(proxy, name)
        text, several = isinstance(default, str), isinstance(default, list)
        found[name] = str(value).strip("'") if text else list(value) if several else value
    return found


def run(script, *words, tool="pvpython", status=0, timeout=600, launcher=()):
    """Runs a script in a process of its own; returns all it wrote. `status` None: any."""
    done = subprocess.run(
        [*launcher, str(TOOLS / tool), str(script), *map(str, words)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        timeout=timeout,
        cwd=OUTPUT,
        env=environment(),
    )
    if status is not None and done.returncode != status:
        raise AssertionError(f"{tool} {script}: exit {done.returncode}\n{done.stdout}")
    return done.stdout


def mpirun(ranks):
    """The words that start a tool on so many ranks; skips the test in a ParaView without MPI."""
    if importlib.util.find_spec("vtkmodules.vtkParallelMPI") is None:
        raise unittest.SkipTest("this ParaView was built without MPI")
    # A rank that waits leaves its core, and each may take any: other tests run beside this one.
    shares = ["--oversubscribe", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]
    return ["mpirun", "--allow-run-as-root", *shares, "-np", str(ranks)]


def environment():
    """For other processes: without the variables that say that pvpython is a rank itself."""
    mpi = ("OMPI_", "PMIX_", "ORTE_")
    return {name: value for name, value in os.environ.items() if not name.startswith(mpi)}


class Server:
    """A pvserver on a port that was free, ended with the `with` block or by its own time limit."""

    def __init__(self, *words, launcher=(), limit=600):
        self.words = [*launcher, str(TOOLS / "pvserver"), *words]
        self.limit = limit
        self.log = OUTPUT / "pvserver.log"

    def __enter__(self):
        # Port 0: pvserver takes a free one and says which.
        with self.log.open("w") as log:
            self.process = subprocess.Popen(
                ["timeout", str(self.limit), *self.words, "--server-port=0"],
                stdout=log,
                stderr=subprocess.STDOUT,
                env=environment(),
            )
        try:
            self.port = self._wait_for_port()
        except BaseException:
            self._end()
            raise
        return self

    def _wait_for_port(self):
        end = time.monotonic() + self.limit
        while time.monotonic() < end:
            said = re.search(r"Accepting connection\(s\): .*:(\d+)", self.text())
            if said:
                return int(said.group(1))
            if self.process.poll() is not None:
                break
            time.sleep(0.05)
        raise AssertionError(f"pvserver did not start:\n{self.text()}")

    def text(self):
        """The server's output so far."""
        return self.log.read_text(errors="replace")

    def _end(self):
        if self.process.poll() is None:
            self.process.terminate()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()

    def __exit__(self, *_):
        # It ends by itself when its client disconnects.
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self._end()


def main():
    """Runs the script's cases; the exit status says whether all passed."""
    done = unittest.main(argv=[sys.argv[0], "-v", *sys.argv[1:]], module="__main__", exit=False)
    leave(not done.result.wasSuccessful())


def leave(status=0):
    """Ends the script. ParaView 5.11 crashes in sys.exit() while there are views."""
    clear()
    sys.exit(status)
