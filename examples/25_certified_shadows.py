# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shadows by a small map, by a tolerance, and exact ones, each with a certificate of its errors.

    25_certified_shadows.py [FOLDER] [RAYS]    writes FOLDER/certified_shadows.png

Top: the pictures. Bottom: an enlarged piece of the layer shadow_0 of each. Certify checks RAYS
random pixels by rays in double precision, and returns an upper bound of the share of errors.
"""

import sys

import numpy
import relievo

import demo_sheet
import scene

SIZE = (420, 320)
PIECE = (slice(150, 190), slice(160, 213))  # rows and columns at the edge of the ring's shadow
ENLARGED = 8


def use_small_map(shadows):
    shadows.SetMethodToMap()
    shadows.SetMapSize(512)


def use_tolerance(shadows):
    shadows.SetTolerance(0.001)  # 0.1 % of the pixels that face the sun


def use_exact(shadows):
    shadows.SetMethodToExact()


def column(name, choose, rays):
    renderer, window = scene.make(*SIZE)
    renderer.SetBackground(0.74, 0.83, 0.90)
    frame = relievo.attach(renderer)
    frame.ShadowsOn()
    shadows = frame.GetShadowStage()
    choose(shadows)
    window.Render()
    certificate = shadows.Certify(rays)
    print(f"{name}: {shadows.GetPlan() or 'as it is set'}")
    share = shadows.EstimateWrongShareInView(shadows.GetMethodUsed(), shadows.GetMapSizeUsed())
    print(f"  expected: {100 * share:.3g} % wrong")
    print(f"  found: {certificate.GetWrong()} of {certificate.GetJudged()} verdicts are wrong")
    print(f"  proven: at most {100 * certificate.GetWrongShareBound():.3g} %, confidence 95 %")
    image = relievo.capture(renderer, ["color", "shadow_0"])
    color = demo_sheet.picture_of("color", relievo.layer(image, "color"))[0]
    piece = relievo.layer(image, "shadow_0")[PIECE]
    piece = piece.repeat(ENLARGED, axis=0).repeat(ENLARGED, axis=1)[:, : SIZE[0]]
    grey = demo_sheet.bytes_of(numpy.repeat(piece[..., None], 3, axis=-1))
    return numpy.concatenate([color, grey], axis=0)


def main():
    folder = scene.folder()
    rays = int(sys.argv[2]) if len(sys.argv) > 2 else 20000
    ways = (("map of 512", use_small_map), ("tolerance", use_tolerance), ("exact", use_exact))
    columns = [column(name, choose, rays) for name, choose in ways]
    demo_sheet.write_png(folder / "certified_shadows.png", numpy.concatenate(columns, axis=1))
    print(folder / "certified_shadows.png")


if __name__ == "__main__":
    main()
