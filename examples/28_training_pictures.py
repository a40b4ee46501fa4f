# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Training data for pose estimation: bodies on a table, seen from anywhere, in BOP's format.

    28_training_pictures.py [FOLDER]

Default: the current folder. Writes to FOLDER
    train       a scene of BOP: rgb, depth, mask, mask_visib, scene_gt.json, ...
    train.png   its views: the picture, the depth, and the visible part and outline of each body

A seed determines the bodies, the cameras and the sun: equal seeds give equal bytes. The table
occludes but is not an object.
Needs armadillo.off, bunny.off and elephant.off in the folder RELIEVO_DATA (default: build/data
beside this folder); tools/unpack-data puts them there.
"""

import json
import time

import numpy
import relievo
from relievo.vtk.util.numpy_support import vtk_to_numpy
from relievo.vtk.vtkFiltersCore import vtkPolyDataNormals
from relievo.vtk.vtkFiltersSources import vtkPlaneSource
from relievo.vtk.vtkIOImage import vtkPNGReader
from relievo.vtk.vtkRenderingCore import vtkActor, vtkPolyDataMapper

import demo_sheet
import scene

SEED = 5
VIEWS = 3
SIZE = (320, 240)
TABLE = 0.6  # half its width, in metres
LENGTH, APART = 0.16, 0.09  # of the bodies
BODIES = {"armadillo": (0.45, 0.62, 0.36), "bunny": (0.85, 0.78, 0.66),
          "elephant": (0.42, 0.55, 0.72)}  # fmt: skip
SHADES = numpy.array(
    [(228, 26, 28), (55, 126, 184), (77, 175, 74), (255, 200, 40), (152, 78, 163), (255, 127, 0)]
)


def body(name, random):
    """A body lying on the table near the middle, on a random side."""
    reader = relievo.vtkRelievoOFFReader()
    reader.SetFileName(scene.data(f"{name}.off"))
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(reader.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*BODIES[name])
    actor.SetOrigin(normals.GetOutput().GetCenter())
    actor.RotateWXYZ(random.uniform(0, 360), *random.normal(size=3))
    actor.SetScale(LENGTH / normals.GetOutput().GetLength())
    points = vtk_to_numpy(normals.GetOutput().GetPoints().GetData())
    height = numpy.array([actor.GetMatrix().GetElement(1, j) for j in range(4)])
    x, _, z = actor.GetCenter()
    actor.AddPosition(-x, -(points @ height[:3] + height[3]).min(), -z)
    return actor


def scatter(bodies, random):
    """Moves bodies apart; they may still occlude each other."""
    places = []
    while len(places) < len(bodies):
        place = random.uniform(-0.14, 0.14, 2)
        if all(numpy.linalg.norm(place - other) > APART for other in places):
            bodies[len(places)].AddPosition(place[0], 0, place[1])
            places.append(place)


def heap():
    random = numpy.random.default_rng(SEED)
    table = vtkPlaneSource()
    table.SetOrigin(-TABLE, 0, -TABLE)
    table.SetPoint1(-TABLE, 0, TABLE)
    table.SetPoint2(TABLE, 0, -TABLE)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(table.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.62, 0.52, 0.42)
    names = [name for name in BODIES for _ in range(2)]
    bodies = [body(name, random) for name in names]
    scatter(bodies, random)
    renderer, window = scene.room([actor, *bodies], SIZE, (1, 2, 1), (0.2, 0.22, 0.25))
    window.SetMultiSamples(8)
    return renderer, window, [None, *(f"{name}_{i}" for i, name in enumerate(names))]


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return relievo.from_image(reader.GetOutput()).astype(float)


def row(folder, view, infos):
    """The picture, the depth, the visible masks, and the full outlines of the bodies."""
    picture = read(folder / "rgb" / f"{view:06d}.png")
    depth = read(folder / "depth" / f"{view:06d}.png")
    near, far = depth[depth > 0].min(), depth.max()
    grey = numpy.where(depth > 0, 255 - 205 * (depth - near) / (far - near), 0)
    seen, whole = 0.35 * picture, picture.copy()
    for i, info in enumerate(infos):
        name, shade = f"{view:06d}_{i:06d}.png", SHADES[i]
        mask = read(folder / "mask_visib" / name) > 0
        seen[mask] = 0.35 * picture[mask] + 0.65 * shade
        if info["px_count_visib"] == 0:
            continue
        mask = read(folder / "mask" / name) > 0
        inside = mask.copy()
        inside[1:-1, 1:-1] &= mask[:-2, 1:-1] & mask[2:, 1:-1] & mask[1:-1, :-2] & mask[1:-1, 2:]
        whole[mask & ~inside] = shade
    grey = numpy.repeat(grey[..., None], 3, axis=2)
    return numpy.concatenate([picture, grey, seen, whole], axis=1)


def main():
    folder = scene.folder()
    renderer, window, names = heap()
    start = time.perf_counter()
    written = relievo.write_dataset(
        renderer, f"random:{VIEWS},lowest=25,highest=60,nearest=0.6,farthest=0.8", folder / "train",
        size=SIZE, objects=names, seed=SEED, random_sun=True,
    )  # fmt: skip
    print(f"{written} views of {len(names) - 1} bodies in {time.perf_counter() - start:.1f} s")
    infos = json.loads((folder / "train" / "scene_gt_info.json").read_text())
    share = [info["visib_fract"] for view in infos.values() for info in view]
    print(f"of a body between {min(share):.0%} and {max(share):.0%} is seen")
    sheet = numpy.concatenate(
        [row(folder / "train", view, infos[str(view)]) for view in range(VIEWS)]
    )
    demo_sheet.write_png(folder / "train.png", sheet.astype(numpy.uint8))
    print(f"wrote {folder / 'train'} and {folder / 'train.png'}")
    del window


if __name__ == "__main__":
    main()
