# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's render view stays what it was: without the plugin's features bit for bit, and with
shadows every pixel is one of two of ParaView's own pictures, the lit or the unlit, as rays say.

With the words `draw FILE` the script draws all features without the plugin.
"""

import sys

import features
import numpy
import pv
import stage


def draw():
    return {name: pv.picture(features.make(name).view) for name in features.FEATURES}


class Features(pv.Test):
    @classmethod
    def setUpClass(cls):
        pv.run(__file__, "draw", pv.OUTPUT / "own.npz")
        cls.own = dict(numpy.load(pv.OUTPUT / "own.npz"))
        pv.load()

    def judge(self, name):
        scene = features.make(name)
        first = pv.picture(scene.view)
        self.same(first, self.own[name], name + ", everything off")
        if name != "nothing":
            self.differ(first, self.own["nothing"], name + ", the feature itself", 1e-4)
        truth = scene.verdicts(margin=1 + features.FEATURES[name][1])
        self.shadows(scene, truth, name)
        scene.sun(on=False, shadows=False)
        self.same(pv.picture(scene.view), first, name + ", off again")

    def shadows(self, scene, truth, name):
        scene.sun(shadows=False)
        lit = pv.picture(scene.view)
        scene.sun(shadows=False, intensity=0.0)
        dark = pv.picture(scene.view)
        scene.sun()
        found = pv.picture(scene.view)
        expected = numpy.where((truth == stage.DARK)[..., None], dark, lit)
        sure = truth != stage.UNSURE
        # What the light does not change is the same whatever it reaches, at edges too.
        sure |= ~pv.unlike(lit, dark)
        shadow = sure & (truth == stage.DARK) & pv.unlike(lit, dark, 8)
        self.assertGreater(shadow.mean(), 0.02, name + ": no shadow in this picture")
        self.assertGreater(sure.mean(), 0.8, name + ": too few pixels to judge")
        found = numpy.where(sure[..., None], found, expected)
        self.near(found, expected, name + ", shadows", level=1, share=3e-4)


for each in features.FEATURES:

    def case(self, name=each):
        self.judge(name)

    setattr(Features, "test_" + each.replace(" ", "_"), case)


if sys.argv[1:2] == ["draw"]:
    numpy.savez(sys.argv[2], **draw())
    pv.leave()
elif __name__ == "__main__":
    pv.main()
