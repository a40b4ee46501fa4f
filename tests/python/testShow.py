# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers as pictures, in notebooks and as a page of HTML."""

import base64
import io
import json
import pathlib
import re
import tempfile
import unittest
import zlib

import numpy
from matplotlib import colormaps
from PIL import Image
from vtkmodules.vtkCommonDataModel import vtkImageData

import relievo


def opened(data):
    return numpy.asarray(Image.open(io.BytesIO(data)).convert("RGB"))


def image_of(**layers):
    return relievo.to_image(layers)


class Pictures(unittest.TestCase):
    def test_numbers_are_viridis_over_their_range(self):
        values = numpy.linspace(2, 3, 10000).reshape(100, 100).astype(numpy.float32)
        values[0, :50] = numpy.inf
        shown = relievo.picture(image_of(depth=values), "depth")
        self.assertEqual((shown.shape, shown.dtype), ((100, 100, 3), numpy.uint8))
        low, high = numpy.percentile(values[numpy.isfinite(values)], (1, 99))
        truth = colormaps["viridis"](numpy.clip((values - low) / (high - low), 0, 1))[..., :3]
        off = numpy.abs(shown / 255 - truth)[numpy.isfinite(values)]
        self.assertLess(off.max(), 0.03)
        self.assertEqual({tuple(rgb) for rgb in shown[0, :50].tolist()}, {(40, 42, 46)})

    def test_the_first_row_is_the_upper_one(self):
        values = numpy.zeros((4, 6, 3), numpy.float32)
        values[0] = 1
        self.assertGreater(relievo.picture(image_of(color=values), "color")[0].min(), 250)

    def test_light_is_shown_as_srgb(self):
        values = numpy.full((2, 2, 4), 0.2140, numpy.float32)
        self.assertEqual(set(relievo.picture(image_of(color=values), "color").ravel()), {127})

    def test_normals_and_positions(self):
        normal = numpy.zeros((2, 3, 3), numpy.float32)
        normal[:, 1:] = (0, 0, 1)
        shown = relievo.picture(image_of(normal=normal), "normal")
        self.assertEqual(shown[0].tolist(), [[40, 42, 46], [128, 128, 255], [128, 128, 255]])
        position = numpy.zeros((1, 4, 3))
        position[0, 1:] = [(5, 1, 1), (6, 3, 2), (7, 2, 3)]
        shown = relievo.picture(image_of(position=position), "position")
        self.assertEqual(shown[0].tolist(),
                         [[40, 42, 46], [0, 0, 0], [128, 255, 128], [255, 128, 255]])

    def test_ids_have_colours_of_their_own(self):
        ids = numpy.arange(-1, 99, dtype=numpy.int32).reshape(10, 10)
        shown = relievo.picture(image_of(cell=ids), "cell").reshape(-1, 3)
        self.assertEqual(len(numpy.unique(shown, axis=0)), 100)
        self.assertEqual(shown[0].tolist(), [40, 42, 46])

    def test_a_layer_of_nothing(self):
        empty = numpy.full((3, 3), numpy.nan, numpy.float32)
        self.assertEqual(set(relievo.picture(image_of(depth=empty), "depth").ravel()), {40, 42, 46})
        nowhere = numpy.zeros((3, 3, 3))
        shown = relievo.picture(image_of(position=nowhere), "position")
        self.assertEqual(set(shown.ravel()), {40, 42, 46})

    def test_refusals(self):
        image = image_of(depth=numpy.zeros((2, 2)))
        for call, words in ((relievo.picture, (image, "normal")), (relievo.show, (image, "normal")),
                            (relievo.picture, (None, "depth")), (relievo.show, (vtkImageData(),)),
                            (relievo.show, (image, []))):
            with self.assertRaises(ValueError):
                call(*words)


class Notebooks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        random = numpy.random.default_rng(1)
        self.layers = {
            "depth": random.uniform(1, 9, (30, 40)).astype(numpy.float32),
            "cell": random.integers(-1, 2**31 - 1, (30, 40)).astype(numpy.int32),
            "position": random.uniform(-5, 5, (30, 40, 3)),
        }
        path = self.folder / "layers.exr"
        relievo.write_exr(path, relievo.to_image(self.layers))
        self.image = relievo.read_exr(path)

    def test_layers_of_a_file_have_a_picture(self):
        self.assertIsInstance(self.image, vtkImageData)
        shown = opened(self.image._repr_png_())
        self.assertEqual(shown.shape, (30, 120, 3))
        for i, name in enumerate(relievo.layer_names(self.image)):
            numpy.testing.assert_array_equal(
                shown[:, 40 * i : 40 * (i + 1)], relievo.picture(self.image, name))

    def test_a_capture_has_a_picture(self):
        from vtkmodules.vtkFiltersSources import vtkSphereSource

        layers = ["depth", "normal", "cell", "actor"]
        image = relievo.capture(vtkSphereSource(), layers, size=(64, 48))
        self.assertEqual(opened(image._repr_png_()).shape, (96, 192, 3))

    def test_the_page_holds_the_values(self):
        path = self.folder / "layers.html"
        page = relievo.show(self.image, path=path)
        text = path.read_text(encoding="utf-8")
        self.assertNotIn("http", re.sub(r"@LAYERS@", "", text).replace("http-equiv", ""))
        layers = json.loads(re.search(r"^const layers = (.*);$", text, re.M)[1])
        self.assertEqual({each["name"] for each in layers}, set(self.layers))
        for each in layers:
            truth = self.layers[each["name"]]
            kind = numpy.int32 if each["whole"] else numpy.float32
            values = numpy.frombuffer(zlib.decompress(base64.b64decode(each["values"])), kind)
            # Positions are float in the file, relative to an origin.
            near = 1e-6 if each["name"] == "position" else 0
            numpy.testing.assert_allclose(values, truth.astype(kind).ravel(), atol=near, rtol=0)
            self.assertEqual((each["rows"], each["columns"]), (30, 40))
            numpy.testing.assert_array_equal(opened(base64.b64decode(each["picture"])),
                                             relievo.picture(self.image, each["name"]))
        self.assertIn("<iframe srcdoc=", page._repr_html_())

    def test_names_cannot_break_the_page(self):
        name = '</script><b "quoted" & @LAYERS@'
        image = relievo.to_image(numpy.zeros((2, 2), numpy.float32), name=name)
        path = self.folder / "odd.html"
        relievo.show(image, path=path)
        text = path.read_text(encoding="utf-8")
        self.assertEqual(text.count("</script>"), 1)
        layers = json.loads(re.search(r"^const layers = (.*);$", text, re.M)[1])
        self.assertEqual(layers[0]["name"], name)

    def test_a_scene_has_a_picture(self):
        path = self.folder / "triangle.obj"
        path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        scene = relievo.scene(path, size=(80, 60), color="red")
        shown = opened(scene._repr_png_())
        scene.render(self.folder / "scene.png")
        numpy.testing.assert_array_equal(shown, opened((self.folder / "scene.png").read_bytes()))
        self.assertGreater((shown[..., 0] > 100).sum(), 100)


if __name__ == "__main__":
    unittest.main()
