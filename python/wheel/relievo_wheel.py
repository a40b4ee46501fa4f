# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds Relievo's wheel, for pip (pyproject.toml): scikit-build-core on the SDK of wheels.txt,
then auditwheel, which puts what is linked beside VTK into the wheel."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

from scikit_build_core import build as core
from scikit_build_core.build import (  # noqa: F401  (pip calls them)
    build_sdist,
    get_requires_for_build_sdist,
    get_requires_for_build_wheel,
)

ROOT = pathlib.Path(__file__).resolve().parents[2]
SDK = ROOT / "build" / "vtk97-sdk"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    _run([ROOT / "tools" / "unpack-vtk", "--wheel", SDK], PYTHON=sys.executable)
    settings = {"cmake.define.VTK_DIR": str(SDK / "cvista_sdk" / "cmake")}
    settings.update(config_settings or {})
    if sys.version_info < (3, 12):
        settings["cmake.define.RELIEVO_PYTHON_CORE"] = str(_python_core())
    with tempfile.TemporaryDirectory() as folder:
        name = core.build_wheel(folder, settings, metadata_directory)
        repaired = pathlib.Path(folder, "repaired")
        _run(
            [sys.executable, "-m", "auditwheel", "repair", "--exclude", "libvtk*-cvista.so",
             "--wheel-dir", repaired, pathlib.Path(folder, name)],
            PATH=os.pathsep.join([os.path.dirname(sys.executable), os.environ["PATH"]]),
        )  # fmt: skip
        (wheel,) = repaired.iterdir()
        wheel.rename(pathlib.Path(wheel_directory, wheel.name))
        return wheel.name


def _python_core():
    """cvista's own library for a Python that its SDK, which needs 3.12, is not for."""
    folder = pathlib.Path(*importlib.util.find_spec("cvista").submodule_search_locations)
    (library,) = folder.glob("libvtkWrappingPythonCore*")
    return library


def _run(words, **environment):
    subprocess.run(list(map(str, words)), check=True, env={**os.environ, **environment})
