# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the command `relievo` of this wheel, build folder or prefix is."""

import os
import pathlib
import shutil
import sys


def program():
    """The path of the command; None if this build has none."""
    package = pathlib.Path(sys.modules["relievo"].__file__).parent  # a build has links to this file
    for folder in (package, *package.parents):
        if os.access(folder / "bin" / "relievo", os.X_OK):
            return folder / "bin" / "relievo"
    return shutil.which("relievo")
