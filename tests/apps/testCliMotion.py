# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of a moving camera: equal to stills, views as constructed here, films read by ffmpeg."""

import json
import math
import os
import random
import shutil
import subprocess
import unittest

import numpy

from cli import CliTest, main, read_png

# A block that looks different from all sides, and the corners of its bounds.
BLOCK = """OFF
8 6 0
-1 -0.5 -2  1 -0.5 -2  1 0.5 -2  -1 0.5 -2  -1 -0.5 2  1 -0.5 2  0.2 0.3 1  -1 0.5 2
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 3 7 6 2
4 1 2 6 5
4 0 4 7 3
"""
PLAIN = ["--preset", "none", "--size", "48x36"]
CORNERS = numpy.array([(x, y, z) for x in (-1, 1) for y in (-0.5, 0.5) for z in (-2, 2)])


def camera(position, focus=(0, 0, 0), up=(0, 1, 0)):
    return ",".join(map(repr, map(float, (*position, *focus, *up))))


def write_path(path, keys):
    """keys: time, position, focal point, up."""
    names = ("time", "position", "focal_point", "view_up")
    path.write_text(json.dumps({"keys": [dict(zip(names, key)) for key in keys]}))


class Motion(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "block.off").write_text(BLOCK)
        self.before = self.names()

    def draw(self, *words, **more):
        return self.relievo("render", "block.off", *PLAIN, *words, **more)

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def check_still(self, name, position, focus=(0, 0, 0), up=(0, 1, 0), words=()):
        self.draw(*words, "--camera", camera(position, focus, up), "--png", "still.png")
        self.assertEqual(self.bytes_of("still.png"), self.bytes_of(name), name)

    def views(self, count, name="v%d.json"):
        """Eye, direction of view and up of each frame, from its report."""
        views = []
        for i in range(count):
            found = json.loads((self.folder / (name % i)).read_text())["camera"]
            r, t = numpy.array(found["R"]).reshape(3, 3), numpy.array(found["t"])
            views.append((-r.T @ t, r[2], -r[1], numpy.array(found["K"]).reshape(3, 3)))
        return views

    def test_a_turn_by_quarters(self):
        start = ("--camera", camera((3, 2, 7)))
        self.draw(*start, "--turntable", 4, "--png", "f%d.png")
        # Counter-clockwise seen from above: from +z towards +x.
        places = ((3, 2, 7), (7, 2, -3), (-3, 2, -7), (-7, 2, 3))
        for i, place in enumerate(places):
            self.check_still(f"f{i}.png", place)
        self.assertEqual(len({self.bytes_of(f"f{i}.png") for i in range(4)}), 4)
        # The lights of a preset stay with the scene.
        preset = ("--preset", "print", "--stage", "antialias:samples=1")
        self.relievo("render", "block.off", "--size", "48x36", *preset, *start, "--turntable", 2,
                     "--png", "p%d.png")  # fmt: skip
        self.relievo("render", "block.off", "--size", "48x36", *preset, "--camera",
                     camera(places[2]), "--png", "still.png")  # fmt: skip
        self.assertEqual(self.bytes_of("still.png"), self.bytes_of("p1.png"))

    def test_a_fitted_turn_sees_everything(self):
        self.relievo("render", "block.off", "--size", "48x36", "--preset", "print", "--stage",
                     "antialias:samples=1", "--turntable", 6, "--report", "v%d.json")  # fmt: skip
        views = self.views(6)
        for eye, forward, up, k in views:
            distance = numpy.linalg.norm(views[0][0])
            self.assertAlmostEqual(numpy.linalg.norm(eye), distance, places=9)
            right = numpy.cross(forward, up)
            seen = (CORNERS - eye) @ numpy.array([right, -up, forward]).T @ k.T
            pixels = seen[:, :2] / seen[:, 2:]
            self.assertTrue((pixels > 0.05 * numpy.array([48, 36])).all(), pixels)
            self.assertTrue((pixels < 0.95 * numpy.array([48, 36])).all(), pixels)
        angles = [math.degrees(math.atan2(eye[0], eye[2])) for eye, *_ in views]
        for i, angle in enumerate(angles):
            self.assertAlmostEqual((angle - angles[0]) % 360, 60 * i, places=6)

    def test_a_turn_around_a_point(self):
        (self.folder / "point.ply").write_text(
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n1 2 3\n")  # fmt: skip
        self.relievo("render", "point.ply", *PLAIN, "--point-size", 9, "--turntable", 2,
                     "--report", "v%d.json")  # fmt: skip
        eyes = [eye - (1, 2, 3) for eye, *_ in self.views(2)]
        self.assertGreater(numpy.linalg.norm(eyes[0]), 1)
        numpy.testing.assert_allclose(eyes[1], eyes[0] * (-1, 1, -1), atol=1e-9)

    def test_a_path_through_its_keys(self):
        keys = [(0, (3, 2, 7), (0, 0, 0), (0, 1, 0)), (0.2, (6, 1, 2), (0.3, 0, 0), (0, 1, 0.2)),
                (0.5, (2, 3, -6), (0, 0.1, 0), (0.1, 1, 0))]  # fmt: skip
        write_path(self.folder / "path.json", keys)
        self.draw("--camera-path", "path.json", "--fps", 10, "--png", "f%d.png")
        self.assertIn("f5.png", self.names())
        self.assertNotIn("f6.png", self.names())
        for time, *view in keys:
            self.check_still(f"f{round(10 * time)}.png", *view)
        rows = ["time,px,py,pz,fx,fy,fz,ux,uy,uz"]
        rows += [",".join(map(str, (time, *sum(view, ())))) for time, *view in keys]
        (self.folder / "path.csv").write_text("\n".join(rows))
        self.draw("--camera-path", "path.csv", "--fps", 10, "--png", "c%d.png")
        for i in range(6):
            self.assertEqual(self.bytes_of(f"c{i}.png"), self.bytes_of(f"f{i}.png"))

    def test_a_closed_circle(self):
        """Eight views on a circle: the distance is kept, the turn is even, also at the end."""
        radius, every = 5.0, 45
        keys = [(i, (radius * math.sin(math.radians(every * i)), 0,
                     radius * math.cos(math.radians(every * i))), (0, 0, 0), (0, 1, 0))
                for i in range(8)]  # fmt: skip
        write_path(self.folder / "path.json", [*keys, (8, *keys[0][1:])])
        self.draw("--camera-path", "path.json", "--fps", 4, "--report", "v%d.json")
        views = self.views(32)
        self.assertNotIn("v32.json", self.names())
        for i, (eye, _, up, _) in enumerate(views):
            self.assertAlmostEqual(numpy.linalg.norm(eye), radius, places=9)
            numpy.testing.assert_allclose(up, (0, 1, 0), atol=1e-9)
            turned = math.degrees(math.atan2(eye[0], eye[2])) - every / 4 * i
            self.assertLess(abs((turned + 180) % 360 - 180), 0.5, i)

    def test_up_never_overshoots(self):
        """It tilts between two keys and rests at the others, and a resting view does not move."""
        ups = [(0, 1, 0), (0, 1, 0), (0.6, 0.8, 0), (0.6, 0.8, 0)]
        keys = [(i, (i if i < 3 else 2, 0, 9), (i if i < 3 else 2, 0, 0), up)
                for i, up in enumerate(ups)]  # fmt: skip
        write_path(self.folder / "path.json", keys)
        self.draw("--camera-path", "path.json", "--fps", 5, "--report", "v%d.json")
        views = self.views(16)
        tilts = [math.degrees(math.atan2(up[0], up[1])) for _, _, up, _ in views]
        limit = math.degrees(math.atan2(0.6, 0.8))
        numpy.testing.assert_allclose(tilts[:6], 0, atol=1e-9)
        numpy.testing.assert_allclose(tilts[10:], limit, atol=1e-9)
        self.assertEqual(tilts, sorted(tilts))
        along = [eye[0] for eye, *_ in views]
        numpy.testing.assert_allclose(along[:6], numpy.arange(6) / 5, atol=1e-9)  # even
        numpy.testing.assert_allclose(along[10:], 2, atol=1e-9)

    def test_frames_are_kept(self):
        words = ("--camera", camera((3, 2, 7)), "--turntable", 4, "--png", "f%d.png")
        self.draw(*words)
        whole = [self.bytes_of(f"f{i}.png") for i in range(4)]
        (self.folder / "f1.png").unlink()
        (self.folder / "f2.png").write_bytes(b"kept")
        done = self.draw(*words, "--resume")
        self.assertEqual(self.bytes_of("f1.png"), whole[1])
        self.assertEqual(self.bytes_of("f2.png"), b"kept")
        self.assertIn("--resume: 3 of 4 frames", done.stderr)
        self.draw(*words)
        self.assertEqual(self.bytes_of("f2.png"), whole[2])

    def test_without_ffmpeg(self):
        done = self.draw("--camera", camera((3, 2, 7)), "--turntable", 3, "--video", "a.mp4",
                         environment={"PATH": str(self.folder)})  # fmt: skip
        self.assertIn("ffmpeg is not installed: the frames are in a_0000.png", done.stderr)
        self.assertEqual(set(self.names()) - set(self.before), {f"a_000{i}.png" for i in range(3)})
        self.check_still("a_0000.png", (3, 2, 7))
        self.before = self.names()
        self.refused("render", "block.off", *PLAIN, "--turntable", 3, "--video", "b%d.mp4",
                     status=2, says=["--video b%d.mp4", "not installed", "--png F"],
                     environment={"PATH": str(self.folder)})  # fmt: skip

    def fake_ffmpeg(self, script):
        """An environment in which ffmpeg is this script."""
        fake = self.folder / "bin"
        fake.mkdir(exist_ok=True)
        (fake / "ffmpeg").write_text("#!/bin/sh\n" + script)
        (fake / "ffmpeg").chmod(0o755)
        return {"PATH": f"{fake}:{os.environ['PATH']}"}

    def test_frames_of_films(self):
        """ffmpeg gets the pixels of the stills, from the top left, and the name of a file."""
        environment = self.fake_ffmpeg(
            'for last; do :; done\ncase $last in file:*) cat > "${last#file:}";; esac\n')
        words = ("--camera", camera((3, 2, 7)), "--turntable", 3)
        self.draw(*words, "--png", "f%d.png", "--video", "a.mkv", environment=environment)
        stills = b"".join(read_png(self.folder / f"f{i}.png").tobytes() for i in range(3))
        self.assertEqual(len(stills), 3 * 48 * 36 * 3)
        self.assertEqual(self.bytes_of("a.mkv"), stills)
        (self.folder / "f1.png").unlink()
        self.draw(*words, "--png", "f%d.png", "--video", "b.mkv", "--resume",
                  environment=environment)  # fmt: skip
        self.assertEqual(self.bytes_of("b.mkv"), stills)
        self.draw(*words, "--video", "c.mp4", environment=environment)
        self.assertEqual(self.bytes_of("c.mp4"), stills)

    def test_frames_in_parts(self):
        """Frames and film of processes in a drawn order are those of one process."""
        environment = self.fake_ffmpeg(
            'for last; do :; done\ncase $last in file:*) cat > "${last#file:}";; esac\n')
        words = ("--camera", camera((3, 2, 7)), "--turntable", 5, "--fps", 5, "--png", "f%d.png",
                 "--report", "r%d.json", "--video", "a.mkv")  # fmt: skip
        names = [*(f"f{i}.png" for i in range(5)), "a.mkv"]
        self.draw(*words, environment=environment)
        whole = {name: self.bytes_of(name) for name in names}
        for name in names:
            (self.folder / name).unlink()
        draw = random.Random(45)
        count = draw.randint(2, 7)  # more than frames: some parts have none
        parts = draw.sample(range(1, count + 1), count)
        self.kill(lambda: list(self.folder.glob("*.png")), draw.uniform(0, 0.01), "render",
                  "block.off", *PLAIN, *words, "--part", f"{parts[0]}/{count}")  # fmt: skip
        for part in parts[:-1]:
            self.draw(*words, "--part", f"{part}/{count}", whole=True)
        self.assertIn("missing", self.relievo("verify", "a.mkv.parts", status=3).stdout)
        self.relievo("merge", "a.mkv.parts", status=1, environment=environment)
        self.draw(*words, "--part", f"{parts[-1]}/{count}", whole=True)
        self.assertIn("5 of 5 frames", self.relievo("status", "a.mkv.parts").stdout)
        self.assertFalse((self.folder / "a.mkv").exists())
        done = self.draw(*words, "--part=1/1", whole=True)
        self.assertIn("is complete", done.stdout)
        damaged = f"f{draw.randrange(5)}.png"
        (self.folder / damaged).write_bytes(whole[damaged][:-1])
        said = self.relievo("verify", "a.mkv.parts", status=3).stdout
        self.assertIn(f"1 damaged: {damaged[1]} ({damaged})", said)
        self.relievo("merge", "a.mkv.parts", status=1, environment=environment)
        done = self.draw(*words, "--part", "1/1", whole=True)
        self.assertIn("written, 1 frames", done.stdout)
        self.assertIn("a.mkv is missing", self.relievo("verify", "a.mkv.parts", status=3).stdout)
        self.relievo("merge", "a.mkv.parts", environment=environment)
        for name in names:
            self.assertEqual(self.bytes_of(name), whole[name], name)
        self.relievo("verify", "a.mkv.parts")
        done = self.draw(*words, "--shading", "flat", "--part", "1/2", status=2, whole=True)
        self.assertIn("was begun with words", done.stderr)
        usual = ("--size", "16x12", "--turntable", 2, "--png", "h%d.png", "--part", "1/2")
        for preset, status in (("none", 0), ("none", 0), ("studio", 2)):
            done = self.relievo("render", "block.off", *usual, status=status, whole=True,
                                environment={"RELIEVO_PRESET": preset})  # fmt: skip
        self.assertIn("preset", done.stderr)
        settings = self.folder / "a.mkv.parts" / "frames.json"
        kept = settings.read_text()
        for before, now in (('"a.mkv"', '"b.mkv"'), ('"a.mkv"', '"../a.mkv"'),
                            ('"f%d.png"', '"x/../../f%d.png"')):  # fmt: skip
            settings.write_text(kept.replace(before, now))  # as in a folder from elsewhere
            done = self.relievo("merge", "a.mkv.parts", status=1, environment=environment)
            self.assertIn("does not describe frames", done.stderr)
        settings.write_text(kept)
        self.draw(*words[:4], "--png", "g%d.png", "--part", "2/2", whole=True)
        self.assertEqual({name for name in self.names() if name[0] == "g"},
                         {"g3.png", "g4.png", "g.png.parts"})  # fmt: skip
        for i in (3, 4):
            self.assertEqual(self.bytes_of(f"g{i}.png"), whole[f"f{i}.png"])

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_films(self):
        words = ("--camera", camera((3, 2, 7)), "--turntable", 4, "--fps", 5)
        self.draw(*words, "--png", "f%d.png", "--video", "a.mkv")
        stills = [read_png(self.folder / f"f{i}.png") for i in range(4)]
        (self.folder / "f1.png").unlink()
        self.draw(*words, "--png", "f%d.png", "--video", "b.mkv", "--resume")
        for name in ("a.mkv", "b.mkv"):
            numpy.testing.assert_array_equal(self.frames(name), stills)
        self.draw(*words, "--video", "a.mp4")
        off = numpy.abs(self.frames("a.mp4").astype(float) - stills)
        self.assertLess(off.mean(), 2)  # of 255; H.264 stores colours at half the resolution
        self.assertNotIn("a_0000.png", self.names())

    def frames(self, name):
        """The frames as ffmpeg decodes them, and the film's rate as it reports it."""
        done = subprocess.run(["ffmpeg", "-i", name, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                              cwd=self.folder, capture_output=True, check=True)  # fmt: skip
        self.assertIn(b" 5 fps", done.stderr)
        return numpy.frombuffer(done.stdout, numpy.uint8).reshape(-1, 36, 48, 3)

    def test_a_film_that_cannot_be_written(self):
        (self.folder / "a.mkv").write_text("old")
        full = "No space left on device"
        for script, says in (
            ("echo unknown codec >&2\nexit 1\n", "unknown codec"),
            # Of ffmpeg 5.1, whose exit status is 0.
            (f"cat >/dev/null\necho 'Error writing trailer of x: {full}' >&2\n", full),
        ):
            environment = self.fake_ffmpeg(script)
            self.before = self.names()
            self.refused("render", "block.off", *PLAIN, "--turntable", 2, "--video", "a.mkv",
                         status=1, says=[f"a.mkv: ffmpeg cannot write it: {says}"],
                         environment=environment)  # fmt: skip
            self.assertEqual((self.folder / "a.mkv").read_text(), "old")
        # Other messages, such as those of the system's loader, are no failure.
        harmless = ('echo libx: no version information >&2\ncat >/dev/null\n'
                    'for last; do :; done\necho new >"${last#file:}"\n')
        self.draw("--turntable", 2, "--video", "a.mkv", environment=self.fake_ffmpeg(harmless))
        self.assertEqual((self.folder / "a.mkv").read_text(), "new\n")

    def test_wrong_words(self):
        write_path(self.folder / "path.json", [(0, (0, 0, 5), (0, 0, 0), (0, 1, 0)),
                                               (1, (0, 0, -5), (0, 0, 0), (0, 1, 0))])  # fmt: skip
        write_path(self.folder / "late.json", [(1, (0, 0, 5), (0, 0, 0), (0, 1, 0)),
                                               (1, (0, 1, 5), (0, 0, 0), (0, 1, 0))])  # fmt: skip
        write_path(self.folder / "long.json", [(0, (0, 0, 5), (0, 0, 0), (0, 1, 0)),
                                               (1e9, (0, 1, 5), (0, 0, 0), (0, 1, 0))])  # fmt: skip
        (self.folder / "no.json").write_text("[1]")
        self.before = self.names()
        turn, path = ("--turntable", 4), ("--camera-path", "path.json")
        for words, says in (
            ((*turn, "--png", "a.png"), ["a.png", "%d", "--turntable"]),
            ((*turn, *path, "--png", "a%d.png"), ["--turntable and --camera-path"]),
            ((*path, "--camera", camera((0, 0, 5)), "--png", "a%d.png"), ["--camera and"]),
            ((*turn, "--video", "a.avi"), ["'a.avi'", ".mp4", ".mkv"]),
            (("--video", "a.mp4"), ["--video", "one frame", "--turntable"]),
            (("--png", "a.png", "--resume"), ["--resume", "one frame"]),
            ((*turn, "--video", "a.mp4", "--resume"), ["--resume", "--png"]),
            (("--png", "a.png", "--part", "1/2"), ["--part", "one frame", "--turntable"]),
            ((*turn, "--png", "a%d.png", "--part", "3/2"), ["--part", "3/2"]),
            ((*turn, "--png", "a%d.png", "--part", "1/2", "--resume"), ["--part and --resume"]),
            ((*turn, "--png", "a%d.png", "--part", "1/2", "--part", "2/2"),
             ["--part: given twice"]),
            ((*turn, "--video", "a.mp4", "--part", "1/2"), ["--part", "--png"]),
            ((*turn, "--exr", "a%d.exr", "--layers", "flow", "--part", "1/2"), ["--part", "flow"]),
            ((*turn, "--png", "a%d.png", "--exr", "../a%d.exr", "--part", "1/2"),
             ["--part", "../a%d.exr"]),
            ((*turn, "--png", "a%d.png", "--fps", 5), ["--fps"]),
            ((*turn, "--video", "a.mp4", "--transparent", "--png", "a%d.png"), ["--transparent"]),
            (("--turntable", 1, "--png", "a%d.png"), ["--turntable", "'1'", "2"]),
            ((*turn, "--certify", 9, "--shadows", "map", "--light", "sun:1,1,1"),
             ["--certify", "--turntable"]),
            ((*path, "--png", "a%d.png"), ["path.json: key 2", "180 degrees"]),
            (("--camera-path", "late.json", "--png", "a%d.png"), ["key 2", "not after"]),
            (("--camera-path", "long.json", "--png", "a%d.png"),
             ["--camera-path", "25000000001 frames", "1 to 1000000"]),
            (("--camera-path", "no.json", "--png", "a%d.png"), ["no.json", '"focal_point"']),
        ):
            with self.subTest(words=words):
                self.refused("render", "block.off", *PLAIN, *words, status=2, says=says,
                             whole="--part" in words)  # fmt: skip
        self.refused("render", "block.off", *PLAIN, "--camera-path", "gone.json", "--png",
                     "a%d.png", status=1, says="gone.json")  # fmt: skip


if __name__ == "__main__":
    main()
