# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shadows in a picture are judged by ParaView's own pictures: the lit and the unlit."""

import numpy
import pv
import stage


class StageTest(pv.PluginTest):
    """In each case a new stage."""

    def setUp(self):
        super().setUp()
        self.scene = stage.Stage()
        self.view = self.scene.view
        self.scene.render()


def shadows(test, pictures, truth, what, share=3e-4, least=0.02):
    """Every sure pixel of the found picture is the lit picture's or the dark one's, as rays say.

    `pictures` are the lit, the dark (that light's intensity 0) and the found one. Pixels that are
    alike in both must stay so at the edges of shadows too.
    """
    lit, dark, found = pictures
    expected = numpy.where((truth == stage.DARK)[..., None], dark, lit)
    sure = (truth != stage.UNSURE) | ~pv.unlike(lit, dark)
    shadow = sure & (truth == stage.DARK) & pv.unlike(lit, dark, 8)
    test.assertGreater(shadow.mean(), least, what + ": no shadow in this picture")
    test.assertGreater(sure.mean(), 0.8, what + ": too few pixels to judge")
    found = numpy.where(sure[..., None], found, expected)
    test.near(found, expected, what + ", shadows", level=1, share=share)


def sun(scene, draw=None):
    """The lit, the dark and the shadowed picture of a stage with its sun."""
    draw = draw or (lambda: pv.picture(scene.view))
    found = []
    for more in ({"shadows": False}, {"shadows": False, "intensity": 0.0}, {}):
        scene.sun(**more)
        found.append(draw())
    return found
