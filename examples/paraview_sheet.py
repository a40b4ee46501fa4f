# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the examples for ParaView: paths, and views side by side as a picture.

Programs load the plugin from the folder RELIEVO_PLUGIN_PATH (default: build/release/plugin/Relievo
beside this folder), and data from the folder RELIEVO_DATA (default: build/data), where
tools/unpack-data puts them.
"""

import os
import pathlib
import sys

from paraview import simple

BUILD = pathlib.Path(__file__).resolve().parent.parent / "build"
WIDE = 1440


def words(*needed):
    """The output folder (the first argument, or the current one), the plugin, the data's folder.

    Ends with a message if the plugin or one of the needed data files is missing.
    """
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    plugins = os.environ.get("RELIEVO_PLUGIN_PATH", BUILD / "release" / "plugin" / "Relievo")
    plugin = pathlib.Path(plugins) / "Relievo.so"
    data = pathlib.Path(os.environ.get("RELIEVO_DATA", BUILD / "data"))
    for path in (plugin, *(data / name for name in needed)):
        if not path.is_file():
            raise SystemExit(f"{path} is missing: ./run-demo makes it")
    return folder, plugin, data


def save(path, views, high=540):
    """Writes a picture of the views from left to right."""
    layout = simple.CreateLayout(path.stem)
    layout.AssignView(0, views[0])
    cell = 0
    for number, view in enumerate(views[1:]):
        layout.SplitViewHorizontal(views[number], 1 / (len(views) - number))
        cell = 2 * cell + 2
        layout.AssignView(cell, view)
    layout.SetSize(WIDE, high)
    simple.SaveScreenshot(str(path), layout, ImageResolution=[WIDE, high])
    print(path)
