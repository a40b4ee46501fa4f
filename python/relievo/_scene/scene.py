# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of files, as `relievo render` makes them."""

import json
import logging
import numbers
import os
import tempfile
import textwrap
import warnings
from collections.abc import Sequence
from typing import Any

from .._arguments.errors import Watch, check_file, path_of, require
from .._wrapped import vtkRelievoPass, vtkRelievoScene
from ..vtk.vtkCommonCore import vtkStringArray
from ..vtk.vtkRenderingCore import vtkRenderer, vtkRenderWindow

_OPTIONS = {
    row["name"][2:].replace("-", "_"): row for row in json.loads(vtkRelievoScene.GetOptions())
}

_LOG = logging.getLogger("relievo")

# Separators of the numbers of a tuple; the default is a comma.
_BETWEEN = {"size": "x", "color": "/", "background": "/"}

_OF_MOVIES = ["turntable", "camera_path", "video", "fps", "resume"]
_OUTPUTS = [name for name, row in _OPTIONS.items() if row["outputs"] and name != "lens"]


def _word(name, value):
    """A value as the argument of an option."""
    if isinstance(value, (bytes, str, os.PathLike)):
        return os.fsencode(value)
    if isinstance(value, numbers.Real):
        return repr(value + 0).encode()
    try:
        words = [_word(name, each) for each in value]
    except TypeError:
        raise ValueError(
            f"{name}: got {value!r}, expected text, a number, or several of them"
        ) from None
    is_text = any(isinstance(each, (bytes, str)) for each in value)
    return (b"," if is_text else _BETWEEN.get(name, ",").encode()).join(words)


def _words(name, value):
    """The command-line arguments of an option: --name value, once for each value."""
    if name not in _OPTIONS:
        raise ValueError(f"{name}: got an option that there is not, expected {', '.join(_OPTIONS)}")
    option = _OPTIONS[name]
    if value is None or value is False:
        return []
    if not option["value"]:
        if value is not True:
            raise ValueError(f"{name}: got {value!r}, expected True or False")
        return [option["name"].encode()]
    if value is True:
        raise ValueError(f"{name}: got True, expected {option['value']}")
    several = isinstance(value, list) if option["repeats"] else False
    return [
        word
        for each in (value if several else [value])
        for word in (option["name"].encode(), _word(name, each))
    ]


def _key(seconds, view):
    """A key of a camera's path."""
    if hasattr(view, "GetPosition"):
        view = (view.GetPosition(), view.GetFocalPoint(), view.GetViewUp())
    position, focus, up = (list(map(float, each)) for each in view)
    return {"time": float(seconds), "position": position, "focal_point": focus, "view_up": up}


class Scene:
    """A scene of files with options; see scene()."""

    def __init__(self, files: Sequence[str | os.PathLike[str]], options: dict[str, Any]) -> None:
        self._scene = vtkRelievoScene()
        self._files = [os.fsencode(path_of(path, "files")) for path in files]
        self._options: dict[str, Any] = {}
        self._logged: list[str] = []
        self._stale = True
        self.set(**options)

    def __repr__(self):
        words = [*(repr(os.fsdecode(path)) for path in self._files),
                 *(f"{name}={value!r}" for name, value in self._options.items())]  # fmt: skip
        return f"relievo.scene({', '.join(words)})"

    def set(self, **options: Any) -> "Scene":
        """Changes options; None restores the default. Returns the scene."""
        bad = sorted(set(options) & set(_OUTPUTS))
        if bad:
            taker = "movie" if bad[0] in _OF_MOVIES else "render"
            raise ValueError(f"{bad[0]}: got an option of outputs, which {taker}() takes")
        wanted = {**self._options, **options}
        self._say(wanted)
        self._check_files(wanted)
        self._options = {name: value for name, value in wanted.items() if value is not None}
        self._stale = True
        return self

    def update(self) -> "Scene":
        """Reads new files and applies changed options. Returns the scene.

        The camera is set by the options, or fitted if none is given.
        """
        self._say(self._options)
        self._check_files(self._options)
        self._run(self._scene.Update)
        self._stale = False
        return self

    def render(
        self,
        png=None,
        *,
        exr=None,
        baseline=None,
        report=None,
        layers=None,
        hdr=False,
        transparent=False,
        certify=None,
    ):
        """Draws the scene and writes files: a picture, layers, the frame's report; all or none.

        png, exr, baseline, report: paths; baseline is a file for compare(). layers: names of layers
        in the EXR beside its colour (depth).
        hdr: the EXR's colour is linear light. transparent: the picture has no background.
        certify: the number of shadow verdicts to check by rays in double precision; the finding
        is returned as a text.
        """
        outputs = {"png": png, "exr": exr, "report": report, "hdr": hdr, "certify": certify}
        outputs["baseline"] = baseline
        outputs["transparent"] = transparent
        outputs["layers"] = ",".join(layers) if layers and not isinstance(layers, str) else layers
        self._write(outputs)
        return self._scene.GetCertificate() or None

    def movie(
        self,
        video=None,
        *,
        turntable=None,
        camera_path=None,
        fps=None,
        png=None,
        resume=False,
    ):
        """Draws the frames of a moving camera, or of the option `times`, and writes them.

        video: the path of a film, .mp4 (H.264) or .mkv (FFV1, lossless), which the program ffmpeg
        makes; where it is missing, PNG files beside that path are written instead, with a note.
        turntable: the number of frames in which the camera goes once around the scene.
        camera_path: a JSON or CSV file of views through which the camera moves, or a list of pairs
        (seconds, view), where a view is a vtkCamera or (position, focal point, up direction).
        fps: frames per second (25). png: a path with %d or %04d, the number of the frame.
        resume: draws only the frames whose PNG files do not exist; it needs png.
        Raises ValueError for invalid arguments, OSError for files, RuntimeError for failed drawing.
        """
        outputs = {"video": video, "turntable": turntable, "fps": fps, "png": png, "resume": resume}
        if camera_path is None or isinstance(camera_path, (bytes, str, os.PathLike)):
            self._write({**outputs, "camera_path": camera_path})
            return
        try:
            keys = [_key(seconds, view) for seconds, view in camera_path]
        except (TypeError, ValueError):
            keys = []
        if len(keys) < 2:
            raise ValueError(
                f"camera_path: got {camera_path!r}, expected a path or at least two pairs "
                "(seconds, view), each view a vtkCamera or (position, focal point, up direction)"
            )
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "path.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump({"keys": keys}, file)
            self._write({**outputs, "camera_path": path})

    def _write(self, outputs):
        self._stale = True
        self._say({**self._options, **outputs})
        self._check_files(self._options)
        self._run(self._scene.Write)
        # A picture drawn in bands may be too large for the window.
        self._stale = self._scene.GetRenderWindow().GetTileScale() != (1, 1)

    def capture_baseline(self, image: Any, portable: bool = False) -> None:
        """Draws a baseline, as write_baseline() writes it, into a vtkImageData."""
        self._say(self._options)
        self._check_files(self._options)
        self._run(lambda: self._scene.CaptureBaseline(image, portable))
        self._stale = False

    def _repr_png_(self):
        """The picture, which notebooks show."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.png")
            self.render(path)
            with open(path, "rb") as file:
                return file.read()

    @property
    def renderer(self) -> vtkRenderer:
        """The vtkRenderer that shows the scene, up to date with its options.

        Changes by a script stay until an option changes the same setting.
        """
        if self._stale:
            self.update()
        return self._scene.GetRenderer()

    @property
    def window(self) -> vtkRenderWindow:
        """The renderer's vtkRenderWindow: off screen, unless another was set."""
        if self._stale:
            self.update()
        return self._scene.GetRenderWindow()

    @window.setter
    def window(self, window: vtkRenderWindow | None) -> None:
        if window is not None:
            require(window, "vtkRenderWindow", "window")
        self._scene.SetRenderWindow(window)  # type: ignore[arg-type]
        self._stale = True

    @property
    def frame(self) -> vtkRelievoPass | None:
        """The vtkRelievoPass around VTK's drawing; None if no option needs one."""
        if self._stale:
            self.update()
        return self._scene.GetPass()

    @property
    def notes(self) -> list[str]:
        """Parts that the last update or picture left out or repaired, a line each.

        They are also logged, by the logger `relievo` at the level INFO.
        """
        notes = self._scene.GetNotes()
        return [notes.GetValue(i) for i in range(notes.GetNumberOfValues())]

    def _say(self, options):
        words = vtkStringArray()
        for name, value in options.items():
            for word in _words(name, value):
                words.InsertNextValue(word)
        words.InsertNextValue("--")
        for path in self._files:
            words.InsertNextValue(path)
        self._run(lambda: self._scene.SetWords(words))

    def _check_files(self, options):
        """Raises Python's own errors for files that cannot be opened."""
        files = self._scene.GetInputFiles()
        for i in range(files.GetNumberOfValues()):
            check_file(files.GetValue(i))
        folders = options.get("allow_folder") or []
        for folder in folders if isinstance(folders, list) else [folders]:
            os.scandir(folder).close()

    def _run(self, work):
        with Watch(self._scene):
            done = work()
        if not done:
            scene = self._scene
            kinds = {
                scene.USAGE_FAILURE: ValueError,
                scene.FILE_FAILURE: OSError,
                scene.DRAW_FAILURE: RuntimeError,
            }
            raise kinds[scene.GetFailure()](scene.GetFailureText())
        found = self._scene.GetWarnings()
        for i in range(found.GetNumberOfValues()):
            warnings.warn(found.GetValue(i), RuntimeWarning, stacklevel=4)
        notes, self._logged = self._logged, self.notes
        for note in self._logged:
            if note not in notes:
                _LOG.info("%s", note)


def scene(*files, **options) -> Scene:
    files = [files] if isinstance(files, (str, bytes)) else files
    return Scene(files, options)


def _describe():
    """The docstring of scene(), with every option of the command."""
    text = '''A scene of files, as `relievo render` makes it: render() draws it, renderer is VTK's.

    relievo.scene("bike.obj").render("bike.png")

files: in formats that `relievo --help` lists. Options are those of the command, with _ for -: text
as behind the option, a number, a tuple of numbers, True for an option without a value; a list for
one that may be repeated. Raises ValueError for invalid options; FileNotFoundError,
IsADirectoryError or another OSError for a file that cannot be opened, at once, and OSError for one
that cannot be read or written; RuntimeError for drawing that fails.

'''
    for name, row in _OPTIONS.items():
        if name not in _OUTPUTS:
            value = f"={row['value']}" if row["value"] else "=True"
            lines = textwrap.indent(row["help"], "    ")
            text += f"{name}{value}\n{lines}\n"
    return text


scene.__doc__ = _describe()
