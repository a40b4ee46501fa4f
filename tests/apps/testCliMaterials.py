# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relief and normals by --height-map and --normal-map: what must be seen on a known plane."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

from cli import CliTest, main

# Half width 1, at z = 0, u along x and v along y.
PLANE = """v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1 2/2 3/3 4/4
"""
SIDE = 100
LOOK = ["--camera", "0,0,5,0,0,0,0,1,0", "--clip", "1,10", "--parallel-scale", "1",
        "--size", f"{SIDE}x{SIDE}"]  # fmt: skip
SIZE = 128


def write_image(writer, path, values):
    """Values (rows, columns, components), the first row at v = 0."""
    rows, columns, components = values.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    flat = numpy.ascontiguousarray(values).reshape(-1, components)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


class Materials(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "plane.obj").write_text(PLANE)
        # A roof over the middle: heights 0 at u = 0 and 1, 1 at u = 1/2.
        u = (numpy.arange(SIZE) + 0.5) / SIZE
        roof = numpy.tile(1 - abs(2 * u - 1), (SIZE, 1))[..., None]
        write_image(vtkPNGWriter(), self.folder / "roof.png", (roof * 65535).astype(numpy.uint16))
        tilted = numpy.array([0.6, 0.0, 0.8]) * 0.5 + 0.5
        bytes_of_it = numpy.round(tilted * 255).astype(numpy.uint8)
        write_image(vtkPNGWriter(), self.folder / "tilted.png", numpy.tile(bytes_of_it, (8, 8, 1)))
        self.before = self.names()
        # Straight down, what is seen at a pixel is at its own u.
        self.u = (numpy.arange(SIDE) + 0.5) / SIDE
        self.sure = (abs(self.u - 0.5) > 0.03) & (self.u > 0.03) & (self.u < 0.97)

    def draw(self, *words):
        self.relievo("render", "plane.obj", *LOOK, *words, "--exr", "a.exr",
                     "--layers", "depth,normal")  # fmt: skip
        return self.exr("a.exr")[1]

    def test_relief(self):
        """Depth and normals are those of the roof."""
        seen = self.draw("--height-map", "roof.png,0.5")
        below = 0.5 * abs(2 * self.u - 1)
        depth = seen["depth.Z"][:, self.sure]
        numpy.testing.assert_allclose(depth, numpy.tile(5 + below[self.sure], (SIDE, 1)), atol=1e-3)
        # Rises by 0.5 over a length of 1 on the left, falls on the right.
        x = numpy.where(self.u < 0.5, -0.5, 0.5) / numpy.hypot(1, 0.5)
        normal = seen["normal.X"][:, self.sure]
        numpy.testing.assert_allclose(normal, numpy.tile(x[self.sure], (SIDE, 1)), atol=2e-3)

    def test_off(self):
        """Heights as normals only: the plane's depth stays."""
        seen = self.draw("--height-map", "roof.png,0.5", "--relief", "off")
        numpy.testing.assert_allclose(seen["depth.Z"], 5, atol=1e-5)
        self.assertGreater(abs(seen["normal.X"]).mean(), 0.3)

    def test_default_scale(self):
        """0.02 of the longest side, which is 2."""
        seen = self.draw("--height-map", "roof.png")
        self.assertAlmostEqual(float(seen["depth.Z"].max()), 5.04, delta=0.001)

    def test_normal_map(self):
        """Every normal is the map's."""
        seen = self.draw("--normal-map", "tilted.png")
        for axis, value in zip("XYZ", (0.6, 0.0, 0.8)):
            numpy.testing.assert_allclose(seen[f"normal.{axis}"], value, atol=0.006)

    def test_refusals(self):
        """What is no map, or not there, is named, and nothing is written."""
        look = ["render", "plane.obj", "--png", "a.png"]
        (self.folder / "torn.png").write_text("not a picture")
        self.before = self.names()
        self.refused(*look, "--normal-map", "no.png", status=1, says="no.png")
        self.refused(*look, "--normal-map", "torn.png", status=1, says="torn.png")
        self.refused(*look, "--height-map", "map.xyz", status=2, says=["--height-map", ".png"])
        self.refused(*look, "--height-map", "roof.png,-1", status=2, says=["--height-map", "-1"])
        self.refused(*look, "--relief", "steep", status=2, says="--height-map")
        self.refused(*look, "--relief", "deep", "--height-map", "roof.png", status=2,
                     says=["--relief", "deep", "parallax"])  # fmt: skip
        # A mesh without texture coordinates.
        self.refused("render", "triangle.off", "--normal-map", "tilted.png", "--png", "a.png",
                     status=1, says="texture coordinates")  # fmt: skip


if __name__ == "__main__":
    main()
