# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cost of the samples of the default preset, and error of its pictures against many samples.

    python bench/studio_samples.py RELIEVO DATA [--rounds N] [--size WxH] [--files a,b] [--most N]
        >studio.csv

RELIEVO is the command, DATA the folder that tools/unpack-data fills. The preset studio draws
each file with several numbers of samples: `at once`, as it does by default (24), with few maps for
the soft shadow, and `one by one`, with a map for each sample. Errors are the root mean square, in
levels of 255, over the pixels in which any picture differs from the truth by more than two levels:
those of edges and penumbras. The truth has --most samples, one by one (256). Processor
time is the minimum over the rounds, of all threads and processes, of whole commands; the excess
over --preset none is the cost of the look. A display is needed (tools/with-display), and numpy and
Pillow. Exit status: 0; 1 if a command fails.
"""

import csv
import os
import pathlib
import random
import sys
import tempfile

import numpy
from PIL import Image
from processes import parser, run

FILES = ("bunny.off", "motorBike.obj", "elephant.off", "buildings.obj")
SAMPLES = (4, 8, 16, 24, 48)
DEFAULT = 24
DIFFERENT = 2  # levels


def samples_of(way, count):
    """Options to draw so many samples."""
    edges = ["--stage", f"antialias:samples={count}"]
    if way == "one by one":
        return ["--soft-shadows", str(count), *edges]
    return [] if count == DEFAULT else [*edges, "--stage", f"shadows:soft_samples={count}"]


def errors(pictures, truth):
    """Errors by name; and the share of the evaluated pixels."""
    judged = numpy.zeros(truth.shape[:2], bool)
    for picture in pictures.values():
        judged |= numpy.abs(picture - truth).max(axis=2) > DIFFERENT
    return {name: float(numpy.sqrt(numpy.mean((picture - truth)[judged] ** 2))) if judged.any()
            else 0.0 for name, picture in pictures.items()}, float(judged.mean())  # fmt: skip


def load(path):
    return numpy.asarray(Image.open(path).convert("RGB")).astype(float)


def measure(given, file, folder):
    """A row for each method and number of samples."""
    words = [given.relievo, "render", str(pathlib.Path(given.data) / file), "--size", given.size]
    picture = folder / "picture.png"
    draws = {("none", 1): ["--preset", "none"]} | {
        (way, count): samples_of(way, count)
        for way in ("at once", "one by one") for count in SAMPLES}  # fmt: skip
    times, pictures = {}, {}
    for _ in range(given.rounds):
        for name in random.sample(list(draws), len(draws)):
            taken = run([*words, *draws[name], "--png", str(picture)]).processor
            times[name] = min(taken, times.get(name, taken))
            pictures[name] = load(picture)
    run([*words, *samples_of("one by one", given.most), "--png", str(picture)])
    plain = times[("none", 1)]
    del pictures["none", 1], draws["none", 1]
    found, judged = errors(pictures, load(picture))
    for way, count in draws:
        seconds = times[way, count]
        yield [file.split(".")[0], way, count, f"{found[way, count]:.2f}", f"{seconds:.2f}",
               f"{seconds - plain:.2f}", f"{100 * judged:.1f}", given.rounds,
               f"{os.getloadavg()[0]:.1f}"]  # fmt: skip


def main():
    options = parser(__doc__, 3)
    options.add_argument("data")
    options.add_argument("--size", default="400x300")
    options.add_argument("--files", default=",".join(FILES))
    options.add_argument("--most", type=int, default=256)
    given = options.parse_args()
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["scene", "samples", "count", "rms levels", "processor seconds",
                     "seconds more than none", "judged %", "rounds", "load"])  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        for file in given.files.split(","):
            writer.writerows(measure(given, file, pathlib.Path(folder)))
            sys.stdout.flush()


if __name__ == "__main__":
    main()
