# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A motorbike in a forest: the light of an HDR picture all around, mirrored, with the sun's shadow.

    09_environment.py [FOLDER]    writes FOLDER/environment.png and FOLDER/environment_balls.png

A lamp replaces the sun of the HDR picture, because only lamps cast sharp shadows. The rest of that
picture gives diffuse light, as nine coefficients, and reflections at six levels of roughness, which
the second file shows: perfectly reflecting balls of roughness 0, 0.2 ... 1.

Needs motorBike.obj and forest.exr in the folder RELIEVO_DATA (default: build/data beside this
folder); tools/unpack-data puts them there. Without forest.exr a formula gives the sky.
"""

import math

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk
from relievo.vtk.vtkCommonDataModel import vtkImageData
from relievo.vtk.vtkCommonTransforms import vtkTransform
from relievo.vtk.vtkFiltersSources import vtkCylinderSource, vtkSphereSource
from relievo.vtk.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow

import demo_scene
import demo_sheet
import scene

SIZE = (1200, 675)
SUN = 6.0  # light above so many times the mean belongs to the sun
# Reflectivity and roughness of the bike's parts.
MIRRORS = {
    "paint": (0.06, 0.0),
    "second paint": (0.06, 0.0),
    "helmet": (0.06, 0.0),
    "steel": (0.65, 0.15),
    "gold": (0.45, 0.25),
    "glass": (0.08, 0.0),
    "cast": (0.25, 0.45),
    "leather": (0.04, 0.6),
    "rubber": (0.03, 0.8),
}


def read_world():
    """The light by direction: (rows, columns, 3), row 0 lowest; see vtkRelievoEnvironment."""
    try:
        path = scene.data("forest.exr")
    except SystemExit:
        return coded_sky(256)
    light = relievo.layer(relievo.read_exr(path), "color")[::-1, :, :3]  # its first row is the top
    return light.astype(numpy.float64)


def directions(rows):
    """Unit directions and solid angles of a picture of rows x 2 rows."""
    up = math.pi * ((numpy.arange(rows) + 0.5) / rows - 0.5)[:, None]
    east = 2 * math.pi * ((numpy.arange(2 * rows) + 0.5) / (2 * rows) - 0.5)[None, :]
    flat = numpy.cos(up)
    found = numpy.stack(
        [flat * numpy.cos(east), numpy.sin(up) + 0 * east, flat * numpy.sin(east)], axis=-1
    )
    return found, flat * (math.pi / rows) ** 2 + 0 * east


def coded_sky(rows):
    towards, _ = directions(rows)
    high = towards[..., 1:2]
    sky = numpy.array((0.25, 0.45, 0.95)) + (0.6, 0.45, 0.1) * (1 - numpy.abs(high)) ** 4
    light = numpy.where(high > 0, sky, (0.22, 0.2, 0.16))
    sun = numpy.array((-0.5, 0.6, 0.62))
    light[towards @ (sun / numpy.linalg.norm(sun)) > math.cos(math.radians(1.5))] = 900
    return light


def part_sun(world):
    """The world without the light far above its mean; that light's direction and colour."""
    towards, angles = directions(len(world))
    mean = (world * angles[..., None]).sum((0, 1)) / angles.sum()
    rest = numpy.minimum(world, SUN * mean)
    above = ((world - rest) * angles[..., None]).reshape(-1, 3)
    sun = above.sum(axis=1) @ towards.reshape(-1, 3)
    return rest / mean.mean(), sun / numpy.linalg.norm(sun), above.sum(axis=0) / mean.mean()


def make_environment(world):
    image = vtkImageData()
    image.SetDimensions(world.shape[1], world.shape[0], 1)
    values = numpy_to_vtk(world.reshape(-1, 3).astype(numpy.float32), deep=True)
    values.SetName("radiance")
    image.GetPointData().SetScalars(values)
    levels = relievo.vtkRelievoEnvironmentPrefilter()
    levels.SetInputData(image)
    levels.SetSize(128)
    levels.Update()
    irradiance = relievo.vtkRelievoEnvironmentIrradiance()
    irradiance.SetInputData(image)
    irradiance.Update()
    environment = relievo.vtkRelievoEnvironment()
    environment.SetImage(image)
    environment.SetLevels(levels.GetOutput())
    environment.SetIrradiance(irradiance.GetOutput().GetColumnByName("radiance"))
    environment.GammaCorrectOn()  # as for PBR shading
    return environment


def give_material(actor, environment, reflectivity, roughness):
    material = relievo.vtkRelievoMaterial()
    material.SetEnvironment(environment)
    material.SetReflectivity(reflectivity)
    material.SetRoughness(roughness)
    material.Attach(actor)


def plinth():
    disc = vtkCylinderSource()
    disc.SetRadius(1.75)
    disc.SetHeight(0.12)
    disc.SetCenter(0, -0.06, 0)
    disc.SetResolution(180)
    disc.Update()
    return disc.GetOutput()


def add_bike(renderer, environment):
    turn = vtkTransform()
    turn.RotateY(24)
    for material, piece in demo_scene.read_bike(scene.data("motorBike.obj")).items():
        colour, _, roughness, _ = demo_scene.MATERIALS[material]
        part = demo_scene.actor(demo_scene.smooth(piece), colour, 0.0, max(roughness, 0.3), turn)
        give_material(part, environment, *MIRRORS[material])
        renderer.AddActor(part)
    stand = demo_scene.actor(plinth(), (0.42, 0.40, 0.37), 0.0, 0.9)
    give_material(stand, environment, 0.02, 0.9)
    renderer.AddActor(stand)


def add_balls(renderer, environment):
    for i in range(6):
        ball = vtkSphereSource()
        ball.SetCenter(0.86 * (i - 2.5), 0.5, 0)
        ball.SetRadius(0.4)
        ball.SetThetaResolution(96)
        ball.SetPhiResolution(96)
        ball.Update()
        mirror = demo_scene.actor(ball.GetOutput(), (0, 0, 0), 0.0, 1.0)
        give_material(mirror, environment, 1.0, i / 5)
        renderer.AddActor(mirror)


def make_view(environment, sun, colour, size):
    renderer = vtkRenderer()
    sky = relievo.vtkRelievoSkybox()
    sky.SetEnvironment(environment)
    sky.SetRoughness(0.16)  # out of focus
    renderer.AddViewProp(sky)
    lamp = vtkLight()
    lamp.SetLightTypeToSceneLight()
    lamp.SetPosition(*(10 * sun))
    lamp.SetColor(*(colour / colour.max()))
    lamp.SetIntensity(colour.max() * environment.GetIntensity())
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(lamp)
    renderer.UseFXAAOn()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    return renderer, window


def look(renderer, position, focus, angle):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focus)
    camera.SetViewAngle(angle)
    camera.SetClippingRange(1, 20)


def write(renderer, path):
    image = relievo.capture(renderer, ["color"])
    picture, _ = demo_sheet.picture_of("color", relievo.layer(image, "color"))
    demo_sheet.write_png(path, picture)
    print(path)


def main():
    folder = scene.folder()
    world, sun, colour = part_sun(read_world())
    print(f"the sun: {math.degrees(math.asin(sun[1])):.0f} degrees high, "
          f"{colour.mean() / (math.pi + colour.mean()):.0%} of the ground's light")  # fmt: skip
    environment = make_environment(world)
    environment.SetIntensity(0.5)
    # Rotated until the sun is behind the camera, to its left.
    wanted = math.degrees(math.atan2(-0.95, 0.31))
    environment.SetRotation(wanted - math.degrees(math.atan2(sun[0], sun[2])))
    flat = math.hypot(sun[0], sun[2])
    sun = numpy.array((-0.95 * flat, sun[1], 0.31 * flat))

    renderer, _window = make_view(environment, sun, colour, SIZE)
    add_bike(renderer, environment)
    look(renderer, (-1.1, 1.15, 4.9), (-0.05, 0.52, 0), 27)
    relievo.attach(renderer).ShadowsOn()
    write(renderer, folder / "environment.png")

    renderer, _window = make_view(environment, sun, colour, (1200, 300))
    add_balls(renderer, environment)
    look(renderer, (0, 0.5, 7), (0, 0.5, 0), 11)
    write(renderer, folder / "environment_balls.png")


if __name__ == "__main__":
    main()
