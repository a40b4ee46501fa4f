# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Keeps frames on renderers whose passes are set by others: PyVista, its plugins, vedo."""

import contextlib
import weakref

from .._arguments.renderers import need_renderer
from ..vtk.vtkCommonCore import vtkWeakReference
from ..vtk.vtkRenderingOpenGL2 import vtkRenderPassCollection, vtkSequencePass
from .frame import Frame, kept_of, put, take, vtkRelievoPass


def attach(renderer) -> vtkRelievoPass:
    """Puts the Relievo frame around the renderer's pass, and around any that it gets later.

    renderer: a vtkRenderer, or an object whose attribute `renderer` is one (a plotter). Its picture
        does not change: with nothing requested the frame only calls the renderer's own pass. A
        renderer that already has the frame keeps it.

    The frame stays until detach(): a pass that is set later (PyVista's enable_ssao(), vedo's
    ambient occlusion, SetPass()) is moved into it at the next picture.

    Returns the vtkRelievoPass: its ShadowsOn() makes every light cast, SetDisplayLayer() shows a
    layer as the picture, RequestLayer() renders one in every frame; both raise ValueError for a
    name that is neither a layer nor an array of the data in the renderer. Raises ValueError for
    anything but a renderer or an object that has one.
    """
    return kept(need_renderer(renderer), attach=True).frame


def detach(renderer) -> bool:
    """Removes the frame and restores the pass that the renderer had before.

    renderer: as for attach().

    Returns True, or False if no frame was attached. Raises ValueError for anything but a renderer
    or an object that has one.
    """
    return take(need_renderer(renderer))


def kept(renderer, attach=False):
    """The RendererFrame of a renderer; if it has none, a new one or, without `attach`, None."""
    found = kept_of(renderer)
    if found is not None and found.detached():
        found.let_go()
        found = None
    if found is None and attach:
        found = RendererFrame(renderer)
        # VTK keeps attributes as long as the object lives; PyVista's renderers refuse new ones.
        object.__setattr__(renderer, "relievo_kept", found)
    return found


def _has_within(outer, frame):
    """Whether the frame is a delegate of a pass, directly or indirectly."""
    if outer is None or outer is frame:
        return outer is not None
    inner = []
    if hasattr(outer, "GetDelegatePass"):
        inner.append(outer.GetDelegatePass())
    passes = outer.GetPasses() if hasattr(outer, "GetPasses") else None
    if passes is not None:
        inner.extend(passes.GetItemAsObject(i) for i in range(passes.GetNumberOfItems()))
    return any(_has_within(each, frame) for each in inner)


class RendererFrame:
    """The frame of one renderer: around a pass that is set later, or within it."""

    def __init__(self, renderer):
        self._renderer = vtkWeakReference()
        self._renderer.Set(renderer)
        self.frame = put(renderer)
        self._arranged = None  # the pass that contains the frame
        self._given = False  # whether that pass is not known yet
        self._held = 0
        keep = weakref.WeakMethod(self.keep)

        def start(*_):
            if keep() is not None:
                keep()()

        # The last observer: others set passes in theirs.
        self._tag = renderer.AddObserver("StartEvent", start, -1.0)

    def keep(self):
        """Restores the frame after another pass has been set."""
        renderer = self._renderer.Get()
        there = renderer.GetPass()
        if self._given:
            self._arranged, self._given = there, False
        if self.detached() or (there is not None and there.IsA("vtkRelievoPass")):
            return  # itself, or temporarily another for a capture
        if self._arranged is not there and _has_within(there, self.frame):
            self._arranged = there  # already around the frame
        if there is not None and there is self._arranged:
            if self._held:
                renderer.SetPass(self.frame)
            return
        self._arranged = None
        self.frame.SetDelegatePass(there)
        renderer.SetPass(self.frame)

    @contextlib.contextmanager
    def held(self):
        """Makes the frame the renderer's pass meanwhile, where this package's functions find it."""
        renderer = self._renderer.Get()
        self._held += 1
        try:
            self.keep()
            yield renderer
        finally:
            self._held -= 1
            if not self._held and self._arranged is not None and renderer.GetPass() is self.frame:
                renderer.SetPass(self._arranged)

    def give(self, delegate):
        """A new pass that draws the frame around the delegate, for a pass that is being built."""
        self.frame.SetDelegatePass(delegate)
        self._given = True
        passes = vtkRenderPassCollection()
        passes.AddItem(self.frame)
        sequence = vtkSequencePass()
        sequence.SetPasses(passes)
        return sequence

    def detached(self):
        """Whether detach() has taken the frame away."""
        return isinstance(self.frame, Frame) and self.frame.is_detached()

    def let_go(self):
        """Stops moving later passes into the frame."""
        renderer = self._renderer.Get()
        object.__setattr__(renderer, "relievo_kept", None)
        renderer.RemoveObserver(self._tag)

    def release(self):
        """Restores the renderer to its state without the frame."""
        renderer = self._renderer.Get()
        self.let_go()
        if renderer.GetPass() is self.frame:
            take(renderer)
