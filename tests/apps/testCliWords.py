# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Invalid arguments: exit status 2, one line with the option and the value, nothing written."""

import re

from cli import BENCHES, NEEDS_DISPLAY, CliTest, main

# option, value, and further required parts of the message
WRONG_VALUES = [
    ("--size", "800", "WxH"),
    ("--size", "800x", "whole number from 1 to 16384"),
    ("--size", "0x600", "whole number from 1 to 16384"),
    ("--size", "-5x600", "whole number"),
    ("--size", "800x600x3", "WxH"),
    ("--size", "8e2x600", "whole number"),
    ("--size", "99999999999x600", "whole number"),
    ("--camera", "0,0,5", "9 finite numbers"),
    ("--camera", "0,0,5,0,0,0,0,1,up", "9 finite numbers"),
    ("--camera", "0,0,nan,0,0,0,0,1,0", "9 finite numbers"),
    ("--camera", "1,2,3,1,2,3,0,1,0", "focal point"),
    ("--camera", "0,0,5,0,0,0,0,0,1", "up direction"),
    ("--camera", "0,0,5,0,0,0,0,0,0", "up direction"),
    ("--view-angle", "0", "between 0 and 180"),
    ("--view-angle", "180", "between 0 and 180"),
    ("--view-angle", "thirty", "between 0 and 180"),
    ("--parallel-scale", "0", "above 0"),
    ("--parallel-scale", "-1", "above 0"),
    ("--parallel-scale", "inf", "above 0"),
    ("--clip", "1", "2 finite numbers"),
    ("--clip", "0,10", "0 < NEAR < FAR"),
    ("--clip", "10,1", "0 < NEAR < FAR"),
    ("--clip", "1,1", "0 < NEAR < FAR"),
    ("--shading", "toon", "flat, gouraud, phong, pbr"),
    ("--light", "lamp", "sun:"),
    ("--light", "lamp:1,2,3", "sun, spot, point"),
    ("--light", "sun:0,0,0", "direction"),
    ("--light", "sun:1", "3 finite numbers"),
    ("--light", "sun:1,91", "from -90 to 90"),
    ("--light", "spot:0,0,1,0,0,0", "7 finite numbers"),
    ("--light", "spot:0,0,1,0,0,1,30", "focal point"),
    ("--light", "spot:0,0,1,0,0,0,0", "CONE"),
    ("--light", "spot:0,0,1,0,0,0,181", "CONE"),
    ("--light", "point:", "3 finite numbers"),
    ("--light", "sun:0,0,1,size=-1", "0 or more"),
    ("--light", "sun:0,0,1,size=91", "0 to 90"),
    ("--light", "point:1,2,3,color=mud", "#rrggbb"),
    ("--light", "point:1,2,3,color=0.5/2/0", "R/G/B from 0 to 1"),
    ("--light", "sun:1,2,3,intensity=-0.5", "0 or more"),
    ("--light", "sun:1,2,3,intensity=bright", "a finite number"),
    ("--light", "sun:1,2,3,casts=no", "off, on"),
    ("--light", "sun:1,2,3,name=", "a text"),
    ("--light", "sun:1,2,3,hue=4", "size, color, intensity, casts, name"),
    ("--light", "sun:1,2,3,size=1,size=2", "each once"),
    ("--light", "sun:1,2,size=1,3", "NAME=VALUE"),
    ("--light", "sun:2026-06-21T12:00", "2026-06-21T15:30+02:00,48.1,11.6"),
    ("--light", "sun:2026-06-21T1200Z,48,11", "2026-06-21T15:30+02:00"),
    ("--light", "sun:2026-02-29T12:00Z,48,11", "a day of the calendar"),
    ("--light", "sun:2026-06-21T24:01Z,48,11", "from 00:00 to 24:00"),
    ("--light", "sun:2026-06-21T12:60Z,48,11", "from 00:00 to 24:00"),
    ("--light", "sun:2026-06-21T12:00+15:00,48,11", "from -12:00 to +14:00"),
    ("--light", "sun:2026-06-21T12:00Z,91,11", "latitude from -90 to 90"),
    ("--light", "sun:2026-06-21T12:00Z,48,east", "2 finite numbers"),
    ("--fill", "1.5", "a number from 0 to 1"),
    ("--fill", "much", "a number from 0 to 1"),
    ("--shadows", "soft", "off, map, forward, warped, exact"),
    ("--shadows", "warp", "off, map, forward, warped, exact"),
    ("--shadow-size", "0", "whole number from 16"),
    ("--shadow-size", "15", "whole number from 16"),
    ("--size", "16385x600", "whole number from 1 to 16384"),
    ("--shadow-size", "16385", "whole number from 16 to 16384"),
    ("--shadow-size", "1.5", "whole number"),
    ("--soft-shadows", "4097", "whole number from 0 to 4096"),
    ("--shadow-tolerance", "0", "a number between 0 and 1"),
    ("--shadow-tolerance", "2", "a number between 0 and 1"),
    ("--shadow-tolerance", "200%", "a percentage between 0% and 100%"),
    ("--shadow-tolerance", "%", "a percentage between 0% and 100%"),
    ("--shadow-tolerance", "little", "a number between 0 and 1"),
    ("--time-budget", "-3", "a finite number above 0"),
    ("--certify", "0", "whole number from 1"),
    ("--scale-bar", "m" * 40, "a unit in a few letters"),
    ("--scale-bar", "m,lenght=7", "a unit in a few letters, such as mm, or none, optionally"),
    ("--scale-bar", "m,length=0", "a finite number above 0"),
    ("--scale-bar", "m,length=wide", "a finite number above 0"),
    ("--bar", "middle", "right, left, bottom or top"),
    ("--bar", "left,heading=t", "right, left, bottom or top, then optionally ,title=TEXT"),
    ("--figure", "85,300", "WIDTHmm,DPI, such as 85mm,300"),
    ("--figure", "85mm", "WIDTHmm,DPI, such as 85mm,300"),
    ("--figure", "85mm,fine", "a number between 36 and 4800"),
    ("--figure", "85mm,20", "a number between 36 and 4800"),
    ("--up", "w", "x, y, z"),
    ("--reflectivity", "1.5", "R[,ROUGHNESS], both from 0 to 1"),
    ("--reflectivity", "0.5,-1", "both from 0 to 1"),
    ("--reflectivity", "bright", "a finite number"),
    ("--environment", "sky.png,1e999", "a finite number"),
    ("--environment", "sky.xyz", ".png .jpg .jpeg"),
    ("--png", "a.foo", "ends in .png"),
    ("--png", "a", "ends in .png"),
    ("--png", "a.exr", "ends in .png"),
    ("--exr", "a.png", "ends in .exr"),
    ("--layers", "depth,,normal", "names between commas"),
    ("--layers", "shadow_", "shadow_N"),
    ("--layers", "shadow_one", "shadow_N"),
    ("--layers", "shadow_1", "there is 1 light"),
]


class Words(CliTest):
    def test_values(self):
        for option, value, expected in WRONG_VALUES:
            output = ["--report", "a.json"] if option == "--exr" else ["--exr", "a.exr"]
            with self.subTest(option=option, value=value):
                given = value.split(":", 1)[-1] if "sun:" in value else value
                given = given.split("=")[-1]
                given = given.split("x")[0] if option == "--size" else given.split(",")[-1]
                self.refused(
                    "render", "triangle.off", *output, option, value,
                    status=2, says=[option, given, expected],
                )  # fmt: skip

    def test_value_after_equals(self):
        self.refused("render", "triangle.off", "--png", "a.png", "--size=7", status=2,
                     says=["--size", "'7'"])  # fmt: skip

    def test_unknown_option(self):
        done = self.refused("render", "triangle.off", "--sise", "8x8", "--png", "a.png", status=2,
                            says=["--sise", "no such option; did you mean --size",
                                  "relievo render --help"])  # fmt: skip
        self.assertNotIn("8x8", done.stderr)
        self.refused("render", "--no-shadows", status=2, says="did you mean --shadows or")
        self.refused("render", "--quick-and-dirty", status=2,
                     says="relievo render has no such option. See relievo render")  # fmt: skip
        self.refused("render", "-p", "triangle.off", status=2, says="-p: relievo render has no")
        self.refused("bench", "normals", "--png", "a.png", status=2,
                     says=["--png", "bench", "--out"])  # fmt: skip

    def test_missing_value(self):
        self.refused("render", "triangle.off", "--png", status=2, says=["--png", "missing"])
        self.refused("render", "triangle.off", "--png", "--exr", "a.exr", status=2,
                     says=["--png", "missing"])  # fmt: skip
        self.refused("render", "triangle.off", "--png=", status=2, says=["--png", "empty"])

    def test_given_twice(self):
        self.refused("render", "triangle.off", "--png", "a.png", "--png", "b.png", status=2,
                     says=["--png", "twice"])  # fmt: skip

    def test_nothing_to_do(self):
        self.refused(status=2, says=["render", "bench", "--help"])
        self.refused("rendre", "triangle.off", status=2, says=["'rendre'", "render"])
        self.refused("render", "--png", "a.png", status=2, says="FILE")
        self.refused("render", "triangle.off", status=2, says=["--png", "--exr", "--report"])

    def test_contradictions(self):
        self.refused("render", "triangle.off", "--png", "a.png", "--view-angle", "30",
                     "--parallel-scale", "1", status=2,
                     says=["--view-angle", "--parallel-scale"])  # fmt: skip
        self.refused("render", "triangle.off", "--png", "a.png", "--portable", status=2,
                     says=["--portable", "--baseline"])  # fmt: skip
        self.refused("render", "triangle.off", "--baseline", "a.exr", "--portable", "--clip", "1,9",
                     status=2, says=["--portable", "--clip"])  # fmt: skip
        self.refused("render", "triangle.off", "--png", "a.png", "--layers", "depth", status=2,
                     says=["--layers", "--exr"])  # fmt: skip
        self.refused("render", "triangle.off", "--png", "a.png", "--preset", "none", "--fill", "1",
                     status=2, says=["--fill", "none", "--preset"])  # fmt: skip
        self.refused("render", "triangle.off", "--png", "a.png", "--fill", "1", "--environment",
                     "sky.png", environment={"RELIEVO_PRESET": "studio"}, status=2,
                     says=["--fill", "environment", "--preset"])  # fmt: skip

    def test_shadows_of_lights_that_are_not(self):
        lights = ["--light", "sun:0,0,1", "--light", "point:1,2,3"]
        self.refused("render", "triangle.off", "--exr", "a.exr", *lights, "--layers", "shadow_2",
                     status=2,
                     says=["--layers", "'shadow_2'", "shadow_1", "2 --light options"])  # fmt: skip
        self.refused("render", "triangle.off", "--exr", "a.exr", *lights[:2], "--layers",
                     "shadow_0,shadow_1", status=2,
                     says=["--layers", "'shadow_1'", "1 --light option,"])  # fmt: skip

    def test_more_lights_than_shaders_hold(self):
        lights = ["--light", "point:0,0,5"] * 1001
        self.refused("render", "triangle.off", "--png", "a.png", *lights, status=2,
                     says=["--light", "1001", "1000", "--lamps"])  # fmt: skip

    def test_a_size_of_no_shadows(self):
        self.refused("render", "triangle.off", "--png", "a.png", "--shadow-size", "512", status=2,
                     says=["--shadow-size", "--shadows map", "shadow_N"])  # fmt: skip
        self.refused("render", "triangle.off", "--certify", "100", status=2,
                     says=["--certify", "no shadows to judge", "--shadows METHOD"])  # fmt: skip
        self.refused("render", "triangle.off", "--png", "a.png", "--shadow-tolerance", "0.1%",
                     "--shadows", "map", status=2,
                     says=["--shadow-tolerance and --shadows", "one of them"])  # fmt: skip

    def test_shadows_said_in_two_ways(self):
        for words, option, parameter in (
            (["--shadows", "warped", "--stage", "shadows:method=map"], "--shadows", "method"),
            (["--shadows", "off", "--stage", "shadows:visible=on"], "--shadows", "enabled"),
            (["--shadows", "map", "--shadow-size", 64, "--stage", "shadows:map_size=32"],
             "--shadow-size", "map_size"),
            (["--shadow-tolerance", "1%", "--stage", "shadows:tolerance=0.1"],
             "--shadow-tolerance", "tolerance"),
            (["--time-budget", "9", "--stage", "shadows:time_budget=8"], "--time-budget",
             "time_budget"),
        ):  # fmt: skip
            self.refused("render", "triangle.off", "--png", "a.png", *words, status=2,
                         says=[option, f"shadows:{parameter}", "one of them"])
        self.refused("render", "triangle.off", "--png", "a.png", "--ambient", "1", "--stage",
                     "ambient:strength=0.5", status=2,
                     says="--ambient and --stage ambient:strength: both set the same")  # fmt: skip
        self.refused("render", "triangle.off", "--png", "a.png", "--stage", "tone:enabled=perhaps",
                     status=2, says="tone:enabled: 'perhaps' was given, expected on or off")

    def test_unknown_layer(self):
        self.refused("render", "triangle.off", "--exr", "a.exr", "--layers", "depth,detph",
                     status=2,
                     says=["--layers", "'detph'", "geometric_normal", "shadow_N"])  # fmt: skip

    def test_unknown_extension(self):
        (self.folder / "notes.doc").write_text("words")
        self.before = self.names()
        self.refused("render", "notes.doc", "--png", "a.png", status=2, says=["notes.doc", ".vtp"])
        self.refused("render", "triangle", "--png", "a.png", status=2, says=["triangle:", ".off"])

    def test_outputs_in_each_others_way(self):
        self.refused("render", "triangle.off", "--png", "a.png", "--report", "./a.png", status=2,
                     says=["--report", "./a.png", "same file"])  # fmt: skip
        self.refused("render", "triangle.off", "--report", "triangle.off", status=2,
                     says=["--report", "triangle.off", "FILE"])  # fmt: skip

    def test_unknown_bench(self):
        if not BENCHES:
            self.refused("bench", "normals", status=2, says=["bench", "RELIEVO_BUILD_BENCH"])
            return
        self.refused("bench", "speed", status=2, says=["'speed'", "normals", "depth", "position"])
        self.refused("bench", status=2, says=["NAME", "normals"])
        self.refused("bench", "depth", "speed", status=2, says=["'speed'", "normals", "all"])


class Help(CliTest):
    def test_help_knows_every_option(self):
        options = re.findall(r"(?m)^render (--[a-z-]+)", self.relievo("--words").stdout)
        self.assertGreater(len(options), 10)
        page = self.relievo("--help").stdout
        for option in options:
            self.assertRegex(page, rf"(?m)^  {option}( [A-Z]|  )")
        for line in page.splitlines():
            self.assertLessEqual(len(line), 100)
        self.assertEqual(self.relievo("-h").stdout, page)
        # The help of a command is its part of the page.
        for name in ("render", "sun", "stages"):
            own = self.relievo(name, "--none", "--help").stdout
            use, rest = own.removeprefix("relievo ").split("\n", 1)
            self.assertIn(f"\n  relievo {use}\n", page)
            about, more = rest.rsplit("\n\n", 1)
            self.assertTrue(use.startswith(name) and about.lstrip().startswith(f"{name} "), own)
            self.assertIn(about + "\n", page)
            self.assertEqual(more, "relievo --help describes all commands, with examples.\n")
        self.assertIn("  --dates FIRST[:LAST[:EVERY]]", self.relievo("sun", "-h").stdout)

    def test_help_names_every_extension(self):
        (self.folder / "a.doc").write_text("")
        done = self.relievo("render", "a.doc", "--png", "a.png", status=2)
        page = self.relievo("--help").stdout
        for extension in done.stderr.split("one of")[1].split():
            self.assertIn(f"{extension} ", page.replace("\n", " "))

    def test_version(self):
        page = self.relievo("--version").stdout
        self.assertRegex(
            page,
            r"\Arelievo \d+\.\d+\.\d+\nVTK 9\.\d+\.\d+\n"
            r"OpenGL [3-9]\.\d.*\n  vendor .+\n  renderer .+\n"
            r"  numbers of primitives (as written|through a geometry shader|unreliable: .+)\n\Z",
        )
        self.assertNotIn("unknown", page)
        self.assertEqual(self.relievo("render", "a.off", "--version").stdout, page)

    def test_version_without_a_display(self):
        done = self.relievo("--version", environment={"DISPLAY": ""})
        unknown = r"unknown: .*xvfb-run" if NEEDS_DISPLAY else r"[3-9]\.\d"
        self.assertRegex(done.stdout, r"\Arelievo .+\nVTK .+\nOpenGL " + unknown)
        self.assertEqual(done.stderr, "")


if __name__ == "__main__":
    main()
