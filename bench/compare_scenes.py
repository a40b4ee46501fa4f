# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of bench/compare.py, and the faults that it puts into them, with the truth of each."""

import dataclasses
import functools
import math
import typing

import numpy
import relievo

relievo.provide_vtkmodules()  # of a wheel
import vtkmodules.vtkRenderingFreeType  # noqa: E402, F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: E402, F401
from scale import torus  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction  # noqa: E402
from vtkmodules.vtkFiltersCore import (  # noqa: E402
    vtkPolyDataNormals,
    vtkPolyDataTangents,
    vtkTriangleFilter,
)
from vtkmodules.vtkFiltersSources import (  # noqa: E402
    vtkConeSource,
    vtkCubeSource,
    vtkPlaneSource,
    vtkTexturedSphereSource,
)
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor  # noqa: E402
from vtkmodules.vtkRenderingCore import (  # noqa: E402
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkTextActor,
    vtkTexture,
    vtkVolume,
    vtkVolumeProperty,
)
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper  # noqa: E402

SIZES = (0.05, 0.2, 0.5, 1, 3)  # pixels
LEVELS = (1, 2, 4, 8, 16)  # of 255
EYE, AIM, ANGLE = (4.2, -6.5, 4.2), (0, 0, 0.35), 30
TEXELS = 32


class Truth(typing.NamedTuple):
    """A cause that a comparison may report for a fault. None: any."""

    cause: str
    kind: str | None = None
    id: int | None = None
    name: str = ""  # the beginning of it


@dataclasses.dataclass
class Fault:
    kind: str
    apply: typing.Callable  # changes a Draft
    truths: tuple  # the causes of which one must be found
    size: float = 0  # in the unit of its kind


def mesh_of(points, triangles):
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetData(numpy_to_vtk(numpy.ascontiguousarray(points, "f4"), deep=True))
    set_cells(mesh, triangles)
    return mesh


def set_cells(mesh, cells):
    """Cells of as many points each."""
    made = vtkCellArray()
    count, size = cells.shape
    made.SetData(numpy_to_vtk(numpy.arange(0, size * count + 1, size), deep=True, array_type=12),
                 numpy_to_vtk(cells.ravel(), deep=True, array_type=12))  # fmt: skip
    (mesh.SetPolys if size == 3 else mesh.SetVerts)(made)


def cells_of(mesh):
    return vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def points_of(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData())


def output(source, *filters):
    for each in filters:
        each.SetInputConnection(source.GetOutputPort())
        source = each
    source.Update()
    mesh = vtkPolyData()
    mesh.DeepCopy(source.GetOutput())
    return mesh


def smooth(mesh):
    normals = vtkPolyDataNormals()
    normals.SplittingOff()
    normals.SetInputData(mesh)
    return output(normals)


def halved(source):
    """The output of a source, its squares as two triangles each: VTK's filter depends on its
    version."""
    source.Update()
    mesh = vtkPolyData()
    mesh.DeepCopy(source.GetOutput())
    squares = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 4)
    set_cells(mesh, squares[:, (0, 1, 2, 0, 2, 3)].reshape(-1, 3))
    return mesh


def ring(triangles=1800, **more):
    return smooth(mesh_of(*torus(triangles, **more)))


def ball(center=(0, 0, 0), radius=0.5, steps=20):
    source = vtkTexturedSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(steps)
    source.SetPhiResolution(steps // 2)
    mesh = output(source, vtkTriangleFilter())
    points_of(mesh)[:] += numpy.array(center, "f4")
    return mesh


def box(center=(0, 0, 0), side=0.7):
    source = vtkCubeSource()
    source.SetCenter(*center)
    for axis in "XYZ":
        getattr(source, f"Set{axis}Length")(side)
    return halved(source)


def cone(center=(0, 0, 0)):
    source = vtkConeSource()
    source.SetCenter(*center)
    source.SetDirection(0, 0, 1)
    source.SetResolution(24)
    return output(source, vtkTriangleFilter())


def ground(side=5, z=-0.5):
    source = vtkPlaneSource()
    source.SetOrigin(-side / 2, -side / 2, z)
    source.SetPoint1(side / 2, -side / 2, z)
    source.SetPoint2(-side / 2, side / 2, z)
    source.SetResolution(6, 6)
    return halved(source)


def picture(shift=0, seed=3):
    """A smooth texture of random colours."""
    small = numpy.random.default_rng(seed).integers(40, 250, (TEXELS // 4, TEXELS // 4, 3))
    return numpy.roll(numpy.kron(small, numpy.ones((4, 4, 1))), shift, 1).astype("u1")


def bumps(inverted=False):
    """A normal map of waves."""
    turn = numpy.linspace(0, 6 * math.pi, TEXELS, endpoint=False)
    x = 0.4 * numpy.sin(turn)[None] * numpy.ones((TEXELS, 1)) * (-1 if inverted else 1)
    y = 0.4 * numpy.cos(turn)[:, None] * numpy.ones((1, TEXELS)) * (-1 if inverted else 1)
    up = numpy.sqrt(1 - x * x - y * y)
    return (127.5 * (numpy.stack((x, y, up), -1) + 1)).astype("u1")


def texture_of(pixels):
    texture = vtkTexture()
    texture.SetInputData(relievo.to_image(pixels))
    texture.InterpolateOn()
    return texture


class Draft:
    """A scene to be drawn: changed by a fault or in order, then put into a renderer."""

    def __init__(self, make, order=0, named=True):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.25, 0.3, 0.4)
        self.renderer.AutomaticLightCreationOff()
        self.actors, self.names, self.lights, self.overlays, self.volumes = [], [], [], [], []
        self.stages, self.lamps, self.fog = {}, None, None
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*EYE)
        camera.SetFocalPoint(*AIM)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(ANGLE)
        self.order, self.named = order, named
        make(self)
        if not self.lights:
            self.light((2, -5, 6))

    def add(self, name, mesh, color=(1, 1, 1), array=None):
        """An actor, coloured by an array if there is one."""
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        if array:
            mapper.ScalarVisibilityOn()
            mapper.SelectColorArray(array)
            (mapper.SetScalarModeToUsePointFieldData if mesh.GetPointData().HasArray(array)
             else mapper.SetScalarModeToUseCellFieldData)()  # fmt: skip
            mapper.SetLookupTable(colors())
            mapper.UseLookupTableScalarRangeOn()
        else:
            mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(*color)
        actor.GetProperty().SetAmbient(0.1)
        self.actors.append(actor)
        self.names.append(name)
        return actor

    def light(self, place, color=(1, 1, 1), intensity=1.0, cone=0, aim=(0, 0, 0)):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(*place)
        light.SetFocalPoint(*aim)
        light.SetColor(*color)
        light.SetIntensity(intensity)
        light.SetPositional(cone > 0)
        if cone:
            light.SetConeAngle(cone)
        self.lights.append(light)
        return light

    def text(self, words, place, size=16):
        actor = vtkTextActor()
        actor.SetInput(words)
        actor.GetTextProperty().SetFontSize(size)
        actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
        actor.GetPositionCoordinate().SetValue(*place)
        self.overlays.append(actor)

    def mesh(self, place):
        return self.actors[place].GetMapper().GetInput()

    def finish(self, window):
        """Puts everything into the renderer; returns the renderer and the names of actors."""
        props = list(range(len(self.actors)))
        if self.order:
            numpy.random.default_rng(self.order).shuffle(props)
        for place in props:
            self.renderer.AddActor(self.actors[place])
        for light in self.lights:
            self.renderer.AddLight(light)
        for each in (*self.overlays, *self.volumes):
            self.renderer.AddViewProp(each)
        for name, values in self.stages.items():
            relievo.stage(self.renderer, name, **values)
        if self.lamps is not None:
            relievo.lamps(self.renderer, self.lamps[:, :3], radius=self.lamps[0, 3],
                          color="#ffd080", intensity=self.lamps[0, 4])  # fmt: skip
        if self.fog is not None:
            relievo.fog(self.renderer, self.fog[:, :3], radius=self.fog[0, 3],
                        density=self.fog[0, 4], color=(0.8, 0.8, 0.9))  # fmt: skip
        window.AddRenderer(self.renderer)
        names = dict(zip(self.actors, self.names, strict=True)) if self.named else {}
        return self.renderer, names

    def to_pixel(self, point, size):
        """World units of a pixel at a point."""
        camera = self.renderer.GetActiveCamera()
        away = numpy.subtract(point, camera.GetPosition()) @ camera.GetDirectionOfProjection()
        return 2 * away * math.tan(math.radians(camera.GetViewAngle() / 2)) / size[1]


def window_of(size, samples=0):
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(samples)
    window.SetAlphaBitPlanes(1)
    window.SetSize(*size)
    return window


def colors(first=0.667, last=0.0, span=(0.0, 1.0)):
    table = vtkLookupTable()
    table.SetHueRange(first, last)
    table.SetRange(*span)
    table.Build()
    return table


def with_array(mesh, name, values, cells=False):
    array = numpy_to_vtk(numpy.ascontiguousarray(values, "f4"), deep=True)
    array.SetName(name)
    (mesh.GetCellData() if cells else mesh.GetPointData()).AddArray(array)
    return mesh


# ------------------------------------------------------------------------------
# The scenes


def meshes(draft):
    draft.add("ring", ring(), (0.8, 0.5, 0.3))
    draft.add("ball", ball((0.9, -1.2, 0.2)), (0.3, 0.6, 0.8))
    draft.add("box", box((-1.2, -1.0, 0)), (0.6, 0.7, 0.3))
    draft.add("ground", ground(), (0.6, 0.6, 0.6))


def arrays(draft):
    mesh = ring()
    draft.add("ring", with_array(mesh, "height", points_of(mesh)[:, 2] + 0.5), array="height")
    mesh = ball((0, -0.3, 0.6), 0.6)
    count = mesh.GetNumberOfCells()
    draft.add("ball", with_array(mesh, "number", numpy.linspace(0, 1, count), cells=True),
              array="number")  # fmt: skip


def textures(draft):
    draft.add("ground", ground()).SetTexture(texture_of(picture()))
    draft.add("ball", ball((0, 0, 0.4), 1)).SetTexture(texture_of(picture(seed=5)))
    draft.add("box", box((1.4, -1.2, 0)), (0.4, 0.6, 0.4))


def materials(draft):
    tangents = vtkPolyDataTangents()
    tangents.SetInputData(ball((-0.6, 0, 0.5), 1))
    actor = draft.add("ball", output(tangents), (0.9, 0.8, 0.6))
    actor.GetProperty().SetNormalTexture(texture_of(bumps()))
    draft.add("ring", ring(radius=0.6, center=(1.2, -1, 0.1)), (0.8, 0.2, 0.2))
    draft.add("ground", ground(), (0.5, 0.5, 0.5))
    for place, each in enumerate(draft.actors):
        each.GetProperty().SetInterpolationToPBR()
        each.GetProperty().SetMetallic(0.2 * place)
        each.GetProperty().SetRoughness(0.3 + 0.1 * place)
    draft.light((2, -5, 6), intensity=2)
    draft.light((-4, -3, 3), (1, 0.8, 0.6))
    draft.stages["tone"] = {"exposure": 0.2}


def shadows(draft):
    meshes(draft)
    draft.light((3, -3, 6), intensity=0.6)
    draft.light((-3, -4, 5), (1, 0.8, 0.6), 0.6, cone=40)
    draft.light((-5, 1, 4), (0.6, 0.8, 1), 0.3)
    draft.stages["shadows"] = {"map_size": 512}


def lamps(draft):
    meshes(draft)
    draft.light((2, -5, 6), intensity=0.3)
    turn = numpy.linspace(0, 2 * math.pi, 12, endpoint=False)
    draft.lamps = numpy.stack((1.6 * numpy.cos(turn), 1.6 * numpy.sin(turn), 0 * turn,
                               0 * turn + 0.9, 0 * turn + 0.6), -1)  # fmt: skip


def fog(draft):
    meshes(draft)
    draft.fog = numpy.array([(0.5, -0.6, 0, 0.9, 0.9), (-0.8, 0.6, 0.1, 0.9, 0.9)])


def ambient(draft):
    draft.add("ring", ring(), (0.8, 0.7, 0.6))
    draft.add("cone", cone((0, 0, 0)), (0.6, 0.7, 0.8))
    draft.add("ground", ground(), (0.7, 0.7, 0.7))
    draft.stages["ambient"] = {"samples": 16, "radius": 0.8}


def overlay(draft):
    arrays(draft)
    draft.text("ring and ball", (0.03, 0.9))
    draft.text("t = 0.25 s", (0.03, 0.03), 12)
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colors())
    bar.SetTitle("height")
    bar.SetNumberOfLabels(3)
    draft.overlays.append(bar)


def clipped(draft):
    actor = draft.add("ring", ring(), (0.8, 0.5, 0.3))
    plane = vtkPlane()
    plane.SetOrigin(0, 0, 0.12)
    plane.SetNormal(0.2, 0, -1)
    actor.GetMapper().AddClippingPlane(plane)
    draft.add("ball", ball((0, 0, 0), 0.4), (0.3, 0.6, 0.8))
    draft.add("ground", ground(), (0.6, 0.6, 0.6))


def translucent(draft):
    draft.add("ring", ring(), (0.8, 0.5, 0.3))
    draft.add("ground", ground(), (0.6, 0.6, 0.6))
    for place, (center, color) in enumerate((((0, -1.2, 0.2), (0.2, 0.5, 0.9)),
                                             ((0.3, -0.4, 0.5), (0.9, 0.3, 0.3)),
                                             ((-0.4, 0.2, 0.6), (0.3, 0.8, 0.4)))):  # fmt: skip
        actor = draft.add(f"glass {place}", ball(center, 0.6), color)
        actor.GetProperty().SetOpacity(0.4)
    draft.renderer.SetUseDepthPeeling(True)
    draft.renderer.SetMaximumNumberOfPeels(16)
    draft.renderer.SetOcclusionRatio(0)


def points(draft):
    """Points, and a volume."""
    chance = numpy.random.default_rng(7)
    cloud = vtkPolyData()
    cloud.SetPoints(vtkPoints())
    cloud.GetPoints().SetData(numpy_to_vtk(chance.normal((1, -0.8, 0.2), 0.4, (400, 3)),
                                           deep=True))  # fmt: skip
    set_cells(cloud, numpy.arange(400)[:, None])
    draft.add("cloud", cloud, (0.9, 0.7, 0.2)).GetProperty().SetPointSize(3)
    draft.add("ground", ground(), (0.6, 0.6, 0.6))
    draft.add("box", box((1.2, 0.9, 0)), (0.4, 0.6, 0.8))
    at = numpy.linspace(-1, 1, 24)
    far = numpy.sqrt(at[:, None, None] ** 2 + at[:, None] ** 2 + at**2)
    draft.values = numpy.clip(255 * (1 - far), 0, 255).astype("u1")
    volume = vtkVolume()
    volume.SetMapper(vtkFixedPointVolumeRayCastMapper())
    volume.GetMapper().AutoAdjustSampleDistancesOff()  # they depend on the time of a frame
    draft.volumes.append(volume)
    fill_volume(draft)
    volume.SetPosition(-1.3, -0.8, 0)
    volume.SetScale(1.6 / 23)


def fill_volume(draft, opacity=0.15, color=(1, 0.6, 0.3)):
    from vtkmodules.vtkCommonDataModel import vtkImageData

    image = vtkImageData()
    image.SetDimensions(24, 24, 24)
    array = numpy_to_vtk(draft.values.ravel(), deep=True)
    array.SetName("value")
    image.GetPointData().SetScalars(array)
    draft.volumes[0].GetMapper().SetInputData(image)
    made, ramp, shades = vtkVolumeProperty(), vtkPiecewiseFunction(), vtkColorTransferFunction()
    for value, share in ((0, 0), (100, 0), (200, opacity)):
        ramp.AddPoint(value, share)
    shades.AddRGBPoint(0, 0.2, 0.2, 0.9)
    shades.AddRGBPoint(255, *color)
    made.SetScalarOpacity(ramp)
    made.SetColor(shades)
    made.SetInterpolationTypeToLinear()
    draft.volumes[0].SetProperty(made)


SCENES = {each.__name__: each for each in (
    meshes, arrays, textures, materials, shadows, lamps, fog, ambient, overlay, clipped,
    translucent, points)}  # fmt: skip


# ------------------------------------------------------------------------------
# The faults


def across(chance, draft):
    """A random unit vector: in every second case parallel to the picture."""
    camera = draft.renderer.GetActiveCamera()
    found = chance.normal(size=3)
    if chance.random() < 0.5:
        view = numpy.array(camera.GetDirectionOfProjection())
        found -= (found @ view) * view
    return found / numpy.linalg.norm(found)


def move_points(draft, place, ids, vector):
    mesh = draft.mesh(place)
    points_of(mesh)[ids] += vector
    mesh.GetPoints().Modified()
    mesh.Modified()


def change_cells(draft, place, change):
    """change: a function of numbered cells, which returns cells and their former numbers."""
    mesh = draft.mesh(place)
    cells, kept = change(cells_of(mesh).copy())
    data = mesh.GetCellData()
    for each in range(data.GetNumberOfArrays()):
        array = data.GetArray(each)
        moved = numpy_to_vtk(vtk_to_numpy(array)[kept], deep=True)
        moved.SetName(array.GetName())
        data.AddArray(moved)
    set_cells(mesh, cells)


def without(cells, number):
    kept = numpy.delete(numpy.arange(len(cells)), number)
    return cells[kept], kept


def twice(cells, number):
    kept = numpy.append(numpy.arange(len(cells)), number)
    return cells[kept], kept


def reversed_cells(cells, numbers):
    cells[numbers] = cells[numbers][..., ::-1]
    return cells, numpy.arange(len(cells))


def move_actor(draft, place, vector):
    draft.actors[place].AddPosition(*vector)


def remove_actor(draft, place):
    del draft.actors[place], draft.names[place]


def copy_actor(draft, place):
    draft.add(f"{draft.names[place]} again", draft.mesh(place)).ShallowCopy(draft.actors[place])


def recolor(draft, place, channel, levels):
    color = list(draft.actors[place].GetProperty().GetColor())
    color[channel] += (levels if color[channel] < 0.5 else -levels) / 255
    draft.actors[place].GetProperty().SetColor(*color)


def set_property(draft, place, name, value):
    getattr(draft.actors[place].GetProperty(), f"Set{name}")(value)


def move_light(draft, place, degrees):
    light = draft.lights[place]
    x, y, z = light.GetPosition()
    turn = math.radians(degrees)
    light.SetPosition(x * math.cos(turn) - y * math.sin(turn),
                      x * math.sin(turn) + y * math.cos(turn), z)  # fmt: skip


def dim_light(draft, place, share):
    draft.lights[place].SetIntensity(draft.lights[place].GetIntensity() * share)


def tint_light(draft, place, share):
    r, g, b = draft.lights[place].GetDiffuseColor()
    draft.lights[place].SetColor(r, g * share, b)


def turn_camera(draft, pixels, size):
    camera = draft.renderer.GetActiveCamera()
    camera.SetFocalPoint(*(numpy.array(AIM) + (pixels * draft.to_pixel(AIM, size), 0, 0)))


def set_background(draft, levels):
    draft.renderer.SetBackground(0.25, 0.3 + levels / 255, 0.4)


def set_stage(draft, stage, **values):
    draft.stages[stage] = {**draft.stages.get(stage, {}), **values}


def change_array(draft, place, ids, amount, cells=False):
    mesh = draft.mesh(place)
    array = (mesh.GetCellData() if cells else mesh.GetPointData()).GetArray(
        "number" if cells else "height")  # fmt: skip
    vtk_to_numpy(array)[ids] += amount
    array.Modified()


def on_actor(cause, place):
    return (Truth(cause, "actor", place),)


def of_surfaces(draft, base, chance, size):
    """Faults of each scene's objects, at cells that are seen."""
    actor, cell = (relievo.layer(base, name) for name in ("actor", "cell"))
    seen = [place for place in range(len(draft.actors))
            if (actor == place).sum() >= 40 and draft.mesh(place).GetNumberOfPolys()]  # fmt: skip

    def pick():
        """An object, a visible cell of it and one of its points, and a pixel's size there."""
        place = int(chance.choice(seen))
        numbers, counts = numpy.unique(cell[actor == place], return_counts=True)
        number = int(chance.choice(numbers[counts >= min(4, counts.max())]))
        ids = cells_of(draft.mesh(place))[number]
        here = points_of(draft.mesh(place))[ids[0]]
        return place, number, ids, draft.to_pixel(here, size)

    for pixels in SIZES:
        place, _, ids, unit = pick()
        vector = pixels * unit * across(chance, draft)
        yield Fault("vertex moved", functools.partial(
            move_points, place=place, ids=ids[0], vector=vector), on_actor("shape", place), pixels)
        place, _, ids, unit = pick()
        vector = pixels * unit * across(chance, draft)
        yield Fault("cell moved", functools.partial(
            move_points, place=place, ids=ids, vector=vector), on_actor("shape", place), pixels)
        place, _, _, unit = pick()
        vector = pixels * unit * across(chance, draft)
        yield Fault("object moved", functools.partial(
            move_actor, place=place, vector=vector), on_actor("moved", place), pixels)
        yield Fault("camera", functools.partial(turn_camera, pixels=pixels, size=size),
                    (Truth("camera"),), pixels)  # fmt: skip
    for change, kind in ((without, "cell removed"), (twice, "cell duplicated"),
                         (reversed_cells, "cell reversed")):  # fmt: skip
        place, number, _, _ = pick()
        yield Fault(kind, functools.partial(
            change_cells, place=place, change=functools.partial(
                change, **{"numbers" if change is reversed_cells else "number": number})),
            on_actor("shape", place))  # fmt: skip
    place = int(chance.choice(seen))
    yield Fault("all cells reversed", functools.partial(
        change_cells, place=place, change=functools.partial(reversed_cells, numbers=slice(None))),
        on_actor("shape", place))  # fmt: skip
    place = int(chance.choice(seen))
    yield Fault("object removed", functools.partial(remove_actor, place=place),
                on_actor("removed", place))  # fmt: skip
    place = int(chance.choice(seen))
    yield Fault("object duplicated", functools.partial(copy_actor, place=place),
                on_actor("added", len(draft.actors)))  # fmt: skip
    plain = [place for place in seen if not draft.actors[place].GetMapper().GetScalarVisibility()]
    for levels in LEVELS:
        if plain:
            place, channel = int(chance.choice(plain)), int(chance.integers(3))
            yield Fault("colour", functools.partial(
                recolor, place=place, channel=channel, levels=levels),
                on_actor("color", place), levels)  # fmt: skip
    yield Fault("background", functools.partial(set_background, levels=8),
                (Truth("settings", "setting", None, "background"),), 8)  # fmt: skip
    for place in range(len(draft.lights)):
        truths = (Truth("light", "light", place),)
        for change, values in ((move_light, (1, 10)), (dim_light, (0.98, 0.8)),
                               (tint_light, (0.98, 0.8))):  # fmt: skip
            for value in values:
                kind = change.__name__.replace("_", " ")
                argument = "degrees" if change is move_light else "share"
                yield Fault(kind, functools.partial(change, place=place, **{argument: value}),
                            truths, value)  # fmt: skip


def of_arrays(draft, chance):
    for number, amount in enumerate((0.01, 0.05, 0.2, 0.2)):
        ids = chance.integers(draft.mesh(0).GetNumberOfPoints(), size=20)
        yield Fault("array value", functools.partial(change_array, place=0, ids=ids, amount=amount),
                    on_actor("array", 0), amount)  # fmt: skip
        ids = chance.integers(draft.mesh(1).GetNumberOfCells(), size=10)
        yield Fault("array value", functools.partial(
            change_array, place=1, ids=ids, amount=amount, cells=True),
            on_actor("array", 1), amount)  # fmt: skip
        place = number % 2
        table = colors(0.667 - amount)
        yield Fault("colour map", lambda draft, place=place, table=table: draft.actors[
            place].GetMapper().SetLookupTable(table), on_actor("color", place), amount)  # fmt: skip
        table = colors(span=(0, 1 + amount))
        yield Fault("range", lambda draft, place=place, table=table: draft.actors[
            place].GetMapper().SetLookupTable(table), on_actor("color", place), amount)  # fmt: skip


def shift_texture(draft, place, texels):
    coordinates = vtk_to_numpy(draft.mesh(place).GetPointData().GetTCoords())
    coordinates[:, 0] += texels / TEXELS
    draft.mesh(place).GetPointData().GetTCoords().Modified()


def of_textures(draft, chance):
    for place in (0, 1):
        for texels in (0.5, 1):
            yield Fault("texture shifted", functools.partial(
                shift_texture, place=place, texels=texels), on_actor("color", place),
                texels)  # fmt: skip
        other = texture_of(numpy.clip(picture(seed=3 + 2 * place).astype(int) + 6, 0, 255)
                           .astype("u1"))  # fmt: skip
        yield Fault("texture", lambda draft, place=place, other=other: draft.actors[
            place].SetTexture(other), on_actor("color", place))  # fmt: skip


def turn_normals(draft, place, degrees):
    array = draft.mesh(place).GetPointData().GetNormals()
    normals = vtk_to_numpy(array)
    turn = math.radians(degrees)
    x, y = normals[:, 0].copy(), normals[:, 1].copy()
    normals[:, 0] = x * math.cos(turn) - y * math.sin(turn)
    normals[:, 1] = x * math.sin(turn) + y * math.cos(turn)
    array.Modified()


def of_materials(draft, chance):
    def invert(draft):
        draft.actors[0].GetProperty().RemoveTexture("normalTex")
        draft.actors[0].GetProperty().SetNormalTexture(texture_of(bumps(inverted=True)))

    yield Fault("normal map inverted", invert, on_actor("normal", 0))
    for degrees in (0.05, 0.5, 5):
        yield Fault("normals turned", functools.partial(turn_normals, place=1, degrees=degrees),
                    on_actor("normal", 1), degrees)  # fmt: skip
    for place in range(len(draft.actors)):
        for name, value in (("Metallic", 0.9), ("Roughness", 0.5 + 0.1 * place)):
            yield Fault("material", functools.partial(
                set_property, place=place, name=name, value=value),
                on_actor("settings", place))  # fmt: skip
    for exposure in (0.21, 0.5):
        yield Fault("tone", functools.partial(set_stage, stage="tone", exposure=exposure),
                    (Truth("tone"),))  # fmt: skip


def of_shadows(draft, chance):
    truths = (Truth("settings", "setting", None, "shadows:"), Truth("shadow", "light"))
    for values in ({"map_size": 256}, {"map_size": 1024}, {"bias": 0}, {"bias": 4},
                   {"strength": 0.9}, {"filter_radius": 3}, {"method": "warped"}):  # fmt: skip
        yield Fault("shadow settings", functools.partial(set_stage, stage="shadows", **values),
                    truths)  # fmt: skip
    yield Fault("shadows off", lambda draft: draft.stages.clear(), truths)
    yield Fault("cone", lambda draft: draft.lights[1].SetConeAngle(38),
                (Truth("light", "light", 1),))  # fmt: skip


def scale_column(draft, of, row, column, add):
    getattr(draft, of)[row, column] += add


def of_lamps(draft, chance):
    for column, add in ((0, 0.01), (0, 0.1), (2, 0.05)):
        row = int(chance.integers(12))
        yield Fault("lamp moved", functools.partial(
            scale_column, of="lamps", row=row, column=column, add=add), (Truth("lamps"),))
    for column, add in ((3, 0.02), (3, 0.2), (4, 0.02), (4, 0.2)):
        yield Fault("lamps changed", functools.partial(
            scale_column, of="lamps", row=slice(None), column=column, add=add), (Truth("lamps"),))
    for count in (11, 6, 0):
        def fewer(draft, count=count):
            draft.lamps = draft.lamps[:count] if count else None

        yield Fault("lamps removed", fewer, (Truth("lamps"), Truth("settings", name="lamps:")))


def of_fog(draft, chance):
    for column, add in ((0, 0.01), (0, 0.1), (2, 0.05), (3, 0.02), (3, 0.2), (4, 0.02), (4, 0.2)):
        yield Fault("fog changed", functools.partial(
            scale_column, of="fog", row=slice(None), column=column, add=add), (Truth("fog"),))

    def off(draft):
        draft.fog = None

    yield Fault("fog off", off, (Truth("fog"), Truth("settings", name="fog:")))


def of_ambient(draft, chance):
    truths = (Truth("ambient"), Truth("settings", name="ambient:"))
    for values in ({"radius": 0.5}, {"radius": 0.79}, {"strength": 0.8}, {"strength": 0.98},
                   {"weighting": "uniform"}, {"samples": 64}):  # fmt: skip
        yield Fault("ambient changed", functools.partial(set_stage, stage="ambient", **values),
                    truths)  # fmt: skip
    yield Fault("ambient off", lambda draft: draft.stages.clear(), truths)


def of_overlay(draft, chance):
    truths = (Truth("overlay"),)

    def on(place, change):
        return lambda draft: change(draft.overlays[place])

    for kind, change in (
        ("text", on(0, lambda text: text.SetInput("ring and bell"))),
        ("text", on(1, lambda text: text.SetInput("t = 0.26 s"))),
        ("font", on(0, lambda text: text.GetTextProperty().SetFontSize(17))),
        ("font", on(1, lambda text: text.GetTextProperty().BoldOn())),
        ("font", on(1, lambda text: text.GetTextProperty().SetFontFamilyToTimes())),
        ("text", on(0, lambda text: text.GetTextProperty().SetColor(1, 0.9, 1))),
        ("text", on(1, lambda text: text.GetPositionCoordinate().SetValue(0.03, 0.04))),
        ("bar", on(2, lambda bar: bar.SetTitle("weight"))),
        ("bar", on(2, lambda bar: bar.SetNumberOfLabels(4))),
        ("bar", on(2, lambda bar: bar.SetLookupTable(colors(span=(0, 2))))),
        ("bar", on(2, lambda bar: bar.SetLookupTable(colors(0.6)))),
        ("text", lambda draft: draft.overlays.pop(0)),
    ):  # fmt: skip
        yield Fault(f"overlay: {kind}", change, truths)


def move_plane(draft, pixels, size):
    plane = draft.actors[0].GetMapper().GetClippingPlanes().GetItem(0)
    plane.SetOrigin(0, 0, 0.12 + pixels * draft.to_pixel((0, 0, 0.12), size))


def of_clipped(draft, chance, size):
    for pixels in (*SIZES, -3, -1):
        yield Fault("clip plane", functools.partial(move_plane, pixels=pixels, size=size),
                    on_actor("visibility", 0), abs(pixels))  # fmt: skip
    yield Fault("clip plane off", lambda draft: draft.actors[
        0].GetMapper().RemoveAllClippingPlanes(), on_actor("visibility", 0))  # fmt: skip


def of_translucent(draft, chance, size):
    """Of the three translucent objects, which the layers do not show."""
    for place in (2, 3, 4):
        glass = (Truth("translucent", "actor", place),)
        for opacity in (0.41, 0.5):
            yield Fault("opacity", functools.partial(
                set_property, place=place, name="Opacity", value=opacity),
                (*glass, *on_actor("settings", place)))  # fmt: skip
        for levels in (8, 32):
            yield Fault("translucent colour", functools.partial(
                recolor, place=place, channel=place - 2, levels=levels),
                (*glass, *on_actor("color", place)), levels)  # fmt: skip
        for pixels in (0.2, 1, 3):
            vector = pixels * draft.to_pixel((0, 0, 0.4), size) * across(chance, draft)
            yield Fault("translucent moved", functools.partial(
                move_actor, place=place, vector=vector),
                (*glass, *on_actor("moved", place)), pixels)  # fmt: skip


def of_points(draft, chance, size):
    for number, pixels in enumerate((0.5, 1, 3)):
        vector = pixels * draft.to_pixel((1, -0.8, 0.2), size) * across(chance, draft)
        ids = chance.integers(400, size=40 if number % 2 else 1)
        yield Fault("points moved", functools.partial(move_points, place=0, ids=ids, vector=vector),
                    on_actor("shape", 0), pixels)  # fmt: skip
        yield Fault("object moved", functools.partial(move_actor, place=0, vector=vector),
                    on_actor("moved", 0), pixels)  # fmt: skip
    yield Fault("point size", functools.partial(set_property, place=0, name="PointSize", value=4),
                on_actor("settings", 0))  # fmt: skip
    for levels in (4, 16):
        yield Fault("colour", functools.partial(recolor, place=0, channel=1, levels=levels),
                    on_actor("color", 0), levels)  # fmt: skip

    def values(draft):
        draft.values = draft.values.copy()
        draft.values[8:12, 8:12, 4:12] //= 2
        fill_volume(draft)

    for cause, change in (
        ("color", functools.partial(fill_volume, opacity=0.2)),
        ("color", functools.partial(fill_volume, opacity=0.16)),
        ("color", functools.partial(fill_volume, color=(1, 0.8, 0.3))),
        ("array", values),
        ("moved", lambda draft: draft.volumes[0].AddPosition(0.02, 0, 0)),
        ("visibility", lambda draft: draft.volumes[0].VisibilityOff()),
    ):
        yield Fault("volume", change, (Truth(cause, "volume", 0),))


def faults(name, draft, base, size, seed=1):
    """The faults of a scene; base: its frame."""
    chance = numpy.random.default_rng((seed, *name.encode()))
    yield from of_surfaces(draft, base, chance, size)
    own = {"arrays": of_arrays, "overlay": of_overlay, "textures": of_textures,
           "materials": of_materials, "shadows": of_shadows, "lamps": of_lamps, "fog": of_fog,
           "ambient": of_ambient, "clipped": functools.partial(of_clipped, size=size),
           "translucent": functools.partial(of_translucent, size=size),
           "points": functools.partial(of_points, size=size)}.get(name)  # fmt: skip
    if own:
        yield from own(draft, chance)
