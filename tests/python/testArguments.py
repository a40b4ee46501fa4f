# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments that a wrapped method cannot use raise, or do nothing; they never end the program."""

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import types
import unittest

import numpy
import relievo
import scenes
from vtkmodules.vtkCommonCore import vtkObject

NUMBERS = {"int": 1, "float": 0.5, "bool": True}
SURROGATE = "a\ud800"  # no Unicode text

# VTK's macros have them for every class, of VTK as well: they look into a name that is not there.
# Registering is counting references.
VTKS_OWN = {"IsA", "IsTypeOf", "GetNumberOfGenerationsFromBase",
            "GetNumberOfGenerationsFromBaseType", "Register", "UnRegister"}

# VTK's wrapping ends the program on a list of such text: vtkRelievoPass, which derives from these
# in Python, looks at it first. See Package.
CHECKED_BELOW = {("vtkRelievoFramePass", "ReadLayers"), ("vtkRelievoFramePass", "TryReadLayers")}


def classes():
    """The package's classes, with methods inherited within it."""
    found = []
    for thing in vars(relievo).values():
        for each in thing.__mro__ if isinstance(thing, type) else ():
            if each.__name__.startswith("vtkRelievo") and each not in found:
                found.append(each)
    return found


def made(name):
    """An object of a class, or None if there is no such class, or it is abstract."""
    modules = [relievo] + [module for path, module in sys.modules.items()
                           if path.startswith("vtkmodules.vtk")]
    for module in modules:
        kind = getattr(module, name, None)
        if isinstance(kind, type):
            try:
                return kind()
            except TypeError:
                return None
    return None


def value_of(kind, text):
    kind = kind.strip().split("=")[0]
    if kind == "str":
        return text
    if kind.startswith(("(", "[")):
        return [value_of(part, text) for part in kind[1:-1].split(",") if part.strip()]
    return NUMBERS[kind] if kind in NUMBERS else made(kind)


def signatures(name, words):
    """The kinds of arguments of each overload, as VTK's wrapping documents them."""
    for found in re.finditer(rf"^\s*{name}\((.*?)\)\s*->", words or "", re.M | re.S):
        arguments = re.split(r",\s*(?![^(\[]*[)\]])", " ".join(found[1].split()))
        yield [each.split(":", 1)[1] for each in arguments if ":" in each]


def calls_of(kind, text):
    """Name and arguments of each attempt: all and each argument None, and text."""
    for name, method in vars(kind).items():
        if name.startswith("_") or name in VTKS_OWN or not callable(method):
            continue
        for kinds in signatures(name, method.__doc__):
            if text is None:
                yield name, [None] * len(kinds)
                good = [value_of(each, "a") for each in kinds]
                for i in range(len(kinds)):
                    yield name, good[:i] + [None] + good[i + 1:]
            elif "str" in " ".join(kinds) and (kind.__name__, name) not in CHECKED_BELOW:
                yield name, [value_of(each, text) for each in kinds]


def crashes(kind, text):
    """The calls that end a process, of all calls of a class; each is in a process of its own class,
    which begins anew after a crash."""
    found = []
    count = skipped = 0
    while True:
        read, write = os.pipe()
        child = os.fork()
        if child == 0:
            signal.alarm(60)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            thing = made(kind.__name__)
            for i, (name, arguments) in enumerate(calls_of(kind, text)):
                if i < skipped:
                    continue
                os.write(write, f"{i} {name}{ascii(arguments)}\n".encode())
                try:
                    getattr(thing if thing is not None else kind, name)(*arguments)
                except Exception:
                    pass
            os._exit(0)
        os.close(write)
        with os.fdopen(read) as pipe:
            tried = pipe.read().splitlines()
        status = os.waitpid(child, 0)[1]
        count += len(tried)
        if status == 0 or not tried:
            return found if status == 0 else found + [f"{kind.__name__}: status {status}"], count
        found.append(f"{kind.__name__}.{tried[-1].split(' ', 1)[1]}: status {status}")
        skipped = int(tried[-1].split()[0]) + 1


class Wrapped(unittest.TestCase):
    def check(self, text, least):
        faults, count = [], 0
        for kind in classes():
            found, tried = crashes(kind, text)
            faults += found
            count += tried
        self.assertEqual(faults, [])
        self.assertGreater(count, least)

    def test_none(self):
        self.check(None, 800)

    def test_text(self):
        self.check(SURROGATE, 40)


class Package(unittest.TestCase):
    def test_text(self):
        """Names and files of the package's functions."""
        renderer = scenes.plane_and_sphere()
        image = relievo.capture(renderer, ["depth"], (30, 20))
        frame = relievo.attach(renderer)
        calls = {
            "capture": lambda: relievo.capture(renderer, [SURROGATE], (30, 20)),
            "RequestLayer": lambda: frame.RequestLayer(SURROGATE),
            "SetDisplayLayer": lambda: frame.SetDisplayLayer(SURROGATE),
            "ReadLayer": lambda: frame.ReadLayer(SURROGATE, image),
            "ReadLayers": lambda: frame.ReadLayers(["depth", SURROGATE], image),
            "TryReadLayers": lambda: frame.TryReadLayers([SURROGATE], image),
            "stage": lambda: relievo.stage(renderer, SURROGATE),
            "parameter": lambda: relievo.stage(renderer, "fog", **{SURROGATE: 1}),
            "value": lambda: relievo.stage(renderer, "fog", mode=SURROGATE),
            "layer": lambda: relievo.layer(image, SURROGATE),
            "write_exr": lambda: relievo.write_exr(f"{SURROGATE}.exr", image),
            "compression": lambda: relievo.write_exr("a.exr", image, compression=SURROGATE),
            "read_exr": lambda: relievo.read_exr(SURROGATE),
            "environment": lambda: relievo.environment(renderer, SURROGATE),
            "to_image": lambda: relievo.to_image({SURROGATE: numpy.zeros((2, 2), "f4")}),
        }
        for name, call in calls.items():
            with self.subTest(name):
                self.assertRaises((ValueError, OSError), call)

    def test_names_of_arguments(self):
        """Arguments in a wrong order, and of wrong types: the error names the argument."""
        renderer = scenes.plane_and_sphere()
        image = relievo.capture(renderer, ["depth"], (30, 20))
        camera, heights = renderer.GetActiveCamera(), numpy.random.default_rng(1).random((4, 4))
        terrain = relievo.terrain(heights, (1, 0, 0, 0, -1, 4))
        for name, call in (
            ("directory", lambda: relievo.write_dataset(renderer, "folder", [camera])),
            ("description", lambda: relievo.write_dataset(renderer, camera, "a", description=5)),
            ("objects", lambda: relievo.write_dataset(renderer, camera, "a", objects=5)),
            ("path", lambda: relievo.write_baseline(renderer, "a.exr")),
            ("path", lambda: relievo.compare(image, image).write_html(image)),
            ("path", lambda: relievo.write_gltf(renderer, "a.glb")),
            ("path", lambda: relievo.write_exr(image, "a.exr")),
            ("path", lambda: relievo.write_png(image, "a.png")),
            ("path", lambda: relievo.read_exr(image)),
            ("path", lambda: relievo.show(image, "depth", image)),
            ("path", lambda: relievo.rays(terrain.dataset).write(None)),
            ("path", lambda: terrain.write({"a": heights}, "a.tif")),
            ("path", lambda: terrain.write("a.tif\0b.tif", {"a": heights})),
            ("path", lambda: relievo.write_exr(b"a.exr\0b.exr", image)),
            ("rasters", lambda: terrain.write("a.tif", heights)),
            ("nodata", lambda: relievo.terrain(heights, terrain.transform, "none")),
            ("files", lambda: relievo.scene(renderer)),
        ):  # fmt: skip
            with self.subTest(name), self.assertRaisesRegex(ValueError, f"^{name}: got .*expected"):
                call()

    def test_without_display_of_warnings(self):
        """vtkObject.GlobalWarningDisplayOff() silences VTK but not exceptions, and stays."""
        renderer = scenes.plane_and_sphere()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(vtkObject.SetGlobalWarningDisplay, vtkObject.GetGlobalWarningDisplay())

        def broken(name):
            path = os.path.join(folder.name, name)
            with open(path, "w", encoding="utf-8") as file:
                file.write("{")
            return path
        exr, image, lens, model, mesh = map(
            broken, ("a.exr", "a.png", "a.yml", "a.gltf", "a.vtp"))  # fmt: skip
        for call in (
            lambda: relievo.read_exr(exr), lambda: relievo.environment(renderer, exr),
            lambda: relievo.environment(renderer, image), lambda: relievo.lens(lens),
            lambda: relievo.lens("fisheye:1,2,x"), lambda: relievo.scene(model).update(),
            lambda: relievo.scene(mesh).update(),
            lambda: relievo.capture(renderer, ["none such"], (30, 20)),
            lambda: relievo.stage(renderer, "tone", operator="none such"),
        ):  # fmt: skip
            said = []
            for switch in (True, False):
                vtkObject.SetGlobalWarningDisplay(switch)
                with self.assertRaises((ValueError, OSError)) as caught:
                    call()
                said.append((type(caught.exception), str(caught.exception)))
                self.assertEqual(bool(vtkObject.GetGlobalWarningDisplay()), switch)
            self.assertEqual(*said)

    def test_a_pipe_for_a_lens(self):
        with tempfile.TemporaryDirectory() as folder:
            os.mkfifo(f"{folder}/pipe.yml")
            with self.assertRaisesRegex(ValueError, "pipe.yml: expected a file, not a .*pipe"):
                relievo.lens(f"{folder}/pipe.yml")

    @unittest.skipUnless(shutil.which("cc"), "there is no compiler")
    def test_a_program_with_another_vtk(self):
        """ParaView's Python, by a library that has a function of VTK for everybody."""
        with tempfile.TemporaryDirectory() as folder:
            library = f"{folder}/libvtkCommonCore-pv0.so.1"
            subprocess.run(
                ["cc", "-shared", "-fPIC", "-xc", "-o", library, "-"], check=True, text=True,
                input="void *_ZN9vtkObject3NewEv(void) { return 0; }")  # fmt: skip
            done = subprocess.run(
                [sys.executable, "-c", "import relievo"], text=True, stderr=subprocess.PIPE,
                env={**os.environ, "LD_PRELOAD": library}, check=False)  # fmt: skip
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr.splitlines()[-1],
                         "^ImportError: relievo: .*libvtkCommonCore-pv0.*ParaView")  # fmt: skip

    def test_another_vtk(self):
        """A renderer of another VTK in the process is refused, with the packages of both."""
        words = {"IsA": lambda self, name: name == "vtkRenderer", "GetPass": lambda self: None,
                 "GetClassName": lambda self: "vtkOpenGLRenderer",
                 "__module__": "another.vtkRenderingOpenGL2"}  # fmt: skip
        stranger = type("vtkOpenGLRenderer", (), words)()
        plotter = types.SimpleNamespace(renderer=stranger)
        says = (f"^renderer: got (SimpleNamespace with )?a vtkOpenGLRenderer of another, "
                f"another VTK than .*from relievo.vtk")  # fmt: skip
        for call in (
            lambda: relievo.attach(stranger), lambda: relievo.detach(stranger),
            lambda: relievo.capture(stranger, "depth", (30, 20)),
            lambda: relievo.capture(plotter, "depth", (30, 20)),
            lambda: relievo.stage(stranger, "shadows"),
            lambda: relievo.environment(stranger, "a.exr"),
        ):  # fmt: skip
            self.assertRaisesRegex(ValueError, says, call)

    def test_data_of_another_vtk(self):
        """So are data, filters, actors and images, also of classes that derive from its own."""
        base = type("vtkObjectBase", (), {"__module__": "another.vtkCommonCore"})

        def stranger(name, *kinds):
            words = {"IsA": lambda self, kind: kind in (name, *kinds),
                     "GetClassName": lambda self: name, "__module__": "client"}  # fmt: skip
            return type(name, (base,), words)()

        renderer = scenes.plane_and_sphere()
        mesh = stranger("vtkPolyData", "vtkDataSet")
        image = stranger("vtkImageData", "vtkDataSet")
        actor = stranger("vtkActor", "vtkProp3D")
        source = stranger("vtkSphereSource", "vtkAlgorithm")
        output = stranger("vtkAlgorithmOutput")
        window = stranger("vtkRenderWindow")
        scene = relievo.scene()
        for given, call in (
            (mesh, lambda: relievo.lamps(renderer, mesh, radius=1)),
            (source, lambda: relievo.fog(renderer, source, radius=1)),
            (output, lambda: relievo.fog(renderer, output, radius=1)),
            (actor, lambda: relievo.markers(renderer, actor, radius=1)),
            (actor, lambda: relievo.markers(renderer, [actor], radius=1)),
            (mesh, lambda: relievo.capture(mesh)),
            (image, lambda: relievo.environment(renderer, image)),
            (image, lambda: relievo.write_exr("a.exr", image)),
            (window, lambda: setattr(scene, "window", window)),
        ):
            name = given.GetClassName()
            self.assertRaisesRegex(ValueError, f"got a {name} of another, another VTK than ", call)


if __name__ == "__main__":
    unittest.main()
