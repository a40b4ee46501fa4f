# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A sun study: the shadows of a town over a day, and the hours of sun at every point.

    06_sun_study.py [FOLDER] [--latitude DEG] [--date YYYY-MM-DD] [--every MINUTES]

Default: out/sun-study, latitude 48, a spring equinox, every 20 minutes. Writes to FOLDER
    frame_NN.png     the town in the sun, from sunrise to sunset, for a film
    sun_hours.png    hours of sun as colours: the ground from above, and roofs and walls as well

The buildings (of OpenFOAM's example windAroundBuildings) are in metres, z up; y counts as north.
Needs buildings.obj in the folder RELIEVO_DATA (default: build/data beside this folder);
tools/unpack-data puts it there.
"""

import argparse
import datetime
import math
import pathlib

import numpy
import relievo
from relievo.vtk.vtkFiltersSources import vtkPlaneSource
from relievo.vtk.vtkIOGeometry import vtkOBJReader
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

import demo_sheet
import scene
import sun

SIZE = (960, 540)


def words():
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("folder", nargs="?", default="out/sun-study", type=pathlib.Path)
    parser.add_argument("--latitude", type=float, default=48.0, help="degrees, north positive")
    parser.add_argument(
        "--date", type=datetime.date.fromisoformat, default=datetime.date(2026, 3, 20)
    )
    parser.add_argument("--every", type=float, default=20.0, help="minutes between two frames")
    given = parser.parse_args()
    if not -90 <= given.latitude <= 90:
        parser.error(f"--latitude: got {given.latitude}, expected -90 to 90")
    if not 1 <= given.every <= 240:
        parser.error(f"--every: got {given.every}, expected 1 to 240 minutes")
    return given


def make_actor(source, colour):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetColor(*colour)
    look.SetAmbient(0.22)
    look.SetAmbientColor(0.62, 0.74, 0.95)  # skylight on shaded walls
    return actor


def make_light(renderer, intensity, colour):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetIntensity(intensity)
    light.SetColor(*colour)
    renderer.AddLight(light)
    return light


def make_town():
    """A renderer in a window, and its lights: the sun, light 0, and the sky."""
    buildings = vtkOBJReader()
    buildings.SetFileName(scene.data("buildings.obj"))
    buildings.Update()
    x0, x1, y0, y1, _, _ = buildings.GetOutput().GetBounds()
    ground = vtkPlaneSource()
    ground.SetOrigin(x0 - 900, y0 - 900, 0)
    ground.SetPoint1(x1 + 900, y0 - 900, 0)
    ground.SetPoint2(x0 - 900, y1 + 900, 0)
    renderer = vtkRenderer()
    renderer.AddActor(make_actor(ground, (0.62, 0.64, 0.58)))
    renderer.AddActor(make_actor(buildings, (0.95, 0.92, 0.87)))
    renderer.AutomaticLightCreationOff()
    renderer.UseFXAAOn()
    lights = make_light(renderer, 1.0, (1, 1, 1)), make_light(renderer, 0.22, (0.75, 0.85, 1.0))
    lights[1].SetPosition(0.3, -0.5, 1)  # the sky: from above, brighter in the south
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    return renderer, window, lights


def look_from_the_south(camera):
    camera.SetParallelProjection(False)
    camera.SetPosition(205, -190, 205)
    camera.SetFocalPoint(122, 92, 16)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(26)
    camera.SetClippingRange(50, 3000)


def look_from_above(camera):
    """North is up; the picture is 170 m high."""
    camera.SetParallelProjection(True)
    camera.SetParallelScale(85)
    camera.SetPosition(120, 92, 300)
    camera.SetFocalPoint(120, 92, 0)
    camera.SetViewUp(0, 1, 0)
    camera.SetClippingRange(100, 320)


def shine(light, towards):
    """Moves the sun; low suns are weaker and redder."""
    light.SetPosition(*towards)
    height = max(0.0, towards[2])
    weak = min(1.0, height / 0.25)
    light.SetIntensity(0.7 + 0.1 * weak)
    light.SetColor(1.0, 0.70 + 0.26 * weak, 0.42 + 0.46 * weak)


def in_colours(hours, longest):
    """Hours as colours: 0 dark, the day's length bright; NaN grey."""
    known = ~numpy.isnan(hours)
    share = numpy.where(known, hours, 0) / longest
    return demo_sheet.where(known, demo_sheet.bytes_of(demo_sheet.mapped(share)))


def with_scale(hours, longest):
    """The hours as colours, with a legend along the lower edge."""
    picture = in_colours(hours, longest)
    left, wide, top = 20, 300, picture.shape[0] - 46
    picture[top - 12 :, : left + wide + 20] = demo_sheet.PAPER
    bar = numpy.linspace(0, longest, wide)[None, :].repeat(14, axis=0)
    picture[top : top + 14, left : left + wide] = in_colours(bar, longest)
    for hour in range(0, int(longest) + 1, 2):
        at = left + round(hour / longest * (wide - 1))
        picture[top + 14 : top + 18, at] = 200
        demo_sheet.write(picture, f"{hour} h" if hour == 0 else str(hour), at - 3, top + 20, 13)
    return picture


def write_frame(path, colour, caption):
    picture, _ = demo_sheet.picture_of("color", colour)
    picture[:38] = demo_sheet.PAPER
    demo_sheet.write(picture, caption, 16, 11, 16)
    demo_sheet.write_png(path, picture)


def main():
    given = words()
    length = sun.day_length(given.latitude, given.date)
    if length == 0:
        raise SystemExit(f"no sunrise at latitude {given.latitude:g} on {given.date}")
    given.folder.mkdir(parents=True, exist_ok=True)
    renderer, _window, (lamp, sky) = make_town()
    camera = renderer.GetActiveCamera()

    frame = relievo.attach(renderer)
    frame.ShadowsOn()
    frame.GetShadowStage().SetMapSize(4096)  # a low sun stretches a map's texels along the walls
    frame.GetShadowStage().SetLightCasts(sky, False)  # light from all around has no sharp shadow

    count = max(1, round(length * 60 / given.every))
    part = length / count  # hours represented by the middle of each part
    south = above = numpy.zeros(SIZE[::-1])
    view = plan = None
    for i in range(count):
        hour = 12 + (i + 0.5 - count / 2) * part
        towards = sun.direction(given.latitude, given.date, hour)
        shine(lamp, towards)
        look_from_the_south(camera)
        view = relievo.capture(renderer, ["color", "shadow_0", "depth"])
        south = south + part * relievo.layer(view, "shadow_0")
        look_from_above(camera)
        plan = relievo.capture(renderer, ["shadow_0", "position"])
        above = above + part * relievo.layer(plan, "shadow_0")

        clock = f"{int(hour):02}:{int(hour % 1 * 60):02}"
        height = math.degrees(math.asin(towards[2]))
        path = given.folder / f"frame_{i:02}.png"
        caption = f"{given.date}, {clock} solar time, the sun {height:.0f}° high"
        write_frame(path, relievo.layer(view, "color"), caption)
        print(f"{path}: {clock}, the sun {height:.1f} degrees high")

    south[numpy.isinf(relievo.layer(view, "depth"))] = numpy.nan
    above[relievo.layer(plan, "position")[..., 2] > 0.5] = numpy.nan  # roofs
    place = f"latitude {given.latitude:g}, {given.date}"
    tiles = [
        ("the ground, from above", "north is up, 302 m wide, roofs grey", above),
        ("ground, walls and roofs", "from the south, as in the frames", south),
    ]
    tiles = [(name, said, with_scale(hours, length)) for name, said, hours in tiles]
    sheet = demo_sheet.contact_sheet(tiles, 2, SIZE[0], f"Hours of sun, {place}")
    demo_sheet.write_png(given.folder / "sun_hours.png", sheet)
    middle = numpy.nanmedian(above)
    print(f"{given.folder / 'sun_hours.png'}: of {length:.2f} hours, half the ground gets more "
          f"than {middle:.1f}, {numpy.nanmean(above < 2):.0%} less than 2")  # fmt: skip


if __name__ == "__main__":
    main()
