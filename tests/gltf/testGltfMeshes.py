# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of glTF files as the reader gives them, against the evaluator: modes, number types,
mirrors, skins, morph targets, animations."""

import unittest

import numpy

import reading
from reading import GltfTest, times_of
from writer import Writer

HALF = numpy.sqrt(0.5)


def unit(vectors):
    return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)


class Mesh:
    """Random points and directions, the same at every run."""

    def __init__(self, count=24, seed=3):
        self.random = numpy.random.default_rng(seed)
        self.points = self.random.uniform(-1, 1, (count, 3))
        self.normals = unit(self.random.normal(size=(count, 3)))
        side = self.random.choice([-1.0, 1.0], (count, 1))
        self.tangents = numpy.hstack([unit(self.random.normal(size=(count, 3))), side])
        self.coordinates = self.random.uniform(-1, 2, (count, 2))
        self.colors = self.random.uniform(0, 1, (count, 4))
        self.indices = self.random.permutation(count)


def scene(writer, primitive, node=None, **mesh):
    """One node that shows a mesh of this primitive."""
    place = writer.add("meshes", {"primitives": [primitive], **mesh})
    return writer.add("nodes", {"mesh": place, **(node or {})})


class Primitives(GltfTest):
    def test_modes(self):
        """Of every mode, with indices of every type and without."""
        mesh = Mesh()
        for mode in range(7):
            for kind in (None, "u1", "u2", "u4"):
                writer = Writer()
                primitive = {"attributes": {"POSITION": writer.accessor(mesh.points, bounds=True)}}
                primitive["mode"] = mode
                if kind:
                    primitive["indices"] = writer.accessor(mesh.indices, kind)
                scene(writer, primitive)
                self.compare(writer.save(self.folder / f"mode{mode}{kind}.glb"))

    def test_no_normals(self):
        """Flat: each triangle has its own; where there are some they are kept."""
        mesh = Mesh()
        for normals in (False, True):
            writer = Writer()
            attributes = {"POSITION": writer.accessor(mesh.points, bounds=True)}
            if normals:
                attributes["NORMAL"] = writer.accessor(mesh.normals)
                attributes["TANGENT"] = writer.accessor(mesh.tangents)
            primitive = {"attributes": attributes, "indices": writer.accessor(mesh.indices, "u2")}
            scene(writer, primitive, {"scale": [1, 2, 3], "rotation": [0.5, 0.5, 0.5, 0.5]})
            reader = self.compare(writer.save(self.folder / f"normals{normals}.gltf"))
            points = reader.GetOutput().GetBlock(0).GetNumberOfPoints()
            self.assertEqual(points, 24)

    def test_attributes(self):
        """Coordinates and colours as floats, bytes and shorts; colours with alpha and without."""
        mesh = Mesh()
        for kind in ("f4", "u1", "u2"):
            for components in (3, 4):
                for alpha in ("OPAQUE", "BLEND"):
                    writer = Writer()
                    most = 1 if kind == "f4" else numpy.iinfo(kind).max
                    whole = kind != "f4"

                    def pack(values):
                        return numpy.round(values * most) if whole else values

                    attributes = {
                        "POSITION": writer.accessor(mesh.points, bounds=True),
                        "TEXCOORD_0": writer.accessor(
                            pack(numpy.clip(mesh.coordinates, 0, 1)), kind, whole, aligned=True
                        ),
                        "COLOR_0": writer.accessor(
                            pack(mesh.colors[:, :components]), kind, whole, aligned=True
                        ),
                    }
                    material = {
                        "alphaMode": alpha,
                        "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 0.5]},
                    }
                    primitive = {
                        "attributes": attributes,
                        "material": writer.add("materials", material),
                    }
                    scene(writer, primitive)
                    self.compare(writer.save(self.folder / f"{kind}{components}{alpha}.glb"))

    def test_colors_that_are_not_lit(self):
        mesh = Mesh()
        writer = Writer()
        writer.uses("KHR_materials_unlit")
        material = writer.add("materials", {"extensions": {"KHR_materials_unlit": {}}})
        attributes = {
            "POSITION": writer.accessor(mesh.points, bounds=True),
            "COLOR_0": writer.accessor(mesh.colors[:, :3]),
        }
        scene(writer, {"attributes": attributes, "material": material})
        self.compare(writer.save(self.folder / "unlit.glb"))

    def test_quantized(self):
        """KHR_mesh_quantization: positions, normals, tangents and coordinates of every type."""
        mesh = Mesh()
        for kind in ("i1", "u1", "i2", "u2"):
            for whole in (False, True):
                writer = Writer()
                writer.uses("KHR_mesh_quantization", True)
                info = numpy.iinfo(kind)
                signed = kind if kind[0] == "i" else "i" + kind[1]
                most = numpy.iinfo(signed).max
                points = mesh.random.integers(info.min, info.max, (24, 3), endpoint=True)
                points[0] = info.min  # of signed numbers beyond -1, and clamped
                attributes = {
                    "POSITION": writer.accessor(points, kind, whole, aligned=True, bounds=True),
                    "NORMAL": writer.accessor(
                        numpy.round(mesh.normals * most), signed, True, aligned=True
                    ),
                    "TANGENT": writer.accessor(
                        numpy.round(mesh.tangents * most), signed, True, aligned=True
                    ),
                    "TEXCOORD_0": writer.accessor(points[:, :2], kind, whole, aligned=True),
                }
                node = {"scale": [0.01, 0.02, 0.01], "translation": [-1, 2, 3]}
                scene(writer, {"attributes": attributes}, node)
                self.compare(writer.save(self.folder / f"{kind}{whole}.glb"))

    def test_sparse(self):
        """With values below the sparse ones and without, and of indices."""
        mesh = Mesh()
        for bare in (False, True):
            writer = Writer()
            places = range(24) if bare else [1, 5, 23]
            put = (list(places), mesh.random.normal(size=(len(places), 3)))
            points = writer.accessor(mesh.points, sparse=put, bare=bare, bounds=True)
            indices = writer.accessor(mesh.indices, "u2", sparse=([0, 2], [7, 8]))
            scene(writer, {"attributes": {"POSITION": points}, "indices": indices})
            self.compare(writer.save(self.folder / f"sparse{bare}.glb"))

    def test_interleaved(self):
        mesh = Mesh()
        writer = Writer()
        rows = numpy.hstack([mesh.points, mesh.normals]).astype("<f4")
        view = writer.view(rows.tobytes(), 24)
        first = {"bufferView": view, "componentType": 5126, "count": 24, "type": "VEC3"}
        first["min"], first["max"] = (
            [float(v) for v in rows[:, :3].min(0)],
            [float(v) for v in rows[:, :3].max(0)],
        )
        second = {**first, "byteOffset": 12}
        del second["min"], second["max"]
        attributes = {
            "POSITION": writer.add("accessors", first),
            "NORMAL": writer.add("accessors", second),
        }
        scene(writer, {"attributes": attributes})
        self.compare(writer.save(self.folder / "rows.glb"))

    def test_shared_points(self):
        """Primitives with a few of many points get those."""
        mesh = Mesh(300)
        writer = Writer()
        attributes = {
            "POSITION": writer.accessor(mesh.points, bounds=True),
            "NORMAL": writer.accessor(mesh.normals),
        }
        primitives = [
            {"attributes": attributes, "indices": writer.accessor(mesh.indices[i : i + 3], "u2")}
            for i in range(0, 30, 3)
        ]
        writer.add("nodes", {"mesh": writer.add("meshes", {"primitives": primitives})})
        reader = self.compare(writer.save(self.folder / "shared.glb"))
        self.assertEqual(reader.GetOutput().GetBlock(4).GetNumberOfPoints(), 3)

    def test_texture_places(self):
        """The set and the transform of the material's first texture count; others are noted."""
        mesh = Mesh()
        moved = {"offset": [0.25, -0.5], "rotation": 0.7, "scale": [2, 3]}
        uri = "data:image/png;base64,iVBORw0KGgo="
        for set_, transform in ((0, None), (1, None), (1, moved), (0, {**moved, "texCoord": 1})):
            for other in (False, True):
                writer = Writer()
                writer.uses("KHR_texture_transform")
                writer.add("images", {"uri": uri})
                writer.add("textures", {"source": 0})
                info = {"index": 0, "texCoord": set_}
                if transform:
                    info["extensions"] = {"KHR_texture_transform": transform}
                material = {"pbrMetallicRoughness": {"baseColorTexture": info}}
                if other:
                    material["emissiveTexture"] = {"index": 0, "texCoord": 2}
                    material["emissiveFactor"] = [1, 1, 1]
                attributes = {
                    "POSITION": writer.accessor(mesh.points, bounds=True),
                    "TEXCOORD_0": writer.accessor(mesh.coordinates),
                    "TEXCOORD_1": writer.accessor(1 - 2 * mesh.coordinates),
                    "TEXCOORD_2": writer.accessor(mesh.coordinates**2),
                }
                primitive = {
                    "attributes": attributes,
                    "material": writer.add("materials", material),
                }
                scene(writer, primitive)
                notes = ["materials[0]: its texture of emission"] if other else []
                self.compare(writer.save(self.folder / "moved.glb"), notes=notes)

    def test_infinite_points(self):
        """Cells that have them are left out, with a note."""
        mesh = Mesh()
        for value in (numpy.inf, -numpy.inf, numpy.nan):
            points = mesh.points.copy()
            points[4, 1] = value
            writer = Writer()
            scene(writer, {"attributes": {"POSITION": writer.accessor(points)}})
            reader, errors = self.read(writer.save(self.folder / "infinite.glb"))
            self.assertEqual(errors, [])
            block = reader.GetOutput().GetBlock(0)
            self.assertEqual(block.GetNumberOfCells(), 7)
            self.assertTrue(numpy.isfinite(block.GetBounds()).all())
            self.assertIn("1 points are not finite", self.notes(reader)[0])


class Nodes(GltfTest):
    def test_mirrors(self):
        """Faces turn where a node, a parent, or both mirror; the outside stays outside."""
        mesh = Mesh()
        scales = ([1, 1, 1], [-1, 1, 1], [1, -2, 1], [-1, -1, 1], [-1, -1, -0.5])
        for normals in (False, True):
            for own in scales:
                for above in scales:
                    writer = Writer()
                    attributes = {"POSITION": writer.accessor(mesh.points, bounds=True)}
                    if normals:
                        attributes["NORMAL"] = writer.accessor(mesh.normals)
                        attributes["TANGENT"] = writer.accessor(mesh.tangents)
                    node = scene(writer, {"attributes": attributes}, {"scale": own})
                    writer.add(
                        "nodes",
                        {"children": [node], "scale": above, "rotation": [0, HALF, 0, HALF]},
                    )
                    self.compare(writer.save(self.folder / "mirror.glb"))

    def test_matrices(self):
        mesh = Mesh()
        writer = Writer()
        attributes = {
            "POSITION": writer.accessor(mesh.points, bounds=True),
            "NORMAL": writer.accessor(mesh.normals),
        }
        matrix = [1, 0.2, 0, 0, 0.5, 2, 0, 0, 0, 0, -3, 0, 4, 5, 6, 1]
        scene(writer, {"attributes": attributes}, {"matrix": matrix})
        self.compare(writer.save(self.folder / "matrix.glb"))

    def test_one_mesh_at_many_nodes(self):
        mesh = Mesh()
        writer = Writer()
        points = writer.accessor(mesh.points, bounds=True)
        node = scene(writer, {"attributes": {"POSITION": points}})
        children = [
            writer.add("nodes", {"mesh": 0, "translation": [3 * i, 0, 0], "name": f"n{i}"})
            for i in range(4)
        ]
        writer.add("nodes", {"children": [node, *children], "scale": [2, 2, 2]})
        reader = self.compare(writer.save(self.folder / "many.glb"))
        block = reader.GetOutput().GetMetaData(2)
        self.assertEqual(block.Get(reader.GetOutput().NAME()), "n1")

    def test_far_away(self):
        """Doubles, where floats would round to a tenth of the mesh."""
        mesh = Mesh()
        writer = Writer()
        points = writer.accessor(mesh.points, bounds=True)
        scene(writer, {"attributes": {"POSITION": points}}, {"translation": [5e6, -4e6, 1e6]})
        reader = self.compare(writer.save(self.folder / "far.glb"))
        self.assertEqual(reader.GetOutput().GetBlock(0).GetPoints().GetDataType(), 11)

    def test_scenes(self):
        """The file's choice, else the first; without scenes all roots."""
        mesh = Mesh()
        for scenes, chosen, shown in (
            ([[0], [1, 2]], 1, 2), ([[0], [1, 2]], None, 1), (None, None, 3), ([[2]], 0, 1),
        ):  # fmt: skip
            writer = Writer()
            points = writer.accessor(mesh.points, bounds=True)
            writer.add("meshes", {"primitives": [{"attributes": {"POSITION": points}}]})
            for i in range(3):
                writer.add("nodes", {"mesh": 0, "translation": [i, 0, 0]})
            if scenes:
                writer.json["scenes"] = [{"nodes": nodes} for nodes in scenes]
            if chosen is not None:
                writer.json["scene"] = chosen
            reader = self.compare(writer.save(self.folder / "scenes.glb"))
            self.assertEqual(reader.GetOutput().GetNumberOfBlocks(), shown)


def skinned(kind="f4", joints="u1", sets=1, inverse=True, mirror=False, above=None, morph=False):
    """A mesh with three joints, below a moved node of its own, which counts for nothing."""
    mesh = Mesh()
    writer = Writer()
    count = 24
    weights = mesh.random.uniform(0, 1, (count, 4 * sets))
    if sets == 1:
        weights[:, 3] = 0
    weights /= weights.sum(axis=1, keepdims=True)
    if kind != "f4":
        most = numpy.iinfo(kind).max
        weights = numpy.floor(weights * most)
        weights[:, 0] += most - weights.sum(axis=1)
    names = mesh.random.integers(0, 3, (count, 4 * sets))
    for row in names.reshape(-1, 4):  # no joint twice in a set
        row[:] = [*mesh.random.permutation(3), 0]
    if sets > 1:
        names = numpy.tile(numpy.arange(4 * sets), (count, 1))
    nodes = 4 * sets if sets > 1 else 3
    attributes = {
        "POSITION": writer.accessor(mesh.points, bounds=True),
        "NORMAL": writer.accessor(mesh.normals),
    }
    for i in range(sets):
        part = slice(4 * i, 4 * i + 4)
        attributes[f"JOINTS_{i}"] = writer.accessor(names[:, part], joints, aligned=True)
        attributes[f"WEIGHTS_{i}"] = writer.accessor(
            weights[:, part], kind, kind != "f4", aligned=True
        )
    primitive = {"attributes": attributes}
    extra = {}
    if morph:
        primitive["targets"] = [
            {"POSITION": writer.accessor(mesh.random.normal(size=(count, 3)), bounds=True)}
        ]
        extra["weights"] = [0.5]
    place = {"skin": 0, "translation": [7, 8, 9], "scale": [3, 1, 1]}
    node = scene(writer, primitive, place, **extra)
    first = None
    for i in range(nodes):
        child = {"translation": [0.1, 1, 0.2 * i], "rotation": [0, 0, 0.6, 0.8], "name": f"j{i}"}
        if i == 0 and mirror:
            child["scale"] = [-1, 1, 1]
        place = writer.add("nodes", child)
        if first is None:
            first = place
        else:
            writer.json["nodes"][place - 1]["children"] = [place]
    skin = {"joints": list(range(first, first + nodes))}
    if inverse:
        matrices = numpy.tile(numpy.eye(4), (nodes, 1, 1))
        matrices[:, :3, 3] = mesh.random.normal(size=(nodes, 3))
        matrices[:, :3, :3] += 0.2 * mesh.random.normal(size=(nodes, 3, 3))
        skin["inverseBindMatrices"] = writer.accessor(
            matrices.transpose(0, 2, 1).reshape(nodes, 16)
        )
    writer.add("skins", skin)
    if above:
        writer.add("nodes", {"children": [node], **above})
    times = writer.accessor(numpy.array([0.0, 1.0, 2.5]), bounds=True)
    turns = writer.accessor(unit(mesh.random.normal(size=(3, 4))))
    writer.add(
        "animations",
        {
            "samplers": [{"input": times, "output": turns}],
            "channels": [{"sampler": 0, "target": {"node": first + 1, "path": "rotation"}}],
        },
    )
    return writer


class Skins(GltfTest):
    def check(self, **words):
        path = skinned(**words).save(self.folder / "skin.glb")
        with self.subTest(**words):
            self.compare(path)
            for time in (0, 0.3, 1, 1.7, 2.5):
                self.compare(path, 0, time)

    def test_types(self):
        for kind in ("f4", "u1", "u2"):
            for joints in ("u1", "u2"):
                self.check(kind=kind, joints=joints)

    def test_eight_weights(self):
        self.check(sets=2)

    def test_no_matrices(self):
        self.check(inverse=False)

    def test_below_a_moved_parent(self):
        self.check(above={"translation": [100, 0, 0], "scale": [5, 5, 5]})

    def test_mirrored_bones(self):
        self.check(mirror=True)

    def test_morphed(self):
        self.check(morph=True)

    def test_joints_of_no_scene(self):
        writer = skinned()
        writer.json["scenes"] = [{"nodes": [0]}]
        self.compare(writer.save(self.folder / "apart.glb"))

    def test_too_many(self):
        """The strongest are kept, with a note."""
        path = skinned(sets=2).save(self.folder / "eight.glb")
        reader, _ = self.read(path)
        reader.SetWeightsPerPoint(4)
        reader.Update()
        self.assertIn("24 points have more than 4 bones", self.notes(reader)[0])


def morphing(normals=True, node=None, mesh=None, sparse=None, kind="f4"):
    shape = Mesh()
    writer = Writer()
    attributes = {"POSITION": writer.accessor(shape.points, bounds=True)}
    if normals:
        attributes["NORMAL"] = writer.accessor(shape.normals)
        attributes["TANGENT"] = writer.accessor(shape.tangents)
    targets = []
    for i in range(2):
        change = shape.random.normal(size=(24, 3))
        put = ([2, 7 + i], [[1, 1, 1], [2, 2, -2]]) if sparse else None
        target = {
            "POSITION": writer.accessor(change, sparse=put, bare=sparse == "bare", bounds=True)
        }
        if normals:
            target["NORMAL"] = writer.accessor(0.3 * shape.random.normal(size=(24, 3)))
            target["TANGENT"] = writer.accessor(0.3 * shape.random.normal(size=(24, 3)))
        targets.append(target)
    extra = {"weights": mesh} if mesh else {}
    place = {"rotation": [0.5, 0.5, 0.5, 0.5], "scale": [1, -2, 3], "translation": [1, 2, 3]}
    if node:
        place["weights"] = node
    scene(writer, {"attributes": attributes, "targets": targets}, place, **extra)
    times = writer.accessor(numpy.array([0.5, 1.0, 3.0]), bounds=True)
    weights = numpy.array([0, 0.5, 1, 0, 0.25, 1.0])
    if kind != "f4":
        weights = numpy.round(weights * numpy.iinfo(kind).max)
    plain = writer.accessor(weights, kind, kind != "f4")
    splines = writer.accessor(shape.random.normal(size=18))
    for mode, values in (("LINEAR", plain), ("STEP", plain), ("CUBICSPLINE", splines)):
        writer.add(
            "animations",
            {
                "name": mode,
                "samplers": [{"input": times, "output": values, "interpolation": mode}],
                "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
            },
        )
    return writer


class Morphs(GltfTest):
    def test_weights_at_rest(self):
        """Those of the mesh, or of the node, which has the last word; none are zeros."""
        for normals in (False, True):
            for mesh in (None, [0.5, 0.25]):
                for node in (None, [1, -0.5]):
                    writer = morphing(normals, node, mesh)
                    self.compare(writer.save(self.folder / "morph.glb"))

    def test_sparse(self):
        for sparse in ("dense", "bare"):
            writer = morphing(mesh=[0.5, 0.7], sparse=sparse)
            self.compare(writer.save(self.folder / f"{sparse}.glb"))

    def test_animated(self):
        for normals in (False, True):
            for kind in ("f4", "u1", "u2"):
                path = morphing(normals, kind=kind).save(self.folder / "animated.glb")
                reader, _ = self.read(path)
                for i in range(3):
                    name = reader.GetAnimationName(i)
                    for time in (0, 0.5, 0.6, 1, 2, 3, 4):
                        self.compare_at(path, name, i, time)

    def compare_at(self, path, name, which, time):
        reader, errors = self.read(path)
        reader.SetPose(reading.ANIMATION)
        reader.SetAnimation(name)
        reader.UpdateTimeStep(time)
        truth = reading.evaluator.Scene(path, which, time).primitives()
        with self.subTest(name=name, time=time):
            self.assertEqual(errors, [])
            self.compare_block(reader.GetOutput().GetBlock(0), truth[0])


class Animations(GltfTest):
    def test_tracks(self):
        """Of every path and mode; rotations as floats and as whole numbers."""
        for mode in ("LINEAR", "STEP", "CUBICSPLINE"):
            for kind in ("f4", "i1", "u1", "i2", "u2"):
                mesh = Mesh()
                writer = Writer()
                attributes = {
                    "POSITION": writer.accessor(mesh.points, bounds=True),
                    "NORMAL": writer.accessor(mesh.normals),
                }
                # Parts without a track keep the file's values, even a reflection along one axis.
                scene(
                    writer,
                    {"attributes": attributes},
                    {"scale": [-1, 2, 1], "rotation": [0.5, -0.5, 0.5, 0.5]},
                )
                keys = 4
                each = 3 if mode == "CUBICSPLINE" else 1
                times = writer.accessor(numpy.array([0.25, 0.5, 2, 3]), bounds=True)
                turns = mesh.random.uniform(0.1, 1, (keys * each, 4))
                turns = turns if mode == "CUBICSPLINE" else unit(turns)
                whole = kind != "f4"
                if whole:
                    turns = numpy.round(turns * numpy.iinfo(kind).max)
                tracks = {
                    "translation": writer.accessor(mesh.random.normal(size=(keys * each, 3))),
                    "rotation": writer.accessor(turns, kind, whole),
                    "scale": writer.accessor(mesh.random.normal(size=(keys * each, 3))),
                }
                for path, values in tracks.items():
                    writer.add(
                        "animations",
                        {
                            "name": path,
                            "samplers": [
                                {"input": times, "output": values, "interpolation": mode}
                            ],
                            "channels": [{"sampler": 0, "target": {"node": 0, "path": path}}],
                        },
                    )
                path = writer.save(self.folder / "tracks.glb")
                reader, errors = self.read(path)
                self.assertEqual(errors, [])
                reader.SetPose(reading.ANIMATION)
                for i, name in enumerate(tracks):
                    reader.SetAnimation(name)
                    reader.UpdateInformation()
                    self.assertEqual(times_of(reader), [0.25, 0.5, 2, 3])
                    for time in (0, 0.25, 0.3, 0.5, 1, 2.9, 3, 5):
                        reader.UpdateTimeStep(time)
                        truth = reading.evaluator.Scene(path, i, time).primitives()
                        with self.subTest(mode=mode, kind=kind, name=name, time=time):
                            self.compare_block(reader.GetOutput().GetBlock(0), truth[0])

    def test_from_nothing(self):
        """A node of size 0 at rest grows."""
        mesh = Mesh()
        writer = Writer()
        points = writer.accessor(mesh.points, bounds=True)
        scene(writer, {"attributes": {"POSITION": points}}, {"scale": [0, 0, 0]})
        times = writer.accessor(numpy.array([0.0, 1.0]), bounds=True)
        sizes = writer.accessor(numpy.array([[0.0, 0, 0], [1, 2, -3]]))
        writer.add(
            "animations",
            {
                "samplers": [{"input": times, "output": sizes}],
                "channels": [{"sampler": 0, "target": {"node": 0, "path": "scale"}}],
            },
        )
        path = writer.save(self.folder / "grows.glb")
        for time in (0.25, 0.5, 1):
            self.compare(path, 0, time)


if __name__ == "__main__":
    unittest.main()
