# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every representation ParaView has, with shadows and with a layer shown: which cast, that nothing
is said, and that the first picture comes back.

With the word `layers` the script shows a layer of Gaussian points, which have none: that is told.
"""

import sys

import pv
import stage
from paraview import simple

# Whether it leaves a shadow on the ground.
CASTS = {
    "3D Glyphs": True,
    "Feature Edges": False,
    "Outline": False,
    "Point Gaussian": True,
    "Points": True,
    "Slice": True,
    "Surface": True,
    "Surface LIC": False,
    "Surface With Edges": True,
    "Volume": True,
    "Wireframe": True,
}
# Representations without layers: the background is visible.
WITHOUT_LAYERS = ["Surface LIC"]


def make():
    """A block of data over the ground, with vectors, in place of the sphere."""
    scene = stage.Stage()
    simple.Hide(scene.ball, scene.view)
    block = simple.Wavelet(WholeExtent=[-8, 8, -8, 8, -8, 8])
    vectors = simple.Calculator(Input=block, ResultArrayName="flow", Function="coordsY*iHat+jHat")
    shown = simple.Show(vectors, scene.view)
    shown.Scale = [0.08] * 3
    setattr(shown, pv.TRANSLATION, [-0.2, -0.2, 1.2])
    shown.GaussianRadius, shown.ScaleFactor = 0.4, 1.0
    simple.ColorBy(shown, ("POINTS", "RTData"))
    return scene, shown


def show_layers():
    """Shows a layer where there are Gaussian points, twice."""
    pv.load()
    scene, shown = make()
    shown.Representation = "Point Gaussian"
    own = pv.picture(scene.view)
    scene.view.RelievoDisplayLayer = "depth"
    pv.picture(scene.view)
    pv.picture(scene.view)
    scene.view.RelievoDisplayLayer = "None"
    print("as it was", not pv.unlike(pv.picture(scene.view), own).any())


class Representations(pv.Test):
    def test_all(self):
        pv.load()
        scene, shown = make()
        ground = scene.verdicts() == stage.LIT  # a part of it, before the sphere's shadow
        self.assertEqual(sorted(CASTS), sorted(shown.GetProperty("Representation").GetAvailable()))
        for name, casts in CASTS.items():
            scene.sun(on=False, shadows=False)
            scene.view.RelievoDisplayLayer, shown.Visibility = "None", 1
            with self.subTest(name):
                shown.Representation = name
                pv.picture(scene.view)  # glyphs find their size in the first
                own = pv.picture(scene.view)
                scene.sun(shadows=False)
                lit = pv.picture(scene.view)
                scene.sun()
                found = pv.picture(scene.view)
                darker = (lit.astype(int) - found.astype(int)).max(axis=2) > 40
                if casts:
                    self.assertGreater((darker & ground).mean(), 5e-5)
                else:
                    self.same(found, lit, name)
                scene.sun(on=False, shadows=False)
                if name != "Point Gaussian":
                    scene.view.RelievoDisplayLayer = "volume" if name == "Volume" else "actor"
                    ids = pv.picture(scene.view)
                    shown.Visibility = 0
                    there = pv.unlike(ids, pv.picture(scene.view)).any()
                    self.assertEqual(there, name not in WITHOUT_LAYERS)
                    shown.Visibility = 1
                    scene.view.RelievoDisplayLayer = "None"
                self.same(pv.picture(scene.view), own, name + ", off again")

    def test_gaussian_points_have_no_layers(self):
        said = pv.run(__file__, "layers")
        self.assertEqual(len(pv.messages(said)), 1, said)
        self.assertIn("No layers of geometry drawn by vtkOpenGLPointGaussianMapperHelper", said)
        self.assertIn("as it was True", said)


if sys.argv[1:2] == ["layers"]:
    show_layers()
    pv.leave()
elif __name__ == "__main__":
    pv.main()
