# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""`relievo dataset`: objects of files, poses in words and files, processes that share the work,
and refused words."""

import filecmp
import json
import os
import random
import shutil
import signal
import subprocess
import time

import numpy

from cli import RELIEVO, CliTest, main, read_png

PLATE = "OFF\n4 1 0\n{0} {0} {1}\n-{0} {0} {1}\n-{0} -{0} {1}\n{0} -{0} {1}\n4 0 1 2 3\n"
SMALL = ["--size", "40x30", "--shadows", "map"]


class Dataset(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "near.off").write_text(PLATE.format(1, 0.5))
        (self.folder / "far.off").write_text(PLATE.format(2, -0.5))
        self.before = self.names()

    def dataset(self, out, *words, **more):
        return self.relievo("dataset", "near.off", "far.off", "--out", out, *SMALL, *words, **more)

    def json(self, *names):
        return json.loads(self.folder.joinpath(*names).read_text())

    def check_same(self, one, other):
        names = [
            sorted(str(path.relative_to(self.folder / top))
                   for path in (self.folder / top).rglob("*") if path.is_file())
            for top in (one, other)
        ]  # fmt: skip
        self.assertEqual(*names)
        _, differ, lost = filecmp.cmpfiles(self.folder / one, self.folder / other, names[0], False)
        self.assertEqual((differ, lost), ([], []))

    def test_poses_of_a_file(self):
        """The pixels of plates whose edges lie between pixels are known."""
        pose = {"K": [[20, 0, 19.5], [0, 20, 14.5], [0, 0, 1]],
                "R": [1, 0, 0, 0, -1, 0, 0, 0, -1], "t": [0, 0, 4.5]}  # fmt: skip
        aside = {"position": [3, 0, 4], "target": [0, 0, 0]}
        (self.folder / "poses.json").write_text(json.dumps([pose, aside]))
        done = self.dataset("set", "--poses", "poses.json", "--layers", "depth,normal")
        self.assertEqual(done.stdout, "set: 2 of 2 views written\n")
        self.assertEqual(self.json("set", "dataset.json")["objects"], ["near", "far"])
        masks = [read_png(self.folder / "set" / kind / f"000000_00000{i}.png")[..., 0] > 0
                 for kind in ("mask_visib", "mask") for i in (0, 1)]  # fmt: skip
        v, u = numpy.mgrid[:30, :40]
        near, far = (
            (numpy.abs(u - 19.5) < 20 * half / z) & (numpy.abs(v - 14.5) < 20 * half / z)
            for half, z in ((1, 4), (2, 5))
        )
        for found, expected in zip(masks, (near, far & ~near, near, far)):
            numpy.testing.assert_array_equal(found, expected)
        scale = self.json("set", "scene_camera.json")["0"]["depth_scale"]
        depth = read_png(self.folder / "set" / "depth" / "000000.png")[..., 0]
        expected = numpy.where(near, 4000, numpy.where(far, 5000, 0))
        self.assertLessEqual(numpy.abs(depth * scale - expected).max(), 0.51 * scale)
        _, channels = self.exr("set/layers/000000.exr")
        numpy.testing.assert_allclose(channels["depth.Z"][near], 4, rtol=1e-6)
        self.assertIn("normal.X", channels)
        info = self.json("set", "scene_gt_info.json")["0"]
        self.assertEqual([each["bbox_obj"] for each in info], [[15, 10, 10, 10], [12, 7, 16, 16]])
        self.assertEqual(info[1]["px_count_visib"], 16 * 16 - 10 * 10)

    def test_lens(self):
        """Pixels of a barrel's plates by Brown and Conrady's formula; a file's size and K."""
        k1, k2 = -0.2, 0.05
        (self.folder / "camera.yml").write_text(
            "image_width: 41\nimage_height: 31\ndistortion_model: plumb_bob\n"
            "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [20, 0, 20, 0, 20, 15, 0, 0, 1]\n"
            f"distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [{k1}, {k2}, 0, 0, 0]\n")
        pose = {"R": [1, 0, 0, 0, -1, 0, 0, 0, -1], "t": [0, 0, 4.5]}
        (self.folder / "poses.json").write_text(json.dumps([pose]))
        self.relievo("dataset", "near.off", "far.off", "--out", "set", "--poses", "poses.json",
                     "--lens", "camera.yml", "--shadows", "map")  # fmt: skip
        self.assertEqual(self.json("set", "scene_camera.json")["0"]["distortion"][:2], [k1, k2])
        near = read_png(self.folder / "set" / "mask_visib" / "000000_000000.png")[..., 0] > 0
        self.assertEqual(near.shape, (31, 41))
        # The rays by a fixed point of the formula.
        v, u = numpy.mgrid[:31, :41]
        bent = numpy.stack([(u - 20) / 20, (v - 15) / 20])
        straight = bent.copy()
        for _ in range(200):
            r = (straight**2).sum(axis=0)
            straight = bent / (1 + k1 * r + k2 * r * r)
        inside = 4 * numpy.abs(straight).max(axis=0)
        sure = numpy.abs(inside - 1) > 1e-6
        numpy.testing.assert_array_equal(near[sure], (inside < 1)[sure])
        self.assertGreater(near.sum(), 50)

    def test_names(self):
        """Each file is an object of its own, whatever the files are called."""
        for name in ("a", "b"):
            (self.folder / name).mkdir()
            (self.folder / name / "m.off").write_text(PLATE.format(1, 0.5))
        (self.folder / "m_2.off").write_text(PLATE.format(1, 0))
        self.relievo("dataset", "a/m.off", "b/m.off", "m_2.off", "--poses", "orbit:1", "--out",
                     "set", *SMALL)  # fmt: skip
        self.assertEqual(self.json("set", "dataset.json")["objects"], ["m", "m_2", "m_2_2"])

    def test_depth_beyond_the_last_step(self):
        done = self.dataset("set", "--poses", "orbit:1", "--depth-step", "1e-5")
        self.assertRegex(done.stderr, r"^relievo: warning: set: \d+ pixels are farther than 65535")
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertFalse(read_png(self.folder / "set" / "depth" / "000000.png").any())

    def test_goes_on_and_shares(self):
        """Ended by a signal and gone on with, or by two processes at once: the same bytes."""
        words = ["--poses", "random:12", "--seed", "3", "--random-sun", "--format", "coco",
                 "--shadow-size", "256"]  # fmt: skip
        self.dataset("whole", *words)
        command = [RELIEVO, "dataset", "near.off", "far.off", *SMALL, *words, "--out"]
        for _ in range(20):  # a run that was faster than the signal is run again
            shutil.rmtree(self.folder / "broken", ignore_errors=True)
            one = subprocess.Popen([*command, "broken"], cwd=self.folder, stderr=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL)  # fmt: skip
            while (one.poll() is None
                   and not (self.folder / "broken" / "views" / "000001.json").exists()):
                time.sleep(0.001)
            one.send_signal(signal.SIGINT)
            if one.wait() != 0 and not (self.folder / "broken" / "instances.json").exists():
                break
        self.assertEqual(one.returncode, -signal.SIGINT)
        self.assertFalse((self.folder / "broken" / "instances.json").exists())
        self.assertFalse([name for name in self.names() if name.endswith(".tmp")])
        done = self.dataset("broken", *words)
        self.assertRegex(done.stdout, r"broken: \d+ of 12 views written, \d+ were there\n")
        self.check_same("whole", "broken")
        shares = [
            subprocess.Popen([*command, "shared", "--views", views], cwd=self.folder,
                             stdout=subprocess.DEVNULL)
            for views in ("0:5", "5:12")
        ]  # fmt: skip
        self.assertEqual([each.wait() for each in shares], [0, 0])
        self.check_same("whole", "shared")
        self.refused_in("whole", *words[:2], "--seed", "4", "--format", "coco",
                        says=["whole: was begun with", "give another folder"])  # fmt: skip
        self.check_parts(command[4:-1])
        self.check_models()
        self.check_shards()
        self.check_splits()

    def check_models(self):
        """A damaged model is found, and written again by the part of the first view."""
        words = ["--poses", "orbit:2", "--format", "bop"]
        self.dataset("whole-bop", *words)
        for part in ("1/2", "2/2"):
            self.dataset("parts", *words, "--part", part)
        self.relievo("merge", "parts")
        model = self.folder / "parts" / "models" / "obj_000002.ply"
        model.write_bytes(model.read_bytes()[:-1])
        self.assertIn("1 damaged: 0 (models/obj_000002.ply)", self.verify())
        self.dataset("parts", *words, "--part", "1/2")
        shutil.rmtree(self.folder / "parts" / "progress")
        self.relievo("verify", "parts")
        self.check_same("whole-bop", "parts")
        shutil.rmtree(self.folder / "parts")

    def check_shards(self):
        """Archives of parts, which are set by the size of samples, are those of one process."""
        words = ["--poses", "orbit:5", "--format", "webdataset", "--shard-size", "0.01"]
        self.dataset("whole-shards", *words)
        for part in ("2/2", "1/2"):
            self.dataset("parts", *words, "--part", part)
        self.relievo("merge", "parts")
        self.relievo("verify", "parts")
        self.check_same("whole-shards", "parts")
        self.assertEqual(self.json("parts", "dataset.json")["shard_size"], 0.01)
        self.assertNotIn("shard_size", self.json("whole", "dataset.json"))
        shutil.rmtree(self.folder / "parts")

    def check_splits(self):
        """Views for validation and categories are those of one process after parts are merged."""
        words = ["--poses", "orbit:5", "--format", "yolo", "--validation", "0.4", "--category",
                 "block=n*r,far"]  # fmt: skip
        self.dataset("whole-yolo", *words)
        for part in ("2/2", "1/2"):
            self.dataset("parts", *words, "--part", part)
        self.assertIn("data.yaml is missing", self.verify())
        self.relievo("merge", "parts")
        self.relievo("verify", "parts")
        self.check_same("whole-yolo", "parts")
        self.assertEqual(len(list((self.folder / "parts" / "labels" / "val").iterdir())), 2)
        names = (self.folder / "parts" / "data.yaml").read_text().split("names:\n")[1]
        self.assertEqual(names, '  0: "block"\n')
        # A folder that was begun without these settings has none.
        settings = self.folder / "parts" / "dataset.json"
        old = self.json("parts", "dataset.json")
        del old["categories"], old["validation"]
        settings.write_text(json.dumps(old))
        self.assertIn("5 of another version or other settings", self.verify())

    def check_parts(self, words):
        """The views in parts, some of them ended by a signal; then with damaged files."""
        draw = random.Random(45)
        count = draw.randint(3, 5)
        parts = draw.sample(range(1, count + 1), count)
        for part in parts:
            given = [RELIEVO, "dataset", "near.off", "far.off", *words, "--out", "parts", "--part",
                     f"{part}/{count}"]  # fmt: skip
            if part == parts[1]:
                killed = subprocess.Popen(given, cwd=self.folder, stdout=subprocess.DEVNULL)
                records = self.folder / "parts" / "views"
                count_before = len(list(records.iterdir()))
                while killed.poll() is None and len(list(records.iterdir())) == count_before:
                    time.sleep(0.001)
                killed.send_signal(signal.SIGKILL)
                killed.wait()
            done = subprocess.run(given, cwd=self.folder, text=True, check=True,
                                  stdout=subprocess.PIPE)  # fmt: skip
            self.assertIn(f"parts: part {part} of {count}: ", done.stdout)
        self.assertFalse((self.folder / "parts" / "instances.json").exists())
        self.assertIn("instances.json is missing", self.verify())
        record, picture = (self.folder / "parts" / name
                           for name in ("views/000002.json", "images/000007.png"))  # fmt: skip
        kept = record.read_bytes()
        record.unlink()
        picture.write_bytes(picture.read_bytes()[:-1])
        said = self.verify()
        self.assertIn("10 of 12 views complete\n  1 missing: 2\n  1 damaged: 7 (images/000007.png)",
                      said)  # fmt: skip
        self.relievo("merge", "parts", status=1)
        changed = {**json.loads(kept), "version": "0.0.1"}
        record.write_text(json.dumps(changed))
        self.assertIn("1 of another version or other settings: 2", self.verify())
        changed["files"] = {"../near.off": "0" * 32}
        record.write_text(json.dumps(changed))
        self.assertIn("2 (../near.off)", self.verify())
        record.write_text("[")
        self.assertIn("2 (its record)", self.verify())
        record.unlink()
        killed = self.folder / "parts" / "views" / ".relievo-0123456789abcdef.tmp"
        killed.write_text("of a part that was killed while it wrote")
        self.dataset("parts", *words[len(SMALL):], "--part", "1/1")
        self.relievo("merge", "parts")
        self.relievo("verify", "parts")
        self.check_same("whole", "parts")
        shutil.rmtree(self.folder / "parts")

    def verify(self):
        return self.relievo("verify", "parts", status=3).stdout

    def refused_in(self, out, *words, says):
        done = self.dataset(out, *words, status=2)
        for text in says:
            self.assertIn(text, done.stderr)

    def test_refusals(self):
        for words, says in (
            (["--out", "set"], "--poses orbit:N"),
            (["--poses", "orbit:4"], "--out DIR"),
            (["--poses", "orbit:1:0", "--out", "set"],
             "--poses orbit:1:0, number of views: got '1:0', expected a whole number from 1"),
            (["--poses", "orbit", "--out", "set"],
             "--poses: got 'orbit', expected orbit:N, random:N or a FILE.json"),
            (["--poses", "random:4,nearest=2", "--out", "set"],
             "--poses random:4,nearest=2: nearest is above farthest"),
            (["--poses", "orbit:4", "--out", "set", "--camera", "0,0,5,0,0,0,0,1,0"],
             "--camera: is an option of relievo render; for a data set, --poses sets"),
            (["--poses", "orbit:4", "--out", "set", "--seed=1", "--seed=2"], "given twice"),
            (["--poses", "orbit:4", "--out", "set", "--lens", "fish"], "--lens: "),
            (["--poses", "orbit:4", "--out", "set", "--lens", "orthographic"],
             "as in orthographic:100"),
            (["--poses", "orbit:4", "--out", "set", "--lens", "cube"], "six times as wide"),
            (["--poses", "orbit:4", "--out", "set", "--lens", "equirectangular"],
             "equirectangular, which has no K; expected the format coco, npz, yolo or webdataset"),
            (["--poses", "orbit:4", "--out", "set", "--lens", "fisheye", "--grid"], "--grid"),
            (["--poses", "orbit:4", "--out", "set", "--format", "voc"], "bop, coco, nerf, npz"),
            (["--poses", "orbit:4", "--out", "set", "--views", "3"], "A:B"),
            *((["--poses", "orbit:4", "--out", "set", "--format", "yolo", "--category", value],
               f"--category: got '{value}', expected a category and names of objects")
              for value in ("mug", "=near", "mug=", "mug=near,,far")),
            (["--poses", "orbit:4", "--out", "set", "--views", "3:5"],
             "--views: got '3:5', expected views from 0 to 4"),
            *((["--poses", "orbit:4", "--out", "set", "--views", views],
               f"--views: got '{views}', expected the first view to be before the end")
              for views in ("5:3", "2:2")),
            (["--poses", "orbit:4", "--out", "set", "--depth-step", "-1"], "--depth-step"),
        ):
            with self.subTest(words):
                self.refused("dataset", "near.off", *words, status=2, says=says)
        self.refused("dataset", "--poses", "orbit:4", "--out", "set", status=2, says="no FILE")
        self.refused("dataset", "near.off", "--poses", "orbit:4", "--out", "set", "--lens",
                     "none.yml", status=1, says="none.yml")  # fmt: skip
        self.refused("dataset", "near.off", "--poses", "none.json", "--out", "set", status=1,
                     says="none.json: No such file")  # fmt: skip
        if os.getuid() != 0:
            self.refused("dataset", "near.off", "--poses", "orbit:1", "--out", "/nowhere/set",
                         status=1, says="/nowhere/set: cannot be made")  # fmt: skip


if __name__ == "__main__":
    main()
