# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lamps from data."""

from ._errors import require
from ._frame import attach
from ._values import set_color, set_points, set_value, three
from .vtkRelievoDeferred import vtkRelievoLamps

_FALLOFFS = {
    "linear": vtkRelievoLamps.LINEAR,
    "inverse-square": vtkRelievoLamps.INVERSE_SQUARE,
    "vtk": vtkRelievoLamps.VTK,
}
_CASTS = {
    None: vtkRelievoLamps.CASTS_IF_LARGE,
    False: vtkRelievoLamps.CASTS_NEVER,
    True: vtkRelievoLamps.CASTS_ALWAYS,
}


def lamps(renderer, points, radius=None, intensity=None, color=None, falloff="linear",
          attenuation=None, casts=None):
    """Lights what the renderer draws with a lamp at each point.

        relievo.lamps(renderer, street_lamps, radius=12, color=(1, 0.8, 0.5))

    renderer: a vtkRenderer; the frame is attached if there is none. points: a vtkDataSet, a
    composite dataset, or an algorithm or its output port, followed when it changes.
    radius (world units), intensity: a number for all, or the name of a point array; color: linear
    red, green, blue, or the name of a point array. None takes the array "radius", "intensity" or
    "color" if the points have it, else 1, 1 and white. falloff: "linear", "inverse-square" or
    "vtk", with attenuation = (constant, linear, quadratic) as vtkLight has it.
    casts: whether the lamps cast shadows, True or False, or the name of a point array of 1 and 0.
    None takes the array "casts", else as many of the largest lamps cast as the stage says, of all
    that there are: relievo.stage(renderer, "lamps", casting=4), by default none. At most eight
    cast in a picture; all others shine through walls.

    Returns the vtkRelievoLamps; attach(renderer).GetStage("lamps").RemovePoints(it) takes it away.
    Raises ValueError for wrong arguments; then nothing is changed.
    """
    require(renderer, "vtkRenderer", "renderer")
    made = vtkRelievoLamps()
    set_points(made, "lamps", points)
    set_value(made, "lamps", "radius", radius, made.SetRadius, 0)
    set_value(made, "lamps", "intensity", intensity, made.SetIntensity)
    set_color(made, "lamps", color)
    if falloff not in _FALLOFFS:
        raise ValueError(f"lamps: falloff: got {falloff!r}, expected one of {', '.join(_FALLOFFS)}")
    made.SetFalloff(_FALLOFFS[falloff])
    if attenuation is not None:
        if falloff != "vtk":
            raise ValueError("lamps: attenuation: expected falloff='vtk' with it")
        made.SetAttenuationValues(*three("lamps", "attenuation", attenuation))
    if isinstance(casts, str):
        made.SetArray("casts", casts)
    elif casts is None or isinstance(casts, bool):
        made.SetCasts(_CASTS[casts])
        made.SetArray("casts", "casts" if casts is None else "")
    else:
        raise ValueError(f"lamps: casts: got {casts!r}, expected True, False, or the name of a "
                         f"point array")
    attach(renderer).GetStage("lamps").AddPoints(made)
    return made
