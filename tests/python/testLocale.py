# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers, writers and words in a program with the user's locale, whose decimal point is a comma
and whose small i may have no dot: their texts and results are as everywhere."""

import json
import locale
import pathlib
import tempfile
import unittest

import locales
import numpy
import relievo
import scenes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkTIFFWriter
from vtkmodules.vtkRenderingCore import vtkLight

CORNERS = ((0.25, 0.25, 0.5), (1.75, 0.5, 0.5), (0.5, 1.75, 0.5))
ROWS = [" ".join(map(str, corner)) for corner in CORNERS]
MESHES = {
    "a.OFF": "OFF\n3 1 0\n" + "\n".join(ROWS) + "\n3 0 1 2\n",
    "a.obj": "".join(f"v {row}\n" for row in ROWS) + "f 1 2 3\n",
    "a.stl": "solid a\nfacet normal 0 0 1\nouter loop\n"
             + "".join(f"vertex {row}\n" for row in ROWS) + "endloop\nendfacet\nendsolid a\n",
    "a.PLY": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
             "end_header\n" + "\n".join(ROWS) + "\n3 0 1 2\n",
    "a.x": "xof 0303txt 0032\nMesh a {\n3;\n"
           + ",\n".join(";".join(map(str, corner)) + ";" for corner in CORNERS)
           + ";\n1;\n3;0,1,2;;\n}\n",
}


def write_gltf(folder):
    numpy.array(CORNERS, "<f4").tofile(folder / "a.bin")
    (folder / "a.gltf").write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"uri": "a.bin", "byteLength": 36}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0.25, 0.25, 0.5], "max": [1.75, 1.75, 0.5]}],
    }))


def write_hdr(path):
    """A picture of 4 x 2 texels of radiance 0.5, with a number in its header."""
    path.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1.0\n\n-Y 2 +X 4\n"
                     + bytes((128, 128, 128, 128)) * 8)


def points_of(mesh):
    """The points of all polydata in a reader's output."""
    data = [mesh]
    if mesh.IsA("vtkCompositeDataSet"):
        data = []
        blocks = mesh.NewIterator()
        blocks.InitTraversal()
        while not blocks.IsDoneWithTraversal():
            data.append(blocks.GetCurrentDataObject())
            blocks.GoToNextItem()
    return numpy.concatenate([vtk_to_numpy(each.GetPoints().GetData()) for each in data
                              if each.IsA("vtkPolyData") and each.GetNumberOfPoints()])


class Locale(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        locales.make(cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.files = pathlib.Path(self.folder.name)
        self.addCleanup(locale.setlocale, locale.LC_ALL, "C")

    def each(self):
        """Each locale, while it is the program's."""
        for name in locales.NAMES:
            locale.setlocale(locale.LC_ALL, name)
            self.assertEqual(locale.localeconv()["decimal_point"], ",")
            yield name

    def test_meshes(self):
        for name, text in MESHES.items():
            (self.files / name).write_text(text)
        write_gltf(self.files)
        for _ in self.each():
            for name in (*MESHES, "a.gltf"):
                with self.subTest(name):
                    kind = relievo.vtkRelievoOFFReader if name == "a.OFF" else (
                        relievo.vtkRelievoModelReader)
                    reader = kind()
                    reader.SetFileName(str(self.files / name))
                    reader.Update()
                    found = points_of(reader.GetOutputDataObject(0))
                    # Models of x may be mirrored; coordinates keep their places after the point.
                    self.assertEqual(sorted(map(tuple, numpy.abs(found))), sorted(CORNERS))

    def test_scene(self):
        """Files that `relievo render` reads by VTK's readers."""
        texts = {name: MESHES[name] for name in ("a.stl", "a.PLY", "a.obj", "a.OFF")}
        texts["a.vtk"] = ("# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                          + " ".join(ROWS) + "\nPOLYGONS 1 4\n3 0 1 2\n")  # fmt: skip
        for name, text in texts.items():
            (self.files / name).write_text(text)
        for _ in self.each():
            for name in texts:
                with self.subTest(name):
                    shown = relievo.scene(str(self.files / name)).renderer
                    bounds = shown.ComputeVisiblePropBounds()
                    self.assertEqual(bounds, (0.25, 1.75, 0.25, 1.75, 0.5, 0.5))
                    self.assertEqual(locale.localeconv()["decimal_point"], ",")

    def test_images(self):
        """Of an environment, by their names in capitals."""
        write_hdr(self.files / "SHINING.HDR")
        image = vtkImageData()
        image.SetDimensions(4, 2, 1)
        image.AllocateScalars(3, 3)
        vtk_to_numpy(image.GetPointData().GetScalars())[:] = 200
        tiff = vtkTIFFWriter()
        tiff.SetFileName(str(self.files / "SHINING.TIFF"))
        tiff.SetInputData(image)
        tiff.Write()
        sky = relievo.to_image({"color": numpy.full((2, 4, 3), 0.375, "f4")})
        relievo.write_exr(self.files / "SHINING.EXR", sky)
        expected = {"SHINING.HDR": 0.5, "SHINING.EXR": 0.375, "SHINING.TIFF": 200}
        for _ in self.each():
            for name, value in expected.items():
                with self.subTest(name):
                    renderer = scenes.plane_and_sphere()
                    made = relievo.environment(renderer, self.files / name)
                    values = vtk_to_numpy(made.GetImage().GetPointData().GetScalars())
                    numpy.testing.assert_allclose(values, value, rtol=0.01)

    def test_exr(self):
        """Pixels and attributes, the lights' among them, that are numbers in text."""
        light = vtkLight()
        light.SetPosition(0.5, 1.5, 2.25)
        light.SetIntensity(0.75)
        for _ in self.each():
            renderer = scenes.plane_and_sphere()
            renderer.AddLight(light)
            image = relievo.capture(renderer, ["depth"], (30, 20))
            relievo.write_exr(self.files / "a.exr", image)
            back = relievo.read_exr(self.files / "a.exr")
            numpy.testing.assert_array_equal(relievo.layer(back, "depth"),
                                             relievo.layer(image, "depth"))
            for made in (image, back):
                told = json.loads(relievo.attributes(made)["lights"][0])
                self.assertEqual(told["position"], [0.5, 1.5, 2.25])
                self.assertEqual(told["intensity"], 0.75)

    def test_words(self):
        """Parameters, reports, and printed numbers."""
        for _ in self.each():
            renderer = scenes.plane_and_sphere()
            window = scenes.window_of(renderer, 30, 20)
            window.Render()
            tone = relievo.stage(renderer, "tone", exposure=0.5)
            self.assertEqual(tone.GetParameter("exposure"), "0.5")
            self.assertEqual(tone.TrySetParameter("exposure", "1.25"), "")
            self.assertEqual(tone.GetExposure(), 1.25)
            window.Render()
            self.assertTrue(relievo.report(renderer)["stages"])


if __name__ == "__main__":
    unittest.main()
