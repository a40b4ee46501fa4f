# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lamps from data."""

import numbers

from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkAlgorithmOutput

from ._errors import require
from ._frame import attach
from .vtkRelievoDeferred import vtkRelievoLamps

_FALLOFFS = {
    "linear": vtkRelievoLamps.LINEAR,
    "inverse-square": vtkRelievoLamps.INVERSE_SQUARE,
    "vtk": vtkRelievoLamps.VTK,
}


def lamps(renderer, points, radius=None, intensity=None, color=None, falloff="linear",
          attenuation=None):
    """Lights what the renderer draws with a lamp at each point.

        relievo.lamps(renderer, street_lamps, radius=12, color=(1, 0.8, 0.5))

    renderer: a vtkRenderer; the frame is attached if there is none. points: a vtkDataSet, a
    composite dataset, or an algorithm or its output port, followed when it changes.
    radius (world units), intensity: a number for all, or the name of a point array; color: linear
    red, green, blue, or the name of a point array. None takes the array "radius", "intensity" or
    "color" if the points have it, else 1, 1 and white. falloff: "linear", "inverse-square" or
    "vtk", with attenuation = (constant, linear, quadratic) as vtkLight has it.

    Returns the vtkRelievoLamps. attach(renderer).GetStage("lamps").RemoveLamps(it) takes them away.
    Raises ValueError for wrong arguments; then nothing is changed.
    """
    require(renderer, "vtkRenderer", "renderer")
    made = vtkRelievoLamps()
    if isinstance(points, vtkAlgorithmOutput):
        made.SetInputConnection(points)
    elif isinstance(points, vtkAlgorithm) and points.GetNumberOfOutputPorts() > 0:
        made.SetInputConnection(points.GetOutputPort())
    else:
        kinds = ("vtkDataSet", "vtkCompositeDataSet")
        if not any(getattr(points, "IsA", lambda name: False)(kind) for kind in kinds):
            raise ValueError(f"lamps: points: got {points!r}, expected a vtkDataSet, a composite "
                             f"dataset, or an algorithm")
        made.SetInputData(points)
    _take(made, "radius", radius, made.SetRadius, 0)
    _take(made, "intensity", intensity, made.SetIntensity)
    if isinstance(color, str):
        made.SetArray("color", color)
    elif color is not None:
        made.SetColor(*_three("color", color))
        made.SetArray("color", "")
    if falloff not in _FALLOFFS:
        raise ValueError(f"lamps: falloff: got {falloff!r}, expected one of {', '.join(_FALLOFFS)}")
    made.SetFalloff(_FALLOFFS[falloff])
    if attenuation is not None:
        if falloff != "vtk":
            raise ValueError("lamps: attenuation: expected falloff='vtk' with it")
        made.SetAttenuationValues(*_three("attenuation", attenuation))
    attach(renderer).GetStage("lamps").AddLamps(made)
    return made


def _take(made, name, value, set_for_all, least=None):
    if isinstance(value, str):
        made.SetArray(name, value)
    elif value is not None:
        if not isinstance(value, numbers.Real) or (least is not None and not value >= least):
            expected = "a number" if least is None else f"a number of {least} or more"
            raise ValueError(f"lamps: {name}: got {value!r}, expected {expected}, or the name of a "
                             f"point array")
        set_for_all(float(value))
        made.SetArray(name, "")


def _three(name, values):
    try:
        three = [float(each) for each in values]
    except (TypeError, ValueError):
        three = []
    if len(three) != 3:
        raise ValueError(f"lamps: {name}: got {values!r}, expected three numbers")
    return three
