# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's render view stays what it was: without the plugin's features bit for bit, and with
shadows every pixel is one of two of ParaView's own pictures, the lit or the unlit, as rays say.

With the words `draw FILE` the script draws all features without the plugin.
"""

import sys

import features
import judge
import numpy
import pv


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
        judge.shadows(self, judge.sun(scene), truth, name)
        scene.sun(on=False, shadows=False)
        self.same(pv.picture(scene.view), first, name + ", off again")


for each in features.FEATURES:

    def case(self, name=each):
        self.judge(name)

    setattr(Features, "test_" + each.replace(" ", "_"), case)


if sys.argv[1:2] == ["draw"]:
    numpy.savez(sys.argv[2], **draw())
    pv.leave()
elif __name__ == "__main__":
    pv.main()
