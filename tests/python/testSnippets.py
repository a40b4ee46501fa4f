# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The snippets of README and of the pages in docs run as printed, a page's in one Python, with a
reader's likely data at hand. Those of ParaView (`from paraview`, `view.`) are
tests/paraview's, and those of packages from PyPI are tests/clients'."""

import base64
import contextlib
import json
import os
import pathlib
import re
import struct
import sys
import tempfile
import types
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent / "standin"))

import numpy
import pyvista
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import relievo

ROOT = pathlib.Path(__file__).parents[2]
DATA = pathlib.Path(os.environ["RELIEVO_DATA"])
SNIPPET = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
ELSEWHERE = re.compile(
    r"\bparaview\b|^view\.|, view\b|^(from|import) (trame|vedo)\b", re.MULTILINE)

CUBE = """v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8
"""


# A raster as rasterio opens it, with the observers of the pages in it.
DEM = types.SimpleNamespace(
    read=lambda _: numpy.random.default_rng(4).random((60, 60)),
    transform=(10, 0, 689800, 0, -10, 5336600), nodata=None)  # fmt: skip


def pages():
    """{page: [(line, snippet)]} of those that run here."""
    found = {}
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        text = path.read_text(encoding="utf-8")
        snippets = [(text[: each.start(1)].count("\n"), each[1]) for each in SNIPPET.finditer(text)]
        snippets = [each for each in snippets if not ELSEWHERE.search(each[1])]
        if snippets:
            found[str(path.relative_to(ROOT))] = snippets
    return found


def points(*places):
    made = vtkPolyData()
    made.SetPoints(vtkPoints())
    for place in places:
        made.GetPoints().InsertNextPoint(place)
    return made


def actor_of(source):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    return actor


def gltf():
    """A triangle whose material has a normal map, in the file itself."""
    pixels = relievo.to_image(numpy.full((4, 4, 3), (128, 128, 255), numpy.uint8))
    from relievo._images.picture import png_of

    picture = png_of(relievo.from_image(pixels))
    floats = struct.pack("<24f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1,
                         0, 0, 1, 0, 0, 1)  # fmt: skip

    def inside(kind, data):
        return f"data:{kind};base64,{base64.b64encode(data).decode()}"

    views = [(0, 36), (36, 36), (72, 24)]
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "buffers": [{"byteLength": 96, "uri": inside("application/octet-stream", floats)}],
        "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in views],
        "accessors": [
            {"bufferView": i, "componentType": 5126, "count": 3, "type": kind, **ends}
            for i, (kind, ends) in enumerate([
                ("VEC3", {"min": [0, 0, 0], "max": [1, 1, 0]}), ("VEC3", {}), ("VEC2", {})])],
        "images": [{"uri": inside("image/png", picture)}], "textures": [{"source": 0}],
        "materials": [{"normalTexture": {"index": 0}}],
        "meshes": [{"primitives": [{"material": 0, "attributes":
                                    {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}}]}],
    })  # fmt: skip


def read(path):
    reader = relievo.vtkRelievoModelReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader


class Hand:
    """Names available to a reader: those that the snippets of a page use."""

    def __init__(self, page):
        self.page = page
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        ball, floor = vtkSphereSource(), vtkPlaneSource()
        floor.SetOrigin(-3, -3, -0.6)
        floor.SetPoint1(3, -3, -0.6)
        floor.SetPoint2(-3, 3, -0.6)
        actor, ground, light = actor_of(ball), actor_of(floor), vtkLight()
        light.SetPosition(1, 2, 5)
        self.renderer.AddActor(actor)
        self.renderer.AddActor(ground)
        self.renderer.AddLight(light)
        self.window.SetOffScreenRendering(True)
        self.window.SetSize(160, 120)
        self.window.AddRenderer(self.renderer)
        self.renderer.ResetCamera()
        self.frame = relievo.attach(self.renderer)
        self.shadows = self.frame.GetShadowStage()
        self.names = {
            "relievo": relievo, "pyvista": pyvista, "vtkActor": vtkActor,
            "vtkPolyDataMapper": vtkPolyDataMapper, "renderer": self.renderer,
            "window": self.window, "actor": actor, "light": light, "ship": actor, "buoy": ground,
            "frame": self.frame, "shadows": self.shadows, "ball": ball,
            "times": (0.0, 0.5), "lantern": points((0, 0, 1)),
            "heights": numpy.random.default_rng(1).random((16, 16), numpy.float32),
            "rasterio": types.SimpleNamespace(open=lambda _: contextlib.nullcontext(DEM)),
            "src": DEM,
        }  # fmt: skip
        for name in ("street_lamps", "swamps", "mist", "wells", "sites"):
            self.names[name] = points((-1, 0, 0), (1, 0, 0))
        ball.Update()
        self.names["model"] = self.names["mesh"] = ball.GetOutput()

    def before(self, index):
        """Names that mean something else on some page."""
        names = self.names
        if self.page == "docs/python.md" and index == 1:
            self.window.Render()
            names["material"] = relievo.vtkRelievoMaterial()
            names["grab"] = vtkWindowToImageFilter()
            names["grab"].SetInput(self.window)
            names["grab"].Update()
            names["normal"] = numpy.zeros((*names["depth"].shape, 3), numpy.float32)
        elif self.page == "docs/python.md":
            names["mesh"] = names["ball"]
            names["room"] = names["model"]
            names["wall_numbers"] = numpy.arange(names["model"].GetNumberOfCells()) % 2
        elif self.page == "docs/passes/Ambient.md":
            names["sensor"] = relievo.Equirectangular((64, 32))
        elif self.page == "docs/cameras.md":
            K = numpy.array([[80.0, 0, 79.5], [0, 80, 59.5], [0, 0, 1]])
            sensor = relievo.Pinhole(K, (160, 120)).look_at((0, 1, 5), (0, 0, 0))
            names.update(
                numpy=numpy, K=K, R=sensor.R, t=sensor.t, D=(0.01, 0), point=(0, 0, 0),
                points=numpy.eye(3),
                sensors=[sensor], terrain=points(), town=names["model"], site=names["model"],
                roofs=names["model"], masts=3 * numpy.eye(3))
            names["sensor"] = names.get("sensor", sensor)
            temperature = numpy_to_vtk(numpy.arange(float(names["model"].GetNumberOfPoints())))
            temperature.SetName("temperature")
            names["model"].GetPointData().AddArray(temperature)
        elif self.page == "docs/datasets.md":
            lens = relievo.Fisheye([[80, 0, 79.5], [0, 80, 59.5], [0, 0, 1]], (160, 120))
            names.update(
                cameras=[lens.look_at((0, 1, 5), (0, 0, 0))], mugs=[names["actor"]],
                names=["thing"] * names["renderer"].GetActors().GetNumberOfItems())
        elif self.page == "docs/rays.md":
            directions = numpy.array([(0, 0, -1.0), (0.1, 0, -1)])
            names.update(origins=(0, 0, 5), directions=directions, to_sun=(0, 0, 1),
                         city=names["model"], sensor=relievo.lens("fisheye", (16, 12)))
        elif self.page == "docs/environment.md":
            names["given"] = relievo.to_image(numpy.ones((16, 32, 3), numpy.float32))
        elif self.page == "docs/materials.md":
            names["image"] = relievo.to_image(names["heights"])
        elif self.page == "docs/volume-filters.md":
            labels = numpy.zeros((6, 6, 6), numpy.uint8)
            labels[2:4, 2:4, 2:4] = 1
            names["image"] = relievo.to_image(numpy.zeros((6, 6), numpy.uint8))
            names["image"].SetDimensions(6, 6, 6)
            array = numpy_to_vtk(labels.ravel(), deep=True)
            names["image"].GetPointData().SetScalars(array)
        elif self.page == "docs/animation.md" and index:
            names["reader"] = read("chair.glb" if index == 2 else "simple_skin.gltf")
            names["mesh"] = names["reader"].GetOutput().GetBlock(0)
        elif self.page == "docs/voxels.md" and index == 2:
            names["cubes"] = relievo.vtkRelievoVoxelCubes()
            names["shell"] = relievo.vtkRelievoVoxelShell()
            names["shell"].SetInputData(self.names["model"])
            names["shell"].SetResolution(8)
            names["cubes"].SetInputConnection(names["shell"].GetOutputPort())
        elif self.page == "docs/choosing-formats.md" and index == 1:
            names["gbuffer"] = self.frame.GetLayersStage()
        elif self.page == "docs/shadows.md":
            self.window.Render()
            if index == 5:
                self.shadows.SetSoftSamples(0)
                self.window.Render()


class Snippets(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(kept.name)
        for name in ("bike.obj", "motorBike.obj", "town.obj"):
            pathlib.Path(name).write_text(CUBE)
        pathlib.Path("bunny.off").symlink_to(DATA / "bunny.off")
        light = numpy.random.default_rng(2).random((32, 64, 3), numpy.float32)
        pathlib.Path("build/data").mkdir(parents=True)
        for name in ("forest.exr", "build/data/forest.exr"):  # which takes long in its own size
            relievo.write_exr(name, relievo.to_image({"color": light}))
        pathlib.Path("01_01.bvh").symlink_to(DATA / "models/BVH/01_01.bvh")
        skin = "gltf/glTF2/simple_skin/simple_skin.gltf"
        pathlib.Path("simple_skin.gltf").symlink_to(DATA / skin)
        pathlib.Path("chair.glb").write_text(gltf())
        pathlib.Path("calibration.yml").write_text(
            "image_width: 160\nimage_height: 120\n"
            "camera_matrix: [80, 0, 79.5, 0, 80, 59.5, 0, 0, 1]\n"
            "distortion_coefficients: [-0.1, 0.02, 0, 0, 0]\n")
        layers = {"depth": numpy.ones((4, 6), numpy.float32),
                  "normal": numpy.zeros((4, 6, 3), numpy.float32)}  # fmt: skip
        relievo.write_exr("frame.exr", relievo.to_image(layers))
        dem = relievo.terrain(DEM.read(1), DEM.transform)
        dem.write("dem.tif", {"height": dem.heights})

    def test_pages(self):
        found = pages()
        self.assertGreater(sum(map(len, found.values())), 40)
        for page, snippets in found.items():
            hand = Hand(page)
            for index, (line, text) in enumerate(snippets):
                with self.subTest(f"{page}:{line + 1}"):
                    hand.before(index)
                    text = re.sub(r"^image = \.\.\.", "image = given", text)
                    text = text.replace("SetNumberOfParticles(100000)", "SetNumberOfParticles(500)")
                    with open(os.devnull, "w") as null, contextlib.redirect_stdout(null):
                        code = compile("\n" * line + text, str(ROOT / page), "exec")
                        exec(code, hand.names)  # noqa: S102


if __name__ == "__main__":
    unittest.main(verbosity=2)
