# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relief and normals by --height-map and --normal-map: pictures of a known plane."""

import json

import numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataWriter

from cli import CliTest, main, write_image

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
        # Seen straight from above, each pixel's surface is at the pixel's own u.
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

    def test_material(self):
        """Values of --material are those of the material; of two numbers with / between them."""
        seen = self.draw("--normal-map", "tilted.png", "--material", "normal_strength=0.5")
        x, z = 0.3 / numpy.hypot(0.3, 0.8), 0.8 / numpy.hypot(0.3, 0.8)
        numpy.testing.assert_allclose(seen["normal.X"], x, atol=0.006)
        numpy.testing.assert_allclose(seen["normal.Z"], z, atol=0.006)
        seen = self.draw("--height-map", "roof.png,0.5",
                         "--material", "height_range=0/2,depth_correction=on")  # fmt: skip
        below = 0.5 - 0.25 * (1 - abs(2 * self.u - 1))  # half as high, from the ground up
        depth = seen["depth.Z"][:, self.sure]
        numpy.testing.assert_allclose(depth, numpy.tile(5 + below[self.sure], (SIDE, 1)), atol=2e-3)
        seen = self.draw("--height-map", "roof.png,0.5", "--material", "depth_correction=off")
        numpy.testing.assert_allclose(seen["depth.Z"], 5, atol=1e-5)
        look = ["render", "plane.obj", "--png", "b.png", "--material"]
        self.before = self.names()
        self.refused(*look, "gloss=1", status=2, says=["--material", "gloss=1", "one of normal_st"])
        self.refused(*look, "repeat=2", status=2, says=["--material repeat", "on or off"])
        self.refused(*look, "repeat=on,repeat=off", status=2, says=["repeat=off", "each once"])
        self.refused(*look, "self_shadow=on", status=2, says=["self_shadow", "--height-map F"])
        self.refused(*look, "reflection_weight=0", status=2, says="--environment F")
        self.refused(*look, "bisections=3", "--height-map", "roof.png", "--relief", "steep",
                     status=2, says=["--material bisections", "--relief relief"])  # fmt: skip

    def test_refusals(self):
        """Invalid and missing maps are named, and nothing is written."""
        look = ["render", "plane.obj", "--png", "a.png"]
        (self.folder / "torn.png").write_text("not a picture")
        write_image(vtkPNGWriter(), self.folder / "grey.png", numpy.zeros((4, 4, 1), numpy.uint8))
        self.before = self.names()
        self.refused(*look, "--normal-map", "no.png", status=1, says="no.png")
        self.refused(*look, "--normal-map", "torn.png", status=1, says="torn.png")
        self.refused(*look, "--normal-map", "grey.png", status=1,
                     says=["grey.png", "red, green and blue"])  # fmt: skip
        self.refused(*look, "--height-map", "map.xyz", status=2, says=["--height-map", ".png"])
        self.refused(*look, "--height-map", "roof.png,-1", status=2, says=["--height-map", "-1"])
        self.refused(*look, "--relief", "steep", status=2, says="--height-map")
        self.refused(*look, "--relief", "deep", "--height-map", "roof.png", status=2,
                     says=["--relief", "deep", "parallax"])  # fmt: skip
        self.refused(*look, "--texture-coordinates", "box", status=2,
                     says=["--texture-coordinates", "--normal-map"])  # fmt: skip
        self.refused(*look, "--texture-coordinates", "cone", "--normal-map", "tilted.png", status=2,
                     says=["--texture-coordinates", "cone", "sphere"])  # fmt: skip

    def test_mesh_without_texture_coordinates(self):
        """As on a box: the same u and v as PLANE has, for its side is 2; that is said, once."""
        bare = "\n".join(line for line in PLANE.split("\n") if not line.startswith(("vt", "f")))
        (self.folder / "plane.obj").write_text(bare + "f 1 2 3 4\n")
        words = ["render", "plane.obj", "--normal-map", "tilted.png", "--png", "a.png"]
        said = self.relievo(*words).stderr
        self.assertEqual(said.count("\n"), 1, said)
        for text in ("relievo: plane.obj", "no texture coordinates", "box",
                     "--texture-coordinates"):  # fmt: skip
            self.assertIn(text, said)
        self.test_relief()
        self.test_normal_map()
        for method in ("box", "plane", "sphere"):  # asked for: nothing is noted
            self.assertEqual(self.relievo(*words, "--texture-coordinates", method).stderr, "")
        self.assertEqual(self.relievo(*words[:2], "--png", "b.png").stderr, "")

    def test_blocks_without_texture_coordinates(self):
        """Of a file's blocks, those without get some: one map lies alike on both."""
        (self.folder / "bare.obj").write_text(
            "\n".join(line for line in PLANE.split("\n") if not line.startswith(("vt", "f")))
            + "f 1 2 3 4\n"
        )
        blocks = vtkMultiBlockDataSet()
        for i, name in enumerate(("plane.obj", "bare.obj")):
            reader = vtkOBJReader()
            reader.SetFileName(str(self.folder / name))
            half = vtkTransformFilter()
            turn = vtkTransform()
            turn.Translate(i - 0.5, 0, 0)
            turn.Scale(0.5, 1, 1)
            half.SetTransform(turn)
            half.SetInputConnection(reader.GetOutputPort())
            half.Update()
            blocks.SetBlock(i, half.GetOutput())
        writer = vtkXMLMultiBlockDataWriter()
        writer.SetFileName(str(self.folder / "blocks.vtm"))
        writer.SetInputData(blocks)
        writer.Write()
        said = self.relievo("render", "blocks.vtm", *LOOK, "--normal-map", "tilted.png", "--exr",
                            "a.exr", "--layers", "normal,block").stderr  # fmt: skip
        self.assertEqual(said.count("no texture coordinates"), 1, said)
        seen = self.exr("a.exr")[1]
        self.assertEqual(len(numpy.unique(seen["block.id"])), 2)
        for axis, value in zip("XYZ", (0.6, 0.0, 0.8)):
            numpy.testing.assert_allclose(seen[f"normal.{axis}"], value, atol=0.006)

    def test_box(self):
        """On a cube the map stands upright on every side, u to the right seen from outside."""
        cube = "".join(f"v {x} {y} {z}\n" for z in (-1, 1) for y in (-1, 1) for x in (-1, 1))
        cube += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
        (self.folder / "cube.obj").write_text(cube)
        for up, sides in (
            ((0, 1, 0), ((1, 0, 0), (-1, 0, 0), (0, 0, 1), (0, 0, -1))),
            ((0, 0, 1), ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0))),
        ):
            for side in map(numpy.array, sides):
                camera = ",".join(map(str, [*(5 * side), 0, 0, 0, *up]))
                self.relievo("render", "cube.obj", "--camera", camera, "--parallel-scale", "0.9",
                             "--size", "20x20", "--normal-map", "tilted.png", "--exr", "a.exr",
                             "--up", "xyz"[up.index(1)], "--layers", "normal")  # fmt: skip
                seen = self.exr("a.exr")[1]
                truth = 0.6 * numpy.cross(up, side) + 0.8 * side
                for axis, value in zip("XYZ", truth):
                    numpy.testing.assert_allclose(seen[f"normal.{axis}"], value, atol=0.006)

    def test_gltf(self):
        """Images stand on a glTF model as its own textures do, though its v counts downwards."""
        corners = numpy.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], numpy.float32)
        normals = numpy.tile(numpy.array([0, 0, 1], numpy.float32), (4, 1))
        texture = numpy.array([(0, 1), (1, 1), (1, 0), (0, 0)], numpy.float32)
        triangles = numpy.array([0, 1, 2, 0, 2, 3], numpy.uint16)
        parts = [part.tobytes() for part in (corners, normals, texture, triangles)]
        starts = numpy.cumsum([0] + [len(part) for part in parts])
        (self.folder / "plane.bin").write_bytes(b"".join(parts))
        (self.folder / "plane.gltf").write_text(json.dumps({
            "asset": {"version": "2.0"},
            "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{
                "attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2},
                "indices": 3, "material": 0}]}],
            "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
                                                    "metallicFactor": 0}}],
            "textures": [{"source": 0}], "images": [{"uri": "halves.png"}],
            "buffers": [{"uri": "plane.bin", "byteLength": int(starts[-1])}],
            "bufferViews": [{"buffer": 0, "byteOffset": int(start), "byteLength": len(part)}
                            for start, part in zip(starts, parts)],
            "accessors": [
                {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                 "min": [-1, -1, 0], "max": [1, 1, 0]},
                {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
                {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
                {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"},
            ],
        }))  # fmt: skip
        halves = numpy.zeros((64, 64, 3), numpy.uint8)
        halves[32:] = 255  # the upper half of the image
        write_image(vtkPNGWriter(), self.folder / "halves.png", halves)
        upwards = numpy.round((numpy.array([0, 0.6, 0.8]) * 0.5 + 0.5) * 255).astype(numpy.uint8)
        write_image(vtkPNGWriter(), self.folder / "up.png", numpy.tile(upwards, (8, 8, 1)))
        self.relievo("render", "plane.gltf", *LOOK, "--height-map", "halves.png,0.2",
                     "--normal-map", "up.png", "--exr", "a.exr",
                     "--layers", "depth,normal,albedo")  # fmt: skip
        seen = self.exr("a.exr")[1]
        upper, lower = slice(5, SIDE // 2 - 5), slice(SIDE // 2 + 5, SIDE - 5)
        numpy.testing.assert_allclose(seen["depth.Z"][upper], 5, atol=1e-4)
        numpy.testing.assert_allclose(seen["depth.Z"][lower], 5.2, atol=1e-4)
        numpy.testing.assert_allclose(seen["normal.Y"], 0.6, atol=0.006)
        self.assertGreater(seen["albedo.G"][upper].min(), 0.99)
        self.assertLess(seen["albedo.G"][lower].max(), 0.01)

    def test_sphere(self):
        """Longitude is u: heights that rise in the upper half of the map lie there on a ball."""
        v = (numpy.arange(SIZE) + 0.5) / SIZE
        halves = numpy.repeat((v > 0.5)[:, None, None], SIZE, axis=1)
        write_image(vtkPNGWriter(), self.folder / "halves.png", (halves * 255).astype(numpy.uint8))
        rings, around = numpy.linspace(-1.5, 1.5, 40), numpy.linspace(0, 2 * numpy.pi, 80)[:-1]
        points = [(numpy.cos(a) * numpy.cos(b), numpy.sin(a), numpy.cos(a) * numpy.sin(b))
                  for a in rings for b in around]  # fmt: skip
        ball = "".join("v {:.6f} {:.6f} {:.6f}\n".format(*point) for point in points)
        for ring in range(39):
            for i in range(79):
                low, next_low = 79 * ring + i + 1, 79 * ring + (i + 1) % 79 + 1
                ball += f"f {low} {low + 79} {next_low + 79} {next_low}\n"
        (self.folder / "ball.obj").write_text(ball)
        self.relievo("render", "ball.obj", *LOOK, "--height-map", "halves.png,0.2", "--exr",
                     "a.exr", "--texture-coordinates", "sphere")  # fmt: skip
        depth = self.exr("a.exr")[1]["depth.Z"]
        upper, lower = depth[SIDE // 2 - 8, SIDE // 2], depth[SIDE // 2 + 8, SIDE // 2]
        surface = 5 - numpy.sqrt(1 - 0.15**2)
        self.assertAlmostEqual(float(upper), surface, delta=0.02)
        self.assertAlmostEqual(float(lower), surface + 0.2, delta=0.03)


if __name__ == "__main__":
    main()
