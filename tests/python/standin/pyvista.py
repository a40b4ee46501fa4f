# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in for PyVista, which cannot be installed where these tests run: the protocol by which
PyVista 0.48 finds plugins, as its documentation and the docstrings of its registries describe it
(docs.pyvista.org: Extending PyVista; Plotter Components; register_reader; register_writer), and as
much of a plotter as the tests need.

- Group pyvista.plotter_components: the value is a module, imported when plotter.NAME is not found;
  importing it calls register_plotter_component(NAME)(class). The class gets the plotter, once for
  each plotter, and its __plotter_close__() is called by close(), newest first.
- Groups pyvista.readers and pyvista.writers: names are endings, values load as handler(path,
  **options) and handler(dataset, path, **options). A reader is given addresses (https://...) as
  they are; if it raises LocalFileRequiredError it is called again with the downloaded file.
- A plotter's camera is placed when it is first shown, unless it has been set.
- PyVista's passes are set by SetPass() of the renderer, at any time.
"""

import importlib
import os
import pathlib
import re
from importlib.metadata import entry_points

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkCylinderSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow


def _pending(group):
    found = entry_points(group=group)
    return {each.name: each for each in found}


class ImageData(vtkImageData):
    def save(self, path, **options):
        ending = os.path.splitext(path)[1].lower()
        _pending("pyvista.writers")[ending].load()(self, str(path), **options)


def wrap(image):
    made = ImageData()
    made.ShallowCopy(image)
    return made


class LocalFileRequiredError(Exception):
    pass


FETCHED = {}  # files by the addresses that the tests give


def has_scheme(path):
    return bool(re.match("[^/]+://", path))


def read(path, **options):
    path = str(path)
    reader = _pending("pyvista.readers")[os.path.splitext(path)[1].lower()].load()
    if not has_scheme(path):
        return reader(str(pathlib.Path(path).resolve()), **options)
    try:
        return reader(path, **options)
    except LocalFileRequiredError:
        return reader(FETCHED[path], **options)


class Renderer(vtkRenderer):
    def __init__(self):
        self.camera_set = False

    def get_default_cam_pos(self):
        box = self.ComputeVisiblePropBounds()
        middle = [(box[2 * i] + box[2 * i + 1]) / 2 for i in range(3)]
        return [tuple(each + 1 for each in middle), tuple(middle), (0, 0, 1)]

    @property
    def camera_position(self):
        camera = self.GetActiveCamera()
        return [camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()]

    @camera_position.setter
    def camera_position(self, given):
        camera = self.GetActiveCamera()
        camera.SetPosition(*given[0])
        camera.SetFocalPoint(*given[1])
        camera.SetViewUp(*given[2])
        self.camera_set = True


class BasePlotter:
    def __init__(self, shape=1, window_size=(300, 200), off_screen=True):
        self._components, self.actors = [], {}
        self.render_window = vtkRenderWindow()
        self.render_window.SetOffScreenRendering(True)
        self.render_window.SetMultiSamples(0)
        self.render_window.SetSize(*window_size)
        self.renderers = []
        for i in range(shape):
            renderer = Renderer()
            renderer.SetViewport(i / shape, 0, (i + 1) / shape, 1)
            self.render_window.AddRenderer(renderer)
            self.renderers.append(renderer)
        self.subplot(0)

    def __getattr__(self, name):
        found = {} if name.startswith("_") else _pending("pyvista.plotter_components")
        if name not in found:
            raise AttributeError(name)
        importlib.import_module(found[name].value)
        return object.__getattribute__(self, name)

    def subplot(self, index):
        self.renderer = self.renderers[index]

    def add_mesh(self, source, name=None):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        self.actors[name or f"Addr={id(actor)}"] = actor
        return actor

    def show(self):
        for renderer in self.renderers:
            if not renderer.camera_set:
                renderer.camera_position = renderer.get_default_cam_pos()
                renderer.ResetCamera()
        self.render_window.Render()

    def render(self):
        self.render_window.Render()

    def close(self):
        for component in reversed(self._components):
            getattr(component, "__plotter_close__", lambda: None)()
        self._components.clear()


class Plotter(BasePlotter):
    pass


def Cylinder(radius=0.5):  # noqa: N802
    source = vtkCylinderSource()
    source.SetRadius(radius)
    return source


class _Component:
    def __init__(self, name, made_of):
        self._name, self._made_of = name, made_of

    def __get__(self, plotter, _type=None):
        if plotter is None:
            return self._made_of
        made = plotter.__dict__[self._name] = self._made_of(plotter)
        plotter._components.append(made)
        return made


def register_plotter_component(name, target_cls=None, *, override=False):
    target = target_cls or BasePlotter
    if not isinstance(name, str) or not name.isidentifier() or name.startswith("_"):
        raise ValueError(name)
    if hasattr(target, name) and not override:
        raise ValueError(f"{name} is there already")

    def register(made_of):
        setattr(target, name, _Component(name, made_of))
        return made_of

    return register
