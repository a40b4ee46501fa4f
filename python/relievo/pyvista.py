# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relievo in PyVista 0.48 and later: plotter.relievo, and .exr files in read() and save().

PyVista finds this module by the entry points of the installed package `relievo`, without an import:

    plotter = pyvista.Plotter()
    plotter.add_mesh(mesh)
    plotter.relievo.shadows()                       # every light casts
    depth = plotter.relievo.layer("depth")          # numpy, (rows, columns), row 0 at the top
    plotter.relievo.environment("forest.exr")
    image = pyvista.read("frame.exr")               # one point array per layer
    image.save("copy.exr", compression="piz")

All of these are for the plotter's active renderer, as PyVista's own are; plotter.subplot()
changes it. PyVista's passes (EDL, SSAO, blur and so on) replace whatever pass a renderer has:
switch them on first.
"""

import pyvista

from . import _capture, _environment, _exr, _frame, _image, _stages, _things


@pyvista.register_plotter_component("relievo")
class RelievoComponent:
    """What `plotter.relievo` is: the functions of the package `relievo`, for the plotter."""

    def __init__(self, plotter):
        self._plotter = plotter
        self._renderers = []

    def _renderer(self):
        renderer = self._plotter.renderer
        if renderer not in self._renderers:
            self._renderers.append(renderer)
        return renderer

    def shadows(self, on=True, **parameters):
        """Every light casts shadows, or none; parameters as of relievo.stage().

        Lights of PyVista's default kit follow the camera, and so do their shadows; a light with
        light_type="scene light" stays where it is.
        """
        return _stages.stage(self._renderer(), "shadows", visible=bool(on), **parameters)

    def environment(self, path, **parameters):
        """As relievo.environment(): the light of a picture of all directions, and the sky."""
        return _environment.environment(self._renderer(), path, **parameters)

    def stage(self, name, on=True, **parameters):
        """As relievo.stage(): one of the frame's stages by name."""
        return _stages.stage(self._renderer(), name, on, **parameters)

    def show(self, layer):
        """Shows a layer as the picture; None shows the picture again."""
        self.frame.SetDisplayLayer(layer)

    def capture(self, layers=("depth",), size=None, hdr=False):
        """As relievo.capture(), as PyVista's ImageData; layer() gives numpy arrays."""
        return pyvista.wrap(_capture.capture(self._plotter, layers, size, hdr))

    def layer(self, name, size=None, hdr=False):
        """One layer of what is visible, as a numpy array with row 0 at the top."""
        return _image.layer(_capture.capture(self._plotter, name, size, hdr), name)

    def report(self):
        """As relievo.report(): what the last frames did and why."""
        return _frame.report(self.frame)

    @property
    def frame(self):
        """The vtkRelievoPass of the active renderer, attached if there is none."""
        return _frame.attach(self._renderer())

    def off(self):
        """Takes Relievo out of the active renderer: environment, frame and all."""
        self._clear(self._plotter.renderer)

    def _clear(self, renderer):
        if renderer in self._renderers:
            self._renderers.remove(renderer)
            _environment.environment(renderer, None)
            _frame.detach(renderer)

    def __plotter_close__(self):
        for renderer in list(self._renderers):
            self._clear(renderer)


def _add(name, function):
    """Makes a function of a renderer a method of the accessor."""

    def method(self, points, **values):
        return function(self._renderer(), points, **values)

    method.__name__ = name
    method.__doc__ = f"As relievo.{name}() for the plotter's active renderer."
    setattr(RelievoComponent, name, method)


for _name, _function in _things.functions().items():
    _add(_name, _function)


def read_exr(path, **options):
    """What pyvista.read() does with .exr files: relievo.read_exr(), as PyVista's ImageData.

    Addresses are PyVista's to fetch: it calls again with a file.
    """
    if pyvista.has_scheme(str(path)):
        raise pyvista.LocalFileRequiredError(path)
    if options:
        raise TypeError(f"read: .exr files take no options, got {', '.join(options)}")
    return pyvista.wrap(_exr.read_exr(path))


def write_exr(dataset, path, **options):
    """What save() does with .exr files: relievo.write_exr(), with its compression, pixel_types."""
    _exr.write_exr(path, dataset, **options)
