# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""plugin.py FILE.png: a sphere's shadow in ParaView, by a plugin that is loaded automatically."""

import sys

from paraview import numpy_support, simple

view = simple.CreateView("RenderView")
assert "RelievoShadows" in view.ListProperties(), "the plugin was not found"
simple.LoadDistributedPlugin("Relievo", ns=globals())  # harmless, as scripts have it
view.ViewSize = [200, 150]
simple.Show(simple.Plane(Origin=[-2, -2, 0], Point1=[2, -2, 0], Point2=[-2, 2, 0]), view)
simple.Show(simple.Sphere(Center=[0, 0, 0.7]), view)
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [5, -7, 6], [0, 0, 0.4], [0, 0, 1]
simple.Render(view)


def picture():
    """The view's colours."""
    simple.SaveScreenshot(sys.argv[1], view)
    view.CameraPosition, view.CameraFocalPoint = [5, -7, 6], [0, 0, 0.4]
    image = view.CaptureWindow(1)
    return numpy_support.vtk_to_numpy(image.GetPointData().GetScalars()).astype(int)


view.RelievoSun, view.RelievoSunAzimuth, view.RelievoSunElevation = 1, 240, 30
lit = picture()
view.RelievoShadows = 1
shadow = (picture() != lit).any(axis=1).mean()
print(f"the shadow covers {100 * shadow:.1f} % of the picture")
assert 0.01 < shadow < 0.5, shadow
