# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The truth about a glTF 2 file, in double: its primitives at a time by the specification. It
reads JSON and buffers by itself and shares no code with the reader."""

import base64
import json
import pathlib
import struct
import urllib.parse

import numpy

TYPES = {
    5120: numpy.dtype("<i1"),
    5121: numpy.dtype("<u1"),
    5122: numpy.dtype("<i2"),
    5123: numpy.dtype("<u2"),
    5125: numpy.dtype("<u4"),
    5126: numpy.dtype("<f4"),
}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def from_quaternion(q):
    x, y, z, w = numpy.asarray(q, float) / numpy.linalg.norm(q)
    return numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ])  # fmt: skip


def slerp(a, b, share):
    a, b = (numpy.asarray(q, float) / numpy.linalg.norm(q) for q in (a, b))
    cosine = a @ b
    if cosine < 0:
        b, cosine = -b, -cosine
    angle = numpy.arccos(min(cosine, 1.0))
    if angle < 1e-9:
        return a
    return (numpy.sin((1 - share) * angle) * a + numpy.sin(share * angle) * b) / numpy.sin(angle)


def normalized(vectors):
    with numpy.errstate(invalid="ignore"):
        return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)


class File:
    def __init__(self, path):
        self.path = pathlib.Path(path)
        data = self.path.read_bytes()
        self.chunk = None
        if data[:4] == b"glTF":
            size = struct.unpack_from("<I", data, 12)[0]
            text = data[20 : 20 + size]
            if len(data) > 20 + size:
                self.chunk = data[28 + size :]
        else:
            text = data
        self.json = json.loads(text.decode("utf-8-sig"))

    def list(self, name):
        return self.json.get(name, [])

    def buffer(self, index):
        uri = self.json["buffers"][index].get("uri")
        if uri is None:
            return self.chunk
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        return (self.path.parent / urllib.parse.unquote(uri)).read_bytes()

    def raw(self, owner, count, dtype, components):
        view = self.json["bufferViews"][owner["bufferView"]]
        begin = view.get("byteOffset", 0) + owner.get("byteOffset", 0)
        stride = view.get("byteStride", dtype.itemsize * components)
        data = self.buffer(view["buffer"])
        return numpy.array([
            numpy.frombuffer(data, dtype, components, begin + i * stride) for i in range(count)
        ])  # fmt: skip

    def accessor(self, index):
        """Values as numbers, count x components."""
        accessor = self.json["accessors"][index]
        dtype = TYPES[accessor["componentType"]]
        components = COMPONENTS[accessor["type"]]
        count = accessor["count"]
        values = numpy.zeros((count, components), dtype)
        if "bufferView" in accessor:
            values = self.raw(accessor, count, dtype, components)
        if "sparse" in accessor:
            sparse = accessor["sparse"]
            kind = TYPES[sparse["indices"]["componentType"]]
            places = self.raw(sparse["indices"], sparse["count"], kind, 1)[:, 0]
            values = values.copy()
            values[places] = self.raw(sparse["values"], sparse["count"], dtype, components)
        numbers = values.astype(float)
        if accessor.get("normalized") and dtype.kind != "f":
            numbers = numpy.maximum(numbers / numpy.iinfo(dtype).max, -1.0)
        return numbers


class Scene:
    """The scene at a time of one of its animations, or at rest."""

    def __init__(self, path, animation=None, time=0.0, scene=None):
        self.file = File(path)
        self.nodes = self.file.list("nodes")
        self.parent = {c: i for i, n in enumerate(self.nodes) for c in n.get("children", [])}
        self.parts = [self._parts(node) for node in self.nodes]
        self.weights = [self._weights(node) for node in self.nodes]
        if animation is not None:
            self._animate(self.file.list("animations")[animation], time)
        scenes = self.file.list("scenes")
        if scenes:
            chosen = self.file.json.get("scene", 0) if scene is None else scene
            roots = scenes[chosen].get("nodes", [])
        else:
            roots = [i for i in range(len(self.nodes)) if i not in self.parent]
        self.shown = []
        level = list(roots)
        while level:
            self.shown += level
            level = [c for i in level for c in self.nodes[i].get("children", [])]

    @staticmethod
    def _parts(node):
        if "matrix" in node:
            return {"matrix": numpy.array(node["matrix"], float).reshape(4, 4).T}
        return {
            "translation": numpy.array(node.get("translation", [0, 0, 0]), float),
            "rotation": numpy.array(node.get("rotation", [0, 0, 0, 1]), float),
            "scale": numpy.array(node.get("scale", [1, 1, 1]), float),
        }

    def _weights(self, node):
        if "mesh" not in node:
            return None
        mesh = self.file.list("meshes")[node["mesh"]]
        targets = len(mesh["primitives"][0].get("targets", []))
        return numpy.array(node.get("weights", mesh.get("weights", [0] * targets)), float)

    def _animate(self, animation, time):
        for channel in animation["channels"]:
            node = channel["target"].get("node")
            if node is None:
                continue
            path = channel["target"]["path"]
            sampler = animation["samplers"][channel["sampler"]]
            value = self._sample(sampler, path, time, node)
            if path == "weights":
                self.weights[node] = value
            else:
                self.parts[node][path] = value

    def _sample(self, sampler, path, time, node):
        times = self.file.accessor(sampler["input"])[:, 0]
        index = sampler["output"]
        values = self.file.accessor(index)
        parts = len(self.weights[node]) if path == "weights" else values.shape[1]
        mode = sampler.get("interpolation", "LINEAR")
        values = values.reshape(len(times), 3 if mode == "CUBICSPLINE" else 1, parts)
        own = values[:, 1 if mode == "CUBICSPLINE" else 0]
        after = int(numpy.searchsorted(times, time, side="right"))
        if after == 0 or after == len(times):
            return own[0 if after == 0 else -1]
        before = after - 1
        length = times[after] - times[before]
        s = (time - times[before]) / length
        if mode == "STEP":
            return own[before]
        if mode == "LINEAR":
            if path == "rotation":
                return slerp(own[before], own[after], s)
            return (1 - s) * own[before] + s * own[after]
        result = (
            (2 * s**3 - 3 * s**2 + 1) * own[before]
            + length * (s**3 - 2 * s**2 + s) * values[before, 2]
            + (3 * s**2 - 2 * s**3) * own[after]
            + length * (s**3 - s**2) * values[after, 0]
        )
        return normalized(result) if path == "rotation" else result

    def local(self, node):
        parts = self.parts[node]
        if "matrix" in parts:
            return parts["matrix"]
        m = numpy.eye(4)
        m[:3, :3] = from_quaternion(parts["rotation"]) * parts["scale"]
        m[:3, 3] = parts["translation"]
        return m

    def world(self, node):
        m = self.local(node)
        while node in self.parent:
            node = self.parent[node]
            m = self.local(node) @ m
        return m

    def primitives(self):
        """Of each primitive that is shown, in the scene's order: corners of each cell."""
        found = []
        for node in self.shown:
            if "mesh" in self.nodes[node]:
                mesh = self.file.list("meshes")[self.nodes[node]["mesh"]]
                found += [Primitive(self, node, p) for p in mesh["primitives"]]
        return found

    def lights(self):
        """The lights, each with position, direction and the file's values."""
        extension = self.file.json.get("extensions", {}).get("KHR_lights_punctual", {})
        found = []
        for node in self.shown:
            own = self.nodes[node].get("extensions", {}).get("KHR_lights_punctual")
            if own:
                world = self.world(node)
                direction = normalized(-world[:3, 2])
                found.append((world[:3, 3], direction, extension["lights"][own["light"]]))
        return found


class Primitive:
    """points, normals, coordinates, colors: cells x corners x numbers, or None."""

    def __init__(self, scene, node, primitive):
        file = scene.file
        self.json = primitive
        attributes = primitive["attributes"]

        def read(name):
            return file.accessor(attributes[name]) if name in attributes else None

        points = read("POSITION")
        normals = read("NORMAL")
        tangents = read("TANGENT") if normals is not None else None
        weights = scene.weights[node]
        for i, target in enumerate(primitive.get("targets", [])):
            if "POSITION" in target:
                points = points + weights[i] * file.accessor(target["POSITION"])
            if normals is not None and "NORMAL" in target:
                normals = normals + weights[i] * file.accessor(target["NORMAL"])
            if tangents is not None and "TANGENT" in target:
                tangents = tangents.copy()
                tangents[:, :3] += weights[i] * file.accessor(target["TANGENT"])
        skin = scene.nodes[node].get("skin")
        if skin is not None and "JOINTS_0" in attributes:
            matrices, mirrored = self._joints(scene, skin, read, len(points))
        else:
            world = scene.world(node)
            matrices = numpy.repeat(world[None], len(points), axis=0)
            mirrored = numpy.linalg.det(world[:3, :3]) < 0
        axes = matrices[:, :3, :3]
        points = numpy.einsum("nij,nj->ni", axes, points) + matrices[:, :3, 3]
        self.cells = self._cells(file, primitive, len(points))
        if mirrored and self.cells.shape[1] == 3:
            self.cells = self.cells[:, [0, 2, 1]]
        self.points = points[self.cells]
        if normals is not None:
            turned = numpy.linalg.inv(axes).transpose(0, 2, 1)
            self.normals = normalized(numpy.einsum("nij,nj->ni", turned, normals))[self.cells]
        elif self.cells.shape[1] == 3:
            a, b, c = self.points.transpose(1, 0, 2)
            flat = normalized(numpy.cross(b - a, c - a))
            self.normals = numpy.repeat(flat[:, None], 3, axis=1)
        else:
            self.normals = None
        self.tangents = None
        if tangents is not None:
            along = normalized(numpy.einsum("nij,nj->ni", axes, tangents[:, :3]))
            self.tangents = along[self.cells]
        material = {}
        if "material" in primitive:
            material = file.list("materials")[primitive["material"]]
        self.material = material
        self.coordinates = self._coordinates(read, material)
        colors = read("COLOR_0")
        self.colors = None
        if colors is not None:
            if colors.shape[1] == 3:
                colors = numpy.hstack([colors, numpy.ones((len(colors), 1))])
            self.colors = numpy.clip(colors, 0, 1)[self.cells]

    @staticmethod
    def _joints(scene, skin, read, count):
        skin = scene.file.list("skins")[skin]
        bound = numpy.repeat(numpy.eye(4)[None], len(skin["joints"]), axis=0)
        if "inverseBindMatrices" in skin:
            read_matrices = scene.file.accessor(skin["inverseBindMatrices"])
            bound = read_matrices.reshape(-1, 4, 4).transpose(0, 2, 1)
        moved = numpy.array([scene.world(j) @ bound[i] for i, j in enumerate(skin["joints"])])
        matrices = numpy.zeros((count, 4, 4))
        whole = numpy.zeros(count)
        n = 0
        while (joints := read(f"JOINTS_{n}")) is not None:
            weights = read(f"WEIGHTS_{n}")
            matrices += numpy.einsum("nk,nkij->nij", weights, moved[joints.astype(int)])
            whole += weights.sum(axis=1)
            n += 1
        signs = numpy.sign(numpy.linalg.det(moved[:, :3, :3]))
        return matrices / whole[:, None, None], (signs < 0).sum() * 2 > len(signs)

    @staticmethod
    def _cells(file, primitive, count):
        if "indices" in primitive:
            order = file.accessor(primitive["indices"])[:, 0].astype(int)
        else:
            order = numpy.arange(count)
        n = len(order)
        mode = primitive.get("mode", 4)
        if mode == 0:
            cells = [[i] for i in range(n)]
        elif mode == 1:
            cells = [[2 * i, 2 * i + 1] for i in range(n // 2)]
        elif mode in (2, 3):
            cells = [[i, i + 1] for i in range(n - 1)] + ([[n - 1, 0]] if mode == 2 else [])
        elif mode == 4:
            cells = [[3 * i, 3 * i + 1, 3 * i + 2] for i in range(n // 3)]
        elif mode == 5:
            cells = [[i, i + 2, i + 1] if i % 2 else [i, i + 1, i + 2] for i in range(n - 2)]
        else:
            cells = [[i + 1, i + 2, 0] for i in range(n - 2)]
        return order[numpy.array(cells)]

    def _coordinates(self, read, material):
        base = material.get("pbrMetallicRoughness", {})
        infos = [base.get("baseColorTexture"), base.get("metallicRoughnessTexture")]
        infos += [material.get(f"{name}Texture") for name in ("normal", "occlusion", "emissive")]
        info = next((info for info in infos if info), {})
        moved = info.get("extensions", {}).get("KHR_texture_transform", {})
        coordinates = read(f"TEXCOORD_{moved.get('texCoord', info.get('texCoord', 0))}")
        if coordinates is None:
            return None
        offset = numpy.array(moved.get("offset", [0, 0]), float)
        scale = numpy.array(moved.get("scale", [1, 1]), float)
        c, s = numpy.cos(moved.get("rotation", 0)), numpy.sin(moved.get("rotation", 0))
        # The specification's matrices: translation * rotation * scale.
        turn = numpy.array([[c, s], [-s, c]])
        return (coordinates * scale @ turn.T + offset)[self.cells]
