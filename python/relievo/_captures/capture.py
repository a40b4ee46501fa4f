# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Captures a renderer's layers as an image."""

import os
import threading
import weakref
from collections.abc import Iterable
from contextlib import contextmanager, nullcontext
from typing import Any

import numpy

from .._arguments.arrays import why_not
from .._arguments.errors import Watch, describe, is_a
from .._arguments.renderers import inner_renderer, renderer_of
from .._frames.frame import put, take
from .._frames.keep import kept
from .._images.image import from_image, layer
from .._images.picture import captured, write_png
from .._sight.cameras import CameraModel, sensor_of
from .._sight.rays import Rays, rays
from .._sight.sight import FLOW_LAYERS, NEEDS_MOMENT, Moment, layers_by_rays
from ..vtk import vtkCommonCore
from ..vtk.util.numpy_support import vtk_to_numpy
from ..vtk.vtkCommonCore import vtkVersion
from ..vtk.vtkCommonDataModel import vtkImageData
from ..vtk.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter
from ..vtk.vtkRenderingOpenGL2 import vtkTextureObject
from ..vtkRelievoPasses import vtkRelievoDisplay, vtkRelievoLayerSource, vtkRelievoLensPicture

_LARGEST = 16384  # pixels each way; OpenGL's own limit, known once there is a window, may be lower
_SIZE_OF_DATA = (1024, 768)


def capture(renderer, layers=("depth",), size=None, hdr=False, camera=None, ambient=None,
            previous=None) -> vtkImageData:
    """Draws the renderer once and returns the layers of the visible surfaces.

    renderer: a vtkRenderer, or an object whose attribute `renderer` is one (a plotter). Its camera,
        lights, passes and window stay unchanged; but PyVista's plotter gets the camera that it
        would be shown with, unless it has been set. A renderer without a window is drawn in an
        off-screen one, and `size` is needed. Or a dataset (also composite), a filter that makes
        one, an object with a `dataset`, points of shape (n, 3), or an actor; it is drawn (data by
        its surface), seen along -z with y up, fitted to the picture. With a CameraModel also the
        Rays of rays(), for all layers but color.
    layers: names of layers, or one name; see help(relievo). Repeated names count once.
    size: (columns, rows) of the image in pixels, from 1 to 16384, or to OpenGL's limit where that
        is lower; None for the size of the renderer's viewport, (1024, 768) for data.
    hdr: whether the layer `color` is the linear colour of the frame, unclamped, without texts and
        colour bars; otherwise it is the window's picture, converted from 8 bits to linear light
        (but always the linear colour if the stage `tone` makes the picture).
    camera: a CameraModel (Pinhole with distortion, Fisheye, Equirectangular, Lidar, ...) that
        replaces the renderer's camera, in its own size: by a ray for each pixel, in double,
        without a window. It has depth, range, normal, geometric_normal, position, actor, block,
        cell, ambient and arrays by name; the field data holds R, t, and K, lens and distortion. It
        also has color, except for push-brooms and lidars: drawn by pinholes, which needs a display,
        and interpolated between their pixels.
    ambient: settings of the layer `ambient` with a CameraModel, a dict of samples (rays per pixel,
        64), radius (beyond which nothing occludes, world units; 0: no limit), weighting ("cosine"
        or "uniform") and seed (0). Without a CameraModel: stage(renderer, "ambient", ...).
    previous: an earlier moment() of the scene. It gives the layers flow (2 floats: pixels,
        x right, y down, from this picture to where the same point of the surface was in that one;
        NaN where there is none), motion (3 floats: from here to there, world units) and flow_valid
        (1 where that picture shows the point), by rays; see flow(). They are of opaque surfaces, as
        the other layers; with a CameraModel all include translucent ones. If no other layer is
        requested, nothing is drawn, and the field data is that of a CameraModel. An array of such
        a name is then "point:flow" or "cell:flow".

    Returns vtkImageData, which notebooks show as pictures, of (columns, rows, 1) points with one
    point array per layer; VTK's row 0 is the BOTTOM of the picture (layer() gives numpy arrays with
    row 0 at the top). The field data
    holds the camera: worldToCamera, worldToNDC (16 doubles, by rows), near, far, relievo:origin,
    and lights. depth and range are float in world units, position is double in world space.

    Raises ValueError for invalid arguments, such as a layer that no data has or a size above
    the limit, and RuntimeError if the layers cannot be drawn, or there is no display.
    """
    layers = _names(layers)
    flows = _check_flow(layers, previous)
    if camera is not None:
        if not isinstance(camera, CameraModel):
            raise ValueError(f"camera: got {describe(camera)}, expected a CameraModel such as "
                             f"relievo.Fisheye; relievo.camera() sets a renderer's own")
        if size not in (None, camera.size):
            raise ValueError(f"size: got {size!r}, expected none with a camera, which has its own")
        (image,) = _seen_by(renderer, [camera], layers, hdr, ambient, previous)
        return captured(image)
    if ambient is not None:
        raise ValueError("ambient: got settings without a camera, expected them of the stage: "
                         "relievo.stage(renderer, 'ambient', samples=...)")
    thing = renderer
    renderer, made = renderer_of(renderer)
    if made and size is None:
        size = _SIZE_OF_DATA
    if size is not None:
        size = _pixels(size)
    drawn = [name for name in layers if name not in flows]
    if not drawn and not made:
        sensor = sensor_of(renderer, _viewport_of(renderer) if size is None else size)
        return captured(layers_by_rays(thing, flows, sensor, None, previous, opaque_only=True))
    drawn = drawn or ["depth"]  # fits the camera to data
    source = vtkRelievoLayerSource()
    source.SetHDR(bool(hdr))
    for name in drawn:
        source.AddLayer(name)
    found = kept(renderer)
    held = nullcontext() if found is None else found.held()
    with held, _window_of(renderer, size), _frame_of(renderer) as frame:
        if made:
            renderer.ResetCamera()
        source.SetRenderer(renderer)
        with Watch(frame.GetLayersStage(), frame, source) as watch:
            source.Update()
        _check_drawn(watch, source, frame, renderer, drawn)
    image = source.GetOutput()
    if flows:
        sensor = sensor_of(renderer, image.GetDimensions()[:2])
        found = layers_by_rays(thing, flows, sensor, None, previous, opaque_only=True)
        image = _merged(layers, image, found)
    return captured(image)


def capture_many(renderer, cameras, layers=("depth",), size=None, hdr=False) -> dict:
    """Returns the layers that many cameras see of one scene, as numpy arrays.

        poses = [relievo.camera(K=K, size=(64, 64), R=R, t=t) for R, t in found]
        seen = relievo.capture_many(renderer, poses, ["depth", "normal"], size=(64, 64))
        seen["depth"].shape                          # (len(poses), 64, 64)

    renderer, layers, hdr: as for capture(), with CameraModels also the Rays of rays().
    cameras: vtkCameras, which take the place of the renderer's camera one after the other; or
        CameraModels of one size, whose layers are found by rays.
    size: (columns, rows) of each view; None for the size of the renderer's viewport, or that of the
        CameraModels.

    Returns a dict of arrays by layer, (n, rows, columns) or (n, rows, columns, components), ROW 0
    AT THE TOP, which equal those of n calls of capture() bit for bit. The window and the scene are
    prepared once for all views, and layers of surfaces are drawn together and read at once. Raises
    as capture(), ValueError without cameras, and MemoryError for more views than fit into the
    memory left.
    """
    layers = _names(layers)
    given, cameras = cameras, list(cameras) if isinstance(cameras, Iterable) else []
    by_rays = bool(cameras) and all(isinstance(each, CameraModel) for each in cameras)
    if not cameras or not (by_rays or all(is_a(each, "vtkCamera") for each in cameras)):
        raise ValueError(f"cameras: got {describe(given)}, expected vtkCameras or CameraModels")
    if not by_rays:
        return _drawn_by(renderer, cameras, layers, size, hdr)
    if size not in (None, cameras[0].size) or len({each.size for each in cameras}) != 1:
        raise ValueError(f"size: got {size!r} and CameraModels of the sizes "
                         f"{sorted({each.size for each in cameras})}, expected models of one size, "
                         "which is that of the views")
    arrays = {}
    for i, image in enumerate(_seen_by(renderer, cameras, layers, hdr)):
        for name in layers:
            values = layer(image, name)
            if i == 0:
                arrays[name] = numpy.empty((len(cameras), *values.shape), values.dtype)
            arrays[name][i] = values
    return arrays


def _drawn_by(renderer, cameras, layers, size, hdr):
    """Arrays of the layers in all cameras, drawn in one window."""
    renderer, made = renderer_of(renderer)
    size = _SIZE_OF_DATA if made and size is None else size
    size = None if size is None else _pixels(size)
    source = vtkRelievoLayerSource()
    source.SetHDR(bool(hdr))
    for name in layers:
        source.AddLayer(name)
    for camera in cameras:
        source.AddView(camera)
    found = kept(renderer)
    held = nullcontext() if found is None else found.held()
    with held, _window_of(renderer, size), _frame_of(renderer) as frame:
        source.SetRenderer(renderer)
        with Watch(frame.GetLayersStage(), frame, source) as watch:
            source.Update()
        _check_drawn(watch, source, frame, renderer, layers)
    views = source.GetOutput()
    columns, rows, _ = views.GetDimensions()
    arrays = {}
    for name in layers:
        values = vtk_to_numpy(views.GetPointData().GetArray(name))
        values = values.reshape(len(cameras), rows, columns, *values.shape[1:])
        arrays[name] = numpy.ascontiguousarray(values[:, ::-1])
        del values
        views.GetPointData().RemoveArray(name)  # not all layers twice in memory
    return arrays


def _check_drawn(watch, source, frame, renderer, names):
    """Raises if the layers were not drawn."""
    if not watch.errors and source.GetErrorCode() == 0:
        return
    failed = any(
        frame.GetStage(i).GetReasonCode() in ("failed", "refused")
        for i in range(frame.GetNumberOfStages())
    )
    unknown_name = not failed and source.GetErrorCode() == vtkRelievoLayerSource.NO_SUCH_LAYER
    for name in names if unknown_name else ():
        error = why_not(name, renderer, None)  # lists the existing arrays
        if error:
            hint = NEEDS_MOMENT if name in FLOW_LAYERS else ""
            raise ValueError(f"capture: {error}{hint}")
    watch.raise_as(ValueError if unknown_name else RuntimeError, f"capture {', '.join(names)}")


def _viewport_of(renderer):
    """The size of the renderer's viewport."""
    if renderer.GetRenderWindow() is None:
        raise ValueError("size: the renderer has no window, expected size=(columns, rows)")
    return tuple(renderer.GetSize())


def _check_flow(layers, previous):
    """The layers that need another moment."""
    if previous is None:
        return []
    flows = [name for name in layers if name in FLOW_LAYERS]
    if not isinstance(previous, Moment):
        raise ValueError(f"previous: got {describe(previous)}, expected what moment() returns")
    if not flows:
        raise ValueError(f"previous: got a moment, expected one of {', '.join(FLOW_LAYERS)} among "
                         f"the layers, which go to it")
    return flows


def _merged(layers, *images):
    """One image with the layers of several images, in this order."""
    image = images[0].NewInstance()
    image.CopyStructure(images[0])
    image.SetFieldData(images[0].GetFieldData())
    for name in layers:
        arrays = (each.GetPointData().GetArray(name) for each in images)
        image.GetPointData().AddArray(next(each for each in arrays if each is not None))
    return image


def screenshot(renderer, path=None, size=None, transparent=False) -> numpy.ndarray:
    """Draws the renderer's picture, with all samples of soft shadows, antialiasing and the like.

        relievo.screenshot(plotter, "picture.png", size=(1920, 1080))

    renderer, size: as for capture(). path: a PNG file to write, None for none.
    transparent: whether to include alpha, not premultiplied: 0 in the background.

    Returns uint8 of (rows, columns, 3), or 4 with alpha, ROW 0 AT THE TOP: the window's picture in
    the renderer's viewport after all samples, including other renderers' layers. For numbers, use
    capture().

    Raises as capture(), and OSError if the file cannot be written.
    """
    renderer, made = renderer_of(renderer)
    size = _SIZE_OF_DATA if made and size is None else size
    size = None if size is None else _pixels(size)
    found = kept(renderer)
    held = nullcontext() if found is None else found.held()
    with held, _window_of(renderer, size), _frame_of(renderer) as frame:
        if made:
            renderer.ResetCamera()
        waits = frame.GetWaitForSamples()
        frame.WaitForSamplesOn()
        try:
            if transparent:
                pixels = _grab_transparent(renderer, frame)
            else:
                pixels = _grab(renderer, frame)
        finally:
            frame.SetWaitForSamples(waits)
    if path is not None:
        write_png(path, pixels)
    return pixels


def _grab_transparent(renderer, frame):
    with _background(renderer, 0):
        pixels = _grab(renderer, frame, alpha=True)
    alpha = pixels[..., 3:]
    if _loses_alpha(renderer, frame):
        with _background(renderer, 1):
            over_white = _grab(renderer, frame).astype(int)
        through = (over_white - pixels[..., :3]).mean(axis=-1, keepdims=True)
        alpha[...] = numpy.clip(numpy.rint(255 - through), 0, 255)
    # Over black: premultiplied.
    straight = numpy.minimum(pixels[..., :3] * 255.0 / numpy.maximum(alpha, 1) + 0.5, 255)
    pixels[..., :3] = numpy.where(alpha > 0, straight, 0)
    return pixels


def _loses_alpha(renderer, frame):
    """Whether VTK has blended translucent surfaces by its weighted average, which before 9.3 leaves
    a (1 - a) instead of the alpha a."""
    version = vtkVersion()
    return (
        (version.GetVTKMajorVersion(), version.GetVTKMinorVersion()) < (9, 3)
        and not renderer.GetUseDepthPeeling()
        and frame.GetStage("blend").GetReasonCode() != "ran"
        and any(prop.HasTranslucentPolygonalGeometry() for prop in renderer.GetViewProps())
    )


def _grab(renderer, frame, alpha=False):
    window = renderer.GetRenderWindow()
    no_display = vtkRelievoDisplay.Check(window)
    if no_display:
        raise RuntimeError(f"screenshot: {no_display}")
    with Watch(frame) as watch:
        window.Render()
    watch.raise_as(RuntimeError, "screenshot")
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.SetInputBufferType(4 if alpha else 3)  # VTK_RGBA, VTK_RGB
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    shown = from_image(grab.GetOutput())
    left, below = renderer.GetOrigin()
    columns, rows = renderer.GetSize()
    top = shown.shape[0] - below - rows
    return shown[top:top + rows, left:left + columns].copy()


@contextmanager
def _background(renderer, level):
    """Sets a grey background, 0 to 1, without alpha; restores the former one at the end."""
    background, alpha = renderer.GetBackground(), renderer.GetBackgroundAlpha()
    gradient, textured = renderer.GetGradientBackground(), renderer.GetTexturedBackground()
    renderer.SetBackground(level, level, level)
    renderer.SetBackgroundAlpha(0)
    renderer.SetGradientBackground(False)
    renderer.SetTexturedBackground(False)
    try:
        yield
    finally:
        renderer.SetBackground(background)
        renderer.SetBackgroundAlpha(alpha)
        renderer.SetGradientBackground(gradient)
        renderer.SetTexturedBackground(textured)


def _seen_by(thing, sensors, layers, hdr, ambient=None, previous=None):
    """An image for each CameraModel."""
    names = [name for name in layers if name != "color"]
    scene = _rays_of(thing, previous) if names else thing
    renderer = None if len(names) == len(layers) else renderer_of(thing)[0]
    for sensor in sensors:
        image = layers_by_rays(scene, names, sensor, ambient, previous) if names else None
        if renderer is not None:
            drawn = _color(renderer, hdr, sensor)
            image = drawn if image is None else _merged(layers, image, drawn)
        yield image


_trees = threading.local()


def _rays_of(thing, previous):
    """The Rays of the thing. Those of a renderer are kept for its next capture, until another
    renderer is captured, or no reference to it is left in Python."""
    renderer = None if isinstance(thing, Rays) else inner_renderer(thing)
    if renderer is None or previous is not None:  # which would set how points are matched
        return thing if isinstance(thing, Rays) else rays(thing)
    trees = _trees.__dict__.setdefault("by_renderer", weakref.WeakKeyDictionary())
    if renderer not in trees:
        trees.clear()
        trees[renderer] = rays(thing)
    return trees[renderer]


def _color(renderer, hdr, sensor):
    source = vtkRelievoLensPicture()
    source.SetRenderer(renderer)
    source.SetCamera(sensor.model)
    source.SetHDR(bool(hdr))
    found = kept(renderer)
    held = nullcontext() if found is None else found.held()
    size = None if renderer.GetRenderWindow() else (1, 1)  # a spare window, resized as needed
    with held, _window_of(renderer, size), _frame_of(renderer) as frame:
        with Watch(source, frame) as watch:
            source.Update()
    watch.raise_as(ValueError if source.GetErrorCode() else RuntimeError, "capture color")
    return source.GetOutput()


def _names(layers):
    try:
        names = [layers] if isinstance(layers, str) else list(layers)
    except TypeError:
        names = []
    if not names or not all(isinstance(name, str) and name for name in names):
        raise ValueError(f"layers: got {layers!r}, expected names of layers such as ['depth']")
    return list(dict.fromkeys(names))


def _pixels(size):
    try:
        columns, rows = size
        whole = int(columns) == columns and int(rows) == rows
    except (TypeError, ValueError, OverflowError):
        whole = False
    if not whole or not (1 <= columns <= _LARGEST and 1 <= rows <= _LARGEST):
        raise ValueError(
            f"size: got {size!r}, expected (columns, rows), whole and from 1 to {_LARGEST}"
        )
    return int(columns), int(rows)


@contextmanager
def _frame_of(renderer):
    """The frame of the renderer, which is removed at the end if it was attached here."""
    before = renderer.GetPass()
    frame = put(renderer)
    if frame is before:
        yield frame
        return

    def keep(*_):
        there = renderer.GetPass()
        if there is not frame:
            frame.SetDelegatePass(there)
            renderer.SetPass(frame)

    # The last observer: others set passes in theirs.
    window = renderer.GetRenderWindow()
    watched = any(each.HasObserver("StartEvent") for each in (renderer, window) if each)
    tag = renderer.AddObserver("StartEvent", keep, -1.0) if watched else None
    try:
        yield frame
    finally:
        if watched:
            renderer.RemoveObserver(tag)
        take(renderer)


_spare_windows: dict[Any, Any] = {}  # by thread: a context is current in one only


def _spare_window():
    """The window of renderers that have none, made once: making an OpenGL context takes longer than
    many captures, and an X server that loses its only client restarts, unresponsive meanwhile."""
    window = _spare_windows.get(threading.get_ident())
    if window is None:
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(1, 1)
        _spare_windows[threading.get_ident()] = window
    return window


def _leave_spare_windows():
    """Leaves them to the parent of a forked process, whose display connection they would close."""
    for window in _spare_windows.values():
        window.Register(None)
    _spare_windows.clear()


def _leave_threads():
    """A forked process lacks the threads of VTK's pool, and would wait for them for ever."""
    tools = getattr(vtkCommonCore, "vtkSMPTools", None)
    if tools is not None and tools.GetBackend() == "STDThread":
        tools.SetBackend("Sequential")


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_leave_spare_windows)
    os.register_at_fork(after_in_child=_leave_threads)


@contextmanager
def _window_of(renderer, size):
    """Puts the renderer into a window where its viewport has that size; restores it at the end."""
    window = renderer.GetRenderWindow()
    if window is None:
        if size is None:
            size = _viewport_of(renderer)
        window = _spare_window()
        window.AddRenderer(renderer)
        try:
            _fit(window, renderer, size)
            yield
        finally:
            window.RemoveRenderer(renderer)
            _resize(window, 1, 1)
    elif size is None:
        yield
    else:
        before = window.GetSize()
        buffers = window.GetUseOffScreenBuffers()
        window.SetUseOffScreenBuffers(True)
        try:
            _fit(window, renderer, size)
            yield
        finally:
            _resize(window, *before)
            window.SetUseOffScreenBuffers(buffers)


def _fit(window, renderer, size):
    no_display = vtkRelievoDisplay.Check(window)
    if no_display:
        raise RuntimeError(f"capture: {no_display}")
    window.Initialize()  # at its own size: X ends the process for impossible sizes
    window.MakeCurrent()
    if not (window.IsCurrent() or window.IsA("vtkGenericOpenGLRenderWindow")):
        raise RuntimeError(
            "capture: another thread draws in the renderer's window; capture in that thread"
        )
    limit = vtkTextureObject.GetMaximumTextureSize(window)
    if max(size) > limit:
        raise ValueError(f"size: got {size!r}, expected at most {limit} each way, OpenGL's limit")
    viewport = renderer.GetViewport()
    tries = []
    for axis in (0, 1):
        share = viewport[axis + 2] - viewport[axis]
        if share <= 0:
            raise ValueError(f"renderer: its viewport {viewport} has no area")
        near = round(size[axis] / share)
        tries.append([near + step for step in (0, 1, -1, 2, -2) if near + step > 0])
    for columns in tries[0]:
        for rows in tries[1]:
            _resize(window, columns, rows)
            if tuple(renderer.GetSize()) == size:
                return
    raise ValueError(f"size: no window gives the viewport {viewport} exactly {size} pixels")


def _resize(window, columns, rows):
    # The base class's method changes only the buffers, not the window on the screen.
    vtkRenderWindow.SetSize(window, columns, rows)
