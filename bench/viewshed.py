# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Viewsheds of terrains by relievo viewshed and gdal_viewshed: time, memory, differences.

    python bench/viewshed.py RELIEVO [--rounds N] [--small] >viewshed.csv

RELIEVO is the command; gdal_viewshed (Debian: gdal-bin) must be in PATH, and osgeo, numpy and
relievo in this Python. The terrains are made here: ridges of 10 m cells, with an observer 2 m above
the highest cell of the middle ninth. Costs are those of whole commands, from file to file: the
least processor seconds of the rounds (3), and their largest memory. Differences are those of 2000
random cells from lines of sight in double over two surfaces through the heights: the triangles that
Relievo documents, and the bilinear surface, sampled eight times in each cell. --small measures a
small terrain, in seconds. Exit status: 0.
"""

import csv
import pathlib
import subprocess
import sys
import tempfile

import numpy
import relievo
from osgeo import gdal
from processes import parser, run

COLUMNS = ("cells", "method", "processor seconds", "MiB", "differs from triangles, %",
           "differs from bilinear, %", "seen, %")  # fmt: skip
CELL, HEIGHT, SAMPLES = 10.0, 2.0, 2000


def ridges(side):
    """Waves of random directions whose amplitude falls with their frequency."""
    lots = numpy.random.default_rng(5)
    v, u = numpy.mgrid[:side, :side] / 500
    heights = numpy.zeros((side, side))
    for _ in range(60):
        frequency = 2 ** lots.uniform(0, 5.5)
        turn, phase = lots.uniform(0, 2 * numpy.pi, 2)
        along = u * numpy.cos(turn) + v * numpy.sin(turn)
        heights += (1 - abs(numpy.sin(2 * numpy.pi * frequency * along + phase))) / frequency
    return (300 * heights / numpy.ptp(heights)).astype(numpy.float32)


def by_triangles(heights, u, v):
    """Heights at columns u and rows v, in a square cut from its first to its last corner."""
    i, j = (numpy.minimum(numpy.floor(each).astype(int), len(heights) - 2) for each in (v, u))
    s, t = v - i, u - j
    first, last = heights[i, j], heights[i + 1, j + 1]
    down, right = heights[i + 1, j], heights[i, j + 1]
    return numpy.where(s > t, first + s * (down - first) + t * (last - down),
                       first + t * (right - first) + s * (last - right))  # fmt: skip


def bilinear(heights, u, v):
    i, j = (numpy.minimum(numpy.floor(each).astype(int), len(heights) - 2) for each in (v, u))
    s, t = v - i, u - j
    above = heights[i, j] * (1 - t) + heights[i, j + 1] * t
    below = heights[i + 1, j] * (1 - t) + heights[i + 1, j + 1] * t
    return above * (1 - s) + below * s


def crossings(start, end):
    """Shares of a line in which it crosses the edges of triangles: there a line over triangles is
    the nearest to them."""
    found = []
    for a, b in ((start[0], end[0]), (start[1], end[1]),
                 (start[1] - start[0], end[1] - end[0])):  # fmt: skip
        low, high = sorted((a, b))
        levels = numpy.arange(numpy.floor(low) + 1, numpy.ceil(high))
        if a != b:
            found.append((levels - a) / (b - a))
    return numpy.concatenate([*found, [0.5]])


def is_seen(heights, eye, cell, surface):
    """Whether the line from the eye (column, row, height) to a cell is above the surface."""
    row, column = cell
    end = numpy.array([column, row, heights[row, column]])
    if surface is by_triangles:
        shares = crossings(eye[:2], end[:2])
    else:
        steps = 8 * numpy.ceil(numpy.abs(end[:2] - eye[:2]).max()) + 1
        shares = numpy.arange(1, steps) / steps
    u, v, line = (eye[k] + shares * (end[k] - eye[k]) for k in range(3))
    return bool((line - surface(heights, u, v) >= -1e-9).all())


def main():
    made = parser(__doc__, 3)
    made.add_argument("--small", action="store_true", help="a small terrain")
    words = made.parse_args()
    table = csv.writer(sys.stdout, lineterminator="\n")
    table.writerow(COLUMNS)
    for side in (100,) if words.small else (500, 1000, 2000):
        heights = ridges(side)
        third = side // 3
        middle = heights[third:-third, third:-third]
        row, column = numpy.argwhere(middle == middle.max())[0] + third
        x, y = (column + 0.5) * CELL, (side - row - 0.5) * CELL  # rows run downwards
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            terrain = relievo.terrain(heights, (CELL, 0, 0, 0, -CELL, side * CELL))
            dem, seen = str(folder / "dem.tif"), str(folder / "seen.tif")
            terrain.write(dem, {"height": heights})
            methods = {
                "relievo viewshed": [words.relievo, "viewshed", dem, "--observer",
                                     f"{x},{y},{HEIGHT}", "-o", seen],
                "gdal_viewshed": ["gdal_viewshed", "-q", "-ox", str(x), "-oy", str(y), "-oz",
                                  str(HEIGHT), "-tz", "0", "-cc", "0", "-md", "0", "-vv", "1", dem,
                                  seen],
            }  # fmt: skip
            eye = numpy.array([column, row, heights[row, column] + HEIGHT])
            lots = numpy.random.default_rng(side)
            cells = lots.integers(side, size=(SAMPLES, 2))
            exact = {surface: numpy.array([is_seen(heights.astype(float), eye, cell, surface)
                                           for cell in cells])
                     for surface in (by_triangles, bilinear)}  # fmt: skip
            for method, command in methods.items():
                costs = [run(command, peak=True) for _ in range(words.rounds)]
                found = gdal.Open(seen).ReadAsArray() == 1
                differ = [100 * (found[cells[:, 0], cells[:, 1]] != exact[surface]).mean()
                          for surface in (by_triangles, bilinear)]  # fmt: skip
                table.writerow([side * side, method,
                                f"{min(cost.processor for cost in costs):.3g}",
                                round(max(cost.peak for cost in costs) / 2**20),
                                *(f"{each:.3g}" for each in differ),
                                f"{100 * found.mean():.3g}"])  # fmt: skip
                sys.stdout.flush()
    subprocess.run(["gdalinfo", "--version"], stdout=sys.stderr, check=True)


if __name__ == "__main__":
    main()
