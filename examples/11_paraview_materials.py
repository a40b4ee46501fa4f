# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Materials in ParaView: a motorbike reflects a forest, on cobbles made of two triangles.

    pvbatch 11_paraview_materials.py [FOLDER]

Run it with ParaView's own pvbatch or pvpython. Writes to FOLDER (default: the current one)
    cobbles.png              heights of cobbles, computed here
    paraview_materials.png   the scene as ParaView draws it, and with materials

Loads the plugin from the folder RELIEVO_PLUGIN_PATH (default: build/release/plugin/Relievo beside
this folder). motorBike.obj and forest.exr are in the folder RELIEVO_DATA (default: build/data);
tools/unpack-data puts them there.
"""

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

import paraview_sheet

TEXELS, STONES = 512, 8  # of a tile: its size, and stones along a side


def write_cobbles(path):
    """Heights of round stones in rows, in 16 bits; the tile repeats without a seam."""
    chance = numpy.random.default_rng(7)
    nearest = numpy.full((2, TEXELS, TEXELS), numpy.inf)
    place = (numpy.arange(TEXELS) + 0.5) / TEXELS * STONES
    for row in range(STONES):
        for column in range(STONES):
            x, y = numpy.array((column + 0.5 * (row % 2), row)) + chance.uniform(0.3, 0.7, 2)
            far = [numpy.abs((place - at + STONES / 2) % STONES - STONES / 2) for at in (x, y)]
            squared = far[0][None, :] ** 2 + far[1][:, None] ** 2
            nearest = numpy.sort(numpy.concatenate([nearest, squared[None]]), axis=0)[:2]
    gap = numpy.sqrt(nearest[1]) - numpy.sqrt(nearest[0])  # 0 between two stones
    heights = numpy.sqrt(1 - (1 - numpy.clip(gap / 0.5, 0, 1)) ** 2) * (1 - 0.3 * nearest[0])
    image = vtkImageData()
    image.SetDimensions(TEXELS, TEXELS, 1)
    codes = numpy.round(heights / heights.max() * 65535).astype(numpy.uint16)
    image.GetPointData().SetScalars(numpy_to_vtk(codes.ravel(), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()
    print(path)


def make_view(mesh, ground):
    """The bike on the ground; returns the view and the representations."""
    view = simple.CreateView("RenderView")
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground, view.Background = 0, [0.80, 0.85, 0.92]
    bike, floor = (simple.Show(each, view) for each in (mesh, ground))
    bike.AmbientColor = bike.DiffuseColor = [0.55, 0.10, 0.08]
    floor.AmbientColor = floor.DiffuseColor = [0.50, 0.46, 0.42]
    view.CameraPosition, view.CameraFocalPoint = [3.3, -3.0, 1.6], [0.85, 0.05, 0.47]
    view.CameraViewUp, view.CameraViewAngle = [0, 0, 1], 27
    return view, bike, floor


def give_materials(view, bike, floor, cobbles, forest):
    view.RelievoEnvironment = str(forest)
    view.RelievoSkybox = 1
    view.RelievoEnvironmentRotation = 245
    view.RelievoEnvironmentIntensity = 0.8
    bike.RelievoMaterial = 1
    bike.RelievoMirror = 1
    bike.RelievoReflectivity, bike.RelievoRoughness = 0.25, 0.1
    floor.RelievoMaterial = 1
    floor.RelievoHeightMap = str(cobbles)
    floor.RelievoHeightScale = 0.06
    floor.RelievoTextureScale = [8, 8]
    floor.RelievoSelfShadow = 1
    floor.RelievoMirror = 1
    floor.RelievoRoughness = 0.7
    bike.RelievoIrradianceWeight = floor.RelievoIrradianceWeight = 0.15
    # The forest's own sun casts no shadow: a lamp in its direction does, with most of the light.
    view.RelievoShadows = 1
    view.RelievoSun = 1
    view.RelievoSunAzimuth, view.RelievoSunElevation = 241, 20
    view.RelievoSunIntensity, view.RelievoSunKitShare = 2.4, 0.0
    view.RelievoSunColor = [1.0, 0.93, 0.8]


def main():
    folder, plugin, data = paraview_sheet.words("motorBike.obj", "forest.exr")
    # Before the first view is made; in a client-server session also once with remote=True.
    simple.LoadPlugin(str(plugin), remote=False, ns=globals())
    write_cobbles(folder / "cobbles.png")
    mesh = simple.OpenDataFile(str(data / "motorBike.obj"))
    ground = simple.Plane(Origin=[-4, -4, 0], Point1=[6, -4, 0], Point2=[-4, 6, 0])
    plain, covered = make_view(mesh, ground), make_view(mesh, ground)
    give_materials(*covered, folder / "cobbles.png", data / "forest.exr")
    paraview_sheet.save(folder / "paraview_materials.png", [plain[0], covered[0]])


main()
