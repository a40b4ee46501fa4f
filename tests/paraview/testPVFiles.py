# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenEXR through File > Open, Save Data and Export View: files are read back bit for bit.

With the word `provoke`: requests that must be refused.
"""

import locale
import sys
import tempfile

import judge
import layers
import locales
import numpy
import pv
import stage
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

NAMES = "color depth range normal geometric_normal position albedo actor block cell".split()


def fields(image):
    """The image's numbers of field data by name."""
    data = image.GetFieldData()
    return {
        data.GetArray(i).GetName(): vtk_to_numpy(data.GetArray(i)).ravel().tolist()
        for i in range(data.GetNumberOfArrays())
        if data.GetArray(i)
    }


def opened(path):
    """A file as File > Open opens it, and its image."""
    reader = simple.OpenDataFile(str(path))
    return reader, layers.image(reader)


class Files(judge.StageTest):
    def check(self, found, expected, what):
        for name, values in expected.items():
            with self.subTest(f"{what}: {name}"):
                self.assertEqual(found[name].dtype, values.dtype)
                if name == "position":  # float, relative to an origin in the file
                    self.assertLess(numpy.abs(found[name] - values).max(), 4e-7)
                else:
                    self.assertTrue(layers.alike(found[name], values).all())

    def test_saved_layers_are_read_back(self):
        source = simple.RelievoLayers(View=self.view, Layers=[*NAMES, "Normals"])
        image = layers.image(source)
        path = pv.OUTPUT / "saved.exr"
        simple.SaveData(str(path), source)
        _, back = opened(path)
        self.check(layers.arrays(back), layers.arrays(image), "saved")
        kept, given = fields(back), fields(image)
        for name in ("worldToCamera", "worldToNDC", "near", "far", "relievo:origin"):
            self.assertEqual(kept[name], given[name], name)
        self.assertTrue(back.GetFieldData().HasArray("lights"))
        # A second time nothing is rounded, positions neither.
        again = pv.OUTPUT / "again.exr"
        simple.SaveData(str(again), simple.GetActiveSource())
        self.assertEqual(path.read_bytes(), again.read_bytes())
        points = simple.DepthToPoints(Input=simple.GetActiveSource())
        points.UpdatePipeline()
        self.assertEqual(
            points.GetDataInformation().GetNumberOfPoints(),
            numpy.isfinite(layers.arrays(image)["depth"]).sum(),
        )

    def test_an_exported_view_has_its_picture_and_layers(self):
        path = pv.OUTPUT / "exported.exr"
        picture = pv.picture(self.view)
        simple.ExportView(str(path), view=self.view)
        _, image = opened(path)
        source = simple.RelievoLayers(View=self.view, Layers=["color", "depth", "normal"])
        found = layers.arrays(image)
        self.assertEqual(sorted(found), ["color", "depth", "normal"])
        self.check(found, layers.arrays(source), "exported")
        camera, own = (fields(each)["worldToCamera"] for each in (image, layers.image(source)))
        self.assertEqual(camera, own)
        self.same(pv.picture(self.view), picture, "the view")
        simple.ExportView(str(path), view=self.view, Layers=["position", "cell"], Compression="PIZ")
        found = layers.arrays(opened(path)[1])
        self.assertEqual(sorted(found), ["cell", "position"])

    def test_channels_are_chosen_and_series_have_times(self):
        paths = []
        for step, radius in enumerate((0.8, 0.5)):
            self.scene.ball.Radius = radius
            paths.append(str(pv.OUTPUT / f"series{step}.exr"))
            simple.ExportView(paths[-1], view=self.view)
        near = [layers.arrays(opened(path)[1])["depth"][:105].min() for path in paths]
        self.assertGreater(near[1] - near[0], 0.2)
        series = simple.OpenDataFile(paths)
        self.assertEqual(list(series.TimestepValues), [0.0, 1.0])
        for time, depth in enumerate(near):
            series.UpdatePipeline(time)
            data = simple.FetchData(series)[0]
            self.assertEqual(layers.arrays(data)["depth"][:105].min(), depth)
        reader, _ = opened(paths[0])
        self.assertEqual(
            sorted(reader.Channels.Available),
            ["A", "B", "G", "R", "depth.Z", "normal.X", "normal.Y", "normal.Z"],
        )
        reader.Channels = ["depth.Z"]
        self.assertEqual(list(layers.arrays(reader)), ["depth"])

    def test_locales(self):
        """Numbers in text, of files and of field data, where the user's have a comma."""
        text = pv.OUTPUT / "a.x"
        text.write_text("xof 0303txt 0032\nMesh a {\n3;\n0.25;0.25;0.5;,\n1.75;0.5;0.5;,\n"
                        "0.5;1.75;0.5;;\n1;\n3;0,1,2;;\n}\n")
        self.addCleanup(locale.setlocale, locale.LC_ALL, locale.setlocale(locale.LC_ALL))
        with tempfile.TemporaryDirectory() as folder:
            locales.make(folder)
            for name in locales.NAMES:
                locale.setlocale(locale.LC_ALL, name)
                model = simple.ModelWithBonesReader(FileName=str(text))
                model.UpdatePipeline()
                bounds = numpy.abs(model.GetDataInformation().GetBounds())
                self.assertEqual(sorted(bounds), [0.25, 0.25, 0.5, 0.5, 1.75, 1.75])
                source = simple.RelievoLayers(View=self.view, Layers=["depth"])
                path = pv.OUTPUT / "locale.exr"
                simple.SaveData(str(path), source)
                _, back = opened(path)
                self.check(layers.arrays(back), layers.arrays(layers.image(source)), name)

    def test_the_menus_know_them(self):
        session = servermanager.ActiveConnection.Session
        manager = servermanager.vtkSMProxyManager.GetProxyManager()
        readers = manager.GetReaderFactory()
        self.assertIn("OpenEXR Images (*.exr)", readers.GetSupportedFileTypes(session))
        source = simple.RelievoLayers(View=self.view)
        source.UpdatePipeline()
        writers = manager.GetWriterFactory()
        types = writers.GetSupportedFileTypes(source.SMProxy, 0)
        self.assertIn("OpenEXR Images(*.exr )", types)
        self.assertNotIn("exr", writers.GetSupportedFileTypes(self.scene.ball.SMProxy, 0))
        exporters = servermanager.vtkSMViewExportHelper()
        self.assertIn(
            "OpenEXR Layers (*.exr)", exporters.GetSupportedFileTypes(self.view.SMProxy)
        )
        proxies = session.GetSessionProxyManager()
        for group, name in (("sources", "RelievoLayers"), ("filters", "RelievoDepthToPoints")):
            hints = proxies.GetPrototypeProxy(group, name).GetHints()
            menu = hints.FindNestedElementByName("ShowInMenu")
            self.assertEqual(menu.GetAttribute("category"), "Relievo")

    def test_everything_has_a_text(self):
        proxies = servermanager.ActiveConnection.Session.GetSessionProxyManager()
        for group, name in (
            ("sources", "RelievoLayers"),
            ("sources", "RelievoEXRReader"),
            ("writers", "RelievoEXRWriter"),
            ("exporters", "RelievoEXRExporter"),
            ("filters", "RelievoDepthToPoints"),
        ):
            proxy = proxies.GetPrototypeProxy(group, name)
            self.assertTrue(proxy.GetDocumentation().GetShortHelp(), name)
            self.assertTrue(proxy.GetDocumentation().GetDescription().strip(), name)
            each = proxy.NewPropertyIterator()
            each.UnRegister(None)
            each.Begin()
            while not each.IsAtEnd():
                text = each.GetProperty().GetDocumentation()
                if not each.GetProperty().GetInformationOnly():
                    self.assertTrue(text and text.GetDescription().strip(), each.GetKey())
                each.Next()

    def test_what_cannot_be_is_said_once(self):
        (pv.OUTPUT / "words.exr").write_text("no picture")
        said = pv.run(__file__, "provoke", pv.OUTPUT)
        parts = dict(part.split("\n", 1) for part in said.split("--- ")[1:])
        for part, words in (
            ("export", "no file can be made in its folder"),
            ("save", "no file can be made in its folder"),
            ("no layers", "no layer is chosen"),
            ("unknown layer", "'nonsense' cannot be read"),
            ("two tones", "tones can be mapped only once"),
        ):
            self.assertEqual(len(pv.messages(parts[part])), 1, said)
            self.assertIn(words, parts[part])
        self.assertIn("No reader found", parts["words"])
        self.assertIn("ParaView's own True", parts["two tones"])
        self.assertFalse((pv.OUTPUT / "none.exr").exists())


def provoke(folder):
    pv.load()
    scene = stage.Stage()
    scene.render()

    def now(what):
        sys.stdout.flush()
        print("---", what, file=sys.stderr, flush=True)

    now("export")
    simple.ExportView("/nowhere/x.exr", view=scene.view)
    now("save")
    simple.SaveData("/nowhere/x.exr", simple.RelievoLayers(View=scene.view))
    now("no layers")
    simple.ExportView(f"{folder}/none.exr", view=scene.view, Layers=[])
    now("unknown layer")
    simple.ExportView(f"{folder}/none.exr", view=scene.view, Layers=["color", "nonsense"])
    now("two tones")
    scene.view.UseToneMapping = 1
    own = pv.picture(scene.view)
    scene.view.RelievoStageTone = 1
    same = [(pv.picture(scene.view) == own).all() for _ in range(2)]
    print("ParaView's own", all(same), file=sys.stderr)
    now("words")
    try:
        simple.OpenDataFile(f"{folder}/words.exr")
    except RuntimeError as refused:
        print(refused, file=sys.stderr)


if sys.argv[1:2] == ["provoke"]:
    provoke(sys.argv[2])
    pv.leave()
elif __name__ == "__main__":
    pv.main()
