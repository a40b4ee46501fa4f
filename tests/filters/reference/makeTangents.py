#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes tangents.txt: three awkward meshes and their tangents by the original MikkTSpace code.

    tests/filters/reference/makeTangents.py [GODOT] > tests/filters/reference/tangents.txt

GODOT is Debian's `godot3-server` (3.2.3), whose SurfaceTool.generate_tangents() is M. Mikkelsen's
own C code. Its bitangents are flipped (its v points down), and so w is turned here.
"""

import math
import os
import random
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

GDSCRIPT = """extends SceneTree
func _init():
    var input = File.new()
    input.open("res://corners.bin", File.READ)
    var tool = SurfaceTool.new()
    tool.begin(Mesh.PRIMITIVE_TRIANGLES)
    for corner in range(input.get_32()):
        var n = []
        for i in range(8):
            n.append(input.get_float())
        tool.add_normal(Vector3(n[3], n[4], n[5]).normalized())
        tool.add_uv(Vector2(n[6], n[7]))
        tool.add_vertex(Vector3(n[0], n[1], n[2]))
    tool.generate_tangents()
    var output = File.new()
    output.open("res://tangents.bin", File.WRITE)
    for value in tool.commit_to_arrays()[Mesh.ARRAY_TANGENT]:
        output.store_float(value)
    output.close()
    quit()
"""


def single(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def unit(vector):
    length = math.sqrt(sum(c * c for c in vector))
    return [c / length for c in vector]


def shuffled(chance):
    """A bumpy torus whose texture coordinates are dice: mirrored and turned from face to face."""
    points, triangles = [], []
    columns, rows = 10, 8
    for j in range(rows):
        for i in range(columns):
            a, b = 2 * math.pi * i / columns, 2 * math.pi * j / rows
            r = 0.5 + 0.1 * chance.random()
            away = [math.cos(b) * math.cos(a), math.cos(b) * math.sin(a), math.sin(b)]
            place = [math.cos(a) + r * away[0], math.sin(a) + r * away[1], r * away[2]]
            normal = unit([c + 0.3 * chance.uniform(-1, 1) for c in away])
            points.append(place + normal + [chance.randrange(64) / 64 for _ in range(2)])
            b = [(j + y) % rows * columns + (i + x) % columns for y in (0, 1) for x in (0, 1)]
            triangles += [[b[0], b[1], b[3]], [b[0], b[3], b[2]]]
    return points, triangles


def mirrored(chance):
    """A sheet whose halves share their texture, with strips without texture area."""
    points, triangles = [], []
    columns, rows = 9, 8
    for j in range(rows):
        for i in range(columns):
            x, y = i - 4, j + 0.2 * chance.uniform(-1, 1)
            v = 3 if j in (3, 4) else j  # one strip has constant v
            u = abs(x) + (0.1 * y if j != 6 else 0.3)
            normal = unit([0.2 * math.sin(x), 0.3 * math.cos(y), 1])
            points.append([x, y, math.cos(x) + 0.5 * math.sin(y)] + normal + [u, v])
            if i + 1 < columns and j + 1 < rows:
                b = j * columns + i
                triangles += [[b, b + 1, b + columns + 1], [b, b + columns + 1, b + columns]]
    triangles += [[5, 5, 14], [40, 41, 41]]  # two corners in one place
    return points, triangles


def fins(chance):
    """Three sheets that meet in one line, every corner with a point of its own."""
    points, triangles = [], []
    for sheet in range(3):
        a = 2 * math.pi * sheet / 3
        for j in range(6):
            corners = []
            for x, y in ((0, j), (1, j), (1, j + 1), (0, j + 1)):
                flip = -1 if sheet == 1 and x else 1
                normal = unit([0.1, 0.2, 1]) if x == 0 else unit([-math.sin(a), math.cos(a), 0.2])
                corners.append(
                    [x * math.cos(a), x * math.sin(a), y] + normal + [flip * x / 4, (y + x / 8) / 8]
                )
            for corner in (0, 1, 2, 0, 2, 3):
                points.append(corners[corner])
            base = len(points) - 6
            order = [base, base + 1, base + 2], [base + 3, base + 4, base + 5]
            triangles += [t if j % 2 else t[::-1] for t in order]
    return points, triangles


def tangents_of(godot, points, triangles):
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / "project.godot").write_text("config_version=4\n")
        (folder / "tangents.gd").write_text(GDSCRIPT.replace("    ", "\t"))
        numbers = [value for triangle in triangles for c in triangle for value in points[c]]
        head = struct.pack("I", 3 * len(triangles))
        (folder / "corners.bin").write_bytes(head + struct.pack(f"{len(numbers)}f", *numbers))
        subprocess.run(
            [godot, "--no-window", "--path", folder, "-s", "tangents.gd"],
            check=True,
            stdout=subprocess.DEVNULL,
            env={**os.environ, "LC_ALL": "en_US.UTF-8"},
        )
        data = (folder / "tangents.bin").read_bytes()
    values = struct.unpack(f"{len(data) // 4}f", data)
    return [[*values[i : i + 3], -values[i + 3]] for i in range(0, len(values), 4)]


def main():
    godot = sys.argv[1] if len(sys.argv) > 1 else "godot3-server"
    print("# Made by makeTangents.py from MikkTSpace's own code. NAME POINTS TRIANGLES; per point")
    print("# position, normal, texture coordinate; per triangle three points, three tangents.")
    for make in (shuffled, mirrored, fins):
        points, triangles = make(random.Random(20081))
        # Points are as short as they are written, so that both sides read the same floats.
        points = [[single(round(c, 4)) for c in point] for point in points]
        tangents = tangents_of(godot, points, triangles)
        print(make.__name__, len(points), len(triangles))
        for point in points:
            print(*(f"{c:.7g}" for c in point))
        for number, triangle in enumerate(triangles):
            flat = [c for t in tangents[3 * number : 3 * number + 3] for c in t]
            print(*triangle, *(f"{c:.5f}".rstrip("0").rstrip(".") for c in flat))


if __name__ == "__main__":
    main()
