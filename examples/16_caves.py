# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""From a seed to a cave to walk in: labels, a smooth textured surface, lamps, fog.

    16_caves.py [FOLDER [SEED]]    writes FOLDER/caves.png

Finds the place with the longest sight in the tunnels, and looks along it from eye height. Lamps
hang in a row along the way.
"""

import sys

import numpy
import relievo
from relievo.vtk.util.numpy_support import vtk_to_numpy
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

import demo_sheet
import scene

SIZE = (1280, 720)
BLOCKS = (224, 224, 112)  # half a metre each
EYES = 3.4  # blocks above the ground
UP = numpy.array((0.0, 0.0, 1.0))
random = numpy.random.default_rng(2)


def make_caves(seed):
    """The image of labels, and whether there is air, [z, y, x]."""
    caves = relievo.vtkRelievoCaves()
    caves.SetSize(*BLOCKS)
    caves.SetSeed(seed)
    caves.SetTunnelWidth(17)
    caves.SetScale(110)
    caves.SetVerticalScale(1.4)
    caves.SetContent(caves.LABELS)
    caves.Update()
    image = caves.GetOutput()
    labels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(BLOCKS[::-1])
    print(f"{labels.size} blocks, {(labels == 0).mean():.1%} of them air")
    return image, labels == 0


def surface(image):
    blocks = relievo.vtkRelievoSmoothBlocks()
    blocks.SetInputData(image)
    blocks.SetStrength(0.2)
    blocks.CloseBordersOff()
    blocks.SeamsOff()
    blocks.SetNoiseAmplitude(1.0)
    blocks.SetNoiseScale(6)
    blocks.SetNoiseDimensions(3)
    blocks.TextureCoordinatesOn()
    blocks.SetTileSize(12)
    blocks.Update()
    print(f"{blocks.GetOutput().GetNumberOfPolys()} triangles")
    return blocks.GetOutput()


def rock():
    """A seamless texture: waves whose height falls with frequency."""
    size = 512
    frequency = numpy.hypot(*numpy.meshgrid(*[numpy.fft.fftfreq(size, 1 / size)] * 2))
    layers = []
    for slope in (0.7, 1.3):
        spectrum = numpy.fft.fft2(random.standard_normal((size, size)))
        spectrum *= numpy.exp(-frequency / 120) / numpy.maximum(frequency, 10) ** slope
        spectrum[0, 0] = 0
        waves = numpy.fft.ifft2(spectrum).real
        layers.append(waves / waves.std())
    grain = numpy.clip(0.76 + 0.08 * layers[0] + 0.06 * layers[1], 0.2, 1)
    warm = numpy.clip(0.5 + 0.2 * layers[1], 0, 1)[..., None]
    colour = (1 - warm) * (0.66, 0.66, 0.68) + warm * (0.82, 0.74, 0.64)
    return scene.texture(grain[..., None] * colour)


def free_way(air, place, direction, most=130.0):
    """The free distance from a place to the rock, in blocks."""
    steps = numpy.arange(0, most, 0.5)
    at = numpy.rint(place + steps[:, None] * direction).astype(int)
    inside = ((at >= 1) & (at < numpy.array(BLOCKS) - 1)).all(axis=1)
    at = numpy.where(inside[:, None], at, 0)
    open_ = inside & air[at[:, 2], at[:, 1], at[:, 0]]
    return steps[numpy.argmin(open_)] if not open_.all() else most


def lookout(air):
    """A place to stand, and the direction of the longest sight."""
    floor = air[1:-6] & ~air[:-7] & air[3:-4] & air[6:-1]
    floors = numpy.argwhere(floor)[:, ::-1] + (0, 0, 1)
    best = (0, numpy.zeros(3), UP)
    for place in random.permutation(floors)[:300]:
        eyes = place + (0, 0, EYES - 0.5)
        for turn in numpy.arange(0, 2 * numpy.pi, numpy.pi / 10):
            for slope in (-0.25, -0.1, 0.0):
                direction = numpy.array((numpy.cos(turn), numpy.sin(turn), slope))
                direction /= numpy.linalg.norm(direction)
                sides = numpy.cross(direction, (0, 0, 1))
                room = min(free_way(air, eyes, s * sides, 8) for s in (-1, 1))
                far = free_way(air, eyes, direction) if room >= 4.5 else 0
                if far > best[0]:
                    best = (far, eyes, direction)
    return best


def along_the_way(air, eyes, direction, far):
    """Lamps under the roof, on alternate sides, and their ranges."""
    sides = numpy.cross(direction, (0, 0, 1))
    lamps = []
    for number, step in enumerate(numpy.arange(7.0, far, 12.0)):
        at = eyes + step * direction
        side = (-1) ** number * sides
        at = at + max(free_way(air, at, side, 9) - 2.5, 0) * side
        lamps.append(at + max(free_way(air, at, UP, 12) - 2.5, 0) * UP)
    return numpy.array(lamps)


def main():
    folder = scene.folder()
    image, air = make_caves(int(sys.argv[2]) if len(sys.argv) > 2 else 7)
    far, eyes, direction = lookout(air)
    print(f"one sees {far:.0f} blocks far")
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface(image))
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetTexture(rock())
    actor.GetProperty().SetAmbient(0)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.SetBackground(0.01, 0.012, 0.02)
    torch = vtkLight()
    torch.SetLightTypeToHeadlight()
    torch.SetColor(0.55, 0.65, 0.9)
    torch.SetIntensity(0.22)
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(torch)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*eyes)
    camera.SetFocalPoint(*(eyes + direction + 0.12 * UP))
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(62)
    camera.SetClippingRange(0.4, 400)
    renderer.UseFXAAOn()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)

    lamps = along_the_way(air, eyes, direction, far)
    warm = numpy.where(random.random(len(lamps))[:, None] < 0.75, (1.0, 0.66, 0.32), (0.5, 0.8, 1))
    relievo.lamps(renderer, scene.points(lamps, radius=numpy.full(len(lamps), 44.0), color=warm),
                  intensity=62, falloff="inverse-square")  # fmt: skip
    # Mist along the way, and a small glow around each lamp: a thin sphere around a thick one.
    mist = eyes + numpy.linspace(22, far + 6, 12)[:, None] * direction - 4 * UP
    mist = mist + random.normal(0, 2.0, mist.shape)
    relievo.fog(
        renderer,
        scene.points(
            numpy.concatenate([mist, lamps, lamps]),
            radius=numpy.repeat([13.0, 1.6, 0.4], [len(mist), len(lamps), len(lamps)]),
            density=numpy.repeat([0.010, 0.1, 8.0], [len(mist), len(lamps), len(lamps)]),
            color=numpy.concatenate([numpy.full((len(mist), 3), (0.30, 0.25, 0.20)), warm, warm]),
        ),
    )
    picture, _ = demo_sheet.picture_of(
        "color", relievo.layer(relievo.capture(renderer, ["color"]), "color"))  # fmt: skip
    demo_sheet.write_png(folder / "caves.png", picture)
    print(folder / "caves.png")


if __name__ == "__main__":
    main()
