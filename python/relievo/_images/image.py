# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images as numpy arrays, and back: numpy's rows run downwards, VTK's upwards."""

import numpy

from .._arguments.errors import require
from ..vtk.util.numpy_support import create_vtk_array, get_vtk_array_type, vtk_to_numpy
from ..vtk.vtkCommonDataModel import vtkImageData


def layer_names(image) -> list:
    """Returns the names of the image's layers, in the order of capture."""
    require(image, "vtkImageData", "image")
    data = image.GetPointData()
    return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]


def layer(image, name) -> numpy.ndarray:
    """Returns one layer of a captured image as a numpy array.

    image: vtkImageData from capture() or read_exr().
    name: the layer's name; layer_names(image) lists them.

    Returns an array of shape (rows, columns), or (rows, columns, components) if there is more
    than one component, with the layer's own type. ROW 0 IS THE TOP of the picture, as in numpy,
    matplotlib and OpenEXR; VTK's row 0 is the bottom. The array is a view, not a copy: writing to
    it changes the image, and it keeps the memory alive after the image is deleted.

    Raises ValueError for a name that the image does not have.
    """
    require(image, "vtkImageData", "image")
    array = image.GetPointData().GetArray(name)
    if array is None:
        known = ", ".join(layer_names(image)) or "none"
        raise ValueError(f"layer {name!r}: the image holds {known}")
    return _rows_of(image, array)


def from_image(image) -> numpy.ndarray:
    """Returns the scalars of any image of VTK as a numpy array, ROW 0 AT THE TOP.

    image: vtkImageData of (columns, rows, 1) points, of a reader (vtkPNGReader), a
    vtkWindowToImageFilter, a vtkTexture, or to_image(). Point data only.

    Returns an array as layer() does, a view. For layers by name, use layer().

    Raises ValueError for an image of more than one slice or without scalars.
    """
    require(image, "vtkImageData", "image")
    array = image.GetPointData().GetScalars()
    if array is None:
        raise ValueError("from_image: the image has no scalars; layer(image, name) takes a name")
    return _rows_of(image, array)


def to_image(values, name="scalars") -> vtkImageData:
    """Returns a numpy array as an image of VTK, with the array's first row at the top.

        texture.SetInputData(relievo.to_image(picture))
        material.SetHeightMap(relievo.to_image(heights))
        relievo.write_exr("maps.exr", relievo.to_image({"depth": depth, "normal": normal}))

    values: array of (rows, columns) or (rows, columns, components), ROW 0 AT THE TOP, as numpy,
    matplotlib, Pillow and OpenEXR have them; bool becomes uint8 and float16 float32, masked floats
    NaN. Or a dict of such arrays by their names, all of the same rows and columns; the first one is
    the scalars.
    name: of the array, if it is one.

    Returns vtkImageData of (columns, rows, 1) points with copies of the arrays, VTK's row 0 at the
    BOTTOM, as all classes of VTK expect. from_image() and layer() convert it back. A vtkTexture
    takes uint8 as colours and maps other numbers through its table of colours.

    Raises ValueError for other shapes, types that VTK does not have (such as complex), masked
    integers, and no rows.
    """
    arrays = values if isinstance(values, dict) else {name: values}
    if not arrays:
        raise ValueError("to_image: got no arrays")
    image = vtkImageData()
    first = None
    for each, given in arrays.items():
        array = _unmasked(each, given)
        if not isinstance(each, str) or not each:
            raise ValueError(f"to_image: got the name {each!r}, expected a text")
        if array.ndim not in (2, 3) or array.size == 0:
            raise ValueError(f"to_image: {each}: got shape {array.shape}, expected (rows, columns) "
                             f"or (rows, columns, components)")
        if first is None:
            first = array.shape[:2]
            image.SetDimensions(first[1], first[0], 1)
        elif array.shape[:2] != first:
            raise ValueError(f"to_image: {each}: got shape {array.shape}, expected {first} as of "
                             f"the first array")
        made = _copied(each, array)
        made.SetName(each)
        image.GetPointData().AddArray(made)
    image.GetPointData().SetActiveScalars(next(iter(arrays)))
    return image


def _unmasked(name, given):
    if not numpy.ma.is_masked(given):
        return numpy.asarray(given)
    if given.dtype.kind != "f":
        raise ValueError(f"to_image: {name}: got masked values of type {given.dtype}, for which "
                         f"there is no value; give it filled(...)")
    return given.filled(numpy.nan)


def _copied(name, array):
    """An array of VTK with its tuples from the lower left, row by row."""
    kept = {"bool": numpy.uint8, "float16": numpy.float32}.get(array.dtype.name, array.dtype)
    try:
        if array.dtype.kind not in "biuf":
            raise TypeError
        made = create_vtk_array(get_vtk_array_type(numpy.dtype(kept).newbyteorder("=")))
    except TypeError:
        raise ValueError(f"to_image: {name}: got values of type {array.dtype}, expected whole "
                         f"numbers, floats or bool") from None
    rows = array[::-1] if array.ndim == 3 else array[::-1, :, None]
    made.SetNumberOfComponents(rows.shape[2])
    made.SetNumberOfTuples(rows.shape[0] * rows.shape[1])
    vtk_to_numpy(made).reshape(rows.shape)[...] = rows
    return made


def _rows_of(image, array):
    columns, rows, slices = image.GetDimensions()
    if slices != 1 or array.GetNumberOfTuples() != rows * columns:
        raise ValueError(f"image: got {columns} x {rows} x {slices} points, expected one slice of "
                         f"(columns, rows, 1)")
    components = array.GetNumberOfComponents()
    shape = (rows, columns) if components == 1 else (rows, columns, components)
    return vtk_to_numpy(array).reshape(shape)[::-1]


def attributes(image) -> dict:
    """Returns the image's field data, with its camera and lights, as a dict.

    worldToCamera, worldToNDC: arrays of shape (4, 4), for column vectors: clip = worldToNDC @ p.
    K, R: arrays of (3, 3), t: array of 3: the camera's calibration, see camera(); not for parallel
    projections. near, far: floats, world units. relievo:origin: array of 3. lights: list of JSON
    texts.
    Other field data: arrays of shape (values,) or (tuples, components), texts as lists.
    """
    require(image, "vtkImageData", "image")
    found = {}
    data = image.GetFieldData()
    for i in range(data.GetNumberOfArrays()):
        array = data.GetAbstractArray(i)
        if array.IsA("vtkStringArray"):
            found[array.GetName()] = [array.GetValue(k) for k in range(array.GetNumberOfValues())]
        elif array.IsA("vtkDataArray"):
            values = vtk_to_numpy(array).copy()
            if array.GetName() in ("worldToCamera", "worldToNDC"):
                values = values.reshape(4, 4)
            elif array.GetName() in ("K", "R") and values.size == 9:
                values = values.reshape(3, 3)
            elif values.size == 1:
                values = values.reshape(()).item()
            elif 1 in values.shape:
                values = values.reshape(-1)
            found[array.GetName()] = values
    return found
