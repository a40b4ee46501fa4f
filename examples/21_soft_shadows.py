# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shadows of a small, a large and a rectangular lamp in one scene, and the share of light.

    21_soft_shadows.py [FOLDER] [SAMPLES]    writes FOLDER/soft_shadows.png

Top: the pictures of a point light, a ball, and a long, tube-like rectangle.
Bottom: the layer shadow_0 of each, the share of the lamp visible from a pixel.
"""

import sys

import numpy
import relievo

import demo_sheet
import scene

SIZE = (420, 320)
NONE, LONG, THIN = (0, 0, 0), (0, 0, 3.0), (0.2, 0, 0)


def pictures(samples, radius, edges):
    renderer, window = scene.make(*SIZE)
    renderer.SetBackground(0.09, 0.1, 0.13)
    lights = renderer.GetLights()
    lights.InitTraversal()
    lamp = lights.GetNextItem()
    lamp.SetPositional(True)
    lamp.SetConeAngle(180)
    lamp.SetPosition(2.2, 3.6, 1.4)
    frame = relievo.attach(renderer)
    frame.ShadowsOn()
    shadows = frame.GetShadowStage()
    shadows.SetMethodToExact()
    shadows.SetSoftSamples(samples)
    shadows.SetLightSize(lamp, radius)
    shadows.SetLightEdges(lamp, *edges)
    image = relievo.capture(renderer, ["color", "shadow_0"])
    color = demo_sheet.picture_of("color", relievo.layer(image, "color"))[0]
    share = relievo.layer(image, "shadow_0")
    inside = numpy.count_nonzero((share > 0) & (share < 1))
    print(f"radius {radius}: {inside} pixels see a part of the lamp")
    grey = demo_sheet.bytes_of(numpy.repeat(share[..., None], 3, axis=-1))
    return numpy.concatenate([color, grey], axis=0)


def main():
    folder = scene.folder()
    samples = int(sys.argv[2]) if len(sys.argv) > 2 else 64
    lamps = ((0.0, (NONE, NONE)), (0.45, (NONE, NONE)), (0.0, (LONG, THIN)))
    columns = [pictures(samples, radius, edges) for radius, edges in lamps]
    demo_sheet.write_png(folder / "soft_shadows.png", numpy.concatenate(columns, axis=1))
    print(folder / "soft_shadows.png")


if __name__ == "__main__":
    main()
