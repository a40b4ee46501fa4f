# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data sets through lenses and of other sensors, against the formulas of Brown and Conrady and of
fisheyes in numpy, and rays through every triangle; BOP's models; flow between views."""

import json
import pathlib
import tempfile
import unittest

import numpy
from testDatasets import (
    K,
    SIZE,
    add,
    bop_inout,
    box_of,
    follow,
    heap,
    plate,
    read_json,
    read_png,
    runs,
    sphere,
    triangles,
    vtkCompositeMapper,
)
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCamera,
    vtkCompositeDataDisplayAttributes,
    vtkGlyph3DMapper,
    vtkRenderer,
)

import relievo

if bop_inout:
    from bop_toolkit_lib import misc as bop_misc

BROWN = [0.06, 0.02, 0.004, -0.006, 0.01]
RATIONAL = [-0.2, 0.03, 0.002, 0.001, 0.004, 0.05, 0.01, 0.002]
FISHEYE = [0.03, -0.01, 0.004, 0.001]
PLACE = (0.5, 1.0, 3.2), (0, -0.1, 0)


def brown(local, coefficients):
    """The pixels of places (..., 3) in camera space, by the formula of 1971 as OpenCV writes it."""
    k1, k2, p1, p2, k3, k4, k5, k6 = [*coefficients, 0, 0, 0][:8]
    x, y = local[..., 0] / local[..., 2], local[..., 1] / local[..., 2]
    r = x * x + y * y
    radial = (1 + r * (k1 + r * (k2 + r * k3))) / (1 + r * (k4 + r * (k5 + r * k6)))
    a = x * radial + 2 * p1 * x * y + p2 * (r + 2 * x * x)
    b = y * radial + p1 * (r + 2 * y * y) + 2 * p2 * x * y
    return numpy.stack([K[0, 0] * a + K[0, 2], K[1, 1] * b + K[1, 2]], -1)


def fisheye(local, k):
    """The pixels of places in camera space, by the formula of 2006."""
    across = numpy.hypot(local[..., 0], local[..., 1])
    t = numpy.arctan2(across, local[..., 2])
    bent = t * (1 + k[0] * t**2 + k[1] * t**4 + k[2] * t**6 + k[3] * t**8)
    share = bent / numpy.where(across > 0, across, 1)
    return numpy.stack([K[0, 0] * share * local[..., 0] + K[0, 2],
                        K[1, 1] * share * local[..., 1] + K[1, 2]], -1)  # fmt: skip


def unit(angles, turns):
    return numpy.stack([numpy.sin(angles) * numpy.cos(turns),
                        numpy.sin(angles) * numpy.sin(turns), numpy.cos(angles)], -1)  # fmt: skip


def straighten(lens, coefficients, pixels):
    """The rays of pixels, of length 1, by Newton's method with differences of the formula."""
    state = (pixels - K[:2, 2]) / (K[0, 0], K[1, 1])

    def get_rays(state):
        length = numpy.hypot(state[..., 0], state[..., 1])
        angle = length if lens is fisheye else numpy.arctan(length)
        return unit(angle, numpy.arctan2(state[..., 1], state[..., 0]))

    def find(state):
        return lens(get_rays(state), coefficients)

    step = 1e-6
    for _ in range(30):
        errors = find(state) - pixels
        slopes = numpy.stack([(find(state + offset) - find(state - offset)) / (2 * step)
                              for offset in ((step, 0), (0, step))], -1)  # fmt: skip
        state -= numpy.linalg.solve(slopes, errors[..., None])[..., 0]
    assert numpy.abs(find(state) - pixels).max() < 1e-9
    return get_rays(state)


class Truth:
    """The true view of actors through a lens, also so many pixels beyond each edge of the picture.
    """

    def __init__(self, camera, lens, coefficients, actors, beyond=0):
        columns, rows = SIZE
        pixels = numpy.stack(numpy.meshgrid(
            numpy.arange(-beyond * columns, (1 + beyond) * columns),
            numpy.arange(-beyond * rows, (1 + beyond) * rows)), -1)  # fmt: skip
        local = straighten(lens, coefficients, pixels.astype(float))
        found = [follow(camera, local, triangles(actor)) for actor in actors]
        self.away = numpy.array([each[0] for each in found])
        self.sure = ~numpy.any([each[1] for each in found], axis=0)
        self.seen = numpy.isfinite(self.away).any(axis=0)
        self.object = numpy.where(self.seen, self.away.argmin(axis=0), -1)
        self.depth = numpy.where(self.seen, self.away.min(axis=0), numpy.nan) * local[..., 2]


def inner(mask):
    """Pixels farther than two pixels from the edge."""
    for _ in range(2):
        padded = numpy.pad(mask, 1)
        mask = mask & padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] & padded[1:-1, 2:]
    return mask


def read_ply(path):
    """Points and triangles of a binary PLY, by its header."""
    header, body = path.read_bytes().split(b"end_header\n", 1)
    lines = header.decode().splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"]
    counts = [int(line.split()[2]) for line in lines if line.startswith("element")]
    assert [line for line in lines if line.startswith("property")] == [
        *(f"property double {axis}" for axis in "xyz"), "property list uchar int vertex_indices"
    ]  # fmt: skip
    points = numpy.frombuffer(body, "<f8", 3 * counts[0]).reshape(-1, 3)
    faces = numpy.frombuffer(body[24 * counts[0] :], [("n", "u1"), ("ids", "<i4", 3)])
    assert len(faces) == counts[1] and (faces["n"] == 3).all()
    return points, faces["ids"]


class SensorDatasets(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def lenses(self):
        for lens, coefficients, camera in (
            (brown, BROWN, relievo.Pinhole(K, SIZE, distortion=BROWN)),
            (brown, RATIONAL, relievo.Pinhole(K, SIZE, distortion=RATIONAL)),
            (fisheye, FISHEYE, relievo.Fisheye(K, SIZE, FISHEYE)),
        ):
            with self.subTest(lens=lens.__name__, coefficients=coefficients):
                yield lens, coefficients, camera.look_at(*PLACE)

    def test_lenses(self):
        """Masks, depth and boxes by hand; positions on their pixels; the picture shows the same."""
        renderer = heap()
        actors = list(renderer.GetActors())
        colors = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0)]
        for actor, color in zip(actors, colors):
            actor.GetProperty().LightingOff()
            actor.GetProperty().SetColor(color)
        for number, (lens, coefficients, camera) in enumerate(self.lenses()):
            folder = self.folder / str(number)
            relievo.write_dataset(renderer, camera, folder, "npz", ["position"])
            found = numpy.load(folder / "000000.npz")
            numpy.testing.assert_allclose(
                found["distortion"][: len(coefficients)], coefficients, rtol=1e-15
            )
            self.assertEqual(found["lens"], "fisheye" if lens is fisheye else "Brown-Conrady")
            truth = Truth(camera, lens, coefficients, actors)
            self.assertGreater(truth.sure.mean(), 0.95)
            sure = truth.sure
            numpy.testing.assert_array_equal((found["object"] - 1)[sure], truth.object[sure])
            for i in range(4):
                visible, whole = found["visible_masks"][i], found["amodal_masks"][i]
                numpy.testing.assert_array_equal(visible[sure], (truth.object == i)[sure])
                numpy.testing.assert_array_equal(whole[sure], numpy.isfinite(truth.away[i])[sure])
                self.assertFalse((visible & ~whole).any())
                self.assertEqual(found["visible_boxes"][i].tolist(), box_of(visible))
                self.assertEqual(found["amodal_boxes"][i].tolist(), box_of(whole))
                shown = found["color"][inner(visible)].astype(int)
                self.assertEqual(len(shown) > 100, i < 3)  # the last one is in the ball
                if len(shown):
                    errors = numpy.abs(shown - 255 * numpy.array(colors[i]))
                    self.assertLessEqual(errors.max(), 1)
            seen = sure & truth.seen
            errors = numpy.abs(found["depth"][seen] / truth.depth[seen] - 1)
            self.assertLess(errors.max(), 1e-6)
            rows, columns = numpy.nonzero(found["object"])
            local = found["position"][rows, columns] @ camera.R.T + camera.t
            places = lens(local, coefficients)
            self.assertLess(numpy.abs(places - numpy.stack([columns, rows], -1)).max(), 1e-3)

    def test_bop(self):
        """The lens is stored beside K; parts beyond the picture count through the lens."""
        renderer = heap()
        actors = list(renderer.GetActors())
        for number, (lens, coefficients, camera) in enumerate(self.lenses()):
            if coefficients is RATIONAL:
                continue  # its rays end before thrice the picture
            camera.look_at((0.2, 0.4, 1.9), (0, -0.1, 0))
            folder = self.folder / str(number)
            relievo.write_dataset(renderer, camera, folder)
            about = read_json(folder / "scene_camera.json")["0"]
            numpy.testing.assert_allclose(about["cam_K"], K.ravel(), rtol=1e-15)
            numpy.testing.assert_allclose(
                about["distortion"][: len(coefficients)], coefficients, rtol=1e-15
            )
            self.assertEqual(about["lens"], "fisheye" if lens is fisheye else "Brown-Conrady")
            if bop_inout:
                theirs = bop_inout.load_scene_camera(folder / "scene_camera.json")[0]
                numpy.testing.assert_allclose(theirs["cam_K"], K, rtol=1e-15)
            truth = Truth(camera, lens, coefficients, actors, 1)
            middle = numpy.s_[SIZE[1] : 2 * SIZE[1], SIZE[0] : 2 * SIZE[0]]
            depth = read_png(folder / "depth" / "000000.png")
            seen = truth.sure[middle] & truth.seen[middle]
            errors = depth[seen] * about["depth_scale"] / 1000 - truth.depth[middle][seen]
            self.assertLessEqual(numpy.abs(errors).max(), 0.51 * about["depth_scale"] / 1000)
            infos = read_json(folder / "scene_gt_info.json")["0"]
            for i, info in enumerate(infos):
                mask = read_png(folder / "mask" / f"000000_{i:06d}.png") > 0
                every = numpy.isfinite(truth.away[i])
                unsure = (~truth.sure).sum()
                self.assertLessEqual(
                    numpy.count_nonzero(mask != every[middle]), (~truth.sure[middle]).sum()
                )
                self.assertLessEqual(abs(info["px_count_all"] - every.sum()), unsure)
                around = numpy.array(box_of(every)) - [*SIZE, 0, 0]
                numpy.testing.assert_allclose(info["bbox_obj"], around, atol=1)
            self.assertGreater(infos[0]["px_count_all"], 1.2 * SIZE[0] * SIZE[1] / 2)
            picture = read_png(folder / "rgb" / "000000.png")
            self.assertEqual(picture.shape, (SIZE[1], SIZE[0], 3))

    def test_nerf(self):
        """By the numbers of the file a corner falls where it is seen; and it is a file of poses."""
        renderer = heap()
        corner = numpy.array([0.3, -0.8, 0.4, 1])
        for number, (lens, coefficients, camera) in enumerate(self.lenses()):
            folder = self.folder / str(number)
            if coefficients is RATIONAL:
                with self.assertRaisesRegex(ValueError, "view 0: the lens has k4, which transf"):
                    relievo.write_dataset(renderer, camera, folder, "nerf")
                continue
            relievo.write_dataset(renderer, camera, folder, "nerf")
            index = read_json(folder / "transforms.json")
            self.assertEqual(index["camera_model"],
                             "OPENCV_FISHEYE" if lens is fisheye else "OPENCV")  # fmt: skip
            self.assertIs(index["is_fisheye"], lens is fisheye)
            order = ["k1", "k2", "k3", "k4"] if lens is fisheye else ["k1", "k2", "p1", "p2", "k3"]
            said = [index[name] for name in order]
            numpy.testing.assert_allclose(said, coefficients, rtol=1e-15)
            x, y, z, _ = numpy.linalg.inv(index["frames"][0]["transform_matrix"]) @ corner
            place = lens(numpy.array([x, -y, -z]), said)
            expected = lens(camera.R @ corner[:3] + camera.t, coefficients)
            numpy.testing.assert_allclose(place, expected, atol=1e-9)
            self.assertAlmostEqual(index["cx"], K[0, 2] + 0.5)
            again = self.folder / f"{number} again"
            relievo.write_dataset(renderer, folder / "transforms.json", again, "nerf")
            one, two = (read_json(each / "views" / "000000.json")["camera"]
                        for each in (folder, again))  # fmt: skip
            self.assertEqual(one["lens"], two["lens"])
            for name in ("K", "R", "t", "distortion"):
                numpy.testing.assert_allclose(one[name], two[name], atol=1e-12)
            with self.assertRaisesRegex(ValueError, "pose 0: has a lens, and the given camera"):
                relievo.write_dataset(renderer, folder / "transforms.json", self.folder / "x",
                                      "nerf", lens="division:-0.1")  # fmt: skip

    def test_sensors_without_k(self):
        renderer = heap()
        panorama = relievo.Equirectangular((120, 60)).look_at(*PLACE)
        for name, sensor in (
            ("equirectangular", panorama),
            ("cube", relievo.Cube(30).look_at(*PLACE)),
            ("orthographic", relievo.Orthographic(20, SIZE).look_at(*PLACE)),
        ):
            with self.subTest(name):
                relievo.write_dataset(renderer, sensor, self.folder / name, "coco")
                index = read_json(self.folder / name / "instances.json")
                layers = relievo.capture(renderer, ["depth", "actor"], camera=sensor)
                actor, depth = (relievo.layer(layers, each) for each in ("actor", "depth"))
                picture = read_png(self.folder / name / "images" / "000000.png")
                self.assertEqual(picture.shape, (*actor.shape, 3))
                steps = read_png(self.folder / name / "depth" / "000000.png")
                step = index["info"]["depth_step"]
                there = numpy.isfinite(depth)
                self.assertLessEqual(numpy.abs(steps * step - depth)[there].max(), 0.51 * step)
                self.assertEqual(steps[~there].max(initial=0), 0)
                for each in index["annotations"]:
                    size = tuple(each["segmentation"]["size"])
                    mask = runs(each["segmentation"]["counts"], size)
                    numpy.testing.assert_array_equal(mask, actor == each["category_id"] - 1)
                for format in ("bop", "nerf"):
                    with self.assertRaisesRegex(ValueError, f"view 0: got the sensor {name}, which "
                                                            "has no K; expected the format coco"):
                        relievo.write_dataset(renderer, sensor, self.folder / "x", format)
        camera = vtkCamera()
        camera.SetParallelProjection(True)
        camera.SetParallelScale(0.5 * SIZE[1] / 20)
        camera.SetPosition(PLACE[0])
        camera.SetFocalPoint(PLACE[1])
        relievo.write_dataset(renderer, camera, self.folder / "vtk", "coco", size=SIZE)
        names = ("vtk", "orthographic")
        masks = [read_json(self.folder / each / "instances.json")["annotations"] for each in names]
        self.assertEqual(*masks)
        relievo.write_dataset(renderer, panorama, self.folder / "npz", "npz")
        found = numpy.load(self.folder / "npz" / "000000.npz")
        self.assertEqual((found["lens"], found["field_of_view"].tolist()),
                         ("equirectangular", [360, 180]))  # fmt: skip

    def test_beams_have_no_picture(self):
        lidar = relievo.Lidar(numpy.linspace(-30, 10, 8), steps=90, min_range=0.25, noise=0.01,
                              way=(0.1, 0, 0))  # fmt: skip
        relievo.write_dataset(heap(), lidar, self.folder / "npz", "npz")
        found = numpy.load(self.folder / "npz" / "000000.npz")
        self.assertNotIn("color", found)
        self.assertEqual(found["lens"], "lidar")
        self.assertEqual(found["min_range"], 0.25)
        self.assertNotIn("max_range", found)
        numpy.testing.assert_array_equal(found["turn"], (180, -180))
        numpy.testing.assert_array_equal(found["way"], (0.1, 0, 0))
        pinhole = relievo.Pinhole(K, SIZE)
        beams = relievo.Lidar([0, 5], azimuths=[0, 9])
        for cameras, view in (([beams, pinhole], 0), ([pinhole, beams, pinhole], 1)):
            says = f"view {view}: layer flow_valid refers to places"
            with self.assertRaisesRegex(ValueError, says):
                relievo.write_dataset(heap(), cameras, self.folder / "x", "npz", ["flow_valid"])
            self.assertFalse((self.folder / "x").exists())
        with self.assertRaisesRegex(ValueError, "got the sensor lidar, which has no picture"):
            relievo.write_dataset(heap(), lidar, self.folder / "coco", "coco")

    def test_behind_the_camera(self):
        """Parts that a fisheye sees beyond 90 degrees have no depth above 0: it is 0 in 16 bits."""
        renderer = vtkRenderer()
        add(renderer, plate(0.9), (0, 0, 2))
        add(renderer, plate(0.5), (0, 0, -2))
        wide = relievo.Fisheye([[15, 0, 31.5], [0, 15, 31.5], [0, 0, 1]], (64, 64))
        wide.look_at((1.5, 0, 0), (1.5, 0, -1))
        with self.assertWarnsRegex(RuntimeWarning, "behind the camera's plane"):
            relievo.write_dataset(renderer, wide, self.folder, "coco")
        layers = relievo.capture(renderer, ["depth", "actor"], camera=wide)
        actor, depth = (relievo.layer(layers, each) for each in ("actor", "depth"))
        steps = read_png(self.folder / "depth" / "000000.png")
        self.assertGreater((actor == 0).sum(), 10)
        self.assertLess(depth[actor == 0].max(), 0)
        numpy.testing.assert_array_equal(steps > 0, actor == 1)

    def test_translucent(self):
        """Hides nothing, through a lens as in a pinhole's layers."""
        renderer = vtkRenderer()
        add(renderer, plate(0.5), (0, 0, 1)).GetProperty().SetOpacity(0.3)
        behind = add(renderer, plate(0.8))
        lens = relievo.Fisheye(K, SIZE, FISHEYE).look_at((0, 0, 4), (0, 0, 0))
        relievo.write_dataset(renderer, lens, self.folder, "npz")
        found = numpy.load(self.folder / "000000.npz")
        truth = Truth(lens, fisheye, FISHEYE, [behind])
        self.assertFalse(found["visible_masks"][0].any() or found["amodal_masks"][0].any())
        numpy.testing.assert_array_equal(found["visible_masks"][1][truth.sure],
                                         truth.seen[truth.sure])  # fmt: skip
        self.assertTrue(all(actor.GetVisibility() for actor in renderer.GetActors()))

    def test_translucent_blocks(self):
        """Hide nothing either, nor does the depth of the others count without them."""
        renderer = vtkRenderer()
        blocks = vtkMultiBlockDataSet()
        for i, z in enumerate((1.0, 0.0)):
            source = plate(0.5 + 0.3 * i)
            source.SetCenter(0, 0, z)
            source.Update()
            blocks.SetBlock(i, source.GetOutput())
        mapper = vtkCompositeMapper()
        mapper.SetInputDataObject(blocks)
        attributes = vtkCompositeDataDisplayAttributes()
        attributes.SetBlockOpacity(blocks.GetBlock(0), 0.3)
        mapper.SetCompositeDataDisplayAttributes(attributes)
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
        for kind in (relievo.Fisheye, relievo.Pinhole):
            name = kind.__name__
            with self.subTest(name):
                lens = kind(K, SIZE).look_at((0, 0, 4), (0, 0, 0))
                relievo.write_dataset(renderer, lens, self.folder / name, "npz", objects="block")
                found = numpy.load(self.folder / name / "000000.npz")
                seen = found["visible_masks"]
                self.assertFalse(seen[0].any() or found["amodal_masks"][0].any())
                self.assertGreater(seen[1].sum(), 100)
                numpy.testing.assert_allclose(found["depth"][seen[1]], 4, atol=1e-5)
                relievo.write_dataset(renderer, lens, self.folder / (name + "bop"), objects="block")
                (step,) = {each["depth_scale"] for each in
                           read_json(self.folder / (name + "bop") / "scene_camera.json").values()}
                depth = read_png(self.folder / (name + "bop") / "depth" / "000000.png")
                self.assertAlmostEqual(step * depth.max(), 4000, delta=step)

    def test_what_rays_do_not_meet(self):
        """Is in the picture alone, and a warning says so."""
        renderer = vtkRenderer()
        add(renderer, plate(0.8))
        clipped = add(renderer, plate(0.4), (0, 0, 0.5))
        clipped.GetMapper().AddClippingPlane(vtkPlane())
        lens = relievo.Fisheye(K, SIZE, FISHEYE).look_at((0, 0, 4), (0, 0, 0))
        with self.assertWarnsRegex(RuntimeWarning, "Rays do not hit .*clipped meshes"):
            relievo.write_dataset(renderer, lens, self.folder, "npz")
        found = numpy.load(self.folder / "000000.npz")
        self.assertFalse(found["visible_masks"][1].any())
        self.assertTrue(found["visible_masks"][0].any())

    def test_lens_of_poses(self):
        """Texts, a file with a size, and a sensor; incompatible arguments are refused."""
        renderer = heap()
        calibration = self.folder / "camera.json"
        calibration.write_text(json.dumps({
            "image_width": SIZE[0], "image_height": SIZE[1], "distortion_model": "plumb_bob",
            "camera_matrix": {"rows": 3, "cols": 3, "data": K.ravel().tolist()},
            "distortion_coefficients": {"rows": 1, "cols": 5, "data": BROWN}}))  # fmt: skip
        sensor = relievo.Pinhole(K, SIZE, distortion=BROWN)
        words = f"brown:{','.join(map(str, BROWN))},K={K[0, 0]}/{K[1, 1]}/{K[0, 2]}/{K[1, 2]}"
        cameras = []
        for name, lens, size in (("a", calibration, None), ("b", words, SIZE), ("c", sensor, None)):
            relievo.write_dataset(renderer, "orbit:2", self.folder / name, "npz", size=size,
                                  lens=lens)  # fmt: skip
            cameras.append(read_json(self.folder / name / "views" / "000001.json")["camera"])
            self.assertEqual(cameras[-1]["size"], list(SIZE))
            for part in ("K", "R", "t", "distortion"):
                numpy.testing.assert_allclose(cameras[-1][part], cameras[0][part], atol=1e-12)
        numpy.testing.assert_allclose(cameras[0]["distortion"][:5], BROWN)
        for words, says in (
            ({"lens": "brown"}, "lens: .*brown"),
            ({"lens": "orthographic"}, "pixels for a world unit"),
            ({"lens": 3}, "lens: got 3, expected words"),
            ({"lens": sensor, "size": (3, 3)}, "size: got .*expected none with a lens"),
            ({"lens": "fisheye", "cameras": [sensor]}, "lens: got 'fisheye', expected none with"),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, says):
                relievo.write_dataset(renderer, **{"cameras": "orbit:2", **words},
                                      directory=self.folder / "x")  # fmt: skip
        mixed = [sensor, relievo.Fisheye(K, SIZE, FISHEYE)]
        with self.assertRaisesRegex(ValueError, "view 1: transforms.json has one kind of lens"):
            relievo.write_dataset(renderer, mixed, self.folder / "x", "nerf")
        with self.assertRaisesRegex(ValueError, "the lens is one by division"):
            relievo.write_dataset(renderer, relievo.Division(K, SIZE, -0.1), self.folder / "x",
                                  "nerf")  # fmt: skip
        with self.assertRaisesRegex(FileNotFoundError, "none.yml"):
            relievo.write_dataset(renderer, "orbit:2", self.folder / "x", "npz",
                                  lens=self.folder / "none.yml")  # fmt: skip

    def test_models(self):
        """With their poses, models equal the actors: moved, rotated, scaled, mirrored, joined."""
        renderer = vtkRenderer()
        add(renderer, sphere(0.6), (0.1, 0, 0), 20)
        add(renderer, vtkCubeSource(), (-0.4, -0.1, 0.7), 35, 0.5)
        add(renderer, vtkConeSource(), (0.9, 0.2, 0), 70).SetScale(-0.5, 0.7, 0.5)
        add(renderer, vtkCubeSource(), (2, 0, 0), 35, 0.1)
        camera = relievo.Pinhole(K, SIZE).look_at(*PLACE)
        names = ["ball", "boxes", "cone", "boxes"]
        relievo.write_dataset(renderer, camera, self.folder, objects=names, mm_per_unit=250)
        infos = read_json(self.folder / "models" / "models_info.json")
        poses = read_json(self.folder / "scene_gt.json")["0"]
        actors = list(renderer.GetActors())
        self.assertEqual(list(infos), ["1", "2", "3"])
        for pose, which in zip(poses, ([0], [1, 3], [2])):
            number = pose["obj_id"]
            points, ids = read_ply(self.folder / "models" / f"obj_{number:06d}.ply")
            rotation = numpy.array(pose["cam_R_m2c"]).reshape(3, 3)
            found = (points @ rotation.T + pose["cam_t_m2c"])[ids]
            world = numpy.concatenate([triangles(actors[i]) for i in which])
            expected = 250 * (world @ camera.R.T + camera.t)
            self.assertEqual(found.shape, expected.shape)  # squares may be cut the other way
            apart = numpy.abs(found.reshape(-1, 1, 3) - expected.reshape(1, -1, 3)).max(axis=2)
            self.assertLess(max(apart.min(axis=0).max(), apart.min(axis=1).max()), 1e-3)
            areas = [numpy.linalg.norm(numpy.cross(each[:, 1] - each[:, 0],
                                                   each[:, 2] - each[:, 0]), axis=1).sum()
                     for each in (found, expected)]  # fmt: skip
            self.assertAlmostEqual(areas[0] / areas[1], 1, delta=1e-6)
            info = infos[str(number)]
            low, extent = points.min(axis=0), numpy.ptp(points, axis=0)
            numpy.testing.assert_allclose([info[f"min_{axis}"] for axis in "xyz"], low, rtol=1e-6)
            numpy.testing.assert_allclose([info[f"size_{axis}"] for axis in "xyz"], extent,
                                          rtol=1e-6)  # fmt: skip
            apart = numpy.linalg.norm(points[:, None] - points[None], axis=-1)
            self.assertAlmostEqual(info["diameter"] / apart.max(), 1, delta=1e-6)
            if bop_inout:
                model = bop_inout.load_ply(self.folder / "models" / f"obj_{number:06d}.ply")
                numpy.testing.assert_array_equal(model["pts"], points)
                numpy.testing.assert_array_equal(model["faces"], ids)
                self.assertAlmostEqual(bop_misc.calc_pts_diameter(points) / info["diameter"], 1,
                                       delta=1e-6)  # fmt: skip

    def test_diameters(self):
        """Of shapes whose farthest points are many: a fine sphere; and of one point far away."""
        renderer = vtkRenderer()
        fine = sphere(0.5)
        fine.SetThetaResolution(180)
        fine.SetPhiResolution(91)
        add(renderer, fine)
        add(renderer, sphere(0.5), (30, 4, 0), 0, 1e-3)
        relievo.write_dataset(renderer, "orbit:1", self.folder, size=(8, 8), mm_per_unit=1)
        infos = read_json(self.folder / "models" / "models_info.json")
        self.assertAlmostEqual(infos["1"]["diameter"], 1, delta=1e-6)
        points, _ = read_ply(self.folder / "models" / "obj_000002.ply")
        apart = numpy.linalg.norm(points[:, None] - points[None], axis=-1)
        self.assertAlmostEqual(infos["2"]["diameter"] / apart.max(), 1, delta=1e-6)

    def test_models_far_away(self):
        """A square of 5 cm at a place of UTM, in coordinates of the world."""
        renderer = vtkRenderer()
        source = plate(0.025)
        source.SetOutputPointsPrecision(1)  # double
        source.SetCenter(4e5, 5.4e6, 0)
        add(renderer, source)
        relievo.write_dataset(renderer, "orbit:1", self.folder, size=(8, 8))
        info = read_json(self.folder / "models" / "models_info.json")["1"]
        points, _ = read_ply(self.folder / "models" / "obj_000001.ply")
        found = [info["size_x"], info["size_y"], info["diameter"]]
        numpy.testing.assert_allclose(found, (50, 50, 50 * 2**0.5), atol=1e-4)
        numpy.testing.assert_allclose(numpy.ptp(points, axis=0), (50, 50, 0), atol=1e-4)

    def test_models_of_glyphs(self):
        renderer = vtkRenderer()
        places, cube = plate(1.0), vtkCubeSource()
        mapper = vtkGlyph3DMapper()
        mapper.SetInputConnection(places.GetOutputPort())
        mapper.SetSourceConnection(cube.GetOutputPort())
        mapper.SetScaleFactor(0.25)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.SetPosition(0, 3, 0)
        renderer.AddActor(actor)
        relievo.write_dataset(renderer, "orbit:1", self.folder, size=(8, 8), mm_per_unit=1)
        points, ids = read_ply(self.folder / "models" / "obj_000001.ply")
        self.assertEqual(ids.shape, (4 * 12, 3))
        middles = points.reshape(4, 24, 3).mean(axis=1)
        corners = [(-1, -1, 0), (1, -1, 0), (-1, 1, 0), (1, 1, 0)]
        numpy.testing.assert_allclose(middles, corners, atol=1e-6)

    def test_flow(self):
        """From each view to the one before, by K, R and t; the first has none."""
        renderer = heap()
        lens = relievo.Fisheye(K, SIZE, FISHEYE)
        cameras = [relievo.Pinhole(K, SIZE).look_at(*PLACE),
                   relievo.Pinhole(K, SIZE).look_at((0.8, 0.9, 3.1), (0, 0, 0)),
                   lens.look_at((0.6, 1.1, 3.0), (0, 0.1, 0))]  # fmt: skip
        names = ["position", "flow", "motion", "flow_valid"]
        relievo.write_dataset(renderer, cameras, self.folder, "npz", names)
        found = [numpy.load(self.folder / f"00000{i}.npz") for i in range(3)]
        self.assertTrue(numpy.isnan(found[0]["flow"]).all())
        self.assertFalse(found[0]["flow_valid"].any())
        for now, before in ((1, 0), (2, 1)):
            flow, position = found[now]["flow"], found[now]["position"]
            seen = found[now]["object"] > 0
            rows, columns = numpy.nonzero(seen & numpy.isfinite(flow).all(axis=-1))
            self.assertGreater(len(rows), 0.98 * seen.sum())
            local = position[rows, columns] @ cameras[before].R.T + cameras[before].t
            expected = (local / local[:, 2:] @ K.T)[:, :2] - numpy.stack([columns, rows], -1)
            errors = numpy.abs(flow[rows, columns] - expected).max(axis=1)
            self.assertLess(numpy.quantile(errors, 0.98), 0.01)  # edges have another position
            self.assertLess(numpy.nanmax(numpy.abs(found[now]["motion"])), 1e-6)
            valid = found[now]["flow_valid"]
            self.assertTrue(0.5 < valid[seen].mean() < 1)
            self.assertFalse(valid[~seen].any())
        # Equal to a separate range.
        relievo.write_dataset(renderer, cameras, self.folder / "part", "npz", names, views=(2, 3))
        part = numpy.load(self.folder / "part" / "000002.npz")
        numpy.testing.assert_array_equal(part["flow"], found[2]["flow"])


if __name__ == "__main__":
    unittest.main()
