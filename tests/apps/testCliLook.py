# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours by arrays, colour maps and bars, opacity, edges, backgrounds, presets, OBJ materials."""

import zlib

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from cli import CliTest, main, oklab, read_png, write_image

SIDE, CELLS = 96, 8
CAMERA = ["--camera", "0,0,5,0,0,0,0,1,0", "--clip", "1,10", "--parallel-scale", "1"]
LOOK = [*CAMERA, "--size", f"{SIDE}x{SIDE}"]
LONG = "temperature of the cooling water at the outlet"
X = (numpy.arange(SIDE) + 0.5) / SIDE * 2 - 1  # of each column
# Two squares; the first face has no texture coordinates, the file's name a blank.
OBJ = """mtllib two squares.mtl
v -1 -1 0
v 0 -1 0
v 0 1 0
v -1 1 0
v 1 -1 0
v 1 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl plain red
f 1 2 3 4
  usemtl printed items
 f 2/1 5/2 6/3 3/4
"""
MTL = """newmtl plain red
Kd 0.8 0.2 0.4
newmtl printed items
illum 1
Ks 1 1 1
Kd 1 1 1
d -halo 1.0
Tr 1
map_Kd -s 1 1 1 .\\halves.png
"""


def add(data, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.AddArray(array)


class Look(CliTest):
    def setUp(self):
        super().setUp()
        source = vtkPlaneSource()
        source.SetOrigin(-1, -1, 0)
        source.SetPoint1(1, -1, 0)
        source.SetPoint2(-1, 1, 0)
        source.SetResolution(CELLS, CELLS)
        source.Update()
        plane = source.GetOutput()
        x = vtk_to_numpy(plane.GetPoints().GetData())[:, 0].astype(float)
        add(plane.GetPointData(), "across", 3 + 2 * x)  # 1 to 5
        add(plane.GetPointData(), "wind", numpy.c_[x, 0 * x, 0 * x + 1])
        turned = numpy.c_[numpy.cos(7 * x), numpy.sin(7 * x), 0 * x]
        add(plane.GetPointData(), "unit", turned.astype(numpy.float32))
        ulps = numpy.float32(1e6) + numpy.float32(0.0625) * (numpy.arange(len(x)) % 3 - 1)
        add(plane.GetPointData(), "ulps", ulps.astype(numpy.float32))
        add(plane.GetPointData(), "ulps below", -ulps.astype(numpy.float32))
        add(plane.GetPointData(), "none", 0 * x)
        add(plane.GetPointData(), "still", 300 + 1e-13 * x)
        add(plane.GetPointData(), "slow", (300 + 1e-3 * x).astype(numpy.float32))
        add(plane.GetPointData(), LONG, x)
        add(plane.GetPointData(), "paint", numpy.tile(numpy.uint8([30, 200, 90]), (len(x), 1)))
        glass = numpy.tile(numpy.uint8([200, 255, 200, 128]), (len(x), 1))
        add(plane.GetPointData(), "glass", glass)
        add(plane.GetCellData(), "column", numpy.arange(CELLS**2) % CELLS)
        add(plane.GetCellData(), "across", numpy.arange(CELLS**2) % CELLS)
        add(plane.GetCellData(), "label,1", (numpy.arange(CELLS**2) % CELLS).astype(numpy.uint8))
        writer = vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()  # beside newer expats, VTK 9.2 reads nothing appended
        writer.SetFileName(str(self.folder / "plane.vtp"))
        writer.SetInputData(plane)
        writer.Write()
        self.before = self.names()

    def albedo(self, *words, file="plane.vtp"):
        self.relievo("render", file, *LOOK, *words, "--layers", "albedo", "--exr", "a.exr")
        channels = self.exr("a.exr")[1]
        return numpy.stack([channels[f"albedo.{c}"] for c in "RGB"], axis=-1)

    def judge(self, found, expected, columns=slice(None)):
        """Each column's colour, of one channel or three, in bytes."""
        expected = numpy.asarray(expected, dtype=float)
        expected = expected[:, None] if expected.ndim == 1 else expected
        difference = abs(found[:, columns] - expected[None, columns])
        self.assertLess(difference.max(), 1.6 / 255)

    def test_values(self):
        """Of points and cells, a component, a magnitude, a range; bytes are colours."""
        grey = ["--colormap", "grey", "--color-by"]
        self.judge(self.albedo(*grey, "across"), (X + 1) / 2)
        self.judge(self.albedo(*grey, "across", "--range", "2,4"), numpy.clip(X + 0.5, 0, 1))
        self.judge(self.albedo(*grey, "wind,0"), (X + 1) / 2)
        at_points = numpy.hypot(numpy.linspace(-1, 1, CELLS + 1), 1)
        lengths = numpy.interp(X, numpy.linspace(-1, 1, CELLS + 1), at_points)
        self.judge(self.albedo(*grey, "wind"), (lengths - 1) / (2**0.5 - 1))
        for name in ("cell:across", "cell:across,0"):
            self.judge(self.albedo(*grey, name), (numpy.arange(SIDE) * CELLS // SIDE) / 7)
        self.judge(self.albedo(*grey, "point:across"), (X + 1) / 2)
        self.judge(self.albedo(*grey, "column"), (numpy.arange(SIDE) * CELLS // SIDE) / 7)
        self.judge(self.albedo(*grey, "label,1"), (numpy.arange(SIDE) * CELLS // SIDE) / 7)
        self.judge(self.albedo("--color-by", "paint"),
                   numpy.tile(numpy.array([30, 200, 90]) / 255, (SIDE, 1)))  # fmt: skip
        self.judge(self.albedo(*grey, "paint,1", "--range", "0,200"), numpy.ones(SIDE))
        self.judge(self.albedo("--color", "#1e90ff"),
                   numpy.tile(numpy.array([30, 144, 255]) / 255, (SIDE, 1)))  # fmt: skip

    def test_constant_up_to_rounding(self):
        """Values that differ by their rounding alone have one colour, of a range from zero, so that
        a mesh that is seen as a whole looks seen; others have the whole map."""
        rows = (("unit", 1), ("still", 1), ("ulps", 1), ("ulps below", 0), ("none", 0))
        for name, colour in rows:
            found = self.albedo("--colormap", "grey", "--color-by", name)
            self.assertLess(abs(found - colour).max(), 0.005, name)
        found = self.albedo("--colormap", "grey", "--color-by", "slow")
        self.assertGreater(found.max() - found.min(), 0.9)

    def test_maps(self):
        """The ends of each map, as their authors publish them."""
        for name, low, high in (
            ("viridis", (68, 1, 84), (253, 231, 37)),
            ("cool-warm", (59, 76, 192), (180, 4, 38)),
            ("hot", (0, 0, 0), (255, 255, 255)),
            ("rainbow", (0, 0, 255), (255, 0, 0)),
            ("hot:reversed", (255, 255, 255), (0, 0, 0)),
            ("rainbow:reversed", (255, 0, 0), (0, 0, 255)),
            ("#102030,white,1/0.5/0", (16, 32, 48), (255, 128, 0)),
            ("navy,red:reversed", (255, 0, 0), (0, 0, 128)),
        ):
            for bounds, end in (("9,10", low), ("0,1", high)):
                found = self.albedo("--color-by", "across", "--colormap", name, "--range", bounds)
                apart = abs(found * 255 - end).max()
                self.assertLess(apart, 4, f"{name}, {bounds}: {found[0, 0] * 255}")

    def test_lightness(self):
        """Grows evenly, is symmetric, or constant, by the kind of the map; labels are told
        apart."""
        found = {}
        for name in ("ember", "ocean", "blue-orange", "green-purple", "phase", "categories"):
            row = self.albedo("--color-by", "across", "--colormap", name)[SIDE // 2]
            found[name] = oklab(row.astype(float))
        for name in ("ember", "ocean"):
            slope, first = numpy.polyfit(X / 2, found[name][:, 0], 1)
            self.assertGreater(slope, 0.7, name)
            off = found[name][:, 0] - (first + slope * X / 2)
            self.assertLess(abs(off).max(), 0.012, name)
        for name in ("blue-orange", "green-purple"):
            light = found[name][:, 0]
            self.assertLess(abs(light - light[::-1]).max(), 0.008, name)
            self.assertTrue((numpy.diff(light[: SIDE // 2]) > 0).all(), name)
            self.assertGreater(light.max() - light.min(), 0.38)
            ends = numpy.arctan2(found[name][[0, -1], 2], found[name][[0, -1], 1])
            self.assertGreater(abs(numpy.diff(ends)[0]), 2, name)
        phase = found["phase"]
        self.assertLess(numpy.ptp(phase[:, 0]), 0.01)
        self.assertLess(numpy.ptp(numpy.hypot(phase[:, 1], phase[:, 2])), 0.01)
        turns = numpy.linalg.norm(numpy.diff([*phase, phase[0]], axis=0), axis=1)
        self.assertLess(turns.max(), 2 * numpy.median(turns))  # also from the last to the first
        labels = found["categories"][numpy.linspace(SIDE // 20, SIDE - SIDE // 20, 10).astype(int)]
        apart = numpy.linalg.norm(labels[:, None] - labels[None], axis=-1)
        self.assertGreater(apart[~numpy.eye(10, dtype=bool)].min(), 0.15)

    def test_scales(self):
        """Logarithms, steps, positions of custom colours, a range around zero, NaN."""
        across, points = 3 + 2 * X, numpy.linspace(-1, 1, CELLS + 1)
        share, log = (across - 1) / 4, numpy.interp(X, points, numpy.log(3 + 2 * points))
        for words, expected in (
            (["grey:log"], log / numpy.log(5)),
            (["grey:reversed:log"], 1 - log / numpy.log(5)),
            (["grey:log", "--range", "0.5,8"], (log + numpy.log(2)) / numpy.log(16)),
            (["grey:steps=4"], numpy.floor(4 * share) / 3),
            (["grey:steps=3:reversed"], 1 - numpy.floor(3 * share) / 2),
            (["grey:log:steps=2"], (log > numpy.log(5) / 2).astype(float)),
            (["black,0.25=white,0.5=black,white"],
             numpy.interp(share, [0, 0.25, 0.5, 1], [0, 1, 0, 1])),
            (["black,0.5=white,0.5=black,white"],
             numpy.where(share < 0.5, 2 * share, 2 * share - 1)),
            (["0.25=black,0.5=white"], numpy.clip(4 * share - 1, 0, 1)),
            (["0.25=black,0.5=white:reversed"], numpy.clip(3 - 4 * share, 0, 1)),
            (["black,0.5=white,black,white"],
             numpy.interp(share, [0, 0.5, 0.75, 1], [0, 1, 0, 1])),
            (["grey", "--range", "symmetric"], (across + 5) / 10),
        ):
            with self.subTest(words):
                found = self.albedo("--color-by", "across", "--colormap", *words)
                edges = numpy.abs(numpy.diff(expected, prepend=expected[0])) > 0.2
                steady = ~(edges | numpy.roll(edges, -1))  # but where a colour ends
                self.judge(found, expected, numpy.flatnonzero(steady))
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "plane.vtp"))
        reader.Update()
        values = vtk_to_numpy(reader.GetOutput().GetCellData().GetArray("column")).astype(float)
        add(reader.GetOutput().GetCellData(), "holes", numpy.where(values < 4, numpy.nan, values))
        add(reader.GetOutput().GetCellData(), "below", values - 4)
        writer = vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()  # beside newer expats, VTK 9.2 reads nothing appended
        writer.SetFileName(str(self.folder / "holes.vtp"))
        writer.SetInputData(reader.GetOutput())
        writer.Write()
        for words, color in ((["grey:nan=#ff8000"], (1, 128 / 255, 0)), (["grey"], (0.5,) * 3)):
            found = self.albedo("--color-by", "holes", "--colormap", *words, file="holes.vtp")
            self.judge(found[:, :40], numpy.tile(color, (40, 1)))
        # Values up to zero have the first colour; the range begins at the least positive value.
        found = self.albedo("--color-by", "below", "--colormap", "grey:log", file="holes.vtp")
        columns = numpy.arange(SIDE) * CELLS // SIDE - 4
        self.judge(found, numpy.log(numpy.maximum(columns, 1)) / numpy.log(3))

    def test_between_points(self):
        """Values are interpolated, not colours: two cells across have the colours of many."""
        source = vtkPlaneSource()
        source.SetOrigin(-1, -1, 0)
        source.SetPoint1(1, -1, 0)
        source.SetPoint2(-1, 1, 0)
        source.Update()
        coarse = source.GetOutput()
        x = vtk_to_numpy(coarse.GetPoints().GetData())[:, 0].astype(float)
        add(coarse.GetPointData(), "across", 3 + 2 * x)
        writer = vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()  # beside newer expats, VTK 9.2 reads nothing appended
        writer.SetFileName(str(self.folder / "coarse.vtp"))
        writer.SetInputData(coarse)
        writer.Write()
        for name in ("viridis", "rainbow"):
            words = ["--color-by", "across", "--colormap", name]
            fine, rough = self.albedo(*words), self.albedo(*words, file="coarse.vtp")
            self.assertLess(abs(fine - rough).max(), 6 / 255, name)

    def test_translucent_colors(self):
        """Opacities of an array are the picture's, and the opaque behind them stays opaque."""
        for behind, alpha in ((["triangle.off"], 1), ([], 128 / 255)):
            self.relievo("render", "plane.vtp", *behind, *LOOK, "--color-by", "glass",
                         "--exr", "a.exr")  # fmt: skip
            found = self.exr("a.exr")[1]["A"][SIDE - 8, 8]
            self.assertAlmostEqual(float(found), alpha, delta=0.003)

    def test_bar(self):
        """At the right edge and nowhere else; its colours are those of the map."""
        words = ["render", "plane.vtp", *CAMERA, "--size", "400x200", "--background", "white",
                 "--color-by", "across"]  # fmt: skip
        self.relievo(*words, "--png", "a.png")
        self.relievo(*words, "--scalar-bar", "--png", "b.png")
        plain, bar = (read_png(self.folder / name).astype(int) for name in ("a.png", "b.png"))
        apart = (plain != bar).any(axis=2)
        self.assertFalse(apart[:, :330].any())
        self.assertGreater(apart.mean(), 0.01)
        for color in ((68, 1, 84), (253, 231, 37)):
            self.assertGreater((abs(bar - color).max(axis=2) < 12)[:, 330:].sum(), 10, color)

    def test_bar_places(self):
        """At each edge, horizontal at two of them, with other texts; boxes for values left out."""
        words = ["render", "plane.vtp", *CAMERA, "--size", "600x400", "--background", "white",
                 "--color-by", "across", "--colormap", "grey", "--opacity", "0"]  # fmt: skip
        self.relievo(*words, "--png", "a.png")
        empty = read_png(self.folder / "a.png").astype(int)
        for place in ("right", "left", "bottom", "top"):
            self.relievo(*words, "--bar", place, "--png", "a.png")
            seen = (read_png(self.folder / "a.png").astype(int) != empty).any(axis=2)
            rows, columns = (numpy.flatnonzero(seen.any(axis=axis)) for axis in (1, 0))
            tall, wide = numpy.ptp(rows), numpy.ptp(columns)
            self.assertEqual(tall > wide, place in ("right", "left"), place)
            self.assertTrue(0.5 < (tall / 400 if tall > wide else wide / 600) < 0.65, place)
            middle = {"right": columns > 300, "left": columns < 300,
                      "bottom": rows > 200, "top": rows < 200}[place]  # fmt: skip
            self.assertTrue(middle.all(), place)
            other = [*words, "--bar", f"{place},title=σ, first,unit=N/m²", "--png", "a.png"]
            self.relievo(*other)
            named = read_png(self.folder / "a.png").astype(int)
            self.relievo(*other[:-2], "--range", "2,3", "--png", "a.png")
            boxed = read_png(self.folder / "a.png").astype(int)
            self.assertTrue((named != boxed).any() and not (boxed[..., 0] != boxed[..., 1]).any())

    def test_bar_of_a_layer(self):
        """Replaces that of the array where a layer is the picture, and is over the layer."""
        for layer, has in (("depth", True), ("range", True), ("normal", False)):
            shown = ["render", "plane.vtp", *CAMERA, "--size", "300x200", "--color-by", "across",
                     "--stage", f"display:layer={layer}"]  # fmt: skip
            self.relievo(*shown, "--png", "a.png")
            plain = read_png(self.folder / "a.png").astype(int)
            self.relievo(*shown, "--scalar-bar", "--png", "a.png")
            seen = (read_png(self.folder / "a.png").astype(int) != plain).any(axis=2)
            self.assertFalse(seen[:, :200].any(), layer)
            self.assertEqual(seen[:, 200:].mean() > 0.1, has, layer)

    def test_bar_of_nan(self):
        """NaN has a box of its colour where the drawn values have any."""
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "plane.vtp"))
        reader.Update()
        data = reader.GetOutput()
        values = vtk_to_numpy(data.GetPointData().GetArray("across"))
        values[3] = numpy.nan
        writer = vtkXMLPolyDataWriter()
        writer.SetDataModeToBinary()
        writer.SetFileName(str(self.folder / "nan.vtp"))
        writer.SetInputData(data)
        writer.Write()
        for name, most, least in (("plane.vtp", 0, 0), ("nan.vtp", 400, 100)):
            self.relievo("render", name, *CAMERA[:-2], "--size", "600x400", "--background",
                         "white", "--color-by", "across", "--colormap", "grey:nan=#ff0000",
                         "--scalar-bar", "--parallel-scale", "4", "--png", "a.png")  # fmt: skip
            picture = read_png(self.folder / "a.png")[:, 450:].astype(int)
            red = (picture == (255, 0, 0)).all(axis=2).sum()
            self.assertTrue(least <= red <= most, (name, red))

    def test_figure(self):
        """Millimetres and DPI give the size, 8 points the texts, and the PNG says so."""
        for width, dpi in ((85, 150), (40, 600)):
            self.relievo("render", "plane.vtp", *CAMERA, "--size", "400x300", "--background",
                         "white", "--color-by", "across", "--colormap", "#ff0000,#ff0000", "--bar",
                         "right,title=0", "--opacity", "0", "--figure", f"{width}mm,{dpi}",
                         "--png", "a.png")  # fmt: skip
            picture = read_png(self.folder / "a.png").astype(int)
            pixels = round(width / 25.4 * dpi)
            self.assertEqual(picture.shape[:2], (round(pixels * 0.75), pixels))
            bytes_ = (self.folder / "a.png").read_bytes()
            at = bytes_.index(b"pHYs")
            chunk = bytes_[at : at + 13]
            self.assertEqual(chunk[4:12], 2 * round(dpi / 0.0254).to_bytes(4, "big"))
            self.assertEqual(bytes_[at + 13 : at + 17], zlib.crc32(chunk).to_bytes(4, "big"))
            # The title, one digit, is above the bar. Digits of DejaVu Sans are 0.73 of its size
            # high, those of VTK's own font about as much.
            bar = (picture[..., 0] - picture[..., 1] > 100).any(axis=1)
            ink = (picture[: numpy.flatnonzero(bar)[0]].max(axis=2) < 128).any(axis=1)
            rows = numpy.flatnonzero(ink)
            high = rows[numpy.flatnonzero(numpy.diff([*rows, 10**6]) > 1)[0]] - rows[0] + 1
            self.assertLess(abs(high - 0.73 * 8 / 72 * dpi), 0.08 * 8 / 72 * dpi + 1)

    def test_bar_of_steps(self):
        """As many colours as steps, of one height, by logarithms, too."""
        for words in ("grey:steps=5", "grey:steps=5:log"):
            self.relievo("render", "plane.vtp", *CAMERA, "--size", "400x200",
                         "--color-by", "across", "--background", "navy", "--colormap", words,
                         "--scalar-bar", "--png", "a.png")  # fmt: skip
            picture = read_png(self.folder / "a.png").astype(int)
            heights = [(abs(picture[:, 330:] - round(255 * step / 4)).max(axis=2) < 2).sum(axis=0)
                       for step in (1, 2, 3)]  # fmt: skip
            heights = [numpy.median(each[each > 10]) for each in heights]
            self.assertLessEqual(max(heights) - min(heights), 1, words)

    def test_bar_texts(self):
        """Whole, and no two values alike, whatever they are."""
        ranges = ("0,1", "293.15,294", "1e6,1000001", "-12346,-12345", "0,1e300", "-1e-9,2e-9",
                  "0,1e-4")  # fmt: skip
        rows = [("across", values) for values in ranges] + [(LONG, "0,0.3")]
        for array, values in rows:
            self.relievo("render", "plane.vtp", *CAMERA[:-1], "2", "--size", "600x300",
                         "--background", "white", "--color-by", array, "--range", values,
                         "--scalar-bar", "--png", "a.png")  # fmt: skip
            picture = read_png(self.folder / "a.png").astype(int)
            ink = picture.max(axis=2) < 128
            self.assertFalse(ink[:, -2:].any() or ink[:, :200].any(), (array, values))
            with self.subTest(array=array, values=values):
                colorful = (picture.max(axis=2) - picture.min(axis=2) > 60)[:, 380:].any(axis=0)
                right = 380 + int(numpy.flatnonzero(colorful).max()) + 7  # past ticks
                texts = numpy.flatnonzero(numpy.diff(ink[:, right:].any(axis=1).astype(int)))
                texts = [ink[top + 1 : end + 1, right:].tobytes()
                         for top, end in zip(texts[::2], texts[1::2], strict=True)]  # fmt: skip
                self.assertGreaterEqual(len(texts), 5)
                self.assertEqual(len(texts), len(set(texts)))

    def test_commas_in_names(self):
        """A backslash before a comma keeps it in the name."""
        self.relievo("render", "plane.vtp", *LOOK, "--layers", r"depth,label\,1", "--exr", "a.exr")
        found = self.exr("a.exr")[1]["label,1.V"]
        numpy.testing.assert_array_equal(found[0], numpy.arange(SIDE) * CELLS // SIDE)

    def test_background(self):
        """One colour, by name or numbers; two from the bottom to the top."""
        words = ["render", "triangle.off", "--size", "64x64", "--png", "a.png", "--background"]
        for value, expected in (("slategray", (112, 128, 144)), ("1/0.5/0", (255, 128, 0)),
                                ("#0a141e", (10, 20, 30))):  # fmt: skip
            self.relievo(*words, value)
            found = read_png(self.folder / "a.png")[0, 0, :3].astype(int)
            self.assertLess(abs(found - expected).max(), 2, value)
        self.relievo(*words, "black,white")
        column = read_png(self.folder / "a.png")[:, 63, 0].astype(float)
        numpy.testing.assert_allclose(column, (63.5 - numpy.arange(64)) / 64 * 255, atol=1.5)

    def test_opacity_and_edges(self):
        self.relievo("render", "plane.vtp", *LOOK, "--opacity", "0.25", "--layers", "blend",
                     "--exr", "a.exr")  # fmt: skip
        numpy.testing.assert_allclose(self.exr("a.exr")[1]["blend.A"], 0.25, atol=1e-3)
        self.relievo("render", "plane.vtp", *LOOK, "--edges", "--png", "a.png")
        dark = read_png(self.folder / "a.png")[..., 0] < 200
        at_edges = numpy.arange(1, CELLS) * SIDE // CELLS
        across = dark.mean(axis=0)
        for edge in at_edges:
            self.assertGreater(max(across[edge - 1 : edge + 1]), 0.9, "an edge of cells")
        self.assertLess(dark.mean(), 0.4)

    def test_presets(self):
        """A preset's settings can also be given as options, which take precedence."""
        words = ["render", "triangle.off", "--size", "64x64", "--png"]
        self.relievo(*words, "a.png", "--preset", "town", "--shadow-size", "512")
        self.relievo(*words, "a.png", "--preset", "print")
        self.relievo(*words, "b.png", "--preset", "print", "--background", "black")
        white, black = (read_png(self.folder / name).astype(int) for name in ("a.png", "b.png"))
        self.assertEqual((tuple(white[0, -1]), tuple(black[0, -1])), ((255,) * 3, (0,) * 3))
        for up in ("x", "y", "z"):
            # The fitted camera and the lights rotate together: the upper side of the mesh is lit.
            self.relievo("render", "plane.vtp", "--size", "64x64", "--up", up, "--preset", "town",
                         "--layers", "shadow_0,shadow_2", "--exr", "a.exr")  # fmt: skip
            self.assertIn("shadow_2.V", self.exr("a.exr")[1])

    def test_obj_materials(self):
        (self.folder / "two squares.mtl").write_text(MTL)
        (self.folder / "two.obj").write_text(OBJ)
        halves = numpy.zeros((64, 64, 3), numpy.uint8)
        halves[:32], halves[32:] = (20, 40, 200), (240, 230, 10)
        write_image(vtkPNGWriter(), self.folder / "halves.png", halves)
        self.relievo("render", "two.obj", *LOOK, "--exr", "a.exr", "--layers",
                     "albedo,vtkOriginalCellIds")  # fmt: skip
        channels = self.exr("a.exr")[1]
        found = numpy.stack([channels[f"albedo.{c}"] for c in "RGB"], axis=-1) * 255
        for what, area, color in (
            ("plain", found[:, :47], (204, 51, 102)),
            ("lower half", found[52:92, 52:92], (20, 40, 200)),
            ("upper half", found[4:44, 52:92], (240, 230, 10)),
        ):
            self.assertLess(abs(area - color).max(), 2, what)
        cells = next(found for name, found in channels.items() if "vtkOriginalCellIds" in name)
        numpy.testing.assert_array_equal(cells[:, ::95], [[0, 1]] * SIDE)
        for words in (["--color", "white"],
                      ["--color-by", "vtkOriginalCellIds", "--colormap", "grey"]):  # fmt: skip
            plain = self.albedo(*words, file="two.obj")
            self.assertLess(abs(plain[:, 52:92] - 1).max(), 1 / 255, "without the texture")
        self.relievo("render", "two.obj", *LOOK, "--shading", "pbr", "--png", "a.png")
        found = read_png(self.folder / "a.png").astype(int)
        self.assertGreater(found[70, 70, 2], found[70, 70, 0] + 50, "a texture of PBR")
        (self.folder / "two.obj").write_text(OBJ.replace("two squares.mtl", "a.mtl b.mtl"))
        for name, words in (("a.mtl", MTL[: MTL.index("newmtl printed")]),
                            ("b.mtl", MTL[MTL.index("newmtl printed") :])):  # fmt: skip
            (self.folder / name).write_text(words)
        self.judge(self.albedo(file="two.obj")[:, :47], numpy.tile([0.8, 0.2, 0.4], (47, 1)))
        (self.folder / "two.obj").write_text(OBJ)
        (self.folder / "two halves.png").write_bytes((self.folder / "halves.png").read_bytes())
        placed = MTL.replace("-s 1 1 1 .\\halves.png", "-s 1 2 -o 0 0.25 1 two halves.png")
        (self.folder / "two squares.mtl").write_text(placed)
        found = self.albedo(file="two.obj")[:, 52:92]
        v = (2 * (SIDE - numpy.arange(SIDE) - 0.5) / SIDE + 0.25) % 1
        inside = abs((v + 0.25) % 0.5 - 0.25) > 0.06  # away from where the halves meet
        expected = numpy.where(v[:, None] < 0.5, (20, 40, 200), (240, 230, 10)) / 255
        apart = abs(found - expected[:, None])[inside]
        self.assertLess(apart.max(), 1.6 / 255, "scaled, then moved")
        flat = numpy.full((8, 8, 3), 255, numpy.uint8)
        write_image(vtkPNGWriter(), self.folder / "flat.png", flat)
        found = self.albedo("--height-map", "flat.png,0.1", file="two.obj")[:, 52:92]
        apart = abs(found - expected[:, None])[inside]
        self.assertLess(apart.max(), 1.6 / 255, "the same on a flat relief")
        words = placed.replace("-s 1 2", "-mm 0 1 -clamp on -blendu on -s 1 2")
        (self.folder / "two squares.mtl").write_text(words)
        done = self.relievo("render", "two.obj", *LOOK, "--png", "a.png")
        self.assertIn("two halves.png is drawn without -clamp on\n", done.stderr)
        (self.folder / "two squares.mtl").write_text(MTL)
        (self.folder / "halves.png").unlink()
        done = self.relievo("render", "two.obj", *LOOK, "--png", "a.png")
        self.assertIn("drawn without a texture", done.stderr)
        (self.folder / "two squares.mtl").unlink()
        done = self.relievo("render", "two.obj", *LOOK, "--png", "a.png")
        self.assertIn("two squares.mtl: No such file", done.stderr)

    def test_refused(self):
        for words, says in (
            (["--color-by", "acros"],
             ["'acros'",
              f"glass, label,1, none, paint, slow, still, {LONG}, ulps, ulps below, unit, wind"]),
            (["--color-by", "wind,3"], ["component 3", "0 to 2"]),
            (["--colormap", "viridian"], ["'viridian'", "viridis, cool-warm"]),
            (["--colormap", "black,viridian"], ["'viridian'", "colour's name"]),
            (["--colormap", "black,"], "--colormap"),
            (["--colormap", "grey:steps=1"], ["'1'", "2 to 256"]),
            (["--colormap", "grey:lug"], ["'grey:lug'", ":log"]),
            (["--colormap", "black,0.6=red,0.4=white"], ["'0.4=white'", "colour before"]),
            (["--colormap", "grey:nan=greenish"], ["'greenish'", "#rrggbb"]),
            (["--colormap", "grey:log", "--range", "0,1"], ["--colormap log", "above 0"]),
            (["--colormap", "grey:log", "--range", "symmetric"], ["no --range symmetric"]),
            (["--colormap", "grey:log", "--color-by", "wind,1"], ["'wind'", "no positive values"]),
            (["--range", "2,1"], ["'2,1'", "MIN < MAX"]),
            (["--opacity", "1.5"], ["'1.5'", "0 to 1"]),
            (["--background", "greenish"], ["'greenish'", "#rrggbb"]),
            (["--background", "red,green,blue"], ["the bottom and the top"]),
            (["--color", "2/0/0"], ["'2/0/0'", "R/G/B from 0 to 1"]),
            (["--color", "red", "--color-by", "across"], ["--color-by and --color"]),
            (["--preset", "stage"], ["'stage'", "studio, town, print"]),
            (["--scalar-bar"], ["--scalar-bar", "no values", "--color-by"]),
            (["--stage", "display:layer=nope"], ["display:layer", "'nope'", "depth", "across"]),
            (["--stage", "display:layer=cell:wind"], ["'cell:wind'"]),
            (["--exr", "a.exr", "--layers", "depth,point:column"], ["--layers", "'point:column'"]),
        ):
            with self.subTest(words):
                self.refused("render", "plane.vtp", "--png", "a.png", *words, status=2, says=says)


if __name__ == "__main__":
    main()
