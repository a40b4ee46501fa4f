# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Spheres of fog from data."""

from ._errors import require
from ._frame import attach
from ._values import set_color, set_points, set_value
from .vtkRelievoEffects import vtkRelievoFogSpheres


def fog(renderer, points, radius=None, density=None, color=None, mode=None, overlap=None):
    """Lays a sphere of fog around each point, over what the renderer draws.

        relievo.fog(renderer, swamps, radius=30, density=0.05, color=(0.6, 0.7, 0.7))

    renderer: a vtkRenderer; the frame is attached if there is none. points: a vtkDataSet, a
    composite dataset, or an algorithm or its output port, followed when it changes.
    radius (world units), density (per world unit): a number for all, or the name of a point array;
    color: linear red, green, blue, or the name of a point array. None takes the array "radius",
    "density" or "color" if the points have it, else 1, 1 and white.
    mode: "beer" (e^(-density length) of the light passes) or "chord" (1 - density length /
    diameter); overlap: "sum" of optical depths, or the "dominant" sphere alone. They are the
    stage's, and so of all fog of the renderer; None leaves them as they are, "beer" and "sum" at
    first.

    Returns the vtkRelievoFogSpheres; attach(renderer).GetFogStage().RemovePoints(it) takes it away.
    Raises ValueError for wrong arguments; then nothing is changed.
    """
    require(renderer, "vtkRenderer", "renderer")
    made = vtkRelievoFogSpheres()
    set_points(made, "fog", points)
    set_value(made, "fog", "radius", radius, made.SetRadius, 0)
    set_value(made, "fog", "density", density, made.SetDensity, 0)
    set_color(made, "fog", color)
    choices = {"mode": ("beer", "chord"), "overlap": ("sum", "dominant")}
    asked = {"mode": mode, "overlap": overlap}
    given = {name: word for name, word in asked.items() if word is not None}
    for name, word in given.items():
        if word not in choices[name]:
            expected = ", ".join(choices[name])
            raise ValueError(f"fog: {name}: got {word!r}, expected one of {expected}")
    stage = attach(renderer).GetFogStage()
    for name, word in given.items():
        stage.SetParameter(name, word)
    stage.AddPoints(made)
    return made
