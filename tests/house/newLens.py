# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A new sensor in words is a class with its words, a name in cameras/CMakeLists.txt and a row of
its page: after that the command, its help, its completion and Python have it. For testNewPass.py,
which builds the tree anyway.

The sensor sees a slice of the world from a wall: parallel columns, whose rows are angles.
"""

import os

HEADER = """// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoWallCamera
 * @brief Sees along z from a wall: each column from its own place, whose rows are 90 degrees.
 */
#ifndef vtkRelievoWallCamera_h
#define vtkRelievoWallCamera_h

#include "vtkRelievoCameraModel.h"
#include "vtkRelievoSensorWords.h" // for words

#include <vector> // for words

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoWallCamera : public vtkRelievoCameraModel
{
public:
  static vtkRelievoWallCamera* New();
  vtkTypeMacro(vtkRelievoWallCamera, vtkRelievoCameraModel);

#ifndef __VTK_WRAP__
  /** The words that say it. */
  static std::vector<vtkRelievoSensorWords> GetWords();
#endif

  ///@{
  /** World units from the first column to the last. */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  bool GetCameraRay(double u, double v, double origin[3], double direction[3]) override;
  bool ProjectCameraPoint(const double point[3], double pixel[2]) override;
  void Copy(vtkRelievoCameraModel* other) override;
  void AddTo(vtkFieldData* fields) override;

private:
  double Width = 1.0;
};

#endif
"""

SOURCE = """// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoWallCamera.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoWallCamera);

std::vector<vtkRelievoSensorWords> vtkRelievoWallCamera::GetWords()
{
  vtkRelievoSensorWords wall = { "wall", "wall:WIDTH", { 1 }, ": a finite number above 0" };
  wall.IsGood = [](const std::vector<double>& n) { return n[0] > 0.0; };
  wall.Make = [](const std::vector<double>& n,
                const vtkRelievoSensorView&) -> vtkRelievoCameraModel* {
    auto* made = vtkRelievoWallCamera::New();
    made->SetWidth(n[0]);
    return made;
  };
  return { wall };
}

bool vtkRelievoWallCamera::GetCameraRay(
  double u, double v, double origin[3], double direction[3])
{
  const double angle = std::atan(1.0) * (2.0 * (v + 0.5) / this->Size[1] - 1.0);
  std::fill_n(origin, 3, 0.0);
  origin[0] = this->Width * ((u + 0.5) / this->Size[0] - 0.5);
  direction[0] = 0.0;
  direction[1] = std::sin(angle);
  direction[2] = std::cos(angle);
  return true;
}

bool vtkRelievoWallCamera::ProjectCameraPoint(const double point[3], double pixel[2])
{
  const double angle = std::atan2(point[1], point[2]);
  pixel[0] = (point[0] / this->Width + 0.5) * this->Size[0] - 0.5;
  pixel[1] = (0.5 + 0.5 * angle / std::atan(1.0)) * this->Size[1] - 0.5;
  return true;
}

void vtkRelievoWallCamera::Copy(vtkRelievoCameraModel* other)
{
  this->Superclass::Copy(other);
  auto* same = vtkRelievoWallCamera::SafeDownCast(other);
  this->Width = same ? same->Width : this->Width;
}

void vtkRelievoWallCamera::AddTo(vtkFieldData* fields)
{
  this->Superclass::AddTo(fields);
  AddText(fields, "lens", "wall");
}
"""


def replace(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert text.count(old) == 1, (path, old)
    path.write_text(text.replace(old, new), encoding="utf-8")


def add(tree):
    """The class, its name, and what is written of it."""
    cameras = tree / "cameras"
    (cameras / "vtkRelievoWallCamera.h").write_text(HEADER, encoding="utf-8")
    (cameras / "vtkRelievoWallCamera.cxx").write_text(SOURCE, encoding="utf-8")
    replace(cameras / "CMakeLists.txt", "vtkRelievoOrthographicCamera)",
            "vtkRelievoOrthographicCamera\n  vtkRelievoWallCamera)")  # fmt: skip
    replace(tree / "docs" / "cameras.md", "| `orthographic[:PIXELS]` | pixels for a world unit |\n",
            "| `orthographic[:PIXELS]` | pixels for a world unit |\n"
            "| `wall:WIDTH` | parallel columns over so many world units |\n")  # fmt: skip


def on_the_command_line(run, build, folder):
    """In the help, the completion's words and messages; layers by its rays."""
    relievo = build / "bin" / "relievo"
    assert "orthographic[:PIXELS], wall:WIDTH; or" in " ".join(run([relievo, "--help"]).split())
    assert " orthographic wall:\n" in run([relievo, "--words"])
    mesh = folder / "square.off"
    mesh.write_text("OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n", encoding="utf-8")
    words = [relievo, "render", mesh, "--camera", "0,0,2,0,0,0,0,1,0", "--size", "80x60",
             "--preset", "none", "--lens"]  # fmt: skip
    run([*words, "wall:4", "--png", folder / "wall.png", "--exr", folder / "wall.exr", "--layers",
         "depth"])  # fmt: skip
    wrong = run([*words, "wall", "--png", folder / "no.png"], status=2)
    assert "got 'wall', expected wall:WIDTH: a finite number above 0" in wrong, wrong
    wrong = run([*words, "wal:4", "--png", folder / "no.png"], status=2)
    assert "orthographic[:PIXELS], wall:WIDTH, or a file" in wrong, wrong


PYTHON = """
import sys

import numpy
import relievo

assert "wall:WIDTH" in relievo.lens.__doc__
sensor = relievo.lens("wall:4", size=(80, 60)).look_at((0, 0, 2), (0, 0, 0))
image = relievo.read_exr(sys.argv[1] + "/wall.exr")
depth = relievo.layer(image, "depth")
seen = numpy.isfinite(depth)
# 2 of 4 world units across; of 90 degrees those whose tangent is below 1/2.
assert seen[30].sum() == 40 and abs(seen[:, 40].sum() - 60 * numpy.arctan(0.5) / (numpy.pi / 4)) < 2
assert abs(depth[seen] - 2).max() < 1e-5
"""


def in_python(run, build, python, folder):
    """Words of relievo.lens, and the layers that the command wrote."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([python, "-c", PYTHON, folder], env={**os.environ, "PYTHONPATH": path})
