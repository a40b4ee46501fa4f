# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ways to have the plugin loaded: by the environment, from the build and installed; a frame drawn
with it and the process ended without a word.

With the word `twice` the script is the process that is started; with `leave` it is one that ends by
sys.exit() while its views are there.
"""

import os
import pathlib
import subprocess
import sys
from unittest import mock

import materialScene
import pv
import stage


def draw():
    scene = stage.Stage((120, 80))
    own = pv.picture(scene.view)
    scene.sun()
    print("loaded", pv.unlike(pv.picture(scene.view), own).any())


def leave_with_all_on():
    """Everything of the plugin in a view, drawn; ParaView ends by itself."""
    materialScene.write_axes("axes.png")
    scene = stage.Stage((120, 80))
    scene.sun()
    scene.view.RelievoEnvironment = str(pv.OUTPUT / "axes.png")
    scene.view.RelievoSkybox = 1
    scene.view.RelievoDisplayLayer = "shadow_sun"
    for shown in (scene.ball_shown, scene.ground_shown):
        shown.RelievoMaterial = 1
        shown.RelievoMirror = 1
    scene.ground_shown.RelievoNormalMap = str(pv.OUTPUT / "axes.png")
    scene.render()
    print("drawn", flush=True)
    sys.exit()


class Loading(pv.Test):
    def check_leaving(self, tool, **environment):
        """
        Loaded by the environment, with all on, and left by sys.exit() while there are views.
        ParaView 5.11 itself crashes then, plugin or not; its trace must not lead through ours.
        """
        with mock.patch.dict(os.environ, environment):
            said = pv.run(__file__, "leave", tool=tool, status=None)
        before, drawn, _ = said.partition("drawn")
        self.assertTrue(drawn, said)
        self.assertEqual(pv.messages(before), [])
        self.assertNotIn("Relievo", said)

    def test_from_the_build(self):
        config = pathlib.Path(pv.PLUGIN).parents[1] / "relievo.plugins.xml"
        self.check_leaving("pvbatch", PV_PLUGIN_CONFIG_FILE=str(config))

    def test_installed(self):
        prefix = pv.OUTPUT / "prefix"
        subprocess.run(
            ["cmake", "--install", os.environ["RELIEVO_BUILD"], "--prefix", str(prefix)],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        (plugin,) = prefix.glob("lib/**/plugins/Relievo/Relievo.so")
        self.check_leaving("pvpython", PV_PLUGIN_PATH=str(plugin.parent))

    def test_by_the_environment_and_by_the_script(self):
        # The page says so: no harm, and in pvbatch ParaView's word that it was there already.
        folder = pathlib.Path(pv.PLUGIN).parent
        with mock.patch.dict(os.environ, {"PV_PLUGIN_PATH": str(folder)}):
            for tool, words in (("pvpython", 0), ("pvbatch", 1)):
                said = pv.run(__file__, "twice", tool=tool)
                self.assertEqual(said.count("loaded True"), 2, "by the environment, and again")
                self.assertEqual(len(pv.messages(said)), words, said)
                self.assertEqual(said.count("Plugin load failed: No plugin loaded yet."), words)


if sys.argv[1:2] == ["leave"]:
    leave_with_all_on()
elif sys.argv[1:2] == ["twice"]:
    draw()
    pv.load()
    draw()
    pv.leave()
elif __name__ == "__main__":
    pv.main()
