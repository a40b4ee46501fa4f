# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Headless Chromium: trame's remote view shows Relievo's picture, and a local view, drawn by the
browser itself, lists its losses; the report of a comparison shows its result."""

import contextlib
import importlib
import os
import pathlib
import socket
import subprocess
import sys
import unittest

import numpy

import relievo

VTK = type(relievo.to_image(numpy.zeros((1, 1)))).__module__.split(".")[0]  # its package
core = importlib.import_module(f"{VTK}.vtkRenderingCore")
sources = importlib.import_module(f"{VTK}.vtkFiltersSources")

SIZE = (400, 300)


def scene(shadows):
    """A ball above a floor, under a sun; off-screen."""
    ball, floor = sources.vtkSphereSource(), sources.vtkPlaneSource()
    ball.SetCenter(0, 0.5, 0)
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(48)
    floor.SetOrigin(-2, 0, -2)
    floor.SetPoint1(-2, 0, 2)
    floor.SetPoint2(2, 0, -2)
    renderer, window = core.vtkRenderer(), core.vtkRenderWindow()
    for source in (ball, floor):
        mapper, actor = core.vtkPolyDataMapper(), core.vtkActor()
        mapper.SetInputConnection(source.GetOutputPort())
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
    sun = core.vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(2, 4, 1)
    renderer.AddLight(sun)
    renderer.SetBackground(0.2, 0.3, 0.4)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(2, 3, 6)
    camera.SetFocalPoint(0, 0.3, 0)
    camera.OrthogonalizeViewUp()  # as VTK's trackball does: it turns about this axis
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    if shadows == "soft":
        relievo.stage(renderer, "shadows", soft_samples=32, sun_angle=12,
                      soft_at_once=True)  # fmt: skip
    elif shadows:
        relievo.stage(renderer, "shadows")
    return renderer, window


def drawn(shadows, turn=0):
    """The picture without trame, seen from so many degrees further round."""
    renderer, window = scene(shadows)
    renderer.GetActiveCamera().Azimuth(turn)
    renderer.ResetCameraClippingRange()
    grab = core.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    return relievo.from_image(grab.GetOutput())[..., :3].astype(int)


def serve(view, shadows, port):
    """The application, as its users write one."""
    from trame.app import get_server
    from trame.ui.html import DivLayout
    from trame.widgets import html
    from trame.widgets import vtk as widgets

    importlib.import_module(f"{VTK}.vtkInteractionStyle")
    renderer, window = scene(shadows)
    if view == "VtkLocalView":  # with all that does not travel
        relievo.environment(renderer, relievo.to_image(numpy.ones((8, 16, 3), numpy.float32)))
        relievo.lamps(renderer, sources.vtkSphereSource(), radius=2)
        renderer.AddViewProp(relievo.vtkRelievoSkinnedActor())
    interactor = core.vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.GetInteractorStyle().SetCurrentStyleToTrackballCamera()
    window.Render()  # after the interactor is there: VTK crashes otherwise, without a display
    server = get_server(client_type="vue3")
    with DivLayout(server):
        with html.Div(style=f"position:fixed;left:0;top:0;width:{SIZE[0]}px;height:{SIZE[1]}px"):
            getattr(widgets, view)(window)
    server.start(port=port, open_browser=False, show_connection_info=False)


class Module(unittest.TestCase):
    """The VTK that trame takes: the wheel's, but where another is in use."""

    def said(self, before="", **environment):
        code = f"""
{before}
import os, sys
import relievo
import trame_vtk.modules.vtk
first = sys.modules["vtk_module"]
import trame_vtk.modules.vtk.serializers.initialize, trame_vtk.modules.vtk.widget
print(sys.modules["vtk_module"].__name__, first is sys.modules["vtk_module"],
      os.environ.get("VTK_MODULE_NAME"))
"""
        usual = {name: value for name, value in os.environ.items() if name != "VTK_MODULE_NAME"}
        done = subprocess.run([sys.executable, "-c", code], env={**usual, **environment},
                              capture_output=True, text=True, check=False)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.splitlines()[-1]

    def test_it_is_relievos(self):
        """Programs that this one starts do not inherit the choice."""
        self.assertEqual(self.said(), f"{VTK} True None")

    def test_another(self):
        self.assertEqual(self.said("import vtkmodules"), "vtkmodules True None")
        self.assertEqual(self.said(VTK_MODULE_NAME="vtkmodules"), "vtkmodules True vtkmodules")


class Views(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"])

    @contextlib.contextmanager
    def page(self, view, shadows):
        """The application in Chromium, and the file of its messages."""
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        log = self.folder / f"{view}-{shadows}.log"
        words = [sys.executable, __file__, "--serve", view, shadows, str(port)]
        with browser.served(words, f"http://127.0.0.1:{port}/", log):
            with browser.chromium(SIZE) as page:
                page.goto(f"http://127.0.0.1:{port}/index.html")
                yield page, log
        self.assertNotIn("Traceback", log.read_text())

    def wait_for(self, page, truth, name):
        """Waits until the page shows the picture; the largest difference of each pixel."""
        for _ in range(60):
            shot = page.screenshot(path=self.folder / f"{name}.png")
            off = numpy.abs(browser.picture_of(shot) - truth).max(axis=2)
            if off.mean() < 1.5:
                break
            page.wait_for_timeout(500)
        print(f"{name}: {off.mean():.2f} levels off on average, {off.max()} at most")
        return off

    def test_remote(self):
        """The picture arrives as it is drawn, but for JPEG, and turns with the mouse."""
        for shadows in ("hard", "soft"):
            truth = drawn(shadows)
            dark = numpy.abs(drawn("") - truth).max(axis=2) > 60
            self.assertGreater(dark.sum(), 800, "the scene has no shadows")
            with self.page("VtkRemoteView", shadows) as (page, log):
                off = self.wait_for(page, truth, shadows)
                self.assertLess(off.mean(), 1.5)
                self.assertLess((off > 24).sum(), 0.05 * dark.sum())
                page.mouse.move(180, 150)
                page.mouse.down()
                page.mouse.move(220, 150, steps=4)
                page.mouse.up()
                # VTK's trackball: 200 degrees for a drag over all of the window.
                off = self.wait_for(page, drawn(shadows, -200 * 40 / SIZE[0]), f"{shadows}-turned")
                self.assertLess((off > 24).sum(), 0.05 * dark.sum())
            self.assertNotIn("draws this scene itself", log.read_text())

    def test_local(self):
        """The browser draws VTK's picture, and one sentence lists the missing parts."""
        plain = drawn("")
        dark = numpy.abs(drawn("hard") - plain).max(axis=2) > 60
        with self.page("VtkLocalView", "hard") as (page, log):
            off = self.wait_for(page, plain, "local")
            self.assertLess(off.mean(), 1.5)
            self.assertLess(off[dark].mean(), 6)
        self.assertEqual(log.read_text().count("the browser draws this scene itself"), 1)


class Report(unittest.TestCase):
    """The page of relievo.compare(), used in Chromium."""

    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"])
        cls.path = folder / "report.html"
        renderer, window = scene("hard")
        window.Render()
        ball = renderer.GetActors().GetItemAsObject(0)
        names = {ball: "<b>ball</b>"}
        relievo.write_baseline(folder / "report.exr", renderer, names=names)
        ball.SetPosition(0.1, 0, 0)
        renderer.SetBackground(0.204, 0.3, 0.4)  # by one level, which is within the limits
        cls.found = relievo.compare(folder / "report.exr", renderer)
        cls.found.write_html(cls.path)
        cls.after = relievo.picture(relievo.capture(renderer, "color"), "color")

    @contextlib.contextmanager
    def page(self):
        problems = []
        with browser.chromium((1280, 900)) as page:
            page.on("pageerror", lambda error: problems.append(str(error)))
            page.on("console", lambda message: problems.append(message.text)
                    if message.type == "error" else None)
            page.on("request", lambda request: problems.append(request.url[:80])
                    if not request.url.startswith(("file:", "data:")) else None)
            page.goto(self.path.as_uri())
            page.wait_for_selector("html[data-ready]")
            yield page
        self.assertEqual(problems, [])

    def painted(self, page, color):
        """The number of pixels of this colour in the picture."""
        return page.evaluate("""(color) => {
            const canvas = document.querySelector("canvas"), { width, height } = canvas;
            const all = canvas.getContext("2d").getImageData(0, 0, width, height).data;
            let n = 0;
            for (let i = 0; i < all.length; i += 4) {
              n += color.every((level, c) => level === all[i + c]);
            }
            return n;
        }""", color)

    def test_table(self):
        """Each cause has a row; a click highlights its pixels, and Escape shows all again."""
        moved, shadow = (next(each for each in self.found.causes if each["cause"] == cause)
                         for cause in ("moved", "shadow"))
        with self.page() as page:
            rows = page.locator("#causes tbody tr").all_inner_texts()
            for row, cause in zip(rows, self.found.causes, strict=False):
                self.assertEqual(int("".join(filter(str.isdigit, row.split("\t")[-1]))),
                                 cause["pixels"])
            self.assertEqual(page.locator("#causes b").count(), 0)
            colors = {"moved": [0xF5, 0xA0, 0x0B], "shadow": [0x5F, 0x62, 0xEA]}
            self.assertEqual(self.painted(page, colors["moved"]), moved["pixels"])
            button = page.get_by_role("button", name="<b>ball</b>")
            button.first.click()
            self.assertEqual(button.first.get_attribute("aria-pressed"), "true")
            self.assertEqual(self.painted(page, colors["moved"]), moved["pixels"])
            self.assertEqual(self.painted(page, colors["shadow"]), 0)
            page.keyboard.press("Escape")
            self.assertGreaterEqual(self.painted(page, colors["shadow"]), shadow["pixels"])
            # Pixels within the limits have their colour only when chosen.
            rounding = [0x5B, 0x64, 0x72]
            self.assertEqual(self.painted(page, rounding), 0)
            page.get_by_role("button", name="rounding").last.click()
            within = self.found.dict["within_limits"]["rounding"]
            self.assertEqual(self.painted(page, rounding), within)

    def test_values(self):
        """Mouse and keys show colour, object and cause of a pixel."""
        place = self.found.image.tolist()
        moved = [each["cause"] for each in self.found.causes].index("moved")
        row = next(i for i, each in enumerate(place) if each.count(moved) > 3)
        column = place[row].index(moved)
        with self.page() as page:
            canvas = page.locator("canvas").first
            box = canvas.bounding_box()
            size = box["width"] / SIZE[0]
            canvas.hover(position={"x": (column + 0.5) * size, "y": (row + 0.5) * size})
            text = page.locator("#inspector").inner_text()
            self.assertIn(f"column {column}, row {row} ", text)
            self.assertIn("<b>ball</b> (actor 0): moved by (0.1, 0, 0)", text)
            self.assertIn(" ".join(map(str, self.after[row, column][:3])),
                          page.locator("#values tr").nth(1).locator("td").nth(1).inner_text())
            canvas.focus()
            page.keyboard.press("ArrowRight")
            self.assertIn(f"column {column + 1}, row {row} ", page.locator("#place").inner_text())

    def test_views(self):
        """Keys choose all views, in both themes; the page fits a telephone's width."""
        back = "getComputedStyle(document.body).backgroundColor"
        with self.page() as page:
            for width, scheme in ((390, "light"), (390, "dark"), (1280, "light"), (1280, "dark")):
                page.set_viewport_size({"width": width, "height": 844})
                page.emulate_media(color_scheme=scheme)
                levels = page.evaluate(back)[4:-1].split(",")
                self.assertEqual(max(map(int, levels)) < 128, scheme == "dark")
                for key, view in zip("1234", ("causes", "slider", "flicker", "beside"),
                                     strict=True):
                    page.keyboard.press(key)
                    chosen = page.locator(f"[data-view={view}]")
                    self.assertEqual(chosen.get_attribute("aria-pressed"), "true")
                    self.assertEqual(page.evaluate("document.documentElement.scrollWidth"), width)
            before = page.evaluate(back)
            page.locator("#theme").select_option("light")
            self.assertNotEqual(page.evaluate(back), before)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--serve"]:
        serve(sys.argv[2], sys.argv[3], int(sys.argv[4]))
    else:
        import browser

        unittest.main(verbosity=2)
