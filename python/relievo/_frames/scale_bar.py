# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A bar that shows the scale of a picture."""

import math
import numbers

from .._arguments.renderers import need_renderer
from .._wrapped import vtkRelievoScaleBar


def scale_bar(renderer, unit=None, length=None) -> vtkRelievoScaleBar:
    """Shows a bar of a round length at the lower right of the picture, with its number and unit.

        bar = relievo.scale_bar(renderer, "mm")
        renderer.RemoveViewProp(bar)

    It follows the camera and the picture's size, and is in no layer. In a parallel projection it is
    exact everywhere; in perspective it is exact across the view at the depth of the camera's focal
    point, or at bar.SetDepth(distance along the view direction, world units).

    renderer: a vtkRenderer, or an object whose attribute `renderer` is one (a plotter).
    unit: the unit of the world's lengths, a text such as "µm"; None: only the number.
    length: of the bar, world units; None: 1, 2 or 5 times a power of ten that takes up to a fifth
        of the picture's width (bar.SetShare()). A bar wider than the picture is not drawn.

    Returns the vtkRelievoScaleBar. Another call replaces the bar.

    Raises ValueError for an invalid argument.
    """
    inner = need_renderer(renderer)
    if unit is not None and (not isinstance(unit, str) or "\n" in unit):
        raise ValueError(f"unit: got {unit!r}, expected a text in one line, such as 'mm', or None")
    if length is not None and not (
        isinstance(length, numbers.Real) and math.isfinite(length) and float(length) > 0
    ):
        raise ValueError(f"length: got {length!r}, expected a number above 0, or None")
    bar = vtkRelievoScaleBar()
    bar.SetUnit(unit or "")
    bar.SetLength(float(length or 0))
    for prop in [each for each in inner.GetViewProps() if each.IsA("vtkRelievoScaleBar")]:
        inner.RemoveViewProp(prop)
    inner.AddViewProp(bar)
    return bar
