# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""What Relievo must leave as it is, for any window: its picture, bit for bit, whatever was drawn.

check(window) draws the window plain, attached with nothing asked, with layers, with shadows, with
them off again, captured, and detached, and says what differs.
"""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData

import relievo

LAYERS = ["depth", "range", "normal", "geometric_normal", "position", "albedo", "actor", "block",
          "cell"]  # fmt: skip


def picture(window):
    """The window drawn anew: RGBA bytes, (rows, columns, 4)."""
    window.Render()
    columns, rows = window.GetActualSize()
    bytes_of = vtkUnsignedCharArray()
    window.GetRGBACharPixelData(
        0, 0, columns - 1, rows - 1, 0 if window.GetDoubleBuffer() else 1, bytes_of
    )
    return vtk_to_numpy(bytes_of).reshape(rows, columns, 4).copy()


def renderers_of(window):
    """The renderers that draw something of their own."""
    found = [r for r in window.GetRenderers() if r.GetViewProps().GetNumberOfItems() > 0]
    return [r for r in found if r.GetDraw() and min(r.GetSize()) > 0]


def plain_pictures(window):
    """What VTK itself draws: at first, again, and after its mappers are told to have changed.

    They differ where VTK depends on what was drawn before: actors that share a mapper, levels of
    detail, widgets. Then each of them is right.
    """
    found = [picture(window), picture(window)]
    for renderer in renderers_of(window):
        for actor in renderer.GetActors():
            if actor.GetMapper() is not None:
                actor.GetMapper().Modified()
    found += [picture(window), picture(window)]
    return found


def unlike(one, other):
    """How many pixels differ."""
    if one.shape != other.shape:
        return max(one.size, other.size)
    same = (one == other) | ((one != one) & (other != other))
    return int((~same).reshape(*one.shape[:2], -1).any(axis=2).sum())


class Frames:
    """The findings of one window; `step` is called with the name of each before it begins."""

    def __init__(self, window, step=lambda name: None):
        self.window = window
        self.step = step
        self.found = {}

    def note(self, name, pixels):
        if pixels:
            self.found[name] = pixels

    def compare(self, name):
        self.step(name)
        self.note(name, min(unlike(picture(self.window), plain) for plain in self.plain))

    def read(self, frame):
        image = vtkImageData()
        frame.ReadLayers(LAYERS, image)
        return {name: relievo.layer(image, name).copy() for name in LAYERS}

    def compare_layers(self, name, ones, others):
        for layer in LAYERS:
            self.note(f"{name}: {layer}", unlike(ones[layer], others[layer]))

    def run(self):
        self.step("plain")
        self.plain = plain_pictures(self.window)
        first = self.plain[0]
        self.history = max(unlike(first, other) for other in self.plain[1:])
        renderers = renderers_of(self.window)
        frames = [relievo.attach(renderer) for renderer in renderers]
        self.compare("attached")
        for frame in frames:
            for layer in LAYERS:
                frame.RequestLayer(layer)
        self.compare("layers")
        self.step("reading layers")
        once = [self.read(frame) for frame in frames]
        self.compare("layers again")
        self.step("reading layers again")
        for frame, layers in zip(frames, once):
            self.compare_layers("layers of two frames", layers, self.read(frame))
        self.step("capture")
        for renderer, layers in zip(renderers, once):
            image = relievo.capture(renderer, LAYERS)
            self.compare_layers(
                "layers of a frame and a capture",
                layers, {name: relievo.layer(image, name) for name in LAYERS},
            )  # fmt: skip
        self.compare("layers after a capture")
        for frame in frames:
            frame.ReleaseLayers()
        self.compare("layers released")
        self.step("shadows")
        for frame in frames:
            frame.ShadowsOn()
        shadows = picture(self.window)
        self.step("shadows again")
        self.note("shadows of two frames", unlike(shadows, picture(self.window)))
        for frame in frames:
            frame.ShadowsOff()
        self.compare("shadows off")
        for renderer in renderers:
            relievo.detach(renderer)
        self.compare("detached")
        self.step("end")
        return self


def check(window, step=lambda name: None):
    """Draws the window in all these ways; returns the Frames with its findings."""
    return Frames(window, step).run()


def coverage(window):
    """The share of pixels that differ from the first one: whether anything is seen at all."""
    shown = picture(window)
    return float((shown != shown[0, 0]).any(axis=2).mean()), numpy.unique(
        shown.reshape(-1, 4), axis=0
    ).shape[0]
