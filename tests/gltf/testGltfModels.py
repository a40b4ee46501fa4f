# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every glTF 2 file of Debian's assimp-testmodels: valid ones equal the evaluator's truth, the
others are refused with their error, or differ as stated here."""

import os
import pathlib
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import evaluator
import reading
from reading import GltfTest, cells_of

FOLDER = pathlib.Path(os.environ["RELIEVO_DATA"]) / "gltf" / "glTF2"

REFUSED = {
    "BoxTextured-glTF-techniqueWebGL/BoxTextured.gltf": "KHR_technique_webgl",
    "IndexOutOfRange/AllIndicesOutOfRange.gltf": "indices has 65535 as number 0",
    "IndexOutOfRange/IndexOutOfRange.gltf": "indices has 255 as number 0",
    "MissingBin/BoxTextured.gltf": "images[0] names CesiumLogoFlat.png, which is not there",
    "RecursiveNodes/RecursiveNodes.gltf": "nodes[0] is below itself",
    "SchemaFailures/sceneWrongType.gltf": 'scene is "hello"',
    "TestNoRootNode/NoScene.gltf": "scene names scenes[0], and there are 0 scenes",
    "wrongTypes/badArray.gltf": "meshes[0].primitives is an object",
    "wrongTypes/badExtension.gltf": "KHR_texture_transform is",
    "wrongTypes/badNumber.gltf": "materials[0].normalTexture.index is missing",
    "wrongTypes/badObject.gltf": "materials[0].pbrMetallicRoughness is a list",
    "wrongTypes/badUint.gltf": "baseColorTexture.index is -1",
}
NOTED = {
    "BoxTexcoords-glTF/boxTexcoords.gltf": ["has other coordinates than that of base colour"],
    "BoxTextured-glTF-pbrSpecularGlossiness/BoxTextured.gltf": [
        "uses KHR_materials_pbrSpecularGlossiness"
    ],
    "IncorrectVertexArrays/Cube.gltf": ["35 corners, which is no multiple of 3"],
}
INFINITE = "BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb"
COMPRESSED = "draco/2CylinderEngine.gltf"


def measure(block):
    """The area of a mesh, and the middle of its surface."""
    points = vtk_to_numpy(block.GetPoints().GetData()).astype(float)
    a, b, c = points[cells_of(block)].transpose(1, 0, 2)
    areas = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2
    return areas.sum(), (areas[:, None] * (a + b + c) / 3).sum(axis=0) / areas.sum()


class Models(GltfTest):
    def test_all(self):
        paths = sorted([*FOLDER.rglob("*.gltf"), *FOLDER.rglob("*.glb")])
        self.assertGreaterEqual(len(paths), 40)
        for path in paths:
            name = str(path.relative_to(FOLDER))
            with self.subTest(name=name):
                if name in REFUSED:
                    self.refused(path, REFUSED[name])
                elif name not in (INFINITE, COMPRESSED):
                    self.compare(path, notes=NOTED.get(name, ()))

    def test_all_times(self):
        for path in sorted(FOLDER.rglob("*.gltf")):
            name = str(path.relative_to(FOLDER))
            if name in REFUSED or not evaluator.File(path).list("animations"):
                continue
            reader, _ = self.read(path, reading.ANIMATION)
            times = reading.times_of(reader)
            for time in numpy.linspace(times[0], times[-1], 25):
                self.compare(path, 0, time)

    def test_infinite(self):
        """None of its cells has four finite points: nothing is left, with a note."""
        reader, errors = self.read(FOLDER / INFINITE)
        self.assertEqual(errors, [])
        self.assertIn("points are not finite", self.notes(reader)[0])
        with numpy.errstate(invalid="ignore"):
            points = evaluator.Scene(FOLDER / INFINITE).primitives()[0].points
        self.assertFalse(numpy.isfinite(points).all(axis=(1, 2)).any())
        self.assertEqual(reader.GetOutput().GetNumberOfBlocks(), 0)

    def test_compressed(self):
        """Draco's engine is the plain one within the step of its quantized positions."""
        packed, errors = self.read(FOLDER / COMPRESSED)
        self.assertEqual((errors, self.notes(packed)), ([], []))
        plain, _ = self.read(FOLDER / "2CylinderEngine-glTF-Binary/2CylinderEngine.glb")
        self.assertEqual(
            packed.GetOutput().GetNumberOfBlocks(), plain.GetOutput().GetNumberOfBlocks()
        )
        for i in range(plain.GetOutput().GetNumberOfBlocks()):
            a, b = (reader.GetOutput().GetBlock(i) for reader in (packed, plain))
            # Faces without area were left out when it was compressed, and points moved a little.
            (area, middle), (other, centre) = measure(a), measure(b)
            self.assertLess(abs(area / other - 1), 2e-3)
            self.assertLess(numpy.abs(middle - centre).max() / numpy.sqrt(other), 1e-3)


if __name__ == "__main__":
    unittest.main()
