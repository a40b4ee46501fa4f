# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for pyvista-render-passes, which needs Python 3.12: the protocol by which its version
0.2 has passes of others among its own, as its README and docs/design.md describe it.

- Group pyvista_render_passes.providers: a value is a class, of which each renderer has an object.
  bind() gives that a method of the renderer's component, which has the passes built anew.
- Passes are built in the renderer's StartEvent when something has changed: the renderer's pass is
  None, then build_pass("base", renderer, chain, delegate) makes a pass around the scene's,
  or returns None, then all others go around it.
- veto() is asked before a setting changes, and may say why not.
"""

from importlib.metadata import entry_points

from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkLightsPass,
    vtkOpaquePass,
    vtkRenderPassCollection,
    vtkSequencePass,
    vtkSSAAPass,
    vtkTranslucentPass,
    vtkVolumetricPass,
)


def _sequence(*passes):
    collection = vtkRenderPassCollection()
    for each in passes:
        collection.AddItem(each)
    sequence = vtkSequencePass()
    sequence.SetPasses(collection)
    return sequence


class RenderPassComponent:
    def __init__(self, renderer):
        self.renderer = renderer
        self.settings = {"anti_aliasing": False, "ssao": False, "shadows": False}
        self.top = None
        self.providers = [each.load()() for each in
                          entry_points(group="pyvista_render_passes.providers")]  # fmt: skip
        for provider in self.providers:
            provider.bind(self.invalidate)
        self.invalidate()
        renderer.AddObserver("StartEvent", self._start)

    def invalidate(self):
        self._dirty = True

    def set(self, **settings):
        wanted = {**self.settings, **settings}
        for provider in self.providers:
            reason = provider.veto(wanted)
            if reason:
                raise ValueError(reason)
        self.settings = wanted
        self.invalidate()

    def _start(self, *_):
        if not self._dirty:
            return
        self._dirty = False
        self.renderer.SetPass(None)
        base = vtkCameraPass()
        base.SetDelegatePass(
            _sequence(vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass(), vtkVolumetricPass()))
        scene = base
        for provider in self.providers:
            scene = provider.build_pass("base", self.renderer, None, scene) or scene
        if scene is base and not self.settings["anti_aliasing"]:
            self.top = None
            return
        if self.settings["anti_aliasing"]:
            smooth = vtkSSAAPass()
            smooth.SetDelegatePass(scene)
            scene = smooth
        self.top = _sequence(scene)
        self.renderer.SetPass(self.top)
