# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of tools/compare-frames, each with the commands that draw it.

{made} is the folder of inputs.py, {data} that of tools/unpack-data, {tools} this one, {examples}
those of the build's source tree, {plugin} the build's library for ParaView.
"""

import collections
import shlex

# `status`: the exit statuses of the commands; `program`: the one that draws.
Scene = collections.namedtuple("Scene", "program commands status")

LOOK = "--camera 2.5,3,6,0,0.5,0,0,1,0 --clip 2,14"
SEEN = f"{{made}}/ground.vtp {{made}}/things.vtp {LOOK}"
ROOM = f"{SEEN} --size 300x200"
WINDOW = "--size 480x400"  # smaller windows have no room for the panels
SUN = "--light sun:3,5,2"
BEHIND = "--light sun:1,2,4"  # behind a fitted camera
LIGHTS = f"{SUN} --light spot:-3,4,3,0,0,0,30 --light point:0.6,2.4,1.5"
SIZED = "--light sun:3,5,2,size=6 --light point:-1,3,2,size=0.3"
GLASS = "{made}/glass.vtp"
LAMPS = "--lamps {made}/lamps.vtp"
FOG = "--fog {made}/fog.vtp"
MARKERS = "--markers {made}/markers.vtp"
BUNNY = "{data}/bunny.off --size 240x200"
PNG = "--png picture.png"
ALL = "--png picture.png --exr frame.exr --report report.json"
LAYERS = (
    "depth range normal geometric_normal position albedo actor block cell light light_depth "
    "lamp_evaluations lamps_reaching blend fog marker shadow_0 shadow_1 shadow_2"
).split()
MODELS = "{data}/models"
SIZE = "--size 200x200"


def render():
    """Scenes of `relievo render`, by their arguments."""
    shadows = "--layers depth,shadow_0,shadow_1,shadow_2"
    for method in ("map", "forward", "warped", "exact"):
        yield f"shadows-{method}", f"{ROOM} {GLASS} {LIGHTS} --shadows {method} {shadows} {ALL}"
        soft = f"{SIZED} --shadows {method} --soft-shadows 8 --layers shadow_0,shadow_1"
        yield f"soft-{method}", f"{ROOM} {soft} {ALL}"
    yield "shadows-town", (
        "{data}/buildings.obj --up z --preset town --shadows warped --certify 400 "
        f"--shadow-size 512 --size 300x200 {ALL}")  # fmt: skip
    yield "shadows-parameters", (
        f"{ROOM} {LIGHTS} --shadows map --shadow-size 256 --stage "
        f"shadows:filter_radius=3,bias=4,strength=0.6 {shadows} {ALL}")  # fmt: skip
    yield "shadows-unseen", f"{ROOM} {LIGHTS} --layers shadow_1 {ALL}"
    yield "shadows-colored", (
        f"{ROOM} {GLASS} {LIGHTS} --shadows exact --colored-shadows --layers blend,shadow_0 {ALL}")
    yield "shadows-tolerance", f"{ROOM} {SUN} --shadow-tolerance 0.5% --certify 300 {ALL}"
    yield "light-depth", (
        f"{ROOM} {LIGHTS} --shadows map --stage light_depth:light=1 --layers light_depth {ALL}")
    lit = f"{ROOM} {GLASS} --light sun:1,4,2 {LAMPS}"
    counts = "--layers light,lamp_evaluations,lamps_reaching"
    for way in ("auto", "quads", "clusters", "all"):
        yield f"lamps-{way}", f"{lit} --stage lamps:way={way} {counts} {ALL}"
    yield "lamps-floats", f"{lit} --stage lamps:floats=on,translucent=on {counts} {ALL}"
    yield "lamps-square", f"{lit},falloff=inverse-square,radius=3,color=1/0.8/0.5 {counts} {ALL}"
    yield "lamps-vtk", f"{lit},falloff=vtk,attenuation=0.5/0.4/0.2 {counts} {ALL}"
    yield "lamps-cast", f"{lit},casts=casts --shadows map {counts} {ALL}"
    yield "lamps-casting", f"{lit},casts=never,casting=2 {LAMPS},casts=always {counts} {ALL}"
    yield "deferred", f"{ROOM} {LIGHTS} --shadows map --deferred {ALL}"
    yield "deferred-lamps", f"{lit} --deferred --shading pbr --layers light,albedo {ALL}"
    yield "fog-beer", f"{ROOM} {GLASS} {SUN} {FOG} --layers depth,fog,blend {ALL}"
    yield "fog-chord", f"{ROOM} {SUN} {FOG},mode=chord --layers depth,fog {ALL}"
    yield "fog-dominant", (
        f"{ROOM} {SUN} {FOG},radius=1.5,density=0.8,color=0.9/0.9/1 --stage "
        f"fog:overlap=dominant --layers fog {ALL}")  # fmt: skip
    for shape in ("ring", "glow", "disc", "shadow"):
        yield f"markers-{shape}", f"{ROOM} {SUN} {MARKERS},shape={shape} --layers marker {ALL}"
    yield "markers-values", (
        f"{ROOM} {MARKERS},shape=shadow,radius=0.4,opacity=1,up=0/1/0.3,color=0/0/0 "
        f"{MARKERS},width=0.5,opacity=0.5 --deferred --layers marker {ALL}")  # fmt: skip
    for operator in ("clamp", "simple", "reinhard", "reinhard-rgb"):
        yield f"tone-{operator}", f"{lit} --tone {operator} --exposure 1.5 --hdr {ALL}"
    yield "tone-auto", f"{lit} --exposure auto --stage tone:dither=ordered {ALL}"
    yield "tone-dither", f"{lit} --tone reinhard,white=8 --stage tone:dither=blue_noise {ALL}"
    yield "hdr", f"{lit} --hdr {ALL}"
    everything = (
        f"{ROOM} {GLASS} {LIGHTS} {LAMPS} {FOG} {MARKERS} --shadows map --shadow-size 512")
    arrays = "height,flow,zone,point:value,cell:value,point:depth"
    yield "layers", f"{everything} --layers {','.join(LAYERS)},{arrays} {ALL}"
    yield "everything", f"{everything} --deferred --tone reinhard --exposure auto {ALL}"
    for layer in (*LAYERS, "height", "zone", "point:value"):
        yield f"display-{layer.replace(':', '-')}", (  # a folder's name
            f"{everything} --stage display:layer={layer} {PNG}")
    yield "display-grey", f"{ROOM} --stage display:layer=depth,grey=on {PNG}"
    yield "translucent", f"{BUNNY} {SUN} --opacity 0.4 --layers blend,depth {ALL}"
    yield "edges", f"{ROOM} {SUN} --edges --shadows map {ALL}"
    yield "wires", f"{{made}}/wires.vtp {{made}}/ground.vtp {SUN} --shadows map {SIZE} {ALL}"
    for shading in ("flat", "gouraud", "phong", "pbr"):
        yield f"shading-{shading}", f"{BUNNY} {SUN} --shading {shading} --color gold {ALL}"
    yield "plain", f"{BUNNY} {PNG}"
    for preset in ("studio", "town", "print"):
        yield f"preset-{preset}", f"{BUNNY} --preset {preset} {PNG} --report report.json"
    for colormap in ("viridis", "cool-warm", "grey", "hot", "rainbow"):
        yield f"colormap-{colormap}", (
            f"{ROOM} --color-by height --colormap {colormap} --range 0,1.5 --scalar-bar {ALL}")
    yield "component", f"{ROOM} --color-by flow,1 --background slategray,#102030 {PNG}"
    yield "magnitude", f"{ROOM} --color-by flow,magnitude --scalar-bar {PNG}"
    yield "cell-values", f"{ROOM} --color-by cell:value --layers cell:value {ALL}"
    yield "clip", f"{BUNNY} --camera 0,0.1,0.4,0,0.1,0,0,1,0 --clip 0.35,0.41 {ALL}"
    yield "parallel", (
        f"{ROOM} --parallel-scale 2 {LIGHTS} --shadows map --layers depth,range {ALL}")
    yield "view-angle", f"{ROOM} --view-angle 70 {FOG} {SUN} --shadows exact {PNG}"
    yield "several", "{data}/bunny.off {made}/ball.vtk {made}/blocks.vtm --size 240x200 " + ALL
    yield "elephant", f"{{data}}/elephant.off {SIZE} {BEHIND} --shadows exact {ALL}"
    yield "clear-coat", f"{{data}}/ClearCoatTest/ClearCoatTest.gltf {SIZE} {ALL}"
    morph = f"{MODELS}/glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf"
    yield "gltf", f"{morph} {SIZE} {ALL}"
    yield "lost-material", f"{{made}}/lost.obj {SIZE} {ALL}"
    yield "materials", (
        f"{{made}}/materials.obj {SIZE} {BEHIND} --shadows exact --colored-shadows "
        f"--layers actor,cell,albedo {ALL}")  # fmt: skip
    bike = f"{{data}}/motorBike.obj --up z {SIZE}"
    yield "motor-bike", f"{bike} --light sun:1,-3,2 --shadows map {ALL}"
    for file in (
        "things.stl", "things.ply", "things.pvtp", "wave.vti", "wave.vtr", "wave.vts", "wave.vtk",
        "wave.vtu", "wave.pvti", "wave.pvtu", "blocks.vtm", "infinite.vtp",
    ):  # fmt: skip
        names = "depth,normal,block,cell"
        if file.startswith("wave"):
            names += ",wave,cells,vtkOriginalCellIds"
        yield f"file-{file.replace('.', '-')}", (
            f"{{made}}/{file} {SIZE} {BEHIND} --shadows map --layers {names} {ALL}")
    for method in ("off", "parallax", "steep", "occlusion", "relief"):
        yield f"relief-{method}", (
            f"{ROOM} {SUN} --height-map {{made}}/heights.png,0.5 --relief {method} {ALL}")
    for method in ("box", "plane", "sphere"):
        yield f"coordinates-{method}", (
            f"{BUNNY} {SUN} --normal-map {{made}}/normals.png --texture-coordinates {method} {ALL}")
    room = f"{ROOM} --environment"
    yield "environment", f"{room} {{made}}/sky.png,60 --skybox --reflectivity 0.5,0.1 {ALL}"
    yield "environment-ball", f"{room} {{data}}/metal_shiny.exr --skybox --hdr {ALL}"
    yield "environment-pbr", f"{room} {{made}}/sky.png --shading pbr {SUN} --shadows map {ALL}"
    yield "environment-forest", (
        f"{bike} --environment {{data}}/forest.exr,30 --skybox "
        f"--light sun:1,-1,1 --shadows map {ALL}")  # fmt: skip
    yield from models()


def models():
    """Models with bones, at their times."""
    walker = f"{MODELS}/X/Testwuson.X {SIZE} {BEHIND} --shadows map --time 0.6"
    for method in ("linear", "dual-quaternion", "key-matrix", "off"):
        yield f"skin-{method}", f"{walker} --skin {method} --layers depth,normal,actor {ALL}"
    yield "skeleton", f"{walker} --skeleton --opacity 0.4 {ALL}"
    yield "blend", f"{walker} --animation Wuson_Walk --blend Wuson_Run=0.3 --loop {ALL}"
    yield "bone-weight", f"{walker} --bone-weight Spine_Back01 {PNG}"
    yield "first-bone", f"{walker} --color-by first_bone {PNG}"
    for name, file in (
        ("bvh", "BVH/01_01.bvh --skeleton"), ("dae", "Collada/box_nested_animation.dae"),
        ("fbx", "FBX/huesitos.fbx"), ("iqm", "IQM/mrfixit.iqm"), ("ms3d", "MS3D/Wuson.ms3d"),
        ("gltf", "glTF2/simple_skin/simple_skin.gltf"), ("x", "X/BCN_Epileptic.X"),
    ):  # fmt: skip
        yield f"model-{name}", f"{MODELS}/{file} {SIZE} --time 0.7 --loop {ALL}"
    yield "model-textured", (
        f"{{data}}/textured/FBX/embedded_ascii/box_embedded_texture_fragmented.fbx {SIZE} {ALL}")
    yield "times", (
        f"{MODELS}/glTF2/simple_skin/simple_skin.gltf {SIZE} {SUN} --times 0:1.5:0.5 "
        "--png picture-%02d.png --exr frame-%d.exr --report report-%d.json")  # fmt: skip


def messages():
    """Refused arguments and unreadable files, each with its status."""
    refused = (
        "", "paint", "render", "render {made}/ground.vtp", "render --png a.png", "bench nothing",
        "cave", "stages more", "render {made}/nothing.off --png a.png",
        "render {made}/lamps.txt --png a.png",
        "render {made}/ground.vtp --size 0x10 --png a.png",
        "render {made}/ground.vtp --size 3 --png a.png",
    )  # fmt: skip
    refusals = (
        "--png a.jpg", "--png a.png --png b.png", "--png a.png --exr a.png", "--png no/a.png",
        "--png {made}/ground.vtp", "--exr a.exr --layers deep", "--exr a.exr --layers shadow_5",
        "--png a.png --camera 1,2,3", "--png a.png --camera 0,0,0,0,0,0,0,1,0",
        "--png a.png --clip 4,2", "--png a.png --view-angle 180", "--png a.png --shading oil",
        "--png a.png --preset desert", "--png a.png --color-by nothing",
        "--png a.png --colormap jet", "--png a.png --range 2,1", "--png a.png --color 1/2/3",
        "--png a.png --opacity 2", "--png a.png --light moon:1,2,3",
        "--png a.png --light sun:0,0,0",
        "--png a.png --shadows cube", "--png a.png --shadow-size 8", "--png a.png --soft-shadows 0",
        "--png a.png --colored-shadows", "--png a.png --shadow-tolerance 2 --shadows map",
        "--png a.png --shadow-tolerance x", "--png a.png --relief steep",
        "--png a.png --height-map {made}/cut.png", "--png a.png --normal-map {made}/nothing.png",
        "--png a.png --environment {made}/checks.txt", "--png a.png --environment {made}/cut.png",
        "--png a.png --skybox", "--png a.png --up w", "--png a.png --lamps {made}/nothing.vtp",
        "--png a.png --lamps {made}/lamps.vtp,falloff=cubic",
        "--png a.png --fog {made}/fog.vtp,mode=x",
        "--png a.png --fog {made}/fog.vtp,density=nothing",
        "--png a.png --markers {made}/markers.vtp,shape=star",
        "--png a.png --stage nothing", "--png a.png --stage fog:nothing=1",
        "--png a.png --stage shadows:bias=200", "--png a.png --stage display:layer=deep",
        "--png a.png --tone film", "--png a.png --exposure 30", "--png a.png --time 1",
        "--png a.png --times 0:1:0.5", "--png a.png --animation walk", "--png a.png --skin rubber",
        "--exr a.exr --deferred --layers albedo,nothing", "--png a.png --certify 10",
        "--frame 3 --png a.png",
    )  # fmt: skip
    yield "refused", [*refused, *(f"render {{made}}/ground.vtp {SIZE} {more}" for more in refusals)]
    broken = (
        "empty.off", "words.off", "missing.off", "huge.off", "infinite.off", "cut.stl", "cut.ply",
        "cut.vtp", "cut.bvh", "table.vtk", "lost.gltf",
    )  # fmt: skip
    yield "broken", [f"render {{made}}/{file} {SIZE} {PNG}" for file in broken]


def package():
    """Scenes of the Python package: scripts of this folder, and examples with arguments."""
    frames = (
        "layers", "attached", "report", "soft", "lamps", "fog", "markers", "environment", "files",
        "errors", "wireframe", "passes", "images", "described",
    )  # fmt: skip
    filters = ("relief", "blocks", "voxels", "particles", "caves", "skinned", "views", "points")
    for script, names in (("packageScenes", frames), ("filterScenes", filters)):
        for name in names:
            yield name, f"{{tools}}/{script}.py {{made}} {{data}} {name}"
    words = {"06_sun_study": "--every 240", "10_relief_terrain": "129", "21_soft_shadows": "4",
        "23_animation_series": "--rate 3"}  # fmt: skip
    for name in (
        "01_capture_depth", "02_write_exr", "03_debug_views", "04_point_cloud", "05_frame_report",
        "06_sun_study", "07_three_spots", "09_environment", "10_relief_terrain",
        "12_town_at_night", "13_fog_valley", "14_markers", "15_blocks", "16_caves",
        "18_voxel_cubes", "19_surface_particles", "20_moving_cubes", "21_soft_shadows",
        "22_animation", "23_animation_series", "24_soft_borders", "25_certified_shadows",
        "26_wall_thickness",
    ):  # fmt: skip
        yield f"example-{name}", f"{{examples}}/{name}.py out {words.get(name, '')}"


def scenes():
    """All scenes by name."""
    found = {}
    for name, words in render():
        found[f"render/{name}"] = Scene("relievo", [f"render {words}"], {0})
    for name, commands in messages():
        found[f"messages/{name}"] = Scene("relievo", commands, {1, 2})
    found["messages/help"] = Scene("relievo", ["--help", "--version", "stages"], {0})
    found["messages/viewer"] = Scene("relievo-viewer", ["--help", "--version"], {0})
    refused = ["--once", "{made}/nothing.off --once", "--frame", "{made}/empty.off --once"]
    found["messages/viewer-refused"] = Scene("relievo-viewer", refused, {1, 2})
    for content in ("mask", "density", "labels"):
        found[f"cave/{content}"] = Scene("relievo", [
            f"cave --size 40x24x40 --seed 3 --content {content} --width 5 --scale 24 -o caves.vti",
            f"render caves.vti {SIZE} {PNG}"], {0})  # fmt: skip
    for name, words in package():
        found[f"python/{name}"] = Scene("python", [words], {0})
    for name, words in (
        ("room", f"{SEEN} {GLASS} {LIGHTS} {LAMPS} {FOG} {MARKERS} --shadows map --tone simple"),
        ("soft", f"{{data}}/bunny.off {SIZED} --shadows exact --soft-shadows 8 --preset studio"),
        ("materials", "{made}/materials.obj --height-map {made}/heights.png"),
        ("model", f"{MODELS}/X/Testwuson.X --time 0.6 --skeleton --opacity 0.5"),
        ("colors", "{made}/wave.vtu --color-by wave --scalar-bar --deferred"),
    ):
        found[f"viewer/{name}"] = Scene("viewer", [f"{words} {WINDOW}"], {0})
    for name in ("shadows", "points", "materials", "layers", "filters", "model", "errors"):
        words = f"{{tools}}/paraviewScenes.py {{plugin}} {{made}} {{data}} {name}"
        found[f"paraview/{name}"] = Scene("pvpython", [words], {0})
    return found


def split(command, folders):
    """A command's arguments, with the folders inserted."""
    return [word.format(**folders) for word in shlex.split(command)]
