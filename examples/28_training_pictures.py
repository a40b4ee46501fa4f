# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Training data for pose estimation: ten mugs on a table, in BOP's format.

    28_training_pictures.py [FOLDER]

Default: the current folder. Writes to FOLDER
    train       a scene of BOP: rgb, depth, mask, mask_visib, scene_gt.json, ...
    train.png   its views: the picture, the depth, and the visible part and outline of each mug

Each view has its own scene, chosen by the seed and the view's number: where the mugs and the blocks
between them rest, their colours, the sun. Equal seeds give equal bytes. Table and blocks hide mugs
but are no objects.
"""

import colorsys
import json
import time

import numpy
import relievo
from relievo.vtk.vtkCommonCore import vtkPoints
from relievo.vtk.vtkCommonDataModel import vtkCellArray, vtkPolyData
from relievo.vtk.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals, vtkTubeFilter
from relievo.vtk.vtkFiltersModeling import vtkRotationalExtrusionFilter
from relievo.vtk.vtkFiltersSources import vtkCubeSource, vtkPlaneSource
from relievo.vtk.vtkIOImage import vtkPNGReader
from relievo.vtk.vtkRenderingCore import vtkActor, vtkPolyDataMapper

import demo_sheet
import scene

SEED = 5
VIEWS = 3
SIZE = (320, 240)
TABLE = 0.6  # half its width, in metres
AREA = ((-0.24, 0.24), (-0.24, 0.24))  # of the mugs and blocks
MUGS, BLOCKS = 10, 3
SHADES = numpy.array(
    [[255 * each for each in colorsys.hsv_to_rgb(i / MUGS, 0.8, 0.95)] for i in range(MUGS)]
)


def line(points):
    """A line through points, n x 3."""
    made, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    cells.InsertNextCell(len(points))
    for point in points:
        cells.InsertCellPoint(places.InsertNextPoint(point))
    made.SetPoints(places)
    made.SetLines(cells)
    return made


def mug():
    """A mug of 8 x 10 cm with its handle, open upwards along z."""
    # The profile of the wall, from the middle of the bottom out, up, over the rim and back.
    profile = [(0, 0), (0.034, 0), (0.038, 0.004), (0.04, 0.02), (0.04, 0.097), (0.0385, 0.1),
               (0.037, 0.097), (0.037, 0.012), (0.032, 0.006), (0, 0.006)]  # fmt: skip
    wall = vtkRotationalExtrusionFilter()
    wall.SetInputData(line([(x, 0, z) for x, z in profile]))
    wall.SetResolution(48)
    wall.CappingOff()
    angles = numpy.linspace(-0.5 * numpy.pi, 0.5 * numpy.pi, 17)
    handle = vtkTubeFilter()
    handle.SetInputData(line([
        (0.0385 + 0.028 * numpy.cos(angle), 0, 0.052 + 0.032 * numpy.sin(angle))
        for angle in angles
    ]))  # fmt: skip
    handle.SetRadius(0.005)
    handle.SetNumberOfSides(12)
    handle.CappingOn()
    both = vtkAppendPolyData()
    both.AddInputConnection(wall.GetOutputPort())
    both.AddInputConnection(handle.GetOutputPort())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(both.GetOutputPort())
    normals.SetFeatureAngle(50)
    normals.AutoOrientNormalsOff()
    normals.Update()
    return normals.GetOutput()


def actor_of(mesh, colour=(1, 1, 1)):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetSpecular(0.3)
    actor.GetProperty().SetSpecularPower(40)
    return actor


def block(length, width, height):
    source = vtkCubeSource()
    source.SetXLength(length)
    source.SetYLength(width)
    source.SetZLength(height)
    source.Update()
    return source.GetOutput()


def make_table():
    """The scene, its window, the names of its objects, and the function that varies it."""
    table = vtkPlaneSource()
    table.SetOrigin(-TABLE, 0, -TABLE)
    table.SetPoint1(-TABLE, 0, TABLE)
    table.SetPoint2(TABLE, 0, -TABLE)
    table.Update()
    shape = mug()
    mugs = [actor_of(shape) for _ in range(MUGS)]
    blocks = [actor_of(block(0.1, 0.06, 0.03), (0.35, 0.33, 0.3)) for _ in range(BLOCKS)]
    plane = actor_of(table.GetOutput())
    renderer, window = scene.room([plane, *blocks, *mugs], SIZE, (1, 2, 1), (0.74, 0.79, 0.84))
    window.SetMultiSamples(8)

    def vary(_view, random):
        places = relievo.scatter([*mugs, *blocks], random, AREA)
        colours = [colorsys.hsv_to_rgb(*each) for each in
                   random.uniform((0, 0.1, 0.6), (1, 0.7, 1), (MUGS, 3))]  # fmt: skip
        for each, colour in zip(mugs, colours):
            each.GetProperty().SetColor(*colour)
        wood = colorsys.hsv_to_rgb(*random.uniform((0.06, 0.1, 0.55), (0.12, 0.4, 0.8)))
        plane.GetProperty().SetColor(*wood)
        return {"colours": colours, "table": wood, "blocks": places[MUGS:]}

    names = [None] * (1 + BLOCKS) + [f"mug_{i}" for i in range(MUGS)]
    return renderer, window, names, vary


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return relievo.from_image(reader.GetOutput()).astype(float)


def row(folder, view, infos):
    """The picture, the depth, the visible masks, and the full outlines of the mugs."""
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
    renderer, window, names, vary = make_table()
    start = time.perf_counter()
    written = relievo.write_dataset(
        renderer, f"random:{VIEWS},lowest=25,highest=60,nearest=0.6,farthest=0.8", folder / "train",
        size=SIZE, objects=names, seed=SEED, random_sun=True, vary=vary,
    )  # fmt: skip
    print(f"{written} views of {MUGS} mugs in {time.perf_counter() - start:.1f} s")
    infos = json.loads((folder / "train" / "scene_gt_info.json").read_text())
    share = [info["visib_fract"] for view in infos.values() for info in view]
    print(f"of a mug between {min(share):.0%} and {max(share):.0%} is seen")
    sheet = numpy.concatenate(
        [row(folder / "train", view, infos[str(view)]) for view in range(VIEWS)]
    )
    demo_sheet.write_png(folder / "train.png", sheet.astype(numpy.uint8))
    print(f"wrote {folder / 'train'} and {folder / 'train.png'}")
    del window


if __name__ == "__main__":
    main()
