# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A view's layers are the same wherever its picture is drawn: by ParaView alone, by a pvserver or
its client, by one rank or two, each with a part of the scene. testPVRanks has those of pvbatch."""

import pathlib

import layers
import layersScene
import numpy
import pv

SCENE = pathlib.Path(__file__).with_name("layersScene.py")
# Interpolated or made of differences on the GPU, in coordinates that each part centres by itself.
ROUNDED = {"normal": 3e-4, "geometric_normal": 1e-3}


class Anywhere(pv.Test):
    @classmethod
    def setUpClass(cls):
        pv.load()
        layersScene.keep(layersScene.scene(), pv.OUTPUT, "alone")
        pv.clear()
        cls.alone = numpy.load(pv.OUTPUT / "alone.npz")

    def check(self, name, parts=1, edges=0, cells=False):
        """`parts`: processes that drew; `edges`: pixels that may differ for their rounding;
        `cells`: the geometry was made by one process, so that its cells are the same."""
        found = numpy.load(pv.OUTPUT / f"{name}.npz")
        self.assertEqual(found["points"], self.alone["points"])
        self.assertEqual("process" in found, parts > 1)
        for layer in self.alone.files:
            first, second = self.alone[layer], found[layer]
            if layer == "points" or (layer == "cell" and not cells):
                continue
            with self.subTest(layer):
                self.assertEqual(first.dtype, second.dtype)
                unlike = ~layers.alike(first, second)
                if parts > 1 and layer in ROUNDED:
                    unlike = numpy.abs(first - second).max(axis=2) > ROUNDED[layer]
                self.assertLessEqual(unlike.sum(), edges)
        if parts > 1:
            process = found["process"]
            seen = numpy.isfinite(found["depth"])
            self.assertTrue(((process == -1) == ~seen).all())
            self.assertEqual(set(process[seen]), set(range(parts)))

    def test_the_scene(self):
        """The reference scene has the expected values."""
        alone = self.alone
        self.assertGreater(numpy.isfinite(alone["depth"]).sum(), 5000)
        for name in ("saved", "exported", "followed"):
            self.assertTrue(layers.alike(alone[name], alone["depth"]).all(), name)
        self.assertTrue(layers.alike(alone["picture"], alone["color"]).all())
        contour = numpy.isfinite(alone["RTData"])
        self.assertLess(numpy.abs(alone["RTData"][contour] - 157.0).max(), 1e-3)
        self.assertGreater(contour.sum(), 3000)

    def server(self, *where, **more):
        with pv.Server(**more) as server:
            said = pv.run(SCENE, pv.OUTPUT, "remote", server.port, *where)
        self.assertEqual(pv.messages(said + server.text()), [])

    def test_a_server(self):
        self.server("server", "client")
        self.check("remote-server", cells=True)
        self.check("remote-client", cells=True)

    def test_a_server_of_two(self):
        self.server("server", launcher=pv.mpirun(2))
        self.check("remote-server", parts=2, edges=10)


if __name__ == "__main__":
    pv.main()
