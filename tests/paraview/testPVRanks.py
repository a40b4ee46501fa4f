# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two ranks, with half of the casters beside the receivers, draw the picture of one rank."""

import pathlib

import layers
import numpy
import pv

STEPS = "off kit sun moved-sun moved-camera warped forward exact exact-moved lamp normal".split()
STEPS += ["depth", "without-ambient", "ambient", "off-again"]
SCENE = pathlib.Path(__file__).with_name("ranksScene.py")


def draw(ranks):
    """All steps' pictures with so many ranks, and ParaView's output."""
    launcher = pv.mpirun(ranks) if ranks > 1 else ()
    said = pv.run(SCENE, pv.OUTPUT, ranks, tool="pvbatch", launcher=launcher)
    return {name: pv.read(pv.OUTPUT / f"{name}-{ranks}.png") for name in STEPS}, said


class Ranks(pv.Test):
    """Two ranks against one."""

    @classmethod
    def setUpClass(cls):
        cls.one, cls.said = draw(1)

    def test_scene(self):
        """The steps are as described: there are shadows, and they move with the sun."""
        self.assertEqual(pv.messages(self.said), [])
        self.differ(self.one["kit"], self.one["off"], "kit", share=0.004)
        self.differ(self.one["sun"], self.one["moved-sun"], "moved sun")
        self.differ(self.one["lamp"], self.one["moved-camera"], "lamp")
        self.differ(self.one["ambient"], self.one["without-ambient"], "ambient")
        self.same(self.one["off"], self.one["off-again"], "off again")

    def test_two(self):
        """
        The caster on both, the ground on one: maps are fitted to whole props, whichever rank
        draws their parts. No more than 0.02 % of the pixels may differ by more than a grey
        level.
        """
        two, said = draw(2)
        # Layers of volumes, of which each rank has a part, are not merged.
        faults = pv.messages(said)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn("'volume_depth' is known only for a whole volume", faults[0])
        self.differ(two["moved-camera"], two["exact"], "exact", share=0.0002)
        self.assertIn("merged over 2 processes", said)
        # Rays of the exact steps pass the other ranks' casters.
        self.assertRegex(said, r"(?s)rays: .*, [1-9]\d* of them from other processes")
        self.assertRegex(said, r"(?s)sky: .*per pixel through .*, [1-9]\d* of them from other")
        for name in STEPS:
            with self.subTest(step=name):
                self.near(self.one[name], two[name], name, level=1, share=0.0002)
        self.check_layers()
        self.check_volume()

    def check_volume(self):
        """Two bricks let as much light pass as the whole volume."""
        one, two = (numpy.load(pv.OUTPUT / f"cloud-{ranks}.npz") for ranks in (1, 2))
        light = one["shadow_5"]
        self.assertGreater(((light > 0.05) & (light < 0.95)).sum(), 1000)
        off = numpy.abs(light - two["shadow_5"]) > 0.005
        self.assertLessEqual((off & numpy.isfinite(light)).sum(), 12)

    def check_layers(self):
        """In numbers they are those of one rank but for edges, and say which rank drew."""
        one, two = (numpy.load(pv.OUTPUT / f"layers-{ranks}.npz") for ranks in (1, 2))
        self.assertEqual(set(two.files), {*one.files, "process"})
        for name in set(one.files) - {"cell"}:  # of which each rank counts its own
            self.assertEqual(one[name].dtype, two[name].dtype)
            self.assertLessEqual((~layers.alike(one[name], two[name])).sum(), 40, name)
        seen = numpy.isfinite(two["depth"])
        self.assertTrue(((two["process"] == -1) == ~seen).all())
        self.assertEqual(set(two["process"][seen]), {0, 1})


if __name__ == "__main__":
    pv.main()
