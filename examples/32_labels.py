# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A volume of labels among meshes: each hides the others, and casts its shadow on them.

    32_labels.py [FOLDER]    writes FOLDER/labels.png and FOLDER/labels_depth.png

The volume counts as solid: the layer depth, which is the second picture, shows the nearer of mesh
and volume.
"""

import numpy
import relievo

import scene

SIZE = (640, 480)
POINTS = 64


def labels():
    """Five regions of a ball, which do not blend into each other."""
    z, y, x = 2 * numpy.mgrid[0:POINTS, 0:POINTS, 0:POINTS] / (POINTS - 1) - 1
    away = numpy.sqrt(x**2 + y**2 + z**2)
    sector = (numpy.arctan2(z, x) / (2 * numpy.pi) * 4).astype(int) % 4
    values = numpy.where(away < 0.45, 5, numpy.where((away < 0.95) & (y < 0.5), 1 + sector, 0))
    made = scene.volume(
        scene.image(values.astype("u1"), (1.3 / (POINTS - 1),) * 3, (0.35, 0.0, -0.2)),
        [(0, 0), (0.5, 0), (0.51, 0.95), (5, 0.95)],
        [(1, 0.9, 0.4, 0.3), (2, 0.95, 0.75, 0.3), (3, 0.4, 0.7, 0.4), (4, 0.35, 0.5, 0.85),
         (5, 0.95, 0.9, 0.8)],
        unit=0.02)  # fmt: skip
    look = made.GetProperty()
    look.SetInterpolationTypeToNearest()
    look.ShadeOff()  # within a region values do not change: no direction to shade by
    return made


def main():
    folder = scene.folder()
    renderer, window = scene.make(*SIZE)
    renderer.SetBackground(0.85, 0.87, 0.9)
    renderer.AddVolume(labels())
    relievo.attach(renderer).ShadowsOn()
    relievo.stage(renderer, "lines", volumes=True, creases=False, folds=False)
    relievo.screenshot(renderer, folder / "labels.png")
    relievo.stage(renderer, "volumes", solid=True)
    image = relievo.capture(renderer, ["depth", "volume_value"])
    relievo.write_png(folder / "labels_depth.png", image, "depth")
    seen = relievo.layer(image, "volume_value")
    for label in range(1, 6):
        print(f"label {label}: {numpy.count_nonzero(seen == label)} pixels")
    for name in ("labels.png", "labels_depth.png"):
        print(folder / name)


if __name__ == "__main__":
    main()
