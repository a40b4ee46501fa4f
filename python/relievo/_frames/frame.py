# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame around a renderer's own passes, and its report."""

import json
from collections.abc import Iterable
from typing import Any

from .. import vtkRelievoPasses
from .._arguments.arrays import why_not
from .._arguments.errors import Watch, require
from .._arguments.renderers import inner_renderer
from ..vtk.vtkCommonCore import vtkWeakReference


class Frame(vtkRelievoPasses.vtkRelievoPass):
    """The frame, with exceptions instead of messages on the error output.

    Raises ValueError for a name that is neither a layer nor an array of the data in the renderer.
    In an empty renderer every name is accepted, and a wrong one raises when it is read.
    """

    def __init__(self):
        self._renderer = vtkWeakReference()

    @staticmethod
    def Attach(renderer: Any) -> "Frame":
        """Puts a frame around the renderer's pass; attach() also keeps it around later passes."""
        return put(renderer)

    @staticmethod
    def Detach(renderer: Any) -> bool:
        """See detach()."""
        return take(renderer)

    def is_detached(self) -> bool:
        """Whether detach() has removed the frame from its renderer."""
        return self._renderer.Get() is None

    def _check(self, name, method):
        error = why_not(name, self._renderer.Get(), self.GetShadowStage())
        if error:
            raise ValueError(f"{method}: {error}")

    def RequestLayer(self, name: str) -> None:
        """Renders the layer in every frame, until it is released."""
        self._check(name, "RequestLayer")
        super().RequestLayer(name)

    def SetDisplayLayer(self, name: str | None) -> None:
        """Shows the layer as the picture; None shows the picture itself."""
        if name is not None:
            self._check(name, "SetDisplayLayer")
        super().SetDisplayLayer(name)  # type: ignore[arg-type]

    def ReadLayer(self, name: str, image: Any) -> bool:
        """Adds a layer of the last frame to the image; see ReadLayers."""
        return self.ReadLayers([name], image)

    def ReadLayers(self, names: Iterable[str], image: Any) -> bool:
        """Adds layers of the last frame to the image, as point arrays of their names.

        Returns True. Raises ValueError for a layer that the last frame did not make, for an array
        that no drawn data have, and if the image is not a vtkImageData of the frame's size.
        """
        require(image, "vtkImageData", "image")
        names = list(names)
        "".join(names).encode()  # VTK's wrapping would end the program where this raises
        with Watch(self) as watch:
            good = super().ReadLayers(names, image)
        watch.raise_as(ValueError, "ReadLayers")
        return good

    def TryReadLayers(self, names: Iterable[str], image: Any) -> str:
        """Like ReadLayers, but returns the problem as a text, or ""."""
        names = list(names)
        "".join(names).encode()
        return super().TryReadLayers(names, image)


# Not its name: VTK modules of Python's stable ABI (cvista's) take a class of the name of a wrapped
# one for that.
vtkRelievoPass = Frame


def kept_of(renderer):
    """The RendererFrame of the renderer (_keep.py), or None."""
    return getattr(renderer, "relievo_kept", None)


def frame_of(renderer):
    """The frame of a renderer, around its pass or within it, or None."""
    there = renderer.GetPass()
    if there is not None and there.IsA("vtkRelievoPass"):
        return there
    found = kept_of(renderer)
    return found.frame if found is not None and not found.detached() else None


def put(renderer):
    """The frame around the pass that the renderer has now."""
    there = frame_of(renderer)
    if there is not None:
        if isinstance(there, Frame) and there.is_detached():
            there._renderer.Set(renderer)  # from a deleted one, or by SetPass()
        return there
    frame = vtkRelievoPass()
    frame.SetDelegatePass(renderer.GetPass())
    frame._renderer.Set(renderer)
    renderer.SetPass(frame)
    return frame


def take(renderer):
    """Removes the frame from the renderer's pass; returns whether there was one."""
    found = kept_of(renderer)
    frame = renderer.GetPass() if found is None else found.frame
    if found is not None:
        found.let_go()
    taken = vtkRelievoPasses.vtkRelievoPass.Detach(renderer)
    if isinstance(frame, Frame) and frame._renderer.Get() is renderer:
        frame._renderer.Set(None)
        taken = True  # also from within a pass that was set meanwhile
    return bool(taken)


def report(frame) -> dict:
    """Returns a report on the stages of the last frames, as a dict.

    frame: the vtkRelievoPass, or a renderer (or a plotter) that has one.

    For each stage the report has whether it ran, the reason as a text, GPU milliseconds (read some
    frames later, so None at first), bytes held and draw calls.

    Raises ValueError for anything else.
    """
    owner = inner_renderer(frame)
    if owner is not None:
        frame = frame_of(owner)
        if frame is None:
            raise ValueError(f"frame: the {owner.GetClassName()} has none; attach() it first")
    require(frame, "vtkRelievoPass", "frame")
    return json.loads(frame.GetFrameReport())
