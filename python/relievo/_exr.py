# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenEXR files, out and in."""

import errno
import os

from vtkmodules.vtkCommonDataModel import vtkImageData

from ._errors import Watch, require
from .vtkRelievoIO import vtkRelievoEXRReader, vtkRelievoEXRWriter

_PIXEL_TYPES = {
    "uint": vtkRelievoEXRWriter.UINT,
    "half": vtkRelievoEXRWriter.HALF,
    "float": vtkRelievoEXRWriter.FLOAT,
}


def write_exr(path, image, compression="zip", pixel_types=None):
    """Writes every layer of an image to one OpenEXR file, top row first.

    path: name of the file, str or path-like. An existing file is replaced when the new one is
        complete; after an error it is unchanged.
    image: vtkImageData of (columns, rows, 1) points, as returned by capture().
    compression: none, rle, zips, zip, piz (lossless), pxr24, b44, b44a, dwaa or dwab (not).
    pixel_types: {name: "half" | "float" | "uint"} for layers ("normal") or channels ("normal.X");
        the others keep their own type: floats FLOAT, integers UINT.

    Channels: color as R G B A, then depth.Z, normal.X normal.Y normal.Z, actor.id (UINT, background
    0xFFFFFFFF) and so on, arrays as NAME.V; the camera and the lights are attributes. position is
    written relative to the attribute relievo:origin. docs/exr.md has all names.

    Raises ValueError for a wrong argument or for values that a pixel type cannot hold, OSError if
    the file cannot be written.
    """
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
        writer.SetFileName(os.fspath(path))
        writer.SetInputData(image)
        written = writer.Write()
    _raise(watch, written, path, _place_error(path))


def read_exr(path):
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
    name = os.fspath(path)
    with open(name, "rb"):  # Python's own errors for what is missing or forbidden
        pass
    reader = vtkRelievoEXRReader()
    reader.SetFileName(name)
    with Watch(reader) as watch:
        reader.Update()
    _raise(watch, reader.GetErrorCode() == 0, name, None)
    image = vtkImageData()
    image.ShallowCopy(reader.GetOutput())
    return image


def _raise(watch, good, path, place_error):
    if place_error and not good:
        raise place_error
    watch.raise_as(ValueError, os.fspath(path))
    if not good:
        raise OSError(f"{os.fspath(path)}: failed without a message")


def _place_error(path):
    """What keeps a file from being written at this place, as an OSError; None if nothing does."""
    name = os.path.abspath(os.fspath(path))
    folder = os.path.dirname(name)
    code = None
    if os.path.isdir(name):
        code = errno.EISDIR
    elif not os.path.exists(folder):
        code = errno.ENOENT
    elif not os.path.isdir(folder):
        code = errno.ENOTDIR
    elif not os.access(folder, os.W_OK | os.X_OK):
        code = errno.EACCES
    return OSError(code, os.strerror(code), os.fspath(path)) if code else None
