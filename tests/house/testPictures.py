# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every picture of docs/pictures is shown by a page, and made by an example, by tools/screenshots,
or by a command on a page that shows it. (testCharts checks docs/charts.)"""

import os
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).parents[2]

# Pictures with another name than the file that their example writes.
WRITTEN_AS = {
    "datasets": "28_training_pictures.py: train.png",
    "layers": "demo.py: demo_layers.png",
    "lines-hidden": "29_technical_drawing.py: drawing.png",
    "paraview-bike": "08_paraview_tour.py: paraview_bike.png",
    "paraview-day": "08_paraview_tour.py: paraview_day.png",
    "paraview-hall": "17_paraview_hall.py: paraview_hall.png",
    "paraview-materials": "11_paraview_materials.py: paraview_materials.png",
    "paraview-town": "08_paraview_tour.py: paraview_town.png",
    "rays": "26_wall_thickness.py: thickness.png",
    "relief": "10_relief_terrain.py: relief_terrain.png",
    "shadows": "07_three_spots.py: three_spots.png",
    "sun-hours": "06_sun_study.py: sun_hours.png",
    "town-lamps": "12_town_at_night.py: town.png",
}

BLOCK = re.compile(r"^```[^\n]*\n.*?^```|(?:^    [^\n]*\n)+", re.MULTILINE | re.DOTALL)


def has(text, name):
    return re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", text) is not None


def find_faults(root):
    examples = {path.name: path.read_text(encoding="utf-8")
                for path in (root / "examples").glob("*.py")}
    screenshots = (root / "tools/screenshots").read_text(encoding="utf-8")
    pages = [path.read_text(encoding="utf-8")
             for path in [root / "README.md", *(root / "docs").rglob("*.md")]]
    names = {path.stem for path in (root / "docs/pictures").iterdir()}
    for name in sorted(names):
        showing = [page for page in pages if has(page, f"pictures/{name}.png")]
        if not showing:
            yield f"{name}: no page shows it"
        if name in WRITTEN_AS:
            example, file = WRITTEN_AS[name].split(": ")
            made = has(examples.get(example, ""), file)
        else:
            made = (any(has(text, f"{name}.png") for text in examples.values())
                    or f'"{name}"' in screenshots
                    or any(has(block, f"{name}.png") for page in showing
                           for block in BLOCK.findall(page)))
        if not made:
            yield f"{name}: no example, screenshot or command beside it writes a file of its name"
    for name in sorted(set(WRITTEN_AS) - names):
        yield f"{name}: is no picture of docs/pictures; remove its line in this test"


def main():
    faults = list(find_faults(ROOT))
    print("\n".join(faults) or "every picture has a tool that makes it")
    # A picture that neither a page shows nor a tool makes is found.
    tree = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"]) / "tree"
    shutil.rmtree(tree, ignore_errors=True)
    for folder in ("docs/pictures", "examples", "tools"):
        (tree / folder).mkdir(parents=True)
    (tree / "README.md").write_text(
        "![a](docs/pictures/a.png)\n![b](docs/pictures/b.png)\n"
        "```\nrelievo render --png a.png\n```\n")
    (tree / "tools/screenshots").touch()
    for name in "abc":
        (tree / f"docs/pictures/{name}.png").touch()
    found = [fault.split(":")[0] for fault in find_faults(tree)]
    expected = ["b", "c", "c", *sorted(WRITTEN_AS)]
    if found != expected:
        print(f"a tree with faults of {expected}: faults of {found}")
        return 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
