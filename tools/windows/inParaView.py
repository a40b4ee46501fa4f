# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sets up ParaView's window for the screenshots, by the function that the environment variable
PICTURE names; tools/screenshots runs ParaView with it. When done, writes the file `ready` into the
folder MADE."""

import os
import pathlib
import traceback

from paraview import simple

MADE, DATA = pathlib.Path(os.environ["MADE"]), pathlib.Path(os.environ["DATA"])


def look(view, direction, up, zoom=1.0):
    """Shows the whole scene from this direction."""
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraPosition = direction
    view.CameraViewUp = up
    simple.ResetCamera(view)
    view.GetActiveCamera().Dolly(zoom)
    view.CameraPosition = view.GetActiveCamera().GetPosition()


def ground(view, bounds, up, reach):
    """The plane that the dock's button makes."""
    lower, upper = bounds[0::2], bounds[1::2]
    first, second = (up + 1) % 3, (up + 2) % 3
    origin = [0.5 * (low + high) for low, high in zip(lower, upper)]
    origin[up] = lower[up]
    origin[first] -= reach
    origin[second] -= reach
    ends = [list(origin), list(origin)]
    ends[0][first] += 2 * reach
    ends[1][second] += 2 * reach
    plane = simple.Plane(registrationName="Ground", Origin=origin, Point1=ends[0], Point2=ends[1])
    shown = simple.Show(plane, view)
    shown.DiffuseColor = shown.AmbientColor = [0.8, 0.8, 0.8]


def sun(view, up, azimuth, elevation):
    view.RelievoSun, view.RelievoShadows = 1, 1
    view.RelievoSunUpAxis = up
    view.RelievoSunAzimuth, view.RelievoSunElevation = azimuth, elevation
    view.RelievoShadowSoftSamples, view.RelievoShadowSunAngle = 16, 3


def backdrop(view, dark):
    view.UseColorPaletteForBackground = 0
    view.Background = [0.16, 0.18, 0.21] if dark else [0.87, 0.89, 0.92]
    view.OrientationAxesVisibility = 0


def surface(view):
    """A surface coloured by its height, on a ground, in the sun."""
    backdrop(view, dark=True)
    bunny = simple.XMLPolyDataReader(registrationName="bunny", FileName=[str(MADE / "bunny.vtp")])
    shown = simple.Show(bunny, view)
    simple.ColorBy(shown, ("POINTS", "height"))
    shown.SetScalarBarVisibility(view, True)
    bounds = bunny.GetDataInformation().GetBounds()
    look(view, [0.5, 0.45, 1.0], [0.0, 1.0, 0.0], 0.95)
    ground(view, bounds, 1, 2.0 * (bounds[1] - bounds[0]))
    simple.SetActiveSource(bunny)
    sun(view, "Y", 140, 40)


def model(view):
    """A model that reflects an environment, in the sun by date and place."""
    backdrop(view, dark=False)
    bike = simple.WavefrontOBJReader(registrationName="motorBike",
                                     FileName=str(DATA / "motorBike.obj"))
    shown = simple.Show(bike, view)
    shown.DiffuseColor = shown.AmbientColor = [0.75, 0.2, 0.15]
    shown.RelievoMaterial, shown.RelievoMirror = 1, 1
    shown.RelievoReflectivity, shown.RelievoRoughness = 0.3, 0.2
    view.RelievoEnvironment = str(DATA / "studio.exr")
    bounds = bike.GetDataInformation().GetBounds()
    look(view, [-0.7, -1.0, 0.55], [0.0, 0.0, 1.0], 1.15)
    ground(view, bounds, 2, 2.5 * (bounds[1] - bounds[0]))
    simple.SetActiveSource(bike)
    sun(view, "Z", 200, 45)
    view.RelievoSunBy = "Date and place"
    view.RelievoSunDate, view.RelievoSunTime = [2026, 6, 21], 10.5


def labels(view):
    """A label volume as smooth surfaces."""
    backdrop(view, dark=False)
    atlas = simple.XMLImageDataReader(registrationName="labels",
                                      FileName=[str(MADE / "labels.vti")])
    smooth = simple.SmoothBlocks(registrationName="SmoothBlocks1", Input=atlas,
                                 Labels=["POINTS", "label"])
    shown = simple.Show(smooth, view)
    simple.ColorBy(shown, ("CELLS", "material"))
    colors = simple.GetColorTransferFunction("material")
    colors.ApplyPreset("Rainbow Uniform", True)
    bounds = smooth.GetDataInformation().GetBounds()
    look(view, [1.0, -0.8, 0.5], [0.0, 0.0, 1.0], 1.2)
    ground(view, bounds, 2, 1.5 * (bounds[3] - bounds[2]))
    simple.SetActiveSource(smooth)
    sun(view, "Z", 120, 45)


def layer(view):
    """A layer as the picture, its colour legend, and the values under the mouse."""
    backdrop(view, dark=True)
    town = simple.WavefrontOBJReader(registrationName="buildings",
                                     FileName=str(DATA / "buildings.obj"))
    simple.Show(town, view)
    bounds = town.GetDataInformation().GetBounds()
    look(view, [-0.6, -1.0, 0.8], [0.0, 0.0, 1.0], 1.3)
    ground(view, bounds, 2, bounds[1] - bounds[0])
    simple.SetActiveSource(town)
    view.RelievoDisplayLayer = "depth"


def run():
    view = simple.GetActiveViewOrCreate("RenderView")
    globals()[os.environ["PICTURE"]](view)
    simple.Render(view)
    (MADE / "ready").touch()


try:
    run()
except Exception:  # pylint: disable=broad-except
    print(traceback.format_exc(), flush=True)
    os._exit(1)
