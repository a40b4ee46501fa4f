# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame around a renderer's own passes, and its report."""

import json
import weakref

from vtkmodules.vtkCommonCore import vtkWeakReference

from . import vtkRelievoPasses
from ._arrays import why_not
from ._errors import Watch, is_a, require


class Frame(vtkRelievoPasses.vtkRelievoPass):
    """The frame, with exceptions instead of messages on the error output.

    Raises ValueError for a name that is neither a layer nor an array of the data in the renderer.
    In an empty renderer every name is accepted, and a wrong one raises when it is read.
    """

    def __init__(self):
        self._renderer = vtkWeakReference()

    @staticmethod
    def Attach(renderer):
        """As attach()."""
        return attach(renderer)

    def is_detached(self):
        """Whether detach() has taken it from the renderer that it was attached to."""
        return self._renderer.Get() is None

    def _check(self, name, method):
        wrong = why_not(name, self._renderer.Get(), self.GetShadowStage())
        if wrong:
            raise ValueError(f"{method}: {wrong}")

    def RequestLayer(self, name):
        """Renders the layer in every frame, until it is released."""
        self._check(name, "RequestLayer")
        super().RequestLayer(name)

    def SetDisplayLayer(self, name):
        """Shows the layer as the picture; None shows the picture itself."""
        if name is not None:
            self._check(name, "SetDisplayLayer")
        super().SetDisplayLayer(name)

    def ReadLayer(self, name, image):
        """Adds a layer of the last frame to the image; see ReadLayers."""
        return self.ReadLayers([name], image)

    def ReadLayers(self, names, image):
        """Adds layers of the last frame to the image, as point arrays of their names.

        Returns True. Raises ValueError for a layer that the last frame did not make or that
        nothing drawn has, and for anything but a vtkImageData of the frame's size.
        """
        require(image, "vtkImageData", "image")
        names = list(names)
        "".join(names).encode()  # VTK's wrapping ends the program where that raises
        with Watch(self) as watch:
            good = super().ReadLayers(names, image)
        watch.raise_as(ValueError, "ReadLayers")
        return good

    def TryReadLayers(self, names, image):
        """As ReadLayers, but returns what is wrong, in words, or nothing."""
        names = list(names)
        "".join(names).encode()
        return super().TryReadLayers(names, image)


# Not its name: VTK modules of Python's stable ABI (cvista's) take a class of the name of a wrapped
# one for that.
vtkRelievoPass = Frame


# Renderers whose passes others set, with what keeps their frames (_keep.py).
kept = weakref.WeakKeyDictionary()


def frame_of(renderer):
    """The frame of a renderer, around its pass or within it, or None."""
    there = renderer.GetPass()
    if there is not None and there.IsA("vtkRelievoPass"):
        return there
    found = kept.get(renderer)
    return found.frame if found is not None and not found.detached() else None


def attach(renderer):
    """Puts the Relievo frame around whatever pass the renderer has and returns it.

    renderer: a vtkRenderer. Its picture does not change: with nothing requested the frame only
    calls the renderer's own pass. A renderer that already has the frame keeps it.

    Returns the vtkRelievoPass: its ShadowsOn() makes every light cast, SetDisplayLayer() shows a
    layer as the picture, RequestLayer() renders one in every frame; both raise ValueError for a
    name that is neither a layer nor an array of the data in the renderer. Raises ValueError for
    anything but a renderer.
    """
    require(renderer, "vtkRenderer", "renderer")
    there = frame_of(renderer)
    if there is not None:
        return there
    frame = vtkRelievoPass()
    frame.SetDelegatePass(renderer.GetPass())
    frame._renderer.Set(renderer)
    renderer.SetPass(frame)
    return frame


def detach(renderer):
    """Removes the frame and restores the pass that the renderer had before.

    Returns True, or False if no frame was attached. Raises ValueError for anything but a
    vtkRenderer.
    """
    require(renderer, "vtkRenderer", "renderer")
    frame = renderer.GetPass()
    if isinstance(frame, Frame):
        frame._renderer.Set(None)
    return bool(vtkRelievoPass.Detach(renderer))


def report(frame):
    """Returns what the last frames did and why, as a dict.

    frame: the vtkRelievoPass, or a renderer that has one.

    For each stage the report has whether it ran, the reason in words, GPU milliseconds (read some
    frames later, so None at first), bytes held and draw calls.

    Raises ValueError for anything else.
    """
    if is_a(frame, "vtkRenderer"):
        owner, frame = frame, frame_of(frame)
        if frame is None:
            raise ValueError(f"frame: the {owner.GetClassName()} has none; attach() it first")
    require(frame, "vtkRelievoPass", "frame")
    return json.loads(frame.GetFrameReport())
