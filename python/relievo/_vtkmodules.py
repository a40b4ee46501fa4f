# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Provides a wheel's VTK under the usual name, for packages that know no other."""

import importlib
import importlib.abc
import importlib.util
import sys
import types

_NAME = "vtkmodules"

# Base classes that vedo needs at import and cvista lacks.
_BASES = {"vtkRenderingCore": ("vtkFlagpoleLabel",)}


def _missing(name, own):
    """A substitute for a class that the VTK lacks: only for use as a base class."""

    def fail(self, *_arguments, **_given):
        raise NotImplementedError(f"{name}: {own}, which Relievo is built on, has no such class")

    return type(name, (), {"__init__": fail, "__doc__": f"Not in {own}."})


class Alias(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Finds each module of `vtkmodules` as the module of another package, loaded once.

    Also finds `vtk` as a package with all of their names and modules.
    """

    def __init__(self, own):
        self._own = own

    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in (_NAME, "vtk"):
            return importlib.util.spec_from_loader(name, self, is_package=name == "vtk")
        return None

    def create_module(self, spec):
        if spec.name == "vtk":
            module = types.ModuleType("vtk")
            everything = importlib.import_module(f"{self._own}.all")
            vars(module).update({name: value for name, value in vars(everything).items()
                                 if not name.startswith("__")})  # fmt: skip
            return module
        module = importlib.import_module(".".join([self._own, *spec.name.split(".")[1:]]))
        for name in _BASES.get(spec.name.rpartition(".")[2], ()):
            if not hasattr(module, name):
                setattr(module, name, _missing(name, self._own))
        spec.loader_state = module.__spec__
        return module

    def exec_module(self, module):
        if module.__spec__.loader_state is not None:
            module.__spec__ = module.__spec__.loader_state


def provide_vtkmodules() -> None:
    """Makes `vtkmodules` the VTK that Relievo is built on, for all later imports of the process.

        import relievo
        relievo.provide_vtkmodules()
        import vedo

    For packages that know VTK only by that name, such as vedo, beside a wheel of Relievo, whose VTK
    is the package `cvista`. Classes that cvista lacks are missing there, too. Does nothing in a
    build whose VTK is called vtkmodules.

    Raises ImportError if another VTK has been imported by that name before.
    """
    from vtkmodules.vtkCommonCore import vtkObjectBase  # here: tests use Alias without any VTK

    own = vtkObjectBase.__module__.split(".")[0]
    if own == _NAME or any(isinstance(each, Alias) for each in sys.meta_path):
        return
    if _NAME in sys.modules:
        raise ImportError(
            f"provide_vtkmodules: {_NAME} has been imported already, from "
            f"{list(sys.modules[_NAME].__path__)[0]}: call it before what imports that"
        )
    sys.meta_path.insert(0, Alias(own))
