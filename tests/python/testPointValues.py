# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The stages' descriptions of values agree with every interface and every page."""

import inspect
import os
import pathlib
import re
import subprocess
import unittest

import relievo

DOCS = pathlib.Path(os.environ["RELIEVO_EXAMPLES"]).parent / "docs"


def stages():
    frame = relievo.vtkRelievoPass()
    found = [frame.GetStage(i) for i in range(frame.GetNumberOfStages())]
    return [each for each in found if each.IsA("vtkRelievoPointStage")]


def rows(page):
    """The rows of a page's tables, by the name in their first cell: name, meaning, default."""
    text = (DOCS / "passes" / page).read_text(encoding="utf-8")
    cells = [line.strip("| ").split(" | ") for line in text.splitlines() if line.startswith("|")]
    return {row[0].strip("`"): row[1:] for row in reversed(cells)}  # the first of a name counts


class Values(unittest.TestCase):
    def test_three_stages(self):
        self.assertEqual(
            sorted(each.GetStageName() for each in stages()), ["fog", "lamps", "markers"]
        )

    def test_pages(self):
        """Each value stands in the table of its page, with its default."""
        for stage in stages():
            points = stage.NewPoints()
            page = stage.GetStageName().capitalize() + ".md"
            table = rows(page)
            for i in range(points.GetNumberOfParameters()):
                name = points.GetParameterName(i)
                self.assertTrue(name in table, f"docs/passes/{page} has no row of `{name}`")
                self.assertEqual(table[name][-1], points.GetParameterDefault(name), name)

    def test_command(self):
        """Each value is in the help, and accepts Python's values."""
        page = subprocess.run(
            [os.environ["RELIEVO"], "--help"], stdout=subprocess.PIPE, text=True, check=True
        ).stdout
        for stage in stages():
            points = stage.NewPoints()
            option = re.search(
                rf"^  --{stage.GetStageName()} (?:.|\n)*?(?=^  --)", page, re.M
            ).group()
            names = re.findall(r"^ +(\w+)=", option, re.M)
            self.assertEqual(
                names,
                [points.GetParameterName(i) for i in range(points.GetNumberOfParameters())],
            )

    def test_python(self):
        """Each value is a keyword, behind the renderer and the points, before the stage's."""
        for stage in stages():
            points = stage.NewPoints()
            names = list(inspect.signature(getattr(relievo, stage.GetStageName())).parameters)
            of_points = [points.GetParameterName(i) for i in range(points.GetNumberOfParameters())]
            of_stage = [stage.GetParameterName(i) for i in range(stage.GetNumberOfParameters())]
            self.assertEqual(names, ["renderer", "points", *of_points, *of_stage])

    def test_words(self):
        """Numbers, choices and names of arrays are distinguished, and settings are kept."""
        lamps = relievo.vtkRelievoLamps()
        for name, words, said in (
            ("radius", "2.5", "2.5"),
            ("radius", "size", "size"),
            ("radius", "radius", "radius"),
            ("color", "1/0.5/0.25", "1,0.5,0.25"),
            ("color", "1,2,3", "1,2,3"),
            ("color", "tint", "tint"),
            ("casts", "always", "always"),
            ("casts", "if-large", "if-large"),
            ("casts", "wanted", "wanted"),
            ("falloff", "vtk", "vtk"),
            ("attenuation", "1/2/3", "1,2,3"),
        ):
            self.assertEqual(lamps.TrySetParameter(name, words), "", words)
            self.assertEqual(lamps.GetParameter(name), said)
        self.assertEqual(lamps.GetCasts(), lamps.CASTS_IF_LARGE)
        self.assertEqual(lamps.GetFalloff(), lamps.VTK)
        self.assertEqual(lamps.GetAttenuationValues(), (1, 2, 3))
        for name, words, says in (
            ("radius", "-1", "0 or more"),
            ("radius", "", "a number"),
            ("color", "1/2", "red,green,blue, each 0 or more"),
            ("falloff", "cubic", "one of linear"),
            ("attenuation", "a", "three numbers"),
            ("size", "1", "one of radius, intensity"),
        ):
            self.assertIn(says, lamps.TrySetParameter(name, words))
        self.assertEqual(lamps.GetFalloff(), lamps.VTK)
        markers = relievo.vtkRelievoMarkers()
        self.assertIn("a direction", markers.TrySetParameter("up", "0/0/0"))
        self.assertEqual(markers.GetParameter("up"), "0,1,0")


if __name__ == "__main__":
    unittest.main(verbosity=2)
