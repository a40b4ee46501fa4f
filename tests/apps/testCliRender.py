# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Good runs: the picture's size and pixels, the EXR's channels and values, the report."""

import base64
import html.parser
import importlib.util
import json
import math
import re
import shutil
import unittest
import zlib

import numpy

from cli import BENCHES, LOOK, CliTest, main, read_png

BACKGROUND_ID = 0xFFFFFFFF


def write_data(folder):
    """A sphere with the array `height` as every kind of file that VTK writes; returns the names."""
    from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkElevationFilter
    from vtkmodules.vtkFiltersSources import vtkSphereSource
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
    from vtkmodules.vtkIOGeometry import vtkSTLWriter
    from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
    from vtkmodules.vtkIOPLY import vtkPLYWriter
    from vtkmodules.vtkIOXML import (
        vtkXMLImageDataWriter,
        vtkXMLMultiBlockDataWriter,
        vtkXMLPolyDataWriter,
        vtkXMLUnstructuredGridWriter,
    )
    from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

    sphere = vtkSphereSource()
    sphere.SetThetaResolution(30)
    sphere.SetPhiResolution(30)
    height = vtkElevationFilter()
    height.SetInputConnection(sphere.GetOutputPort())
    height.SetLowPoint(0, -0.5, 0)
    height.SetHighPoint(0, 0.5, 0)
    height.Update()
    height.GetOutput().GetPointData().GetArray("Elevation").SetName("height")
    grid = vtkAppendFilter()
    grid.AddInputData(height.GetOutput())
    image = vtkRTAnalyticSource()
    image.SetWholeExtent(-5, 5, -5, 5, -5, 5)
    image.Update()
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, height.GetOutput())
    blocks.SetBlock(1, image.GetOutput())
    for name, writer, data in (
        ("a.vtp", vtkXMLPolyDataWriter(), height.GetOutput()),
        ("a.stl", vtkSTLWriter(), height.GetOutput()),
        ("a.ply", vtkPLYWriter(), height.GetOutput()),
        ("a.vtk", vtkPolyDataWriter(), height.GetOutput()),
        ("a.vti", vtkXMLImageDataWriter(), image.GetOutput()),
        ("a.vtm", vtkXMLMultiBlockDataWriter(), blocks),
    ):
        writer.SetInputData(data)
        writer.SetFileName(str(folder / name))
        writer.Write()
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputConnection(grid.GetOutputPort())
    writer.SetFileName(str(folder / "a.vtu"))
    writer.Write()
    return ["a.vtp", "a.stl", "a.ply", "a.vtk", "a.vti", "a.vtm", "a.vtu"]


def gltf_triangle(colour, alpha=1, **material):
    """TRIANGLE as glTF, of a material of that colour."""
    points = numpy.array([(-1, -1, 0), (1, -1, 0), (-1, 1, 0)], "<f4").tobytes()
    return json.dumps(
        {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
            "materials": [
                {
                    "pbrMetallicRoughness": {
                        "baseColorFactor": [*colour, alpha], "metallicFactor": 0,
                    },
                    **material,
                }
            ],
            "accessors": [
                {
                    "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                    "min": [-1, -1, 0], "max": [1, 1, 0],
                }
            ],
            "bufferViews": [{"buffer": 0, "byteLength": len(points)}],
            "buffers": [
                {
                    "byteLength": len(points),
                    "uri": "data:application/octet-stream;base64,"
                    + base64.b64encode(points).decode(),
                }
            ],
        }
    )  # fmt: skip


class Picture(CliTest):
    def test_nothing_is_seen(self):
        """A picture of the background alone comes with a note, whatever the reason."""
        sliver = "OFF\n3 1 0\n-1 -1 0\n1 -1 1e9\n-1 1 0\n3 0 1 2\n"
        (self.folder / "sliver.off").write_text(sliver)
        says = "relievo: a.png: shows only the background: everything else is out of view, "
        says += "thinner than a pixel, or has the background's colour\n"
        for words in (["sliver.off"], ["triangle.off", "--camera", "0,0,5,0,0,9,0,1,0"],
                      ["triangle.off", "--camera", "0,0,5,0,0,9,0,1,0", "--shadows", "map"]):
            done = self.relievo("render", *words, "--size", "48x48", "--png", "a.png")
            self.assertEqual(done.stderr, says)
        done = self.relievo("render", "triangle.off", "--opacity", 0, "--size", "48x48", "--png",
                            "a.png")  # fmt: skip
        self.assertIn("only the background: --opacity 0 makes surfaces invisible\n", done.stderr)
        # One colour all over, which is that of the mesh.
        close = ["--camera", "-0.5,-0.5,0.1,-0.5,-0.5,0,0,1,0", "--color", "0/0/0"]
        done = self.relievo("render", "triangle.off", *close, "--size", "48x48", "--png", "a.png")
        self.assertEqual(done.stderr, "")

    def test_size_and_silence(self):
        done = self.render("--png", "a.png")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        self.assertEqual(read_png(self.folder / "a.png").shape, (768, 1024, 3))
        self.render("--size", "37x91", "--png", "b.png")
        self.assertEqual(read_png(self.folder / "b.png").shape, (91, 37, 3))
        self.assertEqual(self.names(), ["a.png", "b.png", "triangle.off"])

    def test_the_triangle_is_where_it_belongs(self):
        # Parallel projection of half height 2 on 100x100 pixels: 25 pixels to a unit, the middle
        # at 50. The corners (-1,-1), (1,-1), (-1,1) are 25 and 75 pixels from the left and the top.
        self.render("--size", "100x100", "--parallel-scale", "2", "--shading", "flat",
                    "--png", "a.png")  # fmt: skip
        lit = read_png(self.folder / "a.png").sum(axis=2) > 0
        rows, columns = numpy.mgrid[0:100, 0:100] + 0.5
        inside = (columns > 25) & (rows < 75) & (rows - 25 > columns - 25)
        self.assertGreater(lit.sum(), 1200)
        self.assertLessEqual((lit != inside).sum(), 60, "more than the edges differ")

    def test_lights(self):
        def brightness(*words):
            self.render("--size", "64x64", "--png", "a.png", *words)
            return int(read_png(self.folder / "a.png")[36, 20, 0])

        self.assertEqual(brightness("--light", "sun:0,0,1"), 255)
        self.assertAlmostEqual(brightness("--light", "sun:0,3,4"), 255 * 0.8, delta=1)
        self.assertEqual(brightness("--light", "sun:0,0,-1"), 0)
        self.assertAlmostEqual(brightness("--light", "sun:180,60"), 127.5, delta=1)
        self.assertEqual(brightness("--light", "spot:0,0,4,5,0,4,20"), 0)
        self.assertGreater(brightness("--light", "spot:0,0,4,0,0,0,20"), 200)
        self.assertGreater(brightness("--light", "point:0,0,4"), 200)
        both = brightness("--light", "sun:0,4,3", "--light=sun:0,-3,1")
        self.assertAlmostEqual(both, 255 * (0.6 + 1 / math.sqrt(10)), delta=2)

    def test_colours_and_intensities_of_lights(self):
        """A white plane that faces a light by an angle has its colour, times its intensity, times
        the angle's cosine, and those of several lights together."""
        for light, expected in (
            ("sun:0,0,1,color=#804020", (128, 64, 32)),
            ("sun:0,3,4,color=0.5/1/0.25", (102, 204, 51)),
            ("sun:0,0,1,intensity=0.4", (102, 102, 102)),
            ("sun:0,3,4,intensity=1.5,color=0.4/0.2/0.8", (122.4, 61.2, 244.8)),
            ("sun:0,0,1,intensity=0,name=off", (0, 0, 0)),
            ("point:0,0,1000,color=orange,size=0.5", (255, 165, 0)),
            ("sun:0,0,1,color=1/0/0,casts=on --light sun:0,3,4,color=blue", (255, 0, 204)),
        ):
            with self.subTest(light=light):
                self.render("--size", "64x64", "--png", "a.png", "--light", *light.split(" "))
                found = read_png(self.folder / "a.png")[36, 20].astype(int)
                numpy.testing.assert_allclose(found[:3], expected, atol=1)

    def test_the_sun_by_date(self):
        """By NREL's example (see tests/viewer/testViewerSun.cxx); at night there is no light of it,
        which is said, and a sun that a direction puts below lights from there."""
        plane = ["--size", "64x64", "--png", "a.png", "--up", "z", "--light"]

        def brightness(light, camera=LOOK):
            done = self.relievo("render", "triangle.off", *camera, *plane, light)
            column = 20 if camera is LOOK else 43  # from behind
            return int(read_png(self.folder / "a.png")[36, column, 0]), done.stderr

        place = "39.742476,-105.1786"
        expected = 255 * math.cos(math.radians(50.112 + 0.017))
        for time in ("12:30:30-07:00", "19:30:30Z", "19:30:30", "22:00:30+02:30"):
            found, said = brightness(f"sun:2003-10-17T{time},{place}")
            self.assertAlmostEqual(found, expected, delta=1, msg=time)
            self.assertEqual(said, "")
        found, said = brightness(f"sun:2003-10-17T00:30-07:00,{place},size=2")
        self.assertEqual(found, 0)
        self.assertRegex(said, r"night: the sun is [0-9.]+ degrees below the horizon")
        below = ["--camera", "0,0,-5,0,0,0,0,1,0", "--clip", "1,10"]
        self.assertEqual(brightness("sun:0,0,-1", below), (255, ""))
        self.assertEqual(brightness(f"sun:2003-10-17T00:30-07:00,{place}", below)[0], 0)

    def test_shading(self):
        pictures = {}
        write_data(self.folder)
        for kind in ("flat", "gouraud", "phong", "pbr"):
            self.relievo("render", "a.stl", "--size", "80x80", "--shading", kind, "--png", "a.png")
            pictures[kind] = read_png(self.folder / "a.png")
        self.relievo("render", "a.stl", "--size", "80x80", "--png", "a.png")
        numpy.testing.assert_array_equal(read_png(self.folder / "a.png"), pictures["phong"])
        for kind in ("flat", "pbr"):
            self.assertGreater((pictures[kind] != pictures["phong"]).mean(), 0.05, kind)

    def test_files_of_every_kind(self):
        for name in write_data(self.folder):
            with self.subTest(file=name):
                self.relievo("render", name, "--size", "60x60", "--png", "a.png")
                lit = read_png(self.folder / "a.png").sum(axis=2) > 0
                self.assertGreater(lit.mean(), 0.2)

    def test_gltf_keeps_its_materials(self):
        (self.folder / "a.gltf").write_text(gltf_triangle((0.2, 0.7, 0.1)))
        look = [*LOOK, "--size", "64x64", "--light", "sun:0,0,1"]
        self.relievo("render", "a.gltf", *look, "--png", "a.png")
        red, green, blue = (int(value) for value in read_png(self.folder / "a.png")[36, 20])
        self.assertGreater(green, red)
        self.assertGreater(red, blue)
        self.relievo("render", "a.gltf", *look, "--shading", "flat", "--exr", "a.exr",
                     "--layers", "albedo,depth")  # fmt: skip
        _, channels = self.exr("a.exr")
        for name, value in zip("RGB", (0.2, 0.7, 0.1)):
            self.assertAlmostEqual(float(channels[f"albedo.{name}"][36, 20]), value, delta=0.01)
        self.assertAlmostEqual(float(channels["depth.Z"][36, 20]), 5, delta=1e-5)

    def test_gltf_opacity(self):
        """Where it counts: not that of an opaque material, and all or nothing of a mask."""
        for alpha, mode, expected in ((0.25, "BLEND", 0.25), (0.25, "OPAQUE", 1),
                                      (0.25, "MASK", 0), (0.75, "MASK", 1)):  # fmt: skip
            text = gltf_triangle((1, 1, 1), alpha, alphaMode=mode)
            (self.folder / "a.gltf").write_text(text)
            self.relievo("render", "a.gltf", *LOOK, "--size", "60x60", "--exr", "a.exr")
            found = float(self.exr("a.exr")[1]["A"][36, 20])
            self.assertAlmostEqual(found, expected, delta=0.003, msg=f"{mode} {alpha}")

    def test_gltf_that_is_wrong(self):
        """One line gives problem and place; no picture is written."""
        for change, says in (
            (lambda file: file["accessors"][0].update(count=65000), "accessors[0] has 65000"),
            (lambda file: file["nodes"][0].update(children=[0]), "nodes[0] is below itself"),
            (lambda file: file.update(extensionsRequired=["EXT_none"]), "EXT_none"),
            (lambda file: file.update(scenes=[{}]), "contains nothing to draw"),
        ):
            file = json.loads(gltf_triangle((1, 1, 1)))
            change(file)
            (self.folder / "a.gltf").write_text(json.dumps(file))
            done = self.relievo("render", "a.gltf", "--png", "a.png", status=1)
            self.assertIn("a.gltf: ", done.stderr)
            self.assertIn(says, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertFalse((self.folder / "a.png").exists())

    def test_gltf_lights(self):
        """Those of the file light, and the headlight where it has none; --light replaces them."""
        file = json.loads(gltf_triangle((1, 1, 1), doubleSided=True))
        seen = []
        for lights in (None, [{"type": "point", "intensity": 0}], [{"type": "point"}]):
            if lights:
                file["extensions"] = {"KHR_lights_punctual": {"lights": lights}}
                own = {"KHR_lights_punctual": {"light": 0}}
                file["nodes"][1:] = [{"extensions": own, "translation": [-0.5, -0.5, 1]}]
                file["scenes"][0]["nodes"] = [0, 1]
            (self.folder / "a.gltf").write_text(json.dumps(file))
            for words in ((), ("--light", "sun:0,0,1")):
                self.relievo("render", "a.gltf", *LOOK, *words, "--size", "60x60", "--exr", "a.exr")
                seen.append(float(self.exr("a.exr")[1]["G"][36, 20]))
        self.assertGreater(seen[0], 0.1)
        self.assertEqual(seen[2], 0)
        self.assertGreater(seen[4], 0.1)
        self.assertEqual(seen[1], seen[3])
        self.assertEqual(seen[1], seen[5])

    def test_gltf_whose_files_are_missing(self):
        """The missing file is named."""
        text = gltf_triangle((1, 1, 1))
        start = text.index("data:")
        text = text[:start] + "my%20points.bin" + text[text.index('"', start) :]
        (self.folder / "a.gltf").write_text(text)
        done = self.relievo("render", "a.gltf", "--png", "a.png", status=1)
        self.assertIn("a.gltf: buffers[0] names my points.bin, which is not there", done.stderr)

    def test_overwrites_and_follows_links(self):
        (self.folder / "real").mkdir()
        (self.folder / "real" / "a.png").write_text("old")
        (self.folder / "a.png").symlink_to("real/a.png")
        self.render("--png", "a.png")
        self.assertTrue((self.folder / "a.png").is_symlink())
        self.assertEqual(read_png(self.folder / "real" / "a.png").shape, (768, 1024, 3))
        (self.folder / "b.png").symlink_to("real/b.png")  # which is not there yet
        self.render("--png", "b.png")
        self.assertTrue((self.folder / "b.png").is_symlink())
        self.assertEqual(read_png(self.folder / "real" / "b.png").shape, (768, 1024, 3))


def names_of(header):
    return sorted(channel["name"] for channel in header["channels"])


class Layers(CliTest):
    def test_channels(self):
        layers = "depth,range,normal,geometric_normal,position,albedo,actor,block,cell"
        self.render("--size", "40x30", "--exr", "a.exr", "--layers", layers)
        header, channels = self.exr("a.exr")
        self.assertEqual((header["width"], header["height"]), (40, 30))
        types = {channel["name"]: channel["type"] for channel in header["channels"]}
        for name in ("R", "G", "B", "A"):
            self.assertIn(types[name], ("half", "float"))
        for layer in ("normal", "geometric_normal", "position"):
            for axis in "XYZ":
                self.assertIn(types[f"{layer}.{axis}"], ("half", "float"))
        self.assertEqual(types["depth.Z"], "float")
        self.assertEqual(types["range.Z"], "float")
        for layer in ("actor", "block", "cell"):
            self.assertEqual(types[f"{layer}.id"], "uint")
        for attribute in ("worldToCamera", "worldToNDC", "near", "far"):
            self.assertIn(attribute, header["attributes"])
        self.assertAlmostEqual(header["attributes"]["near"]["value"], 1.0)
        self.assertAlmostEqual(header["attributes"]["far"]["value"], 10.0)

        # The triangle in z = 0 seen from z = 5, and the background's values.
        hit = numpy.isfinite(channels["depth.Z"])
        self.assertGreater(hit.sum(), 100)
        self.assertFalse(hit.all())
        numpy.testing.assert_allclose(channels["depth.Z"][hit], 5.0, rtol=1e-6)
        self.assertTrue(numpy.isposinf(channels["depth.Z"][~hit]).all())
        self.assertTrue(numpy.isposinf(channels["range.Z"][~hit]).all())
        self.assertTrue((channels["range.Z"][hit] >= channels["depth.Z"][hit] * (1 - 1e-6)).all())
        numpy.testing.assert_allclose(channels["normal.Z"][hit], 1.0, atol=1e-3)
        numpy.testing.assert_allclose(channels["normal.X"][hit], 0.0, atol=1e-3)
        self.assertTrue((channels["normal.Z"][~hit] == 0).all())
        numpy.testing.assert_allclose(channels["position.Z"][hit], 0.0, atol=1e-5)
        self.assertTrue((channels["position.X"][hit] + channels["position.Y"][hit] < 1e-3).all())
        # The right angle is at the lower left: the top row of the file is the top of the picture.
        top, left = numpy.argwhere(hit).min(axis=0)
        self.assertTrue(hit[top, left] or hit[top + 1, left])
        self.assertFalse(hit[top, left + 5])
        for layer in ("actor", "block", "cell"):
            self.assertEqual(set(channels[f"{layer}.id"][hit]), {0}, layer)
            self.assertEqual(set(channels[f"{layer}.id"][~hit]), {BACKGROUND_ID}, layer)

    def test_without_layers_colour_and_depth(self):
        self.render("--size", "8x8", "--exr", "a.exr")
        header, _ = self.exr("a.exr")
        self.assertEqual(names_of(header), ["A", "B", "G", "R", "depth.Z"])

    def test_only_what_was_asked(self):
        self.render("--size", "8x8", "--exr", "a.exr", "--layers", "cell")
        header, _ = self.exr("a.exr")
        self.assertEqual(names_of(header), ["A", "B", "G", "R", "cell.id"])

    def test_array_by_name(self):
        write_data(self.folder)
        for name in ("a.vtp", "a.vtu"):
            with self.subTest(file=name):
                self.relievo("render", name, "--size", "60x60", "--exr", "a.exr",
                             "--layers", "depth,height,position")  # fmt: skip
                _, channels = self.exr("a.exr")
                hit = numpy.isfinite(channels["depth.Z"])
                self.assertGreater(hit.mean(), 0.2)
                # The array is y + 1/2 by its making.
                numpy.testing.assert_allclose(
                    channels["height.V"][hit], channels["position.Y"][hit] + 0.5, atol=2e-3
                )

    def test_array_that_shares_a_layers_name(self):
        write_data(self.folder)
        self.relievo("render", "a.vtp", "--size", "60x60", "--exr", "a.exr",
                     "--layers", "depth,point:height")  # fmt: skip
        header, channels = self.exr("a.exr")
        self.assertEqual(names_of(header), ["A", "B", "G", "R", "depth.Z", "point:height.V"])
        seen = numpy.isfinite(channels["depth.Z"])
        self.assertTrue(numpy.isfinite(channels["point:height.V"][seen]).all())
        self.assertTrue(numpy.isnan(channels["point:height.V"][~seen]).all())

    def test_unknown_array(self):
        write_data(self.folder)
        done = self.relievo("render", "a.vtp", "--exr", "b.exr", "--layers", "hieght", status=2)
        self.assertIn("'hieght'", done.stderr)
        self.assertIn("height", done.stderr)
        self.assertFalse((self.folder / "b.exr").exists())

    def test_two_files_are_two_actors(self):
        (self.folder / "behind.off").write_text("OFF\n3 1 0\n-3 -3 -1\n3 -3 -1\n0 4 -1\n3 0 1 2\n")
        self.relievo("render", "triangle.off", "behind.off", *LOOK, "--size", "50x50", "--exr",
                     "a.exr", "--layers", "actor,depth")  # fmt: skip
        _, channels = self.exr("a.exr")
        self.assertEqual(set(channels["actor.id"].ravel()), {0, 1, BACKGROUND_ID})
        numpy.testing.assert_allclose(channels["depth.Z"][channels["actor.id"] == 0], 5, rtol=1e-6)
        numpy.testing.assert_allclose(channels["depth.Z"][channels["actor.id"] == 1], 6, rtol=1e-6)

    def test_view_angle(self):
        # The half height at distance 5 is 5 tan(angle/2): the triangle's left edge at x = -1.
        for angle in (20.0, 50.0, 90.0):
            with self.subTest(angle=angle):
                self.render("--size", "200x200", "--view-angle", str(angle), "--exr", "a.exr")
                _, channels = self.exr("a.exr")
                columns = numpy.nonzero(numpy.isfinite(channels["depth.Z"]).any(axis=0))[0]
                half = 5 * math.tan(math.radians(angle / 2))
                edge = max(0.0, 100 - 100 / half)
                self.assertAlmostEqual(columns.min(), edge, delta=1.0)


class Report(CliTest):
    def test_report(self):
        self.render("--size", "32x32", "--layers", "depth,normal", "--exr", "a.exr",
                    "--report", "a.json")  # fmt: skip
        report = json.loads((self.folder / "a.json").read_text())
        self.assertIsInstance(report, dict)
        stages = {stage["name"]: stage for stage in report["stages"]}
        self.assertTrue(stages["gbuffer"]["ran"])
        self.assertGreater(stages["gbuffer"]["bytes"], 32 * 32 * 4)

    def test_a_picture_alone_makes_no_layers(self):
        self.render("--size", "32x32", "--png", "a.png", "--report", "a.json")
        report = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(report["bytes"], 0)
        ran = [stage["name"] for stage in report["stages"] if stage["ran"]]
        self.assertEqual(ran, ["delegate"])

    def test_the_picture_is_the_same_with_layers(self):
        self.render("--size", "64x64", "--png", "plain.png")
        self.render("--size", "64x64", "--png", "a.png", "--exr", "a.exr", "--layers", "depth,cell")
        numpy.testing.assert_array_equal(
            read_png(self.folder / "plain.png"), read_png(self.folder / "a.png")
        )


class Page(html.parser.HTMLParser):
    """A page's JSON, and its faults: elements that do not close, and addresses."""

    VOID = {"meta", "input"}

    def __init__(self, text):
        super().__init__()
        self.open, self.problems, self.data, self.scripts = [], [], "", 0
        self.feed(text)
        self.close()
        self.problems += self.open
        if self.scripts != 2:
            self.problems.append(f"{self.scripts} scripts")

    def handle_starttag(self, tag, attrs):
        self.problems += [f"{tag} {name}" for name, _ in attrs if name in ("src", "href")]
        self.scripts += tag == "script"
        if tag not in self.VOID:
            self.open.append((tag, dict(attrs).get("id")))

    def handle_endtag(self, tag):
        if not self.open or self.open.pop()[0] != tag:
            self.problems.append(f"/{tag} at {self.getpos()}")

    def handle_data(self, data):
        if self.open and self.open[-1] == ("script", "data"):
            self.data += data


def words_of(text, kind):
    """Decodes a page's 32-bit words, compressed with the lowest bytes of all words first."""
    planes = numpy.frombuffer(zlib.decompress(base64.b64decode(text)), "u1").reshape(4, -1)
    return numpy.ascontiguousarray(planes.T).view(kind).ravel()


def document_of(path):
    """The JSON of a .glb file."""
    data = path.read_bytes()
    size = int.from_bytes(data[12:16], "little")
    return json.loads(data[20 : 20 + size])


class Gltf(CliTest):
    """Files are checked by tests/gltf; here the option."""

    def test_one_picture(self):
        look = ("render", "triangle.off", "--preset", "studio", "--size", "64x48", "--report")
        self.relievo(*look, "a.json")
        self.relievo(*look, "b.json", "--gltf", "a.glb")
        stages = [[(each["name"], each["reason"])
                   for each in json.loads((self.folder / name).read_text())["stages"]]
                  for name in ("a.json", "b.json")]  # fmt: skip
        self.assertEqual(*stages)
        document = document_of(self.folder / "a.glb")
        names = {node.get("name") for node in document["nodes"]}
        self.assertLessEqual({"triangle.off", "camera"}, names)
        self.assertNotIn("animations", document)
        self.assertEqual(list(self.folder.glob(".relievo*")), [])

    def test_frames(self):
        turn = ("render", "triangle.off", "--turntable", "3", "--size", "16x16", "--gltf")
        self.relievo(*turn, "%d.glb")
        self.assertNotIn("animations", document_of(self.folder / "2.glb"))
        self.relievo(*turn, "all.glb")
        (animation,) = document_of(self.folder / "all.glb")["animations"]
        nodes = document_of(self.folder / "all.glb")["nodes"]
        moved = {nodes[each["target"]["node"]]["name"] for each in animation["channels"]}
        self.assertEqual(moved, {"camera"})

    def test_refused(self):
        for words, says in (
            (["--gltf", "a.gltf"], ["--gltf", "'a.gltf'", ".glb"]),
            (["--gltf", "a.glb", "--lens", "fisheye:angle=90"], "--gltf and --lens"),
            (["--gltf", "a.glb", "--turntable", "2", "--png", "%d.png", "--resume"],
             "--resume and --gltf"),
        ):  # fmt: skip
            self.refused("render", "triangle.off", *words, status=2, says=says)
        (self.folder / "cloud.ply").write_text(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n")
        done = self.relievo("render", "cloud.ply", "--point-size", "3", "--gltf", "a.glb")
        self.assertIn("--gltf: sizes of points", done.stderr)


class Compare(CliTest):
    """`relievo compare`: exit status, text and JSON for known changes."""

    # A table 2 wide at y = 0, and above it a plate of this height, which casts a shadow.
    PLATE = """# vtk DataFile Version 3.0
plate
ASCII
DATASET POLYDATA
POINTS 4 float
-1 {y} -1  -1 {y} 0  0.2 {y} 0  0.2 {y} -1
POLYGONS 1 5
4 0 1 2 3
"""
    LOOK = ("--size", "160x120", "--light", "sun:1,5,2", "--light", "point:-1,3,2",
            "--shadows", "map")  # fmt: skip

    def setUp(self):
        super().setUp()
        (self.folder / "table.vtk").write_text(
            self.PLATE.format(y=0).replace("0.2 0", "1 0").replace("0 0  1", "0 1  1"))
        self.move(0.5)
        self.relievo("render", "table.vtk", "plate.vtk", *self.LOOK, "--camera",
                     "2,4,6,0,0.2,0,0,1,0", "--baseline", "a.exr")

    def move(self, y):
        (self.folder / "plate.vtk").write_text(self.PLATE.format(y=y))

    def found(self, *words, status=3):
        done = self.relievo("compare", *words, "--json", "found.json", status=status)
        return done.stdout, json.loads((self.folder / "found.json").read_text())

    def test_alike(self):
        text, found = self.found("a.exr", "a.exr", status=0)
        self.assertEqual(text, "alike: 0 of 19 200 pixels\n")
        self.assertTrue(found["alike"])
        # The recorded options override the environment.
        done = self.relievo("compare", "a.exr", "--render", "table.vtk", "plate.vtk",
                            environment={"RELIEVO_PRESET": "studio"})
        self.assertTrue(done.stdout.startswith("alike: 0 of 19 200 pixels"), done.stdout)
        header, _ = self.exr("a.exr")
        self.assertEqual([c["name"] for c in header["channels"] if "shadow" in c["name"]],
                         ["shadow_light_0.V", "shadow_light_1.V"])

    def test_moved(self):
        self.move(0.53)
        text, found = self.found("a.exr", "--render", "table.vtk", "plate.vtk")
        causes = {(each["cause"], each.get("name")): each for each in found["causes"]}
        self.assertEqual(set(causes), {("moved", "plate.vtk"), ("shadow", "light 0"),
                                       ("shadow", "light 1")}, text)  # fmt: skip
        moved = causes["moved", "plate.vtk"]
        self.assertEqual(moved["id"], 1)
        numpy.testing.assert_allclose(moved["displacement"], (0, 0.03, 0), atol=1e-7)
        self.assertEqual(found["unexplained"], 0)
        self.assertIn("1 of 2 objects, 2 of 2 lights;", text)
        self.assertRegex(text, r"plate.vtk \(actor 1\) +moved by \(0, 0.03, 0\), at most [01]\.")
        self.assertLessEqual(max(map(len, text.splitlines())), 120)
        # Another order of the files is no difference.
        _, swapped = self.found("a.exr", "--render", "plate.vtk", "table.vtk")
        self.assertEqual(found["causes"], swapped["causes"])

    def test_pictures(self):
        """The pictures of both sides equal those of `relievo render`, except for rounding."""
        camera = ("--camera", "2,4,6,0,0.2,0,0,1,0")
        drawn = []
        for name, y in (("a.png", 0.5), ("b.png", 0.53)):
            self.move(y)
            self.relievo("render", "table.vtk", "plate.vtk", *self.LOOK, *camera, "--png", name)
            drawn.append(read_png(self.folder / name).astype(int))
        self.relievo("compare", "a.exr", "--png-a", "1.png", "--png-b", "2.png",
                     "--render", "table.vtk", "plate.vtk", status=3)
        self.relievo("compare", "1.png", "2.png", "--png-a", "3.png", status=3)
        for name, side in (("1.png", 0), ("2.png", 1), ("3.png", 0)):
            seen = read_png(self.folder / name)
            self.assertEqual(seen.shape, (120, 160, 3))
            for other in range(2):
                off = numpy.abs(seen - drawn[other]).max()
                (self.assertLessEqual if side == other else self.assertGreater)(off, 1, name)

    def test_options_that_are_given(self):
        _, found = self.found("a.exr", "--render", "table.vtk", "plate.vtk",
                              "--light", "sun:1,5,2.2", "--light", "point:-1,3,2")
        self.assertEqual([(each["cause"], each["name"]) for each in found["causes"]],
                         [("light", "light 0")])
        _, found = self.found("a.exr", "--render", "table.vtk", "--background", "white")
        causes = {each["cause"]: each for each in found["causes"]}
        self.assertEqual(causes["removed"]["name"], "plate.vtk")
        self.assertEqual(causes["settings"]["name"], "background")
        self.assertGreater(causes["settings"]["pixels"], 5000)

    # A file name with HTML, Markdown, a mention and an issue.
    ODD = "<script>x&amp;@me #1 |_`.vtk"

    def test_report(self):
        """The page has the pictures and the cause of each pixel; names are escaped, also in
        Markdown."""
        (self.folder / "plate.vtk").rename(self.folder / self.ODD)
        look = (*self.LOOK, "--camera", "2,4,6,0,0.2,0,0,1,0")
        self.relievo("render", "table.vtk", self.ODD, *look, "--baseline", "a.exr", "--png",
                     "a.png")
        (self.folder / self.ODD).write_text(self.PLATE.format(y=0.53))
        self.relievo("render", "table.vtk", self.ODD, *look, "--baseline", "b.exr", "--png",
                     "b.png")
        _, found = self.found("a.exr", "b.exr", "--html", "page.html", "--markdown", "page.md")
        page = (self.folder / "page.html").read_text("ascii")
        parts = Page(page)
        self.assertEqual(parts.problems, [])
        (entry,) = json.loads(parts.data)
        self.assertEqual(entry["name"], "a.exr, b.exr")
        self.assertEqual([{**each, "label": ""} for each in entry["causes"]],
                         [{**each, "label": ""} for each in found["causes"]])
        self.assertIn(f"{self.ODD} (actor 1)", [each["label"] for each in entry["causes"]])
        places = words_of(entry["places"], "<i4")
        self.assertEqual([(places == i).sum() for i in range(len(found["causes"]))],
                         [each["pixels"] for each in found["causes"]])
        self.assertEqual([(places == i).sum() for i in (-4, -3, -2)],
                         [0, *found["within_limits"].values()])
        for frame, name in zip(entry["frames"], "ab", strict=True):
            _, channels = self.exr(f"{name}.exr")
            (self.folder / "shown.png").write_bytes(
                base64.b64decode(frame["picture"].removeprefix("data:image/png;base64,")))
            numpy.testing.assert_array_equal(
                read_png(self.folder / "shown.png"), read_png(self.folder / f"{name}.png")[..., :3])
            actor = words_of(frame["actor"], "<u4").reshape(120, 160)
            numpy.testing.assert_array_equal(actor, channels["actor.id"])
            self.assertEqual(frame["objects"][1], self.ODD)
            depth = words_of(frame["depth"], "<f4").reshape(120, 160)
            numpy.testing.assert_allclose(depth, channels["depth.Z"], rtol=2**-17)
        # The plate's pixels are at the right place, with the top row first.
        moved = [each["cause"] for each in found["causes"]].index("moved")
        plate = channels["actor.id"] == 1
        self.assertGreater(plate[places.reshape(120, 160) == moved].mean(), 0.9)
        self.marked(found)

    def marked(self, found):
        """The table in Markdown has a row for each cause, and names are escaped."""
        text = (self.folder / "page.md").read_text("utf-8")
        rows = [line for line in text.splitlines() if line.startswith("| ")]
        self.assertEqual(len(rows), len(found["causes"]) + 1, text)
        for row, cause in zip(rows[1:], found["causes"], strict=True):
            cells = re.split(r"(?<!\\)\|", row)
            self.assertEqual(int(cells[3].replace(" ", "")), cause["pixels"])
        self.assertIn("&lt;script&gt;x&amp;amp;@&#8203;me #&#8203;1 \\|\\_\\`.vtk", text)

    def test_report_of_folders(self):
        for name in ("one", "two"):
            (self.folder / name).mkdir()
            for file in ("a.exr", "c.exr"):
                shutil.copy(self.folder / "a.exr", self.folder / name / file)
        self.move(0.53)
        self.relievo("render", "table.vtk", "plate.vtk", *self.LOOK, "--camera",
                     "2,4,6,0,0.2,0,0,1,0", "--baseline", "two/a.exr")
        self.relievo("render", "table.vtk", "--png", "two/b.png", *self.LOOK)
        self.found("one", "two", "--html", "page.html", "--markdown", "page.md")
        parts = Page((self.folder / "page.html").read_text("ascii"))
        self.assertEqual([(each["name"], each["alike"], "frames" in each)
                          for each in json.loads(parts.data)],
                         [("a.exr", False, True), ("b.png", False, False), ("c.exr", True, False)])
        text = (self.folder / "page.md").read_text("utf-8")
        self.assertEqual(re.findall("^### (.*)", text, re.M), ["a.exr", "b.png", "c.exr"])
        self.assertIn("missing in one", text)

    def test_folders(self):
        for name in ("one", "two"):
            (self.folder / name).mkdir()
            (self.folder / name / "a.exr").write_bytes((self.folder / "a.exr").read_bytes())
            (self.folder / name / "link.exr").symlink_to(self.folder / "a.exr")
            (self.folder / name / "nothing.png").symlink_to("nowhere.png")
        self.relievo("compare", "one", "two")
        self.relievo("render", "table.vtk", "--png", "two/b.png", *self.LOOK)
        text, found = self.found("one", "two")
        self.assertEqual(text, "b.png: missing in one\n1 of 3 files different\n")
        self.assertEqual([(each["file"], each["alike"]) for each in found["files"]],
                         [("a.exr", True), ("b.png", False), ("link.exr", True)])
        # A file that cannot be read fails alone; the others are compared and reported.
        (self.folder / "one" / "a.exr").write_bytes(b"cut")
        done = self.relievo("compare", "one", "two", "--json", "all.json", "--html", "all.html",
                            status=1)  # fmt: skip
        self.assertRegex(done.stdout, r"a\.exr: not compared: .*a\.exr.*\nb\.png: missing in one\n"
                                      r"2 of 3 files different\n")  # fmt: skip
        found = json.loads((self.folder / "all.json").read_text("utf-8"))
        self.assertIn("a.exr", found["files"][0]["failure"])
        self.assertEqual([each["alike"] for each in found["files"]], [False, False, True])
        self.assertIn("not compared", done.stdout)

    def test_refused(self):
        self.before = self.names()
        cut = self.folder / "cut.exr"
        cut.write_bytes((self.folder / "a.exr").read_bytes()[:5000])
        self.relievo("render", "table.vtk", "--exr", "plain.exr", *self.LOOK)
        self.before = self.names()
        for status, words, says in (
            (2, ("a.exr",), "got 1 file, expected A and B"),
            (2, ("a.exr", "b.exr", "--render", "table.vtk"), "expected A alone"),
            (2, ("a.exr", "a.exr", "--levels", "300"), "--levels"),
            (2, (".", ".", "--png-a", "a.png"), "--png-b need two files, got folders"),
            (2, ("a.exr", "plain.exr", "--png-b", "plain.exr"), "--png-b"),
            (2, ("plain.exr", "--render", "table.vtk"), "records no options"),
            (2, ("a.exr", "--render", "table.vtk", "--lite", "1"), "--lite"),
            (1, ("a.exr", "none.exr"), "none.exr"),
            (1, ("a.exr", "cut.exr"), "cut.exr"),
            (1, ("a.exr", "table.vtk"), "table.vtk"),
            (2, ("a.exr", "a.exr", "--html", "page.md"), "a name that ends in .html"),
            (1, ("a.exr", "a.exr", "--html", "none/page.html"), "none/page.html"),
        ):
            with self.subTest(words):
                self.refused("compare", *words, status=status, says=says)
        self.refused("render", "table.vtk", "--lens", "fisheye:angle=120", "--baseline", "b.exr",
                     status=2, says="--lens")


@unittest.skipUnless(BENCHES, "built without benches")
class Bench(CliTest):
    def without_matplotlib(self):
        """The environment of a command that finds none; to draw charts takes longest."""
        (self.folder / "matplotlib.py").write_text(
            "raise ModuleNotFoundError('none', name='matplotlib')")  # fmt: skip
        return {"PYTHONPATH": str(self.folder)}

    def test_depth(self):
        """Charts are drawn where this Python, which the command runs too, has matplotlib."""
        done = self.relievo("bench", "depth", "--quick", "--out", "charts/new")
        self.assertEqual(done.stderr, "")
        names = {path.name for path in (self.folder / "charts" / "new").iterdir()}
        self.assertIn("depth.csv", names)
        pictures = [name for name in names if name.endswith(".png")]
        has_matplotlib = importlib.util.find_spec("matplotlib") is not None
        self.assertEqual(bool(pictures), has_matplotlib)
        self.assertEqual("bench/charts.py charts/new" in done.stdout, not has_matplotlib)
        for name in pictures:
            self.assertIn(name.replace(".png", ".svg"), names)
            self.assertGreater(min(read_png(self.folder / "charts" / "new" / name).shape[:2]), 100)

    def test_without_matplotlib(self):
        """It measures, and says in one line how charts are drawn."""
        done = self.relievo("bench", "depth", "--quick", "--out", "new",
                            environment=self.without_matplotlib())  # fmt: skip
        self.assertEqual(done.stderr, "")
        said = [line for line in done.stdout.splitlines() if "charts" in line]
        self.assertEqual(len(said), 1, done.stdout)
        self.assertIn("bench/charts.py new", said[0])
        names = {path.name for path in (self.folder / "new").iterdir()}
        self.assertEqual(names, {"depth.csv", "renderer.txt"})

    def test_list(self):
        """Each bench with a line about it, scripts with their file; no display is needed."""
        lines = self.relievo("bench", "--list").stdout.splitlines()
        found = dict(line.split(maxsplit=1) for line in lines)
        self.assertIn("error of the depth formats", found["depth"])
        self.assertIn("(bench/compare.py)", found["compare"])
        self.assertGreater(min(len(line) for line in found.values()), 20)

    def test_scripts(self):
        """Options after -- are for a script alone; failures name it."""
        self.refused("bench", "depth", "--", "--seed", "7", status=2,
                     says="expected one NAME of a Python script")  # fmt: skip
        for words, says in (
            (("compare", "--", "--no-such"), "bench: compare.py: it ended with status 2"),
            (("studio",), "bench: studio_samples.py: set RELIEVO_DATA"),
        ):
            done = self.relievo("bench", *words, status=1, environment={"RELIEVO_DATA": ""})
            self.assertIn(says, done.stderr)

    def test_scripts_keep_tables(self):
        """A script that fails, or shows its help, leaves the older table, and no other file."""
        data = {"RELIEVO_DATA": str(self.folder)}
        for name in ("studio", "readable"):
            table = self.folder / f"{name}.csv"
            table.write_text("old\n")
            self.relievo("bench", name, "--", "--nonsense", status=1, environment=data)
            said = self.relievo("bench", name, "--", "--help", environment={"RELIEVO_DATA": ""})
            self.assertIn("usage:", said.stdout)
            self.assertEqual(table.read_text(), "old\n")
        self.assertFalse(list(self.folder.glob("*.part")))

    def test_folder_named_like_a_place(self):
        """Words for places that scripts are given are not taken from the user's."""
        done = self.relievo("bench", "compare", "--out", "DATA", "--", "--nonsense", status=1,
                            environment={"RELIEVO_DATA": ""})  # fmt: skip
        self.assertIn("compare.py: it ended with status 2", done.stderr)

    def test_several(self):
        """One fails for want of meshes, the other is done, and is not run again; the summary tells
        both, and puts times beside those of a folder."""
        words = ("bench", "capture", "depth", "--quick", "--out", "here", "--beside", "there")
        self.refused(*words, status=2, says=["--beside", "'there'"])
        plain = {**self.without_matplotlib(), "RELIEVO_DATA": ""}
        (self.folder / "there").mkdir()
        (self.folder / "there" / "other.csv").write_text("scene,ms\nbunny,1\n")
        done = self.relievo(*words, status=1, environment=plain)
        self.assertIn("capture ... failed, status 1: relievo: bench:", done.stdout)
        self.assertRegex(done.stdout, r"depth ... done quickly, [\d.]+ s")
        here = self.folder / "here"
        self.assertIn("RELIEVO_DATA", (here / "logs" / "capture.txt").read_text())
        self.assertTrue((here / "depth.csv").exists())
        summary = (here / "summary.md").read_text()
        for words_of in ("renderer ", "| capture | failed", "| depth | done"):
            self.assertIn(words_of, summary)
        written = (here / "depth.csv").stat().st_mtime_ns
        again = self.relievo(*words, status=1, environment=plain)
        self.assertIn("depth ... done before", again.stdout)
        self.assertEqual((here / "depth.csv").stat().st_mtime_ns, written)

    def test_quick(self):
        """A quick run is done for a quick call, and measured again by one that is not."""
        (self.folder / "there").mkdir()
        (self.folder / "there" / "other.csv").write_text("scene,ms\nbunny,1\n")
        words = ("bench", "depth", "--out", "here", "--beside", "there")
        quick, before = (*words, "--quick"), "depth ... done before"
        plain = self.without_matplotlib()
        self.assertIn("depth ... done quickly,", self.relievo(*quick, environment=plain).stdout)
        self.assertIn(before, self.relievo(*quick, environment=plain).stdout)
        self.assertIn("depth ... done, ", self.relievo(*words, environment=plain).stdout)
        self.assertIn(before, self.relievo(*quick, environment=plain).stdout)
        self.assertIn("renderer", (self.folder / "here" / "summary.md").read_text())
        self.assertTrue((self.folder / "here" / "renderer.txt").read_text().strip())


if __name__ == "__main__":
    main()
