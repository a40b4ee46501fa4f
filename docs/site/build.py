#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lays out the site's sources for Sphinx: the pages of docs/, and those that are made from code.

    build.py DEST        DEST: a folder for them, made anew

Made are the examples (examples/*.py), the gallery's pairs of pictures (gallery.py), and the
reference of the package and of every wrapped class (reference.py). Needs relievo to be importable,
and RELIEVO_DATA.
"""

import ast
import pathlib
import re
import shutil
import sys

import gallery
import reference

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def install_lines():
    """The README's lines that install the package, which the home page repeats."""
    readme = (ROOT / "README.md").read_text()
    lines = re.search(r"```\n[^`]*\bpip3? install\b[^`]*```", readme)
    if not lines:
        raise SystemExit("build.py: README.md has no block of lines with 'pip install'")
    return lines[0]


def linked(text, depth):
    """Links out of docs/ to what the site has of it: examples as pages, other sources as files."""
    up = "../" * depth
    root = re.escape("](../" + up)  # of the sources
    text = re.sub(rf"{root}examples/(\w+)\.py\)", rf"]({up}examples/\1.md)", text)
    text = re.sub(rf"{root}examples\)", f"]({up}examples/index.md)", text)
    text = re.sub(rf"{root}CONTRIBUTING\.md", f"]({up}contributing.md", text)
    return re.sub(rf"{root}(shaders/[^)#]*)\)", rf"]({up}sources/\1)", text)


def lay_pages(dest):
    for page in sorted((ROOT / "docs").rglob("*.md")):
        name = page.relative_to(ROOT / "docs")
        if name.parts[0] == "site":
            continue
        text = linked(page.read_text(), len(name.parts) - 1)
        for source in re.findall(r"\]\((?:\.\./)*sources/([^)]*)\)", text):
            kept = dest / "sources" / source
            kept.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / source, kept)
        (dest / name).parent.mkdir(parents=True, exist_ok=True)
        (dest / name).write_text(text)
    contributing = (ROOT / "CONTRIBUTING.md").read_text().replace("](docs/", "](")
    (dest / "contributing.md").write_text(contributing)
    for folder in ("charts", "pictures", "notebooks"):
        shutil.copytree(ROOT / "docs" / folder, dest / folder, dirs_exist_ok=True,
                        ignore=shutil.ignore_patterns("*.md"))
    for page in ("learn", "guide", "reference"):
        shutil.copy(HERE / f"{page}.md", dest)
    home = (HERE / "index.md").read_text().replace("@INSTALL@", install_lines())
    (dest / "index.md").write_text(home)
    shutil.copytree(HERE / "static", dest / "site/static")
    shutil.copy(HERE / "conf.py", dest)


def lay_examples(dest):
    """A page an example: what its docstring says, and the file."""
    (dest / "examples").mkdir()
    names = []
    for source in sorted((ROOT / "examples").glob("[0-9]*.py")):
        text = source.read_text()
        said = ast.get_docstring(ast.parse(text)).split("\n", 1)
        shutil.copy(source, dest / "examples")
        body = f"# {said[0].rstrip('.')}\n\n"
        if len(said) > 1:
            body += f"```text\n{said[1].strip()}\n```\n\n"
        body += f"```{{literalinclude}} {source.name}\n:language: python\n```\n"
        (dest / "examples" / f"{source.stem}.md").write_text(body)
        names.append(source.stem)
    for module in ("scene", "sun", "knot", "demo_sheet", "paraview_sheet"):
        shutil.copy(ROOT / "examples" / f"{module}.py", dest / "examples")
    listed = "\n".join(names)
    (dest / "examples/index.md").write_text(
        "# Examples\n\nComplete scripts, in the folder `examples/`. Most use meshes that "
        f"`tools/unpack-data` unpacks.\n\n```{{toctree}}\n:maxdepth: 1\n{listed}\n```\n")


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    dest = pathlib.Path(sys.argv[1]).resolve()
    shutil.rmtree(dest, ignore_errors=True)
    dest.mkdir(parents=True)
    lay_pages(dest)
    lay_examples(dest)
    reference.lay(dest / "api")
    gallery.lay(dest)


main()
