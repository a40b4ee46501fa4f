# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files whose cells, grids or arrays do not fit, or that end too early: drawn or refused in one
line that names the file, never a crash, and never a part without a word."""

import os
import struct

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOLegacy import (
    vtkPolyDataWriter,
    vtkStructuredPointsWriter,
    vtkUnstructuredGridWriter,
)
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLPolyDataWriter,
    vtkXMLUnstructuredGridWriter,
)

from cli import CliTest, main

LACKS = os.environ.get("RELIEVO_VTK_LACKS", "").split()  # tests/wheel/CMakeLists.txt
POINTS = "".join(f"{i * 7 % 5} {i * 3 % 4} {i % 3}\n" for i in range(31))
HEAD = "# vtk DataFile Version 3.0\nmade by a test\nASCII\nDATASET "
# How many points there may be: of VTK's documentation of each cell.
FIXED = {1: 1, 3: 2, 5: 3, 8: 4, 9: 4, 10: 4, 11: 8, 12: 8, 13: 6, 14: 5, 15: 10, 16: 12, 21: 3,
         22: 6, 23: 8, 24: 10, 25: 20, 26: 15, 27: 13, 28: 9, 29: 27, 30: 6, 31: 12, 32: 18, 33: 24,
         34: 7, 35: 4, 37: 19}  # fmt: skip
LEAST = {2: 1, 4: 2, 6: 3, 7: 3, 41: 4, 68: 2, 75: 2}
ORDERS = {69: (3, 6, 7, 10, 15, 21, 28), 70: (4, 9, 16, 25), 71: (4, 10, 15, 20), 72: (8, 27),
          73: (6, 18, 21)}  # fmt: skip
ORDERS.update({kind + 7: counts for kind, counts in list(ORDERS.items())})
ORDERS[36] = tuple(range(6, 31, 2))


def may_be_drawn(kind, count):
    if kind in FIXED:
        return count == FIXED[kind]
    if kind in LEAST:
        return count >= LEAST[kind]
    return count in ORDERS.get(kind, ())


class Cells(CliTest):
    def render(self, name, text=None):
        """The exit status and the messages."""
        if text is not None:
            data = text.encode() if isinstance(text, str) else text
            (self.folder / name).write_bytes(data)
        done = self.finished("render", name, "--size", "32x32", "--png", name + ".png")
        return done.returncode, done.stderr

    def check_refused(self, name, text, *says):
        status, said = self.render(name, text)
        self.assertEqual(status, 1, said)
        self.assertEqual(said.count("\n"), 1, said)
        for each in (name, *says):
            self.assertIn(each, said)

    def test_types(self):
        """Every type of cell, with numbers of points that fit and that do not."""
        every = os.environ.get("RELIEVO_TEST_EVERY") == "1"
        jobs = []
        for kind in range(90):
            fits = [count for count in range(31) if may_be_drawn(kind, count)]
            # Counts that fit no existing type are refused as such.
            counts = {0, 1, 3, 4, 30, *fits[:2], fits[0] - 1} if fits else {0, 4}
            jobs += [(kind, count) for count in (range(31) if every else counts)]

        refused = 0
        for kind, count in jobs:
            cells = f"{count} " + " ".join(map(str, range(count)))
            text = (f"{HEAD}UNSTRUCTURED_GRID\nPOINTS 31 float\n{POINTS}"
                    f"CELLS 1 {count + 1}\n{cells}\nCELL_TYPES 1\n{kind}\n")  # fmt: skip
            with self.subTest(type=kind, points=count):
                status, said = self.render(f"{kind}-{count}.vtk", text)
                self.assertIn(status, (0, 1), said)
                self.assertEqual(status == 1, f"{kind}-{count}.vtk: " in said, said)
                if may_be_drawn(kind, count):
                    self.assertNotIn("expected", said)
                elif kind not in (0, 42):  # empty cells; polyhedra are said by their faces
                    self.assertEqual(status, 1)
                    self.assertRegex(said, "cell 0 is |a cell uses point")
                refused += status
        self.assertGreater(refused, len(jobs) // 2)

    def test_polyhedra(self):
        """A tetrahedron of four faces; then faces that are not there, or are none."""
        def make(faces, offset):
            return ('<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid><Piece '
                    'NumberOfPoints="4" NumberOfCells="1"><Points><DataArray type="Float32" '
                    'NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray>'
                    '</Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">'
                    '0 1 2 3</DataArray><DataArray type="Int64" Name="offsets" format="ascii">4'
                    '</DataArray>'
                    '<DataArray type="UInt8" Name="types" format="ascii">42</DataArray>'
                    f'<DataArray type="Int64" Name="faces" format="ascii">{faces}</DataArray>'
                    f'<DataArray type="Int64" Name="faceoffsets" format="ascii">{offset}'
                    '</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>')  # fmt: skip

        whole = "4 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2"
        status, said = self.render("whole.vtu", make(whole, 17))
        self.assertEqual((status, said), (0, ""))
        for name, faces, offset in (
            ("index", whole.replace("1 2 3 3 0", "1 2 9 3 0"), 17),
            ("negative", whole.replace("1 2 3 3 0", "1 -2 3 3 0"), 17),
            ("few", "3 3 0 2 1 3 0 1 3 3 1 2 3", 13),
            ("none", "0", 1),
        ):
            with self.subTest(faces=name):
                self.check_refused(name + ".vtu", make(faces, offset))
        # How far VTK's reader gets with such is its own affair.
        for name, faces, offset in (("long", "4 999 0 2 1", 5), ("count", "4000000 3 0 2 1", 5)):
            self.check_refused(name + ".vtu", make(faces, offset))

    def test_polygons(self):
        for kind, count in (("VERTICES", 0), ("LINES", 1), ("POLYGONS", 2), ("POLYGONS", 0),
                            ("TRIANGLE_STRIPS", 1), ("TRIANGLE_STRIPS", 2)):  # fmt: skip
            few = f"{count} " + " ".join(map(str, range(count)))
            more = "3 0 1 2"
            text = (f"{HEAD}POLYDATA\nPOINTS 31 float\n{POINTS}{kind} 2 {4 + count + 1}\n{more}\n"
                    f"{few}\n")  # fmt: skip
            with self.subTest(kind=kind, points=count):
                self.check_refused("a.vtk", text, "cell 1 is a", f"{count} point", "at least")

    def test_structured(self):
        """Points, coordinates and arrays that do not fit the extent."""
        grid = f"{HEAD}STRUCTURED_GRID\nDIMENSIONS 3 3 {{}}\nPOINTS {{}} float\n{{}}"
        good = grid.format(3, 27, POINTS[: len(POINTS) // 31 * 27])
        self.assertEqual(self.render("good.vtk", good)[0], 0)
        self.check_refused("few.vtk", grid.format(9, 27, POINTS))
        self.check_refused("none.vtk", grid.format(3, 0, ""))
        self.check_refused("wild.vtk", grid.format(-7, 27, POINTS))
        straight = (f"{HEAD}RECTILINEAR_GRID\nDIMENSIONS 3 3 {{}}\nX_COORDINATES 3 float\n0 1 2\n"
                    "Y_COORDINATES {} float\n{}\nZ_COORDINATES 2 float\n0 1\n")  # fmt: skip
        self.assertEqual(self.render("good.vtk", straight.format(2, 3, "0 1 2"))[0], 0)
        self.check_refused("z.vtk", straight.format(5, 3, "0 1 2"))
        self.check_refused("y.vtk", straight.format(2, 1, "0"))

    def test_large_images(self):
        """Images announced by a file of 200 bytes are not allocated."""
        for size in (1500, 40000) if "huge" in LACKS else (1500, 40000, 2**31 - 2):
            extent = f"0 {size} 0 {size} 0 {size if size < 40000 else 0}"
            text = (f'<VTKFile type="ImageData" version="0.1"><ImageData WholeExtent="{extent}" '
                    f'Origin="0 0 0" Spacing="1 1 1"><Piece Extent="{extent}"/></ImageData>'
                    '</VTKFile>')  # fmt: skip
            self.check_refused("a.vti", text, f"{size + 1} x {size + 1}", "1200 million points")

    # ------------------------------------------------------------------------
    def test_cut_short(self):
        """Files that end at any of twelve places, or between two lines, are refused."""
        source = vtkSphereSource()
        source.Update()
        grid = vtkAppendFilter()
        grid.AddInputData(source.GetOutput())
        grid.Update()
        image = vtkImageData()
        image.SetDimensions(4, 5, 6)
        image.AllocateScalars(10, 1)
        sphere = source.GetOutput()
        for make, name, data, modes in (
            (vtkXMLPolyDataWriter, "a.vtp", sphere, ("DataModeToAscii", "DataModeToBinary")),
            (vtkXMLUnstructuredGridWriter, "a.vtu", grid.GetOutput(), ("DataModeToAscii",)),
            (vtkXMLImageDataWriter, "a.vti", image, ("DataModeToBinary",)),
            (vtkPolyDataWriter, "a.vtk", sphere, ("FileTypeToASCII", "FileTypeToBinary")),
            (vtkUnstructuredGridWriter, "b.vtk", grid.GetOutput(), ("FileTypeToBinary",)),
            (vtkStructuredPointsWriter, "c.vtk", image, ("FileTypeToBinary",)),
            (vtkSTLWriter, "a.stl", sphere, ("FileTypeToASCII", "FileTypeToBinary")),
        ):
            for mode in modes:
                if f"{name}:{mode}" in LACKS:
                    continue
                path = self.folder / name
                writer = make()
                writer.SetFileName(str(path))
                writer.SetInputData(data)
                getattr(writer, "Set" + mode)()
                writer.Write()
                self.assertEqual(self.render(name)[0], 0)
                whole = path.read_bytes()
                sizes = [len(whole) * i // 12 for i in range(12)]
                sizes += [whole.rfind(b"\n", 0, len(whole) * i // 4) + 1 for i in (2, 3)]
                for size in sizes:
                    with self.subTest(file=name, mode=mode, size=size):
                        self.check_refused(name, whole[:size])

    def test_stl(self):
        """Binary STL against the number of triangles that it says it holds."""
        triangle = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
        for said, held, rest, status in ((2, 2, b"", 0), (2, 1, b"", 1), (2, 2, b"more", 0),
                                         (1, 2, b"", 0), (0, 2, b"", 0), (2**32 - 1, 2, b"", 1),
                                         (2, 1, b"x" * 49, 1)):  # fmt: skip
            if rest == b"more" and "rest" in LACKS:
                continue
            head = b"made by a test".ljust(80, b"\0") + struct.pack("<I", said)
            with self.subTest(said=said, held=held):
                found, words = self.render("a.stl", head + triangle * held + rest)
                self.assertEqual(found, status, words)
                noted = status == 1 or said == 1
                says = f"declares {said} triangles, and has {held}"
                self.assertEqual(says in words, noted)

    def test_stl_names(self):
        """Text is detected by its content: letters of any language before the facets, up to the
        share that VTK's reader still takes for text; a mark before the first word is named."""
        rest = ("facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                "endloop\nendfacet\nendsolid\n")  # fmt: skip
        for name, says in (("part", ""), ("Gehäuse", ""), (20 * "ä", "expected ASCII")):
            with self.subTest(name=name):
                found, words = self.render("a.stl", f"solid {name}\n{rest}".encode())
                self.assertEqual((found, says in words), (1 if says else 0, True), words)
                self.assertNotIn("complete", words)
        for code in ("utf-8-sig", "utf-16"):
            found, words = self.render("a.stl", f"solid part\n{rest}".encode(code))
            self.assertEqual((found, "byte order mark" in words), (1, True), words)


if __name__ == "__main__":
    main()
