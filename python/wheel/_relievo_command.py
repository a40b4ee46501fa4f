# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command `relievo` of a wheel. Outside the package, whose import would load all of VTK."""

import os
import pathlib
import signal
import sys


def main():
    program = pathlib.Path(__file__).parent / "relievo" / "bin" / "relievo"
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # Python ignores it; children inherit that
    os.execv(program, [sys.argv[0], *sys.argv[1:]])
