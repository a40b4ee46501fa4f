# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks whether the program that runs this Python has another VTK than Relievo's."""

import ctypes
import os
import pathlib
import re

_LIBRARY = re.compile(rb"(libvtkCommon(?:Core)?(?:-[\w.+-]*?)?)\.so")  # cvista's names are longer
_FUNCTION = "_ZN9vtkObject3NewEv"  # vtkObject::New()


class _Place(ctypes.Structure):
    _fields_ = [("file", ctypes.c_char_p), ("base", ctypes.c_void_p),
                ("name", ctypes.c_char_p), ("address", ctypes.c_void_p)]  # fmt: skip


def check():
    """Raises ImportError if the program itself has another VTK, as ParaView's Python has.

    Its functions would be called instead of those that Relievo is built on, and crash. A VTK that
    Python has imported, such as PyPI's `vtk`, does no harm: other libraries do not find its
    functions.
    """
    everyone = ctypes.CDLL(None)
    if not hasattr(everyone, _FUNCTION) or not hasattr(everyone, "dladdr"):
        return
    place = _Place()
    everyone.dladdr(ctypes.cast(getattr(everyone, _FUNCTION), ctypes.c_void_p), ctypes.byref(place))
    theirs = place.file or b""
    own = {
        name
        for module in pathlib.Path(__file__).parents[1].glob("vtkRelievo*.so")
        for name in _LIBRARY.findall(module.read_bytes())
    }
    if own and not own & set(_LIBRARY.findall(os.path.basename(theirs))):
        raise ImportError(
            f"relievo: this program has a VTK of its own, {os.fsdecode(theirs)}, and Relievo is "
            f"built on another, {os.fsdecode(min(own))}: the two would crash in one process. Use "
            "an ordinary Python; ParaView takes Relievo's plugin, which is built on its VTK"
        )
