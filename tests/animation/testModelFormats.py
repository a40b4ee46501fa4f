# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Models of other formats than glTF against the files' own numbers: the triangles of Collada, by a
small evaluator in double that shares no code with Assimp; mirrored nodes, names, encodings."""

import os
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import numpy
import relievo
from vtkmodules.util.numpy_support import vtk_to_numpy

# A number that begins with a space, which Assimp refuses; decimal commas, which are not valid.
OTHERS = ("library_animation_clips.dae", "earthCylindrical.DAE", "teapots.DAE")
FOLDER = pathlib.Path(os.environ["RELIEVO_DATA"]) / "formats"

# A tetrahedron whose normals point outwards, at nodes that are put here; a scale that an animation
# turns into a mirror.
SOLID = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], float)
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
TEXT = """<?xml version="1.0" encoding="{code}"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1" name="meter"/><up_axis>Y_UP</up_axis></asset>
<library_animations><animation id="a">
<source id="t"><float_array id="ta" count="2">0 1</float_array><technique_common>
<accessor source="#ta" count="2" stride="1"><param name="TIME" type="float"/>
</accessor></technique_common></source>
<source id="o"><float_array id="oa" count="6">1 1 1 -1 1 1</float_array>
<technique_common><accessor source="#oa" count="2" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="i"><Name_array id="ia" count="2">LINEAR LINEAR</Name_array><technique_common>
<accessor source="#ia" count="2" stride="1"><param name="INTERPOLATION" type="name"/></accessor>
</technique_common></source>
<sampler id="m"><input semantic="INPUT" source="#t"/><input semantic="OUTPUT" source="#o"/>
<input semantic="INTERPOLATION" source="#i"/></sampler>
<channel source="#m" target="turning/size"/></animation></library_animations>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">{points}</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="n"><float_array id="na" count="12">{normals}</float_array><technique_common>
<accessor source="#na" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="NORMAL" source="#n" offset="1"/><p>{corners}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s">{nodes}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""
MESH = '<instance_geometry url="#g"/>'
NODES = {
    "plain": f'<node id="plain">{MESH}</node>',
    "mirror": f'<node id="a"><scale>-2 1 1</scale>{MESH}</node>',
    "parent": '<node id="a"><matrix>1 0 0 3 0 0 1 0 0 1 0 0 0 0 0 1</matrix>'
              f'<node id="b"><scale>1 3 1</scale>{MESH}</node></node>',
    "both": f'<node id="a"><scale>-1 1 1</scale><node id="b"><scale>1 1 -1</scale>{MESH}</node>'
            "</node>",
    "all axes": f'<node id="a"><scale>-1 -1 -1</scale>{MESH}</node>',
    "turning": f'<node id="turning"><scale sid="size">1 1 1</scale>{MESH}</node>',
}  # fmt: skip


def write(path, nodes, code="utf-8"):
    normals = [numpy.cross(SOLID[b] - SOLID[a], SOLID[c] - SOLID[a]) for a, b, c in FACES]
    corners = " ".join(f"{corner} {i}" for i, face in enumerate(FACES) for corner in face)
    text = TEXT.format(code=code, nodes=nodes, corners=corners,
                       points=" ".join(map(str, SOLID.ravel())),
                       normals=" ".join(map(str, numpy.ravel(normals))))  # fmt: skip
    path.write_bytes(text.encode(code))


class Collada:
    """Where the file's visual scene puts the corners of its triangles, at rest, in metres with y
    up; polygons are cut into as many triangles as they have."""

    def __init__(self, path):
        root = ElementTree.fromstring(path.read_bytes())
        self.name = root.tag[: root.tag.index("}") + 1]
        self.ids = {each.get("id"): each for each in root.iter() if each.get("id")}
        unit = root.find(f"{self.name}asset/{self.name}unit")
        axis = root.findtext(f"{self.name}asset/{self.name}up_axis") or "Y_UP"
        turn = {
            "X_UP": [[0, -1, 0], [1, 0, 0], [0, 0, 1]],
            "Y_UP": numpy.eye(3),
            "Z_UP": [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
        }[axis.strip()]
        world = numpy.eye(4)
        world[:3, :3] = numpy.array(turn) * float(
            unit.get("meter", 1) if unit is not None else 1
        )
        self.corners = []  # of each triangle or polygon, as an array
        self.bent = root.find(f".//{self.name}instance_controller") is not None
        scene = root.find(f"{self.name}scene/{self.name}instance_visual_scene")
        for node in self.all(self.refer(scene.get("url")), "node"):
            self.walk(node, world)

    def all(self, element, tag):
        return element.findall(self.name + tag)

    def refer(self, url):
        return self.ids[url.lstrip("#")]

    def walk(self, node, world):
        for part in node:
            tag = part.tag[len(self.name) :]
            numbers = [float(word) for word in (part.text or "").split()] if tag in (
                "matrix", "translate", "rotate", "scale") else []  # fmt: skip
            m = numpy.eye(4)
            if tag == "matrix":
                m = numpy.reshape(numbers, (4, 4))
            elif tag == "translate":
                m[:3, 3] = numbers
            elif tag == "scale":
                m[:3, :3] = numpy.diag(numbers)
            elif tag == "rotate" and any(numbers[:3]):
                axis = numpy.array(numbers[:3]) / numpy.linalg.norm(numbers[:3])
                c, s = numpy.cos(numpy.radians(numbers[3])), numpy.sin(numpy.radians(numbers[3]))
                x, y, z = axis
                cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
                m[:3, :3] = c * numpy.eye(3) + s * cross + (1 - c) * numpy.outer(axis, axis)
            world = world @ m
        for child in self.all(node, "node"):
            self.walk(child, world)
        for instance in self.all(node, "instance_node"):
            self.walk(self.refer(instance.get("url")), world)
        for instance in self.all(node, "instance_geometry"):
            for mesh in self.all(self.refer(instance.get("url")), "mesh"):
                self.read(mesh, world)

    def read(self, mesh, world):
        for primitive in mesh:
            tag = primitive.tag[len(self.name) :]
            inputs = self.all(primitive, "input")
            if tag not in ("triangles", "polygons", "polylist", "tristrips") or not inputs:
                continue
            stride = 1 + max(int(each.get("offset", 0)) for each in inputs)
            place = next(each for each in inputs if each.get("semantic") == "VERTEX")
            offset = int(place.get("offset", 0))
            points = self.points(self.refer(place.get("source"))) @ world[:3, :3].T + world[:3, 3]
            lists = [numpy.array(each.text.split(), int).reshape(-1, stride)[:, offset]
                     for each in self.all(primitive, "p") if each.text and each.text.strip()]
            if tag == "triangles":
                lists = [three for each in lists for three in each.reshape(-1, 3)]
            elif tag == "polylist":
                counts = numpy.array(primitive.findtext(self.name + "vcount").split(), int)
                lists = numpy.split(lists[0], numpy.cumsum(counts)[:-1])
            elif tag == "tristrips":
                lists = [each[i : i + 3] for each in lists for i in range(len(each) - 2)]
            self.corners += [points[each] for each in lists]

    def points(self, vertices):
        place = next(each for each in self.all(vertices, "input")
                     if each.get("semantic") == "POSITION")
        source = self.refer(place.get("source"))
        numbers = numpy.array(source.findtext(self.name + "float_array").split(), float)
        accessor = source.find(f"{self.name}technique_common/{self.name}accessor")
        return numbers.reshape(-1, int(accessor.get("stride", 1)))[:, :3]


def read(path, pose=relievo.vtkRelievoModelReader.POSE_NODES):
    """The reader, its reports, and the corners of all of its triangles."""
    reader = relievo.vtkRelievoModelReader()
    reader.SetFileName(str(path))
    reader.SetPose(pose)
    errors = []

    def hear(_object, _event, text):
        errors.append(text)

    hear.CallDataType = "string0"
    reader.AddObserver("ErrorEvent", hear)
    reader.Update()
    output = reader.GetOutput()
    found = [numpy.zeros((0, 3, 3))]
    for i in range(output.GetNumberOfBlocks()):
        block = output.GetBlock(i)
        corners = vtk_to_numpy(block.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        found.append(vtk_to_numpy(block.GetPoints().GetData()).astype(float)[corners])
    return reader, errors, numpy.concatenate(found)


def area(corners):
    """The vector area of a polygon."""
    return 0.5 * numpy.cross(corners, numpy.roll(corners, -1, axis=0)).sum(axis=0)


def against(block):
    """The share of the corners of a block's triangles whose normal points to their inside."""
    corners = vtk_to_numpy(block.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(block.GetPoints().GetData()).astype(float)[corners]
    normals = vtk_to_numpy(block.GetPointData().GetNormals())[corners]
    faces = numpy.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
    return (numpy.einsum("fi,fci->fc", faces, normals) < 0).mean()


class Written(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.path = pathlib.Path(kept.name) / "a.dae"

    def test_mirrors(self):
        """The outside stays outside: of nodes, of their parents, of an animation."""
        for name, nodes in NODES.items():
            write(self.path, nodes)
            truth = numpy.array(Collada(self.path).corners)
            for pose in ("POSE_NODES", "POSE_REST", "POSE_ANIMATION"):
                pose_number = getattr(relievo.vtkRelievoModelReader, pose)
                reader, errors, found = read(self.path, pose_number)
                with self.subTest(name=name, pose=pose):
                    self.assertEqual(errors, [])
                    self.assertEqual(against(reader.GetOutput().GetBlock(0)), 0)
                    middles = found.mean(axis=1)
                    for middle in truth.mean(axis=1):
                        self.assertLess(numpy.abs(middles - middle).max(axis=1).min(), 1e-6)
        reader, _, _ = read(self.path, relievo.vtkRelievoModelReader.POSE_ANIMATION)
        for time, left in ((0.25, 0), (0.75, -0.5), (1, -1)):
            reader.UpdateTimeStep(time)
            block = reader.GetOutput().GetBlock(0)
            self.assertAlmostEqual(block.GetBounds()[0], left)
            self.assertEqual(against(block), 0)

    def test_encodings(self):
        for code in ("utf-8", "utf-8-sig", "utf-16", "utf-16-be"):
            write(self.path, '<node id="Kr\u00fcmmung \u4e2d \U0001f600">' + MESH + "</node>", code)
            if code == "utf-16-be":  # which Python writes without a mark
                self.path.write_bytes(b"\xfe\xff" + self.path.read_bytes())
            reader, errors, found = read(self.path)
            with self.subTest(code=code):
                self.assertEqual(errors, [])
                self.assertEqual(len(found), 4)
                array = reader.GetOutputDataObject(1).GetPointData().GetAbstractArray("name")
                names = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
                self.assertIn("Kr\u00fcmmung \u4e2d \U0001f600", names)


FBX = """; FBX 7.3.0 project file
FBXHeaderExtension:  {
    FBXHeaderVersion: 1003
    FBXVersion: 7300
}
Objects:  {
    Geometry: 10, "Geometry::", "Mesh" {
        Vertices: *9 {
            a: 0,0,0,1,0,0,0,1,0
        }
        PolygonVertexIndex: *3 {
            a: 0,1,-3
        }
    }
    Model: 20, "Model::parent", "Null" {
        Properties70:  {
            @PIVOT@
            P: "Lcl Scaling", "Lcl Scaling", "", "A",@SCALE@
        }
    }
    Model: 21, "Model::child", "Mesh" {
        Properties70:  {
            P: "InheritType", "enum", "", "",@TYPE@
            @PIVOT@
            P: "Lcl Translation", "Lcl Translation", "", "A",1,0,0
        }
    }
}
Connections:  {
    C: "OO",20,0
    C: "OO",21,20
    C: "OO",10,21
}
"""


class Scales(unittest.TestCase):
    def test_inherit_type(self):
        """Handling of a parent's scale unknown to Assimp is noted."""
        pivot = 'P: "ScalingPivot", "Vector3D", "Vector", "",1,2,3'  # makes chains of nodes
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.fbx"
            for inherit in (0, 1, 2):
                for scale in ("1,1,1", "1,3,1"):
                    for chain in ("", pivot):
                        text = FBX.replace("@TYPE@", str(inherit)).replace("@SCALE@", scale)
                        path.write_text(text.replace("@PIVOT@", chain))
                        reader, errors, _ = read(path)
                        notes = [reader.GetNote(i) for i in range(reader.GetNumberOfNotes())]
                        with self.subTest(inherit=inherit, scale=scale, chain=bool(chain)):
                            self.assertEqual(errors, [])
                            says = "node 'child' is to leave out the scale of its parent 'parent'"
                            told = [note for note in notes if says in note]
                            self.assertEqual(len(told), inherit == 2 and scale != "1,1,1", notes)


MATERIAL = """    Material: 40, "Material::", "" {
        ShadingModel: "unknown"
        Properties70:  {
            P: "DiffuseColor", "Color", "", "A",0.5,0.5,0.5
            @COLOR@
        }
    }
"""
LAYER = """
        LayerElementMaterial: 0 {
            MappingInformationType: "AllSame"
            ReferenceInformationType: "IndexToDirect"
            Materials: *1 {
                a: 0
            }
        }
        Layer: 0 {
            LayerElement:  {
                Type: "LayerElementMaterial"
                TypedIndex: 0
            }
        }
    }
    Model: 20"""
MAP = """    Texture: 41, "Texture::", "" {
        FileName: "a.png"
        RelativeFilename: "a.png"
    }
"""


class Colors(unittest.TestCase):
    def test_3ds_max(self):
        """The colour of its physical and PBR materials; a map replaces it."""
        physical = 'P: "3dsMax|Parameters|base_color", "ColorAndAlpha", "", "A",1,0.5,0,1'
        weight = 'P: "3dsMax|Parameters|base_weight", "Float", "", "A",0.5'
        pbr = 'P: "3dsMax|main|basecolor", "ColorAndAlpha", "", "A",0,0.25,1,1'
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.fbx"
            for color, slot, expected in (
                ("", None, (0.5, 0.5, 0.5, 1)),
                (physical, None, (1, 0.5, 0, 1)),
                (physical + "\n" + weight, None, (0.5, 0.25, 0, 1)),
                (physical + "\n" + weight.replace("0.5", "nan"), None, (1, 0.5, 0, 1)),
                (physical + "\n" + weight, "Parameters", (0.5, 0.5, 0.5, 1)),
                (pbr, None, (0, 0.25, 1, 1)),
                (pbr, "main", (1, 1, 1, 1)),
            ):
                text = FBX.replace("@TYPE@", "0").replace("@SCALE@", "1,1,1").replace("@PIVOT@", "")
                objects = MATERIAL.replace("@COLOR@", color) + (MAP if slot else "")
                lines = 'C: "OO",40,21\n'
                if slot:
                    lines += f'C: "OP",41,40, "3dsMax|{slot}|base_color_map"\n'
                text = text.replace("\n    }\n    Model: 20", LAYER)
                text = text.replace("    Geometry:", objects + "    Geometry:")
                path.write_text(text.replace('C: "OO",20,0', lines + 'C: "OO",20,0'))
                reader, errors, _ = read(path)
                with self.subTest(color=color, slot=slot):
                    self.assertEqual(errors, [])
                    fields = reader.GetOutput().GetBlock(0).GetFieldData()
                    found = fields.GetArray("base_color").GetTuple4(0)
                    numpy.testing.assert_allclose(found, expected, atol=1e-6)
                    texture = fields.GetAbstractArray("base_color_texture")
                    self.assertEqual(bool(texture), bool(slot))


SKIN = FBX[: FBX.index("    Model: 20")] + """
    Model: 20, "Model::bone", "LimbNode" {
        Properties70:  {
            P: "Lcl Translation", "Lcl Translation", "", "A",@BONE@,0,0
        }
    }
    Model: 21, "Model::body", "Mesh" {
        Properties70:  {
            P: "Lcl Translation", "Lcl Translation", "", "A",@NODE@,0,0
            P: "GeometricTranslation", "Vector3D", "Vector", "",@GEOMETRIC@,0,0
            P: "GeometricRotation", "Vector3D", "Vector", "",0,0,@TURN@
            P: "GeometricScaling", "Vector3D", "Vector", "",@SIZE@,1,1
        }
    }
    Deformer: 30, "Deformer::", "Skin" {
        Version: 101
    }
    Deformer: 31, "SubDeformer::", "Cluster" {
        Version: 100
        Indexes: *3 {
            a: 0,1,2
        }
        Weights: *3 {
            a: 1,1,1
        }
        Transform: *16 {
            a: 1,0,0,0,0,1,0,0,0,0,1,0,@TRANSFORM@,0,0,1
        }
        TransformLink: *16 {
            a: 1,0,0,0,0,1,0,0,0,0,1,0,@LINK@,0,0,1
        }
    }
    AnimationStack: 50, "AnimStack::take", "" {
    }
    AnimationLayer: 51, "AnimLayer::base", "" {
    }
    AnimationCurveNode: 52, "AnimCurveNode::T", "" {
        Properties70:  {
            P: "d|X", "Number", "", "A",0
        }
    }
    AnimationCurve: 53, "AnimCurve::", "" {
        KeyTime: *2 {
            a: 0,46186158000
        }
        KeyValueFloat: *2 {
            a: 0,10
        }
    }
}
Connections:  {
    C: "OO",20,0
    C: "OO",21,@PARENT@
    C: "OO",10,21
    C: "OO",30,10
    C: "OO",31,30
    C: "OO",20,31
    C: "OO",51,50
    C: "OO",52,51
    C: "OP",52,@MOVES@,"Lcl Translation"
    C: "OP",53,52,"d|X"
}
"""


class Skins(unittest.TestCase):
    def test_own_node(self):
        """A skinned mesh goes with its bones alone, from where its node was when it was bound:
        bone now x TransformLink^-1 x node then x geometric, as Autodesk's ViewScene has it; the
        file's Transform is the middle two. Its own node moves nothing, before or since."""
        cases = [
            (node, moves, parent, link, geometric)
            for node in (0, 5)
            for moves in (20, 21)
            for parent in (0, 20)
            for link in (0, 2)
            for geometric in ((0, 0, 1), (3, 0, 1), (3, 90, 2))
        ]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.fbx"
            for node, moves, parent, link, (along, turn, size) in cases:
                bound = 7  # the mesh's node, then
                text = SKIN
                for name, value in (
                    ("NODE", node), ("MOVES", moves), ("PARENT", parent), ("LINK", link),
                    ("BONE", 4), ("TRANSFORM", bound - link), ("GEOMETRIC", along),
                    ("TURN", turn), ("SIZE", size),
                ):  # fmt: skip
                    text = text.replace(f"@{name}@", str(value))
                path.write_text(text)
                reader = read(path, relievo.vtkRelievoModelReader.POSE_ANIMATION)[0]
                for time in (0, 1):
                    bone = 10 * time if moves == 20 else 4
                    x = bone - link + bound + along
                    # The triangle is as wide along x as along y, here or turned by 90 degrees.
                    low, high = (x, x + size) if turn == 0 else (x - 1, x)
                    reader.UpdateTimeStep(time)
                    bounds = [0.0] * 6
                    reader.GetOutputDataObject(0).GetBounds(bounds)
                    with self.subTest(node=node, moves=moves, parent=parent, link=link, turn=turn):
                        numpy.testing.assert_allclose(bounds[:2], (low, high), atol=1e-5)
                        numpy.testing.assert_allclose(
                            bounds[2:4], (0, 1 if turn == 0 else size), atol=1e-5)  # fmt: skip


class Files(unittest.TestCase):
    def test_outside_and_names(self):
        """Blocks have names, without which ParaView reports errors; normals point outwards."""
        paths = sorted([*FOLDER.glob("FBX/**/*.[fF][bB][xX]"), *FOLDER.glob("Collada/*.*")])
        self.assertGreaterEqual(len(paths), 40)
        for path in paths:
            reader, errors, _ = read(path)
            output = reader.GetOutput()
            for i in range(0 if errors else output.GetNumberOfBlocks()):
                with self.subTest(path=path.name, block=i):
                    self.assertTrue(output.GetMetaData(i).Get(output.NAME()))
                    block = output.GetBlock(i)
                    if block.GetPointData().GetNormals() and block.GetNumberOfPolys():
                        self.assertLess(against(block), 0.1)

    def test_collada(self):
        """As many triangles, with the same corners and the same area."""
        paths = sorted((FOLDER / "Collada").glob("*.[dD][aA][eE]"))
        compared = 0
        for path in paths:
            if path.name in OTHERS:
                continue
            truth = Collada(path)
            if truth.bent or not truth.corners:
                continue  # testModels has those with bones
            with self.subTest(path=path.name):
                _, errors, found = read(path)
                self.assertEqual(errors, [])
                wanted = [each for each in truth.corners if len(each) >= 3]
                size = max(numpy.abs(each).max() for each in wanted)
                self.assertEqual(len(found), sum(len(each) - 2 for each in wanted))
                total = sum(numpy.linalg.norm(area(each)) for each in wanted)
                seen = numpy.linalg.norm([area(each) for each in found], axis=1).sum()
                self.assertLess(abs(seen / total - 1), 2e-3)  # some polygons are not flat
                ours = numpy.unique(numpy.round(found.reshape(-1, 3) / size, 6), axis=0)
                theirs = numpy.unique(numpy.round(numpy.concatenate(wanted) / size, 6), axis=0)
                for one, other in ((ours, theirs), (theirs, ours)):
                    for point in one:
                        self.assertLess(numpy.abs(other - point).max(axis=1).min(), 1e-5)
                compared += 1
        self.assertGreaterEqual(compared, 15)


if __name__ == "__main__":
    unittest.main()
