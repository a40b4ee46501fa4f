# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes as people bring them: OBJ files with their libraries, colours of points in every format,
skeletons without a mesh."""

import json
import os

import numpy
from vtkmodules.vtkIOImage import vtkPNGWriter

from cli import CliTest, main, read_png, write_image

SIDE = 100
# Straight down on -1 to 1: each pixel shows its own x and y.
LOOK = ["--camera", "0,0,5,0,0,0,0,1,0", "--clip", "1,10", "--parallel-scale", "1",
        "--size", f"{SIDE}x{SIDE}"]  # fmt: skip
LEFT = "v -1 -1 0\nv 0 -1 0\nv 0 1 0\nv -1 1 0\n"
RIGHT = "v 1 -1 0\nv 1 1 0\n"
# Red at the left, blue at the right.
CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))
COLORS = ((1, 0, 0), (0, 0, 1), (0, 0, 1), (1, 0, 0))

COLLADA = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1" name="meter"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">{points}</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="c"><float_array id="ca" count="12">{colors}</float_array><technique_common>
<accessor source="#ca" count="4" stride="3"><param name="R" type="float"/>
<param name="G" type="float"/><param name="B" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="2"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="COLOR" source="#c" offset="0"/><p>0 1 2 0 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""
BVH = """HIERARCHY
ROOT hip
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT knee
  {
    OFFSET 0.6 0 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 0.6 0
    }
  }
}
MOTION
Frames: 1
Frame Time: 0.04
0 0 0 0 0 0 0 0 0
"""


class OBJ(CliTest):
    def write(self, name, text):
        data = text.encode() if isinstance(text, str) else text
        (self.folder / name).write_bytes(data)

    def draw(self, name="a.obj", layers="cell", says=(), **more):
        """The layers, after comparing the messages with the texts."""
        done = self.relievo("render", name, *LOOK, "--png", "a.png", "--exr", "a.exr",
                            "--layers", layers, **more)  # fmt: skip
        said = done.stderr.splitlines()
        self.assertEqual(len(said), len(says), done.stderr)
        for line, texts in zip(said, says):
            for text in texts:
                self.assertIn(text, line)
        return self.exr("a.exr")[1]

    def test_normals_of_some(self):
        """The half without normals is drawn, and lit."""
        self.write("a.obj", LEFT + RIGHT + "vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 2 5 6 3\n")
        cells = self.draw()["cell.id"]
        numpy.testing.assert_array_equal(cells[:, 0], 0)
        numpy.testing.assert_array_equal(cells[:, -1], 1)
        self.assertEqual(read_png(self.folder / "a.png").min(), 255)

    def test_wrong_points(self):
        """Their faces are left out, and the others keep their numbers."""
        text = LEFT + RIGHT + "v 1,5 0 0\nf 7 1 2\nf 1 2 3 4\nf 7 1 3\nf 2 5 6 3\n"
        self.write("a.obj", text)
        says = [("a.obj: left out 1 point", "(line 7)", "2 cells")]
        ids = self.draw(layers="vtkOriginalCellIds", says=says)["vtkOriginalCellIds.V"]
        numpy.testing.assert_array_equal(ids[:, 0], 1)
        numpy.testing.assert_array_equal(ids[:, -1], 3)

    def test_refused(self):
        for name, text, says in (
            ("index.obj", LEFT + "f 1 2 9\n", ["line 5", "from 1 to 4", "not 9"]),
            ("wide.obj", LEFT.encode("utf-16"), ["UTF-16"]),
        ):
            self.write(name, text)
            self.before = self.names()
            self.refused("render", name, "--png", "b.png", status=1, says=[name, *says])

    def test_materials(self):
        """Colours by the names of faces, without one before any name and behind an empty one."""
        bands = "".join(f"v {x} {y} 0\n" for x in (-1, -0.5, 0, 0.5, 1) for y in (-1, 1))
        faces = [f"f {i} {i + 2} {i + 3} {i + 1}\n" for i in (1, 3, 5, 7)]
        for mark, end in (("", "\n"), ("\ufeff", "\r\n"), ("", "\r")):
            self.write("m.mtl", f"{mark}newmtl red # bright{end}Kd 1 0 0{end}"
                       f"newmtl two words{end}Kd 0 0 1{end}")  # fmt: skip
            text = mark + "mtllib m.mtl # colours\n" + bands + faces[0] + "usemtl red\t# first\n"
            text += faces[1] + "usemtl two words\n" + faces[2] + "usemtl\n" + faces[3]
            self.write("a.obj", text.replace("\n", end))
            seen = self.draw(layers="albedo,actor")
            for x, color, actor in ((10, (1, 1, 1), 0), (40, (1, 0, 0), 1), (60, (0, 0, 1), 2),
                                    (90, (1, 1, 1), 0)):  # fmt: skip
                found = [seen["albedo." + name][50, x] for name in "RGB"]
                self.assertEqual((tuple(found), seen["actor.id"][50, x]), (color, actor))

    def test_names_of_other_systems(self):
        """Slashes of either kind, quotes, and paths of the machine that wrote the file: missing
        files are looked for beside the file that names them."""
        write_image(vtkPNGWriter(), self.folder / "green.png",
                    numpy.tile(numpy.array([0, 255, 0], numpy.uint8), (8, 8, 1)))  # fmt: skip
        (self.folder / "sub").mkdir()
        places = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
        for library in ("m.mtl", "sub\\m.mtl", '"a b.mtl"', "C:\\made\\m.mtl", "/gone/m.mtl"):
            for image in ("green.png", "..\\green.png", '"green.png"', "D:\\maps\\green.png",
                          "/gone/green.png"):  # fmt: skip
                is_below = library.startswith("sub")
                if is_below != image.startswith(".."):
                    continue
                name = library.strip('"').replace("\\", "/")
                name = name if is_below else name.split("/")[-1]
                self.write(name, f"newmtl a\nKd 1 1 1\nmap_Kd {image}\n")
                self.write("a.obj", f"mtllib {library}\n" + LEFT + places
                           + "usemtl a\nf 1/1 2/2 3/3 4/4\n")  # fmt: skip
                with self.subTest(library=library, image=image):
                    seen = self.draw(layers="albedo")
                    found = [seen["albedo." + letter][50, 25] for letter in "RGB"]
                    self.assertEqual(found, [0, 1, 0])

    def test_named_files(self):
        """Missing or endless files are named, and the mesh is drawn without them."""
        os.mkfifo(self.folder / "pipe.png")
        os.mkfifo(self.folder / "pipe.mtl")
        os.symlink("/dev/zero", self.folder / "zero.png")
        (self.folder / "folder.mtl").mkdir()
        face = LEFT + RIGHT + "vt 0 0\nvt 1 1\nusemtl a\nf 1/1 5/2 6/2 4/1\n"
        for name, *says in (("pipe.mtl", "it is a pipe"), ("gone.mtl", "No such file"),
                            ("folder.mtl", "it is a folder"), ("/dev/zero", "outside the folder")):
            self.write("a.obj", f"mtllib {name}\n" + face)
            self.draw(says=[("a.obj: drawn without the materials of " + name, *says)])
        for name, *says in (("pipe.png", "it is a pipe"), ("zero.png", "outside the folder"),
                            ("gone.png", "No such file")):  # fmt: skip
            self.write("m.mtl", f"newmtl a\nmap_Kd {name}\n")
            self.write("a.obj", "mtllib m.mtl\n" + face)
            self.draw(says=[("a.obj: drawn without a texture", name, *says)])
        self.write("a.obj", "mtllib gone.mtl m.mtl\n" + face)
        self.write("m.mtl", "newmtl a\nKd 0 1 0\n")
        seen = self.draw(layers="albedo", says=[("materials of gone.mtl: No such file",)])
        self.assertEqual(seen["albedo.R"].max(), 0)

    def test_pipes(self):
        """Pipes are not opened by any reader, so none waits for a writer."""
        for name in ("a.obj", "a.off", "a.ply", "a.stl", "a.vtp", "a.dae", "a.gltf", "a.png"):
            os.mkfifo(self.folder / name)
        self.before = self.names()
        for name in self.before:
            if name.startswith("a.") and name != "a.png":
                self.refused("render", name, "--png", "b.png", status=1,
                             says=[name, "it is a pipe"])  # fmt: skip
        for option in ("--normal-map", "--height-map", "--environment"):
            self.refused("render", "triangle.off", option, "a.png", "--png", "b.png", status=1,
                         says=["a.png", "it is a pipe"])  # fmt: skip

    def test_half_textured(self):
        """Of two materials the one with coordinates has its texture, the other its colour."""
        halves = numpy.zeros((8, 8, 3), numpy.uint8)
        halves[4:, :, 1] = 255  # the upper half is green
        write_image(vtkPNGWriter(), self.folder / "halves.png", halves)
        self.write("m.mtl", "newmtl a\nKd 1 1 1\nmap_Kd halves.png\nnewmtl b\nKd 0 0 1\n")
        self.write("a.obj", "mtllib m.mtl\n" + LEFT + RIGHT + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                   "usemtl a\nf 1/1 2/2 3/3 4/4\nusemtl b\nf 2 5 6 3\n")  # fmt: skip
        seen = self.draw(layers="albedo")
        self.assertEqual([seen["albedo.G"][y, 25] for y in (10, 90)], [1, 0])
        self.assertEqual([seen["albedo." + name][10, 75] for name in "RGB"], [0, 0, 1])


class Colors(CliTest):
    def check(self, name, text):
        """The picture's colours go from red to blue as those of the points do."""
        (self.folder / name).write_text(text)
        done = self.relievo("render", name, *LOOK, "--png", "a.png", "--exr", "a.exr",
                            "--layers", "albedo,depth")  # fmt: skip
        self.assertEqual(done.stderr, "")
        seen = self.exr("a.exr")[1]
        self.assertTrue(numpy.isfinite(seen["depth.Z"]).all())
        share = (numpy.arange(SIDE) + 0.5) / SIDE
        numpy.testing.assert_allclose(seen["albedo.R"], numpy.tile(1 - share, (SIDE, 1)), atol=0.01)
        numpy.testing.assert_allclose(seen["albedo.G"], 0, atol=0.01)
        numpy.testing.assert_allclose(seen["albedo.B"], numpy.tile(share, (SIDE, 1)), atol=0.01)
        picture = read_png(self.folder / "a.png")[50, :, :3] / 255.0
        numpy.testing.assert_allclose(picture[:, 0], 1 - share, atol=0.02)

    def test_obj(self):
        for whole in (1, 255):
            text = "".join("v {} {} 0 {} {} {}\n".format(*place, *(whole * c for c in color))
                           for place, color in zip(CORNERS, COLORS))  # fmt: skip
            self.check("a.obj", text + "f 1 2 3 4\n")

    def test_ply(self):
        for kind, whole in (("uchar", 255), ("ushort", 65535), ("float", 1), ("double", 1.0)):
            head = "ply\nformat ascii 1.0\nelement vertex 4\n"
            head += "".join(f"property float {axis}\n" for axis in "xyz")
            head += "".join(f"property {kind} {name}\n" for name in ("red", "green", "blue"))
            head += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            body = "".join("{} {} 0 {} {} {}\n".format(*place, *(whole * c for c in color))
                           for place, color in zip(CORNERS, COLORS))  # fmt: skip
            self.check("a.ply", head + body + "4 0 1 2 3\n")

    def test_collada(self):
        points = " ".join(f"{x} {y} 0" for x, y in CORNERS)
        colors = " ".join(" ".join(map(str, color)) for color in COLORS)
        self.check("a.dae", COLLADA.format(points=points, colors=colors))

    def test_x(self):
        # Its z points away from the viewer.
        places = ",".join(f"{x};{y};0;" for x, y in CORNERS)
        colors = ",".join("{};{};{};{};1;;".format(i, *color) for i, color in enumerate(COLORS))
        self.check("a.x", "xof 0303txt 0032\nMesh a {\n4;\n" + places + ";\n2;\n"
                   "3;0;2;1;,3;0;3;2;;\nMeshVertexColors {\n4;\n" + colors
                   + ";\n}\n}\n")  # fmt: skip


class TexturedPLY(CliTest):
    def write(self, comments, coordinates="property float s\nproperty float t\n"):
        head = "ply\nformat ascii 1.0\n" + comments + "element vertex 4\n"
        head += "".join(f"property float {axis}\n" for axis in "xyz")
        head += "".join(f"property uchar {name}\n" for name in ("red", "green", "blue"))
        head += coordinates
        head += "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        body = "".join("{} {} 0 0 0 255 {}\n".format(
            *place, "{} {}".format(*((c + 1) / 2 for c in place)) if coordinates else "")
            for place in CORNERS)  # fmt: skip
        (self.folder / "a.ply").write_text(head + body + "4 0 1 2 3\n")

    def draw(self, says, *words):
        done = self.relievo("render", "a.ply", *LOOK, *words, "--exr", "a.exr", "--layers",
                            "albedo")  # fmt: skip
        self.assertEqual(len(done.stderr.splitlines()), len(says), done.stderr)
        for text in says:
            self.assertIn(text, done.stderr)
        seen = self.exr("a.exr")[1]
        return numpy.stack([seen["albedo." + letter] for letter in "RGB"], axis=-1)

    def test_texture(self):
        """The comment's picture, its first row uppermost, in place of the points' colours."""
        (self.folder / "below").mkdir()
        rows = numpy.zeros((8, 8, 3), numpy.uint8)
        rows[:4] = (255, 0, 0)  # the lower half, as VTK counts rows
        rows[4:] = (0, 255, 0)
        for name in ("below/two halves.png", "halves.png"):
            write_image(vtkPNGWriter(), self.folder / name, rows)
        for name in ("below/two halves.png", "C:\\scans\\halves.png"):
            self.write(f"comment VCGLIB generated\ncomment TextureFile {name}\n")
            seen = self.draw([])
            numpy.testing.assert_allclose(seen[25, 50], (0, 1, 0), atol=0.01)
            numpy.testing.assert_allclose(seen[75, 50], (1, 0, 0), atol=0.01)
        for comments, coordinates, says in (
            ("comment TextureFile none.png\n", True, "drawn without a texture: none.png"),
            ("comment TextureFile /etc/halves.jpg\n", True, "drawn without a texture: "),
            ("comment TextureFile halves.png\n", False,
             "drawn without halves.png, for want of texture coordinates"),
            ("comment TextureFile halves.png\ncomment TextureFile b.png\n", True,
             "drawn without its 2 textures, expected one"),
        ):
            self.write(comments, *([] if coordinates else [""]))
            numpy.testing.assert_allclose(self.draw([says])[50, 50], (0, 0, 1), atol=0.01)


class Clouds(CliTest):
    """Points without cells, of every format that can hold them."""

    # In the middle of pixels.
    PLACES = numpy.array([(-0.49, 0.49, 0), (0.51, 0.39, 0.2), (0.11, -0.31, -0.1)])
    COLORS = numpy.array([(255, 0, 0), (0, 255, 0), (0, 0, 255)])

    def check(self, name):
        done = self.relievo("render", name, *LOOK, "--exr", "a.exr",
                            "--layers", "albedo,depth,cell")  # fmt: skip
        self.assertEqual(done.stderr, "")
        seen = self.exr("a.exr")[1]
        wanted = numpy.full((SIDE, SIDE), numpy.inf)
        for i, (place, color) in enumerate(zip(self.PLACES, self.COLORS)):
            at = int((1 - place[1]) * SIDE / 2), int((place[0] + 1) * SIDE / 2)
            wanted[at] = 5 - place[2]
            self.assertEqual(seen["cell.id"][at], i)
            numpy.testing.assert_allclose(
                [seen["albedo." + letter][at] for letter in "RGB"], color / 255, atol=0.005)
        numpy.testing.assert_allclose(seen["depth.Z"], wanted, atol=1e-5)

    def test_ply(self):
        head = "ply\nformat ascii 1.0\nelement vertex 3\n"
        head += "".join(f"property double {axis}\n" for axis in "xyz")
        head += "".join(f"property uchar {name}\n" for name in ("red", "green", "blue"))
        head += "property float scalar_Intensity\nend_header\n"
        rows = "".join("{} {} {} {} {} {} 0.5\n".format(*place, *color)
                       for place, color in zip(self.PLACES, self.COLORS))  # fmt: skip
        (self.folder / "a.ply").write_text(head + rows)
        self.check("a.ply")

    def test_obj(self):
        rows = "".join("v {} {} {} {} {} {}\n".format(*place, *(color / 255))
                       for place, color in zip(self.PLACES, self.COLORS))  # fmt: skip
        (self.folder / "a.obj").write_text(rows)
        self.check("a.obj")

    def test_points_that_are_not_finite(self):
        """The others are drawn, with a note; with none left the file is refused."""
        text = "v nan 0 0\nv 0.3 0.1 0\nv 1 1,5 0\nv 0 0.1 0\n"
        (self.folder / "a.obj").write_text(text)
        done = self.relievo("render", "a.obj", *LOOK, "--exr", "a.exr")
        self.assertIn("a.obj: left out 2 points", done.stderr)
        self.assertEqual(numpy.isfinite(self.exr("a.exr")[1]["depth.Z"]).sum(), 2)
        head = "ply\nformat ascii 1.0\nelement vertex 3\n"
        head += "".join(f"property float {axis}\n" for axis in "xyz") + "end_header\n"
        (self.folder / "a.ply").write_text(head + "nan nan nan\n0.3 0.1 0\n0 0.1 0\n")
        done = self.relievo("render", "a.ply", *LOOK, "--exr", "a.exr")
        self.assertIn("a.ply: left out 1 cell with points that are not finite", done.stderr)
        self.assertEqual(numpy.isfinite(self.exr("a.exr")[1]["depth.Z"]).sum(), 2)
        (self.folder / "b.obj").write_text("v nan 0 0\nv 1 0\n")
        self.before = self.names()
        self.refused("render", "b.obj", *LOOK, "--png", "a.png", status=1,
                     says=["b.obj: contains nothing", "left out 2 points"])  # fmt: skip

    def test_vtk(self):
        for what in ("POLYDATA", "UNSTRUCTURED_GRID"):
            text = f"# vtk DataFile Version 3.0\na\nASCII\nDATASET {what}\nPOINTS 3 double\n"
            text += " ".join(map(str, self.PLACES.ravel()))
            text += "\nPOINT_DATA 3\nCOLOR_SCALARS c 3\n"
            text += " ".join(map(str, (self.COLORS / 255).ravel())) + "\n"
            (self.folder / "a.vtk").write_text(text)
            with self.subTest(what=what):
                self.check("a.vtk")

    def test_what_is_left_out(self):
        """If nothing is left, the message gives the reason."""
        (self.folder / "flat.obj").write_text("v 0 0\nv 1 0\nv 1 1\nf 1 2 3\n")
        self.before = self.names()
        self.refused("render", "flat.obj", *LOOK, "--png", "a.png", status=1,
                     says=["flat.obj: contains no", "left out 3 points", "line 1"])  # fmt: skip


class FlatScenes(CliTest):
    def test_fitted_camera(self):
        """Sees the flat side of a square, wherever it lies, its corner of another colour where it
        belongs: from above, from the right, else from the front."""
        for up, flat, right, above in (
            ("y", 1, 0, -2), ("y", 0, -2, 1), ("y", 2, 0, 1), ("z", 2, 0, 1), ("z", 0, 1, 2),
            ("z", 1, 0, 2), ("x", 0, -1, -2), ("x", 1, 2, 0),
        ):  # fmt: skip
            places = []
            for x, y in CORNERS:
                place = numpy.zeros(3)
                for axis, value in ((right, x), (above, y)):
                    place[abs(axis)] = -value if axis < 0 else value
                places.append(place)
            text = "".join("v {} {} {} {}\n".format(*place, "0 1 0" if i == 2 else "1 0 0")
                           for i, place in enumerate(places))  # fmt: skip
            (self.folder / "a.obj").write_text(text + "f 1 2 3 4\n")
            done = self.relievo("render", "a.obj", "--up", up, "--size", "101x101", "--png",
                                "a.png", "--exr", "a.exr", "--layers", "depth,albedo")  # fmt: skip
            with self.subTest(up=up, flat=flat):
                self.assertEqual(done.stderr, "")
                seen = self.exr("a.exr")[1]
                rows, columns = numpy.nonzero(numpy.isfinite(seen["depth.Z"]))
                self.assertGreater(len(rows), 2000)
                self.assertEqual(numpy.ptp(rows), numpy.ptp(columns))
                self.assertGreater(seen["albedo.G"][rows.min() + 1, columns.max() - 1], 0.9)
                self.assertLess(seen["albedo.G"][rows.max() - 1, columns.min() + 1], 0.1)


    def test_empty_pictures(self):
        """A note about an empty picture: of a wall from behind, which glTF leaves out, and of black
        on black; none if the picture or a given camera shows something."""
        corners = numpy.array([(x, y, 0) for x, y in CORNERS], "<f4")
        for faces, seen in (([0, 1, 2, 0, 2, 3], True), ([0, 2, 1, 0, 3, 2], False)):
            data = corners.tobytes() + numpy.array(faces, "<u2").tobytes()
            (self.folder / "a.bin").write_bytes(data)
            (self.folder / "a.gltf").write_text(json.dumps({
                "asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
                "buffers": [{"uri": "a.bin", "byteLength": len(data)}],
                "bufferViews": [{"buffer": 0, "byteLength": 48},
                                {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
                "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                               "min": [-1, -1, 0], "max": [1, 1, 0]},
                              {"bufferView": 1, "componentType": 5123, "count": 6,
                               "type": "SCALAR"}],
            }))  # fmt: skip
            done = self.relievo("render", "a.gltf", "--background", "navy,black", "--size", "50x50",
                                "--png", "a.png")  # fmt: skip
            self.assertEqual("shows only the background" in done.stderr, not seen, done.stderr)
            done = self.relievo("render", "a.gltf", *LOOK, "--png", "a.png")
            self.assertEqual("shows only the background" in done.stderr, not seen, done.stderr)
        done = self.relievo("render", "triangle.off", "--color", "black", "--png", "a.png")
        self.assertIn("a.png: shows only the background", done.stderr)

    def test_nothing_above_the_ground(self):
        """A word where the ground alone is seen: transparent as a whole, or without area."""
        small = ["--size", "40x30", "--preset", "studio", "--shadows", "off", "--stage",
                 "antialias:samples=1", "--png", "a.png"]  # fmt: skip
        nothing = "a.png: shows only the ground"
        cube = "".join(f"v {i & 1} {i >> 1 & 1} {i >> 2}\n" for i in range(8))
        cube += "usemtl glass\nf 1 2 4 3\nf 5 7 8 6\nusemtl rest\nf 1 5 6 2\nf 3 4 8 7\n"
        (self.folder / "a.obj").write_text("mtllib a.mtl\n" + cube)
        for text, says in (("Kd 1 0 0\n", []), ("d 0.0\n", ["'glass' is invisible", nothing]),
                           ("d 1\nTr 1\n", []),
                           ("Tr 1.0\n", ["in spite of Tr 1", "2 materials", "'glass'"])):
            library = "".join(f"newmtl {name}\n{text}" for name in ("glass", "rest"))
            (self.folder / "a.mtl").write_text(library)
            done = self.relievo("render", "a.obj", *small)
            for each in says:
                self.assertIn(each, done.stderr)
            self.assertEqual(nothing in done.stderr, nothing in says, done.stderr)
        (self.folder / "a.mtl").write_text("newmtl glass\nd 0\nnewmtl rest\nTr 1\n")
        done = self.relievo("render", "a.obj", *small)
        for each in ("'glass' is invisible", "in spite of Tr 1", "1 material 'rest'"):
            self.assertIn(each, done.stderr)
        self.assertNotIn(nothing, done.stderr)
        (self.folder / "b.obj").write_text(cube)
        self.assertIn(nothing, self.relievo("render", "b.obj", "--opacity", "0", *small).stderr)
        flat = "v 0 0 0\nv 1 1 1\nv 2 2 2\nv 0 1 0\nf 1 2 3\nf 2 2 4\nf 4 4 4\n"
        (self.folder / "c.obj").write_text(flat)
        self.assertIn(nothing, self.relievo("render", "c.obj", *small).stderr)
        (self.folder / "c.obj").write_text(flat + "f 1 2 4\n")
        self.assertNotIn(nothing, self.relievo("render", "c.obj", *small).stderr)

    def test_a_repeated_triangle(self):
        """It is read within a reader's processor time, with the normal of its plane, and so are
        many at an edge and at a point. Neighbouring surfaces keep their smooth normals."""
        ring = [(numpy.cos(a), numpy.sin(a)) for a in numpy.linspace(0, 6, 5000)]
        corners = "".join(f"v {x / 2} {y / 2} 0.1\n" for x, y in ring)
        fan = "".join(f"f 1 {i} {i + 1}\n" for i in range(2, 5001))
        book = "".join(f"f 2 3 {i}\n" for i in range(4, 3000))
        for text in ("v -1 -1 0\nv 1 -1 0\nv -1 1 0\n" + 3000 * "f 1 2 3\n",
                     "v 0 0 0.1\n" + corners + fan, "v 0 0 0.1\n" + corners + book):
            (self.folder / "a.obj").write_text(text)
            self.relievo("render", "a.obj", *LOOK, "--exr", "a.exr", "--layers", "normal")
            normal = self.exr("a.exr")[1]
            seen = normal["normal.Z"] != 0
            self.assertGreater(seen.sum(), 100)
            numpy.testing.assert_allclose(abs(normal["normal.Z"][seen]), 1, atol=1e-6)


class Skeletons(CliTest):
    def test_bvh(self):
        """Two bones, each a solid that the headlight lights where it is seen."""
        (self.folder / "a.bvh").write_text(BVH)
        done = self.relievo("render", "a.bvh", *LOOK, "--png", "a.png", "--exr", "a.exr",
                            "--layers", "depth,geometric_normal")  # fmt: skip
        self.assertEqual(done.stderr, "")
        shown = numpy.isfinite(self.exr("a.exr")[1]["depth.Z"])
        for x, y in ((0.3, 0), (0.6, 0.3)):  # along the bones
            column, row = int((x + 1) * SIDE / 2), int((1 - y) * SIDE / 2)
            self.assertTrue(shown[row - 3 : row + 4, column - 3 : column + 4].any())
        self.assertGreater(shown.sum(), 50)
        # By how far the side turns away.
        facing = self.exr("a.exr")[1]["geometric_normal.Z"]
        light = read_png(self.folder / "a.png")[..., 0] / 255.0
        seen = shown & (facing > 0.2)
        self.assertGreater(seen.sum(), 50)
        numpy.testing.assert_allclose(light[seen], facing[seen], atol=0.02)


if __name__ == "__main__":
    main()
