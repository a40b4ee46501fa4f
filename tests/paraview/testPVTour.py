# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The documentation's tour runs, and its pictures show the described content."""

import os
import pathlib

import numpy
import pv

EXAMPLES = pathlib.Path(os.environ["RELIEVO_EXAMPLES"])
os.environ["RELIEVO_PLUGIN_PATH"] = str(pathlib.Path(pv.PLUGIN).parent)


class Tour(pv.Test):
    def test_pictures(self):
        said = pv.run(EXAMPLES / "08_paraview_tour.py", pv.OUTPUT, tool="pvbatch")
        self.assertEqual(pv.messages(said), [])
        # The sun at the equinox: at noon as high as 90 degrees less the latitude, and seven
        # minutes, the equation of time, before it is in the south.
        self.assertIn("12:00, azimuth 177, elevation 42", said)
        town, day, bike = (pv.read(pv.OUTPUT / f"paraview_{name}.png") for name in
                           ("town", "day", "bike"))  # fmt: skip
        self.assertEqual((town.shape, day.shape), ((540, 1440, 3), (400, 1440, 3)))
        # Shadows: places much darker than anything that ParaView alone leaves so dark.
        own, shadows = town[:, :718].max(axis=2), town[:, 722:].max(axis=2)
        self.assertGreater((shadows < 75).mean(), (own < 75).mean() + 0.08)
        morning, noon = day[:, 4:476].max(axis=2), day[:, 484:956].max(axis=2)
        self.assertGreater((morning < 75).mean(), (noon < 75).mean() + 0.05)
        self.assertGreater(((bike[..., 2] > 250) & (bike[..., 0] > 120)).mean(), 0.2, "normals")

    def test_materials(self):
        said = pv.run(EXAMPLES / "11_paraview_materials.py", pv.OUTPUT, tool="pvbatch")
        self.assertEqual(pv.messages(said), [])
        both = pv.read(pv.OUTPUT / "paraview_materials.png").astype(int)
        plain, styled = both[:, :719], both[:, 721:]
        # The ground, lower left: even without relief; stones in the sun and gaps between with it.
        self.assertLess(plain[430:, :200].std(axis=(0, 1)).max(), 3)
        self.assertGreater(styled[430:, :200].std(axis=(0, 1)).min(), 25)
        # The bike: its own red, brighter or darker; and mirrored, other colours and white.
        bike = (plain[..., 0] > 1.5 * plain[..., 2] + 20) & (plain[..., 0] > 2 * plain[..., 1])
        self.assertGreater(bike.mean(), 0.2)
        self.assertGreater((styled[bike].min(axis=1) > 150).mean(), 0.02, "the sky's white")
        green = styled[..., 1] > styled[..., 0]
        self.assertGreater(green[bike].mean(), 0.02, "the forest's green")
        # The forest in place of the background.
        sky = (plain == plain[0, 0]).all(axis=2)
        self.assertGreater(sky.mean(), 0.15)
        self.assertLess(styled[sky].max(axis=1).mean(), 120)

    def test_hall(self):
        said = pv.run(EXAMPLES / "17_paraview_hall.py", pv.OUTPUT, tool="pvbatch")
        self.assertEqual(pv.messages(said), [])
        both = pv.read(pv.OUTPUT / "paraview_hall.png").astype(int)
        plain, lit = both[:, :719], both[:, 721:]
        # Lamps on pillars are warm and bright, fireflies' light is green; ParaView has neither.
        warm, green = (
            lambda c: (c[:200, :, 0] > 220) & (c[:200, :, 2] < 160),
            lambda c: (c[..., 1] > 1.15 * c[..., 0]) & (c[..., 1] > 1.3 * c[..., 2]),
        )
        for what, test in (("lamps", warm), ("fireflies", green)):
            self.assertGreater(test(lit).sum(), 300, what)
            self.assertLess(test(plain).sum(), 30, what)
        # The ring on the floor, and nothing of it within.
        ring = (lit[..., 2] > 150) & (lit[..., 2] > 1.8 * lit[..., 0])
        rows, columns = numpy.nonzero(ring)
        self.assertGreater(len(rows), 500)
        self.assertFalse(ring[int(rows.mean()), int(columns.mean())])
        # Mist on the floor of the far end; the lamps' colour on the near floor.
        mist, floor = (lit[rows, 210:310].mean(axis=(0, 1)) for rows in (slice(285, 330),
                                                                         slice(490, 535)))
        self.assertGreater(mist[2], 1.08 * mist[0])
        self.assertLess(floor[2], 0.8 * floor[0])


if __name__ == "__main__":
    pv.main()
