# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shadows by --shadows and by layers shadow_N: where they must be, for each kind of light."""

import json

import numpy

from cli import CliTest, main, read_png

# A plate of half width 1/2 hangs at z = 1 over a floor of half width 2 at z = 0; a parallel camera
# looks down on them, 25 pixels to a unit.
PLATE = "OFF\n4 1 0\n-0.5 -0.5 1\n0.5 -0.5 1\n0.5 0.5 1\n-0.5 0.5 1\n4 0 1 2 3\n"
FLOOR = "OFF\n4 1 0\n-2 -2 0\n2 -2 0\n2 2 0\n-2 2 0\n4 0 1 2 3\n"
SIDE = 100
LOOK = ["--camera", "0,0,5,0,0,0,0,1,0", "--clip", "1,10", "--parallel-scale", "2",
        "--size", f"{SIDE}x{SIDE}", "--shading", "flat"]  # fmt: skip

# Lights, and the part of the floor that each leaves dark: x0, x1, y0, y1. A light at height h over
# a place casts the plate's edge at e to place + (e - place) h / (h - 1).
LIGHTS = {
    "sun:-1,0,1": (0.5, 1.5, -0.5, 0.5),
    "sun:1,1,1": (-1.5, -0.5, -1.5, -0.5),
    "spot:-1,0,3,0,0,0,60": (-0.25, 1.25, -0.75, 0.75),
    "spot:-1,0,3,0,0,0,120": (-0.25, 1.25, -0.75, 0.75),
    "point:0.5,-1,3": (-1.0, 0.5, -0.25, 1.25),
}


def dark(bounds):
    """Pixels of the shadow with these bounds, and pixels further than one from its edge or the
    plate's."""
    rows, columns = numpy.mgrid[0:SIDE, 0:SIDE] + 0.5
    x, y = (columns - SIDE / 2) / 25, (SIDE / 2 - rows) / 25

    def outside(x0, x1, y0, y1):  # signed distance in pixels, of the larger axis
        return 25 * numpy.maximum.reduce([x0 - x, x - x1, y0 - y, y - y1])

    shadow, plate = outside(*bounds), outside(-0.5, 0.5, -0.5, 0.5)
    return (shadow < 0) & (plate > 0), (abs(shadow) > 1) & (abs(plate) > 1)


class Shadows(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plate.off").write_text(PLATE)
        (self.folder / "floor.off").write_text(FLOOR)
        self.before = self.names()

    def draw(self, *words, lights=(), **more):
        lit = [word for light in lights for word in ("--light", light)]
        return self.relievo("render", "plate.off", "floor.off", *LOOK, *lit, *words, **more)

    def picture(self, *words, lights):
        self.draw("--png", "a.png", *words, lights=lights)
        return read_png(self.folder / "a.png")[..., 0].astype(int)

    def check_layer(self, values, bounds):
        shadow, sure = dark(bounds)
        numpy.testing.assert_array_equal(values[sure], numpy.where(shadow, 0.0, 1.0)[sure])
        self.assertGreater((shadow & sure).sum(), 300)

    def test_each_light_darkens_its_side(self):
        for light, bounds in LIGHTS.items():
            with self.subTest(light=light):
                off = self.picture(lights=[light])
                on = self.picture("--shadows", "map", lights=[light])
                shadow, sure = dark(bounds)
                self.assertGreater(off[shadow & sure].min(), 60)
                self.assertEqual(on[shadow & sure].max(), 0)
                numpy.testing.assert_array_equal(on[sure & ~shadow], off[sure & ~shadow])
                numpy.testing.assert_array_equal(
                    self.picture("--shadows", "off", lights=[light]), off
                )

    def test_lights_that_cast_none(self):
        """Are as without shadows, and the report names them."""
        (first, bounds), (second, _) = list(LIGHTS.items())[:2]
        first, second = first + ",intensity=0.5", second + ",intensity=0.5"
        lights = [first + ",name=Porch", second + ",casts=off,name=Moon\\, full"]
        self.draw("--png", "a.png", "--shadows", "map", "--report", "a.json", lights=lights)
        on = read_png(self.folder / "a.png")[..., 0].astype(int)
        alone, other = (self.picture(lights=[light]) for light in (first, second))
        shadow, sure = dark(bounds)
        seen = sure & (alone + other < 250)
        self.assertGreater((seen & shadow).sum(), 100)
        self.assertLessEqual(abs(on - numpy.where(shadow, 0, alone) - other)[seen].max(), 1)
        stages = json.loads((self.folder / "a.json").read_text())["stages"]
        (reason,) = [stage["reason"] for stage in stages if stage["name"] == "shadows"]
        self.assertIn("Moon, full casts none", reason)
        self.assertNotIn("Porch casts none", reason)
        fills = ["sun:1,0,1,casts=off,name=fill", "sun:0,1,1,casts=off,name=fill"]
        self.draw("--png", "a.png", "--shadows", "map", "--report", "a.json",
                  lights=[*lights, *fills])  # fmt: skip
        stages = json.loads((self.folder / "a.json").read_text())["stages"]
        (reason,) = [stage["reason"] for stage in stages if stage["name"] == "shadows"]
        self.assertIn("; Moon, full, fill (2 lights) cast none: it is chosen so", reason)

    def test_all_lights_cast(self):
        lights = list(LIGHTS)
        layers = [f"shadow_{i}" for i in range(len(lights))]
        done = self.draw("--exr", "a.exr", "--layers", ",".join(layers), lights=lights)
        self.assertEqual(done.stderr, "")
        header, channels = self.exr("a.exr")
        names = sorted(channel["name"] for channel in header["channels"])
        self.assertEqual(names, sorted(["R", "G", "B", "A", *(f"{name}.V" for name in layers)]))
        for light, name in zip(lights, layers):
            with self.subTest(light=light):
                self.check_layer(channels[f"{name}.V"], LIGHTS[light])

    def test_soft_shadows_are_shares_of_the_light(self):
        # Beside the plate's edge at x = 0.5 a sun above it leaves the share of its disc on that
        # side. It is not quite behind the parallel camera, which would see no shadows then.
        self.draw(
            "--exr", "a.exr", "--layers", "shadow_0", "--shadows", "exact", "--soft-shadows", "64",
            "--report", "a.json", lights=["sun:0,0.02,1,size=40"],
        )  # fmt: skip
        share = self.exr("a.exr")[1]["shadow_0.V"][SIDE // 2]
        x = (numpy.arange(SIDE) + 0.5 - SIDE / 2) / 25
        h = (x - 0.5) / numpy.tan(numpy.radians(20))
        edge = numpy.clip(h, -1, 1)
        truth = 0.5 + (edge * numpy.sqrt(1 - edge**2) + numpy.arcsin(edge)) / numpy.pi
        seen = (x > 0.55) & (x < 1.5)  # the plate's other edges hide nothing more of the disc here
        self.assertLess(abs(share - truth)[seen].max(), 0.06)
        self.assertTrue((share[seen] < 0.9).sum() > 3)
        report = json.loads((self.folder / "a.json").read_text())
        self.assertEqual((report["soft_samples"], report["soft_gathered"]), (64, 64))

    def test_glass_colours_the_light(self):
        (self.folder / "glass.mtl").write_text(
            "newmtl glass\nKd 1 0.25 0\nd 0.4\nnewmtl floor\nKd 1 1 1\n"
        )
        (self.folder / "glass.obj").write_text(
            "mtllib glass.mtl\nv -0.5 -0.5 1\nv 0.5 -0.5 1\nv 0.5 0.5 1\nv -0.5 0.5 1\n"
            "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\n"
            "usemtl glass\nf 1 2 3 4\nusemtl floor\nf 5 6 7 8\n"
        )
        self.before = self.names()
        words = ["render", "glass.obj", *LOOK, "--light", "sun:-1,0,1", "--png", "a.png"]
        for more in ([], ["--stage", "shadows:method=map"]):
            self.refused(*words, "--colored-shadows", *more, status=2, says="give --shadows exact")
        colors = {}
        stage = "shadows:colored_shadows=on"
        ways = ("", "--colored-shadows", "--colored-shadows --deferred", f"--stage {stage}")
        for more in ways:
            self.relievo(*words, "--shadows", "exact", *more.split())
            picture = read_png(self.folder / "a.png")[..., :3].astype(int)
            colors[more] = (picture[50, 75], picture[90, 10])  # behind the glass, beside it
        self.assertEqual(colors[""][0].tolist(), colors[""][1].tolist())
        for more in ways[1:]:
            passed, whole = colors[more]
            self.assertEqual(whole.tolist(), colors[""][1].tolist(), more)
            numpy.testing.assert_allclose(passed / whole, [0.6, 0.15, 0.0], atol=0.01, err_msg=more)

    def test_the_colour_of_the_exr_is_shadowed_as_the_picture(self):
        light = "sun:-1,0,1"
        for words, seen in ((["--shadows", "map"], True), ([], False)):
            self.draw("--exr", "a.exr", "--layers", "shadow_0", *words, lights=[light])
            _, channels = self.exr("a.exr")
            self.check_layer(channels["shadow_0.V"], LIGHTS[light])  # made whether seen or not
            shadow, sure = dark(LIGHTS[light])
            self.assertEqual((channels["R"][shadow & sure] == 0).all(), seen)
            self.assertEqual((channels["R"][shadow & sure] > 0.1).all(), not seen)

    def test_a_headlight_hides_its_shadows(self):
        self.draw("--exr", "a.exr", "--layers", "shadow_0", "--shadows", "map")
        _, channels = self.exr("a.exr")
        self.assertEqual(set(channels["shadow_0.V"].ravel()), {1.0})

    def test_a_stage_that_has_nothing_to_do_says_so(self):
        light = ["sun:-1,0,1"]
        done = self.draw("--stage", "shadows:method=warped", "--png", "a.png", lights=light)
        self.assertIn("--stage shadows changed nothing: ", done.stderr)
        # One switch for every stage, and its older name.
        for words in ("shadows", "shadows:enabled=on,method=warped", "shadows:visible=on"):
            done = self.draw("--stage", words, "--png", "b.png", lights=light)
            self.assertNotIn("changed nothing", done.stderr)
            self.assertNotEqual((self.folder / "a.png").read_bytes(),
                                (self.folder / "b.png").read_bytes(), words)
        self.draw("--stage", "tone:exposure=2,enabled=off", "--png", "b.png", lights=light)
        self.assertEqual((self.folder / "a.png").read_bytes(),
                         (self.folder / "b.png").read_bytes())

    def test_the_size_of_the_map(self):
        light = ["sun:-1,0,1"]
        for size in (16, 512):
            self.draw("--shadows", "map", "--shadow-size", size, "--exr", "a.exr", "--layers",
                      "shadow_0", "--report", "a.json", lights=light)  # fmt: skip
            report = json.loads((self.folder / "a.json").read_text())
            stage = {stage["name"]: stage for stage in report["stages"]}["shadows"]
            self.assertTrue(stage["ran"])
            self.assertEqual(stage["bytes"], 4 * size * size)
            _, channels = self.exr("a.exr")
            shadow, sure = dark(LIGHTS[light[0]])
            mismatches = (channels["shadow_0.V"] != numpy.where(shadow, 0, 1)) & sure
            self.assertEqual(mismatches.any(), size == 16, f"map of {size}")
        # Shadows by the stage's own parameter have a size too.
        self.draw("--stage", "shadows:visible=on,bias=2", "--shadow-size", 512, "--report",
                  "a.json", lights=light)  # fmt: skip
        report = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(report["bytes"], 4 * 512**2)
        # Without shadows nothing is held, whatever the size.
        self.draw("--shadows", "off", "--shadow-size", 512, "--report", "a.json", lights=light)
        self.assertEqual(json.loads((self.folder / "a.json").read_text())["bytes"], 0)

    def test_a_tolerance_chooses_the_method_and_a_certificate_proves_the_picture(self):
        light = ["sun:-1,0,1"]
        done = self.draw("--shadow-tolerance", "0.01%", "--certify", 2000, "--report", "a.json",
                         lights=light)  # fmt: skip
        self.assertIn("certified shadows: 0 of 2000 verdicts are wrong", done.stdout)
        self.assertIn("at most 0.15 % with a confidence of 95 %", done.stdout)
        report = json.loads((self.folder / "a.json").read_text())
        self.assertIn("was chosen for a tolerance of 0.01 %", report["shadow_plan"])
        self.assertLessEqual(report["expected_wrong_share"], 1e-4)
        self.assertGreater(report["frame_ms"], 0)
        # A coarse map is found out, with edges across its rows.
        done = self.draw("--shadows", "map", "--shadow-size", 16, "--certify", 20000,
                         lights=["sun:-1,0.5,1"])  # fmt: skip
        mismatches = int(done.stdout.split("certified shadows: ")[1].split()[0])
        self.assertGreater(mismatches, 20)
        done = self.draw("--time-budget", 100000, "--report", "a.json", lights=light)
        report = json.loads((self.folder / "a.json").read_text())
        self.assertIn("exact was chosen for a time of 1e+05 ms", report["shadow_plan"])


if __name__ == "__main__":
    main()
