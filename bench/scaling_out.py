# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cost of files of ray trees, parts, many views of one scene, data sets, and camera places.

    python bench/scaling_out.py [--small] [--rounds N] >scaling-out.csv

Needs the package relievo in PYTHONPATH, numpy, and a display (tools/with-display). Rows:

- start: a ray tree of a bumpy ring, built from the mesh, or opened from its file, alone or with the
  mesh, for one process; `bytes` per triangle of the file, and of the build at its peak, beside the
  mesh (Linux). The column `MiB` has the proportional set size of each of eight processes that hold
  the file, less that without it (Linux).
- part: `relievo sun` of a bumpy ring for a day, part 1 of `number`, with a file of the tree. `MiB`
  is the process's own memory at its peak, without the file, which all parts share. The rows of the
  model are a + b / number, fitted to the processor seconds by least squares.
- view: depth of a sphere in 64 x 64 pixels, by calls of capture(), one for each view, or by
  capture_many(), drawn, or by rays with a Pinhole; per view. `other cells` is the share of pixels
  with a cell that differs from the drawn one.
- data set: a view of 640 x 480 pixels in the format coco, of 20 objects that stand apart or cover
  each other, and of the same meshes as one object, whose full mask takes one draw. Data sets of the
  format npz of a sphere, from 64 x 64 to 640 x 480 pixels.
- cover: ten of so many candidates over a plane with 60 blocks.

Processor seconds of all threads, the least of the rounds (3). --small measures small scenes, in
seconds. Exit status: 0.
"""

import argparse
import csv
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

import numpy
import processes
import relievo
from relievo._scene.program import program
from relievo.vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from relievo.vtk.vtkCommonCore import vtkPoints
from relievo.vtk.vtkCommonDataModel import vtkCellArray, vtkPolyData
from relievo.vtk.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from relievo.vtk.vtkFiltersSources import (
    vtkConeSource,
    vtkCylinderSource,
    vtkPlaneSource,
    vtkSphereSource,
)
from relievo.vtk.vtkRenderingCore import vtkActor, vtkCamera, vtkPolyDataMapper, vtkRenderer
from scale import torus, write_ply

COLUMNS = ("subject", "method", "triangles", "number", "processor seconds", "bytes", "MiB",
           "other cells")  # fmt: skip
PROCESSES = 8
HOLD = """
import re, sys, relievo
def size():
    return int(re.search(r"Pss:\\s+(\\d+)", open("/proc/self/smaps_rollup").read())[1]) / 1024
if len(sys.argv) > 1:
    scene = relievo.rays(sys.argv[1])
    scene.any([0, 0, 9], [[0, 0, -1.0]])
print("ready", flush=True)
sys.stdin.readline()
print(size(), flush=True)
sys.stdin.read()
"""


def seconds(call, rounds):
    """The least processor time of the call."""
    taken = []
    for _ in range(rounds):
        before = resource.getrusage(resource.RUSAGE_SELF)
        call()
        after = resource.getrusage(resource.RUSAGE_SELF)
        taken.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return min(taken)


def peak(call):
    """Bytes of memory that the call adds at its peak."""
    def held(word):
        status = pathlib.Path("/proc/self/status").read_text()
        return 1024 * int(re.search(rf"{word}:\s+(\d+)", status)[1])

    pathlib.Path("/proc/self/clear_refs").write_text("5")  # the peak is counted anew
    before = held("VmRSS")
    call()
    return held("VmHWM") - before


def ring(triangles):
    points, cells = torus(triangles)
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    polygons = vtkCellArray()
    polygons.SetData(3, numpy_to_vtk(cells.astype("i8").ravel(), deep=True))
    mesh.SetPolys(polygons)
    return mesh


def set_size(*words):
    """Mean proportional set size of as many processes."""
    held = [subprocess.Popen([sys.executable, "-c", HOLD, *words], stdin=subprocess.PIPE,
                             stdout=subprocess.PIPE, text=True) for _ in range(PROCESSES)]
    for each in held:
        each.stdout.readline()
    sizes = []
    for each in held:
        each.stdin.write("\n")
        each.stdin.flush()
        sizes.append(float(each.stdout.readline()))
    for each in held:
        each.communicate()
    return sum(sizes) / PROCESSES


def starts(write, triangles, rounds):
    mesh = ring(triangles)
    count = mesh.GetNumberOfCells()
    with tempfile.TemporaryDirectory() as folder:
        path = str(pathlib.Path(folder, "ring.rays"))
        bytes_at_peak = peak(lambda: relievo.rays(mesh).scene.Update())
        sizes = {"built": f"{bytes_at_peak / count:.1f}"}
        relievo.rays(mesh).write(path)
        sizes["file"] = f"{os.path.getsize(path) / count:.1f}"
        for method, things in (("built", (mesh,)), ("file", (path,)), ("file, mesh", (path, mesh))):
            taken = seconds(lambda given=things: relievo.rays(*given).scene.Update(), rounds)
            write("start", method, count, 1, taken, sizes.get(method, ""),
                  f"{set_size(path) - set_size():.1f}" if method == "file" else "", "")


def parts(write, triangles, rounds):
    points, cells = torus(triangles)
    numbers = numpy.array([1, 2, 4, 8, 16])
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        write_ply(folder / "ring.ply", points, cells)
        words = [program(), "sun", folder / "ring.ply", "--place", "48.2,16.4", "--dates",
                 "2026-06-21", "--rays", folder / "ring.rays"]  # fmt: skip
        processes.run([*words, "--step", "240", "-o", folder / "first.vtp"])  # writes the tree
        measured = []
        for number in numbers:
            taken = [processes.run([*words, "-o", folder / f"{number}-{each}.vtp", "--part",
                                    f"1/{number}"], peak=True) for each in range(rounds)]
            measured.append(min(each.processor for each in taken))
            write("part", "measured", len(cells), number, measured[-1], "",
                  f"{min(each.peak for each in taken) / 2**20:.1f}", "")  # fmt: skip
    model = numpy.vander(1 / numbers, 2)
    fitted = model @ numpy.linalg.lstsq(model, numpy.array(measured), rcond=None)[0]
    for number, taken in zip(numbers, fitted, strict=True):
        write("part", "model", len(cells), number, taken, "", "", "")


def ball(triangles):
    """A renderer with a sphere, and its number of triangles."""
    sphere = vtkSphereSource()
    side = round((triangles / 2) ** 0.5)
    sphere.SetThetaResolution(side)
    sphere.SetPhiResolution(side + 2)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    return renderer, 2 * side * side


def cameras_around(number, distance, depths, seed):
    """Cameras that look at the origin from random directions."""
    lots, made = numpy.random.default_rng(seed), []
    for _ in range(number):
        place = lots.normal(size=3)
        camera = vtkCamera()
        camera.SetPosition(distance * place / numpy.linalg.norm(place))
        camera.SetViewUp(lots.normal(size=3))
        camera.SetClippingRange(*depths)
        made.append(camera)
    return made


def views(write, triangles, number, rounds):
    renderer, triangles = ball(triangles)
    size = (64, 64)
    cameras = cameras_around(number, 2, (0.5, 5), 3)
    sensors = [relievo.Pinhole(relievo.intrinsics(camera, size), size, *relievo.extrinsics(camera))
               for camera in cameras]  # fmt: skip
    renderer.SetActiveCamera(cameras[0])
    relievo.capture(renderer, "depth", size=size)  # compiles shaders

    def draw_each():
        for camera in cameras:
            renderer.SetActiveCamera(camera)
            relievo.capture(renderer, "depth", size=size)

    def trace_each():
        for sensor in sensors[:10]:
            relievo.capture(renderer, "depth", camera=sensor)

    def draw_many():
        relievo.capture_many(renderer, cameras, "depth", size=size)

    def trace_many():
        relievo.capture_many(renderer, sensors, "depth")

    def other_cells():
        drawn, traced = (relievo.capture_many(renderer, each, "cell", size=size)["cell"]
                         for each in (cameras, sensors))  # fmt: skip
        return (drawn != traced).mean()

    calls = {"capture, drawn": (draw_each, number), "capture_many, drawn": (draw_many, number),
             "capture, rays": (trace_each, 10), "capture_many, rays": (trace_many, number)}
    taken = dict.fromkeys(calls, numpy.inf)
    for _ in range(rounds):  # in turn, so that other work slows all of them
        for method, (call, count) in calls.items():
            taken[method] = min(taken[method], seconds(call, 1) / count)
    for method in calls:
        write("view", method, triangles, number, taken[method], "", "",
              f"{other_cells():.2g}" if method == "capture_many, rays" else "")  # fmt: skip


def solids(spread):
    """20 spheres, cones and cylinders in rows."""
    lots = numpy.random.default_rng(5)
    meshes = []
    for i in range(20):
        source = (vtkSphereSource, vtkConeSource, vtkCylinderSource)[i % 3]()
        if i % 3 == 0:
            source.SetThetaResolution(32)
            source.SetPhiResolution(24)
        else:
            source.SetResolution(48)
        place = spread * numpy.array([i % 5, 0, i // 5]) + lots.uniform(-0.2, 0.2, 3)
        source.SetCenter(place)
        source.Update()
        meshes.append(source.GetOutput())
    return meshes


def sets(write, views, rounds):
    apart, covering = solids(1.1), solids(0.25)
    joined = vtkAppendPolyData()
    for mesh in covering:
        joined.AddInputData(mesh)
    joined.Update()
    triangles = sum(mesh.GetPolys().GetNumberOfConnectivityIds() - 2 * mesh.GetNumberOfPolys()
                    for mesh in apart)  # fmt: skip
    for method, meshes in (("20 objects apart", apart),
                           ("20 objects that cover each other", covering),
                           ("one object", [joined.GetOutput()])):  # fmt: skip
        renderer = vtkRenderer()
        for mesh in meshes:
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(mesh)
            actor = vtkActor()
            actor.SetMapper(mapper)
            renderer.AddActor(actor)

        def make(renderer=renderer):
            with tempfile.TemporaryDirectory() as out:
                relievo.write_dataset(renderer, f"orbit:{views}", out, "coco", size=(640, 480))

        make()  # compiles shaders
        write("data set", method, triangles, views, seconds(make, rounds) / views, "", "", "")


def sizes(write, triangles, small):
    renderer, triangles = ball(triangles)
    for columns, rows, views in ((64, 64, 128), (128, 128, 64), (320, 240, 24), (640, 480, 8)):
        views = 4 if small else views

        def make(size=(columns, rows), views=views):
            with tempfile.TemporaryDirectory() as out:
                relievo.write_dataset(renderer, f"orbit:{views}", out, "npz", size=size)

        make()  # compiles shaders
        write("data set", f"sphere, {columns} x {rows}", triangles, views,
              seconds(make, 2) / views, "", "", "")  # fmt: skip


def covers(write, triangles, number, rounds):
    side = int((triangles / 2) ** 0.5)
    plane = vtkPlaneSource()
    plane.SetOrigin(0, 0, 0)
    plane.SetPoint1(100, 0, 0)
    plane.SetPoint2(0, 100, 0)
    plane.SetResolution(side, side)
    cut = vtkTriangleFilter()
    cut.SetInputConnection(plane.GetOutputPort())
    cut.Update()
    mesh = cut.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    lots = numpy.random.default_rng(1)
    for _ in range(60):
        low, width = lots.uniform(0, 95, 2), lots.uniform(2, 8, 2)
        within = ((points[:, :2] >= low) & (points[:, :2] <= low + width)).all(axis=1)
        points[within, 2] = lots.uniform(3, 20)
    places = numpy.column_stack([lots.uniform(0, 100, (number, 2)), lots.uniform(5, 25, number)])
    taken = seconds(lambda: relievo.cover(mesh, places, 10), rounds)
    write("cover", "relievo.cover", mesh.GetNumberOfCells(), number, taken, "", "", "")


def main():
    given = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    given.add_argument("--small", action="store_true")
    given.add_argument("--rounds", type=int, default=3)
    given = given.parse_args()
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(COLUMNS)

    def write(subject, method, triangles, number, taken, *others):
        out.writerow([subject, method, triangles, number, f"{taken:.3g}", *others])
        sys.stdout.flush()

    for triangles in (20_000,) if given.small else (1_000_000, 10_000_000):
        starts(write, triangles, 1 if triangles > 1_000_000 else given.rounds)
    parts(write, 2_000 if given.small else 300_000, 1 if given.small else 2)
    for triangles in (1_000,) if given.small else (1_000, 100_000):
        number = 1000 if triangles == 1_000 else 100
        views(write, triangles, 20 if given.small else number, given.rounds)
    sets(write, 2 if given.small else 6, given.rounds)
    for triangles in (1_000,) if given.small else (1_000, 100_000):
        sizes(write, triangles, given.small)
    for triangles, number in ([(1_000, 5)] if given.small
                              else [(10_000, 100), (100_000, 20), (100_000, 100)]):  # fmt: skip
        covers(write, triangles, number, given.rounds)


if __name__ == "__main__":
    main()
