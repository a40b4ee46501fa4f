# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of tools/compare-frames in ParaView: pvpython paraviewScenes.py PLUGIN MADE DATA NAME."""

import pathlib
import sys

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

PLUGIN, MADE, DATA, NAME = sys.argv[1:]
SIZE = [300, 200]
LAYERS = (
    "depth range normal geometric_normal position albedo color actor block cell fog marker light "
    "blend shadow_sun height zone"
).split()


def read(name):
    source = simple.OpenDataFile(str(pathlib.Path(MADE) / name))
    source.UpdatePipeline()  # filters take its arrays by name
    return source


def read_picture(name):
    source = simple.PNGSeriesReader(FileNames=[str(pathlib.Path(MADE) / name)])
    source.UpdatePipeline()
    return source


def make_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    view.UseFXAA, view.MultiSamples = 0, 0
    return view


def room(*names):
    """A view of files, and their representations, by name."""
    view = make_view()
    shown = {}
    for name in names:
        shown[name] = simple.Show(read(name), view, "GeometryRepresentation")
    simple.Render(view)
    view.CameraPosition, view.CameraFocalPoint = [2.5, 3, 6], [0, 0.5, 0]
    view.CameraViewUp, view.CameraViewAngle = [0, 1, 0], 30
    return view, shown


def sun(view):
    view.RelievoShadows = 1
    view.RelievoSun = 1
    view.RelievoSunUpAxis = "Y"
    view.RelievoSunAzimuth, view.RelievoSunElevation = 130, 50


def save(view, name="picture"):
    simple.SaveScreenshot(f"{name}.png", view, ImageResolution=SIZE)


def report(view, name="report"):
    view.UpdatePropertyInformation()
    text = view.GetProperty("RelievoFrameReport").GetElement(0)
    pathlib.Path(f"{name}.json").write_text(text)


def keep(source, name):
    """Saves all points and arrays of a source's output."""
    source.UpdatePipeline()
    for which, data in simple.FetchData(source).items():
        keep_data(data, f"{name}-{which}")


def keep_data(data, name):
    if data.IsA("vtkCompositeDataSet"):
        for i in range(data.GetNumberOfBlocks()):
            if data.GetBlock(i):
                keep_data(data.GetBlock(i), f"{name}-{i}")
        return
    if data.IsA("vtkPointSet") and data.GetPoints():
        numpy.save(f"{name}-points.npy", vtk_to_numpy(data.GetPoints().GetData()))
    for kind in ("Point", "Cell", "Row"):
        held = getattr(data, f"Get{kind}Data", lambda: None)()
        for i in range(held.GetNumberOfArrays() if held else 0):
            if held.GetArray(i):
                called = held.GetArrayName(i).replace(":", "-")
                numpy.save(f"{name}-{kind}-{called}.npy", vtk_to_numpy(held.GetArray(i)))


def shadows():
    """Every method, soft and coloured shadows, the sun by its date, layers as the picture."""
    view, _ = room("ground.vtp", "things.vtp", "glass.vtp")
    save(view, "plain")
    sun(view)
    for method in ("Map", "Forward", "Warped", "Exact"):
        view.RelievoShadowMethod = method
        save(view, f"method-{method}")
    view.RelievoShadowColored = 1
    save(view, "colored")
    view.RelievoShadowSoftSamples, view.RelievoShadowSunAngle = 6, 5
    save(view, "soft")
    report(view)
    view.RelievoShadowSoftSamples = 0
    view.RelievoSunBy = "Date and place"
    view.RelievoSunDate, view.RelievoSunTime = [2026, 3, 20], 9.5
    save(view, "by-date")
    view.UpdatePropertyInformation()
    for name in ("RelievoSunAngles", "RelievoShadowLayers"):
        held = view.GetProperty(name)
        print(name, *(held.GetElement(i) for i in range(held.GetNumberOfElements())))
    for layer in ("normal", "depth", "shadow_sun", "height"):
        view.RelievoDisplayLayer = layer
        save(view, f"layer-{layer}")
    view.RelievoDisplayLayer = "None"
    view.RelievoShadows = view.RelievoSun = 0
    save(view, "again")


def points():
    """Lamps, fog, markers, tone and deferred shading."""
    names = ("ground", "things", "glass", "lamps", "fog", "markers")
    view, shown = room(*(f"{name}.vtp" for name in names))
    sun(view)
    view.RelievoSunIntensity = 0.3
    shown["lamps.vtp"].RelievoLamps = 1
    shown["lamps.vtp"].RelievoLampsFalloff = "Inverse Square"
    save(view, "lamps")
    shown["fog.vtp"].RelievoFog = 1
    save(view, "fog")
    shown["markers.vtp"].RelievoMarkers = 1
    for shape in ("Ring", "Glow", "Disc", "Shadow"):
        shown["markers.vtp"].RelievoMarkersShape = shape
        shown["markers.vtp"].RelievoMarkersUp = [0, 1, 0]
        save(view, f"markers-{shape}")
    view.RelievoStageTone, view.RelievoStageToneOperator = 1, "Reinhard"
    view.RelievoStageToneExposure = 0.5
    save(view, "tone")
    view.RelievoStageDeferred = 1
    save(view, "deferred")
    report(view)


def materials():
    """Maps by every method, and an environment."""
    view, shown = room("ground.vtp", "things.vtp")
    ground = shown["ground.vtp"]
    ground.RelievoMaterial = 1
    ground.RelievoHeightMap = str(pathlib.Path(MADE) / "heights.png")
    ground.RelievoHeightScale = 0.15
    for method in ("Off", "Parallax", "Steep", "Occlusion", "Relief"):
        ground.RelievoReliefMethod = method
        save(view, f"relief-{method}")
    ground.RelievoSelfShadow = ground.RelievoDepthCorrection = 1
    ground.RelievoNormalMap = str(pathlib.Path(MADE) / "normals.png")
    save(view, "normals")
    view.RelievoEnvironment = str(pathlib.Path(MADE) / "sky.png")
    view.RelievoSkybox, view.RelievoEnvironmentUp = 1, "Y"
    for each in shown.values():
        each.RelievoMaterial = each.RelievoMirror = 1
        each.RelievoReflectivity, each.RelievoRoughness = 0.6, 0.15
    save(view, "environment")
    sun(view)
    save(view, "shadows")
    report(view)


def layers():
    """Layers as images, in files, and as points."""
    view, shown = room("ground.vtp", "things.vtp", "glass.vtp", "fog.vtp", "lamps.vtp")
    sun(view)
    shown["fog.vtp"].RelievoFog = 1
    shown["lamps.vtp"].RelievoLamps = 1
    source = simple.RelievoLayers(View=view, Layers=LAYERS)
    keep(source, "layers")
    keep(simple.DepthToPoints(Input=source), "points")
    simple.SaveData("saved.exr", source)
    simple.ExportView("exported.exr", view=view)
    keep(simple.OpenDataFile("saved.exr"), "again")
    save(view)
    report(view)


def filters():
    """Filters and sources of the plugin."""
    view, shown = room("things.vtp")
    mesh = simple.GetActiveSource()
    caves = simple.Caves(Size=[30, 30, 16], Seed=3, Content="Labels")
    caves.UpdatePipeline()
    blocks = simple.SmoothBlocks(Input=caves)
    shell = simple.VoxelShell(Input=mesh, Resolution=24)
    cubes = simple.VoxelCubes(Input=shell, Model=mesh, Transition=0.05)
    particles = simple.SurfaceParticles(Input=mesh, NumberOfParticles=300, Resolution=40)
    placed = simple.TextureCoordinates(Input=simple.Triangulate(Input=mesh))
    for name, source in (
        ("caves", caves), ("blocks", blocks), ("shell", shell), ("cubes", cubes),
        ("particles", particles), ("tangents", simple.Tangents(Input=placed)),
        ("normals", simple.HeightsToNormals(Input=read_picture("heights.png"))),
        ("convert", simple.EnvironmentConvert(read_picture("sky.png"), OutputSize=16, InputSRGB=1)),
        ("levels", simple.EnvironmentPrefilter(read_picture("sky.png"), Size=16, Levels=3)),
        ("irradiance", simple.EnvironmentIrradiance(read_picture("sky.png"))),
    ):  # fmt: skip
        keep(source, name)
    simple.Hide(mesh, view)
    simple.Show(blocks, view)
    sun(view)
    simple.ResetCamera(view)
    save(view)


def model():
    """A model with bones at its times, moved by the reader."""
    view = make_view()
    source = simple.OpenDataFile(f"{DATA}/models/X/Testwuson.X")
    simple.Show(source, view)
    simple.Render(view)
    sun(view)
    for time in (0.0, 0.4, 0.8):
        view.ViewTime = time
        source.UpdatePipeline(time)
        save(view, f"time-{time}")


def errors():
    """Invalid values, refused or clamped."""
    view, shown = room("ground.vtp", "things.vtp")
    sun(view)
    shown["ground.vtp"].RelievoMaterial = 1
    shown["ground.vtp"].RelievoNormalMap = str(pathlib.Path(MADE) / "cut.png")
    save(view, "no-map")
    shown["ground.vtp"].RelievoFog, shown["ground.vtp"].RelievoFogDensity = 1, -3
    shown["things.vtp"].RelievoReflectivity = 7
    view.RelievoShadowMapSize = 3
    view.RelievoShadowStrength = 4
    view.RelievoEnvironment = str(pathlib.Path(MADE) / "words.off")
    save(view, "clamped")
    view.RelievoStageToneExposure = 90
    view.RelievoDisplayLayer = "deep"
    save(view, "no-layer")
    simple.RelievoLayers(View=view, Layers=["nonsense"]).UpdatePipeline()
    report(view)


simple.LoadPlugin(PLUGIN, remote=False, ns=simple.__dict__)
globals()[NAME]()
for kept in simple.GetViews():
    simple.Delete(kept)  # ParaView 5.11 crashes at exit if views exist
