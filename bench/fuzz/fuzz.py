#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damaged files of every format that Relievo reads, reproducible by seed: each is drawn, or refused
with one message that names it; nothing crashes, hangs or takes too much memory, and no files are
left behind.

    fuzz.py [--seconds N | --files N] [--seed N] [--only N] [--formats A,B,...]

--seconds: time to make new files (RELIEVO_FUZZ_SECONDS, or 300). --files: number of files, without
a time limit. --seed: seed of the files (RELIEVO_FUZZ_SEED, or one from the clock, which is
printed). --only: only file N, which stays in the printed folder. A failing file is kept below
RELIEVO_TEST_OUTPUT (or the current folder) in fuzz-failures, with the command to repeat it.
Exit: 0 no failure, 1 failures.

Environment: RELIEVO_FUZZ (the program relievo-fuzz-files), RELIEVO and VIEWER (the command and the
viewer; may be missing), RELIEVO_DATA.
"""

import argparse
import collections
import contextlib
import json
import os
import pathlib
import random
import re
import select
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
import time

from damage import damage
from PIL import Image
from samples import all_samples

SECONDS = 20  # of the processor, per file: its reader may take 15
IDLE = 300  # by the clock, for a process that waits for ever; less than the limit of testFuzz
MEMORY = (8 << 30) + (1 << 28)  # per process: the limit for small files, plus the program
BATCH = 400  # files drawn by one process
BY_COMMAND = 40  # one of so many files is also drawn by the command itself
READER = re.compile(r"reader(?: \(\w+\))? (?:crashed|did not end|used more|ended early|was ended)")
PROGRESS = re.compile(r"relievo: .* \d+ %")  # of a step of more than two seconds
LOOK = ["--size", "48x48", "--background", "0.3/0.5/0.7", "--png", "out.png"]


def processor_seconds(process):
    """Those of a process, of the processes that it started, and of theirs."""
    ticks, started = collections.Counter(), collections.defaultdict(list)
    for each in pathlib.Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):  # it has ended
            fields = each.read_text(errors="replace").rpartition(")")[2].split()
            number = int(each.parent.name)
            started[int(fields[1])].append(number)
            ticks[number] = sum(map(int, fields[11:15]))  # with those that ended
    found = [process.pid]
    for number in found:
        found += started[number]
    return sum(ticks[number] for number in found) / os.sysconf("SC_CLK_TCK")


def complaint(process, is_done):
    """Nothing once is_done(one second) is true, or a text if the process, which is then killed,
    works or waits for too long. The first second does not count."""
    if is_done(1):
        return ""
    before, began = processor_seconds(process), time.monotonic()
    while not is_done(1):
        took = processor_seconds(process) - before
        if took > SECONDS or time.monotonic() - began > IDLE:
            process.kill()
            return (f"did not end within {SECONDS} processor seconds and {IDLE} s: "
                    f"it took {took:.0f}")  # fmt: skip
    return ""


class Driver:
    """A process that draws files one by one."""

    def __init__(self, folder, temporary):
        self.errors = tempfile.TemporaryFile()
        self.process = subprocess.Popen(
            [os.environ["RELIEVO_FUZZ"]], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=self.errors, env={**os.environ, "TMPDIR": str(temporary)})  # fmt: skip
        self.drawn = 0

    def draw(self, words):
        """The answer, or a text on the failure of the process."""
        self.drawn += 1
        try:
            self.process.stdin.write(json.dumps(words).encode() + b"\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass
        fault = complaint(
            self.process, lambda seconds: select.select([self.process.stdout], [], [], seconds)[0])
        if fault:
            return fault
        line = self.process.stdout.readline()
        if line:
            answer = json.loads(line)
            return {"status": answer["status"], "say": answer["say"]}
        status = self.process.wait()
        self.errors.seek(0)
        return f"ended with status {status}: {self.errors.read()[-600:].decode(errors='replace')}"

    def end(self):
        """The peak memory of the process and its readers, in bytes."""
        self.process.stdin.close()
        self.process.stdout.close()
        self.errors.close()
        if self.process.returncode is not None:
            return 0  # already awaited
        _, status, usage = os.wait4(self.process.pid, 0)
        self.process.returncode = status
        return usage.ru_maxrss << 10


def judge(answer, sample, folder):
    """The problem of an answer, or nothing."""
    if isinstance(answer, str):
        return answer
    said = answer["say"]
    if answer["status"] == 0:
        try:
            with Image.open(folder / "out.png") as picture:
                colors = picture.convert("RGB").getcolors(1 << 16)
        except (OSError, SyntaxError) as error:
            return f"done, but its picture cannot be read: {error}"
        # Incomplete files are drawn with a note. A lens may look elsewhere.
        empty = len(colors) == 1 and not said and sample.kind != "yml"
        return "an empty picture, without a word" if empty else ""
    if answer["status"] not in (1, 2):
        return f"exit status {answer['status']}"
    if len(said) != 1 or "\n" in said[0] or not said[0].strip():
        return f"not one line: {said}"
    names = list(sample.files)
    if sample.kind == "session":  # a session may name other files
        names += re.findall(r'"([^"]+)"', (folder / "a.json").read_text(errors="replace"))
    if not any(name in said[0] for name in names):
        return f"a message that names no file: {said[0]}"
    return ""


def by_program(words, program, folder, temporary):
    """The answer of the command or the viewer itself, in the same form."""

    def is_done(seconds):
        with contextlib.suppress(subprocess.TimeoutExpired):
            done.wait(seconds)
        return done.returncode is not None

    with tempfile.TemporaryDirectory() as runtime, tempfile.TemporaryFile() as errors:
        # Without XDG_RUNTIME_DIR, Qt makes a folder in TMPDIR, which must stay empty.
        folders = {"TMPDIR": str(temporary), "XDG_RUNTIME_DIR": runtime}
        done = subprocess.Popen([program, *words], cwd=folder, stdout=subprocess.DEVNULL,
                                stderr=errors, env={**os.environ, **folders})  # fmt: skip
        fault = complaint(done, is_done)
        if fault:
            done.wait()
            return fault
        errors.seek(0)
        lines = errors.read().decode(errors="replace").splitlines()
    name = pathlib.Path(program).name + ": "
    said = [line.removeprefix(name) for line in lines if not PROGRESS.fullmatch(line)]
    if done.returncode not in (0, 1, 2):
        return f"ended with status {done.returncode}: {said}"
    return {"status": done.returncode, "say": said}


class Campaign:
    def __init__(self, seed, formats):
        self.seed = seed
        self.samples = all_samples(pathlib.Path(os.environ["RELIEVO_DATA"]))
        if not os.environ.get("VIEWER"):
            self.samples.pop("session")
        unknown = set(formats or ()) - set(self.samples)
        if unknown:
            sys.exit(f"fuzz.py: --formats: no {', '.join(sorted(unknown))}; expected some of "
                     + ", ".join(self.samples))  # fmt: skip
        self.kinds = formats or list(self.samples)
        self.kept = pathlib.Path(os.environ.get("RELIEVO_TEST_OUTPUT", ".")) / "fuzz-failures"
        self.counts, self.read, self.ended = (collections.Counter() for _ in range(3))
        self.failures, self.seconds, self.memory = [], collections.Counter(), 0
        self.lock = threading.Lock()

    def check_samples(self):
        """Draws the undamaged samples: all must be valid, except models from other sources."""
        with tempfile.TemporaryDirectory() as base:
            folder = pathlib.Path(base)
            driver = Driver(folder, folder)
            for kind in set(self.kinds) - {"session"}:
                sound = []
                for sample in self.samples[kind]:
                    sample.write(folder)
                    answer = driver.draw([*sample.words, *LOOK])
                    if answer["status"] == 0:
                        sound.append(sample)
                    elif not sample.of_others:
                        sys.exit(f"fuzz.py: a sound {kind} file is refused: {answer['say']}")
                self.samples[kind] = sound
            driver.end()

    def make(self, number, folder):
        """Writes the files of a number; returns their sample."""
        rng = random.Random(f"{self.seed}:{number}")
        sample = rng.choice(self.samples[self.kinds[number % len(self.kinds)]])
        name = rng.choice(sample.damaged)
        other = rng.choice(self.samples[sample.kind])
        more = other.files[rng.choice(other.damaged)]
        sample.write(folder, {name: damage(rng, name, sample.files[name], more)})
        return sample

    def keep(self, number, sample, folder, words, fault):
        kept = self.kept / f"{self.seed}-{number}"
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(folder, kept)
        (kept / "command.txt").write_text(shlex.join(words) + f"\n{fault}\n")
        print(f"FAILURE {kept} ({sample.kind}): {fault}\n  {shlex.join(words)}", flush=True)
        self.failures.append(number)

    def left(self, sample, folder, temporary):
        """Files left behind, or nothing."""
        expected = {pathlib.Path(name).parts[0] for name in sample.files} | {"out.png"}
        more = [each.name for each in folder.iterdir() if each.name not in expected]
        more += [each.name for each in temporary.iterdir()]
        return f"left {', '.join(more)}" if more else ""

    def try_one(self, number, driver, folder, temporary):
        """False if the driver must be replaced."""
        for each in (*folder.iterdir(), *temporary.iterdir()):  # the driver uses the folders
            shutil.rmtree(each) if each.is_dir() else each.unlink()
        sample = self.make(number, folder)
        session = sample.kind == "session"
        words = [*sample.words, *([] if session else LOOK)]
        whole = ([os.environ["VIEWER"], *words, "--once"] if session else
                 [os.environ.get("RELIEVO", "relievo"), "render", *words])  # fmt: skip
        began = time.monotonic()
        if session:
            answer = by_program(whole[1:], whole[0], folder, temporary)
            fault = answer if isinstance(answer, str) else ""
            if not fault and answer["status"] != 0:
                fault = judge(answer, sample, folder)
        else:
            answer = driver.draw(words)
            fault = judge(answer, sample, folder)
        took = time.monotonic() - began
        fault = fault or self.left(sample, folder, temporary)
        if not fault and not session and number % BY_COMMAND == 0 and "RELIEVO" in os.environ:
            (folder / "out.png").unlink(missing_ok=True)
            command = by_program(whole[1:], whole[0], folder, temporary)
            alike = command == answer or (command["status"] == 0 == answer["status"])
            fault = "" if alike else f"the command: {command}, the driver: {answer}"
        with self.lock:
            self.counts[sample.kind] += 1
            self.seconds[sample.kind] += took
            self.read[sample.kind] += not isinstance(answer, str) and answer["status"] == 0
            self.ended[sample.kind] += not isinstance(answer, str) and any(
                READER.search(line) for line in answer["say"])  # fmt: skip
            if fault:
                self.keep(number, sample, folder, whole, fault)
        return not isinstance(answer, str) or session

    def work(self, first, step, goes_on, only):
        with tempfile.TemporaryDirectory() as base:
            folder, temporary = pathlib.Path(base) / "files", pathlib.Path(base) / "temporary"
            folder.mkdir()
            temporary.mkdir()
            driver = Driver(folder, temporary)
            number = first
            while goes_on(number) or number == first:
                of_use = self.try_one(number, driver, folder, temporary)
                if not of_use or driver.drawn >= BATCH:
                    self.renew(driver)
                    driver = Driver(folder, temporary)
                if only:
                    break
                number += step
            self.renew(driver)

    def renew(self, driver):
        memory = driver.end()
        with self.lock:
            self.memory = max(self.memory, memory)

    def run(self, seconds, files, only):
        self.check_samples()
        until = time.monotonic() + seconds

        def goes_on(number):
            return number < files if files else time.monotonic() < until

        step = 1 if only is not None else max(1, (os.cpu_count() or 1))
        alone = only is not None
        threads = [threading.Thread(target=self.work, args=(only or i, step, goes_on, alone))
                   for i in range(step)]  # fmt: skip
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        if self.memory > MEMORY:
            print(f"FAILURE: a process used {self.memory} bytes")
            self.failures.append(-1)
        for kind in sorted(self.counts):
            print(f"{kind:8} {self.counts[kind]:6} files, {self.read[kind]:6} of them drawn, "
                  f"{self.ended[kind]:4} ended a reader, "
                  f"{1000 * self.seconds[kind] / self.counts[kind]:6.1f} ms a file")
        drawn = sum(self.read.values()) / sum(self.counts.values())
        if only is None and not 0.05 < drawn < 0.95:
            print(f"FAILURE: {100 * drawn:.0f} % are drawn: the damage is of no use")
            self.failures.append(-1)
        print(f"{sum(self.counts.values())} files, {len(self.failures)} failures, at most "
              f"{self.memory / 2**20:.0f} MiB; seed {self.seed}")
        return 1 if self.failures else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float,
                        default=float(os.environ.get("RELIEVO_FUZZ_SECONDS", 300)))  # fmt: skip
    parser.add_argument("--files", type=int)
    parser.add_argument("--seed", type=int,
                        default=int(os.environ.get("RELIEVO_FUZZ_SEED", time.time())))  # fmt: skip
    parser.add_argument("--only", type=int)
    parser.add_argument("--formats", type=lambda text: text.split(","))
    given = parser.parse_args()
    print(f"seed {given.seed}", flush=True)
    sys.exit(Campaign(given.seed, given.formats).run(
        given.seconds, given.files, given.only))


if __name__ == "__main__":
    main()
