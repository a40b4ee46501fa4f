# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Support for trame, which shows scenes in browsers: its VTK, and warnings about local views."""

import functools
import importlib.abc
import importlib.util
import os
import sys
import warnings

from ._build import VTK
from .vtkRelievoMaterials import vtkRelievoMaterial

# The module with trame's serializers of VTK's classes, imported with an application's first view.
_INITIALIZE = "trame_vtk.modules.vtk.serializers.initialize"
_REGISTRY = "trame_vtk.modules.vtk.serializers.registry"

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


class _Finder(importlib.abc.MetaPathFinder):
    """Waits for trame to import its functions."""

    def find_spec(self, name, path=None, target=None):
        if name != _INITIALIZE:
            return None
        sys.meta_path.remove(self)
        spec = importlib.util.find_spec(name)
        execute = spec.loader.exec_module

        def execute_and_watch(module):
            execute(module)
            _watch(module)

        spec.loader.exec_module = execute_and_watch
        return spec


def prepare():
    """Makes trame, now or later, use Relievo's VTK and warn of parts missing in the browser."""
    if VTK != "vtkmodules" and "vtkmodules" not in sys.modules:
        os.environ.setdefault("VTK_MODULE_NAME", f"{__package__}.vtk")
    if _INITIALIZE in sys.modules:
        _watch(sys.modules[_INITIALIZE])
    else:
        sys.meta_path.insert(0, _Finder())
