# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""testChecks.py CHECK: tools/check finds each kind of mistake, and none in a clean tree."""

import os
import pathlib
import shutil
import subprocess
import sys

LICENCE = (
    "// SPDX-FileCopyrightText: Copyright (c) The Relievo authors\n"
    "// SPDX-License-Identifier: BSD-3-Clause\n"
)
CLEAN = {
    "passes/vtkA.cxx": LICENCE + 'bool A()\n{\n  return Has(fragment, "vec3 albedo =");\n}\n',
    "passes/vtk.module": "NAME\n  Relievo::Passes\nPRIVATE_DEPENDS\n  Relievo::Frame\n",
    "passes/gbuffer/vtk.module": "NAME\n  Relievo::GBuffer\nDEPENDS\n  Relievo::Frame\n",
    "shaders/a.glsl": LICENCE + "void main() { gl_FragDepth = 0.5; }\n",
    "shaders/splice/contract.glsl": LICENCE + "#define RELIEVO_LIT 1.0\n",
    "shaders/gbuffer/a.glsl": LICENCE + "// RELIEVO_LIT, RELIEVO_WORDS\n",
    "shaders/shadow/a.glsl": LICENCE + "// RELIEVO_LIT, RELIEVO_LIGHTS\n",
    "look/lights/Sun.h": LICENCE + '#include "Color.h"\n',
    "plugin/vtkP.cxx": LICENCE + '#include "vtkPVView.h"\n',
    "tools/run": "#!/usr/bin/env bash\n# SPDX-License-Identifier: BSD-3-Clause\necho ok\n",
    "python/relievo/a.py": "# SPDX-License-Identifier: BSD-3-Clause\nvalue = 1\n",
    "python/relievo/_sight/rays.py": "# SPDX-License-Identifier: BSD-3-Clause\n"
                                     "from .._images.image import layer\n",
}
# Each mistake: the file that holds it, its text, and words of the complaint.
MISTAKES = {
    "look": ("passes/vtkB.cxx", LICENCE + "int  B(){return 1;}\n", "clang-format"),
    "shell": ("tools/bad", CLEAN["tools/run"] + "cd $1 && rm -rf $unset/*\nfi\n", "shellcheck"),
    "python": ("python/relievo/b.py", CLEAN["python/relievo/a.py"] + "def (:\n",
               "does not compile"),
    "python's text": ("python/relievo/b.py", CLEAN["python/relievo/a.py"] + "value = '\0'\n",
                      "does not compile"),
    "licence": ("io/vtkB.h", "int B();\n", "SPDX"),
    "blanks": ("shaders/b.glsl", LICENCE + "float b; \n", "white space"),
    "tab": ("python/relievo/c.py", CLEAN["python/relievo/a.py"] + "\tx = 1\n", "tab"),
    "wide": ("shaders/c.glsl", LICENCE + "// " + "x" * 100 + "\n", "100 columns"),
    "private word": ("io/vtkW.h", LICENCE + "// The nearest meeting of a ray.\n", "say hit"),
    "private name": ("io/vtkX.h", LICENCE + "int GetReaderDoor();\n", "interface"),
    "no noun": ("docs/a.md", "The depth is infinite where nothing is.\n", "the noun"),
    "wrong": ("tests/testW.cxx", LICENCE + "int wrong = 0;\n", "says how"),
    "beam": ("rays/vtkY.h", LICENCE + "// Along a beam.\n", "a ray"),
    "version": ("io/vtkV.h", LICENCE + "#if VTK_VERSION_NUMBER > 1\n#endif\n",
                "vtkRelievoVTKVersions.h"),
    "ParaView": ("passes/vtkC.h", LICENCE + "class vtkPVView;\n", "plugin/ only"),
    "ParaView module": ("io/vtk.module", "NAME\n  Relievo::IO\nDEPENDS\n  ParaView::Core\n",
                        "plugin/ only"),
    "GLSL": ("passes/vtkD.cxx", LICENCE + 'const char* D = "gl_FragDepth = 1.;";\n', "shaders/"),
    "GLSL uniform": ("passes/vtkE.cxx", LICENCE + 'const char* E = "uniform vec3 e;";\n',
                     "shaders/"),
    "GLSL input": ("materials/vtkE.cxx", LICENCE + 'const char* E = "in vec2 tcoord;";\n',
                   "shaders/"),
    "GLSL expression": ("materials/vtkF.cxx",
                        LICENCE + 'std::string F(std::string i)\n{\n  return "normalize(light" + '
                        'i + " - placeVC)";\n}\n', "shaders/"),
    "GLSL variable": ("passes/vtkF.cxx",
                      LICENCE + 'const char* F = "  float relievoLit = 1.0;";\n', "shaders/"),
    "undeclared macro": ("shaders/gbuffer/b.glsl", LICENCE + "#ifdef RELIEVO_LIGHTS\n#endif\n",
                         "contract.glsl"),
    "OpenGL": ("filters/vtkF.h", LICENCE + '#include "vtkOpenGLActor.h"\n', "use no OpenGL"),
    "sideways": ("filters/vtk.module", "NAME\n  Relievo::Filters\nDEPENDS\n  Relievo::Passes\n",
                 "may not stand on this one"),
    "across": ("passes/shadows/vtk.module",
               "NAME\n  Relievo::Shadows\nDEPENDS\n  Relievo::GBuffer\n",
               "may not stand on this one"),
    "upwards": ("shaders/vtk.module", "NAME\n  Relievo::Shaders\nDEPENDS\n  Relievo::IO\n",
                "may not stand on this one"),
    "mutual imports": ("python/relievo/_images/image.py", CLEAN["python/relievo/a.py"]
                       + "def layer():\n    from .._sight.rays import Rays\n",
                       "include each other"),
    "mutual": ("look/colors/Color.h", LICENCE + '#include "Sun.h"\n', "include each other"),
    "base": ("base/vtk.module", "NAME\n  Relievo::Base\nDEPENDS\n  Relievo::Shaders\n",
             "may not stand on this one"),
    "neighbours": ("apps/tool/a.cxx", LICENCE + '#include "../../plugin/vtkP.h"\n',
                   "do not know each other"),
    "window kit": ("qt/a.cxx", LICENCE + '#include "../apps/viewer/docks/Panel.h"\n',
                   "knows neither the viewer"),
}


def write(tree, files):
    for name, text in files.items():
        path = tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def check(command, tree):
    done = subprocess.run(
        [command, "--no-tidy", "--tree", str(tree)], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def main(command):
    missing = [tool for tool in ("clang-format", "shellcheck") if shutil.which(tool) is None]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed (tools/install-packages check)")
        return 125
    look = pathlib.Path(command).parents[1] / ".clang-format"
    tree = pathlib.Path(os.environ["RELIEVO_TEST_OUTPUT"]) / "tree"
    failures = []
    for name, (path, text, words) in {"none": ("a", "", ""), **MISTAKES}.items():
        shutil.rmtree(tree, ignore_errors=True)
        write(tree, {**CLEAN, ".clang-format": look.read_text(encoding="utf-8")})
        if name != "none":
            write(tree, {path: text})
        status, output = check(command, tree)
        lines = [line for line in output.splitlines()
                 if line.startswith(path) and words in line]
        if name == "none" and status != 0:
            failures.append(f"a clean tree: status {status}\n{output}")
        if name != "none" and (status != 1 or not lines):
            failures.append(
                f"{name}: no complaint about {path} with '{words}', status {status}\n{output}")
    print("\n".join(failures) or f"{len(MISTAKES)} kinds of mistakes found, none in a clean tree")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
