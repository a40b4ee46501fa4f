# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Frames that stay on renderers whose passes others set: PyVista's, and those of its plugins."""

import contextlib
import weakref

from vtkmodules.vtkRenderingOpenGL2 import vtkRenderPassCollection, vtkSequencePass

from . import _frame


def kept(renderer, attach=False):
    """The KeptFrame of a renderer; None if it has none, unless one is to be attached."""
    found = _frame.kept.get(renderer)
    if found is not None and found.detached():
        found.release()
        found = None
    if found is None and attach:
        found = _frame.kept[renderer] = KeptFrame(renderer)
    return found


class KeptFrame:
    """The frame of one renderer: around the pass that somebody sets later, or within it."""

    def __init__(self, renderer):
        self._renderer = weakref.ref(renderer)
        self.frame = _frame.attach(renderer)
        self._arranged = None  # the pass that the frame was given into
        self._given = False  # and that pass is not known yet
        self._held = 0
        keep = weakref.WeakMethod(self.keep)

        def start(*_):
            if keep() is not None:
                keep()()

        # The last observer: others set passes in theirs.
        self._tag = renderer.AddObserver("StartEvent", start, -1.0)

    def keep(self):
        """The frame is back where it belongs, if somebody has set the renderer's pass."""
        renderer = self._renderer()
        there = renderer.GetPass()
        if self._given:
            self._arranged, self._given = there, False
        if self.detached() or (there is not None and there.IsA("vtkRelievoPass")):
            return  # itself, or one that is around for a capture
        if there is not None and there is self._arranged:
            if self._held:
                renderer.SetPass(self.frame)
            return
        self._arranged = None
        self.frame.SetDelegatePass(there)
        renderer.SetPass(self.frame)

    @contextlib.contextmanager
    def held(self):
        """Meanwhile the frame is the renderer's pass, where the functions of this package look."""
        renderer = self._renderer()
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
        return isinstance(self.frame, _frame.Frame) and self.frame.is_detached()

    def release(self):
        """The renderer is as it would be without the frame."""
        renderer = self._renderer()
        _frame.kept.pop(renderer, None)
        renderer.RemoveObserver(self._tag)
        if renderer.GetPass() is self.frame:
            _frame.detach(renderer)
