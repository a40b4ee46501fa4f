# SPDX-FileCopyrightText: Copyright (c) The Relievo authors
# SPDX-License-Identifier: BSD-3-Clause
"""A new sensor in words is a class with its words, a name in cameras/CMakeLists.txt and a row of
its page: after that the command, its help, its completion and Python have it. For testNewPass.py,
which builds the tree anyway.

The sensor is a panorama on a cylinder: columns are angles, rows heights.
"""

import os

HEADER = """// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRelievoCylinderCamera
 * @brief A panorama on a cylinder: columns are equal steps of the angle, rows of the height.
 */
#ifndef vtkRelievoCylinderCamera_h
#define vtkRelievoCylinderCamera_h

#include "vtkRelievoCameraModel.h"
#include "vtkRelievoSensorWords.h" // for words

#include <vector> // for words

class VTKRELIEVOCAMERAS_EXPORT vtkRelievoCylinderCamera : public vtkRelievoCameraModel
{
public:
  static vtkRelievoCylinderCamera* New();
  vtkTypeMacro(vtkRelievoCylinderCamera, vtkRelievoCameraModel);

#ifndef __VTK_WRAP__
  /** The words that say it. */
  static std::vector<vtkRelievoSensorWords> GetWords();
#endif

  ///@{
  /** Degrees that the columns span. */
  vtkSetMacro(Turn, double);
  vtkGetMacro(Turn, double);
  ///@}

  bool GetCameraRay(double u, double v, double origin[3], double direction[3]) override;
  bool ProjectCameraPoint(const double point[3], double pixel[2]) override;
  void Copy(vtkRelievoCameraModel* other) override;
  void AddTo(vtkFieldData* fields) override;

private:
  double Turn = 90.0;
};

#endif
"""

SOURCE = """// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRelievoCylinderCamera.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkRelievoCylinderCamera);

std::vector<vtkRelievoSensorWords> vtkRelievoCylinderCamera::GetWords()
{
  vtkRelievoSensorWords round = { "cylinder", "cylinder:DEG", { 1 }, ": a finite number above 0" };
  round.IsGood = [](const std::vector<double>& n) { return n[0] > 0.0; };
  round.Make = [](const std::vector<double>& n,
                const vtkRelievoSensorView&) -> vtkRelievoCameraModel* {
    auto* made = vtkRelievoCylinderCamera::New();
    made->SetTurn(n[0]);
    return made;
  };
  return { round };
}

bool vtkRelievoCylinderCamera::GetCameraRay(
  double u, double v, double origin[3], double direction[3])
{
  const double step = vtkMath::RadiansFromDegrees(this->Turn) / this->Size[0];
  const double angle = (u + 0.5 - 0.5 * this->Size[0]) * step;
  std::fill_n(origin, 3, 0.0);
  direction[0] = std::sin(angle);
  direction[1] = (v + 0.5 - 0.5 * this->Size[1]) * step;
  direction[2] = std::cos(angle);
  vtkMath::Normalize(direction);
  return true;
}

bool vtkRelievoCylinderCamera::ProjectCameraPoint(const double point[3], double pixel[2])
{
  const double step = vtkMath::RadiansFromDegrees(this->Turn) / this->Size[0];
  pixel[0] = std::atan2(point[0], point[2]) / step + 0.5 * this->Size[0] - 0.5;
  pixel[1] = point[1] / std::hypot(point[0], point[2]) / step + 0.5 * this->Size[1] - 0.5;
  return true;
}

void vtkRelievoCylinderCamera::Copy(vtkRelievoCameraModel* other)
{
  this->Superclass::Copy(other);
  auto* same = vtkRelievoCylinderCamera::SafeDownCast(other);
  this->Turn = same ? same->Turn : this->Turn;
}

void vtkRelievoCylinderCamera::AddTo(vtkFieldData* fields)
{
  this->Superclass::AddTo(fields);
  AddText(fields, "lens", "cylinder");
}
"""


def replace(path, old, new):
    text = path.read_text(encoding="utf-8")
    assert text.count(old) == 1, (path, old)
    path.write_text(text.replace(old, new), encoding="utf-8")


def add(tree):
    """The class, its name, and their documentation."""
    cameras = tree / "cameras"
    (cameras / "vtkRelievoCylinderCamera.h").write_text(HEADER, encoding="utf-8")
    (cameras / "vtkRelievoCylinderCamera.cxx").write_text(SOURCE, encoding="utf-8")
    replace(cameras / "CMakeLists.txt", "vtkRelievoOrthographicCamera)",
            "vtkRelievoOrthographicCamera\n  vtkRelievoCylinderCamera)")  # fmt: skip
    replace(tree / "docs" / "cameras.md", "| `orthographic[:PIXELS]` | pixels for a world unit |\n",
            "| `orthographic[:PIXELS]` | pixels for a world unit |\n"
            "| `cylinder:DEG` | a panorama on a cylinder, so many degrees wide |\n")  # fmt: skip


def on_the_command_line(run, build, folder):
    """In the help, the completion's words and messages; layers by its rays."""
    relievo = build / "bin" / "relievo"
    assert "orthographic[:PIXELS], cylinder:DEG; or" in " ".join(run([relievo, "--help"]).split())
    assert " orthographic cylinder:\n" in run([relievo, "--words"])
    mesh = folder / "square.off"
    mesh.write_text("OFF\n4 1 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n", encoding="utf-8")
    words = [relievo, "render", mesh, "--camera", "0,0,2,0,0,0,0,1,0", "--size", "80x60",
             "--preset", "none", "--lens"]  # fmt: skip
    run([*words, "cylinder:120", "--png", folder / "round.png", "--exr", folder / "round.exr",
         "--layers", "depth"])  # fmt: skip
    said = run([*words, "cylinder", "--png", folder / "no.png"], status=2)
    assert "got 'cylinder', expected cylinder:DEG: a finite number above 0" in said, said
    said = run([*words, "cylindre:4", "--png", folder / "no.png"], status=2)
    assert "orthographic[:PIXELS], cylinder:DEG, or a file" in said, said


PYTHON = """
import sys

import numpy
import relievo

assert "cylinder:DEG" in relievo.lens.__doc__
sensor = relievo.lens("cylinder:120", size=(80, 60)).look_at((0, 0, 2), (0, 0, 0))
image = relievo.read_exr(sys.argv[1] + "/round.exr")
depth = relievo.layer(image, "depth")
seen = numpy.isfinite(depth)
# Of 120 degrees in 80 columns, those whose tangent is below 1/2.
assert abs(seen[30].sum() - 2 * numpy.degrees(numpy.arctan(0.5)) / 1.5) < 1
assert sensor.project([(0, 0, 0)]).round(6).tolist() == [[39.5, 29.5]]
assert abs(depth[seen] - 2).max() < 1e-5
"""


def in_python(run, build, python, folder):
    """Words of relievo.lens, and the layers that the command wrote."""
    path = os.pathsep.join([str(build / "python"), os.environ["PYTHONPATH"]])  # and VTK's
    run([python, "-c", PYTHON, folder], env={**os.environ, "PYTHONPATH": path})
