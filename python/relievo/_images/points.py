# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts depth images to points."""

from .._arguments.errors import Watch, require
from ..vtk.vtkCommonDataModel import vtkPolyData
from ..vtkRelievoFilters import vtkRelievoDepthToPoints


def depth_to_points(image) -> vtkPolyData:
    """Returns the surface points of a captured depth layer, as a point cloud.

    image: vtkImageData with the layer `depth` and the camera's matrices in its field data, as
    returned by capture() and read_exr(). Background pixels give no points.

    Returns vtkPolyData with points in double, in world space, one vertex cell each; the image's
    layers are its point data.

    Raises ValueError if the layer or a matrix is missing, or the image is empty.
    """
    require(image, "vtkImageData", "image")
    if image.GetNumberOfPoints() == 0:
        # The filter accepts it, because some of several processes have no part of an image.
        raise ValueError(
            "depth_to_points: the image is empty; expected the layer 'depth' and the camera's "
            "matrices, as capture() and read_exr() give them"
        )
    reader = vtkRelievoDepthToPoints()
    reader.SetInputData(image)
    with Watch(reader) as watch:
        reader.Update()
    watch.raise_as(ValueError, "depth_to_points")
    return reader.GetOutput()
