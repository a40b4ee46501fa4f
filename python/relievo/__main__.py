# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""`python -m relievo` is the command `relievo` of the same wheel, build folder or prefix."""

import os
import pathlib
import shutil
import signal
import sys


def _program():
    package = pathlib.Path(sys.modules["relievo"].__file__).parent  # a build has links to this file
    for folder in (package, *package.parents):
        if os.access(folder / "bin" / "relievo", os.X_OK):
            return folder / "bin" / "relievo"
    return shutil.which("relievo")


if __name__ == "__main__":
    program = _program()
    if program is None:
        sys.exit("relievo: this build has no command: build the target relievo, or install a wheel")
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # Python ignores it; children inherit that
    os.execv(program, ["relievo", *sys.argv[1:]])
