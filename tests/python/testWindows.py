# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Windows that are closed and reopened, captures from other processes and threads, and objects
that outlive their actor."""

import gc
import multiprocessing
import threading
import unittest

import numpy
import relievo
import scenes
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkWindowToImageFilter


def image(columns=8, rows=4, value=(0.75, 0.5, 0.9)):
    made = vtkImageData()
    made.SetDimensions(columns, rows, 1)
    made.AllocateScalars(VTK_FLOAT, 3)
    vtk_to_numpy(made.GetPointData().GetScalars())[:] = value
    return made


def normal_map():
    material = relievo.vtkRelievoMaterial()
    material.SetNormalMap(image())
    return material


def height_map():
    material = relievo.vtkRelievoMaterial()
    heights = image()
    vtk_to_numpy(heights.GetPointData().GetScalars())[:] = numpy.arange(32)[:, None] / 32
    material.SetHeightMap(heights)
    material.SetReliefMethod(material.METHOD_RELIEF)
    return material


def mirror():
    environment = relievo.vtkRelievoEnvironment()
    environment.SetImage(image())
    material = relievo.vtkRelievoMaterial()
    material.SetEnvironment(environment)
    return material


def rough_mirror():
    material = mirror()
    prefilter = relievo.vtkRelievoEnvironmentPrefilter()
    prefilter.SetInputData(image())
    prefilter.Update()
    material.GetEnvironment().SetLevels(prefilter.GetOutput())
    material.SetRoughness(0.5)
    return material


def picture(window):
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).copy()


def depth_of(renderer):
    return relievo.layer(relievo.capture(renderer, size=(60, 40)), "depth").copy()


def capture_in_child(send):
    send.send(depth_of(scenes.plane_and_sphere()))


class Finalized(unittest.TestCase):
    def test_materials(self):
        """A window that was finalized draws the picture that it drew."""
        for make in (normal_map, height_map, mirror, rough_mirror):
            with self.subTest(make.__name__):
                renderer = vtkRenderer()
                actor = scenes.add(renderer, vtkPlaneSource())
                window = scenes.window_of(renderer, 40, 40)
                plain = picture(window)
                material = make()
                material.Attach(actor)
                before = picture(window)
                self.assertTrue((before != plain).any())
                held = material.GetEnvironment() or material
                self.assertGreater(held.GetBytesHeld(), 0)
                window.Finalize()
                self.assertEqual(held.GetBytesHeld(), 0)
                numpy.testing.assert_array_equal(picture(window), before)

    def test_frame(self):
        """Everything that a frame holds is made again, with or without a window to release it."""
        renderer = scenes.plane_and_sphere()
        window = scenes.window_of(renderer, 60, 40)
        frame = relievo.attach(renderer)
        frame.ShadowsOn()
        frame.RequestLayer("normal")
        relievo.stage(renderer, "tone")
        relievo.environment(renderer, image())
        before = picture(window)
        window.Finalize()
        numpy.testing.assert_array_equal(picture(window), before)
        for i in range(frame.GetNumberOfStages()):
            frame.GetStage(i).ReleaseGraphicsResources(None)
        numpy.testing.assert_array_equal(picture(window), before)


class Attached(unittest.TestCase):
    def test_material_goes_with_its_actor(self):
        for detach in (False, True):
            with self.subTest(detach=detach):
                renderer = vtkRenderer()
                actor = scenes.add(renderer, vtkPlaneSource())
                window = scenes.window_of(renderer, 20, 20)
                material = normal_map()
                material.Attach(actor)
                gone = []
                for name, each in (("material", material), ("map", material.GetNormalMap())):
                    each.AddObserver("DeleteEvent", lambda *_, name=name: gone.append(name))
                window.Render()
                relievo.capture(renderer)
                if detach:
                    material.Detach(actor)
                    window.Render()  # VTK's mapper remembers whom it drew for
                del material, each
                gc.collect()
                self.assertEqual(sorted(gone), ["map", "material"] if detach else [])
                renderer.RemoveActor(actor)
                del actor
                gc.collect()
                self.assertEqual(sorted(gone), ["map", "material"])

    def test_two_passes_of_one_actor(self):
        """Others' passes among an actor's keys stay, whatever is attached and detached."""
        actor = vtkActor()
        first, second = normal_map(), mirror()
        first.Attach(actor)
        second.Attach(actor)
        self.assertIs(relievo.vtkRelievoMaterial.Get(actor), second)
        self.assertEqual(first.GetReferenceCount(), 1)
        second.Detach(actor)
        self.assertIsNone(relievo.vtkRelievoMaterial.Get(actor))
        self.assertEqual(second.GetReferenceCount(), 1)


class Elsewhere(unittest.TestCase):
    def setUp(self):
        self.renderer = scenes.plane_and_sphere()
        self.here = depth_of(self.renderer)
        self.assertTrue(numpy.isfinite(self.here).any())

    def test_forked_process(self):
        fork = multiprocessing.get_context("fork")
        receive, send = fork.Pipe(duplex=False)
        child = fork.Process(target=capture_in_child, args=(send,))
        child.start()
        self.assertTrue(receive.poll(60), "the forked process hangs")
        numpy.testing.assert_array_equal(receive.recv(), self.here)
        child.join(60)
        self.assertEqual(child.exitcode, 0)
        numpy.testing.assert_array_equal(depth_of(self.renderer), self.here)

    def test_threads(self):
        """Each thread gets its picture, without a word from VTK."""
        said = []
        output = vtkOutputWindow.GetInstance()
        tags = [output.AddObserver(event, lambda *_: said.append(1))
                for event in ("ErrorEvent", "WarningEvent")]
        found = []

        def work():
            try:
                found.append(depth_of(scenes.plane_and_sphere()))
            except Exception as error:
                found.append(error)

        for count in (1, 3):
            threads = [threading.Thread(target=work) for _ in range(count)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join(60)
            numpy.testing.assert_array_equal(depth_of(self.renderer), self.here)
        for tag in tags:
            output.RemoveObserver(tag)
        self.assertEqual(len(found), 4)
        for depth in found:
            numpy.testing.assert_array_equal(depth, self.here)
        self.assertEqual(said, [])


if __name__ == "__main__":
    unittest.main()
