# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cells of a terrain that two observers see: a raster on its grid, and a picture.

    34_viewshed.py [FOLDER]

Default: the current folder. Writes to FOLDER
    viewshed.tif    the number of observers that see each cell, a GeoTIFF
    viewshed.vtp    the terrain as a mesh with that number
    viewshed.png    the terrain, coloured by it

The program makes the heights itself. To read a file, use relievo.terrain("dem.tif"), or with
rasterio relievo.terrain(src.read(1), src.transform, src.nodata).
"""

import numpy
import relievo
from relievo.vtk.vtkIOXML import vtkXMLPolyDataWriter

import scene

ROWS, COLUMNS, CELL = 360, 480, 10.0  # metres
LEFT, TOP = 689000.0, 5338000.0  # UTM
HEIGHT = 10  # metres of the observers above the ground
SIZE = (1280, 640)
COLORS = "#8a9096,#f0b429,#e4572e"  # seen by none, one, both
# From the south and above: position, focal point, up.
CAMERA = (691400, 5330900, 4400, 691400, 5335900, 450, 0, 0, 1)


def heights():
    """Ridges: waves of random directions whose amplitude falls with their frequency."""
    lots = numpy.random.default_rng(11)
    v, u = numpy.mgrid[:ROWS, :COLUMNS] / COLUMNS
    sum_ = numpy.zeros((ROWS, COLUMNS))
    for _ in range(80):
        frequency = 2 ** lots.uniform(0.5, 5)
        turn, phase = lots.uniform(0, 2 * numpy.pi, 2)
        wave = numpy.sin(
            2 * numpy.pi * frequency * (u * numpy.cos(turn) + v * numpy.sin(turn)) + phase)
        sum_ += (1 - abs(wave)) / frequency
    return 400 + 700 * (sum_ - sum_.min()) / numpy.ptp(sum_)


def main():
    folder = scene.folder()
    transform = (CELL, 0, LEFT, 0, -CELL, TOP)
    hills = relievo.terrain(heights(), transform)
    # The highest places of the west and the east.
    observers = []
    for part in (slice(0, COLUMNS // 2), slice(COLUMNS // 2, COLUMNS)):
        row, column = numpy.argwhere(hills.heights == hills.heights[40:-40, part].max())[0] + 0.5
        observers.append((LEFT + CELL * column, TOP - CELL * row, HEIGHT))
    mesh = relievo.viewshed(hills, observers, target_height=1.7)
    seen = hills.rasters(mesh)["seen"]
    print(f"{(seen > 0).mean():.1%} of {seen.size} cells are seen, "
          f"{(seen > 1).mean():.1%} by both observers")
    hills.write(folder / "viewshed.tif", {"seen": seen})
    writer = vtkXMLPolyDataWriter()
    writer.SetDataModeToBinary()  # with newer expat, VTK 9.2 cannot read appended data
    writer.SetInputData(mesh)
    writer.SetFileName(str(folder / "viewshed.vtp"))
    if not writer.Write():
        raise SystemExit(f"{folder / 'viewshed.vtp'}: could not be written")
    picture = str(folder / "viewshed.png")
    relievo.scene(str(folder / "viewshed.vtp"), color_by="seen", colormap=COLORS, up="z",
                  camera=CAMERA, preset="studio", ground=False, size=SIZE).render(picture)
    print(f"wrote viewshed.tif, viewshed.vtp and {picture}")


if __name__ == "__main__":
    main()
