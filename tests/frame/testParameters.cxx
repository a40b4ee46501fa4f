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
#include <utility>
#include <vector>

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

// Dates, boxes, sizes, choices whose first is not 0, and whole numbers of 64 bits.
void TestOtherTypes()
{
  int day[3] = { 2026, 1, 5 };
  double box[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  int size[2] = { 1, 2 };
  int choice = 2;
  long long label = 7;
  vtkRelievoParameterList list;
  list.AddDate(
    "day", day, [&day](const int* given) { std::copy_n(given, 3, day); }, 1900, 2100, "Day.");
  list.AddBox(
    "box", box, [&box](const double* given) { std::copy_n(given, 6, box); }, "Box.");
  list.AddSize(
    "size", size, [&size](const int* given) { std::copy_n(given, 2, size); }, 0, "S.");
  list.AddChoice(
    "choice", choice, [&choice](int given) { choice = given; }, { "two", "three" }, "Choice.", 2);
  list.AddWhole(
    "label", label, [&label](long long given) { label = given; }, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX,
    "", "Label.");
  RELIEVO_CHECK(list.GetDefault("day") == "2026-01-05" && list.GetDefault("choice") == "two");
  const auto takes = [&list](const std::string& name, const std::string& words) {
    return list.TrySet(name, words).empty() && list.GetValue(name) == words;
  };
  RELIEVO_CHECK(takes("day", "2026-06-21") && day[0] == 2026 && day[1] == 6 && day[2] == 21);
  RELIEVO_CHECK(takes("box", "-1,1,0,2,0.5,3") && box[0] == -1.0 && box[5] == 3.0);
  RELIEVO_CHECK(takes("size", "4x0") && size[0] == 4 && size[1] == 0);
  RELIEVO_CHECK(takes("choice", "three") && choice == 3 && takes("choice", "two") && choice == 2);
  RELIEVO_CHECK(takes("label", "-9007199254740992") && label == -9007199254740992LL);
  const std::vector<std::pair<const char*, std::vector<const char*>>> invalid = {
    { "day",
      { "2026-13-01", "2026-00-01", "2026-02-32", "1899-01-01", "2026-06", "2026-06-21-1" } },
    { "box", { "0,1,0,1,0", "0,1,0,1,0,nan", "0,1,0,1,0,1,0" } },
    { "size", { "4x", "4", "4x4x4", "-1x4", "4.5x4" } }, { "choice", { "one", "2", "" } },
    { "label", { "1e30", "-1e30", "9007199254740994", "0.5" } }
  };
  for (const auto& each : invalid)
  {
    const std::string before = list.GetValue(each.first);
    for (const char* words : each.second)
    {
      RELIEVO_CHECK_THAT(!list.TrySet(each.first, words).empty(), words);
      RELIEVO_CHECK_THAT(list.GetValue(each.first) == before, words);
    }
  }
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
  TestOtherTypes();
  TestLabels();
  TestLabelsOfStages();
  return session.Result();
}
}
