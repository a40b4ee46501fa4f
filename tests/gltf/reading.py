# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Helpers for the tests of glTF: reading a file with the reader, and comparing the result with
the evaluator's truth, corner by corner."""

import pathlib
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import evaluator
import relievo

NODES = relievo.vtkRelievoModelReader.POSE_NODES
ANIMATION = relievo.vtkRelievoModelReader.POSE_ANIMATION

VERSION = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())


class GltfTest(unittest.TestCase):
    """Each test has an empty folder of its own."""

    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name).resolve()

    def read(self, path, pose=NODES, time=None):
        """Returns the reader and the errors that it reported."""
        reader = relievo.vtkRelievoModelReader()
        reader.SetFileName(str(path))
        reader.SetPose(pose)
        reader.SetWeightsPerPoint(8)
        errors = []

        def hear(_object, _event, text):
            errors.append(text)

        hear.CallDataType = "string0"
        reader.AddObserver("ErrorEvent", hear)
        reader.Update() if time is None else reader.UpdateTimeStep(time)
        return reader, errors

    def refused(self, path, *says):
        """Reading gives one error that names the file and says these words, and nothing else."""
        reader, errors = self.read(path)
        self.assertEqual(len(errors), 1, errors)
        self.assertNotEqual(reader.GetErrorCode(), 0)
        self.assertEqual(reader.GetOutput().GetNumberOfBlocks(), 0)
        for words in (path.name, *says):
            self.assertIn(words, errors[0])

    def notes(self, reader):
        return [reader.GetNote(i) for i in range(reader.GetNumberOfNotes())]

    def compare(self, path, animation=None, time=0.0, notes=()):
        """Compares all that the reader gives of meshes with the truth; returns the reader."""
        pose = NODES if animation is None else ANIMATION
        reader, errors = self.read(path, pose, None if animation is None else time)
        self.assertEqual(errors, [])
        for words in notes:
            self.assertTrue(any(words in note for note in self.notes(reader)), self.notes(reader))
        if not notes:
            self.assertEqual(self.notes(reader), [])
        truth = evaluator.Scene(path, animation, time).primitives()
        output = reader.GetOutput()
        self.assertEqual(output.GetNumberOfBlocks(), len(truth))
        for i, primitive in enumerate(truth):
            with self.subTest(path=path.name, block=i, time=time):
                self.compare_block(output.GetBlock(i), primitive)
        return reader

    def compare_block(self, block, truth):
        cells = cells_of(block)
        self.assertEqual(cells.shape, truth.cells.shape)
        size = max(numpy.abs(truth.points).max(), 1e-30)
        points = vtk_to_numpy(block.GetPoints().GetData())[cells]
        self.assertLess(numpy.abs(points - truth.points).max() / size, 1e-6)
        data = block.GetPointData()
        self.assertEqual(data.GetNormals() is None, truth.normals is None)
        if truth.normals is not None:
            normals = vtk_to_numpy(data.GetNormals())[cells]
            known = numpy.isfinite(truth.normals)  # triangles without area have none
            self.assertTrue(known.any())
            self.assertLess(numpy.abs(normals - truth.normals)[known].max(), 2e-6)
        self.assertEqual(data.GetTangents() is None, truth.tangents is None)
        if truth.tangents is not None:
            tangents = vtk_to_numpy(data.GetTangents())[cells]
            self.assertLess(numpy.abs(tangents - truth.tangents).max(), 2e-6)
        if truth.coordinates is not None:
            given = vtk_to_numpy(data.GetTCoords())[cells]
            wanted = truth.coordinates * [1, -1] + [0, 1]  # v upwards
            size = max(numpy.abs(wanted).max(), 1)
            self.assertLess(numpy.abs(given - wanted).max() / size, 1e-6)
        self.assertEqual(data.HasArray("RGBA"), int(truth.colors is not None))
        if truth.colors is not None:
            self.compare_colors(vtk_to_numpy(data.GetArray("RGBA"))[cells], truth)

    def compare_colors(self, given, truth):
        """Base colour times the points' colours; alpha is that of the points."""
        base = truth.material.get("pbrMetallicRoughness", {}).get("baseColorFactor", [1] * 4)
        wanted = truth.colors * [*base[:3], 1]
        unlit = "KHR_materials_unlit" in truth.material.get("extensions", {})
        light = wanted[..., :3]
        if unlit and "baseColorTexture" not in truth.material.get("pbrMetallicRoughness", {}):
            light[:] = numpy.where(light <= 0.0031308, 12.92 * light,
                                   1.055 * light ** (1 / 2.4) - 0.055)  # fmt: skip
        elif unlit or VERSION >= (9, 7):
            light **= 1 / 2.2
        if truth.material.get("alphaMode", "OPAQUE") == "OPAQUE":
            wanted[..., 3] = 1
        self.assertLessEqual(numpy.abs(given - 255 * wanted).max(), 0.51)


def cells_of(block):
    """The points of each cell, of which all are of one kind."""
    for cells in (block.GetPolys(), block.GetLines(), block.GetVerts()):
        if cells.GetNumberOfCells() > 0:
            corners = vtk_to_numpy(cells.GetConnectivityArray())
            return corners.reshape(cells.GetNumberOfCells(), -1)
    return numpy.zeros((0, 3), int)


def times_of(reader):
    """Those of the animation that is played."""
    information = reader.GetOutputInformation(0)
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    return [information.Get(key, i) for i in range(information.Length(key))]
