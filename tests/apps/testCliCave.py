# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""relievo cave: its output, options and refused arguments."""

import numpy
from cli import CliTest, main
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader


class Cave(CliTest):
    def read(self, name):
        reader = vtkXMLImageDataReader()
        reader.SetFileName(str(self.folder / name))
        reader.Update()
        return reader.GetOutput()

    def values(self, *words):
        self.relievo("cave", *words, "-o", "a.vti")
        return vtk_to_numpy(self.read("a.vti").GetPointData().GetScalars())

    def test_image(self):
        done = self.relievo("cave", "--size", "64x32x48", "--seed", "7", "--origin", "10,0,-4",
                            "--spacing=1,0.5,-2", "-o", "cave.vti")  # fmt: skip
        self.assertEqual(done.stderr, "")
        image = self.read("cave.vti")
        self.assertEqual(image.GetDimensions(), (64, 32, 48))
        self.assertEqual(image.GetOrigin(), (10, 0, -4))
        self.assertEqual(image.GetSpacing(), (1, 0.5, -2))
        mask = vtk_to_numpy(image.GetPointData().GetArray("cave"))
        self.assertEqual(sorted(set(mask)), [0, 1])
        self.assertIn(f"98304 samples, {100 * mask.mean():.2f} % air", done.stdout)
        self.assertEqual(self.names(), sorted([*self.before, "cave.vti"]))
        # Readable beside every expat, by any VTK.
        self.assertNotIn(b"<AppendedData", (self.folder / "cave.vti").read_bytes())

    def test_options(self):
        mask = self.values("--size", "48x48x48")
        self.assertTrue((mask == self.values("--size=48x48x48", "--seed", "0")).all())
        for words in (["--seed", "-1"], ["--width", "9"], ["--scale", "40"], ["--up", "z"],
                      ["--vertical-scale", "1"], ["--origin", "1e7,0,0"]):  # fmt: skip
            self.assertTrue((mask != self.values("--size", "48x48x48", *words)).any(), words)
        labels = self.values("--size", "48x48x48", "--content", "labels")
        self.assertTrue((labels == 1 - mask).all())
        others = self.values("--size", "48x48x48", "--content", "labels", "--air-label", "7",
                             "--rock-label=9")  # fmt: skip
        self.assertTrue((others == 9 - 2 * mask).all())
        # By the thresholds themselves: a wider shell has all the air of a narrower one.
        wide, narrow = (
            self.values("--size", "48x48x48", "--width", "0", "--shell", shell) > 0
            for shell in ("-0.2,0.2", "-0.1,0.1")
        )
        self.assertTrue(wide[narrow].all() and wide.sum() > narrow.sum() > 0)
        density = self.values("--size", "48x48x48", "--content", "density")
        self.assertEqual(density.dtype, numpy.float32)
        self.assertTrue(((density < 0) == (mask == 1)).all())

    def test_refused(self):
        for words, says in (
            ([], "no file to write; give -o FILE.vti"),
            (["-o", "a.png"], ["-o", "a.png", ".vti"]),
            (["-o", "a.vti", "--size", "5x5"], ["--size", "5x5", "WxHxD"]),
            (["-o", "a.vti", "--size", "0x5x5"], ["--size", "'0x5x5'", "WxHxD", "from 1 to"]),
            (["-o", "a.vti", "--size", "5x5x2147483648"], ["--size", "to 2147483647"]),
            (["-o", "a.vti", "--up", "w"], ["--up", "'w'", "x"]),
            (["-o", "a.vti", "--width", "nan"], ["--width", "nan"]),
            (["-o", "a.vti", "--width", "-1"], ["--width", "0 or more", "'-1'"]),
            (["-o", "a.vti", "--shell", "1"], ["--shell", "A,B, two numbers", "'1'"]),
            (["-o", "a.vti", "--rock-label", "256"], ["--rock-label", "from 0 to 255"]),
            (["-o", "a.vti", "--seed=1", "--seed=2"], "--seed: given twice"),
            (["-o", "a.vti", "--seed="], "--seed: its value is empty"),
            (["-o", "a.vti", "--scale", "0"], ["--scale", "above 0", "'0'"]),
            (["-o", "a.vti", "--vertical-scale", "-1"], ["--vertical-scale", "above 0", "'-1'"]),
            (["-o", "a.vti", "--content", "air"], ["--content", "mask"]),
            (["-o", "a.vti", "more.vti"], ["more.vti"]),
            (["-o", "a.vti", "--depth", "3"], ["--depth", "--vertical-scale"]),
        ):
            with self.subTest(words=words):
                self.refused("cave", *words, status=2, says=says)
        self.refused("cave", "-o", "no/a.vti", status=1, says=["no/a.vti", "there is no folder"])
        self.refused("cave", "-o", "a.vti", "--width", "40", status=2,
                     says=["--width is 40", "at most 32, half of --scale"])  # fmt: skip
        self.refused("cave", "-o", "a.vti", "--size", "900000x900000x900000", status=1,
                     says=["it would take 729000000000000000 bytes"])  # fmt: skip


if __name__ == "__main__":
    main()
