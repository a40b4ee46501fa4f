# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's scene: OpenFOAM's motorBike and CGAL's bunny in a photographer's studio."""

import math

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from relievo.vtk.vtkCommonCore import vtkPoints, vtkVersion
from relievo.vtk.vtkCommonDataModel import (
    vtkCellArray,
    vtkCompositeDataSet,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
)
from relievo.vtk.vtkCommonTransforms import vtkTransform
from relievo.vtk.vtkFiltersCore import vtkCleanPolyData, vtkElevationFilter, vtkPolyDataNormals
from relievo.vtk.vtkFiltersGeneral import vtkTransformFilter
from relievo.vtk.vtkIOGeometry import vtkOBJReader
from relievo.vtk.vtkRenderingCore import (
    vtkActor,
    vtkCompositeDataDisplayAttributes,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkTexture,
)

# VTK 9.3 extended the one to replace the other, which was removed later.
if vtkVersion().GetVTKMinorVersion() >= 3:
    from relievo.vtk.vtkRenderingCore import vtkCompositePolyDataMapper as CompositeMapper
else:
    from relievo.vtk.vtkRenderingOpenGL2 import (  # type: ignore[attr-defined,no-redef]
        vtkCompositePolyDataMapper2 as CompositeMapper,
    )

# The bike's materials: colour, metallic, roughness, and the beginnings of parts' names; the first
# match counts. The three painted ones are the blocks of one actor.
MATERIALS = {
    "paint": ((0.55, 0.015, 0.02), 0.1, 0.25, ("frt-fairing", "fuel-tank", "fr-mud-guard")),
    "second paint": ((0.78, 0.76, 0.72), 0.1, 0.25, ("rear-body", "rear-mud-guard",
                                                   "fairing-inner")),
    "helmet": ((0.85, 0.45, 0.04), 0.1, 0.25, ("rider-helmet",)),
    "rubber": ((0.025, 0.025, 0.028), 0.0, 0.7, ("fr-wh-tyre", "rr-wh-tyre", "driversseat",
                                               "rearseat", "footpeg", "water-pipe")),
    "steel": ((0.75, 0.75, 0.76), 1.0, 0.28, ("exhaust", "fr-forks", "fr-wh-brake-disk",
                                            "rear-susp", "rear-shock", "chain")),
    "gold": ((0.72, 0.52, 0.20), 1.0, 0.35, ("fr-wh-rim", "rr-wh-rim", "rr-wh-chain-hub")),
    "glass": ((0.02, 0.03, 0.04), 0.3, 0.08, ("windshield", "headlights", "rider-visor",
                                            "square-dial", "round-dial", "rear-brake-lights")),
    "leather": ((0.03, 0.035, 0.07), 0.0, 0.45, ("rider-body", "rider-boots", "rider-gloves")),
    "cast": ((0.20, 0.20, 0.21), 0.8, 0.45, ("",)),
}  # fmt: skip
PAINTED = ("paint", "second paint", "helmet")


def material_of(part):
    """The name of the material of the bike's part of that name."""
    return next(
        material
        for material, (_, _, _, starts) in MATERIALS.items()
        if any(part.startswith(start) for start in starts)
    )


def read_bike(path):
    """The bike as {material: vtkPolyData}, y up, 2 long, on y = 0, with the cell array `part`."""
    with open(path, encoding="ascii") as file:
        parts = [line[2:].split("%")[0] for line in file if line.startswith("g ")]
    reader = vtkOBJReader()
    reader.SetFileName(path)
    reader.Update()
    mesh = stand(reader.GetOutput(), 2.0, z_up=True)
    group = vtk_to_numpy(mesh.GetCellData().GetArray("GroupIds")).astype(int)
    first = group.min()
    kinds = numpy.array([list(MATERIALS).index(material_of(part)) for part in parts])
    # Parts called shadow coincide with others and would flicker.
    kinds[["shadow" in part for part in parts]] = -1
    kinds = kinds[group - first]
    pieces = {}
    for index, material in enumerate(MATERIALS):
        ids = numpy.nonzero(kinds == index)[0]
        if len(ids):
            pieces[material] = some_cells(mesh, ids)
    return pieces


def read_bunny(path):
    """The bunny, y up, 0.9 high or long, with the array `height` (0 to 1), on y = 0."""
    reader = relievo.vtkRelievoOFFReader()
    reader.SetFileName(path)
    reader.Update()
    mesh = stand(reader.GetOutput(), 0.95, z_up=False)
    low, high = mesh.GetBounds()[2:4]
    height = vtkElevationFilter()
    height.SetInputData(mesh)
    height.SetLowPoint(0, low, 0)
    height.SetHighPoint(0, high, 0)
    height.Update()
    mesh = height.GetOutput()
    mesh.GetPointData().GetArray("Elevation").SetName("height")
    return mesh


def some_cells(mesh, ids):
    """The polygons of a mesh that have these ids, with the points that they use."""
    whole = mesh.GetPolys()
    offsets = vtk_to_numpy(whole.GetOffsetsArray())
    points = vtk_to_numpy(whole.GetConnectivityArray())
    sizes = (offsets[1:] - offsets[:-1])[ids]
    starts = numpy.concatenate(([0], numpy.cumsum(sizes)))
    places = numpy.repeat(offsets[ids] - starts[:-1], sizes) + numpy.arange(starts[-1])
    used, renumbered = numpy.unique(points[places], return_inverse=True)
    piece = vtkPolyData()
    piece.SetPoints(vtkPoints())
    whole_points = vtk_to_numpy(mesh.GetPoints().GetData())
    piece.GetPoints().SetData(numpy_to_vtk(whole_points[used], deep=True))
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtk(starts, deep=True, array_type=12),
                  numpy_to_vtk(renumbered, deep=True, array_type=12))  # fmt: skip
    piece.SetPolys(cells)
    piece.GetCellData().AddArray(group_of(mesh, ids))
    return piece


def group_of(mesh, ids):
    values = vtk_to_numpy(mesh.GetCellData().GetArray("GroupIds"))[ids]
    array = numpy_to_vtk(values, deep=True)
    array.SetName("part")
    return array


def stand(mesh, length, z_up):
    """The mesh turned to y up, its longest side made `length`, centred, standing on y = 0."""
    turn = vtkTransform()
    if z_up:
        turn.RotateX(-90)
    turned = transformed(mesh, turn)
    x0, x1, y0, y1, z0, z1 = turned.GetBounds()
    scale = length / max(x1 - x0, y1 - y0, z1 - z0)
    place = vtkTransform()
    place.Scale(scale, scale, scale)
    place.Translate(-(x0 + x1) / 2, -y0, -(z0 + z1) / 2)
    return transformed(turned, place)


def transformed(mesh, transform):
    move = vtkTransformFilter()
    move.SetTransform(transform)
    move.SetInputData(mesh)
    move.Update()
    return move.GetOutput()


def smooth(mesh, angle=40):
    """The mesh with point normals, split at edges sharper than `angle` degrees."""
    clean = vtkCleanPolyData()
    clean.SetInputData(mesh)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(clean.GetOutputPort())
    normals.SetFeatureAngle(angle)
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def cove():
    """A studio's floor that bends up into a wall behind, without a horizon."""
    profile = [(9.0, 0.0), (0.0, 0.0), (-2.6, 0.0)]
    for step in range(1, 25):
        angle = math.radians(90 * step / 24)
        profile.append((-2.6 - 2.2 * math.sin(angle), 2.2 - 2.2 * math.cos(angle)))
    profile.append((-4.8, 9.0))
    points, polys = vtkPoints(), vtkCellArray()
    for z, y in profile:
        points.InsertNextPoint(-14, y, z)
        points.InsertNextPoint(14, y, z)
    for i in range(len(profile) - 1):
        polys.InsertNextCell(4, [2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2])
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(polys)
    return smooth(mesh, 60)


def softboxes(rows=256):
    """The studio's lamps and walls seen from its middle, as an equirectangular texture."""
    columns = 2 * rows
    latitude = (numpy.arange(rows) + 0.5) / rows * math.pi - math.pi / 2
    longitude = (numpy.arange(columns) + 0.5) / columns * 2 * math.pi - math.pi
    up = numpy.sin(latitude)[:, None]
    light = numpy.empty((rows, columns, 3), numpy.float32)
    wall = 0.05 + 0.04 * up
    light[:] = (wall * numpy.ones((1, columns)))[..., None] * (0.95, 0.97, 1.0)
    for where, wide, low, high, colour in (
        (-2.1, 0.75, 0.25, 0.95, (2.0, 1.9, 1.75)),
        (0.9, 0.55, 0.1, 0.8, (0.8, 0.9, 1.05)),
        (2.6, 0.2, -0.1, 0.9, (1.8, 1.8, 1.8)),
    ):
        across = numpy.abs((longitude - where + math.pi) % (2 * math.pi) - math.pi)
        inside = (across[None, :] < wide) & (latitude[:, None] > low) & (latitude[:, None] < high)
        light[inside] = colour
    light[latitude > 1.2] = (0.6, 0.6, 0.6)
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(light.reshape(-1, 3), deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.SetColorModeToDirectScalars()
    texture.MipmapOn()
    texture.InterpolateOn()
    return texture


def set_material(thing, colour, metallic, roughness):
    look = thing.GetProperty()
    look.SetInterpolationToPBR()
    look.SetColor(*colour)
    look.SetMetallic(metallic)
    look.SetRoughness(roughness)


def actor(mesh, colour, metallic, roughness, place=None):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    thing = vtkActor()
    thing.SetMapper(mapper)
    set_material(thing, colour, metallic, roughness)
    if place is not None:
        thing.SetUserTransform(place)
    return thing


def blocks_actor(pieces, place):
    """One actor of several meshes, each a block with its own colour. pieces: {name: mesh}."""
    blocks = vtkMultiBlockDataSet()
    colours = vtkCompositeDataDisplayAttributes()
    for index, (name, mesh) in enumerate(pieces.items()):
        blocks.SetBlock(index, mesh)
        blocks.GetMetaData(index).Set(vtkCompositeDataSet.NAME(), name)
        colours.SetBlockColor(mesh, MATERIALS[name][0])
    mapper = CompositeMapper()
    mapper.SetCompositeDataDisplayAttributes(colours)
    mapper.SetInputDataObject(blocks)
    mapper.ScalarVisibilityOff()
    thing = vtkActor()
    thing.SetMapper(mapper)
    set_material(thing, *MATERIALS[next(iter(pieces))][:3])
    thing.SetUserTransform(place)
    return thing


def lamp(position, focus, intensity, colour=(1, 1, 1)):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(*position)
    light.SetFocalPoint(*focus)
    light.SetColor(*colour)
    light.SetIntensity(intensity)
    return light


def make_renderer(bike, bunny):
    """The studio, lit, with the camera in place. bike: of read_bike(); bunny: of read_bunny()."""
    renderer = vtkRenderer()
    renderer.AddActor(actor(cove(), (0.42, 0.43, 0.46), 0.0, 0.75))
    turn = vtkTransform()
    turn.Translate(0.30, 0, -0.15)
    turn.RotateY(24)
    bike = {material: smooth(piece) for material, piece in bike.items()}
    renderer.AddActor(blocks_actor({name: bike[name] for name in PAINTED}, turn))
    for material, piece in bike.items():
        if material not in PAINTED:
            colour, metallic, roughness = MATERIALS[material][:3]
            renderer.AddActor(actor(piece, colour, metallic, roughness, turn))
    sit = vtkTransform()
    sit.Translate(-1.02, 0, 0.42)
    sit.RotateY(32)
    sit.Scale(0.9, 0.9, 0.9)
    renderer.AddActor(actor(smooth(bunny, 180), (0.62, 0.50, 0.38), 0.0, 0.42, sit))

    renderer.SetEnvironmentTexture(softboxes(), False)
    renderer.UseImageBasedLightingOn()
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(lamp((-5, 4.2, 0.9), (0, 0.3, 0), 4.0, (1.0, 0.95, 0.88)))
    renderer.AddLight(lamp((5, 3, 1), (0, 0.3, 0), 0.25, (0.80, 0.90, 1.0)))

    renderer.UseSSAOOn()
    renderer.SetSSAORadius(0.35)
    renderer.SetSSAOBias(0.006)
    renderer.SetSSAOKernelSize(64)
    renderer.SSAOBlurOn()

    camera = renderer.GetActiveCamera()
    camera.SetPosition(-1.07, 1.18, 4.3)
    camera.SetFocalPoint(-0.26, 0.54, 0.0)
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(24)
    camera.SetClippingRange(1, 20)
    return renderer
