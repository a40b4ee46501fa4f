# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's render view stays unchanged: without the plugin's features bit for bit, and with
shadows every pixel is one of two of ParaView's own pictures, the lit or the unlit, as rays say.

With the words `draw FILE` the script draws all features without the plugin.
"""

import sys

import features
import judge
import numpy
import pv


# Props that VTK shades although deferred shading is on, and a word of the reason.
LEFT_TO_VTK = {
    "8 samples": "multisampled",
    "ambient occlusion": "several buffers",
    "axes": "vtkPVGridAxes3DActor",
}


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
        pictures = judge.sun(scene)
        judge.shadows(self, pictures, truth, name)
        self.judge_deferred(name, scene, pictures[-1])
        scene.sun(on=False, shadows=False)
        self.same(pv.picture(scene.view), first, name + ", off again")


    def judge_deferred(self, name, scene, own):
        """Deferred shading gives VTK's picture, or says why all of it is left to VTK."""
        scene.view.RelievoStageDeferred = 1
        # FXAA's edges choose by thresholds, from which a level may carry it away.
        level = 4 if name == "FXAA" else 2 if name == "materials" else 1
        self.near(pv.picture(scene.view), own, name + ", deferred", level=level, share=0)
        reason = pv.stage(scene.view, "deferred")["reason"]
        self.assertIn(LEFT_TO_VTK.get(name, "shades the surfaces of"), reason, name)
        scene.view.RelievoStageDeferred = 0


for each in features.FEATURES:

    def case(self, name=each):
        self.judge(name)

    setattr(Features, "test_" + each.replace(" ", "_"), case)


if sys.argv[1:2] == ["draw"]:
    numpy.savez(sys.argv[2], **draw())
    pv.leave()
elif __name__ == "__main__":
    pv.main()
