# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras in the terms of their calibration: K, R, t, lenses, panoramas, scanners."""

import math
from collections.abc import Sequence
from typing import Any, Self

import numpy
from numpy.typing import ArrayLike

from .._arguments.errors import Watch, check_file, describe, is_a
from .._arguments.renderers import inner_renderer
from ..vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from ..vtk.vtkCommonCore import vtkDoubleArray
from ..vtk.vtkRenderingCore import vtkCamera
from ..vtkRelievoCameras import (
    vtkRelievoCalibration,
    vtkRelievoLensCamera,
    vtkRelievoLidar,
    vtkRelievoOrthographicCamera,
    vtkRelievoPanoramaCamera,
    vtkRelievoPushbroomCamera,
)

_LARGEST = 1 << 20  # pixels each way


class CameraModel:
    """A sensor: its size, its pose, and the ray of each of its pixels.

    Pixels are counted as in OpenCV: column u from the left, row v from the top, the CENTRE
    of the first pixel at (0, 0). The pose takes a world point p to R p + t, where x is right, y is
    down and z is forward (lidars: x forward, y left, z up).

    model: the VTK object behind it, a vtkRelievo…Camera or vtkRelievoLidar.
    size: (columns, rows). R, t: the pose; see pose().

    Raises ValueError for invalid arguments, as all camera classes do.
    """

    def __init__(self, model: Any, size: Sequence[int] | None, R: ArrayLike | None,
                 t: ArrayLike | None) -> None:
        self.model = model
        if size is not None:
            self._call("size", model.SetSize, *_whole(size))
        if R is not None or t is not None:
            self.pose(R, t)

    def __repr__(self):
        columns, rows = self.size
        return f"<relievo.{type(self).__name__} of {columns} x {rows} pixels>"

    def _call(self, subject, method, *values):
        with Watch(self.model) as watch:
            method(*values)
        watch.raise_as(ValueError, subject)

    @property
    def size(self) -> tuple[int, int]:
        """(columns, rows)."""
        return tuple(self.model.GetSize())

    @property
    def R(self) -> numpy.ndarray:
        """The rotation from the world to the camera, array of (3, 3)."""
        return numpy.array(self.model.GetRotation()).reshape(3, 3)

    @property
    def t(self) -> numpy.ndarray:
        """The translation from the world to the camera, array of 3, world units."""
        return numpy.array(self.model.GetTranslation())

    def pose(self, R: ArrayLike | None = None, t: ArrayLike | None = None) -> Self:
        """Sets the pose: R of (3, 3), or a rotation vector of 3 (Rodrigues, radians), and t of 3;
        None for the identity and 0. Returns self. Raises ValueError if R is not a rotation."""
        turn = _rotation(R)
        shift = numpy.zeros(3) if t is None else _numbers("t", t, 3)
        self._call("pose", self.model.SetExtrinsics, turn.ravel().tolist(), shift.tolist())
        return self

    def look_at(self, position: ArrayLike, target: ArrayLike, up: ArrayLike = (0, 1, 0)) -> Self:
        """Sets the pose of a camera at `position` that looks at `target`, with `up` upwards in the
        picture. Returns self. Raises ValueError if these define no direction."""
        triples = (_numbers(name, each, 3).tolist() for name, each in
                   (("position", position), ("target", target), ("up", up)))
        self._call("look_at", self.model.LookAt, *triples)
        return self

    def copy(self) -> Self:
        """Returns an independent copy."""
        other = object.__new__(type(self))
        other.model = self.model.NewInstance()
        other.model.Copy(self.model)
        return other

    def rays(self, places: ArrayLike | None = None) -> tuple[numpy.ndarray, numpy.ndarray]:
        """Returns (origins, directions), the rays in the world, directions of length 1.

        places: pixels (n, 2) as (u, v), also between their centres; None for all pixels.

        Returns two arrays of (n, 3), or of (rows, columns, 3) for all pixels; NaN where the lens
        sees nothing.
        """
        origins, directions = vtkDoubleArray(), vtkDoubleArray()
        if places is None:
            self.model.GetRays(origins, directions)
            columns, rows = self.size
            shape: tuple[int, ...] = (rows, columns, 3)
        else:
            self.model.GetRays(_array(_rows("places", places, 2)), origins, directions)
            shape = (-1, 3)
        return vtk_to_numpy(origins).reshape(shape), vtk_to_numpy(directions).reshape(shape)

    def project(self, points: ArrayLike) -> numpy.ndarray:
        """Returns the places (u, v) of world points (n, 3) in the picture, array of (n, 2); NaN for
        points that no ray hits. Places may lie outside the picture."""
        places = vtkDoubleArray()
        self.model.Project(_array(_rows("points", points, 3)), places)
        return vtk_to_numpy(places)


class Pinhole(CameraModel):
    """A camera with intrinsics K (3, 3), and optionally OpenCV's distortion.

    distortion: k1, k2[, p1, p2[, k3[, k4, k5, k6]]] of Brown and Conrady, in OpenCV's order.
    size: (columns, rows). R, t: the pose; see CameraModel.pose.

    Raises ValueError for invalid arguments.
    """

    def __init__(self, K: ArrayLike, size: Sequence[int], R: ArrayLike | None = None,
                 t: ArrayLike | None = None, distortion: ArrayLike = ()) -> None:
        super().__init__(vtkRelievoLensCamera(), size, R, t)
        self._lens(K, vtkRelievoLensCamera.BROWN_CONRADY, distortion)

    def _lens(self, K, lens, coefficients):
        K = _intrinsics(K)
        self._call("K", self.model.SetIntrinsics, K[0, 0], K[1, 1], K[0, 1], K[0, 2], K[1, 2])
        values = [] if coefficients is None else _list("distortion", coefficients)
        if not any(values) and lens != vtkRelievoLensCamera.FISHEYE:
            lens, values = vtkRelievoLensCamera.PINHOLE, []
        self._call("distortion", self.model.SetLens, lens, len(values), values)

    @classmethod
    def of(cls, camera: Any, size: Sequence[int]) -> "Pinhole":
        """The pinhole equal to a vtkCamera, a renderer's or a plotter's, in a picture of (columns,
        rows). Raises ValueError for cameras without perspective projection."""
        found = _camera_of(camera)
        taken = Pinhole(numpy.eye(3), size)
        taken._call("camera", taken.model.TakeFrom, found, *taken.size)
        return taken

    @property
    def K(self) -> numpy.ndarray:
        """The intrinsics, array of (3, 3), pixels."""
        matrix = [0.0] * 9
        self.model.GetIntrinsics(matrix)
        return numpy.array(matrix).reshape(3, 3)


class Fisheye(Pinhole):
    """A fisheye with intrinsics K (3, 3) and OpenCV's fisheye coefficients D: k1, k2, k3, k4
    (Kannala and Brandt). Those not given are 0; without any, angles are equal steps of the radius.

    size: (columns, rows). R, t: the pose; see CameraModel.pose.

    Raises ValueError for invalid arguments.
    """

    def __init__(self, K: ArrayLike, size: Sequence[int], D: ArrayLike = (),
                 R: ArrayLike | None = None, t: ArrayLike | None = None) -> None:
        CameraModel.__init__(self, vtkRelievoLensCamera(), size, R, t)
        self._lens(K, vtkRelievoLensCamera.FISHEYE, D)


class Division(Pinhole):
    """A lens by Fitzgibbon's division model, with one coefficient k in units of K's focal length:
    the undistorted place is the distorted one divided by 1 + k r².

    size: (columns, rows). R, t: the pose; see CameraModel.pose.

    Raises ValueError for invalid arguments.
    """

    def __init__(self, K: ArrayLike, size: Sequence[int], k: float, R: ArrayLike | None = None,
                 t: ArrayLike | None = None) -> None:
        CameraModel.__init__(self, vtkRelievoLensCamera(), size, R, t)
        self._lens(K, vtkRelievoLensCamera.DIVISION, [k])


class Equirectangular(CameraModel):
    """A panorama with equal steps of azimuth and elevation, forward in the middle.

    size: (columns, rows); a whole panorama is twice as wide as high. field: degrees that its
    columns and rows span, at most (360, 180).

    R, t: the pose; see CameraModel.pose.

    Raises ValueError for invalid arguments.
    """

    def __init__(self, size: Sequence[int], field: Sequence[float] = (360, 180),
                 R: ArrayLike | None = None, t: ArrayLike | None = None) -> None:
        super().__init__(vtkRelievoPanoramaCamera(), size, R, t)
        self._call("field", self.model.SetFieldOfView, *_numbers("field", field, 2).tolist())


class Cube(CameraModel):
    """A panorama of six square faces side by side: front, right, back, left, up, down.

    face: pixels along each side of a face; the picture is six times as wide as high.

    R, t: the pose; see CameraModel.pose.

    Raises ValueError for invalid arguments.
    """

    def __init__(self, face: int, R: ArrayLike | None = None, t: ArrayLike | None = None) -> None:
        super().__init__(vtkRelievoPanoramaCamera(), (6 * face, face), R, t)
        self.model.SetLayout(vtkRelievoPanoramaCamera.CUBE)


class Orthographic(CameraModel):
    """A camera of parallel rays, as in a map, with a number of pixels per world unit.

    center: the pixel of its axis; None for the middle of the picture.

    pixels_per_unit: above 0. size: (columns, rows). R, t: the pose; see CameraModel.pose.

    Raises ValueError for invalid arguments.
    """

    def __init__(self, pixels_per_unit: float, size: Sequence[int],
                 center: Sequence[float] | None = None, R: ArrayLike | None = None,
                 t: ArrayLike | None = None) -> None:
        super().__init__(vtkRelievoOrthographicCamera(), size, R, t)
        self.model.SetPixelsPerUnit(_positive("pixels_per_unit", pixels_per_unit))
        middle = (numpy.array(self.size) - 1) / 2
        center = middle.tolist() if center is None else _numbers("center", center, 2).tolist()
        self.model.SetPrincipalPoint(*center)

    @classmethod
    def of(cls, camera: Any, size: Sequence[int]) -> "Orthographic":
        """The map equal to a vtkCamera of parallel projection, a renderer's or a plotter's, in a
        picture of (columns, rows), from its matrices. Raises ValueError for other cameras, and for
        shear, a parallel scale of 0, or pixels that are not square."""
        found = _camera_of(camera)
        columns, rows = _whole(size)
        projection, view = numpy.empty((4, 4)), numpy.empty((4, 4))
        matrices = (found.GetProjectionTransformMatrix(columns / rows, -1, 1),
                    found.GetModelViewTransformMatrix())
        for array, matrix in zip((projection, view), matrices):
            array[:] = [[matrix.GetElement(i, j) for j in range(4)] for i in range(4)]
        with numpy.errstate(all="ignore"):
            projection /= projection[3, 3]
        half = numpy.array([columns, rows]) / 2
        scale = half[1] * projection[1, 1]
        expected = projection.copy()  # of parallel rays, along z alone, to square pixels
        expected[3] = 0, 0, 0, 1
        expected[:2, :3] = numpy.diag((*(scale / half), 0))[:2]
        if not (found.GetParallelProjection() and numpy.isfinite(projection).all() and scale > 0
                and numpy.allclose(projection, expected, rtol=1e-9, atol=1e-9 * scale / max(half))):
            raise ValueError("camera: expected one of parallel projection, with a scale above 0 "
                             "and square pixels, without shear")
        center = half * (1 + projection[:2, 3] * (1, -1)) - 0.5
        turn = numpy.diag((1, -1, -1)) @ view[:3]  # to y down and z forward
        return Orthographic(scale, (columns, rows), center.tolist(), turn[:, :3], turn[:, 3])


class Pushbroom(CameraModel):
    """A line sensor that moves while it looks: row v is seen from v times `velocity`, in camera
    space and world units, with the focal length and the column of its axis in pixels.

    focal_length, center: pixels; center None for the middle. size: (columns, rows). R, t: the pose
    of row 0; see CameraModel.pose.

    Raises ValueError for invalid arguments.
    """

    def __init__(self, focal_length: float, velocity: ArrayLike, size: Sequence[int],
                 center: float | None = None, R: ArrayLike | None = None,
                 t: ArrayLike | None = None) -> None:
        super().__init__(vtkRelievoPushbroomCamera(), size, R, t)
        self.model.SetFocalLength(_positive("focal_length", focal_length))
        center = (self.size[0] - 1) / 2 if center is None else _numbers("center", center, 1)[0]
        self.model.SetPrincipalColumn(center)
        self.model.SetVelocity(*_numbers("velocity", velocity, 3).tolist())


class Lidar(CameraModel):
    """A laser scanner, whose pose has x forward, y left, z up.

    elevations: degrees of each ray above the plane z = 0.
    steps: a spinning sensor's steps in a turn: its picture has a row per elevation, a column for
        each step. turn: azimuths, in degrees from x towards y, of the first step and behind the
        last one. offsets: azimuth of each row relative to the step.
    azimuths: instead of steps, the azimuth of each ray: a picture of one row.
    way, rotation: motion of a spinning sensor during a turn, in its axes at column 0: a straight
        way in world units, and degrees about an axis as a vector of that length. The pose is that
        of column 0.
    min_range, max_range: world units; beams have no return from surfaces that are nearer or
        farther.
    divergence: full angle of a beam, degrees, 0 to 90; samples: rays that fill it, 1 to 4096.
    returns: "first" for the nearest hit of these rays, "last" for the farthest one.
    noise: standard deviation of normally distributed range errors, world units; they depend on the
        pixel and on `seed` alone.

    Divergence and noise apply to captures and data sets. visible() and flow() follow the axes of
    the beams, within the range limits, and need elevations in ascending or descending order.

    R, t: the pose; see CameraModel.pose.

    Raises ValueError for invalid arguments.
    """

    def __init__(self, elevations: ArrayLike, steps: int | None = None,
                 azimuths: ArrayLike | None = None, turn: Sequence[float] = (180, -180),
                 offsets: ArrayLike | None = None, R: ArrayLike | None = None,
                 t: ArrayLike | None = None, *, way: ArrayLike = (0, 0, 0),
                 rotation: ArrayLike = (0, 0, 0), min_range: float = 0,
                 max_range: float = math.inf, divergence: float = 0, samples: int = 16,
                 returns: str = "first", noise: float = 0, seed: int = 0) -> None:
        super().__init__(vtkRelievoLidar(), None, R, t)
        motion = [_numbers(name, each, 3).tolist()
                  for name, each in (("way", way), ("rotation", rotation))]
        self._call("way, rotation", self.model.SetMotion, *motion)
        numbers = {"min_range": min_range, "max_range": max_range, "divergence": divergence,
                   "noise": noise}  # fmt: skip
        if not all(_is_number(each) for each in numbers.values()):
            raise ValueError(f"{', '.join(numbers)}: got {numbers}, expected numbers")
        whole = {"samples": samples, "seed": seed}
        if not all(_is_number(each) and abs(each) < 1 << 31 and int(each) == each
                   for each in whole.values()):
            raise ValueError(f"samples, seed: got {whole}, expected whole numbers")
        if returns not in ("first", "last"):
            raise ValueError(f"returns: got {returns!r}, expected 'first' or 'last'")
        self._call("min_range, max_range", self.model.SetRangeLimits, min_range, max_range)
        self._call("divergence, samples", self.model.SetDivergence, divergence, int(samples))
        self.model.SetReturn(("first", "last").index(returns))
        self._call("noise", self.model.SetNoise, noise, int(seed))
        if (steps is None) == (azimuths is None):
            raise ValueError("Lidar: expected either steps, of a spinning sensor, or azimuths, as "
                             "many as elevations")
        raised = _list("elevations", elevations)
        count = len(raised)
        if azimuths is not None:
            azimuths = _numbers("azimuths", azimuths, count).tolist()
            self._call("azimuths", self.model.SetDirections, count, azimuths, raised)
            return
        turn = _numbers("turn", turn, 2).tolist()
        whole = _positive("steps", steps)
        if whole != int(whole) or whole > _LARGEST:
            raise ValueError(f"steps: got {steps!r}, expected a whole number up to {_LARGEST}")
        self._call("elevations", self.model.SetSpinning, count, raised, int(whole), *turn)
        if offsets is not None:
            offsets = _numbers("offsets", offsets, count).tolist()
            self._call("offsets", self.model.SetAzimuthOffsets, count, offsets)


def camera(target=None, *, K, size, R=None, t=None, near=None, far=None) -> vtkCamera:
    """Sets a vtkCamera from a calibration, and returns it.

        relievo.camera(renderer, K=K, R=R, t=t, size=(1280, 720))
        image = relievo.capture(renderer, ["depth", "cell"], size=(1280, 720))

    target: a vtkCamera, a renderer or a plotter; None for a new vtkCamera.
    K: intrinsics (3, 3) in pixels, OpenCV's: fx and fy may differ, the principal point may lie
        anywhere, a skew is allowed. The centre of the first pixel, at the top left, is (0, 0).
    size: (columns, rows) of the picture that K is for. In a window of another shape the
        height, fx and fy stay; intrinsics() gives the result.
    R, t: the pose, world to camera, x right, y down, z forward; R (3, 3) or a rotation vector; see
        cv2.solvePnP. None for the identity and 0.
    near, far: the clipping planes, world units; None to fit them to what the renderer shows, or to
        leave the camera's.

    Raises ValueError for a K that is not upper triangular, or an R that is not a rotation. A camera
    with a distorting lens is a Pinhole, Fisheye, …, for capture(…, camera=).
    """
    model = Pinhole(K, size, R, t)
    renderer = None if target is None or is_a(target, "vtkCamera") else inner_renderer(target)
    if renderer is not None:
        found = renderer.GetActiveCamera()
        if getattr(renderer, "camera_set", True) is False:
            renderer.camera_set = True  # PyVista would place it when it is first shown
    elif target is None:
        found = vtkCamera()
    elif is_a(target, "vtkCamera"):
        found = target
    else:
        raise ValueError(f"target: got {describe(target)}, expected a vtkCamera, a renderer or "
                         f"something with a .renderer")
    old = found.GetClippingRange()
    planes = [old[i] if each is None else _numbers(name, each, 1)[0]
              for i, (name, each) in enumerate((("near", near), ("far", far)))]
    if not 0 < planes[0] < planes[1]:
        raise ValueError(f"near, far: got {planes[0]:g} and {planes[1]:g}, expected 0 < near < far")
    model._call("camera", model.model.ApplyTo, found)
    if near is not None or far is not None:
        found.SetClippingRange(*planes)
    elif renderer is not None:
        renderer.ResetCameraClippingRange()
    return found


def lens(words, size=None, view_angle=30, R=None, t=None) -> CameraModel:
    words = str(words)
    if vtkRelievoCalibration.IsFile(words):
        check_file(words)
    calibration = vtkRelievoCalibration()
    view = vtkCamera()
    with Watch(calibration) as watch:
        read = calibration.SetWords(words) and calibration.Read()
        if read and size is None:
            size = calibration.GetFileSize()
            if not any(size):
                raise ValueError("size: got None, expected (columns, rows): only a file says its "
                                 "size")
        if read:
            columns, rows = _whole(size)
            calibration.SetViewAngle(_positive("view_angle", view_angle))
            model = calibration.MakeCamera(view, columns, rows)
    watch.raise_as(ValueError, "lens")
    made = object.__new__(_class_of(model))
    CameraModel.__init__(made, model, None, None, None)
    return made.pose(R, t)


lens.__doc__ = f"""Returns the camera that words or a calibration's file say, as `--lens` does.

    sensor = relievo.lens("calibration.yml").look_at((2, 1, 5), (0, 0, 0))
    sensor = relievo.lens("fisheye:0.02,-0.013", size=(1280, 720), view_angle=170)

words: {vtkRelievoCalibration.GetForms(True)}, each
    with ,K=FX/FY/CX/CY or ,angle=DEG by choice; {vtkRelievoCalibration.GetForms(False)}.
    Or the name of a file .yml, .yaml, .json or .xml, also with .gz, as OpenCV, ROS, Kalibr and
    EuRoC write it, or of COLMAP's cameras.txt.
size: (columns, rows) of the picture; None for the file's. A file's K is scaled to it.
view_angle: degrees that the height of the picture spans, where the words say neither.

R, t: the pose; see CameraModel.pose. Returns a CameraModel. Raises ValueError for invalid words
and sizes and for files that are no calibrations, OSError for a file that cannot be read.
"""


def _class_of(model):
    if model.IsA("vtkRelievoLensCamera"):
        bent = {vtkRelievoLensCamera.FISHEYE: Fisheye, vtkRelievoLensCamera.DIVISION: Division}
        return bent.get(model.GetLens(), Pinhole)
    if model.IsA("vtkRelievoOrthographicCamera"):
        return Orthographic
    if model.IsA("vtkRelievoPanoramaCamera"):
        return Cube if model.GetLayout() == vtkRelievoPanoramaCamera.CUBE else Equirectangular
    return CameraModel


def intrinsics(camera, size) -> numpy.ndarray:
    """Returns K, array of (3, 3) in pixels, of the camera, a vtkCamera, a renderer or a plotter, as
    seen in a picture of size (columns, rows). Raises ValueError unless the projection is
    perspective."""
    return Pinhole.of(camera, size).K


def extrinsics(camera) -> tuple:
    """Returns (R, t), arrays of (3, 3) and 3: from the world to x right, y down, z forward, of a
    vtkCamera, a renderer or a plotter, the camera. Raises ValueError unless it is a pinhole."""
    taken = Pinhole.of(camera, (1, 1))
    return taken.R, taken.t


def sensor_of(camera, size):
    """The pinhole or the map equal to a vtkCamera, a renderer's or a plotter's, in a picture."""
    of = Orthographic.of if _camera_of(camera).GetParallelProjection() else Pinhole.of
    return of(camera, size)


def _camera_of(camera):
    renderer = None if is_a(camera, "vtkCamera") else inner_renderer(camera)
    found = camera if renderer is None else renderer.GetActiveCamera()
    if not is_a(found, "vtkCamera"):
        raise ValueError(f"camera: got {describe(camera)}, expected a vtkCamera, a renderer or "
                         f"something with a .renderer")
    return found


def _is_number(value):
    return isinstance(value, (int, float, numpy.number)) and not math.isnan(value)


def _numbers(name, values, count):
    try:
        array = numpy.asarray(values, float).ravel()
    except (TypeError, ValueError):
        array = numpy.empty(0)
    if array.size != count or not numpy.isfinite(array).all():
        raise ValueError(f"{name}: got {values!r}, expected {count} finite numbers")
    return array


def _whole(size):
    columns, rows = _numbers("size", size, 2)
    if columns != int(columns) or rows != int(rows) or max(columns, rows) > _LARGEST:
        raise ValueError(f"size: got {size!r}, expected whole (columns, rows), at most {_LARGEST} "
                         f"each")
    return int(columns), int(rows)


def _list(name, values):
    try:
        return numpy.asarray(values, float).ravel().tolist()
    except (TypeError, ValueError):
        raise ValueError(f"{name}: got {values!r}, expected numbers") from None


def _positive(name, value):
    number = _numbers(name, value, 1)[0]
    if number <= 0:
        raise ValueError(f"{name}: got {value!r}, expected a number above 0")
    return number


def _rows(name, values, count):
    array = numpy.ascontiguousarray(values, dtype=float)
    if array.ndim == 1 and array.size == count:
        array = array[None]
    if array.ndim != 2 or array.shape[1] != count:
        raise ValueError(f"{name}: got an array of {array.shape}, expected (n, {count})")
    return array


def _array(values):
    return numpy_to_vtk(values, deep=True)


def _intrinsics(K):
    K = _numbers("K", K, 9).reshape(3, 3)
    if K[1, 0] != 0 or (K[2] != (0, 0, 1)).any():
        raise ValueError(f"K: got {K.tolist()}, expected [[fx, skew, cx], [0, fy, cy], [0, 0, 1]]")
    return K


def _rotation(R):
    if R is None:
        return numpy.eye(3)
    if numpy.size(R) != 3:
        return _numbers("R", R, 9).reshape(3, 3)
    # Rodrigues' formula.
    vector = _numbers("R", R, 3)
    angle = numpy.linalg.norm(vector)
    if angle == 0:
        return numpy.eye(3)
    x, y, z = vector / angle
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + numpy.sin(angle) * cross + (1 - numpy.cos(angle)) * cross @ cross
