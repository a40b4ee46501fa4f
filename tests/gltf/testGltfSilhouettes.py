# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of glTF files by `relievo render`, from three sides and at times of their animations:
no pixel is farther than one pixel from the silhouette of the evaluator's triangles, as numpy
fills them, or from its lines and points."""

import os
import pathlib
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import evaluator
import relievo
import testGltfMeshes as meshes
from reading import GltfTest
from testGltfPictures import farther_than_a_pixel
from writer import Writer

FOLDER = pathlib.Path(os.environ["RELIEVO_DATA"]) / "gltf" / "glTF2"
SIZE = 120  # which farther_than_a_pixel expects
# To the right, up, and to the viewer.
VIEWS = (
    numpy.eye(3),
    numpy.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]]),
    numpy.array([[0.8, 0, -0.6], [-0.36, 0.8, -0.48], [0.48, 0.6, 0.64]]),
)
# Debian's models with triangles and without cut-outs, and a time of their animation.
MODELS = {
    "2CylinderEngine-glTF-Binary/2CylinderEngine.glb": None,
    "BoxTextured-glTF/BoxTextured.gltf": None,
    "cameras/Cameras.gltf": None,
    "glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_05.gltf": None,
    "glTF-Asset-Generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_13.gltf": None,
    "glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf": 0.7,
    "simple_skin/simple_skin.gltf": 1.3,
}


SMALL = 8  # pixels across: such triangles, of which files have many, are filled all at once


def within(triangles, x, y):
    """Whether places are in the triangles, for either winding."""
    corners = numpy.moveaxis(triangles, -2, 0)
    sides = [(q[..., 0] - p[..., 0]) * (y - p[..., 1]) - (q[..., 1] - p[..., 1]) * (x - p[..., 0])
             for p, q in zip(corners, numpy.roll(corners, -1, axis=0))]  # fmt: skip
    return numpy.min(sides, axis=0) * numpy.max(sides, axis=0) >= 0


def fill(triangles):
    """Which pixels have their centre in a triangle; corners in pixels from the upper left."""
    covered = numpy.zeros((SIZE, SIZE), bool)
    low = numpy.clip(numpy.floor(triangles.min(axis=1) - 0.5), 0, SIZE).astype(int)
    high = numpy.clip(numpy.ceil(triangles.max(axis=1) + 0.5), 0, SIZE).astype(int)
    small = (high - low).max(axis=1) <= SMALL
    for place in numpy.ndindex(SMALL, SMALL):
        mine = small & (low + place < high).all(axis=1)
        x, y = (low[mine] + place).T
        inside = within(triangles[mine], x + 0.5, y + 0.5)
        covered[y[inside], x[inside]] = True
    for triangle, (left, top), (right, bottom) in zip(triangles[~small], low[~small], high[~small]):
        x, y = numpy.meshgrid(numpy.arange(left, right) + 0.5, numpy.arange(top, bottom) + 0.5)
        covered[top:bottom, left:right] |= within(triangle[None, None], x, y)
    return covered


class Silhouettes(GltfTest):
    def look(self, scene, view, truth):
        """The visible pixels, and the corners of each primitive's cells in pixels."""
        right, up, back = view
        corners = numpy.concatenate([each.points.reshape(-1, 3) for each in truth])
        middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
        half = 1.1 * numpy.abs((corners - middle) @ numpy.array([right, up]).T).max()
        far = 3 * numpy.linalg.norm(corners - middle, axis=1).max()
        place = ",".join(map(repr, map(float, (*(middle + far * back), *middle, *up))))
        scene.set(camera=place, parallel_scale=float(half))
        layers = relievo.capture(scene.renderer, layers=["depth"])
        depth = vtk_to_numpy(layers.GetPointData().GetArray("depth")).reshape(SIZE, SIZE)[::-1]
        pixels = [((each.points - middle) @ numpy.array([right, -up]).T / half + 1) * SIZE / 2
                  for each in truth]  # fmt: skip
        return numpy.isfinite(depth), pixels

    def check(self, path, time=None, least=100):
        truth = evaluator.Scene(path, None if time is None else 0, time or 0.0).primitives()
        settings = {"time": time} if time is not None else {}
        scene = relievo.scene(path, size=f"{SIZE}x{SIZE}", **settings)
        for view in VIEWS:
            seen, pixels = self.look(scene, view, truth)
            shown = []
            for primitive, corners in zip(truth, pixels):
                a, b, c = corners.transpose(1, 0, 2)
                turns = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
                both = primitive.material.get("doubleSided", False)
                shown.append(corners if both else corners[turns < 0])  # y is downwards
            wanted = fill(numpy.concatenate(shown))
            with self.subTest(path=path.name, time=time, view=view[2].tolist()):
                self.assertEqual(farther_than_a_pixel(seen, wanted), 0)
                least -= wanted.sum()
        self.assertLess(least, 0, "hardly anything was to be seen")

    def test_models(self):
        for name, time in MODELS.items():
            self.check(FOLDER / name)
            if time is not None:
                self.check(FOLDER / name, time)

    def test_skins_and_morphs(self):
        for name, writer in (
            ("skin", meshes.skinned(above={"translation": [100, 0, 0], "scale": [5, 5, 5]})),
            ("mirror", meshes.skinned(mirror=True)),
            ("bind", meshes.skinned(inverse=False, kind="u1")),
            ("morph", meshes.morphing(mesh=[0.5, 0.25])),
            ("both", meshes.skinned(morph=True)),
        ):
            for sided in (False, True):
                writer.json["materials"] = [{"doubleSided": sided}]
                writer.json["meshes"][0]["primitives"][0]["material"] = 0
                path = writer.save(self.folder / f"{name}{sided}.glb")
                self.check(path)
                self.check(path, 0.6)

    def test_lines_and_points(self):
        """Each pixel is within one pixel of a line or a point, and each place of them has one."""
        shape = meshes.Mesh(8)
        for mode in range(4):
            writer = Writer()
            points = writer.accessor(shape.points, bounds=True)
            meshes.scene(writer, {"attributes": {"POSITION": points}, "mode": mode})
            path = writer.save(self.folder / "lines.glb")
            truth = evaluator.Scene(path).primitives()
            scene = relievo.scene(path, size=f"{SIZE}x{SIZE}")
            for view in VIEWS:
                seen, pixels = self.look(scene, view, truth)
                places = numpy.concatenate([
                    cell[0] + share * (cell[-1] - cell[0])
                    for cell in pixels[0] for share in numpy.linspace(0, 1, 400)[:, None]
                ]).reshape(-1, 2)  # fmt: skip
                rows, columns = numpy.nonzero(seen)
                centres = numpy.stack([columns, rows], axis=1) + 0.5
                gaps = numpy.abs(centres[:, None] - places[None]).max(axis=2)
                with self.subTest(mode=mode, view=view[2].tolist()):
                    self.assertLess(gaps.min(axis=1).max(), 1.5)  # no pixel without a place
                    self.assertLess(gaps.min(axis=0).max(), 1.5)  # no place without a pixel


if __name__ == "__main__":
    unittest.main()
