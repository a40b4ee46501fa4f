# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""What people have in hand, as a renderer: a renderer, a plotter, data, a filter."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkGeometryFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from ._errors import describe, is_a

_EXPECTED = "a vtkRenderer, something with a .renderer, a dataset, or a filter that makes one"


def inner_renderer(thing):
    """The thing itself if it is a renderer, or its attribute `renderer` if that is one, or None."""
    inner = thing if is_a(thing, "vtkRenderer") else getattr(thing, "renderer", None)
    return inner if is_a(inner, "vtkRenderer") else None


def renderer_of(thing):
    """The renderer, and whether it was made here, for data.

    Data is drawn by its outer surface and seen along -z with y up; polygons as they are. The camera
    is to be fitted when the size of the picture is known.
    """
    inner = inner_renderer(thing)
    if inner is not None:
        _place_camera(inner)
        return inner, False
    if is_a(thing, "vtkAlgorithm"):
        thing.Update()
        thing = thing.GetOutputDataObject(0) if thing.GetNumberOfOutputPorts() else None
    if is_a(thing, "vtkPolyData"):
        surface = thing
    elif is_a(thing, "vtkCompositeDataSet"):
        surface = _run(vtkCompositeDataGeometryFilter(), thing)
    elif is_a(thing, "vtkDataSet"):
        surface = _run(vtkGeometryFilter(), _numbered(thing))
    else:
        renderer = getattr(thing, "renderer", None)
        given = describe(renderer if hasattr(renderer, "IsA") else thing)
        raise ValueError(f"renderer: got {given}, expected {_EXPECTED}")
    if surface.GetNumberOfCells() == 0:
        raise ValueError("renderer: the data has no cells to draw")
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    return renderer, True


def _place_camera(renderer):
    """PyVista's plotters place their cameras when they are first shown: so it is done before."""
    if getattr(renderer, "camera_set", True) is False and hasattr(renderer, "get_default_cam_pos"):
        renderer.camera_position = renderer.get_default_cam_pos()
        renderer.ResetCamera()


def _numbered(grid):
    """With a number for each cell: the filter counts those of a copy without nonlinear cells."""
    ids = numpy_to_vtkIdTypeArray(numpy.arange(grid.GetNumberOfCells()), deep=True)
    ids.SetName("vtkOriginalCellIds")
    copy = grid.NewInstance()
    copy.ShallowCopy(grid)
    copy.GetCellData().AddArray(ids)
    return copy


def _run(algorithm, data):
    algorithm.SetInputDataObject(data)
    algorithm.Update()
    surface = vtkPolyData()
    surface.ShallowCopy(algorithm.GetOutputDataObject(0))
    return surface
