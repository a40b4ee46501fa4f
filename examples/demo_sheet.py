# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers as pictures, and pictures with captions on one sheet."""

import numpy
from relievo.vtk.util.numpy_support import vtk_to_numpy
from relievo.vtk.vtkCommonDataModel import vtkImageData
import relievo.vtk.vtkRenderingFreeType  # noqa: F401  (draws the captions' letters)
from relievo.vtk.vtkRenderingCore import vtkTextProperty, vtkTextRenderer

from relievo._images.picture import (  # noqa: F401
    IDS,
    bytes_of,
    hashed,
    mapped,
    picture_of,
    png_of,
    where,
)

PAPER = (24, 25, 28)
INK = (0.90, 0.90, 0.88)
def shrunk(picture, factor):
    """The picture with each block of factor x factor pixels as their mean."""
    rows, columns = picture.shape[0] // factor, picture.shape[1] // factor
    whole = picture[: rows * factor, : columns * factor].astype(float)
    return whole.reshape(rows, factor, columns, factor, -1).mean(axis=(1, 3))


def contact_sheet(tiles, across, width, title):
    """Pictures of equal size with captions on one sheet. tiles: (name, text, RGB bytes)."""
    factor = max(1, round(tiles[0][2].shape[1] / width))
    # The mean of two ids' colours could be that of a third id.
    small = [
        (name, words, rgb[::factor, ::factor] if name in IDS else shrunk(rgb, factor))
        for name, words, rgb in tiles
    ]
    rows, columns = (min(picture.shape[axis] for _, _, picture in small) for axis in (0, 1))
    gap, line = 14, 34
    down = -(-len(small) // across)
    sheet = numpy.empty(
        (64 + down * (rows + line + gap), gap + across * (columns + gap), 3), numpy.uint8
    )
    sheet[:] = PAPER
    write(sheet, title, gap + 2, 18, 22, bold=True)
    for i, (name, words, rgb) in enumerate(small):
        top = 64 + (i // across) * (rows + line + gap)
        left = gap + (i % across) * (columns + gap)
        sheet[top : top + rows, left : left + columns] = numpy.round(rgb[:rows, :columns])
        used = write(sheet, name, left + 2, top + rows + 8, 15, bold=True)
        write(sheet, words, left + 2 + used + 12, top + rows + 8, 13)
    return sheet


def write(sheet, text, left, top, size, bold=False):
    """Draws a line of text with its top left corner there; returns its width in pixels."""
    look = vtkTextProperty()
    look.SetFontFamilyToArial()
    look.SetFontSize(size)
    look.SetBold(bold)
    look.SetColor(1, 1, 1)
    image = vtkImageData()
    used = [0, 0]
    vtkTextRenderer.GetInstance().RenderString(look, text, image, used, 72)
    columns, rows, _ = image.GetDimensions()
    letters = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[::-1]
    rows, columns = min(rows, sheet.shape[0] - top), min(columns, used[0], sheet.shape[1] - left)
    cover = letters[:rows, :columns, 3:4].astype(float) / 255
    place = sheet[top : top + rows, left : left + columns]
    ink = numpy.array(INK if bold else [0.75 * value for value in INK]) * 255
    place[:] = (place * (1 - cover) + ink * cover + 0.5).astype(numpy.uint8)
    return columns


def write_png(path, rgb):
    """Writes 8-bit RGB (rows, columns, 3), row 0 at the top."""
    with open(path, "wb") as file:
        file.write(png_of(rgb))
