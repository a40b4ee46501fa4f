# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws pictures of a scene whose parts lie on the ranks: ranksScene.py FOLDER NAME

The ground is on the last rank and the casters are spread over all, so that some of them cast
from another rank than the receiving one. Writes FOLDER/STEP-NAME.png for every step, and
FOLDER/layers-NAME.npz.
"""

import sys

import layers
import numpy
import pv
from paraview import simple

FOLDER, NAME = sys.argv[1:3]

# A rank's part of the scene; run by ParaView on each of them.
PART = """
import numpy, pathlib
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
ranks, rank = controller.GetNumberOfProcesses(), controller.GetLocalProcessId()
if "WHAT" == "ground" and rank == ranks - 1:
    plane = vtkPlaneSource()
    plane.SetOrigin(-3, -3, 0)
    plane.SetPoint1(3, -3, 0)
    plane.SetPoint2(-3, 3, 0)
    plane.Update()
    self.GetOutput().ShallowCopy(plane.GetOutput())
elif "WHAT" == "bunny":
    words = pathlib.Path("DATA/bunny.off").read_text().split()
    points, faces = int(words[1]), int(words[2])
    xyz = numpy.array(words[4 : 4 + 3 * points], float).reshape(-1, 3)
    cells = numpy.array(words[4 + 3 * points : 4 + 3 * points + 4 * faces], int).reshape(-1, 4)
    low, high = xyz.min(axis=0), xyz.max(axis=0)
    # z up, 2 long, on the ground. Built-ins like max() are ParaView's own in here.
    xyz = (xyz - 0.5 * (low + high)) * (2.0 / (high - low).max())
    xyz = numpy.stack([xyz[:, 0], -xyz[:, 2], xyz[:, 1] - xyz[:, 1].min()], 1)
    xyz = numpy.ascontiguousarray(xyz)
    mine = numpy.array_split(cells, ranks)[rank]
    output = self.GetOutput()
    output.SetPoints(vtkPoints())
    output.GetPoints().SetData(numpy_to_vtk(xyz, deep=True))
    polys = vtkCellArray()
    corners = numpy.ascontiguousarray(mine[:, 1:]).ravel()
    polys.SetData(3, numpy_to_vtkIdTypeArray(corners, deep=True))
    output.SetPolys(polys)
"""

pv.load()
view = simple.CreateView("RenderView")
view.ViewSize = [300, 200]
for what in ("ground", "bunny"):
    part = simple.ProgrammableSource()
    part.OutputDataSetType = "vtkPolyData"
    part.Script = PART.replace("WHAT", what).replace("DATA", str(pv.DATA))
    shown = simple.Show(part, view)
    shown.Interpolation = "Flat"
simple.Render(view)  # whose first call in a process turns the camera
simple.Render(view)  # the first picture of a view is fitted to the scene
view.CameraPosition = [5, -7, 5]
view.CameraFocalPoint = [0, 0, 0.7]
view.CameraViewUp = [0, 0, 1]
view.CameraViewAngle = 20


def step(name):
    """The picture now."""
    pv.write(f"{FOLDER}/{name}-{NAME}.png", pv.picture(view))


step("off")
view.RelievoShadows = 1
step("kit")
view.RelievoSun = 1
step("sun")
print("report:", view.SMProxy.UpdatePropertyInformation(), view.GetProperty("RelievoFrameReport"))
view.RelievoSunAzimuth = 60
step("moved-sun")
view.CameraPosition = [2, -4, 2]
step("moved-camera")
view.RelievoShadowMethod = "Warped"
step("warped")
view.RelievoShadowMethod = "Forward"
step("forward")
view.RelievoShadowMethod = "Exact"
step("exact")
print("rays:", view.SMProxy.UpdatePropertyInformation(), view.GetProperty("RelievoFrameReport"))
view.RelievoSunAzimuth = 70
step("exact-moved")
view.RelievoSunAzimuth = 60
view.RelievoShadowMethod = "Map"
light = simple.AddLight(view=view)
light.Coords = "Scene"
light.Type = "Positional"
light.Position = [0.4, -0.9, 2.5]
light.FocalPoint = [0, 0, 0]
light.ConeAngle = 90
step("lamp")
view.RelievoDisplayLayer = "normal"
step("normal")
# Without a range, one process fits the colours to the visible values, but several do not.
view.RelievoDisplayRange = [1, 8]
view.RelievoDisplayLayer = "depth"
step("depth")
view.RelievoDisplayLayer = "None"
source = simple.RelievoLayers(View=view, Layers=["depth", "position", "actor", "cell"])
numpy.savez(f"{FOLDER}/layers-{NAME}.npz", **layers.arrays(source))
simple.Delete(source)
# Each rank has a brick of a volume. In pictures VTK's own light of bricks differs from the whole's.
cloud = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
shown = simple.Show(cloud, view, "UniformGridRepresentation")
simple.ColorBy(shown, ("POINTS", "RTData"))
shown.SetRepresentationType("Volume")
shown.Scale = [0.06] * 3
setattr(shown, pv.TRANSLATION, [0.6, -0.8, 1.7])
source = simple.RelievoLayers(View=view, Layers=["depth", "shadow_5"])
numpy.savez(f"{FOLDER}/cloud-{NAME}.npz", **layers.arrays(source))
simple.Delete(source)
simple.Delete(shown)
simple.Delete(cloud)
if NAME != "1":
    source = simple.RelievoLayers(View=view, Layers=["volume_depth"])
    source.UpdatePipeline()
    simple.Delete(source)
view.RelievoSun = 0
view.RelievoShadows = 0
simple.RemoveLight(light)
view.UseFXAA = 0  # which one process draws before the picture is darkened, and several after it
step("without-ambient")
view.RelievoStageAmbient = 1
step("ambient")
print("sky:", view.SMProxy.UpdatePropertyInformation(), view.GetProperty("RelievoFrameReport"))
view.RelievoStageAmbient = 0
view.UseFXAA = 1
view.CameraPosition = [5, -7, 5]
step("off-again")
pv.clear()  # no sys.exit() here: the other ranks would not hear of it
