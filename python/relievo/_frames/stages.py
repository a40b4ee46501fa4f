# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame's stages by name, with their parameters."""

from .._arguments.data import did_you_mean
from .._arguments.errors import describe
from .._arguments.parameters import names, words
from .._arguments.renderers import need_renderer
from .._wrapped import vtkRelievoPass, vtkRelievoStage
from .frame import frame_of
from .keep import attach


def stage(renderer, name, on=True, **parameters) -> vtkRelievoStage:
    """Switches a stage of the renderer's frame on or off and sets its parameters.

        relievo.stage(renderer, "shadows", method="warped", bias=2)

    renderer: a vtkRenderer, or an object whose attribute `renderer` is one (a plotter); the frame
    is attached if there is none. name: one of stages(). on: whether the frame may run the stage;
    layers of shadows and ambient occlusion are there either way.
    parameters: numbers, True or False, strings, and for a colour three numbers, "#ff8000" or a
    name; stages() gives ranges and defaults.

    Returns the vtkRelievoStage. Raises ValueError for an unknown stage or parameter, and for a
    value that the parameter does not accept; then no parameter is changed.
    """
    renderer = need_renderer(renderer)
    there = frame_of(renderer)
    frame = vtkRelievoPass() if there is None else there
    found = frame.GetStage(name) if isinstance(name, str) else None
    if found is None:
        known = _names(frame)
        raise ValueError(f"stage: got {describe(name)}{did_you_mean(name, known)}, expected one of "
                         f"{', '.join(known)}")
    wanted = {}
    for key, value in parameters.items():
        try:
            wanted[key] = words(value)
        except (TypeError, ValueError, OverflowError):
            raise ValueError(
                f"stage: {name}:{key}: got {describe(value)}, expected a number, True or False, a "
                f"word, or a sequence of numbers"
            ) from None
    # Checked on an unused frame, so that nothing is attached if a value is invalid.
    before = {key: found.GetParameter(key) for key in wanted if key in names(found)}
    for key, text in wanted.items():
        error = found.TrySetParameter(key, text)
        if error:
            for known, old in before.items():
                found.TrySetParameter(known, old)
            guess = "" if key in before else did_you_mean(key, names(found))
            raise ValueError(f"stage: {error}{guess}")
    if frame is not there:
        found = attach(renderer).GetStage(name)
        for key, text in wanted.items():
            found.TrySetParameter(key, text)
    found.SetEnabled(bool(on))
    return found


def _names(frame):
    return [frame.GetStage(i).GetStageName() for i in range(frame.GetNumberOfStages())]


def stages() -> dict:
    """Returns all stages of a frame: a dict by name, each value a dict of the stage's parameters.

    Each parameter has a pair of strings, default and help: ("0.5", "Fraction of ... from 0 to 1.").
    """
    frame = vtkRelievoPass()
    found = {}
    for i in range(frame.GetNumberOfStages()):
        each = frame.GetStage(i)
        found[each.GetStageName()] = {
            name: (each.GetParameter(name), each.GetParameterHelp(name))
            for name in names(each)
        }
    return found
