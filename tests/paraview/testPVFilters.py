# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters that make meshes and images ready for materials, as ParaView's users run them."""

import re
import struct
import sys

import described
import materialScene
import numpy
import pv
from materialScene import AXES
from paraview import servermanager, simple
from relievo import vtkRelievoAnimation, vtkRelievoFilters, vtkRelievoIO
from vtkmodules.util.numpy_support import vtk_to_numpy

# Label, and properties whose values are words.
FILTERS = {
    "TextureCoordinates": ["Mapping", "Up"],
    "Tangents": [],
    "ConvexPolygons": [],
    "HeightsToNormals": ["Kernel", "Encoding"],
    "EnvironmentConvert": ["InputProjection", "OutputProjection"],
    "EnvironmentPrefilter": ["InputProjection"],
    "EnvironmentIrradiance": ["InputProjection"],
    "Caves": ["Content", "Up"],
    "SmoothBlocks": ["Surface", "Normals", "Up", "NoiseDimensions", "OutputPointsPrecision"],
    "VoxelShell": ["Method", "Axis"],
    "VoxelCubes": [],
    "Skin": ["Method"],
    "BoneWeights": [],
    "SurfaceParticles": ["Place"],
    "SunExposure": ["UpAxis"],
    "Cover": [],
    "ViewFactors": [],
    "Viewshed": [],
    "Visibility": [],
}
GROUPS = {
    "Caves": "sources", "ModelReader": "sources", "EXRReaderCore": "internal_sources",
    "EXRWriter": "writers", "EXRExporter": "exporters",
}  # fmt: skip
# Properties whose defaults are ParaView's own.
OWN = {"SurfaceParticles.NoiseSpeed": [-1.0], "SunExposure.UpAxis": [2.0]}


def points(source, name):
    """A point array of a source's output, (points, components)."""
    made = servermanager.Fetch(source)
    found = vtk_to_numpy(made.GetPointData().GetArray(name))
    return found.reshape(made.GetNumberOfPoints(), -1)


def write_heights(name, heights, corner=None, model=1):
    """A TIFF of floats in one strip; with the place of its upper left corner, of cells of 1, and
    the kind of its coordinates (OGC 19-008: 1 projected, 2 degrees)."""
    data = heights.astype("<f4").tobytes()
    rows, columns = heights.shape
    tags = [(256, 4, columns), (257, 4, rows), (258, 3, 32), (259, 3, 1), (262, 3, 1), (273, 4, 8),
            (277, 3, 1), (278, 4, rows), (279, 4, len(data)), (339, 3, 3)]  # fmt: skip
    tags = [(tag, kind, 1, value) for tag, kind, value in tags]
    after = 8 + len(data) + 2 + 12 * (len(tags) + 3) + 4
    place = b""
    if corner:
        tags += [(33550, 12, 3, after), (33922, 12, 6, after + 24), (34735, 3, 8, after + 72)]
        place = struct.pack("<9d8H", 1, 1, 0, 0, 0, 0, *corner, 0, 1, 1, 0, 1, 1024, 0, 1, model)
    path = pv.OUTPUT / name
    path.write_bytes(
        struct.pack("<2sHI", b"II", 42, 8 + len(data)) + data + struct.pack("<H", len(tags))
        + b"".join(struct.pack("<HHII", *tag) for tag in tags) + bytes(4) + place)  # fmt: skip
    return str(path)


class Filters(pv.PluginTest):
    def read_axes(self):
        image = simple.PNGSeriesReader(FileNames=[materialScene.write_axes("axes.png")])
        image.UpdatePipeline()
        return image

    def test_menu_and_texts(self):
        """All are in Filters > Relievo; each property has a text, words where numbers mean some."""
        manager = servermanager.ProxyManager()
        for name, worded in FILTERS.items():
            made = manager.GetPrototypeProxy(GROUPS.get(name, "filters"), f"Relievo{name}")
            menu = made.GetHints().FindNestedElementByName("ShowInMenu")
            self.assertEqual(menu.GetAttribute("category"), "Relievo", name)
            self.assertEqual(made.GetXMLLabel().replace(" ", ""), name)
            self.assertGreater(len(made.GetDocumentation().GetDescription()), 60, name)
            for key in worded:
                self.assertIsNotNone(made.GetProperty(key).FindDomain("vtkSMEnumerationDomain"))
            properties = made.NewPropertyIterator()
            properties.UnRegister(None)
            properties.Begin()
            while not properties.IsAtEnd():
                text = properties.GetProperty().GetDocumentation()
                self.assertIsNotNone(text, f"{name}.{properties.GetKey()}")
                self.assertGreater(len(text.GetDescription().strip()), 8, properties.GetKey())
                properties.Next()

    def test_descriptions(self):
        """Properties have the names, texts and defaults of the described classes."""
        manager = servermanager.ProxyManager()
        compared = 0
        for name in [*FILTERS, "DepthToPoints", *GROUPS]:
            made = manager.GetPrototypeProxy(GROUPS.get(name, "filters"), f"Relievo{name}")
            of_class = made.GetVTKClassName().replace("vtkPV", "vtk")  # some have a subclass
            modules = [vtkRelievoFilters, vtkRelievoAnimation, vtkRelievoIO]
            owner = next(getattr(each, of_class) for each in modules if hasattr(each, of_class))()
            for i in range(getattr(owner, "GetNumberOfParameters", int)()):
                parameter = owner.GetParameterName(i)
                found = made.GetProperty(described.capitalize(parameter).replace("Srgb", "SRGB"))
                self.assertIsNotNone(found, f"{name}.{parameter}")
                text = owner.GetParameterHelp(parameter).removesuffix(" Takes a text.")
                # A control for each number.
                text = re.sub(r" Takes (\d whole numbers with x between|six numbers).*", "", text)
                text = re.sub(r"a date, .*, with (a year .*)\.$", r"\1, a month and a day.", text)
                self.assertEqual(found.GetDocumentation().GetDescription().strip(), text)
            properties = made.NewPropertyIterator()
            properties.UnRegister(None)
            properties.Begin()
            while not properties.IsAtEnd():
                one = properties.GetProperty()
                command = one.GetCommand() or ""
                getter = getattr(owner, command.replace("Set", "Get", 1), None)
                if command.startswith("Set") and getter and hasattr(one, "GetNumberOfElements"):
                    key = f"{name}.{properties.GetKey()}"
                    value = getter()
                    values = list(value) if isinstance(value, (list, tuple)) else [value]
                    shown = [one.GetElement(i) for i in range(one.GetNumberOfElements())]
                    expected = OWN.get(key, ["" if each is None else each for each in values])
                    self.assertEqual(shown, expected, key)
                    compared += 1
                properties.Next()
        self.assertGreater(compared, 80)

    def test_texture_coordinates_and_tangents(self):
        square = simple.Plane(Origin=[0, 0, 0], Point1=[4, 0, 0], Point2=[0, 2, 0])
        placed = simple.TextureCoordinates(
            Input=simple.Triangulate(Input=square), Mapping="Plane", UpAxis="Y", TileSize=2.0
        )
        places = points(placed, "TCoords")
        self.assertEqual(numpy.ptp(places, axis=0).tolist(), [2.0, 1.0])
        placed.TileSize = 0.0
        self.assertEqual(numpy.ptp(points(placed, "TCoords"), axis=0).tolist(), [1.0, 0.5])
        tangents = points(simple.Tangents(Input=placed, TangentsName="along"), "along")
        self.assertLess(numpy.abs(tangents - (1, 0, 0, 1)).max(), 1e-6)

    def test_convex_polygons(self):
        """A dart whose first corner sees too much begins with another."""
        dart = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script="""
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
points, cells = vtkPoints(), vtkCellArray()
for place in ((0, 0, 0), (2, 0, 0), (0.4, 0.4, 0), (0, 2, 0)):
    points.InsertNextPoint(place)
cells.InsertNextCell(4, (1, 2, 3, 0))
output.VTKObject.SetPoints(points)
output.VTKObject.SetPolys(cells)
""")  # fmt: skip
        made = servermanager.Fetch(simple.ConvexPolygons(Input=dart))
        corners = vtk_to_numpy(made.GetPolys().GetConnectivityArray())
        self.assertIn(corners[0], (0, 2))

    def test_heights_to_normals(self):
        slope = simple.Calculator(
            Input=simple.Wavelet(WholeExtent=[0, 8, 0, 8, 0, 0]),
            ResultArrayName="height", Function="0.5*coordsX-0.25*coordsY",
        )  # fmt: skip
        slope.UpdatePipeline()
        made = simple.HeightsToNormals(Input=slope)
        made.Heights = ["POINTS", "height"]
        truth = numpy.array((-0.5, 0.25, 1.0))
        self.assertLess(
            numpy.abs(points(made, "normal") - truth / numpy.linalg.norm(truth)).max(), 1e-6
        )
        made.HeightScale, made.FlipGreen = 2.0, 1
        truth = numpy.array((-1.0, -0.5, 1.0)) / 1.5
        self.assertLess(numpy.abs(points(made, "normal") - truth).max(), 1e-6)
        made.Encoding = "8 bits"
        codes = points(made, "normal")
        self.assertEqual(codes.dtype, numpy.uint8)
        self.assertLess(numpy.abs(codes / 127.5 - 1 - truth).max(), 1 / 254)

    def test_environments(self):
        """The axes' colours in the middle of a cube's faces; levels; light of all sides."""
        axes = self.read_axes()
        cube = simple.EnvironmentConvert(axes, OutputSize=16, InputSRGB=1)
        faces = points(cube, "radiance").reshape(6, 16, 16, 3)
        self.assertLess(numpy.abs(faces[:, 7:9, 7:9] - AXES[:, None, None] / 255).max(), 1e-6)
        levels = simple.EnvironmentPrefilter(axes, Size=16, Levels=3)
        made = servermanager.Fetch(levels)
        sizes = [made.GetBlock(level).GetDimensions() for level in range(3)]
        self.assertEqual(sizes, [(16, 16, 6), (8, 8, 6), (4, 4, 6)])
        rows = servermanager.Fetch(simple.EnvironmentIrradiance(axes))
        first = vtk_to_numpy(rows.GetColumnByName("radiance"))[0]
        # Each colour is light of three of the six sides: half of all, times the first harmonic's
        # integral over the sphere.
        self.assertEqual(rows.GetNumberOfRows(), 9)
        self.assertLess(numpy.abs(first / numpy.sqrt(4 * numpy.pi) - 0.5).max(), 0.01)

    def test_sun_exposure(self):
        """Level ground at an equinox, and below a roof; a wall that faces south."""
        ground = simple.Plane()  # in z = 0, faces z
        sun = simple.SunExposure(
            Input=ground, Latitude=40.0, FirstDay=[2026, 3, 20], LastDay=[2026, 3, 20], Step=10.0
        )
        sun.SkySamples = 64

        def found(name):
            return vtk_to_numpy(servermanager.Fetch(sun).GetCellData().GetArray(name))

        self.assertAlmostEqual(found("sun_hours")[0], 12, delta=0.2)
        self.assertAlmostEqual(
            found("insolation")[0], 24 / numpy.pi * numpy.cos(numpy.radians(40)), delta=0.1)
        self.assertAlmostEqual(found("sky_view")[0], 1, delta=1e-6)
        # A constant result has the highest colour, not the lowest.
        shown = simple.Show(sun)
        simple.Render()
        self.assertEqual(list(shown.ColorArrayName), ["CELLS", "sun_hours"])
        for name in ("sun_hours", "insolation"):
            simple.ColorBy(shown, ("CELLS", name))
            ends = list(shown.LookupTable.RGBPoints)[::4]
            self.assertEqual(ends[0], 0)
            self.assertAlmostEqual(ends[-1], found(name)[0], delta=1e-3 * found(name)[0])
        # A range that the user sets stays, however small.
        shown.LookupTable.AutomaticRescaleRangeMode = "Never"
        shown.LookupTable.RescaleTransferFunction(5.0, 5.0005)
        simple.Render()
        self.assertEqual(list(shown.LookupTable.RGBPoints)[0], 5)
        simple.Hide(sun)
        roofs = [
            simple.Plane(Origin=[-99, y, 0.1], Point1=[99, y, 0.1], Point2=[-99, y + 99, 0.1])
            for y in (-99, 0)
        ]
        sun.Occluders = roofs
        self.assertEqual(found("sun_hours")[0], 0)
        sun.Occluders = []
        sun.UpAxis = "Y"  # north is -z: the ground is a wall that faces south
        # On the equator the sun's cosine to the south is sin(40) times that of its hour.
        self.assertAlmostEqual(found("sun_hours")[0], 12, delta=0.2)
        self.assertAlmostEqual(
            found("insolation")[0], 24 / numpy.pi * numpy.sin(numpy.radians(40)), delta=0.1)
        sun.FirstDay = sun.LastDay = [2026, 6, 21]
        # At midsummer it is south of east and west while cos(hour) > tan(declination) / tan(40).
        half = numpy.arccos(numpy.tan(numpy.radians(23.44)) / numpy.tan(numpy.radians(40)))
        self.assertAlmostEqual(found("sun_hours")[0], 24 / numpy.pi * half, delta=0.35)

    def test_cover(self):
        """Of two places, the one in front of the larger of two plates, then both."""
        plates = simple.AppendGeometry(Input=[
            simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0]),
            simple.Plane(Origin=[5, 0, 0], Point1=[7, 0, 0], Point2=[5, 1, 0]),
        ])  # fmt: skip
        places = simple.Line(Point1=[0.5, 0.5, 1], Point2=[6, 0.5, 1], Resolution=1)
        cover = simple.Cover(Input=plates, Candidates=places, NumberOfPlaces=1, LargestAngle=45.0)
        cover.UpdatePipeline()
        chosen = cover.GetClientSideObject().GetOutputDataObject(1)
        self.assertEqual(chosen.GetNumberOfPoints(), 1)
        self.assertEqual(chosen.GetPoint(0), (6, 0.5, 1))
        share = servermanager.Fetch(cover).GetFieldData().GetArray("share").GetValue(0)
        self.assertAlmostEqual(share, 2 / 3)
        cover.NumberOfPlaces = 2
        covered = servermanager.Fetch(cover).GetCellData().GetArray("covered")
        self.assertEqual([covered.GetValue(i) for i in (0, 1)], [1, 1])

    def test_view_factors(self):
        """Parallel squares at the distance of their side, and a screen between them."""
        plates = simple.AppendGeometry(Input=[
            simple.Calculator(
                Input=plane, AttributeType="Cell Data", ResultArrayName="plate", Function=number)
            for plane, number in (
                (simple.Plane(Origin=[0, 0, 0], Point1=[1, 0, 0], Point2=[0, 1, 0]), "0"),
                (simple.Plane(Origin=[0, 0, 1], Point1=[0, 1, 1], Point2=[1, 0, 1]), "1"))
        ])  # fmt: skip
        found = simple.ViewFactors(Input=plates, Groups="plate", Tolerance=0.005)

        def column(name):
            return vtk_to_numpy(servermanager.Fetch(found).GetColumnByName(name))

        # J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11.
        root = numpy.sqrt(2)
        truth = 2 / numpy.pi * (
            numpy.log(2 / numpy.sqrt(3)) + 2 * root * numpy.arctan(1 / root) - numpy.pi / 2)
        expected = {(0, 1): truth, (1, 0): truth, (0, 0): 0, (1, 1): 0,
                    (0, -1): 1 - truth, (1, -1): 1 - truth, (0, -2): 0, (1, -2): 0}  # fmt: skip
        pairs = list(zip(column("from"), column("to"), strict=True))
        self.assertEqual(set(pairs), set(expected))
        for pair, factor, bound in zip(pairs, column("factor"), column("bound"), strict=True):
            self.assertLessEqual(bound, 0.005)
            self.assertLess(abs(factor - expected[pair]), bound, pair)
        self.assertLess(numpy.abs(column("area") - 1).max(), 1e-12)
        found.Occluders = [simple.Plane(
            Origin=[-99, -99, 0.5], Point1=[99, -99, 0.5], Point2=[-99, 99, 0.5])]  # fmt: skip
        others = column("factor")[column("to") == -2]
        self.assertGreater(others.min(), 0.99)

    def test_viewshed(self):
        """A terrain of a GeoTIFF: from a height h, a ridge of height H at a distance x hides level
        ground to x h/(h - H). Only TIFFs that can be read as terrains are offered."""
        heights = numpy.zeros((3, 200))
        heights[:, 60] = 8
        file = write_heights("terrain.tif", heights, (689299.5, 5337202.5))
        picture = write_heights("picture.tif", heights)
        degrees = write_heights("degrees.tif", heights, (11.5, 48.1), 2)
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        session = servermanager.ActiveConnection.Session
        for path, offered in ((file, True), (picture, False), (degrees, False)):
            readers = factory.GetReaders(path, session)
            names = [readers.GetString(i) for i in range(readers.GetNumberOfStrings())]
            self.assertEqual("RelievoTerrainReader" in names, offered, path)
        terrain = simple.TerrainReader(FileName=file)
        places = vtk_to_numpy(servermanager.Fetch(terrain).GetPoints().GetData())
        numpy.testing.assert_array_equal(places[:, 2], heights.ravel())
        numpy.testing.assert_array_equal(places[[0, -1], :2],
                                         [(689300, 5337202), (689499, 5337200)])  # fmt: skip
        shed = simple.Viewshed(Input=terrain)
        self.assertEqual(list(shed.Observers), [689399.5, 5337201, 2])
        shed = simple.Viewshed(Input=terrain, Observers=[689300, 5337201, 12])
        along = numpy.arange(200)
        near = (along <= 60) | (along >= 180)
        numpy.testing.assert_array_equal(points(shed, "seen").reshape(3, 200)[1], near)
        shed.Observers = [689300, 5337201, 12, 689499, 5337201, 100]
        far = (along >= 60) | (along <= 199 - 139 * 100 / 92)
        numpy.testing.assert_array_equal(
            points(shed, "seen").reshape(3, 200)[1], near.astype(int) + far)
        shed.FarthestDistance = 50
        numpy.testing.assert_array_equal(
            points(shed, "seen").reshape(3, 200)[1], (along <= 50).astype(int) + (along >= 149))
        shed.FarthestDistance = 0
        shed.Observers = [689300, 5337201, 12]
        shed.Occluders = [simple.Plane(
            Origin=[689310.5, 5337190, 0], Point1=[689310.5, 5337210, 0],
            Point2=[689310.5, 5337190, 99])]  # fmt: skip
        numpy.testing.assert_array_equal(points(shed, "seen").reshape(3, 200)[1], along <= 10)

    def test_sun_exposure_takes_the_views_up(self):
        """At first, but where the mesh is low."""
        view = simple.CreateView("RenderView")
        self.addCleanup(simple.Delete, view)
        simple.SetActiveView(view)
        for up, box, axis in (
            ([0, 1, 0], [1, 2, 1], "Y"),
            ([0.1, 0.2, 0.9], [1, 2, 1], "Z"),
            ([0, 1, 0], [9, 9, 1], "Z"),
        ):
            view.CameraViewUp = up
            source = simple.Box(XLength=box[0], YLength=box[1], ZLength=box[2])
            self.assertEqual(simple.SunExposure(Input=source).UpAxis, axis)
        given = simple.SunExposure(Input=source, UpAxis="X")
        self.assertEqual(given.UpAxis, "X")

    def test_visibility(self):
        """A square's solid angle in closed form; occluders; all around; points."""
        square = simple.Plane()
        seen = simple.Visibility(Input=square, Position=[0, 0, 2], Size=[400, 400])
        seen.ViewAngle = 60.0

        def found(name):
            return vtk_to_numpy(servermanager.Fetch(seen).GetCellData().GetArray(name))

        expected = 4 * numpy.arctan(0.25 / (2 * numpy.sqrt(0.5 + 4)))
        self.assertEqual(found("seen").tolist(), [1])
        shown = simple.Show(seen)
        simple.Render()
        self.assertEqual(list(shown.ColorArrayName), ["CELLS", "seen"])
        self.assertEqual(list(shown.LookupTable.RGBPoints)[::4][::2], [0, 1])  # all seen looks seen
        simple.Hide(seen)
        self.assertAlmostEqual(found("solid_angle")[0], expected, delta=0.01 * expected)
        # The height of 400 spans 60 degrees 2 away, in pixels by hand.
        side = 200 / (2 * numpy.tan(numpy.radians(30)))
        self.assertAlmostEqual(found("pixels")[0], side**2, delta=2 * side)
        seen.MakeCloud = 1
        cloud = servermanager.Fetch(seen, idx=1)
        self.assertEqual(cloud.GetNumberOfPoints(), found("pixels")[0])
        seen.Lens = "equirectangular"
        seen.Size = [800, 400]
        self.assertAlmostEqual(found("solid_angle")[0], expected, delta=0.02 * expected)
        # Aimed 30 degrees aside, a picture twice as wide as high that spans 60 degrees of height:
        # lying it sees all, standing the half from its middle on.
        seen.Lens = "pinhole"
        seen.Size = [400, 200]
        seen.FocalPoint = [2 * numpy.tan(numpy.radians(30)), 0, 0]
        self.assertAlmostEqual(found("solid_angle")[0], expected, delta=0.03 * expected)
        seen.ViewUp = [1, 0, 0]
        self.assertAlmostEqual(found("solid_angle")[0], expected / 2, delta=0.03 * expected)
        seen.Occluders = simple.Plane(Origin=[-1, -1, 1], Point1=[1, -1, 1], Point2=[-1, 1, 1])
        self.assertEqual(found("seen").tolist(), [0])

    def test_where_visibility_begins(self):
        """Above the middle of its input, which a sphere's picture of the view angle just holds."""
        ball = simple.Sphere(Center=[100, -50, 7], Radius=3, ThetaResolution=60, PhiResolution=60)
        ball.UpdatePipeline()
        seen = simple.Visibility(Input=ball)
        self.assertEqual(list(seen.FocalPoint), [100, -50, 7])
        away = numpy.linalg.norm((3, 3, 3)) / numpy.sin(numpy.radians(15))
        numpy.testing.assert_allclose(seen.Position, (100, -50, 7 + away), rtol=1e-3)
        cells = servermanager.Fetch(seen).GetCellData()
        angle = vtk_to_numpy(cells.GetArray("solid_angle")).sum()
        cap = 2 * numpy.pi * (1 - numpy.sqrt(1 - (3 / away) ** 2))
        self.assertAlmostEqual(angle, cap, delta=0.01 * cap)
        chosen = simple.Visibility(Input=ball, Position=[100, -60, 7])
        self.assertEqual(list(chosen.Position), [100, -60, 7])

    def test_lens_of_a_file(self):
        """Its size counts unless one is said: 100 pixels for a unit that is 2 away."""
        path = pv.OUTPUT / "visibility.yml"
        path.write_text(
            "%YAML:1.0\nimage_width: 300\nimage_height: 200\n"
            "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
            "   data: [ 200., 0., 149.5, 0., 200., 99.5, 0., 0., 1. ]\n"
        )
        seen = simple.Visibility(Input=simple.Plane(), Position=[0, 0, 2], Lens=str(path))
        for size, side in (([0, 0], 100), ([600, 400], 200)):
            seen.Size = size
            pixels = vtk_to_numpy(servermanager.Fetch(seen).GetCellData().GetArray("pixels"))
            self.assertAlmostEqual(pixels[0], side**2, delta=2 * side)

    def test_smooth_blocks(self):
        """Labels on points; lists of labels; the seams are the second output."""
        wavelet = simple.Wavelet(WholeExtent=[0, 12, 0, 12, 0, 12])
        labels = simple.Calculator(Input=wavelet, ResultArrayName="labels")
        labels.Function = "(coordsX>4)+2*(coordsY>6)"
        labels.ResultArrayType = "Int"
        blocks = simple.SmoothBlocks(Input=labels)
        blocks.Labels = ["POINTS", "labels"]
        blocks.Surface = "Between labels"
        blocks.UpdatePipeline()
        smooth = servermanager.Fetch(blocks)
        self.assertGreater(smooth.GetNumberOfPolys(), 500)
        self.assertIsNotNone(smooth.GetCellData().GetArray("neighbor"))
        seams = servermanager.Fetch(blocks, idx=1)
        self.assertGreater(seams.GetNumberOfLines(), 13)
        self.assertGreater(vtk_to_numpy(seams.GetCellData().GetArray("uses")).min(), 2)
        blocks.RigidLabels = [1, 2, 3]
        blocks.UpdatePipeline()
        moved = vtk_to_numpy(servermanager.Fetch(blocks).GetPoints().GetData()) - 0.5
        self.assertEqual(numpy.abs(moved - numpy.round(moved)).max(), 0)
        blocks.RigidLabels = []
        blocks.UpdatePipeline()
        moved = vtk_to_numpy(servermanager.Fetch(blocks).GetPoints().GetData()) - 0.5
        self.assertGreater(numpy.abs(moved - numpy.round(moved)).max(), 0.2)

    def test_caves(self):
        """A source: its labels make a surface of blocks, its density a contour between them."""
        caves = simple.Caves(Size=[40, 40, 20], Seed=3, Content="Labels")
        labels = points(caves, "label")
        self.assertEqual(sorted(set(labels.ravel())), [0, 1])
        blocks = simple.SmoothBlocks(Input=caves)
        blocks.UpdatePipeline()
        self.assertGreater(servermanager.Fetch(blocks).GetNumberOfPolys(), 1000)
        caves.Content = "Density"
        density = points(caves, "density")
        self.assertTrue(((density < 0) == (labels == 0)).all())
        caves.Origin = [1e7, 0, 0]
        self.assertTrue((density != points(caves, "density")).any())

    def test_voxel_shell(self):
        """Cells of a ball in a composite, and of a cut one, which is open; cubes with its data."""
        ball = simple.Sphere(ThetaResolution=60, PhiResolution=60)
        shell = simple.VoxelShell(Input=simple.GroupDatasets(Input=[ball]), Resolution=40)
        shell.Distances = 1
        image = servermanager.Fetch(shell)
        self.assertEqual(image.GetNumberOfCells(), 40**3)
        mask = vtk_to_numpy(image.GetCellData().GetArray("mask"))
        self.assertLess(abs(mask.sum() / 40**3 - numpy.pi / 6), 0.005)
        self.assertEqual(image.GetFieldData().GetArray("closed").GetTuple1(0), 1)
        self.assertIsNotNone(image.GetCellData().GetArray("front"))
        shell.Method = "Six views"
        seen = vtk_to_numpy(servermanager.Fetch(shell).GetCellData().GetArray("mask"))
        self.assertLess(abs(int(seen.sum()) - int(mask.sum())), 0.002 * mask.sum())
        cut = simple.Sphere(ThetaResolution=60, PhiResolution=60, StartPhi=20)
        holed = servermanager.Fetch(simple.VoxelShell(Input=cut, Resolution=40))
        self.assertEqual(holed.GetFieldData().GetArray("closed").GetTuple1(0), 0)
        self.assertGreater(holed.GetFieldData().GetArray("open_columns").GetComponent(0, 2), 50)
        cubes = servermanager.Fetch(simple.VoxelCubes(Input=shell, Model=ball, Transition=0.05))
        sizes = vtk_to_numpy(cubes.GetPointData().GetArray("size"))
        self.assertEqual((sizes.max(), sizes.min() < 0.5), (1, True))
        self.assertIsNotNone(cubes.GetPointData().GetArray("Normals"))

    def test_surface_particles(self):
        """On a ball, at all times; the animation has its steps; points and a field of another."""
        ball = simple.Sphere(ThetaResolution=60, PhiResolution=60)
        made = simple.SurfaceParticles(Input=ball, NumberOfParticles=500, Resolution=50)
        made.NumberOfSteps = 20
        self.assertEqual(made.NoiseSpeed, -1)
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        self.assertEqual(len(scene.TimeKeeper.TimestepValues), 21)
        places = []
        for time in (0, 20, 20.0, 0):
            made.UpdatePipeline(time)
            here = vtk_to_numpy(servermanager.Fetch(made).GetPoints().GetData())
            self.assertLess(numpy.abs(numpy.linalg.norm(here, axis=1) - 0.5).max(), 0.02)
            places.append(here)
        self.assertGreater(numpy.abs(places[1] - places[0]).max(), 0.05)
        self.assertTrue((places[3] == places[0]).all() and (places[1] == places[2]).all())
        upwards = simple.Calculator(Input=simple.Wavelet(), Function="kHat", ResultArrayName="up")
        other = simple.SurfaceParticles(Input=ball, Points=simple.Plane(), Field=upwards)
        other.NoiseSpeed, other.FieldArray = 0, "up"
        other.UpdatePipeline(50)
        top = servermanager.Fetch(other)
        self.assertEqual(top.GetNumberOfPoints(), 4)
        self.assertGreater(vtk_to_numpy(top.GetPoints().GetData())[:, 2].min(), 0.45)
        # By default they are as fast as the data are large.
        self.assertGreater(self.way(0.5), 0.001)
        self.assertAlmostEqual(self.way(50) / self.way(0.5), 100, delta=10)
        nothing = simple.Threshold(Input=simple.Wavelet(), LowerThreshold=1e6, UpperThreshold=2e6)
        none = simple.SurfaceParticles(Input=nothing)
        none.UpdatePipeline(1)
        self.assertEqual(servermanager.Fetch(none).GetNumberOfPoints(), 0)

    def test_what_is_shown_at_first(self):
        """Results of filters are visible as soon as they are shown; the user's choices stay."""
        ball = simple.Sphere(ThetaResolution=60, PhiResolution=60)
        shell = simple.VoxelShell(Input=ball, Resolution=20)
        cubes = simple.VoxelCubes(Input=shell)
        seen = simple.Visibility(Input=ball)
        for source, kind, array in (
            (simple.SunExposure(Input=ball), "Surface", ("CELLS", "sun_hours")),
            (seen, "Surface", ("CELLS", "seen")),
            (simple.Caves(), "Volume", ("POINTS", "cave")),
            (shell, "Volume", ("CELLS", "mask")),
            (cubes, "3D Glyphs", None),
        ):
            view = simple.CreateView("RenderView", ViewSize=[300, 300])
            view.OrientationAxesVisibility = 0
            empty = pv.picture(view)
            shown = simple.Show(source, view)
            view.ResetCamera()
            with self.subTest(source.SMProxy.GetXMLLabel()):
                self.assertEqual(shown.Representation, kind)
                if array:
                    self.assertEqual(tuple(shown.ColorArrayName), array)
                seen = pv.picture(view)
                self.differ(seen, empty, "seen", share=0.05)
                pv.write(pv.OUTPUT / f"{source.SMProxy.GetXMLName()}.png", seen)
                if kind == "Volume":
                    self.assertEqual(shown.Shade, 1)
                elif kind == "3D Glyphs":
                    self.assertEqual((shown.Scaling, shown.ScaleFactor), (1, 1))
                    self.assertEqual(shown.GlyphType.SMProxy.GetXMLName(), "CubeSource")
                second = simple.CreateView("RenderView")
                other = simple.Show(source, second, Representation="Outline")
                self.assertEqual(other.Representation, "Outline")

    def test_messages_name_no_code(self):
        """Errors are described in the words of menus and panels."""
        said = pv.run(__file__, "invalid")
        parts = said.split("case ")[1:]
        self.assertEqual(len(parts), 14, said)
        for part in parts:
            self.assertEqual(len(pv.messages(part)), 1, part)
            self.assertNotRegex(part, pv.NAMES_OF_CODE)
            self.assertNotIn("has pixels", part)

    def way(self, radius):
        """How far particles go in a step, in the mean."""
        ball = simple.Sphere(Radius=radius, ThetaResolution=60, PhiResolution=60)
        made = simple.SurfaceParticles(Input=ball, NumberOfParticles=500, Resolution=200)
        places = []
        for time in (0, 1):
            made.UpdatePipeline(time)
            places.append(vtk_to_numpy(servermanager.Fetch(made).GetPoints().GetData()).copy())
        return numpy.linalg.norm(places[1] - places[0], axis=1).mean()


def begin(name):
    sys.stdout.flush()
    print("case", name, file=sys.stderr, flush=True)


def apply(source):
    """As the window's button does."""
    simple.Show(source)
    simple.Render()


def refuse_inputs():
    """Each of these filters with an input that it refuses."""
    pv.load()
    image, ball = simple.Wavelet(), simple.Sphere()
    empty = simple.PassArrays(Input=image)
    strips = simple.TriangleStrips(Input=simple.TextureCoordinates(Input=ball))
    for name, given in (
        ("SmoothBlocks", image),
        ("SmoothBlocks", empty),
        ("HeightsToNormals", empty),
        ("EnvironmentConvert", empty),
        ("VoxelCubes", image),
        ("TextureCoordinates", strips),
        ("Tangents", strips),
        ("Tangents", ball),
    ):
        begin(name)
        apply(getattr(simple, name)(Input=given))
    for given in (
        {"Lens": "orthographic"},
        {"Position": [0, 0, 5], "ViewUp": [0, 0, 1]},
        {"ViewUp": [0, 0, 0]},
        {"Position": [1, 2, 3], "FocalPoint": [1, 2, 3]},
    ):
        begin("Visibility")
        seen = simple.Visibility(Input=ball, **given)
        apply(seen)
        if servermanager.Fetch(seen).GetCellData().HasArray("pixels"):
            print("has pixels", file=sys.stderr, flush=True)
    begin("SunExposure")
    apply(simple.SunExposure(Input=ball, LastDay=[2026, 2, 30]))
    begin("Caves")
    apply(simple.Caves(MemoryLimit=1000.0))


if sys.argv[1:2] == ["invalid"]:
    refuse_inputs()
    pv.leave()
elif __name__ == "__main__":
    pv.main()
