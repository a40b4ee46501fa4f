# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Growth of the time and memory of `relievo render` with the scene, beside F3D and plain VTK.

    python bench/scale.py RELIEVO [--out scale.csv] [--size WxH] [--series a,b]
        [--small | --large]

RELIEVO is the command. Whole commands draw scenes that this script makes, larger and larger, to a
PNG: the command with --preset none and studio, its default, and bench/peers.py with F3D and with
VTK, in the first that has them of --f3d or --vtk, this Python, python3 and pvpython. Two series are
of other commands: relievo visible on one mesh, and relievo dataset, with a growing number of
cameras; a third writes OpenEXR. Processor time is that of all threads and processes, the least of
the rounds: the first compiles shaders that Mesa
keeps. Memory is the most that all processes hold at a time, of the first round. Both are given
whole, and less those of the first row, whose scene is next to nothing: an empty start. An exponent
is the slope of the logarithm of what is more than that against the logarithm of the size, by least
squares over the sizes of the decade that ends in its row; costs of less than a tenth of the empty
start are left out, for they are mostly noise. What takes more than --longest seconds (8) is
measured once, and larger sizes are left out. --small draws small scenes, in seconds; --large also
the largest. --against measures another build as well. A display is needed where VTK needs one
(tools/with-display), and numpy. Exit status: 0; 1 if a command fails or draws nothing.
"""

import csv
import dataclasses
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import typing

import numpy
from processes import PEERS, parser, run

BODY, PIECE = 100000, 200  # triangles of lit bodies, and of each block and object
OBJECTS = 20  # of data sets
DECADE = 12  # sizes are rounded
NOISE = 0.1  # of an empty start
OUTPUTS = {".png": "--png", ".exr": "--exr", ".vtp": "-o", "": "--out"}  # options, by suffix
MODULES = {"f3d": "f3d", "vtk": "vtkmodules.vtkRenderingOpenGL2"}
COLUMNS = ("series", "method", "size", "processor seconds", "seconds more", "exponent", "MiB",
           "MiB more", "MiB exponent", "rounds", "load")  # fmt: skip


def torus(triangles, center=(0, 0, 0), radius=1.0):
    """Points and triangles of a bumpy ring, with about so many triangles and shared points."""
    around = max(1, round(math.sqrt(triangles / 4)))
    along = 2 * around
    u = numpy.linspace(0, 2 * numpy.pi, along, endpoint=False)[:, None]
    v = numpy.linspace(0, 2 * numpy.pi, around, endpoint=False)[None]
    thick = 0.4 + 0.02 * numpy.sin(12 * u) * numpy.sin(6 * v)
    far = 1 + thick * numpy.cos(v)
    points = numpy.empty((along, around, 3), "<f4")
    for axis, each in enumerate((far * numpy.cos(u), far * numpy.sin(u), thick * numpy.sin(v))):
        points[..., axis] = radius * each + center[axis]
    here = numpy.arange(along * around, dtype="<i4").reshape(along, around)
    next_u, next_v = numpy.roll(here, -1, 0), numpy.roll(here, -1, 1)
    corner = numpy.roll(next_u, -1, 1)
    cells = numpy.empty((along, around, 2, 3), "<i4")
    for place, each in enumerate((here, next_u, corner)):
        cells[..., 0, place] = each
    for place, each in enumerate((here, corner, next_v)):
        cells[..., 1, place] = each
    return points.reshape(-1, 3), cells.reshape(-1, 3)


def write_ply(file, points, cells):
    corners = cells.shape[1]
    faces = numpy.empty(len(cells), [("count", "u1"), ("points", "<i4", corners)])
    faces["count"], faces["points"] = corners, cells
    with open(file, "wb") as out:
        out.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
                  "property float x\nproperty float y\nproperty float z\n"
                  f"element face {len(cells)}\nproperty list uchar int vertex_indices\n"
                  "end_header\n".encode())  # fmt: skip
        points.tofile(out)
        faces.tofile(out)


def write_vtk(file, kind, words, piece, blocks):
    """An XML file of VTK with raw arrays: piece has a `{0}`, `{1}`... for the place of each."""
    places, place = [], 0
    for block in blocks:
        places.append(f'format="appended" offset="{place}"')
        place += 8 + block.nbytes
    with open(file, "wb") as out:
        out.write(f'<VTKFile type="{kind}" version="1.0" byte_order="LittleEndian" '
                  f'header_type="UInt64"><{kind} {words}>{piece.format(*places)}</{kind}>'
                  '<AppendedData encoding="raw">_'.encode())  # fmt: skip
        for block in blocks:
            out.write(struct.pack("<Q", block.nbytes))
            block.tofile(out)
        out.write(b"</AppendedData></VTKFile>")


def write_vtp(file, points, cells):
    """Cells of as many points each: one is a vertex."""
    size = cells.shape[1]
    name = "Polys" if size == 3 else "Verts"
    array = '<DataArray type="{}" Name="{}" NumberOfComponents="{}" {}/>'.format
    write_vtk(
        file, "PolyData", "",
        f'<Piece NumberOfPoints="{len(points)}" NumberOf{name}="{len(cells)}">'
        f"<Points>{array('Float32', 'Points', 3, '{0}')}</Points><{name}>"
        f"{array('Int64', 'connectivity', 1, '{1}')}{array('Int64', 'offsets', 1, '{2}')}"
        f"</{name}></Piece>",
        [points, cells.astype("<i8").ravel(),
         numpy.arange(size, size * len(cells) + 1, size, "<i8")])  # fmt: skip


def grid(count):
    """Positions of so many pieces, next to each other, and their size."""
    side = math.ceil(math.sqrt(count))
    places = [(3 * (i % side), 3 * (i // side), 0) for i in range(count)]
    return numpy.array(places, float) / side, 1 / side


@dataclasses.dataclass
class Case:
    """One size of a series."""

    file: pathlib.Path
    size: int  # the actual size
    command: str = "render"
    result: str = "picture.png"  # a file, or the folder of a data set
    window: str = ""  # if other than --size
    relievo: tuple = ()  # options
    peers: tuple = ("f3d", "vtk")
    options: tuple = ()  # of peers.py


def body(folder, size, **more):
    points, cells = torus(BODY)
    write_ply(folder / "body.ply", points, cells)
    return Case(folder / "body.ply", size, **more)


def meshes(folder, size):
    points, cells = torus(size)
    write_ply(folder / "mesh.ply", points, cells)
    return Case(folder / "mesh.ply", len(cells), peers=("f3d", "vtk", "vtk normals"))


def blocks(folder, size):
    names = []
    places, radius = grid(size)
    for number, place in enumerate(places):
        write_vtp(folder / f"{number}.vtp", *torus(PIECE, place, radius))
        names.append(f'<DataSet index="{number}" file="{number}.vtp"/>')
    file = folder / "blocks.vtm"
    file.write_text('<VTKFile type="vtkMultiBlockDataSet" version="1.0"><vtkMultiBlockDataSet>'
                    f"{''.join(names)}</vtkMultiBlockDataSet></VTKFile>")  # fmt: skip
    return Case(file, size)


def objects(folder, size):
    """Nodes of a glTF file that share a mesh."""
    places, radius = grid(size)
    points, cells = torus(PIECE, radius=radius)
    nodes = [{"mesh": 0, "translation": place.tolist()} for place in places]
    data = cells.astype("<u4").tobytes() + points.tobytes()
    views = [{"buffer": 0, "byteOffset": 0, "byteLength": cells.nbytes, "target": 34963},
             {"buffer": 0, "byteOffset": cells.nbytes, "byteLength": points.nbytes,
              "target": 34962}]  # fmt: skip
    words = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "nodes": nodes,
        "scenes": [{"nodes": list(range(size))}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5125, "count": cells.size, "type": "SCALAR"},
            {"bufferView": 1, "componentType": 5126, "count": len(points), "type": "VEC3",
             "min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()}],
        "bufferViews": views, "buffers": [{"byteLength": len(data)}]}).encode()  # fmt: skip
    words += b" " * (-len(words) % 4)
    file = folder / "objects.glb"
    with open(file, "wb") as out:
        out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(words) + len(data)))
        out.write(struct.pack("<I4s", len(words), b"JSON") + words)
        out.write(struct.pack("<I4s", len(data), b"BIN\0") + data)
    return Case(file, size)


def cloud(count):
    """Random points on the ring, equal in all runs."""
    points, _ = torus(40000)
    chance = numpy.random.default_rng(1)
    return (points[chance.integers(len(points), size=count)]
            + chance.normal(0, 0.01, (count, 3))).astype("<f4")  # fmt: skip


def points(folder, size):
    write_vtp(folder / "points.vtp", cloud(size), numpy.arange(size)[:, None])
    return Case(folder / "points.vtp", size)


def volumes(folder, size):
    side = round(size ** (1 / 3))
    at = numpy.linspace(-1, 1, side, dtype="<f4")
    values = at[:, None, None] ** 2 + at[:, None] ** 2 + numpy.sin(6 * at) ** 2
    extent = " ".join([f"0 {side - 1}"] * 3)
    write_vtk(
        folder / "volume.vti", "ImageData",
        f'WholeExtent="{extent}" Origin="0 0 0" Spacing="{" ".join([str(1 / side)] * 3)}"',
        f'<Piece Extent="{extent}"><PointData Scalars="value"><DataArray type="Float32" '
        'Name="value" {0}/></PointData></Piece>', [values.ravel()])  # fmt: skip
    return Case(folder / "volume.vti", side**3, relievo=("--image", "volume"),
                options=("--volume",))  # fmt: skip


def pictures(folder, size):
    side = round(math.sqrt(size))
    return body(folder, side * side, window=f"{side}x{side}")


def exr(folder, size):
    case = pictures(folder, size)
    return dataclasses.replace(case, result="picture.exr", peers=())


def quads(folder, size):
    """A torus of quads, in a small picture."""
    points, cells = torus(2 * size)
    corners = numpy.hstack([cells[::2], cells[1::2, 2:]])  # of the two triangles of each quad
    write_ply(folder / "quads.ply", points, corners)
    return Case(folder / "quads.ply", len(corners), window="240x180")


def sights(folder, size):
    points, cells = torus(size)
    write_ply(folder / "mesh.ply", points, cells)
    return seen(folder / "mesh.ply", len(cells), 10)


def cameras(folder, size):
    return seen(body(folder, size).file, size, size)


def seen(file, size, count):
    """A mesh, and its cells seen by so many cameras."""
    return Case(file, size, "visible", "cells.vtp", window="320x240",
                relievo=("--poses", f"orbit:{count}"), peers=())  # fmt: skip


def views(folder, size):
    files = []
    for number, place in enumerate(grid(OBJECTS)[0]):
        files.append(folder / f"{number}.ply")
        write_ply(files[-1], *torus(BODY // 50, place, grid(OBJECTS)[1]))
    first, *others = map(str, files)
    return Case(pathlib.Path(first), size, "dataset", "views",
                relievo=(*others, "--poses", f"orbit:{size}"), peers=())  # fmt: skip


def lights(folder, size):
    words = []
    for number in range(size):
        turn = 2 * math.pi * number / size
        place = f"{3 * math.cos(turn):.6f},{3 * math.sin(turn):.6f},3"
        words += ["--light", f"point:{place},intensity={1 / size:.6f}"]
    return body(folder, size, relievo=tuple(words), peers=("vtk",), options=("--lights", str(size)))


def lamps(folder, size):
    write_vtp(folder / "lamps.vtp", cloud(size), numpy.arange(size)[:, None])
    return body(folder, size, relievo=("--lamps", f"{folder / 'lamps.vtp'},radius=0.1"), peers=())


class Series(typing.NamedTuple):
    of: str  # the growing quantity
    make: typing.Callable  # a Case of a folder and a size
    start: int  # size of next to nothing
    sizes: tuple
    small: tuple
    large: tuple = ()


SERIES = {
    "meshes": Series(
        "triangles of a mesh", meshes, 36, (100_000, 300_000, 1_000_000, 3_000_000, 10_000_000),
        (100_000, 500_000), (20_000_000,)),
    "blocks": Series("blocks of a data set", blocks, 1, (10, 30, 100, 300, 1000, 3000), (60, 300)),
    "objects": Series("objects of a glTF file", objects, 1, (10, 30, 100, 300, 1000, 3000),
                      (60, 300)),
    "points": Series("points", points, 1, (10_000, 100_000, 300_000, 1_000_000, 3_000_000),
                     (100_000, 500_000), (10_000_000,)),
    "volumes": Series("voxels of a volume", volumes, 8, (32**3, 64**3, 128**3, 256**3),
                      (32**3, 64**3), (512**3,)),
    "pictures": Series("pixels of the picture", pictures, 256,
                       (256**2, 512**2, 1024**2, 2048**2, 4096**2), (1024**2, 2048**2),
                       (8192**2, 16384**2)),
    "exr": Series("pixels of an OpenEXR file", exr, 256, (1024**2, 2048**2, 4096**2),
                  (512**2, 1024**2), (8192**2, 16384**2)),
    "quads": Series("quads in 240x180 pixels", quads, 18, (4800, 48_000), (4800, 48_000)),
    "sights": Series("triangles that ten cameras see", sights, 36, (100_000, 300_000, 1_000_000),
                     (10_000, 30_000), (3_000_000,)),
    "cameras": Series("cameras that see a mesh", cameras, 1, (10, 30, 100), (3, 10)),
    "views": Series("views of a data set", views, 1, (3, 10, 30), (2, 4)),
    "lights": Series("lights", lights, 1, (3, 10, 30, 100), (3, 10)),
    "lamps": Series("lamps", lamps, 1, (10, 100, 1000, 10_000), (100, 1000)),
}  # fmt: skip


def finds(module, first):
    """A Python that has a module, or None."""
    for python in (first, sys.executable, "python3", "pvpython"):
        try:
            if python and subprocess.run([python, "-c", f"import {module}"], capture_output=True,
                                         check=False).returncode == 0:  # fmt: skip
                return python
        except OSError:
            continue
    return None


def commands(given, pythons, case, picture):
    """The commands that draw a case, by method."""
    found, window = {}, case.window or given.size
    drawn = case.command != "visible"
    option = OUTPUTS[pathlib.Path(picture).suffix]
    for build, end in ((given.relievo, ""), (given.against, ", the other build")):
        for preset in (given.presets.split(",") if drawn else [case.command]) if build else ():
            look = ("--preset", preset) if drawn else ()
            found[f"Relievo, {preset}{end}"] = [
                build, case.command, str(case.file), *look, "--size", window, *case.relievo,
                option, picture]  # fmt: skip
    names = {"f3d": "F3D", "vtk": "VTK", "vtk normals": "VTK, normals"}
    for peer in case.peers:
        kind, *normals = peer.split()
        if pythons[kind]:
            found[names[peer]] = [
                pythons[kind], str(PEERS), kind, str(case.file), picture, window,
                *case.options, *(f"--{each}" for each in normals)]  # fmt: skip
    return found


def cost(words, result, given):
    """Minimum processor seconds, peak memory, and the number of measurements."""

    def once(**options):
        shutil.rmtree(result, ignore_errors=True)  # a data set would be continued
        return run(words, **options)

    first = once(peak=True)
    rounds = given.rounds if 2 * first.processor < given.longest else 1
    more = [once() for _ in range(rounds - 1)]
    return min(each.processor for each in (first, *more)), first.peak / 2**20, rounds


def contents(result):
    """All that a command has written: a file or a folder."""
    files = sorted(result.rglob("*")) if result.is_dir() else [result]
    return [file.read_bytes() for file in files if file.is_file()]


def exponent(sizes, costs, start):
    """The exponent defined above; NaN with fewer than two points."""
    kept = [(math.log(size), math.log(cost)) for size, cost in zip(sizes, costs, strict=True)
            if DECADE * size >= sizes[-1] and cost > NOISE * start]  # fmt: skip
    return numpy.polyfit(*zip(*kept, strict=True), 1)[0] if len(kept) > 1 else math.nan


def measure(given, series, pythons):
    """Rows of a series, of which each method's first is an empty start."""
    sizes = (*(series.small if given.small else series.sizes), *(series.large * given.large))
    done = {}  # by method: sizes, seconds, MiB; the first is the empty start
    empty = {}  # its pictures
    for wanted in (series.start, *sizes):
        with tempfile.TemporaryDirectory() as folder:
            case = series.make(pathlib.Path(folder), wanted)
            result = pathlib.Path(folder, case.result)
            for method, words in commands(given, pythons, case, str(result)).items():
                past = done.setdefault(method, [])
                if past and past[-1][1] > given.longest:
                    continue
                seconds, peak, rounds = cost(words, result, given)
                if past and contents(result) == empty[method]:
                    raise SystemExit(f"scale: {method} draws {case.size} {series.of} as it draws "
                                     f"{series.start}: nothing?")  # fmt: skip
                empty.setdefault(method, contents(result))
                past.append((case.size, seconds, peak))
                yield row(series.of, method, past, rounds)


def row(series, method, past, rounds):
    size, seconds, peak = past[-1]
    cells = [series, method, size]
    for place, digits, value in ((1, 2, seconds), (2, 1, peak)):
        start = past[0][place]
        more = [each[place] - start for each in past[1:]]
        slope = exponent([each[0] for each in past[1:]], more, start) if more else math.nan
        cells += [f"{value:.{digits}f}", f"{more[-1]:.{digits}f}" if more else "",
                  "" if math.isnan(slope) else f"{slope:.2f}"]  # fmt: skip
    return [*cells, rounds, f"{os.getloadavg()[0]:.1f}"]


def main():
    options = parser(__doc__, 2)
    options.add_argument("--out")
    options.add_argument("--size", default="640x480")
    options.add_argument("--series", default=",".join(SERIES))
    options.add_argument("--presets", default="none,studio")
    options.add_argument("--against", metavar="RELIEVO")
    options.add_argument("--longest", type=float, default=8)
    options.add_argument("--small", action="store_true")
    options.add_argument("--large", action="store_true")
    for peer in MODULES:
        options.add_argument(f"--{peer}", metavar="PYTHON", help="that has it; none: without")
    given = options.parse_args()
    pythons = {peer: None if getattr(given, peer) == "none" else finds(module, getattr(given, peer))
               for peer, module in MODULES.items()}  # fmt: skip
    form = "{:22} {:32} {:>9} {:>17} {:>12} {:>8} {:>7} {:>8} {:>12} {:>6} {:>5}".format
    print(form(*COLUMNS), flush=True)
    rows = []
    for name in given.series.split(","):
        for each in measure(given, SERIES[name], pythons):
            print(form(*each), flush=True)
            rows.append(each)
    if given.out:
        with open(given.out, "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])


if __name__ == "__main__":
    main()
