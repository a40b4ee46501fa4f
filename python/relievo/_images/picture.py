# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layers as pictures."""

import os
import tempfile

import numpy

from ..vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from ..vtk.vtkCommonCore import vtkStringArray
from ..vtk.vtkCommonDataModel import vtkImageData
from ..vtk.vtkIOImage import vtkPNGWriter
from .image import layer, layer_names, to_image

NOTHING = numpy.array((40, 42, 46), numpy.uint8)  # colour of pixels without a value

# Viridis, dark to light with even steps of lightness; linear between these colours within 0.03.
MAP = numpy.array(
    [
        (0.267, 0.005, 0.329), (0.282, 0.095, 0.417), (0.279, 0.175, 0.483), (0.259, 0.252, 0.525),
        (0.230, 0.322, 0.546), (0.199, 0.388, 0.555), (0.173, 0.449, 0.558), (0.149, 0.508, 0.557),
        (0.128, 0.567, 0.551), (0.121, 0.626, 0.533), (0.158, 0.684, 0.502), (0.246, 0.739, 0.452),
        (0.369, 0.789, 0.383), (0.516, 0.831, 0.294), (0.678, 0.864, 0.190), (0.846, 0.887, 0.100),
        (0.993, 0.906, 0.144),
    ]
)  # fmt: skip

IDS = ("actor", "block", "cell")


def picture_of(name, values):
    """A layer as 8-bit RGB (rows, columns, 3), and a text for its caption.

    Scalars cover their own range, except the last percent at either end; unit vectors are shown as
    0.5 v + 0.5, positions within their bounds, and each id in a different colour.
    """
    if name == "color":
        return bytes_of(srgb(values[..., :3])), "the picture, shown as sRGB"
    if name == "albedo":
        return values[..., :3].copy(), "before lighting"
    if name in IDS or numpy.issubdtype(values.dtype, numpy.integer):
        count = len(numpy.unique(values[values >= 0]))
        return hashed(values), f"{count} {'value' if count == 1 else 'values'} visible"
    if name == "position":
        seen = (values != 0).any(axis=2)
        if not seen.any():
            return where(seen, bytes_of(values)), "nothing visible"
        low, high = values[seen].min(axis=0), values[seen].max(axis=0)
        text = "  ".join(f"{a} {l:.1f} to {h:.1f}" for a, l, h in zip("xyz", low, high))
        return where(seen, bytes_of((values - low) / numpy.maximum(high - low, 1e-30))), text
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
    """Values from 0 to 1 as colours of the map."""
    place = numpy.clip(share, 0, 1) * (len(MAP) - 1)
    return numpy.stack([numpy.interp(place, range(len(MAP)), MAP[:, i]) for i in range(3)], axis=-1)


def hashed(ids):
    """A colour for each id: consecutive ids get very different hues."""
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


def png_of(rgb):
    """The bytes of a PNG file with 8 bits, (rows, columns) or (rows, columns, components), row 0 at
    the top."""
    writer = vtkPNGWriter()
    writer.SetInputData(to_image(rgb))
    writer.WriteToMemoryOn()
    writer.Write()
    return numpy.asarray(writer.GetResult()).tobytes()


def picture(image, name) -> numpy.ndarray:
    """Returns a layer as a picture: uint8 of shape (rows, columns, 3), ROW 0 AT THE TOP.

    image: vtkImageData from capture() or read_exr(). name: the layer's name.

    Numbers are shown by viridis over their own range, except the last percent at either end, unit
    vectors as 0.5 v + 0.5, positions within their bounds, each id in a different colour, light as
    sRGB, and pixels without a value dark grey. For values, use layer().

    Raises ValueError for a name that the image does not have.
    """
    return picture_of(name, layer(image, name))[0]


def write_png(path, image, name=None, transparent=False) -> None:
    """Writes a layer of an image as a PNG file, 8 bits.

        relievo.write_png("picture.png", relievo.capture(renderer, "color", size=(1280, 720)))

    path: name of the file, str or path-like. An existing file is replaced when the new one is
        complete.
    image: vtkImageData from capture() or read_exr(), or a numpy array of uint8, (rows, columns) or
        (rows, columns, 1 to 4), which is written unchanged.
    name: the layer; None for `color` if the image has it, else the only one.
    transparent: whether `color` keeps its alpha, not premultiplied; the background has the
        renderer's GetBackgroundAlpha(), by default 0.

    color is written as sRGB, other layers as picture() shows them.

    Raises ValueError for invalid arguments, OSError if the file cannot be written.
    """
    name_of_file = os.fsdecode(path) if isinstance(path, (str, bytes, os.PathLike)) else ""
    if os.path.splitext(name_of_file)[1].lower() != ".png":
        raise ValueError(f"path: got {path!r}, expected a name that ends in .png")
    if isinstance(image, numpy.ndarray):
        right = image.ndim == 2 or (image.ndim == 3 and 1 <= image.shape[2] <= 4)
        if image.dtype != numpy.uint8 or not right:
            raise ValueError(f"image: got an array of {image.dtype} and shape {image.shape}, "
                             f"expected uint8, (rows, columns) or (rows, columns, 1 to 4)")
        data = png_of(image)
    else:
        known = layer_names(image)
        if name is None:
            name = known[0] if len(known) == 1 else "color"
            if name not in known:
                raise ValueError(f"name: got None, expected one of {', '.join(known) or 'none'}")
        if transparent and name != "color":
            raise ValueError(f"transparent: got it for {name!r}, expected it for color alone")
        values = layer(image, name)
        with_alpha = name == "color" and transparent and values.shape[2] == 4
        data = png_of(_rgba(values) if with_alpha else picture_of(name, values)[0])
    folder = os.path.dirname(os.path.abspath(name_of_file))
    try:
        part = tempfile.NamedTemporaryFile(dir=folder, prefix=".relievo-", delete=False)
    except OSError as error:
        raise type(error)(error.errno, error.strerror, name_of_file) from None
    try:
        with part:
            part.write(data)
        umask = os.umask(0)
        os.umask(umask)
        os.chmod(part.name, 0o666 & ~umask)
        os.replace(part.name, name_of_file)
    except BaseException:
        os.remove(part.name)
        raise


def _rgba(linear):
    """Linear light, premultiplied, as 8-bit sRGB with alpha not premultiplied."""
    rgb, alpha = linear[..., :3], linear[..., 3:]
    straight = numpy.divide(rgb, alpha, out=numpy.zeros_like(rgb), where=alpha > 0)
    return numpy.concatenate([bytes_of(srgb(straight)), bytes_of(alpha)], axis=2)


def _values_of(data):
    """The arrays of point or field data: names, types, and numpy arrays or lists of texts."""
    arrays = map(data.GetAbstractArray, range(data.GetNumberOfArrays()))
    return [
        (each.GetName(), None, [each.GetValue(i) for i in range(each.GetNumberOfValues())])
        if each.IsA("vtkStringArray")
        else (each.GetName(), each.GetDataType(), vtk_to_numpy(each))
        for each in arrays
    ]


def _restored(extent, spacing, origin, of_points, of_field):
    """A capture from its pickled parts."""
    image = Capture()
    image.SetExtent(extent)
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    for data, arrays in ((image.GetPointData(), of_points), (image.GetFieldData(), of_field)):
        for name, kind, values in arrays:
            if kind is None:
                array = vtkStringArray()
                for text in values:
                    array.InsertNextValue(text)
            else:
                array = numpy_to_vtk(values, deep=True, array_type=kind)
            array.SetName(name)
            data.AddArray(array)
    return image


class Capture(vtkImageData):
    """Layers as vtkImageData, which notebooks show as pictures side by side; it can be pickled."""

    def __repr__(self):
        columns, rows, _ = self.GetDimensions()
        return f"<relievo capture of {columns} x {rows} pixels: {', '.join(layer_names(self))}>"

    def __reduce__(self):
        parts = self.GetExtent(), self.GetSpacing(), self.GetOrigin()
        return _restored, (*parts, *map(_values_of, (self.GetPointData(), self.GetFieldData())))

    def _repr_png_(self):
        names = layer_names(self)
        if not names:
            return None
        across = min(len(names), 3)
        pictures = [picture(self, name) for name in names]
        step = max(1, -(-pictures[0].shape[1] * across // 1600))
        pictures = [shown[::step, ::step] for shown in pictures]
        rows = [pictures[i : i + across] for i in range(0, len(pictures), across)]
        rows[-1] += [numpy.full_like(pictures[0], 255)] * (across - len(rows[-1]))
        return png_of(numpy.concatenate([numpy.concatenate(row, axis=1) for row in rows]))


def captured(data):
    """A copy of an image, without copies of its arrays, that notebooks show."""
    image = Capture()
    image.ShallowCopy(data)
    return image
