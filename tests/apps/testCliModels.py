# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Models with bones: times, frames, blends, looks inside, notes, and words refused."""

import json
import os
import pathlib
import shutil
import struct
import zlib

import numpy

import srgb
from cli import CliTest, main

MODELS = pathlib.Path(os.environ["RELIEVO_DATA"]) / "models"
SKIN = "simple_skin.gltf"
WALK = "01_01.bvh"
TUBE = "animation_with_skeleton.fbx"


def png(texels):
    """A PNG of bytes (rows, columns, 3), the top row first."""
    rows, columns, _ = texels.shape

    def chunk(name, data):
        named = name + data
        return struct.pack(">I", len(data)) + named + struct.pack(">I", zlib.crc32(named))

    lines = b"".join(b"\0" + row.tobytes() for row in texels)
    header = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines))
            + chunk(b"IEND", b""))  # fmt: skip


def square_glb(colors, normals):
    """A square from -1 to 1 that looks along z, with these images in the file, as glTF places them:
    the top row at its upper edge."""
    places = numpy.float32([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
    coordinates = numpy.float32([[0, 1], [1, 1], [1, 0], [0, 0]])
    facing = numpy.float32([[0, 0, 1]] * 4)
    corners = numpy.uint16([0, 1, 2, 0, 2, 3])
    data, views = b"", []
    for part in (*(each.tobytes() for each in (places, facing, coordinates, corners)),
                 png(colors), png(normals)):  # fmt: skip
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
        data += part + b"\0" * (-len(part) % 4)
    kinds = (("VEC3", 5126, 4), ("VEC3", 5126, 4), ("VEC2", 5126, 4), ("SCALAR", 5123, 6))
    accessors = [{"bufferView": i, "type": kind, "componentType": of, "count": count}
                 for i, (kind, of, count) in enumerate(kinds)]  # fmt: skip
    accessors[0].update(min=[-1, -1, 0], max=[1, 1, 0])
    material = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                "normalTexture": {"index": 1}}  # fmt: skip
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3,
                 "material": 0}  # fmt: skip
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}], "meshes": [{"primitives": [primitive]}], "materials": [material],
        "samplers": [{"magFilter": 9728, "minFilter": 9728}],
        "textures": [{"source": i, "sampler": 0} for i in range(2)],
        "images": [{"bufferView": i, "mimeType": "image/png"} for i in (4, 5)],
        "buffers": [{"byteLength": len(data)}], "bufferViews": views, "accessors": accessors,
    }).encode()  # fmt: skip
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + 8 + len(data)
    return (struct.pack("<4sIII4s", b"glTF", 2, size, len(text), b"JSON") + text
            + struct.pack("<I4s", len(data), b"BIN\0") + data)  # fmt: skip


class Models(CliTest):
    def setUp(self):
        super().setUp()
        for path in (f"glTF2/simple_skin/{SKIN}", f"BVH/{WALK}", f"FBX/{TUBE}"):
            shutil.copy(MODELS / path, self.folder)
        self.before = self.names()

    def depths(self, name, *words):
        """The depth layer of a fixed view."""
        self.relievo("render", name, "--size", "80x60", "--camera", "0,1,6,0,1,0,0,1,0",
                     "--clip", "0.1,100", "--exr", "a.exr", *words)  # fmt: skip
        return self.exr("a.exr")[1]["depth.Z"]

    def test_times_of_a_bent_strip(self):
        """glTF's simple skin, a strip in the plane z = 0, bends left and right and comes back."""
        rest = numpy.isfinite(self.depths(SKIN, "--time", "0"))
        self.assertGreater(rest.sum(), 100)
        left = numpy.isfinite(self.depths(SKIN, "--time", "1.5"))
        right = numpy.isfinite(self.depths(SKIN, "--time", "3.5"))
        self.assertGreater((left != rest).sum(), 100)
        middle = numpy.argwhere(rest)[:, 1].mean()
        lean = [numpy.argwhere(each)[:, 1].mean() - middle for each in (left, right)]
        self.assertLess(lean[0] * lean[1], 0, "to opposite sides")
        for method in ("dual-quaternion", "linear", "key-matrix"):
            held = numpy.isfinite(self.depths(SKIN, "--time", "99", "--skin", method))
            self.assertLess((held != rest).sum(), 5, method)

    def test_notes_and_default_time(self):
        done = self.relievo("render", WALK, "--size", "64x64", "--png", "walk.png")
        self.assertEqual(done.stderr, "")
        self.before = self.names()
        self.refused("render", TUBE, "--animation", "fly", "--png", "a.png", status=2,
                     says=[TUBE, "no animation 'fly'; it has '"])  # fmt: skip

    def test_images_in_the_file(self):
        """Its colours and its normals are drawn where the file has them, and still in a later frame
        and under an environment's material."""
        colors = numpy.zeros((32, 32, 3), numpy.uint8)
        colors[:16, :16], colors[:16, 16:] = (250, 10, 20), (30, 240, 50)
        colors[16:, :16], colors[16:, 16:] = (60, 70, 230), (200, 200, 40)
        normals = numpy.zeros((32, 32, 3), numpy.uint8)
        normals[:, :16], normals[:, 16:] = (204, 128, 230), (128, 204, 230)  # to the right; up
        path = self.folder / "square.glb"
        path.write_bytes(square_glb(colors, normals))
        view = ("--size", "64x64", "--camera", "0,0,3,0,0,0,0,1,0", "--parallel-scale", "1")
        self.before = self.names()
        for words in (("--time", "0"), ("--time", "0", "--height-map", "flat.png,0.01")):
            (self.folder / "flat.png").write_bytes(png(numpy.full((4, 4, 3), 255, numpy.uint8)))
            done = self.relievo("render", "square.glb", *view, *words, "--layers", "albedo,normal",
                                "--exr", "a.exr", "--png", "a.png")  # fmt: skip
            self.assertNotIn("drawn without", done.stderr)
            layers = self.exr("a.exr")[1]
            albedo = numpy.stack([layers[f"albedo.{c}"] for c in "RGB"], axis=-1)
            normal = numpy.stack([layers[f"normal.{c}"] for c in "XYZ"], axis=-1)
            for row, column in ((16, 16), (16, 48), (48, 16), (48, 48)):
                expected = srgb.decoded(colors[row // 2, column // 2] / 255)
                self.assertLess(abs(albedo[row, column] - expected).max(), 1.6 / 255, (row, column))
                expected = normals[row // 2, column // 2] / 127.5 - 1
                expected /= numpy.linalg.norm(expected)
                self.assertLess(abs(normal[row, column] - expected).max(), 0.01, (row, column))

    def test_damaged_images_in_the_file(self):
        texels = numpy.full((8, 8, 3), 200, numpy.uint8)
        whole = square_glb(texels, texels)
        at = whole.index(b"IDAT") + 6
        (self.folder / "bad.glb").write_bytes(whole[:at] + b"????" + whole[at + 4 :])
        done = self.relievo("render", "bad.glb", "--time", "0", "--size", "64x64", "--png", "a.png")
        self.assertIn("bad.glb: drawn without a texture: the image 'images[0]' in it", done.stderr)
        self.assertIn("damaged", done.stderr)
        self.assertEqual(done.stderr.count("drawn without"), 1)

    def test_sequence(self):
        """Frames are those that --time draws, and each is whole."""
        words = ("--size", "80x60", "--camera", "0,1,6,0,1,0,0,1,0", "--clip", "0.1,100")
        self.relievo("render", SKIN, *words, "--times", "0.5:2.5:0.5", "--exr", "f%02d.exr",
                     "--png", "f%d.png", "--report", "f%d.json")  # fmt: skip
        made = [f"f{i}.{end}" for i in range(5) for end in ("json", "png")]
        made += [f"f0{i}.exr" for i in range(5)]
        self.assertEqual(set(self.names()) - set(self.before), set(made))
        seen = [self.exr(f"f0{i}.exr")[1]["depth.Z"] for i in range(5)]
        for i in (0, 2, 4):
            alone = self.depths(SKIN, "--time", str(0.5 + 0.5 * i))
            self.assertTrue((alone == seen[i]).all(), i)
        self.assertGreater((seen[0] != seen[2]).sum(), 50)

    def test_sequence_fits_all_frames(self):
        """The camera stays, and sees the strip that leans to both sides."""
        self.relievo("render", SKIN, "--size", "80x60", "--times", "0:4:1", "--exr", "f%d.exr")
        for i in range(5):
            seen = numpy.isfinite(self.exr(f"f{i}.exr")[1]["depth.Z"])
            self.assertGreater(seen.sum(), 50)
            for edge in (seen[0], seen[-1], seen[:, 0], seen[:, -1]):
                self.assertFalse(edge.any(), i)

    def test_sequence_of_flow(self):
        """Where a pixel was, the frame before shows the point from where the motion comes."""
        for camera in ((), ("--parallel-scale", "2"), ("--lens", "fisheye:angle=60")):
            with self.subTest(camera):
                self.check_flow(camera)
        self.before = self.names()
        self.refused("render", SKIN, "--layers", "flow", "--exr", "a.exr", status=2,
                     says=["--layers: got 'flow'", "--times"])  # fmt: skip

    def check_flow(self, camera):
        self.relievo("render", SKIN, "--size", "160x120", "--times", "0:1.5:0.5", "--layers",
                     "position,flow,motion,flow_valid", "--exr", "f%d.exr", *camera)  # fmt: skip
        headers, frames = zip(*(self.exr(f"f{i}.exr") for i in range(4)))

        def get(i, name, axes="XYZ"):
            return numpy.stack([frames[i][f"{name}.{axis}"] for axis in axes], -1)

        def places(i):
            """In the world: each file has an origin of its own."""
            return get(i, "position") + headers[i]["attributes"]["relievo:origin"]["value"]

        self.assertTrue(numpy.isnan(get(0, "flow", "XY")).all())
        self.assertFalse(frames[0]["flow_valid.V"].any())
        for i in (1, 2, 3):
            valid = frames[i]["flow_valid.V"] == 1
            self.assertGreater(valid.sum(), 500)
            rows, columns = numpy.nonzero(valid)
            flow = get(i, "flow", "XY")[valid]
            self.assertEqual(numpy.abs(flow).max() > 20, i < 3)  # then it keeps its pose
            before = numpy.rint(numpy.stack([columns, rows], -1) + flow).astype(int)
            shown = places(i - 1)[before[:, 1], before[:, 0]]
            come = places(i)[valid] + get(i, "motion")[valid]
            apart = numpy.linalg.norm(shown - come, axis=-1)
            size = numpy.ptp(come, axis=0).max()
            self.assertLess(numpy.quantile(apart, 0.98), 0.015 * size)  # a pixel, but for edges

    def test_flow_of_what_is_translucent(self):
        """A frame has it in no layer, by a lens all have it."""
        for lens in ((), ("--lens", "fisheye:angle=60")):
            with self.subTest(lens):
                self.relievo("render", SKIN, "--size", "80x60", "--times", "0:0.5:0.5", "--opacity",
                             "0.3", "--layers", "depth,flow", "--exr", "f%d.exr", *lens)
                layers = self.exr("f1.exr")[1]
                shown = numpy.isfinite(layers["depth.Z"])
                moved = numpy.isfinite(layers["flow.X"])
                self.assertEqual(moved.sum() > 50, bool(lens))
                self.assertEqual(shown.sum() > 50, bool(lens))

    def test_look_inside(self):
        bare = self.depths(TUBE, "--time", "0.5", "--color-by", "first_bone")
        lines = self.depths(TUBE, "--time", "0.5", "--skeleton", "--skin", "off")
        self.assertEqual(bare.shape, lines.shape)
        self.relievo("render", SKIN, "--size", "80x60", "--layers", "bone_weight",
                     "--bone-weight", "nodes[1]", "--exr", "w.exr")  # fmt: skip
        layers = self.exr("w.exr")[1]
        (weights,) = [layers[name] for name in layers if name.startswith("bone_weight")]
        weights = weights[numpy.isfinite(weights)]
        self.assertGreaterEqual(weights.min(), 0)
        self.assertLess(weights.min(), 0.1)
        self.assertGreater(weights.max(), 0.9)
        self.assertLess(weights.max(), 1.001)
        self.before = self.names()
        self.refused("render", SKIN, "--bone-weight", "tail", "--png", "a.png", status=2,
                     says=[SKIN, "no bone 'tail'; it has '"])  # fmt: skip

    def test_blend(self):
        self.refused("render", SKIN, "--blend", "x=0.5", "--png", "a.png", status=2,
                     says="no animation 'x'; it has '")  # fmt: skip
        for word in ("walk", "walk=2", "=0.5", "walk=much"):
            self.refused("render", WALK, "--blend", word, "--png", "a.png", status=2,
                         says="--blend")  # fmt: skip

    def test_refused_sequences(self):
        for word in ("1", "0:1", "0:1:0", "1:0:0.1", "0:1:-1", "0:1e9:1e-9", "a:b:c"):
            self.refused("render", WALK, "--times", word, "--png", "a%d.png", status=2,
                         says="--times")  # fmt: skip
        for name in ("a.png", "a%d%d.png", "a%s.png", "a%4d.png"):
            self.refused("render", WALK, "--times", "0:1:0.5", "--png", name, status=2,
                         says=["--png", "%04d"])  # fmt: skip
        self.refused("render", WALK, "--times", "0:1:0.5", "--time", "1", "--png", "a%d.png",
                     status=2, says="--time and --times")  # fmt: skip
        self.refused("render", WALK, "--times", "0:1:0.5", "--png", "no/a%d.png", status=1,
                     says=["no/a0.png", "no folder"])  # fmt: skip

    def test_refused(self):
        self.refused("render", "triangle.off", "--time", "1", "--png", "a.png", status=2,
                     says=["--time", "no FILE can have bones", ".fbx"])  # fmt: skip
        for words, says in ((("--time", "soon"), "--time"), (("--skin", "fur"), "--skin")):
            self.refused("render", WALK, *words, "--png", "a.png", status=2, says=says)
        whole = (self.folder / TUBE).read_bytes()
        (self.folder / "cut.fbx").write_bytes(whole[: len(whole) // 2])
        self.before = self.names()
        self.refused("render", "cut.fbx", "--png", "a.png", status=1, says="cut.fbx")


if __name__ == "__main__":
    main()
