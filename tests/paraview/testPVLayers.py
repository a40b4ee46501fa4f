# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The source Relievo Layers gives the view's contents as numbers, at the requested times.

With words: `restore STATE FILE` loads a state and stores its layers; `provoke` makes requests
that must be refused.
"""

import sys

import judge
import layers
import numpy
import pv
import srgb
import stage
from paraview import simple, smstate

# Half a step of the tessellated sphere: its triangles lie inside of it.
FACET = stage.RADIUS * (1 - numpy.cos(numpy.pi / 128)) * 1.5


def distance(first, second):
    return numpy.linalg.norm(first - second, axis=-1)


class Layers(judge.StageTest):
    def check_values(self, source):
        found, true = layers.arrays(source), layers.truth(self.scene)
        sure = true["sure"]
        ground = sure & (true["kind"] == layers.GROUND)
        ball = sure & (true["kind"] == layers.BALL)
        none = sure & (true["kind"] == layers.NONE)
        self.assertGreater(min(ground.sum(), ball.sum(), none.sum()), 1500)
        for name in ("depth", "range"):
            self.assertEqual(found[name].dtype, numpy.float32)
            with numpy.errstate(invalid="ignore"):
                error = numpy.abs(found[name].astype(float) - true[name])
            self.assertLess(error[ground].max(), 2e-6, name)
            self.assertLess(error[ball].max(), 6 * FACET, name)
            self.assertTrue(numpy.isposinf(found[name][none]).all(), name)
        self.assertEqual(found["position"].dtype, numpy.float64)
        self.assertLess(distance(found["position"], true["position"])[ground].max(), 2e-6)
        radius = distance(found["position"], self.scene.center)[ball]
        self.assertLess(numpy.abs(radius - stage.RADIUS).max(), FACET)
        for name, angle in (("normal", 0.1), ("geometric_normal", 2.0)):
            # A float's rounding of a normal, and of the differences that make the flat one.
            limit = 1e-5 if name == "normal" else 2e-4
            self.assertLess(distance(found[name], true["normal"])[ground].max(), limit, name)
            error = numpy.degrees(distance(found[name], true["normal"])[ball])
            self.assertLess(error.max(), angle, name)
            self.assertFalse(found[name][none].any(), name)
        for name in ("actor", "block", "cell"):
            self.assertEqual(found[name].dtype, numpy.int32)
            self.assertTrue((found[name][none] == -1).all(), name)
        self.assertEqual(len(set(found["actor"][ground])), 1)
        self.assertEqual(len(set(found["actor"][ball])), 1)
        self.assertNotEqual(found["actor"][ground][0], found["actor"][ball][0])
        self.assertEqual(set(found["cell"][ground]), {0})
        self.assertGreater(len(set(found["cell"][ball])), 1000)
        self.assertTrue((found["albedo"][ground] == found["albedo"][ground][0]).all())

    def test_values_are_those_of_the_scene(self):
        names = "depth range normal geometric_normal position albedo actor block cell".split()
        source = simple.RelievoLayers(View=self.view, Layers=names)
        self.check_values(source)
        self.assertEqual(list(layers.arrays(source)), names, "in the order asked for")
        self.view.CameraParallelProjection = 1
        self.view.CameraParallelScale = 2.5
        source.SMProxy.InvokeCommand("GrabAgain")
        self.check_values(source)

    def test_points_lie_where_the_scene_is(self):
        source = simple.RelievoLayers(View=self.view)
        points = simple.DepthToPoints(Input=source)
        points.UpdatePipeline()
        cloud = simple.FetchData(points)[0]
        depth = layers.arrays(source)["depth"]
        self.assertEqual(cloud.GetNumberOfPoints(), numpy.isfinite(depth).sum())
        self.assertEqual(cloud.GetNumberOfVerts(), cloud.GetNumberOfPoints())
        places = layers.vtk_to_numpy(cloud.GetPoints().GetData())
        self.assertEqual(places.dtype, numpy.float64)
        height = numpy.abs(places[:, 2])
        from_ball = numpy.abs(distance(places, self.scene.center) - stage.RADIUS)
        self.assertLess(height[from_ball > FACET].max(), 3e-6, "on the ground or on the ball")
        self.assertGreater((from_ball < FACET).sum(), 1500)
        self.assertTrue(cloud.GetPointData().HasArray("normal"))
        points.Stride, points.KeepArrays = 10, 0
        points.UpdatePipeline()
        cloud = simple.FetchData(points)[0]
        self.assertEqual(
            cloud.GetNumberOfPoints(), numpy.isfinite(depth[::-1][::10, ::10]).sum()
        )
        self.assertEqual(cloud.GetPointData().GetNumberOfArrays(), 0)

    def test_arrays_shadows_and_colours_by_name(self):
        self.scene.sun()
        names = ["Normals", "normal", "shadow_5", "color"]
        found = layers.arrays(simple.RelievoLayers(View=self.view, Layers=names))
        self.assertEqual(sorted(found), sorted(names))
        true = layers.truth(self.scene)
        ball = true["sure"] & (true["kind"] == layers.BALL)
        self.assertLess(distance(found["Normals"], found["normal"])[ball].max(), 2e-3)
        none = true["kind"] == layers.NONE
        self.assertTrue(numpy.isnan(found["Normals"][none & true["sure"]]).all())
        # The sun is the view's last light, after the kit's five.
        verdicts = self.scene.verdicts()
        sure = (verdicts == stage.LIT) | (verdicts == stage.DARK)
        mismatches = (found["shadow_5"] > 0.5) != (verdicts == stage.LIT)
        facing = true["normal"] @ stage.sun() > 0.05
        self.assertLess((mismatches & sure & facing).sum() / (sure & facing).sum(), 2e-3)
        display = srgb.encoded(found["color"][..., :3].astype(float))
        self.near(numpy.rint(display * 255), pv.picture(self.view), "colour", level=0, share=0.0)

    def test_alpha(self):
        """Of both walls of a translucent ball, however the view sorts them."""
        ball = layers.truth(self.scene)
        ball = ball["sure"] & (ball["kind"] == layers.BALL)
        simple.Hide(self.scene.ground, self.view)
        simple.GetDisplayProperties(self.scene.ball, self.view).Opacity = 0.5
        source = simple.RelievoLayers(View=self.view, Layers=["color", "range"])
        for peeling in (1, 0):
            self.view.DepthPeeling = peeling
            source.SMProxy.InvokeCommand("GrabAgain")
            alpha = layers.arrays(source)["color"][..., 3]
            self.assertLess(numpy.abs(alpha[ball] - 0.75).max(), 0.006, peeling)

    def test_when_they_are_grabbed(self):
        source = simple.RelievoLayers()
        self.assertEqual(source.View, self.view, "the active view")
        self.assertEqual(list(source.Layers), ["depth", "normal"])
        first = layers.arrays(source)["depth"]
        self.scene.look([4.0, -7.0, 6.0])
        simple.Render(self.view)
        self.assertTrue(layers.alike(layers.arrays(source)["depth"], first).all(), "as it was")
        source.SMProxy.InvokeCommand("GrabAgain")
        moved = layers.arrays(source)["depth"]
        self.assertFalse(layers.alike(moved, first).all(), "grabbed again")
        source.FollowView = 1
        self.scene.look([6.0, -7.0, 6.0])
        simple.Render(self.view)
        followed = layers.arrays(source)["depth"]
        self.assertFalse(layers.alike(followed, moved).all(), "followed")
        source.FollowView = 0
        self.scene.look()
        source.Layers = ["depth", "range"]
        self.assertTrue(layers.alike(layers.arrays(source)["depth"], first).all(), "other layers")

    def test_they_follow_an_animation(self):
        source = simple.RelievoLayers(View=self.view, Layers=["depth", "range"], FollowView=1)
        points = simple.DepthToPoints(Input=source)
        scene = simple.GetAnimationScene()
        scene.NumberOfFrames = 3
        track = simple.GetAnimationTrack("Radius", proxy=self.scene.ball)
        first, last = simple.CompositeKeyFrame(), simple.CompositeKeyFrame()
        first.KeyTime, first.KeyValues = 0.0, [0.4]
        last.KeyTime, last.KeyValues = 1.0, [0.8]
        track.KeyFrames = [first, last]
        scene.GoToFirst()
        for radius in (0.4, 0.6, 0.8):
            eye = distance(numpy.array(self.view.CameraPosition), self.scene.center)
            near = layers.arrays(source)["range"][:105].min()
            self.assertLess(abs(near - (eye - radius)), 1e-3)
            points.UpdatePipeline()
            cloud = simple.FetchData(points)[0]
            high = layers.vtk_to_numpy(cloud.GetPoints().GetData())[:, 2].max()
            self.assertLess(abs(high - self.scene.center[2] - radius), 5e-3)
            scene.GoToNext()

    def test_the_view_stays_as_it_is(self):
        before = pv.picture(self.view)
        source = simple.RelievoLayers(View=self.view)
        self.same(pv.picture(self.view), before, "after a grab")
        # Layers that are up to date make no view seem so.
        self.scene.ball.Radius = 0.5
        source.UpdatePipeline()
        self.differ(pv.picture(self.view), before, "a smaller ball")
        self.scene.ball.Radius = stage.RADIUS
        self.same(pv.picture(self.view), before, "as before")

    def test_a_closed_view_is_let_go(self):
        source = simple.RelievoLayers(View=self.view)
        other = simple.CreateView("RenderView")
        simple.Show(source, other)
        simple.Render(other)
        simple.Delete(self.view)
        self.assertIsNone(source.View)
        source.View = other
        source.UpdatePipeline()
        self.assertEqual(layers.image(source).GetNumberOfPoints(), numpy.prod(other.ViewSize))

    def test_states_restore_them_in_fresh_processes(self):
        source = simple.RelievoLayers(registrationName="Layers", View=self.view)
        source.Layers = ["depth", "Normals"]
        other = simple.CreateView("RenderView")
        points = simple.DepthToPoints(registrationName="Points", Input=source)
        simple.Show(points, other)
        simple.Render(other)
        own = layers.arrays(source)
        pvsm, python = pv.OUTPUT / "state.pvsm", pv.OUTPUT / "state.py"
        simple.SaveState(str(pvsm))
        python.write_text(smstate.get_state())
        for state in (pvsm, python):
            said = pv.run(__file__, "restore", state, pv.OUTPUT / "found.npz")
            self.assertEqual(pv.messages(said), [], state.name)
            found = numpy.load(pv.OUTPUT / "found.npz")
            for name in ("depth", "Normals"):
                self.assertTrue(layers.alike(found[name], own[name]).all(), f"{state.name} {name}")
            self.assertEqual(found["points"], numpy.isfinite(own["depth"]).sum())

    def test_what_cannot_be_is_said_once(self):
        said = pv.run(__file__, "provoke")
        parts = dict(part.split("\n", 1) for part in said.split("--- ")[1:])
        for part, words in (
            ("no view", "View is no render view"),
            ("another kind of view", "View is no render view"),
            ("no layers", "none is chosen"),
            ("unknown array", "'nonsense' cannot be read"),
            ("a volume", "has 21 slices, but a depth image has one"),
        ):
            self.assertEqual(len(pv.messages(parts[part])), 1, said)
            self.assertIn(words, parts[part])
        self.assertEqual(pv.messages(parts["early"]), [], "what is not yet there is no error")
        self.assertEqual(pv.messages(parts["end"]), [])


def restore(state, path):
    pv.load()
    if state.endswith(".py"):
        with open(state, encoding="utf-8") as script:
            exec(script.read(), {})  # pylint: disable=exec-used
    else:
        simple.LoadState(state)
    for view in simple.GetRenderViews():
        view.SMProxy.StillRender()
    points = simple.FindSource("Points")
    points.UpdatePipeline()
    numpy.savez(
        path,
        points=points.GetDataInformation().GetNumberOfPoints(),
        **layers.arrays(simple.FindSource("Layers")),
    )


def provoke():
    pv.load()

    def now(what):
        sys.stdout.flush()
        print("---", what, file=sys.stderr, flush=True)

    now("no view")
    simple.RelievoLayers().UpdatePipeline()
    now("early")
    scene = stage.Stage()
    source = simple.RelievoLayers(View=scene.view, Layers=["nonsense"])
    now("unknown array")
    source.UpdatePipeline()
    now("no layers")
    source.Layers = []
    now("another kind of view")
    source.View = simple.CreateView("SpreadSheetView")
    source.Layers = ["depth"]
    source.UpdatePipeline()
    now("a volume")
    simple.DepthToPoints(Input=simple.Wavelet()).UpdatePipeline()
    now("end")
    source.View = scene.view
    source.UpdatePipeline()


if sys.argv[1:2] == ["restore"]:
    restore(*sys.argv[2:])
    pv.leave()
elif sys.argv[1:2] == ["provoke"]:
    provoke()
    pv.leave()
elif __name__ == "__main__":
    pv.main()
