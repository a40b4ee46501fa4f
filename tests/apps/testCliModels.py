# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Models with bones: times, frames, blends, looks inside, notes, and words refused."""

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

    def test_sequence(self):
        """Frames are those that --time draws, and each is whole."""
        words = ("--size", "80x60", "--camera", "0,1,6,0,1,0,0,1,0", "--clip", "0.1,100")
        self.relievo("render", SKIN, *words, "--times", "0.5:2.5:0.5", "--exr", "f%02d.exr",
                     "--png", "f%d.png", "--report", "f%d.json")  # fmt: skip
        made = [f"f{i}.{end}" for i in range(5) for end in ("json", "png")]
        made += [f"f0{i}.exr" for i in range(5)]
        self.assertEqual(set(self.names()) - set(self.before), set(made))
        seen = [self.exr(f"f0{i}.exr")[1]["depth.Z"] for i in range(5)]
        for i in (0, 2, 4):
            alone = self.depths(SKIN, "--time", str(0.5 + 0.5 * i))
            self.assertTrue((alone == seen[i]).all(), i)
        self.assertGreater((seen[0] != seen[2]).sum(), 50)

    def test_sequence_fits_all_frames(self):
        """The camera stays, and sees the strip that leans to both sides."""
        self.relievo("render", SKIN, "--size", "80x60", "--times", "0:4:1", "--exr", "f%d.exr")
        for i in range(5):
            seen = numpy.isfinite(self.exr(f"f{i}.exr")[1]["depth.Z"])
            self.assertGreater(seen.sum(), 50)
            for edge in (seen[0], seen[-1], seen[:, 0], seen[:, -1]):
                self.assertFalse(edge.any(), i)

    def test_look_inside(self):
        bare = self.depths(TUBE, "--time", "0.5", "--color-by", "first_bone")
        lines = self.depths(TUBE, "--time", "0.5", "--skeleton", "--skin", "off")
        self.assertEqual(bare.shape, lines.shape)
        self.relievo("render", SKIN, "--size", "80x60", "--layers", "bone_weight",
                     "--bone-weight", "nodes[1]", "--exr", "w.exr")  # fmt: skip
        layers = self.exr("w.exr")[1]
        (weights,) = [layers[name] for name in layers if name.startswith("bone_weight")]
        weights = weights[numpy.isfinite(weights)]
        self.assertGreaterEqual(weights.min(), 0)
        self.assertLess(weights.min(), 0.1)
        self.assertGreater(weights.max(), 0.9)
        self.assertLess(weights.max(), 1.001)
        self.before = self.names()
        self.refused("render", SKIN, "--bone-weight", "tail", "--png", "a.png", status=1,
                     says=[SKIN, "no bone 'tail'; it has '"])  # fmt: skip

    def test_blend(self):
        self.refused("render", SKIN, "--blend", "x=0.5", "--png", "a.png", status=1,
                     says="no animation 'x'; it has '")  # fmt: skip
        for word in ("walk", "walk=2", "=0.5", "walk=much"):
            self.refused("render", WALK, "--blend", word, "--png", "a.png", status=2,
                         says="--blend")  # fmt: skip

    def test_refused_sequences(self):
        for word in ("1", "0:1", "0:1:0", "1:0:0.1", "0:1:-1", "0:1e9:1e-9", "a:b:c"):
            self.refused("render", WALK, "--times", word, "--png", "a%d.png", status=2,
                         says="--times")  # fmt: skip
        for name in ("a.png", "a%d%d.png", "a%s.png", "a%4d.png"):
            self.refused("render", WALK, "--times", "0:1:0.5", "--png", name, status=2,
                         says=["--png", "%04d"])  # fmt: skip
        self.refused("render", WALK, "--times", "0:1:0.5", "--time", "1", "--png", "a%d.png",
                     status=2, says="--time and --times")  # fmt: skip
        self.refused("render", WALK, "--times", "0:1:0.5", "--png", "no/a%d.png", status=1,
                     says=["no/a0.png", "no folder"])  # fmt: skip

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
