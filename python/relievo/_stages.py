# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame's stages by name, with their parameters."""

from ._frame import attach
from .vtkRelievoPasses import vtkRelievoPass


def _words(value):
    """A parameter's value in the stages' words: "on", "0.5", "1,0.5,0", "warped"."""
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, str):
        return value
    if isinstance(value, (list, tuple)):
        return ",".join(_words(each) for each in value)
    return repr(float(value)) if not float(value).is_integer() else str(int(value))


def stage(renderer, name, on=True, **parameters):
    """Switches a stage of the renderer's frame on or off and sets its parameters.

        relievo.stage(renderer, "shadows", method="warped", bias=2)

    renderer: a vtkRenderer; the frame is attached if there is none. name: one of stages().
    on: whether the frame may run the stage. parameters: numbers, True or False, strings, or a
    sequence of three numbers for a colour; stages() gives ranges and defaults.

    Returns the vtkRelievoStage. Raises ValueError for an unknown stage or parameter, and for a
    value that the parameter does not take; then no parameter is changed.
    """
    frame = attach(renderer)
    found = frame.GetStage(name)
    if found is None:
        raise ValueError(f"stage: got {name!r}, expected one of {', '.join(stages())}")
    before = {key: found.GetParameter(key) for key in parameters}
    for key, value in parameters.items():
        wrong = found.TrySetParameter(key, _words(value))
        if wrong:
            for known, words in before.items():
                if words:
                    found.TrySetParameter(known, words)
            raise ValueError(f"stage: {wrong}")
    found.SetEnabled(on)
    return found


def stages():
    """Returns all stages of a frame: a dict by name, each value a dict of the stage's parameters.

    Each parameter has a pair of strings, default and help: ("0.5", "Fraction of ... from 0 to 1.").
    """
    frame = vtkRelievoPass()
    found = {}
    for i in range(frame.GetNumberOfStages()):
        each = frame.GetStage(i)
        names = [each.GetParameterName(j) for j in range(each.GetNumberOfParameters())]
        found[each.GetStageName()] = {
            name: (each.GetParameter(name), each.GetParameterHelp(name)) for name in names}
    return found
