# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkRelievoPLYReader: files that the test, or VTK's writer, makes of known numbers."""

import os
import pathlib
import random
import struct
import tempfile
import unittest

import numpy
import relievo
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYWriter

CODES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
         "float": "f", "double": "d"}  # fmt: skip
FORMATS = ("ascii", "binary_little_endian", "binary_big_endian")
SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]


def make(form, elements, end="\n"):
    """A file; an element is (name, properties, rows), a property (type, name), of lists
    ((type of the length, type), name)."""
    lines = ["ply", f"format {form} 1.0", "comment made by a test"]
    body = b""
    for name, properties, rows in elements:
        lines.append(f"element {name} {len(rows)}")
        for kind, word in properties:
            listed = isinstance(kind, tuple)
            lines.append(f"property {'list ' + ' '.join(kind) if listed else kind} {word}")
        for row in rows:
            for (kind, _), value in zip(properties, row):
                numbers = [(kind, value)]
                if isinstance(kind, tuple):
                    numbers = [(kind[0], len(value)), *((kind[1], each) for each in value)]
                for each, number in numbers:
                    if form == "ascii":
                        body += f"{number} ".encode()
                    else:
                        order = "<" if "little" in form else ">"
                        body += struct.pack(order + CODES[each], number)
            body += end.encode() if form == "ascii" else b""
    return end.join([*lines, "end_header", ""]).encode() + body


def vertices(extra=(), values=(), kind="float"):
    properties = [(kind, axis) for axis in "xyz"] + list(extra)
    return ("vertex", properties, [(*place, *more) for place, more
                                   in zip(SQUARE, values or len(SQUARE) * [()])])  # fmt: skip


def faces(rows, extra=(), name="vertex_indices", kinds=("uchar", "int")):
    return ("face", [(kinds, name), *extra], rows)


WHOLE = faces([([0, 1, 2, 3],)])


class PLY(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.path = pathlib.Path(kept.name) / "mesh.ply"

    def read(self, content=None, refused=None):
        if content is not None:
            self.path.write_bytes(content)
        errors = []
        reader = relievo.vtkRelievoPLYReader()

        def keep(_, __, text):
            errors.append(text)

        keep.CallDataType = "string0"
        reader.AddObserver("ErrorEvent", keep)
        reader.SetFileName(str(self.path))
        reader.Update()
        mesh = reader.GetOutput()
        if refused is None:
            self.assertEqual((errors, reader.GetErrorCode()), ([], 0))
            return mesh
        self.assertEqual(len(errors), 1, errors)
        for text in (str(self.path), *refused):
            self.assertIn(text, errors[0])
        self.assertNotEqual(reader.GetErrorCode(), 0)
        self.assertEqual((mesh.GetNumberOfPoints(), mesh.GetNumberOfCells()), (0, 0))
        return None

    def array(self, data, name):
        self.assertIsNotNone(data.GetArray(name), name)
        return vtk_to_numpy(data.GetArray(name))

    def corners(self, cells):
        return list(vtk_to_numpy(cells.GetConnectivityArray()))

    def test_formats(self):
        for form in FORMATS:
            for end in ("\n", "\r\n", "\r"):
                for kind, type_of_points in (("float", VTK_FLOAT), ("double", VTK_DOUBLE),
                                             ("short", VTK_FLOAT)):  # fmt: skip
                    mesh = self.read(make(form, [vertices(kind=kind), WHOLE], end))
                    points = mesh.GetPoints()
                    self.assertEqual(points.GetDataType(), type_of_points)
                    numpy.testing.assert_array_equal(vtk_to_numpy(points.GetData()), SQUARE)
                    self.assertEqual(self.corners(mesh.GetPolys()), [0, 1, 2, 3])

    def test_sizes_of_faces(self):
        """Of one size, or not, from any face on; as integers of every kind."""
        for sizes in ([3] * 6, [4] * 5, [3, 3, 3, 4, 3], [4, 3, 4], [3, 0, 3], [0, 0, 3], [0, 0],
                      [2, 2], [1, 3, 2, 4], [4, 4, 1]):  # fmt: skip
            rows = [([(i + k) % 4 for k in range(size)], i) for i, size in enumerate(sizes)]
            by_kind = [[row for row in rows if least <= len(row[0]) <= most]
                       for least, most in ((1, 1), (2, 2), (3, 4))]  # fmt: skip
            for form in FORMATS:
                for kinds in (("uchar", "int"), ("uint", "uint"), ("short", "uchar")):
                    element = faces(rows, [("short", "part")], kinds=kinds)
                    mesh = self.read(make(form, [vertices(), element]))
                    got = [mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys()]
                    for cells, expected in zip(got, by_kind):
                        starts = list(vtk_to_numpy(cells.GetOffsetsArray()))
                        ends = numpy.cumsum([0, *(len(row[0]) for row in expected)])
                        self.assertEqual(starts if cells.GetNumberOfCells() else [0], list(ends))
                        corners = [i for row in expected for i in row[0]]
                        self.assertEqual(self.corners(cells), corners)
                    parts = [row[1] for rows in by_kind for row in rows]
                    self.assertEqual(list(self.array(mesh.GetCellData(), "part")), parts)
        for form in FORMATS[1:]:
            for kind, invalid in (("int", -1), ("uint", 2**32 - 1), ("uint", 4), ("int", 4)):
                element = faces([([0, 1, 2],), ([0, 1, invalid],)], kinds=("uchar", kind))
                self.read(make(form, [vertices(), element]), refused=["face 1:", f"not {invalid}"])

    def test_vtk(self):
        """Files of VTK's writer."""
        source = vtkSphereSource()
        source.SetThetaResolution(50)
        source.Update()
        colors = numpy.random.default_rng(2).integers(
            0, 256, (source.GetOutput().GetNumberOfPoints(), 4), numpy.uint8
        )
        array = numpy_to_vtk(colors, deep=True)
        array.SetName("colors")
        source.GetOutput().GetPointData().AddArray(array)
        for binary in (True, False):
            writer = vtkPLYWriter()
            writer.SetFileName(str(self.path))
            writer.SetInputData(source.GetOutput())
            writer.SetFileType(2 if binary else 1)
            writer.SetArrayName("colors")
            writer.SetEnableAlpha(True)
            writer.Write()
            mesh = self.read()
            points = vtk_to_numpy(source.GetOutput().GetPoints().GetData())
            numpy.testing.assert_allclose(
                vtk_to_numpy(mesh.GetPoints().GetData()), points, atol=0 if binary else 1e-5
            )
            self.assertEqual(
                self.corners(mesh.GetPolys()), self.corners(source.GetOutput().GetPolys())
            )
            numpy.testing.assert_array_equal(self.array(mesh.GetPointData(), "RGBA"), colors)

    def test_strips(self):
        """Triangles whose outside is that of the strip's first; -1 begins anew, and corners that
        are twice there join strips."""
        rows = [([0, 1, 2, 3, -1, 3, 2, 2, 0],), ([1, 0],)]
        strips = ("tristrips", [(("int", "int"), "vertex_indices")], rows)
        for form in FORMATS:
            mesh = self.read(make(form, [vertices(), strips]))
            self.assertEqual(self.corners(mesh.GetPolys()), [0, 1, 2, 2, 1, 3])
        for invalid in (4, -2):
            rows[0][0][1] = invalid
            self.read(make("ascii", [vertices(), strips]),
                      refused=["tristrips 0", f"from 0 to 3, or -1, not {invalid}"])  # fmt: skip

    def test_edges(self):
        """Lines, where there are no faces."""
        edges = ("edge", [("int", "vertex1"), ("int", "vertex2"), ("uchar", "red"),
                          ("uchar", "green"), ("uchar", "blue")],
                 [(0, 1, 9, 8, 7), (3, 2, 6, 5, 4)])  # fmt: skip
        for form in FORMATS:
            mesh = self.read(make(form, [vertices(), edges]))
            self.assertEqual(self.corners(mesh.GetLines()), [0, 1, 3, 2])
            self.assertEqual(self.array(mesh.GetCellData(), "RGBA").tolist(),
                             [[9, 8, 7, 255], [6, 5, 4, 255]])  # fmt: skip
        mesh = self.read(make("ascii", [vertices(), WHOLE, edges]))
        self.assertEqual((mesh.GetNumberOfLines(), mesh.GetNumberOfPolys()), (0, 1))
        edges[2][1] = (3, 4, 0, 0, 0)
        self.read(make("ascii", [vertices(), edges]), refused=["edge 1", "from 0 to 3, not 4"])

    def test_colors(self):
        """White is white, in every type; VTK's reader takes floats for bytes."""
        shares = ((1, 0, 0), (0, 0.5, 1), (0.2, 1, 0.4), (0, 0, 0))
        for kind, whole in (("uchar", 255), ("ushort", 65535), ("uint", 2**32 - 1),
                            ("short", 32767), ("float", 1.0), ("double", 1.0)):  # fmt: skip
            values = [[each * whole if kind in ("float", "double") else round(each * whole)
                       for each in share] for share in shares]  # fmt: skip
            for before in ("", "diffuse_"):
                for alpha in (False, True):
                    names = ["red", "green", "blue"] + ["alpha"] * alpha
                    rows = [(*row, *[whole] * alpha) for row in values]
                    extra = [(kind, before + name) for name in names]
                    for form in FORMATS:
                        mesh = self.read(make(form, [vertices(extra, rows), WHOLE]))
                        colors = self.array(mesh.GetPointData(), "RGBA")
                        truth = numpy.round(255 * numpy.column_stack([shares, numpy.ones(4)]))
                        self.assertLessEqual(abs(colors - truth).max(), 0.5)
                        self.assertEqual(mesh.GetPointData().GetScalars().GetName(), "RGBA")

    def test_arrays(self):
        """Normals, texture coordinates, and whatever else there is, of vertices and of faces."""
        names = ["nx", "ny", "nz", "s", "t", "quality"]
        rows = [(0, 0, 1, i / 4, i / 8, i) for i in range(4)]
        extra = [("float", name) for name in names[:-1]] + [("ushort", "quality")]
        of_faces = [([0, 1, 2], 255, 0, 0, 7), ([3], 0, 255, 0, 8), ([1, 2], 0, 0, 255, 9),
                    ([], 1, 1, 1, 10)]  # fmt: skip
        colors = [("uchar", name) for name in ("red", "green", "blue")]
        for form in FORMATS:
            mesh = self.read(make(form, [
                ("camera", [("float", "view"), (("uchar", "float"), "more")], [(1, [2, 3])]),
                vertices(extra, rows),
                faces(of_faces, [*colors, ("int", "region")], "vertex_index"),
            ]))  # fmt: skip
            data = mesh.GetPointData()
            numpy.testing.assert_array_equal(vtk_to_numpy(data.GetNormals()), 4 * [(0, 0, 1)])
            numpy.testing.assert_array_equal(
                vtk_to_numpy(data.GetTCoords()), [row[3:5] for row in rows]
            )
            self.assertEqual(list(self.array(data, "quality")), [0, 1, 2, 3])
            self.assertEqual(data.GetNumberOfArrays(), 3)
            data = mesh.GetCellData()  # of a vertex, a line, a polygon
            self.assertEqual(self.corners(mesh.GetVerts()), [3])
            self.assertEqual(self.corners(mesh.GetLines()), [1, 2])
            self.assertEqual(self.corners(mesh.GetPolys()), [0, 1, 2])
            self.assertEqual(list(self.array(data, "region")), [8, 9, 7])
            numpy.testing.assert_array_equal(
                self.array(data, "RGBA"), [(0, 255, 0, 255), (0, 0, 255, 255), (255, 0, 0, 255)]
            )

    def test_coordinates_of_faces(self):
        """Texture coordinates of corners split the points where they differ."""
        rows = [([0, 1, 2], [0, 0, 1, 0, 1, 1]), ([0, 2, 3], [0.5, 0, 1, 1, 0, 1]),
                ([2, 0, 1], [1, 1, 0.5, 0, 1, 0])]  # fmt: skip
        extra = [(("uchar", "float"), "texcoord")]
        mesh = self.read(make("ascii", [vertices(), faces(rows, extra)]))
        self.assertEqual(self.corners(mesh.GetPolys()), [0, 1, 2, 4, 2, 3, 2, 4, 1])
        numpy.testing.assert_array_equal(
            vtk_to_numpy(mesh.GetPointData().GetTCoords()),
            [(0, 0), (1, 0), (1, 1), (0, 1), (0.5, 0)],
        )
        numpy.testing.assert_array_equal(vtk_to_numpy(mesh.GetPoints().GetData())[4], SQUARE[0])

    def test_not_finite(self):
        text = make("ascii", [vertices(), WHOLE]).replace(b"1 1 0", b"nan +inf -1e-999")
        point = self.read(text).GetPoint(2)
        self.assertTrue(numpy.isnan(point[0]) and point[1] == numpy.inf and point[2] == 0)

    # ------------------------------------------------------------------------
    def test_cut(self):
        """At every byte: refused, but where only the last line's end is missing."""
        for form in FORMATS:
            whole = make(form, [vertices(), faces([([0, 1, 2],), ([0, 2, 3],)])])
            for size in range(len(whole) - (2 if form == "ascii" else 0)):
                self.read(whole[:size], refused=[])
            start = whole.index(b"end_header\n") + len(b"end_header\n")
            self.read(whole[: start - 11], refused=["ends in its header"])
            self.read(whole[: start + 3], refused=["vertex"])
            self.read(whole[:-5], refused=["ends in face 1 of 2"])

    def test_refusals(self):
        good = make("ascii", [vertices(), WHOLE])
        for old, new, *says in (
            (b"ply\n", b"plx\n", "first line is the word ply"),
            (b"ascii", b"binary", "expected the format"),
            (b"format ascii 1.0\n", b"", "expected the format"),
            (b"vertex 4", b"vertex -4", "line 4:", "number of elements"),
            (b"vertex 4", b"vertex 4000000000000", "4000000000000 of the element vertex"),
            (b"face 1", b"face 999999999", "999999999 of the element face"),
            (b"float x", b"real x", "line 5:", "not 'real'"),
            (b"property float y\n", b"property float\n", "line 6:"),
            (b"property float y\n", b"", "x, y and z"),
            (b"comment", b"remark", "line 3:", "not 'remark'"),
            (b"uchar int", b"float int", "line 9:", "whole numbers"),
            (b"4 0 1 2 3", b"4 0 1 2 4", "face 0:", "from 0 to 3, not 4"),
            (b"4 0 1 2 3", b"4 0 1 2 -1", "face 0:", "not -1"),
            (b"4 0 1 2 3", b"-4 0 1 2 3", "face 0:", "the length of a list"),
            (b"4 0 1 2 3", b"4 0 1 2 1.5", "face 0:", "not '1.5'"),
            (b"1 1 0", b"1 one 0", "vertex 2:", "not 'one'"),
            (b"1 1 0", b"1 1,5 0", "vertex 2:", "not '1,5'"),
            (b"4 0 1 2 3", b"200 0 1 2 3", "ends in face 0 of 1"),
        ):
            with self.subTest(new=new):
                self.assertIn(old, good)
                self.read(good.replace(old, new), refused=says)
        self.path.unlink()
        self.read(refused=["No such file"])
        os.mkfifo(self.path)
        self.read(refused=["it is a pipe"])

    def test_broken(self):
        """Broken bytes anywhere: read or refused, never an index out of range."""
        numbers, counts = random.Random(6), [0, 0]
        colors = [("float", name) for name in ("red", "green", "blue")]
        goods = [make(form, [vertices(colors, 4 * [(1, 0, 1)]),
                             faces([([0, 1, 2, 3], [0] * 8), ([1], [0, 1])],
                                   [(("uchar", "float"), "texcoord")])])
                 for form in FORMATS]  # fmt: skip
        goods += [make(form, [vertices(), faces([([0, 1, 2],), ([0, 2, 3],)])])
                  for form in FORMATS[1:]]  # fmt: skip
        for i in range(2500):
            text = bytearray(goods[i % len(goods)])
            for _ in range(numbers.randint(1, 2)):
                place = numbers.randrange(len(text))
                if numbers.random() < 0.7:
                    text[place] = numbers.randrange(256)
                else:
                    del text[place : place + numbers.randint(1, 8)]
            self.path.write_bytes(text)
            reader, errors = relievo.vtkRelievoPLYReader(), []
            reader.AddObserver("ErrorEvent", lambda *_, errors=errors: errors.append(1))
            reader.SetFileName(str(self.path))
            reader.Update()
            self.assertEqual(len(errors), reader.GetErrorCode() != 0)
            counts[len(errors)] += 1
            mesh = reader.GetOutput()
            for cells in (mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys()):
                found = self.corners(cells)
                self.assertTrue(all(0 <= each < mesh.GetNumberOfPoints() for each in found))
        self.assertGreater(min(counts), 200, counts)


if __name__ == "__main__":
    unittest.main(verbosity=2)
