# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Models with bones in ParaView: opened by their names, played by its time controls, skinned."""

import numpy
import pv
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

WALK = str(pv.DATA / "models/BVH/01_01.bvh")
FIGURE = str(pv.DATA / "models/X/Testwuson.X")


def points(source, port=0):
    """The points of all meshes of a source."""
    made = servermanager.Fetch(servermanager.OutputPort(source, port))
    blocks = [made]
    if made.IsA("vtkMultiBlockDataSet"):
        blocks = [made.GetBlock(i) for i in range(made.GetNumberOfBlocks())]
    return numpy.concatenate([vtk_to_numpy(block.GetPoints().GetData()) for block in blocks])


class Models(pv.Test):
    @classmethod
    def setUpClass(cls):
        pv.load()

    def setUp(self):
        pv.clear()

    def test_opened_and_played(self):
        reader = simple.OpenDataFile(WALK)
        self.assertEqual(reader.SMProxy.GetXMLName(), "RelievoModelReader")
        reader.UpdatePipelineInformation()
        times = list(reader.TimestepValues)
        self.assertEqual(len(times), 2752)
        self.assertAlmostEqual(times[-1], 2751 / 120, delta=1e-3)  # "0.0083333" a frame
        view = simple.CreateRenderView()
        simple.Show(servermanager.OutputPort(reader, 0), view)
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        seen = []
        for time in (times[0], times[1000]):
            scene.AnimationTime = time
            seen.append(points(reader))
        self.assertGreater(numpy.abs(seen[0] - seen[1]).max(), 1)
        self.assertEqual(points(reader, 1).shape[1], 3)

    def test_animation_by_name_and_skin(self):
        reader = simple.ModelWithBonesReader(FileName=FIGURE)
        reader.UpdatePipelineInformation()
        names = list(reader.GetProperty("AnimationNames"))
        self.assertEqual(len(names), 3)
        reader.Animation = names[1]
        reader.UpdatePipeline(0.3)
        moved = points(reader)
        rest = simple.ModelWithBonesReader(FileName=FIGURE, Animation=names[1], Pose="Rest")
        rest.UpdatePipeline(0.3)
        self.assertGreater(numpy.abs(points(rest) - moved).max(), 0.1)
        skin = simple.Skin(Input=servermanager.OutputPort(rest, 0),
                           Skeleton=servermanager.OutputPort(rest, 1))  # fmt: skip
        skin.UpdatePipeline(0.3)
        self.assertTrue((points(skin) == moved).all())


if __name__ == "__main__":
    pv.main()
