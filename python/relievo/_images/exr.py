# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenEXR files, out and in."""

import os

import numpy

from .._arguments.errors import Watch, check_file, path_of, require
from ..vtk.vtkCommonDataModel import vtkImageData
from ..vtkRelievoIO import vtkRelievoEXRReader, vtkRelievoEXRWriter
from .image import to_image
from .picture import captured

_PIXEL_TYPES = {
    "uint": vtkRelievoEXRWriter.UINT,
    "half": vtkRelievoEXRWriter.HALF,
    "float": vtkRelievoEXRWriter.FLOAT,
}

# Extensions of other image formats, which users may expect to select the format.
_OTHERS = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".hdr", ".pfm", ".npy", ".npz")

# FileNotFoundError, CannotOpenFileError, OutOfDiskSpaceError of vtkErrorCode, which not every VTK
# wraps.
_FILE_ERRORS = (20001, 20002, 20007)


def write_exr(path, image, compression="zip", pixel_types=None) -> None:
    """Writes every layer of an image to one OpenEXR file, top row first.

    path: name of the file, str or path-like; not one of another kind of image, such as .png. An
        existing file is replaced when the new one is complete; after an error it is unchanged.
    image: vtkImageData of (columns, rows, 1) points, as returned by capture(); or a numpy array of
        the layer `color`, or a dict of arrays by names, as for to_image().
    compression: none, rle, zips, zip, piz (lossless), pxr24, b44, b44a, dwaa or dwab (not). The
        last four make numbers of infinities and NaN, which raises: b44 in half, dwaa in R, G, B, Y.
    pixel_types: {name: "half" | "float" | "uint"} for layers ("normal") or channels ("normal.X");
        the others keep their own type: floats FLOAT, integers UINT.

    Channels: color as R G B A, then depth.Z, normal.X normal.Y normal.Z, actor.id (UINT, background
    0xFFFFFFFF) and so on, arrays as NAME.V; the camera and the lights are attributes. position is
    written relative to the attribute relievo:origin. docs/exr.md has all names.

    Raises ValueError for an invalid argument or for values that a pixel type cannot hold, OSError
    if the file cannot be written (its errno says why: ENOSPC on a full disk, for example).
    """
    path = path_of(path, "path")
    suffix = os.path.splitext(path)[1].lower()
    if suffix in _OTHERS:
        raise ValueError(f"path: got {path!r}, expected an OpenEXR file, .exr; "
                         f"relievo.write_png() writes PNG files")
    if isinstance(image, (dict, numpy.ndarray)):
        image = to_image(image, "color")
    require(image, "vtkImageData", "image")
    writer = vtkRelievoEXRWriter()
    with Watch(writer) as watch:
        if not (isinstance(compression, str) and writer.SetCompressionByName(compression)):
            raise ValueError(
                f"compression: got {compression!r}, expected none, rle, zips, zip, piz, pxr24, "
                "b44, b44a, dwaa or dwab"
            )
        for name, kind in (pixel_types or {}).items():
            if kind not in _PIXEL_TYPES:
                raise ValueError(
                    f"pixel_types[{name!r}]: got {kind!r}, expected half, float or uint"
                )
            writer.SetPixelType(name, _PIXEL_TYPES[kind])
        watch.raise_as(ValueError, "pixel_types")
        writer.SetFileName(path)
        writer.SetInputData(image)
        written = writer.Write()
    if not written:
        system = writer.GetSystemError()
        if system:
            raise OSError(system, os.strerror(system), path)
        raise _refusal(watch, writer, path)


def read_exr(path) -> vtkImageData:
    """Reads the layers of an OpenEXR file as an image.

    path: name of the file, str or path-like. Scan lines or tiles, one part or several, any
        compression; deep data is refused.

    Returns vtkImageData of (columns, rows, 1) points, VTK's row 0 at the bottom (layer() gives
    row 0 at the top), one point array per layer, attributes as field data. A file of write_exr()
    gives back its layers bit for bit, with position in world space. In other files R G B [A]
    become `color` and every other channel or group of channels its own array, float or unsigned
    int.

    Raises FileNotFoundError or another OSError if the file cannot be opened, ValueError if it is
    not a complete OpenEXR file.
    """
    name = path_of(path, "path")
    check_file(name)
    reader = vtkRelievoEXRReader()
    reader.SetFileName(name)
    with Watch(reader) as watch:
        reader.Update()
    if watch.errors or reader.GetErrorCode() != 0:
        raise _refusal(watch, reader, name)
    return captured(reader.GetOutput())


def _refusal(watch, algorithm, name):
    """The exception for the failure of an EXR reader or writer."""
    said = watch.errors[0] if watch.errors else f"{name}: failed without a message"
    of_the_file = algorithm.GetErrorCode() in _FILE_ERRORS or not watch.errors
    return (OSError if of_the_file else ValueError)(said)
