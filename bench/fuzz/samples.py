# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small sound files of every format that Relievo reads, which the campaign damages.

A sample is a format's name, the files of it by their names, which of them may be damaged, and the
words of `relievo render` that read it.
"""

import io
import json
import pathlib
import struct
import tempfile
from dataclasses import dataclass

import numpy
from PIL import Image
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList, vtkLookupTable, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkRectilinearGrid,
    vtkStructuredGrid, vtkUnstructuredGrid)  # fmt: skip
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkDataSetWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLDataSetWriter, vtkXMLMultiBlockDataWriter

LARGEST = 200000  # bytes per sample from the data folder

MESH = b"OFF\n4 4 0\n-1 -1 0\n1 -1 0\n-1 1 0\n0 0 1\n3 0 1 2\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
COLORED = b"COFF\n3 1 0\n-1 -1 0 0.1 0.2 0.3 1\n1 -1 0 1 0 0 1\n-1 1 0 0 1 0 1\n3 0 1 2\n"
OBJ = b"""# a comment
mtllib a.mtl
o part
v -1 -1 0
v 1 -1 0 1 0.5 0.25
v -1 1 0
v 0 0 1
vt 0 0
vt 1 0
vt 0 1
vn 0 0 1
vn 0.6 0 0.8
usemtl shiny
s 1
f 1/1/1 2/2/1 3/3/1
f 1/1 2/2 4/3
usemtl clear
f -3//2 -2//2 -1//2
l 1 2 3
p 4
g rest
f 1 2 3 4
"""
MTL = b"""newmtl shiny
Ka 0.1 0.1 0.1
Kd 0.8 0.2 0.1
Ks 1 1 1
Ns 60
illum 2
map_Kd -s 2 2 1 -o 0.5 0 0 a.png
newmtl clear
Kd 0.1 0.2 0.9
d 0.4
Tr 0.6
"""


OPENCV = b"""%YAML:1.0
---
# a comment
image_width: 48
image_height: 48
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 40., 0., 23.5, 0., 40., 23.5, 0.,
       0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 5
   cols: 1
   dt: d
   data: [ -0.1, 0.02, 0.001, 0., 0. ]
"""
KALIBR = b"""cam0:
  camera_model: pinhole
  distortion_coeffs: [0.02, -0.013, 0.006, -0.0011]
  distortion_model: 'equidistant'
  intrinsics:
  - 40.0
  - 40.0
  - 23.5
  - 23.5
  resolution: [48, 48]
  rostopic: "/cam0/image_raw"
"""


@dataclass
class Sample:
    kind: str
    files: dict
    damaged: list  # names of files
    words: list
    of_others: bool = False  # who may have made it wrong on purpose

    def write(self, folder, instead=()):
        """Its files, some of them with other bytes."""
        for name, content in {**self.files, **dict(instead)}.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)


def png(color=True):
    rng = numpy.random.default_rng(3)
    made = io.BytesIO()
    Image.fromarray(rng.integers(0, 256, (8, 8, 3) if color else (8, 8), dtype=numpy.uint8)).save(
        made, "png")
    return made.getvalue()


def of_one(kind, name, content, *words):
    return Sample(kind, {name: content}, [name], list(words) or [name])


def data_sets():
    """A data set of each kind, with arrays."""
    rng = numpy.random.default_rng(5)

    def array(name, values):
        made = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
        made.SetName(name)
        return made
    places = numpy.stack(numpy.meshgrid(*[numpy.arange(3.0)] * 3, indexing="ij"), -1)
    points = vtkPoints()
    points.SetData(array("p", places.transpose(2, 1, 0, 3).reshape(-1, 3)))
    image = vtkImageData()
    image.SetDimensions(3, 3, 3)
    rectilinear = vtkRectilinearGrid()
    rectilinear.SetDimensions(3, 3, 3)
    for axis in "XYZ":
        getattr(rectilinear, f"Set{axis}Coordinates")(array(axis, numpy.array([0, 1, 2.5])))
    structured = vtkStructuredGrid()
    structured.SetDimensions(3, 3, 3)
    structured.SetPoints(points)
    unstructured = vtkUnstructuredGrid()
    unstructured.SetPoints(points)
    for kind, ids in ((10, (0, 1, 3, 9)), (12, (0, 1, 4, 3, 9, 10, 13, 12)), (5, (20, 21, 24)),
                      (14, (13, 14, 17, 16, 22)), (3, (25, 26)), (22, (1, 2, 5, 0, 4, 3)),
                      (68, (0, 1, 3))):  # fmt: skip
        unstructured.InsertNextCell(kind, len(ids), ids)
    faces = vtkIdList()
    for word in (4, 3, 0, 3, 1, 3, 0, 1, 9, 3, 1, 3, 9, 3, 3, 0, 9):
        faces.InsertNextId(word)
    unstructured.InsertNextCell(42, faces)
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    polygons, strips, lines = vtkCellArray(), vtkCellArray(), vtkCellArray()
    for ids in ((0, 1, 4, 3), (9, 10, 12)):
        polygons.InsertNextCell(len(ids), ids)
    strips.InsertNextCell(4, (18, 19, 21, 22))
    lines.InsertNextCell(3, (24, 25, 26))
    mesh.SetPolys(polygons)
    mesh.SetStrips(strips)
    mesh.SetLines(lines)
    texts = vtkStringArray()
    texts.SetName("texts")
    texts.InsertNextValue("of the field")
    made = {"vti": image, "vtr": rectilinear, "vts": structured, "vtu": unstructured, "vtp": mesh}
    for data in made.values():
        count = data.GetNumberOfPoints()
        data.GetPointData().SetScalars(array("heat", rng.random(count).astype(numpy.float32)))
        data.GetPointData().SetVectors(array("flow", rng.random((count, 3))))
        data.GetCellData().AddArray(array("part", numpy.arange(data.GetNumberOfCells()) % 3))
        data.GetFieldData().AddArray(texts)
    return made


def written(writer, name, data, **settings):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / name
        writer.SetFileName(str(path))
        writer.SetInputData(data)
        for setting, value in settings.items():
            getattr(writer, setting)(value)
        writer.Write()
        return {str(each.relative_to(folder)): each.read_bytes()
                for each in sorted(pathlib.Path(folder).rglob("*")) if each.is_file()}  # fmt: skip


def of_vtk():
    for extension, data in data_sets().items():
        for mode in range(3):
            for compressed in (None, "zlib") if mode else (None,):
                writer = vtkXMLDataSetWriter()
                if compressed is None:
                    writer.SetCompressorTypeToNone()
                files = written(writer, "a." + extension, data, SetDataMode=mode)
                yield of_one(extension, *next(iter(files.items())))
        for binary in (1, 2):
            legacy = vtkDataSetWriter()
            files = written(legacy, "a.vtk", data, SetFileType=binary)
            yield of_one("vtk", *next(iter(files.items())))
            yield Sample("points", {**files, "m.off": MESH}, ["a.vtk"],
                         ["m.off", "--lamps", "a.vtk,intensity=0.5"])  # fmt: skip
        name = "a." + extension
        files = written(vtkXMLDataSetWriter(), name, data, SetDataMode=0)
        if extension in ("vtp", "vtu"):
            tag = "PPolyData" if extension == "vtp" else "PUnstructuredGrid"
            files = {f"a.p{extension}": (
                f'<VTKFile type="{tag}" version="0.1"><{tag} GhostLevel="0"><PPointData '
                'Scalars="heat"><PDataArray type="Float32" Name="heat"/></PPointData><PPoints>'
                '<PDataArray type="Float64" NumberOfComponents="3"/></PPoints>'
                f'<Piece Source="{name}"/><Piece Source="{name}"/></{tag}></VTKFile>').encode(),
                **files}  # fmt: skip
            yield Sample(f"p{extension}", files, list(files), [f"a.p{extension}"])
    sets = data_sets()
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(3)
    sets["vtp"].GetPointData().GetScalars().SetLookupTable(colors)
    yield of_one("vtk", "a.vtk", written(vtkDataSetWriter(), "a.vtk", sets["vtp"])["a.vtk"])
    blocks = vtkMultiBlockDataSet()
    for i, data in enumerate(sets.values()):
        blocks.SetBlock(i, data)
    files = written(vtkXMLMultiBlockDataWriter(), "a.vtm", blocks, SetDataMode=0)
    yield Sample("vtm", files, sorted(files), ["a.vtm"])
    for mode in (1, 2):
        yield of_one("stl", "a.stl",
                     written(vtkSTLWriter(), "a.stl", sets["vtp"], SetFileType=mode)["a.stl"])
        yield of_one("ply", "a.ply",
                     written(vtkPLYWriter(), "a.ply", sets["vtp"], SetFileType=mode)["a.ply"])


def of_images():
    rng = numpy.random.default_rng(3)
    color = rng.integers(0, 256, (12, 24, 4), dtype=numpy.uint8)
    color[:, :10] = color[:, :1]
    grey, rgb = Image.fromarray(color[..., 0]), Image.fromarray(color[..., :3])
    rgba = Image.fromarray(color)
    rows = [(image, kind, {}) for image in (grey, rgb, rgba, rgb.quantize(16), grey.convert("1"))
            for kind in ("png", "bmp", "tiff") if (image.mode, kind) != ("RGBA", "bmp")]
    rows += [(rgb, "tiff", {"compression": c})
             for c in ("tiff_lzw", "tiff_adobe_deflate", "packbits", "jpeg")]
    rows += [(rgb, "jpeg", {"quality": 60}), (rgb, "jpeg", {"progressive": True}),
             (rgb.convert("CMYK"), "jpeg", {})]
    rows += [(image, "tga", {"rle": rle}) for image in (grey, rgb, rgba) for rle in (False, True)]
    images = []
    for image, kind, options in rows:
        made = io.BytesIO()
        image.save(made, kind, **options)
        images.append(({"jpeg": "jpg", "tiff": "tif"}.get(kind, kind), made.getvalue()))
    head = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 12 +X 24\n"
    images.append(("hdr", head + color.tobytes()))
    images.append(("exr", exr(rng.random((6, 12)).astype(numpy.float32))))
    for kind, content in images:
        name = "a." + kind
        # Readers are shared; making an environment of an image takes long.
        options = ["--height-map", *(["--environment"] if kind in ("png", "hdr", "exr") else [])]
        for option in options:
            yield Sample(kind, {name: content, "m.off": MESH}, [name], ["m.off", option, name])


def exr(values):
    """An uncompressed OpenEXR file of scan lines with one channel."""
    rows, columns = values.shape

    def attribute(name, kind, value):
        return name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value
    box = struct.pack("<4i", 0, 0, columns - 1, rows - 1)
    header = b"\x76\x2f\x31\x01\x02\0\0\0" + b"".join((
        attribute(b"channels", b"chlist", b"Y\0" + struct.pack("<iB3xii", 2, 0, 1, 1) + b"\0"),
        attribute(b"compression", b"compression", b"\0"),
        attribute(b"dataWindow", b"box2i", box), attribute(b"displayWindow", b"box2i", box),
        attribute(b"lineOrder", b"lineOrder", b"\0"),
        attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1)),
        attribute(b"screenWindowCenter", b"v2f", bytes(8)),
        attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1)))) + b"\0"  # fmt: skip
    size = 8 + 4 * columns
    first = len(header) + 8 * rows
    offsets = b"".join(struct.pack("<q", first + i * size) for i in range(rows))
    return header + offsets + b"".join(
        struct.pack("<ii", i, 4 * columns) + values[i].tobytes() for i in range(rows))


def of_models(data):
    """Models of the data folder with all files that they name beside them: the small ones, or the
    smallest of a format without any."""
    found = {}
    for path in sorted(data.rglob("*")):
        kind = path.suffix.lower()[1:]
        if kind not in ("bvh", "dae", "fbx", "iqm", "ms3d", "x", "gltf", "glb"):
            continue
        beside = [each for each in path.parent.iterdir() if each.is_file() and each != path
                  and each.name.encode() in path.read_bytes()]  # fmt: skip
        files = {each.name: each.read_bytes() for each in [path, *beside]}
        damaged = [path.name] + [name for name in files if name.endswith(".bin")]
        sample = Sample(kind, files, damaged, [path.name], of_others=True)
        found.setdefault(kind, []).append((sum(map(len, files.values())), sample))
    for rows in found.values():
        rows = sorted(rows, key=lambda row: row[0])
        yield from (row[-1] for i, row in enumerate(rows) if i == 0 or row[0] <= LARGEST)


def of_calibrations():
    for content in (OPENCV, KALIBR):
        yield Sample("yml", {"a.yml": content, "m.off": MESH}, ["a.yml"],
                     ["m.off", "--lens", "a.yml"])


def of_sessions():
    words = ["--size", "64x64", "--color", "0.2/0.4/0.8", "--light", "sun:0,1,1", "m.off"]
    sun = {"by_time": False, "date": [2026, 6, 1], "hour": 12.5, "time_zone": 1, "latitude": 48.0,
           "longitude": 9.0}  # fmt: skip
    session = {"relievo-viewer": 1, "words": words, "sun": sun}
    content = json.dumps(session, indent=1).encode()
    yield Sample("session", {"a.json": content, "m.off": MESH}, ["a.json"], ["a.json"])


def all_samples(data):
    """All samples, by format."""
    samples = [of_one("off", "a.off", MESH),
               of_one("off", "a.off", COLORED),
               Sample("obj", {"a.obj": OBJ, "a.mtl": MTL, "a.png": png()},
                      ["a.obj", "a.obj", "a.mtl"], ["a.obj"])]  # fmt: skip
    samples += [*of_vtk(), *of_images(), *of_models(data), *of_calibrations(),
                *of_sessions()]
    by_kind = {}
    for sample in samples:
        by_kind.setdefault(sample.kind, []).append(sample)
    return by_kind
