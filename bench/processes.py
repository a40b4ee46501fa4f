# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time and memory of programs, for benches that measure whole commands."""

import argparse
import contextlib
import pathlib
import resource
import subprocess
import sys
import tempfile
import time
import typing

PEERS = pathlib.Path(__file__).with_name("peers.py")
NAME = pathlib.Path(sys.argv[0]).stem
PAUSE = 0.005  # minimum seconds between two samples of the memory
SHARE = 0.005  # of the time since the start


class Cost(typing.NamedTuple):
    seconds: float  # by the clock
    processor: float  # seconds of all its threads and processes
    peak: int = 0  # bytes, if requested


def parser(doc, rounds):
    """The command-line parser of a bench, with RELIEVO and --rounds."""
    made = argparse.ArgumentParser(description=doc.splitlines()[0])
    made.add_argument("relievo", metavar="RELIEVO", help="the command")
    made.add_argument("--rounds", type=int, default=rounds, help=f"({rounds})")
    return made


def children(pid):
    """A process and all its descendants."""
    yield pid
    for file in pathlib.Path(f"/proc/{pid}/task").glob("*/children"):
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):  # a thread that has ended
            for child in file.read_text().split():
                yield from children(child)


def memory(pid):
    """Bytes that a process and its descendants have held at most so far, each for itself, while
    they live together. What they share by shared memory counts once, and pages of files, such as
    libraries, not at all: other processes have them as well, and they can go."""
    found = set()  # a process that vfork has made has its parent's memory, and so its numbers
    for each in children(pid):
        try:
            lines = pathlib.Path(f"/proc/{each}/status").read_text().splitlines()
        except (FileNotFoundError, ProcessLookupError):
            continue  # it has ended
        kilobytes = {line.split()[0]: int(line.split()[1]) for line in lines if line[-3:] == " kB"}
        if kilobytes:  # excludes zombies
            found.add(tuple(kilobytes[f"{name}:"] for name in ("VmHWM", "RssFile", "RssShmem")))
    own = sum(most - file - shared for most, file, shared in found)
    return 1024 * (own + max((shared for *_, shared in found), default=0))


def run(words, peak=False):
    """The Cost of a program; SystemExit if it fails. Its memory is looked at every few
    milliseconds (Linux)."""
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    most = 0
    with tempfile.TemporaryFile("w+") as said:
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=said, text=True)
        while peak and process.poll() is None:
            most = max(most, memory(process.pid))
            time.sleep(max(PAUSE, SHARE * (time.monotonic() - began)))
        status = process.wait()
        after, ended = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        if status != 0:
            said.seek(0)
            raise SystemExit(f"{NAME}: {words[0]} failed\n{said.read()}")
    taken = (after.ru_utime + after.ru_stime) - (before.ru_utime + before.ru_stime)
    return Cost(ended - began, taken, most)
