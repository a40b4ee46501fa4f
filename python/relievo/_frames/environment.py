# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lights a renderer by a picture of all directions."""

import inspect
import os
import textwrap
from typing import Any

import numpy

from .._arguments.errors import Watch, check_file, is_a, require
from .._arguments.errors import describe as described
from .._arguments.parameters import bind, describe, keywords, names, set_value, value
from .._arguments.renderers import need_renderer
from .._images.image import to_image
from ..vtk.vtkCommonCore import vtkWeakReference
from ..vtk.vtkCommonDataModel import vtkImageData
from ..vtk.vtkRenderingCore import vtkCamera, vtkLight
from ..vtkRelievoFilters import vtkRelievoEnvironmentIrradiance, vtkRelievoEnvironmentPrefilter
from ..vtkRelievoIO import vtkRelievoImageReader
from ..vtkRelievoMaterials import vtkRelievoEnvironment, vtkRelievoMaterial, vtkRelievoSkybox
from .frame import frame_of
from .stages import stage

_NO_SURFACES = ("vtkAxisActor", "vtkCubeAxesActor", "vtkSkybox")
_MAKE_SURFACES = ("vtkGlyph3DMapper", "vtkOpenGLSphereMapper", "vtkOpenGLStickMapper")  # of points
_SHARPEST = 128  # texels across a face of the sharpest level
_TOLERANCE = 2e-3  # error of the levels' sums, as on the command line


# Defaults of materials for actors without their own; other defaults are those of the classes.
_OF_MIRRORS = [
    name for name in names(vtkRelievoMaterial())
    if vtkRelievoMaterial().GetParameterCondition(name) == "environment"
]
_OF_ENVIRONMENT = names(vtkRelievoEnvironment())
_DEFAULTS = {
    **{name: vtkRelievoEnvironment().GetParameterDefault(name) for name in _OF_ENVIRONMENT},
    **{name: vtkRelievoMaterial().GetParameterDefault(name) for name in _OF_MIRRORS},
    "gamma_correct": "on",  # pictures are for displays
    "roughness": "0.2",
}
_SIGNATURE = inspect.Signature(
    keywords({"renderer": inspect.Parameter.empty, "path": inspect.Parameter.empty})
    + keywords({**{name: value(text) for name, text in _DEFAULTS.items()}, "sky": True,
                "tone": False}),
    return_annotation=vtkRelievoEnvironment,
)


def environment(*arguments, **given):
    bound = bind("environment", _SIGNATURE, arguments, given)
    bound.apply_defaults()
    renderer, path = bound.arguments["renderer"], bound.arguments["path"]
    inner = need_renderer(renderer)
    if path is None:
        _remove(inner)
        return None
    made, own = vtkRelievoEnvironment(), vtkRelievoMaterial()
    for owner, of_owner in ((made, _OF_ENVIRONMENT), (own, _OF_MIRRORS)):
        for name in of_owner:
            set_value("environment", owner, name, bound.arguments[name])
    actors = _actors(inner)
    there = [vtkRelievoMaterial.Get(actor) for actor in actors]
    rough = any(each is not None and each.GetRoughness() > 0 for each in [own, *there])
    _fill(made, path, rough)
    made.relievo_own = True  # VTK keeps attributes as long as the object lives
    _remove(inner)
    frame = frame_of(inner)
    if bound.arguments["tone"] and not (frame and frame.GetStage("tone").GetEnabled()):
        # Reinhard's curve keeps differences of bright light, such as that of skies.
        stage(inner, "tone", operator="reinhard")
        object.__setattr__(inner, "relievo_tone", True)  # PyVista's renderers refuse new ones
    if bound.arguments["sky"]:
        shown = vtkRelievoSkybox()
        shown.SetEnvironment(made)
        # The first frame resets a camera that has not been requested before.
        camera = inner.GetActiveCamera() if inner.IsActiveCameraCreated() else vtkCamera()
        shown.SetParallelViewAngle(camera.GetViewAngle())
        shown.relievo_own = True
        inner.AddViewProp(shown)
    own.SetEnvironment(made)
    own.relievo_own = True
    for actor in actors:
        _placed.append(_Placed(inner, actor, made, own))
    object.__setattr__(inner, "relievo_null_light", _NullLight(inner))
    return made


def _describe():
    """The docstring of environment()."""
    images = vtkRelievoImageReader.GetExtensions().replace(" ", ", ")
    made, own = vtkRelievoEnvironment(), vtkRelievoMaterial()
    lines = [describe(made, name, _DEFAULTS[name]) for name in _OF_ENVIRONMENT]
    lines += [
        describe(own, name, _DEFAULTS[name]) + " Not of actors with a material of their own."
        for name in _OF_MIRRORS
    ]
    values = "\n".join(textwrap.fill(line, 96, subsequent_indent="    ") for line in lines)
    return f"""Lights all actors by a picture of all directions, which they mirror, as the sky.

    relievo.environment(renderer, "forest.exr")
    relievo.environment(renderer, None)                     # as it was before

renderer: a vtkRenderer, or an object whose attribute `renderer` is one (a plotter); its actors
    at the time of the call, except unlit ones, those of only lines or points, cube axes and
    VTK's skies. An actor's own vtkRelievoMaterial stays and gets the environment; None restores
    its former one.
path: a file ({images}), a numpy array of (rows, columns, 3) with row 0 at the top, a vtkImageData
    with row 0 at the bottom, as to_image() makes it, or a vtkTexture of one; twice as wide as
    high (all directions) or square (a mirror ball). Whole numbers are decoded from sRGB, floats
    are linear light. None takes the environment away.
{values}
sky: whether the picture is shown behind everything.
tone: whether the stage `tone` maps the sum of the picture's and the renderer's lights to the
    display's range, with the operator `reinhard` if the stage is still off; without tone, sums
    above 1 are clipped.

Returns the vtkRelievoEnvironment, None for None. Another call replaces it. Roughness above 0 takes
a second.

Raises ValueError for an invalid argument or an image of another shape, OSError (FileNotFoundError)
if the file cannot be read; then nothing is changed.
"""


environment.__signature__ = _SIGNATURE  # type: ignore[attr-defined]
environment.__doc__ = _describe()


class _Placed:
    """An environment on an actor, until it is removed. Holds only weak references."""

    def __init__(self, renderer, actor, environment, own):
        material = vtkRelievoMaterial.Get(actor)
        if material is None or _is_own(material):
            own.Attach(actor)
            material = own
        else:
            if not _is_own(material.GetEnvironment()):
                material.relievo_before = material.GetEnvironment()
            material.SetEnvironment(environment)
        self._weak = []
        for each in (renderer, actor, environment, material):
            self._weak.append(vtkWeakReference())
            self._weak[-1].Set(each)

    def renderer(self):
        """The renderer, None if it is gone."""
        return self._weak[0].Get()

    def take_away(self):
        """Removes the environment unless it or the material has been replaced meanwhile."""
        _, actor, environment, material = [each.Get() for each in self._weak]
        if actor is None or material is None or vtkRelievoMaterial.Get(actor) is not material:
            return
        if _is_own(material):
            material.Detach(actor)
        elif environment is not None and material.GetEnvironment() is environment:
            material.SetEnvironment(getattr(material, "relievo_before", None))
            material.relievo_before = None


class _NullLight:
    """A light of intensity 0 during frames in which no light is on: without any light, VTK's
    shaders show full colours without shading, and have no normals."""

    def __init__(self, renderer):
        self._light = vtkLight()
        self._light.SetLightTypeToHeadlight()
        self._light.SetIntensity(0)
        self._tags = [renderer.AddObserver("StartEvent", self._place),
                      renderer.AddObserver("EndEvent", self._remove)]

    def take_away(self, renderer):
        for tag in self._tags:
            renderer.RemoveObserver(tag)

    def _place(self, renderer, _event):
        lights = list(renderer.GetLights())
        makes_one = not lights and renderer.GetAutomaticLightCreation()
        if not makes_one and not any(light.GetSwitch() for light in lights):
            renderer.AddLight(self._light)

    def _remove(self, renderer, _event):
        renderer.RemoveLight(self._light)


_placed: list[Any] = []  # of all calls


def _is_own(thing):
    return getattr(thing, "relievo_own", False)


def _remove(renderer):
    if getattr(renderer, "relievo_tone", False):
        if frame_of(renderer) is not None:
            stage(renderer, "tone", on=False)
        object.__setattr__(renderer, "relievo_tone", False)
    null_light = getattr(renderer, "relievo_null_light", None)
    if null_light is not None:
        null_light.take_away(renderer)
        object.__setattr__(renderer, "relievo_null_light", None)
    for prop in list(renderer.GetViewProps()):
        if _is_own(prop) and prop.IsA("vtkRelievoSkybox"):
            renderer.RemoveViewProp(prop)
    # Includes actors that have been removed from the renderer.
    for each in [each for each in _placed if each.renderer() in (renderer, None)]:
        each.take_away()
        _placed.remove(each)


def _actors(renderer):
    return [actor for actor in renderer.GetActors()
            if vtkRelievoMaterial.Get(actor) is not None or _is_lit_surface(actor)]


def _is_lit_surface(actor):
    shown = actor.GetProperty()
    if not shown.GetLighting() or any(actor.IsA(each) for each in _NO_SURFACES):
        return False
    if shown.GetRenderLinesAsTubes() or shown.GetRenderPointsAsSpheres():
        return True
    mapper = actor.GetMapper()
    if mapper is None or any(mapper.IsA(each) for each in _MAKE_SURFACES):
        return True
    data = mapper.GetInputDataObject(0, 0)
    return (data is None or not data.IsA("vtkPolyData") or data.GetNumberOfCells() == 0
            or data.GetNumberOfPolys() + data.GetNumberOfStrips() > 0)


def _fill(made, path, rough):
    if is_a(path, "vtkTexture") and not path.GetCubeMap():
        path.Update()
        path = path.GetInput()
        if path is None:
            raise ValueError("environment: path: got a vtkTexture without a picture")
    elif isinstance(path, numpy.ndarray):
        path = to_image(path)
    if hasattr(path, "IsA"):
        require(path, "vtkImageData", "path")
    elif not isinstance(path, (str, bytes, os.PathLike)):
        raise ValueError(f"environment: path: got {described(path)}, expected a file, a "
                         f"vtkImageData, a vtkTexture or a numpy array")
    image = path if is_a(path, "vtkImageData") else _read(os.fspath(path))
    name = "image" if image is path else os.fspath(path)
    columns, rows, slices = image.GetDimensions()
    if image.GetPointData().GetScalars() is None:
        raise ValueError(f"environment: {name}: expected an image with scalars")
    if slices != 1 or columns not in (rows, 2 * rows):
        raise ValueError(f"environment: {name}: got {columns} x {rows} x {slices} pixels, expected "
                         f"an image twice as wide as high (all directions) or square (a mirror "
                         f"ball)")
    kind = image.GetPointData().GetScalars().GetDataTypeAsString()
    srgb = kind not in ("float", "double")
    irradiance = vtkRelievoEnvironmentIrradiance()
    levels = vtkRelievoEnvironmentPrefilter()
    levels.SetSize(_SHARPEST)
    levels.SetTolerance(_TOLERANCE)
    with Watch(irradiance, levels) as watch:
        for each in (irradiance, levels) if rough else (irradiance,):
            each.SetInputData(image)
            each.SetInputSRGB(srgb)
            each.Update()
    watch.raise_as(ValueError, f"environment: {name}")
    made.SetImage(image)
    made.SetSRGB(srgb)
    made.SetLevels(levels.GetOutput() if rough else None)
    made.SetIrradiance(irradiance.GetOutput().GetColumnByName("radiance"))


def _read(path):
    check_file(path)
    reader = vtkRelievoImageReader()
    reader.SetFileName(path)
    with Watch(reader) as watch:
        reader.Update()
    watch.raise_as(ValueError, "environment")
    image = vtkImageData()
    image.ShallowCopy(reader.GetOutput())
    return image
