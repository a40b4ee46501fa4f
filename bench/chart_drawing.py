# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Defines charts and draws them: each scene is a panel, a method has one colour, marker and dash
everywhere, and a curve has its name at its end, so that no legend is needed and nothing depends on
colour.

The result depends only on the chart and the version of matplotlib, not on a user's settings, a
display, or the date.
"""

import dataclasses
import math

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.ticker import MaxNLocator

# In pixels of a picture 900 wide.
WIDTH = 900
DPI = 96
PIXEL = 72 / DPI  # in points, matplotlib's unit
EDGE = 12  # around the picture
GAP = 14  # from a panel's names to the next panel
FOOT = 24  # under a panel, for the labels of its axis
BELOW = FOOT + 17 + EDGE  # under the last panel, with the title of its axis
ROW = 26  # height of a bar or a row of marks, with its margin
BESIDE = 18  # from the right side of a panel to the names beside it
LINE = 16  # distance of names
RING = 9  # radius
MARKER = 6  # half a marker, with a margin
STEP = 4  # along lines
# Costs of a name's position, in pixels of distance.
COVERS_MARKER = 60
COVERS_LINE = 5  # per step of a line
CROSSES = 20  # for lines to names that cross names or each other
NOT_BESIDE = 0.1  # per pixel above or below
WORDS = 12 * PIXEL  # size of names and axis labels, in points

STYLE = {
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": "#404040",
    "axes.linewidth": PIXEL, "axes.grid": True, "axes.axisbelow": True, "grid.color": "#e1e1e1",
    "grid.linewidth": PIXEL, "lines.scale_dashes": False, "lines.linewidth": 1.8 * PIXEL,
    "xtick.major.size": 0, "ytick.major.size": 0, "xtick.major.pad": 5, "ytick.major.pad": 5,
    "xtick.labelsize": WORDS, "ytick.labelsize": WORDS, "text.parse_math": False,
    # Keeps text as text in SVG; the fallback fonts take no more room.
    "svg.fonttype": "none", "font.sans-serif": ["DejaVu Sans", "Verdana", "Arial", "sans-serif"],
    "svg.hashsalt": "relievo",
}  # fmt: skip

# By Okabe and Ito, distinguishable with all kinds of colour vision; then darker, for text on white.
COLORS = {
    "blue": ("#0072b2", "#005a8c"), "vermillion": ("#d55e00", "#a84a00"),
    "green": ("#009e73", "#007756"), "purple": ("#cc79a7", "#9c4a76"),
    "orange": ("#e69f00", "#8a5f00"), "sky": ("#56b4e9", "#1f6f9c"),
    "black": ("#000000", "#000000"), "grey": ("#8c8c8c", "#666666"),
}  # fmt: skip
MARKERS = {"o": 9, "s": 8.4, "D": 8.2, "^": 10, "v": 10, "+": 11, "x": 8}  # sizes
DASHES = {"-": (), "--": (7, 4), ":": (2, 3), "-.": (8, 3, 2, 3)}  # on, off, ...

# Every method in charts, by its name in the CSV files: colour, marker, dash, and its name in charts
# if different. Grey is a peer, or a method that Relievo does not offer.
METHODS = {
    # normals
    "octahedral": "blue o -", "octahedral precise": "green D --",
    "0.5n+0.5": "vermillion s -. 0.5n + 0.5", "half": "purple ^ - half xyz",
    "float": "black + - float xyz", "spherical angles": "grey x --", "azimuthal": "grey v :",
    # depth, and positions from it
    "R32F, linear": "blue o -", "R32F and id, refined": "black + -",
    "reversed z, 32F": "vermillion s --", "window z, 24 bits": "orange ^ -",
    "R16F, scaled by 2^k": "green D -.", "R16F, world units": "grey D :",
    "window z, 32F": "grey x --", "RGBA8 alpha, linear": "purple v --",
    "world RGBA16F": "grey v :", "world RGBA32F": "grey o --", "eye space RGBA32F": "grey ^ --",
    # frames with layers
    "plain": "black + -", "attached, nothing asked": "sky o - attached, idle", "depth": "blue o -",
    "normal + depth": "green D - normal, depth",
    "normal + depth + albedo + ids": "vermillion s - … and albedo, ids",
    "the same + geometric normal": "purple ^ - … and facet normal",
    "vtkSSAOPass, kernel 1": "grey x -- vtkSSAOPass",
    # shadows
    "map": "blue o -", "forward": "vermillion s -.", "warped": "green D --", "exact": "orange v -",
    "constant, computed": "purple ^ : constant bias", "vtkShadowMapPass": "grey x -- VTK",
    "with ties": "orange v -", "without ties": "blue o -", "expected": "grey x --",
    # light through volumes
    "grid": "blue o -", "Fourier terms": "green s -.", "march": "grey D --",
    # volumes whose transparent parts are skipped
    "one ball": "blue o -", "64 balls": "green D -", "gyroid": "vermillion s -",
    # samples of the default preset
    "at once": "blue o -", "one by one": "grey x --",
    # lamps
    "quads": "blue o -", "clusters": "vermillion s -.", "every lamp": "purple ^ -",
    "VTK's lights": "grey x --", "deferred": "green D -", "VTK's shading": "grey x -- VTK",
    # relief
    "relief": "blue o -", "occlusion": "green D --", "steep": "vermillion s -.",
    "parallax": "purple ^ -",
    # environments
    "cube": "blue o -", "tan-warped cube": "vermillion s -.",
    "octahedral map": "green D -- octahedral", "sphere map": "purple ^ -", "lat-long": "orange v :",
    # tone
    "clamp": "black + --", "simple": "vermillion s -.", "reinhard": "blue o -",
    "reinhard_rgb": "purple ^ :", "neutral": "orange v -",
    "none": "vermillion s -. no dithering", "ordered": "green D --",
    "blue_noise": "blue o - blue noise",
    # surfaces of blocks
    "smooth blocks": "blue o -", "smooth blocks, 0.25": "sky o -- smooth, 0.25",
    "cubes": "black s :", "flying edges": "grey x --",
    "flying edges, sinc": "vermillion ^ -. … and sinc", "surface nets": "green D --",
    # caves
    "skipping": "blue o -", "classic": "grey x -- second if the first passes",
    "naive": "black s : both noises", "level lines": "blue o - level",
    "upright lines": "sky ^ -- upright",
    # ambient occlusion
    "rays": "blue o -", "vtkSSAOPass": "grey x --",
    # rays
    "rays in double": "blue o -", "Embree": "grey x --",
    "Embree's boxes, triangles in double": "orange s - Embree's boxes, our test",
    # irradiation
    "tolerance": "blue o -", "bound": "vermillion s -. its bound",
    "number of rays": "grey x -- rays, no bound",
    # cells inside bodies
    "parity": "blue o -", "two views": "vermillion s -.", "six views": "green D --",
    "six views, drawn": "purple ^ : … drawn",
    "vtkPolyDataToImageStencil": "grey x -- image stencil",
    "vtkSelectEnclosedPoints": "grey x -- enclosed points",
    "vtkVoxelModeller": "grey v : voxel modeller",
    # particles on surfaces
    "depth maps": "blue o -", "closest point": "grey x --", "not held": "black s :",
    # parts of work
    "measured": "blue o -", "model": "grey x --",
    # what many cameras see
    "relievo.visible": "sky s -", "capture_many": "blue o -", "write_dataset": "green D --",
    "VTK, colours": "grey x -- VTK", "vtkHardwareSelector": "grey v : VTK's selector",
    "PyVista, colours": "grey ^ : PyVista", "Embree by trimesh": "grey s -. Embree",
    # bones
    "slerp": "blue o -", "nlerp": "green D --", "key-matrix": "vermillion s -.",
    "linear": "blue o -", "dual quaternion": "green D --", "rigid, GPU": "grey ^ :",
    "linear, GPU": "orange s -", "dual quaternion, GPU": "vermillion s --",
    "VTK's glTF reader": "grey x --",
    # fog
    "pairs of floats": "blue o -", "textbook, double": "grey x --", "textbook, float": "grey ^ :",
    "perpendicular, float": "grey v --",
    # other viewers
    "Relievo": "blue o -", "Relievo, PBR": "green D -", "Relievo, studio": "vermillion s -",
    "F3D": "grey x --",
    "relievo viewshed": "blue o -", "gdal_viewshed": "grey x --",
    # colours of values
    "studio": "vermillion s -", "studio, before": "grey s --", "VTK's headlight": "grey x --",
    # comparisons of pictures
    "Relievo, baselines": "blue o -", "Relievo, layers": "green D --",
    "Relievo, pictures": "sky s :", "vtkImageDifference": "grey x --",
    "SSIM, scikit-image": "purple ^ -", "FLIP": "orange v -", "pixelmatch": "vermillion s -.",
    "SSIM, VTK TIGHT": "purple D -.", "SSIM, VTK LOOSE": "purple s --",
    "odiff": "vermillion v :", "idiff": "black + -",
    "Relievo, none": "blue o -", "Relievo, visible": "sky ^ -", "VTK": "grey v -.",
    "VTK, normals": "grey ^ :",
}  # fmt: skip


@dataclasses.dataclass
class Axis:
    """An axis, shared by all panels."""

    title: str = ""
    log: bool = False  # values that are not positive are left out
    ticks: object = ()  # values, or {value: label}; empty: powers of ten, or even steps


@dataclasses.dataclass
class Series:
    """The measured values of one method."""

    method: str  # of METHODS
    name: str = ""  # at the end of the curve, or before the row; empty: that of the method
    x: list = dataclasses.field(default_factory=list)
    y: list = dataclasses.field(default_factory=list)  # rows need none
    line: bool = True  # connects the points in order
    default: int = -1  # index of the point with a ring; -1: none

    def __post_init__(self):
        color, self.marker, self.dash, *own = METHODS[self.method].split(" ", 3)
        self.color, self.dark = COLORS[color]
        self.name = self.name or " ".join(own) or self.method


@dataclasses.dataclass
class Chart:
    """Panels, {title: [Series]}. Kinds: curves; bars, a row per series, from 0 to each x; dots, a
    row per series, with a mark at each x, infinity as text."""

    stem: str  # of the file names
    title: str
    note: str  # a line under the title that explains the marks
    x: Axis
    y: Axis
    panels: dict
    kind: str = "curves"
    columns: int = 3  # at most
    own_x: bool = False  # each panel's values of x are its own

    def __post_init__(self):
        self.panels = self.panels or {"": []}  # for empty tables
        self.rows = self.kind != "curves"


def draw(chart):
    """The chart as a figure of matplotlib; marks have their method as label, rings "ring"."""
    matplotlib.rcdefaults()
    matplotlib.rcParams.update(STYLE)
    figure = Figure(dpi=DPI)
    FigureCanvasAgg(figure)
    columns = min(chart.columns, len(chart.panels))
    rows = -(-len(chart.panels) // columns)
    axes = figure.subplots(rows, columns, sharex=not chart.own_x, sharey=True, squeeze=False)
    for ax in axes.flat[len(chart.panels) :]:
        ax.remove()
    every = [series for panel in chart.panels.values() for series in panel]
    ylim, yticks = fit(chart.y, [y for each in every for y in each.y])
    if chart.rows:
        yticks = {row: series.name for row, series in enumerate(next(iter(chart.panels.values())))}
        ylim = (max(1, len(yticks)) - 0.5, -0.5)
    panels = []
    for ax, (title, panel) in zip(axes.flat, chart.panels.items()):
        xs = [x for each in (panel if chart.own_x else every) for x in each.x]
        xlim, xticks = fit(chart.x, xs, chart.kind == "bars")
        ax.set(xscale="log" if chart.x.log else "linear", yscale="log" if chart.y.log else "linear")
        ax.minorticks_off()
        ax.set_xticks(list(xticks), xticks.values())
        ax.set_yticks(list(yticks), yticks.values())
        ax.set(xlim=xlim, ylim=ylim)
        ax.tick_params(labelbottom=True)
        ax.set_title(title, loc="left", fontsize=14 * PIXEL, pad=5)
        panels.append((draw_rows if chart.rows else draw_curves)(ax, chart, panel))
    beside = arrange(figure, axes, chart, yticks.values(), sum(panels, []))
    for ax, curves in zip(axes.flat, panels):
        name_curves(ax, curves, beside)
    return figure


def save(figure, stem):
    """Writes STEM.png and STEM.svg."""
    figure.savefig(f"{stem}.png")
    save_svg(figure, stem)


def save_svg(figure, stem):
    figure.savefig(f"{stem}.svg", metadata={"Date": None})


def has(axis, value):
    """Whether an axis can show a value."""
    return math.isfinite(value) and (value > 0 or not axis.log)


def fit(axis, values, zero=False):
    """Limits of an axis around the values, or from zero; and its ticks, {value: label}."""
    named = isinstance(axis.ticks, dict)
    ticks = axis.ticks if named else {tick: label(tick) for tick in axis.ticks}
    places = [math.log10(v) if axis.log else v for v in [*values, *ticks] if has(axis, v)]
    low, high = min(places, default=0), max(places, default=1)
    if axis.log and not ticks and math.floor(high) - math.ceil(low) < 1:
        low, high = math.floor(low), math.ceil(high)  # less than two powers of ten are within
    margin = 0.05 * (high - low) or 0.5
    low, high = 0 if zero else low - margin, high + margin
    if axis.log:
        powers = range(math.ceil(low), math.floor(high) + 1)
        return (10**low, 10**high), ticks or {10.0**power: label(10.0**power) for power in powers}
    even = MaxNLocator(7, steps=[1, 2, 5, 10]).tick_values(low, high)
    return (low, high), ticks or {tick: label(tick) for tick in even if low <= tick <= high}


def label(value):
    """A number in its usual short notation."""
    power = math.log10(value) if value > 0 else 0
    is_power = power == round(power) and not -3 <= power <= 4
    return f"1e{power:.0f}" if is_power else f"{value + 0.0:.6g}"  # not -0


def draw_marks(ax, series, x, y):
    """Marks, and a line through them."""
    if series.line and len(x) > 1:  # dashes over solid lines: both of two equal curves show
        dashes = [length * PIXEL for length in DASHES[series.dash]]
        over = 2.1 if dashes else 2
        ax.plot(x, y, color=series.color, linestyle=(0, dashes or None), zorder=over)
    thick = 2.4 * PIXEL if series.marker in "+x" else 0
    ax.plot(x, y, series.marker, color=series.color, markersize=MARKERS[series.marker] * PIXEL,
            markeredgewidth=thick, clip_on=False, zorder=3, label=series.method)  # fmt: skip


def draw_ring(ax, x, y):
    """Marks the default."""
    ax.plot(x, y, "o", color="black", markerfacecolor="none", markersize=2 * RING * PIXEL,
            markeredgewidth=1.5 * PIXEL, clip_on=False, zorder=4, label="ring")  # fmt: skip


def draw_curves(ax, chart, panel):
    """Draws curves without names; returns those that have points."""
    curves = []
    for series in panel:
        points = enumerate(zip(series.x, series.y))
        places = {i: (x, y) for i, (x, y) in points if has(chart.x, x) and has(chart.y, y)}
        if places:
            draw_marks(ax, series, *zip(*places.values()))
            rings = [places[series.default]] if series.default in places else []
            for x, y in rings:
                draw_ring(ax, x, y)
            curves.append(Curve(ax, series, list(places.values()), rings))
    return curves


def draw_rows(ax, chart, panel):
    """Draws bars or rows of marks, named by the axis labels."""
    for row, series in enumerate(panel):
        places = [x for x in series.x if has(chart.x, x)]
        if chart.kind == "bars":
            ax.barh(row, places, 16 / ROW, color=series.color, label=series.method)
            continue
        draw_marks(ax, series, places, [row] * len(places))
        if series.default >= 0:
            draw_ring(ax, series.x[series.default], row)
        if math.inf in series.x:
            ax.text(0.99, row, "infinite", transform=ax.get_yaxis_transform(), color=series.dark,
                    fontsize=WORDS, ha="right", va="center")  # fmt: skip
    ax.grid(False, axis="y")
    for name, series in zip(ax.get_yticklabels(), panel):
        name.set_color(series.dark)
    return []


def arrange(figure, axes, chart, yticks, curves):
    """Sets the places of panels and writes the titles around them. Returns the width for names at
    the right of each panel."""
    rows, columns = axes.shape
    names = [width(figure, curve.series.name) for curve in curves if curve.ends_right()]
    beside = max(names) + BESIDE if names else 6
    left = EDGE + max([width(figure, words) for words in yticks], default=0)
    left += 10 if chart.rows else 31  # includes the title of that axis
    wide = (WIDTH - EDGE - left - columns * beside - (columns - 1) * GAP) / columns
    high = (340 if columns < 3 else 300) if rows == 1 else (230 if columns == 1 else 180)
    high = ROW * max(1, len(yticks)) if chart.rows else high
    head = 26 if any(chart.panels) else 8
    above = EDGE + 44 + head
    height = above + rows * (head + high + FOOT) - head - FOOT + BELOW
    figure.set_size_inches(WIDTH / DPI, height / DPI)
    figure.subplots_adjust(
        left / WIDTH, BELOW / height, 1 - (EDGE + beside) / WIDTH, 1 - above / height,
        (beside + GAP) / wide, (head + FOOT) / high)  # fmt: skip

    def write(x, y, words, size, **how):
        figure.text(x / WIDTH, y / height, words, fontsize=size * PIXEL, **how)

    write(EDGE, height - EDGE, chart.title, 16, va="top")
    write(EDGE, height - EDGE - 24, chart.note, 12, va="top", color="#404040")
    middle = left + (columns * (wide + beside + GAP) - beside - GAP) / 2
    write(middle, EDGE, chart.x.title, 13, ha="center", va="bottom")
    write(EDGE, (BELOW + height - above) / 2, chart.y.title, 13, ha="center", va="top", rotation=90,
          rotation_mode="anchor")  # fmt: skip
    return beside


def width(figure, words):
    """The width of a name or an axis label."""
    renderer = figure.canvas.get_renderer()
    return renderer.get_text_width_height_descent(words, FontProperties(size=WORDS), False)[0]


class Curve:
    """A series in a panel, with its points in data coordinates and those that have rings. Pixel
    coordinates are known once the panel has its place in the figure."""

    def __init__(self, ax, series, places, rings):
        self.ax, self.series, self.places, self.rings = ax, series, places, rings

    def ends_right(self):
        """Whether the curve ends at the right side of the panel, where its name is then written."""
        within = self.ax.transScale + self.ax.transLimits
        return within.transform(self.places[-1])[0] > 0.9

    def measure(self):
        """Computes pixel coordinates, and boxes that names should not cover, with their costs."""
        self.points = self.ax.transData.transform(self.places)
        self.size = width(self.ax.figure, self.series.name)
        half = [RING + 2 if place in self.rings else MARKER for place in self.places]
        self.marks = [
            (x - r, y - r, x + r, y + r, COVERS_MARKER) for (x, y), r in zip(self.points, half)
        ]
        for ends in zip(self.points, self.points[1:]) if self.series.line else ():
            self.marks += [(x, y, x, y, COVERS_LINE) for x, y in steps(*ends)]

    def write_name(self, at, box, lead=False):
        """Writes the name in its box, with a line to a point if requested or if the point is far.
        Returns the marks of that line."""
        x0, y0, x1, y1 = box
        (x, y), place = self.points[at], self.places[at]
        nearest = np.clip((x, y), box[:2], box[2:])
        lead = lead or np.hypot(*(nearest - (x, y))) > MARKER + 8
        line = {
            "arrowstyle": "-", "color": self.series.dark, "linewidth": 0.8 * PIXEL, "shrinkA": 0,
            "shrinkB": (1 + (RING if place in self.rings else MARKER)) * PIXEL,
            "relpos": (min(max(0, (x - x0) / (x1 - x0)), 1), float(y > y1) if x0 < x < x1 else 0.5),
        }  # fmt: skip
        self.ax.annotate(
            self.series.name, place, ((x0 - x) * PIXEL, ((y0 + y1) / 2 - y) * PIXEL),
            textcoords="offset points", va="center", fontsize=WORDS, color=self.series.dark,
            annotation_clip=False, arrowprops=line if lead else None)  # fmt: skip
        return [(x, y, x, y, CROSSES) for x, y in steps((x, y), nearest)] if lead else []


def name_curves(ax, curves, beside):
    """Names a panel's curves: in the width `beside` the panel, or in the panel where the names
    cover least."""
    plot = ax.get_window_extent()
    low, high = plot.y0, plot.y1 + 4
    for curve in curves:
        curve.measure()
    marks = [mark for curve in curves for mark in curve.marks]
    right = [curve for curve in curves if curve.ends_right()]
    boxes = [(0, 0, 0, 0)]  # of names
    for curve, y in zip(right, spread([each.points[-1][1] for each in right], low, high)):
        x = plot.x1 + BESIDE - 2
        boxes.append((x, y - LINE / 2, x + curve.size, y + LINE / 2))
        marks += curve.write_name(-1, boxes[-1], lead=True)
    for curve in curves:
        if curve not in right:
            room = (plot.x0 + 2, low, plot.x1 + beside, high)
            at, box = best_place(curve, room, np.array(boxes), np.array(marks))
            boxes.append(box)
            marks += curve.write_name(at, box)


def steps(start, end):
    """Points along a line."""
    return np.linspace(start, end, 2 + int(np.hypot(*np.subtract(end, start)) / STEP))


def best_place(curve, room, taken, marks):
    """The point of least cost for a name, and the name's box."""
    best = (math.inf,)
    # A crowded end can be replaced by the beginning of a curve; without a line, any point will do.
    ends = {-1: 0, 0: 15} if curve.series.line else dict.fromkeys(range(len(curve.points)), 0)
    for at, cost in ends.items():
        x, y = curve.points[at]
        aside = [9, RING + 4, 27]
        corners = np.array([
            (x + dx, y + dy - LINE / 2) for dy in range(-160, 161, 8)
            for dx in (*aside, -curve.size / 2, *(-curve.size - gap for gap in aside))
        ])  # fmt: skip
        boxes = np.hstack([corners, corners + (curve.size, LINE)])
        nearest = np.clip((x, y), boxes[:, :2], boxes[:, 2:])
        cost = cost + np.hypot(*(nearest - (x, y)).T)
        cost += NOT_BESIDE * abs(boxes[:, 1] + LINE / 2 - y)
        cost += meet(boxes, marks[:, :4]) @ marks[:, 4]
        for line in np.linspace((x, y), nearest, 6)[1:]:
            cost += CROSSES * meet(np.hstack([line, line]), taken).any(axis=1)
        outside = (boxes[:, :2] < room[:2]).any(axis=1) | (boxes[:, 2:] > room[2:]).any(axis=1)
        cost[outside | meet(boxes, taken).any(axis=1)] += 1e6
        best = min(best, (cost.min(), at, tuple(boxes[cost.argmin()])))
    return best[1:]


def meet(boxes, others):
    """A matrix of which boxes overlap which others."""
    a, b = boxes[:, None], others[None]
    return ((a[..., :2] < b[..., 2:]) & (b[..., :2] < a[..., 2:])).all(axis=2)


def spread(heights, low, high):
    """Heights for lines between low and high, in the given order and as near to the wanted heights
    as possible: least squares, by pooling neighbours."""
    order = sorted(range(len(heights)), key=lambda i: (heights[i], -i))
    pools = []  # mean and count; with distances subtracted, heights must only not fall
    for rank, i in enumerate(order):
        pools.append((heights[i] - LINE * rank, 1))
        while len(pools) > 1 and pools[-2][0] > pools[-1][0]:
            (last, more), (mean, count) = pools.pop(), pools.pop()
            pools.append(((mean * count + last * more) / (count + more), count + more))
    level = np.array([mean for mean, count in pools for _ in range(count)])
    low, high = low + LINE / 2, high - LINE / 2 - LINE * (len(order) - 1)
    placed = np.empty(len(order))
    placed[order] = np.maximum(np.minimum(level, high), low) + LINE * np.arange(len(order))
    return placed
