# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""How well relievo.compare() finds and explains faults, beside other comparisons of pictures.

    python bench/compare.py [--out FOLDER] [--quick] [--size WxH] [--seed N] [--other PYTHON]...
        [--pairs FILE] [--keep FOLDER] [--scenes a,b] [--of FILE]... [--frames no]
        [--odiff FILE] [--vtk PYTHON] [--write-frames FOLDER | --elsewhere FOLDER]

Twelve scenes of bench/compare_scenes.py are drawn as baselines, then with faults, each in a new
renderer, and with changes that are no fault, each in a process of its own: another order of actors,
multisampling, other numbers of threads, other vector units of software OpenGL, and with --other in
a Python with another VTK; of those, pictures in which VTK itself draws a pixel differently by more
than two levels are left out.

A fault is visible if it changes at least four pixels by more than two of 255 levels. It is detected
if the frames are not alike, and attributed correctly if its cause is reported, for its object, and
no other cause than shadows and stages that a changed surface affects, and no pixel is unexplained.
A false alarm is a change without a fault for which the frames are not alike.

Peers that this Python has: vtkImageDifference, SSIM of scikit-image, FLIP (flip_evaluator),
pixelmatch, and idiff (OpenImageIO); the program odiff (npm's package odiff-bin); and, with a Python
that has the package vtk 9.4 or newer (--vtk), TIGHT_VALID and LOOSE_VALID of vtkTesting. Each is
measured at the limit that its project recommends, if there is one, at its best limit, the one that
detects the most faults without a false alarm, and in between.

compare.csv has the methods at their limits, compare-faults.csv the kinds of faults, and
compare-frames.csv the processor seconds and memory for frames of 1920 x 1080 pixels; --pairs writes
every pair as JSON, and --of reads such files, as of several --scenes, instead of drawing. --keep
keeps the pictures that peers compare; with --of, peers that a file does not have compare them.
--quick draws three scenes with every fifteenth fault and two changes, without peers.
--write-frames only draws the scenes, as EXR files. --elsewhere only compares such files, drawn on
another machine, with the scenes drawn here, such as by a GPU: changes that are no fault. --of joins
its --pairs with others. tools/compare-bundle packs both for such a machine.
A display is needed where VTK needs one (tools/with-display).
"""

import argparse
import contextlib
import csv
import dataclasses
import functools
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import compare_scenes
import numpy
import relievo

VISIBLE, LEVELS = 4, 2  # pixels, of 255
RECORD = ("baseline_version", "objects", "overlays", "settings", "versions")
SURFACE = ("removed", "added", "moved", "shape", "visibility", "normal")
AFFECTED = ("shadow", "lamps", "fog", "ambient", "translucent")  # by a changed surface
QUICK = ("meshes", "shadows", "overlay")
OURS = ("Relievo, baselines", "Relievo, layers", "Relievo, pictures")
LARGE, ROUNDS = (1920, 1080), 5
CURVE = 24  # limits of a curve


@dataclasses.dataclass
class Change:
    """No fault: a difference from the baseline's process."""

    kind: str
    order: int = 0
    samples: int = 0
    python: str = sys.executable
    environment: dict = dataclasses.field(default_factory=dict)


def changes(others):
    yield from (Change("another run") for _ in range(3))
    yield from (Change("order of actors", order=1 + seed) for seed in range(5))
    yield from (Change("multisampling", samples=count) for count in (2, 4, 8))
    for count in (0, 1, 3, 8):
        yield Change("threads", environment={"LP_NUM_THREADS": str(count)})
    yield Change("threads", environment={"VTK_SMP_MAX_THREADS": "1"})
    for units in ("sse2", "sse3", "ssse3", "sse4.1", "avx"):
        yield Change("vector units", environment={"GALLIUM_OVERRIDE_CPU_CAPS": units})
    for width in (128, 256, 512):  # Mesa's cache of compiled shaders confuses widths
        yield Change("vector units", environment={
            "LP_NATIVE_VECTOR_WIDTH": str(width), "MESA_SHADER_CACHE_DISABLE": "true"})  # fmt: skip
    for seed, units in enumerate(("sse2", "sse4.1", "avx")):
        yield Change("several", 7 + seed, 4, environment={
            "GALLIUM_OVERRIDE_CPU_CAPS": units, "LP_NUM_THREADS": str(seed)})  # fmt: skip
    for python in others:
        yield Change("another VTK", python=python)


# ------------------------------------------------------------------------------
# Drawing


def draw(draft, window, path):
    renderer, names = draft.finish(window)
    relievo.write_baseline(path, renderer, names=names)
    window.RemoveRenderer(renderer)


def draft_of(name, order=0):
    """A scene: every second one has names."""
    place = list(compare_scenes.SCENES).index(name)
    return compare_scenes.Draft(compare_scenes.SCENES[name], order, named=place % 2 == 0)


def draw_all(names, size, order, samples, folder):
    """In a process of its own."""
    for name in names:
        draw(draft_of(name, order), compare_scenes.window_of(size, samples),
             str(pathlib.Path(folder, f"{name}.exr")))  # fmt: skip


def in_process(change, names, size, folder):
    """Draws the scenes; returns whether the process ended well."""
    words = json.dumps([names, size, change.order, change.samples, str(folder)])
    environment = {**os.environ, **change.environment}
    if change.python != sys.executable:
        environment.pop("PYTHONPATH", None)  # of the VTK here
    done = subprocess.run([change.python, __file__, "--draw", words], env=environment,
                          capture_output=True, check=False)  # fmt: skip
    return done.returncode == 0


def drawn(change, names, size, folder):
    """The scenes that could be drawn. Mesa crashes at width 512 without AVX-512."""
    if in_process(change, names, size, folder):
        return names
    found = [name for name in names if in_process(change, [name], size, folder)]
    for name in set(names) - set(found):
        print(f"{change.kind} {change.environment}: {name} cannot be drawn", flush=True)
    return found


# ------------------------------------------------------------------------------
# Relievo's verdicts


def without_record(image):
    found = type(image)()
    found.ShallowCopy(image)
    for name in RECORD:
        found.GetFieldData().RemoveArray(name)
    return found


def is_truth(finding, truth):
    return (finding["cause"] == truth.cause and truth.kind in (None, finding["kind"])
            and truth.id in (None, finding.get("id"))
            and finding.get("name", "").startswith(truth.name))  # fmt: skip


def is_right(found, truths):
    """Whether a comparison reports the cause of a fault, for its object, and no other."""
    hits = [any(is_truth(each, truth) for truth in truths) for each in found.causes]
    allowed = AFFECTED if truths[0].cause in SURFACE else ()
    return any(hits) and not found.unexplained and all(
        hit or each["cause"] in allowed
        for hit, each in zip(hits, found.causes, strict=True))  # fmt: skip


def verdicts(before, after, truths):
    """By method: the score, which is 1 if the frames differ; and whether the cause is right."""
    scores, right, said = {}, {}, ""
    pair = (before, after)
    for method, frames in zip(OURS, (
            pair, [without_record(each) for each in pair],
            [relievo.picture(each, "color") for each in pair]), strict=True):  # fmt: skip
        found = relievo.compare(*frames)
        scores[method] = float(not found)
        right[method] = bool(truths) and is_right(found, truths)
        said = said or repr(found)
    return scores, right, said


# ------------------------------------------------------------------------------
# Peers: a score of two pictures, larger for a larger difference


def with_vtk(a, b):
    from vtkmodules.vtkImagingCore import vtkImageDifference

    compared = vtkImageDifference()
    compared.SetInputData(relievo.to_image(a))
    compared.SetImageData(relievo.to_image(b))
    compared.Update()
    return compared.GetThresholdedError()


def with_skimage(a, b):
    from skimage.metrics import structural_similarity

    return 1 - structural_similarity(a, b, channel_axis=2)


def with_flip(a, b):
    import flip_evaluator

    return flip_evaluator.evaluate(a.astype("f4") / 255, b.astype("f4") / 255, "LDR",
                                   applyMagma=False)[1]  # fmt: skip


def with_pixelmatch(a, b):
    from pixelmatch import pixelmatch

    rows, columns = a.shape[:2]
    flat = [numpy.dstack((each, numpy.full((rows, columns, 1), 255, "u1"))).ravel().tolist()
            for each in (a, b)]  # fmt: skip
    return pixelmatch(*flat, columns, rows, threshold=0.1)


def with_openimageio(a, b):
    """As idiff does: the largest difference of a channel."""
    import OpenImageIO as oiio

    buffers = []
    for each in (a, b):
        rows, columns, channels = each.shape
        buffers.append(oiio.ImageBuf(oiio.ImageSpec(columns, rows, channels, oiio.UINT8)))
        buffers[-1].set_pixels(oiio.ROI(), numpy.ascontiguousarray(each))
    return oiio.ImageBufAlgo.compare(*buffers, 1e-6, 1e-6).maxerror


@contextlib.contextmanager
def files_of(a, b):
    """PNG files of two pictures, while the context lasts."""
    with tempfile.TemporaryDirectory() as folder:
        files = [str(pathlib.Path(folder, f"{name}.png")) for name in "ab"]
        for file, pixels in zip(files, (a, b), strict=True):
            relievo.write_png(file, pixels)
        yield files


def with_odiff(program, a, b):
    """The number of different pixels, at the default threshold of a pixel."""
    with files_of(a, b) as files:
        said = subprocess.run([program, *files, "--parsable-stdout"], capture_output=True,
                              text=True, check=False).stdout  # fmt: skip
    return float(said.split(";")[0])


@functools.cache
def vtk_ssim(python):
    """A function for the errors of two pictures by bench/vtk_ssim.py, TIGHT and LOOSE; or None."""
    process = subprocess.Popen([python, str(pathlib.Path(__file__).with_name("vtk_ssim.py"))],
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True)  # fmt: skip
    if not process.stdout.readline():
        return None

    @functools.lru_cache(1)
    def errors(shape, *both):
        with files_of(*(numpy.frombuffer(each, "u1").reshape(shape) for each in both)) as files:
            print(*files, sep="\t", file=process.stdin, flush=True)
            return [float(word) for word in process.stdout.readline().split()]

    return lambda a, b: errors(a.shape, a.tobytes(), b.tobytes())


def odiff_of(given):
    program = shutil.which(given.odiff)
    return program and functools.partial(with_odiff, program)


def vtk_ssim_of(given, place):
    errors = vtk_ssim(given.vtk)
    return errors and (lambda a, b: errors(a, b)[place])


def of_module(name, score):
    def find(given):
        with contextlib.suppress(ImportError):
            __import__(name)
            return score
        return None

    return find


# By name: a function for its score, which is None where a peer is missing; and the recommended
# limit, beyond which pictures differ: for SSIM that of VTK's own tests in Python.
PEERS = {
    "vtkImageDifference": (lambda given: with_vtk, 10),
    "SSIM, scikit-image": (of_module("skimage", with_skimage), None),
    "SSIM, VTK TIGHT": (functools.partial(vtk_ssim_of, place=0), 0.05),
    "SSIM, VTK LOOSE": (functools.partial(vtk_ssim_of, place=1), 0.05),
    "FLIP": (of_module("flip_evaluator", with_flip), None),
    "pixelmatch": (of_module("pixelmatch", with_pixelmatch), 0),
    "odiff": (odiff_of, 0),
    "idiff": (of_module("OpenImageIO", with_openimageio), 1e-6),
}  # fmt: skip


# ------------------------------------------------------------------------------


@dataclasses.dataclass
class Pair:
    scene: str
    kind: str
    size: float
    is_fault: bool
    pixels: int  # changed by more than two levels
    scores: dict
    right: dict
    said: str
    causes: list  # expected
    pictures: list = dataclasses.field(default_factory=list)  # files, if they are kept

    def is_visible(self):
        return self.pixels >= VISIBLE


def add_scores(scores, a, b, peers):
    """Of the peers that have none yet."""
    is_equal = numpy.array_equal(a, b)
    for name, score in peers.items():
        if name not in scores:
            scores[name] = 0.0 if is_equal else float(score(a, b))


def keep_pictures(folder, *pictures):
    """Writes two pictures into a folder that has other pairs; returns the files."""
    number = len(list(folder.glob("*.png"))) // 2
    files = [str(folder / f"{number:04}-{name}.png") for name in "ab"]
    for file, pixels in zip(files, pictures, strict=True):
        relievo.write_png(file, pixels)
    return files


def read_picture(file):
    from vtkmodules.vtkIOImage import vtkPNGReader

    reader = vtkPNGReader()
    reader.SetFileName(file)
    reader.Update()
    return relievo.from_image(reader.GetOutput())


def judge(scene, kind, before, after, peers, keep, fault=None):
    a, b = (relievo.picture(each, "color") for each in (before, after))
    off = numpy.abs(a.astype(int) - b).max(axis=-1) > LEVELS
    truths = fault.truths if fault else ()
    scores, right, said = verdicts(before, after, truths)
    pictures = []
    if not fault or off.sum() >= VISIBLE:
        add_scores(scores, a, b, peers)
        pictures = keep_pictures(keep, a, b) if keep else []
    return Pair(scene, kind, fault.size if fault else 0, fault is not None, int(off.sum()), scores,
                right, said, [truth.cause for truth in truths], pictures)  # fmt: skip


def earlier(files, peers):
    for file in files:
        for words in json.loads(pathlib.Path(file).read_text(encoding="utf-8")):
            pair = Pair(**words)
            if pair.pictures:
                add_scores(pair.scores, *map(read_picture, pair.pictures), peers)
            yield pair


def versions(frame):
    """Of Relievo, VTK and OpenGL, as a baseline records them."""
    array = frame.GetFieldData().GetAbstractArray("versions")
    return ", ".join(array.GetValue(i) for i in range(array.GetNumberOfValues()))


def elsewhere(given, names, size, peers):
    """Pairs of frames drawn on another machine and here."""
    with tempfile.TemporaryDirectory() as folder:
        draw_all(names, size, 0, 0, folder)
        for number, name in enumerate(names):
            before, after = (relievo.read_exr(str(pathlib.Path(where, f"{name}.exr")))
                             for where in (given.elsewhere, folder))  # fmt: skip
            if number == 0:
                print(f"elsewhere: {versions(before)}\nhere: {versions(after)}", flush=True)
            yield judge(name, "another renderer", before, after, peers, given.keep)


def measure(given, names, size, peers):
    judged = functools.partial(judge, peers=peers, keep=given.keep)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        frames = {}
        for number, name in enumerate(names):
            window = compare_scenes.window_of(size)
            file = str(folder / f"{name}.exr")
            draw(draft_of(name), window, file)
            frames[name] = relievo.read_exr(file)
            all_faults = list(
                compare_scenes.faults(name, draft_of(name), frames[name], size, given.seed))
            for fault in all_faults[number :: 15] if given.quick else all_faults:
                draft = draft_of(name)
                fault.apply(draft)
                draw(draft, window, str(folder / "fault.exr"))
                yield judged(name, fault.kind, frames[name],
                             relievo.read_exr(str(folder / "fault.exr")), fault=fault)  # fmt: skip
        all_changes = list(changes(given.other))
        for change in (all_changes[3], all_changes[16]) if given.quick else all_changes:
            # VTK does not peel with multisampling, and draws translucent surfaces in another order.
            shown = [name for name in names if not change.samples or name != "translucent"]
            for name in drawn(change, shown, size, folder):
                pair = judged(name, change.kind, frames[name],
                              relievo.read_exr(str(folder / f"{name}.exr")))  # fmt: skip
                if change.kind == "another VTK" and pair.pixels:
                    print(f"another VTK draws {name} differently", flush=True)
                    continue
                yield pair


def share(part, whole):
    """Percent of a list, as text."""
    return f"{100 * sum(map(bool, part)) / len(whole):.2f}" if whole else ""


def row(method, role, limit, faults, innocent):
    detected = [pair.scores[method] > limit for pair in faults]
    alarms = [pair.scores[method] > limit for pair in innocent]
    right = [pair.right[method] for pair in faults] if method in OURS[:2] else []
    return [method, role, f"{limit:.6g}", share(detected, faults), share(right, right),
            share(alarms, innocent), sum(alarms), len(faults), len(innocent)]  # fmt: skip


COLUMNS = ("method", "role", "limit", "detected %", "attributed %", "false alarms %",
           "false alarms", "faults", "innocent")  # fmt: skip


def summary(pairs):
    """Rows of methods at their limits."""
    faults = [pair for pair in pairs if pair.is_fault and pair.is_visible()]
    innocent = [pair for pair in pairs if not pair.is_fault]
    for method in OURS:
        yield row(method, "recommended", 0.5, faults, innocent)
    for method in (name for name in PEERS if name in innocent[0].scores):
        recommended = PEERS[method][1]
        if recommended is not None:
            yield row(method, "recommended", recommended, faults, innocent)
        best = max(pair.scores[method] for pair in innocent)
        yield row(method, "best", best, faults, innocent)
        scores = sorted({pair.scores[method] for pair in innocent} | {0.0})
        for place in numpy.unique(numpy.linspace(0, len(scores) - 1, CURVE).astype(int)):
            yield row(method, "curve", scores[place], faults, innocent)


def by_kind(pairs):
    """Rows of kinds of faults and of changes."""
    kinds = {}
    for pair in pairs:
        kinds.setdefault((not pair.is_fault, pair.kind), []).append(pair)
    for (is_innocent, kind), all_pairs in sorted(kinds.items()):
        shown = [pair for pair in all_pairs if pair.is_visible()] if not is_innocent else all_pairs
        cells = [kind, "no fault" if is_innocent else "fault", len(all_pairs),
                 "" if is_innocent else len(shown)]  # fmt: skip
        for method in OURS[:2]:
            cells.append(sum(pair.scores[method] > 0.5 for pair in shown))
            cells.append("" if is_innocent else sum(pair.right[method] for pair in shown))
        yield cells


KINDS = ("kind", "what", "pairs", "visible", "detected", "attributed", "detected, layers",
         "attributed, layers")  # fmt: skip


def memory():
    """The most bytes that this process has held."""
    words = pathlib.Path("/proc/self/status").read_text().split()
    return 1024 * int(words[words.index("VmHWM:") + 1])


def time_frames(files):
    """In a process of its own: processor seconds and bytes of a comparison beyond reading."""
    frames = [relievo.read_exr(file) for file in files]
    pathlib.Path("/proc/self/clear_refs").write_text("5")  # resets VmHWM
    before, seconds = memory(), []
    for _ in range(ROUNDS):
        began = time.process_time()
        relievo.compare(*frames)
        seconds.append(time.process_time() - began)
    print(json.dumps([statistics.median(seconds), memory() - before]))


def large_frames():
    """Rows of frames of 1920 x 1080 pixels: equal, and with moved objects."""
    with tempfile.TemporaryDirectory() as folder:
        for name in ("meshes", "shadows"):
            window = compare_scenes.window_of(LARGE)
            files = [str(pathlib.Path(folder, f"{number}.exr")) for number in range(2)]
            draft = draft_of(name)
            draw(draft, window, files[0])
            draft = draft_of(name)
            compare_scenes.move_actor(draft, 0, (0.01, 0.01, 0))
            draw(draft, window, files[1])
            for what, chosen in (("equal", [files[0]] * 2), ("an object moved", files)):
                said = subprocess.run([sys.executable, __file__, "--time", *chosen],
                                      capture_output=True, text=True, check=True).stdout
                seconds, peak = json.loads(said)
                yield [name, what, f"{seconds:.2f}", f"{peak / 2**20:.0f}"]


FRAMES = ("scene", "frames", "processor seconds", "MiB")


def write(path, columns, rows):
    form = "  ".join(["{:22}"] * 2 + ["{:>14}"] * (len(columns) - 2)).format
    print()
    for each in (columns, *rows):
        if "curve" not in each:
            print(form(*each), flush=True)
    if path:
        with open(path, "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([columns, *rows])


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--out", metavar="FOLDER", help="of the CSV files")
    options.add_argument("--pairs", metavar="FILE", help="JSON of every pair")
    options.add_argument("--of", metavar="FILE", action="append", default=[],
                         help="JSON of pairs that were measured before")
    options.add_argument("--keep", metavar="FOLDER", type=pathlib.Path,
                         help="of the pictures that peers compare")
    options.add_argument("--size", default="240x180")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--scenes", default="")
    options.add_argument("--peers", default=";".join(PEERS), help="separated by semicolons")
    options.add_argument("--odiff", metavar="FILE", default="odiff", help="the program odiff")
    options.add_argument("--vtk", metavar="PYTHON", default=sys.executable,
                         help="with the package vtk 9.4 or newer, for its SSIM")
    options.add_argument("--other", metavar="PYTHON", action="append", default=[],
                         help="with Relievo for another VTK; may be given several times")
    options.add_argument("--frames", choices=("yes", "no"), help="of 1920 x 1080 pixels")
    options.add_argument("--quick", action="store_true", help="few faults, and no peers")
    options.add_argument("--write-frames", metavar="FOLDER", type=pathlib.Path,
                         help="only draws the scenes into this folder")
    options.add_argument("--elsewhere", metavar="FOLDER", type=pathlib.Path,
                         help="of --write-frames on another machine; only compares these")
    options.add_argument("--draw", help=argparse.SUPPRESS)
    options.add_argument("--time", nargs=2, help=argparse.SUPPRESS)
    given = options.parse_args()
    if given.draw:
        draw_all(*json.loads(given.draw))
        return
    if given.time:
        time_frames(given.time)
        return
    given.frames = given.frames or ("no" if given.quick or given.elsewhere else "yes")
    default = ",".join(QUICK if given.quick else compare_scenes.SCENES)
    names = (given.scenes or default).split(",")
    size = tuple(int(each) for each in given.size.split("x"))
    if given.write_frames:
        given.write_frames.mkdir(parents=True, exist_ok=True)
        draw_all(names, size, 0, 0, given.write_frames)
        return
    peers = {}
    for name in given.peers.split(";") if given.peers and not given.quick else ():
        score = PEERS[name][0](given)
        if score:
            peers[name] = score
        else:
            print(f"{name} is left out: it is not here", flush=True)
    if given.keep:
        given.keep.mkdir(parents=True, exist_ok=True)
    pairs = []
    draws = elsewhere if given.elsewhere else measure
    for pair in earlier(given.of, peers) if given.of else draws(given, names, size, peers):
        pairs.append(pair)
        if (pair.is_fault and pair.is_visible() and not pair.right[OURS[0]]) or (
                not pair.is_fault and pair.scores[OURS[0]]):  # fmt: skip
            print(f"{pair.scene}, {pair.kind} {pair.size}, {pair.pixels} pixels, expected "
                  f"{pair.causes}: {pair.said}", flush=True)  # fmt: skip
    if given.pairs:
        with open(given.pairs, "w", encoding="utf-8") as file:
            json.dump([dataclasses.asdict(pair) for pair in pairs], file, indent=1)
    folder = pathlib.Path(given.out) if given.out else None
    if folder:
        folder.mkdir(parents=True, exist_ok=True)
    for name, columns, rows in (
        ("compare", COLUMNS, summary(pairs)),
        ("compare-faults", KINDS, by_kind(pairs)),
        ("compare-frames", FRAMES, large_frames() if given.frames == "yes" else []),
    ):  # fmt: skip
        rows = list(rows)
        if rows:
            write(folder and folder / f"{name}.csv", columns, rows)


if __name__ == "__main__":
    main()
