# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bodies at rest on a plane, at random, without overlap."""

import numpy

from .._arguments.errors import describe, is_a
from .._arguments.renderers import prop_of
from ..vtk.util.numpy_support import vtk_to_numpy
from ..vtk.vtkCommonMath import vtkMatrix4x4
from ..vtk.vtkFiltersCore import vtkTriangleFilter
from ..vtk.vtkFiltersGeometry import vtkGeometryFilter
from ..vtk.vtkRenderingCore import vtkActor
from .rays import rays

_LEVEL = 1e-9  # points of one level, in sizes of the body
_AXES = {"x": (1, 2, 0), "y": (2, 0, 1), "z": (0, 1, 2)}  # of the plane, and up


class _Body:
    """The triangles of an actor, in the space of its own position, orientation and scale."""

    def __init__(self, thing, name):
        actor = prop_of(thing)
        mapper = None if actor is None else actor.GetMapper()
        if mapper is not None:
            mapper.Update()
        data = None if mapper is None else mapper.GetInputDataObject(0, 0)
        if data is None or not is_a(data, "vtkDataSet"):
            raise ValueError(f"{name}: got {describe(thing)}, expected actors of a mesh")
        surface, triangles = vtkGeometryFilter(), vtkTriangleFilter()
        surface.SetInputData(data)
        triangles.SetInputConnection(surface.GetOutputPort())
        triangles.PassLinesOff()
        triangles.PassVertsOff()
        triangles.Update()
        self.mesh = triangles.GetOutput()
        if self.mesh.GetNumberOfCells() == 0:
            raise ValueError(f"{name}: got an actor without triangles, expected actors of a mesh")
        self.actor = actor
        own = vtkActor()  # without the user's matrix
        own.SetOrigin(actor.GetOrigin())
        own.SetPosition(actor.GetPosition())
        own.SetOrientation(actor.GetOrientation())
        own.SetScale(actor.GetScale())
        self.own = _array(own.GetMatrix())
        points = vtk_to_numpy(self.mesh.GetPoints().GetData()).astype(float)
        # Meshes with edges have several points at one place.
        places, numbers = numpy.unique(points, axis=0, return_inverse=True)
        self.points = _move(self.own, places)
        corners = vtk_to_numpy(self.mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.corners = numpy.reshape(numbers, -1)[corners]
        sides = self.corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
        edges = numpy.unique(numpy.sort(sides, axis=1), axis=0)
        self.edges = edges[edges[:, 0] < edges[:, 1]]  # triangles may have a corner twice
        twins = numpy.concatenate([sides, sides[:, ::-1]])
        self.is_closed = len(numpy.unique(twins, axis=0)) == len(numpy.unique(sides, axis=0))
        self.center = self._find_center()
        self.scene = rays((self.mesh, self.own))
        self.matrix = numpy.identity(4)

    def _find_center(self):
        """The centre of mass of the solid; of its surface, if that is not closed."""
        a, b, c = (self.points[self.corners[:, k]] - self.points[0] for k in range(3))
        if self.is_closed:
            weights = (a * numpy.cross(b, c)).sum(axis=1)
            middles = (a + b + c) / 4
        else:
            weights = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1)
            middles = (a + b + c) / 3
        total = weights.sum()
        if abs(total) <= _LEVEL * numpy.abs(weights).sum():  # without volume, or without area
            return self.points.mean(axis=0)
        return self.points[0] + (weights[:, None] * middles).sum(axis=0) / total

    def take_place(self, matrix):
        self.matrix = matrix
        self.placed = _move(matrix, self.points)
        self.low, self.high = self.placed.min(axis=0), self.placed.max(axis=0)

    def overlaps(self, other):
        """Whether surfaces intersect, or one body lies within the other.

        Of two triangles that intersect, an edge of one meets the other.
        """
        slack = _LEVEL * (self.high - self.low).max()  # a table that bodies touch is no obstacle
        if (self.low > other.high - slack).any() or (other.low > self.high - slack).any():
            return False
        return self._meets(other) or other._meets(self)

    def _meets(self, other):
        ends = self.placed[self.edges]
        near = ~((ends.max(axis=1) < other.low) | (ends.min(axis=1) > other.high)).any(axis=1)
        back = numpy.linalg.inv(other.matrix)
        ends = numpy.stack([_move(back, ends[near, k]) for k in range(2)], axis=1)
        along = ends[:, 1] - ends[:, 0]
        lengths = numpy.linalg.norm(along, axis=1)
        found = other.scene.nearest(ends[:, 0], along).distance if len(ends) else numpy.empty(0)
        if (found <= lengths).any():
            return True
        if not other.is_closed:
            return False
        within = other.scene.all(_move(back, self.placed[:1]), _UNLIKELY)
        return len(numpy.unique(within.distance)) % 2 == 1


_UNLIKELY = numpy.array([[0.3141, 0.8734, 0.3721]])  # seldom along an edge


def _array(matrix):
    return numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def _move(matrix, points):
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _outline(points):
    """The corners of the convex hull of points in the plane, counterclockwise (Andrew 1979)."""
    points = numpy.unique(points, axis=0)
    if len(points) < 3:
        return points
    hull = []
    for each in (points, points[::-1]):
        first = len(hull)
        for point in each:
            while len(hull) - first > 1:
                (x, y), (u, v) = hull[-1] - hull[-2], point - hull[-1]
                if x * v - y * u > 0:
                    break
                hull.pop()
            hull.append(point)
        hull.pop()
    return numpy.array(hull)


def _way_down(contacts):
    """Where a body whose centre is over the origin topples: a point of the axis, and a direction.
    None if it rests on these contacts."""
    corners = _outline(contacts)
    starts, sides = corners, numpy.roll(corners, -1, axis=0) - corners
    lengths = (sides**2).sum(axis=1)
    share = numpy.divide(-(starts * sides).sum(axis=1), lengths, out=numpy.zeros(len(corners)),
                         where=lengths > 0)
    nearest = starts + share.clip(0, 1)[:, None] * sides
    if len(corners) > 2 and (sides[:, 0] * -starts[:, 1] - sides[:, 1] * -starts[:, 0] >= 0).all():
        return None
    pivot = nearest[(nearest**2).sum(axis=1).argmin()]
    length = numpy.linalg.norm(pivot)
    return None if length == 0 else (pivot, -pivot / length)


def rest(points, turn):
    """Lets a body go on the plane z = 0; it topples until it rests, without rolling on.

    points: (n, 3), relative to the centre of mass. turn: (3, 3), the rotation to begin with.

    Returns the rotation at rest. Goldberg et al. 1999 call this the quasi-static pose.
    """
    turned = points @ turn.T
    size = numpy.ptp(turned, axis=0).max()
    for _ in range(10000):
        lowest = turned[:, 2].min()
        down = _way_down(turned[turned[:, 2] <= lowest + _LEVEL * size, :2])
        if down is None:
            break
        pivot, ahead = down
        away = (turned[:, :2] - pivot) @ ahead
        height = turned[:, 2] - lowest
        falls = away > _LEVEL * size
        falls &= height > _LEVEL * size
        if not falls.any():
            break
        angle = numpy.arctan2(height[falls], away[falls]).min()
        sine, cosine = numpy.sin(angle), numpy.cos(angle)
        h = numpy.array([*ahead, 0.0])
        z = numpy.array([0.0, 0.0, 1.0])
        step = (numpy.identity(3) + (cosine - 1) * (numpy.outer(h, h) + numpy.outer(z, z))
                + sine * (numpy.outer(h, z) - numpy.outer(z, h)))
        turn = step @ turn
        turned = points @ turn.T
    return turn


def _any_turn(random):
    """A rotation, uniform among all (Shoemake 1992)."""
    w, x, y, z = (quaternion := random.normal(size=4)) / numpy.linalg.norm(quaternion)
    return numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def scatter(actors, random, area, up="y", height=0.0, fixed=(), tries=200) -> numpy.ndarray:
    """Places bodies on a plane at random: each rests on it, and none overlap.

        relievo.scatter(mugs, numpy.random.default_rng(7), ((-0.3, 0.3), (-0.2, 0.2)))

    actors: actors of meshes. Their own position, orientation and scale belong to the body; the
        place is set as user matrix.
    random: a numpy.random.Generator, or the seed of one. Equal states give equal places.
    area: ((low, high), (low, high)), world units, within which bodies lie, along the axes of the
        plane in the order x, y, z.
    up, height: the axis that points upwards, "x", "y" or "z", and where it meets the plane.
    fixed: actors that stay, and that no body overlaps.
    tries: places and orientations to try for a body, before it is given up.

    A body topples from an orientation that is uniform at random until its centre of mass lies over
    the points that touch the plane. Overlap is decided by rays along all edges, in double.

    Returns the matrices (n, 4, 4). Raises ValueError for invalid arguments, RuntimeError if a body
    finds no place; then all actors stay as they were.
    """
    if up not in _AXES:
        raise ValueError(f"up: got {up!r}, expected 'x', 'y' or 'z'")
    try:
        limits = numpy.array(area, float)
        random = numpy.random.default_rng(random)
    except (TypeError, ValueError) as error:
        raise ValueError(f"area, random: got {area!r} and {describe(random)}, expected two ranges "
                         f"and a numpy.random.Generator or a seed ({error})") from None
    if limits.shape != (2, 2) or not (limits[:, 0] < limits[:, 1]).all():
        raise ValueError(f"area: got {area!r}, expected ((low, high), (low, high))")
    if isinstance(tries, bool) or not isinstance(tries, int) or tries < 1:
        raise ValueError(f"tries: got {tries!r}, expected a whole number from 1")
    axes = _AXES[up]
    frame = numpy.zeros((3, 3))  # from z up to the world
    frame[axes, range(3)] = 1
    plane = sorted(axes[:2])
    bodies = [_Body(each, "actors") for each in actors]
    others = [_Body(each, "fixed") for each in fixed]
    for each in others:
        placed = each.actor.GetUserMatrix()
        each.take_place(numpy.identity(4) if placed is None else _array(placed))
    for number, body in enumerate(bodies):
        for _ in range(tries):
            turn = frame @ rest(body.points - body.center, _any_turn(random))
            matrix = numpy.identity(4)
            matrix[:3, :3] = turn
            matrix[:3, 3] = -turn @ body.center
            moved = _move(matrix, body.points)
            low, high = moved.min(axis=0), moved.max(axis=0)
            first, last = limits[:, 0] - low[plane], limits[:, 1] - high[plane]
            share = random.uniform(size=2)
            if (first > last).any():
                continue  # too large for the area, in this orientation
            matrix[plane, 3] += first + share * (last - first)
            matrix[axes[2], 3] += height - low[axes[2]]
            body.take_place(matrix)
            if not any(body.overlaps(each) for each in others):
                break
        else:
            raise RuntimeError(f"scatter: got an area in which {number} of {len(bodies)} bodies "
                               f"found a place in {tries} tries each; expected a larger area, or "
                               "fewer bodies")
        others.append(body)
    for body in bodies:
        matrix = vtkMatrix4x4()
        matrix.DeepCopy(body.matrix.ravel())
        body.actor.SetUserMatrix(matrix)
    return numpy.array([body.matrix for body in bodies]).reshape(-1, 4, 4)
