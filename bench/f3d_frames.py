# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relievo beside F3D, another viewer on VTK: time to load, to the first picture, and per frame.

    python bench/f3d_frames.py DATA [--rounds N] [--files a,b] [--size WxH] >f3d.csv

In a Python that has both: `pip install relievo f3d`. DATA is the folder that tools/unpack-data
fills. In every round each program is started again, in random order, and draws the file
off-screen from one camera, which further frames turn: F3D with its own look (PBR under a light
kit), Relievo with --preset none (Phong under a headlight), that with PBR, and Relievo with its
default, the preset studio, which has shadows. `loaded` ends when the package is imported, `first
picture` when its pixels are in memory; `frame` is the median of some. The objects in the first
pictures must cover the same pixels. A ratio is the median of the rounds' ratios to F3D, +- half the
distance of its quartiles. On a machine with other work (the load is in the last column), ratios of
processor time, over all threads, vary less.
Exit status: 0; 3 if F3D or Relievo cannot be imported; 1 if the programs draw different objects.
"""

import argparse
import csv
import importlib.util
import json
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import time

FILES = {"armadillo": "armadillo.off", "bunny": "bunny.off", "motorBike": "motorBike.obj"}
PEER = "F3D"
PROGRAMS = (PEER, "Relievo", "Relievo, PBR", "Relievo, studio")
STEPS = ("loaded", "first picture", "frame")
FRAMES = 15
TURN = 3  # degrees per frame
ALIKE = 0.97  # share of the pixels covered in either picture
MISSING = 3  # exit status
BACKGROUND = (51, 51, 51)  # F3D's own


class InF3D:
    def __init__(self, path, size, camera):
        self.engine = self.package.Engine.create(True)
        self.engine.window.size = size
        self.engine.scene.add(str(path))
        self.camera = self.engine.window.camera
        self.camera.position, self.camera.focal_point, self.camera.view_up = (
            camera[0:3], camera[3:6], camera[6:9])  # fmt: skip
        self.camera.view_angle = 30
        self.camera.set_current_as_default()

    def turn(self):
        self.camera.azimuth(TURN)

    def draw(self):
        self.engine.window.render()

    def pixels(self):
        import numpy

        image = self.engine.window.render_to_image()
        return numpy.frombuffer(image.content, numpy.uint8).reshape(
            image.height, image.width, image.channel_count)[::-1, :, :3]  # fmt: skip

    @classmethod
    def load(cls):
        import f3d

        f3d.Log.set_verbose_level(f3d.Log.QUIET)
        cls.package = f3d


class InRelievo:
    look = {"preset": "none"}  # the default is the preset studio

    def __init__(self, path, size, camera):
        self.scene = self.package.scene(
            str(path), size=size, camera=camera, view_angle=30, **self.look,
            background="/".join(str(each / 255) for each in BACKGROUND))  # fmt: skip
        self.renderer, self.window = self.scene.renderer, self.scene.window

    def turn(self):
        self.renderer.GetActiveCamera().Azimuth(TURN)
        self.renderer.ResetCameraClippingRange()

    def draw(self):
        self.window.Render()
        self.window.WaitForCompletion()

    def pixels(self):
        grab = self.grabs()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        return self.package.from_image(grab.GetOutput())[..., :3]

    @classmethod
    def load(cls):
        import relievo

        cls.package = relievo
        vtk = relievo.vtkRelievoPass.__mro__[-2].__module__.split(".")[0]  # vtkmodules, or cvista
        core = importlib.import_module(f"{vtk}.vtkRenderingCore")
        cls.grabs = core.vtkWindowToImageFilter


class InRelievoWithPBR(InRelievo):
    look = {"preset": "none", "shading": "pbr"}


class InRelievoStudio(InRelievo):
    look = {"preset": "studio"}


def camera_of(path):
    """Position, focal point and view-up of an oblique view of the whole file."""
    InRelievo.load()
    camera = InRelievo.package.scene(str(path)).renderer.GetActiveCamera()
    camera.Azimuth(30)
    camera.Elevation(20)
    camera.OrthogonalizeViewUp()
    return [*camera.GetPosition(), *camera.GetFocalPoint(), *camera.GetViewUp()]


def clocks():
    """Seconds since the start of the machine, and the processor time of this process."""
    return time.monotonic(), time.process_time()


def work(program, path, size, camera, started, file):
    """Draws in a process; prints the elapsed and processor milliseconds of each step."""
    kinds = (InF3D, InRelievo, InRelievoWithPBR, InRelievoStudio)
    kind = dict(zip(PROGRAMS, kinds, strict=True))[program]
    kind.load()
    times = {"loaded": [1e3 * (clocks()[0] - started), 1e3 * clocks()[1]]}
    scene = kind(path, size, camera)
    first = scene.pixels().copy()
    times["first picture"] = [1e3 * (clocks()[0] - started), 1e3 * clocks()[1]]
    frames = []
    for _ in range(FRAMES):
        before = clocks()
        scene.turn()
        scene.draw()
        frames.append([1e3 * (b - a) for a, b in zip(before, clocks(), strict=True)])
    times["frame"] = [statistics.median(each) for each in zip(*frames, strict=True)]
    first.tofile(file)
    print(json.dumps(times), flush=True)


def run(*words):
    """The last line of a new process of this script; VTK and F3D print others before."""
    done = subprocess.run([sys.executable, __file__, "--work", json.dumps(words)],
                          capture_output=True, text=True, check=False)  # fmt: skip
    if done.returncode != 0:
        raise SystemExit(f"f3d_frames: {words[0]} failed\n{done.stderr}")
    return json.loads(done.stdout.splitlines()[-1])


def same_object(pictures):
    """Raises SystemExit unless the objects of all pictures cover the same pixels."""
    import numpy

    covered = {name: (numpy.abs(each.astype(int) - BACKGROUND) > 2).any(axis=2)
               for name, each in pictures.items()}  # fmt: skip
    for name, mask in covered.items():
        share = (mask & covered[PEER]).sum() / max(1, (mask | covered[PEER]).sum())
        if share < ALIKE:
            raise SystemExit(f"f3d_frames: {name} and {PEER} draw different objects: "
                             f"{100 * share:.1f} % of the pixels are covered in both")  # fmt: skip


def ratio(times, others):
    """The median of the ratios of two series, and half the distance of their quartiles."""
    ratios = [a / b for a, b in zip(times, others, strict=True)]
    if len(ratios) == 1:
        return ratios[0], 0.0
    low, _, high = statistics.quantiles(ratios, n=4)
    return statistics.median(ratios), (high - low) / 2


def bench(writer, name, path, size, rounds):
    import numpy

    camera = run("camera", str(path))
    times = {(program, step): [] for program in PROGRAMS for step in STEPS}
    with tempfile.TemporaryDirectory() as folder:
        for number in range(rounds + 1):  # the first warms the files and the shaders' cache
            pictures = {}
            for program in random.sample(PROGRAMS, len(PROGRAMS)):
                file = pathlib.Path(folder, program)
                found = run(program, str(path), size, camera, time.monotonic(), str(file))
                pictures[program] = numpy.fromfile(file, numpy.uint8).reshape(size[1], size[0], 3)
                for step in STEPS if number else ():
                    times[program, step].append(found[step])
            same_object(pictures)
    for step in STEPS:
        for program in PROGRAMS:
            cells = [name, step, program]
            for clock in (0, 1):
                own, peer = ([each[clock] for each in times[which, step]]
                             for which in (program, PEER))  # fmt: skip
                found = ratio(own, peer)
                cells += [f"{statistics.median(own):.1f}", f"{found[0]:.3f}", f"{found[1]:.3f}"]
            writer.writerow([*cells, rounds, f"{os.getloadavg()[0]:.1f}"])
    sys.stdout.flush()


def main():
    if sys.argv[1:2] == ["--work"]:
        words = json.loads(sys.argv[2])
        if words[0] == "camera":
            print(json.dumps(camera_of(words[1])))
        else:
            work(*words)
        return
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("data")
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--files", default=",".join(FILES))
    parser.add_argument("--size", default="1280x720")
    given = parser.parse_args()
    for package in ("f3d", "relievo"):
        if importlib.util.find_spec(package) is None:
            print(f"skipped: this Python has no {package}; `pip install relievo f3d`, or relievo's "
                  f"wheel", file=sys.stderr)  # fmt: skip
            raise SystemExit(MISSING)
    columns = ["milliseconds", "ratio", "+-"]
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["file", "step", "program", *columns,
                     *(f"processor {each}" for each in columns), "rounds", "load"])  # fmt: skip
    size = [int(each) for each in given.size.split("x")]
    for name in given.files.split(","):
        bench(writer, name, pathlib.Path(given.data) / FILES[name], size, given.rounds)


if __name__ == "__main__":
    main()
