# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Models with bones in ParaView: opened by their names, played by its time controls, skinned.

With the words `restore STATE PICTURE` the script draws a state; with `ranks FILE` it counts
the figure's points and cells on all ranks together, at rest, moved by the reader, and moved
by Skin.
"""

import json
import pathlib
import sys

import numpy
import pv
from paraview import servermanager, simple, smstate, smtrace
from vtkmodules.util.numpy_support import vtk_to_numpy

WALK = str(pv.DATA / "models/BVH/01_01.bvh")
STRIP = str(pv.DATA / "models/glTF2/simple_skin/simple_skin.gltf")
FIGURE = str(pv.DATA / "models/X/Testwuson.X")

# A bone may be called as ParaView calls none elsewhere.
NONE = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 3 Zrotation Xrotation Yrotation
  JOINT None
  {
    OFFSET 0 1 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 1 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.1
0 0 0 0 0 0
0 0 0 90 0 0
"""


def points(source, port=0):
    """The points of all meshes of a source."""
    made = servermanager.Fetch(source, idx=port)
    blocks = [made]
    if made.IsA("vtkMultiBlockDataSet"):
        blocks = [made.GetBlock(i) for i in range(made.GetNumberOfBlocks())]
    return numpy.concatenate([vtk_to_numpy(block.GetPoints().GetData()) for block in blocks])


def pose(names):
    """Settings unlike the defaults."""
    return {
        "Animation": names[1],
        "BlendAnimation": names[0],
        "BlendWeight": 0.25,
        "Method": "Dual Quaternion",
        "WeightsPerPoint": 3,
        "Slerp": 0,
        "KeyRate": 5.0,
        "Loop": 1,
        "Speed": 2.0,
        "SkeletonAxes": 1,
        "AxisLength": 0.5,
        "FirstBone": 1,
    }


def count_on_ranks(path):
    """Writes the number of points, and the bounds, of all ranks together."""
    pv.load()
    found = {}
    reader = simple.ModelWithBonesReader(FileName=FIGURE)
    rest = simple.ModelWithBonesReader(FileName=FIGURE, Pose="Rest")
    skin = simple.Skin(Input=servermanager.OutputPort(rest, 0),
                       Skeleton=servermanager.OutputPort(rest, 1))  # fmt: skip
    for name, source in (("moved", reader), ("rest", rest), ("skin", skin)):
        source.UpdatePipeline(0.3)
        about = source.GetDataInformation()
        found[name] = [about.GetNumberOfPoints(), *about.GetBounds()]
    found["joints"] = rest.GetDataInformation(1).GetNumberOfPoints()
    pathlib.Path(path).write_text(json.dumps(found))


class Models(pv.PluginTest):
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

    def test_gltf(self):
        """Read by Relievo's reader, where it is asked for: the strip bends in time."""
        reader = simple.ModelWithBonesReader(FileName=STRIP)
        reader.UpdatePipelineInformation()
        times = list(reader.TimestepValues)
        seen = []
        for time in (times[0], times[len(times) // 3]):
            reader.UpdatePipeline(time)
            seen.append(points(reader))
        self.assertEqual(seen[0].shape[1], 3)
        self.assertGreater(numpy.abs(seen[0] - seen[1]).max(), 0.1)

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
        # Bones of the meshes at rest, shown on the moved ones.
        bones = simple.BoneWeights(Input=servermanager.OutputPort(rest, 0))
        bones.UpdatePipeline(0.3)
        first = bones.PointData["first_bone"].GetRange()
        self.assertGreater(first[1], first[0])
        bones.Bone = int(first[1])
        skin.Input = bones
        skin.UpdatePipeline(0.3)
        self.assertTrue((points(skin) == moved).all())
        self.assertGreater(skin.PointData["bone_weight"].GetRange()[1], 0.5)

    def test_blend_and_look(self):
        reader = simple.ModelWithBonesReader(FileName=FIGURE, SkeletonAxes=1, FirstBone=1)
        reader.UpdatePipelineInformation()
        names = list(reader.GetProperty("AnimationNames"))
        bones = list(reader.GetProperty("BoneNames"))
        self.assertGreater(len(bones), 10)
        self.assertEqual(reader.BlendAnimation, "")
        self.assertEqual(reader.WeightsOf, "")
        reader.Animation = names[0]
        seen = []
        for weight in (0, 0.5, 1):
            reader.BlendAnimation, reader.BlendWeight = names[1], weight
            reader.UpdatePipeline(0.3)
            seen.append(points(reader))
        self.assertGreater(numpy.abs(seen[0] - seen[2]).max(), 0.1)
        self.assertGreater(numpy.abs(seen[0] - seen[1]).max(), 0.01)
        self.assertGreater(numpy.abs(seen[2] - seen[1]).max(), 0.01)
        other = simple.ModelWithBonesReader(FileName=FIGURE, Animation=names[1])
        other.UpdatePipeline(0.3)
        self.assertLess(numpy.abs(points(other) - seen[2]).max(), 1e-4)
        reader.WeightsOf = bones[3]
        reader.UpdatePipeline(0.3)
        mesh = servermanager.Fetch(reader).GetBlock(0)
        for name in ("first_bone", "bone_weight"):
            self.assertTrue(mesh.GetPointData().GetArray(name), name)
        skeleton = servermanager.Fetch(reader, idx=1)
        self.assertTrue(skeleton.GetCellData().GetArray("axis_color"))

    def test_no_name(self):
        """The lists' word for none is none; and a bone called None is a bone."""
        reader = simple.ModelWithBonesReader(FileName=FIGURE)
        reader.UpdatePipeline(0.3)
        alone = points(reader)
        for name in ("BlendAnimation", "WeightsOf"):
            words = list(reader.GetProperty(name).GetAvailable())
            self.assertEqual(words[0], "(none)")
            setattr(reader, name, words[-1])
            reader.UpdatePipeline(0.3)
        self.assertGreater(numpy.abs(points(reader) - alone).max(), 0.01)
        reader.BlendAnimation = reader.WeightsOf = "(none)"
        reader.UpdatePipeline(0.3)
        self.assertTrue((points(reader) == alone).all())
        self.assertIsNone(reader.PointData["bone_weight"])
        path = pv.OUTPUT / "none.bvh"
        path.write_text(NONE)
        reader = simple.ModelWithBonesReader(FileName=str(path), WeightsOf="None")
        reader.UpdatePipeline(0)
        self.assertEqual(reader.PointData["bone_weight"].GetRange(), (0, 1))

    def test_state(self):
        """States restored in fresh processes give the picture, to the bit."""
        reader = simple.ModelWithBonesReader(FileName=FIGURE)
        reader.UpdatePipelineInformation()
        for name, value in pose(list(reader.GetProperty("AnimationNames"))).items():
            setattr(reader, name, value)
        view = simple.CreateRenderView(ViewSize=[240, 180], MultiSamples=0, UseFXAA=0)
        simple.Show(servermanager.OutputPort(reader, 0), view)
        joints = simple.Glyph(Input=servermanager.OutputPort(reader, 1), GlyphType="Sphere")
        joints.ScaleArray, joints.ScaleFactor = ["POINTS", "No scale array"], 0.03
        simple.Show(joints, view)
        simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
        view.ViewTime = 0.2
        simple.GetAnimationScene().AnimationTime = 0.2
        # Numbers that a state file holds to the last bit.
        view.CameraPosition, view.CameraFocalPoint = [1.5, 2.5, 1.0], [0.0, 0.25, 0.0]
        view.CameraViewUp = [0.0, 1.0, 0.0]
        picture = pv.picture(view)
        reader.BlendWeight = 0.75
        self.differ(pv.picture(view), picture, "another weight", share=0.001)
        reader.BlendWeight = 0.25
        pvsm, python = pv.OUTPUT / "state.pvsm", pv.OUTPUT / "state.py"
        simple.SaveState(str(pvsm))
        # ParaView's states in Python hold no time.
        simple.GetAnimationScene().AnimationTime = 0.0
        view.ViewTime = 0.0
        python.write_text(smstate.get_state())
        for state, picture in ((pvsm, picture), (python, pv.picture(view))):
            found = pv.OUTPUT / (state.name + ".npy")
            said = pv.run(__file__, "restore", state, found, tool="pvbatch")
            self.assertEqual(pv.messages(said), [], state.name)
            self.same(numpy.load(found), picture, state.name)

    def test_trace(self):
        smtrace.start_trace()
        reader = simple.ModelWithBonesReader(FileName=FIGURE)
        reader.UpdatePipelineInformation()
        settings = pose(list(reader.GetProperty("AnimationNames")))
        item = smtrace._create_trace_item_internal("PropertiesModified", kwargs={"proxy": reader})
        for name, value in settings.items():
            setattr(reader, name, value)
        item.finalize()
        del item
        trace = smtrace.stop_trace()
        for name, value in settings.items():
            self.traced(trace, name, value)

    def test_ranks(self):
        """Two ranks together have each mesh once, where one alone has it."""
        found = {}
        for ranks in (1, 2):
            path = pv.OUTPUT / f"ranks{ranks}.json"
            said = pv.run(__file__, "ranks", path, tool="pvbatch", launcher=pv.mpirun(ranks))
            self.assertEqual(pv.messages(said), [])
            found[ranks] = json.loads(path.read_text())
        self.assertGreater(found[1]["rest"][0], 100)
        self.assertNotEqual(found[1]["rest"][1:], found[1]["moved"][1:])
        self.assertEqual(found[1]["skin"], found[1]["moved"])
        self.assertEqual(found[1], found[2])


if __name__ == "__main__":
    if sys.argv[1:2] == ["restore"]:
        pv.load()
        pv.restore(*sys.argv[2:])
        pv.leave()
    elif sys.argv[1:2] == ["ranks"]:
        count_on_ranks(sys.argv[2])
    else:
        pv.main()
