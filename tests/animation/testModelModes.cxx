// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Keys of glTF that are steps and splines, against closed forms and against VTK's own reader, which
// shares nothing with Assimp; and files whose keys do not fit.
#include "Check.h"
#include "GltfScene.h"
#include "ReaderErrors.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkCompositeDataIterator.h>
#include <vtkGLTFReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRelievoModelReader.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace testModelModes
{
namespace
{
using namespace relievoTest;

std::vector<glm::dvec3> PointsOf(vtkDataObject* data)
{
  std::vector<glm::dvec3> points;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(blocks->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto* mesh = vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
    for (vtkIdType i = 0; mesh && i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      points.emplace_back(p[0], p[1], p[2]);
    }
  }
  return points;
}

// Largest distance from a point of one to the next of the other: Assimp numbers points anew.
double DistanceOf(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to)
{
  double largest = from.empty() || to.empty() ? 1e300 : 0.;
  for (const glm::dvec3& a : from)
  {
    double nearest = 1e300;
    for (const glm::dvec3& b : to)
    {
      nearest = std::min(nearest, glm::length(a - b));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

// Largest distance of ours from VTK's, at 100 times between the ends or at the keys alone.
double CompareWithVTK(const std::string& path, bool keys)
{
  vtkNew<vtkRelievoModelReader> ours;
  ours->SetFileName(path.c_str());
  ours->UpdateInformation();
  vtkNew<vtkGLTFReader> theirs;
  theirs->SetFileName(path.c_str());
  theirs->UpdateInformation();
  theirs->EnableAnimation(0);
  theirs->UpdateInformation();
  vtkInformation* info = ours->GetOutputInformation(0);
  const double* range = info->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  std::vector<double> times;
  if (keys)
  {
    const double* steps = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    times.assign(steps, steps + info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
  }
  for (int i = 0; i < 100 && !keys; ++i)
  {
    times.push_back(range[0] + (range[1] - range[0]) * (i + 0.5) / 100.);
  }
  double off = 0.;
  for (const double time : times)
  {
    ours->UpdateTimeStep(time);
    theirs->UpdateTimeStep(time);
    const auto a = PointsOf(ours->GetOutput());
    const auto b = PointsOf(theirs->GetOutputDataObject(0));
    off = Larger(off, Larger(DistanceOf(a, b), DistanceOf(b, a)));
  }
  return off;
}

glm::dvec3 FirstAt(vtkRelievoModelReader* reader, double time)
{
  reader->UpdateTimeStep(time);
  const std::vector<glm::dvec3> points = PointsOf(reader->GetOutput());
  return points.empty() ? glm::dvec3(1e300) : points[0];
}

const GltfTrack Steps = { "translation", "STEP", { 0.f, 1.f, 3.f },
  { 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 5.f, 0.f } };
// y by splines: from 0 with slope 2 to 1 with slope 0, and to 3, reached with slope -1.
const GltfTrack Splines = { "translation", "CUBICSPLINE", { 0.f, 1.f, 3.f },
  { 0.f, 9.f, 0.f, /**/ 0.f, 0.f, 0.f, /**/ 0.f, 2.f, 0.f, //
    0.f, 0.f, 0.f, /**/ 0.f, 1.f, 0.f, /**/ 0.f, 0.f, 0.f, //
    0.f, -1.f, 0.f, /**/ 0.f, 3.f, 0.f, /**/ 0.f, 9.f, 0.f } };

void TestSteps(const std::string& name, bool named)
{
  const std::string path = OutputFolder() + "/" + name;
  WriteGltf(path, { Steps }, named);
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(path.c_str());
  const std::pair<double, double> expected[] = { { 0., 0. }, { 0.99, 0. }, { 1., 1. }, { 2.9, 1. },
    { 3., 5. }, { 9., 5. }, { -1., 0. } };
  for (const auto& [time, y] : expected)
  {
    RELIEVO_CHECK_NEAR(FirstAt(reader, time).y, y, 1e-6, name + ": step");
  }
  RELIEVO_CHECK(reader->GetNumberOfNotes() == 0);
}

// A key for each picture of 30 a second, at its time as a double, and as the reader says it.
void TestStepsOfPictures()
{
  const std::string path = OutputFolder() + "/pictures.gltf";
  GltfTrack track = { "translation", "STEP", {}, {} };
  const int count = 89;
  for (int i = 0; i < count; ++i)
  {
    track.Times.push_back(static_cast<float>(i) / 30.f);
    track.Values.insert(track.Values.end(), { 0.f, static_cast<float>(i), 0.f });
  }
  WriteGltf(path, { track });
  for (const double speed : { 1., 0.3, 7. })
  {
    vtkNew<vtkRelievoModelReader> reader;
    reader->SetFileName(path.c_str());
    reader->SetSpeed(speed);
    reader->UpdateInformation();
    vtkInformation* info = reader->GetOutputInformation(0);
    RELIEVO_CHECK(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()) == count);
    const double* said = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
    const std::vector<double> steps(said, said + count);
    int mismatches = 0;
    for (int i = 0; i < count; ++i)
    {
      const double y = FirstAt(reader, 0.).y + i;
      mismatches +=
        FirstAt(reader, steps[i]).y != y || FirstAt(reader, i / 30. / speed).y != y ? 1 : 0;
    }
    RELIEVO_CHECK_THAT(mismatches == 0, std::to_string(mismatches) + " keys are late");
  }
}

void TestSplines(const std::string& name)
{
  const std::string path = OutputFolder() + "/" + name;
  WriteGltf(path, { Splines });
  vtkNew<vtkRelievoModelReader> reader;
  reader->SetFileName(path.c_str());
  for (const double s : { 0., 0.1, 0.5, 0.75, 1. })
  {
    // Bernstein's form: control points a third of the slopes away.
    const auto bernstein = [s](double a, double b, double c, double d) {
      const double r = 1. - s;
      return r * r * r * a + 3. * r * r * s * b + 3. * r * s * s * c + s * s * s * d;
    };
    RELIEVO_CHECK_NEAR(FirstAt(reader, s).y, bernstein(0., 2. / 3., 1., 1.), 1e-6, "first spline");
    RELIEVO_CHECK_NEAR(FirstAt(reader, 1. + 2. * s).y, bernstein(1., 1., 3. + 2. / 3., 3.), 1e-6,
      "second spline, of two seconds");
  }
  RELIEVO_CHECK_NEAR(FirstAt(reader, -1.).y, 0., 1e-6, "before the first key");
  RELIEVO_CHECK_NEAR(FirstAt(reader, 9.).y, 3., 1e-6, "after the last key");
  RELIEVO_CHECK(reader->GetNumberOfNotes() == 0);
}

void TestAgainstVTK()
{
  const std::string skin = DataFile("models/glTF2/simple_skin/simple_skin.gltf");
  RELIEVO_CHECK_AT_MOST(
    CompareWithVTK(skin, true), 1e-5, "simple_skin.gltf against VTK's, at keys");
  // VTK's slerp takes the arc cosine of floats: between near keys it is this far from testModels'
  // truth in double, where ours is not.
  RELIEVO_CHECK_AT_MOST(
    CompareWithVTK(skin, false), 2e-4, "simple_skin.gltf against VTK's, between keys");
  const float r = std::sqrt(0.5f);
  const GltfTrack turns = { "rotation", "LINEAR", { 0.f, 2.f, 3.f },
    { 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, r, r, 0.f, r, 0.f, -r } };
  const GltfTrack bends = { "rotation", "CUBICSPLINE", { 0.f, 3.f },
    { 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.3f, 0.f, 0.5f, 0.f, //
      0.f, 0.4f, 0.f, 0.1f, 0.f, 0.f, r, r, 0.f, 0.f, 0.f, 0.f } };
  const GltfTrack scales = { "scale", "STEP", { 0.f, 1.5f, 3.f },
    { 1.f, 1.f, 1.f, 2.f, 1.f, 0.5f, 1.f, 1.f, 1.f } };
  const std::string path = OutputFolder() + "/tracks.gltf";
  WriteGltf(path, { Splines, turns });
  RELIEVO_CHECK_AT_MOST(
    CompareWithVTK(path, false), 1e-5, "splines and turns against VTK's reader");
  WriteGltf(path, { Steps, bends, scales });
  RELIEVO_CHECK_AT_MOST(CompareWithVTK(path, false), 1e-5, "steps and bends against VTK's reader");
}

// The file says spline and its buffer holds less: linear, with a note; nothing is read beyond.
void TestUnfit()
{
  const std::string path = OutputFolder() + "/unfit.gltf";
  WriteGltf(path, { Splines });
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  const std::string whole = text.str();
  // The slopes' accessor, the last one: as many floats, but of a view that does not exist.
  std::string bad = whole;
  const std::string view = R"("bufferView":2,"componentType":5126,"count":9)";
  const std::size_t at = bad.find(view);
  if (RELIEVO_CHECK(at != std::string::npos))
  {
    for (const char* other : { R"("bufferView":99,"componentType":5126,"count":9)",
           R"("bufferView":2,"componentType":5126,"count":999999)",
           R"("bufferView":2,"byteOffset":-4000,"componentType":5126,"count":9)" })
    {
      bad = whole;
      bad.replace(at, view.size(), other);
      std::ofstream(path) << bad;
      vtkNew<vtkRelievoModelReader> reader;
      reader->SetFileName(path.c_str());
      const int errors = CountErrors(reader);
      const bool refused = reader->GetErrorCode() != 0;
      RELIEVO_CHECK(errors == (refused ? 1 : 0));
      RELIEVO_CHECK(reader->GetOutput()->GetNumberOfBlocks() == (refused ? 0u : 1u));
      RELIEVO_CHECK(refused || reader->GetNumberOfNotes() == 1);
    }
  }
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testModelModes)
{
  relievoTest::Session session;
  TestSteps("steps.gltf", true);
  TestSteps("steps.glb", true);
  TestSteps("nameless.gltf", false);
  TestStepsOfPictures();
  TestSplines("splines.gltf");
  TestSplines("splines.glb");
  TestAgainstVTK();
  TestUnfit();
  return session.Result();
}
}
