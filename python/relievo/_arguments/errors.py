# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's error events as Python exceptions."""

import errno
import os
import re
import reprlib
import sys
import warnings

from ..vtk.util.misc import calldata_type
from ..vtk.util.vtkConstants import VTK_STRING
from ..vtk.vtkCommonCore import vtkLogger, vtkObject, vtkObjectBase, vtkOutputWindow

_PREAMBLE = re.compile(r"^(ERROR|Warning): In .*, line \d+\n\w+ \(0x[0-9a-f]+\): ")

_NO_MEMORY = re.compile(r"it would take .*\d+ bytes.*, and (the machine has \d+|memory ran out)")

_ECHO = re.compile(r"^Algorithm \w+ \(0x[0-9a-f]+\) returned failure")


class Watch:
    """Collects the error and warning events of VTK objects while it is entered.

    Includes an algorithm's executive, which reports failures of the pipeline.
    Observed messages are not printed. vtkObject.GlobalWarningDisplayOff(), without which VTK has no
    such events, only keeps others from being printed.
    """

    def __init__(self, *objects):
        self.errors = []
        self.warnings = []
        self._objects = []
        for thing in objects:
            self._objects.append(thing)
            if thing.IsA("vtkAlgorithm"):
                self._objects.append(thing.GetExecutive())
        self._observed = []

    def __enter__(self):
        @calldata_type(VTK_STRING)
        def collect(_caller, _event, text):
            text = " ".join(_PREAMBLE.sub("", text or "").split())
            # A pipeline's echo of a filter's own error contains only addresses.
            self.errors.append("VTK failed without saying why" if _ECHO.match(text) else text)

        @calldata_type(VTK_STRING)
        def note(_caller, _event, text):
            self.warnings.append(" ".join(_PREAMBLE.sub("", text or "").split()))

        for thing in self._objects:
            self._observed.append((thing, thing.AddObserver("ErrorEvent", collect)))
            self._observed.append((thing, thing.AddObserver("WarningEvent", note)))
        self._quiet = None
        if not vtkObject.GetGlobalWarningDisplay():
            window = vtkOutputWindow.GetInstance()
            self._quiet = window, window.GetDisplayMode(), vtkLogger.GetCurrentVerbosityCutoff()
            window.SetDisplayModeToNever()
            vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
            vtkObject.GlobalWarningDisplayOn()
        return self

    def __exit__(self, *_):
        if self._quiet:
            window, mode, verbosity = self._quiet
            vtkObject.GlobalWarningDisplayOff()
            vtkLogger.SetStderrVerbosity(verbosity)
            window.SetDisplayMode(mode)
        for thing, tag in self._observed:
            thing.RemoveObserver(tag)
        self._observed = []
        for each in self.warnings:
            warnings.warn(each, RuntimeWarning, stacklevel=3)

    def raise_as(self, kind, subject):
        """Raises kind("subject: the first error") if there was one: the rest are its echoes. For a
        lack of memory raises MemoryError."""
        if self.errors:
            kind = MemoryError if _NO_MEMORY.search(self.errors[0]) else kind
            raise kind(f"{subject}: {self.errors[0]}")


def check_file(path):
    """Raises Python's own errors for missing or forbidden files and for folders. Does not wait for
    pipes."""
    os.close(os.open(path, os.O_RDONLY | os.O_NONBLOCK))
    if os.path.isdir(path):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), path)


def path_of(thing, argument):
    """The text or bytes of a path; or ValueError, also for a null byte, where VTK would cut it."""
    try:
        path = os.fspath(thing)
    except TypeError:
        path = None
    if path is None or "\0" in os.fsdecode(path):
        raise ValueError(f"{argument}: got {describe(thing)}, expected a path")
    return path


def is_a(thing, class_name):
    """Whether thing is an object of this class, in the VTK that Relievo is built on."""
    return isinstance(thing, vtkObjectBase) and bool(thing.IsA(class_name))


def describe(thing):
    """Describes an unexpected object for a message, with its package if it, or an object that it
    has, belongs to another VTK."""
    for each in ("renderer", "dataset", "actor"):
        inner = getattr(thing, each, None)
        if hasattr(inner, "IsA") and not isinstance(inner, vtkObjectBase):
            return f"{type(thing).__name__} with {describe(inner)}"
    if hasattr(thing, "IsA") and not isinstance(thing, vtkObjectBase):
        # PyVista's classes derive from VTK's.
        bases = [each for each in type(thing).__mro__ if each.__name__ == "vtkObjectBase"]
        known = [vtkObjectBase, *bases, type(thing)]
        other = known[1].__module__.split(".")[0]
        if "pyvista" in sys.modules:
            cure = "import relievo before pyvista, or set PYVISTA_VTK_BACKEND to relievo.vtk"
        else:
            cure = (
                "import VTK's classes from relievo.vtk, or call relievo.provide_vtkmodules() "
                "before anything imports vtkmodules"
            )
        return f"a {thing.GetClassName()} of {other}, another VTK than Relievo's: {cure}"
    if hasattr(thing, "shape") and hasattr(thing, "dtype"):
        return f"an array of shape {tuple(thing.shape)}"
    return " ".join(_short.repr(thing).split())


_short = reprlib.Repr()
_short.maxother = _short.maxstring = 80


def require(thing, class_name, argument):
    """Raises ValueError unless thing is a VTK object of that class."""
    if not is_a(thing, class_name):
        raise ValueError(f"{argument}: got {describe(thing)}, expected a {class_name}")
