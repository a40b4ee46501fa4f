# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benches of whole commands: bench/command_start.py with commands that only write a file, its
output and refusals; bench/scale.py with the command itself, in small; the counts of both;
bench/compare.py, which draws in Python; and small tables of other benches. CMakeLists.txt has the
classes of each test."""

import csv
import importlib.util
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BENCH = pathlib.Path(__file__).resolve().parents[2] / "bench"
sys.path.insert(0, str(BENCH))
import processes  # noqa: E402
import scale  # noqa: E402

# Holds so many MiB for so many processor seconds, and first waits for another that is asked for.
HOLDS = """
import subprocess, sys, time
own, mebibytes, seconds, *more = sys.argv
held = bytearray(int(mebibytes) << 20)
for page in range(0, len(held), 4096):
    held[page] = 1
if more:
    subprocess.run([sys.executable, own, *more], check=True)
while time.process_time() < float(seconds):
    pass
"""


def rows_of(script, *words):
    """The rows of a small run of a bench."""
    done = subprocess.run([sys.executable, BENCH / script, *words, "--small"],
                          stdout=subprocess.PIPE, text=True, check=True)  # fmt: skip
    return list(csv.DictReader(done.stdout.splitlines()))


class Start(unittest.TestCase):
    def run_with(self, *pictures):
        with tempfile.TemporaryDirectory() as folder:
            commands = []
            for i, picture in enumerate(pictures):
                command = pathlib.Path(folder, f"command{i}")
                command.write_text(f'#!/bin/sh\nfor last; do :; done\nprintf {picture} >"$last"\n')
                command.chmod(0o755)
                commands.append(str(command))
            return subprocess.run(
                [sys.executable, BENCH / "command_start.py", commands[0], folder, "--rounds", "3",
                 "--looks", "none", *(["--against", commands[1]] if len(commands) > 1 else [])],
                capture_output=True, text=True, check=False)  # fmt: skip

    def test_prints_each_program(self):
        done = self.run_with("same", "same")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = list(csv.DictReader(done.stdout.splitlines()))
        self.assertEqual([row["program"] for row in rows if row["program"] != "F3D"],
                         ["relievo, none", "relievo, the other build, none"])  # fmt: skip
        self.assertEqual(float(rows[0]["ratio"]), 1)
        self.assertGreater(float(rows[1]["milliseconds"]), 0)

    def test_refuses_builds_that_differ(self):
        done = self.run_with("one", "other")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("the builds draw --preset none differently", done.stderr)


class Lists(unittest.TestCase):
    def test_every_class_is_in_a_list(self):
        lists = pathlib.Path(__file__).with_name("CMakeLists.txt").read_text(encoding="utf-8")
        words = re.findall(r"testCommandStart\.py[^)]*?ARGS ([\w.\s]+?)\s+ENVIRONMENT", lists)
        self.assertEqual(len(words), 2)
        classes = {name for name, each in globals().items()
                   if isinstance(each, type) and issubclass(each, unittest.TestCase)}  # fmt: skip
        self.assertEqual(classes - set(" ".join(words).split()), set())


class Cost(unittest.TestCase):
    def hold(self, *words):
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(folder, "holds.py")
            script.write_text(HOLDS)
            return processes.run([sys.executable, script, *words], peak=True)

    def test_of_all_processes_together(self):
        least = self.hold("0", "0.1").peak
        one = self.hold("64", "0.3")
        both = self.hold("64", "0.3", "32", "0.4")
        for cost, seconds, starts, mebibytes in ((one, 0.3, 1, 64), (both, 0.7, 2, 96)):
            self.assertTrue(seconds <= cost.processor < seconds + 0.35, cost.processor)
            self.assertGreaterEqual(cost.seconds, 0.3)
            self.assertAlmostEqual((cost.peak - starts * least) / 2**20, mebibytes, delta=4)

    def test_failures_say_why(self):
        with self.assertRaisesRegex(SystemExit, "(?s)failed.*ZeroDivisionError"):
            processes.run([sys.executable, "-c", "1 / 0"])


@unittest.skipUnless(importlib.util.find_spec("relievo"), "no package relievo")
class ScalingOut(unittest.TestCase):
    def test_small_tables(self):
        rows = rows_of("scaling_out.py", "--rounds", "1")
        self.assertEqual([row["subject"] for row in rows],
                         ["start"] * 3 + ["part"] * 10 + ["view"] * 4
                         + ["data set"] * 7 + ["cover"])  # fmt: skip
        self.assertTrue(all(float(row["processor seconds"]) > 0 for row in rows))
        self.assertAlmostEqual(float(rows[1]["bytes"]), 48, delta=3)  # of 12 + 4 + 12 + 2 + a node
        measured, model = (
            sum(float(row["processor seconds"]) for row in rows if row["method"] == each)
            for each in ("measured", "model"))
        self.assertAlmostEqual(measured / model, 1, delta=0.02)  # least squares with a constant
        self.assertLess(float(rows[16]["other cells"]), 0.01)  # at edges alone


@unittest.skipUnless(importlib.util.find_spec("relievo"), "no package relievo")
class ManyFrames(unittest.TestCase):
    def test_small_table(self):
        """Each frame is against plain frames, and exact shadows also against those of maps."""
        rows = rows_of("many_frames.py", "--rounds", "2")
        shadows = ["plain / plain", "map / plain", "exact / plain", "exact / map"]
        self.assertEqual(
            [f"{row['frame']} / {row['against']}" for row in rows],
            4 * shadows + [f"{name}, {frame} / {name}, plain" for name in ("blocks", "one mesh")
                           for frame in ("plain", "capture")]
            + [f"{way} / VTK's lights" for way in ("VTK's lights", "attached", "lamps")],
        )  # fmt: skip
        self.assertTrue(all(float(row["processor milliseconds"]) > 0 for row in rows))
        for row in (row for row in rows if row["frame"].endswith("capture")):
            self.assertGreater(float(row["ratio"]), 1)  # a capture draws, and then reads


@unittest.skipUnless(importlib.util.find_spec("relievo"), "no package relievo")
class Irradiation(unittest.TestCase):
    def test_small_table(self):
        """Errors are within bounds, and bounds of scenes without gaps are near the tolerance."""
        rows = rows_of("irradiation.py", "--rounds", "1")
        closed = [row for row in rows if row["method"] == "tolerance" and row["places"] == "64"]
        self.assertEqual(len(closed), 7)
        for row in closed:
            with self.subTest(row["scene"], tolerance=row["setting"]):
                error, bound, tolerance = (
                    float(row[name]) for name in ("largest error %", "largest bound %", "setting"))
                self.assertLess(error, bound)
                if row["scene"] != "courtyard, separate walls":
                    self.assertLessEqual(bound, max(tolerance, 1.1))  # of the smallest patches
        for row in rows:
            if row["method"] == "number of rays":
                self.assertLess(float(row["rms error %"]), 60 / float(row["setting"]) ** 0.5)
            elif row["places"] == "1":  # where pvlib is
                self.assertLess(float(row["largest error %"]), 0.5)


@unittest.skipUnless(importlib.util.find_spec("relievo"), "no package relievo")
@unittest.skipUnless(importlib.util.find_spec("osgeo") and shutil.which("gdal_viewshed"),
                     "no GDAL: packages.txt, [tests]")  # fmt: skip
class Viewshed(unittest.TestCase):
    def test_small_table(self):
        """Relievo's cells are those of lines over triangles, most of GDAL's too."""
        ours, theirs = rows_of("viewshed.py", os.environ["RELIEVO"], "--rounds", "1")
        self.assertEqual([row["method"] for row in (ours, theirs)],
                         ["relievo viewshed", "gdal_viewshed"])  # fmt: skip
        self.assertEqual(float(ours["differs from triangles, %"]), 0)
        self.assertTrue(0 < float(theirs["differs from triangles, %"]) < 15)
        for row in (ours, theirs):
            self.assertEqual(row["cells"], "10000")
            self.assertTrue(1 < float(row["seen, %"]) < 99)
            self.assertTrue(0 < float(row["differs from bilinear, %"]) < 15)
            self.assertGreater(float(row["processor seconds"]), 0)
            self.assertGreater(float(row["MiB"]), 0)


@unittest.skipUnless(importlib.util.find_spec("relievo"), "no package relievo")
class ManyViews(unittest.TestCase):
    def test_small_table(self):
        """All methods find nearly all cells that Relievo finds, and estimates go on in lines."""
        rows = rows_of("many_views.py", "--rounds", "1")
        for subject, methods in (
            ("cameras", {"relievo.visible", "VTK, colours", "vtkHardwareSelector"}),
            ("views", {"capture_many", "VTK, colours", "write_dataset"}),
        ):
            shown = [row for row in rows if row["subject"] == subject]
            self.assertLessEqual(methods, {row["method"] for row in shown})
            for few, many, estimated in zip(shown[::3], shown[1::3], shown[2::3], strict=True):
                self.assertEqual([row["kind"] for row in (few, many, estimated)],
                                 ["measured", "measured", "estimated"])  # fmt: skip
                (n, t), (m, u), (k, v) = ((int(row["number"]), float(row["processor seconds"]))
                                          for row in (few, many, estimated))  # fmt: skip
                self.assertTrue(0 < t < u < v)
                self.assertAlmostEqual((u - t) / (m - n) / ((v - u) / (k - m)), 1, delta=0.1)
                self.assertAlmostEqual(float(many["exponent"]) * math.log(m / n),
                                       math.log(u / t), delta=0.02)  # fmt: skip
                for row in (few, many):
                    self.assertGreaterEqual(float(row["found, %"] or 100), 98)


class Scale(unittest.TestCase):
    def measure(self, *words):
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder, "scale.csv")
            subprocess.run(
                [sys.executable, BENCH / "scale.py", os.environ["RELIEVO"], "--small", "--size",
                 "200x150", "--rounds", "1", "--presets", "none", "--f3d", "none", "--vtk", "none",
                 "--out", table, *words],
                stdout=subprocess.DEVNULL, check=True)  # fmt: skip
            with open(table, encoding="utf-8", newline="") as file:
                return list(csv.DictReader(file))

    def test_exponents(self):
        """Of a law, less an empty start; of the last decade alone; without noise."""
        sizes = [10, 30, 100, 1000, 10000]
        costs = [3 * size**1.5 for size in sizes]
        self.assertAlmostEqual(scale.exponent(sizes, costs, 2), 1.5)
        self.assertAlmostEqual(scale.exponent(sizes, [*[7] * 3, 10, 100], 0), 1)
        self.assertTrue(math.isnan(scale.exponent(sizes, [*costs[:3], 0.1, 9], 2)))
        self.assertTrue(math.isnan(scale.exponent([10], [5], 0)))

    def test_every_series_grows(self):
        rows = self.measure()
        names = {series.of: name for name, series in scale.SERIES.items()}
        found = {}
        for row in rows:
            found.setdefault(names[row["series"]], []).append(row)
        self.assertEqual(list(found), list(scale.SERIES))
        for name, (start, *grown) in found.items():
            with self.subTest(name):
                self.assertEqual((start["seconds more"], start["exponent"]), ("", ""))
                self.assertEqual(len(grown), 2)
                for row, size in zip(grown, scale.SERIES[name].small, strict=True):
                    self.assertAlmostEqual(int(row["size"]), size, delta=0.02 * size)
                    look = "visible" if name in ("sights", "cameras") else "none"
                    self.assertEqual(row["method"], f"Relievo, {look}")
        for column, names in (
            ("exponent", ("meshes", "blocks", "objects", "points", "pictures")),
            ("MiB exponent", ("meshes", "points", "pictures")),
        ):
            for name in names:
                with self.subTest(f"{column} of {name}"):
                    slope = float(found[name][-1][column])
                    self.assertTrue(0.3 < slope < 2.0, slope)  # of single runs on a busy machine

    def test_refuses_a_command_that_draws_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            command = pathlib.Path(folder, "command")
            command.write_text('#!/bin/sh\nfor last; do :; done\necho blank >"$last"\n')
            command.chmod(0o755)
            done = subprocess.run(
                [sys.executable, BENCH / "scale.py", command, "--small", "--series", "points",
                 "--f3d", "none", "--vtk", "none"], capture_output=True, text=True,
                check=False)  # fmt: skip
        self.assertEqual(done.returncode, 1)
        self.assertIn("Relievo, none draws 100000 points as it draws 1", done.stderr)

    def test_an_unmodified_build_costs_as_much(self):
        rows = self.measure("--series", "meshes", "--against", os.environ["RELIEVO"])
        kinds = ("Relievo, none", "Relievo, none, the other build")
        one, other = ([row for row in rows if row["method"] == kind] for kind in kinds)
        self.assertEqual(len(one), 3)
        for a, b in zip(one, other, strict=True):
            self.assertEqual(a["size"], b["size"])
            for column, share in (("processor seconds", 1.0), ("MiB", 0.15)):
                self.assertAlmostEqual(float(a[column]), float(b[column]),
                                       delta=share * float(a[column]))  # fmt: skip


@unittest.skipUnless(importlib.util.find_spec("relievo"), "no package relievo")
class Compare(unittest.TestCase):
    def run_with(self, *words):
        """Runs the bench with these options, by the command."""
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(
                [os.environ["RELIEVO"], "bench", "compare", "--out", folder, "--", *words],
                stdout=subprocess.DEVNULL, check=True)  # fmt: skip
            found = []
            for name in ("compare", "compare-faults"):
                table = pathlib.Path(folder, f"{name}.csv").read_text(encoding="utf-8")
                found.append(list(csv.DictReader(table.splitlines())))
            return found

    def test_few_faults(self):
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/pairs.json"
            methods, kinds = self.run_with("--quick", "--keep", folder, "--pairs", file)
            # A peer that was not there then compares the pictures that were kept: in one pair,
            # those of two scenes.
            pairs = json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
            first = next(pair for pair in pairs if pair["is_fault"] and pair["pictures"])
            shutil.copyfile(pairs[-1]["pictures"][0], first["pictures"][1])
            later, kinds_later = self.run_with(
                "--of", file, "--peers", "vtkImageDifference", "--frames", "no")  # fmt: skip
        self.assertEqual((later[:3], kinds_later), (methods, kinds))
        peer = [row for row in later[3:] if row["role"] == "best"]
        self.assertEqual([row["method"] for row in peer], ["vtkImageDifference"])
        self.assertEqual(peer[0]["detected %"], f"{100 / int(peer[0]['faults']):.2f}", peer)
        self.assertEqual([row["method"] for row in methods],
                         [f"Relievo, {of}" for of in ("baselines", "layers", "pictures")])
        for row in methods:
            self.assertEqual((row["detected %"], row["false alarms"]), ("100.00", "0"), row)
        self.assertEqual(methods[0]["attributed %"], "100.00")
        self.assertEqual(methods[0]["innocent"], "6")
        self.assertGreaterEqual(sum(int(row["pairs"]) for row in kinds), 14)

    def test_elsewhere(self):
        """Frames drawn before, as on another machine, are compared as a change without a fault."""
        with tempfile.TemporaryDirectory() as folder:
            few = ("--scenes", "meshes", "--size", "80x60")
            subprocess.run([sys.executable, BENCH / "compare.py", *few, "--write-frames", folder],
                           check=True)  # fmt: skip
            self.assertEqual(os.listdir(folder), ["meshes.exr"])
            methods, kinds = self.run_with(*few, "--elsewhere", folder, "--peers", "")
        self.assertEqual([(row["kind"], row["pairs"], row["detected"]) for row in kinds],
                         [("another renderer", "1", "0")])  # fmt: skip
        self.assertEqual([row["false alarms"] for row in methods], ["0"] * 3)

    def test_counts(self):
        """Of known scores: 8 faults, of which 6 are visible, and 5 changes without a fault."""
        ours = dict.fromkeys(("Relievo, baselines", "Relievo, layers", "Relievo, pictures"), 0.0)
        pairs = [
            {"scene": "meshes", "kind": "colour" if score else "another run", "size": 1,
             "is_fault": bool(score), "pixels": 3 if score < 3 else 40,
             "scores": {**ours, "Relievo, baselines": float(score > 3),
                        "vtkImageDifference": score or off},
             "right": dict.fromkeys(ours, score > 4), "said": "", "causes": []}
            for score, off in ((1, 0), (2, 0), (3, 0), (4, 0), (5, 0), (6, 0), (11, 0), (30, 0),
                               (0, 0), (0, 0), (0, 0), (0, 4.5), (0, 5.5))]  # fmt: skip
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "pairs.json")
            file.write_text(json.dumps(pairs), encoding="utf-8")
            methods, kinds = self.run_with("--of", str(file), "--frames", "no")
        found = {(row["method"], row["role"], row["limit"]): row for row in methods}
        for key, detected, alarms in (
            (("Relievo, baselines", "recommended", "0.5"), 5 / 6, 0),
            (("vtkImageDifference", "recommended", "10"), 2 / 6, 0),
            (("vtkImageDifference", "best", "5.5"), 3 / 6, 0),
            (("vtkImageDifference", "curve", "0"), 1, 2 / 5),
            (("vtkImageDifference", "curve", "4.5"), 4 / 6, 1 / 5),
        ):
            self.assertEqual(found[key]["detected %"], f"{100 * detected:.2f}", key)
            self.assertEqual(found[key]["false alarms %"], f"{100 * alarms:.2f}", key)
        self.assertEqual(
            found["Relievo, baselines", "recommended", "0.5"]["attributed %"], f"{100 * 4 / 6:.2f}")
        fault, change = kinds
        self.assertEqual([fault[name] for name in ("pairs", "visible", "detected", "attributed")],
                         ["8", "6", "5", "4"])
        self.assertEqual((change["kind"], change["pairs"], change["visible"]),
                         ("another run", "5", ""))


if __name__ == "__main__":
    unittest.main(verbosity=2)
