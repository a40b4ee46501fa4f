# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that cannot be read or written: exit status 1, one line with the name, nothing left."""

import ctypes.util
import json
import os
import pathlib
import pty
import signal
import subprocess
import tempfile
import time
import unittest

import locales
import numpy
from cli import LOOK, NEEDS_DISPLAY, RELIEVO, CliTest, main, read_png, write_image
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

OUTPUTS = ["--png", "a.png", "--exr", "a.exr", "--report", "a.json"]

BROKEN = {
    "empty.off": "",
    "words.off": "this is not a mesh\n",
    "cut.off": "OFF\n3 1 0\n-1 -1 0\n1 -1 0\n",
    "index.off": "OFF\n3 1 0\n-1 -1 0\n1 -1 0\n-1 1 0\n3 0 1 7\n",
    "empty.vtp": "",
    "words.vtp": "this is not XML\n",
    "cut.vtp": '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1">\n<PolyData>\n',
    "empty.vtk": "",
    "words.vtk": "this is not a VTK file\n",
    "empty.ply": "",
    "words.ply": "this is not a mesh\n",
    # VTK's reader crashes on these, some by an assertion, which prints to the error output.
    "type.ply": "ply\nproperty float x\n",
    "count.ply": "ply\nformat ascii 1.0\nelement vertex\nend_header\n1 2 3\n",
    "header.ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n",
    "data.ply": "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nend_header\n",
    "empty.obj": "",
    "words.obj": "v 1 two 3\n",
    "empty.stl": "",
    "words.stl": "this is not a mesh\n",
    "empty.gltf": "",
    "words.gltf": "{ this is not JSON",
    "nothing.gltf": "{}",
    "words.glb": "this is not a scene\n",
}


def polydata(points, polygons):
    mesh, corners, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    corners.SetDataTypeToDouble()
    for point in points:
        corners.InsertNextPoint(point)
    for polygon in polygons:
        cells.InsertNextCell(len(polygon), polygon)
    mesh.SetPoints(corners)
    mesh.SetPolys(cells)
    return mesh


def write(mesh, path):
    writer = vtkPolyDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(mesh)
    writer.SetFileTypeToBinary()  # the others cannot hold infinity
    writer.Write()


class Inputs(CliTest):
    def test_locales(self):
        """The user's decimal comma has no say in files and words."""
        (self.folder / "SHAPE.STL").write_text(
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex -0.75 -0.75 0.5\n"
            "vertex 0.75 -0.75 0.5\nvertex -0.75 0.75 0.5\nendloop\nendfacet\nendsolid a\n")
        (self.folder / "lamps.vtk").write_text(
            "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0.25 0.5 1.5\n"
            "POINT_DATA 1\nSCALARS radius float 1\nLOOKUP_TABLE default\n2.5\n")
        made = []
        with tempfile.TemporaryDirectory() as folder:
            locales.make(folder)
            for name in ("C", *locales.NAMES):
                self.relievo("render", "SHAPE.STL", *LOOK, "--lamps", "lamps.vtk,intensity=0.75",
                             "--exr", "a.exr", "--png", "a.png", environment={"LC_ALL": name},
                             whole=True)  # fmt: skip
                made.append([(self.folder / each).read_bytes() for each in ("a.exr", "a.png")])
        self.assertEqual(made[1:], [made[0]] * 2)

    def test_missing(self):
        self.refused("render", "gone.off", *OUTPUTS, status=1,
                     says=["gone.off", "No such file"])  # fmt: skip
        self.refused("render", "triangle.off", "gone/b.vtu", *OUTPUTS, status=1,
                     says=["gone/b.vtu", "No such file"])  # fmt: skip

    def test_folder(self):
        (self.folder / "meshes.off").mkdir()
        self.before = self.names()
        self.refused("render", "meshes.off", *OUTPUTS, status=1, says=["meshes.off", "folder"])

    def test_broken(self):
        for name, text in BROKEN.items():
            (self.folder / name).write_text(text)
        self.before = self.names()
        for name in BROKEN:
            with self.subTest(file=name):
                self.refused("render", name, *OUTPUTS, status=1, says=name)

    def test_many_blanks(self):
        """Valid JSON, however much is between its words."""
        images = '"images": [{"uri"' + " " * 300000 + ': "none.png"}]'
        (self.folder / "blanks.gltf").write_text('{"asset": {"version": "2.0"}, ' + images + "}")
        self.before = self.names()
        self.refused("render", "blanks.gltf", *OUTPUTS, status=1,
                     says=["blanks.gltf", "contains nothing to draw"])  # fmt: skip

    def test_causes(self):
        """Messages with expectation and remedy where libraries only report failure."""
        huge = 4 * 10**12
        (self.folder / "huge.bvh").write_text(
            "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\n"
            f"End Site\n{{\nOFFSET 0 1 0\n}}\n}}\nMOTION\nFrames: {huge}\nFrame Time: 1\n0 0 0\n")
        (self.folder / "huge.dae").write_text(
            '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
            "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='a' "
            f"count='{huge}'>0 0 0</float_array></source></mesh></geometry></library_geometries>"
            "</COLLADA>")
        head = "# vtk DataFile Version 3.0\na\nASCII\n"
        (self.folder / "field.vtk").write_text(head + "FIELD f 1\nx 1 1 double\n1\n")
        (self.folder / "none.vtk").write_text(head + "DATASET NONE\n")
        (self.folder / "words.vtp").write_text("none")
        (self.folder / "large.json").write_text(json.dumps({
            "image_width": 100000, "image_height": 100000, "distortion_coefficients": [0] * 4,
            "camera_matrix": [[50, 0, 32], [0, 50, 24], [0, 0, 1]]}))  # fmt: skip
        self.before = self.names()
        memory = ["too large for memory", "is it damaged"]
        for name, says in (("huge.bvh", memory), ("huge.dae", memory),
                           ("field.vtk", ["DATASET", "geometry"]), ("none.vtk", ["DATASET"]),
                           ("words.vtp", ["cannot be read as .vtp", "complete"])):  # fmt: skip
            with self.subTest(name):
                self.refused("render", name, "--png", "a.png", status=1, says=[name, *says])
        self.refused("render", "triangle.off", "--lens", "large.json", "--png", "a.png", status=2,
                     says=["large.json", "100000x100000", "16384", "--size"])  # fmt: skip

    def test_no_geometry(self):
        (self.folder / "points.off").write_text("OFF\n0 0 0\n")
        self.before = self.names()
        self.refused("render", "points.off", *OUTPUTS, status=1, says="points.off")

    def test_broken_images(self):
        write_image(
            vtkPNGWriter(), self.folder / "good.png", numpy.full((64, 64, 3), 128, numpy.uint8)
        )
        whole = (self.folder / "good.png").read_bytes()
        hurt = bytearray(whole)
        hurt[60:64] = b"XXXX"
        for name, content in (("cut.png", whole[:80]), ("hurt.png", bytes(hurt))):
            (self.folder / name).write_bytes(content)
        self.before = self.names()
        # libpng prints to the error output.
        for name, what in (("cut.png", "ends too early"), ("hurt.png", "is damaged")):
            with self.subTest(file=name):
                self.refused("render", "triangle.off", "--normal-map", name, *OUTPUTS, status=1,
                             says=[name, what])  # fmt: skip

    def test_points_out_of_reach(self):
        for name, size in (("huge.off", 1e308), ("large.off", 1e19), ("tiny.off", 1e-30)):
            (self.folder / name).write_text(
                f"OFF\n3 1 0\n{-size} 0 0\n{size} 0 0\n0 {size} 0\n3 0 1 2\n"
            )
        mesh = polydata([(0, 0, 0), (1, 0, 0), (1e308, 1, 0)], [(0, 1, 2)])
        write(mesh, self.folder / "stray.vtk")
        self.before = self.names()
        for name, says in (("huge.off", "reach to"), ("large.off", "reach to"),
                           ("tiny.off", "long"), ("stray.vtk", "1e+308 along x")):  # fmt: skip
            with self.subTest(file=name):
                self.refused("render", name, *OUTPUTS, status=1, says=[name, says])

    def test_points_that_are_not_finite(self):
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]
        cells = [(0, 1, 2), (1, 4, 2), (1, 3, 2)]
        whole = polydata(corners, [cells[0], cells[2]])
        write(whole, self.folder / "whole.vtk")
        self.relievo("render", "whole.vtk", "--exr", "whole.exr")
        _, whole = self.exr("whole.exr")
        for bad in ((numpy.inf, 0, 0), (0, numpy.nan, 0), (0, 0, -numpy.inf)):
            write(polydata([*corners, bad], cells), self.folder / "mesh.vtk")
            done = self.relievo("render", "mesh.vtk", "--exr", "a.exr", "--layers",
                                "depth,cell,vtkOriginalCellIds")  # fmt: skip
            self.assertEqual(
                done.stderr,
                "relievo: mesh.vtk: left out 1 cell with points that are not finite "
                "(1 of 5 points)\n",
            )
            _, found = self.exr("a.exr")
            for name in ("R", "depth.Z"):
                numpy.testing.assert_array_equal(found[name], whole[name])
            seen = found["cell.id"] != 0xFFFFFFFF
            numpy.testing.assert_array_equal(
                found["vtkOriginalCellIds.V"][seen], 2 * found["cell.id"][seen]
            )
        write(polydata([(numpy.nan, 0, 0)] * 3, [(0, 1, 2)]), self.folder / "none.vtk")
        self.before = self.names()
        self.refused("render", "none.vtk", "--png", "a.png", status=1,
                     says=["none.vtk", "none of its 3 points is finite"])  # fmt: skip

    def test_a_broken_file_among_good_ones(self):
        (self.folder / "cut.off").write_text(BROKEN["cut.off"])
        self.before = self.names()
        self.refused("render", "triangle.off", "cut.off", *OUTPUTS, status=1, says="cut.off")


class InputsOfInputs(CliTest):
    """Files that no word names, for another file does: no output takes their place."""

    def keeps(self, name, *files):
        """Each file, which drawing `name` reads, stays, by whatever name an output is asked."""
        self.render_file(name)  # is read at all
        self.before = self.names()
        for file in files:
            path = self.folder / file
            content = path.read_bytes()
            link, hard = self.folder / f"link{path.suffix}", self.folder / f"hard{path.suffix}"
            link.symlink_to(file)
            os.link(path, hard)
            self.before = self.names()
            for place in (file, f"./{file}", link.name, hard.name):
                options = ["--report"] + [f"--{end}" for end in ("png", "exr")
                                          if path.suffix == f".{end}"]  # fmt: skip
                for option in options:
                    with self.subTest(name=name, option=option, place=place):
                        self.refused("render", name, option, place, "--size", "8x8", status=2,
                                     says=[f"{option} {place}: ", "is read as well"])  # fmt: skip
                        self.assertEqual(path.read_bytes(), content)
            link.unlink()
            hard.unlink()
            self.before = self.names()

    def render_file(self, name):
        done = self.relievo("render", name, "--size", "8x8", "--report", "first.json")
        self.assertEqual(done.stderr, "")
        (self.folder / "first.json").unlink()

    def texture(self, name):
        colors = numpy.full((4, 4, 3), 200, numpy.uint8)
        write_image(vtkPNGWriter(), self.folder / name, colors)

    def test_obj(self):
        self.texture("wood.png")
        (self.folder / "a.mtl").write_text("newmtl wood\nKd 1 1 1\nmap_Kd wood.png\n")
        (self.folder / "a.obj").write_text(
            "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n"
            "usemtl wood\nf 1/1/1 2/2/1 3/3/1\n")
        self.keeps("a.obj", "a.mtl", "wood.png")
        # One that is not there is no input.
        (self.folder / "wood.png").unlink()
        done = self.relievo("render", "a.obj", "--size", "8x8", "--png", "wood.png")
        self.assertIn("drawn without a texture", done.stderr)
        self.assertTrue((self.folder / "wood.png").is_file())

    def test_gltf(self):
        self.texture("base2.png")
        points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4")
        normals = numpy.array([[0, 0, 1]] * 3, "<f4")
        places = points[:, :2].copy()
        parts = [part.tobytes() for part in (points, normals, places)]
        (self.folder / "a.bin").write_bytes(b"".join(parts))
        starts = [sum(map(len, parts[:i])) for i in range(3)]
        (self.folder / "a.gltf").write_text(json.dumps({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"material": 0, "attributes": {
                "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}}]}],
            "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            "textures": [{"source": 0}], "images": [{"uri": "base2.png"}],
            "buffers": [{"uri": "a.bin", "byteLength": sum(map(len, parts))}],
            "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": len(part)}
                            for start, part in zip(starts, parts)],
            "accessors": [{"bufferView": i, "componentType": 5126, "count": 3, "type": kind,
                           **({"min": [0, 0, 0], "max": [1, 1, 0]} if i == 0 else {})}
                          for i, kind in enumerate(("VEC3", "VEC3", "VEC2"))],
        }))  # fmt: skip
        self.keeps("a.gltf", "a.bin", "base2.png")
        # Nor does the last of several frames, of which the first is not drawn then.
        self.refused("render", "a.gltf", "--times", "0:2:1", "--png", "base%d.png", status=2,
                     says=["--png base2.png: ", "is read as well"])  # fmt: skip

    def test_pieces(self):
        for name in ("one & two.vtp", "three.vtp"):
            writer = vtkXMLPolyDataWriter()
            writer.SetFileName(str(self.folder / name))
            writer.SetInputData(polydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))
            writer.SetDataModeToAscii()
            writer.Write()
        (self.folder / "a.vtm").write_text(
            '<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
            '<DataSet index="0" file="one &amp; two.vtp"/><Block index="1">'
            "<DataSet index='0'\n file = 'three.vtp'/></Block></vtkMultiBlockDataSet></VTKFile>\n")
        (self.folder / "a.pvtp").write_text(
            '<VTKFile type="PPolyData" version="1.0"><PPolyData GhostLevel="0"><PPoints>'
            '<PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
            '<Piece Source="three.vtp"/></PPolyData></VTKFile>\n')
        self.keeps("a.vtm", "one & two.vtp", "three.vtp")
        self.keeps("a.pvtp", "three.vtp")


class Named(CliTest):
    """Files that a file names are read from its own folder and below, and from allowed ones."""

    def setUp(self):
        super().setUp()
        self.secret = self.folder / "secret"
        self.inside = self.folder / "inside"
        for each in (self.secret, self.inside / "below"):
            each.mkdir(parents=True)
        red = numpy.tile(numpy.uint8([255, 0, 0]), (4, 4, 1))
        write_image(vtkPNGWriter(), self.secret / "red.png", red)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(self.secret / "piece.vtp"))
        writer.SetInputData(polydata([(-1, -1, 0), (1, -1, 0), (-1, 1, 0)], [(0, 1, 2)]))
        writer.SetDataModeToAscii()
        writer.Write()
        (self.secret / "m.mtl").write_text("newmtl a\nKd 1 0 0\n")
        for name in ("red.png", "piece.vtp", "m.mtl", "points.bin"):
            os.symlink(self.secret / name, self.inside / "below" / name)

    def places(self, name):
        """The forms in which a file can name another outside its folder."""
        return (f"../secret/{name}", str(self.secret / name), f"below/../../secret/{name}",
                f"below/{name}")  # fmt: skip

    def is_red(self):
        found = read_png(self.folder / "a.png")[20, 12]
        return bool(found[0] > 100 and found[1] < 20)

    def left_out(self, name, *more):
        """Noted once, with the option by which it is drawn."""
        done = self.relievo("render", f"inside/{name}", *LOOK, "--size", "32x32", "--png", "a.png")
        for text in ("outside the folder", f"{self.secret}", "--allow-folder", *more):
            self.assertIn(text, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertFalse(self.is_red())
        done = self.relievo("render", f"inside/{name}", *LOOK, "--size", "32x32", "--png", "a.png",
                            "--allow-folder", "secret")  # fmt: skip
        self.assertEqual(done.stderr, "")
        self.assertTrue(self.is_red())

    def refused_then_read(self, name):
        words = ("render", f"inside/{name}", *LOOK, "--png", "a.png")
        self.before = self.names()
        self.refused(*words, status=1, says=[name, "outside the folder", str(self.secret),
                                             "--allow-folder"])  # fmt: skip
        self.relievo(*words, "--allow-folder", "none", "--allow-folder=secret", status=1)
        self.relievo(*words, "--allow-folder", ".", "--allow-folder=secret")
        (self.folder / "a.png").unlink()

    def test_materials_and_textures_of_obj(self):
        mesh = "v -1 -1 0\nv 1 -1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nusemtl a\n"
        mesh += "f 1/1/1 2/2/1 3/3/1\n"
        (self.inside / "a.obj").write_text("mtllib a.mtl\n" + mesh)
        for place in self.places("red.png"):
            (self.inside / "a.mtl").write_text(f"newmtl a\nKd 1 1 1\nmap_Kd {place}\n")
            with self.subTest(texture=place):
                self.left_out("a.obj", "red.png")
        (self.inside / "a.mtl").unlink()
        for place in self.places("m.mtl"):
            (self.inside / "a.obj").write_text(f"mtllib {place}\n" + mesh)
            with self.subTest(library=place):
                self.left_out("a.obj", "m.mtl")

    def test_buffers_and_images_of_gltf(self):
        points = numpy.float32([[-1, -1, 0], [1, -1, 0], [-1, 1, 0]])
        normals, places = numpy.float32([[0, 0, 1]] * 3), points[:, :2].copy()
        parts = [part.tobytes() for part in (points, normals, places)]
        for folder in (self.secret, self.inside):
            (folder / "points.bin").write_bytes(b"".join(parts))
        starts = [sum(map(len, parts[:i])) for i in range(3)]

        def scene(buffer, image):
            (self.inside / "a.gltf").write_text(json.dumps({
                "asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": [{"material": 0, "attributes": {
                    "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}}]}],
                "extensionsUsed": ["KHR_materials_unlit"],
                "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                               "extensions": {"KHR_materials_unlit": {}}}],
                "textures": [{"source": 0}], "images": [{"uri": image}],
                "buffers": [{"uri": buffer, "byteLength": sum(map(len, parts))}],
                "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": len(part)}
                                for start, part in zip(starts, parts)],
                "accessors": [{"bufferView": i, "componentType": 5126, "count": 3, "type": kind,
                               **({"min": [-1, -1, 0], "max": [1, 1, 0]} if i == 0 else {})}
                              for i, kind in enumerate(("VEC3", "VEC3", "VEC2"))],
            }))  # fmt: skip

        def coded(name):
            return *self.places(name), f"%2e%2e%2fsecret%2f{name}"
        for image in coded("red.png"):
            scene("points.bin", image)
            with self.subTest(image=image):
                self.left_out("a.gltf", "images[0]")
        for buffer in coded("points.bin"):
            scene(buffer, "../secret/red.png")
            with self.subTest(buffer=buffer):
                self.refused_then_read("a.gltf")

    def test_textures_of_collada(self):
        """Of the formats that Assimp reads; of a name that is there as well, the folder's own."""
        source = '<source id="{0}"><float_array id="{0}a" count="{2}">{1}</float_array>'
        source += '<technique_common><accessor source="#{0}a" count="3" stride="{3}">{4}</accessor>'
        source += "</technique_common></source>"

        def array(name, values, axes):
            params = "".join(f'<param name="{axis}" type="float"/>' for axis in axes)
            return source.format(name, values, len(values.split()), len(axes), params)
        for place in self.places("red.png"):
            (self.inside / "a.dae").write_text(
                '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
                "<asset><up_axis>Y_UP</up_axis></asset><library_images><image id='i'><init_from>"
                f"{place}</init_from></image></library_images><library_effects><effect id='e'>"
                "<profile_COMMON><newparam sid='s'><surface type='2D'><init_from>i</init_from>"
                "</surface></newparam><newparam sid='t'><sampler2D><source>s</source></sampler2D>"
                "</newparam><technique sid='c'><lambert><diffuse><texture texture='t' "
                "texcoord='u'/></diffuse></lambert></technique></profile_COMMON></effect>"
                "</library_effects>"
                "<library_materials><material id='m'><instance_effect url='#e'/></material>"
                "</library_materials><library_geometries><geometry id='g'><mesh>"
                + array("p", "-1 -1 0 1 -1 0 -1 1 0", "XYZ") + array("u", "0 0 1 0 0 1", "ST")
                + "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>"
                "<triangles count='1' material='x'><input semantic='VERTEX' source='#v' "
                "offset='0'/><input semantic='TEXCOORD' source='#u' offset='0' set='0'/>"
                "<p>0 1 2</p></triangles></mesh></geometry></library_geometries>"
                "<library_visual_scenes><visual_scene id='w'>"
                "<node id='n'><instance_geometry url='#g'><bind_material><technique_common>"
                "<instance_material symbol='x' target='#m'><bind_vertex_input semantic='u' "
                "input_semantic='TEXCOORD' input_set='0'/></instance_material></technique_common>"
                "</bind_material></instance_geometry></node></visual_scene></library_visual_scenes>"
                "<scene><instance_visual_scene url='#w'/></scene></COLLADA>")
            with self.subTest(texture=place):
                self.left_out("a.dae", "red.png")

    def write_pieces(self, place, name="a.vtm", kind="vtkMultiBlockDataSet"):
        piece = f'<DataSet index="0" file="{place}"/>'
        if kind == "PPolyData":
            piece = '<PPoints><PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
            piece += f'<Piece Source="{place}"/>'
        (self.inside / name).write_text(
            f'<VTKFile type="{kind}" version="1.0"><{kind}>{piece}</{kind}></VTKFile>\n')

    def test_pieces_of_vtk(self):
        """In any form, and of any of VTK's readers, chosen by the file's content."""
        for place in (*self.places("piece.vtp"), "..&#x2f;secret&#47;piece.vtp"):
            self.write_pieces(place)
            with self.subTest(place=place):
                self.refused_then_read("a.vtm")
        for name, kind in (("a.pvtp", "PPolyData"), ("a.vtp", "vtkMultiBlockDataSet"),
                           ("b.vtp", "PPolyData")):  # fmt: skip
            self.write_pieces(place, name, kind)
            with self.subTest(name=name):
                self.refused_then_read(name)

    def test_points_of_pieces(self):
        """Other interfaces: points of stages, and the commands that work on meshes."""
        self.write_pieces("../secret/piece.vtp")
        self.before = self.names()
        outside = ["a.vtm", "outside the folder", "--allow-folder"]
        lamps = ("render", "triangle.off", "--lamps", "inside/a.vtm", "--png", "a.png")
        seen = ("visible", "inside/a.vtm", "--poses", "orbit:1", "--size", "9x9", "-o", "a.vtp")
        sun = ("sun", "inside/a.vtm", "--place", "0,0", "--dates", "2026-06-21", "-o", "a.vtp")
        for words in (lamps, seen, sun):
            self.refused(*words, status=1, says=outside)
        for words in (seen, sun):
            self.relievo(*words, "--allow-folder", "secret")

    def test_pieces_that_never_end(self):
        os.mkfifo(self.inside / "pipe.vtp")
        os.symlink("/dev/zero", self.inside / "zero.vtp")
        for place, *more in (("pipe.vtp",), ("zero.vtp", "--allow-folder", "/dev")):
            for name, kind in (("a.vtm", "vtkMultiBlockDataSet"), ("a.pvtp", "PPolyData")):
                self.write_pieces(place, name, kind)
                self.before = self.names()
                self.refused("render", f"inside/{name}", "--png", "a.png", *more, status=1,
                             says=[name, place, "it is a "])  # fmt: skip

    def test_poses_that_never_end(self):
        os.mkfifo(self.folder / "pipe.json")
        os.symlink("/dev/zero", self.folder / "zero.json")
        (self.folder / "long.json").touch()
        os.truncate(self.folder / "long.json", 1 << 40)  # holes
        for name, says in (("pipe", "a pipe"), ("zero", "a device"), ("long", "256 MiB")):
            self.before = self.names()
            for words in (("visible", "-o", "a.vtp"), ("dataset", "--out", "out")):
                self.refused(words[0], "triangle.off", "--poses", f"{name}.json", *words[1:],
                             status=1, says=[f"{name}.json", says])  # fmt: skip

    def test_a_data_set_that_never_ends(self):
        words = ("dataset", "triangle.off", "--poses", "orbit:1", "--size", "9x9", "--out", "out")
        self.relievo(*words)
        for path in sorted((self.folder / "out").rglob("*.json")):
            content = path.read_bytes()
            path.unlink()
            os.mkfifo(path)
            done = self.finished(*words)
            if done.returncode:
                self.assertIn("it is a pipe", done.stderr)
            path.unlink()
            path.write_bytes(content)


class Outputs(CliTest):
    def test_no_folder(self):
        for option, name in (("--png", "a.png"), ("--exr", "a.EXR"), ("--report", "a.txt")):
            with self.subTest(option=option):
                self.refused("render", "triangle.off", option, f"no/where/{name}", status=1,
                             says=[option, f"no/where/{name}", "folder"])  # fmt: skip

    def test_a_folder_instead_of_a_file(self):
        (self.folder / "out.png").mkdir()
        self.before = self.names()
        for option, place in (("--png", "out.png"), ("--report", "out.png/")):
            self.refused("render", "triangle.off", option, place, status=1,
                         says=[f"{option} {place}", "folder"])  # fmt: skip

    def test_a_device(self):
        self.refused("render", "triangle.off", "--report", "/dev/null", status=1,
                     says=["/dev/null", "regular"])  # fmt: skip
        self.assertTrue(pathlib.Path("/dev/null").is_char_device())

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_no_permission(self):
        (self.folder / "shut").mkdir(mode=0o555)
        self.before = self.names()
        self.refused("render", "triangle.off", "--png", "shut/a.png", status=1,
                     says=["shut/a.png", "Permission denied"])  # fmt: skip

    def test_disk_full(self):
        # A limit on the size of files has the effect of a full disk on a writer. Each kind of file
        # is tried alone and after another one that was complete.
        full = ["/bin/bash", "-c", 'ulimit -f "$0" && exec "$@"']
        look = [*LOOK, "--size", "300x300"]
        layers = ["--layers", "depth,normal,position"]
        for limit, outputs, fails in (
            (4, [*layers, "--exr", "a.exr"], "a.exr"),
            (0, ["--png", "a.png"], "a.png"),
            (8, [*layers, "--png", "a.png", "--exr", "a.exr", "--report", "a.json"], "a.exr"),
        ):
            with self.subTest(outputs=outputs):
                self.refused("render", "triangle.off", *look, *outputs, status=1, says=fails,
                             wrapper=[*full, str(limit)])  # fmt: skip

    def test_standard_output_full(self):
        """Printed output is the result: if it is lost, the run has failed."""
        cave = ["cave", "--size", "4x4x4", "-o", "a.vti"]
        for words in (["--help"], ["--version"], ["stages"], cave):
            for place in ("/dev/full", "&-"):
                with self.subTest(words=words, place=place):
                    done = self.relievo(
                        *words, status=1, wrapper=["/bin/bash", "-c", f'exec "$0" "$@" >{place}']
                    )
                    self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                    self.assertIn("the standard output cannot be written", done.stderr)

    def test_a_failed_run_keeps_the_old_files(self):
        for name in ("a.png", "a.exr", "a.json"):
            (self.folder / name).write_text("precious")
        self.before = self.names()
        self.refused("render", "triangle.off", *OUTPUTS, "--layers", "none", status=2, says="none")
        for name in ("a.png", "a.exr", "a.json"):
            self.assertEqual((self.folder / name).read_text(), "precious")

    def test_a_place_that_is_lost_meanwhile(self):
        """The second file's place becomes a folder while the first is being written."""
        try:
            from relievo.vtkRelievoScene import vtkRelievoScene
            from vtkmodules.vtkCommonCore import vtkStringArray
        except ImportError as error:  # a build without Python
            self.skipTest(str(error))
        (self.folder / "a.png").write_text("precious")
        before, scene, words = self.names(), vtkRelievoScene(), vtkStringArray()
        for word in (self.folder / "triangle.off", *LOOK, "--size", "64x64",
                     "--png", self.folder / "a.png", "--exr", self.folder / "a.exr"):  # fmt: skip
            words.InsertNextValue(str(word))

        def take_its_place(*_):
            if scene.GetProgressText().startswith("writing"):
                (self.folder / "a.exr").mkdir(exist_ok=True)

        scene.AddObserver("ProgressEvent", take_its_place)
        scene.AddObserver("ErrorEvent", lambda *_: None)
        self.assertTrue(scene.SetWords(words))
        self.assertFalse(scene.Write())
        self.assertIn("a.exr", scene.GetFailureText())
        self.assertEqual((self.folder / "a.png").read_text(), "precious")
        self.assertEqual(self.names(), sorted([*before, "a.exr"]))

    def test_long_names(self):
        """Whatever is a file's name here can be that of an output."""
        longest = os.pathconf(self.folder, "PC_NAME_MAX")
        for length in (longest - 1, longest):
            outputs = [(option, "a" * (length - 4) + end) for option, end in
                       (("--png", ".png"), ("--exr", ".exr"), ("--report", ".txt"))]  # fmt: skip
            self.render("--size", "8x8", *(word for each in outputs for word in each))
            for _, name in outputs:
                (self.folder / name).unlink()
        self.assertEqual(self.names(), self.before)
        self.refused("render", "triangle.off", "--png", "a" * (longest - 3) + ".png", status=1,
                     says=["--png", "too long"])  # fmt: skip

    def ended_by(self, number, wanted, old):
        """Whether a run was ended by a signal that came when there were so many files more than
        before. Every file is the old one or the new one, all of them alike, and no other is left;
        there may have been none."""
        names = ["a.png", "a.exr", "a.json"]
        for name in names:
            (self.folder / name).unlink(missing_ok=True)
            if old:
                (self.folder / name).write_text("precious")
        before = self.names()
        words = ["render", "triangle.off", *LOOK, "--size", "500x500", *OUTPUTS,
                 "--layers", "depth,normal,position,cell"]  # fmt: skip
        run = subprocess.Popen(["/bin/sh", "-c", 'ulimit -c 0; exec "$0" "$@"', RELIEVO, *words],
                               cwd=self.folder, stderr=subprocess.DEVNULL)  # fmt: skip
        while run.poll() is None and len(self.names()) < len(before) + number:
            time.sleep(0.001)
        run.send_signal(wanted)
        status = run.wait(timeout=600)
        self.assertIn(status, (0, -wanted))
        new = [name for name in names if (self.folder / name).exists()
               and (self.folder / name).read_bytes() != b"precious"]  # fmt: skip
        self.assertIn(new, ([], names))
        self.assertEqual(self.names(), sorted({*before, *new}))
        self.assertTrue(status != 0 or new)
        return status != 0

    def test_signals(self):
        """At the start, when the first file is there, while the EXR file, which has another name
        besides, is written. A run that was faster than the signal is run again."""
        signals = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGPIPE, signal.SIGQUIT,
                   signal.SIGXCPU, signal.SIGALRM)  # fmt: skip
        for i, wanted in enumerate(signals * 2):
            number, old = (0, 1, 4)[i % 3], i % 2 == 0
            with self.subTest(signal=wanted, files=number, old=old):
                self.assertTrue(any(self.ended_by(number, wanted, old) for _ in range(20)))

    def test_signals_that_are_ignored(self):
        """As nohup has it."""
        words = ["render", "triangle.off", *LOOK, "--size", "500x500", "--exr", "a.exr"]
        run = subprocess.Popen(["/bin/sh", "-c", 'trap "" HUP; exec "$0" "$@"', RELIEVO, *words],
                               cwd=self.folder)  # fmt: skip
        while run.poll() is None and self.names() == self.before:
            time.sleep(0.001)
        run.send_signal(signal.SIGHUP)
        self.assertEqual(run.wait(timeout=600), 0)
        self.assertEqual(self.names(), sorted([*self.before, "a.exr"]))


class Display(CliTest):
    def test_no_display(self):
        for name in ("", ":7654", "nowhere:0"):
            with self.subTest(display=name):
                if NEEDS_DISPLAY:
                    self.refused("render", "triangle.off", *OUTPUTS, status=1,
                                 says=["DISPLAY", f"'{name}'", "xvfb-run"],
                                 environment={"DISPLAY": name}, whole=True)  # fmt: skip
                    continue
                self.relievo("render", "triangle.off", *OUTPUTS, whole=True)
                with_display = (self.folder / "a.png").read_bytes()
                done = self.relievo(
                    "render", "triangle.off", *OUTPUTS, environment={"DISPLAY": name}, whole=True
                )
                self.assertEqual(done.stderr, "")
                self.assertEqual((self.folder / "a.png").read_bytes(), with_display)

    @unittest.skipIf(NEEDS_DISPLAY, "VTK before 9.4 opens one kind of window")
    @unittest.skipIf(ctypes.util.find_library("OSMesa"), "this machine has OSMesa")
    def test_no_opengl(self):
        # The window class that VTK uses if neither X nor EGL works, and one that crashes without
        # its library.
        only = {"VTK_DEFAULT_OPENGL_WINDOW": "vtkOSOpenGLRenderWindow"}
        self.refused("render", "triangle.off", *OUTPUTS, status=1, says=["no OpenGL", "driver"],
                     environment=only, whole=True)  # fmt: skip

    def test_several_runs_on_one_server(self):
        # An X server without -noreset restarts when its last client leaves, and does not respond
        # meanwhile, so that a run may meet the end of the previous one.
        read, write = os.pipe()
        server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "640x480x24", "+extension", "GLX"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )  # fmt: skip
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        os.close(write)
        with os.fdopen(read) as number:
            display = ":" + number.readline().strip()
        for i in range(5):
            self.render("--size", "8x8", "--png", f"{i}.png", environment={"DISPLAY": display},
                        whole=True)  # fmt: skip


class Progress(CliTest):
    def test_on_a_terminal_only(self):
        words = ["render", "triangle.off", *LOOK, "--size", "64x64", "--exr", "a.exr"]
        self.assertEqual(self.relievo(*words, whole=True).stderr, "")
        try:
            ours, theirs = pty.openpty()
        except OSError as error:  # a bare container has no /dev/pts
            self.skipTest(f"no pseudo-terminal: {error}")
        run = subprocess.Popen([RELIEVO, *words], cwd=self.folder, stderr=theirs)
        os.close(theirs)
        said = b""
        try:
            while piece := os.read(ours, 4096):
                said += piece
        except OSError:  # how Linux says that the other end of a terminal is closed
            pass
        os.close(ours)
        self.assertEqual(run.wait(timeout=600), 0)
        for step in (b"reading triangle.off", b"rendering 64x64", b"writing a.exr"):
            self.assertIn(b"relievo: " + step + b" 0 %", said)
        self.assertTrue(said.endswith(b"\r\x1b[K"), "the line is not cleared at the end")


if __name__ == "__main__":
    main()
