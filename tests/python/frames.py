# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relievo must not change the picture of any window, bit for bit, whatever was drawn before.

check(window) draws the window plain, attached without requests, with layers, with shadows, with
them off again, captured, and detached, and returns the differences.
"""

from contextlib import contextmanager

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight

import relievo

LAYERS = ["depth", "range", "normal", "geometric_normal", "position", "albedo", "actor", "block",
          "cell"]  # fmt: skip

SURFACES = ["depth", "normal", "geometric_normal", "albedo", "cell"]


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


def capture_surfaces(renderer):
    """Captures layers of any surfaces."""
    image = relievo.capture(renderer, SURFACES)
    return {name: relievo.layer(image, name).copy() for name in SURFACES}


def plain_pictures(window):
    """VTK's own pictures: the first, a second, and those after marking its mappers as modified,
    then their properties, and after changing the number of lights, which rebuilds its
    shaders.

    They differ where VTK depends on earlier drawing: actors that share a mapper, levels of
    detail, widgets. Then each of them is right.
    """
    found = [picture(window), picture(window)]
    renderers = renderers_of(window)
    actors = [actor for renderer in renderers for actor in renderer.GetActors()]
    for changed in [actor.GetMapper() for actor in actors], [a.GetProperty() for a in actors]:
        for thing in changed:
            if thing is not None:
                thing.Modified()
        found += [picture(window), picture(window)]
    dark = vtkLight()
    dark.SetIntensity(0)
    for renderer in renderers:
        renderer.AddLight(dark)
    found.append(picture(window))
    for renderer in renderers:
        renderer.RemoveLight(dark)
    return [*found, picture(window), picture(window)]


@contextmanager
def sunlight(window):
    """A sun besides the window's own lights; the index that it has in every renderer."""
    renderers = renderers_of(window)
    sun = vtkLight()
    sun.SetPosition(1, 2, 1)
    for renderer in renderers:
        renderer.AddLight(sun)
    yield renderers[0].GetLights().GetNumberOfItems() - 1
    for renderer in renderers:
        renderer.RemoveLight(sun)


def with_shadows(window):
    """The window's picture with shadows."""
    renderers = renderers_of(window)
    for renderer in renderers:
        relievo.attach(renderer).ShadowsOn()
    drawn = picture(window)
    for renderer in renderers:
        relievo.detach(renderer)
    return drawn


def one_sided(values):
    """Where the pixels around, 3 by 3, have one value; never at the rim."""
    rows, columns = values.shape
    around = [values[y : rows - 2 + y, x : columns - 2 + x] for y in range(3) for x in range(3)]
    found = numpy.zeros(values.shape, bool)
    found[1:-1, 1:-1] = numpy.min(around, axis=0) == numpy.max(around, axis=0)
    return found


def unlike(one, other):
    """How many pixels differ, bit for bit; relievo.compare() forgives rounding at edges."""
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

    def compare_layers(self, name, ones, others, names=LAYERS):
        for layer in names:
            self.note(f"{name}: {layer}", unlike(ones[layer], others[layer]))

    def separate(self, renderers):
        """The layers do not tell whether actors share a mapper."""
        for renderer in renderers:
            actors = [actor for actor in renderer.GetActors() if actor.GetMapper() is not None]
            mappers = [actor.GetMapper() for actor in actors]
            if len({mapper.GetAddressAsString("") for mapper in mappers}) == len(mappers):
                continue
            shared = capture_surfaces(renderer)
            for actor, mapper in zip(actors, mappers):
                own = mapper.NewInstance()
                # VTK 9.1 copies a mapper by accessors that it itself calls deprecated.
                vtkObject.GlobalWarningDisplayOff()
                own.ShallowCopy(mapper)
                vtkObject.GlobalWarningDisplayOn()
                actor.SetMapper(own)
            separate = capture_surfaces(renderer)
            for actor, mapper in zip(actors, mappers):
                actor.SetMapper(mapper)
            self.compare_layers("layers of shared mappers", shared, separate, SURFACES)

    def compare_twin(self, twin, shadows=True):
        """The layers and the picture of another window that shows the same, and its shadows."""
        self.step("twin")
        self.note("picture of the twin", unlike(picture(self.window), picture(twin)))
        pairs = zip(renderers_of(self.window), renderers_of(twin))
        for ours, theirs in pairs:
            self.compare_layers(
                "layers of the twin", capture_surfaces(ours), capture_surfaces(theirs), SURFACES
            )
        if shadows:
            self.step("shadows of the twin")
            self.compare_shadows(twin)

    def compare_shadows(self, twin):
        """The same but at edges of shadows: maps are fitted to the boxes of props, and an assembly
        has one box."""
        with sunlight(self.window), sunlight(twin) as light:
            ours, theirs = with_shadows(self.window), with_shadows(twin)
            if not unlike(ours, picture(self.window)):
                self.note("no shadows beside the twin", 1)
            renderer = renderers_of(twin)[0]
            name = f"shadow_{light}"
            reached = relievo.layer(relievo.capture(renderer, [name]), name)[::-1]
        differ = (ours != theirs).any(axis=2)
        self.note("shadows of the twin", int((differ & one_sided(reached)).sum()))

    def run(self):
        self.step("plain")
        self.plain = plain_pictures(self.window)
        first = self.plain[0]
        self.history = max(unlike(first, other) for other in self.plain[1:])
        # A picture that changes by itself cannot be compared with.
        again = zip(self.plain[0:4:2] + self.plain[-2:-1], self.plain[1:4:2] + self.plain[-1:])
        self.steady = any(unlike(one, other) == 0 for one, other in again)
        if not self.steady:
            return self
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
            # Drawn at another place of a framebuffer, values round another way; and alone, nothing
            # is hidden by surfaces of other renderers.
            if renderer.GetOrigin() != (0, 0) or renderer.GetPreserveDepthBuffer():
                continue
            image = relievo.capture(renderer, LAYERS)
            captured = {name: relievo.layer(image, name) for name in LAYERS}
            self.compare_layers("layers of a frame and a capture", layers, captured)
        self.compare("layers after a capture")
        if self.history == 0:
            self.step("mappers of their own")
            self.separate(renderers)
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
