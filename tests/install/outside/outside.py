# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""outside.py FILE.exr PREFIX: captures with the relievo installed in PREFIX and reads it back."""

import sys

import relievo
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

sphere = vtkSphereSource()  # radius 0.5, with a vertex at (0, 0, 0.5)
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(sphere.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.GetActiveCamera().SetPosition(0, 0, 3)
renderer.ResetCameraClippingRange()

image = relievo.capture(renderer, layers=["depth", "normal"], size=(101, 101))
relievo.write_exr(sys.argv[1], image)
again = relievo.read_exr(sys.argv[1])
depth = relievo.layer(image, "depth")
assert depth.shape == (101, 101), depth.shape
assert abs(depth[50, 50] - 2.5) < 1e-5, depth[50, 50]
assert (depth == relievo.layer(again, "depth")).all()
assert relievo.vtkRelievoPass().GetNumberOfStages() >= 1

# The libraries that were loaded are those of the prefix, not those of the build.
with open("/proc/self/maps", encoding="utf-8") as maps:
    loaded = {line.split()[-1] for line in maps if "vtkRelievo" in line}
strangers = [path for path in loaded if not path.startswith(sys.argv[2] + "/")]
assert loaded and not strangers, strangers
print(f"depth {depth[50, 50]}, {len(loaded)} libraries from the prefix")
