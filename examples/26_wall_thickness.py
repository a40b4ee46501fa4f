# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The thickness of a body at every point of its surface, by rays through it.

    26_wall_thickness.py [FOLDER]

Default: the current folder. Writes to FOLDER
    thickness.vtp    the mesh with the point array "thickness"
    thickness.png    the thickness as colours

From each point a cone of rays goes inwards; the thickness is the median of their lengths (L.
Shapira, A. Shamir, D. Cohen-Or, Consistent mesh partitioning and skeletonisation using the shape
diameter function, 2008). Only the picture needs a window.
Needs armadillo.off in the folder RELIEVO_DATA (default: build/data beside this folder);
tools/unpack-data puts it there.
"""

import time

import numpy
import relievo
from relievo.vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from relievo.vtk.vtkFiltersCore import vtkPolyDataNormals
from relievo.vtk.vtkIOXML import vtkXMLPolyDataWriter

import scene

RAYS = 32  # of a point
CONE = numpy.radians(40)  # half its opening


def cone(normals):
    """Directions around the inward normals, n x RAYS x 3, spread evenly over the cone."""
    k = numpy.arange(RAYS) + 0.5
    along = 1 - k / RAYS * (1 - numpy.cos(CONE))
    turn = numpy.pi * (1 + numpy.sqrt(5)) * k
    across = numpy.sqrt(1 - along**2)
    helper = numpy.where(numpy.abs(normals[:, :1]) < 0.7, [[1.0, 0, 0]], [[0, 1.0, 0]])
    side = numpy.cross(normals, helper)
    side /= numpy.linalg.norm(side, axis=1, keepdims=True)
    other = numpy.cross(normals, side)
    spread = across * numpy.cos(turn), across * numpy.sin(turn), -along
    first, second, third = (
        part[None, :, None] * axis[:, None, :]
        for part, axis in zip(spread, (side, other, normals))
    )
    return first + second + third


def thickness(mesh):
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    directions = cone(vtk_to_numpy(mesh.GetPointData().GetNormals()).astype(float))
    size = mesh.GetLength()
    start = time.perf_counter()
    hits = relievo.rays(mesh).nearest(
        numpy.repeat(points, RAYS, axis=0), directions.reshape(-1, 3), minimum=1e-6 * size
    )
    took = time.perf_counter() - start
    print(f"{len(hits.distance)} rays in {took:.2f} s, {hits.hit.mean():.1%} met the other side")
    # Rays that leave through a hole are ignored.
    far = numpy.where(hits.hit, hits.distance, numpy.nan).reshape(-1, RAYS)
    return numpy.nan_to_num(numpy.nanmedian(far, axis=1))


def main():
    folder = scene.folder()
    reader = relievo.vtkRelievoOFFReader()
    reader.SetFileName(scene.data("armadillo.off"))
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(reader.GetOutputPort())
    normals.SplittingOff()
    normals.ConsistencyOn()
    normals.Update()
    mesh = normals.GetOutput()
    array = numpy_to_vtk(thickness(mesh).astype(numpy.float32), deep=True)
    array.SetName("thickness")
    mesh.GetPointData().AddArray(array)
    data, picture = str(folder / "thickness.vtp"), str(folder / "thickness.png")
    writer = vtkXMLPolyDataWriter()
    writer.SetDataModeToBinary()  # with newer expat, VTK 9.2 cannot read appended data
    writer.SetInputData(mesh)
    writer.SetFileName(data)
    if not writer.Write():
        raise SystemExit(f"{data}: could not be written")
    relievo.scene(data, color_by="thickness", scalar_bar=True, size=(960, 540)).render(picture)
    print(f"wrote {data} and {picture}")


if __name__ == "__main__":
    main()
