# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The frame's stages by name, with their parameters."""

from ._frame import attach
from .vtkRelievoPasses import vtkRelievoPass


def _words(value):
    """A parameter's value as the stages take it: "on", "0.5", "1,0.5,0", "warped"."""
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, str):
        return value
    if isinstance(value, (list, tuple)):
        return ",".join(_words(each) for each in value)
    return repr(float(value)) if not float(value).is_integer() else str(int(value))


def stage(renderer, name, on=True, **parameters):
    """Switches a stage of the renderer's frame on, or off, and sets its parameters.

        relievo.stage(renderer, "shadows", method="warped", bias=2)

    renderer: a vtkRenderer; the frame is attached if it is not there. name: one of stages(). The
    values are numbers, True or False, words, or a sequence of three for a colour; stages() gives
    their ranges and defaults. Returns the vtkRelievoStage. Raises ValueError for an unknown stage
    or parameter, and for a value that the parameter does not take; nothing is changed then.
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
    """The stages that frames have: a dict of their names, each with a dict of its parameters.

    A parameter's value is its default and help in words: ("0.5", "Fraction of ... from 0 to 1.").
    Raises nothing.
    """
    frame = vtkRelievoPass()
    found = {}
    for i in range(frame.GetNumberOfStages()):
        each = frame.GetStage(i)
        names = [each.GetParameterName(j) for j in range(each.GetNumberOfParameters())]
        found[each.GetStageName()] = {
            name: (each.GetParameter(name), each.GetParameterHelp(name)) for name in names}
    return found
