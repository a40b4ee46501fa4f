# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of glTF files by the reader's properties, textures and lights: silhouettes against
triangles that numpy fills, colours against the file's numbers and the specification's formulas."""

import gc
import itertools
import unittest

import numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import (
    vtkConeSource,
    vtkCubeSource,
    vtkLineSource,
    vtkSphereSource,
)
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkGlyph3DMapper,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTexture,
    vtkWindowToImageFilter,
)

import relievo
from evaluator import Scene
from reading import VERSION, GltfTest
from writer import Writer, data_uri, png

try:
    from vtkmodules.vtkIOGeometry import vtkGLTFReader
except ImportError:
    vtkGLTFReader = None  # the VTK of the wheel has none

SIZE = 120
REPEAT, CLAMP, MIRROR = 10497, 33071, 33648


def picture(reader, lights=False, background=(0, 0, 0), half=1.5, light=None):
    """Rows from the top, of a view along -z that shows -half to half."""
    renderer = vtkRenderer()
    renderer.SetBackground(background)
    for i in range(reader.GetOutput().GetNumberOfBlocks()):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(reader.GetOutput().GetBlock(i))
        actor = vtkActor()
        actor.SetMapper(mapper)
        reader.ApplyMaterial(i, actor)
        renderer.AddActor(actor)
    if lights:
        for i in range(reader.GetNumberOfLights()):
            renderer.AddLight(reader.GetLight(i))
    else:
        renderer.AddLight(light or vtkLight())
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetPosition(0, 0, 50)
    camera.SetParallelScale(half)
    camera.SetClippingRange(1, 100)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    texels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return texels.reshape(SIZE, SIZE, 3)[::-1].astype(int)


def fill(triangles, half=1.5):
    """Which pixels have their centre in a triangle; corners in world coordinates."""
    centres = (numpy.arange(SIZE) + 0.5) * (2 * half / SIZE) - half
    x, y = numpy.meshgrid(centres, -centres)
    covered = numpy.zeros((SIZE, SIZE), bool)
    for (ax, ay), (bx, by), (cx, cy) in triangles[..., :2]:
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if abs(area) < 1e-12:
            continue
        s = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
        t = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
        covered |= (s >= 0) & (t >= 0) & (s + t <= 1)
    return covered


def farther_than_a_pixel(seen, truth):
    """Pixels that differ where the truth is the same all around."""
    padded = numpy.pad(truth, 1, mode="edge")
    around = [padded[i : i + SIZE, j : j + SIZE] for i in range(3) for j in range(3)]
    same = numpy.all(around, axis=0) | ~numpy.any(around, axis=0)
    return int(((seen != truth) & same).sum())


def quad(writer, material=None, scale=1.0, colors=None, **coordinates):
    """A square from -1 to 1 in the plane z = 0, facing +z; coordinates from the top left."""
    corners = numpy.array([[-1.0, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]])
    attributes = {"POSITION": writer.accessor(scale * corners, bounds=True)}
    attributes["NORMAL"] = writer.accessor(numpy.array([[0.0, 0, 1]] * 4))
    for name, (low, high) in coordinates.items():
        attributes[name] = writer.accessor(
            numpy.array([[low, high], [high, high], [high, low], [low, low]], float)
        )
    if colors is not None:
        attributes["COLOR_0"] = writer.accessor(numpy.array(colors, float))
    primitive = {
        "attributes": attributes,
        "indices": writer.accessor(numpy.array([0, 1, 2, 0, 2, 3]), "u2"),
    }
    if material is not None:
        primitive["material"] = writer.add("materials", material)
    mesh = writer.add("meshes", {"primitives": [primitive]})
    return writer.add("nodes", {"mesh": mesh})


def textured(writer, texels, wrap=(CLAMP, CLAMP), filtering=9728):
    sampler = {"wrapS": wrap[0], "wrapT": wrap[1], "magFilter": filtering, "minFilter": filtering}
    texture = {
        "source": writer.add("images", {"uri": data_uri(png(texels))}),
        "sampler": writer.add("samplers", sampler),
    }
    return {"index": writer.add("textures", texture)}


UNLIT = {"extensions": {"KHR_materials_unlit": {}}}
TEXELS = numpy.random.default_rng(5).integers(0, 256, (4, 4, 4))
TEXELS[..., 3] = 255


class Silhouettes(GltfTest):
    def check(self, path, sided=False):
        reader, errors = self.read(path)
        self.assertEqual(errors, [])
        seen = picture(reader).any(axis=-1)
        shown = numpy.concatenate([p.points for p in Scene(path).primitives()])
        a, b, c = (shown[:, i, :2] for i in range(3))
        turns = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
        truth = fill(shown if sided else shown[turns > 0])
        self.assertEqual(farther_than_a_pixel(seen, truth), 0)
        return truth.sum()

    def test_sides(self):
        """Half of a solid, by whatever mirrors: outsides are seen, insides only if doubleSided."""
        corners = numpy.array([[0, 0, 1], [1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]], float)
        faces = [[0, 1, 2], [0, 2, 3], [0, 4, 1]]  # one is open
        counts = set()
        for own, above in itertools.product(([1, 1, 1], [-1, 1, 1], [-1, -1, -1]), repeat=2):
            for turned, sided in itertools.product((False, True), repeat=2):
                writer = Writer()
                primitive = {
                    "attributes": {"POSITION": writer.accessor(corners, bounds=True)},
                    "indices": writer.accessor(numpy.array(faces).ravel(), "u2"),
                    "material": writer.add("materials", {"doubleSided": sided}),
                }
                mesh = writer.add("meshes", {"primitives": [primitive]})
                node = writer.add("nodes", {"mesh": mesh, "scale": own})
                turn = [0, 1, 0, 0] if turned else [0, 0, 0.3, 0.954]
                writer.add("nodes", {"children": [node], "scale": above, "rotation": turn})
                path = writer.save(self.folder / "sides.glb")
                with self.subTest(own=own, above=above, turned=turned, sided=sided):
                    counts.add(self.check(path, sided) > 0)
        self.assertEqual(counts, {False, True})

    def test_points_and_lines(self):
        for mode in (0, 1, 3):
            writer = Writer()
            points = numpy.array([[-1, -1, 0], [1, 1, 0], [1, -1, 0], [-1, 1, 0]], float)
            attributes = {"POSITION": writer.accessor(points, bounds=True)}
            writer.add("meshes", {"primitives": [{"attributes": attributes, "mode": mode}]})
            writer.add("nodes", {"mesh": 0})
            reader, _ = self.read(writer.save(self.folder / "lines.glb"))
            self.assertGreaterEqual((picture(reader) > 0).any(axis=-1).sum(), 4)


class Textures(GltfTest):
    def shown(self, writer, **words):
        reader, errors = self.read(writer.save(self.folder / "textured.glb"))
        self.assertEqual(errors, [])
        return picture(reader, **words)

    def test_wraps(self):
        """Along u and v apart, within 2 of 255 at the middle of each texel."""
        at = numpy.arange(12) - 4
        places = {
            REPEAT: at % 4,
            CLAMP: numpy.clip(at, 0, 3),
            MIRROR: numpy.where(at // 4 % 2, 3 - at % 4, at % 4),
        }
        for s, t in itertools.product(places, repeat=2):
            for lit in (False, True):
                writer = Writer()
                info = textured(writer, TEXELS, (s, t))
                base = {"baseColorTexture": info, "metallicFactor": 0}
                material = {"pbrMetallicRoughness": base, **({} if lit else UNLIT)}
                quad(writer, material, TEXCOORD_0=(-1, 2))
                seen = self.shown(writer, half=1)[5::10, 5::10]
                wanted = TEXELS[places[t]][:, places[s]][..., :3]
                with self.subTest(s=s, t=t, lit=lit):
                    if lit:  # dimmed, in the same order
                        order = numpy.corrcoef(seen.ravel(), wanted.ravel())[0, 1]
                        self.assertGreater(order, 0.99)
                    else:
                        self.assertLessEqual(numpy.abs(seen - wanted).max(), 2)

    def test_sets(self):
        """The second set of coordinates, moved, and that of whole numbers."""
        writer = Writer()
        info = textured(writer, TEXELS, (REPEAT, REPEAT))
        info["texCoord"] = 1
        info["extensions"] = {
            "KHR_texture_transform": {"offset": [0.25, 0.5], "scale": [2, 1], "rotation": 0}
        }
        quad(writer, {"pbrMetallicRoughness": {"baseColorTexture": info}, **UNLIT},
             TEXCOORD_0=(0, 0.1), TEXCOORD_1=(0, 1))  # fmt: skip
        seen = self.shown(writer, half=1)[15::30, 7::15]
        rows = (numpy.arange(4) + 2) % 4
        columns = (numpy.arange(8) + 1) % 4
        self.assertLessEqual(numpy.abs(seen - TEXELS[rows][:, columns][..., :3]).max(), 2)

    def test_shared(self):
        """Textures with equal images and samplers are one; of colours and of values two."""
        writer = Writer()
        info = textured(writer, TEXELS)
        base = {"pbrMetallicRoughness": {"baseColorTexture": info}}
        for material in (base, {**base, "doubleSided": True}, {**base, "normalTexture": info}):
            quad(writer, material, TEXCOORD_0=(0, 1))
        reader, _ = self.read(writer.save(self.folder / "shared.glb"))
        properties = [reader.GetProperty(i) for i in range(3)]
        textures = {p.GetTexture("albedoTex") for p in properties}
        self.assertEqual(len(textures), 1)
        self.assertTrue(textures.pop().GetUseSRGBColorSpace())
        normal = properties[2].GetTexture("normalTex")
        self.assertFalse(normal.GetUseSRGBColorSpace())
        self.assertEqual([p.GetBackfaceCulling() for p in properties], [1, 0, 1])

    def test_one_image_twice(self):
        """A material may use an image in any of its slots; the scene can be let go of."""
        alone = vtkTexture()
        alone.GetExecutive()  # which refers to it
        slots = ["baseColorTexture", "metallicRoughnessTexture"]
        slots += ["normalTexture", "occlusionTexture", "emissiveTexture"]
        for count in range(2, len(slots) + 1):
            for used in itertools.combinations(slots, count):
                writer = Writer()
                info = textured(writer, TEXELS)
                rough = {slot: info for slot in used if slot in slots[:2]}
                material = {slot: info for slot in used if slot not in rough}
                material.update(pbrMetallicRoughness=rough, emissiveFactor=[1, 1, 1])
                quad(writer, material, TEXCOORD_0=(0, 1))
                scene = relievo.scene(writer.save(self.folder / "twice.glb"))
                actor = scene.renderer.GetActors().GetLastActor()
                names = ("albedoTex", "materialTex", "normalTex", "emissiveTex")
                textures = {actor.GetProperty().GetTexture(name) for name in names} - {None}
                self.assertGreater(len(textures), 0, used)
                del scene, actor
                gc.collect()
                counts = {each.GetReferenceCount() for each in textures}
                self.assertEqual(counts, {alone.GetReferenceCount()}, used)

    def test_material(self):
        """Every factor, in the property."""
        writer = Writer()
        writer.uses("KHR_materials_emissive_strength")
        image = TEXELS.copy()
        info = textured(writer, image)
        material = {
            "pbrMetallicRoughness": {
                "baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5,
                "roughnessFactor": 0.25, "metallicRoughnessTexture": info,
            },
            "normalTexture": {**info, "scale": 0.75},
            "occlusionTexture": {**textured(writer, 255 - image), "strength": 0.6},
            "emissiveTexture": info, "emissiveFactor": [1, 0.5, 0.25],
            "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}},
            "alphaMode": "BLEND", "doubleSided": True,
        }  # fmt: skip
        quad(writer, material, TEXCOORD_0=(0, 1))
        reader, errors = self.read(writer.save(self.folder / "material.glb"))
        self.assertEqual(errors, [])
        own = reader.GetProperty(0)
        self.assertEqual(own.GetInterpolationAsString(), "Physically based rendering")
        numpy.testing.assert_allclose(own.GetColor(), [0.1, 0.2, 0.3])
        self.assertEqual(own.GetOpacity(), 0.4)
        self.assertEqual((own.GetMetallic(), own.GetRoughness()), (0.5, 0.25))
        self.assertEqual((own.GetNormalScale(), own.GetOcclusionStrength()), (0.75, 0.6))
        self.assertEqual(own.GetEmissiveFactor(), (4, 2, 1))
        self.assertEqual(own.GetBackfaceCulling(), 0)
        # Red is the occlusion's red, green and blue are roughness and metal.
        merged = own.GetTexture("materialTex").GetInput().GetPointData().GetScalars()
        wanted = image[::-1, :, :3].copy()
        wanted[..., 0] = 255 - image[::-1, :, 0]
        numpy.testing.assert_array_equal(vtk_to_numpy(merged), wanted.reshape(-1, 3))
        self.assertTrue(own.GetTexture("emissiveTex").GetUseSRGBColorSpace())
        self.assertEqual(reader.GetAlphaMode(0), reader.ALPHA_BLEND)
        self.assertIsNone(reader.GetProperty(1))
        self.assertIsNone(reader.GetProperty(-1))

    def test_damaged_image(self):
        """One error, and the mesh without it."""
        writer = Writer()
        writer.add("images", {"uri": data_uri(b"\x89PNG\r\n\x1a\n" + bytes(40))})
        writer.add("textures", {"source": 0})
        quad(writer, {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}},
             TEXCOORD_0=(0, 1))  # fmt: skip
        reader, errors = self.read(writer.save(self.folder / "damaged.glb"))
        self.assertEqual(errors, [])
        self.assertTrue(picture(reader).any())
        self.assertEqual(len(errors), 1, errors)
        self.assertIn("images[0]", errors[0])


class Alpha(GltfTest):
    def middle(self, writer, **words):
        reader, errors = self.read(writer.save(self.folder / "alpha.glb"))
        self.assertEqual(errors, [])
        return picture(reader, background=(0, 0, 1), **words)[SIZE // 2, SIZE // 2 + 3]

    def test_modes(self):
        """OPAQUE ignores every alpha; BLEND multiplies those of factor, texture, and colours."""
        half = numpy.full((2, 2, 4), 128)
        half[..., :3] = 255
        for mode in ("OPAQUE", "BLEND"):
            for factor, texture, colors in itertools.product((False, True), repeat=3):
                writer = Writer()
                base = {"baseColorFactor": [1, 1, 1, 0.5 if factor else 1]}
                if texture:
                    base["baseColorTexture"] = textured(writer, half)
                quad(writer, {"alphaMode": mode, "pbrMetallicRoughness": base, **UNLIT},
                     colors=[[1, 1, 1, 0.5]] * 4 if colors else None,
                     TEXCOORD_0=(0, 1))  # fmt: skip
                alpha = 0.5 ** (factor + texture + colors) if mode == "BLEND" else 1
                wanted = numpy.array([alpha, alpha, 1]) * 255
                with self.subTest(mode=mode, factor=factor, texture=texture, colors=colors):
                    self.assertLessEqual(numpy.abs(self.middle(writer) - wanted).max(), 3)

    def test_lit(self):
        """Of a surface that is lit, too: alpha of factor and texture."""
        half = numpy.full((2, 2, 4), 128)
        half[..., :3] = 0
        modes = ("OPAQUE", "BLEND")
        for mode, factor, texture in itertools.product(modes, (1, 0.5), (False, True)):
            writer = Writer()
            base = {"baseColorFactor": [0, 0, 0, factor], "metallicFactor": 1}
            if texture:
                base["baseColorTexture"] = textured(writer, half)
            quad(writer, {"alphaMode": mode, "pbrMetallicRoughness": base}, TEXCOORD_0=(0, 1))
            if texture and VERSION < (9, 2):
                factor = 1  # which VTK did not look at there
            alpha = factor * (0.5 if texture else 1) if mode == "BLEND" else 1
            with self.subTest(mode=mode, factor=factor, texture=texture):
                self.assertLessEqual(abs(self.middle(writer)[2] - 255 * (1 - alpha)), 3)

    def test_masks(self):
        """Factor times texture against the cutoff, in the scene's picture: lit, and not."""
        texels = numpy.full((4, 4, 4), 200)
        texels[..., 3] = [0, 100, 180, 255]
        for lit, factor, shown in ((False, 0.8, 2), (True, 0.8, 2), (True, 1, 2), (True, 0.6, 1)):
            writer = Writer()
            base = {"baseColorTexture": textured(writer, texels), "metallicFactor": 0}
            if lit and factor != 1 and VERSION < (9, 2):
                continue  # VTK did not look at the factor there
            base["baseColorFactor"] = [1, 1, 1, factor]
            material = {"alphaMode": "MASK", "alphaCutoff": 0.5, "pbrMetallicRoughness": base}
            quad(writer, {**material, **({} if lit else UNLIT)}, TEXCOORD_0=(0, 1))
            path = writer.save(self.folder / "mask.glb")
            picture_path = self.folder / "mask.png"
            scene = relievo.scene(path, size="80x80", camera="0,0,5,0,0,0,0,1,0", parallel_scale=1)
            scene.render(picture_path)
            reader = vtkPNGReader()
            reader.SetFileName(str(picture_path))
            reader.Update()
            seen = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
            columns = seen.reshape(80, 80, -1)[40, 10::20, 0] > 0
            with self.subTest(lit=lit, factor=factor):
                self.assertEqual(columns.tolist(), [False] * (4 - shown) + [True] * shown)


class Light(GltfTest):
    def render(self, light, material, node=None, **words):
        writer = Writer()
        writer.json["extensions"] = {"KHR_lights_punctual": {"lights": [light]}}
        writer.uses("KHR_lights_punctual")
        quad(writer, material, **words)
        writer.add("nodes", {"extensions": {"KHR_lights_punctual": {"light": 0}}, **(node or {})})
        reader, errors = self.read(writer.save(self.folder / "lit.glb"))
        self.assertEqual(errors, [])
        return picture(reader, lights=True, half=1)

    def test_candela_and_lux(self):
        """The specification's BRDF of a white dielectric of roughness 1, straight from above: the
        diffuse part (1 - F) / pi, the mirrored D V F with D = 1 / pi, V = 1 / 4, F = 0.04."""
        white = {"pbrMetallicRoughness": {"metallicFactor": 0}}
        brdf = (0.96 + 0.04 / 4) / numpy.pi
        for kind, strength, height in (
            ("point", 1, 1), ("point", 1, 2), ("point", 3, 1), ("directional", 1, 7),
            ("directional", 2, 1), ("spot", 2, 1),
        ):  # fmt: skip
            light = {"type": kind, "intensity": strength}
            seen = self.render(light, white, {"translation": [0, 0, height]})
            fall = 1 if kind == "directional" else height**2
            wanted = 255 * min(brdf * strength / fall, 1) ** (1 / 2.2)
            with self.subTest(kind=kind, strength=strength, height=height):
                self.assertLessEqual(abs(seen[SIZE // 2, SIZE // 2, 0] - wanted), 2)

    def test_sun_beside_a_lamp(self):
        """Lights as it does alone, from the side too."""
        sun = {"type": "directional", "intensity": 2}
        node = {"translation": [0, 0, 0.1], "rotation": [0.4, 0, 0, 0.9165]}
        white = {"pbrMetallicRoughness": {"metallicFactor": 0}}
        alone = self.render(sun, white, node)
        writer = Writer()
        lights = [sun, {"type": "point", "intensity": 0}]
        writer.json["extensions"] = {"KHR_lights_punctual": {"lights": lights}}
        quad(writer, white)
        writer.add("nodes", {"extensions": {"KHR_lights_punctual": {"light": 0}}, **node})
        writer.add("nodes", {"extensions": {"KHR_lights_punctual": {"light": 1}}})
        reader, _ = self.read(writer.save(self.folder / "both.glb"))
        both = picture(reader, lights=True, half=1)
        self.assertGreater(alone.min(), 100)
        self.assertLessEqual(numpy.abs(alone - both).max(), 1)

    def test_cone(self):
        """Nothing outside of the outer cone, and the middle is bright."""
        light = {"type": "spot", "intensity": 3, "spot": {"outerConeAngle": 0.5}}
        seen = self.render(light, {"pbrMetallicRoughness": {"metallicFactor": 0}},
                           {"translation": [0, 0, 1]})[..., 0]  # fmt: skip
        centres = (numpy.arange(SIZE) + 0.5) * 2 / SIZE - 1
        radius = numpy.hypot(*numpy.meshgrid(centres, centres))
        self.assertEqual(seen[radius > numpy.tan(0.5) + 0.02].max(), 0)
        self.assertGreater(seen[radius < numpy.tan(0.5) - 0.05].min(), 0)

    def test_emission(self):
        """With a texture and without, also where the mesh has no coordinates; and its strength."""
        dark = {"type": "point", "intensity": 0}
        black = {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 1}
        for texture, placed, strength in ((False, False, 1), (False, True, 1), (True, True, 1),
                                          (False, False, 2)):  # fmt: skip
            writer = Writer()
            material = {
                "emissiveFactor": [0.2, 0.1, 0.4],
                "pbrMetallicRoughness": black,
                "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": strength}},
            }
            if texture:
                material["emissiveTexture"] = textured(writer, numpy.full((2, 2, 3), 188))
            writer.json["extensions"] = {"KHR_lights_punctual": {"lights": [dark]}}
            writer.add("nodes", {"extensions": {"KHR_lights_punctual": {"light": 0}}})
            quad(writer, material, **({"TEXCOORD_0": (0, 1)} if placed else {}))
            reader, _ = self.read(writer.save(self.folder / "glows.glb"))
            seen = picture(reader, lights=True)[SIZE // 2, SIZE // 2]
            share = ((188 / 255 + 0.055) / 1.055) ** 2.4 if texture else 1
            wanted = 255 * (strength * share * numpy.array([0.2, 0.1, 0.4])) ** (1 / 2.2)
            with self.subTest(texture=texture, placed=placed, strength=strength):
                self.assertLessEqual(numpy.abs(seen - wanted).max(), 2)

    def test_textures(self):
        """Base colour by sRGB's curve, times the factor, lit by a sun of two lux from above."""
        writer = Writer()
        writer.json["extensions"] = {
            "KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 2}]}
        }
        writer.uses("KHR_lights_punctual")
        base = {"baseColorTexture": textured(writer, TEXELS), "metallicFactor": 0}
        base["baseColorFactor"] = [1, 0.5, 0.25, 1]
        quad(writer, {"pbrMetallicRoughness": base}, TEXCOORD_0=(0, 1))
        writer.add("nodes", {"extensions": {"KHR_lights_punctual": {"light": 0}}})
        reader, _ = self.read(writer.save(self.folder / "lit.glb"))
        seen = picture(reader, lights=True, half=1)[15::30, 15::30]
        share = TEXELS[..., :3] / 255
        linear = numpy.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
        lit = 2 * (0.96 * linear * [1, 0.5, 0.25] + 0.01) / numpy.pi
        self.assertLessEqual(numpy.abs(seen - 255 * lit ** (1 / 2.2)).max(), 2)

    def test_colors(self):
        """COLOR_0 times the factor, linear: lit by 1 / brdf of a candela, and without light."""
        colors = [[0.5, 0.25, 1, 1]] * 4
        base = {"baseColorFactor": [0.5, 1, 0.5, 1], "metallicFactor": 0}
        product = numpy.array([0.25, 0.25, 0.5])
        light = {"type": "point", "intensity": 2}
        seen = self.render(light, {"pbrMetallicRoughness": base}, {"translation": [0, 0, 1]},
                           colors=colors)  # fmt: skip
        lit = 2 * (0.96 * product + 0.01) / numpy.pi
        wanted = 255 * lit ** (1 / 2.2)
        self.assertLessEqual(numpy.abs(seen[SIZE // 2, SIZE // 2] - wanted).max(), 3)
        # Unlit colours are those of sRGB itself, with colours of points and without.
        seen = self.render(light, {"pbrMetallicRoughness": base, **UNLIT}, colors=colors)
        wanted = 255 * (1.055 * product ** (1 / 2.4) - 0.055)
        self.assertLessEqual(numpy.abs(seen[SIZE // 2, SIZE // 2] - wanted).max(), 1)
        seen = self.render(light, {"pbrMetallicRoughness": base, **UNLIT})
        wanted = 255 * (1.055 * numpy.array([0.5, 1, 0.5]) ** (1 / 2.4) - 0.055)
        self.assertLessEqual(numpy.abs(seen[SIZE // 2, SIZE // 2] - wanted).max(), 1)


def linear_of(srgb):
    return numpy.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def mapped(mapper, values):
    """The colours of a mapper's table, which has 8 bits."""
    colors = numpy.zeros((len(values), 3))
    for value, color in zip(values, colors, strict=True):
        found = [0.0] * 3
        mapper.GetLookupTable().GetColor(value, found)
        color[:] = found
    return numpy.round(255 * colors) / 255


class Written(GltfTest):
    """Scenes as write_gltf() writes them, read by the evaluator and by VTK's own reader."""

    def setUp(self):
        super().setUp()
        self.path = str(self.folder / "out.glb")
        self.renderer = vtkRenderer()
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)

    def add(self, source):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        return actor

    def sphere(self):
        source = vtkSphereSource()
        source.SetThetaResolution(24)
        source.SetPhiResolution(12)
        heights = vtkElevationFilter()
        heights.SetInputConnection(source.GetOutputPort())
        heights.SetLowPoint(0, 0, -0.5)
        heights.SetHighPoint(0, 0, 0.5)
        return heights

    def write(self, **words):
        self.renderer.ResetCamera()
        notes = relievo.write_gltf(self.path, self.renderer, **words)
        return Scene(self.path), notes

    def test_points_normals_and_colors(self):
        """A turned, stretched and moved sphere, coloured by height, in a scene with z up."""
        actor = self.add(self.sphere())
        actor.SetPosition(3, -2, 1)
        actor.RotateX(40)
        actor.SetScale(1, 2, 0.5)
        scene, notes = self.write(up="z", names={actor: "ball"})
        self.assertEqual(notes, [])
        (found,) = scene.primitives()
        self.assertIn("ball", [node.get("name") for node in scene.nodes])
        data = actor.GetMapper().GetInput()
        cells = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        matrix = numpy.array([[actor.GetMatrix().GetElement(i, j) for j in range(4)]
                              for i in range(4)])  # fmt: skip
        upright = numpy.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])
        points = vtk_to_numpy(data.GetPoints().GetData())[cells]
        wanted = (points @ matrix[:3, :3].T + matrix[:3, 3]) @ upright.T
        self.assertLess(numpy.abs(found.points - wanted).max(), 1e-6)
        normals = vtk_to_numpy(data.GetPointData().GetNormals())[cells]
        wanted = normals @ numpy.linalg.inv(matrix[:3, :3]) @ upright.T
        wanted /= numpy.linalg.norm(wanted, axis=-1, keepdims=True)
        self.assertLess(numpy.abs(found.normals - wanted).max(), 1e-6)
        heights = vtk_to_numpy(data.GetPointData().GetScalars())
        wanted = linear_of(mapped(actor.GetMapper(), heights))[cells]
        self.assertLess(numpy.abs(found.colors[..., :3] - wanted).max(), 1 / 65535)

    def test_edges_are_left_out(self):
        """With a note, from the file and from its comparison; the scene keeps them."""
        actor = self.add(self.sphere())
        actor.GetProperty().EdgeVisibilityOn()
        scene, notes = self.write()
        self.assertEqual(len(scene.primitives()), 1)
        self.assertEqual(notes, ["edges are left out: glTF has none on surfaces"])
        self.assertTrue(actor.GetProperty().GetEdgeVisibility())

    def test_colors_of_cells(self):
        source = vtkCubeSource()
        source.Update()
        numbers = numpy_to_vtk(numpy.arange(6.0), deep=True)
        source.GetOutput().GetCellData().SetScalars(numbers)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(source.GetOutput())
        mapper.SetScalarRange(0, 5)
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        (found,) = self.write()[0].primitives()
        wanted = linear_of(mapped(mapper, range(6)))
        wanted = numpy.repeat(wanted, 2, axis=0)  # two triangles a side
        self.assertLess(numpy.abs(found.colors[..., :3] - wanted[:, None]).max(), 1 / 65535)
        if vtkGLTFReader is None:
            return
        reader = vtkGLTFReader()
        reader.SetFileName(self.path)
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfCells(), 12)
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), 36)

    def test_maps_of_values_are_textures(self):
        """A colour map that VTK looks up for each pixel."""
        actor = self.add(self.sphere())
        actor.GetMapper().InterpolateScalarsBeforeMappingOn()
        (found,) = self.write()[0].primitives()
        self.assertIn("baseColorTexture", found.material["pbrMetallicRoughness"])
        self.assertIsNone(found.colors)
        # PBR takes colours of a map as linear light: the file passes its own comparison.
        actor.GetProperty().SetInterpolationToPBR()
        self.assertEqual(self.write()[1], [])

    def test_far_from_the_origin(self):
        actor = self.add(self.sphere())
        source = actor.GetMapper().GetInputAlgorithm().GetInputAlgorithm()
        source.SetOutputPointsPrecision(1)  # double
        source.SetCenter(5e6, 3e6 + 0.125, -1e6)
        (found,) = self.write()[0].primitives()
        middle = (found.points.min(axis=(0, 1)) + found.points.max(axis=(0, 1))) / 2
        self.assertLess(numpy.abs(middle - [5e6, 3e6 + 0.125, -1e6]).max(), 1e-6)

    def test_materials_lights_and_camera(self):
        actor = self.add(self.sphere())
        actor.GetMapper().ScalarVisibilityOff()
        actor.GetProperty().SetColor(0.5, 0.25, 1)
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(1, 5, 2)
        light.SetFocalPoint(1, 2, -2)
        light.SetIntensity(0.5)
        self.renderer.AddLight(light)
        lamp = vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.PositionalOn()
        lamp.SetConeAngle(30)
        lamp.SetPosition(0, 0, 4)
        lamp.SetAttenuationValues(0, 0, 1)
        self.renderer.AddLight(lamp)
        scene, notes = self.write()
        self.assertEqual(notes, [])
        (found,) = scene.primitives()
        base = found.material["pbrMetallicRoughness"]
        wanted = [*linear_of(numpy.array([0.5, 0.25, 1])), 1]
        self.assertLess(numpy.abs(numpy.array(base["baseColorFactor"]) - wanted).max(), 1e-12)
        self.assertEqual(base["metallicFactor"], 0)
        (_, along, sun), (place, _, spot) = scene.lights()
        self.assertLess(numpy.abs(along - numpy.array([0, -0.6, -0.8])).max(), 1e-12)
        self.assertAlmostEqual(sun["intensity"], 0.5 * numpy.pi)
        self.assertEqual(list(place), [0, 0, 4])
        self.assertAlmostEqual(spot["intensity"], numpy.pi)
        self.assertAlmostEqual(spot["spot"]["outerConeAngle"], numpy.pi / 6)
        camera = self.renderer.GetActiveCamera()
        (lens,) = scene.file.list("cameras")
        self.assertAlmostEqual(lens["perspective"]["yfov"], numpy.radians(camera.GetViewAngle()))
        # PBR keeps its values, and its lights theirs.
        actor.GetProperty().SetInterpolationToPBR()
        actor.GetProperty().SetRoughness(0.3)
        scene, _ = self.write()
        base = scene.primitives()[0].material["pbrMetallicRoughness"]
        self.assertEqual(base["baseColorFactor"][:3], [0.5, 0.25, 1])
        self.assertEqual(base["roughnessFactor"], 0.3)
        self.assertEqual(scene.lights()[0][2]["intensity"], 0.5)

    def test_glyphs_blocks_and_clipping(self):
        """Cones at three points; the file passes its own comparison with the drawn scene."""
        cone = vtkConeSource()
        glyphs = vtkGlyph3DMapper()
        line = vtkLineSource()
        line.SetResolution(2)
        glyphs.SetInputConnection(line.GetOutputPort())
        glyphs.SetSourceConnection(cone.GetOutputPort())
        glyphs.SetScaleFactor(0.3)
        actor = vtkActor()
        actor.SetMapper(glyphs)
        self.renderer.AddActor(actor)
        ball = self.add(self.sphere())
        ball.SetPosition(0, 1, 0)
        plane = vtkPlane()
        plane.SetOrigin(0, 1, 0)
        plane.SetNormal(1, 0, 0)
        ball.GetMapper().AddClippingPlane(plane)
        cones, half = self.write()[0].primitives()
        self.assertEqual(len(cones.points), 3 * (6 + 4))  # a base of six corners in four triangles
        self.assertGreater(half.points[..., 0].min(), -1e-6)

    def test_animation(self):
        """A moved actor and one whose points move, by the evaluator at and between the keys."""
        moved, waving = self.add(self.sphere()), self.add(self.sphere())
        data = vtkPolyData()
        waving.GetMapper().GetInputAlgorithm().Update()
        data.DeepCopy(waving.GetMapper().GetInput())
        waving.GetMapper().SetInputDataObject(data)
        rest = vtk_to_numpy(data.GetPoints().GetData()).copy()
        writer = relievo.vtkRelievoGltfWriter()
        writer.SetRenderer(self.renderer)
        writer.SetFileName(self.path)
        self.renderer.ResetCamera()
        bent = [rest * (1 + 0.2 * i) + [0, 0, 2] for i in range(3)]
        matrices = []
        for i, points in enumerate(bent):
            moved.SetPosition(i, 0, 0)
            moved.SetOrientation(0, 30 * i, 0)
            matrices.append([moved.GetMatrix().GetElement(*divmod(k, 4)) for k in range(16)])
            data.GetPoints().SetData(numpy_to_vtk(points.astype(numpy.float32), deep=True))
            data.Modified()
            self.assertTrue(writer.AddKey(0.5 * i))
        self.assertTrue(writer.Write())
        self.assertEqual(writer.GetNumberOfNotes(), 0)
        cells = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        for i in range(3):
            first, second = Scene(self.path, animation=0, time=0.5 * i).primitives()
            matrix = numpy.array(matrices[i]).reshape(4, 4)
            wanted = rest[cells] @ matrix[:3, :3].T + matrix[:3, 3]
            self.assertLess(numpy.abs(first.points - wanted).max(), 2e-6)
            self.assertLess(numpy.abs(second.points - bent[i][cells]).max(), 2e-6)
        _, between = Scene(self.path, animation=0, time=0.25).primitives()
        self.assertLess(numpy.abs(between.points - (bent[0] + bent[1])[cells] / 2).max(), 2e-6)

    def test_a_file_of_another_scene_is_not_kept(self):
        actor = self.add(self.sphere())
        self.write()
        before = (self.folder / "out.glb").read_bytes()
        # A shader moves the sphere where only OpenGL knows.
        actor.GetShaderProperty().AddVertexShaderReplacement(
            "//VTK::PositionVC::Impl", True,
            "//VTK::PositionVC::Impl\ngl_Position.x += 0.2 * gl_Position.w;", False)
        with self.assertRaisesRegex(RuntimeError, "differs from the scene in depth of"):
            self.write()
        self.assertEqual((self.folder / "out.glb").read_bytes(), before)
        self.assertEqual(len(list(self.folder.iterdir())), 1)
        self.write(check=False)
        with self.assertRaisesRegex(ValueError, "ends in .glb"):
            relievo.write_gltf(self.folder / "out.gltf", self.renderer)
        with self.assertRaisesRegex(ValueError, "up: got 'w'"):
            self.write(up="w")
        self.renderer.RemoveActor(actor)
        with self.assertRaisesRegex(RuntimeError, "no mesh"):
            self.write()
        with self.assertRaises(FileNotFoundError):
            self.renderer.AddActor(actor)
            relievo.write_gltf(self.folder / "none" / "out.glb", self.renderer)


if __name__ == "__main__":
    unittest.main()
