# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers as pictures, and pictures with captions on one sheet."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws the captions' letters)
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer

PAPER = (24, 25, 28)
INK = (0.90, 0.90, 0.88)
NOTHING = numpy.array((40, 42, 46), numpy.uint8)  # where a layer has no value

# Nine colours of viridis, dark to light and even in lightness.
MAP = numpy.array(
    [
        (0.267, 0.005, 0.329), (0.283, 0.141, 0.458), (0.254, 0.265, 0.530), (0.207, 0.372, 0.553),
        (0.164, 0.471, 0.558), (0.128, 0.567, 0.551), (0.267, 0.749, 0.441), (0.627, 0.854, 0.223),
        (0.993, 0.906, 0.144),
    ]
)  # fmt: skip

IDS = ("actor", "block", "cell")


def picture_of(name, values):
    """A layer as 8-bit RGB (rows, columns, 3), and words for its caption.

    Scalars go over their own range, but for the last percent at either end; unit vectors are shown
    as 0.5 v + 0.5, positions within their bounds, ids each in a colour of its own.
    """
    if name == "color":
        return bytes_of(srgb(values[..., :3])), "the picture, shown as sRGB"
    if name == "albedo":
        return values[..., :3].copy(), "before lighting"
    if name in IDS or numpy.issubdtype(values.dtype, numpy.integer):
        count = len(numpy.unique(values[values >= 0]))
        return hashed(values), f"{count} {'value' if count == 1 else 'values'} visible"
    if name == "position":
        low, high = values.min(axis=(0, 1)), values.max(axis=(0, 1))
        text = "  ".join(f"{a} {l:.1f} to {h:.1f}" for a, l, h in zip("xyz", low, high))
        return bytes_of((values - low) / numpy.maximum(high - low, 1e-30)), text
    if values.ndim == 3:
        seen = (values != 0).any(axis=2)
        return where(seen, bytes_of(0.5 * values + 0.5)), "0.5 n + 0.5, world space"
    seen = numpy.isfinite(values)
    low, high = numpy.percentile(values[seen], (1, 99)) if seen.any() else (0.0, 1.0)
    share = numpy.where(seen, (values - low) / max(high - low, 1e-30), 0.0)
    return where(seen, bytes_of(mapped(share))), f"{low:.3g} to {high:.3g}"


def bytes_of(colours):
    return (numpy.clip(colours, 0, 1) * 255 + 0.5).astype(numpy.uint8)


def where(seen, colours):
    return numpy.where(seen[..., None], colours, NOTHING)


def mapped(share):
    """Shares from 0 to 1 as colours of the map."""
    place = numpy.clip(share, 0, 1) * (len(MAP) - 1)
    return numpy.stack([numpy.interp(place, range(len(MAP)), MAP[:, i]) for i in range(3)], axis=-1)


def hashed(ids):
    """A colour for each id: neighbours get hues that are far apart."""
    mixed = (ids.astype(numpy.int64) + 1).astype(numpy.uint64) * numpy.uint64(0x9E3779B97F4A7C15)
    mixed ^= mixed >> numpy.uint64(29)
    hue = (mixed >> numpy.uint64(40)).astype(float) / (1 << 24)
    light = 0.60 + 0.35 * ((mixed >> numpy.uint64(16)) & numpy.uint64(0xFF)).astype(float) / 255
    wheel = numpy.abs((hue[..., None] * 6 + (0, 4, 2)) % 6 - 3) - 1
    colours = light[..., None] * (0.35 + 0.65 * numpy.clip(wheel, 0, 1))
    return where(ids >= 0, bytes_of(colours))


def srgb(linear):
    """Linear light to sRGB (IEC 61966-2-1)."""
    linear = numpy.clip(linear, 0, 1)
    return numpy.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055
    )


def shrunk(picture, factor):
    """The picture with each block of factor x factor pixels as their mean."""
    rows, columns = picture.shape[0] // factor, picture.shape[1] // factor
    whole = picture[: rows * factor, : columns * factor].astype(float)
    return whole.reshape(rows, factor, columns, factor, -1).mean(axis=(1, 3))


def contact_sheet(tiles, across, width, title):
    """Pictures of one shape with captions, as one picture. tiles: (name, words, RGB bytes)."""
    factor = max(1, round(tiles[0][2].shape[1] / width))
    # A mean of two ids' colours would be the colour of a third.
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
    image = vtkImageData()
    image.SetDimensions(rgb.shape[1], rgb.shape[0], 1)
    flat = numpy.ascontiguousarray(rgb[::-1]).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path))
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"{path}: cannot be written")
