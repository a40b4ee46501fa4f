# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of tools/compare-frames that the Python package draws: packageScenes.py MADE DATA NAME.

They use functions of the package, and parameters of stages by name, so that they run in builds
whose methods have other names.
"""

import json
import sys

import numpy
import relievo
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLFXAAPass, vtkRenderStepsPass, vtkSSAOPass

from drawing import (
    DATA,
    MADE,
    NORMALS,
    actor_of,
    grab,
    read,
    read_picture,
    room,
    save,
    write_report,
)


def layers():
    renderer, window = room("ground", "things", "glass")
    names = [name for name in relievo.layers() if name != "shadow_N"]
    save(relievo.capture(renderer, [*names, "shadow_0", "shadow_1", "height", "cell:value"]))
    save(relievo.capture(renderer, NORMALS, size=(150, 120), hdr=True), "small")
    save(relievo.capture(renderer.GetActors().GetItemAsObject(1).GetMapper().GetInput(), "depth",
                         size=(80, 60)), "data")  # fmt: skip
    grab(window)


def attached():
    renderer, window = room("ground", "things")
    grab(window, "plain")
    frame = relievo.attach(renderer)
    grab(window, "attached")
    frame.ShadowsOn()
    grab(window, "shadows")
    for layer in ("normal", "depth", "actor", "height"):
        frame.SetDisplayLayer(layer)
        grab(window, f"display-{layer}")
    frame.SetDisplayLayer(None)
    for method in ("map", "forward", "warped", "exact"):
        for name, value in (("method", method), ("map_size", "400"), ("filter_radius", "2")):
            frame.GetStage("shadows").SetParameter(name, value)
        grab(window, f"method-{method}")
    frame.ShadowsOff()
    grab(window, "again")
    print(relievo.detach(renderer), relievo.detach(renderer))
    grab(window, "detached")


def report():
    renderer, window = room("ground", "things")
    frame = relievo.attach(renderer)
    for wanted in ("depth", "normal", "shadow_1", "value"):
        try:
            frame.RequestLayer(wanted)
        except ValueError as error:
            print(error)
        grab(window, f"with-{wanted}")
        write_report(frame, f"report-{wanted}")
    image = vtkImageData()
    frame.ReadLayers(["depth", "normal"], image)
    save(image)


def soft():
    renderer, window = room("ground", "things")
    relievo.stage(renderer, "shadows", method="exact", soft_samples=6, sun_angle=4,
                  lamp_radius=0.3)  # fmt: skip
    for i in range(7):
        grab(window, f"picture-{i}")
    save(relievo.capture(renderer, ["color", "shadow_0", "shadow_1"]))


def remove(renderer, stage, made):
    """Removes points from a stage, by whichever method the build has."""
    held = relievo.attach(renderer).GetStage(stage)
    names = ("RemovePoints", f"Remove{stage.capitalize()}")
    getattr(held, next(name for name in names if hasattr(held, name)))(made)


def lamps():
    renderer, window = room("ground", "things", "glass")
    made = relievo.lamps(renderer, read("lamps"), casts="casts", falloff="inverse-square")
    names = ["light", "lamp_evaluations", "lamps_reaching", "color"]
    for way in ("quads", "clusters", "all"):
        relievo.stage(renderer, "lamps", way=way)
        save(relievo.capture(renderer, names), way)
    relievo.lamps(renderer, read("lamps"), radius=1, color=(1, 1, 1), casts=False)
    grab(window)
    remove(renderer, "lamps", made)
    grab(window, "removed")


def fog():
    renderer, window = room("ground", "things", "glass")
    made = relievo.fog(renderer, read("fog"), density=0.7)
    for mode in ("beer", "chord"):
        relievo.stage(renderer, "fog", mode=mode, overlap="dominant")
        save(relievo.capture(renderer, ["fog", "color"]), mode)
    grab(window)
    remove(renderer, "fog", made)
    grab(window, "removed")


def markers():
    renderer, window = room("ground", "things")
    for shape in ("ring", "glow", "disc"):
        relievo.markers(renderer, read("markers"), shape=shape)
    made = relievo.markers(renderer, list(renderer.GetActors())[1], shape="shadow", up=(0, 1, 0))
    save(relievo.capture(renderer, ["marker", "color"]))
    remove(renderer, "markers", made)
    grab(window)


def environment():
    renderer, window = room("ground", "things")
    for name, path, more in (
        ("sky", MADE / "sky.png", {"rotation": 40, "reflectivity": 0.6, "roughness": 0.1}),
        ("ball", DATA / "metal_shiny.exr", {"sky": False, "intensity": 0.6}),
        ("image", read_picture("sky.png"), {"up": "z"}),
        ("none", None, {}),
    ):
        relievo.environment(renderer, path, **more)
        save(relievo.capture(renderer, NORMALS), name)
        grab(window, name)


def files():
    """OpenEXR files of all compressions and types, read again."""
    renderer, window = room("ground", "things")
    image = relievo.capture(renderer, ["color", "depth", "normal", "position", "cell", "height"])
    window.Render()
    for compression in "none rle zips zip piz pxr24 b44 b44a dwaa dwab".split():
        relievo.write_exr(f"{compression}.exr", image, compression)
        save(relievo.read_exr(f"{compression}.exr"), f"again-{compression}")
    relievo.write_exr("half.exr", image, pixel_types={"normal": "half", "depth.Z": "half"})
    for key, value in relievo.attributes(relievo.read_exr("half.exr")).items():
        print(key, value)


def errors():
    """Exceptions of invalid calls."""
    renderer, window = room("ground", "things")
    frame = relievo.attach(renderer)
    window.Render()
    image = relievo.capture(renderer, "depth")
    for call in (
        lambda: relievo.capture(3), lambda: relievo.capture(renderer, ["deep"]),
        lambda: relievo.capture(renderer, size=(0, 4)), lambda: relievo.layer(image, "normal"),
        lambda: relievo.capture(vtkRenderer(), ["depth"]), lambda: relievo.read_exr("nothing.exr"),
        lambda: relievo.read_exr(MADE / "words.off"), lambda: relievo.write_exr("no/a.exr", image),
        lambda: relievo.write_exr("a.exr", image, "lzw"), lambda: relievo.attach(None),
        lambda: relievo.write_exr("a.exr", image, pixel_types={"depth": "byte"}),
        lambda: frame.RequestLayer("deep"), lambda: frame.SetDisplayLayer("shadow_7"),
        lambda: relievo.stage(renderer, "glow"), lambda: relievo.stage(renderer, "fog", mode="x"),
        lambda: relievo.stage(renderer, "shadows", bias=1000), lambda: relievo.fog(renderer, 3),
        lambda: relievo.lamps(renderer, read("lamps"), radius="nothing"),
        lambda: relievo.markers(renderer, read("markers"), shape="star"),
        lambda: relievo.environment(renderer, "nothing.png"), lambda: relievo.report(vtkRenderer()),
        lambda: relievo.environment(renderer, MADE / "checks.png", up="w"),
        lambda: relievo.to_image("text"), lambda: relievo.depth_to_points(vtkImageData()),
        lambda: frame.GetStage("shadows").SetParameter("method", "cube"),
    ):  # fmt: skip
        try:
            print("returned", type(call()).__name__)
        except Exception as error:  # of any type
            print(f"{type(error).__name__}: {error}")


def wireframe():
    """Wire frames, points, edges, flat and PBR shading, parallel projection, a second renderer."""
    renderer, window = room("ground", "things", "wires", "glass")
    relievo.attach(renderer).ShadowsOn()
    shape = list(renderer.GetActors())[1].GetProperty()
    for name in ("SetRepresentationToWireframe", "SetRepresentationToPoints",
        "SetRepresentationToSurface", "EdgeVisibilityOn", "SetInterpolationToFlat",
        "SetInterpolationToPBR"):  # fmt: skip
        getattr(shape, name)()
        save(relievo.capture(renderer, NORMALS), name)
    renderer.GetActiveCamera().ParallelProjectionOn()
    renderer.GetActiveCamera().SetParallelScale(2)
    renderer.SetViewport(0, 0, 0.5, 1)
    other = vtkRenderer()
    other.SetViewport(0.5, 0, 1, 1)
    other.AddActor(actor_of(read("things")))
    window.AddRenderer(other)
    other.ResetCamera()
    relievo.attach(other).SetDisplayLayer("normal")
    grab(window)


def passes():
    """Linear depth as a separate pass, the frame around VTK's own passes, many samples."""
    renderer, window = room("ground", "things")
    linear = relievo.vtkRelievoLinearDepthPass()
    linear.NormalizedOff()
    linear.SetRange(4, 9)
    renderer.SetPass(linear)
    grab(window, "linear")
    for kind in (vtkOpenGLFXAAPass, vtkSSAOPass):
        own = kind()
        own.SetDelegatePass(vtkRenderStepsPass())
        renderer.SetPass(own)
        relievo.attach(renderer).ShadowsOn()
        grab(window, kind.__name__)
        relievo.detach(renderer)
    renderer.SetPass(None)
    window.SetMultiSamples(4)
    relievo.attach(renderer).ShadowsOn()
    save(relievo.capture(renderer, NORMALS))


def images():
    """Images and arrays, back and forth."""
    made = relievo.to_image(numpy.arange(24.0).reshape(4, 6), "ramp")
    save(made, "made")
    numpy.save("back.npy", relievo.from_image(read_picture("checks.png")))
    panel = vtkSphereSource()
    panel.Update()
    save(relievo.capture(panel, ["depth", "normal"], size=(90, 70)), "source")


def described():
    """The package's own descriptions."""
    print(json.dumps(relievo.layers(), indent=1, default=str))
    print(json.dumps(relievo.stages(), indent=1, default=str))
    empty = vtkPolyData()
    empty.SetPoints(vtkPoints())
    renderer = vtkRenderer()
    renderer.AddActor(actor_of(empty))
    save(relievo.capture(renderer, ["depth", "normal"], size=(20, 10)))


if __name__ == "__main__":
    globals()[sys.argv[3]]()
