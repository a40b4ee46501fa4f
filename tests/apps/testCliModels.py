# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Models with bones: --time, --animation and --skin, notes, and words refused."""

import os
import pathlib
import shutil

import numpy

from cli import CliTest, main

MODELS = pathlib.Path(os.environ["RELIEVO_DATA"]) / "models"
SKIN = "simple_skin.gltf"
WALK = "01_01.bvh"
TUBE = "animation_with_skeleton.fbx"


class Models(CliTest):
    def setUp(self):
        super().setUp()
        for path in (f"glTF2/simple_skin/{SKIN}", f"BVH/{WALK}", f"FBX/{TUBE}"):
            shutil.copy(MODELS / path, self.folder)
        self.before = self.names()

    def depths(self, name, *words):
        """The depth layer of a fixed view."""
        self.relievo("render", name, "--size", "80x60", "--camera", "0,1,6,0,1,0,0,1,0",
                     "--clip", "0.1,100", "--exr", "a.exr", *words)  # fmt: skip
        return self.exr("a.exr")[1]["depth.Z"]

    def test_times_of_a_bent_strip(self):
        """glTF's simple skin, a strip in the plane z = 0, bends left and right and comes back."""
        rest = numpy.isfinite(self.depths(SKIN, "--time", "0"))
        self.assertGreater(rest.sum(), 100)
        left = numpy.isfinite(self.depths(SKIN, "--time", "1.5"))
        right = numpy.isfinite(self.depths(SKIN, "--time", "3.5"))
        self.assertGreater((left != rest).sum(), 100)
        middle = numpy.argwhere(rest)[:, 1].mean()
        lean = [numpy.argwhere(each)[:, 1].mean() - middle for each in (left, right)]
        self.assertLess(lean[0] * lean[1], 0, "to opposite sides")
        for method in ("dual-quaternion", "linear", "key-matrix"):
            held = numpy.isfinite(self.depths(SKIN, "--time", "99", "--skin", method))
            self.assertLess((held != rest).sum(), 5, method)

    def test_notes_and_default_time(self):
        done = self.relievo("render", WALK, "--size", "64x64", "--png", "walk.png")
        self.assertEqual(done.stderr, "")
        self.before = self.names()
        self.refused("render", TUBE, "--animation", "fly", "--png", "a.png", status=1,
                     says=[TUBE, "no animation 'fly'; it has '"])  # fmt: skip

    def test_refused(self):
        self.refused("render", "triangle.off", "--time", "1", "--png", "a.png", status=2,
                     says=["--time", "no FILE can have bones", ".fbx"])  # fmt: skip
        for words, says in ((("--time", "soon"), "--time"), (("--skin", "fur"), "--skin")):
            self.refused("render", WALK, *words, "--png", "a.png", status=2, says=says)
        whole = (self.folder / TUBE).read_bytes()
        (self.folder / "cut.fbx").write_bytes(whole[: len(whole) // 2])
        self.before = self.names()
        self.refused("render", "cut.fbx", "--png", "a.png", status=1, says="cut.fbx")


if __name__ == "__main__":
    main()
