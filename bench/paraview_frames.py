# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cost of the plugin in ParaView's render view: frames with the plugin, everything off, against
frames without it; frames with shadows of both methods, map and exact, against frames without; and
shadows of maps for VTK alone, in the reference scenes and a ring of 1.65 million triangles.

    pvbatch bench/paraview_frames.py PLUGIN DATA [--rounds N] [--scenes a,b]
        [--against "a; b"] >paraview-frames.csv

PLUGIN is the path of Relievo.so, DATA the folder that tools/unpack-data fills; the package relievo
is on PYTHONPATH. --against measures only the groups that begin with these frames: ParaView, sun, or
"alone, sun". The frames of a group are drawn in turn, a few in every round, in random order, so
that other work on the machine affects all; frames with and without the plugin by two processes,
replaced every few rounds. A ratio is the median of the rounds' ratios, +- half the distance of its
quartiles. On a machine with other work (the load is in the last column), ratios of processor time,
over all threads, vary less: with software OpenGL nearly all of a frame is processor time.
"""

import argparse
import itertools
import math
import os
import pathlib
import random
import statistics
import subprocess
import sys
import time

from scale import torus

# `ring` is a mesh of so many triangles, made by scale.py.
SCENES = {
    "bunny": "bunny.off",
    "motorBike": "motorBike.obj",
    "buildings": "buildings.obj",
    "ring": 1650000,
}
FRAMES = 3  # timed in each turn
ROUNDS_OF_A_PROCESS = 3  # then new processes: one may be faster than another for its whole life
MOTIONS = ("still", "camera moves", "light moves")
EXACT = 2  # shadows by the method exact
# Frames against the first of each group: the process that draws each (none: without the plugin;
# alone: VTK), sun, shadows
GROUPS = (
    (("ParaView", "none", 0, 0), ("all off", "plugin", 0, 0)),
    (("sun", "plugin", 1, 0), ("sun, shadows", "plugin", 1, 1),
     ("sun, exact shadows", "plugin", 1, EXACT)),
    (("alone, sun", "alone", 1, 0), ("alone, sun, shadows", "alone", 1, 1)),
)  # fmt: skip


def read_off(path):
    """A mesh of triangles from an OFF file, as vtkPolyData."""
    import numpy

    text = path.read_text().split()
    points, faces = int(text[1]), int(text[2])
    numbers = numpy.array(text[4:], dtype=float)
    cells = numbers[3 * points : 3 * points + 4 * faces].reshape(-1, 4)[:, 1:]
    return make(numbers[: 3 * points].reshape(-1, 3), cells)


def make(places, cells):
    """vtkPolyData of points and triangles."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    mesh, kept, triangles = vtkPolyData(), vtkPoints(), vtkCellArray()
    kept.SetData(numpy_to_vtk(places, deep=True))
    ids = numpy_to_vtkIdTypeArray(cells.astype(numpy.int64).reshape(-1), deep=True)
    triangles.SetData(3, ids)
    mesh.SetPoints(kept)
    mesh.SetPolys(triangles)
    return mesh


def stand(mesh, z_up):
    """Longest side 2, y up, centred on x and z, on y = 0."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

    places = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    if z_up:
        places = places[:, [0, 2, 1]] * [1, 1, -1]
    low, high = places.min(axis=0), places.max(axis=0)
    middle = (low + high) / 2
    middle[1] = low[1]
    places = (places - middle) * (2 / (high - low).max())
    mesh.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(places), deep=True))
    return mesh


def read(data, name):
    """The mesh of a reference scene."""
    from vtkmodules.vtkIOGeometry import vtkOBJReader

    if isinstance(SCENES[name], int):
        return stand(make(*torus(SCENES[name])), True)
    path = pathlib.Path(data) / SCENES[name]
    if path.suffix == ".off":
        return stand(read_off(path), False)
    reader = vtkOBJReader()
    reader.SetFileName(str(path))
    reader.Update()
    return stand(reader.GetOutput(), True)


def look(camera, count, moves):
    """Places the camera of the count-th frame."""
    turn = 0.02 * count * moves
    camera.SetPosition(2.5 + 2 * math.sin(turn), 3, 6 - 2 * (1 - math.cos(turn)))
    camera.SetFocalPoint(0, 0.5, 0)
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(30)


class InParaView:
    """The reference scene in a render view."""

    def __init__(self, plugin, data, name):
        from paraview import simple

        self.loaded = plugin != "none"
        if self.loaded:
            simple.LoadPlugin(plugin, remote=False, ns=globals())
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(read(data, name))
        ground = simple.Plane(Origin=[-3, 0, -3], Point1=[-3, 0, 3], Point2=[3, 0, -3])
        self.view = simple.CreateView("RenderView")
        self.view.ViewSize = [600, 600]
        self.view.MultiSamples = self.view.UseFXAA = self.view.OrientationAxesVisibility = 0
        for each in (source, ground):
            shown = simple.Show(each, self.view)
            simple.ColorBy(shown, ("POINTS", None))
            shown.Interpolation = "Flat"
        simple.Render(self.view)
        self.window = self.view.SMProxy.GetRenderWindow()

    def set(self, sun, shadows, count, motion):
        look(self.view.SMProxy.GetActiveCamera(), count, motion == "camera moves")
        if self.loaded:
            self.view.RelievoSunUpAxis, self.view.RelievoSunElevation = "Y", 54.2
            self.view.RelievoSun, self.view.RelievoShadows = sun, shadows > 0
            self.view.RelievoShadowMethod = "Exact" if shadows == EXACT else "Map"
            # Towards (3, 5, 2); north is -z.
            self.view.RelievoSunAzimuth = 123.7 + 0.2 * (count % 50) * (motion == "light moves")

    def draw(self):
        self.view.SMProxy.StillRender()
        self.window.WaitForCompletion()

    def end(self):
        from paraview import simple

        simple.Delete(self.view)


class Alone:
    """The scene in VTK's renderer, with ParaView's light kit."""

    def __init__(self, _, data, name):
        import relievo
        from vtkmodules.vtkFiltersSources import vtkPlaneSource
        from vtkmodules.vtkRenderingCore import (
            vtkActor,
            vtkLight,
            vtkLightKit,
            vtkPolyDataMapper,
            vtkRenderer,
            vtkRenderWindow,
        )

        ground = vtkPlaneSource()
        ground.SetOrigin(-3, 0, -3)
        ground.SetPoint1(-3, 0, 3)
        ground.SetPoint2(3, 0, -3)
        ground.Update()
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        for mesh in (read(data, name), ground.GetOutput()):
            mapper, actor = vtkPolyDataMapper(), vtkActor()
            mapper.SetInputData(mesh)
            actor.SetMapper(mapper)
            actor.GetProperty().SetInterpolationToFlat()
            self.renderer.AddActor(actor)
        self.renderer.AutomaticLightCreationOff()
        self.frame = relievo.attach(self.renderer)
        self.kit, self.sun = vtkLightKit(), vtkLight()
        self.kit.AddLightsToRenderer(self.renderer)
        for light in range(self.renderer.GetLights().GetNumberOfItems()):
            fill = self.renderer.GetLights().GetItemAsObject(light)
            self.frame.GetShadowStage().SetLightCasts(fill, False)
        self.sun.SetLightTypeToSceneLight()
        self.renderer.AddLight(self.sun)
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(600, 600)
        self.window.AddRenderer(self.renderer)

    def set(self, sun, shadows, count, motion):
        look(self.renderer.GetActiveCamera(), count, motion == "camera moves")
        self.renderer.ResetCameraClippingRange()
        self.sun.SetPosition(3 + 0.02 * (count % 50) * (motion == "light moves"), 5, 2)
        self.sun.SetSwitch(sun)
        self.frame.SetShadows(bool(shadows))

    def draw(self):
        self.window.Render()
        self.window.WaitForCompletion()

    def end(self):
        self.window.Finalize()


def work(kind, data, name):
    """Draws on request in a process: reads lines `SUN SHADOWS ROUND MOTION`, writes lines of
    elapsed and processor milliseconds. Each round has the same path."""
    scene = (Alone if kind == "alone" else InParaView)(kind, data, name)
    print("ready", flush=True)
    for line in open(0, encoding="ascii"):  # sys.stdin is ParaView's own
        sun, shadows, number, motion = line.strip().split(" ", 3)
        count = int(number) * (FRAMES + 4)
        times = []
        for frame in range(-4, FRAMES):
            count += 1
            scene.set(int(sun), int(shadows), count, motion)
            start = time.perf_counter(), time.process_time()
            scene.draw()
            if frame >= 0:
                times.append((time.perf_counter() - start[0], time.process_time() - start[1]))
        print(*(1e3 * statistics.median(each) for each in zip(*times)), flush=True)
    scene.end()


class Worker:
    """A process of pvbatch that draws one scene."""

    def __init__(self, kind, data, name):
        self.process = subprocess.Popen(
            [f"/proc/{os.getpid()}/exe", __file__, "--work", kind, data, name],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        if self.process.stdout.readline().strip() != "ready":
            raise SystemExit(f"the process that draws {name} ({kind}) did not start")

    def draw(self, sun, shadows, number, motion):
        self.process.stdin.write(f"{sun} {shadows} {number} {motion}\n")
        self.process.stdin.flush()
        return tuple(map(float, self.process.stdout.readline().split()))

    def end(self):
        self.process.stdin.close()
        self.process.wait(60)


def ratio(times, others):
    """The median of the ratios of two series, and half the distance of their quartiles."""
    ratios = [a / b for a, b in zip(times, others)]
    low, _, high = statistics.quantiles(ratios, n=4)
    return statistics.median(ratios), (high - low) / 2


def bench(given, name):
    groups = [group for group in GROUPS if group[0][0] in given.against.split("; ")]
    words = {"none": "none", "plugin": given.plugin, "alone": "alone"}
    kinds = {kind: words[kind] for group in groups for _, kind, *_ in group}
    times = {(motion, frame): [] for motion in MOTIONS for group in groups for frame in group}
    for number in range(given.rounds):
        if number % ROUNDS_OF_A_PROCESS == 0:
            workers = {kind: Worker(word, given.data, name) for kind, word in kinds.items()}
        for motion in MOTIONS:
            for group in groups:
                for frame in random.sample(group, len(group)):
                    _, kind, sun, shadows = frame
                    times[motion, frame].append(workers[kind].draw(sun, shadows, number, motion))
        if number % ROUNDS_OF_A_PROCESS == ROUNDS_OF_A_PROCESS - 1 or number == given.rounds - 1:
            for worker in workers.values():
                worker.end()
    for motion, (against, *group) in itertools.product(MOTIONS, groups):
        for frame in group:
            cells = [name, motion, frame[0], against[0]]
            for clock in (0, 1):
                first, second = (
                    [each[clock] for each in times[motion, way]] for way in (against, frame)
                )
                found = ratio(second, first)
                cells += [f"{statistics.median(second):.1f}", f"{found[0]:.3f}", f"{found[1]:.3f}"]
            cells.append(f"{os.getloadavg()[0]:.1f}")
            print(",".join(f'"{cell}"' if "," in cell else cell for cell in cells), flush=True)


def main():
    if sys.argv[1:2] == ["--work"]:
        work(*sys.argv[2:])
        return
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("plugin")
    parser.add_argument("data")
    parser.add_argument("--rounds", type=int, default=30)
    parser.add_argument("--scenes", default=",".join(SCENES))
    parser.add_argument("--against", default="; ".join(group[0][0] for group in GROUPS))
    given = parser.parse_args()
    columns = ["milliseconds", "ratio", "+-"]
    print("scene", "motion", "frame", "against", *columns, end=",", sep=",")
    print("processor " + columns[0], *columns[1:], "load", sep=",")
    for name in given.scenes.split(","):
        bench(given, name)


main()
