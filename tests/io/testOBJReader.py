# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkRelievoOBJReader: OBJ files written by hand; real meshes compared with VTK's reader."""

import locale
import os
import pathlib
import random
import tempfile
import time
import unittest

import numpy
import relievo
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkIOGeometry import vtkOBJReader

DATA = pathlib.Path(os.environ["RELIEVO_DATA"])
SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"


class OBJ(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.path = pathlib.Path(kept.name) / "mesh.obj"

    def read(self, content, refused=None, **settings):
        """The output; `refused`: texts that the one error must hold beside the file's name."""
        self.path.write_bytes(content.encode() if isinstance(content, str) else content)
        return self.read_path(self.path, refused, **settings)

    def read_path(self, path, refused=None, **settings):
        errors = []
        reader = self.reader = relievo.vtkRelievoOBJReader()

        def keep(_, __, text):
            errors.append(text)

        keep.CallDataType = "string0"
        reader.AddObserver("ErrorEvent", keep)
        reader.SetFileName(str(path))
        for name, value in settings.items():
            getattr(reader, "Set" + name)(value)
        reader.Update()
        self.notes = [reader.GetNote(i) for i in range(reader.GetNumberOfNotes())]
        mesh = reader.GetOutput()
        if refused is None:
            self.assertEqual(errors, [])
            self.assertEqual(reader.GetErrorCode(), 0)
            return mesh
        self.assertEqual(len(errors), 1, errors)
        for text in (str(path), *refused):
            self.assertIn(text, errors[0])
        self.assertNotEqual(reader.GetErrorCode(), 0)
        self.assertEqual((mesh.GetNumberOfPoints(), mesh.GetNumberOfCells()), (0, 0))

    def cells(self, mesh):
        """All cells in VTK's order, each a list of points."""
        found = []
        for cells in (mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys()):
            starts = vtk_to_numpy(cells.GetOffsetsArray())
            corners = vtk_to_numpy(cells.GetConnectivityArray())
            found += [list(corners[a:b]) for a, b in zip(starts, starts[1:])]
        return found

    def points(self, mesh):
        return vtk_to_numpy(mesh.GetPoints().GetData())

    def array(self, attributes, name):
        array = attributes.GetAbstractArray(name)
        self.assertIsNotNone(array, name)
        if array.IsA("vtkStringArray"):
            return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
        return vtk_to_numpy(array)

    def check(self, text, cells, count=4):
        mesh = self.read(text)
        self.assertEqual(self.cells(mesh), cells)
        self.assertEqual(mesh.GetNumberOfPoints(), count)
        return mesh

    # ------------------------------------------------------------------------
    def test_cells(self):
        """Vertices, lines and faces in VTK's order, with names of either sign."""
        self.check(SQUARE + "f 1 2 3 4\nl 1 3 2\np 4 1\nf -4 -3 -2\nl 2 4\nf 1 2\nf 3\np 2\n",
                   [[3, 0], [2], [1], [0, 2, 1], [1, 3], [0, 1], [0, 1, 2, 3],
                    [0, 1, 2]])  # fmt: skip

    def test_later_points(self):
        self.check("f 1 2 3\n" + SQUARE + "f 2 3 4\n", [[0, 1, 2], [1, 2, 3]])

    def test_lines_of_text(self):
        """Every end of a line, joined lines, comments, a mark, blanks, no end of the last line."""
        text = SQUARE + "f 1 2 3 # a face\n  f\t2 3 4\t#\n#f 1 2 4\nf 3 \\\n4 1\nf 4 1 2"
        cells = [[0, 1, 2], [1, 2, 3], [2, 3, 0], [3, 0, 1]]
        for end in ("\n", "\r\n", "\r"):
            for mark in ("", "\ufeff"):
                self.check(mark + text.replace("\n", end), cells)
        self.check(SQUARE + "f 1/\\\n", [[0]])  # a slash with nothing behind it
        self.check("v 0 0 0 " + 3000000 * " " + "\nv 1 0 0\nf" + 100000 * " 1 2" + "\n",
                   [100000 * [0, 1]], count=2)  # fmt: skip

    def test_numbers(self):
        text = "v 1e-1 +2 -3.25E+2\nv .5 5. +1E-400\nv 0.123456789012345 -0 +.5\nf 1 2 3\n"
        expected = [(0.1, 2, -325), (0.5, 5, 0), (0.123456789012345, 0, 0.5)]
        numpy.testing.assert_array_equal(self.points(self.read(text)), expected)
        single = self.read(text, OutputPointsPrecision=0).GetPoints()
        self.assertEqual(single.GetDataType(), VTK_FLOAT)
        numpy.testing.assert_array_equal(vtk_to_numpy(single.GetData()), numpy.float32(expected))

    def test_locale(self):
        for name in ("de_DE.UTF-8", "tr_TR.UTF-8", "de_DE.utf8"):
            try:
                before = locale.setlocale(locale.LC_ALL)
                locale.setlocale(locale.LC_ALL, name)
            except locale.Error:
                continue
            self.addCleanup(locale.setlocale, locale.LC_ALL, before)
            self.test_numbers()

    # ------------------------------------------------------------------------
    def test_normals_of_some(self):
        """Faces with and without normals beside each other: VTK's reader drops the latter."""
        mesh = self.check("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\nvn 0.6 0 0.8\n"
                          "f 1//1 2//1 3//1\nf 2 5 6 3\nf 1//1 3//1 4//1\n",
                          [[0, 1, 2], [6, 4, 5, 7], [0, 2, 3]], count=8)  # fmt: skip
        points, normals = self.points(mesh), self.array(mesh.GetPointData(), "Normals")
        numpy.testing.assert_array_equal(points[[6, 7]], points[[1, 2]])
        numpy.testing.assert_allclose(normals[:4], 4 * [(0.6, 0, 0.8)], rtol=1e-7)
        numpy.testing.assert_allclose(normals[4:], 4 * [(1, 0, 0)], atol=1e-7)
        self.assertIs(mesh.GetPointData().GetNormals(), mesh.GetPointData().GetArray("Normals"))

    def test_smoothing_groups(self):
        """The mean of the group's faces at the point, by area; a face of no group keeps its own."""
        roof = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 4 -2\nv 2 4 -2\nvn 0 0 1\n"
        faces = "f 1 2 3 4\ns {}\nf 4 3 6 5\n"
        given = "v 9 0 0\nv 9 1 0\nv 8 0 0\nf 7//1 8//1 9//1\n"
        flat, slope = numpy.array((0, 0, 4.0)), numpy.array((0, 4, 4.0))
        for group, shared in (("1", True), ("2", False), ("off", False)):
            mesh = self.read(roof + given + "s 1\n" + faces.format(group))
            normals, cells = self.array(mesh.GetPointData(), "Normals"), self.cells(mesh)
            at = [normals[cells[1][2]], normals[cells[2][1]]]  # of the point 3 in both faces
            for found, own in zip(at, (flat, slope)):
                mean = flat + slope if shared else own
                numpy.testing.assert_allclose(found, mean / numpy.linalg.norm(mean), atol=1e-6)
            self.assertEqual(mesh.GetNumberOfPoints(), 9 if shared else 11)

    def test_wrong_normals(self):
        mesh = self.read(SQUARE + "vn 0 0 0\nvn nan 0 1\nvn 0 1\nvn 0 0 -1\n"
                         "f 1//1 2//2 3//3 4//4\n")  # fmt: skip
        normals = self.array(mesh.GetPointData(), "Normals")
        numpy.testing.assert_array_equal(normals, 3 * [(0, 0, 1)] + [(0, 0, -1)])
        self.assertEqual(self.notes, ["read without 3 invalid normals (the first on line 5)"])

    def test_normals_of_lines(self):
        """A line has the normals of the faces at its points, or outward ones."""
        mesh = self.check(SQUARE + "v 0.5 0.5 3\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nl 1 5\np 5\n",
                          [[4], [0, 4], [0, 1, 2, 3]], count=5)  # fmt: skip
        normals = self.array(mesh.GetPointData(), "Normals")
        numpy.testing.assert_allclose(normals, 5 * [(0, 0, 1)], atol=1e-6)

    def test_texture_coordinates(self):
        """A point is split where its coordinates differ, and only there."""
        mesh = self.check(SQUARE + "vt 0 0\nvt 1 0.5 9\nvt 0.25\nvt no 1\n"
                          "f 1/1 2/2 3/3\nf 1/1 3/2 4/1\nf 1 2/4 4\nl 3/2 4/1\n",
                          [[4, 3], [0, 1, 2], [0, 4, 3], [5, 6, 7]], count=8)  # fmt: skip
        found = self.array(mesh.GetPointData(), "TextureCoordinates")
        numpy.testing.assert_array_equal(
            found,
            [(0, 0), (1, 0.5), (0.25, 0), (0, 0), (1, 0.5), (0, 0), (0, 0), (0, 0)],
        )
        self.assertIsNone(mesh.GetPointData().GetNormals())
        self.assertEqual(self.notes, ["read without 1 invalid texture coordinate (line 8)"])

    def test_both(self):
        """Corners with all four kinds of indices."""
        self.check(SQUARE + "vt 0 0\nvn 0 0 1\nvn 1 0 0\n"
                   "f 1/1/1 2/1/1 3/1/1\nf 1/1/2 -2/-1/-2 4//2\n",
                   [[0, 1, 2], [4, 2, 3]], count=5)  # fmt: skip

    # ------------------------------------------------------------------------
    def test_colors(self):
        for one, full in (("1", "1.0"), ("255", "255"), ("0.5", "1")):
            mesh = self.read(f"v 0 0 0 {one} 0 0\nv 1 0 0\nv 1 1 0 0 {full} nan\nv 0 1 0 0.5\n"
                             "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/1 4/1\n")  # fmt: skip
            red = 128 if one == "0.5" else 255
            white = (255, 255, 255, 255)
            numpy.testing.assert_array_equal(
                self.array(mesh.GetPointData(), "RGBA"),
                [(red, 0, 0, 255), white, (0, 255, 255, 255), white, (red, 0, 0, 255)],
            )
            self.assertEqual(mesh.GetPointData().GetScalars().GetName(), "RGBA")
        self.assertFalse(self.read(SQUARE + "f 1 2 3\n").GetPointData().HasArray("RGBA"))

    def test_materials(self):
        mesh = self.read("mtllib a.mtl b c.mtl \n" + SQUARE + "f 1 2 3\nusemtl red # bright\n"
                         "f 2 3 4\nl 1 2\nusemtl  two words\t\nf 3 4 1\nusemtl\nf 4 1 2\n"
                         "usemtl a#b\nusemtl red\nf 1 2 4\np 1\n")  # fmt: skip
        data = mesh.GetFieldData()
        self.assertEqual(self.array(data, "MaterialNames"), ["red", "two words", "a#b"])
        self.assertEqual(self.array(data, "MaterialLibraries"), ["a.mtl b c.mtl"])
        ids = self.array(mesh.GetCellData(), "MaterialIds")
        self.assertEqual(list(ids), [0, 0, -1, 0, 1, -1, 0])
        self.assertFalse(self.read(SQUARE + "f 1 2 3\n").GetCellData().HasArray("MaterialIds"))

    def test_groups(self):
        text = SQUARE + "f 1 2 3\ng left upper\nf 2 3 4\no box\nf 3 4 1\ng\nf 4 1 2\n"
        self.assertEqual(self.read(text).GetCellData().GetNumberOfArrays(), 0)
        mesh = self.read(text, Groups=True)
        self.assertEqual(self.array(mesh.GetFieldData(), "GroupNames"), ["left upper", ""])
        self.assertEqual(list(self.array(mesh.GetCellData(), "GroupIds")), [-1, 0, 0, 1])
        self.assertEqual(self.array(mesh.GetFieldData(), "ObjectNames"), ["box"])
        self.assertEqual(list(self.array(mesh.GetCellData(), "ObjectIds")), [-1, -1, 0, 0])

    def test_many_materials(self):
        """Each name is found at once, however many there are."""
        faces = "".join(f"usemtl m{i}\nf 1 2 3\n" for i in range(200000))
        self.path.write_text(SQUARE + faces)
        begin = time.process_time()
        mesh = self.read_path(self.path)
        self.assertLess(time.process_time() - begin, 1)
        ids = self.array(mesh.GetCellData(), "MaterialIds")
        numpy.testing.assert_array_equal(ids, numpy.arange(200000))

    # ------------------------------------------------------------------------
    def test_wrong_points(self):
        """Invalid points remove only their faces; the rest keeps its numbers."""
        faces = "l 1 5\nl 1 2\nf 1 2 3\nf 3 4 5\nf 5 1 2\nf 1 3 4\n"
        for invalid in ("inf 0 0", "nan 0 0", "0 -nan 0", "0 0 1,5", "abc 0 0", "0 0", "",
                      "1e999 0 0", "0 0x10 0", "1.0.0 0 0", "0 0 -inf"):  # fmt: skip
            with self.subTest(point=invalid):
                mesh = self.check(f"{SQUARE}v {invalid}\nv 9 9 9\n{faces}",
                                  [[0, 1], [0, 1, 2], [0, 2, 3]], count=6)  # fmt: skip
                ids = self.array(mesh.GetCellData(), "vtkOriginalCellIds")
                self.assertEqual(list(ids), [1, 2, 5])
                note = "left out 1 point with a coordinate that is no finite number (line 5) and "
                self.assertEqual(self.notes, [note + "the 3 cells of such points"])
                self.assertTrue(numpy.isfinite(self.points(mesh)).all())
        mesh = self.read("v x 0 0\nv 0 0 y\nf 1 2 1\n")
        self.assertEqual(mesh.GetNumberOfCells(), 0)
        self.assertIn("left out 2 points", self.notes[0])
        self.assertIn("(the first on line 1)", self.notes[0])

    def test_free_form(self):
        self.check(SQUARE + "f 1 2 3\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n",
                   [[0, 1, 2]])  # fmt: skip
        self.assertEqual(self.notes, ["left out 1 free-form curve or surface (line 8)"])

    def test_refusals(self):
        for text, *says in (
            (SQUARE + "f 1 2 5\n", "line 5:", "a point, from 1 to 4 or from -4 to -1, not 5"),
            (SQUARE + "\n#\nf 1 \\\n2 -5\n", "line 7:", "not -5"),
            (SQUARE + "f 1 2 9\nf 1 2 8\nv 1 2 3\n", "line 5:", "from 1 to 5", "not 9"),
            (SQUARE + "f 0 1 2\n", "line 5:", "not 0"),
            (SQUARE + "f 1/1 2/1 3/1\n", "line 5:", "a texture coordinate, and there is none"),
            (SQUARE + "f 1//1 2//1 3//1\n", "line 5:", "a normal, and there is none"),
            (SQUARE + "vt 0 0\nf 1/2 2/1 3/1\n", "line 6:", "a texture coordinate", "not 2"),
            (SQUARE + "f 1 two 3\n", "line 5:", "1/2/3, not 'two'"),
            (SQUARE + "f 1 2.5 3\n", "line 5:", "not '2.5'"),
            (SQUARE + "f 1 2 3,4\n", "line 5:", "not '3,4'"),
            (SQUARE + "f 1 2 99999999999999999999\n", "line 5:", "not '99999999999999999999'"),
            (SQUARE + "f\n", "line 5:", "there are none"),
            (SQUARE.encode("utf-16"), "UTF-16"),
            (SQUARE.encode("utf-16-le"), "UTF-16"),
            (SQUARE.encode("utf-16-be"), "UTF-16"),
        ):
            with self.subTest(text=text):
                self.read(text, refused=says)

    def test_no_file(self):
        folder = self.path.parent
        self.read_path(folder / "gone.obj", refused=["No such file"])
        self.read_path(folder, refused=["it is a folder"])
        os.mkfifo(folder / "pipe.obj")
        self.read_path(folder / "pipe.obj", refused=["it is a pipe"])
        self.read_path("/dev/zero", refused=["it is a device"])

    def test_empty(self):
        for text in ("", "\n", "# nothing\n", "words and words\n"):
            self.assertEqual(self.read(text).GetNumberOfPoints(), 0)

    # ------------------------------------------------------------------------
    def test_broken(self):
        """Broken bytes anywhere: read or refused, never an index out of range."""
        good = (SQUARE + "v 2 2 2 1 0 0\nvt 0 0\nvt 1 1\nvn 0 0 1\nusemtl a\ns 1\n"
                "f 1/1/1 2/2/1 3/1/1\ng x\nf 1 2 3\nl 1/2 3\np 4\n"
                "f -1//-1 -2//1 -3//1\n").encode()  # fmt: skip
        numbers, counts = random.Random(5), [0, 0]
        for _ in range(2000):
            text = bytearray(good)
            for _ in range(numbers.randint(1, 3)):
                place = numbers.randrange(len(text))
                change = numbers.randrange(3)
                if change == 0:
                    text[place] = numbers.randrange(256)
                elif change == 1:
                    del text[place : place + numbers.randint(1, 8)]
                else:
                    text[place:place] = good[place : place + numbers.randrange(8)]
            self.path.write_bytes(text)
            reader, errors = relievo.vtkRelievoOBJReader(), []
            reader.AddObserver("ErrorEvent", lambda *_, errors=errors: errors.append(1))
            reader.SetFileName(str(self.path))
            reader.Update()
            self.assertEqual(len(errors), reader.GetErrorCode() != 0)
            counts[len(errors)] += 1
            mesh = reader.GetOutput()
            for cell in self.cells(mesh):
                self.assertTrue(0 <= min(cell) <= max(cell) < mesh.GetNumberOfPoints())
            for data, count in ((mesh.GetPointData(), mesh.GetNumberOfPoints()),
                                (mesh.GetCellData(), mesh.GetNumberOfCells())):  # fmt: skip
                for i in range(data.GetNumberOfArrays()):
                    self.assertEqual(data.GetArray(i).GetNumberOfTuples(), count)
                    self.assertTrue(numpy.isfinite(vtk_to_numpy(data.GetArray(i))).all())
        self.assertGreater(min(counts), 200, counts)

    def test_real_meshes(self):
        """Those of OpenFOAM have no normals: VTK's reader has the same points and faces."""
        for name in ("motorBike.obj", "buildings.obj"):
            theirs = vtkOBJReader()
            theirs.SetFileName(str(DATA / name))
            theirs.Update()
            mesh = self.read_path(DATA / name)
            other = theirs.GetOutput()
            self.assertGreater(mesh.GetNumberOfPolys(), 300000)
            numpy.testing.assert_array_equal(self.points(mesh), self.points(other))
            for get in ("GetOffsetsArray", "GetConnectivityArray"):
                numpy.testing.assert_array_equal(
                    vtk_to_numpy(getattr(mesh.GetPolys(), get)()),
                    vtk_to_numpy(getattr(other.GetPolys(), get)()),
                )


if __name__ == "__main__":
    unittest.main(verbosity=2)
