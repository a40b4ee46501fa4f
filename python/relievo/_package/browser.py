# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Support for trame, which shows scenes in browsers: its VTK, and warnings about local views."""

import contextlib
import functools
import importlib
import importlib.abc
import os
import sys
import warnings

from .._build import VTK
from ..vtkRelievoMaterials import vtkRelievoMaterial

# The module with trame's serializers of VTK's classes, imported with an application's first view.
_INITIALIZE = "trame_vtk.modules.vtk.serializers.initialize"
_REGISTRY = "trame_vtk.modules.vtk.serializers.registry"

_CHOICE = "VTK_MODULE_NAME"  # the variable of the environment that names trame's VTK

_LEFT_OUT = (
    "relievo: the browser draws this scene itself (a local view of trame, or an exported page), "
    "without Relievo's passes, materials and actors: its picture has no shadows, for example. A "
    "remote view shows what Relievo draws: VtkRemoteView, or PyVista's jupyter_backend='server'."
)


def _has_relievo(renderer):
    """Whether Relievo contributes to the renderer's picture."""
    drawn = renderer.GetPass()
    while drawn is not None:
        if drawn.IsA("vtkRelievoPass"):
            return True
        drawn = drawn.GetDelegatePass() if hasattr(drawn, "GetDelegatePass") else None
    props = renderer.GetViewProps()
    return any(
        prop.GetClassName().startswith("vtkRelievo")
        or vtkRelievoMaterial.Get(prop) is not None
        for prop in map(props.GetItemAsObject, range(props.GetNumberOfItems()))
    )


def _watch(initialize):
    """Makes trame's serializer of renderers print the warning, once."""
    serialize = initialize.renderer_serializer
    waiting = [_LEFT_OUT]

    @functools.wraps(serialize)
    def say(parent, renderer, *rest):
        if waiting and _has_relievo(renderer):
            warnings.warn(waiting.pop(), RuntimeWarning, stacklevel=2)
        return serialize(parent, renderer, *rest)

    initialize.renderer_serializer = say
    known = sys.modules[_REGISTRY].SERIALIZERS
    known.update({name: say for name, function in known.items() if function is serialize})


@contextlib.contextmanager
def _chosen(vtk):
    """Makes a VTK trame's choice, for a while: programs that this one starts do not inherit it."""
    os.environ[_CHOICE] = vtk
    try:
        yield
    finally:
        os.environ.pop(_CHOICE, None)


class _Finder(importlib.abc.MetaPathFinder):
    """Finds trame's modules, each of which asks for the VTK's name when it is imported."""

    def __init__(self, vtk):
        self._vtk = vtk  # the name, or None for trame's own choice

    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] not in ("trame_vtk", "trame_pyvista"):
            return None
        others = (each for each in sys.meta_path if each is not self)
        found = (each.find_spec(name, path, target) for each in others)
        spec = next((each for each in found if each is not None), None)
        if spec is None or spec.loader is None:
            return spec
        execute = spec.loader.exec_module

        def execute_and_watch(module):
            if self._vtk is None or _CHOICE in os.environ:
                execute(module)
            else:
                with _chosen(self._vtk):
                    execute(module)
                if name == "trame_pyvista":  # PyVista asks for trame's VTK before trame has one
                    sys.modules.setdefault("vtk_module", importlib.import_module(self._vtk))
            if name == _INITIALIZE:
                _watch(module)

        spec.loader.exec_module = execute_and_watch
        return spec


def prepare():
    """Makes trame, now or later, use Relievo's VTK and warn of parts missing in the browser."""
    if _INITIALIZE in sys.modules:
        _watch(sys.modules[_INITIALIZE])
    own = VTK != "vtkmodules" and "vtkmodules" not in sys.modules
    sys.meta_path.insert(0, _Finder("relievo.vtk" if own else None))
