# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relievo in PyVista 0.48 and later: plotter.relievo, and .exr files in read() and save().

PyVista finds this module by the entry points of the installed package `relievo`, without an import:

    plotter = pyvista.Plotter()
    plotter.add_mesh(mesh)
    plotter.relievo.shadows()                       # every light casts
    depth = plotter.relievo.layer("depth")          # numpy, (rows, columns), row 0 at the top
    plotter.relievo.environment("forest.exr")
    plotter.relievo.screenshot("picture.png")       # with all samples of soft shadows
    image = pyvista.read("frame.exr")               # one point array per layer
    image.save("copy.exr", compression="piz")

A wheel includes a VTK of its own, which PyVista takes if `import relievo` comes first, or if the
environment variable PYVISTA_VTK_BACKEND is relievo.vtk. Files need neither.

All of these but files are for the plotter's active renderer, like PyVista's own; plotter.subplot()
changes it. Call plotter.render() to update a picture that is already drawn. PyVista's passes (EDL,
SSAO, blur and so on) can be switched on and off before or after. With pyvista-render-passes, the
frame is inside its passes, which smooth and shade the frame's picture.
"""

import importlib
import weakref
from collections.abc import Callable, Sequence
from typing import Any

import numpy

import pyvista

if not hasattr(pyvista, "register_plotter_component"):
    raise ImportError(f"relievo.pyvista: got PyVista {pyvista.__version__}, expected 0.48 or later")

from ._arguments.errors import describe, is_a
from ._captures import capture as _capture
from ._captures import pick as _pick
from ._frames import environment as _environment
from ._frames import frame as _frame
from ._frames import stages as _stages
from ._frames import things as _things
from ._frames.keep import kept
from ._images import exr as _exr
from ._images import image as _image
from ._wrapped import vtkRelievoEnvironment, vtkRelievoPass, vtkRelievoStage
from .vtk.vtkCommonDataModel import vtkImageData

# Of renderers whose passes pyvista-render-passes builds.
_providers: weakref.WeakKeyDictionary[Any, "RenderPassProvider"] = weakref.WeakKeyDictionary()

_OF_LAYERS = ("lamps", "fog", "markers", "tone", "show")


def _refusal(used, settings):
    """Why stages of the frame and settings of pyvista-render-passes are incompatible, or None."""
    of_layers = [each for each in used if each in _OF_LAYERS]
    if settings.get("ssao") and of_layers:
        return (f"{', '.join(of_layers)} beside SSAO of plotter.render_passes, which draws to "
                f"buffers of its own: switch one of the two off")  # fmt: skip
    if settings.get("shadows") and "shadows" in used:
        return ("shadows beside those of plotter.render_passes: switch one of the two off, "
                "plotter.relievo.shadows(False)")  # fmt: skip
    return None


def _used(frame):
    """The stages of a frame that may conflict with settings of pyvista-render-passes."""
    points = ("lamps", "fog", "markers")
    found = [each for each in points if frame.GetStage(each).GetPoints(0) is not None]
    if frame.GetStage("tone").GetEnabled():
        found.append("tone")
    if frame.GetDisplayLayer():
        found.append("show")
    if frame.GetShadows():
        found.append("shadows")
    return found


@pyvista.register_plotter_component("relievo")
class RelievoComponent:
    """The accessor `plotter.relievo`: the functions of the package `relievo`, for the plotter."""

    # Made by _add().
    lamps: Callable[..., Any]
    fog: Callable[..., Any]
    markers: Callable[..., Any]

    def __init__(self, plotter: pyvista.Plotter) -> None:
        self._plotter = plotter
        self._renderers: list[Any] = []

    def _renderer(self):
        renderer = self._plotter.renderer
        if not is_a(renderer, "vtkRenderer"):
            raise RuntimeError(f"plotter.relievo: got {describe(renderer)}")
        if renderer not in self._renderers:
            self._renderers.append(renderer)
        return renderer

    def _kept(self):
        renderer = self._renderer()
        found = kept(renderer)
        if found is None:
            found = kept(renderer, attach=True)
            if renderer in _providers:
                _providers[renderer].invalidate()
        return found

    def _check(self, used):
        renderer = self._renderer()
        error = renderer in _providers and _refusal([used], _providers[renderer].settings)
        if error:
            raise ValueError(f"plotter.relievo: {error}")

    def _call(self, function, *arguments, **values):
        with self._kept().held() as renderer:
            return function(renderer, *arguments, **values)

    def shadows(self, on: bool = True, **parameters: Any) -> vtkRelievoStage:
        """Every light casts shadows, or none; parameters as of relievo.stage().

        Lights of PyVista's default kit follow the camera, and so do their shadows; a light with
        light_type="scene light" stays in place.
        """
        return self.stage("shadows", bool(on), **parameters)

    def environment(self, path: Any, **parameters: Any) -> vtkRelievoEnvironment:
        """As relievo.environment(): the light of a picture of all directions, and the sky."""
        return _environment.environment(self._renderer(), path, **parameters)

    def stage(self, name: str, on: bool = True, **parameters: Any) -> vtkRelievoStage:
        """As relievo.stage(): one of the frame's stages by name."""
        if on:
            self._check(name)
        return self._call(_stages.stage, name, on, **parameters)

    def show(self, layer: str | None) -> None:
        """Shows a layer as the picture; None shows the picture again."""
        if layer is not None:
            self._check("show")
        self.frame.SetDisplayLayer(layer)  # type: ignore[arg-type]

    def capture(self, layers: str | Sequence[str] = ("depth",), size: Sequence[int] | None = None,
                hdr: bool = False) -> pyvista.ImageData:  # fmt: skip
        """As relievo.capture(), as PyVista's ImageData; layer() gives numpy arrays."""
        return pyvista.wrap(self._captured(layers, size, hdr))

    def layer(self, name: str, size: Sequence[int] | None = None,
              hdr: bool = False) -> numpy.ndarray:  # fmt: skip
        """One layer of the visible surfaces, as a numpy array with row 0 at the top."""
        return _image.layer(self._captured(name, size, hdr), name)

    def pick(self, x: int, y: int, arrays: Sequence[str] = ()) -> _pick.Picked:
        """The surface or volume that a pixel of the active renderer shows: relievo.pick()."""
        self._renderer()
        return _pick.pick(self._plotter, x, y, arrays)

    def _captured(self, layers, size, hdr):
        self._renderer()
        window = self._plotter.render_window
        shown = window is not None and not window.GetNeverRendered()
        image = _capture.capture(self._plotter, layers, size, hdr)
        if shown:
            self._plotter.render()  # PyVista's pictures are taken from the window
        return image

    def screenshot(self, path: Any = None, size: Sequence[int] | None = None,
                   transparent: bool = False) -> numpy.ndarray:  # fmt: skip
        """As relievo.screenshot(): the active renderer's picture with all samples."""
        self._renderer()
        return _capture.screenshot(self._plotter, path, size, transparent)

    def report(self) -> dict[str, Any]:
        """As relievo.report(): a report on the stages of the last frames."""
        return _frame.report(self.frame)

    @property
    def frame(self) -> vtkRelievoPass:
        """The vtkRelievoPass of the active renderer, attached if there is none."""
        return self._kept().frame

    def off(self) -> None:
        """Removes Relievo from the active renderer, including environment and frame."""
        self._clear(self._plotter.renderer)

    def _clear(self, renderer):
        if renderer in self._renderers:
            self._renderers.remove(renderer)
            _environment.environment(renderer, None)
            found = kept(renderer)
            if found is not None:
                found.release()
            if renderer in _providers:
                _providers[renderer].invalidate()

    def __plotter_close__(self):
        for renderer in list(self._renderers):
            self._clear(renderer)

    __plotter_deep_clean__ = __plotter_close__


def _add(name, function):
    """Makes a function of a renderer a method of the accessor."""

    def method(self, points, **values):
        self._check(name)
        return self._call(function, points, **values)

    method.__name__ = name
    method.__doc__ = f"As relievo.{name}() for the plotter's active renderer."
    setattr(RelievoComponent, name, method)


for _name, _function in _things.functions().items():
    _add(_name, _function)


class RenderPassProvider:
    """The frame among the passes of pyvista-render-passes, which finds it by an entry point.

    It is around the scene's pass, below SSAO, EDL and SSAA, in renderers used with
    plotter.relievo.
    """

    name = "relievo"
    stages = ("base",)

    def __init__(self):
        self._invalidate = None
        self._renderer = None
        self.settings = {}  # known settings of the passes

    def bind(self, invalidate):
        """Stores the callback that rebuilds the passes."""
        self._invalidate = invalidate
        owner = getattr(invalidate, "__self__", None)
        if getattr(owner, "renderer", None) is not None:
            self._know(owner.renderer)

    def _know(self, renderer):
        _providers[renderer] = self
        self._renderer = weakref.ref(renderer)

    def invalidate(self):
        """Rebuilds the passes before the next frame."""
        if self._invalidate is not None:
            self._invalidate()

    def build_pass(self, stage, renderer, chain, delegate):
        """The frame around the delegate, or None where Relievo is not used."""
        self._know(renderer)
        found = kept(renderer)
        return found.give(delegate) if found is not None else None

    def default_state(self):
        """No settings: those of the frame's stages are plotter.relievo's."""
        return {}

    def get_state(self):
        """No settings."""
        return {}

    def set_state(self, state):
        """No settings."""

    def veto(self, settings):
        """Why settings are refused, or None."""
        renderer = self._renderer() if self._renderer is not None else None
        found = kept(renderer) if renderer is not None else None
        error = _refusal(_used(found.frame), settings) if found is not None else None
        if not error:
            self.settings = dict(settings)
        return error


def read_exr(path, **options):
    """Reads .exr files for pyvista.read(), by relievo.read_exr(), as PyVista's ImageData.

    PyVista itself fetches URLs and calls this function with a file.
    """
    if pyvista.has_scheme(str(path)):
        raise pyvista.LocalFileRequiredError(path)
    if options:
        raise TypeError(f"read: .exr files take no options, got {', '.join(options)}")
    return pyvista.wrap(_of_vtk(pyvista.ImageData(), _exr.read_exr(path)))


def write_exr(dataset, path, **options):
    """Writes .exr files for save(), by relievo.write_exr(), with its compression, pixel_types."""
    _exr.write_exr(path, _of_vtk(vtkImageData(), dataset), **options)


def _of_vtk(other, data):
    """The data, or a copy in the VTK of another object where that is another one."""
    give, take = (
        next(each.__module__ for each in type(thing).__mro__ if each.__name__ == "vtkObjectBase")
        for thing in (data, other)
    )
    if give == take:
        return data
    give, take = (
        importlib.import_module(f"{name.rpartition('.')[0]}.util.pickle_support")
        for name in (give, take)
    )
    _, (state,) = give.serialize_VTK_data_object(data)
    return take.unserialize_VTK_data_object(state)
