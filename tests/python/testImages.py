# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images as numpy arrays, OpenEXR round trips; errors as exceptions."""

import errno
import json
import os
import pathlib
import pickle
import resource
import signal
import subprocess
import sys
import tempfile
import tracemalloc
import unittest
import zlib

import numpy
import scenes
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkWindowToImageFilter

import relievo

LAYERS = ["color", "depth", "range", "normal", "position", "albedo", "actor", "cell"]


def image_of(**arrays):
    """A vtkImageData of numpy arrays (rows, columns[, components]), row 0 at the top."""
    image = vtkImageData()
    for name, values in arrays.items():
        image.SetDimensions(values.shape[1], values.shape[0], 1)
        flat = values[::-1].reshape(values.shape[0] * values.shape[1], -1)
        array = numpy_to_vtk(flat, deep=True)
        array.SetName(name)
        image.GetPointData().AddArray(array)
    return image


class Rows(unittest.TestCase):
    """numpy's row 0 is the top, VTK's the bottom: a value is where it is seen."""

    def test_top_is_top(self):
        values = numpy.arange(12).reshape(3, 4)
        image = relievo.to_image(values)
        self.assertEqual(image.GetDimensions(), (4, 3, 1))
        # VTK's own places: (column, row from the bottom).
        for row in range(3):
            for column in range(4):
                self.assertEqual(
                    image.GetScalarComponentAsDouble(column, 2 - row, 0, 0), values[row, column])
        numpy.testing.assert_array_equal(relievo.from_image(image), values)

    def test_as_vtk_sees_it(self):
        """A texture's upper edge is at v = 1, and a PNG's first row is the top."""
        picture = numpy.zeros((6, 4, 3), numpy.uint8)
        picture[0] = (255, 0, 0)
        with tempfile.TemporaryDirectory() as folder:
            path = str(pathlib.Path(folder) / "top.png")
            writer = vtkPNGWriter()
            writer.SetInputData(relievo.to_image(picture))
            writer.SetFileName(path)
            writer.Write()
            with open(path, "rb") as file:
                rows = png_rows(file.read(), 4 * 3)
            self.assertEqual(rows[0], bytes((255, 0, 0)) * 4)
            self.assertEqual(rows[5], bytes(12))
            reader = vtkPNGReader()
            reader.SetFileName(path)
            reader.Update()
            numpy.testing.assert_array_equal(relievo.from_image(reader.GetOutput()), picture)

    def test_a_captured_picture(self):
        """The upper side of the world is in the upper rows."""
        renderer = vtkRenderer()
        above = vtkSphereSource()
        above.SetCenter(0, 0.8, 0)
        above.SetRadius(0.1)
        scenes.add(renderer, above)
        renderer.GetActiveCamera().SetPosition(0, 0, 5)
        window = scenes.window_of(renderer, 60, 60)
        image = relievo.capture(renderer, "depth")
        rows = numpy.nonzero(numpy.isfinite(relievo.layer(image, "depth")).any(axis=1))[0]
        self.assertLess(rows.max(), 30)
        window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.Update()
        shown = relievo.from_image(grab.GetOutput()).any(axis=(1, 2))
        numpy.testing.assert_array_equal(numpy.nonzero(shown)[0], rows)

    def test_kinds(self):
        for kind in ("bool", "uint8", "int16", "int32", "int64", "float16", "float32", ">f8"):
            values = (numpy.arange(6).reshape(2, 3) % 2).astype(kind)
            numpy.testing.assert_array_equal(
                relievo.from_image(relievo.to_image(values)), values.astype(float))
        values = numpy.arange(24.0).reshape(4, 6)
        image = relievo.to_image(values[:, ::2])
        values[:] = 0  # a copy was taken
        numpy.testing.assert_array_equal(relievo.from_image(image)[0], (0, 2, 4))
        two = {"a": numpy.ones((2, 3)), "b": numpy.ones((2, 3, 2))}
        image = relievo.to_image(two)
        self.assertEqual(relievo.layer_names(image), ["a", "b"])
        self.assertEqual(relievo.from_image(image).shape, (2, 3))
        self.assertEqual(relievo.layer(image, "b").shape, (2, 3, 2))

    def test_masked(self):
        values = numpy.array([[1.5, 2], [3, 4]])
        masked = numpy.ma.masked_greater(values, 3)
        back = relievo.from_image(relievo.to_image(masked))
        numpy.testing.assert_array_equal(back, [[1.5, 2], [3, numpy.nan]])
        nothing = numpy.ma.masked_array(values.astype(int))
        numpy.testing.assert_array_equal(
            relievo.from_image(relievo.to_image(nothing)), values.astype(int))
        with self.assertRaisesRegex(ValueError, r"ids: got masked values of type int64.*filled"):
            relievo.to_image({"ids": numpy.ma.masked_greater(values.astype(int), 3)})

    def test_copied_once(self):
        """Into VTK's memory, without a copy for numpy, whatever the type; the values are kept."""
        for given in (numpy.float32, numpy.float16, bool, ">f8"):
            values = (numpy.arange(360000) % 199).reshape(300, 400, 3).astype(given)
            tracemalloc.start()
            image = relievo.to_image(values)
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            self.assertLess(peak, values.nbytes / 3)
            kept = values.copy()
            values[...] = 0
            numpy.testing.assert_array_equal(relievo.from_image(image), kept)

    def test_refusals(self):
        flat = numpy.ones((2, 3))
        for invalid, says in (
            (numpy.ones(3), r"got shape \(3,\)"),
            (numpy.ones((2, 0)), "shape"),
            (numpy.ones((2, 2, 2, 2)), "shape"),
            (numpy.ones((2, 2), complex), "complex"),
            (numpy.array([["a"]]), "<U1"),
            ({}, "no arrays"),
            ({"a": flat, "b": flat.T}, "b: got shape"),
            ({"": flat}, "name"),
        ):
            with self.assertRaisesRegex(ValueError, says):
                relievo.to_image(invalid)
        solid = vtkImageData()
        solid.SetDimensions(2, 2, 2)
        with self.assertRaisesRegex(ValueError, "no scalars"):
            relievo.from_image(solid)
        solid.AllocateScalars(10, 1)
        with self.assertRaisesRegex(ValueError, "2 x 2 x 2"):
            relievo.from_image(solid)
        with self.assertRaisesRegex(ValueError, "expected a vtkImageData"):
            relievo.from_image(flat)


def png_rows(data, width):
    """The rows of a PNG file of bytes without interlacing, as PNG's filters leave them."""
    packed, at = b"", 8
    while at < len(data):
        size, kind = int.from_bytes(data[at : at + 4], "big"), data[at + 4 : at + 8]
        packed += data[at + 8 : at + 8 + size] if kind == b"IDAT" else b""
        at += size + 12
    raw, rows = zlib.decompress(packed), []
    for start in range(0, len(raw), width + 1):
        line, before = bytearray(raw[start + 1 : start + 1 + width]), (rows or [bytes(width)])[-1]
        for i in range(width):
            left, up = line[i - 3] if i >= 3 else 0, before[i]
            corner = before[i - 3] if i >= 3 else 0
            near = min((left, up, corner), key=lambda each: abs(left + up - corner - each))
            line[i] = (line[i] + (0, left, up, (left + up) // 2, near)[raw[start]]) % 256
        rows.append(bytes(line))
    return rows


class FolderTest(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)


class Layer(unittest.TestCase):
    def setUp(self):
        self.values = numpy.arange(24, dtype=numpy.float32).reshape(4, 6)
        self.vectors = numpy.arange(72, dtype=numpy.float64).reshape(4, 6, 3)
        self.image = image_of(one=self.values, three=self.vectors)

    def test_shape_and_order(self):
        numpy.testing.assert_array_equal(relievo.layer(self.image, "one"), self.values)
        numpy.testing.assert_array_equal(relievo.layer(self.image, "three"), self.vectors)
        # VTK's first value is the lower left pixel's.
        self.assertEqual(self.image.GetPointData().GetArray("one").GetValue(0), self.values[3, 0])

    def test_it_is_no_copy(self):
        view = relievo.layer(self.image, "one")
        view[3, 0] = 77
        self.assertEqual(self.image.GetPointData().GetArray("one").GetValue(0), 77)
        self.image.GetPointData().GetArray("one").SetValue(1, 78)
        self.assertEqual(view[3, 1], 78)
        self.assertFalse(view.flags.owndata)

    def test_it_outlives_the_image(self):
        view = relievo.layer(self.image, "one")
        expected = self.values.copy()
        self.image = None
        for _ in range(20):
            image_of(filler=numpy.zeros((64, 64)))
        numpy.testing.assert_array_equal(view, expected)

    def test_unknown(self):
        with self.assertRaises(ValueError) as caught:
            relievo.layer(self.image, "two")
        self.assertIn("'two'", str(caught.exception))
        self.assertIn("one, three", str(caught.exception))
        for invalid in (None, "image", numpy.zeros(3)):
            with self.assertRaises(ValueError):
                relievo.layer(invalid, "one")


class RoundTrip(FolderTest):
    def test_a_capture_comes_back_bit_for_bit(self):
        image = relievo.capture(scenes.plane_and_sphere(), LAYERS, size=(90, 60))
        for compression in ("none", "rle", "zips", "zip", "piz"):
            with self.subTest(compression=compression):
                path = self.folder / f"{compression}.exr"
                self.assertIsNone(relievo.write_exr(path, image, compression=compression))
                back = relievo.read_exr(path)
                self.assertEqual(sorted(relievo.layer_names(back)), sorted(LAYERS))
                for name in LAYERS:
                    before, after = relievo.layer(image, name), relievo.layer(back, name)
                    self.assertEqual(before.dtype, after.dtype, name)
                    if name == "position":  # float in the file, relative to relievo:origin
                        numpy.testing.assert_allclose(after, before, rtol=0, atol=2e-6)
                    else:
                        self.assertEqual(before.tobytes(), after.tobytes(), name)

    def test_pickled(self):
        """A capture, its camera and its lights, also in a process that has not imported relievo."""
        image = relievo.capture(scenes.plane_and_sphere(), LAYERS, size=(30, 20))
        path = self.folder / "image.pickle"
        path.write_bytes(pickle.dumps(image))
        code = "import pickle, sys; data = open(sys.argv[1], 'rb').read(); image = "
        code += "pickle.loads(data); print(repr(image)); assert pickle.dumps(image) == data"
        done = subprocess.run([sys.executable, "-c", code, path], capture_output=True, text=True,
                              check=False)  # fmt: skip
        self.assertEqual(done.stdout, f"{image!r}\n", done.stderr)
        back = pickle.loads(path.read_bytes())
        for name in LAYERS:
            before, after = relievo.layer(image, name), relievo.layer(back, name)
            self.assertEqual((before.dtype, before.tobytes()), (after.dtype, after.tobytes()))
        before, after = relievo.attributes(image), relievo.attributes(back)
        self.assertEqual(list(before), list(after))
        self.assertEqual(before["lights"], after["lights"])
        numpy.testing.assert_array_equal(before["worldToNDC"], after["worldToNDC"])

    def test_the_camera_comes_back(self):
        renderer = scenes.plane_and_sphere()
        for position in ((3, 5, 2), (-1, 0.1, 7)):
            light = vtkLight()
            light.SetPosition(*position)
            renderer.AddLight(light)
        image = relievo.capture(renderer, "depth", size=(20, 10))
        relievo.write_exr(self.folder / "a.exr", image)
        before = relievo.attributes(image)
        after = relievo.attributes(relievo.read_exr(self.folder / "a.exr"))
        for name in ("worldToCamera", "worldToNDC", "near", "far", "relievo:origin"):
            numpy.testing.assert_allclose(after[name], before[name], rtol=1e-6, err_msg=name)
        self.assertEqual(len(before["lights"]), 2)
        self.assertEqual(json.loads(before["lights"][1])["position"], [-1, 0.1, 7])
        self.assertEqual(after["lights"], before["lights"])

    def test_pixel_types(self):
        values = numpy.linspace(0, 1, 24, dtype=numpy.float32).reshape(4, 6)
        relievo.write_exr(self.folder / "a.exr", image_of(v=values), pixel_types={"v": "half"})
        back = relievo.layer(relievo.read_exr(self.folder / "a.exr"), "v")
        numpy.testing.assert_array_equal(back, values.astype(numpy.float16).astype(numpy.float32))
        self.assertTrue((back != values).any())

    def test_special_values(self):
        values = numpy.array([[numpy.inf, -numpy.inf], [numpy.nan, -0.0]], numpy.float32)
        relievo.write_exr(self.folder / "a.exr", image_of(v=values))
        back = relievo.layer(relievo.read_exr(self.folder / "a.exr"), "v")
        self.assertEqual(back.tobytes(), values.tobytes())

    def test_names_as_str_and_path(self):
        image = image_of(v=numpy.zeros((2, 2), numpy.float32))
        relievo.write_exr(str(self.folder / "a.exr"), image)
        self.assertEqual(relievo.read_exr(str(self.folder / "a.exr")).GetDimensions(), (2, 2, 1))


class WriteErrors(FolderTest):
    def setUp(self):
        super().setUp()
        self.image = image_of(v=numpy.zeros((2, 2), numpy.float32))

    def refused(self, kind, *arguments, **more):
        with self.assertRaises(kind) as caught:
            relievo.write_exr(*arguments, **more)
        self.assertEqual(sorted(os.listdir(self.folder)), [])
        return str(caught.exception)

    def test_arguments(self):
        path = self.folder / "a.exr"
        self.assertIn("image: got None", self.refused(ValueError, path, None))
        self.assertIn("'zap'", self.refused(ValueError, path, self.image, compression="zap"))
        self.assertIn("3", self.refused(ValueError, path, self.image, compression=3))
        said = self.refused(ValueError, path, self.image, pixel_types={"v": "double"})
        self.assertIn("'v'", said)
        self.assertIn("'double'", said)
        self.refused(ValueError, path, self.image, pixel_types={"v": "uint"})

    def test_places(self):
        said = self.refused(FileNotFoundError, self.folder / "no" / "a.exr", self.image)
        self.assertIn(str(self.folder / "no" / "a.exr"), said)
        self.refused(IsADirectoryError, self.folder, self.image)
        (self.folder / "file").write_text("")
        with self.assertRaises(NotADirectoryError):
            relievo.write_exr(self.folder / "file" / "a.exr", self.image)

    def test_what_the_system_refuses(self):
        said = self.refused(OSError, "/dev/full", self.image)
        self.assertIn("/dev/full", said)
        with self.assertRaises(OSError) as caught:
            relievo.write_exr("/proc/a.exr", self.image)
        self.assertIn(caught.exception.errno, (errno.EACCES, errno.ENOENT, errno.EPERM))
        self.assertEqual(caught.exception.filename, "/proc/a.exr")

    def test_a_full_disk(self):
        # A limit of this process stands for it.
        image = image_of(v=numpy.random.default_rng(1).random((200, 200)))
        before = resource.getrlimit(resource.RLIMIT_FSIZE)
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        path = self.folder / "a.exr"
        resource.setrlimit(resource.RLIMIT_FSIZE, (8192, before[1]))
        try:
            with self.assertRaises(OSError) as caught:
                relievo.write_exr(path, image)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, before)
        self.assertEqual(caught.exception.errno, errno.EFBIG)
        self.assertEqual(caught.exception.filename, str(path))
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_wrong_name_of_a_pixel_type_writes_nothing(self):
        self.refused(ValueError, self.folder / "a.exr", self.image, pixel_types={"": "half"})

    def test_an_old_file_stays_after_an_error(self):
        path = self.folder / "a.exr"
        relievo.write_exr(path, self.image)
        before = path.read_bytes()
        with self.assertRaises(ValueError):
            relievo.write_exr(path, self.image, pixel_types={"v": "uint"})
        self.assertEqual(path.read_bytes(), before)


class ReadErrors(FolderTest):
    def test_places(self):
        with self.assertRaises(FileNotFoundError) as caught:
            relievo.read_exr(self.folder / "gone.exr")
        self.assertIn("gone.exr", str(caught.exception))
        with self.assertRaises(IsADirectoryError):
            relievo.read_exr(self.folder)
        pipe = self.folder / "pipe.exr"
        os.mkfifo(pipe)
        for place in ("/dev/null", pipe):
            with self.assertRaises(OSError) as caught:
                relievo.read_exr(place)
            self.assertIn(str(place), str(caught.exception))

    def test_broken_files(self):
        path = self.folder / "a.exr"
        relievo.write_exr(path, relievo.capture(scenes.plane_and_sphere(), "depth", size=(64, 64)))
        whole = path.read_bytes()
        for label, content in (
            ("empty", b""),
            ("text", b"this is no picture\n" * 9),
            ("header only", whole[:200]),
            ("cut", whole[: len(whole) // 2]),
        ):
            with self.subTest(label=label):
                path.write_bytes(content)
                with self.assertRaises(ValueError) as caught:
                    relievo.read_exr(path)
                self.assertIn(str(path), str(caught.exception))


if __name__ == "__main__":
    unittest.main(verbosity=2)
