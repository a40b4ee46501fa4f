# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""testNewPass.py SOURCE CMAKE CTEST [CMAKE OPTIONS...]: "add a pass in N steps", done.

In a copy of the tree, tools/new-pass adds a pass; the copy is built and the new pass's own test
runs. The copy keeps its build, so that a second run compiles only what changed.
"""

import filecmp
import os
import pathlib
import shutil
import subprocess
import sys

NAME = "Mist"


def run(words, status=0, **options):
    done = subprocess.run(words, capture_output=True, text=True, check=False, **options)
    if done.returncode != status:
        sys.exit(f"{' '.join(map(str, words))}: status {done.returncode}, expected {status}\n"
                 f"{done.stdout[-6000:]}{done.stderr[-6000:]}")
    return done.stdout + done.stderr


def copy_tree(source, tree):
    """The files that git knows or would add; an unchanged file keeps its time."""
    listed = subprocess.run(
        ["git", "-C", source, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        capture_output=True, check=False)
    if listed.returncode != 0:
        print("skipped: the source is not a git tree")
        sys.exit(125)
    names = {name for name in os.fsdecode(listed.stdout).split("\0") if name}
    names = {name for name in names if (source / name).is_file()}
    for name in names:
        target = tree / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or not filecmp.cmp(source / name, target, shallow=False):
            shutil.copy(source / name, target)
    for path in tree.rglob("*"):
        name = path.relative_to(tree)
        if path.is_file() and name.parts[0] != "build" and name.as_posix() not in names:
            path.unlink()


def main(source, cmake, ctest, *options):
    source = pathlib.Path(source)
    tree = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"]) / "tree"
    copy_tree(source, tree)
    generator = [tree / "tools" / "new-pass"]
    run([*generator, "two words", "Nothing"], status=2)
    run([*generator, NAME], status=2)
    print(run([*generator, NAME, "Mist in front of what is far"]))
    again = run([*generator, NAME, "Once more"], status=1)
    assert "there already" in again, again

    listed = (tree / "CHANGELOG.md").read_text(encoding="utf-8")
    assert f"- `vtkRelievo{NAME}Stage`: mist in front of what is far.\n" in listed, listed
    check = subprocess.run([tree / "tools" / "check", "--no-tidy", "--tree", tree],
                           capture_output=True, text=True, check=False)
    complaints = [line for line in check.stdout.splitlines() if NAME.lower() in line.lower()]
    assert not complaints, complaints

    build = tree / "build" / "dev"
    run([cmake, "-G", "Ninja", "-S", tree, "-B", build, *options])
    run([cmake, "--build", build, "--target", f"test{NAME}Stage"])
    output = run([ctest, "--test-dir", build, "-R", f"^test{NAME}Stage$", "--no-tests=error",
                  "--output-on-failure"])
    assert "100% tests passed" in output, output
    print(output)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
