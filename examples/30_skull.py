# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A skull as a volume in studio light, with a soft shadow on the ground, and its depth.

    30_skull.py [FOLDER]    writes FOLDER/skull.png and FOLDER/skull_depth.png

The second picture is the layer volume_depth: where half of the light is absorbed.
"""

import pathlib
import tempfile

import numpy
import relievo
from relievo.vtk.vtkIOXML import vtkXMLImageDataWriter

import scene

SIZE = (960, 720)
BONE = 2.9  # the value at the surface of the bone
SPACING = (3.94305, 3.94305, 3.65079)


def write_image(path):
    """The scan, 64 x 64 x 64 floats behind a header of 256 bytes, as an image of VTK."""
    with open(scene.data("skull_2.9.inr"), "rb") as file:
        values = numpy.frombuffer(file.read()[256:], "<f4").reshape(64, 64, 64)
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(scene.image(values, SPACING))
    writer.SetFileName(str(path))
    writer.Write()


def main():
    folder = scene.folder()
    with tempfile.TemporaryDirectory() as scratch:
        path = pathlib.Path(scratch) / "skull.vti"
        write_image(path)
        skull = relievo.scene(
            path, image="volume", size=SIZE, preset="studio",
            opacity_curve=f"{BONE - 0.4}/0,{BONE}/0.3,{BONE + 1}/0.9",
            colormap="#6e5238,#b4a283,#cfc6b4", range=(BONE - 0.4, BONE + 1.2))  # fmt: skip
        skull.render(folder / "skull.png")
        image = relievo.capture(skull.renderer, ["volume_depth"], size=SIZE)
        relievo.write_png(folder / "skull_depth.png", image, "volume_depth")
        found = relievo.pick(skull.renderer, SIZE[0] // 2, SIZE[1] // 3, size=SIZE)
        print(f"{found.kind} of value {found.value:.2f} at {numpy.round(found.position)}")
    for name in ("skull.png", "skull_depth.png"):
        print(folder / name)


if __name__ == "__main__":
    main()
