# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shadows in every way ParaView draws a picture: screenshots of any size, stereo, views side by
side, animations, interaction with coarse data. Rays say where they must be."""

import judge
import numpy
import pv
import stage
from paraview import simple

NAME = str(pv.OUTPUT / "picture.png")


def screenshot(what, **more):
    """The file written by SaveScreenshot."""
    simple.SaveScreenshot(NAME, what, **more)
    return pv.read(NAME)


class Pictures(judge.StageTest):
    def test_screenshots_larger_than_the_view_and_of_another_shape(self):
        for size in ((1200, 780), (410, 600)):

            def draw(size=size):
                return screenshot(self.view, ImageResolution=size)

            truth = self.scene.verdicts(size=size)
            judge.shadows(self, judge.sun(self.scene, draw), truth, f"screenshot {size}")
        self.assertEqual(tuple(self.view.ViewSize), stage.SIZE)

    def test_transparent_background(self):
        def alpha():
            simple.SaveScreenshot(NAME, self.view, TransparentBackground=1)
            return pv.read(NAME, channels=4)[..., 3:]

        own = alpha()
        self.assertEqual(own.min(), 0)
        self.scene.sun()
        self.same(alpha(), own, "opacity")

    def test_ambient_occlusion(self):
        """A ground before an endless wall: the picture's light times the share of the sky."""
        pv.clear()
        view = simple.CreateView("RenderView", ViewSize=[200, 200])
        view.OrientationAxesVisibility = view.UseFXAA = 0
        simple.Show(simple.Plane(Origin=[0, -99, 0], Point1=[9, -99, 0], Point2=[0, 99, 0]), view)
        simple.Show(simple.Plane(Origin=[0, -99, 0], Point1=[0, 99, 0], Point2=[0, -99, 2]), view)
        view.CameraPosition, view.CameraFocalPoint = [2, 0, 9], [2, 0, 0]
        view.CameraViewUp = [0, 1, 0]
        view.CameraParallelProjection, view.CameraParallelScale = 1, 1

        def light():
            code = numpy.mean(pv.picture(view)[..., 0] / 255, axis=0)
            return numpy.where(code < 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)

        own, first = pv.picture(view), light()
        view.RelievoStageAmbient = 1
        x = 1 + (numpy.arange(200) + 0.5) / 100
        share = (1 + x / numpy.sqrt(x**2 + 2**2)) / 2  # of the sky that the wall leaves
        numpy.testing.assert_allclose(light() / first, share, atol=0.02)
        view.RelievoStageAmbientStrength = 0.5
        numpy.testing.assert_allclose(light() / first, (1 + share) / 2, atol=0.02)
        view.RelievoStageAmbient = 0
        self.same(pv.picture(view), own, "off again")
        view.UpdatePropertyInformation()
        self.assertEqual(view.GetProperty("RelievoFrameReport").GetElement(0), "")

    def test_stereo_has_each_eyes_shadows(self):
        self.view.StereoRender = 1
        self.view.StereoType = "Red-Blue"
        self.scene.render()  # ParaView's first stereo frame is not yet that of both eyes
        pictures = judge.sun(self.scene)
        position = numpy.array(self.view.CameraPosition)
        focus = numpy.array(self.view.CameraFocalPoint)
        gaze = position - focus
        up = numpy.array([0.0, 0.0, 1.0])
        up = up - gaze * (up @ gaze) / (gaze @ gaze)
        side = numpy.cross(up / numpy.linalg.norm(up), gaze)
        for channel, turn in ((0, -1.0), (2, 1.0)):
            angle = numpy.radians(turn * self.view.EyeAngle / 2)
            eye = focus + gaze * numpy.cos(angle) + side * numpy.sin(angle)
            self.scene.look(tuple(eye))
            truth = self.scene.verdicts()
            each = [numpy.repeat(p[..., channel : channel + 1], 3, axis=2) for p in pictures]
            judge.shadows(self, each, truth, "left eye" if turn < 0 else "right eye")

    def test_views_side_by_side_have_their_own(self):
        layout = simple.CreateLayout("two")
        other = simple.CreateView("RenderView")
        layout.AssignView(0, self.view)
        layout.SplitViewHorizontal(self.view)
        layout.AssignView(2, other)
        layout.SetSize(800, 260)
        simple.Show(self.scene.ground, other)
        simple.Show(self.scene.ball, other)
        other.CameraPosition, other.CameraFocalPoint = [4, -5, 6], [0, 0, 0]

        def draw():
            return screenshot(layout, ImageResolution=(800, 260))

        draw()  # ParaView's first picture of a layout differs from the next ones
        own = draw()
        self.scene.sun()
        found = draw()
        self.same(found[:, 410:], own[:, 410:], "the other view")
        self.differ(found[:, :390], own[:, :390], "the view with shadows")
        other.RelievoShadows, other.RelievoSun = 1, 1
        self.differ(draw()[:, 410:], own[:, 410:], "the other view's own shadows")
        self.same(draw()[:, :390], found[:, :390], "the first view")
        self.scene.sun(on=False, shadows=False)
        other.RelievoShadows, other.RelievoSun = 0, 0
        self.same(draw(), own, "off again")

    def test_animation(self):
        track = simple.GetAnimationTrack("Center", index=2, proxy=self.scene.ball)
        track.KeyFrames = [
            simple.CompositeKeyFrame(KeyTime=0.0, KeyValues=[1.1]),
            simple.CompositeKeyFrame(KeyTime=1.0, KeyValues=[2.3]),
        ]
        simple.GetAnimationScene().NumberOfFrames = 4

        def draw():
            simple.SaveAnimation(str(pv.OUTPUT / "frame.png"), self.view, FrameWindow=[0, 3])
            return [pv.read(pv.OUTPUT / f"frame.{frame:04}.png") for frame in range(4)]

        pictures = judge.sun(self.scene, draw)
        for frame in range(4):
            self.scene.center = numpy.array([0.0, 0.0, 1.1 + 0.4 * frame])
            truth = self.scene.verdicts()
            judge.shadows(self, [each[frame] for each in pictures], truth, f"frame {frame}")

    def test_orbit_and_back(self):
        self.scene.sun()
        first = pv.picture(self.view)
        for position in ((8.0, 1.0, 3.0), (2.0, 8.0, 6.0), (0.5, 0.0, 12.0)):
            self.scene.look(position)
            truth = self.scene.verdicts()
            judge.shadows(self, judge.sun(self.scene), truth, f"from {position}")
        self.scene.look()
        # A map that has seen the camera move is fitted more widely: edges may step by a texel.
        self.near(pv.picture(self.view), first, "back again", level=1, share=2e-3)

    def test_interaction_draws_coarse_data_with_its_shadows(self):
        self.scene.sun()
        self.view.LODThreshold = 0.0
        self.view.LODResolution = 0.2
        truth = self.scene.verdicts(margin=8)
        for method in ("Map", "Exact"):
            self.view.RelievoShadowMethod = method
            still = pv.picture(self.view)
            self.view.UseInteractiveRenderingForScreenshots = 1
            pictures = judge.sun(self.scene)
            self.differ(pictures[0], still, f"coarse data, {method}")
            judge.shadows(self, pictures, truth, f"interaction, {method}", least=0.01)
            self.view.UseInteractiveRenderingForScreenshots = 0
            self.same(pv.picture(self.view), still, f"after interaction, {method}")

    def test_legend_of_a_layer(self):
        """The legend replaces the data's scalar bar in the picture, also on bright backgrounds."""
        shown = self.scene.ball_shown
        simple.ColorBy(shown, ("POINTS", "Normals"))
        shown.SetScalarBarVisibility(self.view, True)
        own = pv.picture(self.view)
        shown.SetScalarBarVisibility(self.view, False)
        without = pv.picture(self.view)
        bar = pv.unlike(own, without)
        self.assertGreater(bar.sum(), 500)
        self.view.RelievoDisplayLayer = "depth"
        self.view.RelievoDisplayLegend = 0
        bare = pv.picture(self.view)
        self.view.RelievoDisplayLegend = 1
        legend = pv.picture(self.view)
        self.assertGreater(pv.unlike(legend, bare).mean(), 0.01)
        self.assertLess(pv.unlike(legend, bare).mean(), 0.15)
        shown.SetScalarBarVisibility(self.view, True)
        self.same(pv.picture(self.view), legend, "with a scalar bar of the data")
        self.view.Background = [1.0, 1.0, 1.0]
        bright = pv.picture(self.view)[pv.unlike(legend, bare)]
        self.assertLess(bright.min(axis=1).min(), 100)
        self.assertGreater(bright.min(axis=1).max(), 200)
        self.view.Background = [0.0, 0.0, 0.0]
        self.view.RelievoDisplayLayer = "None"
        self.same(pv.picture(self.view), own, "without the layer")

    def test_selected_cells_are_the_same(self):
        def ids():
            simple.ClearSelection()
            simple.SelectSurfaceCells(Rectangle=[120, 100, 150, 130], View=self.view)
            return list(self.scene.ball.GetSelectionInput(0).Input[0].IDs)

        own = ids()
        self.assertGreater(len(own), 100)
        self.scene.sun()
        pv.picture(self.view)
        self.assertEqual(ids(), own)
        # The buffers that were bound when cells were selected are gone: OpenGL would tell.
        self.scene.ball.ThetaResolution = 100
        self.view.RelievoDisplayLayer = "normal"
        pv.picture(self.view)


if __name__ == "__main__":
    pv.main()
