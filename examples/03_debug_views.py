# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shows layers as the picture, for debugging, without reading anything back.

    03_debug_views.py [FOLDER]    writes FOLDER/view_LAYER.png
"""

import relievo
import scene
from relievo.vtk.vtkIOImage import vtkPNGWriter
from relievo.vtk.vtkRenderingCore import vtkWindowToImageFilter


def save(window, path):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    print(path)


renderer, window = scene.make()
folder = scene.folder()
frame = relievo.attach(renderer)  # around the renderer's pass
for layer in ("depth", "normal", "geometric_normal", "albedo", "actor", "cell", "Elevation"):
    frame.SetDisplayLayer(layer)
    save(window, folder / f"view_{layer}.png")

# Scalars are shown by a colour map with adjustable ends.
frame.SetDisplayLayer("depth")
frame.SetDisplayRange(4, 9)
save(window, folder / "view_depth_4_to_9.png")

# Depth in grey as a separate pass, for a renderer that shows nothing else.
relievo.detach(renderer)
linear = relievo.vtkRelievoLinearDepthPass()
linear.NormalizedOff()
linear.SetRange(4, 9)
renderer.SetPass(linear)
save(window, folder / "view_linear_depth.png")
