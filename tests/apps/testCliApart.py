# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files are read in a separate process: a reader's errors give one message, nothing is left
behind, and the picture equals Python's if Python reads in its own process."""

import ctypes
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import time
import unittest

import numpy
from cli import LOOK, RELIEVO, CliTest, main
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList, vtkLookupTable, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData, vtkRectilinearGrid,
    vtkStructuredGrid, vtkUnstructuredGrid)  # fmt: skip
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkDataSetWriter, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLDataSetWriter, vtkXMLMultiBlockDataWriter, vtkXMLPolyDataWriter)  # fmt: skip

DATA = pathlib.Path(os.environ["RELIEVO_DATA"])
LIMIT = 8 << 30  # of a reader, for a small file

COLLADA = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="9">-1 -1 0 1 -1 0 -1 1 0</float_array>
<technique_common><accessor source="#a" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/>%s</node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
"""
LEGACY = "# vtk DataFile Version 3.0\na\n{}\nDATASET POLYDATA\n"
DEEP = 300000


def become_subreaper():
    """Makes orphaned descendants children of this process."""
    pr_set_child_subreaper = 36
    assert ctypes.CDLL(None).prctl(pr_set_child_subreaper, 1, 0, 0, 0) == 0


def children(parent):
    """The processes whose parent it is, without those that have ended."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            state, its = stat.read_text().rsplit(")", 1)[1].split()[:2]
        except OSError:  # has ended meanwhile
            continue
        if int(its) == parent and state != "Z":
            found.append(int(stat.parent.name))
    return found


def wait_for(condition, seconds=300):  # against hanging alone
    until = time.monotonic() + seconds
    while not condition() and time.monotonic() < until:
        time.sleep(0.002)
    return condition()


class Untrusted(CliTest):
    def refused_apart(self, name, text, says, **more):
        (self.folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        self.before = self.names()
        self.refused("render", name, "--png", "a.png", status=1, says=[name, says], **more)

    def test_whole(self):
        (self.folder / "whole.dae").write_text(COLLADA % "")
        self.relievo("render", "whole.dae", *LOOK, "--png", "a.png")

    def test_nodes_that_instance_themselves(self):
        self.refused_apart("self.dae", COLLADA % '<instance_node url="#n"/>',
                           "the reader (Assimp) crashed (segmentation fault)",
                           whole=True)  # fmt: skip

    def test_nested_nodes(self):
        self.refused_apart("deep.dae", COLLADA % ("<node>" * DEEP + "</node>" * DEEP),
                           "the reader (Assimp) crashed (segmentation fault)")  # fmt: skip

    def test_nested_xml(self):
        text = '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1"><PolyData>'
        text += "<Piece>" * DEEP + "</Piece>" * DEEP + "</PolyData></VTKFile>"
        self.refused_apart("deep.vtp", text, "the reader (VTK) crashed (segmentation fault)")

    def test_more_than_memory(self):
        points = LEGACY.format("BINARY") + "POINTS 2000000000 double\n"
        self.refused_apart("points.vtk", points, "the reader (VTK) used more than 8 GiB of memory")

    def test_less_memory_by_ulimit(self):
        points = LEGACY.format("BINARY") + "POINTS 2000000000 double\n"
        self.refused_apart("points.vtk", points, "the reader (VTK) used more than 3 GiB of memory",
                           wrapper=["sh", "-c", 'ulimit -v 3145728; exec "$@"', "sh"])  # fmt: skip

    def test_memory_of_counts(self):
        """VTK gets over the memory that it lacks, and finds the file too short."""
        text = LEGACY.format("ASCII") + "POINTS 3 double\n0 0 0 1 0 0 0 1 0\n"
        self.refused_apart("cells.vtk", text + "POLYGONS 2000000000 4000000000\n3 0 1 2\n",
                           "cells.vtk", whole=True)  # fmt: skip
        used = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        self.assertLess(used << 10, LIMIT)

    def test_grid_too_large(self):
        """Nothing is allocated for points that are not there."""
        extent = "0 1500 0 1500 0 1500"
        text = f'<VTKFile type="ImageData" version="0.1"><ImageData WholeExtent="{extent}" '
        text += f'Origin="0 0 0" Spacing="1 1 1"><Piece Extent="{extent}"></Piece>'
        code = (
            "import resource, subprocess, sys\n"
            "done = subprocess.run(sys.argv[1:]).returncode\n"
            "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, file=sys.stderr)\n"
            "sys.exit(done)\n"
        )
        (self.folder / "large.vti").write_text(text + "</ImageData></VTKFile>")
        done = self.relievo("render", "large.vti", "--png", "a.png", status=1,
                            wrapper=[sys.executable, "-c", code])  # fmt: skip
        said, used = done.stderr.splitlines()
        self.assertIn("large.vti", said)
        self.assertIn("too large", said)
        self.assertLess(int(used) << 10, 1 << 30)

    def test_points_of_lamps(self):
        points = LEGACY.format("BINARY") + "POINTS 2000000000 double\n"
        (self.folder / "lamps.vtk").write_text(points)
        self.before = self.names()
        self.refused("render", "triangle.off", "--lamps", "lamps.vtk", "--png", "a.png", status=1,
                     says=["lamps.vtk", "8 GiB"])  # fmt: skip

    def test_broken_among_good(self):
        (self.folder / "self.dae").write_text(COLLADA % '<instance_node url="#n"/>')
        self.before = self.names()
        self.refused("render", "triangle.off", "self.dae", "triangle.off", "--png", "a.png",
                     status=1, says="self.dae")  # fmt: skip


class Processes(CliTest):
    """There are two besides the command while it reads, and none after it."""

    def setUp(self):
        super().setUp()
        become_subreaper()
        # Some seconds of reading.
        numbers = "0.25 0.5 0.125\n" * 3000000
        (self.folder / "slow.vtk").write_text(
            LEGACY.format("ASCII") + "POINTS 3000000 double\n" + numbers)

    def start(self):
        """The command while it reads, and its processes; the reader stands still, so that it does
        not end before the test goes on."""
        command = subprocess.Popen(
            [RELIEVO, "render", "slow.vtk", "--png", "a.png"], cwd=self.folder, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE)  # fmt: skip
        found = []

        def reads():
            found[:] = children(command.pid)
            return len(found) == 1 and len(children(found[0])) == 1
        self.assertTrue(wait_for(reads))
        worker = children(found[0])[0]
        os.kill(worker, signal.SIGSTOP)
        return command, found[0], worker

    def ends(self, command, *others):
        said = command.communicate(timeout=60)[1]

        def gone():
            for each in others:
                try:
                    os.waitpid(each, os.WNOHANG)  # ours by now
                except ChildProcessError:
                    pass
            return not any(pathlib.Path(f"/proc/{each}").exists() for each in others)
        self.assertTrue(wait_for(gone))
        self.assertEqual(self.names(), sorted([*self.before, "slow.vtk"]))
        return said

    def test_interrupted(self):
        for each in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):
            command, server, worker = self.start()
            command.send_signal(each)
            if each == signal.SIGKILL:
                command.wait()
                for temporary in self.folder.glob(".relievo-*.tmp"):
                    temporary.unlink()  # no other process can
            self.ends(command, server, worker)
            self.assertEqual(command.returncode, -each)

    def test_interrupted_with_all(self):
        """Ctrl-C is for all of a terminal's processes."""
        command, server, worker = self.start()
        for each in (worker, server, command.pid):
            os.kill(each, signal.SIGINT)
        self.assertEqual(self.ends(command, server, worker), "")
        self.assertEqual(command.returncode, -signal.SIGINT)

    def test_opengl_starts_while_it_reads(self):
        command, server, worker = self.start()
        drivers = "_dri.so", "libgallium", "libnvidia-glcore", "libnvidia-eglcore"

        def has_driver():
            maps = pathlib.Path(f"/proc/{command.pid}/maps").read_text()
            return any(each in maps for each in drivers)
        self.assertTrue(wait_for(has_driver))
        self.assertIn(worker, children(server))
        os.kill(worker, signal.SIGKILL)
        self.assertIn("was ended by the system", self.ends(command, server, worker))

    def test_reader_is_killed(self):
        command, server, worker = self.start()
        os.kill(worker, signal.SIGKILL)
        said = self.ends(command, server, worker)
        self.assertEqual(command.returncode, 1)
        self.assertEqual(len(said.splitlines()), 1, said)
        self.assertIn("slow.vtk: the reader (VTK) was ended by the system", said)

    def test_its_parent_is_killed(self):
        command, server, worker = self.start()
        os.kill(server, signal.SIGKILL)
        said = self.ends(command, server, worker)
        self.assertEqual(command.returncode, 1)
        self.assertEqual(len(said.splitlines()), 1, said)
        self.assertIn("slow.vtk", said)
        self.assertIn("start the program again", said)


SCRIPT = """
import os, pathlib, signal, sys
import numpy, relievo
from relievo.vtkRelievoIO import vtkRelievoImageReader
for path in sys.argv[1:]:
    try:
        relievo.scene(path).update()
        print(path, "read")
    except OSError as error:
        print(error)
pathlib.Path("below").mkdir()
os.chdir("below")
pathlib.Path("flat.off").write_text("OFF\\n3 1 0\\n0 0 0\\n1 0 0\\n0 1 0\\n3 0 1 2\\n")
relievo.scene("flat.off").update()
relievo.write_png("b.png", numpy.zeros((2, 3, 3), numpy.uint8))
reader = vtkRelievoImageReader()
reader.SetFileName("b.png")
reader.Update()
print(reader.GetOutput().GetDimensions())
try:
    os.wait()
except ChildProcessError:
    print("no children")
sys.stdout.flush()
os.kill(os.getpid(), signal.SIGSTOP)
try:
    relievo.scene("flat.off").update()
except OSError as error:
    print(error)
relievo.scene("flat.off").update()
print("read again")
"""


class Scripts(CliTest):
    """Python reads files in a process of relievo-reader."""

    def test_script(self):
        become_subreaper()
        before = set(children(os.getpid()))  # started by other tests
        (self.folder / "self.dae").write_text(COLLADA % '<instance_node url="#n"/>')
        (self.folder / "whole.dae").write_text(COLLADA % "")
        text = '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1"><PolyData>'
        (self.folder / "deep.vtp").write_text(
            text + "<Piece>" * DEEP + "</Piece>" * DEEP + "</PolyData></VTKFile>")
        (self.folder / "cut.vtp").write_text(text + "<Piece")
        script = subprocess.Popen(
            [sys.executable, "-c", SCRIPT, "self.dae", "deep.vtp", "cut.vtp", "whole.dae"],
            cwd=self.folder, text=True, stdout=subprocess.PIPE)  # fmt: skip
        self.addCleanup(script.kill)
        os.waitpid(script.pid, os.WUNTRACED)
        servers = list(set(children(os.getpid())) - before - {script.pid})
        self.assertEqual(len(servers), 1)
        os.kill(servers[0], signal.SIGKILL)
        os.waitpid(servers[0], 0)
        os.kill(script.pid, signal.SIGCONT)
        said = script.communicate(timeout=60)[0].splitlines()
        for line, part in zip(said, (
                "self.dae: the reader (Assimp) crashed (segmentation fault)",
                "deep.vtp: the reader (VTK) crashed (segmentation fault)",
                "cut.vtp: Error parsing XML in stream at line 2", "whole.dae read", "(3, 2, 1)",
                "no children", "has been ended; read it again", "read again"),
                              strict=True):  # fmt: skip
            self.assertIn(part, line)
        self.assertEqual(script.returncode, 0)
        self.assertEqual(set(children(os.getpid())) - before, set())


class Alike(CliTest):
    """Command and Python draw the same, number by number, with the same notes."""

    LAYERS = "depth,normal,geometric_normal,albedo,cell,block,actor"

    def write_meshes(self):
        """Files of VTK's own writers, of every kind of data."""
        rng = numpy.random.default_rng(7)
        names = []

        def write(writer, name, data, **settings):
            writer.SetFileName(str(self.folder / name))
            writer.SetInputData(data)
            if hasattr(writer, "SetDataModeToBinary"):
                writer.SetDataModeToBinary()  # newer expats make Python's VTK refuse appended data
            for setting, value in settings.items():
                getattr(writer, setting)(value)
            self.assertTrue(writer.Write())
            names.append(str(self.folder / name))

        def array(name, values):
            made = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
            made.SetName(name)
            return made
        grid = numpy.stack(numpy.meshgrid(*[numpy.arange(4.0)] * 3, indexing="ij"), -1)
        places = grid.transpose(2, 1, 0, 3).reshape(-1, 3)
        points = vtkPoints()
        points.SetData(array("p", places + 0.1 * rng.random(places.shape)))
        image = vtkImageData()
        image.SetDimensions(4, 4, 4)
        rectilinear = vtkRectilinearGrid()
        rectilinear.SetDimensions(4, 4, 4)
        for axis in "XYZ":
            getattr(rectilinear, f"Set{axis}Coordinates")(array(axis, numpy.array([0, 1, 2.5, 3])))
        structured = vtkStructuredGrid()
        structured.SetDimensions(4, 4, 4)
        structured.SetPoints(points)
        unstructured = vtkUnstructuredGrid()
        unstructured.SetPoints(points)
        for kind, ids in ((10, (0, 1, 4, 16)), (12, (21, 22, 26, 25, 37, 38, 42, 41)),
                          (11, (2, 3, 6, 7, 18, 19, 22, 23)), (13, (8, 9, 12, 24, 25, 28)),
                          (14, (48, 49, 53, 52, 37)), (5, (60, 61, 57)), (3, (63, 47)),
                          (22, (1, 3, 11, 2, 7, 6)), (1, (62,))):  # fmt: skip
            unstructured.InsertNextCell(kind, len(ids), ids)
        faces = vtkIdList()
        for word in (4, 3, 0, 2, 1, 3, 0, 1, 32, 3, 1, 2, 32, 3, 2, 0, 32):
            faces.InsertNextId(word)
        unstructured.InsertNextCell(42, faces)
        mesh = vtkPolyData()
        mesh.SetPoints(points)
        polygons, strips = vtkCellArray(), vtkCellArray()
        for ids in ((0, 1, 5, 4), (21, 22, 26), (40, 41, 45, 44)):
            polygons.InsertNextCell(len(ids), ids)
        strips.InsertNextCell(6, (48, 49, 52, 53, 56, 57))
        mesh.SetPolys(polygons)
        mesh.SetStrips(strips)
        for data in (image, rectilinear, structured, unstructured, mesh):
            count = data.GetNumberOfPoints()
            data.GetPointData().SetScalars(array("heat", rng.random(count).astype(numpy.float32)))
            data.GetPointData().AddArray(array("flow", rng.random((count, 3))))
            data.GetCellData().AddArray(array("part", numpy.arange(data.GetNumberOfCells()) % 3))
        texts = vtkStringArray()
        texts.SetName("texts")
        texts.InsertNextValue("of the field")
        mesh.GetFieldData().AddArray(texts)
        for name, data in (("a.vti", image), ("a.vtr", rectilinear), ("a.vts", structured),
                           ("a.vtu", unstructured), ("a.vtp", mesh)):  # fmt: skip
            write(vtkXMLDataSetWriter(), name, data)
            write(vtkDataSetWriter(), name[2:] + ".vtk", data)
        colors = vtkLookupTable()
        colors.SetNumberOfTableValues(3)
        for i in range(3):
            colors.SetTableValue(i, i == 0, i == 1, i == 2, 1)
        mesh.GetPointData().GetScalars().SetLookupTable(colors)
        write(vtkPolyDataWriter(), "colors.vtk", mesh, SetFileType=2)
        blocks, inner = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
        inner.SetBlock(1, unstructured)
        blocks.SetBlock(0, mesh)
        blocks.SetBlock(3, inner)
        blocks.GetMetaData(0).Set(vtkMultiBlockDataSet.NAME(), "skin")
        write(vtkXMLMultiBlockDataWriter(), "a.vtm", blocks)
        write(vtkSTLWriter(), "a.stl", mesh)
        write(vtkPLYWriter(), "a.ply", mesh)
        mesh.GetPoints().SetPoint(0, numpy.nan, 0, 0)
        write(vtkXMLPolyDataWriter(), "nan.vtp", mesh)
        return names

    def test_every_sample(self):
        extensions = (".off", ".obj", ".gltf", ".glb", ".bvh", ".dae", ".fbx", ".iqm", ".ms3d",
                      ".x")  # fmt: skip
        samples = [str(path) for path in sorted(DATA.rglob("*"))
                   if path.suffix.lower() in extensions and path.stat().st_size < 30e6]  # fmt: skip
        self.assertGreater(len(samples), 60)
        samples += self.write_meshes()
        words = [["render", path, "--size", "90x70", "--png", f"{i}.png", "--exr", f"{i}.exr",
                  "--layers", self.LAYERS] for i, path in enumerate(samples)]  # fmt: skip
        (self.folder / "words.json").write_text(json.dumps([each[1:] for each in words]))
        (self.folder / "here").mkdir()
        here = subprocess.run([sys.executable, __file__, "--here", "../words.json"],
                              cwd=self.folder / "here", check=True, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              env={**os.environ, "RELIEVO_READ_HERE": "1"},
                              timeout=600).stdout  # fmt: skip
        kinds = set()  # of each, the first is drawn and the first refused by the command itself
        for i, said in enumerate(json.loads(here)):
            with self.subTest(file=samples[i]):
                failed = bool(said["failure"])
                kind = pathlib.Path(samples[i]).suffix.lower(), failed
                done = self.relievo(*words[i], status=int(failed), whole=kind not in kinds)
                kinds.add(kind)
                lines = [said["failure"]] if failed else said["notes"]
                self.assertEqual(done.stderr.splitlines(), [f"relievo: {line}" for line in lines])
                for name in [] if failed else [f"{i}.png", f"{i}.exr"]:
                    self.assertEqual((self.folder / name).read_bytes(),
                                     (self.folder / "here" / name).read_bytes())  # fmt: skip


def draw_here(words):
    """Draws everything in this process, and prints the messages as JSON."""
    from relievo.vtkRelievoScene import vtkRelievoScene

    said, window = [], None
    for each in json.loads(pathlib.Path(words).read_text()):
        scene, given = vtkRelievoScene(), vtkStringArray()
        for word in each:
            given.InsertNextValue(word)
        done = scene.SetWords(given)
        if done:
            scene.SetRenderWindow(window)  # that of the one before: all are of one size
            done = scene.Write()
            window = scene.GetRenderWindow()
        notes = [scene.GetNotes().GetValue(i) for i in range(scene.GetNotes().GetNumberOfValues())]
        warnings = scene.GetWarnings()
        notes += ["warning: " + warnings.GetValue(i) for i in range(warnings.GetNumberOfValues())]
        said.append({"failure": "" if done else scene.GetFailureText(), "notes": notes})
        scene.SetRenderWindow(None)
    print(json.dumps(said))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--here"]:
        draw_here(sys.argv[2])
    else:
        main()
