# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences of two results of tools/compare-frames, a line for each.

`relievo compare` cannot replace this: values must be equal bit for bit, and no build judges itself.
"""

import difflib
import json
import re
import struct
import zlib

import numpy

# Fields of a report that are measured, or depend on measurements.
TIMES = ("gpu_ms", "frame_ms", "expected_frame_ms", "untimed")
MOST_LINES = 20  # of a text, to print
EXR_TYPES = (numpy.dtype("<u4"), numpy.dtype("<f2"), numpy.dtype("<f4"))
EXR_ROWS = {0: 1, 2: 1, 3: 16}  # per block: not compressed, zips, zip


def compare(first, second):
    """The differences of two files of the same name."""
    before, after = first.read_bytes(), second.read_bytes()
    if before == after:
        return []
    kinds = {".exr": exr, ".npy": arrays, ".json": reports, ".txt": texts}
    kind = kinds.get(first.suffix, data)
    try:
        return pictures(first, second) if first.suffix == ".png" else kind(before, after)
    except (ValueError, IndexError, KeyError, struct.error, zlib.error) as error:
        return [f"cannot be read as {first.suffix}: {error}; {data(before, after)[0]}"]


def data(before, after):
    """The differences of bytes without another function."""
    if len(before) != len(after):
        return [f"{len(before)} bytes became {len(after)}"]
    places = [i for i, (a, b) in enumerate(zip(before, after)) if a != b]
    return [f"{len(places)} of {len(before)} bytes differ, the first at {places[0]}"]


def values(name, before, after):
    """The differences of two arrays, bit for bit."""
    if (before.shape, before.dtype) != (after.shape, after.dtype):
        return [f"{name}: {before.dtype} {before.shape} became {after.dtype} {after.shape}"]
    size = before.dtype.itemsize
    first, second = (
        numpy.ascontiguousarray(each).view(numpy.uint8).reshape(-1, size)
        for each in (before, after)
    )
    unlike = (first != second).any(axis=1)
    if not unlike.any():
        return []
    with numpy.errstate(invalid="ignore"):
        by = numpy.abs(before.astype(float) - after.astype(float)).ravel()[unlike]
    by = by[numpy.isfinite(by)]
    most = f", at most by {by.max():g}" if by.size else ", in what is no finite number"
    return [f"{name}: {unlike.sum()} of {unlike.size} values differ{most}"]


def pictures(first, second):
    """The differences of two PNG files, pixel for pixel."""
    before, after = read_png(first), read_png(second)
    if before.shape != after.shape:
        return [f"{before.shape} rows, columns, channels became {after.shape}"]
    by = numpy.abs(before.astype(int) - after.astype(int)).max(axis=2)
    if not by.any():
        return []
    return [f"{(by > 0).sum()} of {by.size} pixels differ, at most by {by.max()} of 255 levels"]


def read_png(path):
    """The pixels of a PNG, (rows, columns, channels)."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    if not reader.CanReadFile(str(path)):
        raise ValueError("no PNG")
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)


def exr(before, after):
    """The differences of two OpenEXR files: header attributes, and channels bit for bit."""
    (first, start), (second, begin) = read_header(before), read_header(after)
    found = [
        f"attribute {name}: {describe(first.get(name))} became {describe(second.get(name))}"
        for name in sorted({*first, *second})
        if first.get(name) != second.get(name)
    ]
    if any(first[name] != second[name] for name in ("channels", "dataWindow")):
        return found
    channels, other = read_channels(before, first, start), read_channels(after, second, begin)
    if channels is None or other is None:
        return found + ([] if before[start:] == after[begin:] else data(before, after))
    for name, channel in channels.items():
        found += values(f"channel {name}", channel, other[name])
    return found


def describe(attribute):
    """A type and bytes as readable text."""
    if attribute is None:
        return "nothing"
    kind, held = attribute
    said = repr(held)
    numbers = {"float": "f", "double": "d", "int": "i", "m44f": "16f", "m44d": "16d", "v3d": "3d"}
    if kind in numbers:
        said = " ".join(f"{value:.17g}" for value in struct.unpack("<" + numbers[kind], held))
    return f"{kind} {said}"


def read_header(file):
    """The attributes of a one-part OpenEXR file, by name: type and bytes; and their end."""
    if file[:4] != b"\x76\x2f\x31\x01" or file[5] & 0x1A:
        raise ValueError("no OpenEXR file of one part of lines")

    def word(at):
        end = file.index(b"\0", at)
        return file[at:end].decode("latin-1"), end + 1

    at, found = 8, {}
    while file[at]:
        name, at = word(at)
        kind, at = word(at)
        (size,) = struct.unpack_from("<i", file, at)
        found[name] = (kind, file[at + 4 : at + 4 + size])
        at += 4 + size
    return found, at + 1


def read_channels(file, header, at):
    """Each channel's values in the file's order of rows; None for other compressions."""
    left, low, right, high = struct.unpack("<4i", header["dataWindow"][1])
    columns, rows = right - left + 1, high - low + 1
    compression, kinds, names = header["compression"][1][0], [], []
    if compression not in EXR_ROWS:
        return None
    listed, place = header["channels"][1], 0
    while listed[place]:
        end = listed.index(b"\0", place)
        names.append(listed[place:end].decode("latin-1"))
        kinds.append(EXR_TYPES[struct.unpack_from("<i", listed, end + 1)[0]])
        place = end + 17
    row = numpy.dtype([(f"{i}", kind, columns) for i, kind in enumerate(kinds)])
    lines = numpy.empty(rows, row)
    for block in struct.unpack_from(f"<{-(-rows // EXR_ROWS[compression])}Q", file, at):
        y, size = struct.unpack_from("<ii", file, block)
        count = min(EXR_ROWS[compression], high + 1 - y)
        bare = file[block + 8 : block + 8 + size]
        if size < count * row.itemsize:
            bare = unpack(bare)
        lines[y - low : y - low + count] = numpy.frombuffer(bare, row)
    return {name: lines[f"{i}"] for i, name in enumerate(names)}


def unpack(packed):
    """A zipped block of an OpenEXR file: differences from byte to byte, even bytes first."""
    steps = numpy.frombuffer(zlib.decompress(packed), numpy.uint8).astype(numpy.int64)
    steps[1:] -= 128
    halves = (numpy.cumsum(steps) & 255).astype(numpy.uint8)
    middle = (len(halves) + 1) // 2
    found = numpy.empty_like(halves)
    found[0::2], found[1::2] = halves[:middle], halves[middle:]
    return found.tobytes()


def arrays(before, after):
    """The differences of two files of numpy."""
    import io

    return values("array", *(numpy.load(io.BytesIO(each)) for each in (before, after)))


def reports(before, after):
    """The differences of two JSON files: each field except times."""
    first, second = (dict(fields(json.loads(each))) for each in (before, after))
    nothing = object()
    return [
        f"{name}: {first.get(name, 'nothing')!r} became {second.get(name, 'nothing')!r}"
        for name in dict.fromkeys([*first, *second])
        if first.get(name, nothing) != second.get(name, nothing)
    ]


def fields(value, name=""):
    """Every number and text in JSON, with its place; stages are identified by name."""
    if isinstance(value, dict):
        for key, part in value.items():
            if key not in TIMES:
                yield from fields(part, f"{name}.{key}".lstrip("."))
    elif isinstance(value, list):
        yield f"{name}.length", len(value)
        for i, part in enumerate(value):
            called = part.get("name", i) if isinstance(part, dict) else i
            yield from fields(part, f"{name}.{called}")
    else:
        pattern, instead = MILLISECONDS
        yield name, pattern.sub(instead, value) if isinstance(value, str) else value


def texts(before, after):
    """The differences of two texts, by lines."""
    first, second = (each.decode(errors="replace").splitlines() for each in (before, after))
    found = []
    for change, a, b, c, d in difflib.SequenceMatcher(None, first, second, False).get_opcodes():
        if change == "equal":
            continue
        old, new = first[a:b], second[c:d]
        for i in range(max(len(old), len(new))):
            line = [repr(lines[i]) if i < len(lines) else "nothing" for lines in (old, new)]
            found.append(f"line {a + i + 1}: {line[0]} became {line[1]}")
    more = len(found) - MOST_LINES
    return found[:MOST_LINES] + ([f"and {more} lines more"] if more > 0 else [])


MILLISECONDS = (re.compile(r"\b\d+(?:\.\d+)?(?:e-?\d+)? ms\b"), "# ms")
# Parts of a text that vary between runs: VTK's colours, clock, thread and place in the source,
# addresses, times, progress.
VARYING = (
    (re.compile(r"\x1b\[[0-9;]*m"), ""),
    (re.compile(r"^(?:[\d-]+ [\d:.]+ )?\( *[\d.]+s\) \[[^]]*\] *\S+:\d+ +(?=[A-Z]+\|)", re.M), ""),
    (re.compile(r"(\.(?:cxx|h|txx), line )\d+"), r"\1#"),
    (re.compile(r"\b0x[0-9a-f]{6,}"), "0x#"),
    MILLISECONDS,
    (re.compile(r"(?<=# ms, )[\d.]+ times"), "# times"),
    (re.compile(r"^relievo: .* \d+ %\n", re.M), ""),
)


def steady(text, places):
    """A text without varying parts, and with placeholders for the folders that it names."""
    for place, word in places:
        text = text.replace(str(place), word)
    for pattern, instead in VARYING:
        text = pattern.sub(instead, text)
    return text
