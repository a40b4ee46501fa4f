# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Three coloured spots on a motorbike: each casts shadows, and their colours add on the floor.

    07_three_spots.py [FOLDER]    writes FOLDER/three_spots.png and FOLDER/three_spots_layers.png

Red, green and blue are white together; where one is blocked the floor shows the other two, so the
shadows are cyan, magenta and yellow. The second picture has each spot's layer shadow_N by itself.

Needs motorBike.obj in the folder RELIEVO_DATA (default: build/data beside this folder);
tools/unpack-data puts it there.
"""

import relievo
from relievo.vtk.vtkCommonTransforms import vtkTransform
from relievo.vtk.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow

import demo_scene
import demo_sheet
import scene

SIZE = (1440, 720)
SPOTS = {  # name: position, colour
    "red": ((-2.7, 2.6, 2.6), (1.0, 0.12, 0.10)),
    "green": ((0.5, 3.6, 3.2), (0.10, 0.85, 0.14)),
    "blue": ((2.9, 2.6, 2.5), (0.14, 0.20, 1.0)),
}


def make_bike():
    """The bike's actors: painted parts in light grey, the others darker."""
    turn = vtkTransform()
    turn.RotateY(24)
    for material, piece in demo_scene.read_bike(scene.data("motorBike.obj")).items():
        grey = {"rubber": 0.35, "glass": 0.3, "leather": 0.6}.get(material, 0.85)
        yield demo_scene.actor(demo_scene.smooth(piece), (grey, grey, grey), 0.0, 0.35, turn)


def make_spot(place, colour):
    spot = vtkLight()
    spot.SetLightTypeToSceneLight()
    spot.SetPositional(True)
    spot.SetPosition(*place)
    spot.SetFocalPoint(0, 0.45, 0)
    spot.SetConeAngle(42)  # half the opening, degrees
    spot.SetExponent(1)
    spot.SetColor(*colour)
    spot.SetIntensity(2.8)
    return spot


folder = scene.folder()
renderer = vtkRenderer()
renderer.AddActor(demo_scene.actor(demo_scene.cove(), (0.9, 0.9, 0.9), 0.0, 0.9))
for actor in make_bike():
    renderer.AddActor(actor)
renderer.AutomaticLightCreationOff()
for place, colour in SPOTS.values():
    renderer.AddLight(make_spot(place, colour))
camera = renderer.GetActiveCamera()
camera.SetPosition(-0.4, 2.3, 5.2)
camera.SetFocalPoint(-0.05, 0.42, -0.2)
camera.SetViewAngle(24)
camera.SetClippingRange(1, 20)
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetSize(*SIZE)
window.AddRenderer(renderer)

frame = relievo.attach(renderer)
frame.ShadowsOn()  # every light casts; SetLightCasts and SetPropCasts choose
renderer.UseFXAAOn()
layers = [f"shadow_{light}" for light in range(len(SPOTS))]
image = relievo.capture(renderer, ["color", *layers])

picture, _ = demo_sheet.picture_of("color", relievo.layer(image, "color"))
demo_sheet.write_png(folder / "three_spots.png", picture)
tiles = []
for name, layer in zip(SPOTS, layers):
    lit = relievo.layer(image, layer)
    tiles.append((layer, f"the {name} spot: 1 lit, 0 dark", demo_sheet.bytes_of(lit)))
    print(f"{layer}: the {name} spot is blocked in {1 - lit.mean():.0%} of the picture")
tiles = [(name, words, grey[..., None].repeat(3, axis=2)) for name, words, grey in tiles]
sheet = demo_sheet.contact_sheet(tiles, 3, SIZE[0] / 2, "The spots' visibility, one layer each")
demo_sheet.write_png(folder / "three_spots_layers.png", sheet)
for name in ("three_spots.png", "three_spots_layers.png"):
    print(folder / name)
