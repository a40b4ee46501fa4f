# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images with depth as labels, as a surface, as a volume and as a box; clouds of points."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

from cli import CliTest, main, read_png

STUDIO = {"RELIEVO_PRESET": ""}
SIZE = ["--size", "240x180"]
SMALL = ["--size", "120x90"]  # rays and samples take long
ONCE = ["--stage", "antialias:samples=1", "--soft-shadows", "1"]  # drawn once, not for each sample
SIDE = 40  # points of an image along each axis
SPACING = (0.5, 0.5, 0.25)
MIDDLE = numpy.array([0.5, 0.5, 0.25]) * (SIDE - 1) / 2
ALONG_Z = ["--camera", f"{MIDDLE[0]},{MIDDLE[1]},60,{MIDDLE[0]},{MIDDLE[1]},0,0,1,0",
           "--parallel-scale", "9"]  # fmt: skip
PIXEL = 2 * 9 / 180


def distances():
    """From the image's middle, in points: [z, y, x]."""
    z, y, x = numpy.mgrid[0:SIDE, 0:SIDE, 0:SIDE] - (SIDE - 1) / 2
    return numpy.sqrt(x**2 + y**2 + z**2)


class Volumes(CliTest):
    def image(self, name, values, of_cells=False, mirrored=None):
        """Stored in the opposite order along the axis `mirrored`, with that direction."""
        image = vtkImageData()
        image.SetDimensions(*(n + of_cells for n in values.shape[::-1]))
        image.SetSpacing(*SPACING)
        if of_cells:
            image.SetOrigin(*(-0.5 * step for step in SPACING))
        if mirrored is not None:
            image.GetDirectionMatrix().SetElement(mirrored, mirrored, -1)
            image.SetOrigin(*(2 * MIDDLE * (numpy.arange(3) == mirrored)))
            values = numpy.flip(values, 2 - mirrored)
        array = numpy_to_vtk(values.ravel(), deep=True)
        array.SetName("values")
        (image.GetCellData() if of_cells else image.GetPointData()).SetScalars(array)
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(str(self.folder / name))
        writer.SetInputData(image)
        writer.Write()

    def picture(self, *words, says="", environment=STUDIO, size=SMALL):
        if environment and "--shadows" not in words:
            words = (*words, "--shadow-size", "256")  # each sample has its own
        done = self.relievo("render", *words, *size, "--png", "a.png", environment=environment)
        self.assertIn(says, done.stderr)
        self.assertEqual(done.stderr == "", says == "", done.stderr)
        return read_png(self.folder / "a.png")[..., :3].astype(int)

    def radii(self, *words, layers=()):
        """Of the pixels that show something along z: how far it is from the image's middle in
        points, and more layers."""
        self.relievo("render", *words, *SIZE, *ALONG_Z, "--exr", "a.exr",
                     "--layers", ",".join(["depth", *layers]), environment=STUDIO)  # fmt: skip
        found = self.exr("a.exr")[1]
        shown = numpy.isfinite(found["depth.Z"])
        rows, columns = numpy.nonzero(shown)
        across = (columns + 0.5 - 120) * PIXEL
        down = (rows + 0.5 - 90) * PIXEL
        along = 60 - found["depth.Z"][shown] - MIDDLE[2]
        place = numpy.stack([across, down, along], axis=-1)
        return numpy.linalg.norm(place / SPACING, axis=-1), *(
            found[name + ".V"][shown] for name in layers)  # fmt: skip

    def test_left_handed_axes(self):
        """A volume looks the same however it is stored."""
        z, y, x = numpy.mgrid[0:SIDE, 0:SIDE, 0:SIDE]
        values = numpy.exp(-((x - 12) ** 2 + (y - 16) ** 2 + (z - 24) ** 2) / 60)

        def drawn(*words, **of):
            words = ("a.vti", "--image", "volume", *ALONG_Z, *words)
            return self.picture(*words, environment=None, **of)

        self.image("a.vti", values)
        plain = drawn()
        empty = drawn("--opacity-curve", "0/0,1/0", says="shows only the background")
        self.assertGreater((numpy.abs(plain - empty).max(axis=-1) > 20).sum(), 200)
        for axis in range(3):
            self.image("a.vti", values, mirrored=axis)
            self.assertLessEqual(numpy.abs(drawn() - plain).max(), 1, axis)

    def test_labels(self):
        """Two halves of a ball, with no gap between them, each in a colour of its own."""
        values = numpy.where(distances() < 15, 3, 0).astype(numpy.uint16)
        values[:, :, : SIDE // 2][values[:, :, : SIDE // 2] > 0] = 8
        self.image("points.vti", values)
        self.image("cells.vti", values, of_cells=True)
        says = "labels"
        plain = self.picture("points.vti", says=says)
        numpy.testing.assert_array_equal(self.picture("cells.vti", says=says), plain)
        numpy.testing.assert_array_equal(self.picture("points.vti", "--image", "labels"), plain)
        front = ["points.vti", "--image", "labels"]
        radii, labels = self.radii(*front, layers=["values"])
        self.assertEqual(set(labels), {3, 8})
        self.assertLess(abs((labels == 3).mean() - 0.5), 0.01)
        self.assertGreater(len(radii), 3000)
        # The steps of the labels are up to 0.9 points off the ball, and a gap would be deeper.
        self.assertLess(abs(radii - 15).max(), 1.0)
        self.assertLess(numpy.std(radii), 0.25)
        colors = self.picture(*front, *ALONG_Z, "--preset", "print", "--shadows", "off", size=SIZE)
        left, right = colors[90, 90], colors[90, 150]
        self.assertGreater(abs(left - right).max(), 40)

    def test_surface(self):
        self.image("ball.vti", distances().astype(numpy.float32))
        radii, _ = self.radii("ball.vti", "--image", "surface=12.5", layers=["values"])
        self.assertLess(abs(radii - 12.5).max(), 0.05)  # of the cells' linear interpolation
        self.assertGreater(len(radii), 2000)
        # Two values: any between them parts the image, and that in the middle is taken.
        parted = numpy.where(distances() < 12, 10.0, 30.0).astype(numpy.float32)
        self.image("parted.vti", parted)
        self.picture("parted.vti", says="are 20;")
        self.refused_value("ball.vti", "40")

    def refused_value(self, file, value):
        self.before = self.names()
        self.refused("render", file, "--image", "surface=" + value, "--png", "b.png", status=1,
                     says=["surface", value], environment=STUDIO)  # fmt: skip

    def test_volume(self):
        """Light passes where the values are small, and is stopped where they are large."""
        self.image("ball.vti", (20 - distances()).astype(numpy.float32))
        words = ["ball.vti", "--ground", "off", *ONCE]
        volume = self.picture(*words, "--image", "volume", says="antialias")
        box = self.picture(*words, "--image", "box", says="antialias")
        nothing = box[0, 0] * 0 + volume[:, :1]  # the background depends on the row alone
        seen = abs(volume - nothing).max(axis=-1) > 2
        boxed = abs(box - nothing).max(axis=-1) > 2
        self.assertFalse((seen & ~boxed).any())
        self.assertLess(seen.sum(), 0.75 * boxed.sum())
        self.assertGreater(seen.sum(), 0.1 * boxed.sum())
        grey = self.picture(*words, "--image", "volume", "--colormap", "grey", says="antialias")
        self.assertLess((grey.max(axis=-1) - grey.min(axis=-1))[seen].max(), 40)
        self.assertGreater((volume.max(axis=-1) - volume.min(axis=-1))[seen].max(), 80)

    def test_volume_on_the_ground(self):
        """In studio light a volume has a soft shadow on the ground, and no rings."""
        self.image("ball.vti", (20 - distances()).astype(numpy.float32))
        words = ["ball.vti", "--image", "volume", "--stage", "antialias:samples=1"]
        pictures = {}
        for name, more in (("usual", []), ("fine", ["--volume-step", "0.05"]),
                           ("coarse", ["--volume-step", "2"]),
                           ("bare", ["--shadows", "off"]),
                           *((kind, ["--volume-shadows", kind])
                             for kind in ("casts", "receives", "none")),
                           ("tinted", ["--colored-shadows", "--shadows", "map"])):  # fmt: skip
            pictures[name] = self.picture(*words, *more, says="antialias")
        darker = (pictures["bare"] - pictures["usual"]).mean(axis=-1)
        self.assertGreater((darker > 15).sum(), 150)
        self.assertGreater(((darker > 3) & (darker < 0.6 * darker.max())).sum(), 100)
        off = {name: abs(pictures[name] - pictures["fine"]).max() for name in ("usual", "coarse")}
        self.assertLess(off["usual"], 4)
        self.assertGreater(off["coarse"], 2 * off["usual"])
        # The shadow on the ground, below row 62, needs a caster, the volume's own also a receiver.
        self.assertEqual(abs(pictures["none"] - pictures["receives"]).max(), 0)
        ground = (pictures["none"] - pictures["casts"])[62:]
        self.assertGreater((ground.mean(axis=-1) > 15).sum(), 50)
        own = abs(pictures["usual"] - pictures["casts"]).max(axis=-1)
        self.assertLess(own[62:].max(), 2)
        self.assertGreater((own > 15).sum(), 500)

    def test_opacity_curve(self):
        """Values are visible where the curve says."""
        self.image("ball.vti", (20 - distances()).astype(numpy.float32))
        words = ["--image", "volume", *SMALL, *ALONG_Z, "--exr", "a.exr", "--layers",
                 "volume_value", "--stage", "volumes:rule=first"]  # fmt: skip
        least = {}
        for curve in ("11.9/0,12/0.5,20/0.5", "3.9/0,4/0.5,20/0.5"):
            self.relievo("render", "ball.vti", *words, "--opacity-curve", curve, environment=None)
            values = self.exr("a.exr")[1]["volume_value.V"]
            least[curve] = numpy.nanmin(values)
            self.assertAlmostEqual(least[curve], float(curve.split("/")[0]), delta=0.6)
        self.before = self.names()
        for curve in ("3/0", "3/0,2/1", "3/0,4/2", "3,4"):
            self.refused("render", "ball.vti", "--opacity-curve", curve, "--png", "b.png", status=2,
                         says=["--opacity-curve", "VALUE/OPACITY"])  # fmt: skip

    def test_volume_layers(self):
        """A volume has layers of its own, at the first sample that absorbs light."""
        self.image("ball.vti", (20 - distances()).astype(numpy.float32))
        layers = ["depth", "volume_depth", "volume_value", "volume_position"]
        self.relievo("render", "ball.vti", "--image", "volume", *SMALL, *ALONG_Z, "--exr", "a.exr",
                     "--layers", ",".join(layers), "--stage", "volumes:rule=first",
                     environment=None)  # fmt: skip
        found = self.exr("a.exr")[1]
        self.assertTrue(numpy.isinf(found["depth.Z"]).all())
        hit = numpy.isfinite(found["volume_depth.Z"])
        self.assertTrue(0.1 < hit.mean() < 0.9)
        values = found["volume_value.V"][hit]
        self.assertTrue(numpy.isnan(found["volume_value.V"][~hit]).all())
        self.assertLess(values.max() - values.min(), 3)
        place = numpy.stack([found[f"volume_position.{axis}"][hit] for axis in "XYZ"], -1)
        place[:, 2] -= MIDDLE[2]  # relative to the camera's focal point
        radii = numpy.linalg.norm(place / SPACING, axis=-1)
        self.assertLess(abs(radii - (20 - values)).max(), 0.05)

    def test_samples(self):
        """Of a volume, which takes long and has no edges, the preset draws fewer."""
        self.image("ball.vti", (20 - distances()).astype(numpy.float32))
        for kind, samples in (("volume", "4 of 4 samples"), ("surface", "41 samples in")):
            self.relievo("render", "ball.vti", "--image", kind, *SMALL, "--png", "a.png",
                         "--report", "a.json", environment=STUDIO)  # fmt: skip
            said = (self.folder / "a.json").read_text(encoding="utf-8")
            self.assertIn(samples, said)

    def test_volume_of_even_values(self):
        """It is about as bright as its surface, and opacity makes it see-through."""
        self.image("parted.vti", numpy.where(distances() < 12, 30, 0).astype(numpy.uint8))
        words = ["parted.vti", "--ground", "off", "--background", "black", *ONCE]
        white = ["--image", "volume", "--colormap", "white,white"]
        means = {}
        for name, more in (("surface", ["--image", "surface=15", "--color", "white"]),
                           ("full", white),
                           ("half", [*white, "--opacity", "0.5"]),
                           ("none", [*white, "--opacity", "0"])):  # fmt: skip
            means[name] = self.picture(*words, *more, says="antialias").mean()
        self.assertGreater(means["surface"], 20)
        # Visible samples lie in their own volume's shade, half of it for a dense one seen from
        # the light.
        self.assertGreater(means["full"], 0.4 * means["surface"])
        self.assertLess(means["full"], 1.3 * means["surface"])
        self.assertLess(means["half"], 0.9 * means["full"])
        self.assertGreater(means["half"], 0.1 * means["full"])
        self.assertEqual(means["none"], 0.0)

    def test_volume_of_labels(self):
        """Six regions that touch: each is seen, in the colour of its own value and in no other."""
        values = numpy.zeros((SIDE, SIDE, SIDE), numpy.uint8)
        colors = numpy.array([(1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 1, 1), (0, 0, 1), (1, 0, 1)])
        order = (2, 6, 1, 4, 3, 5)
        for place, label in enumerate(order):
            x, y = 8 + 8 * (place % 3), 8 + 12 * (place // 3)
            values[8:32, y : y + 12, x : x + 8] = label
        self.image("six.vti", values)
        hues = "red,#ffff00,#00ff00,#00ffff,#0000ff,#ff00ff"
        found = self.picture("six.vti", "--image", "volume", "--colormap", hues, "--range", "1,6",
                             *ALONG_Z, environment={}, size=SIZE)  # fmt: skip
        for place, label in enumerate(order):
            x, y = 8 + 8 * (place % 3), 8 + 12 * (place // 3)
            columns = slice(int(120 + 5 * (x + 1 - 19.5)), int(120 + 5 * (x + 6 - 19.5)))
            rows = slice(int(90 - 5 * (y + 10 - 19.5)), int(90 - 5 * (y + 1 - 19.5)))
            seen = found[rows, columns].reshape(-1, 3)
            has = colors[label - 1] == 1
            self.assertGreater(seen[:, has].min(), 100, label)
            self.assertLess(seen[:, ~has].max(), 0.2 * seen[:, has].min(), label)

    def test_which(self):
        """Gradients and noise are not detected as labels; explicit requests are respected."""
        random = numpy.random.default_rng(3)
        noise = random.integers(0, 255, (16, 16, 16)).astype(numpy.uint8)
        self.image("noise.vti", noise)
        self.picture("noise.vti", says="surface")
        self.image("slope.vti", (2 * distances()).astype(numpy.uint8))
        self.picture("slope.vti", says="surface")
        box = self.picture("slope.vti", "--image", "box")
        numpy.testing.assert_array_equal(self.picture("slope.vti", "--color-by", "values"), box)
        bare = self.picture("slope.vti", environment={})
        numpy.testing.assert_array_equal(
            self.picture("slope.vti", "--image", "box", environment={}), bare)  # fmt: skip
        self.image("flat.vti", noise[:1])
        self.picture("flat.vti")
        self.before = self.names()
        self.refused("render", "slope.vti", "--image", "mesh", "--png", "b.png", status=2,
                     says=["--image", "mesh", "labels"])  # fmt: skip

    def test_values_that_are_no_labels(self):
        """One value, which nothing parts, is a box; no numbers, outliers and too many labels."""
        one = numpy.full((SIDE, SIDE, SIDE), 5, numpy.float32)
        self.image("one.vti", one)
        numpy.testing.assert_array_equal(
            self.picture("one.vti"), self.picture("one.vti", "--image", "box"))  # fmt: skip
        self.image("zero.vti", numpy.zeros((SIDE, SIDE, SIDE), numpy.uint8))
        self.picture("zero.vti")
        values = (0.007 * distances() / distances().max()).astype(numpy.float32)
        values[0, 0, 0], values[9, 9, 9] = 1, numpy.nan
        self.image("outlier.vti", values)
        self.picture("outlier.vti", says="surface")
        labels = numpy.where(distances() < 15, 2, 0).astype(numpy.float32)
        labels[0, 0, :5] = numpy.nan
        self.image("floats.vti", labels)
        radii, values = self.radii("floats.vti", "--image", "labels", layers=["values"])
        self.assertEqual(set(values), {2})
        self.assertLess(abs(radii - 15).max(), 1.0)
        ids = numpy.arange(SIDE**3, dtype=numpy.int32).reshape(SIDE, SIDE, SIDE)
        self.image("ids.vti", ids)
        self.picture("ids.vti", says="surface")
        self.before = self.names()
        self.refused("render", "ids.vti", "--image", "labels", "--png", "b.png", status=1,
                     says=["labels", "2000"], environment=STUDIO)  # fmt: skip

    def test_grey_labels(self):
        """A grey image has 255 values in boxes as large as it: minutes, and gigabytes."""
        side = 80
        z, y, x = numpy.mgrid[0:side, 0:side, 0:side]
        self.image("grey.vti", (128 + 127 * numpy.sin(x / 9 + y / 7 + z / 5)).astype(numpy.uint8))
        self.before = self.names()
        self.refused("render", "grey.vti", "--image", "labels", "--png", "b.png", status=1,
                     says=["grey.vti: --image labels", "values that change", "--image surface"])
        # Regions may be as numerous, even if each is spread over the whole image.
        labels = 1 + (x // 8 * 10 + y // 8 + z // 40 * 100).astype(numpy.uint8)
        self.image("labels.vti", labels)
        self.relievo("render", "labels.vti", "--image", "labels", "--size", "9x9", "--png", "b.png")

    def test_images_of_colors(self):
        """They have no one value: --image says that it changes nothing, once."""
        colors = numpy.tile(numpy.uint8([200, 100, 50, 255]), (SIDE**3, 1))
        for components in (3, 4):
            image = vtkImageData()
            image.SetDimensions(SIDE, SIDE, SIDE)
            image.GetPointData().SetScalars(
                numpy_to_vtk(numpy.ascontiguousarray(colors[:, :components]), deep=True))
            writer = vtkXMLImageDataWriter()
            writer.SetFileName(str(self.folder / "colors.vti"))
            writer.SetInputData(image)
            writer.Write()
            for kind in ("volume", "surface", "surface=7", "labels"):
                self.picture("colors.vti", "--image", kind, environment={},
                             says="colors.vti: --image changed nothing")  # fmt: skip
            self.picture("colors.vti", "--image", "box", environment={})
        # Nor is one seen whose alpha is 0, but in other colours.
        image.GetPointData().GetScalars().FillComponent(3, 0)
        writer.Write()
        nothing = "a.png: shows only the ground"
        for words in ([], ["--color", "red"]):
            done = self.relievo("render", "colors.vti", *words, *SMALL, "--png", "a.png",
                                environment=STUDIO)  # fmt: skip
            self.assertEqual(nothing in done.stderr, not words, done.stderr)

    def test_cloud(self):
        """Points are seen on a light background, lit as balls; a wide flat cloud lies."""
        place = numpy.mgrid[-3:3:16j, -3:3:16j, -1:1:2j].reshape(3, -1).T
        points = vtkPoints()
        points.SetData(numpy_to_vtk(place.astype(numpy.float32), deep=True))
        cloud = vtkPolyData()
        cloud.SetPoints(points)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(self.folder / "cloud.vtp"))
        writer.SetInputData(cloud)
        writer.Write()
        words = ["cloud.vtp", "--ground", "off", "--stage", "antialias:samples=1"]
        shown = self.picture(*words, says="antialias", size=SIZE)
        numpy.testing.assert_array_equal(
            self.picture(*words, "--up", "z", says="antialias", size=SIZE), shown)  # fmt: skip
        differs = abs(shown - shown[:, :1]).max(axis=-1)
        self.assertGreater((differs > 40).sum(), 2000)  # of 512 points of 13 pixels, some hidden
        thin = self.picture(*words, "--point-size", "1", says="antialias", size=SIZE)
        self.assertLess((abs(thin - thin[:, :1]).max(axis=-1) > 40).sum(), 600)
        self.before = self.names()
        self.refused("render", "cloud.vtp", "--point-size", "0", "--png", "b.png", status=2,
                     says=["--point-size", "1 to 100"])  # fmt: skip


if __name__ == "__main__":
    main()
