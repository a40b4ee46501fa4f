# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Comparison of frames by cause, and baselines."""

import html
import json
import numbers
import os
from contextlib import nullcontext
from typing import Any

import numpy

from .._arguments.errors import Watch, check_file, is_a, path_of
from .._arguments.renderers import renderer_of
from .._frames.keep import kept
from .._images.exr import write_exr
from .._images.image import layer, to_image
from .._images.picture import captured
from .._scene.scene import Scene
from .._wrapped import vtkRelievoBaseline, vtkRelievoComparisonReport, vtkRelievoFrameComparison
from ..vtk.vtkCommonDataModel import vtkImageData
from .capture import _frame_of, _pixels, _window_of


class Comparison:
    """The result of compare(): true if the frames are alike, and printed as a table of causes.

    Notebooks show the page of write_html().

    alike: whether the frames are alike within the limits.
    pixels, unexplained: numbers of pixels that differ, and of those that no cause explains.
    causes: a list of dicts, most pixels first, with cause, kind, pixels, words, and depending on
        the cause name, id, displacement, largest, cells, array, ...
    within_limits: a dict of the numbers of pixels that differ by edge and by rounding.
    cannot_be_detected: causes for which these frames lack data.
    size: (columns, rows). text: the table. json: the full result as text. dict: the parsed json.
    """

    alike: bool
    pixels: int
    unexplained: int
    causes: list[dict[str, Any]]
    within_limits: dict[str, int]
    cannot_be_detected: list[str]

    def __init__(self, comparison, title):
        self._comparison, self._title = comparison, title
        self.text = comparison.GetText()
        self.json = comparison.GetJSON()
        self.dict = json.loads(self.json)
        for name in ("alike", "pixels", "unexplained", "causes", "within_limits",
                     "cannot_be_detected"):
            setattr(self, name, self.dict[name])
        self.size = tuple(self.dict["size"])
        image = comparison.GetCauses()
        self._causes = None if image is None else layer(image, "cause").copy()
    @property
    def image(self) -> numpy.ndarray | None:
        """The index of each pixel's cause in causes, of shape (rows, columns), row 0 at the top.

        -1: alike, -2: rounding, -3: edge, -4: unexplained. None for frames of different sizes or
        cameras.
        """
        return self._causes

    def write_html(self, path: str | os.PathLike[str]) -> None:
        """Writes a page for browsers, which needs no other file and no network.

        It has both pictures with a slider and flickering, the pixels coloured by cause, a table
        whose rows highlight their pixels, and the values under the mouse.

        path: name of the file. Raises OSError if it cannot be written.
        """
        _write(path, self._report().GetHTML())

    def write_markdown(self, path: str | os.PathLike[str]) -> None:
        """Writes the table of causes as Markdown, for pull requests.

        path: name of the file. Raises OSError if it cannot be written.
        """
        _write(path, self._report(False).GetMarkdown())

    def _report(self, with_frames=True):
        report = vtkRelievoComparisonReport()
        report.Add(self._title, self._comparison, with_frames)
        return report

    def _repr_html_(self):
        page = html.escape(self._report().GetHTML())
        return (f'<iframe srcdoc="{page}" title="Comparison" sandbox="allow-scripts" '
                'style="width:100%;height:800px;border:0"></iframe>')

    def __bool__(self) -> bool:
        return self.alike

    def __repr__(self) -> str:
        return self.text.rstrip("\n")


def compare(a, b, levels=2, normal_angle=0.02, depth_pixels=1 / 256) -> Comparison:
    """Explains how frame b differs from frame a: which objects, cells and lights, and why.

        assert relievo.compare("bike.exr", plotter)     # a failure prints the causes

    a, b: paths of files (.exr of write_baseline() or write_exr(); for .png and other pictures, only
        the pictures are compared), images of capture() or read_exr(), numpy arrays of pictures
        (uint8, row 0 at the top), or renderers, plotters and scenes, which are drawn.
    levels: tolerance for colours, and for shares such as shadows, in levels of 255, 0 to 255.
    normal_angle: tolerance for normals, in degrees, 0 to 180.
    depth_pixels: tolerance for depths, as the change of a surface's depth over this many pixels, 0
        to 1.

    Returns a Comparison. docs/compare.md describes the causes, and the reason for each limit.

    Raises ValueError for invalid arguments and frames that cannot be compared, OSError for files
    that cannot be read, RuntimeError if a frame cannot be drawn.
    """
    comparison = vtkRelievoFrameComparison()
    for name, value, most in (("levels", levels, 255), ("normal_angle", normal_angle, 180),
                              ("depth_pixels", depth_pixels, 1)):
        if not (isinstance(value, numbers.Real) and 0 <= float(value) <= most):
            raise ValueError(f"{name}: got {value!r}, expected a number from 0 to {most}")
    comparison.SetColorLevels(float(levels))
    comparison.SetNormalAngle(float(normal_angle))
    comparison.SetDepthPixels(float(depth_pixels))
    sides = ((a, comparison.ReadBaseline, comparison.SetBaseline),
             (b, comparison.ReadFrame, comparison.SetFrame))  # fmt: skip
    for thing, read, take in sides:
        if isinstance(thing, (str, bytes, os.PathLike)):
            path = os.fspath(thing)
            check_file(path)
            with Watch(comparison):
                good = read(path)  # type: ignore[arg-type] # bytes, too
            if not good:
                raise ValueError(comparison.GetFailureText())
        elif not _is_drawn(thing):
            take(frame_of(thing))
    images = (comparison.GetBaseline(), comparison.GetFrame())
    portable = any(vtkRelievoBaseline.IsPortable(image) for image in images)
    for thing, _, take in sides:
        if _is_drawn(thing):
            take(frame_of(thing, portable))
    with Watch(comparison):
        good = comparison.Compare()
    if not good:
        raise ValueError(f"compare: {comparison.GetFailureText()}")
    return Comparison(comparison, f"{_name_of(a)}, {_name_of(b)}")


def write_baseline(path, thing, size=None, names=None, portable=False) -> None:
    """Draws a frame and writes it as a lossless baseline for compare().

        relievo.write_baseline("bike.exr", plotter)

    path: name of the file, .exr; an existing one is replaced when the new one is complete.
    thing: a vtkRenderer, a plotter or anything else that capture() draws, or a scene().
    size: (columns, rows) in pixels, as for capture(); scenes have their own size.
    names: a dict {actor: name}. Actors are matched by name, wherever they are; an actor without a
        name is matched by its mesh. Actors of PyVista's plotters have the names given to
        add_mesh(), actors of scenes the names of their files.
    portable: whether ids, depth, normals and arrays come from rays instead of OpenGL, and are equal
        on all processors and drivers; for surfaces only.

    The file has the picture, depth, normals, albedo, ids, shadows, the layers of stages that ran,
    and a record of objects, camera, lights, settings and versions (docs/compare.md).

    Raises ValueError for invalid arguments, OSError if the file cannot be written, RuntimeError if
    the frame cannot be drawn.
    """
    path = path_of(path, "path")
    if os.path.splitext(path)[1].lower() not in (".exr", b".exr"):
        raise ValueError(f"path: got {path!r}, expected a name that ends in .exr")
    write_exr(path, _drawn(thing, size, names, portable))


def _write(path, text):
    with open(path_of(path, "path"), "w", encoding="utf-8") as file:
        file.write(text)


def _name_of(thing):
    """A side's label in a report: the file's path, or the type's name."""
    is_path = isinstance(thing, (str, bytes, os.PathLike))
    return os.fsdecode(thing) if is_path else type(thing).__name__


def _is_drawn(thing):
    return not (isinstance(thing, (str, bytes, os.PathLike, numpy.ndarray))
                or is_a(thing, "vtkImageData"))


def frame_of(thing, portable=False):
    """The frame as an image; draws things that are not images, as a portable baseline or not."""
    if _is_drawn(thing):
        return _drawn(thing, portable=portable)
    return to_image(thing, "color") if isinstance(thing, numpy.ndarray) else thing


def _drawn(thing, size=None, names=None, portable=False):
    """The baseline of a scene, a renderer, or anything else that capture() draws."""
    image = vtkImageData()
    if isinstance(thing, Scene):
        if size is not None or names is not None:
            raise ValueError("size, names: got them with a scene, which has its own")
        thing.capture_baseline(image, portable)
        return captured(image)
    renderer, made = renderer_of(thing)
    size = (1024, 768) if made and size is None else size
    baseline = vtkRelievoBaseline()
    baseline.SetRenderer(renderer)
    baseline.SetPortable(bool(portable))
    name_objects(baseline, renderer, thing, names)
    found = kept(renderer)
    held = nullcontext() if found is None else found.held()
    with held, _window_of(renderer, None if size is None else _pixels(size)):
        with _frame_of(renderer) as frame:
            if made:
                renderer.ResetCamera()
            with Watch(frame.GetLayersStage(), frame, baseline) as watch:
                good = baseline.Capture(image)
    watch.raise_as(RuntimeError, "baseline")
    if not good:
        raise RuntimeError("baseline: the frame cannot be drawn")
    return captured(image)


def name_objects(writer, renderer, thing, names):
    """Gives a writer the names of a renderer's actors: the given ones, or those of a plotter."""
    actors = renderer.GetActors()
    places = {actors.GetItemAsObject(i): i for i in range(actors.GetNumberOfItems())}
    for actor, name in (_names_in(thing) if names is None else names).items():
        if not isinstance(name, str):
            raise ValueError(f"names: got {name!r} as an actor's name, expected a str")
        if names is not None and actor not in places:
            raise ValueError(f"names: got {name!r} for an actor that the renderer does not have")
        if actor in places:
            writer.SetObjectName(places[actor], name)


def _names_in(thing):
    """The names of actors in a PyVista plotter, except for names that PyVista made of addresses."""
    actors = getattr(thing, "actors", None)
    if not isinstance(actors, dict):
        return {}
    return {actor: name for name, actor in actors.items()
            if isinstance(name, str) and "Addr=" not in name}
