# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters that make materials, from Python: heights to normals, texture coordinates, tangents; and
the settings by name of all filters that describe them."""

import re
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource, vtkTexturedSphereSource

import relievo


class Normals(unittest.TestCase):
    def test_a_wave(self):
        columns, rows = 128, 64
        x, y = numpy.meshgrid(numpy.arange(columns) * 30.0, numpy.arange(rows) * 20.0)
        kx, ky = 2 * numpy.pi / (columns * 30.0), 4 * numpy.pi / (rows * 20.0)
        image = vtkImageData()
        image.SetDimensions(columns, rows, 1)
        image.SetSpacing(30, 20, 1)
        heights = 100 * numpy.sin(kx * x + ky * y)
        image.GetPointData().SetScalars(numpy_to_vtk(heights.ravel(), deep=1))
        maker = relievo.vtkRelievoHeightsToNormals()
        maker.SetInputData(image)
        maker.SetKernelToFourthOrder()
        maker.WrapColumnsOn()
        maker.WrapRowsOn()
        maker.Update()
        normals = relievo.layer(maker.GetOutput(), "normal")[::-1]  # layer: highest row first
        slope = 100 * numpy.cos(kx * x + ky * y)
        truth = numpy.stack([-kx * slope, -ky * slope, numpy.ones_like(slope)], axis=-1)
        truth /= numpy.linalg.norm(truth, axis=-1, keepdims=True)
        sine = numpy.linalg.norm(numpy.cross(normals, truth), axis=-1)
        self.assertLess(numpy.degrees(sine).mean(), 0.02)
        maker.SetEncodingToUnsignedChar()
        maker.Update()
        codes = relievo.layer(maker.GetOutput(), "normal")[::-1]
        self.assertEqual(codes.dtype, numpy.uint8)
        sine = numpy.linalg.norm(numpy.cross(codes * (2 / 255) - 1, truth), axis=-1)
        self.assertLess(numpy.degrees(sine).mean(), 0.3)


class Settings(unittest.TestCase):
    def check(self, made, name):
        """Get and the setting's name returns the value set by words, at both ends of its range."""
        words = (word.capitalize() for word in name.replace("srgb", "s_r_g_b").split("_"))
        got = getattr(made, "Get" + "".join(words))
        help_ = made.GetParameterHelp(name)
        choices = re.search(r"Takes one of ([^.]*)\.$", help_)
        least = r"number,? (?:from )?([\d.]+(?:e-\d+)?)"
        bounds = re.search(rf"{least} (?:to ([\d.e+]+)(?<!\.)|or more)", help_)
        if choices:
            places = []
            for word in choices[1].split(", "):
                self.assertEqual(made.TrySetParameter(name, word), "", name)
                places.append(got())
            self.assertEqual(places, list(range(places[0], places[0] + len(places))), name)
        elif " numbers" in help_.partition("Takes")[2]:
            counts = {"two": 2, "2": 2, "six": 6}
            (count,) = re.findall(r"Takes (?:a )?(\w+) (?:whole )?numbers", help_) or ["three"]
            values = tuple(range(4, 4 + counts.get(count, 3)))
            words = ("x" if "whole" in help_ else ",").join(map(str, values))
            self.assertEqual(made.TrySetParameter(name, words), "", name)
            self.assertEqual(tuple(got()), values, name)
        elif "Takes on or off" in help_:
            for value in (False, True):
                self.assertEqual(made.TrySetParameter(name, "on" if value else "off"), "", name)
                self.assertEqual(got(), value, name)
        elif " number" in help_.partition("Takes")[2]:
            least, most = bounds.groups() if bounds else ("3", None)
            for word in (least, most or "7"):
                self.assertEqual(made.TrySetParameter(name, word), "", name)
                self.assertEqual(got(), float(word), name)
        if "a text" not in help_:
            fault = made.TrySetParameter(name, "nonsense")
            self.assertIn("'nonsense' was given, expected", fault, name)
        self.assertEqual(made.TrySetParameter(name, made.GetParameterDefault(name)), "", name)
        self.assertEqual(made.GetParameter(name), made.GetParameterDefault(name), name)

    def test_by_name(self):
        checked = 0
        for kind in ("Caves", "EnvironmentConvert", "EnvironmentIrradiance",
                     "EnvironmentPrefilter", "HeightsToNormals", "SmoothBlocks",
                     "SurfaceParticles", "TextureCoordinates", "VoxelCubes",
                     "VoxelShell"):  # fmt: skip
            made = getattr(relievo, f"vtkRelievo{kind}")()
            for i in range(made.GetNumberOfParameters()):
                with self.subTest(kind, setting=made.GetParameterName(i)):
                    self.check(made, made.GetParameterName(i))
                checked += 1
        self.assertGreater(checked, 60)


class Meshes(unittest.TestCase):
    def test_coordinates_then_tangents(self):
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(32)
        sphere.SetPhiResolution(17)
        laid = relievo.vtkRelievoTextureCoordinates()
        laid.SetInputConnection(sphere.GetOutputPort())
        laid.SetMappingToSphere()
        maker = relievo.vtkRelievoTangents()
        maker.SetInputConnection(laid.GetOutputPort())
        maker.Update()
        mesh = maker.GetOutput()
        self.assertEqual(mesh.GetNumberOfPolys(), sphere.GetOutput().GetNumberOfPolys())
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        tangents = vtk_to_numpy(mesh.GetPointData().GetArray("tangent"))
        away = numpy.hypot(points[:, 0], points[:, 1]) > 1e-3  # a pole has no east
        east = numpy.stack([-points[:, 1], points[:, 0], 0 * points[:, 0]], axis=-1)[away]
        east /= numpy.linalg.norm(east, axis=-1, keepdims=True)
        cosine = (tangents[away, :3] * east).sum(axis=-1)
        self.assertGreater(cosine.min(), 0.99)
        self.assertTrue((tangents[away, 3] == 1).all())

    def test_names(self):
        sphere = vtkTexturedSphereSource()
        maker = relievo.vtkRelievoTangents()
        maker.SetInputConnection(sphere.GetOutputPort())
        maker.SetTangentsName("T")
        maker.Update()
        self.assertEqual(maker.GetOutput().GetPointData().GetArray("T").GetNumberOfComponents(), 4)
        self.assertIn("TangentsName: T", str(maker))


if __name__ == "__main__":
    unittest.main(verbosity=2)
