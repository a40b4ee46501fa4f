# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""pyproject.toml compared with the files it names; tools/wheel builds with it."""

import ast
import configparser
import importlib.util
import inspect
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest
from importlib.metadata import metadata, version

import relievo
from relievo._package import stub as _stub
from relievo._package import vtkmodules as _vtkmodules

ROOT = pathlib.Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
CMAKE = (ROOT / "CMakeLists.txt").read_text()


class Pyproject(unittest.TestCase):
    def test_version(self):
        """scikit-build-core's regex finds the version that CMake and the installed package have."""
        settings = PROJECT["tool"]["scikit-build"]["metadata"]["version"]
        self.assertIn("version", PROJECT["project"]["dynamic"])
        found = re.search(settings["regex"], (ROOT / settings["input"]).read_text())
        self.assertEqual(found["value"], re.search(r"VERSION (\d+\.\d+\.\d+)", CMAKE)[1])
        self.assertEqual(found["value"], version("vtk-relievo"))
        self.assertEqual(found["value"], relievo.__version__)
        self.assertEqual(PROJECT["project"]["description"], metadata("vtk-relievo")["Summary"])
        self.assertEqual(PROJECT["project"]["name"], metadata("vtk-relievo")["Name"])

    def test_entry_points(self):
        """Those of an installation by CMake, and each is there."""
        installed = configparser.ConfigParser(delimiters="=")
        installed.optionxform = str
        installed.read(ROOT / "python" / "entry_points.txt")
        self.assertEqual(PROJECT["project"]["entry-points"],
                         {name: dict(group) for name, group in installed.items() if group})
        sys.path.insert(0, str(pathlib.Path(__file__).parent / "standin"))
        for kind, group in PROJECT["project"]["entry-points"].items():
            if kind == "pytest11" and importlib.util.find_spec("pytest") is None:
                continue  # it imports pytest, which loads it
            for value in group.values():
                module, _, name = value.partition(":")
                loaded = importlib.import_module(module)
                self.assertTrue(not name or callable(getattr(loaded, name)))

    def test_build(self):
        """One version of VTK to build and to run with; files, components and options that are."""
        needed = [*PROJECT["build-system"]["requires"], *PROJECT["project"]["dependencies"],
                  *(ROOT / "wheels.txt").read_text().splitlines()]  # fmt: skip
        pins = [re.split("[ ;]", each)[0].split("==") for each in needed if "cvista" in each]
        pins = {name: version for name, version in (each for each in pins if len(each) == 2)}
        self.assertEqual(set(pins), {"cvista[all]", "cvista-sdk"})
        self.assertEqual(len(set(pins.values())), 1, pins)
        backend = ROOT / PROJECT["build-system"]["backend-path"][0]
        self.assertTrue((backend / f"{PROJECT['build-system']['build-backend']}.py").is_file())
        for target in PROJECT["project"]["scripts"].values():
            self.assertTrue((backend / f"{target.split(':')[0]}.py").is_file())
        for name in (PROJECT["project"]["readme"], PROJECT["project"]["license"]["file"]):
            self.assertTrue((ROOT / name).is_file(), name)
        settings = PROJECT["tool"]["scikit-build"]
        for name in settings["cmake"]["define"]:
            text = CMAKE + "".join(path.read_text() for path in (ROOT / "cmake").glob("*.cmake"))
            if name.startswith("RELIEVO_"):
                self.assertRegex(text, rf"option\({name} ")
        used = "".join(path.read_text() for folder in ("apps", "python", "cmake")
                       for path in (ROOT / folder).rglob("*") if path.suffix in (".txt", ".cmake"))
        for component in settings["install"]["components"]:
            self.assertIn(f"COMPONENT {component}", used)


class Import(unittest.TestCase):
    def test_older_python(self):
        code = "import sys; sys.version_info = (3, 9, 18); import relievo"
        done = subprocess.run([sys.executable, "-c", code], stderr=subprocess.PIPE, text=True,
                              check=False)  # fmt: skip
        self.assertRegex(done.stderr, r"ImportError: relievo: got Python 3\.9, expected 3\.11 or ")

    def test_vtk(self):
        """relievo.vtk has the modules of the VTK that the classes derive from, loaded once."""
        code = """if True:
            import relievo.vtk.util.numpy_support
            from relievo.vtk.vtkRenderingCore import vtkRenderer
            from vtkmodules.vtkRenderingCore import vtkRenderer as usual
            print(vtkRenderer is usual, issubclass(relievo.vtkRelievoPass, vtkRenderer.__mro__[-3]))
            """
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                              check=False)  # fmt: skip
        self.assertEqual((done.stdout, done.stderr), ("True True\n", ""))

    def test_command(self):
        done = subprocess.run([sys.executable, "-m", "relievo", "--version"], check=False,
                              capture_output=True, text=True)  # fmt: skip
        self.assertEqual(done.stdout.splitlines()[0], f"relievo {relievo.__version__}", done.stderr)


class Stub(unittest.TestCase):
    def test_it_says_what_the_package_has(self):
        """Functions with the parameters, defaults and help that they have when they are called."""
        stub = {}
        exec(compile(_stub.make(relievo), "__init__.pyi", "exec"), stub)  # noqa: S102
        for name in relievo.__all__:
            has, says = getattr(relievo, name), stub[name]
            if inspect.isfunction(has):
                said, wanted = inspect.signature(says), inspect.signature(has)
                self.assertEqual(
                    [each.replace(annotation=each.empty) for each in said.parameters.values()],
                    [each.replace(annotation=each.empty) for each in wanted.parameters.values()],
                )
                for each in said.parameters.values():
                    self.assertIsNot(each.annotation, each.empty, f"{name}: {each}")
                self.assertEqual(inspect.getdoc(says), inspect.getdoc(has), name)
                self.assertIsNot(wanted.return_annotation, inspect.Signature.empty, name)
            else:
                self.assertIs(says, has, name)
        wrapped = {name for name in dir(relievo) if name.startswith("vtkRelievo")
                   and isinstance(getattr(relievo, name), type)}
        self.assertLessEqual(wrapped, stub.keys())
        self.assertTrue(pathlib.Path(relievo.__file__).with_name("py.typed").is_file())

    def test_wrapped_classes(self):
        """Each has its methods, with the modules of the types that they name."""
        with tempfile.TemporaryDirectory() as folder:
            _stub.write(relievo, pathlib.Path(folder))
            texts = {path.stem: path.read_text() for path in pathlib.Path(folder).glob("*.pyi")}
            vtk = pathlib.Path(folder, "vtk", "vtkRenderingCore.pyi").read_text()
            self.assertRegex(vtk, r"^from vtkmodules\.vtkRenderingCore import|\nclass vtkActor\b")
            self.assertTrue(pathlib.Path(folder, "vtk", "util", "numpy_support.pyi").is_file() or
                            (_vtkmodules.FOLDER / "vtk" / "__init__.py").is_file())  # fmt: skip
        if importlib.util.find_spec(f"{_stub.VTK}.generate_pyi") is None:
            self.assertIn("def __getattr__", texts["vtkRelievoMaterials"])
            return  # Debian's VTK 9.1 cannot describe its classes
        classes = {}
        for text in texts.values():
            for each in ast.parse(text).body:
                if isinstance(each, ast.ClassDef):
                    methods = {one.name for one in each.body if isinstance(one, ast.FunctionDef)}
                    classes[each.name] = methods
        for name in dir(relievo):
            kind = getattr(relievo, name)
            if isinstance(kind, type) and kind.__module__.startswith("relievo.vtkRelievo"):
                has = {each for each, thing in vars(kind).items() if each[0] != "_"
                       and callable(thing) and not isinstance(thing, type)}  # fmt: skip
                self.assertLessEqual(has, classes[name], name)
        self.assertIn(f"SetHeightMap(self, image:'{_stub._VTK}.vtkCommonDataModel.vtkImageData')",
                      texts["vtkRelievoMaterials"])  # fmt: skip


if __name__ == "__main__":
    unittest.main()
