# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers of volumes against closed forms and a march through the same samples in double."""

import json
import math
import pathlib
import resource
import tempfile
import unittest

import numpy
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import (
    vtkImageData, vtkMultiBlockDataSet, vtkPiecewiseFunction, vtkPlane,
    vtkRectilinearGrid)  # fmt: skip
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkAssembly, vtkColorTransferFunction, vtkLODProp3D, vtkRenderer, vtkVolume)  # fmt: skip
from vtkmodules.vtkRenderingOpenGL2 import vtkTextureObject
from vtkmodules.vtkRenderingVolume import (
    vtkFixedPointVolumeRayCastMapper, vtkGPUVolumeRayCastMapper)  # fmt: skip
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkMultiBlockVolumeMapper, vtkSmartVolumeMapper

import relievo
from scenes import add, window_of

LAYERS = ["volume_depth", "volume_position", "volume_value", "volume_normal", "volume_opacity",
          "volume"]  # fmt: skip
SIZE = (64, 64)
SIDE = 17  # points of an image along each axis
MIDDLE = (SIDE - 1) / 2
INNER = (slice(12, 52),) * 2  # pixels of a box that is seen along z, without its rim


def grid(side=SIDE):
    """z, y and x of an image's points, in points from its middle."""
    return numpy.mgrid[0:side, 0:side, 0:side] - (side - 1) / 2


def image_of(values, spacing=(1, 1, 1), origin=(0, 0, 0), direction=None, of_cells=False,
             kind="f4"):  # fmt: skip
    image = vtkImageData()
    image.SetDimensions(*(n + of_cells for n in values.shape[::-1]))
    image.SetSpacing(*spacing)
    image.SetOrigin(*origin)
    if direction is not None:
        image.SetDirectionMatrix(*direction.ravel())
    array = numpy_to_vtk(values.astype(kind).ravel(), deep=True)
    array.SetName("values")
    (image.GetCellData() if of_cells else image.GetPointData()).SetScalars(array)
    return image


def filled(origin=(0, 0, 0)):
    """The value 1, but for a corner that no ray of INNER meets: VTK's table needs a range."""
    values = numpy.ones((SIDE,) * 3)
    values[0, 0, 0] = 0
    return image_of(values, origin=origin)


class Scene:
    """A volume of a given opacity, in a renderer with one camera."""

    def __init__(self, image, opacity, step=0.25, unit=1.0, mapper=None):
        self.image = image
        self.step = step
        self.longest = 2**30  # of a table
        self.mapper = mapper or vtkGPUVolumeRayCastMapper()
        self.mapper.SetInputDataObject(image)
        if mapper is None:
            self.mapper.SetAutoAdjustSampleDistances(False)
            self.mapper.SetSampleDistance(step)
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.opacity = vtkPiecewiseFunction()
        for value, share in opacity:
            self.opacity.AddPoint(value, share)
        color = vtkColorTransferFunction()
        color.AddRGBPoint(0, 1, 0.5, 0.2)
        look = self.volume.GetProperty()
        look.SetScalarOpacity(self.opacity)
        look.SetColor(color)
        look.SetScalarOpacityUnitDistance(unit)
        look.SetInterpolationTypeToLinear()
        self.unit = unit
        self.renderer = vtkRenderer()
        self.renderer.AddVolume(self.volume)
        self.look_at()

    def look_at(self, position=(MIDDLE, MIDDLE, 60), to=(MIDDLE,) * 3, up=(0, 1, 0), near=1,
                far=200, parallel=True):  # fmt: skip
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*position)
        camera.SetFocalPoint(*to)
        camera.SetViewUp(*up)
        camera.SetParallelProjection(parallel)
        camera.SetParallelScale(10)
        camera.SetClippingRange(near, far)

    def set_rule(self, rule, opacity=0.5):
        relievo.stage(self.renderer, "volumes", rule=rule, opacity=opacity)

    def capture(self, layers=LAYERS):
        """The layers as arrays, row 0 at the bottom."""
        image = relievo.capture(self.renderer, layers, size=SIZE)
        return {name: relievo.layer(image, name)[::-1] for name in layers}

    # The march in double ------------------------------------------------------------------

    def rays(self):
        """Of each pixel: the eye, and the point at depth 1 further, in the world."""
        camera = self.renderer.GetActiveCamera()
        matrix = camera.GetCompositeProjectionTransformMatrix(SIZE[0] / SIZE[1], -1, 1)
        inverse = numpy.linalg.inv(array_of(matrix))
        y, x = numpy.mgrid[0:SIZE[1], 0:SIZE[0]]
        ndc = [(2 * x + 1) / SIZE[0] - 1, (2 * y + 1) / SIZE[1] - 1]
        ends = []
        for z in (-1, 1):
            point = numpy.stack([*ndc, z + 0 * x, 1 + 0 * x], -1) @ inverse.T
            ends.append(point[..., :3] / point[..., 3:])
        return ends

    def depths(self, points):
        view = array_of(self.renderer.GetActiveCamera().GetViewTransformMatrix())
        return -(points @ view[2, :3] + view[2, 3])

    def table(self):
        """Opacities of a step over the data's range, as VTK's texture has them."""
        low, high = self.range()
        needed = self.opacity.EstimateMinNumberOfSamples(low, high)
        size = max(1024, 2 ** math.ceil(math.log2(needed)))
        size = min(size, self.longest)
        shares = [self.opacity.GetValue(low + (high - low) * i / (size - 1)) for i in range(size)]
        shares = numpy.array(shares)
        corrected = 1 - (1 - shares) ** (self.step / self.unit)
        return numpy.where(shares > 0.0001, corrected, shares)

    def range(self):
        data = self.image.GetPointData().GetScalars() or self.image.GetCellData().GetScalars()
        return data.GetRange()

    def march(self, values, rule="opacity", threshold=0.5):
        """Depth and opacity of each pixel from the samples at step, 2 step, ... behind the entry.

        values: at the points of the image, or of its cells, [z, y, x]."""
        to_world = array_of(self.volume.GetMatrix())
        to_data = array_of(self.image.GetIndexToPhysicalMatrix())
        begin, end = self.rays()
        to_index = numpy.linalg.inv(to_world @ to_data)
        a = begin @ to_index[:3, :3].T + to_index[:3, 3]
        b = end @ to_index[:3, :3].T + to_index[:3, 3]
        last = numpy.array(self.image.GetDimensions()) - 1
        with numpy.errstate(divide="ignore", invalid="ignore"):
            t = numpy.stack([(0 - a) / (b - a), (last - a) / (b - a)])
        entry = numpy.nanmax(t.min(0), -1)
        leave = numpy.nanmin(t.max(0), -1)
        near, far = self.renderer.GetActiveCamera().GetClippingRange()
        eye = self.depths(begin)
        view = array_of(self.renderer.GetActiveCamera().GetViewTransformMatrix())[2, :3]
        moved = 0.001 * (far - near) * numpy.linalg.norm(view @ to_world[:3, :3])
        inside = (near + moved - eye) / (self.depths(end) - eye)
        entry = numpy.maximum(entry, inside)
        data = numpy.linalg.norm((b - a) @ to_data[:3, :3].T, axis=-1)
        step = self.step / data
        table = self.table()
        low, high = self.range()
        passed = numpy.ones(entry.shape)
        found = numpy.full(entry.shape, numpy.nan)
        most = numpy.zeros(entry.shape)
        of_cells = self.image.GetPointData().GetScalars() is None
        count = int(numpy.nanmax(numpy.where(leave > entry, (leave - entry) / step, 0))) + 1
        for k in range(1, count + 1):
            at = entry + k * step
            inbox = at <= leave
            at = numpy.where(inbox, at, 0)
            place = a + at[..., None] * (b - a)
            value = trilinear(values, place - 0.5 * of_cells)
            share = (value - low) / (high - low) if high > low else 0 * value
            where = numpy.clip(share * len(table) - 0.5, 0, len(table) - 1)
            share = numpy.interp(where, numpy.arange(len(table)), table)
            share = numpy.where(inbox & (passed >= 1 / 255), share, 0)
            after = passed * (1 - share)
            if rule == "first":
                found = numpy.where(numpy.isnan(found) & (share > 0), at, found)
            elif rule == "strongest":
                better = passed - after > most
                most = numpy.where(better, passed - after, most)
                found = numpy.where(better, at, found)
            else:
                now = numpy.isnan(found) & (after <= 1 - threshold)
                with numpy.errstate(divide="ignore", invalid="ignore"):
                    part = numpy.log((1 - threshold) / passed) / numpy.log(after / passed)
                found = numpy.where(now, at + (part - 1) * step, found)
            passed = after
        places = begin + numpy.nan_to_num(found)[..., None] * (end - begin)
        depths = numpy.where(numpy.isnan(found), numpy.inf, self.depths(places))
        # A step's length along the depth, and pixels whose rays end near a sample or the box's rim.
        steps = step * (self.depths(end) - eye)
        crossed = numpy.where(numpy.isfinite(leave - entry), leave - entry, -1)
        sure = numpy.abs(crossed / step % 1 - 0.5) < 0.49
        sure &= (crossed > 2 * step) | (crossed < -0.1)
        return depths, 1 - passed, steps, sure


def array_of(matrix):
    return numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def trilinear(values, places):
    """At positions x, y, z in points; the values of the rim beyond it."""
    top = numpy.array(values.shape[::-1]) - 1
    places = numpy.clip(places, 0, top)
    low = numpy.minimum(places.astype(int), numpy.maximum(top - 1, 0))
    part = places - low
    result = 0
    for corner in range(8):
        bits = [corner >> axis & 1 for axis in range(3)]
        weight = 1
        for axis in range(3):
            weight = weight * (part[..., axis] if bits[axis] else 1 - part[..., axis])
        x, y, z = (low[..., axis] + bits[axis] for axis in range(3))
        result = result + weight * values[z, y, x]
    return result


def ball(side=SIDE):
    """Values that fall from the middle: 1 there, 0 at 7 points from it."""
    z, y, x = grid(side)
    return numpy.maximum(0, 1 - numpy.sqrt(x**2 + y**2 + z**2) / 7)


STEEP = [(0, 0), (0.2, 0), (1, 0.9)]


class Volumes(unittest.TestCase):
    def check(self, scene, values, rule="opacity", threshold=0.5, least=500, most=1e-5, differ=2,
              opacity=1e-4):  # fmt: skip
        """Compares with the march: positions of at least `least` pixels, which differ by at most
        `most` steps, but for `differ` pixels that have a depth in one of both; and opacities."""
        scene.set_rule(rule, threshold)
        found = scene.capture()
        depths, opacities, steps, sure = scene.march(values, rule, threshold)
        hit = numpy.isfinite(depths) & sure
        self.assertGreater(hit.sum(), least)
        seen = numpy.isfinite(found["volume_depth"])
        different = (seen != numpy.isfinite(depths)) & sure
        self.assertLessEqual(different.sum(), differ)
        hit &= seen
        places = scene.depths(found["volume_position"])
        off = numpy.abs(places[hit] - depths[hit]) / steps[hit]
        errors = numpy.abs(found["volume_opacity"] - opacities)[sure]
        self.assertLessEqual(off.max(), most)
        self.assertLessEqual(errors.max(), opacity)
        # The other layers belong to the same place.
        numpy.testing.assert_allclose(found["volume_depth"][seen], places[seen], 1e-7)
        self.assertTrue((found["volume"] == numpy.where(seen, 0, -1)).all())
        self.assertTrue((numpy.isnan(found["volume_value"]) == ~seen).all())
        return found

    def test_box(self):
        """Constant extinction: closed forms."""
        for unit, share in ((1.0, 0.1), (0.01, 0.002), (100.0, 0.999)):
            scene = Scene(filled(), [(0, 0), (1, share)], step=0.3, unit=unit)
            for threshold in (0.3, 0.5):
                scene.set_rule("opacity", threshold)
                found = scene.capture()
                extinction = -math.log(1 - share) / unit
                depth = 60 - (SIDE - 1) - math.log(1 - threshold) / extinction
                self.assertLess(numpy.abs(found["volume_depth"][INNER] - depth).max(), 2e-5 * depth)
                # VTK's march ends with the last of the 53 steps that fit into the box.
                opacity = 1 - math.exp(-extinction * 53 * 0.3)
                # VTK ends rays at 254/255.
                errors = numpy.abs(found["volume_opacity"][INNER] - opacity)
                self.assertLess(errors.max(), 1e-5 if opacity < 254 / 255 else 1 / 255)

    def test_ramp(self):
        """A linear ramp: the depth of its first visible value, the value there, its direction."""
        z = grid()[0]
        values = (z + MIDDLE) / (SIDE - 1)
        scene = Scene(image_of(values), [(0, 0), (0.4, 0), (0.41, 0.5), (1, 0.5)], step=0.13)
        scene.look_at((MIDDLE, MIDDLE, -44))
        found = self.check(scene, values, "first", least=1500)
        depth = 44 + 0.4 * (SIDE - 1)
        hit = numpy.isfinite(found["volume_depth"])
        self.assertLess(numpy.abs(found["volume_depth"][hit] - depth - 0.065).max(), 0.07)
        value = found["volume_position"][hit][:, 2] / (SIDE - 1)
        self.assertLess(numpy.abs(found["volume_value"][hit] - value).max(), 1e-5)
        self.assertLess(numpy.abs(found["volume_normal"][hit] - (0, 0, -1)).max(), 1e-5)

    def test_ball(self):
        for parallel in (True, False):
            for rule in ("first", "opacity", "strongest"):
                scene = Scene(image_of(ball()), STEEP)
                scene.look_at((30, 25, 40), up=(0.2, 1, 0), parallel=parallel)
                found = self.check(scene, ball(), rule)
                hit = numpy.isfinite(found["volume_depth"])
                out = found["volume_position"][hit] - MIDDLE
                out /= numpy.linalg.norm(out, axis=-1, keepdims=True)
                normals = found["volume_normal"][hit]
                self.assertLess(numpy.abs(numpy.linalg.norm(normals, axis=-1) - 1).max(), 1e-5)
                self.assertGreater((normals * out).sum(-1).min(), 0.98)

    def test_placed(self):
        """Anisotropic spacing, a direction matrix, and a volume that is turned and scaled."""
        angle = 0.7
        turn = numpy.array([[math.cos(angle), -math.sin(angle), 0],
                            [math.sin(angle), math.cos(angle), 0], [0, 0, 1]])  # fmt: skip
        image = image_of(ball(), (0.6, 1, 0.8), (3, -2, 1), turn)
        scene = Scene(image, STEEP)
        scene.volume.RotateX(30)
        scene.volume.SetScale(1.4, 1.1, 0.9)
        bounds = scene.volume.GetBounds()
        middle = [(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
                  (bounds[4] + bounds[5]) / 2]  # fmt: skip
        scene.look_at([m + d for m, d in zip(middle, (10, 20, 40))], middle, parallel=False)
        self.check(scene, ball(), least=300)

    def test_inside(self):
        scene = Scene(image_of(ball()), [(0, 0.02), (1, 0.3)])
        scene.look_at((MIDDLE, MIDDLE, 12), (MIDDLE, MIDDLE, 0), near=0.5, far=30, parallel=False)
        scene.renderer.GetActiveCamera().SetViewAngle(70)
        self.check(scene, ball(), least=2000)
        # The near plane moves by a thousandth of the range, as units of the data.
        scene = Scene(image_of(ball()), [(0, 0.02), (1, 0.3)])
        scene.volume.SetScale(1, 1, 3)
        scene.look_at((9, 7, 36), (4, 10, 0), near=0.5, far=100, parallel=False)
        scene.renderer.GetActiveCamera().SetViewAngle(70)
        self.check(scene, ball(), least=2000, opacity=1e-3)

    def test_far(self):
        """VTK marches in float, so that a million voxels away its samples lie off the ray; the
        place is refined in double, where VTK has one."""
        origin = 1e6
        scene = Scene(image_of(ball(), origin=(origin,) * 3), STEEP)
        scene.look_at([origin + m for m in (30, 25, 40)], (origin + MIDDLE,) * 3)
        self.check(scene, ball(), differ=30, opacity=0.05)
        scene = Scene(image_of(ball()), STEEP)
        scene.volume.SetPosition((origin,) * 3)
        scene.look_at([origin + m for m in (30, 25, 40)], (origin + MIDDLE,) * 3)
        self.check(scene, ball(), differ=30, opacity=0.05)

    def test_cells(self):
        scene = Scene(image_of(ball(), of_cells=True), STEEP)
        scene.look_at((30, 25, 40), (MIDDLE + 0.5,) * 3, parallel=False)
        self.check(scene, ball())

    def test_kinds(self):
        """Integers, nearest values, and functions that need a longer table."""
        values = numpy.round(200 * ball())
        steep = [(200 * value, share) for value, share in STEEP]
        # VTK divides integers by the number of their values, OpenGL by the greatest one.
        for kind, larger in (("u1", 256 / 255), ("i2", 32768 / 32767), ("f8", 1)):
            scene = Scene(image_of(values, kind=kind), steep)
            scene.look_at((30, 25, 40), up=(0.2, 1, 0))
            for rule in ("first", "opacity"):
                self.check(scene, values * larger, rule, differ=20, opacity=0.02)
        scene = Scene(image_of(ball()), [(0, 0), (0.5, 0), (0.5003, 0.9), (1, 0.9)])
        scene.look_at((30, 25, 40), up=(0.2, 1, 0))
        self.check(scene, ball(), "first", least=150, opacity=2e-3)
        # A table with 2^25 opacities, which no texture can hold.
        scene = Scene(image_of(ball()), [(0, 0), (0.5, 0), (0.5 + 5e-8, 0.9), (1, 0.9)])
        scene.look_at((30, 25, 40), up=(0.2, 1, 0))
        window = window_of(scene.renderer, *SIZE)
        window.Render()
        scene.longest = vtkTextureObject.GetMaximumTextureSize(window)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        vtkObject.GlobalWarningDisplayOff()  # of VTK's about the table
        self.addCleanup(vtkObject.GlobalWarningDisplayOn)
        self.check(scene, ball(), "first", least=150, opacity=0.01)
        grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
        self.assertLess(grown, 1 << 17)  # KiB

    def test_functions(self):
        """An opacity of the gradient that is 1, weights of components, a rectilinear grid."""
        plain = Scene(image_of(ball()), STEEP)
        truth = plain.capture()
        gradient = Scene(image_of(ball()), STEEP)
        opaque = vtkPiecewiseFunction()
        opaque.AddPoint(0, 1)
        gradient.volume.GetProperty().SetGradientOpacity(opaque)
        image = image_of(ball())
        both = numpy.stack([ball().ravel(), numpy.linspace(0, 1, SIDE**3)], -1)
        image.GetPointData().SetScalars(numpy_to_vtk(both.astype("f4"), deep=True))
        two = Scene(image, STEEP)
        look = two.volume.GetProperty()
        look.SetScalarOpacity(1, two.opacity)
        look.SetColor(1, look.GetRGBTransferFunction(0))
        look.SetComponentWeight(1, 0)
        for scene in (gradient, two):
            found = scene.capture()
            for name in ("volume_depth", "volume_value", "volume_opacity", "volume"):
                numpy.testing.assert_allclose(found[name], truth[name], 1e-4, 1e-4, err_msg=name)
        # Both components of 1, with weights of less than 1: those that do not exist have 1.
        image = image_of(ball())
        both = numpy.stack([ball().ravel(), 0.5 * ball().ravel()], -1)
        image.GetPointData().SetScalars(numpy_to_vtk(both.astype("f4"), deep=True))
        for weights in ((0.3, 0.7), (0.7, 0.3)):
            weighted = Scene(image, STEEP)
            look = weighted.volume.GetProperty()
            look.SetScalarOpacity(1, weighted.opacity)
            look.SetColor(1, look.GetRGBTransferFunction(0))
            for component, weight in enumerate(weights):
                look.SetComponentWeight(component, weight)
            weighted.set_rule("first")
            found = weighted.capture()
            hit = numpy.isfinite(found["volume_depth"])
            self.assertGreater(hit.sum(), 500)
            radii = numpy.linalg.norm(found["volume_position"][hit] - MIDDLE, axis=-1)
            value = (1 - radii / 7) * (0.5 if weights[1] > weights[0] else 1)
            self.assertLess(numpy.abs(found["volume_value"][hit] - value).max(), 0.02, weights)
        grid = vtkRectilinearGrid()
        grid.SetDimensions(SIDE, SIDE, SIDE)
        coordinates = numpy.linspace(0, 1, SIDE) ** 1.5 * (SIDE - 1)
        for place in (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates):
            place(numpy_to_vtk(coordinates, deep=True))
        grid.GetPointData().SetScalars(filled().GetPointData().GetScalars())
        found = Scene(grid, [(0, 0), (1, 0.1)], step=0.3).capture()
        depth = 60 - (SIDE - 1) + math.log(0.5) / math.log(0.9)
        self.assertLess(numpy.abs(found["volume_depth"][INNER] - depth).max(), 1e-3)

    def test_nothing(self):
        """Opacity 0 everywhere, and values that are no numbers."""
        scene = Scene(image_of(ball()), [(0, 0), (1, 0)])
        found = scene.capture()
        self.assertTrue(numpy.isinf(found["volume_depth"]).all())
        self.assertTrue((found["volume_opacity"] == 0).all() and (found["volume"] == -1).all())
        self.assertTrue((found["volume_position"] == 0).all())
        empty = vtkRenderer()
        image = relievo.capture(empty, ["volume_depth", "volume"], size=SIZE)
        self.assertTrue(numpy.isinf(relievo.layer(image, "volume_depth")).all())
        holes = ball()
        holes[:, :6] = numpy.nan
        full = Scene(image_of(ball()), STEEP).capture()
        found = Scene(image_of(holes), STEEP).capture()
        upper = slice(36, None)  # rows that no such value reaches
        for name in ("volume_depth", "volume_opacity", "volume"):
            numpy.testing.assert_allclose(found[name][upper], full[name][upper], 1e-4, 1e-4)

    def test_surfaces(self):
        """Rays end at opaque surfaces; those behind them are hidden."""
        scene = Scene(filled(), [(0, 0), (1, 0.1)])
        for z, steps, shown in ((6.1, 40, True), (-5, 63, True), (12.1, 16, False), (20, 0, False)):
            plane = vtkPlaneSource()
            plane.SetOrigin(-40, -40, z)
            plane.SetPoint1(40, -40, z)
            plane.SetPoint2(-40, 40, z)
            actor = add(scene.renderer, plane)
            found = scene.capture(["volume_depth", "volume_opacity", "depth"])
            scene.renderer.RemoveActor(actor)
            self.assertTrue((numpy.isfinite(found["volume_depth"][INNER]) == shown).all(), z)
            opacity = 1 - 0.9 ** (steps / 4)
            if z != -5:  # without a surface, the last step may lie on the box's rim
                errors = numpy.abs(found["volume_opacity"][INNER] - opacity).max()
                self.assertLess(errors, 1e-4, z)
            numpy.testing.assert_allclose(found["depth"], 60 - z, 1e-6)

    def test_cut(self):
        """Cropping, clipping planes and masks, which VTK's march follows."""
        dense = [(0, 0), (1, 0.999999)]
        for cut in ("crop", "clip", "mask"):
            scene = Scene(filled(), dense)
            if cut == "crop":
                scene.mapper.CroppingOn()
                scene.mapper.SetCroppingRegionPlanes(-1, 17, -1, 17, -1, 10)
                scene.mapper.SetCroppingRegionFlagsToSubVolume()
            elif cut == "clip":
                plane = vtkPlane()
                plane.SetOrigin(0, 0, 10)
                plane.SetNormal(0, 0, -1)
                scene.mapper.AddClippingPlane(plane)
            else:
                mask = vtkImageData()
                mask.SetDimensions(SIDE, SIDE, SIDE)
                array = numpy_to_vtk((255 * (grid()[0] + MIDDLE <= 10)).astype("u1").ravel(),
                                     deep=True)  # fmt: skip
                mask.GetPointData().SetScalars(array)
                scene.mapper.SetMaskInput(mask)
                scene.mapper.SetMaskTypeToBinary()
            found = scene.capture()
            off = numpy.abs(found["volume_depth"][INNER] - 50).max()
            self.assertLess(off, 1.3 if cut == "mask" else 0.3, cut)
            # The first sample that counts has no value before it.
            numpy.testing.assert_allclose(found["volume_value"][INNER], 1, 0, 1e-5, err_msg=cut)

    def test_oblique_cut(self):
        """Samples are at whole steps from a clipping plane. It is in the middle: VTK 9.2 scales the
        planes about it, by one point more than there are."""
        share, step = 0.2, 0.5
        scene = Scene(filled(), [(0, 0), (1, share)], step=step)
        plane = vtkPlane()
        middle = numpy.full(3, MIDDLE)
        plane.SetOrigin(middle)
        normal = numpy.array((0.3, -0.2, -1)) / numpy.linalg.norm((0.3, -0.2, -1))
        plane.SetNormal(normal)
        scene.mapper.AddClippingPlane(plane)
        begin, end = scene.rays()
        cut = (middle - begin) @ normal / ((end - begin) @ normal)
        cut = scene.depths(begin + cut[..., None] * (end - begin))
        for rule in ("first", "opacity", "strongest"):
            scene.set_rule(rule)
            depth = cut + (math.log(0.5) / math.log(1 - share) if rule == "opacity" else step)
            off = numpy.abs(scene.capture()["volume_depth"] - depth)[INNER]
            self.assertLess(off.max(), 0.01 * step, rule)

    def test_intensities(self):
        """Maximum and minimum: where the greatest and the least value is."""
        x, y, z = numpy.mgrid[0:SIDE, 0:SIDE, 0:SIDE][::-1]
        values = 1 - numpy.abs(z - 6) / 20.0
        scene = Scene(image_of(values), [(0, 0), (1, 0.8)])
        scene.mapper.SetBlendModeToMaximumIntensity()
        found = scene.capture()
        self.assertLess(numpy.abs(found["volume_depth"][INNER] - 54).max(), 0.13)
        self.assertLess(numpy.abs(found["volume_value"][INNER] - 1).max(), 0.007)
        self.assertLess(numpy.abs(found["volume_opacity"][INNER] - 0.8).max(), 0.01)
        scene.mapper.SetBlendModeToMinimumIntensity()
        found = scene.capture()
        self.assertLess(numpy.abs(found["volume_depth"][INNER] - 44.25).max(), 0.1)

    def test_mappers(self):
        """Smart mappers and blocks; steps chosen by VTK, with and without jitter."""
        plain = Scene(image_of(ball()), STEEP, step=0.5)
        truth = plain.capture()
        smart = vtkSmartVolumeMapper()
        smart.SetRequestedRenderModeToGPU()
        blocks = vtkMultiBlockVolumeMapper()
        for mapper in (smart, blocks):
            scene = Scene(image_of(ball()), STEEP, mapper=mapper)
            found = scene.capture()
            hit = numpy.isfinite(truth["volume_depth"]) & numpy.isfinite(found["volume_depth"])
            self.assertGreater(hit.sum(), 500)
            off = numpy.abs(found["volume_depth"][hit] - truth["volume_depth"][hit])
            self.assertLess(off.max(), 0.3)
        jitter = Scene(image_of(ball()), STEEP, step=0.5)
        jitter.mapper.UseJitteringOn()
        numpy.testing.assert_array_equal(jitter.capture()["volume_depth"], truth["volume_depth"])

    def test_parts(self):
        """Volumes in an assembly, and as levels of detail."""
        plain = Scene(image_of(ball()), STEEP)
        plain.volume.SetPosition(1, 2, 3)
        truth = plain.capture()
        assembly = vtkAssembly()
        levels = vtkLODProp3D()
        for prop in (assembly, levels):
            scene = Scene(image_of(ball()), STEEP)
            scene.renderer.RemoveVolume(scene.volume)
            if prop is assembly:
                prop.AddPart(scene.volume)
            else:
                prop.AddLOD(scene.mapper, scene.volume.GetProperty(), 0.0)
            prop.SetPosition(1, 2, 3)
            scene.renderer.AddViewProp(prop)
            found = scene.capture()
            for name in LAYERS:
                numpy.testing.assert_allclose(found[name], truth[name], 1e-5, 1e-5, err_msg=name)

    def test_rejected(self):
        """Volumes without layers are named once."""
        on_cpu = vtkSmartVolumeMapper()
        on_cpu.SetRequestedRenderModeToRayCast()
        average = vtkGPUVolumeRayCastMapper()
        average.SetBlendModeToAverageIntensity()
        isosurface = vtkGPUVolumeRayCastMapper()
        isosurface.SetBlendModeToIsoSurface()
        for mapper, words in ((on_cpu, "on the CPU"), (average, "average and additive"),
                              (isosurface, "isosurface and slice"),
                              (vtkFixedPointVolumeRayCastMapper(), "vtkFixedPoint"),
                              (vtkMultiBlockVolumeMapper(), "several blocks")):  # fmt: skip
            data = image_of(ball())
            if words == "several blocks":
                data = vtkMultiBlockDataSet()
                data.SetBlock(0, image_of(ball()[:9]))
                data.SetBlock(1, image_of(ball()[8:], origin=(0, 0, 8)))
            scene = Scene(data, STEEP, mapper=mapper)
            window = window_of(scene.renderer, *SIZE)
            frame = relievo.attach(scene.renderer)
            errors = []

            def note(stage, event, text):
                errors.append(text)

            note.CallDataType = "string0"
            frame.GetStage("volumes").AddObserver("ErrorEvent", note)
            frame.RequestLayer("volume_depth")
            window.Render()
            window.Render()
            self.assertEqual(len(errors), 1, words)
            self.assertRegex(errors[0], "Volume 0 lacks .*" + words)
            image = vtkImageData()
            fault = frame.TryReadLayers(["volume_depth"], image)
            if words == "several blocks":  # which have an opacity
                self.assertEqual(fault, "")
                depths = image.GetPointData().GetArray("volume_depth")
                self.assertEqual({depths.GetValue(i) for i in range(SIZE[0] * SIZE[1])}, {math.inf})
            else:
                self.assertIn(words, fault)
        bricks = Scene(image_of(ball()), STEEP)
        bricks.mapper.SetPartitions(1, 1, 2)
        with self.assertRaisesRegex(ValueError, "bricks"):
            bricks.capture()
        bricks.set_rule("first")
        self.assertGreater(numpy.isfinite(bricks.capture()["volume_depth"]).sum(), 500)
        bricks.mapper.SetBlendModeToMaximumIntensity()
        with self.assertRaisesRegex(ValueError, "bricks"):
            bricks.capture()

    def test_changed_later(self):
        """Values that change after a frame, before its layers are read, do not move its places."""
        scene = Scene(image_of(ball()), STEEP)
        truth = scene.capture()["volume_depth"]
        frame = relievo.attach(scene.renderer)
        frame.RequestLayer("volume_depth")
        window = window_of(scene.renderer, *SIZE)
        window.Render()
        vtk_to_numpy(scene.image.GetPointData().GetScalars())[:] *= 1.1
        scene.image.Modified()
        image = vtkImageData()
        self.assertEqual(frame.TryReadLayers(["volume_depth"], image), "")
        found = relievo.layer(image, "volume_depth")[::-1]
        hit = numpy.isfinite(truth)
        self.assertGreater(hit.sum(), 500)
        self.assertLess(numpy.abs(found[hit] - truth[hit]).max(), 0.02 * scene.step)

    def test_file(self):
        """OpenEXR holds the layers, and the rule."""
        scene = Scene(image_of(ball()), STEEP)
        scene.set_rule("opacity", 0.25)
        image = relievo.capture(scene.renderer, LAYERS, size=SIZE)
        with tempfile.TemporaryDirectory() as folder:
            relievo.write_exr(folder + "/a.exr", image)
            read = relievo.read_exr(folder + "/a.exr")
        for name in LAYERS:
            numpy.testing.assert_allclose(
                relievo.layer(read, name), relievo.layer(image, name), 0, 2e-6, err_msg=name)
        rule = read.GetFieldData().GetAbstractArray("volumeRule")
        self.assertEqual(rule.GetValue(0), "opacity=0.25")

    def test_two_blocks(self):
        values = ball()
        halves = vtkMultiBlockDataSet()
        halves.SetBlock(0, image_of(values[:9]))
        halves.SetBlock(1, image_of(values[8:], origin=(0, 0, 8)))
        opaque = [(0, 0), (0.3, 0), (0.31, 1), (1, 1)]
        scene = Scene(halves, opaque, mapper=vtkMultiBlockVolumeMapper())
        scene.look_at((30, 25, 40))
        scene.set_rule("first")
        found = scene.capture()
        whole = Scene(image_of(values), opaque)
        whole.look_at((30, 25, 40))
        whole.set_rule("first")
        truth = whole.capture()
        hit = numpy.isfinite(found["volume_depth"]) & numpy.isfinite(truth["volume_depth"])
        self.assertGreater(hit.sum(), 300)
        off = numpy.abs(found["volume_depth"][hit] - truth["volume_depth"][hit])
        self.assertLess(numpy.quantile(off, 0.95), 1.0)

    def test_labels(self):
        """Without interpolation, each place has the value of a point."""
        z, y, x = grid()
        values = numpy.where(x**2 + y**2 + z**2 < 49, 2.0 + (x > 0), 0.0)
        for refined in (True, False):
            kind = "f4" if refined else "u1"
            scene = Scene(image_of(values, kind=kind), [(0, 0), (1, 0), (1.5, 0.8), (3, 0.8)])
            scene.volume.GetProperty().SetInterpolationTypeToNearest()
            if not refined:
                scene.volume.GetProperty().SetGradientOpacity(vtkPiecewiseFunction())
                scene.volume.GetProperty().GetGradientOpacity().AddPoint(0, 1)
            scene.look_at((30, 25, 40), up=(0.2, 1, 0))
            found = scene.capture()
            hit = numpy.isfinite(found["volume_depth"])
            self.assertGreater(hit.sum(), 300)
            self.assertEqual(set(found["volume_value"][hit]), {2.0, 3.0})

    def test_several(self):
        """The nearest of two volumes; opacities multiply what passes."""
        scene = Scene(filled(), [(0, 0), (1, 0.1)], step=0.3)
        other = Scene(filled((0, 0, 30)), [(0, 0), (1, 0.1)], step=0.3)
        scene.renderer.AddVolume(other.volume)
        found = scene.capture()
        self.assertTrue((found["volume"][INNER] == 1).all())
        depth = 60 - 30 - (SIDE - 1) + math.log(0.5) / math.log(0.9)
        self.assertLess(numpy.abs(found["volume_depth"][INNER] - depth).max(), 1e-4)
        opacity = 1 - 0.9 ** (2 * 53 * 0.3)
        self.assertLess(numpy.abs(found["volume_opacity"][INNER] - opacity).max(), 1e-5)

    def test_picture_unchanged(self):
        """Capturing changes neither settings nor the picture."""
        scene = Scene(image_of(ball()), STEEP)
        scene.mapper.SetAutoAdjustSampleDistances(True)
        scene.mapper.SetImageSampleDistance(2)
        window = window_of(scene.renderer, *SIZE)
        before = relievo.layer(relievo.capture(scene.renderer, ["color"]), "color")
        times = scene.mapper.GetMTime(), window.GetDesiredUpdateRate()
        scene.capture()
        self.assertEqual(times, (scene.mapper.GetMTime(), window.GetDesiredUpdateRate()))
        self.assertEqual(scene.mapper.GetImageSampleDistance(), 2)
        after = relievo.layer(relievo.capture(scene.renderer, ["color"]), "color")
        numpy.testing.assert_array_equal(before, after)


WHITE = (1.0, 1.0, 1.0)


class Stages(unittest.TestCase):
    """Volumes with the frame's other stages: a row of docs/layers.md each."""

    def box(self, share=0.9999):
        """A box of constant values that absorbs quickly, white, seen along z."""
        scene = Scene(filled(), [(0, 0), (1, share)], step=0.1)
        color = vtkColorTransferFunction()
        color.AddRGBPoint(0, *WHITE)
        scene.volume.GetProperty().SetColor(color)
        scene.renderer.SetBackground(0, 0, 0)
        return scene

    def color(self, scene):
        """The linear colour, row 0 at the bottom."""
        image = relievo.capture(scene.renderer, ["color"], size=SIZE, hdr=True)
        return relievo.layer(image, "color")[::-1]

    def reason(self, scene, name):
        return relievo.attach(scene.renderer).GetStage(name).GetReason()

    def picture(self, renderer):
        return relievo.screenshot(renderer, size=SIZE).astype(int)[::-1]

    def test_solid(self):
        """depth, range and position are those of the nearer of surface and volume."""
        scene = self.box(0.3)
        plane = vtkPlaneSource()
        plane.SetOrigin(-20, -20, MIDDLE)
        plane.SetPoint1(60, -20, MIDDLE)
        plane.SetPoint2(-20, 60, MIDDLE)
        add(scene.renderer, plane)
        names = ["depth", "range", "position"]
        apart = scene.capture([*names, "volume_depth", "volume_position"])
        relievo.stage(scene.renderer, "volumes", solid=True)
        image = relievo.capture(scene.renderer, names, size=SIZE)
        both = {name: relievo.layer(image, name)[::-1] for name in names}
        hit = numpy.isfinite(apart["volume_depth"])
        self.assertTrue(0.1 < hit.mean() < 0.9)
        # Half of the light, in a homogeneous medium; the plane elsewhere.
        depth = 60 - (SIDE - 1) + math.log(0.5) / math.log(0.7)
        self.assertLess(numpy.abs(both["depth"][INNER] - depth).max(), 1e-4)
        self.assertLess(numpy.abs(both["depth"][~hit] - (60 - MIDDLE)).max(), 1e-4)
        numpy.testing.assert_array_equal(both["position"][hit], apart["volume_position"][hit])
        eye = scene.renderer.GetActiveCamera().GetPosition()
        away = numpy.linalg.norm(both["position"] - eye, axis=-1)
        self.assertLess(numpy.abs(both["range"] - away).max(), 1e-4)
        with tempfile.TemporaryDirectory() as folder:
            relievo.write_exr(folder + "/a.exr", image)
            said = relievo.attributes(relievo.read_exr(folder + "/a.exr"))
        self.assertEqual((said["volumeRule"][0], said["depthOf"][0]),
                         ("opacity=0.5", "surfaces and volumes"))  # fmt: skip
        relievo.stage(scene.renderer, "volumes", solid=False)
        numpy.testing.assert_array_equal(scene.capture(["depth"])["depth"], apart["depth"])

    def test_dataset(self):
        """Solid volumes are objects of data sets; others hide nothing."""
        scene = Scene(image_of(ball()), STEEP)
        scene.look_at((30, 25, 40), up=(0.2, 1, 0), parallel=False)
        shelf = vtkPlaneSource()  # cuts the ball
        shelf.SetOrigin(-2, MIDDLE, -2)
        shelf.SetPoint1(18, MIDDLE, -2)
        shelf.SetPoint2(-2, MIDDLE, 18)
        add(scene.renderer, shelf)
        camera = scene.renderer.GetActiveCamera()
        views = {}
        with tempfile.TemporaryDirectory() as folder:
            for solid in (False, True):
                relievo.stage(scene.renderer, "volumes", solid=solid)
                to = f"{folder}/{solid}"
                relievo.write_dataset(
                    scene.renderer, [camera], to, "npz", ["volume_depth"], size=SIZE)
                (file,) = pathlib.Path(to).glob("*.npz")
                views[solid] = dict(numpy.load(file))
            relievo.write_dataset(scene.renderer, [camera], folder + "/coco", "coco", size=SIZE)
            file = pathlib.Path(folder, "coco", "instances.json")
            coco = json.loads(file.read_text())
        self.assertEqual(set(numpy.unique(views[False]["object"])), {0, 1})
        view = views[True]
        hit = numpy.isfinite(view["volume_depth"])
        numpy.testing.assert_array_equal(view["object"] == 2, hit)
        numpy.testing.assert_array_equal(view["visible_masks"][1], hit)
        depth = numpy.where(hit, view["volume_depth"], views[False]["depth"])
        numpy.testing.assert_array_equal(view["depth"], depth)
        # The whole ball, without the shelf.
        whole = view["amodal_masks"][1]
        self.assertTrue((whole | ~hit).all())
        self.assertGreater(whole.sum(), 1.15 * hit.sum())
        numpy.testing.assert_array_equal(view["amodal_masks"][0], views[False]["visible_masks"][0])
        self.assertEqual([each["name"] for each in coco["categories"]], ["actor_0", "volume_0"])
        areas = {each["category_id"]: each["area"] for each in coco["annotations"]}
        self.assertEqual(areas[2], hit.sum())
        with tempfile.TemporaryDirectory() as folder:
            # Refused before the first view is drawn.
            cameras = [camera, relievo.Equirectangular((64, 32))]
            with self.assertRaisesRegex(ValueError, "view 1.*pinhole"):
                relievo.write_dataset(scene.renderer, cameras, folder + "/a", "npz", size=SIZE)
            self.assertFalse(pathlib.Path(folder, "a").exists())
            # A volume takes the next number whose name no actor has.
            relievo.write_dataset(scene.renderer, [camera], folder + "/b", "coco", size=SIZE,
                                  objects=["volume_0"])  # fmt: skip
            coco = json.loads(pathlib.Path(folder, "b", "instances.json").read_text())
        self.assertEqual([each["name"] for each in coco["categories"]], ["volume_0", "volume_1"])

    def test_pick(self):
        scene = self.box(0.3)
        plane = vtkPlaneSource()
        plane.SetOrigin(-1, -1, -3)
        plane.SetPoint1(30, -1, -3)
        plane.SetPoint2(-1, 2, -3)
        actor = add(scene.renderer, plane)
        found = relievo.pick(scene.renderer, SIZE[0] // 2, SIZE[1] // 2, size=SIZE)
        self.assertEqual((found.kind, found.index, found.cell), ("volume", 0, -1))
        self.assertIs(found.prop, scene.volume)
        depth = 60 - (SIDE - 1) + math.log(0.5) / math.log(0.7)
        self.assertAlmostEqual(found.depth, depth, delta=1e-4)
        self.assertAlmostEqual(found.position[2], 60 - depth, delta=1e-4)
        self.assertEqual(found.value, 1)
        self.assertGreater(found.opacity, 0.99)
        found = relievo.pick(scene.renderer, SIZE[0] - 4, SIZE[1] - 7, size=SIZE)
        self.assertEqual((found.kind, found.cell), ("surface", 0))
        self.assertIs(found.prop, actor)
        self.assertAlmostEqual(found.depth, 63, delta=1e-4)
        self.assertTrue(math.isnan(found.value))
        found = relievo.pick(scene.renderer, 1, 1, size=SIZE)
        self.assertFalse(found)
        self.assertIsNone(found.prop)
        with self.assertRaisesRegex(ValueError, "x, y: got 64, 0"):
            relievo.pick(scene.renderer, 64, 0, size=SIZE)
        with self.assertRaisesRegex(ValueError, "x, y: got 1.5, 0"):
            relievo.pick(scene.renderer, 1.5, 0, size=SIZE)

    def test_rejected_and_surfaces(self):
        """Without a volume that has layers, surfaces are still found."""
        average = vtkGPUVolumeRayCastMapper()
        average.SetBlendModeToAverageIntensity()
        scene = Scene(image_of(ball()), STEEP, mapper=average)
        plane = vtkPlaneSource()
        plane.SetOrigin(-20, -20, -3)
        plane.SetPoint1(60, -20, -3)
        plane.SetPoint2(-20, 60, -3)
        actor = add(scene.renderer, plane)
        found = relievo.pick(scene.renderer, 32, 32, size=SIZE)
        self.assertIs(found.prop, actor)
        self.assertIsNone(found.position.base)
        bricks = Scene(image_of(ball()), STEEP)
        bricks.mapper.SetPartitions(1, 1, 2)
        with self.assertRaisesRegex(ValueError, "bricks"):
            relievo.pick(bricks.renderer, 32, 32, size=SIZE)
        relievo.stage(scene.renderer, "volumes", solid=True)
        image = relievo.capture(scene.renderer, ["depth"], size=SIZE)
        numpy.testing.assert_allclose(relievo.layer(image, "depth"), 63, atol=1e-4)
        self.assertIsNone(image.GetFieldData().GetAbstractArray("depthOf"))
        # A frame in which fog needs the volumes' depth, and no stage needs the surfaces'.
        scene = self.box(0.3)
        relievo.stage(scene.renderer, "volumes", solid=True)
        window = window_of(scene.renderer, *SIZE)
        frame = relievo.attach(scene.renderer)
        frame.RequestLayer("volume_depth")
        frame.RequestLayer("normal")
        window.Render()
        self.assertIn("RequestLayer", frame.TryReadLayers(["depth"], vtkImageData()))

    def test_fog(self):
        """Fog in front of a volume covers it, fog behind does not."""
        scene = self.box()
        plain = self.color(scene)[INNER]
        self.assertGreater(plain.min(), 0.99)
        radius, density = 3, 0.2
        relievo.fog(scene.renderer, [(MIDDLE, MIDDLE, 30), (MIDDLE, MIDDLE, -20)],
                    radius=radius, density=density, color=(1, 0, 0))  # fmt: skip
        found = self.color(scene)[SIZE[1] // 2, SIZE[0] // 2]
        passes = math.exp(-density * 2 * radius)
        numpy.testing.assert_allclose(found[:3], (1, passes, passes), atol=4e-3)
        self.assertIn("volumes", [stage["name"] for stage in
                                  relievo.report(relievo.attach(scene.renderer))["stages"]
                                  if stage["ran"]])  # fmt: skip
        # Without the depth of volumes, they are fogged like the background.
        relievo.stage(scene.renderer, "volumes", False)
        found = self.color(scene)[SIZE[1] // 2, SIZE[0] // 2]
        self.assertLess(found[1], passes**2 + 0.02)

    def test_lines(self):
        """Lines at the silhouette of a box, and where it hides itself; none unless asked for."""
        scene = self.box()
        relievo.stage(scene.renderer, "lines")
        without = self.picture(scene.renderer)
        self.assertIn("without lines: 1 volume", self.reason(scene, "lines"))
        relievo.stage(scene.renderer, "lines", volumes=True, color=(1, 0, 0), width=2)
        lines = self.picture(scene.renderer)
        red = (lines[..., 0] - lines[..., 1] > 100) & (without[..., 1] >= 0)
        y, x = numpy.nonzero(red)
        self.assertGreater(len(x), 150)
        scale = SIZE[1] / 20  # pixels per point of the image
        low, high = SIZE[0] / 2 - MIDDLE * scale, SIZE[0] / 2 + MIDDLE * scale
        away = [numpy.minimum(abs(a + 0.5 - low), abs(a + 0.5 - high)) for a in (x, y)]
        self.assertLess(numpy.minimum(*away).max(), 2.1)

    def test_left_out(self):
        """Stages that leave volumes out say so."""
        scene = self.box()
        relievo.lamps(scene.renderer, [(MIDDLE, MIDDLE, 20)], radius=30)
        relievo.stage(scene.renderer, "ambient", samples=4)
        relievo.stage(scene.renderer, "deferred")
        add(scene.renderer, vtkPlaneSource())
        self.picture(scene.renderer)
        self.assertIn("not lit: 1 volume", self.reason(scene, "lamps"))
        self.assertIn("neither hiding nor darkened: 1 volume", self.reason(scene, "ambient"))
        self.assertIn("lit by VTK: 1 volume", self.reason(scene, "deferred"))

    def test_left_handed(self):
        """VTK draws no image with left-handed axes, and the report says so."""
        image = image_of(ball())
        image.SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, -1)
        scene = Scene(image, STEEP)
        relievo.attach(scene.renderer)
        self.assertLess(scene.capture()["volume_opacity"].max(), 0.1)
        reason = self.reason(scene, "volumes")
        self.assertIn("a volume is not drawn: its image has left-handed axes", reason)

    def test_rings(self):
        """Rings of VTK's march around a ball with a steep border, in levels of a picture with a
        very fine step: half the step removes more of them than jitter, which makes noise of them.
        """
        z, y, x = grid(40)
        image = image_of(20 - numpy.sqrt(x**2 + y**2 + z**2))
        pictures = {}
        for step, jitter in ((0.02, 0), (1, 0), (1, 1), (0.5, 0), (0.5, 1), (0.25, 0)):
            scene = Scene(image, [(0, 0), (4, 0), (4.6, 0.3)], step=step)
            scene.mapper.SetUseJittering(jitter)
            look = scene.volume.GetProperty()
            look.ShadeOn()
            look.GetRGBTransferFunction().AddRGBPoint(12, 0.9, 0.3, 0.2)
            scene.renderer.SetBackground(1, 1, 1)
            scene.look_at((19.5, 19.5, 100), (19.5, 19.5, 19.5), far=300)
            scene.renderer.GetActiveCamera().SetParallelScale(20)
            pictures[step, jitter] = relievo.screenshot(scene.renderer, size=(150, 150)).astype(int)
        fine = pictures.pop((0.02, 0))
        seen = fine.min(-1) < 250
        rms, worst = {}, {}
        for key, picture in pictures.items():
            off = (picture - fine)[seen]
            rms[key], worst[key] = math.sqrt((off**2).mean()), numpy.abs(off).max()
            print(f"step {key[0]}, jitter {key[1]}: rms {rms[key]:.2f} levels, worst {worst[key]}")
        self.assertGreater(rms[1, 0], 0.4)
        self.assertLess(rms[0.5, 0], 0.6 * rms[1, 0])
        self.assertLess(rms[0.5, 0], rms[1, 1])
        self.assertLessEqual(worst[0.5, 0], 2)
        self.assertLess(rms[0.25, 0], rms[0.5, 0])

    def test_blend_and_tone(self):
        """A volume is in the layer blend; the tone curve applies to it."""
        scene = self.box(0.05)
        blend = scene.capture(["blend", "volume_opacity"])
        numpy.testing.assert_allclose(
            blend["blend"][INNER][..., 3], blend["volume_opacity"][INNER], atol=2e-3)
        relievo.stage(scene.renderer, "tone", operator="clamp", exposure=-1)
        linear = 0.5 * self.color(scene)[INNER][..., 0]
        shown = self.picture(scene.renderer)[INNER][..., 0]
        curve = numpy.where(
            linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
        self.assertLess(numpy.abs(shown - 255 * curve).max(), 1.6)

    def test_peeling(self):
        """Peeling with volumes changes no layer."""
        scene = Scene(image_of(ball()), STEEP)
        plane = vtkPlaneSource()
        plane.SetOrigin(-20, -20, MIDDLE)
        plane.SetPoint1(60, -20, MIDDLE)
        plane.SetPoint2(-20, 60, MIDDLE)
        add(scene.renderer, plane).GetProperty().SetOpacity(0.5)
        before = scene.capture()
        scene.renderer.SetUseDepthPeeling(True)
        scene.renderer.SetUseDepthPeelingForVolumes(True)
        after = scene.capture()
        for name in LAYERS:
            numpy.testing.assert_array_equal(after[name], before[name], name)

    def test_shown(self):
        """volume_depth as the picture has the values of the capture."""
        scene = Scene(image_of(ball()), STEEP)
        depth = scene.capture(["volume_depth"])["volume_depth"]
        frame = relievo.attach(scene.renderer)
        near, far = 45, 55
        relievo.stage(scene.renderer, "display", layer="volume_depth", grey=True,
                      range=(near, far))  # fmt: skip
        shown = self.picture(scene.renderer)
        hit = numpy.isfinite(depth)
        grey = 255 * numpy.clip((depth[hit] - near) / (far - near), 0, 1)
        self.assertLess(numpy.abs(shown[hit][:, 0] - grey).max(), 1.1)
        self.assertTrue((shown[~hit] == 255).all())
        relievo.stage(scene.renderer, "display", grey=False, range=(0, 0))
        self.assertGreater(len(numpy.unique(self.picture(scene.renderer)[hit], axis=0)), 20)
        frame.SetDisplayLayer(None)
        self.assertLess(self.picture(scene.renderer)[~hit].max(), 255)


if __name__ == "__main__":
    unittest.main()
