# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""layers(): the catalogue agrees with captures and with the documents."""

import os
import pathlib
import re
import unittest

import numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkPointSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer

import relievo
import scenes

LAYERS = relievo.layers()
DOCS = pathlib.Path(os.environ["RELIEVO_EXAMPLES"]).parent / "docs"
TYPES = {"float": numpy.float32, "double": numpy.float64, "int": numpy.int32,
         "unsigned char": numpy.uint8}  # fmt: skip


def is_kind(words, layer):
    """Whether words such as "3 float" are the layer's components and type."""
    count, word = re.fullmatch(r"(?:(\d+) )?(\w+)", words).groups()
    word = {"uchar": "unsigned char", "uint8": "unsigned char"}.get(word, word)
    return (int(count or 1), word) == (layer["components"], layer["type"])


def is_background(words, layer):
    """Whether words such as "+∞" are the layer's background."""
    if layer["background"] is None:
        return "renderer's" in words
    if words == "NaN":
        return numpy.isnan(layer["background"])
    numbers = {"+∞": numpy.inf, "+infinity": numpy.inf, "−1": -1}
    return numbers.get(words, words) == layer["background"] or words == f"{layer['background']:g}"


class Catalogue(unittest.TestCase):
    def test_names(self):
        for name, layer in LAYERS.items():
            self.assertTrue(layer["help"], name)
        for layer in (-1, len(LAYERS)):
            self.assertEqual(relievo.vtkRelievoLayerCatalogue.GetLayerName(layer), "")
            self.assertEqual(relievo.vtkRelievoLayerCatalogue.GetLayerType(layer), "")

    def test_lights(self):
        catalogue = relievo.vtkRelievoLayerCatalogue
        for name, light in (("shadow_0", 0), ("shadow_12", 12), ("shadow_", -1), ("shadow_x", -1),
                            ("shadow_1x", -1), ("shadow_-1", -1), ("shadow_1000", -1),
                            ("Shadow_1", -1), ("depth", -1), ("", -1)):  # fmt: skip
            self.assertEqual(catalogue.GetLight(name), light, name)
            self.assertEqual(catalogue.GetIsLayer(name), light >= 0 or name == "depth", name)

    def test_legends(self):
        """Titles are plain words; arrays keep their names."""
        for layer, title in (("depth", "Depth"), ("range", "Distance"),
                             ("light_depth", "Light depth"), ("shadow_0", "Shadow of light 0"),
                             ("shadow_key_light", "Shadow of key light"),
                             ("wall_shear", "wall_shear")):  # fmt: skip
            stage = relievo.vtkRelievoDisplayStage()
            stage.SetLayer(layer)
            stage.SetRange(0, 1)
            legend = relievo.vtkRelievoLayerLegend()
            self.assertTrue(legend.Follow(stage, False), layer)
            self.assertEqual(legend.GetTitle(), title)

    def test_captured(self):
        """A sphere that leaves the corners to the background."""
        renderer = vtkRenderer()
        scenes.add(renderer, vtkSphereSource())
        renderer.SetBackground(0.0, 0.5, 1.0)
        corners = vtkPlaneSource()  # lamps in front of the sphere
        corners.SetResolution(1, 1)
        corners.Push(1.0)
        pane = vtkPlaneSource()
        pane.SetOrigin(-0.3, -0.3, 0.6)
        pane.SetPoint1(0.3, -0.3, 0.6)
        pane.SetPoint2(-0.3, 0.3, 0.6)
        scenes.add(renderer, pane).GetProperty().SetOpacity(0.5)
        relievo.lamps(renderer, corners, radius=2)
        middle = vtkPointSource()
        middle.SetNumberOfPoints(1)
        middle.SetRadius(0)
        relievo.fog(renderer, middle, radius=0.6)
        relievo.markers(renderer, middle, shape="disc", radius=0.6)
        ball = scenes.dense_ball()
        ball.SetPosition(0, 0, 0.6)
        renderer.AddVolume(ball)
        names = [name.replace("shadow_N", "shadow_0") for name in LAYERS]
        image = relievo.capture(renderer, names, size=(61, 47))
        for name, layer in zip(names, LAYERS.values()):
            with self.subTest(name):
                values = relievo.layer(image, name)
                self.assertEqual(values.dtype, TYPES[layer["type"]])
                self.assertEqual(values[0, 0].size, layer["components"])
                if layer["background"] is None:
                    self.assertAlmostEqual(values[0, 0, 1], 0.2140, delta=0.003)  # 0.5 of sRGB
                else:
                    numpy.testing.assert_array_equal(values[0, 0], layer["background"])
                if name not in ("shadow_0", "light_depth", "ambient"):  # nothing is hidden
                    background = layer["background"] or 0
                    self.assertFalse((values[23, 30] == background).all(), values[23, 30])


class Documents(unittest.TestCase):
    def compare(self, rows, where):
        found = {}
        for names, kind, background in rows:
            for name in names:
                self.assertTrue(name in LAYERS, f"{where} has a row of {name}, which is no layer")
                self.assertTrue(is_kind(kind, LAYERS[name]), (name, kind))
                self.assertTrue(is_background(background, LAYERS[name]), (name, background))
                found[name] = True
        self.assertEqual(set(LAYERS) - set(found), set(), f"have no row in {where}")

    def test_page(self):
        page = (DOCS / "layers.md").read_text(encoding="utf-8")
        rows = [re.split(r" *\| *", line)[1:-1] for line in page.splitlines()
                if line.startswith("| `")]  # fmt: skip
        table = [([re.search("`(.+?)`", row[0])[1]], row[1], row[3])
                 for row in rows if len(row) == 4]  # fmt: skip
        self.compare(table, "docs/layers.md")

    def test_package(self):
        lines = relievo.__doc__.splitlines()
        bars = [i for i, line in enumerate(lines) if line.startswith("====")]
        columns = [(m.start(), m.end()) for m in re.finditer("=+", lines[bars[0]])]
        rows = []
        for line in lines[bars[1] + 1 : bars[2]]:
            name, kind, _, background = (line[a:b].strip() for a, b in columns)
            if not name.startswith("any array"):
                rows.append((name.split(), kind, background))
        self.compare(rows, "the docstring of python/relievo/__init__.py")


if __name__ == "__main__":
    unittest.main()
