# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds Relievo's wheel, for pip (pyproject.toml): scikit-build-core on the SDK of a VTK, then
auditwheel, which puts the libraries other than VTK's into the wheel.

The SDK is that of wheels.txt, or the folder of the setting `sdk` (--config-settings sdk=DIR). A VTK
whose Python package is `vtkmodules` is required from PyPI, in its version. Another, such as cvista,
is included in the wheel: installed beside it, it would become the VTK of every program that uses
PyVista.
"""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from auditwheel.wheeltools import InWheel
from scikit_build_core import build as core
from scikit_build_core.build import (  # noqa: F401  (pip calls them)
    build_sdist,
    get_requires_for_build_sdist,
)

ROOT = pathlib.Path(__file__).resolve().parents[2]
PINNED = ROOT / "build" / "vtk97-sdk"


def get_requires_for_build_wheel(config_settings=None):
    return core.get_requires_for_build_wheel(_split(config_settings)[1])


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    sdk, settings = _split(config_settings)
    name = core.prepare_metadata_for_build_wheel(metadata_directory, settings)
    if sdk is not None:
        _require(pathlib.Path(metadata_directory, name), *_vtk_of(sdk)[1:])
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    sdk, settings = _split(config_settings)
    if sdk is None:
        sdk = PINNED
        _run([ROOT / "tools" / "unpack-vtk", "--wheel", sdk], PYTHON=sys.executable)
    config, package, version = _vtk_of(sdk)
    settings["cmake.define.VTK_DIR"] = str(config)
    if package == "vtkmodules":
        settings["wheel.py-api"] = ""  # its modules are for one version of Python
    elif sys.version_info < (3, 12):
        # its own library for a Python that its SDK, which needs 3.12, is not for
        (library,) = _installed(package).glob("libvtkWrappingPythonCore*")
        settings["cmake.define.RELIEVO_PYTHON_CORE"] = str(library)
    excluded = [f"--exclude={name}" for name in _libraries_of(sdk, package)]
    with tempfile.TemporaryDirectory() as folder:
        name = core.build_wheel(folder, settings)
        repaired = pathlib.Path(folder, "repaired")
        _run(
            [sys.executable, "-m", "auditwheel", "repair", *excluded,
             "--wheel-dir", repaired, pathlib.Path(folder, name)],
            PATH=os.pathsep.join([os.path.dirname(sys.executable), os.environ["PATH"]]),
        )  # fmt: skip
        (wheel,) = repaired.iterdir()
        with InWheel(wheel, pathlib.Path(wheel_directory, wheel.name)) as files:
            (metadata,) = pathlib.Path(files).glob("*.dist-info")
            _require(metadata, package, version)
            if package != "vtkmodules":
                _include(pathlib.Path(files, "relievo"), package, sdk)
                # In the folder of the wheel: PYTHONPATH has what pip installed to build with.
                words = [sys.executable, "-m", "relievo._package.stub", "relievo"]
                subprocess.run(words, check=True, cwd=files)
        return wheel.name


def _split(config_settings):
    """The SDK's folder, or None, and the settings of scikit-build-core."""
    settings = dict(config_settings or {})
    sdk = settings.pop("sdk", None)
    return sdk and pathlib.Path(sdk).resolve(), settings


def _vtk_of(sdk):
    """The folder of an SDK's CMake files, the name of its Python package, and its version."""
    found = [path for name in ("vtk-config.cmake", "VTKConfig.cmake") for path in sdk.rglob(name)]
    if not found:
        raise SystemExit(f"sdk: got {sdk}, expected a folder with VTK's vtk-config.cmake")
    config = min(found, key=lambda path: len(path.parts)).parent
    packages = [
        name
        for path in sdk.rglob("*module-properties.cmake")
        for name in re.findall(r'_module_python_package"? "(\w+)"', path.read_text())
    ]
    versions = [
        version
        for path in [*sdk.rglob("vtk-config-version.cmake"), *sdk.rglob("VTKConfigVersion.cmake")]
        for version in re.findall(r'set\(PACKAGE_VERSION "([\d.]+)"', path.read_text())
    ]
    if not versions:
        raise SystemExit(f"sdk: got {sdk}, expected VTK's version in a vtk-config-version.cmake")
    return config, (packages or ["vtkmodules"])[0], versions[0]


def _libraries_of(sdk, package):
    """The names of VTK's libraries, which do not become libraries beside the package."""
    folders = [sdk] if package == "vtkmodules" else [sdk, _installed(package)]
    return sorted({path.name for each in folders for path in each.rglob("libvtk*.so*")})


def _require(metadata, package, version):
    """Adds the wheel of VTK itself to the requirements of a wheel that is built on it."""
    if package == "vtkmodules":
        path = metadata / "METADATA"
        head, end, rest = path.read_text("utf-8").partition("\n\n")
        path.write_text(f"{head}\nRequires-Dist: vtk=={version}{end}{rest}", "utf-8")


def _installed(package):
    spec = importlib.util.find_spec(package)
    if spec is None:
        raise SystemExit(f"sdk: its Python package {package} is not required by pyproject.toml")
    return pathlib.Path(*spec.submodule_search_locations)


def _include(folder, package, sdk):
    """Puts a VTK into the package, with its libraries and their licences."""
    installed = _installed(package)
    shutil.copytree(installed, folder / "vtk", ignore=shutil.ignore_patterns("__pycache__"))
    libraries = installed.with_name(f"{package}.libs")  # which it looks for beside itself
    if libraries.is_dir():
        shutil.copytree(libraries, folder / libraries.name)
    for licenses in sdk.rglob("share/licenses/VTK"):
        shutil.copytree(licenses, folder / "licenses" / "vtk")


def _run(words, **environment):
    subprocess.run(list(map(str, words)), check=True, env={**os.environ, **environment})
