# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values described by materials, environments and shadows agree with interfaces and pages."""

import inspect
import os
import pathlib
import re
import subprocess
import unittest

import relievo

DOCS = pathlib.Path(os.environ["RELIEVO_EXAMPLES"]).parent / "docs"
PAGES = {
    "materials.md": relievo.vtkRelievoMaterial(),
    "environment.md": relievo.vtkRelievoEnvironment(),
    "shadows.md": relievo.vtkRelievoPass().GetStage("shadows"),
}
# Values with their own option.
BY_OPTIONS = ("height_scale", "relief_method", "reflectivity", "roughness", "rotation", "up")


def names(owner):
    return [owner.GetParameterName(i) for i in range(owner.GetNumberOfParameters())]


def rows(page):
    """The rows of the page's table of values: name, default."""
    text = (DOCS / page).read_text(encoding="utf-8")
    table = text.split("| value | meaning | default |\n|---|---|---|\n", 1)[1].split("\n\n")[0]
    cells = [line.strip("| ").split(" | ") for line in table.splitlines()]
    return {row[0].strip("`"): row[-1] for row in cells}


class Values(unittest.TestCase):
    def test_pages(self):
        """The table of the page has every value, in order, with its default, and no other."""
        for page, owner in PAGES.items():
            defaults = {name: owner.GetParameterDefault(name) for name in names(owner)}
            self.assertEqual(rows(page), defaults, page)
            self.assertEqual(list(rows(page)), list(defaults), page)

    def test_command(self):
        """The help of --material and of --environment has every value without an own option."""
        page = subprocess.run(
            [os.environ["RELIEVO"], "--help"], stdout=subprocess.PIPE, text=True, check=True
        ).stdout
        for option, owner in (
            ("material", relievo.vtkRelievoMaterial()),
            ("environment", relievo.vtkRelievoEnvironment()),
        ):
            text = re.search(rf"^  --{option} (?:.|\n)*?(?=^  --)", page, re.M).group()
            self.assertEqual(
                re.findall(r"^ +(\w+)=", text, re.M),
                [name for name in names(owner) if name not in BY_OPTIONS],
            )

    def test_python(self):
        """environment() has the values of environments, and those of materials for mirrors."""
        material = relievo.vtkRelievoMaterial()
        mirrors = [
            name for name in names(material)
            if material.GetParameterCondition(name) == "environment"
        ]  # fmt: skip
        self.assertIn("reflectivity", mirrors)
        keywords = list(inspect.signature(relievo.environment).parameters)
        self.assertEqual(
            keywords,
            ["renderer", "path", *names(relievo.vtkRelievoEnvironment()), *mirrors, "sky",
             "tone"],
        )
        for name in keywords:
            self.assertRegex(relievo.environment.__doc__, rf"\b{name}: ", name)

    def test_words(self):
        """Texts are accepted, returned, and equal to the class's own methods; or refused with a
        reason."""
        material = relievo.vtkRelievoMaterial()
        for name, words, said in (
            ("normal_strength", "-2.5", "-2.5"),
            ("relief_method", "steep", "steep"),
            ("height_range", "1/3", "1,3"),
            ("minimum_steps", "12", "12"),
            ("repeat", "off", "off"),
        ):
            self.assertTrue(material.SetParameter(name, words))
            self.assertEqual(material.GetParameter(name), said)
        self.assertEqual(
            (material.GetNormalStrength(), material.GetReliefMethod(), material.GetHeightRange(),
             material.GetMinimumSteps(), material.GetRepeat()),
            (-2.5, material.METHOD_STEEP, (1.0, 3.0), 12, False),
        )  # fmt: skip
        for name, words, says in (
            ("roughness", "1.5", "'1.5' was given, expected a number from 0 to 1"),
            ("height_range", "1", "two numbers"),
            ("height_scale", "-1", "0 or more"),
            ("minimum_steps", "1.5", "a whole number from 1 to 4096"),
            ("gloss", "1", "expected one of normal_strength, "),
        ):
            self.assertIn(says, material.TrySetParameter(name, words))
        self.assertEqual(material.GetParameter("roughness"), "0")
        environment = relievo.vtkRelievoEnvironment()
        self.assertTrue(environment.SetParameter("up", "z"))
        self.assertEqual(environment.GetUpAxis(), 2)
        self.assertIn("one of x, y, z", environment.TrySetParameter("up", "w"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
