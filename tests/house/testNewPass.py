# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""testNewPass.py SOURCE [CMAKE CTEST [OPTIONS...]]: a pass and a layer, added as CONTRIBUTING says.

In a copy of the tree, tools/new-pass adds a pass. With the words of a build, which takes minutes
and is left to the night, the copy is built, the new pass's own test runs, and the pass is used from
the command line, Python and ParaView, whose sources are as they were. So is a layer that one entry
adds to the catalogue (newLayer.py), and values that their class and its page have, of fog
(newValue.py) and of materials (newSurfaceValue.py), a setting of a filter and an option of a
command (newSetting.py), options of render (newOption.py), a format of data sets (newFormat.py),
formats of files (newFileFormat.py) and a sensor in words (newLens.py). The tests that compare pages
with the code pass with all of them.
"""

import filecmp
import json
import os
import pathlib
import shutil
import subprocess
import sys

import newFileFormat
import newFormat
import newLayer
import newLens
import newOption
import newSetting
import newSurfaceValue
import newValue

NAME = "Mist"


def run(words, status=0, **options):
    done = subprocess.run(words, capture_output=True, text=True, check=False, **options)
    if done.returncode != status:
        sys.exit(f"{' '.join(map(str, words))}: status {done.returncode}, expected {status}\n"
                 f"{done.stdout[-6000:]}{done.stderr[-6000:]}")
    return done.stdout + done.stderr


def copy_tree(source, tree):
    """The files that git knows or would add; an unchanged file keeps its time."""
    listed = subprocess.run(
        ["git", "-C", source, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        capture_output=True, check=False)
    if listed.returncode != 0:
        print("skipped: the source is not a git tree")
        sys.exit(125)
    names = {name for name in os.fsdecode(listed.stdout).split("\0") if name}
    names = {name for name in names if (source / name).is_file()}
    for name in names:
        target = tree / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or not filecmp.cmp(source / name, target, shallow=False):
            shutil.copy(source / name, target)
    for path in tree.rglob("*"):
        name = path.relative_to(tree)
        if path.is_file() and name.parts[0] != "build" and name.as_posix() not in names:
            path.unlink()


def copy_new(source, tree):
    """A tree of the files that were written, with their module and all headers; houseChecks has the
    others."""
    folder = tree.with_name("written")
    shutil.rmtree(folder, ignore_errors=True)
    for path in tree.rglob("*"):
        name = path.relative_to(tree)
        if not path.is_file() or name.parts[0] == "build":
            continue
        known = (source / name).is_file() and filecmp.cmp(source / name, path, shallow=False)
        if not known or name.parts[0] == "passes" or name.suffix in (".h", ".module") or (
            name.name == ".clang-format"
        ):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, folder / name)
    return folder


def main(source, cmake=None, ctest=None, *options):
    source = pathlib.Path(source)
    tree = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"]) / "tree"
    copy_tree(source, tree)
    generator = [tree / "tools" / "new-pass"]
    run([*generator, "two words", "Nothing"], status=2)
    run([*generator, NAME], status=2)
    print(run([*generator, NAME, "Mist in front of what is far"]))
    again = run([*generator, NAME, "Once more"], status=1)
    assert "there already" in again, again
    run([*generator, f"Deep{NAME}", "Mist of two words"])

    listed = (tree / "CHANGELOG.md").read_text(encoding="utf-8")
    assert f"- `vtkRelievo{NAME}Stage`: mist in front of what is far.\n" in listed, listed
    page = f"docs/passes/{NAME}.md"
    listed = (tree / "README.md").read_text(encoding="utf-8")
    assert f"| [{page}]({page}) | mist in front of what is far |\n" in listed, listed
    listed = (tree / "docs" / "site" / "guide.md").read_text(encoding="utf-8")
    assert f"\npasses/{NAME}\n" in listed, listed
    words = ["--no-tidy", "--tree", copy_new(source, tree)]
    check = subprocess.run([tree / "tools" / "check", *words],
                           capture_output=True, text=True, check=False)
    assert "modules " in check.stdout, check.stdout
    complaints = [line for line in check.stdout.splitlines() if NAME.lower() in line.lower()]
    assert not complaints, complaints

    newLayer.add(tree)
    newSetting.add(tree)
    newOption.add(tree)
    newFormat.add(tree)
    newFileFormat.add(tree)
    newLens.add(tree)
    newValue.add(tree)
    newSurfaceValue.add(tree)
    if not cmake:
        return 0
    build = tree / "build" / "dev"
    run([cmake, "-G", "Ninja", "-S", tree, "-B", build, *options])
    paraview = "-DRELIEVO_USE_PARAVIEW=ON" in options and shutil.which("pvpython")
    plugin = ["Relievo"] if paraview else []
    listed = run([cmake, "--build", build, "--target", "help"])
    # The manual page is for testCliShell.
    there = [name for name in ("relievo_tests_viewer", "relievoManual") if f"{name}:" in listed]
    viewer = "relievo_tests_viewer" in there
    targets = ["relievo_tests_effects", "relievo", "relievo_python", *plugin, *there]
    run([cmake, "--build", build, "--target", *targets])
    pages = "testPython_test(Layers|PointValues|SurfaceValues)|testCliShell"
    output = run([ctest, "--test-dir", build, "-R", f"^(test{NAME}Stage|{pages})$",
                  "--no-tests=error", "--output-on-failure"])
    assert "100% tests passed" in output, output
    print(output)
    folder = tree.parent
    on_the_command_line(build)
    newLayer.on_the_command_line(run, build, folder)
    newSetting.on_the_command_line(run, build, folder)
    newOption.on_the_command_line(run, build, folder)
    newFormat.on_the_command_line(run, build, folder)
    newFileFormat.on_the_command_line(run, build, folder)
    newLens.on_the_command_line(run, build, folder)
    newValue.on_the_command_line(run, build, folder)
    newSurfaceValue.on_the_command_line(run, build, folder)
    python = next(each for each in options if each.startswith("-DPython3_EXECUTABLE"))
    python = python.split("=", 1)[1]
    in_python(build, python)
    newLayer.in_python(run, build, python, folder)
    newSetting.in_python(run, build, python, folder)
    newOption.in_python(run, build, python, folder)
    newFormat.in_python(run, build, python, folder)
    newFileFormat.in_python(run, build, python, folder)
    newLens.in_python(run, build, python, folder)
    newValue.in_python(run, build, python, folder)
    newSurfaceValue.in_python(run, build, python, folder)
    if viewer:
        newOption.in_the_viewer(run, build, python)
        newSurfaceValue.in_the_viewer(run, build, python)
    if paraview:
        in_paraview(build)
        newLayer.in_paraview(run, build, folder)
        newSetting.in_paraview(run, build, folder)
        newFileFormat.in_paraview(run, build, folder)
        newValue.in_paraview(run, build, folder)
        newSurfaceValue.in_paraview(run, build, folder)
        in_the_dock(source, build)
    return 0


def on_the_command_line(build):
    """`relievo` knows the stage and its parameters without a line of its own."""
    relievo = build / "bin" / "relievo"
    folder = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"])
    mesh = folder / "floor.off"
    mesh.write_text("OFF\n4 1 0\n-1 0 -9\n1 0 -9\n1 0 1\n-1 0 1\n4 0 1 2 3\n", encoding="utf-8")
    listed = run([relievo, "stages"])
    assert "\nmist\n" in listed and "\ndeep_mist\n" in listed, listed
    assert "strength=0.5" in listed, listed
    words = [relievo, "render", mesh, "--size", "200x150", "--camera", "0,1,3,0,0,0,0,1,0",
             "--clip", "1,14"]
    run([*words, "--png", folder / "plain.png"])
    for value in ("0", "0.9"):
        run([*words, "--stage", f"mist:strength={value},color=1,0,0", "--png",
             folder / f"mist{value}.png"])
    plain = (folder / "plain.png").read_bytes()
    assert (folder / "mist0.png").read_bytes() == plain
    assert (folder / "mist0.9.png").read_bytes() != plain
    said = run([*words, "--stage", "mist:strength=2", "--png", folder / "no.png"], status=2)
    assert "mist:strength" in said and "0 to 1" in said, said
    said = run([*words, "--stage", "mits", "--png", folder / "no.png"], status=2)
    assert "mist" in said, said


PYTHON = """
import relievo
from vtkmodules.vtkRenderingCore import vtkRenderer

assert relievo.stages()["mist"]["strength"][0] == "0.5", relievo.stages()
renderer = vtkRenderer()
stage = relievo.stage(renderer, "mist", strength=0.25, color=(1, 0, 0))
assert stage.GetEnabled() and stage.GetStrength() == 0.25 and stage.GetColor() == (1, 0, 0)
try:
    relievo.stage(renderer, "mist", strength=7)
    raise SystemExit("a strength of 7 was taken")
except ValueError as error:
    assert "0 to 1" in str(error), error
assert stage.GetStrength() == 0.25
"""


def in_python(build, python):
    """The package has the stage by name."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([python, "-c", PYTHON], env={**os.environ, "PYTHONPATH": path})


PARAVIEW = """
import sys
from paraview import simple, smtrace
from vtkmodules.vtkIOImage import vtkPNGReader

plugin, folder = sys.argv[1:]
simple.LoadPlugin(plugin, remote=False, ns=simple.__dict__)
view = simple.CreateView("RenderView")
view.ViewSize = [200, 150]
simple.Show(simple.Plane(), view)
simple.Render(view)
simple.SaveScreenshot(folder + "/plain.png", view)
smtrace.start_trace()
item = smtrace._create_trace_item_internal("PropertiesModified", kwargs={"proxy": view})
view.RelievoStageMist = 1
view.RelievoStageMistStrength = 0.9
view.RelievoStageMistColor = [1, 0, 0]
item.finalize()
del item
trace = smtrace.stop_trace()
assert "RelievoStageMistStrength = 0.9" in trace, trace
view.RelievoStageMist = 5  # with a warning
assert view.SMProxy.GetProperty("RelievoStageMist").GetElement(0) == 1
simple.Render(view)
simple.SaveScreenshot(folder + "/mist.png", view)
reader = vtkPNGReader()
reader.SetFileName(folder + "/mist.png")
reader.Update()
middle = [reader.GetOutput().GetScalarComponentAsFloat(100, 75, 0, i) for i in range(3)]
corner = [reader.GetOutput().GetScalarComponentAsFloat(190, 140, 0, i) for i in range(3)]
assert middle[0] > 60 and middle[0] > 1.2 * middle[1], middle
assert min(corner) > 40, corner
simple.SaveState(folder + "/mist.pvsm")
view.RelievoStageMist = 0
simple.Render(view)
simple.SaveScreenshot(folder + "/again.png", view)
"""


RESTORE = """
import sys
from paraview import simple

plugin, folder = sys.argv[1:]
simple.LoadPlugin(plugin, remote=False, ns=simple.__dict__)
simple.LoadState(folder + "/mist.pvsm")
view = simple.GetActiveView()
assert view.RelievoStageMistStrength == 0.9 and list(view.RelievoStageMistColor) == [1, 0, 0]
simple.SaveScreenshot(folder + "/restored.png", view)
"""


def in_paraview(build):
    """A view has the stage as properties: picture, trace and state."""
    folder = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"])
    script = folder / "useInParaView.py"
    plugin = build / "plugin" / "Relievo" / "Relievo.so"
    for text in (PARAVIEW, RESTORE):
        script.write_text(text, encoding="utf-8")
        output = run(["pvpython", script, plugin, folder])
        assert "ERR|" not in output, output
        assert output.count("expected 0 to 1: 1 is taken") == (text is PARAVIEW), output
    assert (folder / "restored.png").read_bytes() == (folder / "mist.png").read_bytes()
    plain = (folder / "plain.png").read_bytes()
    assert (folder / "mist.png").read_bytes() != plain
    assert (folder / "again.png").read_bytes() == plain


DOCK = """<?xml version="1.0" ?>
<pqevents>
  <pqevent object="{shell}" command="executeCommand"
    arguments="from windowShell import *; scene()" />
  <pqevent object="{dock}/RelievoStageMist/CheckBox" command="set_boolean" arguments="true" />
  <pqevent object="{shell}" command="executeCommand"
    arguments="values('mist', 'RelievoStageMist')" />
</pqevents>
"""
SHELL = "pqClientMainWindow/pythonShellDock/pythonShell/consoleWidget"
STAGES = ("pqClientMainWindow/pqRelievoPanel/1QScrollArea0/qt_scrollarea_viewport/content/all/"
          "stages/RelievoStageMist/stages")


def in_the_dock(source, build):
    """In ParaView's window, the dock has a control of the stage, which switches it on."""
    client = shutil.which("paraview")
    if not client:
        print("not in the dock: paraview's window is not installed")
        return
    folder = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"])
    script = folder / "dock.xml"
    script.write_text(DOCK.format(shell=SHELL, dock=STAGES), encoding="utf-8")
    notes = folder / "notes.jsonl"
    notes.unlink(missing_ok=True)
    home = folder / "home"
    shutil.rmtree(home, ignore_errors=True)
    home.mkdir(mode=0o700)
    output = run(
        [client, "--dr", "--exit", f"--test-script={script}", f"--test-directory={folder}"],
        env={**os.environ, "HOME": str(home), "XDG_RUNTIME_DIR": str(home),
             "PYTHONPATH": str(source / "tests" / "paraview" / "gui"),
             "PV_PLUGIN_PATH": str(build / "plugin" / "Relievo")})
    assert "Success =  true" in output and "ERR|" not in output, output
    noted = dict(json.loads(line) for line in notes.read_text(encoding="utf-8").splitlines())
    assert noted == {"mist": [1]}, noted


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
