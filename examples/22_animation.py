# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A model with bones, moved by the graphics card, with its shadow; and its bone weights.

    22_animation.py [FOLDER]    writes FOLDER/animation.png

The meshes are read at rest and sent to the graphics card once. For each time, only the skeleton is
updated, and the vertex shader moves the meshes (vtkRelievoSkinnedActor). The last two pictures
show each point's first bone, and the weights of one bone (vtkRelievoBoneWeights).

Needs models/X/BCN_Epileptic.X in the folder RELIEVO_DATA (default: build/data beside this folder);
tools/unpack-data puts it there.
"""

import numpy
import relievo
from relievo.vtk.vtkCommonCore import vtkLookupTable
from relievo.vtk.vtkFiltersSources import vtkPlaneSource
from relievo.vtk.vtkRenderingCore import vtkActor, vtkPolyDataMapper

import demo_sheet
import scene

SIZE = (330, 400)
TIMES = (0.0, 0.6, 1.2, 1.9, 2.6, 3.2)
BONE = 12  # the bone to show: a point of the skeleton


def hues():
    """Colours for numbers of bones: consecutive numbers get very different hues."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, (red, green, blue) in enumerate(demo_sheet.hashed(numpy.arange(256)) / 255.0):
        table.SetTableValue(i, red, green, blue, 1)
    table.SetTableRange(0, 255)
    return table


def shades():
    """From grey to orange."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        share = i / 255
        table.SetTableValue(i, 0.45 + 0.55 * share, 0.45 - 0.05 * share, 0.5 - 0.45 * share, 1)
    table.SetTableRange(0, 1)
    return table


def skinned(reader):
    """An actor for each mesh of the reader; all follow its skeleton."""
    actors = []
    meshes = reader.GetOutput()
    for i in range(meshes.GetNumberOfBlocks()):
        bones = relievo.vtkRelievoBoneWeights()
        bones.SetInputDataObject(0, meshes.GetBlock(i))
        bones.SetBone(BONE)
        actor = relievo.vtkRelievoSkinnedActor()
        actor.SetInputConnection(bones.GetOutputPort())
        actor.SetSkeletonConnection(reader.GetOutputPort(1))
        actor.SetMethod(relievo.vtkRelievoSkin.DUAL_QUATERNION)
        actor.GetPolyDataMapper().ScalarVisibilityOff()
        actor.GetProperty().SetColor(0.78, 0.62, 0.5)
        actors.append(actor)
    return actors


def color_by(actors, name, table):
    for actor in actors:
        mapper = actor.GetPolyDataMapper()
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(name)
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        mapper.ScalarVisibilityOn()


def floor(renderer, bounds):
    """Under the model, twelve times as wide."""
    x, z = 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[4] + bounds[5])
    half = 6 * (bounds[3] - bounds[2])
    plane = vtkPlaneSource()
    plane.SetOrigin(x - half, bounds[2], z + half)
    plane.SetPoint1(x + half, bounds[2], z + half)
    plane.SetPoint2(x - half, bounds[2], z - half)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.55, 0.58, 0.6)
    renderer.AddActor(actor)


def main():
    folder = scene.folder()
    reader = relievo.vtkRelievoModelReader()
    reader.SetFileName(scene.data("models/X/BCN_Epileptic.X"))
    reader.SetPose(relievo.vtkRelievoModelReader.POSE_REST)
    reader.Update()
    actors = skinned(reader)
    renderer, window = scene.room(actors, SIZE, (-2, 3, 2.5), (0.16, 0.18, 0.21))
    bounds = renderer.ComputeVisiblePropBounds()
    size = bounds[3] - bounds[2]
    middle = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    floor(renderer, bounds)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(middle[0] + 0.1 * size, middle[1] + 0.05 * size, middle[2])
    camera.SetPosition(middle[0] + 0.4 * size, middle[1] + 0.8 * size, middle[2] + 3.2 * size)

    tiles = []
    for time in TIMES:
        reader.UpdateTimeStep(time)
        tiles.append((f"{time:.1f} s", "moved in the vertex shader", scene.picture(renderer)))
    color_by(actors, "first_bone", hues())
    tiles.append(("first bone", "of each point", scene.picture(renderer)))
    color_by(actors, "bone_weight", shades())
    names = reader.GetOutputDataObject(1).GetPointData().GetAbstractArray("name")
    tiles.append(("weights", f"of {names.GetValue(BONE)}", scene.picture(renderer)))
    title = "One mesh on the graphics card, moved by its bones"
    sheet = demo_sheet.contact_sheet(tiles, 4, SIZE[0], title)
    demo_sheet.write_png(folder / "animation.png", sheet)
    print(folder / "animation.png")


if __name__ == "__main__":
    main()
