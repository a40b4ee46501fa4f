# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data of tools/screenshots, run by pvpython with the plugin: makeData.py DATA DEST

bunny.vtp has its height above the ground, labels.vti is a brain atlas at half its resolution.
"""

import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkmodules.vtkImagingCore import vtkImageShrink3D

DATA, DEST = map(pathlib.Path, sys.argv[1:3])


def write(writer, data, name):
    writer.SetFileName(str(DEST / name))
    writer.SetInputData(data)
    if not writer.Write():
        sys.exit(f"makeData.py: {DEST / name} cannot be written")


def make_bunny():
    words = (DATA / "bunny.off").read_text().split()
    count, faces = int(words[1]), int(words[2])
    places = numpy.array(words[4:4 + 3 * count], dtype=numpy.float32).reshape(-1, 3)
    corners = numpy.array(words[4 + 3 * count:4 + 3 * count + 4 * faces], dtype=numpy.int64)
    bunny = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    bunny.SetPoints(points)
    triangles = vtkCellArray()
    triangles.ImportLegacyFormat(numpy_to_vtkIdTypeArray(corners, deep=True))
    bunny.SetPolys(triangles)
    height = numpy_to_vtk(places[:, 1] - places[:, 1].min(), deep=True)
    height.SetName("height")
    bunny.GetPointData().AddArray(height)
    smooth = vtkPolyDataNormals()
    smooth.SetInputData(bunny)
    smooth.SplittingOff()
    smooth.Update()
    write(vtkXMLPolyDataWriter(), smooth.GetOutput(), "bunny.vtp")


def make_labels():
    reader = vtkNIFTIImageReader()
    reader.SetFileName(str(DATA / "aal.nii.gz"))
    half = vtkImageShrink3D()
    half.SetInputConnection(reader.GetOutputPort())
    half.SetShrinkFactors(2, 2, 2)
    half.AveragingOff()
    half.Update()
    labels = half.GetOutput()
    labels.GetPointData().GetScalars().SetName("label")
    write(vtkXMLImageDataWriter(), labels, "labels.vti")


make_bunny()
make_labels()
