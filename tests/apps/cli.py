# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the tests of the command: running it, small scenes, reading its output."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import numpy

RELIEVO = os.environ["RELIEVO"]
EXR_DUMP = os.environ["EXR_DUMP"]
BENCHES = os.environ["BENCHES"] == "1"  # whether the command was built with them
MANY = os.environ.get("RELIEVO_FUZZ")  # runs `relievo render` many times; a wheel has none

# VTK's version, as 9.7; from 9.4 on it opens windows without a display.
VERSION = subprocess.run(
    [RELIEVO, "--version"], stdout=subprocess.PIPE, text=True, check=True
).stdout
VTK_VERSION = tuple(int(part) for part in re.search(r"VTK (\d+)\.(\d+)", VERSION).groups())
NEEDS_DISPLAY = VTK_VERSION < (9, 4)

# A triangle in the plane z = 0, seen by the camera of LOOK as a triangle of known pixels.
TRIANGLE = "OFF\n3 1 0\n-1 -1 0\n1 -1 0\n-1 1 0\n3 0 1 2\n"
LOOK = ["--camera", "0,0,5,0,0,0,0,1,0", "--clip", "1,10"]

# Progress of a step that takes more than two seconds, on a busy machine of any step.
PROGRESS = re.compile(r"relievo: .* \d+ %")

KEPT = tempfile.TemporaryDirectory()
FOLDER = pathlib.Path(KEPT.name).resolve()


class Many:
    """`relievo render` many times in one process: a process for each picture, with a window for
    each, takes ten times as long as the picture."""

    running = {}  # by the environment that differs

    def __init__(self, environment):
        self.errors, self.seen = tempfile.TemporaryFile("a+b"), 0  # output of libraries
        self.process = subprocess.Popen(
            [MANY], cwd=FOLDER, env={**os.environ, **environment}, stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=self.errors)  # fmt: skip

    @classmethod
    def run(cls, words, environment):
        """The result, as a finished process of the command would have it."""
        kind = tuple(sorted(environment.items()))
        if kind not in cls.running:
            cls.running[kind] = cls(environment)
        return cls.running[kind].draw(words) or cls.running.pop(kind).broken(words)

    def draw(self, words):
        self.process.stdin.write(json.dumps(words).encode() + b"\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            return None
        answer = json.loads(line)
        said = answer["certificate"]
        return subprocess.CompletedProcess(
            words, answer["status"], f"relievo: certified shadows: {said}\n" if said else "",
            "".join(f"relievo: {each}\n" for each in answer["say"]) + self.printed())  # fmt: skip

    def printed(self):
        self.errors.seek(self.seen)
        text = self.errors.read()
        self.seen += len(text)
        return text.decode(errors="replace")

    def broken(self, words):
        raise AssertionError(f"{words}: ended with status {self.process.wait()}: {self.printed()}")

    def end(self):
        self.process.stdin.close()
        return self.process.wait(timeout=60)


def oklab(rgb):
    """L, a and b (B. Ottosson, A perceptual color space for image processing, 2020) of display
    values from 0 to 1."""
    linear = numpy.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    roots = numpy.cbrt(linear @ numpy.array([
        [0.4122214708, 0.2119034982, 0.0883024619], [0.5363325363, 0.6806995451, 0.2817188376],
        [0.0514459929, 0.1073969566, 0.6299787005]]))  # fmt: skip
    return roots @ numpy.array([
        [0.2104542553, 1.9779984951, 0.0259040371], [0.7936177850, -2.4285922050, 0.7827717662],
        [-0.0040720468, 0.4505937099, -0.8086757660]])  # fmt: skip


class CliTest(unittest.TestCase):
    """Each test runs in an empty folder that holds triangle.off."""

    def setUp(self):
        for left in FOLDER.iterdir():
            shutil.rmtree(left) if left.is_dir() and not left.is_symlink() else left.unlink()
        self.folder = FOLDER
        (self.folder / "triangle.off").write_text(TRIANGLE)
        self.before = self.names()

    def names(self):
        return sorted(path.name for path in self.folder.rglob("*"))

    def finished(self, *words, environment=None, wrapper=(), whole=False):
        """Runs the command and returns the finished process, without its progress messages on a
        busy machine. Renderings share one process, unless a separate one is requested or
        needed for a wrapper."""
        words, environment = [str(word) for word in words], environment or {}
        if MANY and words[:1] == ["render"] and not (
                whole or wrapper or {"-h", "--help", "--version"} & set(words)):  # fmt: skip
            done = Many.run(words[1:], environment)
        else:
            done = subprocess.run(
                [*wrapper, RELIEVO, *words],
                cwd=self.folder,
                env={**os.environ, **environment},
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                text=True,
                timeout=600,
            )
        done.stderr = "".join(line for line in done.stderr.splitlines(True)
                              if not PROGRESS.fullmatch(line.rstrip("\n")))  # fmt: skip
        return done

    def relievo(self, *words, status=0, **more):
        """The finished process, whose exit status must be as said."""
        done = self.finished(*words, **more)
        self.assertEqual(done.returncode, status, f"{words}: {done.stderr}")
        return done

    def kill(self, begun, wait, *words):
        """Ends the command by a signal, so many seconds after `begun` returns true."""
        killed = subprocess.Popen([RELIEVO, *map(str, words)], cwd=self.folder,
                                  stdout=subprocess.DEVNULL)  # fmt: skip
        while killed.poll() is None and not begun():
            time.sleep(0.0005)
        time.sleep(wait)
        killed.kill()
        killed.wait()

    def refused(self, *words, status, says, **more):
        """The run fails with one line that holds every text of `says`, and writes nothing."""
        done = self.relievo(*words, status=status, **more)
        said = done.stderr.splitlines()
        self.assertEqual(len(said), 1, f"not one line: {done.stderr}")
        self.assertTrue(said[0].startswith("relievo: "), done.stderr)
        for text in [says] if isinstance(says, str) else says:
            self.assertIn(text, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.names(), self.before, "something was written")
        return done

    def render(self, *words, **more):
        return self.relievo("render", "triangle.off", *LOOK, *words, **more)

    def exr(self, name):
        """Header of an EXR file as OpenEXR reads it, and its channels as arrays, top row first."""
        path = self.folder / name
        raw = self.folder / (name + ".raw")
        done = subprocess.run([EXR_DUMP, path, raw], stdout=subprocess.PIPE, check=True)
        header = json.loads(done.stdout)
        shape = (header["height"], header["width"])
        data, at = raw.read_bytes(), 0
        raw.unlink()
        channels = {}
        for channel in header["channels"]:
            kind = numpy.dtype("<u4" if channel["type"] == "uint" else "<f4")
            count = shape[0] * shape[1]
            values = numpy.frombuffer(data, kind, count, at).reshape(shape)
            channels[channel["name"]] = values
            at += count * kind.itemsize
        self.assertEqual(at, len(data))
        return header, channels


def read_png(path):
    """A PNG as an array (rows, columns, components), top row first."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[::-1]


def write_image(writer, path, values):
    """Values (rows, columns, components), the first row at v = 0."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData

    rows, columns, components = values.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    flat = numpy.ascontiguousarray(values).reshape(-1, components)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def main():
    done = unittest.main(verbosity=2, exit=False).result.wasSuccessful()
    ended = [each.end() for each in Many.running.values()]
    sys.exit(0 if done and not any(ended) else f"failed; ended with {ended}")
