# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""glTF files, out."""

import os
from contextlib import nullcontext

from .._arguments.errors import Watch, path_of
from .._arguments.renderers import renderer_of
from .._frames.keep import kept
from ..vtkRelievoScene import vtkRelievoGltfWriter
from .capture import _window_of
from .compare import name_objects

_AXES = "xyz"


def write_gltf(path, thing, up=None, names=None, check=True) -> list:
    """Writes the surfaces of a scene with colours, materials, lights and camera as glTF 2.

        relievo.write_gltf("bike.glb", plotter)

    path: name of the file, .glb; an existing one is replaced when the new one is complete.
    thing: a vtkRenderer, a plotter or anything else that capture() draws, or a scene().
    up: the scene's upward axis, "x", "y" or "z", which becomes the y of glTF; by default the axis
        closest to the camera's view-up vector.
    names: a dict {actor: name} for the file's nodes. Actors of PyVista's plotters have the names
        given to add_mesh().
    check: whether the file is read again and drawn; it is not kept if its depths, normals or
        surface colours differ from the scene's.

    Returns a list of sentences about the parts that the file leaves out or changes. docs/gltf.md
    says how colours, materials and lights are written.

    Raises ValueError for invalid arguments, OSError if the file cannot be written, RuntimeError if
    nothing can be exported, or if the file differs from the scene.
    """
    path = path_of(path, "path")
    if os.path.splitext(path)[1].lower() not in (".glb", b".glb"):
        raise ValueError(f"path: got {path!r}, expected a name that ends in .glb")
    if up is not None and up not in tuple(_AXES):
        raise ValueError(f"up: got {up!r}, expected 'x', 'y' or 'z'")
    renderer, made = renderer_of(thing)
    writer = vtkRelievoGltfWriter()
    writer.SetRenderer(renderer)
    writer.SetFileName(path)
    writer.SetCheck(bool(check))
    name_objects(writer, renderer, thing, names)
    found = kept(renderer)
    held = nullcontext() if found is None else found.held()
    size = (512, 512) if made or renderer.GetRenderWindow() is None else None
    with held, _window_of(renderer, size):
        if made:
            renderer.ResetCamera()
        view_up = [abs(each) for each in renderer.GetActiveCamera().GetViewUp()]
        writer.SetUpAxis(view_up.index(max(view_up)) if up is None else _AXES.index(up))
        with Watch(writer) as watch:
            written = writer.Write()
    if not written:
        system = writer.GetSystemError()
        if system:
            raise OSError(system, os.strerror(system), path)
        watch.raise_as(RuntimeError, "write_gltf")
        raise RuntimeError("write_gltf: failed without a message")
    return [writer.GetNote(i) for i in range(writer.GetNumberOfNotes())]
