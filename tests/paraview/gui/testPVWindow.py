# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in ParaView's window: the XML files of this folder are played in a real one.

One argument: the name of the case to run; each starts ParaView once.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import numpy  # noqa: E402
import pv  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
# The test's or the user's, for shaders that are built already: each window has a home of its own.
CACHE = (os.environ.get("MESA_SHADER_CACHE_DIR") or os.environ.get("XDG_CACHE_HOME")
         or str(pathlib.Path.home() / ".cache"))  # fmt: skip
# How Qt's and QtTesting's messages begin in ParaView's output.
QT_MESSAGE = re.compile(r"^(critical|warning|fatal): .*(\n(?!debug:).+)*", re.MULTILINE)


def play(scripts, *words, seconds=600, **environment):
    """Plays scripts one after the other in a new ParaView window; returns its output and the notes
    of windowShell.py."""
    home = pv.OUTPUT / "home"
    shutil.rmtree(home, ignore_errors=True)
    home.mkdir(mode=0o700)
    notes = pv.OUTPUT / "notes.jsonl"
    notes.unlink(missing_ok=True)
    command = [str(pv.TOOLS / "paraview"), "--dr", "--exit",
               *(f"--test-script={HERE / script}" for script in scripts),
               f"--test-directory={pv.OUTPUT}",
               f"--data-directory={pathlib.Path(pv.PLUGIN).parent}", *words]
    process = subprocess.run(
        command, env={**os.environ, "HOME": str(home), "XDG_RUNTIME_DIR": str(home),
                      "PYTHONPATH": str(HERE), "MESA_SHADER_CACHE_DIR": CACHE, **environment},
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds, check=False,
        text=True, errors="replace")
    (pv.OUTPUT / f"{scripts[0]}.log").write_text(process.stdout, encoding="utf-8")
    found = {}
    if notes.exists():
        found = dict(json.loads(line) for line in notes.read_text(encoding="utf-8").splitlines())
    return process, found


class Window(pv.Test):
    """Each case starts one window."""

    def played(self, *scripts, words=(), **environment):
        """Plays scripts that must succeed without a message; returns their notes."""
        process, notes = play(scripts, *words, **environment)
        said = pv.messages(process.stdout)
        said += [found.group(0) for found in QT_MESSAGE.finditer(process.stdout)]
        self.assertEqual(said, [], f"{scripts}: ParaView has something to say")
        self.assertNotIn("exception", notes, notes.get("exception"))
        self.assertEqual(process.returncode, 0, process.stdout[-2000:])
        self.assertEqual(process.stdout.count("Success =  true"), len(scripts))
        return notes

    def testLoadByManager(self):
        """Loaded by its manager; shadows by the properties of an older view; a new session."""
        notes = self.played("loadByManager.xml")
        before, loaded, on, off = (
            pv.read(pv.OUTPUT / f"{name}.png") for name in ("before", "loaded", "on", "off"))
        self.same(before, loaded, "loaded, all off")
        self.same(before, off, "off again")
        self.assertEqual(notes["on"][0]["RelievoShadows"], 1)
        self.assertEqual(notes["off"][0]["RelievoShadows"], 0)
        self.assertEqual(notes["styled"], [1, 1], "a surface that is older than the plugin")
        self.assertEqual(notes["new session"][0]["RelievoSun"], 1)
        # The ball's shadow on the floor: darker, and somewhere in the middle third.
        darker = (before.astype(int) - on.astype(int)).min(axis=2) > 20
        self.assertGreater(darker.sum(), 200)
        self.assertFalse((on.astype(int) - before.astype(int) > 1).any(), "nothing gets lighter")

    def testDockControls(self):
        """The dock's controls change only their own settings."""
        notes = self.played("dockControls.xml", PV_PLUGIN_PATH=str(pathlib.Path(pv.PLUGIN).parent))
        for name in ("sun", "layer", "last"):
            self.assertEqual(notes["size " + name], notes["size first"], f"the view beside: {name}")
        # A dial with north at its top: the mouse at its right, then at its bottom.
        self.assertEqual(notes["sun pressed"][:2], [90, 45])
        self.assertEqual(notes["sun let go"][:2], [180, 45])
        trace = notes["trace"]
        self.traced(trace, "RelievoShadowMapSize", 4096)
        self.assertEqual(trace.count("RelievoSunAzimuth"), 1, trace)
        self.traced(trace, "RelievoSunAzimuth", 180.0)
        # 21 June on the Greenwich meridian: at twelve nearly in the south, 90 - 48 + 23.4 high.
        azimuth, elevation, lights = notes["sun noon"]
        self.assertAlmostEqual(azimuth, 180, delta=3)
        self.assertAlmostEqual(elevation, 65.44, delta=0.05)
        self.assertLess(notes["sun night"][1], -10)
        # The dock shows the view's values, also beyond the sliders' ranges; and typed values.
        self.assertEqual(notes["by script"], [5, -30])
        self.assertEqual(notes["typed"], [40, 270])
        self.assertEqual(notes["sun night"][2], lights, "at night it is there, and gives none")

    def testScene(self):
        """The dock's reports on the scene and its additions: hints, ground, light, legends, values.
        """
        notes = self.played("scene.xml", PV_PLUGIN_PATH=str(pathlib.Path(pv.PLUGIN).parent))
        # Two radii to each side of the bounds' middle, (0, 3, 5); half their diagonal is 3.
        for name in ("again", "made", "traced"):
            *corners, seen, color = notes[name]
            true = [[-6, 2, -1], [-6, 2, 11], [6, 2, -1]]
            self.assertLess(numpy.abs(numpy.subtract(corners, true)).max(), 0.02, name)
            self.assertLess(corners[0][1], 2.0, "below what lies flat on it")
            self.assertEqual(seen, 1)
            self.assertLess(max(color), 0.6, "white annotations are read on it")
        self.assertEqual(notes["soft"], [16, 2])
        self.assertEqual(notes["hard"], [0])
        self.assertEqual(notes["all"], [2, 2])

    def testSunUndo(self):
        """A click on the sun: a step of undo, lines of a trace; closed views come back with it."""
        notes = self.played("sunUndo.xml")
        both = {"RelievoSun": 1, "RelievoShadows": 1, "RelievoShadowMapSize": 2048}
        self.assertEqual(notes["sun"], [both])
        self.traced(notes["trace"], "RelievoSun", 1)
        self.traced(notes["trace"], "RelievoShadows", 1)
        self.assertEqual(notes["undone"], [both])
        self.assertEqual(notes["back"], [both])

    def testThree(self):
        """Relievo Layers and Depth To Points by the menus, of a view that is not the active one.
        Files are read when their names are finished; arrays; the dock of a comparative view. The
        dock has times of the stages that ran while it is open, none when closed."""
        notes = self.played("layersMenus.xml", "fields.xml", "panelTimes.xml",
                            PV_PLUGIN_PATH=str(pathlib.Path(pv.PLUGIN).parent))  # fmt: skip
        first, again = notes["first"], notes["again"]
        for each in (first, again):
            self.assertTrue(each["first"])
            self.assertEqual(each["size"], each["view"])
        self.assertGreater(first["seen"], 10000)
        # The floor that is seen now lies behind the ball.
        self.assertGreater(again["mean"], first["mean"] + 0.01)
        self.assertEqual(notes["points"], again["seen"])
        self.assertIsNone(notes["closed"])
        self.assertEqual(notes["typed"], [""])
        self.assertEqual(notes["finished"], ["a.png"])
        self.assertEqual(notes["chosen"], ["Normals"], "the one array of three components")
        self.assertEqual(notes["shadows"][0]["RelievoShadows"], 1)

    def testRemote(self):
        """Loaded on a server and here: an already open view, and the cost of the server's pictures.
        """
        with pv.Server() as server:
            notes = self.played("remote.xml", words=[f"--server-url=cs://localhost:{server.port}"])
        self.assertEqual(pv.messages(server.text()), [], "the server has something to say")
        self.assertTrue(notes["server draws"])
        self.assertEqual(notes["on"][0]["RelievoShadows"], 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
