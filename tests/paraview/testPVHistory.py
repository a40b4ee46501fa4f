# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A picture is a function of scene, camera, lights and settings: a random walk through them, with
screenshots, layers, selections and interaction on the way. After every twentieth step a state file
is saved, and a fresh process that loads it draws the same picture and gives the same layers, bit
for bit.

    testPVHistory.py [STEPS [SEED]]

With the words `restore FILE PICTURE LAYERS` the script loads a state and stores its picture
and layers.
"""

import random
import sys

import layers
import materialScene
import numpy
import pv
import stage
from paraview import simple

LAYERS = "depth normal position albedo actor cell color".split()
SIZES = (400, 260), (333, 241), (520, 300), (256, 256)
STEPS, SEED = 40, 1


def shadow_layers(view):
    """The layers of the lights that cast now."""
    view.UpdatePropertyInformation()
    names = view.GetProperty("RelievoShadowLayers").GetElement(0)
    return [name for name in names.split(",") if name]


def keep(view, path):
    """Writes a view's layers, those of its shadows too, into a file."""
    source = simple.RelievoLayers(View=view, Layers=LAYERS + shadow_layers(view))
    numpy.savez(path, **layers.arrays(source))
    simple.Delete(source)


def light(view, place, strength=1.0):
    """A light among the data."""
    made = simple.AddLight(view)
    made.Coords, made.Type = "Scene", "Positional"
    made.Position, made.FocalPoint, made.ConeAngle = place, [0.0, 0.0, 0.0], 70.0
    made.Intensity, made.RelievoShadowStrength = 0.6, strength
    return made


class Walk:
    """A scene, and possible actions of a user: each step returns its description."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.scene = stage.Stage()
        self.view = self.scene.view
        self.scene.ball.ThetaResolution = self.scene.ball.PhiResolution = 40
        self.box = simple.Box(Center=[-1.6, 0.8, 0.5])
        self.box_shown = simple.Show(self.box, self.view)
        self.scene.render()
        self.shown = [self.scene.ground_shown, self.scene.ball_shown, self.box_shown]
        self.lights = []

    def between(self, low, high):
        # Few digits: a state file has them all.
        return round(self.random.uniform(low, high), 3)

    def set(self, proxy=None, **values):
        for name, value in values.items():
            setattr(proxy or self.view, name, value)
        return ", ".join(f"{name} = {value}" for name, value in values.items())

    # Settings -----------------------------------------------------------------

    def shadows(self):
        choose = self.random.choice
        return self.set(
            **choose(
                [
                    {"RelievoShadows": choose([0, 1, 1])},
                    {"RelievoShadowMethod": choose(["Map", "Forward", "Warped", "Exact"])},
                    {"RelievoShadowMapSize": choose([256, 500, 1024])},
                    {"RelievoShadowFilterRadius": choose([0, 1, 3])},
                    {"RelievoShadowBias": self.between(0.5, 3.0)},
                    {"RelievoShadowStrength": self.between(0.3, 1.0)},
                    {"RelievoLightKitCasts": choose(["Nothing", "Key light", "All lights"])},
                ]
            )
        )

    def sun(self):
        choose, between = self.random.choice, self.between
        return self.set(
            **choose(
                [
                    {"RelievoSun": choose([0, 1, 1])},
                    {"RelievoSunAzimuth": between(0, 360), "RelievoSunBy": "Angles"},
                    {"RelievoSunElevation": between(10, 80), "RelievoSunBy": "Angles"},
                    {"RelievoSunTime": between(0, 24), "RelievoSunBy": "Date and place"},
                    {"RelievoSunUpAxis": choose("XYZ"), "RelievoSunFill": between(0, 1)},
                    {"RelievoSunKitShare": between(0, 1), "RelievoSunIntensity": between(0, 2)},
                ]
            )
        )

    def layer(self):
        named = ["None", "None", "depth", "normal", "actor", *shadow_layers(self.view)]
        words = self.set(RelievoDisplayLayer=self.random.choice(named))
        return words + ", " + self.set(RelievoDisplayGrey=self.random.randint(0, 1))

    def environment(self):
        choose = self.random.choice
        words = self.set(
            **choose(
                [
                    {"RelievoEnvironment": choose(["", str(pv.OUTPUT / "axes.png")])},
                    {"RelievoSkybox": choose([0, 1])},
                    {"RelievoEnvironmentRotation": self.between(0, 360)},
                ]
            )
        )
        mirror = choose([0, 1])
        return words + ", " + self.set(self.scene.ball_shown, RelievoMirror=mirror)

    # Scene --------------------------------------------------------------------

    def lights_change(self):
        # The shown layer may be that of a light that goes.
        self.set(RelievoDisplayLayer="None")
        if self.lights and self.random.random() < 0.4:
            simple.RemoveLight(self.lights.pop(self.random.randrange(len(self.lights))))
            return "remove light"
        place = [self.between(-3, 3), self.between(-3, 3), self.between(2, 5)]
        if self.lights and (len(self.lights) > 1 or self.random.random() < 0.5):
            self.random.choice(self.lights).Position = place
            return f"light to {place}"
        self.lights.append(light(self.view, place, self.random.choice([0.5, 1.0])))
        return f"light at {place}"

    def props(self):
        shown = self.random.choice(self.shown)
        choose = self.random.choice
        words = self.set(
            shown,
            **choose(
                [
                    {"Visibility": choose([0, 1, 1])},
                    {"Representation": choose(["Surface", "Surface", "Wireframe", "Points"])},
                    {"Opacity": choose([1.0, 1.0, 0.5])},
                    {"Pickable": choose([0, 1])},
                    {pv.TRANSLATION: [self.between(-0.5, 0.5), self.between(-0.5, 0.5), 0.1]},
                    {"DiffuseColor": [self.between(0, 1), self.between(0, 1), 0.5]},
                ]
            ),
        )
        return f"prop {self.shown.index(shown)}: {words}"

    def source(self):
        center = [self.between(-0.5, 0.5), self.between(-0.5, 0.5), self.between(1, 2)]
        return self.set(self.scene.ball, Center=center)

    def camera(self):
        place = [self.between(-8, 8), self.between(-8, 8), self.between(2, 8)]
        return self.set(
            CameraPosition=place,
            CameraFocalPoint=[self.between(-0.5, 0.5), 0.0, 0.4],
            CameraViewAngle=self.between(15, 45),
            CameraParallelProjection=self.random.choice([0, 0, 1]),
            CameraParallelScale=self.between(1.5, 3),
        )

    def size(self):
        return self.set(ViewSize=self.random.choice(SIZES))

    # Operations that must leave no trace ---------------------------------------

    def screenshot(self):
        size = self.random.choice([(700, 560), (124, 456), (260, 260)])
        see_through = self.random.randint(0, 1)
        simple.SaveScreenshot(
            str(pv.OUTPUT / "shot.png"),
            self.view,
            ImageResolution=size,
            TransparentBackground=see_through,
        )
        return f"screenshot {size} {see_through}"

    def grab(self):
        keep(self.view, pv.OUTPUT / "grabbed.npz")
        return "layers"

    def select(self):
        simple.SelectSurfaceCells(Rectangle=[100, 100, 150, 150], View=self.view)
        for source in (self.scene.ground, self.scene.ball, self.box):
            simple.ClearSelection(source)
        return "select"

    def interact(self):
        self.view.LODThreshold = 0.0
        self.view.UseInteractiveRenderingForScreenshots = 1
        pv.picture(self.view)
        self.view.UseInteractiveRenderingForScreenshots = 0
        self.view.LODThreshold = 20.0
        return "interact"

    def render(self):
        simple.Render(self.view)
        return "render"

    def orbit(self):
        there = list(self.view.CameraPosition)
        for shift in (0.4, 0.9, -1.3):
            self.view.CameraPosition = [there[0] + shift, there[1] - shift, there[2]]
            simple.Render(self.view)
        self.view.CameraPosition = there
        return "orbit and back"

    def step(self):
        """One change, and often something that must not change anything."""
        changes = [self.shadows, self.shadows, self.sun, self.sun, self.layer, self.environment]
        changes += [self.lights_change, self.props, self.source, self.camera, self.size]
        words = self.random.choice(changes)()
        traceless = [self.screenshot, self.grab, self.select, self.interact, self.render]
        traceless += [self.orbit]
        if self.random.random() < 0.7:
            words += "; " + self.random.choice(traceless)()
        return words


class History(pv.Test):
    @classmethod
    def setUpClass(cls):
        pv.load()
        materialScene.write_axes(str(pv.OUTPUT / "axes.png"))

    def test_a_walk_and_fresh_processes(self):
        walk = Walk(SEED)
        # Something to see from the first step on.
        walk.set(RelievoShadows=1, RelievoShadowMapSize=1024, RelievoSun=1)
        taken = []
        for i in range(1, STEPS + 1):
            taken.append(walk.step())
            if i % 20 == 0:
                with self.subTest(seed=SEED, step=i):
                    self.compare(walk.view, i, "\n  ".join(taken))
                taken.clear()

    def compare(self, view, i, steps):
        """The view as it is, and in a fresh process that loads its state."""
        state, picture, kept = (pv.OUTPUT / f"{i}.{end}" for end in ("pvsm", "npy", "npz"))
        here = pv.picture(view)
        simple.SaveState(str(state))
        keep(view, pv.OUTPUT / f"{i}-here.npz")
        said = pv.run(__file__, "restore", state, picture, kept)
        self.assertEqual(pv.messages(said), [], steps)
        unlike = []
        count = int(pv.unlike(here, numpy.load(picture)).sum())
        if count:
            self.leave(f"step {i}", here=here, fresh=numpy.load(picture))
            unlike.append(f"{count} pixels of the picture")
        mine, fresh = numpy.load(pv.OUTPUT / f"{i}-here.npz"), numpy.load(kept)
        self.assertEqual(set(mine.files), set(fresh.files))
        for name in mine.files:
            count = int((~layers.alike(mine[name], fresh[name])).sum())
            if count:
                unlike.append(f"{count} pixels of {name}")
        self.assertEqual(unlike, [], f"after\n  {steps}")


if sys.argv[1:2] == ["restore"]:
    pv.load()
    keep(pv.restore(*sys.argv[2:4]), sys.argv[4])
    pv.leave()
elif __name__ == "__main__":
    STEPS = int(sys.argv.pop(1)) if sys.argv[1:] else STEPS
    SEED = int(sys.argv.pop(1)) if sys.argv[1:] else SEED
    pv.main()
