# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the output of filters for blocks, caves, voxels and particles: volumeRanks.py FOLDER
RANKS

Each rank writes its part of each output as FOLDER/NAME-RANKS-RANK.npy: a table with a row for each
point or cell that is no ghost.
"""

import sys

import pv
from paraview import simple

FOLDER, RANKS = sys.argv[1:3]

# Run by ParaView on each rank.
WRITE = """
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

def owned(data, count):
    ghosts = data.GetCellData().GetArray("vtkGhostType")
    return vtk_to_numpy(ghosts) == 0 if ghosts else numpy.ones(count, bool)

def indices(image, points):
    # x fastest, as VTK has them.
    e = image.GetExtent()
    axes = [numpy.arange(e[2 * a], e[2 * a + 1] + points) for a in (2, 1, 0)]
    return numpy.stack(numpy.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)

def triangles(data):
    count = data.GetNumberOfCells()
    points = vtk_to_numpy(data.GetPoints().GetData())
    normals = vtk_to_numpy(data.GetPointData().GetNormals())
    corners = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(count, 3)
    material = vtk_to_numpy(data.GetCellData().GetArray("material"))
    table = [points[corners].reshape(count, 9), normals[corners].reshape(count, 9), material]
    return numpy.column_stack(table)[owned(data, count)]

def samples(image, name):
    values = vtk_to_numpy(image.GetPointData().GetArray(name))
    return numpy.column_stack([indices(image, 1), values])

def cells(image, name):
    values = vtk_to_numpy(image.GetCellData().GetArray(name))
    return numpy.column_stack([indices(image, 0), values])[owned(image, len(values))]

def places(data, name):
    values = vtk_to_numpy(data.GetPointData().GetArray(name))
    return numpy.column_stack([vtk_to_numpy(data.GetPoints().GetData()), values])

data = self.GetInputDataObject(0, 0)
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
table = CALL if data.GetNumberOfPoints() else numpy.zeros((0, 1))
numpy.save("FILE-%d.npy" % rank, table)
"""

# Every rank makes the whole ball: voxels and particles need the whole surface.
BALL = """
from vtkmodules.vtkFiltersSources import vtkSphereSource
sphere = vtkSphereSource()
sphere.SetThetaResolution(40)
sphere.SetPhiResolution(20)
sphere.Update()
self.GetOutput().ShallowCopy(sphere.GetOutput())
"""


def write(source, name, call, time=0.0):
    """Has every rank write its part."""
    script = WRITE.replace("CALL", call).replace("FILE", f"{FOLDER}/{name}-{RANKS}")
    writer = simple.ProgrammableFilter(Input=source, Script=script)
    writer.UpdatePipeline(time)


pv.load()
caves = simple.Caves(Size=[40, 32, 24], Seed=3, Content="Labels", Scale=16.0, TunnelWidth=5.0)
write(caves, "caves", "samples(data, 'label')")
write(simple.SmoothBlocks(Input=caves), "blocks", "triangles(data)")
ball = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=BALL)
shell = simple.VoxelShell(Input=ball, Resolution=24)
write(shell, "shell", "cells(data, 'mask')")
write(simple.VoxelCubes(Input=shell, Transition=0.1), "cubes", "places(data, 'size')")
particles = simple.SurfaceParticles(Input=ball, NumberOfParticles=500, Resolution=64)
particles.NoiseSpeed = 0.05
write(particles, "particles", "places(data, 'particle')", 7.0)
