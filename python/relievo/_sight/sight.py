# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Computations by rays: layers of any sensor, visible cells, flow, hours of sun."""

import datetime
import inspect
import os

import numpy

from .._arguments.data import need_data
from .._arguments.errors import Watch, describe, is_a
from .._arguments.parameters import (
    bind,
    defaults_of,
    describe_all,
    keywords,
    keywords_of,
    set_value,
)
from .._arguments.renderers import inner_renderer, outwards, prop_of
from ..vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from ..vtk.vtkCommonCore import vtkPoints
from ..vtk.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkTable
from ..vtk.vtkCommonExecutionModel import vtkAlgorithm
from ..vtk.vtkFiltersCore import vtkAppendPolyData
from ..vtk.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkGeometryFilter
from ..vtkRelievoFilters import (
    vtkRelievoCover,
    vtkRelievoFlow,
    vtkRelievoRayLayers,
    vtkRelievoSunExposure,
    vtkRelievoViewFactors,
    vtkRelievoViewshed,
    vtkRelievoVisibility,
)
from ..vtkRelievoRays import vtkRelievoRayScene
from .cameras import CameraModel, sensor_of
from .rays import Rays, rays

FLOW_LAYERS = ("flow", "motion", "flow_valid")
NEEDS_MOMENT = "; this layer needs previous=, from moment()"


def layers_by_rays(thing, names, sensor, ambient=None, previous=None, opaque_only=False):
    """The image of layers seen by a CameraModel; see capture(). opaque_only: only the surfaces that
    layers of a frame include."""
    scene = (thing if isinstance(thing, Rays) else rays(thing)).scene
    scene.SetMinimumDistance(0.0)  # not those of the last query
    scene.SetMaximumDistance(numpy.inf)
    scene.SetOpaqueOnly(opaque_only)
    source = vtkRelievoRayLayers()
    if previous is not None:
        scene.SetPointIds(previous.scene.GetPointIds())
        source.SetOther(previous.scene, previous.sensor.model)
    _set_ambient(source, {} if ambient is None else ambient)
    source.SetScene(scene)
    source.SetCamera(sensor.model)
    for name in names:
        source.AddLayer(name)
    try:
        if previous is not None:
            previous.scene.SetOpaqueOnly(opaque_only)
        return _image(source, f"capture {', '.join(names)}", scene)
    except ValueError as error:
        if previous is None and any(f"'{name}'" in str(error) for name in FLOW_LAYERS):
            raise ValueError(f"{error}{NEEDS_MOMENT}") from None
        raise
    finally:
        if previous is not None:
            previous.scene.SetOpaqueOnly(False)


def _set_ambient(source, settings):
    expected = ("samples", "radius", "weighting", "seed")
    if not isinstance(settings, dict):
        raise ValueError(f"ambient: got {describe(settings)}, expected a dict of "
                         f"{', '.join(expected)}")
    unknown = [name for name in settings if name not in expected]
    if unknown:
        raise ValueError(f"ambient: got {', '.join(map(str, unknown))}, expected "
                         f"{', '.join(expected)}")
    weighting = settings.get("weighting", "cosine")
    if weighting not in ("cosine", "uniform"):
        raise ValueError(f"weighting: got {weighting!r}, expected 'cosine' or 'uniform'")
    source.SetAmbientSamples(
        _number("samples", settings.get("samples", 64), 1, 65536, whole=True))
    source.SetAmbientRadius(_number("radius", settings.get("radius", 0), 0, 1e300))
    source.SetAmbientByCosine(weighting == "cosine")
    source.SetSeed(_number("seed", settings.get("seed", 0), 0, 2**31 - 1, whole=True))


def visible(thing, cameras, occluders=(), size=None, cloud=False) -> vtkPolyData | list | tuple:
    """Returns a mesh, or each prop of a scene, with arrays of its visibility from cameras.

        seen = relievo.visible(mesh, [relievo.Pinhole(K, (1280, 720), R, t), ...])
        share = (vtk_to_numpy(seen.GetCellData().GetArray("seen")) > 0).mean()
        of_actors = relievo.visible(renderer, sensors)

    thing: a dataset or a filter that makes one; data other than polygons count by their outer
        surface; or Rays of a mesh and its occluders. Or a scene as for rays(): a renderer, a
        plotter, an actor, or a list of data or actors.
    cameras: CameraModels (Pinhole, Fisheye, ...), or vtkCameras, renderers and plotters with
        pictures of `size` (columns, rows); one or a list.
    occluders: other data that occludes it, one or a list.
    cloud: also returns the visible points at pixels' centres, with the arrays cell, camera and
        normal.

    Returns vtkPolyData with the cell arrays seen (number of cameras), pixels and solid_angle
    (steradians, both summed over the cameras) and the point array seen; or with `cloud` that and
    the points. Cells smaller than a pixel are not lost: extra rays go to them.

    For a scene, returns a list of these, one for each of rays(thing).props, which occlude each
    other: in world coordinates, with the cell arrays block and cell as the layers of these names;
    None for a prop that rays do not hit, or that is translucent and occludes nothing. Surfaces are
    two-sided, whatever their culling. The points also have the array actor. Props that rays do not
    support are left out with a RuntimeWarning.

    Raises ValueError for invalid arguments.
    """
    filter_ = vtkRelievoVisibility()
    for each in _listed(cameras):
        filter_.AddCamera(_sensor(each, size).model)
    filter_.SetCloud(bool(cloud))
    is_scene = (isinstance(thing, list) or inner_renderer(thing) is not None
                or prop_of(thing) is not None)
    props = None
    if is_scene:
        scene = rays(thing)
        scene.scene.OpaqueOnlyOn()  # as in the layers of a frame
        with Watch(scene.scene):
            scene.scene.Update()
        props = _Props(scene)
    _give(filter_, thing if props is None else props.mesh, occluders)
    _run(filter_, "visible")
    seen, points = (_copy(filter_.GetOutput(port)) for port in (0, 1))
    if props is not None:
        seen, points = props.split(seen), props.number(points)
    return (seen, points) if cloud else seen


# The function's names of the filter's parameters.
_OF_VIEWSHED = keywords_of(vtkRelievoViewshed(), {})
_VIEWSHED_SIGNATURE = inspect.Signature(
    keywords(dict.fromkeys(("mesh", "observers"), inspect.Parameter.empty))
    + keywords({"occluders": (), **defaults_of(vtkRelievoViewshed(), _OF_VIEWSHED)}),
    return_annotation=vtkPolyData,
)  # fmt: skip


def viewshed(*arguments, **given):
    bound = bind("viewshed", _VIEWSHED_SIGNATURE, arguments, given)
    bound.apply_defaults()
    given = bound.arguments
    filter_ = vtkRelievoViewshed()
    for keyword, name in _OF_VIEWSHED.items():
        set_value("viewshed", filter_, name, given[keyword], keyword)
    try:
        observers = numpy.atleast_2d(numpy.asarray(given["observers"], float))
    except (TypeError, ValueError):
        observers = numpy.empty(0)
    if observers.shape[1:] != (3,) or not (numpy.isfinite(observers).all()
                                           and (observers[:, 2] >= 0).all()):
        raise ValueError(f"observers: got {describe(given['observers'])}, expected finite "
                         f"(x, y, height) each, with heights of at least 0")
    for observer in observers.tolist():
        filter_.AddViewpoint(*observer)
    _give(filter_, given["mesh"], given["occluders"])
    _run(filter_, "viewshed")
    return _copy(filter_.GetOutput())


viewshed.__signature__ = _VIEWSHED_SIGNATURE  # type: ignore[attr-defined]
viewshed.__doc__ = f"""Returns a terrain's mesh with the number of observers that see each point.

    hills = relievo.terrain(src.read(1), src.transform, src.nodata)
    seen = hills.rasters(relievo.viewshed(hills, [(689300, 5337200, 2)]))["seen"]

mesh: a Terrain, from terrain(); or a dataset or a filter that makes one, with heights along z; or
    Rays of it and its occluders.
observers: (x, y, height), or a list of them: coordinates of the terrain, and the height above it.
occluders: other data that also hide it, one or a list.
{describe_all(vtkRelievoViewshed(), _OF_VIEWSHED)}

Returns vtkPolyData with the point array seen. An observer sees a place if no triangle meets the
straight line between them, in double. Raises ValueError for invalid arguments, and for observers
that are not above the mesh.
"""


class _Props:
    """The meshes of a scene joined in world coordinates, and results split by props."""

    def __init__(self, scene):
        meshes = [[] for _ in scene.props]
        parts = []
        for number in range(scene.scene.GetNumberOfMeshes()):
            mesh = vtkPolyData()
            scene.scene.CopyMesh(number, mesh)
            block = numpy.full(mesh.GetNumberOfCells(), scene.scene.GetMeshBlock(number))
            _add(mesh.GetCellData(), "block", block.astype(numpy.int32))
            prop = scene.scene.GetMeshProp(number)
            if prop < 0:  # an occluder without a number
                parts.append((-1, mesh))
            else:
                meshes[prop].append(mesh)
        self._meshes = [_append(each) if each else None for each in meshes]
        parts += [(prop, mesh) for prop, mesh in enumerate(self._meshes) if mesh is not None]
        self.mesh = _append([_numbered(mesh, prop) for prop, mesh in parts])

    def split(self, seen):
        """Splits the arrays by props; None for a prop without a mesh."""
        there = [number for number, mesh in enumerate(self._meshes) if mesh is not None]
        for kind in ("GetCellData", "GetPointData") if there else ():
            data = getattr(seen, kind)()
            prop, place = (_values(data, each) for each in (_PROP, _PLACE))
            order = numpy.lexsort((place, prop))
            begins, ends = (numpy.searchsorted(prop[order], there, side)
                            for side in ("left", "right"))
            for name in ("seen", "pixels", "solid_angle"):
                if data.HasArray(name):
                    values = _values(data, name)[order]
                    for number, begin, end in zip(there, begins, ends):
                        _add(getattr(self._meshes[number], kind)(), name, values[begin:end])
        return self._meshes

    def number(self, points):
        """Sets the points' arrays actor, and cell as its own number."""
        data = points.GetPointData()
        prop = own = numpy.empty(0, numpy.int64)
        if data.HasArray("cell") and points.GetNumberOfPoints() > 0:
            cell = _values(data, "cell")
            prop, own = (_values(self.mesh.GetCellData(), each)[cell] for each in (_PROP, "cell"))
        _add(data, "actor", prop.astype(numpy.int32))
        _add(data, "cell", own)
        return points


_PROP, _PLACE = "relievo:prop", "relievo:place"  # prop and index of a cell or a point


def _numbered(mesh, prop):
    """The mesh with these arrays, and otherwise only the cells' numbers."""
    copy = vtkPolyData()
    copy.CopyStructure(mesh)
    copy.GetCellData().AddArray(mesh.GetCellData().GetArray("cell"))
    for data, count in ((copy.GetCellData(), mesh.GetNumberOfCells()),
                        (copy.GetPointData(), mesh.GetNumberOfPoints())):
        _add(data, _PROP, numpy.full(count, prop, numpy.int32))
        _add(data, _PLACE, numpy.arange(count))
    return copy


def _append(meshes):
    if len(meshes) == 1:
        return meshes[0]
    append = vtkAppendPolyData()
    append.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
    for mesh in meshes:
        append.AddInputData(mesh)
    if meshes:
        append.Update()
    return _copy(append.GetOutput())


def _values(data, name):
    return vtk_to_numpy(data.GetArray(name))


def _add(data, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.AddArray(array)


# The function's names of the filter's parameters. The place is two arguments, the days are dates.
_OF_SUN = keywords_of(
    vtkRelievoSunExposure(),
    {"day_step": "every", "up_axis": "up", "sky_samples": "sky"},
    without=("latitude", "longitude", "first_day", "last_day", "time_zone", "weather_file"),
)
_SUN_SIGNATURE = inspect.Signature(
    keywords(dict.fromkeys(("mesh", "latitude", "longitude", "first"), inspect.Parameter.empty))
    + keywords({"last": None, "occluders": (), **defaults_of(vtkRelievoSunExposure(), _OF_SUN),
                "time_zone": None, "weather": None}),
    return_annotation=vtkPolyData,
)  # fmt: skip


def sun_exposure(*arguments, **given):
    bound = bind("sun_exposure", _SUN_SIGNATURE, arguments, given)
    has_up = "up" in bound.arguments
    bound.apply_defaults()
    given = bound.arguments
    filter_ = vtkRelievoSunExposure()
    for keyword, name in {"latitude": "latitude", "longitude": "longitude", **_OF_SUN}.items():
        set_value("sun_exposure", filter_, name, given[keyword], keyword)
    first, last = given["first"], given["last"]
    filter_.SetFirstDay(*_day("first", first))
    filter_.SetLastDay(*_day("last", first if last is None else last))
    if given["time_zone"] is not None:
        set_value("sun_exposure", filter_, "time_zone", given["time_zone"])
    weather = given["weather"]
    if weather is not None and filter_.GetIrradiance() == 0:
        raise ValueError("weather: got no irradiance, expected irradiance='isotropic' or 'perez'")
    if isinstance(weather, (str, os.PathLike)):
        filter_.SetWeatherFile(os.fspath(weather))
    elif weather is not None:
        filter_.SetWeather(_weather(weather))
    _give(filter_, given["mesh"], given["occluders"])
    if not has_up and filter_.GetInputDataObject(0, 0).GetFieldData().HasArray("raster_size"):
        filter_.SetUpAxis(2)  # a terrain's
    _run(filter_, "sun_exposure")
    return _copy(filter_.GetOutput())


def _weather(arrays):
    """A table of the dict's arrays."""
    if not isinstance(arrays, dict) or not set(arrays) <= {"dni", "dhi", "ghi"}:
        raise ValueError(f"weather: got {describe(arrays)}, expected an EPW file, or a dict of "
                         f"arrays dhi, and dni or ghi")
    columns = {name: numpy.array(values, float).ravel() for name, values in arrays.items()}
    lengths = sorted({len(values) for values in columns.values()})
    if len(lengths) > 1:
        raise ValueError(f"weather: got arrays of lengths {lengths}, expected equal ones")
    table = vtkTable()
    for name, values in columns.items():
        column = numpy_to_vtk(values, deep=True)
        column.SetName(name)
        table.AddColumn(column)
    return table


sun_exposure.__signature__ = _SUN_SIGNATURE  # type: ignore[attr-defined]
sun_exposure.__doc__ = f"""Returns the mesh with its hours of sun and its irradiation.

    town = relievo.sun_exposure(town, 48.2, 16.4, "2026-01-01", "2026-12-31", every=7)
    roofs = relievo.sun_exposure(roofs, 48.2, 16.4, "2026-01-01", "2026-12-31",
                                 irradiance="perez", weather="vienna.epw")

mesh: a dataset or a filter that makes one; data other than polygons count by their outer
    surface. Normals point outwards. Or Rays of it and its occluders, such as
    relievo.rays("city.rays", mesh). For a Terrain, the default of `up` is z.
latitude, longitude: degrees, -90 to 90 and -180 to 180, north and east positive.
first, last: the first and the last day, as datetime.date or "2026-06-21"; last None: one day.
occluders: other data that shade it, one or a list.
{describe_all(vtkRelievoSunExposure(), _OF_SUN)}
time_zone: hours by which the clock is ahead of UTC, -12 to 14; None: with irradiance those of the
    weather file, otherwise local mean time.
weather: with irradiance, a weather file of EnergyPlus (EPW), or a dict of arrays in W/m2: dhi, and
    dni or ghi, the means of equal intervals from the first midnight to the last; None: a clear sky.

Returns vtkPolyData with the arrays sun_hours, insolation (hours times the cosine between the
sun and the normal) and sky_view (share of a uniform sky's light, 0 to 1), and the field data
possible_hours. With irradiance also, in kWh/m2, irradiation, its parts direct_irradiation,
diffuse_irradiation and reflected_irradiation, the bound of its error, irradiation_bound,
sun_hours_bound, and the field data open_irradiation. Raises ValueError for invalid arguments.
"""


class ViewFactors:
    """View factors between groups, as view_factors() returns them; arrays in the groups' order.

    groups: the numbers of the groups.
    areas: of each group, in square world units.
    factors: the share of light that leaves the group of a row and arrives at that of a column.
    bounds: the errors of factors are smaller, each with a confidence of 99.9 %.
    nothing: the share that hits nothing.
    others: the share that hits occluders, cells without a group, or the backs of cells.
    """

    def __init__(self, table):
        start, end, factor, bound, area = (
            vtk_to_numpy(table.GetColumnByName(name))
            for name in ("from", "to", "factor", "bound", "area"))  # fmt: skip
        self.groups = numpy.unique(start)
        rows = factor.reshape(len(self.groups), -1)
        order = end[:rows.shape[1]]
        within = order >= 0
        self.areas = area.reshape(rows.shape)[:, 0].copy()
        self.factors = rows[:, within]
        self.bounds = bound.reshape(rows.shape)[:, within]
        self.nothing = rows[:, order == -1].ravel()
        self.others = rows[:, order == -2].ravel()


def view_factors(mesh, groups, tolerance=0.01, occluders=(), seed=0) -> ViewFactors:
    """Returns the view factors between groups of a mesh's cells, by rays, with bounds.

        room = relievo.view_factors(room, wall_numbers, tolerance=0.002)
        heat = room.factors @ radiosities

    mesh: a dataset or a filter that makes one; of data other than polygons, the outer surface.
        Cells radiate and receive at their fronts, where their points run counter-clockwise.
    groups: a whole number for each cell, negative for none, or the name of a cell array of them.
    tolerance: rays are added until the bounds of all factors are below, 0.0001 to 0.2.
    occluders: other data that hide cells from each other, one or a list.
    seed: of the rays, from 0; equal seeds give equal factors.

    Each row of factors, with nothing and others, adds up to 1. Both directions of a pair have rays
    of their own: areas times factors are symmetric within the bounds.

    Raises ValueError for invalid arguments.
    """
    filter_ = vtkRelievoViewFactors()
    set_value("view_factors", filter_, "tolerance", tolerance)
    set_value("view_factors", filter_, "seed", seed)
    _give(filter_, mesh, occluders)
    if not isinstance(groups, str):
        data = _copy(filter_.GetInputDataObject(0, 0))
        groups = numpy.asarray(groups)
        if groups.shape != (data.GetNumberOfCells(),):
            raise ValueError(f"groups: got an array of shape {groups.shape}, expected one number "
                             f"for each of {data.GetNumberOfCells()} cells")
        _add(data.GetCellData(), _GROUPS, groups.astype(float))
        filter_.SetInputDataObject(0, data)
        groups = _GROUPS
    filter_.SetGroups(groups)
    _run(filter_, "view_factors")
    return ViewFactors(filter_.GetOutput())


_GROUPS = "relievo:groups"


_OF_COVER = keywords_of(vtkRelievoCover(), {}, without=("number_of_places", "weights"))
_COVER_SIGNATURE = inspect.Signature(
    keywords(dict.fromkeys(("mesh", "candidates", "k"), inspect.Parameter.empty))
    + keywords({"occluders": (), "directions": None, "weights": None,
                **defaults_of(vtkRelievoCover(), _OF_COVER)}),
    return_annotation=tuple,
)  # fmt: skip


def cover(*arguments, **given):
    bound = bind("cover", _COVER_SIGNATURE, arguments, given)
    bound.apply_defaults()
    given = bound.arguments
    filter_ = vtkRelievoCover()
    for keyword, name in {"k": "number_of_places", **_OF_COVER}.items():
        set_value("cover", filter_, name, given[keyword], keyword)
    _give(filter_, given["mesh"], given["occluders"])
    if given["weights"] is not None:
        mesh = _copy(filter_.GetInputDataObject(0, 0))
        weights = numpy.asarray(given["weights"], float)
        if weights.shape != (mesh.GetNumberOfCells(),):
            raise ValueError(f"weights: got an array of shape {weights.shape}, expected one number "
                             f"for each of {mesh.GetNumberOfCells()} cells")
        _add(mesh.GetCellData(), _WEIGHTS, weights)
        filter_.SetInputDataObject(0, mesh)
        filter_.SetWeights(_WEIGHTS)
    filter_.SetInputDataObject(2, _candidates(given["candidates"], given["directions"]))
    _run(filter_, "cover")
    covered, places = (_copy(filter_.GetOutput(port)) for port in (0, 1))
    covered.GetCellData().RemoveArray(_WEIGHTS)
    return covered, places


_WEIGHTS = "relievo:weights"


def _candidates(places, directions):
    """Points with directions as vectors."""
    if not hasattr(places, "__array__") and not isinstance(places, (list, tuple)):
        data = need_data(places, "candidates")
    else:
        data = vtkPolyData()
        data.SetPoints(vtkPoints())
        data.GetPoints().SetData(numpy_to_vtk(_vectors("candidates", places), deep=True))
    if directions is not None:
        given = _vectors("directions", directions)
        if len(given) != data.GetNumberOfPoints():
            raise ValueError(f"directions: got {len(given)}, expected one for each of "
                             f"{data.GetNumberOfPoints()} candidates")
        copy = data.NewInstance()
        copy.ShallowCopy(data)
        vectors = numpy_to_vtk(given, deep=True)
        vectors.SetName("relievo:directions")
        copy.GetPointData().SetVectors(vectors)
        data = copy
    return data


def _vectors(name, values):
    values = numpy.ascontiguousarray(values, float)
    if values.ndim != 2 or values.shape[1] != 3:
        raise ValueError(f"{name}: got an array of shape {values.shape}, expected (n, 3)")
    return values


cover.__signature__ = _COVER_SIGNATURE  # type: ignore[attr-defined]
cover.__doc__ = f"""Chooses, of many candidate places, the k from which most of a mesh is seen.

    site, cameras = relievo.cover(site, numpy.array(poles), 6, farthest_distance=40)
    share = site.GetFieldData().GetArray("share").GetValue(0)

mesh: a dataset or a filter that makes one; of data other than polygons, the outer surface; or Rays
    of it and its occluders. Cells count by their areas.
candidates: an array (n, 3) of places, or a dataset whose points are the places.
k: how many to choose, from 1.
occluders: other data that occlude the mesh, one or a list.
directions: an array (n, 3) of directions in which the candidates look; None: the point vectors of
    the dataset, if it has any. Needed if view_angle is less than 360.
weights: one number for each cell, by which its area is multiplied; None: 1.
{describe_all(vtkRelievoCover(), _OF_COVER)}

Returns two vtkPolyData. The mesh has the cell arrays covered (number of chosen places that see
the cell) and candidates (number of candidates that see it), and the field data share (covered part
of the weighted area), reachable (part that all candidates together cover) and bound (no choice of
k places covers a larger part). The chosen places, in their order, have the arrays candidate (its
index), gain (the part that it adds) and share (the part covered so far). Raises ValueError for
invalid arguments.
"""


class Moment:
    """A copy of a scene and its camera, made by moment() and compared by flow()."""

    def __init__(self, thing, camera, size, point_ids):
        self.scene = vtkRelievoRayScene()
        self.sensor = _sensor_of(thing, camera, size).copy()
        scene = rays(thing).scene
        if not isinstance(point_ids, (str, type(None))):
            raise ValueError(f"point_ids: got {describe(point_ids)}, expected an array's name")
        scene.SetPointIds(point_ids)
        with Watch(scene):
            self.scene.CopyStateOf(scene)


def moment(thing, camera=None, size=None, point_ids=None) -> Moment:
    """Copies the current state of a scene, for flow().

    thing: as for rays(): a renderer, a plotter, data.
    camera: a CameraModel, or a vtkCamera; None for the renderer's own, seen in `size` pixels.
    size: (columns, rows); None for the size of the renderer's viewport.
    point_ids: name of a point array of integers that identifies points when the data are meshed
        anew; None: points are identified by their index, and changed cells have no flow.

    Raises ValueError for invalid arguments.
    """
    return Moment(thing, camera, size, point_ids)


def flow(before, thing, camera=None, size=None) -> vtkImageData:
    """Returns the movement of a moment's pixels until now: optical and scene flow, in double.

    For the flow from now to a moment, as layers: capture(…, previous=).

        before = relievo.moment(renderer, size=(640, 480))
        actor.RotateY(5)
        image = relievo.flow(before, renderer)
        dx, dy = relievo.layer(image, "flow")[..., 0], relievo.layer(image, "flow")[..., 1]

    before: from moment(). thing: the scene now, or another moment. camera, size: as for moment();
        size None: that of the moment.

    Returns vtkImageData of the moment's size with the layers flow (2 floats: pixels, x right, y
    down; NaN in the background), motion (3 floats: world units) and flow_valid (1 where the point
    is now within the picture and unoccluded). Raises ValueError for invalid
    arguments.
    """
    if not isinstance(before, Moment):
        raise ValueError(f"before: got {describe(before)}, expected what moment() returns")
    if isinstance(thing, Moment):
        scene, sensor = thing.scene, thing.sensor
    else:
        scene = rays(thing).scene
        scene.SetPointIds(before.scene.GetPointIds())
        sensor = _sensor_of(thing, camera, before.sensor.size if size is None else size)
    source = vtkRelievoFlow()
    source.SetFrom(before.scene, before.sensor.model)
    source.SetTo(scene, sensor.model)
    return _image(source, "flow", before.scene, scene)


def _sensor_of(thing, camera, size):
    if camera is None:
        renderer = inner_renderer(thing)
        if renderer is None:
            raise ValueError("camera: got None, expected a camera; only a renderer has its own")
        camera = renderer.GetActiveCamera()
        size = tuple(renderer.GetSize()) if size is None else size
    return _sensor(camera, size)


def _sensor(camera, size):
    if isinstance(camera, CameraModel):
        return camera
    if size is None:
        raise ValueError("size: expected (columns, rows) of the picture of a vtkCamera")
    return sensor_of(camera, size)


def _listed(things):
    if things is None:
        return []
    return list(things) if isinstance(things, (list, tuple)) else [things]


def _number(name, value, low, high, whole=False):
    try:
        right = low <= value <= high and (not whole or int(value) == value)
    except TypeError:
        right = False
    if not right:
        kind = "a whole number" if whole else "a number"
        raise ValueError(f"{name}: got {value!r}, expected {kind} from {low} to {high}")
    return int(value) if whole else float(value)


def _day(name, day):
    if isinstance(day, str):
        try:
            day = datetime.date.fromisoformat(day)
        except ValueError:
            pass
    if not isinstance(day, datetime.date):
        raise ValueError(f"{name}: got {day!r}, expected a datetime.date or '2026-06-21'")
    return day.year, day.month, day.day


def _surface(thing):
    data = need_data(thing, "mesh")
    if is_a(data, "vtkPolyData"):
        return data
    surface = (
        vtkCompositeDataGeometryFilter() if is_a(data, "vtkCompositeDataSet")
        else vtkGeometryFilter()
    )
    surface.SetInputDataObject(data)
    surface.Update()
    return outwards(surface.GetOutputDataObject(0), data)


def _give(filter_, mesh, occluders):
    if isinstance(mesh, Rays):
        _give_rays(filter_, mesh, occluders)
        return
    filter_.SetInputDataObject(0, _surface(mesh))
    for each in _listed(occluders):
        filter_.AddInputDataObject(1, _surface(each))


def _give_rays(filter_, scene, occluders):
    """The data of rays(): the first is the mesh, the others hide it."""
    if scene.scene.GetRenderer() is not None or scene.has_matrices:
        raise ValueError("mesh: got Rays of a renderer, of actors or of data with matrices, "
                         "expected those of data")
    if not scene.props or None in scene.props:
        raise ValueError("mesh: got Rays of a file alone, which has no cells, expected "
                         "relievo.rays(file, mesh)")
    if not is_a(scene.props[0], "vtkPolyData"):
        raise ValueError(f"mesh: got Rays of {describe(scene.props[0])}, expected vtkPolyData")
    if _listed(occluders):
        raise ValueError("occluders: got some beside Rays, whose data after the first hide the "
                         "mesh")
    filter_.SetInputDataObject(0, scene.props[0])
    for each in scene.props[1:]:
        if is_a(each, "vtkCompositeDataSet"):
            raise ValueError(f"mesh: got Rays of {describe(each)}, expected data without blocks")
        filter_.AddInputDataObject(1, each)
    if hasattr(filter_, "SetScene"):
        filter_.SetScene(scene.scene)


def _run(filter_, subject, *others):
    with Watch(filter_, *others) as watch:
        filter_.Update()
    watch.raise_as(ValueError, subject)


def _image(source, subject, *others):
    _run(source, subject, *others)
    image = vtkImageData()
    image.ShallowCopy(source.GetOutput())
    return image


def _copy(data):
    copy = vtkPolyData()
    copy.ShallowCopy(data)
    return copy
