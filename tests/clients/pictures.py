# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A plugin for pytest: PyVista's own plotting tests with Relievo attached to every renderer, idle.

    PYTHONPATH=tests/clients v/bin/python -m pytest -p pictures PYVISTA/tests/plotting

with PyVista's tests, from its repository, and a virtual environment with pytest, the tests'
requirements and an installed wheel. By hand: it takes a quarter of an hour. Each plotter that a
test closes is drawn with the frame, twice without it, and with it again; at the end a line says how
many pictures were equal bit for bit, and how many differ although both were drawn without Relievo.
Status 1 if another one differs.
"""

import collections

import numpy
import pytest
import relievo  # first: PyVista then takes its VTK

import pyvista
from pyvista.plotting.renderer import Renderer

_counts = collections.Counter()
_different = []


def _attached(self, *arguments, original=Renderer.__init__, **values):
    original(self, *arguments, **values)
    relievo.attach(self)


class Pictures:
    """In the place of pytest-pyvista's fixture, which compares with stored pictures."""

    def __init__(self, name):
        self.name = name
        self.n_calls = 0

    def __call__(self, plotter):
        self.n_calls += 1
        if plotter.render_window is None:
            return

        def draw():
            plotter.render_window.Render()
            return plotter.screenshot(return_img=True).copy()

        for renderer in plotter.renderers:
            relievo.attach(renderer)  # around passes that have replaced the frame since
        idle = draw()
        for renderer in plotter.renderers:
            relievo.detach(renderer)
        plain, again = draw(), draw()
        for renderer in plotter.renderers:
            relievo.attach(renderer)
        # relievo.compare() would forgive rounding, and only pictures are of interest here.
        if numpy.array_equal(idle, plain) and numpy.array_equal(draw(), plain):
            _counts["equal"] += 1
        elif not numpy.array_equal(plain, again):
            _counts["random"] += 1
        else:
            _different.append(f"{self.name}, picture {self.n_calls}")


@pytest.fixture
def verify_image_cache(request):
    pyvista.global_theme.before_close_callback = pictures = Pictures(request.node.nodeid)
    yield pictures
    pyvista.global_theme.before_close_callback = None


def pytest_sessionfinish(session):
    if _different:
        session.exitstatus = 1


def pytest_terminal_summary(terminalreporter):
    total = sum(_counts.values()) + len(_different)
    terminalreporter.write_line(
        f"Pictures with Relievo idle: {_counts['equal']} of {total} equal, "
        f"{_counts['random']} random by themselves, {len(_different)} different")  # fmt: skip
    for each in _different:
        terminalreporter.write_line(f"  {each}")


Renderer.__init__ = _attached
