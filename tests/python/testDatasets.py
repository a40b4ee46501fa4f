# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data sets: masks, depth, boxes and poses against rays through every triangle in numpy, against
the formats' own rules, and against others' readers where they are installed."""

import filecmp
import hashlib
import importlib.util
import io
import json
import pathlib
import tarfile
import tempfile
import unittest

import numpy
from PIL import Image
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkLight,
    vtkPolyDataMapper,
    vtkPropAssembly,
    vtkRenderer,
    vtkRenderWindow,
    vtkTexture,
)

import relievo

try:
    from bop_toolkit_lib import inout as bop_inout
    from bop_toolkit_lib import misc as bop_misc
    from bop_toolkit_lib import visibility as bop_visibility
except ImportError:
    bop_inout = None

if vtkVersion().GetVTKMinorVersion() < 3:
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as vtkCompositeMapper
else:
    from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as vtkCompositeMapper
try:
    from pycocotools import mask as cocomask
    from pycocotools.coco import COCO
except ImportError:
    COCO = None

SIZE = (96, 73)
K = numpy.array([[90.0, 0, 46.3], [0, 84.5, 35.2], [0, 0, 1]])


def add(renderer, source, position=(0, 0, 0), turn=0.0, scale=1.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(*position)
    actor.RotateWXYZ(turn, 1, 2, 3)
    actor.SetScale(scale)
    renderer.AddActor(actor)
    return actor


def plate(half):
    source = vtkPlaneSource()
    source.SetOrigin(-half, -half, 0)
    source.SetPoint1(half, -half, 0)
    source.SetPoint2(-half, half, 0)
    return source


def sphere(radius=0.5):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(9)
    source.SetPhiResolution(7)
    return source


def heap():
    """A floor, a ball, a box before it, and a box that is hidden in the ball."""
    renderer = vtkRenderer()
    floor = add(renderer, plate(2.0), (0, -0.8, 0))
    floor.RotateX(-90)
    add(renderer, sphere(0.6), (0.1, 0, 0), 20)
    add(renderer, vtkCubeSource(), (-0.4, -0.1, 0.7), 35, 0.5)
    add(renderer, vtkCubeSource(), (0.1, 0, 0), 10, 0.2)
    return renderer


def around():
    """Cameras that stand around the heap, one so near that it does not see all of it."""
    places = [(0.5, 1.0, 3.2), (-2.5, 1.5, 1.0), (0.2, 0.4, 1.9)]
    return [relievo.Pinhole(K, SIZE).look_at(place, (0, -0.1, 0)) for place in places]


def triangles(actor):
    """The corners of an actor's triangles, in the world: n x 3 x 3."""
    source = vtkTriangleFilter()
    source.SetInputConnection(actor.GetMapper().GetInputConnection(0, 0))
    source.Update()
    mesh = source.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    cells = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    matrix = matrix_of(actor)
    return (points @ matrix[:3, :3].T + matrix[:3, 3])[cells]


def matrix_of(actor):
    matrix = actor.GetMatrix()
    return numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def trace(camera, corners, beyond=0):
    """Of each pixel, also of so many pictures beyond: the depth of the first triangle, infinity for
    none; and whether its ray goes so near to an edge that a float may decide otherwise."""
    columns, rows = (count * (1 + 2 * beyond) for count in camera.size)
    u, v = numpy.meshgrid(numpy.arange(columns), numpy.arange(rows))
    u, v = u - beyond * camera.size[0], v - beyond * camera.size[1]
    local = numpy.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], numpy.ones_like(u)], -1)
    return follow(camera, local, corners)


def follow(camera, local, corners):
    """Of rays (rows x columns x 3) in camera space: how many times their length the first triangle
    is away, infinity for none; and whether they go near an edge."""
    rows, columns = local.shape[:2]
    direction = local.reshape(-1, 3) @ camera.R
    origin = -camera.R.T @ camera.t
    depth = numpy.full(len(direction), numpy.inf)
    near = numpy.zeros(len(direction), bool)
    for a, b, c in corners:
        normal = numpy.cross(b - a, c - a)
        with numpy.errstate(divide="ignore", invalid="ignore"):
            z = normal @ (a - origin) / (direction @ normal)
            point = origin + z[:, None] * direction
            weights = numpy.stack([
                numpy.cross(q - p, point - p) @ normal / (normal @ normal)
                for p, q in ((a, b), (b, c), (c, a))
            ]).min(axis=0)  # fmt: skip
        inside = (weights >= 0) & (z > 0)
        depth[inside] = numpy.minimum(depth[inside], z[inside])
        near |= numpy.abs(weights) < 1e-4
    return depth.reshape(rows, columns), near.reshape(rows, columns)


class Truth:
    """The true view of actors from a camera."""

    def __init__(self, camera, actors):
        found = [trace(camera, triangles(actor)) for actor in actors]
        self.depths = numpy.array([each[0] for each in found])
        self.near = numpy.any([each[1] for each in found], axis=0)
        self.depth = self.depths.min(axis=0)
        self.object = numpy.where(numpy.isfinite(self.depth), self.depths.argmin(axis=0), -1)


def box_of(mask):
    if not mask.any():
        return [-1, -1, -1, -1]
    rows, columns = numpy.nonzero(mask)
    return [columns.min(), rows.min(), numpy.ptp(columns) + 1, numpy.ptp(rows) + 1]


def runs(text, shape):
    """COCO's compressed runs, by its description: six bits a letter, differences to the run before
    the last."""
    lengths, value, shift = [], 0, 0
    for letter in text.encode():
        letter -= 48
        value |= (letter & 31) << shift
        shift += 5
        if not letter & 32:
            if letter & 16:
                value -= 1 << shift
            lengths.append(value + (lengths[-2] if len(lengths) > 2 else 0))
            value = shift = 0
    flat = numpy.repeat(numpy.arange(len(lengths)) % 2, lengths).astype(bool)
    return flat.reshape(shape[::-1]).T


def read_json(path):
    return json.loads(path.read_text())


def read_png(path):
    return numpy.array(Image.open(path))


def same(one, other):
    """Whether two folders hold the same bytes."""
    names = [sorted(str(p.relative_to(top)) for p in top.rglob("*") if p.is_file())
             for top in (one, other)]  # fmt: skip
    return names[0] == names[1] and not any(
        filecmp.cmpfiles(one, other, names[0], shallow=False)[1:]
    )


class Datasets(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def check_masks(self, visible, whole, camera, actors):
        """Against rays through each triangle; returns the truth."""
        truth = Truth(camera, actors)
        self.assertLess(truth.near.mean(), 0.05)
        sure = ~truth.near
        visible, whole = numpy.array(visible) > 0, numpy.array(whole) > 0
        self.assertEqual(visible.sum(axis=0).max(), 1, "masks are not disjoint")
        self.assertFalse((visible & ~whole).any(), "more is seen of an object than there is")
        foreground = numpy.isfinite(truth.depth)
        numpy.testing.assert_array_equal(visible.any(axis=0)[sure], foreground[sure])
        for i in range(len(actors)):
            numpy.testing.assert_array_equal(visible[i][sure], (truth.object == i)[sure])
            numpy.testing.assert_array_equal(whole[i][sure], numpy.isfinite(truth.depths[i])[sure])
        return truth, visible, whole

    def test_bop(self):
        renderer = heap()
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(8)
        window.SetSize(50, 40)
        window.AddRenderer(renderer)
        before = renderer.GetActiveCamera()
        cameras = around()
        written = relievo.write_dataset(renderer, cameras, self.folder, mm_per_unit=250)
        self.assertEqual(written, 3)
        self.assertEqual(tuple(window.GetSize()), (50, 40))
        self.assertIs(renderer.GetActiveCamera(), before)
        poses = read_json(self.folder / "scene_gt.json")
        infos = read_json(self.folder / "scene_gt_info.json")
        intrinsics = read_json(self.folder / "scene_camera.json")
        self.assertEqual(list(poses), ["0", "1", "2"])
        actors = list(renderer.GetActors())
        hidden = reaching = 0
        for view, camera in enumerate(cameras):
            masks = [
                [read_png(self.folder / kind / f"{view:06d}_{i:06d}.png") for i in range(4)]
                for kind in ("mask_visib", "mask")
            ]
            self.assertEqual(set(numpy.unique(masks)), {0, 255})
            truth, visible, whole = self.check_masks(*masks, camera, actors)
            about = intrinsics[str(view)]
            numpy.testing.assert_allclose(about["cam_K"], K.ravel(), atol=1e-12)
            numpy.testing.assert_allclose(about["cam_R_w2c"], camera.R.ravel(), atol=1e-12)
            numpy.testing.assert_allclose(about["cam_t_w2c"], 250 * camera.t, atol=1e-9)
            # Depth in millimetres.
            depth = read_png(self.folder / "depth" / f"{view:06d}.png")
            self.assertIn(depth.dtype, (numpy.int32, numpy.uint16))  # as Pillow reads 16 bits
            numpy.testing.assert_array_equal(depth > 0, visible.any(axis=0))
            seen = visible.any(axis=0) & ~truth.near
            errors = numpy.abs(depth[seen] * about["depth_scale"] / 250 - truth.depth[seen])
            # Half a step, of a float.
            allowed = 0.5 * about["depth_scale"] / 250 + 1e-6 * truth.depth[seen]
            self.assertLessEqual((errors / allowed).max(), 1)
            self.assertGreater(depth.max(), 30000)
            for i, (pose, info) in enumerate(zip(poses[str(view)], infos[str(view)])):
                self.assertEqual(pose["obj_id"], i + 1)
                self.assertEqual(info["bbox_visib"], box_of(visible[i]))
                self.assertEqual(info["px_count_visib"], visible[i].sum())
                if view == 2:  # all of it, also beyond the picture
                    depths, near = trace(camera, triangles(actors[i]), 1)
                    every = numpy.isfinite(depths)
                    self.assertLessEqual(abs(info["px_count_all"] - every.sum()), near.sum())
                    around_it = numpy.array(box_of(every)) - [*SIZE, 0, 0]
                    numpy.testing.assert_allclose(info["bbox_obj"], around_it, atol=1)
                    reaching += info["px_count_all"] > 1.2 * whole[i].sum() > 0
                self.assertEqual(info["px_count_valid"], (whole[i] & (depth > 0)).sum())
                self.assertAlmostEqual(
                    info["visib_fract"], visible[i].sum() / max(1, info["px_count_all"])
                )
                hidden += info["px_count_visib"] == 0 < info["px_count_all"]
                # A corner of the model, which its scale belongs to, by BOP's pose and by the actor.
                rotation = numpy.array(pose["cam_R_m2c"]).reshape(3, 3)
                numpy.testing.assert_allclose(rotation @ rotation.T, numpy.eye(3), atol=1e-12)
                self.assertAlmostEqual(numpy.linalg.det(rotation), 1)
                corner = numpy.array([0.3, -0.2, 0.1])
                scaled = corner * actors[i].GetScale()
                world = (matrix_of(actors[i]) @ [*corner, 1])[:3]
                numpy.testing.assert_allclose(
                    rotation @ (250 * scaled) + pose["cam_t_m2c"],
                    250 * (camera.R @ world + camera.t),
                    atol=1e-9,
                )
        self.assertEqual(hidden, 3)  # the box in the ball
        self.assertGreater(reaching, 0)
        if bop_inout:
            self.check_as_bop_reads(cameras, actors)
        # The picture has smooth edges: colours in between, where masks have none.
        picture = read_png(self.folder / "rgb" / "000000.png")
        self.assertEqual(picture.shape, (SIZE[1], SIZE[0], 3))
        self.assertGreater(len(numpy.unique(picture.reshape(-1, 3), axis=0)), 100)

    def check_as_bop_reads(self, cameras, actors):
        """BOP's own reader and its rule of visibility, with depths computed by numpy."""
        scene_camera = bop_inout.load_scene_camera(self.folder / "scene_camera.json")
        scene_gt = bop_inout.load_scene_gt(self.folder / "scene_gt.json")
        for view, camera in enumerate(cameras):
            about = scene_camera[view]
            depth = bop_inout.load_depth(self.folder / "depth" / f"{view:06d}.png")
            distance = bop_misc.depth_im_to_dist_im_fast(
                depth * about["depth_scale"], about["cam_K"]
            )
            truth = Truth(camera, actors)
            for i, pose in enumerate(scene_gt[view]):
                own = numpy.where(numpy.isfinite(truth.depths[i]), 250 * truth.depths[i], 0)
                own = bop_misc.depth_im_to_dist_im_fast(own, about["cam_K"])
                seen = bop_visibility.estimate_visib_mask_gt(distance, own, 0.1)
                mask = bop_inout.load_im(
                    self.folder / "mask_visib" / f"{view:06d}_{i:06d}.png") > 0  # fmt: skip
                sure = ~truth.near
                numpy.testing.assert_array_equal(seen[sure], mask[sure])
                center = numpy.array([actors[i].GetOrigin()])
                projected = bop_misc.project_pts(
                    center, about["cam_K"], pose["cam_R_m2c"], pose["cam_t_m2c"]
                )
                numpy.testing.assert_allclose(
                    projected, camera.project([actors[i].GetPosition()]), atol=1e-9
                )

    def test_arrays(self):
        renderer = heap()
        camera = around()[0]
        relievo.write_dataset(
            renderer, camera, self.folder, "npz", ["normal", "position", "cell", "depth"]
        )
        found = numpy.load(self.folder / "000000.npz")
        truth, visible, whole = self.check_masks(
            found["visible_masks"], found["amodal_masks"], camera, list(renderer.GetActors())
        )
        self.assertEqual(found["depth"].dtype, numpy.float32)
        numpy.testing.assert_array_equal(numpy.isfinite(found["depth"]), visible.any(axis=0))
        sure = ~truth.near & numpy.isfinite(truth.depth)
        errors = numpy.abs(found["depth"][sure] / truth.depth[sure] - 1)
        self.assertLess(errors.max(), 1e-6)
        numpy.testing.assert_array_equal(found["object"] - 1, numpy.where(
            visible.any(axis=0), visible.argmax(axis=0), -1))  # fmt: skip
        # A position is projected to its pixel by hand.
        place = found["position"][sure] @ found["R"].T + found["t"]
        pixel = (place / place[:, 2:]) @ found["K"].T
        rows, columns = numpy.nonzero(sure)
        numpy.testing.assert_allclose(pixel[:, 0], columns, atol=1e-3)
        numpy.testing.assert_allclose(pixel[:, 1], rows, atol=1e-3)
        numpy.testing.assert_allclose(
            numpy.linalg.norm(found["normal"][sure], axis=1), 1, atol=1e-6
        )
        self.assertEqual(found["color"].shape, (SIZE[1], SIZE[0], 3))
        boxes = [box_of(mask) for mask in visible]
        numpy.testing.assert_array_equal(found["visible_boxes"], boxes)
        numpy.testing.assert_array_equal(
            found["object_to_world"], [matrix_of(actor) for actor in renderer.GetActors()]
        )

    def test_coco(self):
        renderer = heap()
        cameras = around()
        names = ["floor", "ball", "box", "box"]  # two actors are one object
        relievo.write_dataset(renderer, cameras, self.folder, "coco", objects=names)
        index = read_json(self.folder / "instances.json")
        self.assertEqual([each["name"] for each in index["categories"]], ["floor", "ball", "box"])
        self.assertEqual(len({each["id"] for each in index["annotations"]}), 9)
        coco = COCO(self.folder / "instances.json") if COCO else None
        actors = list(renderer.GetActors())
        for view, camera in enumerate(cameras):
            truth = Truth(camera, actors)
            kind = numpy.minimum(truth.object, 2)
            sure = ~truth.near
            of_view = [each for each in index["annotations"] if each["image_id"] == view]
            self.assertEqual([each["category_id"] for each in of_view], [1, 2, 3])
            for each in of_view:
                number = each["category_id"] - 1
                shape = tuple(each["segmentation"]["size"])
                mask = runs(each["segmentation"]["counts"], shape)
                whole = runs(each["amodal_segmentation"]["counts"], shape)
                numpy.testing.assert_array_equal(mask[sure], (kind == number)[sure])
                depths = truth.depths[2:].min(axis=0) if number == 2 else truth.depths[number]
                numpy.testing.assert_array_equal(whole[sure], numpy.isfinite(depths)[sure])
                self.assertEqual(each["bbox"], box_of(mask))
                self.assertEqual(each["amodal_bbox"], box_of(whole))
                self.assertEqual((each["area"], each["iscrowd"]), (mask.sum(), 0))
                if COCO:
                    numpy.testing.assert_array_equal(coco.annToMask(each), mask)
                    self.assertEqual(cocomask.area(each["segmentation"]), each["area"])
                    self.assertEqual(list(cocomask.toBbox(each["segmentation"])), each["bbox"])
                    theirs = cocomask.encode(numpy.asfortranarray(mask.astype(numpy.uint8)))
                    self.assertEqual(theirs["counts"].decode(), each["segmentation"]["counts"])

    def test_nerf(self):
        renderer = heap()
        cameras = around()
        relievo.write_dataset(renderer, cameras, self.folder / "one", "nerf")
        index = read_json(self.folder / "one" / "transforms.json")
        self.assertEqual((index["w"], index["h"]), SIZE)
        # The corner of the ground, by OpenGL's axes, and by the camera.
        corner = numpy.array([2, -0.8, 2, 1])
        for camera, frame in zip(cameras, index["frames"]):
            x, y, z, _ = numpy.linalg.inv(frame["transform_matrix"]) @ corner
            u = index["fl_x"] * x / -z + index["cx"] - 0.5  # centres are halves
            v = index["fl_y"] * -y / -z + index["cy"] - 0.5
            place = camera.R @ corner[:3] + camera.t
            if place[2] > 0:
                numpy.testing.assert_allclose((K @ place)[:2] / place[2], [u, v], atol=1e-9)
            self.assertTrue((self.folder / "one" / frame["file_path"]).is_file())
        # It is a file of poses.
        poses = self.folder / "one" / "transforms.json"
        relievo.write_dataset(renderer, poses, self.folder / "two", "nerf")
        for view in range(3):
            pictures = [read_png(self.folder / each / "images" / f"{view:06d}.png").astype(int)
                        for each in ("one", "two")]  # fmt: skip
            self.assertLess(numpy.abs(pictures[0] - pictures[1]).mean(), 0.1)

    def test_shards(self):
        """Samples in tar archives have the arrays of npz; shards have at most their size. Read by
        Python's tarfile, and by the package webdataset if it is installed."""
        renderer, cameras = heap(), [*around(), *around()]
        common = {"layers": ["normal"], "depth_step": 0.001}
        relievo.write_dataset(renderer, cameras, self.folder / "npz", "npz", layers=["normal"])
        one, two = self.folder / "one", self.folder / "two"
        relievo.write_dataset(renderer, cameras, one, "webdataset", **common)
        sample = (one / "samples" / "000000.tar").stat().st_size
        relievo.write_dataset(renderer, cameras, two, "webdataset", shard_size=2.6 * sample / 1e6,
                              **common)  # fmt: skip
        self.assertEqual([each["url"] for each in read_json(one / "index.json")["shardlist"]],
                         ["shard-000000.tar"])  # fmt: skip
        shards = read_json(two / "index.json")["shardlist"]
        self.assertEqual([each["nsamples"] for each in shards], [2, 2, 2])
        views = 0
        for shard in shards:
            self.assertEqual((two / shard["url"]).stat().st_size, shard["filesize"])
            self.assertLess(shard["filesize"], 2.6 * sample)
            with tarfile.open(two / shard["url"]) as archive:
                files = {each.name: archive.extractfile(each).read() for each in archive}
            self.assertEqual(len(files), 10)
            for key in sorted({name.split(".")[0] for name in files}):
                self.assertEqual(key, f"{views:06d}")
                found = numpy.load(self.folder / "npz" / f"{key}.npz")
                layers = numpy.load(io.BytesIO(files[f"{key}.layers.npz"]))
                numpy.testing.assert_array_equal(layers["normal"], found["normal"])
                images = {}
                for name in ("png", "depth.png", "object.png"):
                    (self.folder / "image.png").write_bytes(files[f"{key}.{name}"])
                    images[name] = read_png(self.folder / "image.png")
                numpy.testing.assert_array_equal(images["png"], found["color"])
                numpy.testing.assert_array_equal(images["object.png"], found["object"])
                depth = numpy.where(numpy.isfinite(found["depth"]), found["depth"], 0)
                numpy.testing.assert_allclose(images["depth.png"] * 0.001, depth, atol=0.00051)
                record = json.loads(files[f"{key}.json"])
                self.assertEqual((record["view"], record["depth_step"]), (views, 0.001))
                views += 1
        self.assertEqual(views, 6)
        self.assertEqual(relievo.verify(two), "")
        (two / "shard-000001.tar").write_bytes(b"")
        self.assertIn("shard-000001.tar is not that of these views", relievo.verify(two))
        relievo.merge(two)
        self.assertEqual(relievo.verify(two), "")
        if importlib.util.find_spec("webdataset"):
            import webdataset  # noqa: PLC0415

            found = webdataset.WebDataset([str(two / each["url"]) for each in shards],
                                          shardshuffle=False)  # fmt: skip
            self.assertEqual([each["__key__"] for each in found],
                             [f"{view:06d}" for view in range(6)])  # fmt: skip
        # A sample may be larger than the files that are read whole.
        large, named = two / "samples" / "000000.tar", two / "views" / "000000.json"
        with open(large, "r+b") as file:
            file.truncate(257 << 20)
        record = read_json(named)
        record["files"]["samples/000000.tar"] = hashlib.md5(large.read_bytes()).hexdigest()
        named.write_text(json.dumps(record))
        self.assertIn("shard-000000.tar is not that of these views", relievo.verify(two))

    def test_boxes_in_lines(self):
        """Lines of yolo and kitti have the boxes, categories and shares of the masks of npz."""
        renderer = heap()
        cameras = [*around(), around()[0]]
        names = ["floor", "ball", "box_0", "box_1"]
        common = {"objects": names, "categories": {"a box": ["box_*"]}, "validation": 0.5}
        relievo.write_dataset(renderer, cameras, self.folder / "npz", "npz", objects=names)
        for name in ("yolo", "kitti"):
            relievo.write_dataset(renderer, cameras, self.folder / name, name, **common)
        yolo, kitti = self.folder / "yolo", self.folder / "kitti" / "training"
        self.assertEqual((yolo / "data.yaml").read_text(),
                         'train: images/train\nval: images/val\nnames:\n  0: "floor"\n'
                         '  1: "ball"\n  2: "a box"\n')  # fmt: skip
        for part, views in (("train", (0, 2)), ("val", (1, 3))):
            listed = [f"{view:06d}" for view in views]
            for kind, ending in (("images", "png"), ("labels", "txt")):
                self.assertEqual(sorted(each.name for each in (yolo / kind / part).iterdir()),
                                 [f"{name}.{ending}" for name in listed])  # fmt: skip
            lists = self.folder / "kitti" / "ImageSets" / f"{part}.txt"
            self.assertEqual(lists.read_text().split(), listed)
        for view in range(4):
            found = numpy.load(self.folder / "npz" / f"{view:06d}.npz")
            seen = [i for i in range(4) if found["visible_masks"][i].any()]
            part = "val" if view in (1, 3) else "train"
            lines = (yolo / "labels" / part / f"{view:06d}.txt").read_text().splitlines()
            boxes = []
            for i in seen:
                left, top, wide, high = box_of(found["visible_masks"][i])
                boxes.append([min(i, 2), (left + wide / 2) / SIZE[0], (top + high / 2) / SIZE[1],
                              wide / SIZE[0], high / SIZE[1]])  # fmt: skip
            numpy.testing.assert_allclose(
                [list(map(float, line.split())) for line in lines], boxes, rtol=1e-15)
            lines = (kitti / "label_2" / f"{view:06d}.txt").read_text().splitlines()
            self.assertEqual(len(lines), len(seen))
            for i, line in zip(seen, lines):
                name, beyond, level, *rest = line.split()
                self.assertEqual(name, ["floor", "ball", "a_box"][min(i, 2)])
                whole = found["amodal_masks"][i]
                share = found["visible_masks"][i].sum() / whole.sum()
                self.assertEqual(int(level), 0 if share >= 0.95 else 1 if share >= 0.5 else 2)
                left, top, wide, high = box_of(whole)
                self.assertEqual(rest, ["-10", *map(str, (left, top, left + wide - 1,
                                                          top + high - 1)),
                                        *"-1 -1 -1 -1000 -1000 -1000 -10".split()])  # fmt: skip
                inside = left > 0 and top > 0 and left + wide < SIZE[0] and top + high < SIZE[1]
                self.assertLess(float(beyond), 1e-9 if inside else 1)
            lines = (kitti / "calib" / f"{view:06d}.txt").read_text().splitlines()
            self.assertEqual([line.split(":")[0] for line in lines],
                             ["P0", "P1", "P2", "P3", "R0_rect", "Tr_velo_to_cam",
                              "Tr_imu_to_velo"])  # fmt: skip
            matrix = numpy.array(lines[2].split()[1:], float).reshape(3, 4)
            numpy.testing.assert_array_equal(matrix, numpy.column_stack([found["K"], [0, 0, 0]]))
        one = read_json(yolo / "views" / "000001.json")["files"]
        self.assertLessEqual({"labels/val/000001.txt", "images/val/000001.png"}, set(one))

    def test_truncated(self):
        """KITTI's share beyond the picture, of a plate that is half outside, is a half."""
        renderer = vtkRenderer()
        add(renderer, plate(0.475))  # 9.5 pixels
        camera = relievo.Pinhole([100, 0, 0, 0, 100, 20, 0, 0, 1], (61, 41))  # x = 0 is column 0
        relievo.write_dataset(
            renderer, camera.look_at((0, 0, 5), (0, 0, 0)), self.folder, "kitti")
        line = (self.folder / "training" / "label_2" / "000000.txt").read_text().split()
        self.assertEqual(line[4:8], ["0", "11", "9", "29"])
        self.assertAlmostEqual(float(line[1]), 9 / 19, delta=1e-9)

    def test_categories_and_validation(self):
        """Categories group objects; views for validation are apart."""
        renderer = heap()
        cameras = [*around(), *around()]
        for each in ("one", "many"):
            given = {} if each == "one" else {"categories": {"solid": ["b*"]}, "validation": 0.4}
            relievo.write_dataset(renderer, cameras, self.folder / each, "coco",
                                  objects=["floor", "ball", "box", "box2"], **given)  # fmt: skip
        one = read_json(self.folder / "one" / "instances.json")
        halves = [read_json(self.folder / "many" / f"instances_{part}.json")
                  for part in ("train", "val")]  # fmt: skip
        self.assertFalse((self.folder / "many" / "instances.json").exists())
        # floor((v + 1) * 0.4) > floor(v * 0.4)
        self.assertEqual([[each["id"] for each in half["images"]] for half in halves],
                         [[0, 1, 3, 5], [2, 4]])  # fmt: skip
        for half in halves:
            self.assertEqual([each["name"] for each in half["categories"]], ["floor", "solid"])
            views = {each["id"] for each in half["images"]}
            expected = [(each["image_id"], min(each["category_id"], 2), each["bbox"])
                        for each in one["annotations"] if each["image_id"] in views]  # fmt: skip
            self.assertEqual([(each["image_id"], each["category_id"], each["bbox"])
                              for each in half["annotations"]], expected)  # fmt: skip
            self.assertEqual([each["id"] for each in half["annotations"]],
                             list(range(1, len(expected) + 1)))  # fmt: skip
        relievo.write_dataset(renderer, cameras, self.folder / "nerf", "nerf", validation=0.4)
        index = read_json(self.folder / "nerf" / "transforms.json")
        self.assertEqual(index["val_filenames"], ["images/000002.png", "images/000004.png"])
        self.assertEqual(index["test_filenames"], index["val_filenames"])
        self.assertEqual(len(index["train_filenames"]), 4)
        small = relievo.Pinhole([8, 0, 4, 0, 8, 4, 0, 0, 1], (8, 8)).look_at((0, 0, 5), (0, 0, 0))
        relievo.write_dataset(vtkRenderer(), [small] * 100, self.folder / "rounding", "kitti",
                              validation=0.29)  # fmt: skip
        listed = (self.folder / "rounding" / "ImageSets" / "val.txt").read_text().split()
        self.assertEqual(len(listed), 29)  # of 100, where floats have 28.999999999999996
        relievo.write_dataset(renderer, cameras[0], self.folder / "signs", "yolo",
                              objects=["m[1]", "m\\2", "m3", "m?"],
                              categories={"a": ["m[1]", "m\\2"], "b": "m?"})  # fmt: skip
        self.assertEqual(read_json(self.folder / "signs" / "dataset.json")["categories"],
                         ["a", "a", "b", "b"])  # fmt: skip
        folder = self.folder / "none"
        for words, says in (
            ({"format": "bop", "validation": 0.5}, "validation: cannot be written in the format "
             "bop; expected the format coco, nerf, yolo or kitti"),
            ({"format": "npz", "categories": {"a": ["ball"]}}, "category a: cannot be written in "
             "the format npz; expected the format coco, yolo or kitti"),
            ({"format": "coco", "validation": 1.5}, "validation: got 1.5, expected .*0 to 1"),
            ({"format": "coco", "categories": {"a": ["mug*"]}},
             r"category a: no object is called mug\*; expected a name or pattern of actor_0"),
            *(({"format": "coco", "categories": invalid}, "categories: got .*expected a dictionary")
              for invalid in (["a"], {"a": 5}, {"a": [5]}, {5: ["a"]}, {"a": []})),
            ({"format": "yolo", "categories": {"": ["ball"]}}, "category: got '' for the objects"),
            *(({"format": "yolo", "validation": share}, f"validation: got {share}, which is "
               f"{count} of 6 views") for share, count in ((0.1, 0), (1, 6))),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, says):
                relievo.write_dataset(renderer, cameras, folder, **words)

    def test_plates_that_nearly_touch(self):
        """The nearer plate has all of its pixels, however far away the planes of the camera are."""
        renderer = vtkRenderer()
        add(renderer, plate(0.4))
        add(renderer, plate(0.8), (0, 0, -1e-3))
        add(renderer, plate(0.5), (0, 0, -500))
        camera = relievo.Pinhole(K, SIZE).look_at((0.3, 0.2, 3), (0, 0, 0))
        relievo.write_dataset(renderer, camera, self.folder, "npz")
        found = numpy.load(self.folder / "000000.npz")
        _, visible, whole = self.check_masks(
            found["visible_masks"], found["amodal_masks"], camera, list(renderer.GetActors())
        )
        numpy.testing.assert_array_equal(visible[0], whole[0])
        numpy.testing.assert_array_equal(visible[1], whole[1] & ~whole[0])
        self.assertGreater(visible[0].sum(), 300)

    def test_translucent_and_cut_out(self):
        """Translucent surfaces occlude nothing; the opaque part of a cut-out does."""
        renderer = vtkRenderer()
        glass = add(renderer, plate(0.5), (0, 0, 1))
        glass.GetProperty().SetOpacity(0.3)
        add(renderer, plate(0.8))
        leaf = add(renderer, plate(0.4), (0, 0, 0.5))
        image = Image.new("RGBA", (2, 2), (200, 200, 200, 255))
        image.putpixel((0, 0), (0, 0, 0, 0))
        image.save(self.folder / "leaf.png")
        reader = relievo.vtkRelievoImageReader()
        reader.SetFileName(str(self.folder / "leaf.png"))
        texture = vtkTexture()
        texture.SetInputConnection(reader.GetOutputPort())
        texture.InterpolateOff()
        leaf.SetTexture(texture)
        leaf.ForceOpaqueOn()
        camera = relievo.Pinhole(K, SIZE).look_at((0, 0, 4), (0, 0, 0))
        relievo.write_dataset(renderer, camera, self.folder / "set", "npz")
        found = numpy.load(self.folder / "set" / "000000.npz")
        visible, whole = found["visible_masks"], found["amodal_masks"]
        self.assertFalse(visible[0].any() or whole[0].any())
        self.assertFalse((visible[1] & visible[2]).any())
        numpy.testing.assert_array_equal(visible[1], whole[1] & ~whole[2])
        truth = Truth(camera, list(renderer.GetActors()))
        full = numpy.isfinite(truth.depths[2])
        self.assertFalse((whole[2] & ~full & ~truth.near).any())
        self.assertAlmostEqual(whole[2].sum() / full.sum(), 0.75, delta=0.05)
        # It is the upper left quarter that lacks.
        left, top, columns, rows = box_of(full)
        corner = whole[2][top : top + rows // 2 - 1, left : left + columns // 2 - 1]
        self.assertFalse(corner.any())

    def test_parts_without_a_number_hide_and_are_none(self):
        renderer = vtkRenderer()
        add(renderer, plate(0.8))
        loose = vtkRenderer()
        add(loose, plate(0.4), (0, 0, 0.5))
        assembly = vtkPropAssembly()
        assembly.AddPart(loose.GetActors().GetLastActor())
        renderer.AddViewProp(assembly)
        camera = relievo.Pinhole(K, SIZE).look_at((0, 0, 4), (0, 0, 0))
        relievo.write_dataset(renderer, camera, self.folder, "npz")
        found = numpy.load(self.folder / "000000.npz")
        hidden = found["depth"] < 3.75
        self.assertGreater(hidden.sum(), 200)
        self.assertFalse(found["visible_masks"][0][hidden].any())
        self.assertTrue(found["amodal_masks"][0][hidden].all())
        truth = Truth(camera, [renderer.GetActors().GetItemAsObject(0)])
        sure = ~truth.near
        numpy.testing.assert_array_equal(
            found["amodal_masks"][0][sure], numpy.isfinite(truth.depth)[sure]
        )

    def test_blocks(self):
        blocks = vtkMultiBlockDataSet()
        for i, x in enumerate((-0.3, 0.3)):
            source = sphere(0.5)
            source.SetCenter(x, 0, -x)
            source.Update()
            blocks.SetBlock(i, source.GetOutput())
        mapper = vtkCompositeMapper()
        mapper.SetInputDataObject(blocks)
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer = vtkRenderer()
        renderer.AddActor(actor)
        camera = relievo.Pinhole(K, SIZE).look_at((0, 0, 4), (0, 0, 0))
        for name, objects in (("one", "actor"), ("two", "block")):
            relievo.write_dataset(renderer, camera, self.folder / name, "npz", objects=objects)
        one, two = (numpy.load(self.folder / name / "000000.npz") for name in ("one", "two"))
        numpy.testing.assert_array_equal(
            one["visible_masks"][0], two["visible_masks"].any(axis=0)
        )
        self.assertEqual(len(two["visible_masks"]), 2)
        self.assertFalse((two["visible_masks"] & ~two["amodal_masks"]).any())
        # The one at the left is nearer: all of it is seen.
        counts = two["visible_masks"].sum(axis=(1, 2)), two["amodal_masks"].sum(axis=(1, 2))
        self.assertEqual(counts[0][0], counts[1][0])
        self.assertLess(counts[0][1], 0.9 * counts[1][1])

    def test_rays(self):
        """For a distorting lens, everything is traced by rays, as in captures."""
        renderer = heap()
        lens = relievo.Fisheye(K, SIZE, [0.02, -0.01]).look_at((0.5, 1.0, 3.2), (0, -0.1, 0))
        relievo.write_dataset(renderer, [lens], self.folder, "npz", "normal")
        found = numpy.load(self.folder / "000000.npz")
        layers = relievo.capture(renderer, ["depth", "actor"], camera=lens)
        numpy.testing.assert_array_equal(found["object"] - 1, relievo.layer(layers, "actor"))
        numpy.testing.assert_array_equal(found["depth"], relievo.layer(layers, "depth"))
        self.assertFalse((found["visible_masks"] & ~found["amodal_masks"]).any())
        origins, directions = (each.reshape(-1, 3) for each in lens.rays())
        hits = relievo.rays(renderer).all(origins, directions)
        for i in range(4):
            whole = numpy.isin(numpy.arange(len(origins)), hits.ray[hits.prop == i])
            numpy.testing.assert_array_equal(found["amodal_masks"][i].ravel(), whole)

    def test_nothing_there(self):
        renderer = vtkRenderer()
        camera = around()[0]
        for name in ("bop", "coco", "nerf", "npz", "yolo", "kitti"):
            relievo.write_dataset(renderer, camera, self.folder / name, name)
        self.assertEqual(read_json(self.folder / "bop" / "scene_gt.json"), {"0": []})
        self.assertEqual(read_json(self.folder / "coco" / "instances.json")["annotations"], [])
        for labels in ("yolo/labels/train", "kitti/training/label_2"):
            self.assertEqual((self.folder / labels / "000000.txt").read_text(), "")
        found = numpy.load(self.folder / "npz" / "000000.npz")
        self.assertEqual(found["visible_masks"].shape, (0, SIZE[1], SIZE[0]))
        self.assertTrue(numpy.isinf(found["depth"]).all())
        self.assertFalse(read_png(self.folder / "bop" / "depth" / "000000.png").any())
        with self.assertRaisesRegex(ValueError, "cameras have nothing to surround"):
            relievo.write_dataset(renderer, "orbit:3", self.folder / "none")

    def test_goes_on(self):
        """Interrupted and gone on with, in parts, or twice by one seed: the same bytes."""
        renderer = heap()
        words = {"cameras": "random:5,nearest=0.8", "size": (40, 30), "random_sun": True,
                 "layers": ["normal"]}
        whole, parts, broken = (self.folder / name for name in ("whole", "parts", "broken"))
        self.assertEqual(relievo.write_dataset(renderer, directory=whole, **words), 5)
        # Several views are drawn in one frame, and a single one has a frame of its own.
        for views in ((4, 5), (2, 4), (1, 2), (0, 1)):
            relievo.write_dataset(renderer, directory=parts, views=views, **words)
        self.assertTrue(same(whole, parts))
        with self.assertRaisesRegex(RuntimeError, "ended by progress at 40%"):
            relievo.write_dataset(renderer, directory=broken,
                                  progress=lambda share: share < 0.3, **words)  # fmt: skip
        self.assertFalse((broken / "scene_gt.json").exists())
        # The third view has a file but no record.
        (broken / "rgb" / "000002.png").write_bytes(b"half")
        shares = []
        self.assertEqual(
            relievo.write_dataset(renderer, directory=broken, progress=shares.append, **words), 3
        )
        numpy.testing.assert_allclose(shares, [0.2, 0.4, 0.6, 0.8, 1])
        self.assertTrue(same(whole, broken))
        self.assertEqual(relievo.write_dataset(renderer, directory=whole, **words), 0)
        # The sun moves, and the shapes do not.
        still = {**words, "random_sun": False}
        relievo.write_dataset(renderer, directory=self.folder / "still", **still)
        for kind, alike in (("rgb", False), ("mask_visib", True), ("depth", True)):
            self.assertEqual(same(whole / kind, self.folder / "still" / kind), alike, kind)
        relievo.write_dataset(renderer, directory=self.folder / "seed", seed=1, **words)
        self.assertFalse(same(whole / "depth", self.folder / "seed" / "depth"))

    def test_scenes_that_vary(self):
        """Each view has its own scene, by its number alone: also in parts and after an end."""
        renderer = heap()
        actors = [renderer.GetActors().GetItemAsObject(i) for i in range(4)]
        words = {"cameras": "random:4,nearest=0.8", "size": (40, 30), "seed": 3, "format": "npz"}

        def vary(view, random):
            place = random.uniform(-0.4, 0.4, 3)
            actors[1].SetPosition(place)
            shade = random.uniform()
            actors[2].GetProperty().SetColor(shade, 0.5, 0.5)
            return {"place": place, "shade": shade, "view": view}

        whole, parts, broken = (self.folder / name for name in ("whole", "parts", "broken"))
        self.assertEqual(relievo.write_dataset(renderer, directory=whole, vary=vary, **words), 4)
        places = []
        for view in range(4):
            record = read_json(whole / "views" / f"{view:06d}.json")["variation"]
            self.assertEqual(record["view"], view)
            random = numpy.random.default_rng((3, view))
            numpy.testing.assert_array_equal(record["place"], random.uniform(-0.4, 0.4, 3))
            found = numpy.load(whole / f"{view:06d}.npz")
            numpy.testing.assert_allclose(found["object_to_world"][1][:3, 3], record["place"],
                                          rtol=1e-12)
            places.append(record["place"])
            # Where rays see the ball at this place.
            vary(view, numpy.random.default_rng((3, view)))
            camera = relievo.Pinhole(found["K"], (40, 30), found["R"], found["t"])
            seen = relievo.layer(relievo.capture(renderer, "actor", camera=camera), "actor")
            self.assertLess((found["object"] - 1 != seen).mean(), 0.01)
            self.assertTrue((seen == 1).any())
        self.assertEqual(numpy.unique(places, axis=0).shape, (4, 3))
        for views in ((2, 4), (0, 2)):
            relievo.write_dataset(renderer, directory=parts, views=views, vary=vary, **words)
        self.assertTrue(same(whole, parts))
        with self.assertRaisesRegex(RuntimeError, "ended by progress at 50%"):
            relievo.write_dataset(renderer, directory=broken, vary=vary,
                                  progress=lambda share: share < 0.3, **words)  # fmt: skip
        self.assertEqual(relievo.write_dataset(renderer, directory=broken, vary=vary, **words), 2)
        self.assertTrue(same(whole, broken))

        # Lights of the scene's own beside random suns.
        def light(_view, random):
            renderer.RemoveAllLights()
            lamp = vtkLight()
            lamp.SetPosition(random.normal(size=3))
            renderer.AddLight(lamp)

        once, twice = self.folder / "once", self.folder / "twice"
        suns = {"renderer": renderer, "cameras": "orbit:2", "size": (40, 30), "format": "npz",
                "random_sun": True, "vary": light}  # fmt: skip
        relievo.write_dataset(directory=once, **suns)
        for views in ((1, 2), (0, 1)):
            relievo.write_dataset(directory=twice, views=views, **suns)
        self.assertTrue(same(once, twice))

        def fail(view, _random):
            if view == 1:
                raise KeyError("mine")

        for kind, words, call, more in (
            (ValueError, "vary: got 3", 3, {}),
            (KeyError, "mine", fail, {}),
            (TypeError, "vary: got", lambda *_: {"actor": actors[0]}, {}),
            (ValueError, "not JSON compliant", lambda *_: {"x": numpy.nan}, {}),
            (ValueError, "view 1: got the objects actor_0, actor_2",
             lambda view, _: actors[1].SetVisibility(view != 1), {}),
            (ValueError, "layer flow: got a scene that varies", vary, {"layers": ["flow"]}),
        ):  # fmt: skip
            with self.subTest(words=words), self.assertRaisesRegex(kind, words):
                relievo.write_dataset(renderer, "random:2", self.folder / words.replace(" ", ""),
                                      "npz", size=(40, 30), vary=call, **more)  # fmt: skip

    def test_refusals(self):
        renderer = heap()
        camera = around()[0]
        relievo.write_dataset(renderer, camera, self.folder / "set")
        for words, says in (
            ({"format": "coco"}, 'was begun with format "bop", now it is "coco"'),
            ({"seed": 3}, "was begun with seed 0, now it is 3"),
            ({"up": "z"}, 'was begun with up_axis "y", now it is "z"'),
            ({"layers": ["depth"]}, "layers"),
            ({"objects": ["a", "b", "c", "d"]}, "objects"),
            ({"description": "another scene"}, 'scene "", now it is "another scene"'),
            ({"format": "png"}, "expected one of bop, coco, nerf, npz"),
            ({"views": (0, 4)}, "got 0:4, expected views from 0 to 1"),
            ({"layers": ["depht"], "directory": self.folder / "other"}, "depht"),
            ({"format": "npz", "layers": ["color"], "directory": self.folder / "own"},
             "layer color: is the name of an array that npz has"),
            ({"cameras": "random:3,nearest=2,farthest=1"}, "nearest is above farthest"),
            ({"cameras": "orbit"}, "got 'orbit', expected orbit:N, random:N or a FILE.json"),
            ({"cameras": "orbit:0"}, "orbit:0, number of views: got '0', expected a whole number"),
            ({"cameras": "orbit:1:0"}, "orbit:1:0, number of views: got '1:0', expected a whole"),
            ({"cameras": "orbit:3,distnace=2"}, "'distnace', expected one of elevation, distance"),
            ({"cameras": "orbit:3,30"}, "'30', expected NAME=VALUE with a NAME of elevation, dist"),
            ({"cameras": "orbit:3,elevation=a"}, "elevation: got 'a', expected .*-90 to 90"),
            ({"views": (1, 0)}, "got 1:0, expected the first view to be before the end"),
            ({"views": (1, 1)}, "got 1:1, expected the first view to be before the end"),
            ({"cameras": "random:3,lowest=100"}, "from -90 to 90"),
            ({"cameras": []}, "no views"),
            ({"cameras": 5}, "cameras: got .*5.*expected CameraModels"),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, says):
                arguments = {"cameras": camera, "directory": self.folder / "set", **words}
                relievo.write_dataset(renderer, **arguments)
        moved = relievo.Pinhole(K, SIZE).look_at((0.5, 1.0, 3.3), (0, -0.1, 0))
        with self.assertRaisesRegex(ValueError, "depth_step|another camera"):
            relievo.write_dataset(renderer, moved, self.folder / "set")
        # Another seed gives other cameras, and other ranges of a depth step.
        words = {"cameras": "random:2", "directory": self.folder / "seeds", "size": SIZE}
        relievo.write_dataset(renderer, **words)
        with self.assertRaisesRegex(ValueError, "was begun with seed 0, now it is 5"):
            relievo.write_dataset(renderer, seed=5, **words)
        poses = self.folder / "poses.json"
        for text, says in (("[]", "has no poses, expected a list"), ("{}", "has no poses"),
                           ("[", "is no JSON, expected a list of poses with R and t")):
            poses.write_text(text)
            with self.assertRaisesRegex(OSError, f"poses.json: {says}"):
                relievo.write_dataset(renderer, poses, self.folder / "none")
        (self.folder / "mine").mkdir()
        (self.folder / "mine" / "thesis.txt").write_text("mine")
        with self.assertRaisesRegex(ValueError, "contains other files, such as thesis.txt"):
            relievo.write_dataset(renderer, camera, self.folder / "mine")
        (self.folder / "file").write_text("mine")
        with self.assertRaisesRegex(OSError, "cannot be made"):
            relievo.write_dataset(renderer, camera, self.folder / "file" / "set")
        # The remains of a refused call are no obstacle.
        relievo.write_dataset(renderer, camera, self.folder / "other")

    def test_damaged_records(self):
        renderer = vtkRenderer()
        add(renderer, plate(0.4))
        cameras = around()
        for name in ("bop", "coco", "nerf", "npz"):
            folder = self.folder / name
            relievo.write_dataset(renderer, cameras, folder, name)
            path = folder / "views" / "000001.json"
            whole = read_json(path)
            damaged = [{}, [], {**whole, "objects": []}, {**whole, "view": 2}]
            for part in ("R", "t", "size"):
                camera = {key: whole["camera"][key] for key in whole["camera"] if key != part}
                damaged.append({**whole, "camera": camera})
            for number in (0, 99):
                damaged.append(json.loads(json.dumps(whole)))
                damaged[-1]["objects"][0]["object"] = number
            for part in ("t", "visible_pixels"):
                damaged.append(json.loads(json.dumps(whole)))
                del damaged[-1]["objects"][0][part]
            for record in damaged:
                path.write_text(json.dumps(record))
                for views in ((0, 3), (2, 3)) if name == "bop" else ((2, 3),):
                    with self.assertRaisesRegex(OSError, r"000001\.json: is no record of view 1"):
                        relievo.write_dataset(renderer, cameras, folder, name, views=views)
            path.unlink()
            self.assertEqual(relievo.write_dataset(renderer, cameras, folder, name), 1)
            self.assertEqual(read_json(path), whole)

    def poses_of(self, poses, **words):
        """The cameras of a file of poses, as records have them."""
        file = self.folder / "poses.json"
        file.write_text(json.dumps(poses))
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        relievo.write_dataset(vtkRenderer(), file, folder, "npz", size=(40, 30), **words)
        return [read_json(each)["camera"] for each in sorted((folder / "views").iterdir())]

    def test_poses_of_files(self):
        matrix = {"transform_matrix": numpy.eye(4).tolist()}
        focal = 15 / numpy.tan(numpy.radians(15))
        both = {"camera_angle_x": 1.2, "camera_angle_y": 0.9, "w": 60, "h": 20, "frames": [matrix]}
        for poses, expected in (
            ({"camera_angle_x": 1.2, "frames": [matrix]}, [20 / numpy.tan(0.6)] * 2 + [19.5, 14.5]),
            (both, [30 / numpy.tan(0.6), 10 / numpy.tan(0.45), 29.5, 9.5]),
            ({"fl_x": 50, "fl_y": 40, "cx": 3, "camera_angle_x": 2, "k1": 0, "frames": [matrix]},
             [50, 40, 2.5, 14.5]),
            # A size alone: as high as 30 degrees, and in the middle.
            ({"w": 80, "h": 60, "frames": [matrix]}, [2 * focal] * 2 + [39.5, 29.5]),
            ([{"R": numpy.eye(3).tolist(), "t": [0, 0, 3], "size": [15, 60]}],
             [2 * focal] * 2 + [7, 29.5]),
        ):  # fmt: skip
            found = numpy.array(self.poses_of(poses)[0]["K"])
            numpy.testing.assert_allclose(found[[0, 4, 2, 5]], expected, rtol=1e-12)
        # Without another definition, up is the scene's axis: z is towards the upper edge.
        aside = [{"position": [3, 1, 0.5], "target": [0, 0, 0]}]
        rotation = numpy.array(self.poses_of(aside, up="z")[0]["R"]).reshape(3, 3)
        self.assertAlmostEqual(rotation[0, 2], 0)
        self.assertLess(rotation[1, 2], -0.9)

    def test_rational_lens_of_a_file(self):
        """OpenCV's eight coefficients, in its order."""
        said = dict(zip(("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"),
                        (-0.2, 0.03, 0.002, 0.001, 0.004, 0.05, 0.01, 0.002)))  # fmt: skip
        matrix = {"transform_matrix": numpy.eye(4).tolist()}
        (camera,) = self.poses_of({"camera_model": "FULL_OPENCV", **said, "frames": [matrix]})
        self.assertEqual(camera["distortion"], list(said.values()))

    def test_poses_that_are_refused(self):
        matrix = {"transform_matrix": numpy.eye(4).tolist()}
        pose = {"R": numpy.eye(3).tolist(), "t": [0, 0, 3]}
        for poses, says in (
            ([{"R": [1, 0, 0], "t": [0, 0, 0]}], "pose 0, R: expected 9 numbers"),
            ([pose, {**pose, "K": [50, 0, 0, 0, 50, 0, 20, 15, 1]}], "pose 1, K: expected 9 numb"),
            ([{**pose, "K": [50, 0, 20, 0, 50, 15, 0, 0, 2]}], "pose 0, K: .* row by row"),
            ([{**pose, "size": [100.7, 30]}], "pose 0, size: expected whole numbers"),
            ([{**pose, "size": [1e12, 30]}], "pose 0, size: expected whole numbers"),
            ({"k4": 0.1, "frames": [matrix]}, "pose 0, k4: got 0.1, expected 0: .*k2, p1, p2, k3"),
            ({"is_fisheye": True, "frames": [matrix, {**matrix, "p1": 0.1}]},
             "pose 1, p1: got 0.1, expected 0: .*k1, k2, k3, k4"),
            ({"is_fisheye": 1, "frames": [matrix]}, "pose 0, is_fisheye: got 1, expected true or"),
            ({"is_fisheye": "true", "frames": [matrix]}, 'is_fisheye: got "true", expected true'),
            ({"camera_model": "FISHEYE624", "frames": [matrix]},
             'pose 0, camera_model: got "FISHEYE624", expected one of PINHOLE'),
            ({"camera_angle_x": 4, "frames": [matrix]}, "camera_angle_x: expected radians"),
            ({"w": 40, "frames": [matrix]}, "expected both w and h"),
        ):  # fmt: skip
            with self.subTest(says), self.assertRaisesRegex(ValueError, says):
                self.poses_of(poses)

    def test_from_above(self):
        """Places on a circle above the objects are as many views."""
        relievo.write_dataset(heap(), "orbit:4,elevation=90", self.folder, "npz", size=(40, 30))
        turns = [numpy.load(self.folder / f"00000{i}.npz")["R"] for i in range(4)]
        for one, other in zip(turns, turns[1:]):
            turn = one @ other.T
            numpy.testing.assert_allclose(turn[2], (0, 0, 1), atol=1e-9)
            self.assertAlmostEqual(abs(turn[0, 1]), 1)

    def test_assembly(self):
        """Its parts are where the assembly puts them."""
        loose = vtkRenderer()
        ball = add(loose, sphere())
        assembly = vtkAssembly()
        assembly.AddPart(ball)
        assembly.SetPosition(0.3, 0, -20)
        renderer = vtkRenderer()
        renderer.AddViewProp(assembly)
        camera = relievo.Pinhole(K, SIZE, numpy.diag([1.0, -1, -1]), (0, 0, 3))
        relievo.write_dataset(renderer, camera, self.folder / "bop", mm_per_unit=1)
        pose = read_json(self.folder / "bop" / "scene_gt.json")["0"][0]
        numpy.testing.assert_allclose(pose["cam_t_m2c"], (0.3, 0, 23), atol=1e-12)
        step = read_json(self.folder / "bop" / "scene_camera.json")["0"]["depth_scale"]
        depth = read_png(self.folder / "bop" / "depth" / "000000.png")
        self.assertAlmostEqual(depth[depth > 0].min() * step, 22.5, delta=0.1)
        mask = read_png(self.folder / "bop" / "mask" / "000000_000000.png") > 0
        numpy.testing.assert_array_equal(depth > 0, mask)
        relievo.write_dataset(renderer, "orbit:1,elevation=0", self.folder / "npz", "npz")
        found = numpy.load(self.folder / "npz" / "000000.npz")
        numpy.testing.assert_array_equal(found["object_to_world"][0][:3, 3], (0.3, 0, -20))
        self.assertGreater(found["visible_masks"].sum(), 10000)
        self.assertEqual(renderer.GetLights().GetNumberOfItems(), 0)  # as before

    def test_mirrored(self):
        """The pose is a turn: the mirror belongs to the model, as scales do."""
        renderer = vtkRenderer()
        actor = add(renderer, sphere(), (0.2, 0.1, 0), 40)
        actor.SetScale(-1, 1, 1)
        camera = around()[0]
        relievo.write_dataset(renderer, camera, self.folder, mm_per_unit=1)
        pose = read_json(self.folder / "scene_gt.json")["0"][0]
        rotation = numpy.array(pose["cam_R_m2c"]).reshape(3, 3)
        self.assertAlmostEqual(numpy.linalg.det(rotation), 1)
        model = rotation.T @ camera.R @ matrix_of(actor)[:3, :3]
        numpy.testing.assert_allclose(model, -numpy.eye(3), atol=1e-12)

    def test_beyond_the_picture(self):
        """BOP counts pixels beyond the picture, also for objects and parts out of view."""
        renderer = vtkRenderer()
        camera = relievo.Pinhole(K, SIZE, numpy.diag([1.0, -1, -1]), (0, 0, 3))
        places = [(0, 0, 0), (3, 0, 0), (2.5, 0.3, 0), (0, 0, 9)]
        actors = [add(renderer, vtkCubeSource(), place, 40, 0.4) for place in places]
        names = ["parts", "parts", "unseen", "behind"]
        relievo.write_dataset(renderer, camera, self.folder, objects=names)
        infos = read_json(self.folder / "scene_gt_info.json")["0"]
        for info, which in zip(infos, ([0, 1], [2], [3])):
            corners = numpy.concatenate([triangles(actors[i]) for i in which])
            depths, near = trace(camera, corners, 1)
            every = numpy.isfinite(depths)
            self.assertEqual(every.any(), which != [3])
            self.assertLessEqual(abs(info["px_count_all"] - every.sum()), near.sum())
            if every.any():
                numpy.testing.assert_allclose(
                    info["bbox_obj"], numpy.array(box_of(every)) - [*SIZE, 0, 0], atol=1
                )
        self.assertEqual([info["px_count_visib"] > 0 for info in infos], [True, False, False])

    def test_surface_that_leaves_its_box(self):
        """A shader moves a plate in front of another, whose full mask stays whole."""
        renderer = vtkRenderer()
        camera = relievo.Pinhole(K, SIZE, numpy.diag([1.0, -1, -1]), (0, 0, 3))
        moved = add(renderer, plate(0.3), (0.9, 0, 0.5))
        moved.GetShaderProperty().AddVertexShaderReplacement(
            "//VTK::PositionVC::Impl", True,
            "//VTK::PositionVC::Impl\n  gl_Position.x -= 0.67 * gl_Position.w;\n", False,
        )  # fmt: skip
        behind = add(renderer, plate(0.3))
        relievo.write_dataset(renderer, camera, self.folder, "npz")
        found = numpy.load(self.folder / "000000.npz")
        truth = Truth(camera, [behind])
        full = numpy.isfinite(truth.depths[0])
        self.assertFalse(((found["amodal_masks"][1] != full) & ~truth.near).any())
        self.assertLess(found["visible_masks"][1].sum(), 0.2 * full.sum())

    def test_names_of_any_bytes(self):
        """Invalid Unicode is replaced, and the views are not lost."""
        renderer = heap()
        writer = relievo.vtkRelievoDatasetWriter()
        writer.SetRenderer(renderer)
        writer.SetDirectory(str(self.folder / "set"))
        writer.SetFormat(1)
        writer.AddView(around()[0].model)
        writer.SetObjectName(0, b"floor\xff")
        self.assertTrue(writer.Write(), writer.GetFailureText())
        index = read_json(self.folder / "set" / "instances.json")
        self.assertEqual(index["categories"][0]["name"], "floor\ufffd")

    def test_lights_are_given_back(self):
        """The sun of one scene turns; one without gets another."""
        from vtkmodules.vtkRenderingCore import vtkLight

        matrix = vtkMatrix4x4()
        matrix.SetElement(1, 3, 5)
        pictures = []
        for own in (False, True):
            renderer = heap()
            if own:
                light = vtkLight()
                light.SetLightTypeToSceneLight()
                light.SetPosition(1, 2, 3)
                light.SetTransformMatrix(matrix)
                renderer.AddLight(light)
            folder = self.folder / str(own)
            relievo.write_dataset(renderer, "orbit:2", folder, size=(20, 20), random_sun=True)
            sun = read_json(folder / "views" / "000001.json")["sun"]
            self.assertAlmostEqual(numpy.linalg.norm(sun), 1)
            self.assertGreater(sun[1], numpy.sin(numpy.radians(14.9)))
            pictures.append(read_png(folder / "rgb" / "000001.png"))
            lights = renderer.GetLights()
            self.assertEqual(lights.GetNumberOfItems(), int(own))
            if own:
                self.assertEqual(light.GetPosition(), (1, 2, 3))
                self.assertIs(light.GetTransformMatrix(), matrix)
        numpy.testing.assert_array_equal(*pictures)  # whatever the light's matrix


if __name__ == "__main__":
    unittest.main()
