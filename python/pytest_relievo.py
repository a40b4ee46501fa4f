# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A pytest plugin that compares plotters, renderers and scenes with baselines, by cause.

It is not part of the package relievo, because importing that loads all of VTK; only tests that
compare import it.
Options, names of files and folders follow pytest-pyvista.
"""

import hashlib
import os
import pathlib
import re
import shlex
import shutil

import pytest

_USE = pytest.StashKey()  # a test's fixture
_OWNERS = pytest.StashKey()  # a run's {baseline: (test, whether it has the test's name)}
_NEW = pytest.StashKey()  # baselines written by a run
_WRITTEN = "relievo_baseline_written"  # a property of reports


def pytest_addoption(parser):
    group = parser.getgroup("relievo", "frames compared with baselines (fixture relievo_baseline)")
    folder = ("folder of the baselines, relative to pytest's root folder; default: baselines, "
              "beside the file of the test")  # fmt: skip
    group.addoption("--relievo-baselines", metavar="DIR", help=folder)
    parser.addini("relievo_baselines", folder, default="")
    group.addoption("--relievo-update", action="store_true",
                    help="write baselines that are missing or differ; their tests are skipped")
    group.addoption("--relievo-report", metavar="DIR",
                    help="folder for both frames (.exr, .png), the causes (.json) and a page for "
                    "browsers (.html) of failures, relative to pytest's root folder")  # fmt: skip


def pytest_configure(config):
    config.stash[_OWNERS], config.stash[_NEW] = {}, set()


@pytest.fixture
def relievo_baseline(request):
    """Compares a frame with a baseline.

        relievo_baseline(thing, name=None, portable=False, **limits)

    thing: a plotter, a renderer, a scene or anything else that relievo.compare() draws, or an image
        of relievo.capture().
    name: name of the baseline's file, without folder; default: the test's name without `test_`,
        with its parameters, and for later calls `_1`, `_2` and so on.
    portable: whether a new baseline is portable, as for relievo.write_baseline(). Frames are drawn
        like the existing baseline.
    limits: limits of relievo.compare(): levels, normal_angle, depth_pixels.

    Fails with the table of causes if the frames differ, and if there is no baseline. A test that
    never calls the fixture fails.
    """
    request.node.stash[_USE] = use = _Baselines(request)
    return use


class _Baselines:
    def __init__(self, request):
        self._config, self._node = request.config, request.node
        self._own = 0  # calls without a name
        self.calls, self.written = 0, []

    def __call__(self, thing, name=None, portable=False, **limits):
        __tracebackhide__ = True
        import relievo
        from relievo._captures.compare import frame_of
        from relievo._wrapped import vtkRelievoBaseline

        self.calls += 1
        path = self._path(name)
        shown = self._shown(path)
        baseline = found = None
        try:
            baseline = relievo.read_exr(path)
        except FileNotFoundError:
            said = "there is no such baseline"
        except (OSError, ValueError) as error:  # the message names the file
            said = f"the baseline cannot be read: {error}"
        is_portable = vtkRelievoBaseline.IsPortable(baseline)
        frame = frame_of(thing, portable if baseline is None else is_portable)
        if path in self._config.stash[_NEW]:
            self.written.append(shown)
            return
        if baseline is not None:
            found = relievo.compare(baseline, frame, **limits)
            if found:
                return
            said = found.text.rstrip("\n")
        if self._config.getoption("relievo_update"):
            path.parent.mkdir(parents=True, exist_ok=True)
            if portable and not vtkRelievoBaseline.IsPortable(frame):
                frame = frame_of(thing, portable)
            relievo.write_exr(path, frame)
            self._config.stash[_NEW].add(path)
            self.written.append(shown)
            return
        report = self._report(path, baseline, frame, found)
        pytest.fail(f"{shown}: {said}\n{report}If the frame is right, this writes it as the "
                    f"baseline: pytest --relievo-update {shlex.quote(self._node.nodeid)}")

    def _path(self, name):
        """The baseline's path. Two tests share one only if both give its name."""
        __tracebackhide__ = True
        is_own = name is None
        if is_own:
            name = _safe(self._node.name.removeprefix("test_"))
            name += f"_{self._own}" if self._own else ""
            self._own += 1
        elif not isinstance(name, str) or name != _safe(name):
            raise ValueError(f"name: got {name!r}, expected a file's name of letters, digits, "
                             f"'.', '-' and '_', without a folder")
        given = (self._config.getoption("relievo_baselines")
                 or self._config.getini("relievo_baselines"))  # fmt: skip
        folder = self._config.rootpath / given if given else self._node.path.parent / "baselines"
        path = folder / (name.removesuffix(".exr") + ".exr")
        owners, own = self._config.stash[_OWNERS], (self._node.nodeid, is_own)
        other, other_is_own = owners.setdefault(path, own)
        if other != self._node.nodeid and (is_own or other_is_own):
            pytest.fail(f"{self._shown(path)}: is the baseline of {other} and of "
                        f"{self._node.nodeid}; give one of them a name: "
                        f"relievo_baseline(thing, name=...)")
        return path

    def _shown(self, path):
        return os.path.relpath(path, self._config.rootpath)

    def _report(self, path, baseline, frame, found):
        """Writes the files of --relievo-report, and returns a line that names them."""
        import relievo

        folder = self._config.getoption("relievo_report")
        if not folder:
            return ""
        test = pathlib.Path(os.path.relpath(self._node.path, self._config.rootpath))
        parts = [part for part in test.with_suffix("").parts if part != ".."]
        folder = self._config.rootpath.joinpath(folder, *parts)
        folder.mkdir(parents=True, exist_ok=True)
        relievo.write_exr(folder / f"{path.stem}.frame.exr", frame)
        if path.is_file():
            shutil.copyfile(path, folder / f"{path.stem}.baseline.exr")
        for word, image in (("baseline", baseline), ("frame", frame)):
            if image is not None and "color" in relievo.layer_names(image):
                relievo.write_png(folder / f"{path.stem}.{word}.png", image, "color")
        if found is not None:
            (folder / f"{path.stem}.json").write_text(found.json + "\n", encoding="utf-8")
            found.write_html(folder / f"{path.stem}.html")
        return f"Frames and causes: {self._shown(folder / path.stem)}.*\n"


def _safe(name):
    """Makes a file name: parameters of tests may contain any characters, and be long."""
    safe = re.sub(r"[^\w.-]+", "_", name).strip("_.") or "test"
    if len(safe.encode()) > 200:
        safe = f"{safe[:40]}-{hashlib.sha256(safe.encode()).hexdigest()[:12]}"
    return safe


@pytest.hookimpl(hookwrapper=True, tryfirst=True)
def pytest_runtest_makereport(item, call):
    """Tests that wrote baselines are skipped; tests that pass without a comparison fail."""
    outcome = yield
    report = outcome.get_result()
    use = item.stash.get(_USE, None)
    if call.when != "call" or use is None:
        return
    report.user_properties += [(_WRITTEN, each) for each in use.written]
    if not report.passed or hasattr(report, "wasxfail"):
        return
    if use.written:
        report.outcome = "skipped"
        report.longrepr = (str(item.path), (item.location[1] or 0) + 1,
                           f"Skipped: wrote {', '.join(use.written)}")  # fmt: skip
    elif use.calls == 0:
        report.outcome = "failed"
        report.longrepr = (f"{item.nodeid}: has the fixture relievo_baseline, but compares "
                           f"nothing; call relievo_baseline(thing)")  # fmt: skip


def pytest_terminal_summary(terminalreporter):
    written = {value for reports in terminalreporter.stats.values() for report in reports
               for name, value in getattr(report, "user_properties", ()) if name == _WRITTEN}
    if written:
        terminalreporter.section("Relievo's baselines")
        terminalreporter.line("Written; look at them, then run the tests without --relievo-update:")
        for each in sorted(written):
            terminalreporter.line(f"  {each}")
