# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""pick(): the surface or volume that a pixel shows."""

import math
import operator
from typing import Any, NamedTuple

import numpy

from .._arguments.renderers import inner_renderer
from .._images.image import layer
from .capture import capture

_OF_SURFACES = ["depth", "position", "normal", "actor", "block", "cell"]
_OF_VOLUMES = ["volume_depth", "volume_position", "volume_normal", "volume_value",
               "volume_opacity", "volume"]  # fmt: skip


class Picked(NamedTuple):
    """The surface or volume that a pixel shows, whichever is nearer."""

    kind: str
    """"surface", "volume", or "" where there is neither."""
    prop: Any
    """The vtkActor or vtkVolume; None without one, or for data."""
    index: int
    """Its index in renderer.GetActors() or renderer.GetVolumes(); -1: none."""
    block: int
    """Of a surface: flat index of the block in composite data, 0 in other data; -1: none."""
    cell: int
    """Of a surface: index of the cell in the drawn mesh; -1: none."""
    depth: float
    """Along the view direction, world units; infinity: none."""
    position: numpy.ndarray
    """World coordinates, in double; 0, 0, 0: none."""
    normal: numpy.ndarray
    """In world space; of a volume, the direction in which its values fall. 0, 0, 0: none."""
    value: float
    """Of a volume: the value of its data; else NaN."""
    opacity: float
    """Of all volumes in front of the surface together: 0 transparent, 1 opaque."""
    arrays: dict
    """Values of the requested arrays of the surface, by name."""

    def __bool__(self) -> bool:
        return bool(self.kind)


def _has_layers(renderer, size):
    """Whether any volume has layers."""
    try:
        capture(renderer, ["volume_opacity"], size)
    except ValueError:
        return False
    return True


def pick(renderer, x, y, arrays=(), size=None) -> Picked:
    """Returns the surface or volume that a pixel shows, its place, and values of the data there.

        found = relievo.pick(renderer, 320, 240)
        if found.kind == "volume":
            print(found.position, found.value, found.prop)

    renderer, size: as for capture(), which draws the layers of the whole picture once.
    x, y: column from the left and row from the top, from 0, as in arrays of layer().
    arrays: names of point and cell arrays of surfaces whose values are wanted.

    The place in a volume follows the rule of stage(renderer, "volumes", rule=..., opacity=...).

    The result, a Picked, is false where there is neither. If no volume has layers, only surfaces
    are found. Raises ValueError for a pixel outside the picture, and the errors of capture().
    """
    arrays = [arrays] if isinstance(arrays, str) else list(arrays)
    inside = inner_renderer(renderer)
    has_volumes = inside is not None and inside.GetVolumes().GetNumberOfItems() > 0
    of_surfaces = _OF_SURFACES + arrays
    try:
        x, y = operator.index(x), operator.index(y)
    except TypeError as error:
        raise ValueError(f"x, y: got {x}, {y}, expected whole numbers") from error
    try:
        image = capture(renderer, of_surfaces + (_OF_VOLUMES if has_volumes else []), size)
    except ValueError:
        if not has_volumes:
            raise
        image = capture(renderer, of_surfaces, size)
        if _has_layers(renderer, size):
            raise  # of volumes drawn in bricks, which have an opacity alone
        has_volumes = False
    columns, rows, _ = image.GetDimensions()
    if not (0 <= x < columns and 0 <= y < rows):
        raise ValueError(f"x, y: got {x}, {y}, expected a pixel of {columns} x {rows}")

    def at(name):
        return layer(image, name)[y, x].copy()

    opacity = float(at("volume_opacity")) if has_volumes else 0.0
    values = {name: at(name) for name in arrays}
    depth = float(at("depth"))
    # Rays through volumes end at the surface.
    if has_volumes and math.isfinite(at("volume_depth")):
        number = int(at("volume"))
        return Picked("volume", inside.GetVolumes().GetItemAsObject(number), number, -1, -1,
                      float(at("volume_depth")), at("volume_position"), at("volume_normal"),
                      float(at("volume_value")), opacity, values)  # fmt: skip
    number = int(at("actor"))
    known = inside is not None and number >= 0
    prop = inside.GetActors().GetItemAsObject(number) if known else None
    return Picked("surface" if math.isfinite(depth) else "", prop, number, int(at("block")),
                  int(at("cell")), depth, at("position"), at("normal"), math.nan, opacity,
                  values)  # fmt: skip
