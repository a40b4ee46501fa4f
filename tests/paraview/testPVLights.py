# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which of a view's lights cast, and where: the sun, lights that users add, the light kit."""

import datetime

import judge
import numpy
import pv
import stage
from paraview import simple


def almanac(days, latitude, longitude):
    """Azimuth and elevation of the sun, of the low-precision formulas of the Astronomical Almanac,
    section C: right to 0.01 degrees. days: from 2000-01-01 12:00 UT."""
    mean = 280.460 + 0.9856474 * days
    anomaly = numpy.radians(357.528 + 0.9856003 * days)
    ecliptic = numpy.radians(mean + 1.915 * numpy.sin(anomaly) + 0.020 * numpy.sin(2 * anomaly))
    tilt = numpy.radians(23.439 - 0.0000004 * days)
    right = numpy.arctan2(numpy.cos(tilt) * numpy.sin(ecliptic), numpy.cos(ecliptic))
    high = numpy.arcsin(numpy.sin(tilt) * numpy.sin(ecliptic))
    # Greenwich mean sidereal time, in degrees.
    sidereal = 280.46062 + 360.98564737 * days
    angle = numpy.radians(sidereal + longitude) - right
    place = numpy.radians(latitude)
    east = -numpy.cos(high) * numpy.sin(angle)
    level = numpy.cos(high) * numpy.cos(angle)
    north = numpy.sin(high) * numpy.cos(place) - level * numpy.sin(place)
    up = numpy.sin(high) * numpy.sin(place) + level * numpy.cos(place)
    return numpy.degrees(numpy.arctan2(east, north)) % 360, numpy.degrees(numpy.arcsin(up))


def unlike_color(picture, color):
    """Where a picture has another colour, by more than a grey level."""
    return (numpy.abs(picture.astype(int) - color) > 1).any(axis=2)


class Lights(judge.StageTest):
    def add(self, **values):
        """A light that a user adds, alone in the view."""
        self.view.UseLight = 0
        light = simple.AddLight(self.view)
        light.Coords = "Scene"
        light.Intensity = 0.6
        for name, value in values.items():
            setattr(light, name, value)
        return light

    def states(self, light):
        """The lit, the dark and the found picture of that light."""
        self.view.RelievoShadows = 0
        lit = pv.picture(self.view)
        intensity = light.Intensity
        light.Intensity = 0.0
        dark = pv.picture(self.view)
        light.Intensity = intensity
        self.view.RelievoShadows = 1
        return lit, dark, pv.picture(self.view)

    def test_the_sun_with_each_axis_up(self):
        for axis, azimuth in (("X", 20.0), ("Y", 200.0)):
            east, north, up = stage.sun(azimuth, 20.0)
            # North is z with x up, -z with y up.
            towards = (up, east, north) if axis == "X" else (east, up, -north)
            self.scene.sun()
            self.view.RelievoSunUpAxis = axis
            self.view.RelievoSunAzimuth = azimuth
            self.view.RelievoSunElevation = 20.0
            pictures = []
            for shadows, intensity in ((0, 1.0), (0, 0.0), (1, 1.0)):
                self.view.RelievoShadows = shadows
                self.view.RelievoSunIntensity = intensity
                pictures.append(pv.picture(self.view))
            truth = self.scene.verdicts(light=numpy.array(towards))
            judge.shadows(self, pictures, truth, axis + " up", least=0.015)

    def left(self):
        """Samples of soft shadows that the last picture lacks."""
        self.view.UpdatePropertyInformation()
        return self.view.GetProperty("RelievoSamplesLeft").GetElement(0)

    def test_soft_shadows_refine_and_are_saved_complete(self):
        self.scene.sun()
        simple.Render(self.view)
        hard = pv.picture(self.view)
        self.assertEqual(self.left(), 0)
        self.view.RelievoShadowSunAngle = 8.0
        self.view.RelievoShadowSoftSamples = 4
        for left in (3, 2, 1, 0, 0):
            simple.Render(self.view)
            self.assertEqual(self.left(), left)
        soft = pv.picture(self.view)
        between = numpy.any(numpy.abs(soft.astype(int) - hard) > 8, axis=-1)
        self.assertTrue(between.sum() > 100, f"{between.sum()} pixels are softer")
        # A change restarts accumulation; saved pictures do not show it.
        self.view.RelievoShadowStrength = 0.9
        simple.Render(self.view)
        self.view.RelievoShadowStrength = 1.0
        self.same(pv.picture(self.view), soft, "a saved picture after a change")
        self.view.RelievoShadowSoftSamples = 0
        self.same(pv.picture(self.view), hard, "hard again")

    def test_glass_colours_the_light(self):
        self.scene.ball_shown.Opacity = 0.4
        self.scene.ball_shown.DiffuseColor = [1.0, 0.5, 0.0]
        self.view.RelievoSunFill = 0.0
        pictures = {}
        for name, shadows, intensity in (("lit", 0, 0.4), ("dark", 0, 0.0), ("on", 1, 0.4)):
            self.scene.sun(shadows=shadows, intensity=intensity)
            pictures[name] = pv.picture(self.view).astype(float)
        self.view.RelievoShadowColored = 1
        self.same(pv.picture(self.view), pictures["on"], "maps store no colours")
        self.view.RelievoShadowMethod = "Exact"
        found = pv.picture(self.view).astype(float)
        ball = numpy.isfinite(self.scene.sphere_hit(*self.scene.rays(stage.SIZE)))
        whole = pictures["lit"] - pictures["dark"]
        dark = (self.scene.verdicts() == stage.DARK) & ~ball & (pictures["lit"].max(axis=2) < 255)
        self.assertGreater(dark.sum(), 300)
        # Without it, translucent surfaces cast nothing.
        numpy.testing.assert_array_equal(pictures["on"][dark], pictures["lit"][dark])
        passed = pictures["dark"] + 0.36 * numpy.array([1.0, 0.25, 0.0]) * whole  # two walls
        self.assertLess(abs(found - passed)[dark].max(), 3.0)

    def test_exact_shadows(self):
        self.view.RelievoShadowMethod = "Exact"
        for position in ((8.0, 1.0, 3.0), (2.0, 8.0, 6.0)):
            self.scene.look(position)
            truth = self.scene.verdicts()
            judge.shadows(self, judge.sun(self.scene), truth, f"exact from {position}")

    def test_the_sun_by_date_and_place(self):
        self.scene.sun()
        view = self.view
        view.RelievoSunBy = "Date and place"
        view.RelievoSunDate = [2025, 10, 4]
        view.RelievoSunLatitude, view.RelievoSunLongitude = -33.87, 151.21
        view.RelievoSunTimeZone, view.RelievoSunTime = 10.0, 15.25
        view.RelievoSunNorth = 65.0
        passed = datetime.datetime(2025, 10, 4, 5, 15) - datetime.datetime(2000, 1, 1, 12)
        azimuth, elevation = almanac(passed.total_seconds() / 86400, -33.87, 151.21)
        self.assertTrue(20 < elevation < 60 and 270 < azimuth < 340, "a southern afternoon")
        pictures = []
        for shadows, intensity in ((0, 1.0), (0, 0.0), (1, 1.0)):
            view.RelievoShadows = shadows
            view.RelievoSunIntensity = intensity
            pictures.append(pv.picture(view))
        view.UpdatePropertyInformation()
        angles = view.GetProperty("RelievoSunAngles")
        self.assertAlmostEqual(angles.GetElement(0), azimuth, delta=0.03)
        self.assertAlmostEqual(angles.GetElement(1), elevation, delta=0.03)
        truth = self.scene.verdicts(light=stage.sun(azimuth + 65.0, elevation))
        judge.shadows(self, pictures, truth, "by date and place")
        view.RelievoSunTime = 21.0
        night = pv.picture(view)
        view.RelievoSunIntensity = 0.0
        self.same(pv.picture(view), night, "night: no light of the sun")
        view.RelievoSunBy = "Angles"
        view.RelievoSunIntensity = 1.0
        self.differ(pv.picture(view), night, "by angles again")

    def test_the_fill_shows_form_where_the_sun_does_not_reach(self):
        # The sun behind the ball: the side visible to the camera is in the shade.
        self.view.RelievoSunFill = 0.0
        self.scene.sun(intensity=0.7)
        self.view.RelievoSunAzimuth, self.view.RelievoSunElevation = 325.0, 30.0
        origin, direction = self.scene.rays(stage.SIZE)
        ball = self.scene.sphere_hit(origin, direction)
        place = origin + numpy.where(numpy.isfinite(ball), ball, 0)[..., None] * direction
        facing = ((place - stage.CENTER) * stage.sun(325.0, 30.0)).sum(axis=2) / stage.RADIUS
        shade = numpy.isfinite(ball) & (facing < -0.2)
        self.assertGreater(shade.sum(), 1000)
        without = pv.picture(self.view).max(axis=2)[shade]
        self.view.RelievoSunFill = 0.3
        filled = pv.picture(self.view).max(axis=2)[shade]
        self.view.RelievoSun = self.view.RelievoShadows = 0
        kit = pv.picture(self.view).max(axis=2)[shade]
        # Nearly black without it: under a third of the light kit's brightness. With it, more than
        # half, and the light kit's contrast relative to brightness.
        self.assertLess(without.mean(), kit.mean() / 3)
        self.assertGreater(filled.mean(), kit.mean() / 2)
        self.assertGreater(filled.std(), 1.5 * without.std())
        self.assertGreater(filled.std() / filled.mean(), 0.8 * kit.std() / kit.mean())

    def test_layers_have_the_lights_names(self):
        view = self.view
        lamp = self.add(Type="Positional", Position=[-1.5, -1.5, 4.5], FocalPoint=[0.0, 0.0, 0.4])
        self.scene.sun()
        pv.picture(view)
        view.UpdatePropertyInformation()
        layers = view.GetProperty("RelievoShadowLayers").GetElement(0).split(",")
        self.assertEqual(len(layers), 2, layers)
        self.assertIn("shadow_sun", layers)
        (added,) = set(layers) - {"shadow_sun"}
        manager = lamp.SMProxy.GetSessionProxyManager()
        name = manager.GetProxyName("additional_lights", lamp.SMProxy)
        self.assertEqual(added, "shadow_" + name.lower())
        shown = view.SMProxy.GetProperty("RelievoDisplayLayer")
        offered = shown.FindDomain("vtkSMStringListDomain")
        names = [offered.GetString(i) for i in range(offered.GetNumberOfStrings())]
        self.assertEqual(names[-2:], layers, "and no light that casts nothing")
        view.RelievoDisplayLegend = 0  # every pixel is judged
        for layer, truth in (("shadow_sun", self.scene.verdicts()),
                             (added, self.scene.verdicts(lamp=[-1.5, -1.5, 4.5], cone=30.0))):
            view.RelievoDisplayLayer = layer
            shown = pv.picture(view)[..., 0]
            self.assertGreater((shown[truth == stage.LIT] > 250).mean(), 0.999, layer)
            self.assertTrue((truth == stage.DARK).mean() > 0.01)
            blocked = shown < 5
            self.assertGreater(blocked.mean(), 0.01, layer)
            self.assertLess(blocked[truth == stage.LIT].mean(), 1e-3, layer)
        view.RelievoDisplayLayer = "None"
        view.RelievoSun = 0
        pv.picture(view)
        names = [offered.GetString(i) for i in range(offered.GetNumberOfStrings())]
        self.assertEqual(names[-1:], [added])
        self.assertNotIn("shadow_sun", names)

    def test_what_a_light_reaches_is_shown_in_grey_before_the_background(self):
        self.scene.sun()
        self.view.Background = [0.2, 0.4, 0.6]
        self.view.UseColorPaletteForBackground = 0
        self.view.RelievoDisplayLegend = 0  # every pixel is judged
        verdicts = self.scene.verdicts()
        self.assertGreater(min((verdicts == each).sum() for each in (0, 1, 2)), 2000)
        for layer in ("shadow_sun", "shadow_0"):
            self.view.RelievoDisplayLayer = layer
            shown = pv.picture(self.view)
            self.assertFalse(unlike_color(shown, (51, 102, 153))[verdicts == stage.NONE].any())
        self.view.RelievoDisplayLayer = "shadow_sun"
        shown = pv.picture(self.view)
        # Surfaces turned away are not blocked by others: their darkness is not only the shadow's.
        for verdict, level in ((stage.DARK, 0), (stage.LIT, 255)):
            there = verdicts == verdict
            mismatches = unlike_color(shown, (level, level, level))[there]
            self.assertLess(mismatches.mean(), 0.01, f"where the sun's light is {level}")

    def check_not_in_its_own_shadow(self, source, **look):
        """Without anything above it, the surface is lit by the sun and casts."""
        self.view.RelievoShadows = 0
        bare = pv.picture(self.view)
        shown = simple.Show(source, self.view)
        for name, value in look.items():
            setattr(shown, name, value)
        lit = pv.picture(self.view)
        there = pv.unlike(bare, lit, 1)
        self.assertGreater(there.sum(), 100)
        for method in ("Map", "Warped", "Forward", "Exact"):
            self.view.RelievoShadows, self.view.RelievoShadowMethod = 1, method
            picture = pv.picture(self.view)
            if method == "Map":  # in others its shadow may be narrower than a pixel
                self.assertTrue(pv.unlike(picture, lit, 20)[~there].any(), "its shadow")
            dark = pv.unlike(picture, lit, 8) & there
            self.assertLess(dark.sum(), 0.02 * there.sum(), method)
        simple.Hide(source, self.view)

    def test_tubes_and_spheres_are_not_in_their_own_shadow(self):
        self.scene.ball_shown.Visibility = 0
        self.scene.sun(shadows=False)
        self.check_not_in_its_own_shadow(
            simple.Line(Point1=[-1, 0, 0.8], Point2=[1, 0, 0.8]), LineWidth=8, RenderLinesAsTubes=1)
        self.check_not_in_its_own_shadow(
            simple.PointSource(Center=[0, 0, 0.8], Radius=0, NumberOfPoints=1),
            Representation="Points", PointSize=14, RenderPointsAsSpheres=1)

    def test_the_lights_that_cast_are_those_of_the_settings(self):
        def layers():
            self.view.UpdatePropertyInformation()
            return self.view.GetProperty("RelievoShadowLayers").GetElement(0)

        # No frame of Relievo is drawn between.
        self.view.RelievoLightKitCasts = "Nothing"
        self.assertEqual(layers(), "")
        self.view.RelievoSun = 1
        self.assertEqual(layers(), "shadow_sun")
        self.view.RelievoLightKitCasts = "Key light"
        self.assertEqual(layers(), "shadow_key_light,shadow_sun")
        self.view.RelievoSun = 0
        self.assertEqual(layers(), "shadow_key_light")

    def test_the_sun_stays_and_the_kit_is_given_back(self):
        before = self.view.KeyLightIntensity
        own = pv.picture(self.view)
        self.scene.sun()
        self.view.RelievoSunColor = [1.0, 0.2, 0.2]
        red = pv.picture(self.view)
        seen = (self.scene.verdicts() == stage.LIT) & (red[..., 0] > 100)
        self.assertGreater(seen.mean(), 0.1)
        self.assertTrue((red[seen][:, 0] > red[seen][:, 2]).all())
        self.view.KeyLightIntensity = before / 2
        pv.picture(self.view)
        self.view.KeyLightIntensity = before
        self.scene.sun(on=False, shadows=False)
        self.same(pv.picture(self.view), own, "the sun taken away")
        self.assertEqual(self.view.KeyLightIntensity, before)

    def test_a_night_has_the_fill_alone(self):
        """By date and place; the light kit stays as dim as by day. A sun that an elevation puts
        below lights from beneath."""
        view = self.view
        kit = view.KeyLightIntensity
        own = pv.picture(view)
        self.scene.sun(shadows=False)
        view.RelievoSunBy = "Date and place"
        view.RelievoSunTime = 12
        noon = pv.picture(view)
        self.differ(noon, own, "noon")
        view.RelievoSunTime = 1
        night = pv.picture(view)
        self.assertLess(night.mean(), 0.7 * noon.mean())
        view.RelievoSunIntensity = 0.0
        self.same(pv.picture(view), night, "no light of the sun")
        view.RelievoSunIntensity = 1.0
        view.KeyLightIntensity = view.RelievoSunFill = 0.0
        black = pv.picture(view)
        ball = numpy.isfinite(self.scene.sphere_hit(*self.scene.rays(stage.SIZE)))
        self.assertEqual(black[ball].max(), 0, "with neither fill nor kit")
        view.RelievoShadows = 1
        self.same(pv.picture(view), black, "and no shadow of it")
        view.UpdatePropertyInformation()
        self.assertNotIn("shadow_sun", view.GetProperty("RelievoShadowLayers").GetElement(0))
        view.RelievoShadows = 0
        view.RelievoSunBy = "Angles"
        view.RelievoSunElevation = -30.0
        self.assertGreater(pv.picture(view)[ball].max(), 30, "from beneath")
        view.KeyLightIntensity = kit
        view.RelievoSun = 0
        self.same(pv.picture(view), own, "the sun taken away")

    def test_a_directional_light(self):
        towards = stage.sun(100.0, 50.0)
        light = self.add(Type="Directional", Position=10 * towards, FocalPoint=[0.0, 0.0, 0.0])
        truth = self.scene.verdicts(light=towards)
        judge.shadows(self, self.states(light), truth, "directional", least=0.01)

    def test_spots_and_point_lights(self):
        place = [-1.5, -1.5, 4.5]
        for cone in (20.0, 60.0, 90.0):
            light = self.add(Type="Positional", Position=place, FocalPoint=[0.0, 0.0, 0.4])
            light.ConeAngle = cone
            truth = self.scene.verdicts(lamp=place, cone=cone)
            judge.shadows(self, self.states(light), truth, f"cone {cone}")
            simple.RemoveLight(light)

    def test_strength_of_one_light_and_of_all(self):
        towards = stage.sun()
        light = self.add(Type="Directional", Position=10 * towards, FocalPoint=[0.0, 0.0, 0.0])
        lit, dark, found = self.states(light)
        truth = self.scene.verdicts()
        for owner in (light, self.view):
            owner.RelievoShadowStrength = 0.0
            self.same(pv.picture(self.view), lit, "no strength")
            owner.RelievoShadowStrength = 0.25
            quarter = pv.picture(self.view).astype(int)
            shadow = (truth == stage.DARK) & pv.unlike(lit, dark, 40)
            self.assertGreater(shadow.mean(), 0.02)
            expected = 0.75 * lit[shadow] + 0.25 * dark[shadow]
            self.assertLess(numpy.abs(quarter[shadow] - expected).max(), 2.0)
            owner.RelievoShadowStrength = 1.0
            self.same(pv.picture(self.view), found, "full strength")

    def test_a_light_that_is_off_or_at_the_eye_casts_nothing(self):
        own = self.add(Coords="Headlight")
        lit, _, found = self.states(own)
        self.same(found, lit, "headlight")
        own.Coords = "Ambient"
        lit, _, found = self.states(own)
        self.same(found, lit, "ambient light")
        off = self.add(Type="Directional", Position=[5.0, 0.0, 5.0], Enable=0)
        self.same(pv.picture(self.view), lit, "a light that is off")
        off.Enable = 1
        self.differ(pv.picture(self.view), lit, "a light that is on")

    def test_the_kits_key_light(self):
        origin, direction = self.scene.rays(stage.SIZE)
        eye = numpy.array(self.view.CameraPosition)
        back = eye - numpy.array(self.view.CameraFocalPoint)
        back /= numpy.linalg.norm(back)
        right = numpy.cross([0.0, 0.0, 1.0], back)
        right /= numpy.linalg.norm(right)
        up = numpy.cross(back, right)
        azimuth, elevation = numpy.radians(
            [self.view.KeyLightAzimuth, self.view.KeyLightElevation]
        )
        level = numpy.cos(elevation)
        towards = (
            right * level * numpy.sin(azimuth)
            + up * numpy.sin(elevation)
            + back * level * numpy.cos(azimuth)
        )
        truth = self.scene.verdicts(light=towards)
        lit = pv.picture(self.view)
        self.view.RelievoShadows = 1
        found = pv.picture(self.view)
        sunny = truth == stage.LIT
        kept = numpy.where(sunny[..., None], found, lit)
        self.near(kept, lit, "what the key light reaches", share=3e-4)
        ground = (truth == stage.DARK) & (lit.min(axis=2) > 150)
        self.assertGreater(ground.mean(), 0.01)
        self.assertTrue(pv.unlike(found, lit, 8)[ground].all(), "what it does not reach")
        self.view.RelievoLightKitCasts = "Nothing"
        self.same(pv.picture(self.view), lit, "a kit that casts nothing")
        self.view.RelievoLightKitCasts = "All lights"
        self.differ(pv.picture(self.view), found, "all lights of the kit", share=0.005)


if __name__ == "__main__":
    pv.main()
