# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time of `relievo render` from its start to the written picture, beside F3D.

    python bench/command_start.py RELIEVO DATA [--rounds N] [--looks none,studio]
        [--against RELIEVO] >command-start.csv

RELIEVO is the command, DATA the folder that tools/unpack-data fills. In every round each program
is started again, in random order, and writes bunny.off as a PNG of 1920 x 1080 pixels: the
command with --preset none (one sample of VTK's headlight) and with its default (the preset studio:
24 samples, soft shadows), another build of it with --against, and F3D, if this Python has it, with
its own look. A ratio is the median of the rounds' ratios to the first of these, +- half the
distance of its quartiles; processor time is that of all threads and processes. The pictures of
both builds must be equal. A display is needed (tools/with-display).
Exit status: 0; 1 if a program fails, or the builds draw different pictures.
"""

import csv
import importlib.util
import os
import pathlib
import random
import statistics
import sys
import tempfile

from f3d_frames import ratio
from processes import PEERS, parser, run

SIZE = "1920x1080"


def commands(given, mesh, folder):
    """The commands to run, by name; and the picture that each writes."""
    found = {}
    builds = {"relievo": given.relievo, "relievo, the other build": given.against}
    for name, path in builds.items():
        for look in given.looks.split(",") if path else ():
            picture = folder / f"{len(found)}.png"
            found[f"{name}, {look}"] = picture, [
                path, "render", mesh, "--preset", look, "--size", SIZE, "--png",
                str(picture)]  # fmt: skip
    if importlib.util.find_spec("f3d"):
        picture = folder / "f3d.png"
        found["F3D"] = picture, [sys.executable, str(PEERS), "f3d", mesh, str(picture), SIZE]
    return found


def main():
    options = parser(__doc__, 15)
    options.add_argument("data")
    options.add_argument("--looks", default="none,studio")
    options.add_argument("--against")
    given = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        programs = commands(given, str(pathlib.Path(given.data) / "bunny.off"),
                            pathlib.Path(folder))  # fmt: skip
        times = {name: [] for name in programs}
        for number in range(given.rounds + 1):  # the first warms the files and the shaders' cache
            for name in random.sample(list(programs), len(programs)):
                taken = run(programs[name][1])
                if number:
                    times[name].append(taken)
        for look in given.looks.split(",") if given.against else ():
            names = (f"relievo, {look}", f"relievo, the other build, {look}")
            if len({programs[name][0].read_bytes() for name in names}) > 1:
                raise SystemExit(f"command_start: the builds draw --preset {look} differently")
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["program", "milliseconds", "ratio", "+-", "processor milliseconds",
                     "processor ratio", "processor +-", "rounds", "load"])  # fmt: skip
    for name in programs:
        cells = [name]
        for clock in (0, 1):
            own, peer = ([each[clock] for each in times[which]]
                         for which in (name, next(iter(programs))))  # fmt: skip
            found = ratio(own, peer)
            cells += [f"{1e3 * statistics.median(own):.0f}", f"{found[0]:.3f}", f"{found[1]:.3f}"]
        writer.writerow([*cells, given.rounds, f"{os.getloadavg()[0]:.1f}"])


if __name__ == "__main__":
    main()
