# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A model's animation as a series of .vtp files, readable without support for bones.

    23_animation_series.py [FOLDER] [--model FILE] [--animation NAME] [--rate N] [--method METHOD]

Default: out/animation, a tube on three bones, its first animation, 10 frames a second, linear.
Writes to FOLDER
    frame_0000.vtp ...     all meshes of one time, with normals and the weights of bones
    animation.vtp.series   the times of these files: open it in ParaView, and the time controls play

The default model comes from Debian's package assimp-testmodels; tools/unpack-data puts it into the
folder RELIEVO_DATA (default: build/data beside this folder).
"""

import argparse
import json
import os
import pathlib

import relievo
from relievo.vtk.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from relievo.vtk.vtkFiltersCore import vtkAppendPolyData
from relievo.vtk.vtkIOXML import vtkXMLPolyDataWriter

import scene

METHODS = ["linear", "dual-quaternion", "key-matrix"]


def words():
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("folder", nargs="?", default="out/animation")
    parser.add_argument("--model")
    parser.add_argument("--animation", default="")
    parser.add_argument("--rate", type=float, default=10)
    parser.add_argument("--method", choices=METHODS, default=METHODS[0])
    return parser.parse_args()


def times_of(reader, rate):
    """Frames at the rate, from the animation's first time to its last one."""
    reader.UpdateInformation()
    key = vtkStreamingDemandDrivenPipeline.TIME_RANGE()
    information = reader.GetOutputInformation(0)
    if not information.Has(key):
        raise SystemExit(f"{reader.GetFileName()} has no animation")
    first, last = information.Get(key)
    count = int((last - first) * rate + 1e-9)
    return [first + i / rate for i in range(count + 1)]


def mesh_at(reader, time):
    """All meshes in one."""
    reader.UpdateTimeStep(time)
    blocks = reader.GetOutput()
    whole = vtkAppendPolyData()
    for i in range(blocks.GetNumberOfBlocks()):
        whole.AddInputData(blocks.GetBlock(i))
    whole.Update()
    return whole.GetOutput()


def write(mesh, path):
    """Writes a file that appears only when it is complete."""
    unfinished = path.with_suffix(".tmp")
    writer = vtkXMLPolyDataWriter()
    writer.SetDataModeToBinary()  # with newer expat, VTK 9.2 cannot read appended data
    writer.SetFileName(str(unfinished))
    writer.SetInputData(mesh)
    if not writer.Write():
        unfinished.unlink(missing_ok=True)
        raise SystemExit(f"{path} cannot be written")
    os.replace(unfinished, path)


def main():
    chosen = words()
    folder = pathlib.Path(chosen.folder)
    folder.mkdir(parents=True, exist_ok=True)
    reader = relievo.vtkRelievoModelReader()
    reader.SetFileName(chosen.model or scene.data("models/FBX/animation_with_skeleton.fbx"))
    reader.SetAnimation(chosen.animation)
    reader.SetMethod(METHODS.index(chosen.method))
    files = []
    for i, time in enumerate(times_of(reader, chosen.rate)):
        name = f"frame_{i:04d}.vtp"
        write(mesh_at(reader, time), folder / name)
        files.append({"name": name, "time": time})
        print(f"{folder / name}: {time:g} s")
    series = {"file-series-version": "1.0", "files": files}
    (folder / "animation.vtp.series").write_text(json.dumps(series, indent=1))
    print(folder / "animation.vtp.series")


if __name__ == "__main__":
    main()
