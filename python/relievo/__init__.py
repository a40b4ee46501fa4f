# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measurable buffers of what VTK draws: depth, normals, positions, ids, data arrays.

    import relievo
    image = relievo.capture(renderer, layers=["depth", "normal", "cell"])
    depth = relievo.layer(image, "depth")      # numpy, (rows, columns), no copy
    relievo.write_exr("frame.exr", image)

    relievo.environment(renderer, "forest.exr")           # light, mirrors and sky
    relievo.scene("bike.obj").render("bike.png")
    relievo.write_baseline("bike.exr", renderer)
    assert relievo.compare("bike.exr", renderer)          # or which objects and lights differ
    relievo.rays(renderer).nearest(origins, directions)   # what rays hit, in double

Rows of numpy arrays run downwards, VTK's upwards: layer(), from_image() and to_image() turn them.

Layers, one sample per pixel, at its centre; layers() lists them for scripts:

=================  ==========  ====================================================  ==========
name               components  content                                               background
=================  ==========  ====================================================  ==========
depth              1 float     distance along the view direction, world units        +infinity
range              1 float     distance from the eye, world units                    +infinity
normal             3 float     unit shading normal, world space                      0
geometric_normal   3 float     unit normal of the triangle, world space              0
position           3 double    world position                                        0
albedo             4 uint8     surface colour before lighting, RGBA, 0 to 255        0
light              3 float     light of lamps, before the surface's colour           0
light_depth        1 float     depth in a light's shadow map, along its axis         +infinity
lamp_evaluations   1 float     number of lamps computed for the pixel                0
lamps_reaching     1 float     number of lamps that reach the pixel's surface        0
blend              4 float     translucent surfaces, linear light, premultiplied     0
color              4 float     the picture in linear light, premultiplied            renderer's
actor block cell   1 int       ids, from 0                                           -1
fog                1 float     transmittance of fog: 1 all, 0 nothing                1
ambient            1 float     visible share of the sky: 1 all, 0 nothing            1
marker             1 float     cover of the surface by markers, 0 to 1               0
volume_depth       1 float     depth of a volume, world units                        +infinity
volume_position    3 double    world position there                                  0
volume_value       1 float     value of the data there                               NaN
volume_normal      3 float     unit vector along falling values there, world space   0
volume_opacity     1 float     opacity of volumes before the surface, 0 to 1         0
volume             1 int       index of the volume, from 0                           -1
shadow_N           1 float     visibility of light N: 1 lit, 0 dark                  1
any array's name   the array's  point data interpolated, cell data per cell          NaN
=================  ==========  ====================================================  ==========

The background of color is the renderer's background in linear light, with its own alpha
(GetBackgroundAlpha(), 0 by default). N is an index in renderer.GetLights(), from 0;
shadow_key_light belongs to the light named "Key light" (shadows.SetLightName). These layers do not
need shadows in the picture. The place that stands for a volume follows a rule:
relievo.stage(renderer, "volumes", rule="opacity", opacity=0.5) takes the depth at which half of
the light is absorbed (the default), "first" the first visible sample, "strongest" the one that
contributes most. Shadows are switched on by

    frame = relievo.attach(renderer)
    frame.ShadowsOn()                                 # every light casts; see also ShadowsOff()
    shadows = frame.GetShadowStage()
    shadows.SetMapSize(4096)                          # texels; default 2048
    shadows.SetTolerance(0.0005)                      # or method and size for 0.05 % wrong pixels
    print(shadows.Certify(6000).GetWords())           # proves the last picture
    shadows.SetLightCasts(light, False)               # a light without shadows
    shadows.SetPropCasts(actor, shadows.CASTS_NEVER)  # or CASTS_ALWAYS, CASTS_IF_OPAQUE (default)
    shadows.SetPropReceives(actor, False)

Invalid arguments raise ValueError, file errors OSError and drawing errors RuntimeError; each
message says what was given. The package also contains the wrapped classes (vtkRelievoPass,
vtkRelievoEXRWriter, ...), and the VTK that it is built on, as relievo.vtk:

    from relievo.vtk.vtkRenderingCore import vtkRenderer
"""

import sys

if sys.version_info < (3, 11):
    raise ImportError("relievo: got Python %d.%d, expected 3.11 or later" % sys.version_info[:2])

from ._build import VERSION as __version__
from ._build import VTK as _vtk
from ._package import one_vtk as _one_vtk
from ._package import vtkmodules as _vtkmodules

_one_vtk.check()
_vtkmodules.prepare(_vtk)

try:
    from .vtk import vtkRenderingOpenGL2  # noqa: F401  (its factories draw)
except ImportError as error:
    raise ImportError(
        f"relievo needs VTK's Python modules ({error}). With Debian's ParaView they belong to "
        "/usr/bin/python3 and pvpython: run one of these."
    ) from error

from ._wrapped import *  # noqa: F401,F403

from ._captures.capture import capture, capture_many, screenshot
from ._captures.compare import compare, write_baseline
from ._captures.dataset import write_dataset
from ._captures.gltf import write_gltf
from ._captures.pick import pick
from ._frames.environment import environment
from ._frames.frame import report, vtkRelievoPass
from ._frames.keep import attach, detach
from ._frames.scale_bar import scale_bar
from ._frames.stages import stage, stages
from ._frames.things import functions as _functions
from ._images.exr import read_exr, write_exr
from ._images.image import attributes, from_image, layer, layer_names, to_image
from ._images.layers import layers
from ._images.picture import picture, write_png
from ._images.points import depth_to_points
from ._images.show import show
from ._package import browser as _browser
from ._package import font as _font
from ._package.vtkmodules import provide_vtkmodules
from ._scene.parts import Part, PartStatus, merge, parts, status, verify
from ._scene.scene import scene
from ._sight.cameras import (
    CameraModel,
    Cube,
    Division,
    Equirectangular,
    Fisheye,
    Lidar,
    Orthographic,
    Pinhole,
    Pushbroom,
    camera,
    extrinsics,
    intrinsics,
    lens,
)
from ._sight.rays import rays
from ._sight.scatter import scatter
from ._sight.sight import cover, flow, moment, sun_exposure, view_factors, viewshed, visible
from ._sight.terrain import terrain

globals().update(_functions())  # lamps, fog, markers: each stage that draws points
_browser.prepare()
_font.offer_matplotlibs()

__all__ = [
    *_functions(),
    "CameraModel",
    "Cube",
    "Division",
    "Equirectangular",
    "Fisheye",
    "Lidar",
    "Orthographic",
    "Part",
    "PartStatus",
    "Pinhole",
    "Pushbroom",
    "attach",
    "attributes",
    "camera",
    "capture",
    "capture_many",
    "compare",
    "cover",
    "depth_to_points",
    "detach",
    "environment",
    "extrinsics",
    "flow",
    "from_image",
    "intrinsics",
    "layer",
    "layer_names",
    "layers",
    "lens",
    "merge",
    "moment",
    "parts",
    "pick",
    "picture",
    "provide_vtkmodules",
    "rays",
    "read_exr",
    "report",
    "scale_bar",
    "scatter",
    "scene",
    "screenshot",
    "show",
    "stage",
    "stages",
    "status",
    "sun_exposure",
    "terrain",
    "to_image",
    "verify",
    "view_factors",
    "viewshed",
    "visible",
    "vtkRelievoPass",
    "write_baseline",
    "write_dataset",
    "write_exr",
    "write_gltf",
    "write_png",
]
