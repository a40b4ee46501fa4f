# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of known depth, and the rays of a camera in double."""

import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkPointSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume)  # fmt: skip
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401


def add(renderer, source):
    """Adds an actor of the source's output; returns the actor."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    return actor


def points_at(places, **arrays):
    """Points without cells, with arrays by name."""
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.array(places, float), deep=True))
    data.SetPoints(points)
    for name, values in arrays.items():
        array = numpy_to_vtk(numpy.array(values, float), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


def plane_and_sphere(parallel=False, far_from_origin=(0, 0, 0)):
    """A renderer that sees a tilted plane behind a sphere of flat triangles, all in sight."""
    middle = numpy.array(far_from_origin, float)
    renderer = vtkRenderer()
    plane = vtkPlaneSource()
    plane.SetOutputPointsPrecision(1)
    plane.SetOrigin(*(middle + (-40, -40, -12)))
    plane.SetPoint1(*(middle + (40, -40, 8)))
    plane.SetPoint2(*(middle + (-40, 40, -20)))
    add(renderer, plane)
    sphere = vtkSphereSource()
    sphere.SetOutputPointsPrecision(1)
    sphere.SetCenter(*(middle + (0.3, -0.2, 1)))
    sphere.SetRadius(1.5)
    sphere.SetThetaResolution(16)
    sphere.SetPhiResolution(9)
    add(renderer, sphere)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*(middle + (2, 3, 12)))
    camera.SetFocalPoint(*(middle + (0, 0, 0)))
    camera.SetViewUp(0.1, 1, 0)
    camera.SetViewAngle(35)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(4)
    camera.SetClippingRange(1, 100)
    return renderer


def window_of(renderer, columns=300, rows=200):
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(columns, rows)
    window.AddRenderer(renderer)
    return window


def point_source(place):
    """A port with one point, which SetCenter moves."""
    source = vtkPointSource()
    source.SetNumberOfPoints(1)
    source.SetRadius(0)
    source.SetCenter(*place)
    return source


class PointsTest(unittest.TestCase):
    """A scene of 90 x 60 pixels, to add points to."""

    def setUp(self):
        self.renderer = plane_and_sphere()
        self.window = window_of(self.renderer, 90, 60)

    def check_refusals(self, add, first, data, table):
        """Wrong arguments are named, and change nothing; `first` is the name of the data's."""
        for bad, says in table:
            with self.assertRaisesRegex(ValueError, f"{add.__name__}: {says}"):
                add(self.renderer, **{first: data, **bad})
        self.assertIsNone(self.renderer.GetPass())
        with self.assertRaises(ValueError):
            add(None, data)


def rays(camera, columns, rows):
    """Origins and directions of the rays through the pixels' centres, (rows, columns, 3), row 0 at
    the top; a point on a ray at parameter t has depth t."""
    eye, focus, up = (
        numpy.array(v)
        for v in (camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp())
    )
    ahead = (focus - eye) / numpy.linalg.norm(focus - eye)
    right = numpy.cross(ahead, up)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(right, ahead)
    y, x = numpy.mgrid[0:rows, 0:columns] + 0.5
    x = (2 * x / columns - 1) * columns / rows
    y = 1 - 2 * y / rows
    if camera.GetParallelProjection():
        half = camera.GetParallelScale()
        origins = eye + half * (x[..., None] * right + y[..., None] * up)
        return origins, numpy.broadcast_to(ahead, origins.shape)
    half = numpy.tan(numpy.radians(camera.GetViewAngle()) / 2)
    directions = ahead + half * (x[..., None] * right + y[..., None] * up)
    return numpy.broadcast_to(eye, directions.shape), directions


def truth(renderer, columns, rows):
    """Depth, and the unit normal of the triangle hit, by intersecting every ray with every
    triangle in double: (rows, columns) and (rows, columns, 3); infinity and 0 for a miss.
    Last, a mask of pixels at least `margin` pixels away from an edge of the visible surfaces."""
    origins, directions = rays(renderer.GetActiveCamera(), columns, rows)
    depth = numpy.full((rows, columns), numpy.inf)
    normal = numpy.zeros((rows, columns, 3))
    owner = numpy.full((rows, columns), -1)
    count = 0
    for actor in (renderer.GetActors().GetItemAsObject(i) for i in range(2)):
        mesh = actor.GetMapper().GetInput()
        points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        polys = mesh.GetPolys()
        for cell in range(polys.GetNumberOfCells()):
            corners = cell_points(polys, cell)
            for i in range(1, len(corners) - 1):
                a, b, c = points[[corners[0], corners[i], corners[i + 1]]]
                n = numpy.cross(b - a, c - a)
                length = numpy.linalg.norm(n)
                if length == 0:
                    continue
                with numpy.errstate(divide="ignore", invalid="ignore"):
                    t = ((a - origins) @ n) / (directions @ n)
                hit = origins + numpy.where(numpy.isfinite(t), t, 0)[..., None] * directions
                inside = numpy.isfinite(t) & (t > 0) & (t < depth)
                for p, q in ((a, b), (b, c), (c, a)):
                    inside &= numpy.cross(q - p, hit - p) @ n >= 0
                depth[inside] = t[inside]
                normal[inside] = n / length
                owner[inside] = count
            count += 1
    return depth, normal, inner(owner)


def cell_points(polys, cell):
    offsets = vtk_to_numpy(polys.GetOffsetsArray())
    return vtk_to_numpy(polys.GetConnectivityArray())[offsets[cell] : offsets[cell + 1]]


def inner(owner):
    """Pixels whose eight neighbours see the same cell: rounding cannot have moved an edge there."""
    mask = numpy.zeros(owner.shape, bool)
    mask[1:-1, 1:-1] = True
    for rows in (-1, 0, 1):
        for columns in (-1, 0, 1):
            mask[1:-1, 1:-1] &= (
                numpy.roll(owner, (rows, columns), (0, 1))[1:-1, 1:-1] == owner[1:-1, 1:-1]
            )
    return mask


def dense_ball(side=9):
    """A volume that is opaque in its middle, of side 1 around the origin."""
    image = vtkImageData()
    image.SetDimensions(side, side, side)
    image.SetSpacing(1 / (side - 1), 1 / (side - 1), 1 / (side - 1))
    image.SetOrigin(-0.5, -0.5, -0.5)
    z, y, x = numpy.mgrid[-1 : 1 : side * 1j, -1 : 1 : side * 1j, -1 : 1 : side * 1j]
    values = numpy.maximum(0, 1 - numpy.sqrt(x**2 + y**2 + z**2)).astype("f4")
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 0)
    opacity.AddPoint(1, 1)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetScalarOpacityUnitDistance(0.1)
    return volume
