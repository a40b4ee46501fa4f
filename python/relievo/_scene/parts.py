# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Work in parts: the command's --part, merge, verify and status from Python."""

import dataclasses
import json
import operator
import os
import pathlib
import re
import shlex
import subprocess

from .._arguments.errors import describe
from .program import program

_WITH_PARTS = ("dataset", "render", "sun", "viewshed", "visible")


@dataclasses.dataclass(frozen=True)
class Part:
    """One of the equal shares of a job, made by parts(): part `number`, from 1, of `count`.

    Calling a part computes it, in a process of its own, and returns the paths of its files; a part
    that is complete only returns them. It can be pickled, and be called on any machine that has
    the files: `words`, the call of the command, names files relative to `folder`.

    Raises, when it is called, ValueError for invalid words and RuntimeError if the work fails.
    """

    words: tuple
    folder: str
    number: int
    count: int

    def __call__(self) -> list[str]:
        """Computes the part.

        Returns the paths of its files. Raises ValueError for invalid words, RuntimeError if the
        work fails.
        """
        command, *words = self.words
        _run([command, f"--part={self.number}/{self.count}", *words], self.folder)
        return self.files()

    @property
    def directory(self) -> str:
        """The folder of all parts, which merge(), verify() and status() take."""
        name = _output(self.words)
        path = pathlib.Path(self.folder, name if self.words[0] == "dataset" else f"{name}.parts")
        return str(path)

    def files(self) -> list[str]:
        """The paths of the files that this part has written so far."""
        top = pathlib.Path(self.directory)
        base = top
        if self.words[0] == "dataset":
            records = [top / "views" / f"{view:06d}.json"
                       for view in self._share(top / "dataset.json", "views")]  # fmt: skip
        elif self.words[0] == "render":
            base = top.parent
            records = [top / f"frame-{frame:06d}.json"
                       for frame in self._share(top / "frames.json", "frames")]  # fmt: skip
        else:
            records = [top / f"part-{self.number:06d}.json"]
        paths = []
        for record in records:
            if record.exists():
                names = json.loads(record.read_text("utf-8"))["files"]
                paths += [base / name for name in names if _is_within(base / name, base)]
                paths.append(record)
        return [str(path) for path in paths]

    def _share(self, settings, items):
        """The numbers of this part's items, of as many as the settings say."""
        count = json.loads(settings.read_text("utf-8"))[items] if settings.exists() else 0
        share, rest = divmod(count, self.count)
        return range(*(n * share + min(n, rest) for n in (self.number - 1, self.number)))


def parts(job, n) -> list[Part]:
    """Returns n equal shares of a job, for processes on one or many machines.

        job = "sun town.obj --place 48.2,16.4 --dates 2026-06-21 -o town.vtp"
        parts = relievo.parts(job, 8)
        with concurrent.futures.ThreadPoolExecutor() as pool:
            for part in [pool.submit(part) for part in parts]:
                part.result()
        town = relievo.merge(parts)

    job: a call of `relievo dataset`, `render`, `sun`, `viewshed` or `visible` without the
        program's name, as one text (as in a shell) or a list of words. Files are relative to the
        folder in which parts() is called.
    n: number of parts, from 1. If n is larger than the number of items, some parts have no work.

    Parts can be pickled: concurrent.futures, joblib, dask.distributed and submitit take them as
    functions without arguments. The result of merge() does not depend on n, nor on the order in
    which the parts ran. Raises ValueError for invalid arguments.
    """
    try:
        words = tuple(shlex.split(job)) if isinstance(job, str) else tuple(map(os.fspath, job))
    except TypeError:
        words = ()
    if not words or words[0] not in _WITH_PARTS:
        raise ValueError(f"job: got {job!r}, expected the words of {', '.join(_WITH_PARTS)}")
    _output(words)
    try:
        count = 0 if isinstance(n, bool) else operator.index(n)
    except TypeError:
        count = 0
    if count < 1:
        raise ValueError(f"n: got {n!r}, expected a whole number from 1")
    return [Part(words, os.getcwd(), number, count) for number in range(1, count + 1)]


def merge(parts) -> str:
    """Joins the parts of a job, and returns the path of the result: the file, or the folder of the
    data set. Frames without a film are complete without merge(), which then checks them and returns
    the folder of the parts, beside the pictures.

    parts: the list from parts(), all of them complete; or the folder of the parts.

    The result is that of a single process, byte for byte. Raises ValueError for invalid arguments,
    RuntimeError if parts are missing or damaged, or the result cannot be written.
    """
    directory = _directory(parts)
    _run(["merge", "--", directory])
    frames = pathlib.Path(directory, "frames.json")
    is_file = (json.loads(frames.read_text("utf-8"))["film"] != "" if frames.exists()
               else pathlib.Path(directory, "parts.json").exists())  # fmt: skip
    return directory.removesuffix(".parts") if is_file else directory


def verify(parts) -> str:
    """Checks the parts of a job and their result, and changes nothing.

    parts: as for merge().

    Returns "" if everything is complete, otherwise a text that lists parts that are missing,
    damaged, or made by another version. Raises ValueError for invalid arguments, RuntimeError if
    the folder cannot be checked.
    """
    done = _run(["verify", "--", _directory(parts)], good=(0, 3))
    return done.stdout if done.returncode == 3 else ""


@dataclasses.dataclass(frozen=True)
class PartStatus:
    """How far part `number` of `count` is, from status().

    `done` of `all` items are complete: views of a data set, frames, percent of other work. `rate`
    is the number of items per second, `seconds_left` the time that the rest takes at this rate;
    both are None as long as nothing is measured. Raises TypeError for fields that are missing.
    """

    number: int
    count: int
    done: float
    all: float
    rate: float | None
    seconds_left: float | None


def status(parts) -> list[PartStatus]:
    """Returns how far the parts of a job are, those that have begun, in their order.

    parts: as for merge(). After merge() the list is empty.

    Changes nothing, and may be called while parts run, on any machine that has the folder. Raises
    ValueError for invalid arguments and for a folder that no job has begun.
    """
    top = pathlib.Path(_directory(parts))
    if not any((top / name).exists() for name in ("dataset.json", "frames.json", "parts.json")):
        raise ValueError(f"parts: got {str(top)!r}, expected a folder that relievo dataset, "
                         "render, sun, viewshed or visible has begun")
    found = []
    for path in sorted((top / "progress").glob("part-*.json")):
        try:
            said = json.loads(path.read_text("utf-8"))
            done, total, made = said["done"], said["all"], said["done"] - said["before"]
            rate = made / said["seconds"] if made > 0 and said["seconds"] > 0 else None
            left = 0.0 if done >= total else None if rate is None else (total - done) / rate
            found.append(PartStatus(said["part"], said["of"], done, total, rate, left))
        # Removed meanwhile, by merge(), or damaged.
        except (OSError, ValueError, KeyError, TypeError):
            continue
    return found


def _directory(parts):
    if isinstance(parts, (str, os.PathLike)):
        return os.fspath(pathlib.Path(parts))  # without a slash at the end
    parts = list(parts) if hasattr(parts, "__iter__") else [parts]
    folders = {part.directory if isinstance(part, Part) else None for part in parts}
    if len(folders) != 1 or None in folders:
        raise ValueError(f"parts: got {describe(parts)}, expected the parts of one job, from "
                         "parts(), or a folder")
    return folders.pop()


def _is_within(path, top):
    return path.resolve().is_relative_to(top.resolve())


def _output(words):
    """The value of the option for the output; of frames the film, or a file without its number."""
    names = {"dataset": ["--out"],
             "render": ["--video", "--png", "--exr", "--baseline", "--gltf", "--report"]
             }.get(words[0], ["-o"])  # fmt: skip
    end = words.index("--") if "--" in words else len(words)
    for name in names:
        for at, word in enumerate(words[:end]):
            if word == name and at + 1 < len(words):
                value = words[at + 1]
            elif word.startswith(f"{name}="):
                value = word.partition("=")[2]
            else:
                continue
            is_numbered = words[0] == "render" and name != "--video"
            return re.sub("%[0-9]*d", "", value) if is_numbered else value
    raise ValueError(f"job: got no {names[0]}, expected the words of {words[0]} with their output")


def _run(words, folder=None, good=(0,)):
    path = program()
    if path is None:
        raise RuntimeError("relievo: this build has no command: build the target relievo, or "
                           "install a wheel")
    done = subprocess.run([path, *words], cwd=folder, text=True, capture_output=True, check=False)
    if done.returncode not in good:
        raise (ValueError if done.returncode == 2 else RuntimeError)(
            done.stderr.strip() or f"relievo {words[0]}: ended with {done.returncode}")
    return done
