// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The description of every registered stage: complete, and consistent with the accepted values;
// bounds in descriptions of stages, points, materials, filters and data sets.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkRelievoCaves.h>
#include <vtkRelievoDatasetWriter.h>
#include <vtkRelievoEnvironment.h>
#include <vtkRelievoEnvironmentConvert.h>
#include <vtkRelievoEnvironmentIrradiance.h>
#include <vtkRelievoEnvironmentPrefilter.h>
#include <vtkRelievoHeightsToNormals.h>
#include <vtkRelievoMaterial.h>
#include <vtkRelievoParameter.h>
#include <vtkRelievoPass.h>
#include <vtkRelievoPointStage.h>
#include <vtkRelievoShadowStage.h>
#include <vtkRelievoSmoothBlocks.h>
#include <vtkRelievoStage.h>
#include <vtkRelievoSunExposure.h>
#include <vtkRelievoSurfaceParticles.h>
#include <vtkRelievoTextureCoordinates.h>
#include <vtkRelievoVoxelCubes.h>
#include <vtkRelievoVoxelShell.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace testParameters
{
namespace
{
void TestDescription(vtkRelievoStage* stage)
{
  const vtkRelievoStageDescription& description = stage->GetDescription();
  const std::string name = description.Name;
  RELIEVO_CHECK_THAT(!name.empty() && !description.Label.empty(), "a stage without a name");
  RELIEVO_CHECK_THAT(!description.Help.empty() && description.Help.back() == '.', name + ": help");
  std::set<std::string> names;
  for (const vtkRelievoParameter& parameter : description.Parameters)
  {
    const std::string which = name + ":" + parameter.Name;
    RELIEVO_CHECK_THAT(names.insert(parameter.Name).second, which + " is there twice");
    RELIEVO_CHECK_THAT(!parameter.Help.empty() && parameter.Help.back() == '.', which + ": help");
    // Described values are accepted.
    const std::string before = stage->GetParameter(parameter.Name);
    RELIEVO_CHECK_THAT(
      stage->TrySetParameter(parameter.Name, before).empty(), which + " = " + before);
    RELIEVO_CHECK_THAT(stage->GetParameter(parameter.Name) == before, which + " comes back");
    if (parameter.Type == vtkRelievoParameter::TEXT)
    {
      continue;
    }
    RELIEVO_CHECK_THAT(!stage->TrySetParameter(parameter.Name, "rubbish").empty(), which);
    for (const double value : { parameter.Least, parameter.Most })
    {
      if (std::isfinite(value))
      {
        const std::vector<double> values(parameter.GetNumberOfComponents(), value);
        RELIEVO_CHECK_THAT(parameter.Set(values).empty(), which + " takes its end");
        RELIEVO_CHECK_THAT(parameter.GetValues() == values, which + " keeps its end");
        std::vector<double> beyond = values;
        beyond[0] += value == parameter.Least ? -1.0 : 1.0;
        RELIEVO_CHECK_THAT(!parameter.Set(beyond).empty(), which + " refuses what is beyond");
        RELIEVO_CHECK_THAT(parameter.GetValues() == values, which + " keeps its value");
      }
    }
    stage->TrySetParameter(parameter.Name, before);
  }
}

void TestDescriptions()
{
  vtkNew<vtkRelievoPass> frame;
  RELIEVO_CHECK(frame->GetNumberOfStages() >= 3);
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    TestDescription(frame->GetStage(i));
  }
}

// A setter takes the bounds of its description; a number beyond them becomes the bound, is refused,
// or is kept by a setter without bounds.
void TestBounds(const std::string& name, const vtkRelievoParameterList& list)
{
  vtkObject::GlobalWarningDisplayOff(); // of refusals
  for (const vtkRelievoParameter& parameter : list.Parameters)
  {
    const bool whole =
      parameter.Type == vtkRelievoParameter::WHOLE || parameter.Type == vtkRelievoParameter::CHOICE;
    if (!whole && parameter.Type != vtkRelievoParameter::NUMBER)
    {
      continue;
    }
    const double before = parameter.GetValues()[0];
    for (const bool upper : { false, true })
    {
      const double end = upper ? parameter.Most : parameter.Least;
      const double most = whole ? VTK_INT_MAX : VTK_DOUBLE_MAX;
      const double beyond = upper ? most : whole ? VTK_INT_MIN : -most;
      const auto set = [&](double value) {
        parameter.SetValues({ before });
        parameter.SetValues({ value });
        return parameter.GetValues()[0];
      };
      const double got = set(beyond);
      const bool isEnd = std::abs(got - end) <= (parameter.Open ? 1e-9 : 0.0);
      RELIEVO_CHECK_THAT(isEnd || got == beyond || got == before,
        name + ":" + parameter.Name + " is described to " + std::to_string(end) + ", clamped to " +
          std::to_string(got));
      RELIEVO_CHECK_THAT(!std::isfinite(end) || parameter.Open || set(end) == end,
        name + ":" + parameter.Name + " takes " + std::to_string(end));
    }
    parameter.SetValues({ before });
  }
  vtkObject::GlobalWarningDisplayOn();
}

template <typename... Described>
void TestBoundsOf()
{
  (TestBounds(vtkNew<Described>()->GetClassName(), vtkNew<Described>()->GetParameters()), ...);
}

void TestAllBounds()
{
  vtkNew<vtkRelievoPass> frame;
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    vtkRelievoStage* stage = frame->GetStage(i);
    TestBounds(stage->GetClassName(), stage->GetDescription());
    if (auto* drawn = vtkRelievoPointStage::SafeDownCast(stage))
    {
      const auto points = vtkSmartPointer<vtkRelievoPointValues>::Take(drawn->NewPoints());
      TestBounds(points->GetClassName(), points->GetDescription());
    }
  }
  TestBounds("material", vtkNew<vtkRelievoMaterial>()->GetDescription());
  TestBounds("environment", vtkNew<vtkRelievoEnvironment>()->GetDescription());
  TestBoundsOf<vtkRelievoCaves, vtkRelievoDatasetWriter, vtkRelievoEnvironmentConvert,
    vtkRelievoEnvironmentIrradiance, vtkRelievoEnvironmentPrefilter, vtkRelievoHeightsToNormals,
    vtkRelievoSmoothBlocks, vtkRelievoSunExposure, vtkRelievoSurfaceParticles,
    vtkRelievoTextureCoordinates, vtkRelievoVoxelCubes, vtkRelievoVoxelShell>();
}

// The default is a new stage's value, whatever this one is set to when it is first asked.
void TestDefaults()
{
  vtkNew<vtkRelievoShadowStage> stage;
  stage->SetMapSize(512);
  stage->SetBias(3.25);
  vtkNew<vtkRelievoShadowStage> fresh;
  RELIEVO_CHECK(stage->GetParameterDefault("map_size") == std::to_string(fresh->GetMapSize()));
  RELIEVO_CHECK(stage->GetParameter("map_size") == "512");
  for (int i = 0; i < stage->GetNumberOfParameters(); ++i)
  {
    const std::string name = stage->GetParameterName(i);
    const std::string value = stage->GetParameterDefault(name);
    RELIEVO_CHECK_THAT(!value.empty() && value == fresh->GetParameter(name), name);
    RELIEVO_CHECK_THAT(stage->SetParameter(name, value), name + " takes its default");
  }
  RELIEVO_CHECK(stage->GetMapSize() == fresh->GetMapSize() && stage->GetBias() == fresh->GetBias());
  RELIEVO_CHECK(stage->GetParameterDefault("no such").empty());
}

void TestWords()
{
  vtkNew<vtkRelievoPass> frame;
  vtkRelievoStage* stage = frame->GetStage("shadows");
  RELIEVO_CHECK(stage == frame->GetShadowStage());
  RELIEVO_CHECK(stage->SetParameter("method", "warped"));
  RELIEVO_CHECK(frame->GetShadowStage()->GetMethod() == vtkRelievoShadowStage::METHOD_WARPED);
  RELIEVO_CHECK(stage->SetParameter("bias", "2.25") && frame->GetShadowStage()->GetBias() == 2.25);
  RELIEVO_CHECK(!stage->GetEnabled() && !frame->GetShadows());
  frame->GetShadowStage()->SetMapSize(512);
  RELIEVO_CHECK(stage->GetParameter("map_size") == "512");
  const std::string unknown = stage->TrySetParameter("size", "3");
  RELIEVO_CHECK(
    unknown.find("'size'") != std::string::npos && unknown.find("map_size") != std::string::npos);
  const std::string error = stage->TrySetParameter("bias", "1e3");
  RELIEVO_CHECK(
    error.find("'1e3'") != std::string::npos && error.find("0 to 100") != std::string::npos);
  RELIEVO_CHECK(
    stage->GetParameterHelp("map_size").find("16 to 16384 (texels)") != std::string::npos);
}

// Pairs of numbers, and values that depend on others.
void TestPairsAndConditions()
{
  double scale[2] = { 1.0, 2.0 };
  vtkRelievoParameterList list;
  vtkRelievoParameter& pair = list.AddPair(
    "scale", scale, [&scale](const double* given) { std::copy_n(given, 2, scale); }, "Tiles.");
  pair.OnlyIf = "map,method!=off,way=far";
  RELIEVO_CHECK(list.GetDefault("scale") == "1,2" && list.TrySet("scale", "3/-4.5").empty());
  RELIEVO_CHECK(scale[0] == 3.0 && scale[1] == -4.5 && list.GetValue("scale") == "3,-4.5");
  for (const char* error : { "1", "1,2,3", "1,nan", "one,two" })
  {
    RELIEVO_CHECK_THAT(
      list.TrySet("scale", error).find("expected two numbers") != std::string::npos, error);
  }
  RELIEVO_CHECK(scale[0] == 3.0 && scale[1] == -4.5);
  RELIEVO_CHECK(list.TrySet("size", "1").find("one of scale") != std::string::npos);
  const std::vector<vtkRelievoParameter::Condition> found = list.Find("scale")->GetConditions();
  RELIEVO_CHECK(found.size() == 3);
  RELIEVO_CHECK(found[0].Name == "map" && found[0].Value.empty() && !found[0].Other);
  RELIEVO_CHECK(found[1].Name == "method" && found[1].Value == "off" && found[1].Other);
  RELIEVO_CHECK(found[2].Name == "way" && found[2].Value == "far" && !found[2].Other);
  RELIEVO_CHECK(vtkRelievoParameter().GetConditions().empty());
}

// By the name, unless the description has another word for people.
void TestLabels()
{
  int choice = 0;
  vtkRelievoParameterList list;
  vtkRelievoParameter& kind = list.AddChoice(
    "kind_of_mist", choice, [&choice](int which) { choice = which; }, { "thin", "blue_as-ice" },
    "Which.");
  RELIEVO_CHECK(kind.GetLabel() == "Kind Of Mist" && kind.GetChoiceLabel(1) == "blue as ice");
  kind.Label = "Mist";
  kind.ChoiceLabels = { "hardly any", "blue" };
  RELIEVO_CHECK(kind.GetLabel() == "Mist" && kind.GetChoiceLabel(0) == "hardly any");
  RELIEVO_CHECK(list.TrySet("kind_of_mist", "blue_as-ice").empty() && choice == 1);
  RELIEVO_CHECK(!list.TrySet("kind_of_mist", "blue").empty()); // no word of the command
}

// Each has a label of its own within its stage, and each of its choices within it.
void TestLabelsOfStages()
{
  vtkNew<vtkRelievoPass> frame;
  for (int i = 0; i < frame->GetNumberOfStages(); ++i)
  {
    std::set<std::string> labels;
    for (const vtkRelievoParameter& parameter : frame->GetStage(i)->GetDescription().Parameters)
    {
      RELIEVO_CHECK_THAT(labels.insert(parameter.GetLabel()).second, parameter.Name);
      std::set<std::string> choices;
      for (std::size_t c = 0; c < parameter.Choices.size(); ++c)
      {
        RELIEVO_CHECK_THAT(choices.insert(parameter.GetChoiceLabel(c)).second, parameter.Name);
      }
      RELIEVO_CHECK_THAT(
        parameter.ChoiceLabels.empty() || parameter.ChoiceLabels.size() == parameter.Choices.size(),
        parameter.Name);
    }
  }
}
}

RELIEVO_TEST_CASE(testParameters)
{
  relievoTest::Session session;
  TestDescriptions();
  TestAllBounds();
  TestDefaults();
  TestWords();
  TestPairsAndConditions();
  TestLabels();
  TestLabelsOfStages();
  return session.Result();
}
}
