# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""--lamps: the light of each point, in the layer `light`, compared with the formula."""

import json

import numpy

from cli import CliTest, main, read_png
from srgb import encoded

# A floor of half width 2 at z = 0; a parallel camera looks down on it, 25 pixels to a unit.
FLOOR = "OFF\n4 1 0\n-2 -2 0\n2 -2 0\n2 2 0\n-2 2 0\n4 0 1 2 3\n"
SIDE = 100
LOOK = ["--camera", "0,0,5,0,0,0,0,1,0", "--clip", "1,10", "--parallel-scale", "2",
        "--size", f"{SIDE}x{SIDE}", "--shading", "flat"]  # fmt: skip

# FLOOR with a plate of half width 0.3 above it, at z = 0.3.
PLATE = ("OFF\n8 2 0\n-2 -2 0\n2 -2 0\n2 2 0\n-2 2 0\n-.3 -.3 .3\n.3 -.3 .3\n.3 .3 .3\n"
         "-.3 .3 .3\n4 0 1 2 3\n4 4 5 6 7\n")  # fmt: skip

PLACES = numpy.array([[0.0, 0.0, 0.5], [1.0, -0.7, 0.3], [-1.2, 1.1, 1.0]])
RADII = numpy.array([1.5, 0.8, 1.2])
COLOURS = numpy.array([[1.0, 0.5, 0.0], [0.2, 0.4, 1.0], [1.0, 1.0, 1.0]])


def vtk_file(places, **arrays):
    """A legacy VTK file of points with arrays of one or three components."""
    lines = ["# vtk DataFile Version 3.0", "lamps", "ASCII", "DATASET POLYDATA",
             f"POINTS {len(places)} double"]  # fmt: skip
    lines += [" ".join(map(repr, map(float, place))) for place in places]
    if arrays:
        lines += [f"POINT_DATA {len(places)}", f"FIELD arrays {len(arrays)}"]
    for name, values in arrays.items():
        table = numpy.asarray(values, float).reshape(len(places), -1)
        lines.append(f"{name} {table.shape[1]} {len(table)} double")
        lines += [" ".join(map(repr, map(float, row))) for row in table]
    return "\n".join(lines) + "\n"


def light(radii, colours, share):
    """The light of these lamps on the floor: share(distance / radius, distance) for each."""
    rows, columns = numpy.mgrid[0:SIDE, 0:SIDE] + 0.5
    x, y = (columns - SIDE / 2) / 25, (SIDE / 2 - rows) / 25
    total = numpy.zeros((SIDE, SIDE, 3))
    for place, radius, colour in zip(PLACES, radii, colours):
        d = numpy.sqrt((x - place[0]) ** 2 + (y - place[1]) ** 2 + place[2] ** 2)
        reached = numpy.where(d < radius, share(numpy.minimum(d / radius, 1.0), d), 0.0)
        total += (reached * place[2] / d)[..., None] * colour
    return total


def linear(part, _):
    return 1.0 - part


class Lamps(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "floor.off").write_text(FLOOR)
        (self.folder / "lamps.vtk").write_text(vtk_file(PLACES, radius=RADII, color=COLOURS))
        (self.folder / "bare.vtk").write_text(vtk_file(PLACES, size=RADII))
        self.before = self.names()

    def draw(self, *words, **more):
        return self.relievo("render", "floor.off", *LOOK, *words, **more)

    def check(self, lamps, expected):
        self.draw("--lamps", lamps, "--layers", "light", "--exr", "a.exr")
        _, channels = self.exr("a.exr")
        seen = numpy.stack([channels[f"light.{c}"] for c in "RGB"], axis=-1)
        numpy.testing.assert_allclose(seen, expected, rtol=2e-5, atol=2e-5)

    def test_values(self):
        """Arrays of the file, numbers for all, arrays by other names, each fall-off."""
        white = numpy.ones((3, 3))
        self.check("lamps.vtk", light(RADII, COLOURS, linear))
        self.check("lamps.vtk,intensity=2.5", 2.5 * light(RADII, COLOURS, linear))
        self.check("lamps.vtk,radius=1.25,color=1/1/1", light([1.25] * 3, white, linear))
        self.check("bare.vtk,radius=size", light(RADII, white, linear))
        self.check("bare.vtk,radius=2", light([2] * 3, white, linear))
        self.check(
            "bare.vtk,radius=size,falloff=inverse-square",
            light(RADII, white, lambda part, d: (1 - part**4) ** 2 / d**2))
        self.check(
            "bare.vtk,radius=size,falloff=vtk,attenuation=0.5/1/2,color=0/1/0.5",
            light(RADII, [[0, 1, 0.5]] * 3, lambda _, d: 1 / (0.5 + d + 2 * d**2)))

    def test_several(self):
        """Two files add up; without lamps the layer is 0, as it is beside the mesh."""
        self.draw("--lamps", "lamps.vtk", "--lamps", "bare.vtk,radius=1", "--layers", "light",
                  "--exr", "a.exr")
        _, channels = self.exr("a.exr")
        both = light(RADII, COLOURS, linear) + light([1] * 3, numpy.ones((3, 3)), linear)
        numpy.testing.assert_allclose(channels["light.G"], both[..., 1], rtol=2e-5, atol=2e-5)
        self.draw("--layers", "light", "--exr", "none.exr")
        self.assertFalse(self.exr("none.exr")[1]["light.R"].any())

    def test_picture_and_report(self):
        """The picture is lit; the report gives the number of lamps and the method."""
        self.draw("--light", "sun:0,0,-1", "--lamps", "bare.vtk,radius=size", "--png", "a.png",
                  "--report", "a.json", "--stage", "lamps:way=clusters")
        seen = read_png(self.folder / "a.png")[..., 0] / 255.0
        sum_of_light = light(RADII, numpy.ones((3, 3)), linear)[..., 0]
        shown = numpy.minimum(encoded(sum_of_light), 1)
        numpy.testing.assert_allclose(seen, shown, atol=1.01 / 255)
        report = json.loads((self.folder / "a.json").read_text())
        self.assertEqual((report["lamps"], report["lamps_drawn"]), (3, 3))
        self.assertEqual(report["lamps_way"], "clusters")

    def test_shadows(self):
        """A plate's shadow where the lamp's rays say, by each word; none without."""
        (self.folder / "plate.off").write_text(PLATE)
        place = numpy.array([0.8, 0.0, 1.0])
        (self.folder / "one.vtk").write_text(vtk_file([place], radius=[3.0], lit=[1.0]))
        rows, columns = numpy.mgrid[0:SIDE, 0:SIDE] + 0.5
        x, y = (columns - SIDE / 2) / 25, (SIDE / 2 - rows) / 25
        # Where the ray from the floor to the lamp passes the plate's plane.
        off = numpy.maximum(abs(x + 0.3 * (place[0] - x)), abs(y + 0.3 * (place[1] - y)))
        plate = numpy.maximum(abs(x), abs(y)) < 0.35
        d = numpy.sqrt((x - place[0]) ** 2 + (y - place[1]) ** 2 + place[2] ** 2)
        free = numpy.maximum(1 - d / 3.0, 0) * place[2] / d
        dark, lit = (off < 0.27) & ~plate, (off > 0.33) & ~plate
        self.assertGreater(dark.sum(), 100)
        for words, casts in (("", False), (",casting=1", True), (",casts=always", True),
                             (",casts=lit", True), (",casting=8,casts=never", False)):  # fmt: skip
            self.relievo("render", "plate.off", *LOOK, "--lamps", "one.vtk" + words, "--layers",
                         "light", "--exr", "a.exr", "--report", "a.json")  # fmt: skip
            seen = self.exr("a.exr")[1]["light.R"]
            numpy.testing.assert_allclose(seen[lit], free[lit], rtol=2e-5, atol=2e-5)
            numpy.testing.assert_allclose(seen[dark], 0 if casts else free[dark], rtol=2e-5)
            report = json.loads((self.folder / "a.json").read_text())
            self.assertEqual(report["lamps_casting"], int(casts), words)
            self.assertEqual(report["lamp_maps"] > 0, casts)

    def test_deferred(self):
        """--deferred: the same picture within a level, shadows and lamps included."""
        words = ("--light", "point:1,2,3", "--shadows", "map", "--lamps", "bare.vtk,casting=2",
                 "--report", "a.json", "--png")  # fmt: skip
        self.draw(*words, "a.png")
        report = json.loads((self.folder / "a.json").read_text())
        self.assertEqual(report["deferred_draws"], 0)
        self.draw(*words, "b.png", "--deferred")
        report = json.loads((self.folder / "a.json").read_text())
        self.assertEqual((report["deferred_draws"], report["forward_draws"]), (1, 0))
        first, second = (read_png(self.folder / name).astype(int) for name in ("a.png", "b.png"))
        self.assertGreater(first.max(), 100)
        self.assertLessEqual(abs(first - second).max(), 1)

    def test_refusals(self):
        """Words, files and arrays that do not fit, each by name."""
        picture = ("--png", "a.png")
        for word, says in {
            ",radius=1": "--lamps",
            "lamps.vtk,size=1": ["size", "radius"],
            "lamps.vtk,radius": ["--lamps", "NAME=VALUE"],
            "lamps.vtk,radius=1,radius=2": "each once",
            "lamps.vtk,radius=-1": ["--lamps radius", "-1", "0 or more"],
            "lamps.vtk,radius=": ["--lamps radius", "a number", "or the name of a point array"],
            "lamps.vtk,color=1/2": ["--lamps color", "red,green,blue"],
            "lamps.vtk,falloff=cubic": ["--lamps falloff", "cubic", "inverse-square"],
            "lamps.vtk,attenuation=1/0/0": "falloff=vtk",
            "lamps.vtk,casting=9": ["--lamps casting", "9", "0 to 8"],
            "lamps.vtk,casts=": ["--lamps casts", "never, always"],
            "lamps.png": ["lamps.png", "extension"],
            "town.gltf": ["town.gltf", "scene"],
            "bare.vtk,radius=width": ["--lamps bare.vtk,radius", "'width'", "array of the file"],
            "bare.vtk,casts=walls": ["--lamps bare.vtk,casts", "'walls'", "array of the file"],
        }.items():
            self.refused("render", "floor.off", "--lamps", word, *picture, status=2, says=says)
        for word, says in {
            "none.vtk": ["none.vtk", "No such file"],
            "lamps.vtk,radius=color": ["lamps.vtk", "'color'", "has 3 components"],
            "bare.vtk,radius=0": ["bare.vtk", "no points that are lamps"],
        }.items():
            self.refused("render", "floor.off", "--lamps", word, *picture, status=1, says=says)


if __name__ == "__main__":
    main()
