# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""relievo.scene(): the command's pictures, for every order of settings; VTK is left unchanged."""

import base64
import errno
import html
import json
import math
import os
import pathlib
import re
import struct
import subprocess
import tempfile
import unittest
import warnings

import numpy
import relievo
from relievo.vtkRelievoScene import vtkRelievoBaseline, vtkRelievoScene
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkDoubleArray,
    vtkOutputWindow,
    vtkPoints,
    vtkStringArray,
    vtkStringOutputWindow,
    vtkUnsignedCharArray,
    vtkVersion,
)
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkCompositeDataSet,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPiecewiseFunction,
    vtkPolyData,
)
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkCompositeDataDisplayAttributes,
    vtkGlyph3DMapper,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkVolume,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper

if vtkVersion().GetVTKMinorVersion() < 3:
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as CompositeMapper
else:
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as CompositeMapper

# A roof over a floor, in two heights, with values at the points.
MESH = """# vtk DataFile Version 3.0
roof
ASCII
DATASET POLYDATA
POINTS 7 float
-2 0 -2  2 0 -2  2 0 2  -2 0 2  -1 1 -1  1 1.3 -1  0 1 1
POLYGONS 2 9
4 0 3 2 1
3 4 6 5
POINT_DATA 7
SCALARS height float 1
LOOKUP_TABLE default
0 0 0 0 1 1.3 1
"""
LAMPS = """# vtk DataFile Version 3.0
lamps
ASCII
DATASET POLYDATA
POINTS 2 float
1.5 0.5 1.5  -1.5 0.5 1.5
"""
CAMERA = (2.5, 3, 6, 0, 0.5, 0, 0, 1, 0)
SIZE = (120, 90)


def moving():
    """A glTF of a triangle that moves by 1 along x in a second."""
    numbers = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0]
    data = base64.b64encode(struct.pack("<17f", *numbers)).decode()
    views = ((0, 36), (36, 8), (44, 24))
    return json.dumps({
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": 68, "uri": "data:application/octet-stream;base64," + data}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": size} for start, size in views
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
             "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR",
             "min": [0], "max": [1]},
            {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"},
        ],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "animations": [{
            "samplers": [{"input": 1, "output": 2}],
            "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
        }],
    })  # fmt: skip


class Scene(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        self.mesh = self.folder / "roof.vtk"
        self.mesh.write_text(MESH)
        self.lamps = self.folder / "lamps.vtk"
        self.lamps.write_text(LAMPS)

    def path(self, name):
        return str(self.folder / name)

    def command(self, *words):
        """The bytes of the command's picture."""
        png = self.path("command.png")
        subprocess.run(
            [os.environ["RELIEVO"], "render", self.mesh, "--png", png, *words], check=True
        )
        return pathlib.Path(png).read_bytes()

    def picture(self, scene):
        scene.render(self.path("scene.png"))
        return (self.folder / "scene.png").read_bytes()

    def pixels(self, name):
        reader = vtkPNGReader()
        reader.SetFileName(self.path(name))
        reader.Update()
        width, height, _ = reader.GetOutput().GetDimensions()
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        return pixels.astype(int).reshape(height, width, -1)

    def test_every_kind_of_value(self):
        """Text, numbers, tuples, flags, lists: equal results to the command's arguments."""
        made = relievo.scene(
            self.mesh,
            size=SIZE,
            camera=CAMERA,
            clip=(1, 20.5),
            view_angle=40,
            color=(0.5, 0.25, 1),
            background="white,skyblue",
            edges=True,
            scalar_bar=False,
            light=["sun:3,5,2", "spot:1,4,1,0,0,0,30"],
            lamps=[f"{self.lamps},radius=2"],
            shadows="exact",
            tone=None,
        )
        words = "--size 120x90 --camera 2.5,3,6,0,0.5,0,0,1,0 --clip 1,20.5 --view-angle 40".split()
        words += "--color 0.5/0.25/1 --background white,skyblue --edges --light sun:3,5,2".split()
        words += ["--light", "spot:1,4,1,0,0,0,30", "--lamps", f"{self.lamps},radius=2"]
        self.assertEqual(self.picture(made), self.command(*words, "--shadows", "exact"))

    def test_any_order(self):
        """After other settings, files and cameras a picture is that of a new scene."""
        look = {"size": SIZE, "camera": CAMERA}
        ways = [
            {},
            {"preset": "studio"},
            {"color_by": "height", "scalar_bar": True, "shadows": "map", "light": "sun:1,3,2"},
            {"shading": "flat", "opacity": 0.5},
            {"lamps": str(self.lamps), "tone": "reinhard"},
            {"size": (90, 120), "camera": None, "up": "z"},
        ]
        fresh = [self.picture(relievo.scene(self.mesh, **{**look, **way})) for way in ways]
        self.assertEqual(len(set(fresh)), len(ways))
        scene = relievo.scene(self.mesh, **look)
        before = {}
        for i in (3, 0, 2, 5, 1, 4, 2, 3, 5, 0):
            scene.set(**{**dict.fromkeys(before), **look, **ways[i]})
            before = ways[i]
            self.assertEqual(self.picture(scene), fresh[i], ways[i])

    def test_labels_of_logarithms(self):
        """Powers of ten in the range; few decades have even steps."""
        for ends, expected in (((0.9, 1000), [1, 10, 100, 1000]), ((2, 900), [10, 100]),
                               ((1, 11), None)):  # fmt: skip
            scene = relievo.scene(
                self.mesh,
                color_by="height",
                range=ends,
                colormap="grey:log",
                scalar_bar=True,
            )
            props = scene.renderer.GetViewProps()
            props = [props.GetItemAsObject(i) for i in range(props.GetNumberOfItems())]
            (bar,) = [prop for prop in props if isinstance(prop, relievo.vtkRelievoColorBar)]
            _, *texts = bar.GetTexts(scene.renderer).split("\n")
            values = [float(text) for text in texts if text[0] not in "<>N"]
            if expected:
                self.assertEqual(values, expected)
            else:
                self.assertIn(numpy.diff(values).tolist(), ([1] * 10, [2] * 4, [5]))

    def test_files_of_actors(self):
        files = [str(self.folder / f"{i}.vtk") for i in range(3)]
        words = vtkStringArray()
        for file in files:
            pathlib.Path(file).write_text(MESH)
            words.InsertNextValue(file)
        scene = vtkRelievoScene()
        self.assertTrue(scene.SetWords(words) and scene.Update())
        self.assertEqual([scene.GetFileOf(actor) for actor in range(-1, 4)], ["", *files, ""])

    def test_frames_that_a_sequence_lacks(self):
        scene = vtkRelievoScene()
        scene.AddObserver("ErrorEvent", lambda *_: None)
        for ranges, more, said in (
            (((-1, 2), (3, 4), (0, 4), (2, 2)), (), "from 0 to 3"),
            (((1, 3),), ("--video", self.path("m.mp4")), "--video"),
        ):
            words = vtkStringArray()
            for word in (self.mesh, "--turntable", "3", "--png", self.path("m%d.png"), *more):
                words.InsertNextValue(str(word))
            self.assertTrue(scene.SetWords(words))
            for frames in ranges:
                with self.subTest(frames=frames):
                    scene.SetFrames(*frames)
                    self.assertFalse(scene.Write())
                    self.assertEqual(scene.GetFailure(), vtkRelievoScene.USAGE_FAILURE)
                    self.assertIn(said, scene.GetFailureText())

    def test_suns_right_above_and_below(self):
        for elevation in (90, -90):
            scene = relievo.scene(self.mesh, light=f"sun:30,{elevation}")
            light = scene.renderer.GetLights().GetItemAsObject(0)
            towards = numpy.subtract(light.GetPosition(), light.GetFocalPoint())
            towards /= numpy.linalg.norm(towards)
            numpy.testing.assert_allclose(towards, [0, elevation / 90, 0], atol=1e-9)

    def test_after_a_sequence(self):
        """A sequence's movements are undone at its end; a script's angle and size do not stay."""
        path = self.folder / "moving.gltf"
        path.write_text(moving())
        look = {"size": SIZE, "camera": (1, 0, 5, 1, 0, 0, 0, 1, 0)}
        still = self.picture(relievo.scene(path, **look, time=0))
        scene = relievo.scene(path, **look, times="0:1:0.5")
        frames = []
        for _ in range(2):
            scene.render(self.path("frame%d.png"))
            frames.append([(self.folder / f"frame{i}.png").read_bytes() for i in range(3)])
        self.assertEqual(frames[0], frames[1])
        self.assertEqual(len(set(frames[0])), 3)
        self.assertEqual(frames[0][0], still)
        scene.set(times=None, time=0)
        self.assertEqual(self.picture(scene), still)
        scene.renderer.GetActiveCamera().SetViewAngle(5)
        scene.window.SetSize(50, 40)
        self.assertEqual(self.picture(scene), still)

    def test_movies(self):
        """Frames equal stills of their views; views are cameras or triples, with their times."""
        scene = relievo.scene(self.mesh, size=SIZE)
        views = [((1, 3, 9), (0, 0, 0), (0, 1, 0)), ((7, 3, 4), (0, 0, 0), (0, 1, 0))]
        camera = vtkCamera()
        camera.SetPosition(views[1][0])
        scene.movie(png=self.path("m%d.png"), camera_path=[(1, views[0]), (1.5, camera)], fps=4)
        frames = [(self.folder / f"m{i}.png").read_bytes() for i in range(3)]
        for view, frame in zip(views, frames[::2]):
            still = relievo.scene(self.mesh, size=SIZE, camera=sum(view, ()))
            self.assertEqual(self.picture(still), frame)
        self.assertNotEqual(frames[1], frames[0])
        (self.folder / "m1.png").unlink()
        scene.movie(png=self.path("m%d.png"), camera_path=[(1, views[0]), (1.5, camera)], fps=4,
                    resume=True)  # fmt: skip
        self.assertEqual((self.folder / "m1.png").read_bytes(), frames[1])
        alone = [(1, views[0])]
        for invalid in ({"turntable": 1}, {"turntable": 3, "fps": 2}, {"camera_path": alone}):
            with self.assertRaises(ValueError):
                scene.movie(png=self.path("w%d.png"), **invalid)
        for invalid in (alone, [(0, 5)], [(0,)], 3, []):
            with self.assertRaisesRegex(ValueError, "^camera_path: .*expected a path or at least"):
                scene.movie(png=self.path("w%d.png"), camera_path=invalid)
        with self.assertRaisesRegex(ValueError, "movie"):
            scene.set(turntable=3)

    def test_two_scenes_in_turns(self):
        """A scene's options are applied while another's window drew last, in another state."""
        words = {"size": SIZE, "light": "sun:1,2,1", "shadows": "map", "shadow_size": 64}
        scene = relievo.scene(self.mesh, **words, opacity=0.5)
        other = relievo.scene(self.mesh, **words)
        first = self.picture(scene)
        self.assertNotEqual(self.picture(other), first)
        self.assertEqual(self.picture(scene), first)

    def test_a_cutoff_and_back(self):
        """Removing a material that made a translucent texture opaque restores the picture."""
        texture = numpy.full((8, 8, 4), 200, numpy.uint8)
        texture[..., 3] = 255 * (numpy.indices((8, 8)).sum(0) % 4) // 4
        image = vtkImageData()
        image.SetDimensions(8, 8, 1)
        image.GetPointData().SetScalars(numpy_to_vtk(texture.reshape(-1, 4), deep=True))
        writer = vtkPNGWriter()
        writer.SetFileName(self.path("holes.png"))
        writer.SetInputData(image)
        writer.Write()
        (self.folder / "holes.mtl").write_text("newmtl holes\nmap_Kd holes.png\n")
        path = self.folder / "holes.obj"
        path.write_text("mtllib holes.mtl\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nv -1 -1 -1\nv 1 -1 -1\n"
                        "v 0 1 -1\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl holes\n"
                        "f 1/1 2/2 3/3\nf 4/3 5/2 6/1\n")  # fmt: skip
        words = {"size": SIZE, "camera": (0, 0, 4, 0, 0, 0, 0, 1, 0)}
        cut = {"material": "alpha_cutoff=0.6"}
        opaque = self.picture(relievo.scene(path, **words, **cut))
        scene = relievo.scene(path, **words)
        first = self.picture(scene)
        self.assertEqual(self.picture(scene.set(**cut)), opaque)
        self.assertEqual(self.picture(scene.set(material=None)), first)

    def test_relief_in_masks(self):
        """Masks of forward shadows do not depend on what was drawn before."""
        heights = 255 * (numpy.indices((32, 32)).sum(0) % 8 < 4)
        relievo.write_png(self.path("heights.png"),
                          numpy.repeat(heights[..., None], 3, -1).astype(numpy.uint8))
        scene = relievo.scene(self.mesh, size=SIZE, camera=CAMERA, light="point:0,3,1",
                              shadows="forward", shadow_size=256,
                              height_map=self.path("heights.png,0.3"),
                              texture_coordinates="plane")  # fmt: skip
        first = self.picture(scene)
        for _ in range(2):  # mappers make their buffers anew
            self.assertTrue(self.picture(scene.set(color="red")) != first)
            self.assertTrue(self.picture(scene.set(color=None)) == first)

    def test_layers_leave_nothing(self):
        """Layers of the file are the capture's; the renderer has no frame afterwards."""
        scene = relievo.scene(self.mesh, size=SIZE, camera=CAMERA)
        plain = self.picture(scene)
        self.assertIsNone(scene.frame)
        scene.render(exr=self.path("a.exr"), layers=["depth", "cell", "height"])
        self.assertIsNone(scene.frame)
        written = relievo.read_exr(self.path("a.exr"))
        captured = relievo.capture(scene.renderer, ["depth", "cell", "height"])
        for name in ("depth", "cell", "height"):
            numpy.testing.assert_array_equal(
                relievo.layer(written, name), relievo.layer(captured, name)
            )
        self.assertEqual(set(numpy.unique(relievo.layer(captured, "cell"))), {-1, 0, 1})
        self.assertEqual(self.picture(scene), plain)

    def test_bands(self):
        """A picture drawn in bands is the whole one: texts, lines, samples, noise, layers."""
        size = (150, 460)  # a lowest band of 160 rows, two of 128, and one of 44
        common = {"size": size, "camera": (2.5, 3, 9, 0, 0.5, 0, 0, 1, 0), "view_angle": 50}
        sky = vtkImageData()
        sky.SetDimensions(64, 32, 1)
        turns = numpy.add.outer(3 * numpy.arange(32), 5 * numpy.arange(64)).ravel() / 10
        colors = 120 + 90 * numpy.sin(numpy.stack([turns, turns + 2, turns + 4], axis=1))
        sky.GetPointData().SetScalars(numpy_to_vtk(colors.astype(numpy.uint8), deep=True))
        writer = vtkPNGWriter()
        writer.SetInputData(sky)
        writer.SetFileName(self.path("sky.png"))
        writer.Write()
        version = vtkVersion().GetVTKMajorVersion(), vtkVersion().GetVTKMinorVersion()
        gradient = {"preset": "none", "background": "white,skyblue"}
        for options, often in (
            ({"preset": "none", "edges": True}, 1e-3 if version >= (9, 7) else 2e-4),
            # Since VTK 9.4, rows of a gradient may be rounded to the next level.
            (gradient, 2e-2 if version >= (9, 4) else 2e-4),
            ({"preset": "none", "scale_bar": "m", "color_by": "height", "scalar_bar": True,
              "parallel_scale": 3, "view_angle": None}, 2e-4),
            ({"preset": "none", "skybox": True, "environment": self.path("sky.png")}, 2e-4),
            ({"preset": "none", "skybox": True, "environment": self.path("sky.png"),
              "parallel_scale": 3, "view_angle": None}, 2e-4),
            ({"preset": "none", "lamps": f"{self.lamps},radius=2", "light": "sun:1,2,1",
              "shadows": "exact"}, 1e-3),
            ({"preset": "none", "ambient": "1", "tone": "reinhard", "light": "sun:1,2,1",
              "stage": ["lines", "tone:dither=ordered"],
              "soft_shadows": 8, "shadows": "map"}, 2e-2),
            ({"preset": "studio"}, 2e-2),
        ):  # fmt: skip
            with self.subTest(options=options):
                scene = relievo.scene(self.mesh, **{**common, **options})
                pictures = []
                for rows in (0, 192, 0):
                    scene._scene.SetBandRows(rows)
                    self.picture(scene)
                    pictures.append(self.pixels("scene.png"))
                whole, bands, again = pictures
                numpy.testing.assert_array_equal(whole, again)
                differ = abs(whole - bands).max(axis=2)
                self.assertLess(numpy.mean(differ > 0), often)
                self.assertLess(numpy.mean(differ > 8), 1e-3)
                if options is gradient:
                    self.assertLess(numpy.mean(differ > 1), 2e-4)
                self.assertGreater(numpy.std(whole, axis=(0, 1)).max(), 5)  # shows something

    def test_a_movie_in_bands(self):
        """Its frames are pictures of their views."""
        scene = relievo.scene(self.mesh, size=(90, 460), camera=CAMERA, preset="none")
        scene._scene.SetBandRows(192)
        scene.movie(png=self.path("m%d.png"), turntable=2)
        x, y, z = CAMERA[:3]
        for i, eye in enumerate(((x, y, z), (-x, y, -z))):
            still = relievo.scene(self.mesh, size=(90, 460), camera=(*eye, *CAMERA[3:]),
                                  preset="none")  # fmt: skip
            still.render(self.path("still.png"))
            frame, whole = self.pixels(f"m{i}.png"), self.pixels("still.png")
            self.assertLess(numpy.mean(abs(frame - whole).max(axis=-1) > 0), 1e-3)
            self.assertGreater(numpy.std(whole, axis=(0, 1)).max(), 5)

    def test_after_bands(self):
        """The window and the renderer draw the whole picture after Write(), however it ended."""
        size = (90, 460)

        def check(scene):
            window, renderer = scene._scene.GetRenderWindow(), scene._scene.GetRenderer()
            self.assertEqual(window.GetTileScale(), (1, 1))
            self.assertEqual(renderer.GetViewport(), (0, 0, 1, 1))
            self.assertEqual(window.GetSize(), size)
            return relievo.layer(relievo.capture(renderer, ["depth"]), "depth")

        scene = relievo.scene(self.mesh, size=size, camera=CAMERA, preset="none")
        whole = check(scene.update())
        scene._scene.SetBandRows(192)
        self.picture(scene)
        numpy.testing.assert_array_equal(check(scene), whole)
        (self.folder / "wrong.vtk").write_text("no mesh")
        scene._files.append(os.fsencode(self.path("wrong.vtk")))  # whose reading fails in Write()
        with self.assertRaises(OSError):
            self.picture(scene)
        numpy.testing.assert_array_equal(check(scene), whole)
        scene._files.pop()
        self.picture(scene)
        mine = vtkRenderWindow()
        mine.SetOffScreenRendering(1)
        mine.SetSize(*size)
        scene.window = mine
        self.assertEqual(scene.renderer.GetViewport(), (0, 0, 1, 1))

    def test_layers_in_bands(self):
        """Layers, camera and lights of a file written in bands are those of the whole picture."""
        scene = relievo.scene(self.mesh, size=(90, 460), camera=CAMERA, light="sun:1,2,1",
                              preset="none")  # fmt: skip
        layers = ["depth", "position", "normal", "cell", "height", "color"]
        images = []
        for rows in (0, 192):
            scene._scene.SetBandRows(rows)
            scene.render(exr=self.path("a.exr"), layers=layers[:-1], hdr=True)
            images.append(relievo.read_exr(self.path("a.exr")))
        for name in layers:
            whole, bands = (relievo.layer(image, name) for image in images)
            both = numpy.isfinite(whole) & numpy.isfinite(bands)
            self.assertLess(numpy.mean(numpy.isfinite(whole) != numpy.isfinite(bands)), 1e-3, name)
            differ = abs(numpy.where(both, whole, 0) - numpy.where(both, bands, 0))
            self.assertLess(numpy.mean(differ > 1e-4), 1e-3, name)
        fields = [image.GetFieldData() for image in images]
        self.assertEqual(*(data.GetNumberOfArrays() for data in fields))
        for i in range(fields[0].GetNumberOfArrays()):
            name = fields[0].GetArrayName(i)
            arrays = [data.GetAbstractArray(name) for data in fields]
            if arrays[0].IsA("vtkDataArray"):
                numpy.testing.assert_allclose(*map(vtk_to_numpy, arrays), rtol=1e-12, err_msg=name)
            else:
                self.assertEqual(*(array.GetValue(0) for array in arrays), name)

    def test_no_bands(self):
        """What needs the whole picture is drawn at once, and a note says why."""
        scene = relievo.scene(self.mesh, size=(60, 460), preset="none")
        scene._scene.SetBandRows(192)
        with self.assertLogs("relievo", "INFO"):
            scene.render(self.path("a.png"), report=self.path("a.json"))
        self.assertRegex(" ".join(scene.notes), "drawn at once.*--report needs all of it")
        self.assertEqual(json.loads((self.folder / "a.json").read_text())["size"], [60, 460])
        with self.assertLogs("relievo", "INFO"):
            self.picture(scene.set(grid=True))
        self.assertRegex(" ".join(scene.notes), "--grid needs all of it")
        with self.assertLogs("relievo", "INFO"):
            self.picture(scene.set(grid=None, point_size=65))
        self.assertRegex(" ".join(scene.notes), "--point-size needs all of it")

    def test_a_magnified_grid(self):
        """Numbers stay at their lines in pictures that VTK draws in tiles."""
        scene = relievo.scene(self.mesh, size=(480, 400), preset="print", grid=True)
        for prop in scene.renderer.GetViewProps():
            prop.SetVisibility(prop.IsA("vtkTextActor"))
        inks = []
        for scale in (1, 2):
            grab = vtkWindowToImageFilter()
            grab.SetInput(scene.window)
            grab.SetScale(scale)
            grab.ReadFrontBufferOff()
            grab.Update()
            ink = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).min(axis=-1) < 128
            inks.append(ink.reshape(400, scale, 480, scale).any(axis=(1, 3)))
        self.assertGreater(min(ink.sum() for ink in inks), 100)
        for first, second in (inks, inks[::-1]):
            near = sum(numpy.roll(second, (i, j), (0, 1)) for i in range(-4, 5)
                       for j in range(-4, 5))  # fmt: skip
            self.assertGreater((near > 0)[first].mean(), 0.9)

    def test_a_window_of_ones_own(self):
        """The renderer lives in the window that was given, beside another."""
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetSize(*SIZE)
        other = vtkRenderer()
        other.SetViewport(0.5, 0, 1, 1)
        window.AddRenderer(other)
        scene = relievo.scene(self.mesh)
        scene.window = window
        scene.renderer.SetViewport(0, 0, 0.5, 1)
        window.Render()
        self.assertTrue(window.HasRenderer(scene.renderer))
        self.assertTrue(window.HasRenderer(other))
        self.assertEqual(window.GetSize(), SIZE)
        self.assertGreater(scene.renderer.VisibleActorCount(), 0)

    def test_triangles_as_vtk_draws_them(self):
        """Pictures and bounds are those of VTK's own mapper, however the surface is shown."""
        numbers = numpy.random.default_rng(4)
        points = numbers.normal(size=(300, 3))
        points[-1] = 50  # which no triangle has
        points[7] = points[8]
        plain = numpy.array([three for three in numbers.integers(0, 299, (400, 3))
                             if len({8 if i == 7 else i for i in three}) == 3])  # fmt: skip
        thin = numpy.concatenate([[(7, 8, 9)], plain[:200], [(1, 1, 2)]])
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetSize(*SIZE)

        def draw():
            window.Render()
            pixels = vtkUnsignedCharArray()
            window.GetRGBACharPixelData(0, 0, SIZE[0] - 1, SIZE[1] - 1, 1, pixels)
            return vtk_to_numpy(pixels).copy()

        for name, triangles in (("plain", plain), ("thin", thin)):
            lines = ["OFF", f"{len(points)} {len(triangles)} 0"]
            lines += [" ".join(map(str, row)) for row in points]
            lines += [" ".join(map(str, (3, *row))) for row in triangles]
            path = self.folder / f"{name}.off"
            path.write_text("\n".join(lines))
            scene = relievo.scene(path, preset="none")
            scene.window = window
            actor = scene.renderer.GetActors().GetLastActor()
            own, vtks = actor.GetMapper(), vtkPolyDataMapper()
            own.Update()
            vtks.SetInputConnection(own.GetInputConnection(0, 0))
            self.assertEqual(own.GetClassName(), vtks.GetClassName())
            self.assertEqual(own.GetBounds(), vtks.GetBounds())
            self.assertLess(own.GetBounds()[1], 50)
            kept = own.GetInput().GetPolys()
            half = vtkCellArray()
            half.DeepCopy(kept)
            for row in plain[:100]:
                half.InsertNextCell(3, row)
            look = actor.GetProperty()
            seen = set()
            for step, change in enumerate([
                lambda: None, look.SetRepresentationToWireframe, look.SetRepresentationToSurface,
                look.EdgeVisibilityOn, look.EdgeVisibilityOff, look.SetRepresentationToPoints,
                look.SetRepresentationToSurface, lambda: own.GetInput().SetPolys(half),
                lambda: look.SetInterpolationToFlat(), lambda: own.GetInput().SetPolys(kept),
                lambda: own.GetInput().Modified(), look.VertexVisibilityOn,
                look.VertexVisibilityOff, window.Finalize,
            ]):  # fmt: skip
                change()
                pictures = []
                for mapper in (own, vtks):
                    actor.SetMapper(mapper)
                    pictures.append(draw())
                with self.subTest(name=name, step=step):
                    numpy.testing.assert_array_equal(*pictures)
                    seen.add(pictures[0].tobytes())
            self.assertGreater(len(seen), 4)

    def test_binary_stl_as_vtk_reads_it(self):
        """Points in their order, also both zeros, NaN and infinity; no triangles of two points."""
        numbers = numpy.random.default_rng(5)
        corners = numbers.integers(-9, 9, (3000, 3, 3)) * numpy.float32(0.1)
        corners[::7] *= -0.0
        for name, places in (("finite", corners), ("not", corners.copy())):
            if name == "not":
                places[5, 1, 2] = places[9, 0] = numpy.nan
                places[17, 2, 0] = numpy.inf
            rows = numpy.zeros(3000, [("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")])
            rows["v"] = places
            path = self.path(f"{name}.stl")
            whole = bytes(80) + struct.pack("<I", 3000) + rows.tobytes()
            pathlib.Path(path).write_bytes(whole + b"rest")  # which newer VTKs refuse
            scene = relievo.scene(path, shading="flat")
            if name == "not":
                scene.render(self.path("a.png"))
                self.assertRegex(" ".join(scene.notes), r"left out 3 cells .* not finite \(3 of")
                continue
            reader = vtkSTLReader()
            reader.SetFileName(self.path("whole.stl"))
            pathlib.Path(self.path("whole.stl")).write_bytes(whole)
            reader.Update()
            expected = reader.GetOutput()
            found = scene.renderer.GetActors().GetLastActor().GetMapper().GetInput()
            for mesh in (expected, found):
                self.assertEqual(mesh.GetPolys().IsHomogeneous(), 3)
            # VTK's versions keep either of both zeros.
            numpy.testing.assert_array_equal(
                vtk_to_numpy(found.GetPoints().GetData()),
                vtk_to_numpy(expected.GetPoints().GetData()))  # fmt: skip
            numpy.testing.assert_array_equal(
                vtk_to_numpy(found.GetPolys().GetConnectivityArray()),
                vtk_to_numpy(expected.GetPolys().GetConnectivityArray()))  # fmt: skip

    def test_what_a_script_changes_stays(self):
        """The frame, an actor of the script's, the camera: until update() or render()."""
        scene = relievo.scene(self.mesh, size=SIZE, shadows="map", light="sun:1,3,2")
        self.assertIs(scene.frame, relievo.attach(scene.renderer))
        scene.renderer.GetActiveCamera().SetPosition(9, 9, 9)
        self.assertEqual(scene.renderer.GetActiveCamera().GetPosition(), (9, 9, 9))
        scene.update()
        self.assertNotEqual(scene.renderer.GetActiveCamera().GetPosition(), (9, 9, 9))

    def test_choices_of_casters_stay(self):
        """Choices made on the stage stay over updates, until an option about them changes."""
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        array = numpy_to_vtk(numpy.arange(27.0), deep=True)
        array.SetName("value")
        image.GetPointData().SetScalars(array)
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(self.path("cube.vti"))
        writer.SetInputData(image)
        writer.Write()
        scene = relievo.scene(self.path("cube.vti"), image="volume", size=SIZE, shadows="map",
                              light="sun:1,3,2")  # fmt: skip
        volume = scene.renderer.GetVolumes().GetItemAsObject(0)
        light = scene.renderer.GetLights().GetItemAsObject(0)
        stage = scene.frame.GetShadowStage()
        stage.SetPropCasts(volume, stage.CASTS_NEVER)
        stage.SetPropReceives(volume, False)
        stage.SetLightCasts(light, False)
        scene.update()
        self.assertFalse(stage.GetLightCasts(light))
        scene.set(opacity=0.5).update()
        self.assertEqual(stage.GetPropCasts(volume), stage.CASTS_NEVER)
        self.assertFalse(stage.GetPropReceives(volume))
        scene.set(volume_shadows="casts").update()
        self.assertEqual(stage.GetPropCasts(volume), stage.CASTS_IF_OPAQUE)
        scene.set(volume_shadows="both").update()
        self.assertTrue(stage.GetPropReceives(volume))

    def test_vtk_is_left_as_it_was(self):
        """Neither messages nor the error output are taken from others, be it a good file or not."""
        window = vtkOutputWindow.GetInstance()
        relievo.scene(self.mesh, size=SIZE).update()
        self.assertIs(vtkOutputWindow.GetInstance(), window)
        (self.folder / "torn.vtp").write_text("<VTKFile")
        with self.assertRaisesRegex(OSError, "torn.vtp"):
            relievo.scene(self.path("torn.vtp")).update()
        self.assertIs(vtkOutputWindow.GetInstance(), window)

    def test_errors(self):
        """Errors give value and expectation; the scene keeps its previous values."""
        scene = relievo.scene(self.mesh, size=SIZE, camera=CAMERA)
        plain = self.picture(scene)
        for options, says in (
            ({"colour": "red"}, "colour"),
            ({"size": "big"}, "--size: got 'big'"),
            ({"size": True}, "size: got True, expected WxH"),
            ({"edges": "yes"}, "edges: got 'yes'"),
            ({"light": 3.5}, "--light: got '3.5'"),
            ({"light": object()}, "light: got <object"),
            ({"shadows": "map", "shadow_size": 2}, "--shadow-size"),
            ({"view_angle": 30, "parallel_scale": 1}, "--view-angle and --parallel-scale"),
            ({"png": "a.png"}, "png"),
        ):
            with self.assertRaisesRegex(ValueError, says):
                scene.set(**options)
        with self.assertRaisesRegex(ValueError, "--color-by"):
            scene.set(color_by="nothing").update()
        scene.set(color_by=None)
        self.assertEqual(self.picture(scene), plain)
        for png, says in (("a.jpg", "--png"), (None, "nothing to write")):
            with self.assertRaisesRegex(ValueError, says):
                scene.render(png)
        with self.assertRaisesRegex(ValueError, "--layers"):
            scene.render(exr=self.path("a.exr"), layers=["depht"])
        with self.assertRaisesRegex(ValueError, "no file"):
            relievo.scene().update()
        missing = self.path("there is not.vtp")
        for files, options in (
            ([missing], {}),
            ([self.mesh, missing], {}),
            ([self.mesh], {"environment": missing}),
            ([self.mesh], {"lamps": missing + ",radius=0.5"}),
            ([self.mesh], {"lens": self.path("no.yml")}),
            ([self.mesh], {"allow_folder": [missing]}),
        ):
            with self.assertRaises(FileNotFoundError) as raised:
                relievo.scene(*files, **options)
            self.assertEqual(raised.exception.errno, errno.ENOENT)
            self.assertEqual(raised.exception.filename, options.get("lens", missing))
        for options in ({}, {"normal_map": self.folder}):
            with self.assertRaises(IsADirectoryError) as raised:
                relievo.scene(self.mesh if options else self.folder, **options)
            self.assertEqual(raised.exception.errno, errno.EISDIR)
            self.assertEqual(raised.exception.filename, str(self.folder))
        with self.assertRaises(FileNotFoundError):
            scene.set(environment=missing)
        with self.assertRaises(OSError):
            scene.render(self.path("no folder/a.png"))
        self.assertEqual(sorted(os.listdir(self.folder)), ["lamps.vtk", "roof.vtk", "scene.png"])
        self.assertEqual(self.picture(scene), plain)

    def test_images_have_their_direction(self):
        """Surfaces and volumes are where the image says that its points are, outside outwards."""
        turned = numpy.array([[0, -0.6, 0.8], [1, 0, 0], [0, 0.8, 0.6]])
        for direction in (turned, numpy.diag([1, 1, -1]), turned @ numpy.diag([-1, 1, 1])):
            image = vtkImageData()
            image.SetExtent(3, 12, -2, 9, 0, 8)
            image.SetOrigin(10, 20, 30)
            image.SetSpacing(1, 2, 1.5)
            image.SetDirectionMatrix(direction.ravel())
            values = numpy.zeros((9, 12, 10), numpy.int16)  # z, y, x
            values[2:7, 3:9, 4:8] = 4  # indices 7 to 10, 1 to 6, 2 to 6
            array = numpy_to_vtk(values.ravel(), deep=True)
            array.SetName("label")
            image.GetPointData().SetScalars(array)
            writer = vtkXMLImageDataWriter()
            writer.SetFileName(self.path("image.vti"))
            writer.SetInputData(image)
            writer.Write()
            block = [(6.5, 10.5), (0.5, 6.5), (1.5, 6.5)]
            whole = [(3, 12), (-2, 9), (0, 8)]
            for kind, bounds, off in (("surface=2", block, 1e-5), ("labels", block, 0.5),
                                      ("box", whole, 1e-5)):  # fmt: skip
                made = relievo.scene(self.path("image.vti"), image=kind, ground=False)
                actor = next(iter(made.renderer.GetActors()))
                mesh = actor.GetMapper().GetInputDataObject(0, 0)
                indices = numpy.zeros((mesh.GetNumberOfPoints(), 3))
                for i, index in enumerate(indices):
                    image.TransformPhysicalPointToContinuousIndex(mesh.GetPoint(i), index)
                numpy.testing.assert_allclose(indices.min(axis=0), [b[0] for b in bounds],
                                              atol=off, err_msg=kind)
                numpy.testing.assert_allclose(indices.max(axis=0), [b[1] for b in bounds],
                                              atol=off, err_msg=kind)
                # The winding makes the volume positive: labels smooth some of it off.
                triangles = vtkTriangleFilter()
                triangles.SetInputData(mesh)
                triangles.Update()
                points = vtk_to_numpy(triangles.GetOutput().GetPoints().GetData()).astype(float)
                cells = vtk_to_numpy(triangles.GetOutput().GetPolys().GetConnectivityArray())
                corners = points[cells.reshape(-1, 3)] - points.mean(axis=0)
                volume = numpy.linalg.det(corners).sum() / 6
                expected = 3 * numpy.prod([b[1] - b[0] for b in bounds])
                self.assertGreater(volume, 0.5 * expected, kind)
                self.assertLess(volume, 1.001 * expected, kind)
            made = relievo.scene(self.path("image.vti"), image="volume", ground=False)
            volume = made.renderer.GetVolumes().GetItemAsObject(0)
            drawn = volume.GetMapper().GetInputDataObject(0, 0)
            self.assertGreater(drawn.GetDirectionMatrix().Determinant(), 0)  # VTK culls others
            places = []
            index = [0.0] * 3
            for i in range(drawn.GetNumberOfPoints()):
                image.TransformPhysicalPointToContinuousIndex(drawn.GetPoint(i), index)
                places.append(image.ComputePointId([round(each) for each in index]))
            self.assertEqual(len(set(places)), image.GetNumberOfPoints())
            numpy.testing.assert_array_equal(
                vtk_to_numpy(drawn.GetPointData().GetScalars()),
                vtk_to_numpy(image.GetPointData().GetScalars())[places])

    def test_errors_of_opengl(self):
        """VTK's list of OpenGL errors becomes a remedy."""
        scene = relievo.scene(self.mesh, size=SIZE)
        text = ("ERROR: In vtkOpenGLError.h, line 9\nvtkTextureObject (0x1): failed after Create2D "
                "1 OpenGL errors detected\n  0 : (1285) Out of memory\n")  # fmt: skip
        scene._scene.AddObserver(
            "ProgressEvent", lambda *_: vtkOutputWindow.GetInstance().DisplayErrorText(text))
        with self.assertRaisesRegex((OSError, RuntimeError),
                                    "OpenGL failed: out of memory.*--size"):  # fmt: skip
            scene.update()

    def test_notes_and_warnings(self):
        """The command's messages are a scene's notes; a valid scene has none, and does not warn."""
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            scene = relievo.scene(self.mesh, size=SIZE).update()
        self.assertEqual(scene.notes, [])
        reader = vtkPolyDataReader()
        reader.SetFileName(str(self.mesh))
        reader.Update()
        mesh = reader.GetOutput()
        mesh.GetPoints().SetPoint(6, float("nan"), 1, 1)
        writer = vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()  # newer expats make VTK refuse appended data
        writer.SetInputData(mesh)
        writer.SetFileName(self.path("hole.vtp"))
        writer.Write()
        scene = relievo.scene(self.path("hole.vtp"), size=SIZE)
        self.assertRegex(repr(scene), r"^relievo\.scene\('.*hole\.vtp', size=.*\)$")
        with self.assertLogs("relievo", "INFO") as logged:
            scene.update()
        self.assertRegex(" ".join(scene.notes), "left out 1 cell")
        self.assertEqual([record.getMessage() for record in logged.records], scene.notes)

    def test_folders_of_named_files(self):
        """Those beside the file's own are read where they are allowed, also later."""
        with tempfile.TemporaryDirectory() as folder:
            inside, beside = pathlib.Path(folder, "inside"), pathlib.Path(folder, "beside")
            inside.mkdir()
            beside.mkdir()
            (beside / "m.mtl").write_text("newmtl a\nKd 1 0 0\n")
            (inside / "a.obj").write_text(
                "mtllib ../beside/m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n")
            scene = relievo.scene(inside / "a.obj").update()
            self.assertRegex("\n".join(scene.notes), "m.mtl: it lies outside.*--allow-folder")
            scene.set(allow_folder=[beside]).update()
            self.assertEqual(scene.notes, [])
            actor = scene.renderer.GetActors().GetLastActor()
            self.assertEqual(actor.GetProperty().GetDiffuseColor(), (1, 0, 0))
            with self.assertRaises(NotADirectoryError):
                relievo.scene(inside / "a.obj", allow_folder=[inside / "a.obj"])

    def test_names_of_bytes(self):
        """File names of any bytes, and names that begin with a dash."""
        for name in (b"-roof.vtk", b"r\xff\xfe.vtk", "dächer.vtk".encode()):
            path = os.fsencode(self.folder) + b"/" + name
            pathlib.Path(os.fsdecode(path)).write_text(MESH)
            self.assertEqual(
                self.picture(relievo.scene(path, size=SIZE)),
                self.picture(relievo.scene(os.fsdecode(path), size=SIZE)),
            )


class Compared(unittest.TestCase):
    """compare() and write_baseline(): known changes are found."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.mesh = self.folder / "roof.vtk"
        self.mesh.write_text(MESH)
        self.path = self.folder / "base.exr"

    def box(self, x, height):
        """An actor of a box of width 1 that stands on y = 0 at x."""
        points = vtkPoints()
        for corner in range(8):
            points.InsertNextPoint(x + (corner & 1) - 0.5, height * (corner >> 1 & 1),
                                   (corner >> 2) - 0.5)
        polys = vtkCellArray()
        for face in ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1),
                     (4, 5, 7, 6)):  # fmt: skip
            polys.InsertNextCell(4)
            for point in face:
                polys.InsertCellPoint(point)
        data = vtkPolyData()
        data.SetPoints(points)
        data.SetPolys(polys)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetInterpolationToFlat()
        return actor

    def renderer(self):
        """Two boxes in a window."""
        renderer = vtkRenderer()
        self.actors = [self.box(-0.8, 1), self.box(0.8, 0.7)]
        for actor in self.actors:
            renderer.AddActor(actor)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(3, 4, 8)
        camera.SetFocalPoint(0, 0.4, 0)
        renderer.ResetCameraClippingRange()
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(160, 120)
        self.window.AddRenderer(renderer)
        return renderer

    def only(self, found, cause):
        self.assertEqual([each["cause"] for each in found.causes], [cause], str(found))
        self.assertEqual(found.unexplained, 0, str(found))
        return found.causes[0]

    def test_renderer(self):
        renderer = self.renderer()
        names = {self.actors[0]: "tall", self.actors[1]: "low"}
        relievo.write_baseline(self.path, renderer, names=names)
        found = relievo.compare(self.path, renderer)
        self.assertTrue(found, str(found))
        self.assertEqual((found.pixels, found.size), (0, (160, 120)))
        self.assertIn("alike: 0 of 19 200 pixels", repr(found))
        self.assertIsNone(renderer.GetPass())

        self.actors[1].SetPosition(0.02, 0.01, -0.03)
        moved = self.only(relievo.compare(self.path, renderer), "moved")
        self.assertEqual((moved["name"], moved["id"]), ("low", 1))
        numpy.testing.assert_allclose(moved["displacement"], (0.02, 0.01, -0.03), atol=1e-12)
        # Without the record, the displacement is as accurate as depths in float.
        before = relievo.capture(renderer, ["color", "depth", "actor", "cell"])
        self.actors[1].SetPosition(0, 0, 0)
        after = relievo.capture(renderer, ["color", "depth", "actor", "cell"])
        seen = relievo.compare(before, after)
        numpy.testing.assert_allclose(
            seen.causes[0]["displacement"], (-0.02, -0.01, 0.03), atol=1e-4)
        self.assertIn("overlay", seen.cannot_be_detected)
        seen.write_markdown(self.folder / "seen.md")
        self.assertIn("| actor 1 | moved by", (self.folder / "seen.md").read_text("utf-8"))
        seen.write_html(self.folder / "seen.html")
        page = (self.folder / "seen.html").read_text("utf-8")
        self.assertTrue('[{"name":"Capture, Capture",' in page)
        self.assertTrue(f'<iframe srcdoc="{html.escape(page)}"' in seen._repr_html_())
        self.assertRaises(OSError, seen.write_html, self.folder / "none" / "seen.html")
        causes = seen.image
        self.assertEqual(numpy.count_nonzero(causes == 0), seen.causes[0]["pixels"])
        actor = relievo.layer(before, "actor")
        self.assertTrue((actor[causes == 0] == 1).mean() > 0.9)

        self.actors[0].GetProperty().SetColor(1, 1, 0.9)
        color = self.only(relievo.compare(self.path, renderer), "color")
        self.assertEqual(color["name"], "tall")
        self.assertEqual(color["largest"], 25)  # 255 - 230, rounded from 229.5
        self.actors[0].GetProperty().SetColor(1, 1, 1)
        material = self.actors[0].GetProperty()
        for name, value in (
            ("specular", 0.4), ("ambient_color", (1, 0, 0)), ("specular_color", (1, 0.9, 1)),
            ("edge_color", (0, 0, 1)), ("coat_strength", 0.5), ("emissive_factor", (0, 1, 1)),
        ):  # fmt: skip
            word = "".join(part.capitalize() for part in name.split("_"))
            before = getattr(material, "Get" + word)()
            getattr(material, "Set" + word)(value)
            changed = self.only(relievo.compare(self.path, renderer), "settings")
            self.assertEqual((changed["name"], changed["settings"]), ("tall", name))
            getattr(material, "Set" + word)(before)

        text = vtkTextActor()
        text.SetInput("12 %")
        renderer.AddViewProp(text)
        overlay = self.only(relievo.compare(self.path, renderer), "overlay")
        self.assertGreater(overlay["pixels"], 20)
        renderer.RemoveViewProp(text)

        self.actors.insert(0, self.box(0, 3))
        self.actors[0].SetPosition(0, 0, -3)
        renderer.RemoveAllViewProps()
        for actor in self.actors:  # changes all numbers
            renderer.AddActor(actor)
        self.assertEqual(self.only(relievo.compare(self.path, renderer), "added")["id"], 0)
        renderer.RemoveActor(self.actors[0])
        renderer.RemoveActor(self.actors[2])
        self.assertEqual(
            self.only(relievo.compare(self.path, renderer), "removed")["name"], "low")

    def test_stages(self):
        """Layers of stages are drawn with the picture, which is drawn once."""
        renderer = self.renderer()
        pictures = [relievo.layer(relievo.capture(renderer, ["color"]), "color").copy()]
        stage = relievo.attach(renderer).GetStage("ambient")
        stage.SetSamples(16)
        stage.SetSamplesPerFrame(4)
        stage.SetEnabled(True)
        drawn = []
        renderer.AddObserver("StartEvent", lambda *_: drawn.append(renderer))
        relievo.write_baseline(self.path, renderer)
        self.assertEqual(len(drawn), 1)
        image = relievo.read_exr(self.path)
        names = [image.GetPointData().GetArrayName(i)
                 for i in range(image.GetPointData().GetNumberOfArrays())]
        self.assertIn("ambient", names)
        self.assertEqual({"light", "fog", "marker"} & set(names), set())  # they have no work
        pictures.append(relievo.layer(image, "color"))
        share = relievo.layer(image, "ambient")
        self.assertTrue((share < 0.9).any())
        levels = [256 * numpy.where(light < 0.0031308, 12.92 * light,
                                    1.055 * light ** (1 / 2.4) - 0.055)
                  for light in (pictures[1][..., :3], pictures[0][..., :3] * share[..., None])]
        self.assertLess(numpy.abs(levels[1] - levels[0]).max(), 2)  # the picture has 8 bits

    def volume(self):
        renderer = self.renderer()
        image = vtkImageData()
        image.SetDimensions(9, 9, 9)
        image.SetOrigin(-1, 0, -1)
        image.SetSpacing(0.2, 0.2, 0.2)
        values = numpy_to_vtk(numpy.arange(729, dtype=numpy.uint8), deep=True)
        image.GetPointData().SetScalars(values)
        volume = vtkVolume()
        renderer.AddVolume(volume)
        return renderer, volume, image

    def test_volume(self):
        """Gradient opacities are recorded, and grey volumes remain grey."""
        renderer, volume, image = self.volume()
        mapper = vtkFixedPointVolumeRayCastMapper()
        mapper.SetInputData(image)
        volume.SetMapper(mapper)
        functions = volume.GetProperty()
        grey, opacity, gradient = (vtkPiecewiseFunction() for _ in range(3))
        for function in (grey, opacity, gradient):
            function.AddPoint(0, 0.2)
            function.AddPoint(255, 0.5)
        functions.SetColor(grey)
        functions.SetScalarOpacity(opacity)
        functions.SetGradientOpacity(gradient)
        relievo.write_baseline(self.path, renderer)
        self.assertEqual(functions.GetColorChannels(), 1)
        self.assertTrue(relievo.compare(self.path, renderer))
        gradient.AddPoint(100, 0.9)
        changed = self.only(relievo.compare(self.path, renderer), "color")
        self.assertEqual(changed["words"], "color: gradient opacity")
        gradient.RemovePoint(100)
        grey.AddPoint(100, 0.9)
        changed = self.only(relievo.compare(self.path, renderer), "color")
        self.assertEqual(changed["words"], "color: colors")

    def test_volume_layers(self):
        """Baselines of volumes that OpenGL draws have their layers, by which changes are found."""
        renderer, volume, image = self.volume()
        image.GetPointData().GetScalars().SetName("density")
        mapper = vtkSmartVolumeMapper()
        mapper.SetInputData(image)
        volume.SetMapper(mapper)
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(0, 0.1)
        opacity.AddPoint(255, 0.9)
        volume.GetProperty().SetScalarOpacity(opacity)
        stage = relievo.attach(renderer)
        volume.VisibilityOff()
        relievo.write_baseline(self.path, renderer)  # VTK adds functions when it draws
        volume.VisibilityOn()
        self.only(relievo.compare(self.path, renderer), "visibility")
        relievo.write_baseline(self.path, renderer)
        self.assertFalse(stage.IsLayerRequested("volume"))
        base = relievo.read_exr(self.path)
        seen = relievo.layer(base, "volume_opacity") > 0.1
        self.assertGreater(numpy.count_nonzero(seen), 200)
        self.assertTrue(relievo.compare(self.path, renderer))
        values = vtk_to_numpy(image.GetPointData().GetScalars())

        def halve():
            values[300:500] //= 2
            image.GetPointData().GetScalars().Modified()

        for cause, change, undo in (
            ("moved", lambda: volume.SetPosition(0.1, 0, 0), lambda: volume.SetPosition(0, 0, 0)),
            ("color", lambda: opacity.AddPoint(100, 0.9), lambda: opacity.RemovePoint(100)),
            ("visibility", volume.VisibilityOff, volume.VisibilityOn),
            ("array", halve, lambda: None),
        ):  # fmt: skip
            change()
            found = self.only(relievo.compare(self.path, renderer), cause)
            undo()
            self.assertEqual((found["kind"], found["id"]), ("volume", 0))
            self.assertGreater(found["pixels"], 100)

    def test_blocks_and_glyphs(self):
        """The record has hidden blocks by name, and the shapes of glyphs."""
        renderer = self.renderer()
        blocks = vtkMultiBlockDataSet()
        for number, actor in enumerate(self.actors):
            blocks.SetBlock(number, actor.GetMapper().GetInput())
            blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), ("tall", "low")[number])
        attributes = vtkCompositeDataDisplayAttributes()
        mapper = CompositeMapper()
        mapper.SetInputDataObject(blocks)
        mapper.SetCompositeDataDisplayAttributes(attributes)
        both = vtkActor()
        both.SetMapper(mapper)
        source = vtkCubeSource()
        glyphs = vtkGlyph3DMapper()
        glyphs.SetInputData(self.actors[1].GetMapper().GetInput())
        glyphs.SetSourceConnection(source.GetOutputPort())
        glyphs.SetScaleFactor(0.1)
        dots = vtkActor()
        dots.SetMapper(glyphs)
        dots.SetPosition(0, 1, 0)
        renderer.RemoveAllViewProps()
        renderer.AddActor(both)
        renderer.AddActor(dots)
        relievo.write_baseline(self.path, renderer, names={both: "both", dots: "dots"})
        self.assertTrue(relievo.compare(self.path, renderer))
        attributes.SetBlockVisibility(blocks.GetBlock(1), False)
        hidden = self.only(relievo.compare(self.path, renderer), "visibility")
        self.assertEqual(
            (hidden["name"], hidden["words"]), ("both", "visibility: block 2 (low) hidden"))
        self.assertGreater(hidden["pixels"], 100)
        attributes.SetBlockVisibility(blocks.GetBlock(1), True)
        attributes.SetBlockColor(blocks.GetBlock(0), (1, 0, 0))
        self.assertEqual(self.only(relievo.compare(self.path, renderer), "color")["name"], "both")
        attributes.RemoveBlockColors()
        source.SetXLength(1.2)
        glyph = self.only(relievo.compare(self.path, renderer), "shape")
        self.assertEqual((glyph["name"], glyph["words"]), ("dots", "shape: other glyphs"))

    def test_arrays_of_glyphs(self):
        """The record has the arrays by which glyphs are scaled, with names and values."""
        renderer = self.renderer()
        points = vtkPolyData()
        points.ShallowCopy(self.actors[1].GetMapper().GetInput())
        for name, factor in (("a", 0.1), ("b", 0.2)):
            array = vtkDoubleArray()
            array.SetName(name)
            array.SetNumberOfTuples(points.GetNumberOfPoints())
            array.FillComponent(0, factor)
            points.GetPointData().AddArray(array)
        source = vtkCubeSource()
        glyphs = vtkGlyph3DMapper()
        glyphs.SetInputData(points)
        glyphs.SetSourceConnection(source.GetOutputPort())
        glyphs.SetScaleModeToScaleByMagnitude()
        glyphs.SetScaleArray("a")
        dots = vtkActor()
        dots.SetMapper(glyphs)
        renderer.RemoveAllViewProps()
        renderer.AddActor(dots)
        relievo.write_baseline(self.path, renderer, names={dots: "dots"})
        self.assertTrue(relievo.compare(self.path, renderer))
        glyphs.SetScaleArray("b")
        glyph = self.only(relievo.compare(self.path, renderer), "shape")
        self.assertEqual((glyph["name"], glyph["words"]), ("dots", "shape: other glyphs"))
        glyphs.SetScaleArray("a")
        self.assertTrue(relievo.compare(self.path, renderer))
        array.FillComponent(0, 0.3)  # of b, which is not used
        self.assertTrue(relievo.compare(self.path, renderer))

    def test_window(self):
        """vtkRelievoBaseline.Test(), for programs in C++: its text and files."""
        renderer = self.renderer()
        window = renderer.GetRenderWindow()
        path = self.folder / "boxes & more.exr"
        here = pathlib.Path.cwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)

        def run():
            printed = self.folder / "printed.txt"
            with printed.open("wb") as file:
                stdout = os.dup(1)
                os.dup2(file.fileno(), 1)
                try:
                    alike = vtkRelievoBaseline.Test(window, str(path))
                finally:
                    os.dup2(stdout, 1)
                    os.close(stdout)
            return alike, printed.read_text("utf-8")

        alike, text = run()
        self.assertFalse(alike)
        self.assertIn(f"There is no such baseline: {path}", text)
        (self.folder / "boxes & more.frame.exr").rename(path)
        self.assertEqual(run(), (True, "alike: 0 of 19 200 pixels\n"))
        self.assertEqual(list(self.folder.glob("boxes*")), [path])

        self.actors[1].SetPosition(0.02, 0, 0)
        alike, text = run()
        self.assertFalse(alike)
        self.assertIn("actor 1  moved by (0.02, 0, 0)", text)
        (picture,) = re.findall('name="TestImage" type="image/png">(.*)</DartMeasurement', text)
        self.assertIn("boxes &amp; more.frame.png", picture)
        for side, expected in (("baseline", path), ("frame", renderer)):
            reader = vtkPNGReader()
            reader.SetFileName(str(self.folder / f"boxes & more.{side}.png"))
            reader.Update()
            self.assertTrue(relievo.compare(reader.GetOutput(), expected), side)
        self.assertIn("moved by (0.02", (self.folder / "boxes & more.html").read_text("utf-8"))
        found = relievo.compare("boxes & more.frame.exr", renderer)
        self.assertTrue(found, str(found))

        window.AddRenderer(self.renderer())
        output = vtkStringOutputWindow()
        before = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(output)
        self.addCleanup(vtkOutputWindow.SetInstance, before)
        self.assertFalse(run()[0])
        self.assertIn("Test was given 2 renderers with props", output.GetOutput())

    def test_portable(self):
        """Layers by rays, the same bytes without the processor's FMA, and refusals."""
        renderer = self.renderer()
        relievo.write_baseline(self.path, renderer, portable=True)
        image = relievo.read_exr(self.path)
        self.assertTrue(vtkRelievoBaseline.IsPortable(image))
        self.assertTrue(relievo.compare(self.path, renderer))
        ordinary = self.folder / "ordinary.exr"
        relievo.write_baseline(ordinary, renderer)
        self.assertFalse(vtkRelievoBaseline.IsPortable(relievo.read_exr(ordinary)))
        sensor = relievo.Pinhole.of(renderer.GetActiveCamera(), (160, 120))
        hits = relievo.capture(renderer, ["depth", "actor", "cell", "normal"], camera=sensor)
        for name in ("depth", "actor", "cell", "normal"):
            self.assertTrue((relievo.layer(image, name) == relievo.layer(hits, name)).all(), name)
        self.actors[0].GetProperty().SetRepresentationToWireframe()
        with self.assertRaisesRegex(RuntimeError, "they do not hit actor 0"):
            relievo.write_baseline(self.path, renderer, portable=True)

        # The command, with and without the vector units that libraries choose by the processor.
        files = [str(self.folder / name) for name in ("a.exr", "b.exr")]
        relievo_command = os.environ["RELIEVO"]
        command = [relievo_command, "render", str(self.mesh), "--preset", "none",
                   "--size", "160x120", "--portable", "--baseline"]  # fmt: skip
        for file, units in zip(files, ("", "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F"), strict=True):
            given = {**os.environ, "GLIBC_TUNABLES": units}
            subprocess.run([*command, file], check=True, env=given)
        a, b = map(relievo.read_exr, files)
        for name in ("depth", "actor", "cell", "normal"):
            self.assertTrue((relievo.layer(a, name) == relievo.layer(b, name)).all(), name)
        shown = subprocess.run(
            [relievo_command, "compare", files[0], "--render", str(self.mesh)],
            check=True, capture_output=True, text=True,
        )  # fmt: skip
        self.assertIn("alike: 0 of 19 200 pixels", shown.stdout)

    def test_nan(self):
        renderer = self.renderer()
        points = self.actors[1].GetMapper().GetInput().GetPoints()
        points.InsertNextPoint(math.nan, 0, 0)  # used by no cell
        relievo.write_baseline(self.path, renderer)
        found = relievo.compare(self.path, renderer)
        self.assertTrue(found, str(found))
        points.SetPoint(8, math.inf, 0, 0)
        points.Modified()
        found = relievo.compare(self.path, renderer)
        self.assertEqual(self.only(found, "shape")["id"], 1)
        self.assertGreater(found.pixels, 0)  # VTK draws no actor with infinite bounds

    def test_scene(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            scene = relievo.scene(self.mesh, size=SIZE, camera=CAMERA, shadows="map",
                                  light=["sun:3,5,2", "point:2,4,1"])
            scene.render(baseline=self.path)
            self.assertTrue(relievo.compare(self.path, scene))
            relievo.write_baseline(self.folder / "again.exr", scene)
            self.assertTrue(relievo.compare(self.path, self.folder / "again.exr"))
            scene.set(light=["sun:3,5,2", "point:2,4,1.1"])
            found = relievo.compare(self.path, scene)
        light = self.only(found, "light")
        self.assertEqual((light["kind"], light["id"]), ("light", 1))
        self.assertGreater(light["pixels"], 20)

    def test_pictures(self):
        picture = numpy.full((30, 40, 3), 100, numpy.uint8)
        other = picture.copy()
        other[3:5, 10:20] = 103
        found = relievo.compare(picture, other)
        self.assertEqual((bool(found), found.unexplained), (False, 20))
        self.assertTrue((found.image[3:5, 10:20] == -4).all())
        self.assertTrue(relievo.compare(picture, other, levels=3))
        self.assertTrue(relievo.compare(picture, other, levels=numpy.int64(3)))
        self.assertIn("moved", found.cannot_be_detected)
        self.assertEqual(json.loads(found.json)["size"], [40, 30])

    def test_errors(self):
        picture = numpy.zeros((4, 4, 3), numpy.uint8)
        damaged = self.folder / "damaged.exr"
        damaged.write_bytes(b"v/1\x01 not an image")
        for error, words, invalid in (
            (FileNotFoundError, "none.exr", lambda: relievo.compare("none.exr", picture)),
            (ValueError, "damaged.exr", lambda: relievo.compare(picture, damaged)),
            (ValueError, "levels: got -1", lambda: relievo.compare(picture, picture, levels=-1)),
            (ValueError, "levels: got nan",
             lambda: relievo.compare(picture, picture, levels=math.nan)),
            (ValueError, "expected a vtkRenderer", lambda: relievo.compare(picture, 3)),
            (ValueError, "ends in .exr", lambda: relievo.write_baseline("a.png", picture)),
        ):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                invalid()


if __name__ == "__main__":
    unittest.main(verbosity=2)
