# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Complete glTF files: lights and cameras, names and valid values, and refusals."""

import json
import os
import subprocess
import sys
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import reading
from evaluator import Scene
from reading import GltfTest
from writer import Writer, data_uri, pack_glb

TRIANGLE = numpy.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])


def triangle(**primitive):
    """A writer with a node that shows a triangle."""
    writer = Writer()
    points = writer.accessor(TRIANGLE, bounds=True)
    primitive = {"attributes": {"POSITION": points}, **primitive}
    writer.add("meshes", {"primitives": [primitive]})
    writer.add("nodes", {"mesh": 0})
    return writer


class Lights(GltfTest):
    def write(self, lights, nodes):
        writer = triangle()
        writer.uses("KHR_lights_punctual")
        writer.json["extensions"] = {"KHR_lights_punctual": {"lights": lights}}
        for i, node in enumerate(nodes):
            writer.add("nodes", {"extensions": {"KHR_lights_punctual": {"light": i}}, **node})
        return writer

    def check(self, path, reader):
        truth = Scene(path).lights()
        self.assertEqual(reader.GetNumberOfLights(), len(truth))
        for i, (position, direction, json_) in enumerate(truth):
            light = reader.GetLight(i)
            given = numpy.array(light.GetTransformedPosition())
            back = (given - position) @ direction if json_["type"] == "directional" else 0
            size = max(abs(back), 1)  # VTK before 9.5 needs suns that stand far away
            self.assertLess(numpy.abs(given - back * direction - position).max() / size, 1e-12)
            along = numpy.array(light.GetTransformedFocalPoint()) - given
            along /= numpy.linalg.norm(along)
            self.assertLess(numpy.abs(along - direction).max(), 1e-9)
            self.assertEqual(light.GetIntensity(), json_.get("intensity", 1))
            self.assertEqual(list(light.GetDiffuseColor()), json_.get("color", [1, 1, 1]))
            sun = json_["type"] == "directional"
            self.assertEqual(light.GetPositional(), not sun)
            fall = (1, 0, 0) if sun else (0, 0, 1)
            self.assertEqual(light.GetAttenuationValues(), fall)
            cone = 90
            if json_["type"] == "spot":
                outer = json_.get("spot", {}).get("outerConeAngle", numpy.pi / 4)
                cone = numpy.degrees(outer)
            self.assertAlmostEqual(light.GetConeAngle(), cone)

    def test_places(self):
        """At their nodes, along -z; also below parents that turn and scale."""
        kinds = (
            {"type": "point"},
            {"type": "directional", "intensity": 3, "color": [1, 0.5, 0]},
            {"type": "spot", "intensity": 20, "spot": {}},
            {"type": "spot", "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}},
        )
        turn = [0.1, 0.7, -0.1, 0.7]
        nodes = [{"translation": [1, 1, 6], "rotation": turn} for _ in kinds]
        writer = self.write(kinds, nodes)
        path = writer.save(self.folder / "lights.glb")
        reader, errors = self.read(path)
        self.assertEqual(errors, [])
        self.assertEqual(reader.GetLight(0).GetTransformedPosition(), (1, 1, 6))
        self.check(path, reader)
        parent = {"children": [1, 2, 3, 4], "scale": [2, 3, -4], "rotation": [0.5, 0.5, 0.5, 0.5]}
        writer.add("nodes", parent)
        path = writer.save(self.folder / "below.glb")
        self.check(path, self.read(path)[0])
        self.assertIsNone(reader.GetLight(4))
        self.assertIsNone(reader.GetLight(-1))

    def test_moved(self):
        """Lights and cameras follow their nodes in time, and stay the same objects."""
        writer = self.write([{"type": "point"}], [{"camera": 0}])
        writer.add("cameras", {"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}})
        times = writer.accessor(numpy.array([0.0, 2.0]), bounds=True)
        places = writer.accessor(numpy.array([[0.0, 0, 0], [2, 4, 6]]))
        writer.add(
            "animations",
            {
                "samplers": [{"input": times, "output": places}],
                "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}],
            },
        )
        reader, errors = self.read(writer.save(self.folder / "a.glb"), reading.ANIMATION, 1)
        self.assertEqual(errors, [])
        light = reader.GetLight(0)
        self.assertEqual(light.GetPosition(), (1, 2, 3))
        self.assertEqual(reader.GetCamera(0).GetPosition(), (1, 2, 3))
        reader.UpdateTimeStep(2)
        self.assertEqual(light.GetPosition(), (2, 4, 6))

    def test_spot_falls_off(self):
        """VTK's power of the cosine is the one that misses the specification's least."""
        cosine = numpy.linspace(0, 1, 4001)
        for inner, outer in ((0, numpy.pi / 4), (0.2, 0.5), (0.5, 0.52), (1.0, 1.4)):
            lights = [{"type": "spot", "spot": {"innerConeAngle": inner, "outerConeAngle": outer}}]
            path = self.write(lights, [{}]).save(self.folder / "spot.glb")
            light = self.read(path)[0].GetLight(0)
            within = cosine[cosine > numpy.cos(outer)]
            share = (within - numpy.cos(outer)) / (numpy.cos(inner) - numpy.cos(outer))
            wanted = numpy.clip(share, 0, 1) ** 2

            def miss(exponent):
                return numpy.square(within**exponent - wanted).mean()

            own = miss(light.GetExponent())
            self.assertLess(own, min(map(miss, numpy.geomspace(0.05, 1e5, 400))) + 1e-4)

    def test_cameras(self):
        writer = triangle()
        writer.add(
            "cameras",
            {"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1, "zfar": 50}},
        )
        writer.add(
            "cameras",
            {
                "type": "orthographic",
                "orthographic": {"xmag": 3, "ymag": 2, "znear": 1, "zfar": 9},
            },
        )
        half = numpy.sqrt(0.5)
        writer.add("nodes", {"camera": 0, "translation": [1, 2, 3], "rotation": [0, half, 0, half]})
        writer.add("nodes", {"camera": 1, "scale": [2, 2, 2]})
        reader, errors = self.read(writer.save(self.folder / "cameras.glb"))
        self.assertEqual(errors, [])
        self.assertEqual(reader.GetNumberOfCameras(), 2)
        first, second = reader.GetCamera(0), reader.GetCamera(1)
        self.assertEqual(first.GetPosition(), (1, 2, 3))
        numpy.testing.assert_allclose(first.GetDirectionOfProjection(), (-1, 0, 0), atol=1e-12)
        self.assertAlmostEqual(first.GetViewAngle(), numpy.degrees(0.5))
        self.assertEqual(first.GetClippingRange(), (0.1, 50))
        self.assertTrue(second.GetParallelProjection())
        self.assertEqual(second.GetParallelScale(), 2)
        self.assertIsNone(reader.GetCamera(2))


class Words(GltfTest):
    """Valid but unusual values."""

    def test_files_beside_it(self):
        writer = triangle()
        for uri, name in (
            ("my%20points.bin", "my points.bin"), ("gr%C3%BCn.bin", "grün.bin"),
            ("a+b.bin", "a+b.bin"), ("100%.bin", "100%.bin"), ("sub/a.bin", "sub/a.bin"),
        ):  # fmt: skip
            path = writer.save(self.folder / "beside.gltf", uri)
            (self.folder / name).parent.mkdir(exist_ok=True)
            (self.folder / name).write_bytes(writer.bytes)
            self.compare(path)
        text = path.read_text().replace("sub/a.bin", "my\\u0020points.bin")
        path.write_text(text)
        self.compare(path)

    def test_text(self):
        """With a byte order mark, with blanks and escapes, deep extras, names of any kind."""
        writer = triangle()
        path = writer.save(self.folder / "text.gltf")
        plain = path.read_text()
        path.write_text("\ufeff" + plain, encoding="utf-8")
        self.compare(path)
        path.write_text(plain.replace(":", " \n\t: " + " " * 100000, 3))
        self.compare(path)
        path.write_text(plain.replace('"nodes"', '"\\u006eodes"'))
        self.compare(path)
        deep = "[" * 200 + "]" * 200
        path.write_text(plain.replace("{", '{"extras":' + deep + ",", 1))
        self.compare(path)

    def test_materials(self):
        for material in ({}, {"name": "x"}, {"pbrMetallicRoughness": {}}, {"extras": 5}):
            writer = triangle(material=0)
            writer.add("materials", material)
            self.compare(writer.save(self.folder / "material.glb"))

    def test_nothing_to_show(self):
        """A file without meshes is read; it has no blocks."""
        for text in ('{"asset":{"version":"2.0"}}', '{"asset":{"version":"2.0"},"meshes":[]}',
                     '{"asset":{"version":"2.1"},"nodes":[{}]}'):  # fmt: skip
            path = self.folder / "empty.gltf"
            path.write_text(text)
            reader, errors = self.read(path)
            self.assertEqual(errors, [])
            self.assertEqual(reader.GetOutput().GetNumberOfBlocks(), 0)

    def test_extensions(self):
        """Unknown ones are noted, and refused where they are required."""
        writer = triangle()
        writer.uses("KHR_materials_clearcoat")
        self.compare(writer.save(self.folder / "a.glb"), notes=["uses KHR_materials_clearcoat"])
        writer.uses("EXT_meshopt_compression", True)
        self.refused(writer.save(self.folder / "b.glb"), "extensionsRequired[0]",
                     "EXT_meshopt_compression")  # fmt: skip

    def test_left_over_corners(self):
        writer = Writer()
        points = writer.accessor(numpy.vstack([TRIANGLE, TRIANGLE[:1]]), bounds=True)
        writer.add("meshes", {"primitives": [{"attributes": {"POSITION": points}}]})
        writer.add("nodes", {"mesh": 0})
        self.compare(writer.save(self.folder / "four.glb"), notes=["no multiple of 3"])

    def test_child_that_is_a_root_too(self):
        for order in ([1, 0], [0, 1], [2, 1, 0, 0]):
            writer = triangle()
            writer.add("nodes", {"children": [2], "translation": [5, 0, 0]})
            writer.add("nodes", {"children": [0], "scale": [2, 2, 2]})
            writer.json["scenes"] = [{"nodes": order}]
            reader, errors = self.read(writer.save(self.folder / "a.gltf"))
            with self.subTest(order=order):
                self.assertEqual(errors, [])
                self.assertEqual(reader.GetOutput().GetNumberOfBlocks(), 1)
                points = vtk_to_numpy(reader.GetOutput().GetBlock(0).GetPoints().GetData())
                numpy.testing.assert_allclose(points, 2 * TRIANGLE + (5, 0, 0))
                self.assertIn(f"scenes[0].nodes[{order.index(0)}] names nodes[0], which is a child "
                              "of nodes[2] and is drawn once, there", self.notes(reader))

    def test_repeated_times(self):
        writer = triangle()
        times = writer.accessor(numpy.array([0.0, 0, 1, 1, 1, 2, 2]), bounds=True)
        places = writer.accessor(numpy.random.default_rng(1).random((7, 3)))
        splines = writer.accessor(numpy.random.default_rng(2).random((21, 3)))
        turns = writer.accessor(numpy.random.default_rng(3).random((7, 4)))
        writer.add("animations", {
            "samplers": [{"input": times, "output": places, "interpolation": "STEP"},
                         {"input": times, "output": turns},
                         {"input": times, "output": splines, "interpolation": "CUBICSPLINE"}],
            "channels": [{"sampler": i, "target": {"node": 0, "path": path}}
                         for i, path in enumerate(("translation", "rotation", "scale"))]},
        )  # fmt: skip
        path = writer.save(self.folder / "a.gltf")
        for time in (0, 0.3, 0.999, 1, 1.25, 2):
            self.compare(path, 0, time, ["samplers[0].input has the time 0.000000 more than once"])

    def test_data_without_base64(self):
        writer = triangle()
        path = writer.save(self.folder / "coded.gltf")
        text = json.loads(path.read_text())
        coded = "".join(f"%{byte:02X}" for byte in writer.bytes)
        text["buffers"][0]["uri"] = "data:application/octet-stream," + coded
        path.write_text(json.dumps(text))
        reader, errors = self.read(path)
        self.assertEqual(errors, [])
        self.assertEqual(reader.GetOutput().GetBlock(0).GetBounds(), (0, 1, 0, 1, 0, 0))

    def test_read_again(self):
        """Files are read again only if they or files that they name have changed."""
        writer = triangle()
        path = writer.save(self.folder / "again.gltf", "points.bin")
        (self.folder / "points.bin").write_bytes(writer.bytes)
        reader, _ = self.read(path)
        self.assertEqual(reader.GetOutput().GetBlock(0).GetBounds()[1], 1)
        points = (2 * TRIANGLE).astype("<f4").tobytes()
        (self.folder / "points.bin").write_bytes(points + b"\0" * 4)
        reader.Modified()
        reader.Update()
        self.assertEqual(reader.GetOutput().GetBlock(0).GetBounds()[1], 2)


def change(path_of, value):
    """A change that sets a member, named by a path, of a file's JSON; None removes it."""

    def apply(text):
        *parents, last = path_of
        at = text
        for key in parents:
            at = at[key]
        if value is None:
            del at[last]
        else:
            at[last] = value

    return apply


def skinned():
    writer = Writer()
    attributes = {
        "POSITION": writer.accessor(TRIANGLE, bounds=True),
        "JOINTS_0": writer.accessor(numpy.array([[0, 1, 0, 0]] * 3), "u1"),
        "WEIGHTS_0": writer.accessor(numpy.array([[0.5, 0.5, 0, 0]] * 3)),
    }
    indices = writer.accessor(numpy.array([0, 1, 2]), "u2")
    writer.add("meshes", {"primitives": [{"attributes": attributes, "indices": indices}]})
    writer.add("nodes", {"mesh": 0, "skin": 0})
    writer.add("nodes", {"children": [2]})
    writer.add("nodes", {})
    matrices = writer.accessor(numpy.array([numpy.eye(4).ravel()] * 2))
    writer.add("skins", {"joints": [1, 2], "inverseBindMatrices": matrices})
    times = writer.accessor(numpy.array([0.0, 1.0]), bounds=True)
    places = writer.accessor(numpy.zeros((2, 3)))
    writer.add(
        "animations",
        {
            "samplers": [{"input": times, "output": places}],
            "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}],
        },
    )
    writer.add("accessors", {"componentType": 5126, "type": "VEC3", "count": 3, "sparse": {
        "count": 2, "indices": {"bufferView": writer.view(bytes([0, 1])), "componentType": 5121},
        "values": {"bufferView": writer.view(bytes(24))}}})  # fmt: skip
    writer.json["scenes"] = [{"nodes": [0, 1]}]
    writer.json["scene"] = 0
    writer.add("images", {"uri": data_uri(b"\x89PNG")})
    writer.add("textures", {"source": 0})
    base = {"baseColorTexture": {"index": 0}}
    writer.add("materials", {"pbrMetallicRoughness": base})
    writer.add("samplers", {})
    return writer


# Members of the file made by skinned(), their new values, and the message.
POSITION, JOINTS, WEIGHTS, INDICES, MATRICES, TIMES, PLACES, SPARSE = range(8)
A = "accessors"
V = "bufferViews"
PRIMITIVE = ("meshes", 0, "primitives", 0)
SAMPLER = ("animations", 0, "samplers", 0)
WRONG = [
    ((A, POSITION, "count"), 65000, "accessors[0] has 65000 values of 12 bytes from byte 0, but "
     "bufferViews[0] has 36 bytes"),
    ((A, POSITION, "count"), 0, "accessors[0].count is 0"),
    ((A, POSITION, "count"), -3, "accessors[0].count is -3"),
    ((A, POSITION, "count"), 2.5, "accessors[0].count is 2.5"),
    ((A, POSITION, "count"), 1e300, "accessors[0].count is 1e+300"),
    ((A, POSITION, "count"), "3", 'accessors[0].count is "3"'),
    ((A, POSITION, "count"), 2, "but POSITION has 2"),
    ((A, POSITION, "byteOffset"), 12, "3 values of 12 bytes from byte 12"),
    ((A, POSITION, "byteOffset"), 10**15, "from byte 1000000000000000"),
    ((A, POSITION, "byteOffset"), 2, "accessors[0]"),
    ((A, POSITION, "type"), "VEC2", "POSITION names accessors[0], which is VEC2 of FLOAT, expected "
     "VEC3"),
    ((A, POSITION, "type"), "VEC5", 'accessors[0].type is "VEC5"'),
    ((A, POSITION, "componentType"), 5124, "accessors[0].componentType is 5124"),
    ((A, POSITION, "componentType"), 5125, "which is VEC3 of UNSIGNED_INT"),
    ((A, POSITION, "bufferView"), 99, "accessors[0].bufferView names bufferViews[99]"),
    ((A, POSITION), 7, "accessors[0] is 7, expected an object"),
    ((V, 0, "byteLength"), 10**9, "bufferViews[0] has 1000000000 bytes from byte 0"),
    ((V, 0, "byteOffset"), 10**9, "bufferViews[0]"),
    ((V, 0, "byteOffset"), 2, "expected a multiple of 4"),
    ((V, 0, "byteStride"), 8, "bufferViews[0].byteStride is 8"),
    ((V, 0, "buffer"), 3, "bufferViews[0].buffer names buffers[3]"),
    ((V, 0, "buffer"), None, "bufferViews[0].buffer is missing"),
    ((PRIMITIVE + ("attributes", "POSITION")), 55, "meshes[0].primitives[0].attributes.POSITION "
     "names accessors[55], and there are 8 accessors"),
    ((PRIMITIVE + ("attributes",)), [], "attributes is a list, expected an object"),
    ((PRIMITIVE + ("mode",)), 9, "meshes[0].primitives[0].mode is 9"),
    ((PRIMITIVE + ("material",)), 4, "names materials[4]"),
    ((PRIMITIVE + ("indices",)), POSITION, "expected SCALAR of"),
    ((PRIMITIVE + ("targets",)), [{"POSITION": JOINTS}], "targets[0].POSITION names accessors[1]"),
    ((A, INDICES, "componentType"), 5121, None),  # the bytes 0 0 1: valid
    ((A, MATRICES, "count"), 1, "has 1 matrices, and the skin has 2 joints"),
    (("skins", 0, "joints"), [1, 77], "skins[0].joints[1] names nodes[77]"),
    (("skins", 0, "joints"), [1], "name joint 1, and the skin of nodes[0] has 1 joints"),
    (("skins", 0, "joints"), [], "skins[0].joints is a list, expected"),
    (("nodes", 0, "skin"), 3, "nodes[0].skin names skins[3]"),
    (("nodes", 0, "mesh"), 3, "nodes[0].mesh names meshes[3]"),
    (("nodes", 0, "mesh"), "0", 'nodes[0].mesh is "0"'),
    (("nodes", 0, "matrix"), [1, 2, 3], "nodes[0].matrix has 3 numbers, expected 16"),
    (("nodes", 0, "rotation"), [0, 0, 0, 0], "nodes[0].rotation has no length"),
    (("nodes", 0, "translation"), [0, "a", 0], 'nodes[0].translation[1] is "a"'),
    (("nodes", 2, "children"), [1], "below itself"),
    (("nodes", 0, "children"), [0], "below itself"),
    (("nodes", 0, "children"), [2], "is a child of nodes[0] already"),
    (("nodes", 1, "children"), [2, 2], "is a child of nodes[1] already"),
    (("nodes", 1, "children"), [9], "nodes[1].children[0] names nodes[9]"),
    (("scenes", 0, "nodes"), [0, 2], "expected a root"),
    (("scene",), 5, "scene names scenes[5]"),
    ((SAMPLER + ("input",)), PLACES, "samplers[0].input names accessors[6]"),
    ((SAMPLER + ("output",)), POSITION, "has 3 values, and its input has 2 times"),
    ((SAMPLER + ("interpolation",)), "CUBICSPLINE", "expected 6 values"),
    ((SAMPLER + ("interpolation",)), "SMOOTH", "expected LINEAR, STEP or CUBICSPLINE"),
    (("animations", 0, "channels", 0, "sampler"), 1, "sampler names samplers[1]"),
    (("animations", 0, "channels", 0, "target", "node"), 9, "target.node names nodes[9]"),
    (("animations", 0, "channels", 0, "target", "path"), "color", "expected translation, rotation"),
    (("materials", 0, "alphaMode"), "FADE", 'materials[0].alphaMode is "FADE", expected OPAQUE, '
     "MASK or BLEND"),
    (("materials", 0, "pbrMetallicRoughness", "metallicFactor"), 3, "metallicFactor is 3"),
    (("materials", 0, "pbrMetallicRoughness", "baseColorFactor"), [1, 1, 1], "expected 4"),
    (("materials", 0, "pbrMetallicRoughness", "baseColorTexture", "index"), 8, "textures[8]"),
    (("materials", 0, "doubleSided"), 1, "materials[0].doubleSided is 1"),
    (("textures", 0, "source"), 7, "textures[0].source names images[7]"),
    (("textures", 0, "sampler"), 7, "textures[0].sampler names samplers[7]"),
    (("images", 0, "uri"), "none.png", "images[0] names none.png, which is not there"),
    (("images", 0, "uri"), "fifo", "images[0] names fifo, which is a pipe"),
    (("images", 0, "uri"), ".", "which is a folder"),
    (("images", 0, "uri"), "https://example.org/a.png", "expected a file beside it"),
    (("images", 0, "uri"), None, "images[0] has neither uri nor bufferView"),
    (("asset", "version"), "3.0", 'asset.version is "3.0"'),
    (("asset",), None, "asset.version is missing"),
    (("asset", "minVersion"), "2.1", "asset.minVersion"),
    (("buffers", 0, "uri"), "none.bin", "buffers[0] names none.bin, which is not there"),
    (("buffers", 0, "uri"), "data:;base64,@@@@", "buffers[0] has data: that is not base64"),
    (("buffers", 0, "uri"), "data:;base64,AAAAA", "buffers[0] has data: that is not base64"),
    (("buffers", 0, "uri"), "data:;base64,AAAA", "buffers[0] has 3 bytes, but its byteLength is"),
    (("buffers", 0, "uri"), "data:none", "without a comma"),
    (("buffers", 0, "uri"), "fifo", "buffers[0] names fifo, which is a pipe"),
    (("buffers", 0, "byteLength"), 10**7, "but its byteLength is 10000000"),
    (("buffers",), [], "names buffers[0], and there are 0 buffers"),
    (("meshes",), {}, "meshes is an object, expected a list"),
    (("meshes", 0, "primitives"), 5, "meshes[0].primitives is 5, expected a list"),
]  # fmt: skip


class Refusals(GltfTest):
    def test_members(self):
        os.mkfifo(self.folder / "fifo")
        whole = json.loads(skinned().save(self.folder / "whole.gltf").read_text())
        self.compare(self.folder / "whole.gltf")
        for where, value, says in WRONG:
            text = json.loads(json.dumps(whole))
            change(where, value)(text)
            if where == (A, POSITION, "count") and value == 2:  # the first of several problems
                text["meshes"][0]["primitives"][0].pop("indices")
            path = self.folder / "wrong.gltf"
            path.write_text(json.dumps(text))
            with self.subTest(where=where, value=value):
                if says is None:
                    self.assertEqual(self.read(path)[1], [])
                else:
                    self.refused(path, says)

    def test_numbers_in_buffers(self):
        """Corners, joints and sparse places that are not there, times that do not ascend."""
        for name, values, kind, says in (
            (INDICES, [0, 1, 3], "u2", "indices has 3 as number 2, and POSITION has 3 values"),
            (JOINTS, [[0, 1, 0, 0], [0, 2, 0, 0], [0, 0, 0, 0]], "u1", "name joint 2"),
            (TIMES, [1.0, 0.5], "f4", "input has the time 0.5"),
            (TIMES, [-1.0, 1.0], "f4", "input has the time -1.0"),
            (TIMES, [0.0, numpy.nan], "f4", "input has the time"),
            (PLACES, [[0, 0, 0], [0, numpy.inf, 0]], "f4", "output has a number that is not"),
            (MATRICES, [numpy.eye(4).ravel(), [numpy.nan] * 16], "f4", "of joint 1"),
        ):
            writer = skinned()
            at = writer.json[V][writer.json[A][name]["bufferView"]]["byteOffset"]
            data = writer.pack(numpy.array(values), kind)
            writer.bytes[at : at + len(data)] = data
            with self.subTest(says=says):
                self.refused(writer.save(self.folder / "numbers.glb"), says)
        for places, says in (([1, 1], "has 1 as number 1, after 1"), ([0, 3], "has 3 as number 1")):
            writer = skinned()
            writer.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = SPARSE
            view = writer.json[A][SPARSE]["sparse"]["indices"]["bufferView"]
            at = writer.json[V][view]["byteOffset"]
            writer.bytes[at : at + 2] = bytes(places)
            with self.subTest(says=says):
                path = writer.save(self.folder / "sparse.glb")
                self.refused(path, "accessors[7].sparse.indices", says)

    def test_containers(self):
        whole = skinned().save(self.folder / "whole.glb").read_bytes()
        path = self.folder / "cut.glb"
        for size in range(4, len(whole), 7):
            path.write_bytes(whole[:size])
            self.refused(path)
        for data, says in (
            (b"", "it is not JSON"), (b"{", "it is not JSON"), (b"[]", "expected an object"),
            ('{"asset":1}'.encode("utf-16"), "UTF-16"),
            (b"glTF\x01\0\0\0" + whole[8:], "binary glTF 1"),
            (whole[:16] + b"BLOB" + whole[20:], "first chunk is not JSON"),
            (whole[:12] + b"\xff\xff\xff\x7f" + whole[16:], "chunk 0 says 2147483647 bytes"),
            (pack_glb(b'{"asset":{"version":"2.0"},"a":"\xff"}'), "it is not JSON"),
            (b'{"asset":{"version":"2.0"},"extras":' + b"[" * 10**6, "nested more than 500 deep"),
            (b'{"a":' * 10**6, "nested more than 500 deep"),
        ):  # fmt: skip
            path.write_bytes(data)
            self.refused(path, says)

    def test_places(self):
        self.refused(self.folder / "none.glb", "it is not there")
        (self.folder / "folder.glb").mkdir()
        self.refused(self.folder / "folder.glb", "it is a folder")
        os.mkfifo(self.folder / "fifo.gltf")
        self.refused(self.folder / "fifo.gltf", "it is a pipe")

    def test_many_nodes(self):
        """As deep as is read, and deeper; a cycle of many."""
        for depth, fits in ((2000, True), (2002, False)):
            writer = triangle()
            nodes = writer.json["nodes"]
            for i in range(depth - 1):
                nodes.insert(0, {"children": [1]})
                nodes[0]["children"] = [1]
            for i, node in enumerate(nodes[:-1]):
                node["children"] = [i + 1]
            path = writer.save(self.folder / "deep.glb")
            if fits:
                self.assertEqual(self.read(path)[1], [])
            else:
                self.refused(path, "below more than 2000 others")
        writer = triangle()
        writer.json["nodes"] = [{"children": [(i + 1) % 100000]} for i in range(100000)]
        self.refused(writer.save(self.folder / "cycle.glb"), "is below itself")

    def test_small_files_of_great_size(self):
        """Refused before memory is taken."""
        huge = Writer()
        zeros = {"componentType": 5126, "type": "VEC3", "count": 350_000_000}
        huge.add("accessors", zeros)
        huge.add("meshes", {"primitives": [{"attributes": {"POSITION": 0}}]})
        huge.add("nodes", {"mesh": 0})
        many = triangle()
        many.json["accessors"][0] = {**zeros, "count": 4_000_000}
        many.json["nodes"] = [{"mesh": 0}] * 1000
        shared = triangle()
        shared.json["accessors"][0] = {**zeros, "count": 4_000_000}
        shared.json["meshes"][0]["primitives"] *= 300
        for writer, says in (
            (huge, "has 350000000 points"), (many, "is shown by 1000 nodes"),
            (shared, "at most 33554432 are read"),
        ):  # fmt: skip
            path = writer.save(self.folder / "huge.glb")
            self.assertLess(path.stat().st_size, 50_000)
            self.refused(path, says)
        keys = skinned()
        keys.json["accessors"][TIMES] = {"componentType": 5126, "type": "SCALAR", "count": 10**7}
        path = keys.save(self.folder / "keys.glb")
        self.refused(path, "accessors[5] has 10000000 values without")

    def test_memory(self):
        """Refused files take less than 300 MB."""
        huge = triangle()
        huge.json["accessors"][0] = {"componentType": 5126, "type": "VEC3", "count": 300_000_000}
        path = huge.save(self.folder / "huge.glb")
        code = (
            "import resource, sys, relievo\n"
            "reader = relievo.vtkRelievoModelReader()\n"
            "reader.SetFileName(sys.argv[1])\n"
            "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
            "reader.Update()\n"
            "after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
            "print(after - before, reader.GetErrorCode())\n"
        )
        done = subprocess.run(
            [sys.executable, "-c", code, str(path)], capture_output=True, text=True, check=True
        )
        grown, error = map(int, done.stdout.split())
        self.assertLess(grown, 300_000)
        self.assertNotEqual(error, 0)


if __name__ == "__main__":
    unittest.main()
