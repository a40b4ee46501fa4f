# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""bench/charts.py draws the committed tables: each chart's points are compared with its CSV file,
as read here; a method looks alike in all charts; words overlap nowhere; and two runs make equal
bytes, those that are committed."""

import collections
import contextlib
import csv
import io
import itertools
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import warnings

try:
    import matplotlib
    from matplotlib.image import imread
    from matplotlib.text import Text
except ImportError:
    print("matplotlib is missing")
    sys.exit(125)

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "bench" / "charts.py"
TABLES = ROOT / "docs" / "charts"
sys.path.insert(0, str(SCRIPT.parent))
import chart_drawing  # noqa: E402
import charts  # noqa: E402

# Tables that no chart shows.
UNSHOWN = {
    "blocks-labels", "blocks-labels-vtk97", "blocks-threads", "blocks-vtk97", "capture",
    "command-start", "compare-faults", "compare-frames",
    "environment-frames", "lamp-shadows", "lights-peer", "many-frames", "normal-maps",
    "paraview-frames", "planner-cases", "relief-geometry", "shadow-frames", "tone",
    "tone-dither", "tone-frames", "volume-frames",
}  # fmt: skip


def committed(pattern):
    """The paths of such files in the rooms of docs/charts, by name; no name is in two rooms."""
    paths = [path for path in TABLES.glob(f"*/{pattern}") if path.parent.name != "gpu"]
    assert len({path.name for path in paths}) == len(paths)
    return {path.name: path for path in paths}


def rows(table):
    with open(committed("*.csv")[f"{table}.csv"], encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def points(table, panel, method, x, y, default=None, where=lambda row: True):
    """[panel, method, x, y, whether it has a ring] of the rows of a table. Each is a column in
    brackets, or words, or a function of a row."""

    def said(row, of):
        if callable(of):
            return of(row)
        return row[of[1:-1]] if of.startswith("[") else of

    return [
        (said(row, panel), said(row, method), said(row, x), said(row, y),
         bool(default and default(row)))
        for row in rows(table) if where(row)
    ]  # fmt: skip


def normals(title, x, y):
    return points(
        "normals", title, lambda row: re.sub(r" \S+$", "", row["format"]), x, y,
        lambda row: row["format"] == "octahedral 2x16")  # fmt: skip


def largest_normal(row):
    return max(float(row["max"]), float(row["max at axes and seams"]))


FORMATS = {"depth R16F": "R16F, scaled by 2^k", "depth R32F": "R32F, linear",
           "depth R32F + id, refined": "R32F and id, refined"}  # fmt: skip


def position_format(row):
    return FORMATS.get(row["format"], row["format"].replace(" *", ""))


def position(x, y):
    return points(
        "position", lambda row: "scene at " + row["scene at"].replace("origin", "the origin"),
        position_format, x, y,
        lambda row: row["format"] == "depth R32F + id, refined",
        lambda row: row["projection"] == "perspective")  # fmt: skip


def f3d(step):
    return points("f3d", "[file]", "[program]", "[processor milliseconds]", "[program]", None,
                  lambda row: row["step"] == step)  # fmt: skip


def millions(row):
    return float(row["cells"]) / 1e6


def scale(column):
    """The last point of each of the default's curves has a ring."""
    last = {(row["series"], row["method"]): row["size"] for row in rows("scale")}
    return points("scale", "[series]", "[method]", "[size]", column,
                  lambda row: row["method"] == "Relievo, studio"
                  and row["size"] == last[row["series"], row["method"]],
                  lambda row: row["seconds more"])  # fmt: skip


def shadows(panels, x):
    def panel(row):
        return panels.get(f"{row['scene']}, {row['light']}")

    return points(
        "shadows", panel, "[method]", x, lambda row: max(0.001, float(row["wrong %"])),
        lambda row: row["method"] == "map" and row["map"] == "2048",
        lambda row: panel(row) and row["window"] == "600x600" and row["shading"] == "flat"
        and row["method"] in ("map", "warped", "forward", "exact", "vtkShadowMapPass"))  # fmt: skip


def soft_panel(row):
    panel = f"{row['scene']}, {row['light']}"
    return f"{panel} of {row['size']}" if row["light"] == "point" else panel


def exact_hard(share, x):
    return points("exact-hard", "[scene]", share, x, share, None,
                  lambda row: row["light"] == "sun")  # fmt: skip


def planner(table, x, y, methods, ends):
    line = [("", "plain", end, end, False) for end in ends]
    return line + points(table, "", "[method]", x, y, None, lambda row: row["method"] in methods)


BIASED = ("map", "constant, computed", "vtkShadowMapPass")


def is_default_bias(row):
    return row["method"] == "map" and row["bias, texels"] == "1.5"


def bias(sun):
    return points(
        "bias", "[scene]", "[method]", lambda row: max(0.001, float(row["leak % of dark"])),
        lambda row: max(0.001, float(row["false shadow % of lit"])), is_default_bias,
        lambda row: row["sun, degrees"] == sun and row["method"] in BIASED)  # fmt: skip


def bias_errors():
    found = points(
        "bias", lambda row: f"{row['scene']}, sun at {row['sun, degrees']}°", "[method]",
        lambda row: row["bias, texels"] or None, "[wrong %]", is_default_bias,
        lambda row: row["method"] in BIASED)  # fmt: skip
    return [  # the peer's are level from one side to the other
        (panel, method, at, y, ring)
        for panel, method, x, y, ring in found for at in ((x,) if x else (0.25, 16))
    ]  # fmt: skip


def lights(y, ways):
    return points("lights", "[scene]", "[way]", "[lamps]", y, None,
                  lambda row: row["size"] == "few" and row["way"] in ways)  # fmt: skip


def relief(x):
    def error(row):  # 5 % of the height where it is missed
        missed = float(row["missed %"]) / 100
        return float(row["depth error % of height"]) / 100 * (1 - missed) + 0.05 * missed

    return points("relief", "", lambda row: re.match(r"\w+", row["method"])[0], x, error,
                  lambda row: "(default)" in row["method"],
                  lambda row: row["field"] == "waves" and row["degrees"] == "60")  # fmt: skip


def environment(table, x, last):
    return points(
        table, "[environment]", lambda row: re.sub("^octahedral$", "octahedral map", row["map"]), x,
        "[RMS error / mean light]", lambda row: row["map"] == "cube" and row[x[1:-1]] == last)


def is_irradiation(row):
    return row["scene"] in ("courtyard", "canyon")


def blocks(y):
    return points("blocks", "[shape]", "[method]", "[ms per million blocks]", y,
                  lambda row: row["method"] == "smooth blocks",
                  lambda row: row["blocks"] == "128")  # fmt: skip


def many_views(y):
    """Measured points of bench/many_views.py."""
    names = {("cameras", "320"): "cells seen", ("views", "64"): "views 64 wide",
             ("views", "320"): "views 320 wide"}  # fmt: skip
    sizes = {"1024": "1 000", "99856": "100 000"}
    return points(
        "many-views",
        lambda row: f"{names[row['subject'], row['columns']]}, "
        f"{sizes[row['triangles']]} triangles", "[method]", "[number]", y, None,
        lambda row: row["kind"] == "measured")


FRAMES = {
    "attached, nothing asked": "attached, idle", "normal + depth": "normal, depth",
    "normal + depth + albedo + ids": "… and albedo, ids",
    "the same + geometric normal": "… and facet normal", "vtkSSAOPass, kernel 1": "vtkSSAOPass",
}  # fmt: skip

# The points that each chart must show: see points(). Rows of marks have their names as y.
TRUTH = {
    "normals-bits": normals("largest error", "[bits]", largest_normal)
    + normals("mean error", "[bits]", "[mean degrees]"),
    "normals-time": normals(
        "", lambda row: float(row["encode ns"]) + float(row["decode ns"]), largest_normal),
    "depth-bytes": points(
        "depth", "", "[format]", "[max]", lambda row: f"{row['format']}, {row['bytes']} B",
        lambda row: row["format"] == "R32F, linear" and row["far/near"] == "1e6"),
    "depth-ratio": points(
        "depth", "", "[format]", "[far/near]", "[max]",
        lambda row: row["format"] == "R32F, linear" and row["far/near"] == "1e6"),
    "position-bytes": position("[max]", lambda row: f"{position_format(row)}, {row['bytes']} B"),
    "position-time": position("[times a plain frame]", "[max]"),
    "gbuffer": points(
        "gbuffer", "[scene]", "[frame]", "[times a plain frame]",
        lambda row: FRAMES.get(row["frame"], row["frame"]), None,
        lambda row: row["pixels"] == "1920x1080" and row["frame"] != "plain"),
    "effects": points(
        "effects", "[scene]",
        lambda row: "VTK's shading" if row["frame"].startswith("vtk") else "Relievo",
        "[times the plain frame's]", "[frame]", None, lambda row: row["frame"] != "plain"),
    "compare": points(
        "compare", "", "[method]", "[false alarms %]", "[detected %]",
        lambda row: row["role"] == "recommended", lambda row: row["role"] != "best"),
    "scale": scale("[processor seconds]"),
    "scale-memory": scale("[MiB]"),
    "f3d-first": f3d("first picture"),
    "f3d-frame": f3d("frame"),
    "shadows-meshes": shadows({"bunny, sun": "bunny", "motorBike, sun": "motorBike",
                               "buildings, sun": "buildings"}, "[map]"),
    "shadows-lights": shadows({"motorBike, sun at 10 degrees": "sun at 10°",
                               "motorBike, spot": "spot", "motorBike, point": "point"}, "[map]"),
    "shadows-coded": shadows({"spheres, sun": "spheres", "horizon, sun": "poles to the horizon",
                              "horizon, sun at 10 degrees": "the same, sun at 10°"}, "[map]"),
    "shadows-time": shadows({"bunny, sun": "bunny", "motorBike, sun": "motorBike",
                             "horizon, sun at 10 degrees": "horizon, sun at 10°"}, "[moving ms]"),
    "studio": points(
        "studio", "[scene]", "[samples]", "[seconds more than none]", "[rms levels]",
        lambda row: row["samples"] == "at once" and row["count"] == "24"),
    "readable": points(
        "readable", "[scene]", "[method]", "[median]", "[p95]",
        lambda row: row["method"] == "studio" and row["map"] == "cool-warm",
        lambda row: row["method"] in ("studio", "studio, before", "VTK's headlight")),
    "soft-shadows": points("soft-shadows", soft_panel, "[method]", "[samples]", "[penumbra rms]"),
    "volumes": points(
        "volumes", "[scene]", "[method]", "[milliseconds]",
        lambda row: str(max(1e-7, float(row["rms"]))),
        lambda row: row["method"] == "grid" and row["setting"] == "256",
        lambda row: row["size"] == "128"),
    "empty-space": points("empty-space", "[kind]", "[shape]", "[visible %]", "[times faster]"),
    "exact-hard": exact_hard("with ties", "[wrong %]")
    + exact_hard("without ties", "[wrong without ties %]") + exact_hard("expected", "[expected %]"),
    "ambient": points(
        "ambient", lambda row: {"bunny": "the bunny on a ground", "room": "a room"}[row["scene"]],
        "[method]", "[milliseconds]", "[rms]"),
    "planner-error": planner("planner", "[expected wrong %]", "[wrong %]", ("map", "warped"),
                             (0.003, 3)),
    "planner-choice": planner("planner-choices", "[tolerance %]", "[wrong %]",
                              ("map", "warped", "exact"), (0.003, 0.3)),
    "planner-time": planner("planner-times", "[expected ms]", "[taken ms]",
                            ("map", "warped", "exact"), (10, 1000)),
    "planner-budget": planner("planner-budgets", "[budget ms]", "[taken ms]",
                              ("map", "warped", "exact"), (10, 1000)),
    "bias-wrong": bias_errors(),
    "bias-45": bias("45"),
    "bias-10": bias("10"),
    "bias-3": bias("3"),
    "lights-frames": lights("[times a plain frame]",
                            ("quads", "clusters", "every lamp", "VTK's lights")),
    "lights-computed": lights("[computed / reaching]", ("quads", "clusters")),
    "deferred": points(
        "deferred", lambda row: row["lights"] + " light" + "s" * (row["lights"] != "1"), "[way]",
        "[overdraw]", "[milliseconds]", None, lambda row: row["surface"] == "matte"),
    "relief-error": relief("[looks]"),
    "relief-cost": relief("[times a plain frame (waves, 60)]"),
    "relief-missed": points(
        "relief", "", lambda row: re.match(r"\w+", row["method"])[0], "[degrees]", "[missed %]",
        lambda row: "(default)" in row["method"] and row["degrees"] == "80",
        lambda row: row["field"] != "waves" and re.match("relief|.*by texels", row["method"])),
    "environment-texels": environment("environment", "[texels]", "98304"),
    "environment-angle": environment("environment-angle", "[degrees]", "175"),
    "tone-curves": points("tone-curves", "grey light", "[operator]", "[stops]",
                          "[grey, steps of 255]")
    + points("tone-curves", "red light: how much green is shown", "[operator]", "[stops]",
             "[red's green, steps of 255]"),
    "tone-bands": points("tone-bands", "", "[dither]", "[value, steps of 255]",
                         "[mean error, steps of 255]"),
    "fog-error": points("fog", "", "[method]", "[distance / radius]", "[max]"),
    "fog-frames": points(
        "fog-frames", "[scene]", "pairs of floats", "[spheres]", "[times a plain frame]", None,
        lambda row: row["share of the picture each"] == "0.01"),
    "blocks-distance": blocks("[hausdorff blocks]"),
    "blocks-normals": blocks("[rms normal degrees]"),
    "caves-evaluations": points(
        "caves", "", "[method]", "[scale samples]", "[evaluations per sample]",
        lambda row: row["method"] == "skipping" and row["scale samples"] == "64"),
    "caves-width": points("caves-width", "", "level lines", "[width asked]", "[level over asked]")
    + points("caves-width", "", "upright lines", "[width asked]", "[twice upright over asked]"),
    "voxels-wrong": points(
        "voxels", "[body]", "[method]", "[milliseconds]",
        lambda row: float(row["excess percent"]) + float(row["missed percent"]),
        lambda row: row["method"] == "parity" and row["cells"] == "100",
        lambda row: row["excess percent"] and row["method"] != "vtkVoxelModeller"),
    "voxels-time": points("voxels", "[body]", "[method]", "[cells]", "[milliseconds]", None,
                          lambda row: row["body"] == "bunny" and row["excess percent"]),
    "rays-speed": points(
        "rays", lambda row: {"nearest": "the first hit", "any": "any hit"}[row["answer"]],
        "[method]", lambda row: round(float(row["triangles"]) / 1000),
        "[million rays per second]", None,
        lambda row: row["mesh"] == "bunny"),
    "rays-bytes": points(
        "rays", "", "[method]", lambda row: round(float(row["triangles"]) / 1000),
        "[bytes per triangle]", None,
        lambda row: row["mesh"] == "bunny" and row["answer"] == "nearest"),
    "sun": points("sun", "[of]", "[method]", "[core milliseconds]", "[rms]"),
    "irradiation": points(
        "irradiation", "[scene]", "[method]", "[processor milliseconds]", "[largest error %]",
        lambda row: row["method"] == "tolerance" and row["setting"] == "1", is_irradiation)
    + points("irradiation", "[scene]", "bound", "[processor milliseconds]", "[largest bound %]",
             None, lambda row: is_irradiation(row) and row["largest bound %"]),
    "scaling-out": points("scaling-out", "", "[method]", "[number]", "[processor seconds]", None,
                          lambda row: row["subject"] == "part"),
    "many-views": many_views(
        lambda row: 1000 * float(row["processor seconds"]) / float(row["number"])),
    "many-views-memory": many_views("[MiB]"),
    "viewshed": points("viewshed", "", "[method]", millions, "[processor seconds]"),
    "viewshed-difference":
        points("viewshed", "through the triangles", "[method]", millions,
               "[differs from triangles, %]")
        + points("viewshed", "through the bilinear surface", "[method]", millions,
                 "[differs from bilinear, %]"),
    "skin-keys": points(
        "skin-keys", "[motion]", "[method]", "[keys per second]",
        "[largest error of the arm's end, arm's lengths]", None,
        lambda row: float(row["largest error of the arm's end, arm's lengths"]) > 1e-9),
    "skin-volume": points("skin-volume", "[motion]", "[method]", "[degrees]",
                          "[volume, % of the rest]"),
    "skin": points(
        "skin", "", lambda row: row["method"] + ", GPU" * (row["on"] == "GPU"), "[bones]",
        "[ms per million points]"),
    "particles-time": points("particles", "[body]", "[method]", "[particles]",
                             "[core milliseconds]"),
    "particles-drift": points("particles-drift", "[body]", "[method]", "[steps]",
                              "[largest texels]"),
}  # fmt: skip


def shown(figure):
    """[panel, method, x, y] of the points in a figure, and [panel, x, y] of rings. Rows have
    names as y."""
    found, rings = [], []
    rows_of = {i: label.get_text() for i, label in enumerate(figure.axes[0].get_yticklabels())}
    is_rows = figure.axes[0].yaxis_inverted()
    for ax in figure.axes:
        panel = ax.get_title(loc="left")
        for line in ax.lines:
            for x, y in line.get_xydata():
                y = rows_of[int(y)] if is_rows else y
                if line.get_label() == "ring":
                    rings.append((panel, x, y))
                elif not line.get_label().startswith("_"):  # those join marks
                    found.append((panel, line.get_label(), x, y))
        for bars in ax.containers:
            for bar in bars:
                row = rows_of[round(bar.get_y() + bar.get_height() / 2)]
                found.append((panel, bars.get_label(), bar.get_width(), row))
    return found, rings


def comparable(all_points, figure):
    """Points sorted and rounded, without those that the axes cannot show."""
    scales = {-2: figure.axes[0].get_xscale(), -1: figure.axes[0].get_yscale()}
    kept = []
    for point in all_points:
        point = list(point)
        for at, scale in scales.items():
            if point[at] not in ROW_NAMES:
                value = math.nan if point[at] == "" else float(point[at])
                point[at] = float(f"{value:.9g}")
                if not math.isfinite(value) or (scale == "log" and value <= 0):
                    break
        else:
            kept.append(tuple(point))
    return sorted(kept, key=str)


WITH_ROWS = ("depth-bytes", "position-bytes", "gbuffer", "effects", "f3d-first", "exact-hard")
ROW_NAMES = {y for stem in WITH_ROWS for *_, y, _ in TRUTH[stem]}


def faults(figure):
    """Faults forbidden in charts: texts that overlap, leave the picture, or are too small to read.
    """
    figure.draw_without_rendering()
    renderer = figure.canvas.get_renderer()
    words = [text for text in figure.findobj(Text) if text.get_visible() and text.get_text()]
    boxes = [Text.get_window_extent(text, renderer) for text in words]  # without lines to names
    found = []
    for text, box in zip(words, boxes):
        if box.x0 < 0 or box.y0 < 0 or box.x1 > figure.bbox.x1 or box.y1 > figure.bbox.y1:
            found.append(f"'{text.get_text()}' leaves the picture")
        if text.get_size() < 8.9:
            found.append(f"'{text.get_text()}' is too small")
    for (one, a), (two, b) in itertools.combinations(zip(words, boxes), 2):
        if min(a.x1, b.x1) - max(a.x0, b.x0) > 0 and min(a.y1, b.y1) - max(a.y0, b.y0) > 0:
            found.append(f"'{one.get_text()}' overlaps '{two.get_text()}'")
    return found


def run(*words, status=0):
    """The script in this process, which need not load matplotlib again; its errors."""
    said = io.StringIO()
    with contextlib.redirect_stderr(said):
        try:
            found = charts.main([str(word) for word in words])
        except SystemExit as left:
            found = left.code
    assert found == status, f"{words}: {found}: {said.getvalue()}"
    return said.getvalue()


def run_apart(*words, status=0, **variables):
    done = subprocess.run(
        [sys.executable, str(SCRIPT), *map(str, words)], env={**os.environ, **variables},
        capture_output=True, text=True, check=False)  # fmt: skip
    assert done.returncode == status, f"{words}: {done.returncode}: {done.stderr}"
    return done


def chart(panels, x=(), y=(), **more):
    """A small chart; x and y are words of their axes."""
    axes = (chart_drawing.Axis("x", **dict(x)), chart_drawing.Axis("y", **dict(y)))
    return chart_drawing.Chart("small", "a < b & c", "A note.", *axes, panels, **more)


class Committed(unittest.TestCase):
    """The charts of docs/charts."""

    @classmethod
    def setUpClass(cls):
        cls.charts = {
            each.stem: each for name in charts.BENCHES for each in charts.charts_of(name, TABLES)
        }
        cls.figures = {stem: chart_drawing.draw(each) for stem, each in cls.charts.items()}

    def test_every_table_is_drawn(self):
        tables = {file[:-4] for files, _ in charts.BENCHES.values() for file in files}
        self.assertEqual(tables | UNSHOWN, {name[:-4] for name in committed("*.csv")})
        self.assertFalse(tables & UNSHOWN)
        self.assertEqual([path.name for path in TABLES.glob("*.*")], ["README.md"])
        for kind in ("png", "svg"):
            self.assertEqual(set(self.figures), {name[:-4] for name in committed(f"*.{kind}")})

    def test_charts_are_in_the_room_of_their_table(self):
        tables, drawn = committed("*.csv"), committed("*.svg")
        for name, (files, _) in charts.BENCHES.items():
            room = tables[files[0]].parent
            for each in charts.charts_of(name, TABLES):
                self.assertEqual(drawn[f"{each.stem}.svg"].parent, room, each.stem)
            self.assertEqual({tables[file].parent for file in files}, {room}, name)
        for room in {path.parent for path in tables.values()}:
            self.assertLessEqual(len(list(room.iterdir())), 25, room)

    def test_points_are_those_of_the_tables(self):
        self.assertEqual(set(TRUTH), set(self.figures))
        for stem, figure in self.figures.items():
            with self.subTest(stem):
                found, rings = shown(figure)
                truth = [point[:4] for point in TRUTH[stem]]
                self.assertEqual(comparable(found, figure), comparable(truth, figure))
                truth = [(panel, x, y) for panel, _, x, y, ring in TRUTH[stem] if ring]
                self.assertEqual(comparable(rings, figure), comparable(truth, figure))
                self.assertEqual("Ring:" in self.charts[stem].note, bool(rings))
                for ax in figure.axes:
                    for line in ax.lines:
                        alike = [each for each in ax.lines if each.get_color() == line.get_color()
                                 and not each.get_label().startswith("_")]  # fmt: skip
                        self.assertIn(line.get_xydata().tolist(),
                                      [each.get_xydata().tolist() for each in alike])  # fmt: skip

    def test_infinite_errors_are_in_words(self):
        texts = [t.get_text() for t in self.figures["position-bytes"].findobj(Text)]
        infinite = [p for p in TRUTH["position-bytes"] if p[2] == "inf"]
        self.assertEqual((len(infinite), texts.count("infinite")), (1, 1))

    def test_everything_is_in_its_panel_and_ticks_say_where_they_are(self):
        for stem, figure in self.figures.items():
            for ax in figure.axes:
                (left, right), (low, high) = ax.get_xlim(), sorted(ax.get_ylim())
                for x, y in (point for line in ax.lines for point in line.get_xydata()):
                    self.assertTrue(left <= x <= right and low <= y <= high, stem)
                for axis in (ax.xaxis, ax.yaxis):
                    places, labels = axis.get_majorticklocs(), axis.get_majorticklabels()
                    self.assertGreater(len(places), 1, stem)
                    limits = sorted(axis.get_view_interval())
                    for place, words in zip(places, (label.get_text() for label in labels)):
                        self.assertTrue(limits[0] <= place <= limits[1], stem)
                        if re.fullmatch(r"[-\d. e]+", words) and (words != "0" or place != 0.001):
                            number = float(words.replace(" ", ""))
                            self.assertAlmostEqual(number, place, delta=1e-6 * abs(place))

    def test_words_overlap_nowhere(self):
        for stem, figure in self.figures.items():
            self.assertEqual(faults(figure), [], stem)

    def test_each_curve_has_its_name(self):
        for stem, figure in self.figures.items():
            for ax, panel in zip(figure.axes, self.charts[stem].panels.values()):
                if not ax.yaxis_inverted():
                    drawn = {line.get_label() for line in ax.lines}
                    names = [series.name for series in panel if series.method in drawn]
                    self.assertEqual(sorted(t.get_text() for t in ax.texts), sorted(names), stem)

    def test_a_method_has_one_look(self):
        colors, markers = collections.defaultdict(set), collections.defaultdict(set)
        for stem, figure in self.figures.items():
            methods = set()
            for ax in figure.axes:
                for line in ax.lines:
                    if line.get_label() in chart_drawing.METHODS:
                        methods.add(line.get_label())
                        colors[line.get_label()].add(line.get_color())
                        markers[line.get_label()].add(line.get_marker())
                for bars in ax.containers:
                    color = matplotlib.colors.to_hex(bars[0].get_facecolor())
                    colors[bars.get_label()].add(color)
            # Told apart by colour and marker, and without colours by marker and dash.
            looks = [chart_drawing.METHODS[method].split()[:3] for method in methods]
            self.assertEqual(len({(color, marker) for color, marker, _ in looks}), len(looks), stem)
            self.assertEqual(len({(marker, dash) for _, marker, dash in looks}), len(looks), stem)
        self.assertGreater(len(colors), 60)
        for method, found in itertools.chain(colors.items(), markers.items()):
            self.assertEqual(len(found), 1, f"{method}: {found}")

    def test_two_runs_make_the_same_bytes_which_are_committed(self):
        drawn = committed("*.svg") | committed("*.png")
        names = ("gbuffer", "shadows", "planner")  # that is enough to draw in another process
        with tempfile.TemporaryDirectory() as kept:
            here, there = pathlib.Path(kept), pathlib.Path(kept, "there")
            run_apart(TABLES, *names, "--out", there)
            both = {file.stem for file in there.iterdir()}
            for stem, figure in self.figures.items():
                if stem in both:
                    chart_drawing.save(figure, here / stem)
                    self.assertEqual(imread(here / f"{stem}.png").shape[1], 900)
                else:  # its PNG shows no more than its SVG
                    chart_drawing.save_svg(figure, here / stem)
            self.assertEqual(len(list(there.iterdir())), 2 * (1 + 4 + 4))
            for file in there.iterdir():
                self.assertEqual(file.read_bytes(), (here / file.name).read_bytes(), file.name)
            for file in sorted(here.glob("*.*")):
                present = drawn[file.with_suffix(".svg").name].read_bytes()
                if f"Matplotlib v{matplotlib.__version__}".encode() in present:
                    self.assertEqual(drawn[file.name].read_bytes(), file.read_bytes(),
                                     f"{file.name}: run bench/charts.py docs/charts")  # fmt: skip


class Small(unittest.TestCase):
    def test_faults_are_found(self):
        figure = chart_drawing.draw(chart({"": [chart_drawing.Series("map", "", [1, 2], [1, 2])]}))
        self.assertEqual(faults(figure), [])
        figure.text(0.01, 0.95, "over the title", fontsize=12)
        figure.text(0.99, 0.5, "outside", fontsize=6)
        self.assertEqual(len(faults(figure)), 3, faults(figure))

    def test_crowds(self):
        """As many names as fit, at one place: at the right end, and in the panel."""
        methods = ("map", "forward", "warped", "vtkShadowMapPass", "cube", "sphere map", "lat-long")
        for end in (4, 2.5):
            panel = [chart_drawing.Series(method, "", [1, end], [1e-3, 1e-6]) for method in methods]
            figure = chart_drawing.draw(chart({"": panel}, x={"ticks": (1, 4)}, y={"log": True}))
            self.assertEqual(faults(figure), [])
            self.assertEqual(len(figure.axes[0].texts), len(methods))

    def test_names_move_no_more_than_they_must(self):
        line = chart_drawing.LINE
        for wanted, placed in (
            ([10, 50, 90], [10, 50, 90]),
            ([52, 48], [50 + line / 2, 50 - line / 2]),
            ([99] * 6, [100 - line * (i + 0.5) for i in range(6)]),  # the first is the highest
        ):
            found = chart_drawing.spread(wanted, 0, 100)
            self.assertEqual([round(y, 9) for y in found], placed)

    def test_nothing_measured(self):
        for kind in ("curves", "bars", "dots"):
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                self.assertEqual(faults(chart_drawing.draw(chart({}, kind=kind))), [])

    def test_values_without_a_place(self):
        """Zero has none on a logarithmic axis; the ring stays at its point."""
        series = chart_drawing.Series("map", "", [1, 2, 4], [1e-3, 0, 1e-6], default=2)
        figure = chart_drawing.draw(chart({"": [series]}, y={"log": True}))
        found, rings = shown(figure)
        self.assertEqual(found, [("", "map", 1, 1e-3), ("", "map", 4, 1e-6)])
        self.assertEqual(rings, [("", 4, 1e-6)])
        labels = [label.get_text() for label in figure.axes[0].get_yticklabels()]
        self.assertEqual(labels, ["1e-6", "1e-5", "1e-4", "0.001"])

    def test_unknown_method(self):
        self.assertRaises(KeyError, chart_drawing.Series, "no such method")


class Script(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def names(self):
        return {path.name for path in self.folder.iterdir()}

    def copy(self, *tables):
        for table in tables:
            path = committed("*.csv")[f"{table}.csv"]
            (self.folder / path.name).write_bytes(path.read_bytes())

    def test_charts_are_beside_the_tables(self):
        self.copy("depth", "capture")
        run(self.folder)
        drawn = {f"depth-{what}.{kind}" for what in ("bytes", "ratio") for kind in ("png", "svg")}
        self.assertEqual(self.names(), {"depth.csv", "capture.csv"} | drawn)

    def test_charts_of_rooms_are_beside_their_tables(self):
        (self.folder / "room").mkdir()
        (self.folder / "gpu").mkdir()
        self.copy("depth")
        (self.folder / "depth.csv").rename(self.folder / "room" / "depth.csv")
        (self.folder / "gpu" / "depth.csv").write_text("of another renderer")
        (self.folder / "gpu" / "renderer.txt").write_text("A GPU")
        (self.folder / "room" / "renderer.txt").write_text("software OpenGL\n")
        run(self.folder)
        self.assertEqual(len(list((self.folder / "room").iterdir())), 6)
        self.assertEqual(len(list((self.folder / "gpu").iterdir())), 2)

    def test_a_bench_without_charts(self):
        self.copy("capture")
        run(self.folder, "capture")
        self.assertEqual(self.names(), {"capture.csv"})

    def test_the_renderer_is_named(self):
        self.copy("position")
        for name, said in (("A GPU/PCIe", "A GPU/PCIe"), ("software OpenGL", "software OpenGL")):
            (self.folder / "renderer.txt").write_text(name + "\n")
            run(self.folder, "position", "--out", self.folder / "out")
            picture = (self.folder / "out" / "position-time.svg").read_text()
            self.assertIn(f">times a plain frame, {said}<", picture)

    def test_refusals(self):
        self.assertIn("'speed'", run(TABLES, "speed", status=2))
        self.assertIn("nowhere", run(self.folder / "nowhere", status=2))
        self.copy("fog", "depth")
        self.assertIn("fog-frames.csv", run(self.folder, "fog", status=1))
        table = self.folder / "depth.csv"
        table.write_text(table.read_text().replace("far/near", "ratio", 1))
        self.assertIn("far/near", run(self.folder, "depth", status=1))
        table.write_text("format,bytes\nR32F\n")
        self.assertIn("line 2", run(self.folder, "depth", status=1))
        self.assertEqual(self.names(), {"fog.csv", "depth.csv"})

    def test_without_matplotlib(self):
        (self.folder / "matplotlib.py").write_text(
            "raise ModuleNotFoundError('none', name='matplotlib')\n")  # fmt: skip
        done = run_apart(TABLES, "fog", status=3, PYTHONPATH=str(self.folder))
        self.assertIn("python3-matplotlib", done.stderr)
        run_apart(TABLES, "capture", PYTHONPATH=str(self.folder))  # which has none


if __name__ == "__main__":
    unittest.main()
