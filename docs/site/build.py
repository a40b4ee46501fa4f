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
from relievo.vtk.vtkImagingCore import vtkImageResize
from relievo.vtk.vtkIOImage import vtkJPEGWriter, vtkPNGReader

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent

# Index terms of pages: words that users search for where the page has others.
TERMS = {
    "cameras": ("K matrix", "camera matrix", "intrinsics", "extrinsics", "OpenCV", "distortion"),
    "command-line": ("colour bar", "color bar", "scalar bar", "turntable", "video"),
    "compare": ("image regression", "baseline", "pytest", "ctest", "image comparison"),
    "datasets": ("COCO", "BOP", "NeRF", "YOLO", "KITTI", "segmentation mask", "training data"),
    "exr": ("OpenEXR",),
    "install": ("pip", "wheel", "apt", "installation"),
    "layers": ("depth buffer", "z-buffer", "depth map", "g-buffer", "object id"),
    "parts": ("Slurm", "Dask", "cluster"),
    "passes/Ambient": ("ambient occlusion", "SSAO", "contact shadow"),
    "passes/Antialias": ("anti-aliasing", "supersampling", "FXAA"),
    "passes/Tone": ("tone mapping", "HDR", "exposure"),
    "rays": ("ray tracing", "ray casting", "intersection"),
    "shadows": ("shadow map", "soft shadow", "shadow acne", "volume shadow"),
}

# Pictures of the guide's cards for pages that begin with none.
CARDS = {
    "choosing-formats": "charts/layers/depth-ratio.svg",
    "command-line": "pictures/lines-hidden.png",
    "exr": "pictures/layers.png",
    "frame": "charts/effects/effects.svg",
    "gltf": "pictures/windows-viewer-model.png",
    "install": "pictures/demo.png",
    "material-filters": "site/static/pairs/relief-on.png",
    "parts": "charts/programs/scale.svg",
    "passes/Antialias": "charts/programs/studio.svg",
    "passes/Blend": "pictures/soft_borders.png",
    "passes/Deferred": "charts/lights/deferred.svg",
    "passes/EmptySpace": "pictures/smoke.png",
    "passes/Fill": "pictures/viewer.png",
    "passes/Tone": "site/static/pairs/tone-on.png",
    "python": "pictures/scale-bar.png",
    "shadow-matrix": "site/static/pairs/colored-on.png",
}
CARD_WIDTH = 480


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


def slug(title):
    """The anchor of a heading."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def short_headings(text):
    """Headings that are signatures become names above the signatures, which the list of a page
    shows whole; also the new anchors by the old ones.
    """
    anchors = {}

    def shortened(match):
        signatures = re.split(r", (?=\w+\()", match[1])
        names = ", ".join(signature.split("(")[0] for signature in signatures)
        anchors[slug(match[1])] = slug(names)
        return f"### {names}\n\n```text\n" + "\n".join(signatures) + "\n```\n"

    return re.sub(r"^### (\w+\(.*)\n", shortened, text, flags=re.M), anchors


def with_terms(name, text):
    """A page with its index terms before the first paragraph, which the search then shows."""
    terms = ", ".join(f"! {term}" for term in TERMS.get(name, ()))
    begin = re.search(r"^\w", text, re.M).start()
    return f"{text[:begin]}```{{index}} {terms}\n```\n\n{text[begin:]}" if terms else text


def shrink(source, dest):
    """A picture as wide as a card, as JPEG."""
    reader, resize, writer = vtkPNGReader(), vtkImageResize(), vtkJPEGWriter()
    reader.SetFileName(str(source))
    reader.Update()
    columns, rows, _ = reader.GetOutput().GetDimensions()
    resize.SetInputConnection(reader.GetOutputPort())
    resize.SetOutputDimensions(CARD_WIDTH, max(1, CARD_WIDTH * rows // columns), 1)
    dest.parent.mkdir(parents=True, exist_ok=True)
    writer.SetFileName(str(dest))
    writer.SetInputConnection(resize.GetOutputPort())
    writer.SetQuality(90)
    writer.Write()


def lay_cards(dest):
    """The cards of the guide, the start page and the gallery, with small pictures."""

    def small(picture):
        card = pathlib.Path("cards", picture).with_suffix(".jpg").name
        if not (dest / "cards" / card).exists():
            shrink(dest / picture, dest / "cards" / card)
        return f"cards/{card}"

    def picture_of(page):
        text = (dest / f"{page}.md").read_text()
        found = re.search(r"!\[[^\]]*\]\((?:\.\./)*([^)]*)\)", text)
        picture = CARDS.get(page) or (found and found[1])
        if not picture:
            raise SystemExit(f"build.py: {page}.md begins with no picture, and CARDS has none")
        return picture if picture.endswith(".svg") else small(picture)

    def cards(match):
        caption, pages = re.search(r":caption: (.*)\n", match[0])[1], match[1].split()
        text = f"## {caption}\n\n::::{{grid}} 2 2 3 3\n:gutter: 3\n\n"
        for page in pages:
            title = re.match(r"# (.*)\n", (dest / f"{page}.md").read_text())[1].replace("`", "")
            text += (f":::{{grid-item-card}} {title}\n:link: {page}\n:link-type: doc\n"
                     f":img-top: {picture_of(page)}\n:img-alt: {title}\n:::\n")
        return text + "::::\n\n" + match[0].replace(":maxdepth: 1", ":hidden:")

    guide = (dest / "guide.md").read_text()
    made = re.sub(r"```\{toctree\}\n(?::.*\n)*((?:[\w/-]+\n)*)```", cards, guide)
    (dest / "guide.md").write_text(made)
    for page in ("index.md", "gallery.md"):
        text = (dest / page).read_text()
        text = re.sub(r"(?<=:img-top: )(.*\.png)", lambda found: small(found[1]), text)
        (dest / page).write_text(text)


def lay_pages(dest):
    shown, anchors = short_headings((ROOT / "docs/python.md").read_text())
    for page in sorted((ROOT / "docs").rglob("*.md")):
        name = page.relative_to(ROOT / "docs")
        if name.parts[0] == "site":
            continue
        text = shown if name.name == "python.md" else page.read_text()
        for old, new in anchors.items():
            text = text.replace(f"(#{old})" if name.name == "python.md" else f"python.md#{old})",
                                f"(#{new})" if name.name == "python.md" else f"python.md#{new})")
        text = with_terms(str(name.with_suffix("")), linked(text, len(name.parts) - 1))
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
    project = (ROOT / "CMakeLists.txt").read_text()
    (dest / "version").write_text(re.search(r"^project\(\w+ VERSION ([\d.]+)", project, re.M)[1])


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
    lay_cards(dest)


main()
