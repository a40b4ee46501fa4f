# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo: a real scene with shadows, its picture, every layer, and their cost.

    demo.py [FOLDER] [--size WxH]      default: out, 1600x900

Writes to FOLDER
    demo.png           the picture with shadows, each pixel the mean of four
    demo_layers.png    every layer as a picture, with captions
    demo.exr           every layer as numbers, in one OpenEXR file
    demo_report.json   report of the stages, with GPU time and bytes of each

Needs motorBike.obj and bunny.off in the folder RELIEVO_DATA (default: build/data beside this
folder); tools/unpack-data puts them there. Exit status: 0 done, 1 failed, 2 invalid arguments.
"""

import json
import os
import pathlib
import sys
import time

import relievo
from relievo.vtk.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter

import demo_scene
import demo_sheet

LAYERS = [
    "color", "depth", "range", "normal", "geometric_normal", "position", "albedo", "actor", "block",
    "cell", "height", "part", "shadow_0", "shadow_1",
]  # fmt: skip
STEPS = 6


class Steps:
    """Prints each step and its time."""

    def __init__(self):
        self.number = 0
        self.began = None

    def next(self, what):
        self.end()
        self.number += 1
        self.began = time.monotonic()
        print(f"  {self.number}/{STEPS} {what:44}", end="", flush=True)

    def end(self):
        if self.began is not None:
            print(f"{time.monotonic() - self.began:6.1f} s", flush=True)
            self.began = None


def words():
    """The folder and the size of the command line; ends with status 2 if they are wrong."""
    folder, size, rest = "out", (1600, 900), sys.argv[1:]
    while rest:
        word = rest.pop(0)
        if word in ("-h", "--help"):
            print(__doc__)
            sys.exit(0)
        if word == "--size":
            given = rest.pop(0) if rest else ""
            try:
                columns, rows = (int(part) for part in given.split("x"))
                size = (columns, rows)
                assert 16 <= columns <= 4096 and 16 <= rows <= 4096
            except (ValueError, AssertionError):
                fail(f"--size: got '{given}', expected WxH, each from 16 to 4096", 2)
        elif word.startswith("-"):
            fail(f"{word}: no such option, expected --size", 2)
        else:
            folder = word
    return pathlib.Path(folder), size


def fail(text, status=1):
    print(f"demo: {text}", file=sys.stderr)
    sys.exit(status)


def data(name):
    default = pathlib.Path(__file__).resolve().parent.parent / "build" / "data"
    path = pathlib.Path(os.environ.get("RELIEVO_DATA", default)) / name
    if not path.is_file():
        fail(f"{path} is missing: run tools/unpack-data")
    return str(path)


def smooth_picture(window, size):
    """The window's picture with each pixel the mean of four, as 8-bit RGB."""
    window.SetSize(2 * size[0], 2 * size[1])
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    fine = relievo.layer(grab.GetOutput(), "ImageScalars")
    picture = demo_sheet.bytes_of(demo_sheet.shrunk(fine, 2) / 255)
    window.SetSize(*size)
    return picture


def main():
    folder, size = words()
    bike_file, bunny_file = data("motorBike.obj"), data("bunny.off")
    folder.mkdir(parents=True, exist_ok=True)
    steps = Steps()

    steps.next("reading the motorBike and the bunny")
    bike, bunny = demo_scene.read_bike(bike_file), demo_scene.read_bunny(bunny_file)
    renderer = demo_scene.make_renderer(bike, bunny)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    frame = relievo.attach(renderer)
    frame.ShadowsOn()
    frame.GetShadowStage().SetMapSize(4096)
    frame.GetShadowStage().SetFilterRadius(3)

    steps.next(f"drawing the picture at {2 * size[0]}x{2 * size[1]}")
    demo_sheet.write_png(folder / "demo.png", smooth_picture(window, size))

    steps.next(f"capturing {len(LAYERS)} layers at {size[0]}x{size[1]}")
    image = relievo.capture(renderer, LAYERS)

    steps.next("writing demo.exr")
    relievo.write_exr(folder / "demo.exr", image)

    steps.next("drawing the contact sheet")
    tiles = []
    for name in LAYERS:
        picture, text = demo_sheet.picture_of(name, relievo.layer(image, name))
        tiles.append((name, text, picture))
    title = f"Relievo: {len(LAYERS)} layers of one frame, {size[0]} x {size[1]}"
    demo_sheet.write_png(
        folder / "demo_layers.png", demo_sheet.contact_sheet(tiles, 3, size[0] / 3, title)
    )

    steps.next("writing the frame report")
    for name in LAYERS[1:]:
        frame.RequestLayer(name)
    for _ in range(4):  # GPU times arrive some frames later, without waiting
        window.Render()
        if relievo.report(frame)["gpu_ms"] is not None:
            break
    (folder / "demo_report.json").write_text(json.dumps(relievo.report(frame), indent=2) + "\n")
    relievo.detach(renderer)
    steps.end()

    print(f"\nWrote to {folder}:")
    for name, what in (
        ("demo.png", "the picture"),
        ("demo_layers.png", "every layer as a picture"),
        ("demo.exr", "every layer as numbers: " + " ".join(LAYERS)),
        ("demo_report.json", "what the frame did and why"),
    ):
        print(f"  {name:17} {(folder / name).stat().st_size / 1e6:7.2f} MB  {what}")


if __name__ == "__main__":
    try:
        main()
    except (OSError, RuntimeError, ValueError) as error:
        fail(str(error))
