# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces that are cut out by their opacity, against bilinear filtering in double."""

import unittest

import numpy
import scenes
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkTexture

import relievo
from relievo.vtkRelievoMaterials import vtkRelievoMaterial

COLUMNS, ROWS = 240, 180
CUTOFF = 0.45
WALL = -1.5
SUN = numpy.array((0.5, 0.7, 2.0))


def square(half, height):
    source = vtkPlaneSource()
    source.SetOrigin(-half, -half, height)
    source.SetPoint1(half, -half, height)
    source.SetPoint2(-half, half, height)
    return source


def smooth_texels():
    """8 x 8 texels with opacities that change slowly enough for pixels to tell."""
    values = numpy.random.default_rng(5).integers(0, 256, (8, 8, 4))
    values[..., :3] = 255
    return values.astype(numpy.uint8)


def sampled(alpha, uv, smooth, repeat):
    """Alpha (rows from the bottom) at texture coordinates, as OpenGL filters: 4.6, 8.14."""
    rows, columns = alpha.shape

    def texel(j, i):
        if repeat:
            return alpha[j % rows, i % columns]
        return alpha[numpy.clip(j, 0, rows - 1), numpy.clip(i, 0, columns - 1)]
    u = uv[..., 0] * columns - (0.5 if smooth else 0)
    v = uv[..., 1] * rows - (0.5 if smooth else 0)
    i = numpy.floor(u).astype(int)
    j = numpy.floor(v).astype(int)
    if not smooth:
        return texel(j, i)
    a = u - i
    b = v - j
    return ((1 - b) * ((1 - a) * texel(j, i) + a * texel(j, i + 1))
            + b * ((1 - a) * texel(j + 1, i) + a * texel(j + 1, i + 1)))


def near(mask, pixels):
    """Where within so many pixels both kinds are."""
    widened = {True: mask, False: ~mask}
    for kind, each in widened.items():
        for _ in range(pixels):
            grown = each.copy()
            grown[1:] |= each[:-1]
            grown[:-1] |= each[1:]
            both = grown.copy()
            both[:, 1:] |= grown[:, :-1]
            both[:, :-1] |= grown[:, 1:]
            each = both
        widened[kind] = each
    return widened[True] & widened[False]


class CutOut(unittest.TestCase):
    def setUp(self):
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(*SUN)
        light.SetFocalPoint(0, 0, 0)
        self.renderer.AddLight(light)
        self.texels = smooth_texels()
        self.front = scenes.add(self.renderer, square(1, 0))
        self.wall = scenes.add(self.renderer, square(3, WALL))
        self.wall.GetProperty().SetColor(0.2, 0.6, 0.3)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(1.2, 0.8, 4)
        camera.SetFocalPoint(-0.2, -0.2, 0)
        camera.SetClippingRange(1, 10)
        self.window = scenes.window_of(self.renderer, COLUMNS, ROWS)
        self.material = vtkRelievoMaterial()
        self.smooth = True
        self.repeat = True
        self.scale = (1.0, 1.0)
        self.factor = 1.0

    def tearDown(self):
        self.material.Detach(self.front)

    def texture(self):
        texture = vtkTexture()
        texture.SetInputData(relievo.to_image(self.texels))
        texture.SetInterpolate(self.smooth)
        texture.SetRepeat(self.repeat)
        if self.scale != (1.0, 1.0):
            placed = vtkTransform()
            placed.Scale(self.scale[0], self.scale[1], 1)
            texture.SetTransform(placed)
        return texture

    def put(self, pbr=False):
        texture = self.texture()
        shown = self.front.GetProperty()
        if pbr:
            shown.SetInterpolationToPBR()
            texture.UseSRGBColorSpaceOn()
            shown.RemoveTexture("albedoTex")
            shown.SetBaseColorTexture(texture)
        else:
            self.front.SetTexture(texture)
        shown.SetOpacity(self.factor)
        self.material.SetAlphaCutoff(CUTOFF)
        self.material.Attach(self.front)

    def opaque(self, places):
        """Whether the square is there, of places in its plane."""
        inside = (numpy.abs(places[..., :2]) <= 1).all(axis=-1)
        uv = (places[..., :2] + 1) / 2 * self.scale
        alpha = self.texels[::-1, :, 3].astype(float) / 255
        return inside & (self.factor * sampled(alpha, uv, self.smooth, self.repeat) >= CUTOFF)

    def seen(self):
        """Whether each pixel sees the square, and where on its plane."""
        origins, directions = scenes.rays(self.renderer.GetActiveCamera(), COLUMNS, ROWS)
        places = origins - directions * (origins[..., 2:] / directions[..., 2:])
        return self.opaque(places), places

    def check(self, pixels=1):
        there, places = self.seen()
        layers = ["actor", "depth", "normal", "position", "albedo", "cell", "color"]
        image = relievo.capture(self.renderer, layers)
        actor = relievo.layer(image, "actor")
        got = actor == 0
        self.assertTrue(0.1 < there.mean() < 0.9)
        sure = ~near(there, pixels)
        self.assertGreater(sure.mean(), 0.5)
        numpy.testing.assert_array_equal(got[sure], there[sure])
        self.assertLess((got != there).mean(), 0.01)
        # Each layer belongs to the actor in the actor's layer.
        position = relievo.layer(image, "position")
        height = numpy.where(got, 0, WALL)
        numpy.testing.assert_allclose(position[actor >= 0][:, 2], height[actor >= 0], atol=1e-5)
        numpy.testing.assert_allclose(position[got], places[got], atol=1e-5)
        numpy.testing.assert_array_equal(relievo.layer(image, "cell")[actor >= 0], 0)
        albedo = relievo.layer(image, "albedo")
        self.assertEqual(set(albedo[actor >= 0][:, 3]), {255})
        off = abs(albedo[actor == 1][:, :3] - 255 * numpy.array((0.2, 0.6, 0.3)))
        self.assertLess(off.max(), 1)
        # And the picture: visible parts are as opaque as with a texture without alpha.
        self.check_picture(relievo.layer(image, "color"), got)

    def check_picture(self, color, got):
        numpy.testing.assert_array_equal(color[got][:, 3], 1)
        texels = self.texels
        self.texels = numpy.ascontiguousarray(texels[..., :3])
        factor, self.factor = self.factor, 1.0
        self.material.SetAlphaCutoff(0)
        self.material.Detach(self.front)
        self.put(self.front.GetProperty().GetInterpolation() == 3)
        whole = relievo.layer(relievo.capture(self.renderer, ["color"]), "color")
        self.texels, self.factor = texels, factor
        numpy.testing.assert_allclose(color[got], whole[got], atol=0.01)
        self.assertGreater(abs(color[~got] - whole[~got]).max(), 0.05)

    def test_phong(self):
        for self.smooth in (True, False):
            for self.repeat, self.scale in ((True, (1.0, 1.0)), (True, (1.7, 0.6)),
                                            (False, (1.7, 1.3))):
                with self.subTest(smooth=self.smooth, repeat=self.repeat, scale=self.scale):
                    self.put()
                    self.check()
                    self.material.Detach(self.front)

    def test_pbr(self):
        self.put(pbr=True)
        self.check()

    def test_factor(self):
        self.factor = 0.8
        self.put()
        self.check()

    def test_colors_of_points(self):
        # One opacity for a corner each: bilinear over the square, which two triangles would not be.
        source = square(1, 0)
        source.SetResolution(64, 64)
        source.Update()
        mesh = source.GetOutput()
        places = numpy.array([mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())])
        alpha = numpy.round(255 * (0.5 + 0.5 * numpy.sin(3 * places[:, 0]) * places[:, 1]))
        colors = numpy.full((len(alpha), 4), 255, numpy.uint8)
        colors[:, 3] = alpha
        array = numpy_to_vtk(colors, deep=True)
        array.SetName("colors")
        mesh.GetPointData().SetScalars(array)
        self.front.GetMapper().SetInputDataObject(mesh)
        self.material.SetAlphaCutoff(CUTOFF)
        self.material.Attach(self.front)
        _, places = self.seen()
        inside = (abs(places[..., :2]) <= 1).all(axis=-1)
        there = inside & (0.5 + 0.5 * numpy.sin(3 * places[..., 0]) * places[..., 1] >= CUTOFF)
        got = relievo.layer(relievo.capture(self.renderer, ["actor"]), "actor") == 0
        sure = ~near(there, 1)
        numpy.testing.assert_array_equal(got[sure], there[sure])
        self.check_shadows(lambda at: (numpy.abs(at[..., :2]) <= 1).all(axis=-1) & (
            0.5 + 0.5 * numpy.sin(3 * at[..., 0]) * at[..., 1] >= CUTOFF))

    def check_shadows(self, opaque):
        frame = relievo.attach(self.renderer)
        stage = frame.GetShadowStage()
        stage.SetMapSize(1024)
        for method in (stage.METHOD_MAP, stage.METHOD_WARPED, stage.METHOD_FORWARD,
                       stage.METHOD_EXACT):
            with self.subTest(method=method):
                stage.SetMethod(method)
                image = relievo.capture(self.renderer, ["actor", "position", "shadow_0"])
                wall = relievo.layer(image, "actor") == 1
                position = relievo.layer(image, "position")
                # The sun's direction, as vtkLight has it.
                at = position - SUN * (position[..., 2:] / SUN[2])
                dark = opaque(at)
                sure = wall & ~near(dark, 2)
                self.assertGreater((dark & sure).sum(), 300)
                shadow = relievo.layer(image, "shadow_0")
                numpy.testing.assert_array_equal(shadow[sure] < 0.5, dark[sure])
        relievo.detach(self.renderer)

    def test_shadows(self):
        self.put()
        self.check_shadows(self.opaque)

    def test_soft_shadows_have_holes(self):
        self.put()
        frame = relievo.attach(self.renderer)
        stage = frame.GetShadowStage()
        stage.SetSoftSamples(8)
        stage.SetMapSize(512)
        for method in (stage.METHOD_MAP, stage.METHOD_EXACT):
            stage.SetMethod(method)
            image = relievo.capture(self.renderer, ["actor", "position", "shadow_0"])
            wall = relievo.layer(image, "actor") == 1
            position = relievo.layer(image, "position")
            at = position - SUN * (position[..., 2:] / SUN[2])
            dark = self.opaque(at)
            sure = wall & ~near(dark, 6)
            shadow = relievo.layer(image, "shadow_0")
            numpy.testing.assert_array_equal(shadow[sure] < 0.5, dark[sure])
        relievo.detach(self.renderer)

    def test_relief(self):
        """A flat ground at half the depth: pixels show the ray's hit with that plane."""
        heights = numpy.full((16, 16), 0.5, numpy.float32)
        self.material.SetHeightMap(relievo.to_image(heights))
        self.material.SetHeightRange(0, 1)
        self.material.SetHeightScale(0.3)
        self.put()
        origins, directions = scenes.rays(self.renderer.GetActiveCamera(), COLUMNS, ROWS)
        entry = origins - directions * (origins[..., 2:] / directions[..., 2:])
        ground = origins + directions * ((-0.15 - origins[..., 2:]) / directions[..., 2:])
        inside = (abs(entry[..., :2]) <= 1).all(axis=-1)
        alpha = self.texels[::-1, :, 3].astype(float) / 255
        there = inside & (sampled(alpha, (ground[..., :2] + 1) / 2, True, True) >= CUTOFF)
        got = relievo.layer(relievo.capture(self.renderer, ["actor"]), "actor") == 0
        sure = ~near(there, 1)
        numpy.testing.assert_array_equal(got[sure], there[sure])

    def test_off_is_as_before(self):
        texture = self.texture()
        self.front.SetTexture(texture)
        before = relievo.layer(relievo.capture(self.renderer, ["color"]), "color").copy()
        self.material.SetAlphaCutoff(CUTOFF)
        self.material.Attach(self.front)
        self.assertTrue(self.front.GetForceOpaque())
        cut = relievo.layer(relievo.capture(self.renderer, ["color"]), "color").copy()
        self.assertGreater(abs(cut - before).max(), 0.1)
        self.material.SetAlphaCutoff(0)
        self.assertFalse(self.front.GetForceOpaque())
        after = relievo.layer(relievo.capture(self.renderer, ["color"]), "color")
        numpy.testing.assert_array_equal(after, before)

    def test_changes_reach_the_shadows(self):
        self.put()
        frame = relievo.attach(self.renderer)
        frame.ShadowsOn()

        def darkness():
            image = relievo.capture(self.renderer, ["shadow_0"])
            return (relievo.layer(image, "shadow_0") < 0.5).sum()
        all_of_it = darkness()
        self.material.SetAlphaCutoff(0.8)
        less = darkness()
        self.front.GetProperty().SetOpacity(0.1)
        self.assertLess(less, 0.9 * all_of_it)
        self.assertEqual(darkness(), 0)
        relievo.detach(self.renderer)


if __name__ == "__main__":
    unittest.main(verbosity=2)
