// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SkinKeys.h"

#include "Table.h"
#include "vtkRelievoFormulas.h"

#include <algorithm>
#include <cmath>

namespace relievoBench
{
namespace
{
namespace f64 = relievo::f64;
constexpr double Pi = 3.14159265358979323846;

// One turn per second about a fixed axis, which slerp reproduces exactly; and a swing about a
// changing axis.
glm::dvec4 Turn(double t)
{
  return AboutAxis(glm::normalize(glm::dvec3(1., 2., 2.)), 2. * Pi * t);
}
glm::dvec4 Swing(double t)
{
  return f64::relievoQuaternionProduct(AboutAxis(glm::dvec3(0., 0., 1.), std::sin(2. * Pi * t)),
    AboutAxis(glm::dvec3(1., 0., 0.), 0.7 * std::sin(4. * Pi * t + 1.)));
}

// The end of an arm of length 1, oblique to the axes.
const glm::dvec3 Arm = glm::normalize(glm::dvec3(2., -2., 1.));

// A bone's motion: its rotation, and the position of its joint.
struct Motion
{
  const char* Name;
  glm::dvec4 (*Turned)(double);
  glm::dvec3 (*Place)(double);
};

glm::dvec3 Still(double)
{
  return glm::dvec3(0.);
}
// At an arm's length around the axis of Turn, and along it: the screw motion of a rigid body.
glm::dvec3 Screw(double t)
{
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1., 2., 2.));
  return f64::relievoQuaternionRotate(Turn(t), Arm) + axis * (0.5 * t);
}

const Motion Motions[] = { { "one turn a second", Turn, Still }, { "a swing", Swing, Still },
  { "a screw", Turn, Screw } };
}

//------------------------------------------------------------------------------
glm::dvec4 AboutAxis(const glm::dvec3& axis, double angle)
{
  return glm::dvec4(axis * std::sin(angle / 2.), std::cos(angle / 2.));
}

//------------------------------------------------------------------------------
bool MeasureSkinKeys(const std::string& outDir)
{
  Table table({ "motion", "method", "keys per second", "largest error of the angle, degrees",
    "largest error of the arm's end, arm's lengths" });
  for (const Motion& motion : Motions)
  {
    for (const std::string method : { "key-matrix", "nlerp", "slerp" })
    {
      for (const int keys : { 3, 4, 6, 8, 12, 15, 24, 30, 60, 120 })
      {
        double angle = 0.;
        double off = 0.;
        for (int i = 0; i < 5000; ++i)
        {
          const double t = i / 5000.;
          const double key = std::floor(t * keys);
          const double share = t * keys - key;
          const glm::dvec4 a = motion.Turned(key / keys);
          const glm::dvec4 b = motion.Turned((key + 1.) / keys);
          const glm::dvec4 truth = motion.Turned(t);
          const glm::dvec4 q = method == "slerp" ? f64::relievoQuaternionSlerp(a, b, share)
                                                 : f64::relievoQuaternionNlerp(a, b, share);
          const glm::dvec3 arm = method == "key-matrix"
            ? f64::relievoQuaternionRotate(a, Arm) * (1. - share) +
              f64::relievoQuaternionRotate(b, Arm) * share
            : f64::relievoQuaternionRotate(q, Arm);
          const glm::dvec3 place =
            motion.Place(key / keys) * (1. - share) + motion.Place((key + 1.) / keys) * share;
          const glm::dvec3 expected = motion.Place(t) + f64::relievoQuaternionRotate(truth, Arm);
          const glm::dvec4 near = f64::relievoQuaternionNear(q, truth);
          angle = std::max(angle,
            4. * std::atan2(glm::length(near - truth), glm::length(near + truth)) * 180. / Pi);
          off = std::max(off, glm::length(place + arm - expected));
        }
        // Blended matrices have no exact angle: their rotation nearly equals that of nlerp.
        table.AddRow({ motion.Name, method, std::to_string(keys),
          method == "key-matrix" ? std::string() : Number(angle, 3), Number(off, 3) });
      }
    }
  }
  return table.WriteCsv(outDir + "/skin-keys.csv");
}
}
