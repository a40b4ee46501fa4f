# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A sphere over a square ground in a render view, and the lit part of it by rays in double."""

import numpy
from paraview import simple

CENTER = numpy.array([0.0, 0.0, 1.1])
RADIUS = 0.8
HALF = 3.0  # of the ground's side
SIZE = (280, 182)
AZIMUTH, ELEVATION = 240.0, 40.0
NONE, DARK, LIT, UNSURE = 0, 1, 2, 3


def sun(azimuth=AZIMUTH, elevation=ELEVATION):
    """Direction towards the sun: azimuth in degrees from y, clockwise seen from above, z up."""
    azimuth, elevation = numpy.radians([azimuth, elevation])
    level = numpy.cos(elevation)
    east, north = level * numpy.sin(azimuth), level * numpy.cos(azimuth)
    return numpy.array([east, north, numpy.sin(elevation)])


class Stage:
    """`ground` and `ball` are the sources, `ground_shown`, `ball_shown` their representations."""

    def __init__(self, size=SIZE):
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = size
        self.view.OrientationAxesVisibility = 0
        self.view.UseFXAA = 0
        # The tests' pictures are of one sample a pixel, but where they are about samples.
        self.view.MultiSamples = 0
        self.center = CENTER
        self.ground = simple.Plane(
            Origin=[-HALF, -HALF, 0.0], Point1=[HALF, -HALF, 0.0], Point2=[-HALF, HALF, 0.0]
        )
        self.ball = simple.Sphere(
            Center=CENTER, Radius=RADIUS, ThetaResolution=128, PhiResolution=128
        )
        self.ground_shown = simple.Show(self.ground, self.view)
        self.ball_shown = simple.Show(self.ball, self.view)
        self.look()

    def look(self, position=(5.0, -7.0, 6.0)):
        """Points the camera at the scene's middle."""
        self.view.CameraPosition = position
        self.view.CameraFocalPoint = [0.0, 0.0, 0.4]
        self.view.CameraViewUp = [0.0, 0.0, 1.0]
        self.view.CameraViewAngle = 30.0

    def render(self):
        """Renders the view."""
        simple.Render(self.view)
        self.look()  # the first call of Render() in a process turns the camera

    def sun(self, on=True, shadows=True, intensity=1.0):
        """The stage's sun and its shadows; intensity 0 gives the light outside its reach."""
        self.view.RelievoSun = int(on)
        self.view.RelievoSunAzimuth, self.view.RelievoSunElevation = AZIMUTH, ELEVATION
        self.view.RelievoSunIntensity = intensity
        self.view.RelievoShadows = int(shadows)

    def rays(self, size):
        """Origins and directions, (rows, columns, 3) each, of a picture of that size."""
        columns, rows = size
        eye = numpy.array(self.view.CameraPosition, dtype=float)
        gaze = numpy.array(self.view.CameraFocalPoint, dtype=float) - eye
        gaze /= numpy.linalg.norm(gaze)
        right = numpy.cross(gaze, self.view.CameraViewUp)
        right /= numpy.linalg.norm(right)
        up = numpy.cross(right, gaze)
        x, y = numpy.meshgrid(
            ((numpy.arange(columns) + 0.5) * 2 - columns) / rows,
            (rows - (numpy.arange(rows) + 0.5) * 2) / rows,
        )
        offset = x[..., None] * right + y[..., None] * up
        if self.view.CameraParallelProjection:
            origin = eye + offset * self.view.CameraParallelScale
            return origin, numpy.broadcast_to(gaze, origin.shape)
        half = numpy.tan(numpy.radians(self.view.CameraViewAngle) / 2)
        direction = gaze + offset * half
        direction /= numpy.linalg.norm(direction, axis=2, keepdims=True)
        return numpy.broadcast_to(eye, direction.shape), direction

    def sphere_hit(self, origin, direction):
        """Distance to the sphere along rays, infinite where they miss."""
        to = origin - self.center
        b = (to * direction).sum(axis=2)
        d = b * b - ((to * to).sum(axis=2) - RADIUS**2)
        near = -b - numpy.sqrt(numpy.maximum(d, 0.0))
        return numpy.where((d > 0) & (near > 1e-9), near, numpy.inf)

    def verdicts(self, size=None, light=None, lamp=None, cone=90.0, margin=2):
        """The visibility of a light: LIT, DARK, NONE, or UNSURE within `margin` pixels of an
        edge.

        `light` is the direction towards a far light (default: the stage's sun), `lamp` the place of
        a near one that looks at the scene's middle with that cone angle in degrees.
        """
        size = size or tuple(self.view.ViewSize)
        origin, direction = self.rays(size)
        ball = self.sphere_hit(origin, direction)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            ground = -origin[..., 2] / direction[..., 2]
            there = origin + ground[..., None] * direction
        outside = (ground <= 0) | (numpy.abs(there[..., :2]) > HALF).any(axis=2)
        ground = numpy.where(outside, numpy.inf, ground)
        distance = numpy.minimum(ball, ground)
        seen = numpy.isfinite(distance)
        place = origin + numpy.where(seen, distance, 0.0)[..., None] * direction
        normal = numpy.where(
            (ball < ground)[..., None], (place - self.center) / RADIUS, numpy.array([0.0, 0.0, 1.0])
        )
        if lamp is not None:
            to = numpy.asarray(lamp) - place
            towards = to / numpy.linalg.norm(to, axis=2, keepdims=True)
            axis = numpy.asarray(lamp) - [0.0, 0.0, 0.4]
            inside = (towards * axis).sum(axis=2) / numpy.linalg.norm(axis)
            within = inside > numpy.cos(numpy.radians(cone))
        else:
            towards = numpy.broadcast_to(sun() if light is None else light, place.shape)
            within = numpy.ones(place.shape[:2], bool)
        facing = (normal * towards).sum(axis=2)
        blocked = (ball > ground) & numpy.isfinite(self.sphere_hit(place + 1e-6 * normal, towards))
        found = numpy.where(blocked | (facing <= 0) | ~within, DARK, LIT)
        found = numpy.where(seen, found, NONE)
        # Edges of verdicts and objects; and pixels where triangles, not the sphere, decide the
        # facing side.
        kind = found + 4 * (ball < ground)
        unsure = seen & (ball < ground) & (numpy.abs(facing) < 0.1)
        for axis in (0, 1):
            for step in range(1, margin + 1):
                moved = numpy.roll(kind, step, axis) != kind
                unsure |= moved | numpy.roll(moved, -step, axis)
        return numpy.where(unsure, UNSURE, found)
