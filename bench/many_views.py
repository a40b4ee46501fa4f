# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time and memory of what many cameras see of a mesh, beside VTK, PyVista, and Embree by trimesh.

    python bench/many_views.py [--small] [--rounds N] >many-views.csv

Needs the package relievo in PYTHONPATH, numpy, and a display (tools/with-display); pyvista, and
trimesh with embreex, are left out if they are not installed. The mesh is a bumpy ring, and the
cameras look at its centre from random directions. Rows:

- cameras: how many of so many cameras see each cell, in 320 x 240 pixels, by relievo.visible, by
  vtkHardwareSelector, by a picture whose colours are the cells' numbers, and by Embree's first hits
  of rays through the pixels' centres. `found, %`: the sum of these numbers over all cells, of that
  by relievo.visible.
- views: depth and cells of so many views as arrays, by relievo.capture_many, and by loops over a
  picture whose colours are the cells' numbers and the z-buffer, by VTK's window or PyVista's
  plotter; and as a data set of npz files, by relievo.write_dataset. `found, %` are pixels of the
  first ten views with the cell that capture_many finds, and its depth up to 0.001, of the pixels
  with a cell.

Each method runs with growing numbers until the next is expected to take more than 12 processor
seconds. Those are of all threads, the least of the rounds (2), and `MiB` is the most memory that
the process holds during the call, more than before it (Linux). `exponent` is the slope of log time
over the last factor of ten. Rows whose `kind` is estimated continue the line through the last two
measured numbers. --small measures few cameras, in seconds. Exit status: 0.
"""

import argparse
import csv
import importlib.util
import itertools
import math
import sys
import tempfile

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from relievo.vtk.vtkCommonCore import vtkFloatArray, vtkUnsignedCharArray
from relievo.vtk.vtkCommonDataModel import vtkDataObject
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkHardwareSelector,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)
from scaling_out import cameras_around, peak, ring, seconds

COLUMNS = ("subject", "triangles", "columns", "method", "number", "kind", "processor seconds",
           "exponent", "MiB", "found, %")  # fmt: skip
LIMIT = 12  # processor seconds of the largest number, about
EVERY = 10_000, 100_000  # the numbers of cameras and views that are estimated


def cost(call):
    """Processor seconds and MiB of a call."""
    taken = []
    most = peak(lambda: taken.append(seconds(call, 1)))
    return taken[0], max(0, most) / 2**20


def actor_of(mesh):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def numbered(mesh):
    """The mesh with colours that are the cells' numbers, from 1."""
    made = mesh.NewInstance()
    made.ShallowCopy(mesh)
    each = numpy.arange(1, mesh.GetNumberOfCells() + 1)
    colors = numpy.stack([each >> 16, each >> 8 & 255, each & 255], axis=1).astype(numpy.uint8)
    array = numpy_to_vtk(colors, deep=True)
    array.SetName("colors")
    made.GetCellData().SetScalars(array)
    return made


def cells_of(colors):
    """The cells that the colours number; -1: none."""
    red, green, blue = (colors[..., each].astype(int) for each in range(3))
    return (red << 16 | green << 8 | blue) - 1


def distances(z):
    """Depth from values of the z-buffer, of the cameras here."""
    return 21 / (7 - 4 * z)


class VtkLoop:
    """A window of plain VTK."""

    def __init__(self, mesh, size):
        self.size = size
        self.window, self.renderer = vtkRenderWindow(), vtkRenderer()
        self.window.SetOffScreenRendering(True)
        self.window.SetSize(*size)
        self.window.SetMultiSamples(0)
        self.window.AddRenderer(self.renderer)
        actor = actor_of(numbered(mesh))
        actor.GetProperty().LightingOff()
        self.renderer.AddActor(actor)

    def views(self, cameras):
        columns, rows = self.size
        colors, z = vtkUnsignedCharArray(), vtkFloatArray()
        depth = numpy.empty((len(cameras), rows, columns), numpy.float32)
        cell = numpy.empty((len(cameras), rows, columns), int)
        for i, camera in enumerate(cameras):
            self.renderer.SetActiveCamera(camera)
            self.window.Render()
            self.window.GetPixelData(0, 0, columns - 1, rows - 1, 0, colors, 0)
            self.window.GetZbufferData(0, 0, columns - 1, rows - 1, z)
            cell[i] = cells_of(vtk_to_numpy(colors).reshape(rows, columns, 3)[::-1])
            depth[i] = distances(vtk_to_numpy(z).reshape(rows, columns)[::-1])
        return {"depth": depth, "cell": cell}

    def seen(self, cameras, cells):
        """How many cameras see each cell."""
        columns, rows = self.size
        colors, count = vtkUnsignedCharArray(), numpy.zeros(cells + 1, int)
        for camera in cameras:
            self.renderer.SetActiveCamera(camera)
            self.window.Render()
            self.window.GetPixelData(0, 0, columns - 1, rows - 1, 0, colors, 0)
            count[numpy.unique(cells_of(vtk_to_numpy(colors)))] += 1
        return count[:-1]  # the last is the background's

    def selected(self, cameras, cells):
        """How many cameras see each cell, by vtkHardwareSelector."""
        columns, rows = self.size
        selector, count = vtkHardwareSelector(), numpy.zeros(cells, int)
        selector.SetRenderer(self.renderer)
        selector.SetArea(0, 0, columns - 1, rows - 1)
        selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_CELLS)
        for camera in cameras:
            self.renderer.SetActiveCamera(camera)
            for node in range((found := selector.Select()).GetNumberOfNodes()):
                count[vtk_to_numpy(found.GetNode(node).GetSelectionList())] += 1
        return count


def pyvista_loop(mesh, size):
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, window_size=size, lighting="none")
    plotter.disable_anti_aliasing()
    plotter.set_background("black")
    plotter.add_mesh(pyvista.wrap(numbered(mesh)), rgb=True, lighting=False,
                     scalars="colors", preference="cell")  # fmt: skip

    def views(cameras):
        found = {"depth": [], "cell": []}
        for camera in cameras:
            plotter.camera.DeepCopy(camera)
            plotter.render()
            found["cell"].append(cells_of(plotter.screenshot(None, return_img=True)))
            found["depth"].append(-plotter.get_image_depth(fill_value=None))
        return {name: numpy.stack(each) for name, each in found.items()}

    return views


def embree_loop(mesh, size):
    import trimesh
    from trimesh.ray.ray_pyembree import RayMeshIntersector

    points = vtk_to_numpy(mesh.GetPoints().GetData())
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)

    def seen(cameras, cells):
        count = numpy.zeros(cells + 1, int)
        tree = RayMeshIntersector(trimesh.Trimesh(points, corners, process=False))
        columns, rows = size
        high = math.tan(math.radians(15))  # vtkCamera's angle of view
        x = (2 * (numpy.arange(columns) + 0.5) / columns - 1) * high * columns / rows
        y = (2 * (numpy.arange(rows) + 0.5) / rows - 1) * high
        x, y = (each.reshape(-1, 1) for each in numpy.meshgrid(x, y))
        for camera in cameras:
            ahead = numpy.array(camera.GetDirectionOfProjection())
            right = numpy.cross(ahead, camera.GetViewUp())
            right /= numpy.linalg.norm(right)
            rays = ahead + x * right + y * numpy.cross(right, ahead)
            starts = numpy.broadcast_to(camera.GetPosition(), rays.shape)
            count[numpy.unique(tree.intersects_first(starts, rays))] += 1
        return count[:-1]  # the last is that of rays without a hit

    return seen


def measure(write, head, methods, numbers, until, rounds, found):
    """Rows of all methods for growing numbers, and estimates for a larger number."""
    for method, call in methods.items():
        call(1)  # compiles shaders
        times = {}
        for number in numbers:
            expected = 0 if not times else times[last] * number / last
            if expected > LIMIT:
                break
            costs = [cost(lambda size=number: call(size)) for _ in range(rounds)]
            last, times[number] = number, min(taken for taken, _ in costs)
            write(*head, method, number, "measured", f"{times[number]:.6g}", slope(times),
                  f"{max(peak for _, peak in costs):.0f}", found(method, number))  # fmt: skip
        if len(times) > 1 and last < until:
            (few, less), (many, more) = list(times.items())[-2:]
            each = (more - less) / (many - few)
            write(*head, method, until, "estimated", f"{more + each * (until - many):.6g}", "", "",
                  "")  # fmt: skip


def slope(times):
    """The exponent over the last factor of ten."""
    if len(times) < 2:
        return ""
    (few, less), (many, more) = list(times.items())[-2:]
    return f"{math.log(more / less) / math.log(many / few):.2f}"


def cameras(write, triangles, numbers, rounds):
    mesh, size = ring(triangles), (320, 240)
    cells, all_cameras = mesh.GetNumberOfCells(), cameras_around(max(numbers), 5, (3, 7), 7)
    loop, counts = VtkLoop(mesh, size), {}

    def visible(each, _):
        found = relievo.visible(mesh, each, size=size)
        return vtk_to_numpy(found.GetCellData().GetArray("seen"))

    ways = {"relievo.visible": visible, "VTK, colours": loop.seen,
            "vtkHardwareSelector": loop.selected}  # fmt: skip
    if importlib.util.find_spec("trimesh") and importlib.util.find_spec("embreex"):
        ways["Embree by trimesh"] = embree_loop(mesh, size)

    def calling(method, way):
        def call(number):
            counts[method, number] = way(all_cameras[:number], cells).sum()

        return call

    def found(method, number):
        ours = counts.get(("relievo.visible", number))
        return "" if ours is None else f"{100 * counts[method, number] / ours:.3g}"

    measure(write, ("cameras", cells, size[0]), {each: calling(each, way) for each, way in
            ways.items()}, numbers, EVERY[0], rounds, found)  # fmt: skip


def views(write, triangles, size, numbers, rounds):
    mesh = ring(triangles)
    every, renderer = cameras_around(max(numbers), 5, (3, 7), 7), vtkRenderer()
    renderer.AddActor(actor_of(mesh))
    renderer.SetActiveCamera(every[0])
    first = {}

    def many(each):
        return relievo.capture_many(renderer, each, ("depth", "cell"), size=size)

    def dataset(each):
        with tempfile.TemporaryDirectory() as out:
            relievo.write_dataset(renderer, each, out, "npz", layers=("depth", "cell"), size=size)

    ways = {"capture_many": many, "VTK, colours": VtkLoop(mesh, size).views}
    if importlib.util.find_spec("pyvista"):
        ways["PyVista, colours"] = pyvista_loop(mesh, size)
    ways["write_dataset"] = dataset

    def calling(method, way):
        def call(number):
            made = way(every[:number])
            if made:
                first[method] = made["cell"][:10].astype(int), made["depth"][:10]

        return call

    def found(method, number):
        if method not in first:
            return ""
        (cell, depth), (ours, right) = first[method], first["capture_many"]
        few = min(len(cell), len(ours))
        hit = ours[:few] >= 0
        cell, depth, ours, right = (each[:few][hit] for each in (cell, depth, ours, right))
        return f"{100 * ((cell == ours) & (abs(depth - right) < 1e-3)).mean():.4g}"

    measure(write, ("views", mesh.GetNumberOfCells(), size[0]), {each: calling(each, way) for
            each, way in ways.items()}, numbers, EVERY[1], rounds, found)  # fmt: skip


def main():
    given = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    given.add_argument("--small", action="store_true")
    given.add_argument("--rounds", type=int, default=2)
    given = given.parse_args()
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(COLUMNS)

    def write(*row):
        out.writerow(row)
        sys.stdout.flush()

    if given.small:
        cameras(write, 1_000, (1, 10), given.rounds)
        views(write, 1_000, (64, 64), (2, 20), given.rounds)
        return
    cameras(write, 100_000, (1, 10, 100, 1000), given.rounds)
    for triangles, size in itertools.product((1_000, 100_000), ((64, 64), (320, 240))):
        views(write, triangles, size, (10, 100, 1000), given.rounds)


if __name__ == "__main__":
    main()
