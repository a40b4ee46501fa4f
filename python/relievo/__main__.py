# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""`python -m relievo` is the command `relievo` of the same wheel, build folder or prefix."""

import os
import signal
import sys

from ._scene.program import program

if __name__ == "__main__":
    path = program()
    if path is None:
        sys.exit("relievo: this build has no command: build the target relievo, or install a wheel")
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # Python ignores it; children inherit that
    os.execv(path, ["relievo", *sys.argv[1:]])
