# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of a representation as lamps: what they add, their properties, states, and ranks."""

import os
import pathlib
import subprocess

import lampScene
import numpy
import pv
from paraview import simple, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy

SCENE = pathlib.Path(__file__).with_name("lampScene.py")
STEPS = ("off", "on", "hidden")
MPIRUN = ("mpirun", "--allow-run-as-root", "--oversubscribe", "-np")

# Every property of a representation: default, another value as a script gives it.
PROPERTIES = {
    "RelievoLamps": (0, 1),
    "RelievoLampRadius": (1.0, 2.0),
    "RelievoLampRadiusArray": ("radius", ""),
    "RelievoLampIntensity": (1.0, 2.5),
    "RelievoLampIntensityArray": ("intensity", ""),
    "RelievoLampColor": ([1.0, 1.0, 1.0], [1.0, 0.5, 0.25]),
    "RelievoLampColorArray": ("color", ""),
    "RelievoLampFalloff": ("Linear", "Inverse Square"),
    "RelievoLampAttenuation": ([1.0, 0.0, 0.0], [1.0, 2.0, 3.0]),
}


def values(shown):
    found = {}
    for name, (default, _) in PROPERTIES.items():
        value = getattr(shown, name)
        text, several = isinstance(default, str), isinstance(default, list)
        found[name] = str(value).strip("'") if text else list(value) if several else value
    return found


class Lamps(pv.Test):
    @classmethod
    def setUpClass(cls):
        pv.load()

    def setUp(self):
        pv.clear()
        self.scene = lampScene.Scene()
        self.view, self.lamps = self.scene.view, self.scene.lamps

    def layers(self, *names):
        grab = simple.RelievoLayers(View=self.view)
        grab.Layers = list(names)
        grab.UpdatePipeline()
        image = simple.FetchData(grab)[0].GetPointData()
        found = [vtk_to_numpy(image.GetArray(name)).astype(float) for name in names]
        simple.Delete(grab)
        return found

    def test_light(self):
        """The layer is the sum over the points, wherever the representation is moved."""
        self.lamps.RelievoLamps = 1
        for move in ((0, 0, 0), (0.3, 0.2, 0.1)):
            self.lamps.Position = list(move)
            light, place, normal, depth = self.layers("light", "position", "normal", "depth")
            there = numpy.isfinite(depth)
            truth = lampScene.light(place, normal, numpy.array(lampScene.PLACES) + move)
            self.assertGreater(truth[there].max(), 0.4)
            for channel in range(3):
                numpy.testing.assert_allclose(
                    light[there, channel], truth[there], rtol=1e-4, atol=5e-5)
            self.assertFalse(light[~there].any())

    def test_properties(self):
        """Defaults, pictures that change and come back, trace and state."""
        self.assertEqual(values(self.lamps), {n: first for n, (first, _) in PROPERTIES.items()})
        off = pv.picture(self.view)
        self.lamps.RelievoLamps = 1
        on = pv.picture(self.view)
        self.differ(off, on, "lamps", share=0.2)
        self.assertFalse((on.astype(int) < off.astype(int) - 1).any(), "nothing gets darker")
        for name, (default, other) in PROPERTIES.items():
            if name in ("RelievoLamps", "RelievoLampAttenuation"):
                continue
            setattr(self.lamps, name, other)
            # Of the arrays, only `radius` is there.
            changes = not name.endswith(("IntensityArray", "ColorArray", "LampRadius"))
            changed = pv.picture(self.view)
            (self.differ if changes else self.same)(on, changed, name)
            setattr(self.lamps, name, default)
        self.same(on, pv.picture(self.view), "as before")
        self.lamps.Visibility = 0
        self.same(off, pv.picture(self.view), "hidden")
        self.lamps.Visibility = 1
        self.view.RelievoStageLamps = 0
        self.same(off, pv.picture(self.view), "switched off in the view")
        self.view.RelievoStageLamps = 1
        self.same(on, pv.picture(self.view), "on again")

        smtrace.start_trace()
        item = smtrace._create_trace_item_internal(
            "PropertiesModified", kwargs={"proxy": self.lamps})
        self.lamps.RelievoLampIntensity = 2.0
        item.finalize()
        del item
        self.assertIn("RelievoLampIntensity = 2.0", smtrace.stop_trace())
        state = pv.OUTPUT / "lamps.pvsm"
        picture = pv.picture(self.view)
        simple.SaveState(str(state))
        restored = pv.OUTPUT / "restored.npy"
        pv.run(SCENE, "restore", state, restored)
        self.same(picture, numpy.load(restored), "in another process")

    def test_ranks(self):
        """Each rank has some of the lamps and some of the floor; servers and their clients."""

        def draw(name, *words, launcher=(), tool="pvpython"):
            done = subprocess.run(
                [*launcher, str(pv.TOOLS / tool), *map(str, (SCENE, pv.OUTPUT, name, *words))],
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                timeout=600,
                env={n: v for n, v in os.environ.items()
                     if not n.startswith(("OMPI_", "PMIX_", "ORTE_"))})  # fmt: skip
            self.assertEqual((done.returncode, pv.messages(done.stdout)), (0, []), done.stdout)
            return {step: pv.read(pv.OUTPUT / f"{name}-{step}.png") for step in STEPS}

        alone = draw("alone")
        self.differ(alone["off"], alone["on"], "lamps", share=0.2)
        self.same(alone["off"], alone["hidden"], "hidden")
        for ranks in (2, 3):
            together = draw(f"of{ranks}", launcher=(*MPIRUN, str(ranks)), tool="pvbatch")
            for step in STEPS:
                self.near(alone[step], together[step], f"{step} on {ranks} ranks", level=1)
        for launcher, threshold, where in (((), 0, "server"), ((*MPIRUN, "2"), 0, "two"),
                                           ((), 1e9, "client")):  # fmt: skip
            with self.subTest(where), pv.Server(launcher=launcher) as server:
                there = draw(where, server.port, threshold)
                for step in STEPS:
                    self.near(alone[step], there[step], f"{step} by {where}", level=1)
                self.assertEqual(pv.messages(server.text()), [])


if __name__ == "__main__":
    pv.main()
