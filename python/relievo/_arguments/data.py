# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts arguments to data: datasets, filters, objects with a dataset, points of numpy."""

import difflib

import numpy

from ..vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from ..vtk.vtkCommonCore import vtkPoints
from ..vtk.vtkCommonDataModel import vtkCellArray, vtkPolyData
from .errors import describe, is_a

EXPECTED = "a dataset, a filter that makes one, or something with a .dataset"


def data_of(thing):
    """The dataset, also composite, that an object is, makes or holds (as vedo's do); or None."""
    if is_a(thing, "vtkAlgorithm"):
        thing.Update()
        thing = thing.GetOutputDataObject(0) if thing.GetNumberOfOutputPorts() else None
    for each in (thing, getattr(thing, "dataset", None)):
        if is_a(each, "vtkDataSet") or is_a(each, "vtkCompositeDataSet"):
            return each
    return None


def need_data(thing, argument):
    """data_of(), or ValueError."""
    data = data_of(thing)
    if data is None:
        raise ValueError(f"{argument}: got {describe(thing)}, expected {EXPECTED}")
    return data


def cloud_of(values):
    """Points of numpy, n x 3, or a list of triples, as vertices of a vtkPolyData; None for anything
    else."""
    if not isinstance(values, (list, tuple, numpy.ndarray)):
        return None
    if numpy.ma.is_masked(values):
        return None  # masked values are no points
    try:
        places = numpy.array(values)
    except ValueError:  # rows of different lengths
        return None
    if places.dtype.kind not in "fiu" or places.ndim != 2 or places.shape[1] != 3:
        return None
    kind = numpy.float32 if places.dtype == numpy.float32 else numpy.float64
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places.astype(kind), deep=True))
    vertices = vtkCellArray()
    vertices.SetData(1, numpy_to_vtkIdTypeArray(numpy.arange(len(places), dtype=numpy.int64),
                                                deep=True))
    cloud = vtkPolyData()
    cloud.SetPoints(points)
    cloud.SetVerts(vertices)
    return cloud


def did_you_mean(name, known):
    """A text that suggests the most similar known name, or ""."""
    near = difflib.get_close_matches(name, known, 1) if isinstance(name, str) else []
    return f" (did you mean {near[0]!r}?)" if near else ""
