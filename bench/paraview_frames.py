# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the plugin costs ParaView's render view: a frame without it, with it and all off, and with
shadows, of the reference scenes.

    pvbatch bench/paraview_frames.py PLUGIN DATA [--rounds N] [--scenes a,b] >paraview-frames.csv

PLUGIN is the path of Relievo.so, DATA the folder that tools/unpack-data fills. Two processes, one
without the plugin, draw in turn, a few frames each in every round, so that what else the machine
does meets both. A ratio is the median of the rounds' ratios, +- half the distance of its
quartiles. On a machine that does other things (the load is in the last column) the ratios of
processor time, over all threads, are the steadier ones: with software OpenGL they are nearly all
of a frame.
"""

import argparse
import math
import os
import pathlib
import statistics
import subprocess
import sys
import time

SCENES = {"bunny": "bunny.off", "motorBike": "motorBike.obj", "buildings": "buildings.obj"}
FRAMES = 3  # timed in each turn
MOTIONS = ("still", "camera moves", "light moves")
# state: whether the plugin is loaded, RelievoSun, RelievoShadows
STATES = {
    "ParaView": (False, 0, 0),
    "all off": (True, 0, 0),
    "sun": (True, 1, 0),
    "sun, shadows": (True, 1, 1),
}


def read_off(path):
    """A mesh of triangles from an OFF file, as vtkPolyData."""
    import numpy
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    text = path.read_text().split()
    points, faces = int(text[1]), int(text[2])
    numbers = numpy.array(text[4:], dtype=float)
    places = numbers[: 3 * points].reshape(-1, 3)
    cells = numbers[3 * points : 3 * points + 4 * faces].reshape(-1, 4)[:, 1:].astype(numpy.int64)
    mesh, kept, triangles = vtkPolyData(), vtkPoints(), vtkCellArray()
    kept.SetData(numpy_to_vtk(places, deep=True))
    ids = numpy_to_vtkIdTypeArray(numpy.ascontiguousarray(cells.reshape(-1)), deep=True)
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


def make_view(data, name):
    """The reference scene of that mesh in a render view."""
    from paraview import simple
    from vtkmodules.vtkIOGeometry import vtkOBJReader

    path = data / SCENES[name]
    if path.suffix == ".off":
        mesh = read_off(path)
    else:
        reader = vtkOBJReader()
        reader.SetFileName(str(path))
        reader.Update()
        mesh = reader.GetOutput()
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(stand(mesh, path.suffix == ".obj"))
    ground = simple.Plane(Origin=[-3, 0, -3], Point1=[-3, 0, 3], Point2=[3, 0, -3])
    view = simple.CreateView("RenderView")
    view.ViewSize = [600, 600]
    view.MultiSamples = view.UseFXAA = view.OrientationAxesVisibility = 0
    for each in (source, ground):
        shown = simple.Show(each, view)
        simple.ColorBy(shown, ("POINTS", None))
        shown.Interpolation = "Flat"
    simple.Render(view)
    view.CameraPosition, view.CameraFocalPoint = [2.5, 3, 6], [0, 0.5, 0]
    view.CameraViewUp, view.CameraViewAngle = [0, 1, 0], 30
    return view


def work(plugin, data, name):
    """A process that draws when it is told: lines `STATE;MOTION` come, lines of milliseconds go,
    by the clock and of processor time."""
    from paraview import simple

    loaded = plugin != "none"
    if loaded:
        simple.LoadPlugin(plugin, remote=False, ns=globals())
    view = make_view(pathlib.Path(data), name)
    window = view.SMProxy.GetRenderWindow()
    print("ready", flush=True)
    count = 0
    for line in open(0, encoding="ascii"):  # sys.stdin is ParaView's own
        state, motion = line.strip().split(";")
        _, sun, shadows = STATES[state]
        if loaded:
            view.RelievoSunUpAxis = "Y"
            view.RelievoSunAzimuth, view.RelievoSunElevation = 124.0, 54.0  # towards (3, 5, 2)
            view.RelievoSun, view.RelievoShadows = sun, shadows
        times = []
        for frame in range(-3, FRAMES):
            count += 1
            if motion == "camera moves":
                turn = 0.02 * count
                view.CameraPosition = [2.5 + 2 * math.sin(turn), 3, 6 - 2 * (1 - math.cos(turn))]
            elif motion == "light moves" and loaded:
                view.RelievoSunAzimuth = 124.0 + 0.2 * (count % 50)
            start = time.perf_counter(), time.process_time()
            view.SMProxy.StillRender()
            window.WaitForCompletion()
            if frame >= 0:
                times.append((time.perf_counter() - start[0], time.process_time() - start[1]))
        print(*(1e3 * statistics.median(each) for each in zip(*times)), flush=True)
    simple.Delete(view)


class Worker:
    """A process of pvbatch that draws one scene."""

    def __init__(self, plugin, data, name):
        self.process = subprocess.Popen(
            [f"/proc/{os.getpid()}/exe", __file__, "--work", plugin, data, name],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        if self.process.stdout.readline().strip() != "ready":
            raise SystemExit(f"the process that draws {name} did not start")

    def draw(self, state, motion):
        self.process.stdin.write(f"{state};{motion}\n")
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
    workers = {
        loaded: Worker(given.plugin if loaded else "none", given.data, name)
        for loaded in (False, True)
    }
    for motion in MOTIONS:
        times = {state: [] for state in STATES}
        for _ in range(given.rounds):
            for state, (loaded, _, _) in STATES.items():
                times[state].append(workers[loaded].draw(state, motion))
        for state, series in times.items():
            cells = [name, motion, state]
            for clock in (0, 1):
                mine = [each[clock] for each in series]
                cells.append(f"{statistics.median(mine):.1f}")
                for other in ("ParaView", "sun"):
                    if other == "sun" and state != "sun, shadows":
                        cells += ["", ""]
                        continue
                    found = ratio(mine, [each[clock] for each in times[other]])
                    cells += [f"{found[0]:.3f}", f"{found[1]:.3f}"]
            cells.append(f"{os.getloadavg()[0]:.1f}")
            print(",".join(f'"{cell}"' if "," in cell else cell for cell in cells), flush=True)
    for worker in workers.values():
        worker.end()


def main():
    if sys.argv[1:2] == ["--work"]:
        work(*sys.argv[2:])
        return
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("plugin")
    parser.add_argument("data")
    parser.add_argument("--rounds", type=int, default=21)
    parser.add_argument("--scenes", default=",".join(SCENES))
    given = parser.parse_args()
    columns = ["milliseconds", "times ParaView's", "+-", "times the sun without shadows", "+-"]
    columns += ["processor " + columns[0], *columns[1:], "load"]
    print("scene", "motion", "frame", *columns, sep=",")
    for name in given.scenes.split(","):
        bench(given, name)


main()
