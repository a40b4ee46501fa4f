# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""trame in headless Chromium: what a remote view shows is what Relievo draws, and a local view, which
the browser draws itself, says what it loses."""

import os
import pathlib
import socket
import subprocess
import sys
import unittest

import numpy

import relievo
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

SIZE = (400, 300)


def scene(shadows):
    """A ball above a floor, under a sun; off-screen."""
    ball, floor = vtkSphereSource(), vtkPlaneSource()
    ball.SetCenter(0, 0.5, 0)
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(48)
    floor.SetOrigin(-2, 0, -2)
    floor.SetPoint1(-2, 0, 2)
    floor.SetPoint2(2, 0, -2)
    renderer, window = vtkRenderer(), vtkRenderWindow()
    for source in (ball, floor):
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputConnection(source.GetOutputPort())
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(2, 4, 1)
    renderer.AddLight(sun)
    renderer.SetBackground(0.2, 0.3, 0.4)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2, 3, 6)
    camera.SetFocalPoint(0, 0.3, 0)
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    if shadows == "soft":
        relievo.stage(renderer, "shadows", visible=True, soft_samples=32, sun_angle=12,
                      soft_at_once=True)  # fmt: skip
    elif shadows:
        relievo.stage(renderer, "shadows", visible=True)
    return renderer, window


def drawn(shadows):
    """The picture without trame."""
    renderer, window = scene(shadows)
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return relievo.from_image(grab.GetOutput())[..., :3].astype(int)


def serve(view, shadows, port):
    """The application, as its users write one."""
    import vtkmodules.vtkInteractionStyle  # noqa: F401
    from trame.app import get_server
    from trame.ui.html import DivLayout
    from trame.widgets import html
    from trame.widgets import vtk as widgets
    from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor

    _, window = scene(shadows)
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.GetInteractorStyle().SetCurrentStyleToTrackballCamera()
    window.Render()  # after the interactor is there: VTK crashes otherwise, without a display
    server = get_server(client_type="vue3")
    with DivLayout(server):
        with html.Div(style=f"position:fixed;left:0;top:0;width:{SIZE[0]}px;height:{SIZE[1]}px"):
            getattr(widgets, view)(window)
    server.start(port=port, open_browser=False, show_connection_info=False)


class Views(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(os.environ.get("RELIEVO_TEST_OUTPUT", "."))

    def shown(self, view, shadows, then=None):
        """A screenshot of the view, and one after what `then` does with the page; what is said."""
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        log = self.folder / f"{view}.log"
        words = [sys.executable, __file__, "--serve", view, shadows, str(port)]
        with browser.served(words, f"http://127.0.0.1:{port}/", log):
            with browser.chromium(SIZE) as page:
                page.goto(f"http://127.0.0.1:{port}/index.html")
                page.wait_for_function("document.querySelector('canvas') !== null")
                if view == "VtkRemoteView":
                    page.wait_for_function("[...document.images].some((i) => i.naturalWidth > 9)")
                page.wait_for_timeout(3000)
                shots = [page.screenshot(path=self.folder / f"{view}-{shadows}.png")]
                if then:
                    then(page)
                    page.wait_for_timeout(3000)
                    shots.append(page.screenshot())
        return [browser.picture_of(shot) for shot in shots], log.read_text()

    def test_remote(self):
        """The picture arrives as it is drawn, but for JPEG, and follows the mouse."""
        def drag(page):
            page.mouse.move(200, 150)
            page.mouse.down()
            page.mouse.move(260, 150, steps=6)
            page.mouse.up()

        for shadows in ("hard", "soft"):
            (first, second), said = self.shown("VtkRemoteView", shadows, drag)
            truth, plain = drawn(shadows), drawn("")
            off = numpy.abs(first - truth).max(axis=2)
            lost = numpy.abs(plain - truth).max(axis=2) > 60
            self.assertGreater(lost.sum(), 800, "the scene has no shadows")
            print(f"{shadows}: {off.mean():.2f} levels off on average, {(off > 24).sum()} pixels "
                  f"by more than 24; {lost.sum()} pixels are in shadow")
            self.assertLess(off.mean(), 1.5)
            self.assertLess((off > 24).sum(), 0.1 * lost.sum())
            turned = numpy.abs(second - first).max(axis=2) > 24
            self.assertGreater(turned.sum(), 1000, "dragging moved nothing")
            dark = [(each.max(axis=2) < 40).sum() for each in (first, second)]
            self.assertLess(abs(dark[1] / dark[0] - 1), 0.5, "the shadow is lost when dragging")
            self.assertNotIn("Traceback", said)
            self.assertNotIn("draws this scene itself", said)

    def test_local(self):
        """It draws what it can, and one sentence says what it cannot."""
        (first,), said = self.shown("VtkLocalView", "hard")
        self.assertEqual(said.count("the browser draws this scene itself"), 1, said)
        self.assertNotIn("Traceback", said)
        truth, plain = drawn("hard"), drawn("")
        lost = numpy.abs(plain - truth).max(axis=2) > 60
        off = numpy.abs(first - plain).max(axis=2)
        print(f"local: {off.mean():.2f} levels off VTK's picture on average")
        self.assertLess(off.mean(), 3)
        self.assertLess(off[lost].mean(), 6)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--serve"]:
        serve(sys.argv[2], sys.argv[3], int(sys.argv[4]))
    else:
        import browser

        unittest.main(verbosity=2)
