# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame around a renderer's own passes, and its report."""

import json

from ._errors import Watch, require
from .vtkRelievoPasses import vtkRelievoPass


def attach(renderer):
    """Puts the Relievo frame around whatever pass the renderer has and returns it.

    renderer: a vtkRenderer. Its picture does not change: with nothing requested the frame only
    calls the renderer's own pass. A renderer that already has the frame keeps it.

    Returns the vtkRelievoPass: its ShadowsOn() makes every light cast, SetDisplayLayer() shows a
    layer as the picture, RequestLayer() draws one in every frame. Raises ValueError for anything
    but a renderer, RuntimeError if the frame refuses.
    """
    require(renderer, "vtkRenderer", "renderer")
    with Watch(renderer) as watch:
        frame = vtkRelievoPass.Attach(renderer)
    watch.raise_as(RuntimeError, "attach")
    if frame is None:
        raise RuntimeError("attach: the renderer's passes cannot be wrapped")
    return frame


def detach(renderer):
    """Removes the frame and restores the pass that the renderer had before.

    Returns True, or False if no frame was attached. Raises ValueError for anything but a
    vtkRenderer.
    """
    require(renderer, "vtkRenderer", "renderer")
    return bool(vtkRelievoPass.Detach(renderer))


def report(frame):
    """Returns what the last frames did and why, as a dict.

    frame: the vtkRelievoPass, or a renderer that has one.

    For each stage the report has whether it ran, the reason in words, GPU milliseconds (read some
    frames later, so None at first), bytes held and draw calls.

    Raises ValueError for anything else.
    """
    if hasattr(frame, "IsA") and frame.IsA("vtkRenderer"):
        owner, frame = frame, frame.GetPass()
        if frame is None or not frame.IsA("vtkRelievoPass"):
            raise ValueError(f"frame: the {owner.GetClassName()} has none; attach() it first")
    require(frame, "vtkRelievoPass", "frame")
    return json.loads(frame.GetFrameReport())
