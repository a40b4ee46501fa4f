# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes glTF files for tests: accessors of every type, as .gltf with data in it or as .glb."""

import base64
import json
import struct
import zlib

import numpy

CODES = {"i1": 5120, "u1": 5121, "i2": 5122, "u2": 5123, "u4": 5125, "f4": 5126}
NAMES = {1: "SCALAR", 2: "VEC2", 3: "VEC3", 4: "VEC4", 16: "MAT4"}


class Writer:
    def __init__(self):
        self.json = {"asset": {"version": "2.0"}}
        self.bytes = bytearray()

    def add(self, name, value):
        """Appends to a list of the file; returns the place."""
        self.json.setdefault(name, []).append(value)
        return len(self.json[name]) - 1

    def uses(self, name, required=False):
        for key in ["extensionsUsed"] + ["extensionsRequired"] * required:
            if name not in self.json.setdefault(key, []):
                self.json[key].append(name)

    def view(self, data, stride=None):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        view = {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(data)}
        if stride:
            view["byteStride"] = stride
        self.bytes += data
        return self.add("bufferViews", view)

    def pack(self, values, kind, stride=None):
        rows = numpy.ascontiguousarray(values, numpy.dtype("<" + kind))
        rows = rows.reshape(len(rows), -1)
        size = rows.dtype.itemsize * rows.shape[1]
        if stride is None:
            return rows.tobytes()
        return b"".join(row.tobytes().ljust(stride, b"\xee") for row in rows)

    def accessor(self, values, kind="f4", normalized=False, aligned=False, sparse=None, bare=False,
                 bounds=False):  # fmt: skip
        """`aligned`: each value begins at a multiple of four; `sparse`: places and values put in
        place; `bare`: no values but the sparse ones."""
        values = numpy.asarray(values)
        components = 1 if values.ndim == 1 else int(numpy.prod(values.shape[1:]))
        size = numpy.dtype(kind).itemsize * components
        stride = size + -size % 4 if aligned else None
        accessor = {"componentType": CODES[kind], "count": len(values), "type": NAMES[components]}
        if not bare:
            accessor["bufferView"] = self.view(
                self.pack(values, kind, stride), stride if stride != size else None
            )
        if normalized:
            accessor["normalized"] = True
        shown = numpy.zeros_like(values) if bare else values.copy()
        if sparse:
            places, put = sparse
            accessor["sparse"] = {
                "count": len(places),
                "indices": {
                    "bufferView": self.view(self.pack(numpy.array(places), "u2")),
                    "componentType": CODES["u2"],
                },
                "values": {"bufferView": self.view(self.pack(numpy.array(put), kind))},
            }
            shown[places] = put
        if bounds:
            rows = numpy.asarray(shown, numpy.dtype(kind)).reshape(len(shown), -1)
            accessor["min"] = [float(v) for v in rows.min(axis=0)]
            accessor["max"] = [float(v) for v in rows.max(axis=0)]
        return self.add("accessors", accessor)

    def save(self, path, uri=None):
        """`uri`: of a file beside it that gets the bytes. Returns the path."""
        text = dict(self.json)
        if self.bytes:
            self.bytes += b"\0" * (-len(self.bytes) % 4)
            text["buffers"] = [{"byteLength": len(self.bytes)}]
            if path.suffix == ".gltf":
                coded = base64.b64encode(bytes(self.bytes)).decode()
                text["buffers"][0]["uri"] = uri or "data:application/octet-stream;base64," + coded
        data = json.dumps(text).encode()
        path.write_bytes(data if path.suffix == ".gltf" else pack_glb(data, bytes(self.bytes)))
        return path


def pack_glb(text, data=b""):
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    if data:
        chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def png(texels):
    """The bytes of a PNG with these texels, rows x columns x 3 or 4, the top row first."""
    texels = numpy.asarray(texels, numpy.uint8)
    height, width, components = texels.shape

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    rows = b"".join(b"\0" + row.tobytes() for row in texels)
    head = struct.pack(">IIBBBBB", width, height, 8, 6 if components == 4 else 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", head)
        + chunk(b"IDAT", zlib.compress(rows))
        + chunk(b"IEND", b"")
    )


def data_uri(data, kind="image/png"):
    return f"data:{kind};base64," + base64.b64encode(data).decode()
