# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Materials as properties of representations: maps change the picture as the truth says."""

import math
import pathlib

import described
import materialScene
import numpy
import pv
from materialScene import LIGHT, lean
from paraview import simple, smstate, smtrace

SCENE = pathlib.Path(__file__).with_name("materialScene.py")

# Every property of a representation: default, another value as a script gives it.
PROPERTIES = {
    **described.of_material(),
    "RelievoMaterial": (0, 1),
    "RelievoNormalMap": ("", "map.png"),
    "RelievoHeightMap": ("", "map.png"),
    "RelievoMirror": (0, 1),
}


class Materials(pv.PluginTest):
    def setUp(self):
        super().setUp()
        self.scene = materialScene.Scene()
        self.view, self.shown = self.scene.view, self.scene.shown

    def shade(self, cosine, what, scene=None):
        """The middle of the picture has the grey of that cosine between normal and light."""
        grey = (scene or self.scene).middle()[0]
        truth = 255 * LIGHT * max(cosine, 0.0)
        self.assertLess(numpy.abs(grey - truth).max(), 1.5, f"{what}: {grey}, expected {truth:.1f}")

    def test_properties_of_all_surfaces(self):
        """The same defaults in all, a text for each; nothing changes while nothing is given."""
        block = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
        kinds = [
            block,
            simple.Tetrahedralize(Input=block),
            simple.WarpByVector(Input=simple.Calculator(
                Input=block, ResultArrayName="flow", Function="0.1*coordsY*iHat")),
            simple.GroupDatasets(Input=[self.scene.square, simple.Sphere()]),
        ]  # fmt: skip
        for source in kinds:
            shown = simple.Show(source, self.view)
            known = [name for name in shown.ListProperties() if name.startswith("Relievo")]
            for name in known:
                self.assertGreater(len(getattr(type(shown), name).__doc__.strip()), 15, name)
            points = ("RelievoLamp", "RelievoFog", "RelievoMarker")
            known = [name for name in known if not name.startswith(points)]
            self.assertEqual(sorted(known), sorted(PROPERTIES), source)
            defaults = {name: first for name, (first, _) in PROPERTIES.items()}
            self.assertEqual(pv.values(shown, PROPERTIES), defaults)
            for name in PROPERTIES:
                self.assertGreater(len(getattr(type(shown), name).__doc__.strip()), 15, name)
            simple.Delete(shown)
        own = pv.picture(self.view)
        self.shown.RelievoMaterial = 1
        self.shown.RelievoMirror = 1  # there is no environment
        self.same(pv.picture(self.view), own, "on, and nothing given")

    def test_normals(self):
        """Known normals in known light; off, it is the first picture."""
        own = pv.picture(self.view)
        self.shade(1.0, "plain")
        self.shown.RelievoMaterial = 1
        for degrees in (0, 20, 50):
            name = materialScene.write_normals(f"lean{degrees}.png", lean(degrees, 30))
            self.shown.RelievoNormalMap = name
            self.shade(math.cos(math.radians(degrees)), f"{degrees} degrees")
        self.shown.RelievoNormalStrength = 0.5
        x, y, z = lean(50, 30) * (0.5, 0.5, 1.0)
        self.shade(z / math.hypot(x, y, z), "half as strong")
        self.shown.RelievoMaterial = 0
        self.same(pv.picture(self.view), own, "off")
        self.shown.RelievoMaterial, self.shown.RelievoNormalMap = 1, ""
        self.same(pv.picture(self.view), own, "without a map")

    def test_which_way_normals_lean(self):
        """Along u and v of the square, which are x and y; green is turned where it is asked for."""
        light = lean(40, 70)
        scene = materialScene.Scene(light=light)
        scene.shown.RelievoMaterial = 1
        scene.shown.RelievoNormalMap = materialScene.write_normals("v.png", lean(35, 100))
        self.shade(lean(35, 100) @ light, "green up", scene)
        scene.shown.RelievoFlipGreen = 1
        self.shade(lean(35, -100) @ light, "green down", scene)

    def test_heights(self):
        """A ramp has its slope; a ground below is seen smaller through the square, and deeper."""
        ramp = numpy.broadcast_to(numpy.linspace(0, 1, 52), (52, 52))
        shown = self.shown
        shown.RelievoMaterial, shown.RelievoReliefMethod = 1, "Off"
        shown.RelievoHeightMap = materialScene.write_heights("ramp.png", ramp)
        shown.RelievoHeightScale, shown.RelievoRepeat = 0.5, 0
        slope = 0.5 * 52 / 51  # from the first texel's middle to the last's
        self.shade(1 / math.hypot(slope, 1), "a ramp")
        shown.RelievoHeightRange = [0.0, 2.0]
        self.shade(1 / math.hypot(slope / 2, 1), "half as high")

        shown.RelievoMaterial, shown.RelievoHeightRange = 0, [0.0, 0.0]
        square = pv.picture(self.view)[..., 0] > 0
        shown.RelievoMaterial, shown.RelievoReliefMethod = 1, "Relief"
        shown.RelievoHeightMap = materialScene.write_heights("ground.png", numpy.zeros((8, 8)))
        shown.RelievoClipAtBorders = shown.RelievoDepthCorrection = 1
        ground = pv.picture(self.view)[..., 0] > 0
        smaller = materialScene.DISTANCE / (materialScene.DISTANCE + 0.5)
        rows, columns = ground.any(axis=1).sum(), ground.any(axis=0).sum()
        self.assertLess(abs(rows - square.any(axis=1).sum() * smaller), 2)
        self.assertLess(abs(columns - square.any(axis=0).sum() * smaller), 2)
        self.view.RelievoDisplayLayer, self.view.RelievoDisplayGrey = "depth", 1
        self.view.RelievoDisplayRange = [materialScene.DISTANCE, materialScene.DISTANCE + 1.0]
        depth = self.scene.middle()[0] / 255
        self.assertLess(numpy.abs(depth - 0.5).max(), 0.005)

    def test_cut_outs(self):
        """Below the cutoff there is nothing, above it all is opaque: by opacity and by texture."""
        own = pv.picture(self.view)
        self.shown.Opacity, self.shown.RelievoMaterial = 0.4, 1
        self.shown.RelievoAlphaCutoff = 0.5
        self.assertEqual(pv.picture(self.view).max(), 0)
        self.shown.RelievoAlphaCutoff = 0.3
        self.same(pv.picture(self.view), own, "opaque above the cutoff")
        self.shown.Opacity, self.shown.RelievoAlphaCutoff = 1.0, 0.5
        texels = numpy.full((8, 8, 4), 255)
        texels[:, :4, 3] = 0
        pv.write(pv.OUTPUT / "half.png", texels)
        self.shown.Texture = simple.CreateTexture(str(pv.OUTPUT / "half.png"))
        middle = own.shape[1] // 2
        expected = own.copy()
        expected[:, :middle] = 0
        seen = pv.picture(self.view)
        self.assertLess(abs(seen.astype(int) - expected)[:, : middle - 1].max(), 2)
        self.assertLess(abs(seen.astype(int) - expected)[:, middle + 1 :].max(), 2)
        self.shown.RelievoAlphaCutoff = 0.0
        self.shown.Texture, self.shown.RelievoMaterial = None, 0
        self.same(pv.picture(self.view), own, "off")

    def test_coarse_data_blocks_and_backs(self):
        """The mapped shade on coarse data while the camera moves, on every block, on backs."""
        cosine = math.cos(math.radians(30))
        leaning = materialScene.write_normals("leaning.png", lean(30))
        fine = materialScene.Scene(simple.Plane(XResolution=80, YResolution=80))
        fine.shown.RelievoMaterial, fine.shown.RelievoNormalMap = 1, leaning
        fine.view.LODThreshold, fine.view.LODResolution = 0.0, 0.0
        fine.view.UseInteractiveRenderingForScreenshots = 1
        self.shade(cosine, "coarse data, drawn first", fine)
        fine.view.UseInteractiveRenderingForScreenshots = 0
        self.shade(cosine, "fine data", fine)

        two = simple.GroupDatasets(Input=[
            simple.Plane(XResolution=1, YResolution=1, Origin=[x, -0.5, 0.0],
                         Point1=[x + 0.5, -0.5, 0.0], Point2=[x, 0.5, 0.0])
            for x in (-0.5, 0.0)])  # fmt: skip
        blocks = materialScene.Scene(two)
        plain = blocks.middle()[1]
        simple.ColorBy(blocks.shown, ("FIELD", "vtkBlockColors"))
        blocks.shown.SetScalarBarVisibility(blocks.view, False)
        colours = blocks.middle()[1].astype(float)
        blocks.shown.RelievoMaterial, blocks.shown.RelievoNormalMap = 1, leaning
        mapped = blocks.middle()[1]
        self.assertGreater(pv.unlike(colours.astype(int), plain, 20).mean(), 0.1)
        self.assertLess(numpy.abs(mapped - colours * cosine).max(), 2)

        self.shown.RelievoMaterial, self.shown.RelievoNormalMap = 1, leaning
        self.shown.BackfaceRepresentation = "Surface"
        self.shade(cosine, "the front")
        self.view.CameraPosition = [0.0, 0.0, -materialScene.DISTANCE]
        back = materialScene.Scene(light=(0.0, 0.0, -1.0))
        back.view.CameraPosition = [0.0, 0.0, -materialScene.DISTANCE]
        back.shown.BackfaceRepresentation = "Surface"
        back.shown.BackfaceAmbientColor = back.shown.BackfaceDiffuseColor = [1.0, 1.0, 1.0]
        self.shade(1.0, "the back, plain", back)
        back.shown.RelievoMaterial, back.shown.RelievoNormalMap = 1, leaning
        self.shade(cosine, "the back", back)

    def test_colours_of_data(self):
        """Colour maps of points and cells stay, in the mapped shade; the user's setting is kept."""
        leaning = materialScene.write_normals("leaning.png", lean(30))
        height = simple.Elevation(
            Input=simple.Plane(XResolution=30, YResolution=30),
            LowPoint=[-0.5, -0.5, 0.0], HighPoint=[0.5, 0.5, 0.0],
        )  # fmt: skip
        for source, array in (
            (height, ("POINTS", "Elevation")),
            (simple.PointDatatoCellData(Input=height, PassPointData=1), ("CELLS", "Elevation")),
        ):
            scene = materialScene.Scene(source)
            shown = scene.shown
            simple.ColorBy(shown, array)
            shown.SetScalarBarVisibility(scene.view, False)
            own = scene.middle()[1]
            shown.InterpolateScalarsBeforeMapping = 0
            colours = scene.middle()[1]
            shown.RelievoMaterial, shown.RelievoNormalMap = 1, leaning
            truth = colours * math.cos(math.radians(30))
            self.assertLess(numpy.abs(scene.middle()[1] - truth).max(), 2)
            shown.InterpolateScalarsBeforeMapping = 1
            self.assertLess(numpy.abs(scene.middle()[1] - truth).max(), 2)
            shown.RelievoMaterial = 0
            self.same(scene.middle()[1], own, "off, with the setting that was changed meanwhile")
            shown.RelievoMaterial, shown.RelievoNormalMap = 1, ""
            self.same(scene.middle()[1], own, "without a map")
            shown.InterpolateScalarsBeforeMapping = 0
            self.same(scene.middle()[1], colours, "ParaView's own setting, off")

    def test_texture_coordinates(self):
        """A mesh without gets them from the filter."""
        ball = simple.Sphere(ThetaResolution=64, PhiResolution=64, Radius=0.5)
        simple.Hide(self.scene.square, self.view)
        for mapping in ("Plane", "Box", "Sphere"):
            placed = simple.TextureCoordinates(Input=ball, Mapping=mapping)
            shown = self.scene.show(placed)
            own = pv.picture(self.view)
            shown.RelievoMaterial = 1
            shown.RelievoNormalMap = materialScene.write_normals("leaning.png", lean(30))
            self.differ(pv.picture(self.view), own, mapping, share=0.1)
            shown.RelievoNormalMap = materialScene.write_normals("flat.png", (0, 0, 1))
            # No code of 8 bits is 0: the flat map leans by a third of a degree.
            self.near(pv.picture(self.view), own, f"{mapping}, flat", level=3)
            simple.Delete(shown)

    def test_invalid_files_and_values(self):
        """One message each with the value and the expectation; the picture is unchanged."""
        said = pv.run(SCENE, "invalid")
        cases = said.split("case ")[1:]
        expected = [words for _, _, words in materialScene.invalid_values()]
        expected.append("the filter Texture Coordinates (menu Filters, Relievo) makes some")
        self.assertEqual(len(cases), len(expected), said)
        for words, text in zip(expected, cases):
            self.assertIn(words, text)
            self.assertEqual(len(pv.messages(text)), 1, text)
            self.assertNotRegex(text, pv.NAMES_OF_CODE)
            self.assertIn("same True", text)

    def set_all(self):
        """Every property has its other value, in an environment."""
        self.view.RelievoEnvironment = materialScene.write_axes("axes.png")
        self.view.RelievoSkybox = 1
        wave = numpy.sin(numpy.linspace(0, 6 * math.pi, 64))
        name = materialScene.write_heights("map.png", 0.5 + 0.4 * wave[:, None] * wave[None, :])
        for key, (_, other) in PROPERTIES.items():
            setattr(self.shown, key, name if other == "map.png" else other)
        self.shown.RelievoClipAtBorders = 0
        self.view.CameraPosition = [0.8, -0.6, 1.2]

    def test_states(self):
        """The same picture in fresh processes."""
        self.set_all()
        picture = pv.picture(self.view)
        self.shown.RelievoMaterial = 0
        self.differ(pv.picture(self.view), picture, "off")
        self.shown.RelievoMaterial = 1
        pvsm, python = pv.OUTPUT / "state.pvsm", pv.OUTPUT / "state.py"
        simple.SaveState(str(pvsm))
        python.write_text(smstate.get_state())
        for state in (pvsm, python):
            found = pv.OUTPUT / (state.name + ".npy")
            said = pv.run(SCENE, "restore", state, found, tool="pvbatch")
            self.assertEqual(pv.messages(said), [], state.name)
            self.same(numpy.load(found), picture, state.name)

    def test_trace(self):
        smtrace.start_trace()
        # The panel's actions when its values are applied.
        item = smtrace._create_trace_item_internal(
            "PropertiesModified", kwargs={"proxy": self.shown}
        )
        self.set_all()
        item.finalize()
        del item
        trace = smtrace.stop_trace()
        for name, (_, other) in PROPERTIES.items():
            if name != "RelievoClipAtBorders":
                wanted = str(pv.OUTPUT / other) if other == "map.png" else other
                self.traced(trace, name, wanted)

    def test_undo(self):
        stack = pv.UndoStack(self)
        # The stack has no state before the first change that it sees of an object.
        self.shown.RelievoNormalMap = materialScene.write_normals("leaning.png", lean(30))
        own = pv.picture(self.view)
        stack.change(self.shown, "RelievoMaterial", 1)
        mapped = pv.picture(self.view)
        self.differ(mapped, own, "on")
        stack.undo()
        self.same(pv.picture(self.view), own, "undone")
        stack.redo()
        self.same(pv.picture(self.view), mapped, "done again")


if __name__ == "__main__":
    pv.main()
