# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cost of frames with many actors, glyphs, blocks and lights, against plain frames of the scene.

    python bench/many_frames.py [--rounds N] [--small] [--series a,b] >many-frames.csv

- actors: a thousand spheres with mappers of their own above a ground, of which one moves; shadows
  of one sun by maps of 2048 and by the method exact.
- glyphs: ten thousand spheres of 96 triangles by one vtkGlyph3DMapper; the same shadows.
- blocks: a thousand spheres in one vtkMultiBlockDataSet; a capture of depth, normal and cell, and
  one of the same spheres as a single mesh, against its own plain frame.
- lights: the first frame of three spheres with 300 point lights, in which OpenGL compiles VTK's
  shader, by VTK alone, with Relievo attached, and with 300 lamps in their place; each in a process
  of its own without Mesa's cache, less the second frame, in a quarter of the rounds.

Frames have 600 x 600 pixels; each way has its own window, and all are drawn in turn, three frames
in every round, after frames that are not timed. Times are processor times of all threads, so that
other work on the machine hardly matters (its load is in the last column); a ratio is the median of
the rounds' ratios, +- half the distance of its quartiles. --small draws small scenes, in seconds. A
display is needed where VTK needs one (tools/with-display). Exit status: 0.
"""

import argparse
import csv
import math
import os
import statistics
import subprocess
import sys
import time

import relievo
from f3d_frames import ratio
from relievo.vtk import vtkRenderingOpenGL2
from relievo.vtk.vtkCommonCore import vtkPoints
from relievo.vtk.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from relievo.vtk.vtkFiltersCore import vtkAppendPolyData
from relievo.vtk.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkGlyph3DMapper,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)
from relievo.vtkRelievoPasses import vtkRelievoLayerSource

COLUMNS = ("series", "size", "motion", "frame", "against", "processor milliseconds", "ratio", "+-",
           "load")  # fmt: skip
FRAMES, BEFORE = 3, 3  # timed in each turn, and drawn before them
MAP = 2048
SIZES = {"actors": 1000, "glyphs": 10000, "blocks": 1000, "lights": 300}
SMALL = {"actors": 50, "glyphs": 100, "blocks": 50, "lights": 10}
LAYERS = ("depth", "normal", "cell")


def places(count):
    """Places of so many spheres over the ground."""
    side = math.ceil(math.sqrt(count))
    for i in range(count):
        yield (
            2.5 * (i % side) / side - 1.25, 0.05 + 0.1 * (i % 3), 2.5 * (i // side) / side - 1.25,
        )  # fmt: skip


def sphere(radius, around=8, up=8):
    made = vtkSphereSource()
    made.SetRadius(radius)
    made.SetThetaResolution(around)
    made.SetPhiResolution(up)
    return made


class Scene:
    """A window with a ground in the light of a sun."""

    def __init__(self, fill):
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        ground = vtkPlaneSource()
        ground.SetOrigin(-3, 0, -3)
        ground.SetPoint1(-3, 0, 3)
        ground.SetPoint2(3, 0, -3)
        self.add(vtkPolyDataMapper(), ground)
        self.renderer.AutomaticLightCreationOff()
        self.sun = vtkLight()
        self.sun.SetLightTypeToSceneLight()
        self.sun.SetPosition(3, 5, 2)
        self.renderer.AddLight(self.sun)
        self.mover = fill(self)
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(600, 600)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(0, 0.5, 0)
        camera.SetViewAngle(30)
        self.move("still", 0)

    def add(self, mapper, source):
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        return actor

    def move(self, motion, frame):
        """The state of a frame."""
        turn = 0.02 * frame * (motion == "camera moves")
        self.renderer.GetActiveCamera().SetPosition(
            2.5 + 2 * math.sin(turn), 3, 6 - 2 * (1 - math.cos(turn)))  # fmt: skip
        self.sun.SetPosition(3 + 0.02 * (frame % 50) * (motion == "light moves"), 5, 2)
        if motion == "one actor moves":
            self.mover.SetPosition(0.5 * math.sin(0.1 * frame), 1, 0.5 * math.cos(0.1 * frame))
        self.renderer.ResetCameraClippingRange()

    def draw(self):
        self.window.Render()
        self.window.WaitForCompletion()


def actors(scene, count):
    mover = scene.add(vtkPolyDataMapper(), sphere(0.1))
    for place in list(places(count))[1:]:
        scene.add(vtkPolyDataMapper(), sphere(0.03, 16, 10)).SetPosition(place)
    return mover


def glyphs(scene, count):
    points = vtkPoints()
    for place in places(count):
        points.InsertNextPoint(place)
    data, mapper, actor = vtkPolyData(), vtkGlyph3DMapper(), vtkActor()
    data.SetPoints(points)
    mapper.SetInputData(data)
    source = sphere(0.8 / math.sqrt(count))
    mapper.SetSourceConnection(source.GetOutputPort())
    mapper.ScalingOff()
    actor.SetMapper(mapper)
    scene.renderer.AddActor(actor)


def spheres(count):
    for place in places(count):
        made = sphere(0.03, 16, 10)
        made.SetCenter(place)
        made.Update()
        yield made.GetOutput()


def blocks(scene, count):
    data, actor = vtkMultiBlockDataSet(), vtkActor()
    for i, each in enumerate(spheres(count)):
        data.SetBlock(i, each)
    # since VTK 9.3 without a 2
    mapper = getattr(vtkRenderingOpenGL2, "vtkCompositePolyDataMapper2", None)
    if mapper is None:
        from relievo.vtk.vtkRenderingCore import vtkCompositePolyDataMapper as mapper
    made = mapper()
    made.SetInputDataObject(data)
    actor.SetMapper(made)
    scene.renderer.AddActor(actor)


def mesh(scene, count):
    whole = vtkAppendPolyData()
    for each in spheres(count):
        whole.AddInputData(each)
    scene.add(vtkPolyDataMapper(), whole)


def write(out, scene, times, pairs):
    """Rows of a scene: `pairs` has the names against which each frame is."""
    for name in times:
        for against in pairs[name]:
            middle, spread = ratio(times[name], times[against])
            out.writerow((*scene, name, against, f"{statistics.median(times[name]):.1f}",
                          f"{middle:.3f}", f"{spread:.3f}",
                          f"{os.getloadavg()[0]:.1f}"))  # fmt: skip
    sys.stdout.flush()


def measure(out, series, size, motion, ways, rounds):
    """`ways`: of each frame its name, those against which it is, its scene, the call that draws."""
    times, frame = {name: [] for name, *_ in ways}, 0
    for _ in range(rounds):
        for name, _, scene, draw in ways:
            taken = []
            for i in range(-BEFORE, FRAMES):
                scene.move(motion, frame + i)
                start = time.process_time()
                draw()
                taken.append(1e3 * (time.process_time() - start))
            times[name].append(statistics.median(taken[BEFORE:]))
        frame += BEFORE + FRAMES
    write(out, (series, size, motion), times, {name: against for name, against, *_ in ways})


def shadows(fill):
    """A plain frame, shadows by maps, and exact shadows."""
    for name, against in (("plain", ("plain",)), ("map", ("plain",)), ("exact", ("plain", "map"))):
        scene = Scene(fill)
        if name != "plain":
            frame = relievo.attach(scene.renderer)
            stage = frame.GetShadowStage()
            stage.SetMapSize(MAP)
            if name == "exact":
                stage.SetMethodToExact()
            frame.ShadowsOn()
        yield name, against, scene, scene.draw


def captures(size):
    for name, fill in (("blocks", blocks), ("one mesh", mesh)):
        plain, captured = (Scene(lambda scene, fill=fill: fill(scene, size)) for _ in range(2))
        source = vtkRelievoLayerSource()
        source.SetRenderer(captured.renderer)
        for layer in LAYERS:
            source.AddLayer(layer)

        def capture(source=source):
            source.Modified()
            source.Update()

        yield f"{name}, plain", (f"{name}, plain",), plain, plain.draw
        yield f"{name}, capture", (f"{name}, plain",), captured, capture


def first_frame(way, count):
    """Processor milliseconds of the first frame less those of the second."""

    def fill(scene):
        for x in (-1, 0, 1):
            scene.add(vtkPolyDataMapper(), sphere(0.4, 32, 32)).SetPosition(x, 0.4, 0)

    scene = Scene(fill)
    if way == "lamps":
        points = vtkPoints()
        for x, y, z in places(count):
            points.InsertNextPoint(x, y + 0.5, z)
        data = vtkPolyData()
        data.SetPoints(points)
        lamps = relievo.vtkRelievoLamps()
        lamps.SetInputData(data)
        lamps.SetRadius(0.5)
        relievo.attach(scene.renderer).GetStage("lamps").AddPoints(lamps)
    else:
        for x, y, z in places(count):
            light = vtkLight()
            light.SetLightTypeToSceneLight()
            light.PositionalOn()
            light.SetConeAngle(180)
            light.SetPosition(x, y + 0.5, z)
            light.SetAttenuationValues(1, 0, 10)
            scene.renderer.AddLight(light)
    if way == "attached":
        relievo.attach(scene.renderer)
    taken = []
    for _ in range(2):
        start = time.process_time()
        scene.draw()
        taken.append(1e3 * (time.process_time() - start))
    print(taken[0] - taken[1])


def lights(out, size, rounds):
    ways = ("VTK's lights", "attached", "lamps")
    times = {way: [] for way in ways}
    for _ in range(rounds):
        for way in ways:
            said = subprocess.run(
                [sys.executable, __file__, "--first", way, str(size)],
                env={**os.environ, "MESA_SHADER_CACHE_DISABLE": "true"},
                check=True, capture_output=True, text=True)  # fmt: skip
            times[way].append(float(said.stdout.split()[-1]))
    write(out, ("lights", size, "first frame"), times, {way: (ways[0],) for way in ways})


def main():
    if sys.argv[1:2] == ["--first"]:
        first_frame(sys.argv[2], int(sys.argv[3]))
        return
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--small", action="store_true", help="small scenes")
    parser.add_argument("--series", default=",".join(SIZES))
    given = parser.parse_args()
    sizes = SMALL if given.small else SIZES
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(COLUMNS)
    for series in given.series.split(","):
        size = sizes[series]
        if series == "lights":
            lights(out, size, max(1, given.rounds // 4))
        elif series == "blocks":
            measure(out, series, size, "still", list(captures(size)), given.rounds)
        else:
            fill = {"actors": actors, "glyphs": glyphs}[series]
            ways = list(shadows(lambda scene, fill=fill, size=size: fill(scene, size)))
            for motion in ("one actor moves",) if series == "actors" else (
                "still", "camera moves", "light moves"):  # fmt: skip
                measure(out, series, size, motion, ways, given.rounds)


main()
