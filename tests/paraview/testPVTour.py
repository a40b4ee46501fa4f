# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tour of the documentation runs, and its pictures show what the page says."""

import os
import pathlib

import pv

EXAMPLE = pathlib.Path(os.environ["RELIEVO_EXAMPLES"]) / "08_paraview_tour.py"


class Tour(pv.Test):
    def test_pictures(self):
        os.environ["RELIEVO_PLUGIN_PATH"] = str(pathlib.Path(pv.PLUGIN).parent)
        said = pv.run(EXAMPLE, pv.OUTPUT, tool="pvbatch")
        self.assertEqual(pv.messages(said), [])
        # The sun at the equinox: south at noon, and as high as 90 degrees less the latitude.
        self.assertIn("12:00, azimuth 180, elevation 42", said)
        town, day, bike = (pv.read(pv.OUTPUT / f"paraview_{name}.png") for name in
                           ("town", "day", "bike"))  # fmt: skip
        self.assertEqual((town.shape, day.shape), ((540, 1440, 3), (400, 1440, 3)))
        # Shadows: places much darker than anything that ParaView alone leaves so dark.
        own, shadows = town[:, :718].max(axis=2), town[:, 722:].max(axis=2)
        self.assertGreater((shadows < 75).mean(), (own < 75).mean() + 0.08)
        morning, noon = day[:, 4:476].max(axis=2), day[:, 484:956].max(axis=2)
        self.assertGreater((morning < 75).mean(), (noon < 75).mean() + 0.05)
        self.assertGreater(((bike[..., 2] > 250) & (bike[..., 0] > 120)).mean(), 0.2, "normals")


if __name__ == "__main__":
    pv.main()
