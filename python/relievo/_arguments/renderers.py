# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts arguments to a renderer: a renderer, a plotter, data, a filter."""

import numpy

from ..vtk.util.numpy_support import numpy_to_vtkIdTypeArray
from ..vtk.vtkCommonDataModel import vtkPolyData
from ..vtk.vtkFiltersCore import vtkReverseSense
from ..vtk.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkGeometryFilter
from ..vtk.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
from ..vtkRelievoFilters import vtkRelievoConvexPolygons
from .data import EXPECTED, cloud_of, data_of
from .errors import describe, is_a


def inner_renderer(thing):
    """The object if it is a renderer, its attribute `renderer` if that is one, or None."""
    inner = thing if is_a(thing, "vtkRenderer") else getattr(thing, "renderer", None)
    return inner if is_a(inner, "vtkRenderer") else None


def need_renderer(thing):
    """inner_renderer(), or ValueError."""
    inner = inner_renderer(thing)
    if inner is None:
        raise ValueError(
            f"renderer: got {describe(thing)}, expected a vtkRenderer or something with a "
            f".renderer"
        )
    return inner


def renderer_of(thing):
    """The renderer, and whether it was made here to show data.

    Data is drawn by its outer surface and seen along -z with y up; polygons and actors as they are.
    The caller must reset the camera when the size of the picture is known.
    """
    inner = inner_renderer(thing)
    if inner is not None:
        _place_camera(inner)
        return inner, False
    prop = prop_of(thing)
    if prop is None:
        cloud = cloud_of(thing)
        data = data_of(thing) if cloud is None else cloud
        if data is None:
            raise ValueError(
                f"renderer: got {describe(thing)}, expected a vtkRenderer, something with a "
                f".renderer, an actor, points (n x 3), {EXPECTED}"
            )
        prop = _actor(data)
    renderer = vtkRenderer()
    renderer.AddViewProp(prop)
    return renderer, True


def prop_of(thing):
    """The actor that an object is or has (as vedo's do), or None."""
    for each in (thing, getattr(thing, "actor", None)):
        if is_a(each, "vtkProp3D"):
            return each
    return None


def _actor(data):
    if is_a(data, "vtkPolyData"):
        surface = data
    elif is_a(data, "vtkCompositeDataSet"):
        surface = _run(vtkCompositeDataGeometryFilter(), data)
    else:
        surface = outwards(_run(vtkGeometryFilter(), _numbered(data)), data)
    if surface.GetNumberOfCells() == 0:
        raise ValueError("renderer: the data has no cells to draw")
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(_run(vtkRelievoConvexPolygons(), surface))
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def outwards(surface, data):
    """The surface of the data; faces that VTK turns inwards for left-handed images are reversed."""
    left_handed = (is_a(data, "vtkImageData") and data.GetDataDimension() == 3
                   and data.GetDirectionMatrix().Determinant() < 0)
    return _run(vtkReverseSense(), surface) if left_handed else surface


def _place_camera(renderer):
    """Places the camera of a PyVista plotter, which would happen only when it is first shown."""
    if getattr(renderer, "camera_set", True) is False and hasattr(renderer, "get_default_cam_pos"):
        renderer.camera_position = renderer.get_default_cam_pos()
        renderer.ResetCamera()


def _numbered(grid):
    """A copy with cell numbers: the filter's own are those of a copy without nonlinear cells."""
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
