# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Environments from Python: real worlds of Debian's blender-data, an .hdr file, against numpy."""

import os
import tempfile
import unittest
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkHDRReader

import relievo

DATA = Path(os.environ["RELIEVO_DATA"])


def image_of(array):
    """vtkImageData of an array (slices, rows, columns, 3)."""
    image = vtkImageData()
    image.SetDimensions(array.shape[2], array.shape[1], array.shape[0])
    values = numpy_to_vtk(numpy.ascontiguousarray(array.reshape(-1, 3), numpy.float32), deep=1)
    values.SetName("radiance")
    image.GetPointData().SetScalars(values)
    return image


def texels(image):
    """The array (slices, rows, columns, 3) of an image's scalars."""
    columns, rows, slices = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(slices, rows, columns, 3)


def equirectangular(rows):
    """Unit directions and solid angles of a 2:1 image: +x in the middle, +z to its right."""
    latitude = numpy.pi * ((numpy.arange(rows) + 0.5) / rows - 0.5)
    longitude = 2 * numpy.pi * ((numpy.arange(2 * rows) + 0.5) / (2 * rows) - 0.5)
    across = numpy.cos(latitude)[:, None]
    directions = numpy.stack(
        [
            across * numpy.cos(longitude),
            numpy.sin(latitude)[:, None] + 0 * longitude,
            across * numpy.sin(longitude),
        ],
        axis=-1,
    )
    edges = numpy.sin(numpy.pi * (numpy.arange(rows + 1) / rows - 0.5))
    angles = numpy.diff(edges)[:, None] * (numpy.pi / rows) + 0 * longitude
    return directions, angles


def cube(n):
    """Unit directions and solid angles of n x n x 6, as OpenGL's specification has them."""
    at = (numpy.arange(n) + 0.5) * 2 / n - 1
    s, t = numpy.meshgrid(at, at)
    one = numpy.ones_like(s)
    faces = numpy.stack(
        [
            numpy.stack(face, axis=-1)
            for face in (
                (one, -t, -s),
                (-one, -t, s),
                (s, one, t),
                (s, -one, -t),
                (s, -t, one),
                (-s, -t, -one),
            )
        ]
    )
    length = numpy.linalg.norm(faces, axis=-1)
    return faces / length[..., None], 4 / n**2 / length**3


def convert(image, projection="Cube", size=0):
    maker = relievo.vtkRelievoEnvironmentConvert()
    maker.SetInputData(image)
    getattr(maker, f"SetOutputProjectionTo{projection}")()
    maker.SetOutputSize(size)
    maker.Update()
    return maker.GetOutput()


class Worlds(unittest.TestCase):
    """The files' content is computed by numpy, in double, from the full image."""

    @classmethod
    def setUpClass(cls):
        cls.worlds = {}
        for name in ("forest", "studio", "sunset"):
            image = relievo.read_exr(DATA / f"{name}.exr")
            cls.worlds[name] = image, texels(image).astype(float)[0]

    def test_the_light_stays(self):
        for name, (image, light) in self.worlds.items():
            directions, angles = equirectangular(light.shape[0])
            flux = (light * angles[..., None]).sum(axis=(0, 1))
            toward = numpy.einsum("ijc,ij,ijk->kc", light, angles, directions)
            made = texels(convert(image, size=128)).astype(float)
            directions, angles = cube(128)
            off = (made * angles[..., None]).sum(axis=(0, 1, 2)) / flux - 1
            print(f"{name}: light lost or added {abs(off).max():.1e}")
            self.assertLess(abs(off).max(), 2e-3, name)
            # It also comes from the same directions.
            moved = numpy.einsum("fijc,fij,fijk->kc", made, angles, directions) - toward
            self.assertLess(abs(moved / flux).max(), 2e-3, name)

    def test_there_and_back(self):
        image, light = self.worlds["studio"]
        back = texels(convert(convert(image, size=512), "Equirectangular", 512))[0]
        apart = abs(back - light).mean() / light.mean()
        print(f"studio: to a cube of 512 and back, {apart:.4f} of the mean light apart")
        self.assertLess(apart, 0.08)  # lamps with sharp edges

    def test_irradiance(self):
        for name, (image, light) in self.worlds.items():
            directions, angles = equirectangular(light.shape[0])
            maker = relievo.vtkRelievoEnvironmentIrradiance()
            maker.SetInputData(image)
            maker.Update()
            self.assertEqual(maker.GetOutput().GetNumberOfRows(), 9)
            worst = 0
            scale = 0
            for normal in numpy.vstack([numpy.eye(3), -numpy.eye(3), [[0.6, 0.64, -0.48]]]):
                cosine = numpy.maximum(directions @ normal, 0) * angles
                truth = numpy.einsum("ijc,ij->c", light, cosine)
                got = [0.0] * 3
                maker.GetIrradiance(normal, got)
                worst = max(worst, abs(numpy.array(got) - truth).max())
                scale = max(scale, truth.max())
            print(f"{name}: irradiance by 9 numbers, {worst / scale:.4f} of the largest off")
            self.assertLess(worst / scale, 0.09, name)

    def test_rough_mirrors(self):
        for name, (image, light) in self.worlds.items():
            maker = relievo.vtkRelievoEnvironmentPrefilter()
            maker.SetInputData(image)
            maker.SetSize(64)
            maker.SetLevels(5)
            maker.Update()
            levels = maker.GetOutput()
            self.assertEqual(levels.GetNumberOfBlocks(), 5)
            sharp = texels(levels.GetBlock(0)).astype(float)
            sharp_directions, sharp_angles = cube(64)
            worst = 0
            for level in range(1, 5):
                rough = texels(levels.GetBlock(level)).astype(float)
                self.assertTrue(numpy.isfinite(rough).all())
                self.assertLessEqual(rough.max(), sharp.max() * 1.0001)
                alpha2 = (level / 4) ** 4
                directions, _ = cube(64 >> level)
                rng = numpy.random.default_rng(7)
                for _ in range(12):
                    place = tuple(rng.integers(0, size) for size in directions.shape[:3])
                    x = sharp_directions @ directions[place]
                    half = (1 + x) / 2 * (alpha2 - 1) + 1
                    weight = numpy.where(x > 0, x / half**2, 0) * sharp_angles
                    truth = numpy.einsum("fijc,fij->c", sharp, weight) / weight.sum()
                    worst = max(worst, abs(rough[place] / truth - 1).max())
            print(f"{name}: rough mirrors against a plain sum, worst {worst:.4f}")
            self.assertLess(worst, 0.02, name)

    def test_a_sphere_map(self):
        ball = relievo.read_exr(DATA / "metal_shiny.exr")
        columns, rows, _ = ball.GetDimensions()
        self.assertEqual(columns, rows)
        middle = texels(ball)[0, rows // 2 - 4 : rows // 2 + 4, columns // 2 - 4 : columns // 2 + 4]
        made = texels(convert(ball, size=64))
        # The ball's middle shows +z, which is the middle of the cube's fifth face.
        found = made[4, 30:34, 30:34]
        self.assertLess(abs(found.mean((0, 1)) / middle.mean((0, 1)) - 1).max(), 0.05)


class Files(unittest.TestCase):
    def test_hdr(self):
        """An .hdr whose highest quarter is lit: light from +y, in both readers' row order."""
        # VTK 9.7.0 reads no file of up to 512 bytes: it takes the header's end from the file's.
        pixels = numpy.zeros((16, 32, 4), numpy.uint8)
        pixels[:4] = (128, 64, 32, 129)  # the file's first row is the top; times 2 / 256
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "top.hdr"
            head = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16 +X 32\n"
            path.write_bytes(head + pixels.tobytes())
            reader = vtkHDRReader()
            reader.SetFileName(str(path))
            reader.Update()
            image = reader.GetOutput()
        made = texels(convert(image, size=16))
        numpy.testing.assert_allclose(made[2, 7:9, 7:9].mean((0, 1)), [1, 0.5, 0.25], rtol=1e-2)
        self.assertEqual(made[3, 7:9, 7:9].max(), 0)

    def test_errors(self):
        maker = relievo.vtkRelievoEnvironmentConvert()
        said = []
        maker.AddObserver("ErrorEvent", lambda *_: said.append(1))
        maker.SetInputData(image_of(numpy.zeros((1, 3, 5, 3))))
        maker.Update()
        self.assertEqual(len(said), 1)
        self.assertEqual(maker.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
