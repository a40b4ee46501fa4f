# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery: pairs of pictures, an effect off and on, drawn by the lines that its page shows."""

import os
import pathlib
import re

import numpy
import relievo
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import demo_scene  # this and the next two of examples/
import demo_sheet
import scene

DATA = pathlib.Path(os.environ["RELIEVO_DATA"])
SIZE = (960, 540)
SKY = ((0.87, 0.90, 0.93), (0.62, 0.71, 0.78))
DUSK = ((0.05, 0.05, 0.09), (0.01, 0.012, 0.03))


def actor_of(data, color, **properties):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetInterpolationToPhong()
    for name, value in properties.items():
        getattr(actor.GetProperty(), f"Set{name}")(value)
    return actor


def ground(half, height=0.0, color=(0.62, 0.61, 0.6)):
    plane = vtkPlaneSource()
    plane.SetOrigin(-half, -half, height)
    plane.SetPoint1(half, -half, height)
    plane.SetPoint2(-half, half, height)
    plane.Update()
    return actor_of(plane.GetOutput(), color)


def light(renderer, position, intensity=1.0, color=(1, 1, 1)):
    """A sun, from the direction of a position."""
    made = vtkLight()
    made.SetLightTypeToSceneLight()
    made.SetPosition(*position)
    made.SetIntensity(intensity)
    made.SetColor(*color)
    renderer.AddLight(made)


def renderer_of(actors, eye, focus, sky=SKY, angle=30):
    """A renderer of actors, z up, in a window off screen of twice the picture's size."""
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    for actor in actors:
        renderer.AddActor(actor)
    renderer.GradientBackgroundOn()
    renderer.SetBackground(*sky[0])
    renderer.SetBackground2(*sky[1])
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*eye)
    camera.SetFocalPoint(*focus)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(angle)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(2 * SIZE[0], 2 * SIZE[1])
    window.AddRenderer(renderer)
    return renderer, window


def bike():
    """The demo's motorbike, z up; its linear colours are encoded, since lights here are not."""
    for material, mesh in demo_scene.read_bike(str(DATA / "motorBike.obj")).items():
        color = numpy.power(demo_scene.MATERIALS[material][0], 1 / 2.2)
        actor = actor_of(mesh, color)
        actor.RotateX(90)
        yield actor


def studio(strength=1.0):
    renderer, window = renderer_of(
        [*bike(), ground(6)], (-2.6, -2.6, 1.5), (0.05, 0, 0.5), angle=28)
    light(renderer, (-3, -1.5, 4), 0.8 * strength)
    light(renderer, (2, -4, 2), 0.35 * strength, (0.8, 0.9, 1))
    light(renderer, (-2, -4, 0.5), 0.25 * strength)
    return renderer, window


def panes():
    """Three panes of glass and a ball on a table."""
    made = [ground(5, color=(0.9, 0.89, 0.86))]
    colors = ((0.9, 0.15, 0.1), (0.95, 0.75, 0.1), (0.1, 0.35, 0.9))
    for place, color in zip((-0.9, 0.0, 0.9), colors):
        cube = vtkCubeSource()
        cube.SetBounds(place - 0.4, place + 0.4, -0.03, 0.03, 0, 1.2)
        cube.Update()
        made.append(actor_of(cube.GetOutput(), color, Opacity=0.35))
    ball = vtkSphereSource()
    ball.SetCenter(0.45, -1.0, 0.25)
    ball.SetRadius(0.25)
    ball.SetThetaResolution(64)
    ball.SetPhiResolution(64)
    ball.Update()
    made.append(actor_of(ball.GetOutput(), (0.85, 0.85, 0.85)))
    renderer, window = renderer_of(made, (1.2, -4.6, 2.4), (0, -0.3, 0.35))
    renderer.SetUseDepthPeeling(True)
    light(renderer, (-0.7, 2.6, 2.4))
    light(renderer, (1, -4, 2), 0.35)
    return renderer, window


def heights(texels=512):
    """Cobbles: the distance to the nearest of many points, as a picture that repeats."""
    random = numpy.random.default_rng(3)
    seeds = random.uniform(0, 1, (220, 2))
    u = (numpy.arange(texels) + 0.5) / texels
    x, y = numpy.meshgrid(u, u)
    near = numpy.full((2, texels, texels), 9.0)
    for seed in seeds:
        away = numpy.abs(numpy.stack([x - seed[0], y - seed[1]]))
        away = numpy.hypot(*numpy.minimum(away, 1 - away))
        second = numpy.maximum(near[0], away)
        near[0] = numpy.minimum(near[0], away)
        near[1] = numpy.minimum(near[1], second)
    tall = numpy.clip((near[1] - near[0]) / 0.035, 0, 1)
    tall = tall * tall * (3 - 2 * tall) * (1 - 4 * near[0])
    image = vtkImageData()
    image.SetDimensions(texels, texels, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(tall.astype(numpy.float32).ravel(), deep=True))
    return image


def town(seed=4, blocks=9):
    """Boxes along streets, and lamps beside these."""
    random = numpy.random.default_rng(seed)
    houses, pitch = vtkAppendPolyData(), 12.0
    half = blocks * pitch / 2
    for column in range(blocks):
        for row in range(blocks):
            x, y = (column + 0.5) * pitch - half, (row + 0.5) * pitch - half
            middle = 14 * numpy.exp(-(x * x + y * y) / 500)
            tall = random.uniform(3, 7) + middle * random.uniform(0.3, 1)
            w, d = random.uniform(3.4, 4.4, 2)
            house = vtkCubeSource()
            house.SetBounds(x - w, x + w, y - d, y + d, 0, tall)
            houses.AddInputConnection(house.GetOutputPort())
    houses.Update()
    along = numpy.arange(-half, half, 4.0)
    streets = numpy.arange(blocks + 1) * pitch - half
    places = [(street + 1.2, at, 2.2) for street in streets for at in along]
    places += [(at, street - 1.2, 2.2) for street in streets for at in along]
    cold = random.random(len(places))[:, None] < 0.3
    lamps = scene.points(places, color=numpy.where(cold, (0.7, 0.85, 1.0), (1.0, 0.68, 0.32)))
    boxes = actor_of(houses.GetOutput(), (0.72, 0.69, 0.64))
    return [boxes, ground(80, color=(0.5, 0.5, 0.52))], lamps


def night():
    actors, lamps = town()
    renderer, window = renderer_of(actors, (-38, -52, 30), (0, 0, 3), DUSK)
    light(renderer, (-1, 0.5, 1.2), 0.25, (0.5, 0.6, 1))
    return renderer, window, {"street_lamps": lamps}


def valley():
    """Hills along a valley, and points of mist in it."""
    grid = vtkPlaneSource()
    grid.SetOrigin(-14, -6, 0)
    grid.SetPoint1(14, -6, 0)
    grid.SetPoint2(-14, 26, 0)
    grid.SetResolution(280, 320)
    grid.Update()
    land = grid.GetOutput()
    places = vtk_to_numpy(land.GetPoints().GetData())

    def tall(x, y):
        away = numpy.abs(x - 2 * numpy.sin(0.4 * y))
        rough = 0.3 * numpy.sin(1.6 * x + 0.5 * y) + 0.2 * numpy.sin(2.1 * y - x)
        return 2 * (1 - numpy.exp(-((away / 2.6) ** 2))) * (1 + rough)

    places[:, 2] = tall(places[:, 0], places[:, 1])
    normals = vtkPolyDataNormals()
    normals.SetInputData(land)
    normals.Update()
    random = numpy.random.default_rng(5)
    y = random.uniform(-3, 26, 700)
    x = 2 * numpy.sin(0.4 * y) + random.normal(0, 0.9, len(y))
    above = tall(x, y) + random.uniform(-0.3, 0.2, len(y))
    radii = random.uniform(0.5, 1.3, len(y))
    mist = scene.points(numpy.stack([x, y, above], axis=1), radius=radii)
    y = numpy.arange(0, 18, 3.0)
    x = 2 * numpy.sin(0.4 * y) + 1.9
    sites = scene.points(numpy.stack([x, y, tall(x, y)], axis=1))
    renderer, window = renderer_of([actor_of(normals.GetOutput(), (0.5, 0.56, 0.38))],
                                   (1.5, -5.5, 4.6), (0.3, 8, 0.2))
    light(renderer, (-6, -3, 4.5), 0.9, (1, 0.88, 0.74))
    light(renderer, (2, -2, 9), 0.6, (0.6, 0.75, 1))
    return renderer, window, {"mist": mist, "sites": sites}


def cobbles():
    floor = ground(1, color=(0.85, 0.78, 0.7))
    renderer, window = renderer_of([floor], (-0.2, -1.9, 1.1), (0, -0.15, 0))
    light(renderer, (-2, -0.3, 1.6))
    light(renderer, (1, -2, 2), 0.2)
    return renderer, window, {"actor": floor, "heights": heights()}


# Pages whose first picture and first lines the gallery shows below the pairs.
SHOWN = ("layers", "cameras", "rays", "compare", "datasets", "volume-filters", "voxels", "caves",
         "particles", "animation")

# Name, title, what makes the scene, lines of both pictures, the lines that are on in the second,
# and the page that says more.
PAIRS = [
    ("shadows", "Shadows", studio, "", "relievo.attach(renderer).ShadowsOn()", "shadows"),
    ("soft", "Soft shadows", studio, "relievo.attach(renderer).ShadowsOn()\n"
     "shadows = relievo.attach(renderer).GetShadowStage()",
     "shadows.SetSunAngle(6)\nshadows.SetSoftSamples(24)\nshadows.SoftAtOnceOn()", "shadows"),
    ("colored", "Coloured shadows", panes,
     "relievo.attach(renderer).ShadowsOn()\nshadows = relievo.attach(renderer).GetShadowStage()\n"
     "shadows.SetMethodToExact()", "shadows.ColoredShadowsOn()", "shadows"),
    ("environment", "Environments", lambda: studio(0.35),
     "", 'relievo.environment(renderer, "forest.exr", up="z")', "environment"),
    ("lamps", "Thousands of lamps", night, "",
     'relievo.lamps(renderer, street_lamps, radius=9, intensity=0.7, falloff="linear")',
     "passes/Lamps"),
    ("tone", "Tone", night,
     'relievo.lamps(renderer, street_lamps, radius=9, intensity=3, falloff="linear")',
     'relievo.stage(renderer, "tone", operator="reinhard", white=6)', "passes/Tone"),
    ("fog", "Fog", valley, "",
     "relievo.fog(renderer, mist, density=0.05, color=(0.8, 0.85, 0.9))", "passes/Fog"),
    ("markers", "Markers", valley, "",
     "relievo.markers(renderer, sites, radius=0.8, color=(1, 0.45, 0))", "passes/Markers"),
    ("ambient", "Ambient occlusion", studio, "", 'relievo.stage(renderer, "ambient")',
     "passes/Ambient"),
    ("lines", "Lines", studio, "", 'relievo.stage(renderer, "lines")', "passes/Lines"),
    ("relief", "Relief on two triangles", cobbles, "",
     "material = relievo.vtkRelievoMaterial()\nmaterial.SetHeightMap(heights)\n"
     "material.SetHeightScale(0.06)\nmaterial.Attach(actor)\nrelievo.attach(renderer).ShadowsOn()",
     "materials"),
]


def write(window, path):
    """The window's picture, each pixel the mean of four."""
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    columns, rows = image.GetDimensions()[:2]
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, 3)[::-1]
    pixels = pixels.reshape(rows // 2, 2, columns // 2, 2, 3).mean(axis=(1, 3)).round()
    demo_sheet.write_png(path, pixels.astype(numpy.uint8))


def opening(page):
    """A page's title, its first picture with the words for it, and its first block of lines."""
    text = re.sub(r"^```{.*?^```\n", "", page.read_text(), flags=re.M | re.S)  # the index terms
    title = re.match(r"# (.*)\n", text)[1]
    words, picture = re.search(r"!\[([^\]]*)\]\(([^)]*)\)", text).groups()
    return title, words, picture, re.search(r"^```.*?^```$", text, re.M | re.S)[0]


def card(title, picture):
    """A card that leads to a heading of the page."""
    return (f":::{{grid-item-card}} {title}\n:link: '#{title.lower().replace(' ', '-')}'\n"
            f":link-type: url\n:img-top: {picture}\n:img-alt: {title}\n:::\n")


def lay(dest):
    room = f'width="{SIZE[0]}" height="{SIZE[1]}" loading="lazy"'
    pairs = dest / "site/static/pairs"
    pairs.mkdir()
    text, cards = "", "::::{grid} 2 3 4 4\n:gutter: 2\n\n"
    os.chdir(DATA)  # where the lines find their files
    for name, title, make, before, lines, page in PAIRS:
        renderer, window, *named = make()
        names = {"relievo": relievo, "renderer": renderer, **(named[0] if named else {})}
        exec(before, names)
        write(window, pairs / f"{name}-off.png")
        exec(lines, names)
        write(window, pairs / f"{name}-on.png")
        shown = f"{before}\n{lines}" if before else lines
        cards += card(title, f"site/static/pairs/{name}-on.png")
        text += (f"\n## {title}\n\n```{{raw}} html\n<div class=\"pair\">\n"
                 f"<img src=\"_static/pairs/{name}-off.png\" alt=\"{title}: off\" {room}>\n"
                 f"<img src=\"_static/pairs/{name}-on.png\" alt=\"{title}: on\" {room}>\n"
                 f"<span class=\"off\">off</span><span class=\"on\">on</span>\n"
                 f"<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"{title}: "
                 f"where the effect begins\">\n</div>\n```\n\n```python\n{shown}\n```\n\n"
                 f"More: [{title.lower()}]({page}.md).\n")
    text += "\n## Measuring and making data\n"
    for page in SHOWN:
        title, words, picture, lines = opening(dest / f"{page}.md")
        cards += card(title, picture)
        text += (f"\n### {title}\n\n![{words}]({picture})\n\n{lines}\n\n"
                 f"More: [{title.lower()}]({page}.md).\n")
    (dest / "gallery.md").write_text(
        f"# Gallery\n\n{cards}::::\n\nDrag across a picture: the effect is off on the left and on "
        "at the right. Each pair was drawn by the lines below it, when this site was built. "
        f"[More capabilities](#measuring-and-making-data) follow below the pairs.\n{text}")
