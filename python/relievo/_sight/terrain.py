# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrains whose heights are a raster of the world: their mesh, and values on their grid."""

import os
from collections.abc import Mapping

import numpy
from numpy.typing import ArrayLike

from .._arguments.data import need_data
from .._arguments.errors import Watch, check_file, describe, path_of
from ..vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from ..vtk.vtkCommonDataModel import vtkImageData, vtkPolyData
from ..vtkRelievoFilters import vtkRelievoTerrain
from ..vtkRelievoIO import vtkRelievoGeoTIFFReader, vtkRelievoGeoTIFFWriter


class Terrain:
    """A terrain, made by terrain(). Functions that take a mesh take it as its triangles.

    dataset: the triangles, vtkPolyData in double; the heights are along z.
    heights: array (rows, columns), NaN where there are no data.
    transform: (a, b, c, d, e, f), from columns and rows to x = a column + b row + c and
        y = d column + e row + f.
    nodata: the value of cells without data in rasters() and in files, -9999.
    """

    nodata = vtkRelievoGeoTIFFWriter.GetNoData()

    def __init__(self, image, source):
        filter_ = vtkRelievoTerrain()
        filter_.SetInputDataObject(image)
        with Watch(filter_) as watch:
            filter_.Update()
        watch.raise_as(ValueError, source)
        self.dataset = vtkPolyData()
        self.dataset.ShallowCopy(filter_.GetOutput())
        fields = self.dataset.GetFieldData()
        self.transform = tuple(vtk_to_numpy(fields.GetArray("raster_transform")).ravel().tolist())
        columns, rows = vtk_to_numpy(fields.GetArray("raster_size")).ravel().tolist()
        self._shape = rows, columns
        self._cells = vtk_to_numpy(self.dataset.GetPointData().GetArray("raster_cell"))
        points = vtk_to_numpy(self.dataset.GetPoints().GetData())
        self.heights = self._spread(points[:, 2], numpy.nan)

    def __repr__(self):
        return f"<relievo.Terrain of {self._shape[0]} rows and {self._shape[1]} columns>"

    def _spread(self, values, missing):
        raster = numpy.full(self._shape, missing, _signed(values.dtype))
        raster.ravel()[self._cells] = values
        return raster

    def rasters(self, mesh) -> dict:
        """Returns the arrays at the points of a mesh with this terrain's points, such as the result
        of viewshed() or of sun_exposure(…, points=True), as arrays (rows, columns) by their names,
        `nodata` where there are no data. Raises ValueError for other meshes."""
        data = need_data(mesh, "mesh").GetPointData()
        if data.GetNumberOfTuples() != len(self._cells):
            raise ValueError(f"mesh: got {data.GetNumberOfTuples()} values at points, expected "
                             f"{len(self._cells)}, one for each cell with a height")
        arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
        return {array.GetName(): self._spread(vtk_to_numpy(array), self.nodata)
                for array in arrays if array is not None and array.GetNumberOfComponents() == 1
                and array.GetName() != "raster_cell"}

    def write(self, path: str | os.PathLike, rasters: Mapping[str, ArrayLike]) -> None:
        """Writes rasters, a dict of arrays (rows, columns) by name, as the bands of a GeoTIFF
        with the terrain's place and, if it was read from a file, its coordinate system. Cells
        without a height, and masked ones, are written as `nodata`. Raises ValueError for invalid
        arguments, OSError for a path that cannot be written."""
        path = path_of(path, "path")
        if not isinstance(rasters, Mapping):
            raise ValueError(f"rasters: got {describe(rasters)}, expected a dict of arrays by name")
        mesh = vtkPolyData()
        mesh.ShallowCopy(self.dataset)
        cells = mesh.GetPointData().GetArray("raster_cell")
        mesh.GetPointData().Initialize()  # without arrays of the caller
        mesh.GetPointData().AddArray(cells)
        for name, values in rasters.items():
            if name == "raster_cell":
                raise ValueError(f"rasters: got the name {name!r}, which is that of the cells' "
                                 f"numbers, expected another one")
            raster = numpy.ma.asanyarray(values)
            if raster.shape != self._shape or raster.dtype.kind not in "biuf":
                raise ValueError(f"rasters: got {describe(values)} for {name!r}, expected numbers "
                                 f"of {self._shape[0]} rows and {self._shape[1]} columns")
            kind = _signed(raster.dtype)
            kind = kind if kind.kind == "i" or kind == numpy.float32 else numpy.float64
            raster = numpy.ma.filled(raster.astype(kind), self.nodata)
            array = numpy_to_vtk(raster.ravel()[self._cells], deep=True)
            array.SetName(str(name))
            mesh.GetPointData().AddArray(array)
        if mesh.GetPointData().GetNumberOfArrays() == 1:
            raise ValueError("rasters: got none, expected at least one array by its name")
        writer = vtkRelievoGeoTIFFWriter()
        writer.SetFileName(path)
        writer.SetInputDataObject(mesh)
        with Watch(writer) as watch:
            writer.Write()
        watch.raise_as(OSError, "write")


def _signed(kind):
    """A type of numbers with those of this one, and with `nodata`."""
    return kind if kind.kind == "f" else numpy.promote_types(kind, numpy.int16)


def terrain(heights, transform=None, nodata=None) -> Terrain:
    """Returns a Terrain: the triangles of a raster of heights, and its grid.

        with rasterio.open("dem.tif") as src:
            hills = relievo.terrain(src.read(1), src.transform, src.nodata)
        seen = hills.rasters(relievo.viewshed(hills, [(689300, 5337200, 2)]))["seen"]
        hills = relievo.terrain("dem.tif")            # or from a GeoTIFF, without rasterio
        hills.write("seen.tif", {"seen": seen})

    heights: an array (rows, columns) of numbers, which may be masked; or the path of a GeoTIFF.
    transform: from columns and rows, counted from the outer corner of the first cell, to x and y:
        rasterio's, or six numbers (a, b, c, d, e, f) for x = a column + b row + c and
        y = d column + e row + f. Only with an array. x, y and heights have the same unit: no
        degrees.
    nodata: the height of cells without data; None: only those that are not finite.

    Points are at the centres of the cells, in double. Each square of four is cut along the diagonal
    from its first row and column to its last ones.

    Raises ValueError for invalid arguments, for rasters of less than two rows or columns and for
    files that are no GeoTIFF, OSError for a file that cannot be read, MemoryError if the file or
    the mesh does not fit into the memory left.
    """
    if isinstance(heights, (str, os.PathLike)):
        if transform is not None or nodata is not None:
            raise ValueError("transform, nodata: got values beside a file, which has its own")
        path = os.fspath(heights)
        check_file(path)
        reader = vtkRelievoGeoTIFFReader()
        reader.SetFileName(path)
        with Watch(reader) as watch:
            reader.Update()
        watch.raise_as(ValueError, "terrain")
        return Terrain(reader.GetOutput(), path)
    values = numpy.ma.asanyarray(heights)
    if values.ndim != 2 or values.dtype.kind not in "iuf" or values.size == 0:
        raise ValueError(f"heights: got {describe(heights)}, expected an array (rows, columns) of "
                         f"numbers, or the path of a GeoTIFF")
    values = numpy.ma.filled(values.astype(float), numpy.nan)
    if transform is None:
        raise ValueError("transform: got None beside an array, expected six numbers")
    try:
        numbers = numpy.asarray(tuple(transform)[:6], float)
    except (TypeError, ValueError):
        numbers = numpy.empty(0)
    if numbers.shape != (6,) or not numpy.isfinite(numbers).all():
        raise ValueError(f"transform: got {describe(transform)}, expected six finite numbers")
    image = vtkImageData()
    image.SetDimensions(values.shape[1], values.shape[0], 1)
    scalars = numpy_to_vtk(values[::-1].ravel(), deep=True)
    scalars.SetName("height")
    image.GetPointData().SetScalars(scalars)
    fields = {"raster_transform": numbers}
    if nodata is not None:
        try:
            fields["raster_nodata"] = numpy.array([float(nodata)])
        except (TypeError, ValueError):
            raise ValueError(f"nodata: got {describe(nodata)}, expected a number") from None
    for name, field in fields.items():
        array = numpy_to_vtk(field, deep=True)
        array.SetName(name)
        image.GetFieldData().AddArray(array)
    return Terrain(image, "terrain")
