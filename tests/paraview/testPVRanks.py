# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks, with what casts and what receives on different ones, draw what one rank draws."""

import pathlib

import pv

STEPS = "off kit sun moved-sun moved-camera warped forward exact exact-moved lamp normal".split()
STEPS += ["depth", "without-ambient", "ambient", "off-again"]
SCENE = pathlib.Path(__file__).with_name("ranksScene.py")


def draw(ranks):
    """All steps' pictures with so many ranks, and what ParaView wrote."""
    launcher = pv.mpirun(ranks) if ranks > 1 else ()
    said = pv.run(SCENE, pv.OUTPUT, ranks, tool="pvbatch", launcher=launcher)
    return {name: pv.read(pv.OUTPUT / f"{name}-{ranks}.png") for name in STEPS}, said


class Ranks(pv.Test):
    """Two and three ranks against one."""

    @classmethod
    def setUpClass(cls):
        cls.one, cls.said = draw(1)

    def test_scene(self):
        """The steps are what they say: there are shadows, and they move with the sun."""
        self.assertEqual(pv.messages(self.said), [])
        self.differ(self.one["kit"], self.one["off"], "kit", share=0.004)
        self.differ(self.one["sun"], self.one["moved-sun"], "moved sun")
        self.differ(self.one["lamp"], self.one["moved-camera"], "lamp")
        self.differ(self.one["ambient"], self.one["without-ambient"], "ambient")
        self.same(self.one["off"], self.one["off-again"], "off again")

    def check(self, ranks, level=1):
        """
        All steps: no more than 0.02 % of the pixels may differ by more than so many grey levels.
        """
        several, said = draw(ranks)
        self.assertEqual(pv.messages(said), [])
        self.differ(several["moved-camera"], several["exact"], f"exact {ranks}", share=0.0002)
        self.assertIn(f"merged over {ranks} processes", said)
        # Rays of the exact steps pass what the other ranks cast.
        self.assertRegex(said, r"(?s)rays: .*, [1-9]\d* of them from other processes")
        self.assertRegex(said, r"(?s)sky: .*of each pixel past .*, [1-9]\d* of them from other")
        for name in STEPS:
            with self.subTest(step=name, ranks=ranks):
                self.near(self.one[name], several[name], f"{name} {ranks}", level, share=0.0002)

    def test_two(self):
        """The caster on one, the ground on the other."""
        self.check(2)

    def test_three(self):
        """The caster on two: maps are fitted to whole props, whoever draws their parts."""
        self.check(3)


if __name__ == "__main__":
    pv.main()
