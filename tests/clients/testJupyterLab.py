# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A notebook in JupyterLab, in headless Chromium: pictures inline, and relievo.show() with the
values under the cursor, readable in both themes."""

import contextlib
import json
import os
import pathlib
import socket
import sys
import unittest

import numpy

import browser

SIZE = (1280, 1600)
CELLS = [
    "import numpy, relievo\n"
    "numbers = numpy.arange(12000, dtype=numpy.float32).reshape(100, 120)\n"
    "image = relievo.to_image({'first': -numbers, 'second': numbers})\n"
    "relievo.show(image)",
    "scene = relievo.scene('slab.obj', size=(320, 240))\n"
    "scene",
    "relievo.capture(scene.renderer, ['depth', 'normal'])",
]
SLAB = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n"


def luminance(rgb):
    """Of sRGB from 0 to 255, as WCAG 2 has it."""
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in
              (each / 255 for each in rgb)]  # fmt: skip
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


class Notebook(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"])
        (self.folder / "slab.obj").write_text(SLAB)
        cells = [{"cell_type": "code", "id": str(i), "metadata": {}, "execution_count": None,
                  "source": text, "outputs": []} for i, text in enumerate(CELLS)]  # fmt: skip
        kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3"}}
        (self.folder / "a.ipynb").write_text(json.dumps(
            {"cells": cells, "metadata": kernel, "nbformat": 4, "nbformat_minor": 5}))  # fmt: skip

    @contextlib.contextmanager
    def run_in(self, theme, scheme):
        """The page of the notebook when all cells have run."""
        settings = self.folder / "settings/@jupyterlab/apputils-extension"
        settings.mkdir(parents=True, exist_ok=True)
        (settings / "themes.jupyterlab-settings").write_text(json.dumps({"theme": theme}))
        (settings / "notification.jupyterlab-settings").write_text('{"fetchNews": "false"}')
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            address = f"http://127.0.0.1:{free.getsockname()[1]}"
        words = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root",
                 f"--port={address.rpartition(':')[2]}", "--IdentityProvider.token=",
                 "--ServerApp.ip=127.0.0.1", f"--ServerApp.root_dir={self.folder}"]  # fmt: skip
        homes = {name: str(self.folder / name.lower()) for name in
                 ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR",
                  "JUPYTERLAB_WORKSPACES_DIR")}  # fmt: skip
        homes["JUPYTERLAB_SETTINGS_DIR"] = str(self.folder / "settings")
        log = self.folder / f"{theme.rpartition(' ')[2]}.log"
        with browser.served(words, f"{address}/api", log, env={**os.environ, **homes}):
            with browser.chromium(SIZE, color_scheme=scheme) as page:
                page.goto(f"{address}/lab/tree/a.ipynb")
                page.get_by_text("Python 3 (ipykernel) | Idle").wait_for()
                page.get_by_role("menuitem", name="Run", exact=True).click()
                page.get_by_role("menuitem", name="Run All Cells", exact=True).click()
                outputs = page.locator(".jp-Notebook .jp-OutputArea-output")
                try:
                    outputs.nth(len(CELLS) - 1).wait_for()
                finally:
                    page.screenshot(path=self.folder / f"{theme.rpartition(' ')[2]}.png")
                page.wait_for_timeout(1000)
                yield page, outputs

    def test_themes(self):
        """Also where the notebook's is not the system's."""
        for theme, scheme in (("JupyterLab Dark", "light"), ("JupyterLab Light", "dark")):
            with self.run_in(theme, scheme) as (page, outputs):
                self.look(page, outputs, f"{theme.rpartition(' ')[2]}-on-{scheme}")

    def look(self, page, outputs, name):
        shown = page.screenshot(path=self.folder / f"{name}.png")
        for at in (1, 2):
            image = outputs.nth(at).locator("img").first
            self.assertGreater(image.evaluate("image => image.naturalWidth"), 100, CELLS[at])
        frame = outputs.nth(0).frame_locator("iframe")
        frame.get_by_role("button", name="second").click()
        box = frame.locator("img").bounding_box()
        page.mouse.move(box["x"] + 0.625 * box["width"], box["y"] + 0.305 * box["height"])
        page.wait_for_timeout(1000)
        told = frame.locator("output").evaluate("output => output.value")
        self.assertEqual(told, f"row 30, column 75\nsecond: {30 * 120 + 75}")
        # The text under the picture, compared with its background, and that with the notebook.
        place = frame.locator("output").bounding_box()
        x, y, width, height = (round(place[each]) for each in ("x", "y", "width", "height"))
        words = browser.picture_of(page.screenshot())[y:y + height, x:x + width].reshape(-1, 3)
        light = numpy.array([luminance(rgb) for rgb in numpy.unique(words, axis=0)])
        contrast = (light.max() + 0.05) / (light.min() + 0.05)
        behind = luminance(numpy.median(words, axis=0))
        around = luminance(browser.picture_of(shown)[SIZE[1] - 300, SIZE[0] // 2])
        print(f"{name}: contrast {contrast:.1f}, behind {behind:.3f}, around {around:.3f}")
        self.assertGreater(contrast, 4.5)
        self.assertLess(abs(behind - around), 0.2)


if __name__ == "__main__":
    unittest.main(verbosity=2)
