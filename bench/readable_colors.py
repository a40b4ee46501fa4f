# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""How far the colours of values in a picture are from those of the colour bar.

    python bench/readable_colors.py RELIEVO DATA [--before RELIEVO] [--size WxH] [--files a,b]
        [--maps a,b] >readable.csv

RELIEVO is the command, DATA the folder that tools/unpack-data fills. Each file is coloured by the
height of its points and drawn with each preset of lights, and by VTK's headlight alone; with
--before, also by an earlier version of the command. The error of a pixel is the difference
CIEDE2000 (G. Sharma, W. Wu, E. N. Dalal, Color Research and Application 30(1), 2005) from the layer
`albedo`, whose colours are those of the bar, over the pixels of the file but those of its edges.
`lightness` is the least share of the bar's lightness, L of OKLab, that all but one percent of the
pixels keep. A display is needed (tools/with-display), and numpy, Pillow and VTK.
"""

import csv
import pathlib
import sys
import tempfile

import numpy
from PIL import Image
from processes import parser, run
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

FILES = ("bunny.off", "elephant.off")
MAPS = ("viridis", "cool-warm")
PRESETS = ("studio", "town", "print", "none")
TO_XYZ = numpy.array([[0.4123908, 0.3575843, 0.1804808], [0.2126390, 0.7151687, 0.0721923],
                      [0.0193308, 0.1191948, 0.9505322]])  # fmt: skip
TO_LMS = numpy.array([[0.4122215, 0.5363325, 0.0514460], [0.2119035, 0.6806995, 0.1073970],
                      [0.0883025, 0.2817188, 0.6299787]])  # fmt: skip


def linear(rgb):
    """Linear light of display values from 0 to 255."""
    share = numpy.asarray(rgb) / 255
    return numpy.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


def lightness(rgb):
    """L of OKLab (B. Ottosson, 2020)."""
    return numpy.cbrt(linear(rgb) @ TO_LMS.T) @ (0.2104542553, 0.7936177850, -0.0040720468)


def cielab(rgb):
    """L*, a*, b* under D65."""
    share = linear(rgb) @ TO_XYZ.T / TO_XYZ.sum(axis=1)
    small = share * (29 / 6) ** 2 / 3 + 4 / 29
    root = numpy.where(share > (6 / 29) ** 3, numpy.cbrt(share), small)
    x, y, z = numpy.moveaxis(root, -1, 0)
    return numpy.stack([116 * y - 16, 500 * (x - y), 200 * (y - z)], axis=-1)


def ciede2000(first, second):
    """Differences of colours in CIELAB."""
    (l1, a1, b1), (l2, a2, b2) = (numpy.moveaxis(each, -1, 0) for each in (first, second))
    chroma = (numpy.hypot(a1, b1) + numpy.hypot(a2, b2)) / 2
    g = 0.5 * (1 - numpy.sqrt(chroma**7 / (chroma**7 + 25.0**7)))
    a1, a2 = (1 + g) * a1, (1 + g) * a2
    c1, c2 = numpy.hypot(a1, b1), numpy.hypot(a2, b2)
    h1, h2 = (numpy.degrees(numpy.arctan2(b, a)) % 360 for a, b in ((a1, b1), (a2, b2)))
    turn = (h2 - h1 + 180) % 360 - 180
    grey = c1 * c2 == 0
    turn = numpy.where(grey, 0, turn)
    hue = 2 * numpy.sqrt(c1 * c2) * numpy.sin(numpy.radians(turn / 2))
    mean_l, mean_c = (l1 + l2) / 2, (c1 + c2) / 2
    mean_h = numpy.where(grey, h1 + h2, (h1 + turn / 2) % 360)
    waves = ((-0.17, 1, -30), (0.24, 2, 0), (0.32, 3, 6), (-0.20, 4, -63))
    t = 1 + sum(factor * numpy.cos(numpy.radians(times * mean_h + shift))
                for factor, times, shift in waves)  # fmt: skip
    s_l = 1 + 0.015 * (mean_l - 50) ** 2 / numpy.sqrt(20 + (mean_l - 50) ** 2)
    s_c, s_h = 1 + 0.045 * mean_c, 1 + 0.015 * mean_c * t
    blue = numpy.radians(60 * numpy.exp(-(((mean_h - 275) / 25) ** 2)))
    rotation = -2 * numpy.sqrt(mean_c**7 / (mean_c**7 + 25.0**7)) * numpy.sin(blue)
    l, c, h = (l2 - l1) / s_l, (c2 - c1) / s_c, hue / s_h
    return numpy.sqrt(l**2 + c**2 + h**2 + rotation * c * h)


def load(path):
    """The surface of an OBJ file, or of an OFF file of triangles."""
    if path.suffix == ".obj":
        reader = vtkOBJReader()
        reader.SetFileName(str(path))
        reader.Update()
        return reader.GetOutput()
    words = path.read_text().split()
    count = int(words[1])
    mesh, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places = numpy.array(words[4 : 4 + 3 * count], float).reshape(count, 3)
    points.SetData(numpy_to_vtk(places, deep=True))
    for corners in numpy.array(words[4 + 3 * count :], int).reshape(-1, 4)[:, 1:]:
        cells.InsertNextCell(3, corners.tolist())
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    return mesh


def by_height(path, folder):
    """A file of the surface with the array `height`."""
    mesh = load(path)
    heights = vtk_to_numpy(mesh.GetPoints().GetData())[:, 2 if path.suffix == ".obj" else 1]
    array = numpy_to_vtk(heights.copy(), deep=True)
    array.SetName("height")
    mesh.GetPointData().AddArray(array)
    writer = vtkXMLPolyDataWriter()
    writer.SetDataModeToBinary()
    writer.SetFileName(str(folder / (path.stem + ".vtp")))
    writer.SetInputData(mesh)
    writer.Write()
    return writer.GetFileName()


def measure(given, path, colormap, folder):
    """A row for each method."""
    picture = folder / "picture.png"

    def draw(command, *words):
        run([command, "render", path, "--size", given.size, "--color-by", "height", "--colormap",
             colormap, "--up", "z" if "motorBike" in path else "y", "--ground", "off", "--stage",
             "antialias:samples=1", *words, "--png", str(picture)])  # fmt: skip
        return numpy.asarray(Image.open(picture).convert("RGB")).astype(float)

    seen = {}  # the bar's colours and the judged pixels, which are those of all presets of lights
    for preset in ("studio", "none"):
        bar, other = (draw(given.relievo, "--preset", preset, "--stage", "display:layer=albedo",
                           "--background", color) for color in ("black", "white"))  # fmt: skip
        mesh = (bar == other).all(axis=2)
        around = [numpy.roll(mesh, step, axis) for axis in (0, 1) for step in (-2, 2)]
        seen[preset] = bar, numpy.logical_and.reduce([mesh, *around])
    for before in [None, given.before] if given.before else [None]:
        for preset in PRESETS:
            if before and preset == "none":
                continue
            bar, judged = seen.get(preset, seen["studio"])
            shown = draw(before or given.relievo, "--preset", preset)[judged]
            errors = ciede2000(cielab(shown), cielab(bar[judged]))
            kept = lightness(shown) / numpy.maximum(lightness(bar[judged]), 1e-3)
            name = "VTK's headlight" if preset == "none" else preset
            yield [pathlib.Path(path).stem, colormap, name + (", before" if before else ""),
                   f"{numpy.median(errors):.2f}", f"{numpy.percentile(errors, 95):.2f}",
                   f"{numpy.percentile(kept, 1):.3f}", int(judged.sum())]  # fmt: skip


def main():
    options = parser(__doc__, 1)
    options.add_argument("data")
    options.add_argument("--before")
    options.add_argument("--size", default="320x240")
    options.add_argument("--files", default=",".join(FILES))
    options.add_argument("--maps", default=",".join(MAPS))
    given = options.parse_args()
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["scene", "map", "method", "median", "p95", "lightness", "pixels"])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file in given.files.split(","):
            path = by_height(pathlib.Path(given.data, file), folder)
            for colormap in given.maps.split(","):
                writer.writerows(measure(given, path, colormap, folder))
                sys.stdout.flush()


if __name__ == "__main__":
    main()
