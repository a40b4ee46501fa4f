#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the charts of `relievo bench` as PNG and SVG, from its CSV files.

Each bench has a function here that makes its charts only from the rows of its files.
chart_drawing.py draws them.
"""

import argparse
import csv
import functools
import itertools
import pathlib
import re
import sys

try:
    from chart_drawing import Axis, Chart, Series, draw, save
except ModuleNotFoundError as missing:
    if missing.name not in ("matplotlib", "numpy"):
        raise
    draw = None

NO_MATPLOTLIB = 3  # exit status
SOFTWARE = "software OpenGL"  # in renderer.txt
BENCHES = {}  # name: (its files, the function that makes its charts)
PEER = "Ring: the default. Grey: not offered."
LEAST = 1e-3  # percent, on logarithmic axes: at most two or three pixels of a picture
SUNS = ("45", "10", "3")


class BadTable(Exception):
    """A file that cannot be read, or that no bench wrote."""


def bench(*files):
    """Registers a function for the bench of its name; it gets the rows of each file."""

    def register(function):
        BENCHES[function.__name__.replace("_", "-")] = (files, function)
        return function

    return register


def read(path):
    """The rows of a file, each a dictionary."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file, restkey=""))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise BadTable(f"cannot read {path}: {error}") from error
    for line, row in enumerate(rows, 2):
        if "" in row or None in row.values():
            raise BadTable(f"{path}, line {line}: not as many fields as columns")
    return rows


def number(row, column):
    """The number in a column, or a function's result for the row; NaN if the field is empty."""
    return column(row) if callable(column) else float(row[column] or "nan")


def text(row, column):
    """The text in a column, or a function's result for the row; "" without a column."""
    return column(row) if callable(column) else row[column] if column else ""


def numbers(rows, column):
    """The distinct numbers in a column, for ticks."""
    return sorted({number(row, column) for row in rows})


def always(words):
    """A function of rows that always returns this text."""
    return lambda row: words


def panels(rows, x, y=None, *, panel="scene", method="method", name=None, default=None, line=True,
           methods=(), titles=()):  # fmt: skip
    """{title: [Series]} of rows, each a point. x to name are columns, or functions of a row.

    default: whether a row is one of the default settings; the last of them gets the ring. methods,
    titles: these and no others, in this order.
    """
    found = {title: {} for title in titles}
    for row in rows:
        title, key = text(row, panel), (text(row, method), text(row, name))
        if (titles and title not in titles) or (methods and key[0] not in methods):
            continue
        series = found.setdefault(title, {}).setdefault(key, Series(*key, line=line))
        series.default = len(series.x) if default and default(row) else series.default
        series.x.append(number(row, x))
        series.y += [number(row, y)] if y else []
    rank = {each: place for place, each in enumerate(methods)}
    return {
        title: sorted(series.values(), key=lambda each: rank.get(each.method, 0))
        for title, series in found.items()
    }


@bench("normals.csv")
def normals(rows):
    """Errors of formats of normals, by their bits and by their time."""

    def largest(row):
        return max(number(row, "max"), number(row, "max at axes and seams"))

    def took(row):
        return number(row, "encode ns") + number(row, "decode ns")

    panels_of = functools.partial(
        panels, rows, method=lambda row: row["format"].rpartition(" ")[0],
        default=lambda row: row["format"] == "octahedral 2x16")  # fmt: skip
    degrees = Axis("degrees", log=True)
    yield Chart(
        "normals-bits", "Normals: error against bits", PEER,
        Axis("bits per normal", True, (16, 20, 24, 32, 48, 96)), degrees,
        panels_of("bits", largest, panel=always("largest error"))
        | panels_of("bits", "mean degrees", panel=always("mean error")))  # fmt: skip
    yield Chart(
        "normals-time", "Normals: largest error against time on the CPU", PEER,
        Axis("nanoseconds to encode and decode, one core", True, (2, 5, 10, 20, 50, 100, 200)),
        degrees, panels_of(took, largest, panel=None))  # fmt: skip


def with_bytes(method):
    """The name of a row's method with its bytes."""
    return lambda row: f"{Series(text(row, method)).name}, {row['bytes']} B"


@bench("depth.csv")
def depth(rows):
    """Errors of formats of depth, by their bytes and by far / near."""
    panels_of = functools.partial(
        panels, rows, panel=None, method="format",
        default=lambda row: row["format"] == "R32F, linear")  # fmt: skip
    error = Axis("largest relative error", log=True)
    yield Chart(
        "depth-bytes", "Depth: largest relative error, by format and bytes per pixel",
        PEER + " Marks: far / near = 1e2, 1e3, 1e4, 1e5, 1e6.", error, Axis(),
        panels_of("max", name=with_bytes("format")), kind="dots")  # fmt: skip
    yield Chart(
        "depth-ratio", "Depth: largest relative error against far / near", PEER,
        Axis("far / near", log=True), error, panels_of("far/near", "max"))  # fmt: skip


@bench("position.csv")
def position(rows):
    """Errors of positions, by stored format and by the time of a frame."""
    alike = {"depth R16F": "R16F, scaled by 2^k", "depth R32F": "R32F, linear",
             "depth R32F + id, refined": "R32F and id, refined"}  # fmt: skip
    scenes = {"origin": "scene at the origin", "(5e5, 5e6, 0)": "scene at (5e5, 5e6, 0)"}

    def method(row):
        format_ = row["format"].removesuffix(" *")  # marks what is not offered
        return alike.get(format_, format_)

    panels_of = functools.partial(
        panels, [row for row in rows if row["projection"] == "perspective"], method=method,
        panel=lambda row: scenes.get(row["scene at"]), titles=tuple(scenes.values()),
        default=lambda row: method(row) == "R32F and id, refined")  # fmt: skip
    pixels = Axis("pixels", log=True)
    yield Chart(
        "position-bytes", "Positions: largest error by stored format", PEER + " Perspective.",
        pixels, Axis(), panels_of("max", name=with_bytes(method)), kind="dots")  # fmt: skip
    yield Chart(
        "position-time", "Positions: largest error against frame time",
        PEER + " Their frames are timed with layers of as many bytes.",
        Axis("times a plain frame, software OpenGL"), pixels,
        panels_of("times a plain frame", "max"), columns=1)  # fmt: skip


@bench("gbuffer.csv")
def gbuffer(rows):
    """Frames with layers."""
    shown = [row for row in rows if row["pixels"] == "1920x1080" and row["frame"] != "plain"]
    yield Chart(
        "gbuffer", "Frames of 1920 x 1080 pixels with layers",
        "Software OpenGL. Grey: the peer, with a kernel of one sample.",
        Axis("times a plain frame", ticks=(0, 1, 2, 3)), Axis(),
        panels(shown, "times a plain frame", method="frame"), kind="bars")  # fmt: skip


@bench("effects.csv")
def effects(rows):
    """Frame times by effect; those of a GPU by its own clock."""
    plain = {row["scene"]: row for row in rows if row["frame"] == "plain"}
    on_gpu = any(row["GPU ms"] for row in rows)

    clock = "its own time." if on_gpu else "processor time of all threads."

    def times(row):
        return number(row, "GPU ms") / number(plain[row["scene"]], "GPU ms")

    yield Chart(
        "effects", "Cost of effects per frame",
        f"The first of each effect, and several. Grey: VTK's passes. Software OpenGL, {clock}",
        Axis("times a plain frame"), Axis(),
        panels([row for row in rows if row["frame"] != "plain"],
               times if on_gpu else "times the plain frame's",
               method=lambda row: "VTK's shading" if row["frame"].startswith("vtk") else "Relievo",
               name="frame"), kind="bars", columns=2)  # fmt: skip


@bench("f3d.csv")
def f3d(rows):
    """The first picture and the further frames of other viewers, by bench/f3d_frames.py."""
    steps = {"first picture": "from the start to the first picture", "frame": "a further frame"}
    for step, title in steps.items():
        yield Chart(
            f"f3d-{step.split()[0]}", f"A file beside F3D: {title}",
            "Software OpenGL, 1280 x 720 pixels, processor time. Grey: F3D, with its own look.",
            Axis("milliseconds of processor time"), Axis(),
            panels([row for row in rows if row["step"] == step], "processor milliseconds",
                   panel="file", method="program"), kind="bars")  # fmt: skip


@bench("studio.csv")
def studio(rows):
    """Errors of the default preset against its time, by bench/studio_samples.py."""
    yield Chart(
        "studio", "The default preset: error at edges and in penumbras against time",
        "Lower and further left is better. Points: 4, 8, 16, 24 and 48 samples. Ring: the default. "
        "Software OpenGL.",
        Axis("seconds of processor time more than --preset none", True, (0.3, 1, 3, 10)),
        Axis("rms, levels of 255", True, (1, 2, 5, 10, 20)), panels(
            rows, "seconds more than none", "rms levels", method="samples",
            default=lambda row: row["samples"] == "at once" and row["count"] == "24",
            methods=("at once", "one by one")), columns=2)  # fmt: skip


@bench("readable.csv")
def readable(rows):
    """Errors of the colours of values, by bench/readable_colors.py."""
    yield Chart(
        "readable", "Colours of values in lit pictures against those of the colour bar",
        "CIEDE2000 over the pixels of the surface. Points: viridis and cool-warm. Lower and "
        "further left is better. Ring: the default.",
        Axis("median"), Axis("95th percentile"), panels(
            rows, "median", "p95", default=lambda row: row["method"] == "studio", line=False,
            methods=("studio", "studio, before", "VTK's headlight")))  # fmt: skip


@bench("compare.csv")
def compare(rows):
    """Faults found by comparisons of pictures against false alarms, by bench/compare.py."""
    shown = sorted((row for row in rows if row["role"] != "best"),
                   key=lambda row: (number(row, "false alarms %"), number(row, "detected %")))
    yield Chart(
        "compare", "Comparisons: visible faults that are detected against false alarms",
        "Each curve: all limits of a method. Ring: its recommended limit. Further left and up is "
        "better.",
        Axis("false alarms, % of changes without a fault"), Axis("detected, % of visible faults"),
        panels(shown, "false alarms %", "detected %", panel=None,
               default=lambda row: row["role"] == "recommended"))  # fmt: skip


@bench("scale.csv")
def scale(rows):
    """Time and memory of whole commands by the size of the scene, by bench/scale.py."""
    shown = [row for row in rows if row["seconds more"]]  # without the empty starts
    for stem, title, column, unit in (
        ("scale", "Growth of processor time with the scene", "processor seconds",
         Axis("processor seconds", True, (0.1, 0.3, 1, 3, 10, 30))),
        ("scale-memory", "Growth of memory with the scene", "MiB",
         Axis("peak MiB", True, (50, 100, 300, 1000, 3000))),
    ):  # fmt: skip
        yield Chart(
            stem, title, "Whole commands, software OpenGL. Lower and flatter is better. "
            "Ring: the default preset. Grey: others.",
            Axis("count", True), unit,
            panels(shown, "size", column, panel="series",
                   default=lambda row: row["method"] == "Relievo, studio"),
            columns=2, own_x=True)  # fmt: skip


@bench("shadows.csv")
def shadows(rows):
    """Wrong verdicts by the size of the map, and by the time of a frame."""
    shown = [row for row in rows if row["window"] == "600x600" and row["shading"] == "flat"]
    share = Axis("wrong verdicts, % of pixels", True,
                 {LEAST: "< 0.001", 0.01: "0.01", 0.1: "0.1", 1: "1", 10: "10"})  # fmt: skip
    low = "sun at 10 degrees"
    sizes = Axis("side of the map, texels", True, (512, 1024, 2048, 4096))
    times = Axis("milliseconds of a frame whose light moves, maps of 512 to 4096", True,
                 (10, 100, 1000))  # fmt: skip
    for stem, title, scenes, axis, x in (
        ("meshes", "Wrong shadows under the sun, real meshes",
         {("bunny", "sun"): "bunny", ("motorBike", "sun"): "motorBike",
          ("buildings", "sun"): "buildings"}, sizes, "map"),
        ("lights", "Wrong shadows of other lights, motorBike",
         {("motorBike", low): "sun at 10°", ("motorBike", "spot"): "spot",
          ("motorBike", "point"): "point"}, sizes, "map"),
        ("coded", "Wrong shadows under the sun, scenes made by code",
         {("spheres", "sun"): "spheres", ("horizon", "sun"): "poles to the horizon",
          ("horizon", low): "the same, sun at 10°"}, sizes, "map"),
        ("time", "Wrong shadows under the sun against frame time, software OpenGL",
         {("bunny", "sun"): "bunny", ("motorBike", "sun"): "motorBike",
          ("horizon", low): "horizon, sun at 10°"}, times, "moving ms"),
    ):  # fmt: skip
        yield Chart(
            f"shadows-{stem}", title,
            "Ring: the default, a map of 2048. exact has no map. Grey, VTK: vtkShadowMapPass.",
            axis, share, panels(
                shown, x, lambda row: max(LEAST, number(row, "wrong %")),
                panel=lambda row: scenes.get((row["scene"], row["light"])),
                default=lambda row: row["method"] == "map" and row["map"] == "2048",
                titles=tuple(scenes.values()),
                methods=("map", "warped", "forward", "exact", "vtkShadowMapPass")))  # fmt: skip


@bench("soft-shadows.csv")
def soft_shadows(rows):
    """Errors by samples."""
    yield Chart(
        "soft-shadows", "Soft shadows: error in the penumbra against samples",
        "Lower is better. rms of the light's share, against rays to all of the light.",
        Axis("samples", True, numbers(rows, "samples")),
        Axis("rms error of pixels in the penumbra", log=True),
        panels(rows, "samples", "penumbra rms",
               panel=lambda row: f"{row['scene']}, {row['light']}" +
               (f" of {row['size']}" if row["light"] == "point" else "")))  # fmt: skip


@bench("volumes.csv")
def volumes(rows):
    """Errors of the light through volumes by the processor's time."""
    shown = [row for row in rows if row["size"] == "128"]
    titles = {name: name for name in ("box", "ramp", "ball", "waves")}
    yield Chart(
        "volumes", "Light through volumes of 128³ voxels: error against time",
        "Ring: the default. rms over places in and behind the volume. Without a grid: for each "
        "pixel of 600 × 600.",
        Axis("milliseconds of the processor", log=True),
        Axis("rms error of the light's share", log=True),
        panels(
            shown, "milliseconds", lambda row: max(1e-7, number(row, "rms")),
            panel=lambda row: titles[row["scene"]], titles=tuple(titles),
            methods=("grid", "Fourier terms", "march", "exact"),
            default=lambda row: row["method"] == "grid" and row["setting"] == "256"))


@bench("empty-space.csv")
def empty_space(rows):
    """How much faster volumes are drawn, by the share of visible voxels."""
    yield Chart(
        "empty-space", "Volumes of 128³ voxels whose transparent parts are skipped",
        "Processor time of VTK's frame over that of the frame that skips. 1: as fast as VTK's.",
        Axis("visible voxels, %", True, numbers(rows, "visible %")),
        Axis("times as fast as VTK", log=True, ticks=(1, 2, 4, 8, 16)),
        panels(rows, "visible %", "times faster", panel="kind", method="shape"))  # fmt: skip


@bench("exact-hard.csv")
def exact_hard(rows):
    """Errors of exact shadows where edges lie densely."""
    columns = {"with ties": "wrong %", "without ties": "wrong without ties %",
               "expected": "expected %"}  # fmt: skip
    shown = [{"scene": row["scene"], "share": share, "%": row[column]}
             for row in rows if row["light"] == "sun"
             for share, column in columns.items()]  # fmt: skip
    yield Chart(
        "exact-hard", "Exact shadows where edges lie densely, under the sun",
        "Ties: OpenGL's grid decides which side of an edge a pixel shows. Grey: expected errors.",
        Axis("wrong verdicts, % of pixels"), Axis(), panels(shown, "%", method="share"),
        kind="bars")  # fmt: skip


@bench("ambient.csv")
def ambient(rows):
    """Errors by the time of a frame."""
    titles = {"bunny": "the bunny on a ground", "room": "a room"}
    yield Chart(
        "ambient", "Ambient occlusion: error against the time of a frame",
        "Lower left is better. Along a curve 1, 4, 16, 64 and 256 rays of each pixel, or samples.",
        Axis("milliseconds of a frame", log=True), Axis("rms error of the share", log=True),
        panels(rows, "milliseconds", "rms",
               panel=lambda row: titles[row["scene"]]))  # fmt: skip


@bench("planner.csv", "planner-choices.csv", "planner-times.csv", "planner-budgets.csv")
def planner(errors, choices, times, budgets):
    """Measured against expected errors and times, and the planner's choices."""
    percents = (0.001, 0.01, 0.1, 1)
    ways = ("map", "warped", "exact")
    for stem, title, note, rows, methods, x, y, ends, name, axes in (
        ("error", "Shadows: measured errors against errors expected before drawing",
         "Each mark is a scene, light, window and map size. Below the line: better than expected.",
         errors, ("map", "warped"), "expected wrong %", "wrong %", [0.003, 3], "as expected",
         ("expected, % of pixels", "measured, % of pixels", percents)),
        ("choice", "Shadows: errors of the choice for a tolerance",
         "Each mark is a scene, light and window. Without an error: not shown.",
         choices, ways, "tolerance %", "wrong %", [0.003, 0.3], "tolerance",
         ("tolerance, % of pixels", "measured, % of pixels", percents)),
        ("time", "Shadows: frame time against the time expected after ten frames",
         "Each mark is a scene, light and window; the light moves.",
         times, ways, "expected ms", "taken ms", [10, 1000], "as expected",
         ("expected, milliseconds", "taken, milliseconds", ())),
        ("budget", "Shadows: frame time of the choice for a time budget, after ten frames",
         "Each mark is a scene, light, window and budget; the light moves. Below: in time.",
         budgets, ways, "budget ms", "taken ms", [10, 1000], "budget",
         ("time budget, milliseconds", "taken, milliseconds", ())),
    ):  # fmt: skip
        found = panels(rows, x, y, panel=None, line=False, methods=methods, titles=("",))
        found[""].append(Series("plain", name, ends, ends))
        yield Chart(f"planner-{stem}", title, note, Axis(axes[0], True, axes[2]),
                    Axis(axes[1], True, axes[2]), found)  # fmt: skip


@bench("bias.csv")
def bias(rows):
    """Wrong verdicts by the bias, and false shadow and leak."""
    note = ("Ring: the default, 1.5 texels. Grey, VTK: vtkShadowMapPass, which has no bias to set. "
            "Maps of 2048.")  # fmt: skip
    peer = "vtkShadowMapPass"
    panels_of = functools.partial(
        panels, methods=("map", "constant, computed", peer),
        default=lambda row: row["method"] == "map" and number(row, "bias, texels") == 1.5)
    scenes = ("bunny", "motorBike", "slabs")
    level = [row | {"bias, texels": end}  # the peer's, from one side to the other
             for row in rows if row["method"] == peer for end in ("0.25", "16")]  # fmt: skip
    yield Chart(
        "bias-wrong", "Wrong shadows against the bias", note,
        Axis("bias, texels", True, (0.25, 0.5, 1, 2, 4, 8, 16)),
        Axis("wrong verdicts, % of pixels", log=True),
        panels_of(
            [row for row in rows if row["method"] != peer] + level, "bias, texels", "wrong %",
            panel=lambda row: f"{row['scene']}, sun at {row['sun, degrees']}°",
            titles=[f"{scene}, sun at {sun}°" for sun in SUNS for scene in scenes]))  # fmt: skip
    powers = {0.01: "0.01", 0.1: "0.1", 1: "1", 10: "10", 100: "100"}
    for sun in SUNS:
        yield Chart(
            f"bias-{sun}", f"False shadow against leak, sun at {sun}°, bias from 0 to 16 texels",
            note, Axis("leak, % of dark pixels", True, powers),
            Axis("false shadow, % of lit pixels", True, {LEAST: "0"} | powers),
            panels_of(
                [row for row in rows if row["sun, degrees"] == sun],
                lambda row: max(LEAST, number(row, "leak % of dark")),
                lambda row: max(LEAST, number(row, "false shadow % of lit")),
                titles=scenes))  # fmt: skip


@bench("lights.csv")
def lights(rows):
    """Frame times by the number of lamps, and the number of lamps computed in vain."""
    few = [row for row in rows if row["size"] == "few"]
    for stem, title, column, ways in (
        ("frames", "Frames with lamps that all move", "times a plain frame",
         ("quads", "clusters", "every lamp", "VTK's lights")),
        ("computed", "Lamps computed for a pixel, against those that reach it",
         "computed / reaching", ("quads", "clusters")),
    ):  # fmt: skip
        yield Chart(
            f"lights-{stem}", title, "1.3 to 1.8 reach a pixel from 10 lamps on. Default: quads up "
            "to 8 lamps in sight, then clusters. Grey: VTK.",
            Axis("lamps", True, {1: "1", 100: "100", 1e4: "10 000"}),
            Axis(column, True, (1, 2, 5, 10, 100)),
            panels(few, "lamps", column, method="way", methods=ways,
                   titles=("bunny", "motorBike", "buildings")))  # fmt: skip


@bench("deferred.csv")
def deferred(rows):
    """Frame times by the overdraw of pixels."""
    yield Chart(
        "deferred", "Deferred shading by how often a pixel is drawn",
        "Matte surfaces that fill the window, the farthest first. Grey: VTK's own shading.",
        Axis("surfaces behind a pixel", True, (1, 2, 4, 8, 16)),
        Axis("milliseconds per frame", True, (5, 10, 20, 50, 100, 200, 500, 1000, 2000)),
        panels([row for row in rows if row["surface"] == "matte"], "overdraw", "milliseconds",
               method="way", methods=("deferred", "VTK's shading"),
               panel=lambda row: row["lights"] + (" light" if row["lights"] == "1" else " lights"),
               titles=("1 light", "8 lights", "32 lights")))  # fmt: skip


@bench("relief.csv")
def relief(rows):
    """Errors by reads of the heights and by time, and missed posts."""

    def method(row):  # of "relief 16", or "relief, by texels (default)"
        return row["method"].replace(",", " ").split()[0]

    def by_texels(row):
        return f"{method(row)}, by texels" if "by texels" in row["method"] else ""

    def error(row):  # misses count as errors of 5 % of the height
        missed = 0.01 * number(row, "missed %")
        return 0.01 * number(row, "depth error % of height") * (1 - missed) + 0.05 * missed

    panels_of = functools.partial(
        panels, panel=None, method=method, default=lambda row: "(default)" in row["method"])
    waves = [row for row in rows if row["field"] == "waves" and row["degrees"] == "60"]
    posts = [
        row for row in rows
        if row["field"] != "waves" and (method(row) == "relief" or by_texels(row))
    ]  # fmt: skip
    for stem, against, axis, x in (
        ("error", "reads of the heights",
         Axis("reads of the heights per pixel", True, (1, 2, 5, 10, 20, 50)), "looks"),
        ("cost", "frame time", Axis("times a plain frame, software OpenGL"),
         "times a plain frame (waves, 60)"),
    ):  # fmt: skip
        yield Chart(
            f"relief-{stem}", f"Relief: depth error against {against}, waves at 60 degrees",
            "Along a curve: 16, 32, 64 steps. Ring: the default, steps by the texels passed over.",
            axis, Axis("mean depth error, share of the relief's height", log=True),
            panels_of(waves, x, error, name=by_texels,
                      methods=("parallax", "steep", "occlusion", "relief")))  # fmt: skip
    yield Chart(
        "relief-missed", "Relief: missed thin posts",
        "Posts 4 texels thin. Ring: the default.",
        Axis("degrees off the normal", ticks=(0, 15, 30, 45, 60, 75)), Axis("% of pixels"),
        panels_of(posts, "degrees", "missed %",
                  name=lambda row: by_texels(row) or f"{row['method']} steps"))  # fmt: skip


@bench("environment.csv", "environment-angle.csv")
def environment(sizes, angles):
    """Errors by texels and by angle."""
    panels_of = functools.partial(
        panels, y="RMS error / mean light", panel="environment",
        method=lambda row: {"octahedral": "octahedral map"}.get(row["map"], row["map"]),
        default=lambda row: row["map"] == "cube")  # fmt: skip
    error = Axis("RMS error / mean light", log=True)
    texels = next((row["texels"] for row in angles), "no")  # about; of the first map
    yield Chart("environment-texels", "Environments: error against texels", "Ring: the default.",
                Axis("texels", log=True), error, panels_of(sizes, "texels"))  # fmt: skip
    yield Chart(
        "environment-angle", f"Environments: error by angle, {texels} texels",
        "Ring: the default.", Axis("degrees from the map's axis (of lat-long: from its pole)",
                                   ticks=range(0, 181, 30)),
        error, panels_of(angles, "degrees"))  # fmt: skip


@bench("tone-curves.csv", "tone-bands.csv")
def tone(curves, bands):
    """Displayed values of operators, and the bands of a gradient."""
    panels_of = functools.partial(panels, curves, "stops", method="operator")
    yield Chart(
        "tone-curves", "Tone operators: displayed value against light",
        "White at 4, where the Reinhard curves end: 2 stops.",
        Axis("light, stops above 1", ticks=range(-6, 7, 2)), Axis("shown, steps of 255"),
        panels_of("grey, steps of 255", panel=always("grey light"))
        | panels_of("red's green, steps of 255",
                    panel=always("red light: how much green is shown")))  # fmt: skip
    yield Chart(
        "tone-bands", "A gradient of four steps of 255", "Means over 16 x 64 pixels.",
        Axis("value, steps of 255"), Axis("mean of the picture - value, steps of 255"),
        panels(bands, "value, steps of 255", "mean error, steps of 255", panel=None,
               method="dither"))  # fmt: skip


@bench("fog.csv", "fog-frames.csv")
def fog(chords, frames):
    """Errors of a sphere's chord by distance, and frames by the number of spheres."""
    yield Chart(
        "fog-error", "Fog: largest error of a sphere's chord",
        "All rays that meet the sphere, its outline included.",
        Axis("distance of the eye, in radii", log=True), Axis("error, in radii", log=True),
        panels(chords, "distance / radius", "max", panel=None))  # fmt: skip
    yield Chart(
        "fog-frames", "Frames with fog, by the number of spheres",
        "Each sphere covers a hundredth of the picture. Software OpenGL.",
        Axis("spheres", True, (1, 10, 100, 1000)), Axis("times a plain frame"),
        panels([row for row in frames if number(row, "share of the picture each") == 0.01],
               "spheres", "times a plain frame", method=always("pairs of floats"),
               name=always("fog")))  # fmt: skip


@bench("blocks.csv")
def blocks(rows):
    """Surfaces of labels: errors by time, of the largest images."""
    most = max(numbers(rows, "blocks"))
    for stem, title, axis, column in (
        ("distance", "largest distance to the shape", "Hausdorff distance, blocks",
         "hausdorff blocks"),
        ("normals", "error of normals", "rms error, degrees", "rms normal degrees"),
    ):  # fmt: skip
        yield Chart(
            f"blocks-{stem}", f"Surfaces of blocks: {title}", "Lower left is better. Ring: the "
            f"default. One thread, {most:.0f} blocks each way.",
            Axis("milliseconds per million blocks", log=True), Axis(axis),
            panels([row for row in rows if number(row, "blocks") == most], "ms per million blocks",
                   column, panel="shape", line=False,
                   default=lambda row: row["method"] == "smooth blocks"))  # fmt: skip


@bench("caves.csv", "caves-width.csv")
def caves(rows, widths):
    """Evaluations of noise, and the width of tunnels."""
    yield Chart(
        "caves-evaluations", "Caves: evaluations of noise",
        "Lower is better. Same masks; tunnels a tenth of a cell wide. Ring: the default.",
        Axis("samples across a cell of the noise (Scale)", True, (16, 32, 64, 128, 256)),
        Axis("evaluations per sample"),
        panels(rows, "scale samples", "evaluations per sample", panel=None,
               methods=("naive", "classic", "skipping"), default=lambda row: (
                   row["method"] == "skipping" and number(row, "scale samples") == 64)))
    panels_of = functools.partial(panels, widths, "width asked", panel=None, titles=("",))
    yield Chart(
        "caves-width", "Caves: width of tunnels",
        "1: as asked. Mean length of air along level lines, and twice that along upright ones.",
        Axis("width asked, part of Scale"), Axis("measured over asked"),
        {"": panels_of("level over asked", method=always("level lines"))[""]
         + panels_of("twice upright over asked", method=always("upright lines"))[""]})  # fmt: skip


@bench("voxels.csv")
def voxels(rows):
    """Wrong cells by time, and time by cells."""
    judged = [row for row in rows if row["excess percent"]]
    yield Chart(
        "voxels-wrong", "Cells inside bodies: wrong cells against time",
        "Lower left is better. Each mark is a grid, from coarse to fine. Ring: the default.",
        Axis("milliseconds", log=True), Axis("excess and missed, % of the cells inside"),
        # The modeller marks cells near the surface instead of those inside: it exceeds this scale.
        panels([row for row in judged if row["method"] != "vtkVoxelModeller"], "milliseconds",
               lambda row: number(row, "excess percent") + number(row, "missed percent"),
               panel="body", default=lambda row: row["method"] == "parity"))  # fmt: skip
    found = panels(judged, "cells", "milliseconds", panel="body")
    last = dict(list(found.items())[-1:])  # a real mesh if there is one; one body is enough
    yield Chart(
        "voxels-time", "Cells inside bodies: time by size of the grid", "Lower is better.",
        Axis("cells along the longest side", True, numbers(judged, "cells")),
        Axis("milliseconds", log=True), last)  # fmt: skip


@bench("rays.csv")
def rays(rows):
    """Rays per second, and bytes, by triangles of the subdivided bunny."""
    rows = [row for row in rows if row["mesh"] == "bunny"]
    for row in rows:
        row["thousands"] = str(round(number(row, "triangles") / 1000))
    triangles = Axis("thousand triangles of the bunny", True, numbers(rows, "thousands"))
    titles = {"nearest": "the first hit", "any": "any hit"}
    yield Chart(
        "rays-speed", "Rays at a mesh, on one core",
        "Higher is better. Incoherent rays, ours given at once. Embree's hits are floats.",
        triangles, Axis("million rays per second"),
        panels(rows, "thousands", "million rays per second",
               panel=lambda row: titles[row["answer"]]))
    yield Chart(
        "rays-bytes", "Rays at a mesh: memory",
        "Lower is better. Includes the triangles themselves.",
        triangles, Axis("bytes per triangle"),
        panels([row for row in rows if row["answer"] == "nearest"], "thousands",
               "bytes per triangle", panel=None))  # fmt: skip


@bench("sun.csv")
def sun(rows):
    """Errors of hours of sun and of the sky, by time."""
    yield Chart(
        "sun", "A courtyard's floor: error against time",
        "Lower left is better. Along the curves steps of 60 to 2 minutes, and 4 to 4096 rays.",
        Axis("core milliseconds for 2304 places", log=True),
        Axis("rms error: hours, share", log=True),
        panels(rows, "core milliseconds", "rms", panel="of"))


@bench("irradiation.csv")
def irradiation(rows):
    """Errors of irradiation and of their bounds, by time."""
    shown = [row for row in rows if row["scene"] in ("courtyard", "canyon")]
    bounds = [{**row, "method": "bound", "largest error %": row["largest bound %"]}
              for row in shown if row["largest bound %"]]
    yield Chart(
        "irradiation", "Light of a uniform sky on a floor: error against time",
        "Lower left is better. Along the curves a tolerance of 10 to 0.2 %, and 16 to 4096 rays. "
        "Ring: the default.",
        Axis("processor milliseconds for 2304 places", log=True),
        Axis("largest error or bound, %", log=True),
        panels([*shown, *bounds], "processor milliseconds", "largest error %",
               default=lambda row: row["method"] == "tolerance" and row["setting"] == "1"))


@bench("scaling-out.csv")
def scaling_out(rows):
    """Parts of one job, by bench/scaling_out.py."""
    rows = [row for row in rows if row["subject"] == "part"]
    yield Chart(
        "scaling-out", "One part of hours of sun: processor time",
        "Lower is better. Part 1, with a shared file of the tree. The model is a + b / processes.",
        Axis("processes, each with one part", True, numbers(rows, "number")),
        Axis("processor seconds"),
        panels(rows, "number", "processor seconds", panel=None))  # fmt: skip


@bench("many-views.csv")
def many_views(rows):
    """Time and memory of cameras and views, by bench/many_views.py."""

    def scene(row):
        triangles = f"{round(number(row, 'triangles'), -3):,.0f}".replace(",", " ")
        subject = "cells seen" if row["subject"] == "cameras" else f"views {row['columns']} wide"
        return f"{subject}, {triangles} triangles"

    def each(row):
        return 1000 * number(row, "processor seconds") / number(row, "number")

    measured = [row for row in rows if row["kind"] == "measured"]
    for stem, title, note, unit, column in (
        ("many-views", "Many cameras and views: processor time of each",
         "Level curves: time grows in proportion.",
         Axis("processor milliseconds each", log=True), each),
        ("many-views-memory", "Many cameras and views: memory",
         "The peak during the call, more than before it. Less than 1 MiB is left out.",
         Axis("MiB", log=True), "MiB"),
    ):  # fmt: skip
        yield Chart(stem, title, f"Lower is better. {note} Grey: others.",
                    Axis("cameras or views", True), unit,
                    panels(measured, "number", column, panel=scene), columns=2)  # fmt: skip


@bench("viewshed.csv")
def viewshed(rows):
    """Time of viewsheds, and their differences from lines of sight, by bench/viewshed.py."""
    rows = [{**row, "millions": str(number(row, "cells") / 1e6)} for row in rows]
    cells = Axis("million cells of the raster", True, (0.25, 1, 4))
    yield Chart(
        "viewshed", "Viewsheds of one observer: processor time", "Lower is better. Whole commands.",
        cells, Axis("processor seconds", True, (0.1, 0.3, 1, 3, 10, 30)),
        panels(rows, "millions", "processor seconds", panel=None))
    titles = {"differs from triangles, %": "through the triangles",
              "differs from bilinear, %": "through the bilinear surface"}  # fmt: skip
    each = [{**row, "surface": title, "%": row[column]}
            for column, title in titles.items() for row in rows]  # fmt: skip
    yield Chart(
        "viewshed-difference", "Viewsheds: cells with another verdict than lines of sight",
        "Lower is better. Both surfaces go through the raster's heights.", cells,
        Axis("% of 2000 cells"), panels(each, "millions", "%", panel="surface"))  # fmt: skip


@bench("skin-keys.csv", "skin-volume.csv", "skin.csv")
def skin(keys, volumes, times):
    """Errors of motions by their keys, a tube's volume, and the time of points."""
    error = "largest error of the arm's end, arm's lengths"
    yield Chart(
        "skin-keys", "A turning arm, by the keys of its motion",
        "Lower is better. Slerp's error of one turn a second is rounding, and not drawn.",
        Axis("keys per second", True, (4, 8, 15, 30, 60, 120)), Axis(error, log=True),
        panels([row for row in keys if number(row, error) > 1e-9], "keys per second", error,
               panel="motion"))  # fmt: skip
    yield Chart(
        "skin-volume", "Volume of a tube between two bones",
        "100 is right. The bones share the middle half of the tube.",
        Axis("degrees", ticks=range(0, 181, 45)), Axis("volume, % of the rest"),
        panels(volumes, "degrees", "volume, % of the rest", panel="motion"))  # fmt: skip
    yield Chart(
        "skin", "Skinning a million points, by the number of bones",
        "Lower is better. Four weights a point, points and normals.",
        Axis("bones", True, (4, 32, 100, 1000)), Axis("ms", log=True),
        panels(times, "bones", "ms per million points", panel=None, method=lambda row: (
            row["method"] if row["on"] == "CPU" else f"{row['method']}, {row['on']}")))


@bench("particles.csv", "particles-drift.csv")
def particles(times, drifts):
    """Time of a step by the number of particles, and their drift."""
    yield Chart(
        "particles-time", "Particles on surfaces: time of a step",
        "Lower is better. Sum over all cores.", Axis("particles", log=True),
        Axis("core milliseconds", log=True),
        panels(times, "particles", "core milliseconds", panel="body"))  # fmt: skip
    yield Chart(
        "particles-drift", "Particles on surfaces: largest distance to the surface",
        "Lower is better. By vtkStaticCellLocator.", Axis("steps", log=True),
        Axis("texels", log=True), panels(drifts, "steps", "largest texels", panel="body"))


def find(folder, file):
    """The path of a table in a folder, or in one of its rooms: folders in it whose tables are of
    the same renderer."""
    rooms = (path.parent for path in sorted(folder.glob(f"*/{file}")))
    inside = [room for room in rooms if read_renderer(room) == read_renderer(folder)]
    return next((each / file for each in (folder, *inside) if (each / file).exists()),
                folder / file)  # fmt: skip


def read_renderer(folder):
    """The renderer of the frames in a folder's tables; empty: software OpenGL."""
    file = folder / "renderer.txt"
    name = file.read_text(encoding="utf-8").split("\n")[0] if file.exists() else ""
    return "" if name == SOFTWARE else name


def charts_of(name, folder):
    """The charts of a bench from its files in a folder or its rooms, naming the renderer."""
    files, function = BENCHES[name]
    rows = [read(find(folder, file)) for file in files]
    try:
        charts = list(function(*rows))
    except (KeyError, ValueError) as error:  # an unknown column or method, or an invalid number
        raise BadTable(f"{folder}: {', '.join(files)}: not written by the current {name}, "
                       f"{error!r}; measure it again") from error  # fmt: skip
    renderer = read_renderer(folder)
    for chart in charts if renderer else ():
        for part, field in itertools.product((chart, chart.x, chart.y), ("title", "note")):
            words = getattr(part, field, "")
            setattr(part, field, re.sub("[Ss]oftware OpenGL", lambda _: renderer, words))
    return charts


def parse(words):
    """Parses the command line; ends the program if it is wrong."""
    parser = argparse.ArgumentParser(
        description=__doc__.split("\n")[0],
        epilog="Exit status: 0; 1 if a file cannot be read or written; 2 for a wrong call; "
        f"{NO_MATPLOTLIB} without matplotlib (Debian's python3-matplotlib).")  # fmt: skip
    parser.add_argument("folder", metavar="FOLDER", type=pathlib.Path,
                        help="folder of the CSV files, or of folders of them")  # fmt: skip
    parser.add_argument("names", metavar="NAME", nargs="*",
                        help="a bench; default: all benches with CSV files in FOLDER")  # fmt: skip
    parser.add_argument("--out", metavar="DIR", type=pathlib.Path,
                        help="output folder (default: that of the CSV files)")  # fmt: skip
    call = parser.parse_intermixed_args(words)
    for name in call.names:  # a bench may have no charts
        if name not in BENCHES and not find(call.folder, f"{name}.csv").exists():
            parser.error(f"no bench '{name}'; benches with charts: {', '.join(BENCHES)}")
    call.names = [name for name in call.names if name in BENCHES] if call.names else [
        name for name, (files, _) in BENCHES.items()
        if all(find(call.folder, file).exists() for file in files)
    ] or parser.error(f"'{call.folder}' has no CSV files of a bench")  # fmt: skip
    return call


def main(words):
    """Returns the exit status."""
    call = parse(words)
    if call.names and not draw:
        print("charts.py: needs matplotlib, Debian's python3-matplotlib", file=sys.stderr)
        return NO_MATPLOTLIB
    try:
        charts = [(call.out or find(call.folder, BENCHES[name][0][0]).parent, chart)
                  for name in call.names for chart in charts_of(name, call.folder)]  # fmt: skip
        for out, chart in charts:
            out.mkdir(parents=True, exist_ok=True)
            save(draw(chart), out / chart.stem)
    except (BadTable, OSError) as error:
        print(f"charts.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
