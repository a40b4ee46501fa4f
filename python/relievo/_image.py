# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A captured image as numpy arrays."""

from vtkmodules.util.numpy_support import vtk_to_numpy

from ._errors import require


def layer_names(image):
    """Returns the names of the image's layers, a list in the order of capture."""
    require(image, "vtkImageData", "image")
    data = image.GetPointData()
    return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]


def layer(image, name):
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
    columns, rows, _ = image.GetDimensions()
    components = array.GetNumberOfComponents()
    shape = (rows, columns) if components == 1 else (rows, columns, components)
    return vtk_to_numpy(array).reshape(shape)[::-1]


def attributes(image):
    """Returns the image's field data, with its camera and lights, as a dict.

    worldToCamera, worldToNDC: arrays of shape (4, 4), for column vectors: clip = worldToNDC @ p.
    near, far: floats, world units. relievo:origin: array of 3. lights: list of JSON texts.
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
            elif values.size == 1:
                values = values.reshape(()).item()
            elif 1 in values.shape:
                values = values.reshape(-1)
            found[array.GetName()] = values
    return found
