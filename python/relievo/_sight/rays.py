# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hits of rays as numpy arrays."""

import os
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy
from numpy.typing import ArrayLike

from .._arguments.data import EXPECTED, data_of
from .._arguments.errors import Watch, check_file, describe, is_a, path_of
from .._arguments.renderers import inner_renderer, prop_of
from ..vtk.util.misc import calldata_type
from ..vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from ..vtk.util.vtkConstants import VTK_DOUBLE
from ..vtk.vtkCommonCore import vtkUnsignedCharArray
from ..vtk.vtkCommonDataModel import vtkTable
from ..vtk.vtkCommonMath import vtkMatrix4x4
from ..vtk.vtkRenderingCore import vtkRenderer
from ..vtkRelievoRays import vtkRelievoRayScene

Progress = Callable[[float], Any] | None
_EXPECTED = f"a vtkRenderer, something with a .renderer, actors, a file, {EXPECTED}"


class Hits(NamedTuple):
    """Hits of rays with surfaces: arrays with a row for each ray (nearest) or each hit (all)."""

    distance: numpy.ndarray
    """From the origin in world units; infinity without a hit."""
    prop: numpy.ndarray
    """Index of the prop, equal to the layer `actor` for a renderer's props; -1: no hit, or an actor
    within a prop assembly, which has no number."""
    block: numpy.ndarray
    """Flat index in composite data, 0 in other data; -1: none."""
    cell: numpy.ndarray
    """Cell of the drawn mesh; for glyphs the input's point; for data its cell; -1: none."""
    points: numpy.ndarray
    """n x 3: ids of the triangle's corners in the mesh, or in the data; -1: none."""
    weights: numpy.ndarray
    """n x 3: barycentric weights of these points; they sum to 1, or are 0."""
    position: numpy.ndarray
    """n x 3: world coordinates, in double; 0: none."""
    normal: numpy.ndarray
    """n x 3: unit shading normal, world space, reversed if the back was hit; 0: none."""
    geometric_normal: numpy.ndarray
    """n x 3: unit normal of the triangle, world space, towards the ray's origin; 0: none."""
    ray: numpy.ndarray
    """Index of the ray."""
    opacity: numpy.ndarray
    """For all(): 0 to 1; NaN if a mesh has more than one opacity. None for nearest()."""

    @property
    def hit(self) -> numpy.ndarray:
        """Whether there is a hit, for each row."""
        return numpy.isfinite(self.distance)


class Rays:
    """A scene to trace rays in, made by rays().

    It follows the scene: each call uses its current state, and unchanged parts stay cached. `props`
    lists the numbered props of hits: the renderer's actors, then the data; those of a file alone
    are None.
    """

    def __init__(self, things: Sequence[Any]) -> None:
        self.scene = vtkRelievoRayScene()
        self._data: list[Any] = []
        self.has_matrices = False  # of data
        files = [each for each in things if isinstance(each, (str, os.PathLike))]
        things = [each for each in things if not isinstance(each, (str, os.PathLike))]
        if len(files) > 1:
            raise ValueError(f"rays: got {len(files)} files, expected at most one")
        renderers = [each for each in map(inner_renderer, things) if each is not None]
        if len(renderers) > 1:
            raise ValueError(f"rays: got {len(renderers)} renderers, expected at most one")
        actors = [prop for prop in map(prop_of, things) if prop is not None]
        if actors:
            if renderers:
                raise ValueError("rays: got a renderer and actors, expected one or the other")
            renderers = [vtkRenderer()]
            for each in actors:
                renderers[0].AddViewProp(each)
        if renderers:
            self.scene.SetRenderer(renderers[0])
        for thing in things:
            if inner_renderer(thing) is None and prop_of(thing) is None:
                self._add(thing)
        for path in map(os.fspath, files):
            check_file(path)
            with Watch(self.scene) as watch:
                self.scene.Read(path)
            watch.raise_as(ValueError, "rays")
            if not things:
                self._data = [None] * self.scene.GetNumberOfProps()

    def __repr__(self):
        return f"<relievo.Rays in {len(self.props)} props>"

    @property
    def props(self) -> list:
        """The props, in the order of the hits' numbers."""
        renderer = self.scene.GetRenderer()
        if renderer is None:
            return [*self._data]
        actors = renderer.GetActors()
        numbers = range(actors.GetNumberOfItems())
        return [*map(actors.GetItemAsObject, numbers), *self._data]

    def nearest(self, origins: ArrayLike, directions: ArrayLike, minimum: ArrayLike = 0.0,
            maximum: ArrayLike = numpy.inf, progress: Progress = None) -> Hits:
        """The first hit of each ray, as Hits with a row for each ray.

        origins, directions: array-like, n x 3, world coordinates; or one origin (or direction) for
            all. Directions have any length but 0.
        minimum, maximum: range of hits along a ray, in world units.
        progress: called with the share done after every 65536 rays; if it returns False, the call
            ends with a RuntimeError.

        Raises ValueError for invalid arguments. Rays that are not finite hit nothing.
        """
        hits = vtkTable()
        count = self._ask(
            self.scene.FindNearest, hits, origins, directions, minimum, maximum, progress
        )
        return _hits(hits, ray=numpy.arange(count), opacity=None)

    def any(self, origins: ArrayLike, directions: ArrayLike, minimum: ArrayLike = 0.0,
            maximum: ArrayLike = numpy.inf, progress: Progress = None) -> numpy.ndarray:
        """Whether each ray has a hit: an array of bool. Arguments as for nearest()."""
        hit = vtkUnsignedCharArray()
        self._ask(self.scene.FindAny, hit, origins, directions, minimum, maximum, progress)
        return vtk_to_numpy(hit).astype(bool)

    def all(self, origins: ArrayLike, directions: ArrayLike, minimum: ArrayLike = 0.0,
            maximum: ArrayLike = numpy.inf, progress: Progress = None) -> Hits:
        """All hits of all rays, as Hits with a row for each hit, sorted by rays and distance.

        Arguments as for nearest(). A ray through an edge hits both of its triangles.
        """
        hits = vtkTable()
        self._ask(self.scene.FindAll, hits, origins, directions, minimum, maximum, progress)
        return _hits(hits)

    def write(self, path: str | os.PathLike) -> None:
        """Writes the scene with its trees to a file, which rays() opens without building them.

        path: name of the file. An existing file is replaced when the new one is complete.

        The file holds triangles and normals, about 50 bytes per triangle, in this machine's byte
        order. Raises ValueError for a scene that rays cannot follow, OSError if the file cannot be
        written.
        """
        path = path_of(path, "path")
        none = numpy.empty((0, 3))
        self.any(none, none)  # raises for such a scene
        with Watch(self.scene) as watch:
            self.scene.Write(path)
        watch.raise_as(OSError, "rays")

    def _add(self, thing):
        data, matrix = thing if isinstance(thing, tuple) and len(thing) == 2 else (thing, None)
        given, data = data, data_of(data)
        if data is None:
            raise ValueError(f"rays: got {describe(given)}, expected {_EXPECTED}")
        if matrix is not None and not is_a(matrix, "vtkMatrix4x4"):
            matrix = _matrix(matrix)
        self.has_matrices = self.has_matrices or matrix is not None
        self.scene.AddData(data, matrix)
        self._data.append(data)

    def _ask(self, find, answer, origins, directions, minimum, maximum, progress):
        origins, directions = _vectors(origins, "origins"), _vectors(directions, "directions")
        if len(directions) == 1 and len(origins) != 1:
            directions = numpy.broadcast_to(directions, origins.shape)
        if len(origins) not in (1, len(directions)):
            raise ValueError(
                f"origins, directions: got {len(origins)} and {len(directions)}, expected as many, "
                "or one for all"
            )
        try:
            minimum, maximum = float(minimum), float(maximum)
        except (TypeError, ValueError):
            raise ValueError(
                f"minimum, maximum: got {describe(minimum)} and {describe(maximum)}, expected a "
                "number each"
            ) from None
        if not 0.0 <= minimum <= maximum:
            raise ValueError(
                f"minimum, maximum: got {minimum:g} and {maximum:g}, expected 0 or more, the "
                "maximum not below the minimum"
            )
        self.scene.SetMinimumDistance(minimum)
        self.scene.SetMaximumDistance(maximum)
        report = _Progress(self.scene, progress)
        # Not copied, so these references must last for the call.
        arrays = [numpy.ascontiguousarray(each) for each in (origins, directions)]
        with Watch(self.scene) as watch, report:
            find(*map(numpy_to_vtk, arrays), answer)
        report.check()
        watch.raise_as(ValueError, "rays")
        return len(directions)


class _Progress:
    """Calls back in a `with` block; an exception of the callback ends the rays, and is raised."""

    def __init__(self, scene, call):
        self._scene, self._call = scene, call
        self._tag = None
        self._ended = None

    def __enter__(self):
        if self._call is not None:

            @calldata_type(VTK_DOUBLE)
            def report(_scene, _event, share):
                try:
                    if self._call(share) is False:
                        self._ended = RuntimeError(f"rays: ended by progress at {share:.0%}")
                except BaseException as error:  # also interrupts: VTK would swallow them
                    self._ended = error
                if self._ended is not None:
                    self._scene.AbortOn()

            self._tag = self._scene.AddObserver("ProgressEvent", report)

    def __exit__(self, *_):
        if self._tag is not None:
            self._scene.RemoveObserver(self._tag)

    def check(self):
        if self._ended is not None:
            raise self._ended


def rays(*things) -> Rays:
    """A scene to trace rays in, in double precision, on all cores.

    things: a vtkRenderer, or an object whose attribute `renderer` is one (a plotter), or actors;
        datasets, also composite, or filters that make them; pairs of a dataset and its 4 x 4 matrix
        (array-like, or a vtkMatrix4x4 that may be moved later). One renderer at most. The same
        dataset may be given many times, with other matrices: it is stored once.

        scene = relievo.rays(renderer)
        hits = scene.nearest(origins, directions)        # n x 3 each
        hits.distance, hits.cell, hits.position ...      # numpy arrays, a row for each ray
        dark = scene.any(hits.position, to_sun, minimum=1e-6)
        scene.write("city.rays")                         # for other processes:
        scene = relievo.rays("city.rays")

        A file of Rays.write() is mapped into memory, which all processes share, and read once to
        compare its hash. A change of the file in place can end the processes that use it: replace
        it instead. With other things beside it, it must have been written of the same points, cells
        and matrices; without them, hits have numbers of props, cells and points, but `props` are
        None.

    Returns Rays. Raises ValueError for invalid arguments, also for a file that is damaged or of
    another scene, and OSError for a file that cannot be opened. All functions that follow rays
    raise MemoryError if the tree of their meshes does not fit into the memory left. A renderer's
    props that rays do not support (volumes, lines, points, wireframes, cut-outs) are left out
    with a warning.
    """
    if not things:
        raise ValueError(f"rays: got nothing, expected {_EXPECTED}")
    flat = []
    for thing in things:
        flat.extend(thing if isinstance(thing, list) else [thing])
    return Rays(flat)


def _vectors(values, name):
    array = numpy.asarray(values)
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{name}: got an array of {array.dtype}, expected numbers")
    if array.ndim == 1 and array.shape == (3,):
        array = array[numpy.newaxis]
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: got an array of shape {array.shape}, expected (n, 3) or (3,)")
    return array.astype(float, copy=False)


def _matrix(values):
    array = numpy.asarray(values, float)
    if array.shape != (4, 4):
        raise ValueError(f"rays: got a matrix of shape {array.shape}, expected (4, 4)")
    matrix = vtkMatrix4x4()
    matrix.DeepCopy(array.ravel())
    return matrix


def _hits(table, **others):
    columns = {
        table.GetColumnName(i): vtk_to_numpy(table.GetColumn(i))
        for i in range(table.GetNumberOfColumns())
    }
    return Hits(**columns, **others)
