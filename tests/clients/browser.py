# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Headless Chromium, and servers to look at in it."""

import contextlib
import io
import pathlib
import shutil
import subprocess
import time
import urllib.request

import numpy
from PIL import Image
from playwright.sync_api import sync_playwright


@contextlib.contextmanager
def chromium(size, **options):
    """A page of so many columns and rows. Debian's Chromium; WebGL by software."""
    path = shutil.which("chromium")
    if path is None:
        raise SystemExit("no chromium; install the packages of section [site]")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=path,
            args=["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"])
        page = browser.new_page(viewport={"width": size[0], "height": size[1]}, **options)
        page.set_default_timeout(60_000)
        yield page
        browser.close()


def picture_of(shot):
    """A screenshot as numpy array of (rows, columns, 3)."""
    return numpy.asarray(Image.open(io.BytesIO(shot)).convert("RGB")).astype(int)


@contextlib.contextmanager
def served(words, address, log, **options):
    """A server's process, once it answers; its output goes into the file."""
    with open(log, "w", encoding="utf-8") as file:
        process = subprocess.Popen(words, stdout=file, stderr=subprocess.STDOUT, **options)
        try:
            for _ in range(240):
                if process.poll() is not None:
                    raise AssertionError(pathlib.Path(log).read_text())
                with contextlib.suppress(OSError):
                    urllib.request.urlopen(address, timeout=5).close()
                    break
                time.sleep(0.25)
            else:
                raise AssertionError(f"{address} does not answer\n{pathlib.Path(log).read_text()}")
            yield process
        finally:
            process.terminate()
            process.wait(30)
