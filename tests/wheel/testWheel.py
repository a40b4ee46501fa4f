# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel itself: its contents, its requirements, and its first use."""

import importlib.metadata
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile

from relievo._build import VTK

WHEEL = pathlib.Path(os.environ["RELIEVO_WHEEL"])
INDEX = os.environ["RELIEVO_WHEEL_INDEX"]
BASE_PYTHON = os.environ["RELIEVO_WHEEL_BASE_PYTHON"]
DATA = pathlib.Path(os.environ["RELIEVO_DATA"])

# Available on any Linux with that glibc; the rest comes with the wheel.
SYSTEM = r"lib(c|m|gcc_s|stdc\+\+|pthread|dl|rt|z)\.so\.\d+|ld-linux-x86-64\.so\.2"
TRIED = r"WARN\| (bad X server connection|libOSMesa not found)"

DRAWS = """
import relievo
from relievo.vtk.vtkFiltersSources import vtkSphereSource
depth = relievo.layer(relievo.capture(vtkSphereSource(), "depth", size=(32, 24)), "depth")
print("drew", depth.shape, depth[12, 16] < depth[0, 0])
"""
OTHER_DRAWS = """
import vtk
window, renderer = vtk.vtkRenderWindow(), vtk.vtkRenderer()
window.SetOffScreenRendering(True)
window.AddRenderer(renderer)
window.Render()
try:
    relievo.capture(renderer)
except ValueError as error:
    print(error)
"""
CLIENT = """
import relievo
relievo.provide_vtkmodules()
relievo.provide_vtkmodules()
import vtk
import vtk.util.numpy_support, vtkmodules.util.numpy_support
from vtkmodules.vtkRenderingCore import vtkFlagpoleLabel, vtkRenderer
import relievo.vtk.vtkRenderingCore
class Label(vtkFlagpoleLabel):
    pass
try:
    Label()
except NotImplementedError as error:
    print(error)
print(vtkRenderer is relievo.vtk.vtkRenderingCore.vtkRenderer, vtk.vtkRenderer is vtkRenderer)
relievo.attach(vtkRenderer())
"""
TOO_LATE = """
import relievo
import vtkmodules.vtkCommonCore
try:
    relievo.provide_vtkmodules()
except ImportError as error:
    print(error)
"""
DREW = "drew (24, 32) True\n"
BACKEND = "import pyvista; print(pyvista.vtk_backend())"


class Files(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        kept = tempfile.TemporaryDirectory()
        cls.addClassCleanup(kept.cleanup)
        cls.folder = pathlib.Path(kept.name)
        zipfile.ZipFile(WHEEL).extractall(cls.folder)
        cls.files = [path for path in cls.folder.rglob("*") if path.is_file()]

    def test_size(self):
        self.assertLess(WHEEL.stat().st_size, 70e6)  # PyPI takes 100 MB

    def test_it_is_complete(self):
        """Each library that a file of it names is in it, or in every Linux."""
        own = {path.name for path in self.files}
        for path in self.files:
            if path.read_bytes()[:4] != b"\x7fELF":
                continue
            said = subprocess.run(["readelf", "-dW", path], capture_output=True, text=True,
                                  check=True).stdout  # fmt: skip
            for name in re.findall(r"\(NEEDED\).*\[(.*)\]", said):
                if not re.fullmatch(SYSTEM, name):
                    self.assertIn(name, own, path.name)
            paths = re.findall(r"\(R(?:UN)?PATH\).*\[(.*)\]", said)
            for each in ":".join(paths).split(":"):
                self.assertRegex(each, r"^(\$ORIGIN.*)?$", f"{path.name} looks outside the wheel")
        for name in ("OpenEXR", "assimp", "draco", "Imath", "yaml-cpp", "vtkRenderingOpenGL2"):
            self.assertTrue(any(name in file for file in own), name)

    def test_reading_process(self):
        """The program that reads files may be executed, and finds its libraries."""
        (program,) = [path for path in importlib.metadata.files("vtk-relievo")
                      if path.name == "relievo-reader"]  # fmt: skip
        done = subprocess.run([program.locate()], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("expected to be started by a program", done.stderr)

    def test_licences(self):
        """Licences of included libraries are passed on."""
        texts = {path.stem: path.read_text() for path in self.files
                 if path.parent.name == "licenses"}  # fmt: skip
        self.assertIn("BSD", texts["LICENSE"])
        with_it = [path for path in self.files if path.parent.name.endswith(".libs")]
        vtk = self.folder / "relievo" / "licenses" / "vtk"
        self.assertIn("Ken Martin", (vtk / "vtkRenderingCore" / "LICENSE").read_text())
        self.assertTrue(any(vtk.glob("vtkhdf5/*")))
        self.assertGreater(len(with_it), 4)
        for path in with_it:
            library = re.match(r"lib([A-Za-z]+(?:-cpp)?)", path.name)[1]
            part = "openexr" if library in ("Iex", "IlmThread") else library.lower()
            self.assertIn("Copyright", texts.get(part, ""), path.name)

    def test_metadata(self):
        said = importlib.metadata.metadata("vtk-relievo")
        self.assertEqual(said.get_all("Requires-Dist"), ["numpy"])
        self.assertTrue(WHEEL.name.startswith(f"vtk_relievo-{said['Version']}-"), WHEEL.name)
        self.assertIn("manylinux", WHEEL.name)


class Imports(unittest.TestCase):
    def run_script(self, script, **environment):
        """Its output; it exits normally without error output, except VTK's about a missing
        display or library."""
        done = subprocess.run(
            [sys.executable, "-c", script],
            env={**os.environ, "PYTHONPATH": "", **environment},
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=600, check=False,
        )  # fmt: skip
        said = [line for line in done.stderr.splitlines() if not re.search(TRIED, line)]
        self.assertEqual((done.returncode, said), (0, []), script)
        return done.stdout

    def test_order(self):
        """Before, after and without its VTK's modules, and another VTK, of PyPI's `vtk`."""
        own = "import relievo.vtk.vtkRenderingOpenGL2, relievo.vtk.vtkIOXML, relievo.vtk.all\n"
        for script in (DRAWS, own + DRAWS, DRAWS + own, "import vtk\n" + DRAWS):
            self.assertEqual(self.run_script(script), DREW)
        said = self.run_script(DRAWS + OTHER_DRAWS)
        refusal = ("renderer: got a vtkOpenGLRenderer of vtkmodules,.*classes from relievo.vtk, or "
                   "call relievo.provide_vtkmodules()")  # fmt: skip
        self.assertRegex(said, f"^{re.escape(DREW)}{refusal}")

    def test_clients_of_vtkmodules(self):
        """They get the wheel's VTK by that name, where they ask for it soon enough."""
        said = self.run_script(CLIENT)
        self.assertRegex(said, f"^vtkFlagpoleLabel: {VTK}, .* no such class\nTrue True\n$")
        said = self.run_script(TOO_LATE)
        self.assertRegex(said, "^provide_vtkmodules: .*already.*call it before")

    def test_without_a_display(self):
        for display in ("", ":54321"):
            self.assertEqual(self.run_script(DRAWS, DISPLAY=display), DREW)

    def test_without_opengl(self):
        """One line names the missing package."""
        said = self.run_script(
            f"try:\n    exec({DRAWS!r})\nexcept RuntimeError as error:\n    print(error)",
            VTK_DEFAULT_OPENGL_WINDOW="vtkOSOpenGLRenderWindow",
        )
        self.assertRegex(said, r"^capture: no OpenGL: [^\n]*driver[^\n]*\n$")


    def test_without_x11(self):
        """Where X11 cannot be loaded, nor Mesa's EGL, which needs it: a line, and no crash."""
        with tempfile.TemporaryDirectory() as folder:
            for name in ("libX11.so.6", "libX11.so"):
                pathlib.Path(folder, name).touch()
            mesh = DATA / "bunny.off"
            done = subprocess.run(
                [os.environ["RELIEVO"], "render", mesh, "--png", "a.png"], cwd=folder,
                env={**os.environ, "LD_LIBRARY_PATH": folder, "DISPLAY": ""},
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
            )  # fmt: skip
            if done.returncode != 0:  # an EGL that does without X11 draws
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertRegex(done.stdout, r"^relievo: no OpenGL: [^\n]*driver[^\n]*\n$")


class Install(unittest.TestCase):
    def test_as_a_user(self):
        """From an interpreter with its venv to a picture: without root, without a network. PyVista
        has its usual VTK before, beside and after the wheel, but where relievo is imported."""
        with tempfile.TemporaryDirectory() as folder:
            os.chmod(folder, 0o777)
            script = f"""
set -e
cd {folder}
{BASE_PYTHON} -m venv v
v/bin/pip install -q --no-index --find-links {INDEX} {WHEEL} pyvista
v/bin/relievo render bunny.off --png a.png
v/bin/python -c "import relievo; relievo.scene('bunny.off').render('b.png')"
v/bin/python -c "{BACKEND}"
v/bin/python -c "import relievo; {BACKEND}"
PYVISTA_VTK_BACKEND=relievo.vtk v/bin/python -c "{BACKEND}"
v/bin/pip uninstall -q -y vtk-relievo
v/bin/python -c "{BACKEND}"
"""
            mesh = pathlib.Path(folder, "bunny.off")
            mesh.write_bytes((DATA / "bunny.off").read_bytes())
            wrapper = []
            if os.getuid() == 0:
                wrapper = ["unshare", "--net"]
                home = pathlib.Path.home()
                if home not in pathlib.Path(BASE_PYTHON).resolve().parents:  # others may not use it
                    wrapper += ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
            done = subprocess.run(
                [*wrapper, "bash", "-c", script], capture_output=True, text=True, timeout=600,
                env={"PATH": "/usr/bin:/bin", "HOME": folder, "LC_ALL": "C.UTF-8"}, check=False,
            )  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout.split(), ["vtk", VTK, "relievo.vtk", "vtk"])
            first, second = (pathlib.Path(folder, name).read_bytes() for name in ("a.png", "b.png"))
            self.assertEqual(first[:8], b"\x89PNG\r\n\x1a\n")
            self.assertGreater(len(first), 20000, "an empty picture")
            self.assertEqual(first, second)


if __name__ == "__main__":
    unittest.main(verbosity=2)
