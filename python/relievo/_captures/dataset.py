# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data sets for training and evaluation: pictures, depth, masks, boxes, poses."""

import inspect
import json
import os
from collections.abc import Iterable
from contextlib import nullcontext

import numpy

from .._arguments.errors import Watch, describe, is_a, path_of
from .._arguments.parameters import (
    bind,
    defaults_of,
    describe_all,
    keywords,
    keywords_of,
    set_value,
)
from .._arguments.renderers import renderer_of
from .._frames.keep import kept
from .._sight.cameras import CameraModel, sensor_of
from .._sight.cameras import lens as lens_of
from .._wrapped import vtkRelievoDatasetWriter, vtkRelievoScene
from ..vtk.util.misc import calldata_type
from ..vtk.util.vtkConstants import VTK_DOUBLE, VTK_INT
from ..vtkRelievoCameras import vtkRelievoCalibration
from .capture import _frame_of, _names, _pixels

_SIZE = (1024, 768)

_OF_WRITER = keywords_of(vtkRelievoDatasetWriter(), {})
# The order of positional arguments; the writer's other parameters come last.
_ORDER = ("renderer", "cameras", "directory", "format", "layers", "size", "objects", "depth_step",
          "mm_per_unit", "seed", "random_sun", "up", "views", "description", "progress", "lens",
          "categories")
_OTHERS = {
    **dict.fromkeys(("renderer", "cameras", "directory"), inspect.Parameter.empty),
    **dict.fromkeys(("size", "views", "progress", "lens", "categories", "vary")),
    "layers": (), "objects": "actor", "description": "",
}  # fmt: skip
_ALL = {**_OTHERS, **defaults_of(vtkRelievoDatasetWriter(), _OF_WRITER), "depth_step": None}
_SIGNATURE = inspect.Signature(
    keywords({name: _ALL[name] for name in [*_ORDER, *_ALL]}), return_annotation=int)


def write_dataset(*arguments, **given):
    bound = bind("write_dataset", _SIGNATURE, arguments, given)
    bound.apply_defaults()
    given = bound.arguments
    made, _ = renderer_of(given["renderer"])
    writer = vtkRelievoDatasetWriter()
    writer.SetRenderer(made)
    writer.SetDirectory(path_of(given["directory"], "directory"))
    for keyword, name in _OF_WRITER.items():
        if given[keyword] is not None:
            set_value("write_dataset", writer, name, given[keyword], keyword)
    try:
        writer.SetDescription(given["description"])
    except TypeError:
        raise ValueError(f"description: got {describe(given['description'])}, expected a text"
                         ) from None
    views = given["views"]
    if views is not None:
        try:
            first, end = views
        except (TypeError, ValueError):
            raise ValueError(f"views: got {views!r}, expected (first, end)") from None
        writer.SetRange(_whole("views", first), _whole("views", end))
    for name in _names(given["layers"]) if given["layers"] else ():
        writer.AddLayer(name)
    _name_objects(writer, made, given["objects"])
    _name_categories(writer, given["categories"])
    size = given["size"]
    ended = []
    tag = None if given["vary"] is None else _vary(writer, given["vary"], ended)
    _add_views(writer, given["cameras"], None if size is None else _pixels(size), given["lens"])
    found = kept(made)
    held = nullcontext() if found is None else found.held()
    try:
        with held, _frame_of(made):
            _run(writer, writer.Write, given["progress"], ended)
    finally:
        if tag is not None:  # the observer holds the writer
            writer.RemoveObserver(tag)
    return writer.GetNumberOfViewsWritten()


write_dataset.__signature__ = _SIGNATURE  # type: ignore[attr-defined]
write_dataset.__doc__ = f"""Writes cameras' views of a scene as a data set. See docs/datasets.md.

    relievo.write_dataset(renderer, "random:200", "train/000000", seed=7)

renderer: a vtkRenderer, or an object whose attribute `renderer` is one (a plotter, a scene);
    or data or an actor, as for capture(). The renderer and its window stay unchanged.
cameras: "orbit:N", "random:N" or the path of a file of poses, for `lens`; or a list of
    CameraModels, or of vtkCameras as seen in `size` pixels. Other cameras than pinholes, such
    as a Fisheye, use rays, and their pictures are drawn by pinholes; a Pushbroom or a Lidar has
    no picture, and only the format "npz".
directory: a new or empty folder; or one that an equal call has begun, which is then continued
    with the missing views.
layers: names of layers to write as floats: as arrays of npz, otherwise in layers/NUMBER.exr.
size: (columns, rows) of pictures, unless the cameras have their own; None for the size in the
    lens's file, or (1024, 768).
objects: the kind of objects: "actor", "block" (of composite data), or a list of names, one for
    each of renderer.GetActors(): actors with equal names are one object; actors named None only
    occlude others.
{describe_all(vtkRelievoDatasetWriter(), _OF_WRITER)}
vary: a function of the view's number and a numpy.random.Generator, seeded with `seed` and this
    number. It changes the scene before the view is drawn, and returns a dictionary for the view's
    record, as "variation", or None. It must set all that it changes, because it is called more than
    once for view 0, and views are not drawn in order after an interruption; and keep the visible
    actors. The scene stays as it was for the last view. Layers of flow are refused.
views: (first, end) of the views to draw in this call; None for all.
description: a text about the data set; a folder begun with another description is refused.
progress: called with the share done after each view; if it returns False, the call ends with a
    RuntimeError, and an equal call continues from there.
lens: the camera for poses from a text or a file: a text or a calibration's file as for lens(),
    or a CameraModel; None for a pinhole of 30 degrees.
categories: {{category: [objects]}} for the formats coco, yolo and kitti: names of objects, or
    patterns with * and ?; other objects are categories of their own.

Returns the number of views written. Raises ValueError for invalid arguments, such as settings
other than those that the folder was begun with, OSError for files that cannot be written or
read, RuntimeError if drawing fails, TypeError if `vary` returns something that JSON does not have,
and the errors of `vary` itself.
"""


def _vary(writer, vary, ended):
    """Calls `vary` for each view, and now for the first one, which cameras are placed around."""
    if not callable(vary):
        raise ValueError(f"vary: got {describe(vary)}, expected a function of the view's number "
                         "and a numpy.random.Generator")

    def call(view):
        chosen = vary(view, numpy.random.default_rng((writer.GetSeed() % (1 << 32), view)))
        return json.dumps(chosen, default=_plain, allow_nan=False)

    @calldata_type(VTK_INT)
    def begin(_writer, _event, view):
        try:
            writer.SetVariation(call(view))
        except BaseException as error:  # also interrupts: VTK would swallow them
            ended.append(error)
            writer.SetAbort()

    call(0)
    writer.SceneVariesOn()
    return writer.AddObserver("StartEvent", begin)


def _plain(value):
    """numpy's values as JSON."""
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        return value.tolist()
    raise TypeError(f"vary: got {describe(value)} in its result, expected numbers, texts, lists, "
                    "dictionaries and numpy's arrays")


def _run(writer, work, progress=None, ended=None):
    """Runs `work`, and raises the writer's errors, those of `progress`, or the first of `ended`."""
    ended = [] if ended is None else ended

    @calldata_type(VTK_DOUBLE)
    def report(_writer, _event, share):
        try:
            if progress(share) is False:
                ended.append(RuntimeError(f"write_dataset: ended by progress at {share:.0%}"))
        except BaseException as error:  # also interrupts: VTK would swallow them
            ended.append(error)
        if ended:
            writer.SetAbort()

    tag = writer.AddObserver("ProgressEvent", report) if progress is not None else None
    try:
        with Watch(writer):
            done = work()
    finally:
        if tag is not None:
            writer.RemoveObserver(tag)
    if ended:
        raise ended[0]
    if not done:
        kinds = {
            vtkRelievoScene.USAGE_FAILURE: ValueError,
            vtkRelievoScene.FILE_FAILURE: OSError,
            vtkRelievoScene.DRAW_FAILURE: RuntimeError,
        }
        raise kinds[writer.GetFailure()](f"write_dataset: {writer.GetFailureText()}")


def _name_objects(writer, renderer, objects):
    if isinstance(objects, str):
        if objects not in ("actor", "block"):
            raise ValueError(f"objects: got {objects!r}, expected 'actor', 'block', or names")
        writer.SetObjectsByBlock(objects == "block")
        return
    names = list(objects) if isinstance(objects, Iterable) else [objects]
    count = renderer.GetActors().GetNumberOfItems()
    invalid = [name for name in names if not (name is None or isinstance(name, str))]
    if len(names) != count or invalid:
        raise ValueError(f"objects: got {objects!r}, expected {count} names, one for each of "
                         "renderer.GetActors()")
    for number, name in enumerate(names):
        writer.SetObjectName(number, name or "")


def _name_categories(writer, categories):
    if categories is None:
        return
    try:
        pairs = [(name, [objects] if isinstance(objects, str) else list(objects))
                 for name, objects in categories.items()]
    except (AttributeError, TypeError):
        pairs = [(None, [])]
    if not all(objects and all(isinstance(each, str) for each in (name, *objects))
               for name, objects in pairs):
        raise ValueError(f"categories: got {describe(categories)}, expected a dictionary of "
                         "categories with the names of their objects")
    for name, objects in pairs:
        for each in objects:
            writer.SetCategory(each, name)


def _add_views(writer, cameras, size, lens):
    if isinstance(cameras, (str, os.PathLike)):
        words, like = os.fspath(cameras), _like(lens, size).model
        _run(writer, lambda: writer.AddViews(words, like))
        return
    if lens is not None:
        raise ValueError(f"lens: got {describe(lens)}, expected none with cameras of their own")
    size = _SIZE if size is None else size
    single = isinstance(cameras, CameraModel) or is_a(cameras, "vtkCamera")
    for camera in cameras if not single and hasattr(cameras, "__iter__") else [cameras]:
        if isinstance(camera, CameraModel):
            writer.AddView(camera.model)
        elif is_a(camera, "vtkCamera"):
            writer.AddView(sensor_of(camera, size).model)
        else:
            raise ValueError(f"cameras: got {describe(camera)}, expected CameraModels, vtkCameras, "
                             "'orbit:N', 'random:N' or the path of a file of poses")


def _like(lens, size):
    """The camera that is copied for each pose."""
    if isinstance(lens, CameraModel):
        if size not in (None, lens.size):
            raise ValueError(f"size: got {size!r}, expected none with a lens that has its own")
        return lens
    if not isinstance(lens, (str, os.PathLike, type(None))):
        raise ValueError(f"lens: got {describe(lens)}, expected words, a calibration's file or a "
                         "CameraModel")
    words = "pinhole" if lens is None else os.fspath(lens)
    if words == "orthographic":
        raise ValueError("lens: got 'orthographic', expected the pixels for a world unit as well, "
                         "as in 'orthographic:100'")
    if size is None and not vtkRelievoCalibration.IsFile(words):
        size = _SIZE
    return lens_of(words, size)


def _whole(name, value):
    try:
        number = int(value)
        good = number == value and 0 <= number < 1 << 31
    except (TypeError, ValueError, OverflowError):
        good = False
    if not good:
        raise ValueError(f"{name}: got {value!r}, expected a whole number from 0")
    return number
