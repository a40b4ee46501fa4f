# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Markers on surfaces, around points and actors."""

from ._errors import require
from ._frame import attach
from ._values import set_color, set_points, set_value, three
from .vtkRelievoEffects import vtkRelievoMarkers

_SHAPES = {
    "ring": vtkRelievoMarkers.RING,
    "glow": vtkRelievoMarkers.GLOW,
    "disc": vtkRelievoMarkers.DISC,
    "shadow": vtkRelievoMarkers.SHADOW,
}


def markers(renderer, things, shape="ring", radius=None, width=None, reach=None, opacity=None,
            color=None, up=None):
    """Marks surfaces around each point, or around actors, in what the renderer draws.

        relievo.markers(renderer, wells, radius=25, color=(0, 1, 0.4))
        relievo.markers(renderer, [ship, buoy], shape="shadow", up=(0, 0, 1))

    renderer: a vtkRenderer; the frame is attached if there is none. things: a vtkDataSet, a
    composite dataset, or an algorithm or its output port, followed when it changes; or a vtkProp3D,
    such as an actor, or several, followed as they move: distances are those from their boxes.
    shape: "ring", "glow" or "disc", on all that is within the radius; or "shadow", a soft dark blob
    on what lies below.
    radius (world units), width (of a ring, a share of its radius), reach (how far down a shadow
    falls, in radii), opacity: a number for all, or the name of a point array; color: linear red,
    green, blue, or the name of a point array. None takes the array of that name if the points have
    it, else 1, 0.2, 4, 0.8 and orange. up: where shadows fall from, three numbers; None: (0, 1, 0).

    Returns the vtkRelievoMarkers; attach(renderer).GetMarkersStage().RemovePoints(it) removes it.
    Raises ValueError for wrong arguments; then nothing is changed.
    """
    require(renderer, "vtkRenderer", "renderer")
    made = vtkRelievoMarkers()
    props = list(things) if isinstance(things, (list, tuple, set)) else [things]
    if props and all(getattr(each, "IsA", lambda name: False)("vtkProp3D") for each in props):
        for each in props:
            made.AddActor(each)
    elif isinstance(things, (list, tuple, set)):
        raise ValueError(f"markers: things: got {things!r}, expected vtkProp3Ds")
    else:
        set_points(made, "markers", things)
    if shape not in _SHAPES:
        raise ValueError(f"markers: shape: got {shape!r}, expected one of {', '.join(_SHAPES)}")
    made.SetShape(_SHAPES[shape])
    set_value(made, "markers", "radius", radius, made.SetRadius, 0)
    set_value(made, "markers", "width", width, made.SetWidth, 0)
    set_value(made, "markers", "reach", reach, made.SetReach, 0)
    set_value(made, "markers", "opacity", opacity, made.SetOpacity, 0)
    set_color(made, "markers", color)
    if up is not None:
        direction = three("markers", "up", up)
        if not any(direction) or not all(abs(each) < float("inf") for each in direction):
            raise ValueError(f"markers: up: got {up!r}, expected a direction")
        made.SetUp(*direction)
    attach(renderer).GetMarkersStage().AddPoints(made)
    return made
