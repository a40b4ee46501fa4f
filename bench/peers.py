# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a file by F3D or by plain VTK, for benches that compare `relievo render`.

    python bench/peers.py f3d|vtk FILE PICTURE.png WxH [--volume] [--normals] [--lights N]

In a Python that has the module `f3d` or `vtkmodules` (also pvpython). F3D draws with its own look.
VTK only reads, maps and draws, except for options: --normals first makes smooth normals of a mesh,
as Relievo does; --lights puts N lights around the scene instead of a headlight.
"""

import argparse
import math
import pathlib


def draw_with_f3d(given):
    import f3d

    engine = f3d.Engine.create(True)
    engine.window.size = given.size
    if given.volume:
        engine.options.update({"model.volume.enable": True, "model.coloring": "scivis"})
    engine.scene.add(given.file)
    engine.window.render_to_image().save(given.picture)


def props(given, renderer):
    """Adds the props of a file."""
    from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
    from vtkmodules.vtkIOImport import vtkGLTFImporter
    from vtkmodules.vtkIOPLY import vtkPLYReader
    from vtkmodules.vtkIOXML import (
        vtkXMLImageDataReader,
        vtkXMLMultiBlockDataReader,
        vtkXMLPolyDataReader,
    )
    from vtkmodules.vtkRenderingCore import (
        vtkActor,
        vtkColorTransferFunction,
        vtkCompositePolyDataMapper,
        vtkPolyDataMapper,
        vtkVolume,
    )

    kind = pathlib.Path(given.file).suffix
    if kind == ".glb":
        importer = vtkGLTFImporter()
        importer.SetFileName(given.file)
        importer.SetRenderWindow(renderer.GetRenderWindow())
        importer.Update()
        return
    readers = {".ply": vtkPLYReader, ".vtp": vtkXMLPolyDataReader, ".vti": vtkXMLImageDataReader,
               ".vtm": vtkXMLMultiBlockDataReader}  # fmt: skip
    source = readers[kind]()
    source.SetFileName(given.file)
    if given.normals:
        from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

        normals = vtkPolyDataNormals()
        normals.SetInputConnection(source.GetOutputPort())
        source = normals
    if kind == ".vti":
        from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

        mapper, prop = vtkGPUVolumeRayCastMapper(), vtkVolume()
        source.Update()
        low, high = source.GetOutput().GetScalarRange()
        opacity, colors = vtkPiecewiseFunction(), vtkColorTransferFunction()
        for value, shade in ((low, 0), (high, 1)):
            opacity.AddPoint(value, shade)
            colors.AddRGBPoint(value, shade, shade, shade)
        look = prop.GetProperty()
        look.SetScalarOpacity(opacity)
        look.SetColor(colors)
        look.SetScalarOpacityUnitDistance(source.GetOutput().GetLength() / 10)
        look.SetInterpolationTypeToLinear()
    else:
        mapper = vtkCompositePolyDataMapper() if kind == ".vtm" else vtkPolyDataMapper()
        prop = vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    prop.SetMapper(mapper)
    renderer.AddViewProp(prop)


def draw_with_vtk(given):
    import vtkmodules.vtkRenderingOpenGL2
    import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import (
        vtkLight,
        vtkRenderer,
        vtkRenderWindow,
        vtkWindowToImageFilter,
    )

    window, renderer = vtkRenderWindow(), vtkRenderer()
    window.SetOffScreenRendering(True)
    window.SetSize(*given.size)
    window.SetMultiSamples(0)
    window.AddRenderer(renderer)
    props(given, renderer)
    for number in range(given.lights):
        turn = 2 * math.pi * number / given.lights
        light = vtkLight()
        light.SetPositional(True)
        light.SetConeAngle(90)
        light.SetPosition(3 * math.cos(turn), 3 * math.sin(turn), 3)
        light.SetIntensity(1 / given.lights)
        renderer.AddLight(light)
    renderer.ResetCamera()
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(given.picture)
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("peer", choices=("f3d", "vtk"))
    parser.add_argument("file")
    parser.add_argument("picture")
    parser.add_argument("size", type=lambda words: tuple(map(int, words.split("x"))))
    parser.add_argument("--volume", action="store_true")
    parser.add_argument("--normals", action="store_true")
    parser.add_argument("--lights", type=int, default=0)
    given = parser.parse_args()
    (draw_with_f3d if given.peer == "f3d" else draw_with_vtk)(given)


if __name__ == "__main__":
    main()
