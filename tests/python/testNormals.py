# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Layer `normal` of meshes with consistent or inconsistent winding, compared with VTK's shading."""

import itertools
import os
import pathlib
import subprocess
import unittest

import numpy
import relievo
import scenes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkReverseSense
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkWindowToImageFilter

SIZE = 80


def sphere(turned_normals, turned_winding):
    """Half a sphere's inside is seen past its rim where it is cut open."""
    source = vtkSphereSource()
    source.SetThetaResolution(60)
    source.SetPhiResolution(60)
    source.SetEndPhi(120)
    reverse = vtkReverseSense()
    reverse.SetInputConnection(source.GetOutputPort())
    reverse.SetReverseCells(turned_winding)
    reverse.SetReverseNormals(turned_normals)
    return reverse


def seen(source, culled):
    """Layers and picture under a headlight: its brightness is the cosine to the viewer, or 0."""
    renderer = vtkRenderer()
    actor = scenes.add(renderer, source)
    actor.GetProperty().SetFrontfaceCulling(culled == "front")
    actor.GetProperty().SetBackfaceCulling(culled == "back")
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, -2, -1)
    camera.SetViewUp(0, 0, 1)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.6)
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    renderer.AddLight(light)
    renderer.ResetCameraClippingRange()
    window = scenes.window_of(renderer, SIZE, SIZE)
    image = relievo.capture(renderer, ["normal", "geometric_normal", "actor"])
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    picture = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(SIZE, SIZE, -1)
    ahead = numpy.array(camera.GetDirectionOfProjection())
    return (relievo.layer(image, "actor") >= 0, -relievo.layer(image, "normal") @ ahead,
            -relievo.layer(image, "geometric_normal") @ ahead, picture[::-1, :, 0] / 255)


class Normals(unittest.TestCase):
    def test_as_lit(self):
        for normals, winding, culled in itertools.product(
                (False, True), (False, True), ("", "front", "back")):
            with self.subTest(normals=normals, winding=winding, culled=culled):
                there, cosine, face, lit = seen(sphere(normals, winding), culled)
                self.assertGreater(there.sum(), 500)
                numpy.testing.assert_allclose(lit[there], numpy.maximum(cosine, 0)[there],
                                              atol=1.5 / 255)
                self.assertTrue((face[there] > 0).all())
                side = numpy.sign(cosine[there])
                agree = 1 if normals == winding else -1
                self.assertGreater((side == agree).mean(), 0.98)

    def test_the_command_notes_it(self):
        for normals, winding in itertools.product((False, True), (False, True)):
            with self.subTest(normals=normals, winding=winding):
                name = str(pathlib.Path("sphere.vtp").absolute())
                source = sphere(normals, winding)
                source.Update()
                writer = vtkXMLPolyDataWriter()
                writer.SetDataModeToBinary()
                writer.SetInputConnection(source.GetOutputPort())
                writer.SetFileName(name)
                self.assertTrue(writer.Write())
                done = subprocess.run([os.environ["RELIEVO"], "render", name, "--png", "a.png"],
                                      capture_output=True, text=True, check=True)
                self.assertEqual("against the winding" in done.stdout + done.stderr,
                                 normals != winding)


if __name__ == "__main__":
    unittest.main()
