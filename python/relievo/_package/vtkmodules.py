# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python modules of Relievo's VTK, under the names by which they are imported.

A wheel may include its VTK (folder `vtk`), which only programs that import relievo then find.
"""

import filecmp
import importlib
import importlib.abc
import importlib.util
import pathlib
import sys
import types

FOLDER = pathlib.Path(__file__).parents[1]

_USUAL = "vtkmodules"

# Base classes that vedo needs at import and cvista lacks.
_BASES = {"vtkRenderingCore": ("vtkFlagpoleLabel",)}


def _missing(name, own):
    """A substitute for a class that the VTK lacks: only for use as a base class."""

    def fail(self, *_arguments, **_given):
        raise NotImplementedError(f"{name}: {own}, which Relievo is built on, has no such class")

    return type(name, (), {"__init__": fail, "__doc__": f"Not in {own}."})


class Alias(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Finds each module of a package as the module of another package, loaded once.

    For `vtkmodules` it also finds `vtk`, as a package with all of their names and modules.
    """

    def __init__(self, name, own):
        self.name = name
        self._own = own

    def _given(self, name):
        """The name of the package by which a module is imported, or None for another's."""
        for given in (self.name, "vtk") if self.name == _USUAL else (self.name,):
            if f"{name}.".startswith(f"{given}."):
                return given
        return None

    def find_spec(self, name, path=None, target=None):
        if self._given(name) is None:
            return None
        return importlib.util.spec_from_loader(name, self, is_package=name == "vtk")

    def create_module(self, spec):
        if spec.name == "vtk":
            module = types.ModuleType("vtk")
            everything = importlib.import_module(f"{self._own}.all")
            vars(module).update({name: value for name, value in vars(everything).items()
                                 if not name.startswith("__")})  # fmt: skip
            return module
        within = spec.name.removeprefix(self._given(spec.name))
        module = importlib.import_module(self._own + within)
        for name in _BASES.get(spec.name.rpartition(".")[2], ()):
            if not hasattr(module, name):
                setattr(module, name, _missing(name, self._own))
        spec.loader_state = module.__spec__
        return module

    def exec_module(self, module):
        if module.__spec__.loader_state is not None:
            module.__spec__ = module.__spec__.loader_state


class Included(importlib.abc.MetaPathFinder):
    """Finds the VTK that is included in this package, by the name that its modules have."""

    def __init__(self, own):
        self._own = own

    def find_spec(self, name, path=None, target=None):
        if name != self._own:
            return None
        folder = FOLDER / "vtk"
        return importlib.util.spec_from_file_location(
            name, folder / "__init__.py", submodule_search_locations=[str(folder)]
        )


def _is_included(module):
    """Whether an imported VTK is the included one, or an equal one."""
    folder = pathlib.Path(*module.__path__)
    if folder == FOLDER / "vtk":
        return True
    libraries = [path.name for path in (FOLDER / "vtk").glob("libvtkCommon*.so")]
    equal, _, _ = filecmp.cmpfiles(FOLDER / "vtk", folder, libraries, shallow=False)
    return equal == libraries


def prepare(own):
    """Makes the modules of a VTK, by the name of its package, available as `relievo.vtk`.

    Raises ImportError if another VTK of that name has been imported than the included one.
    """
    if (FOLDER / "vtk" / "__init__.py").is_file():  # and not only stubs
        if own not in sys.modules:
            sys.meta_path.insert(0, Included(own))
        elif not _is_included(sys.modules[own]):
            raise ImportError(
                f"relievo: another {own} than Relievo's has been imported, from "
                f"{list(sys.modules[own].__path__)[0]}: import relievo first"
            )
    sys.meta_path.insert(0, Alias("relievo.vtk", own))


def provide_vtkmodules() -> None:
    """Makes `vtkmodules` the VTK that Relievo is built on, for all later imports of the process.

        import relievo
        relievo.provide_vtkmodules()
        import vedo

    For packages that know VTK only by that name, such as vedo, beside a wheel of Relievo, which
    includes a VTK of another name. Classes that this VTK lacks are missing there, too. Does nothing
    in a build whose VTK is called vtkmodules.

    Raises ImportError if another VTK has been imported by that name before.
    """
    from .._build import VTK as own  # here: tests use Alias without the package

    known = {each.name for each in sys.meta_path if isinstance(each, Alias)}
    if own == _USUAL or _USUAL in known:
        return
    if _USUAL in sys.modules:
        raise ImportError(
            f"provide_vtkmodules: {_USUAL} has been imported already, from "
            f"{list(sys.modules[_USUAL].__path__)[0]}: call it before that"
        )
    sys.meta_path.insert(0, Alias(_USUAL, own))
