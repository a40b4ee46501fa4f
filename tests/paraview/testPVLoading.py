# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ways to have the plugin loaded: by the environment, from the build and installed; a frame drawn
with it and the process ended without a word.

With the word `draw` the script is the process that is started.
"""

import os
import pathlib
import subprocess
import sys
from unittest import mock

import pv
import stage


def draw():
    scene = stage.Stage((120, 80))
    if "RelievoShadows" in scene.view.ListProperties():
        own = pv.picture(scene.view)
        scene.sun()
        print("loaded", pv.unlike(pv.picture(scene.view), own).any())


class Loading(pv.Test):
    def check(self, tool, **environment):
        with mock.patch.dict(os.environ, environment):
            said = pv.run(__file__, "draw", tool=tool)
        self.assertEqual(pv.messages(said), [])
        return said

    def test_from_the_build(self):
        folder = pathlib.Path(pv.PLUGIN).parent
        self.assertIn("loaded True", self.check("pvpython", PV_PLUGIN_PATH=str(folder)))
        config = folder.parent / "relievo.plugins.xml"
        self.assertIn("loaded True", self.check("pvbatch", PV_PLUGIN_CONFIG_FILE=str(config)))
        self.assertNotIn("loaded", self.check("pvpython"))

    def test_installed(self):
        prefix = pv.OUTPUT / "prefix"
        subprocess.run(
            ["cmake", "--install", os.environ["RELIEVO_BUILD"], "--prefix", str(prefix)],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        (plugin,) = prefix.glob("lib/**/plugins/Relievo/Relievo.so")
        self.assertIn("loaded True", self.check("pvbatch", PV_PLUGIN_PATH=str(plugin.parent)))


if sys.argv[1:2] == ["draw"]:
    draw()
    pv.leave()
elif __name__ == "__main__":
    pv.main()
