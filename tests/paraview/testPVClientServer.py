# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A client and a pvserver show the picture of ParaView alone, whichever renders; and a server
without the plugin is reported.

With the words `draw PORT FILE` the script is the client that draws.
"""

import sys

import features
import numpy
import pv
import stage
from paraview import simple


def settings(scene):
    """Name and picture of the view in each of its states."""
    scene.render()
    yield "off", pv.picture(scene.view)
    scene.sun()
    yield "shadows of a sun", pv.picture(scene.view)
    scene.view.RelievoShadowMethod = "Warped"
    yield "warped", pv.picture(scene.view)
    scene.view.RelievoShadowMethod = "Map"
    light = simple.AddLight(scene.view)
    light.Coords, light.Type, light.ConeAngle = "Scene", "Positional", 40.0
    light.Position, light.FocalPoint = [3.0, -2.0, 4.0], [0.0, 0.0, 0.0]
    light.Intensity = 0.5
    yield "shadows of a spot", pv.picture(scene.view)
    light.RelievoShadowStrength = 0.0
    yield "a spot without shadows", pv.picture(scene.view)
    simple.RemoveLight(light)
    scene.sun(on=False, shadows=False)
    # Shown in the legend: this process does not know a server's values.
    scene.view.RelievoDisplayRange = [4.0, 16.0]
    for layer in ("depth", "normal"):
        scene.view.RelievoDisplayLayer = layer
        yield layer, pv.picture(scene.view)
    scene.view.RelievoDisplayLayer = "None"
    features.annotations(scene)
    scene.sun()
    yield "shadows and annotations", pv.picture(scene.view)
    scene.sun(on=False, shadows=False)
    yield "annotations", pv.picture(scene.view)


def draw_remotely(port, path):
    """Draws all with a server, once there and once here, into a file."""
    simple.Connect("localhost", int(port))
    pv.load()
    pv.load(remote=True)
    pictures = {}
    for where, threshold in (("server", 0.0), ("client", 1e9)):
        scene = stage.Stage()
        scene.view.RemoteRenderThreshold = threshold
        for name, picture in settings(scene):
            pictures[f"{name}, drawn by the {where}"] = picture
        pv.clear()
    numpy.savez(path, **pictures)


def draw_without(port, missing):
    """Has the plugin on one side only, and goes on."""
    simple.Connect("localhost", int(port))
    pv.load(remote=missing == "client")
    scene = stage.Stage()
    scene.view.RemoteRenderThreshold = 0.0
    scene.render()
    own = pv.picture(scene.view)
    try:
        scene.sun()
    except AttributeError as refused:
        print("AttributeError", refused)
    print("as it was", (pv.picture(scene.view) == own).all(), len(numpy.unique(own)) > 50)


class ClientServer(pv.Test):
    def test_pictures_are_those_of_one_process(self):
        pv.load()
        alone = dict(settings(stage.Stage()))
        pv.clear()
        path = pv.OUTPUT / "remote.npz"
        with pv.Server() as server:
            said = pv.run(__file__, "draw", server.port, path)
        self.assertEqual(pv.messages(said) + pv.messages(server.text()), [])
        pictures = numpy.load(path)
        self.assertEqual(len(pictures), len(alone) * 2)
        for name in pictures:
            with self.subTest(name):
                self.near(pictures[name], alone[name.partition(", drawn by")[0]], name)

    def test_one_side_without_the_plugin(self):
        for missing in ("server", "client"):
            with pv.Server() as server:
                said = pv.run(__file__, "without", server.port, missing)
            self.assertIn("AttributeError Attribute RelievoSun does not exist", said)
            self.assertIn("as it was True", said)
            self.assertIn("Exiting...", server.text())
            if missing == "server":
                self.assertEqual(pv.messages(server.text()), [])
                self.assertIn("as it was True True", said)
                self.assertEqual(pv.messages(said), [])
            else:
                # A client without the plugin cannot make views and surfaces of a server that has
                # it; both say so.
                self.assertIn("Failed to create subproxy", said)


if sys.argv[1:2] == ["draw"]:
    draw_remotely(*sys.argv[2:])
    pv.leave()
elif sys.argv[1:2] == ["without"]:
    draw_without(*sys.argv[2:])
    pv.leave()
elif __name__ == "__main__":
    pv.main()
