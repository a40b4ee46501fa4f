# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of a representation as lamps: their light, their properties, states, and ranks."""

import pathlib

import lampScene
import numpy
import pv
from paraview import simple, smtrace

SCENE = pathlib.Path(__file__).with_name("lampScene.py")
STEPS = ("off", "on", "far", "cast", "hidden", "fog", "markers")

# Every property of a representation: default, another value as a script gives it.
PROPERTIES = {
    "RelievoLamps": (0, 1),
    "RelievoLampsRadius": (1.0, 2.0),
    "RelievoLampsRadiusArray": ("radius", ""),
    "RelievoLampsIntensity": (1.0, 2.5),
    "RelievoLampsIntensityArray": ("intensity", ""),
    "RelievoLampsColor": ([1.0, 1.0, 1.0], [1.0, 0.5, 0.25]),
    "RelievoLampsColorArray": ("color", ""),
    "RelievoLampsFalloff": ("Linear", "Inverse Square"),
    "RelievoLampsAttenuation": ([1.0, 0.0, 0.0], [1.0, 2.0, 3.0]),
    "RelievoLampsCasts": ("If Large", "Always"),
    "RelievoLampsCastsArray": ("casts", ""),
}


class Lamps(lampScene.Test):
    def test_light(self):
        """The layer is the sum over the points, wherever the representation is moved."""
        self.shown.RelievoLamps = 1
        for move in ((0, 0, 0), (0.3, 0.2, 0.1)):
            setattr(self.shown, pv.TRANSLATION, list(move))
            light, place, normal, depth = self.layers("light", "position", "normal", "depth")
            there = numpy.isfinite(depth)
            truth = lampScene.light(place, normal, numpy.array(lampScene.PLACES) + move)
            self.assertGreater(truth[there].max(), 0.4)
            for channel in range(3):
                numpy.testing.assert_allclose(
                    light[there, channel], truth[there], rtol=1e-4, atol=5e-5)
            self.assertFalse(light[~there].any())

    def test_labels(self):
        """The switches of a surface's points and of the view are told apart."""
        for name in ("Lamps", "Fog", "Markers"):
            points, view = (proxy.SMProxy.GetProperty(switch).GetXMLLabel() for proxy, switch in (
                (self.shown, f"Relievo{name}"), (self.view, f"RelievoStage{name}")))
            self.assertEqual((points, view), (f"Points Are {name}", f"Draw {name}"))

    def test_fog(self):
        """The layer is the joint transmittance of all spheres, in front of surfaces and the sky."""
        names = ("Fog", "FogRadius", "FogRadiusArray", "FogDensity", "FogDensityArray", "FogColor",
                 "FogColorArray")  # fmt: skip
        found = [getattr(self.shown, "Relievo" + name) for name in names]
        self.assertEqual([str(value).strip("'") for value in found[:5]],
                         ["0", "1.0", "radius", "1.0", "density"])  # fmt: skip
        self.assertEqual((list(found[5]), str(found[6]).strip("'")), ([1, 1, 1], "color"))
        self.shown.RelievoFog, self.shown.RelievoFogDensity = 1, 0.7
        fog, depth, place = self.layers("fog", "depth", "position")
        eye = numpy.array(self.view.CameraPosition)
        there = numpy.isfinite(depth)
        ray = place[there] - eye
        far = numpy.linalg.norm(ray, axis=-1)
        ray /= far[:, None]
        length = numpy.zeros(len(far))
        for centre, radius in zip(lampScene.PLACES, lampScene.RADII):
            middle = ((numpy.array(centre) - eye) * ray).sum(axis=-1)
            off2 = ((eye + middle[:, None] * ray - centre) ** 2).sum(axis=-1)
            half = numpy.sqrt(numpy.maximum(radius**2 - off2, 0))
            length += numpy.maximum(numpy.minimum(middle + half, far) - (middle - half), 0)
        # Half floats.
        numpy.testing.assert_allclose(fog[there], numpy.exp(-0.7 * length), rtol=1e-3, atol=2e-5)
        self.assertLess(fog[there].min(), 0.4)
        off = pv.picture(self.view)
        self.shown.RelievoFog = 0
        self.differ(off, pv.picture(self.view), "fog", share=0.2)
        self.assertTrue((self.layers("fog")[0] == 1).all(), "all passes")

    def test_behind_glass(self):
        """A pane that is all but opaque hides the lamps' light as well, once FXAA is off."""
        pane = simple.Box(Center=[0, -2, 2.5], XLength=9, YLength=9, ZLength=0.05)
        shown = simple.Show(pane, self.view)
        shown.Opacity, shown.Ambient, shown.Diffuse = 0.999, 0.0, 0.0
        for smooth in (1, 0):
            self.view.UseFXAA, self.shown.RelievoLamps = smooth, 0
            off = pv.picture(self.view)
            self.shown.RelievoLamps = 1
            on = pv.picture(self.view)
            self.assertEqual(pv.stage(self.view, "blend")["ran"], not smooth)
            (self.differ if smooth else self.near)(off, on, f"FXAA {smooth}", share=0.01)
        simple.Delete(pane)

    def test_properties(self):
        """Defaults, pictures that change and come back, trace and state."""
        defaults = {name: first for name, (first, _) in PROPERTIES.items()}
        self.assertEqual(pv.values(self.shown, PROPERTIES), defaults)
        off = pv.picture(self.view)
        self.shown.RelievoLamps = 1
        on = pv.picture(self.view)
        self.differ(off, on, "lamps", share=0.2)
        self.assertFalse((on.astype(int) < off.astype(int) - 1).any(), "nothing gets darker")
        for name, (default, other) in PROPERTIES.items():
            if name in ("RelievoLamps", "RelievoLampsAttenuation"):
                continue
            setattr(self.shown, name, other)
            # Only the array `radius` exists.
            changes = not name.endswith((
                "IntensityArray", "ColorArray", "LampsRadius", "CastsArray"))
            changed = pv.picture(self.view)
            if changes:
                self.differ(on, changed, name, share=0.0005 if name.endswith("Casts") else 0.01)
            else:
                self.same(on, changed, name)
            setattr(self.shown, name, default)
        self.same(on, pv.picture(self.view), "as before")
        self.shown.Visibility = 0
        self.same(off, pv.picture(self.view), "hidden")
        self.shown.Visibility = 1
        self.view.RelievoStageLamps = 0
        self.same(off, pv.picture(self.view), "switched off in the view")
        self.view.RelievoStageLamps = 1
        self.same(on, pv.picture(self.view), "on again")

        smtrace.start_trace()
        item = smtrace._create_trace_item_internal(
            "PropertiesModified", kwargs={"proxy": self.shown})
        self.shown.RelievoLampsIntensity = 2.0
        item.finalize()
        del item
        self.traced(smtrace.stop_trace(), "RelievoLampsIntensity", 2.0)
        state = pv.OUTPUT / "lamps.pvsm"
        picture = pv.picture(self.view)
        simple.SaveState(str(state))
        restored = pv.OUTPUT / "restored.npy"
        pv.run(SCENE, "restore", state, restored)
        self.same(picture, numpy.load(restored), "in another process")

    def test_ranks(self):
        """Each rank of a server has some of the lamps and some of the floor; its client has all."""

        def read(name):
            return {step: pv.read(pv.OUTPUT / f"{name}-{step}.png") for step in STEPS}

        lampScene.draw_steps(self.scene, pv.OUTPUT, "alone")
        alone = read("alone")
        self.differ(alone["off"], alone["on"], "lamps", share=0.2)
        self.differ(alone["far"], alone["cast"], "shadows", share=0.02)
        self.same(alone["off"], alone["hidden"], "hidden")
        self.differ(alone["off"], alone["fog"], "fog", share=0.2)
        self.differ(alone["off"], alone["markers"], "markers", share=0.02)
        # Ranks put their pictures together where they drew surfaces, without fog before the sky.
        surface = alone["off"].any(axis=2, keepdims=True)
        self.assertGreater(surface.mean(), 0.5)

        def compare(pictures, where, together):
            for step in STEPS:
                seen = surface if step == "fog" and together else True
                self.near(alone[step] * seen, pictures[step] * seen, f"{step} {where}", level=1)

        with pv.Server(launcher=pv.mpirun(2)) as server:
            said = pv.run(SCENE, pv.OUTPUT, "server,client", server.port)
            self.assertEqual(pv.messages(said + server.text()), [], said)
            for where in ("server", "client"):
                compare(read(where), f"by {where}", where == "server")


if __name__ == "__main__":
    pv.main()
