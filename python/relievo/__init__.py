# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measurable buffers of what VTK draws: depth, normals, positions, ids, data arrays.

    import relievo
    image = relievo.capture(renderer, layers=["depth", "normal", "cell"])
    depth = relievo.layer(image, "depth")      # numpy, (rows, columns), no copy
    relievo.write_exr("frame.exr", image)

Layers, single sample at the pixel's centre:

=================  ==========  ====================================================  ==========
name               components  what                                                  background
=================  ==========  ====================================================  ==========
depth              1 float     distance along the view direction, world units        +infinity
range              1 float     distance from the eye, world units                    +infinity
normal             3 float     unit shading normal, world space                      0
geometric_normal   3 float     unit normal of the triangle, world space              0
position           3 double    world position                                        0
albedo             4           surface colour before light, RGBA                     0
color              4 float     the picture, scene-linear and premultiplied           the window's
actor block cell   1 int       ids, from 0                                           -1
shadow_N           1 float     what is not blocked of light N: 1 lit, 0 dark         1
any array's name   as it is    point data interpolated, cell data as it is
=================  ==========  ====================================================  ==========

N counts renderer.GetLights() from 0; shadow_key_light is that of the light named "Key light"
(shadows.SetLightName). Layers shadow_N need no shadows in the picture; those are

    frame = relievo.attach(renderer)
    frame.ShadowsOn()                                 # every light casts; ShadowsOff() ends it
    shadows = frame.GetShadowPass()
    shadows.SetMapSize(4096)                          # texels; 2048 if not set
    shadows.SetLightCasts(light, False)               # a light that casts none
    shadows.SetPropCasts(actor, shadows.CASTS_NEVER)  # or CASTS_ALWAYS, CASTS_IF_OPAQUE (default)
    shadows.SetPropReceives(actor, False)

Wrong arguments raise ValueError, files OSError, drawing RuntimeError; each names what was given.
The wrapped classes (vtkRelievoPass, vtkRelievoEXRWriter, ...) are in this package as well.
"""

try:
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (its factories draw)
except ImportError as error:
    raise ImportError(
        f"relievo needs VTK's Python modules ({error}). With Debian's ParaView they belong to "
        "/usr/bin/python3 and pvpython: run one of these."
    ) from error

from ._wrapped import *  # noqa: F401,F403

from ._capture import capture
from ._exr import read_exr, write_exr
from ._frame import attach, detach, report
from ._image import attributes, layer, layer_names
from ._points import depth_to_points

__all__ = [
    "attach",
    "attributes",
    "capture",
    "depth_to_points",
    "detach",
    "layer",
    "layer_names",
    "read_exr",
    "report",
    "write_exr",
]
