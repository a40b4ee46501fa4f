# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The font of bars where the system has no DejaVu Sans: Matplotlib brings it."""

import importlib.util
import pathlib

from .._wrapped import vtkRelievoColorBar


def offer_matplotlibs():
    """Does not import Matplotlib."""
    found = importlib.util.find_spec("matplotlib")
    for folder in (found and found.submodule_search_locations) or ():
        font = pathlib.Path(folder, "mpl-data", "fonts", "ttf", "DejaVuSans.ttf")
        if font.is_file():
            vtkRelievoColorBar.SetFallbackFont(str(font))
