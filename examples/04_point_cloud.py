# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts a depth image to points in world space, in double, with the other layers as data.

    04_point_cloud.py [FOLDER]    writes FOLDER/points.vtp
"""

import relievo
import scene
from relievo.vtk.vtkIOXML import vtkXMLPolyDataWriter

renderer, window = scene.make()
image = relievo.capture(renderer, ["depth", "normal", "albedo", "actor"])
cloud = relievo.depth_to_points(image)
path = scene.folder() / "points.vtp"
writer = vtkXMLPolyDataWriter()
writer.SetDataModeToBinary()  # with newer expat, VTK 9.2 cannot read appended data
writer.SetFileName(str(path))
writer.SetInputData(cloud)
writer.Write()
print(f"{path}: {cloud.GetNumberOfPoints()} points within {cloud.GetBounds()}")
