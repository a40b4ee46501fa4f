# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A tour of the ParaView plugin: a town and a motorbike, without and with the plugin.

    pvbatch 08_paraview_tour.py [FOLDER]

Run it with ParaView's own pvbatch or pvpython. Writes to FOLDER (default: the current one)
    paraview_town.png    a town as ParaView draws it, and with shadows of the sun at 9:30
    paraview_day.png     the town at 8, 12 and 16 o'clock (UTC; 48 degrees north, 0 east, 20 March)
    paraview_bike.png    a motorbike coloured by height, in a sun and a spot, and the layer `normal`

Loads the plugin from the folder RELIEVO_PLUGIN_PATH (default: build/release/plugin/Relievo beside
this folder). The meshes are in the folder RELIEVO_DATA (default: build/data); tools/unpack-data
puts them there.
"""

from paraview import simple

import paraview_sheet


def make_view():
    view = simple.CreateView("RenderView")
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.80, 0.85, 0.92]
    return view


def write(view, words):
    """Writes a text in the picture's upper left corner."""
    shown = simple.Show(simple.Text(Text=words), view)
    shown.Color, shown.FontSize, shown.WindowLocation = [0.1, 0.1, 0.1], 16, "Upper Left Corner"


def let_the_sun_shine(view, hour):
    """Shadows, and the sun of that hour: only the first five lines are needed."""
    view.RelievoShadows = 1
    view.RelievoSun = 1
    view.RelievoSunBy = "Date and place"
    view.RelievoSunDate, view.RelievoSunTime = [2026, 3, 20], hour
    view.RelievoSunLatitude, view.RelievoSunLongitude = 48.0, 0.0
    view.RelievoShadowMapSize = 4096  # a low sun stretches a map's texels along the walls
    view.RelievoSunIntensity = 0.9
    view.RelievoSunColor = [1.0, 0.95, 0.85]
    view.UpdatePropertyInformation()
    angles = view.GetProperty("RelievoSunAngles")
    return f"azimuth {angles.GetElement(0):.0f}, elevation {angles.GetElement(1):.0f}"


def show_town(view, town, ground, said):
    shown = simple.Show(town, view)
    shown.AmbientColor = shown.DiffuseColor = [0.95, 0.92, 0.87]
    write(view, said)
    shown = simple.Show(ground, view)
    shown.AmbientColor = shown.DiffuseColor = [0.70, 0.72, 0.66]
    view.CameraPosition, view.CameraFocalPoint = [205, -190, 205], [122, 92, 16]
    view.CameraViewUp, view.CameraViewAngle = [0, 0, 1], 26


def town(folder, data):
    buildings = simple.OpenDataFile(str(data / "buildings.obj"))
    ground = simple.Plane(Origin=[-900, -900, 0], Point1=[1200, -900, 0], Point2=[-900, 1200, 0])
    views = [make_view(), make_view()]
    for view, said in zip(views, ("ParaView", "with shadows of the sun at 9:30")):
        show_town(view, buildings, ground, said)
    print(f"9:30, {let_the_sun_shine(views[1], 9.5)}")
    paraview_sheet.save(folder / "paraview_town.png", views)
    views = [make_view() for _ in range(3)]
    for view, hour in zip(views, (8, 12, 16)):
        show_town(view, buildings, ground, f"{hour}:00")
        view.CameraViewAngle = 30
        print(f"{hour}:00, {let_the_sun_shine(view, hour)}")
    paraview_sheet.save(folder / "paraview_day.png", views, high=400)


def bike(folder, data):
    mesh = simple.OpenDataFile(str(data / "motorBike.obj"))
    height = simple.Elevation(Input=mesh)
    height.LowPoint, height.HighPoint, height.ScalarRange = [0, 0, 0], [0, 0, 1.35], [0, 1.35]
    ground = simple.Plane(Origin=[-60, -60, 0], Point1=[60, -60, 0], Point2=[-60, 60, 0])
    views = [make_view(), make_view()]
    for view in views:
        shown = simple.Show(height, view)
        simple.ColorBy(shown, ("POINTS", "Elevation"))
        floor = simple.Show(ground, view)
        floor.AmbientColor = floor.DiffuseColor = [0.85, 0.85, 0.85]
        view.CameraPosition, view.CameraFocalPoint = [3.2, -3.4, 2.0], [0.72, 0.0, 0.5]
        view.CameraViewUp, view.CameraViewAngle = [0, 0, 1], 24
    shadows, layer = views
    write(shadows, "a sun, a spot and a colour map")
    write(layer, "the layer normal")
    shadows.RelievoShadows = 1
    shadows.RelievoSun = 1
    shadows.RelievoSunAzimuth, shadows.RelievoSunElevation = 215, 42
    shadows.RelievoSunIntensity = 0.6
    spot = simple.AddLight(shadows)
    spot.Coords, spot.Type = "Scene", "Positional"
    spot.Position, spot.FocalPoint, spot.ConeAngle = [3.6, 1.2, 3.0], [0.7, 0.0, 0.4], 75
    spot.Intensity = 0.4
    colours = simple.GetColorTransferFunction("Elevation")
    newer = simple.GetParaViewVersion() >= (6, 1)
    colours.ApplyPreset("Viridis" if newer else "Viridis (matplotlib)", True)
    bar = simple.GetScalarBar(colours, shadows)
    bar.Title, bar.ComponentTitle = "height (m)", ""
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    bar.RangeLabelFormat = "{:.1f}" if newer else "%.1f"
    bar.WindowLocation = "Upper Right Corner"
    simple.GetDisplayProperties(height, shadows).SetScalarBarVisibility(shadows, True)
    layer.RelievoDisplayLayer = "normal"
    paraview_sheet.save(folder / "paraview_bike.png", views)


def main():
    folder, plugin, data = paraview_sheet.words("buildings.obj", "motorBike.obj")
    # Before the first view is made; in a client-server session also once with remote=True.
    simple.LoadPlugin(str(plugin), remote=False, ns=globals())
    town(folder, data)
    bike(folder, data)


main()
