# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs scripts, each in a process of its own that has imported relievo: it is forked from this one,
which draws nothing. Each line of the input is [SCRIPT, FOLDER, [WORD...]] as JSON, each line of the
output [STATUS, OUTPUT, ERRORS]."""

import json
import os
import pathlib
import runpy
import signal
import sys
import tempfile

import relievo  # noqa: F401  (half of a short example's time)


def run(script, folder, words):
    """In a process of its own: its exit status, output and errors."""
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        child = os.fork()
        if child == 0:
            signal.alarm(600)  # a script that hangs ends with this signal
            os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
            os.dup2(output.fileno(), 1)
            os.dup2(errors.fileno(), 2)
            os.chdir(folder)
            sys.argv[:] = [script, *words]
            sys.path[0] = str(pathlib.Path(script).parent)
            kept = runpy.run_path(script, run_name="__main__")
            sys.exit(not kept)  # which a script's objects outlive
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        said = []
        for file in (output, errors):
            file.seek(0)
            said.append(file.read().decode("utf-8", "replace"))
        return [status, *said]


for line in sys.stdin:
    print(json.dumps(run(*json.loads(line))), flush=True)
