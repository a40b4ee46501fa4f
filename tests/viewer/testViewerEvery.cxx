// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every option, every parameter of every stage and every layer: the window's picture equals that of
// the command line, byte for byte, and where Python is wrapped that of the copied program too.
#include "TestCase.h"
#include "ViewerTest.h"

#include "Arguments.h"
#include "Options.h"
#include "ParameterEdit.h"
#include "SurfaceOptions.h"

#include "vtkNew.h"
#include "vtkRelievoLayerCatalogue.h"
#include "vtkRelievoParameter.h"
#include "vtkRelievoPass.h"
#include "vtkRelievoStage.h"
#include "vtkRelievoStageDescription.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace testViewerEvery
{
using scene::Settings;

namespace
{
// Values of options not covered by other tests: switches are in testViewerPictures, models in
// testViewerPythonFiles. Words needed by others come first.
const std::vector<QStringList> Given = {
  { "--allow-folder", "/" },
  { "--clip", "0.5,40" },
  { "--view-angle", "47" },
  { "--shading", "gouraud" },
  { "--shading", "phong" },
  { "--preset", "print" },
  { "--preset", "town", "--fill", "0.3", "--light", "sun:2026-06-21T09:30+02:00,48.1,11.6,size=2" },
  { "--light", "sun:1,1,1,color=#ffcc88,intensity=0.6,casts=off,name=a\\,b", "--light",
    "sun:2026-06-21T23:30Z,48,0", "--shadows", "map" },
  { "--preset", "studio", "--ground", "off", "--up", "z" },
  { "--color-by", "part", "--range", "100,300", "--colormap", "cool-warm" },
  { "--color-by", "height", "--colormap", "grey" },
  { "--color-by", "height", "--colormap", "hot:reversed" },
  { "--color-by", "height", "--colormap", "black,#ff8000,0.2/0.9/1" },
  { "--color-by", "height", "--colormap", "black,0.3=#ff8000,white:steps=6:nan=red", "--range",
    "symmetric" },
  { "--color-by", "height", "--colormap", "hot:reversed:log", "--range", "0.1,2", "--scalar-bar" },
  { "--color-by", "Normals,1", "--scalar-bar" },
  { "--color-by", "height", "--bar", "bottom,title=h,unit=m" },
  { "--background", "#102030,gray" },
  { "--preset", "studio", "--grid" },
  { "--preset", "print", "--scale-bar", "µm" },
  { "--scale-bar", "none", "--background", "white" },
  { "--grid", "--environment", "IMAGE", "--background", "white" },
  { "--shadows", "forward" },
  { "--shadows", "warped" },
  { "--shadows", "exact", "--colored-shadows" },
  { "--height-map", "IMAGE,0.1", "--relief", "parallax" },
  { "--height-map", "IMAGE,0.1", "--relief", "steep" },
  { "--height-map", "IMAGE,0.1", "--relief", "occlusion", "--texture-coordinates", "plane" },
  { "--height-map", "IMAGE,0.1", "--relief", "off", "--up", "x" },
  { "--height-map", "IMAGE,0.1", "--material", "texture_scale=2/3,self_shadow=on" },
  { "--environment", "IMAGE,30,intensity=2", "--material", "irradiance_weight=0.5" },
  { "--lamps", "POINTS,falloff=vtk,attenuation=1/0.5/0.1,casts=always" },
  { "--markers", "POINTS,shape=glow,radius=0.5,opacity=0.5,color=1/0/0" },
  { "--light", "point:1,2,2,size=0.3", "--light", "spot:0,3,2,0,0,0,30", "--shadows", "map" },
};

const std::set<std::string> Elsewhere = { "--size", "--camera", "--parallel-scale", "--color",
  "--opacity", "--edges", "--time", "--times", "--animation", "--blend", "--loop", "--skeleton",
  "--bone-weight", "--skin", "--normal-map", "--environment", "--reflectivity", "--skybox", "--fog",
  "--figure", "--image", "--opacity-curve", "--volume-step", "--volume-shadows", "--point-size" };

// Rows for an option that no test above has: from its description, if this gives values.
std::vector<QStringList> MakeRows(const vtkRelievoOption& option)
{
  const QString name = QString::fromStdString(option.Name);
  if (option.IsFlag())
  {
    return { { name } };
  }
  std::vector<QStringList> rows;
  for (const std::string& word : option.Words)
  {
    rows.push_back({ name, QString::fromStdString(word) });
  }
  const vtkRelievoOption::Bounds& range = option.Range;
  if (range.Least != range.Most)
  {
    rows.push_back({ name, QString::number(range.Least + (range.Most - range.Least) / 4.0) });
  }
  return rows;
}

// The result follows from measured times.
const std::string Measured = "time_budget";

// For the view: a picture of each value takes long if it is large.
const char* const Small = "150x110";

// For a shadow map's side: larger ones take longer than everything else.
const char* const Texels = "256";

// Other values than the default.
std::vector<std::string> GetValues(const vtkRelievoParameter& parameter)
{
  std::vector<std::string> values;
  switch (parameter.Type)
  {
    case vtkRelievoParameter::FLAG:
      return { parameter.Default == "on" ? "off" : "on" };
    case vtkRelievoParameter::CHOICE:
      std::copy_if(parameter.Choices.begin(), parameter.Choices.end(), std::back_inserter(values),
        [&parameter](const std::string& choice) { return choice != parameter.Default; });
      return values;
    case vtkRelievoParameter::TEXT:
      return {};
    case vtkRelievoParameter::PAIR:
      return { "0.25/0.75" };
    case vtkRelievoParameter::COLOR:
      return { "0.2/0.4/0.6" };
    case vtkRelievoParameter::VECTOR:
      return {};
    default:
    {
      const double before = std::stod(parameter.Default);
      const bool whole = parameter.Type == vtkRelievoParameter::WHOLE;
      double value = whole ? std::floor(before / 2.0) : before / 2.0;
      if (value == before || value < parameter.Least)
      {
        value = before + (whole ? 1.0 : std::min(1.0, 0.1 * (parameter.Most - before)));
      }
      return { words::WriteNumber(value) };
    }
  }
}
}

class TestViewerEvery : public viewerTest::ViewerTest
{
  Q_OBJECT

private:
  std::vector<QStringList> Rows = Given;

  void CompareAll(const std::string& what)
  {
    QCOMPARE(this->Window->GetTrouble(), QString());
    this->Compare(what.c_str());
#ifdef RELIEVO_TEST_PYTHON
    // testViewerPython draws pictures of its programs.
    // Without stages that are there anyway.
    const scene::Settings shown =
      scene::Settings::FromWords(this->Window->GetCopiedSettings().GetWords());
    QVERIFY2(this->RunPythonForWords() == shown, what.c_str());
#endif
  }

  void CompareStage(const vtkRelievoStageDescription& stage, const scene::Settings& before)
  {
    const auto set = [&](const std::vector<std::pair<std::string, std::string>>& values) {
      scene::Settings settings = before;
      settings.AskStage(stage.Name, true);
      for (const auto& [name, value] : values)
      {
        settings.SetParameter(stage.Name, name, value);
      }
      this->Window->GetDocument()->Set(settings);
      this->WaitUntilRead();
    };
    set({});
    this->CompareAll(stage.Name);
    std::vector<std::pair<std::string, std::string>> others;
    for (const vtkRelievoParameter& parameter : stage.Parameters)
    {
      const std::vector<std::string> values = GetValues(parameter);
      if (parameter.Name == Measured || values.empty())
      {
        continue;
      }
      others.emplace_back(parameter.Name, values.front());
      for (const std::string& value : values)
      {
        set({ { parameter.Name, value } });
        this->Compare((stage.Name + ":" + parameter.Name + "=" + value).c_str());
      }
    }
    set(others);
    this->CompareAll(stage.Name + " with other values");
  }

private Q_SLOTS:
  // Outputs are no part of a picture, and parameters of stages have tests below. Other options have
  // a row here, are in other tests, or describe their values.
  void initTestCase()
  {
    std::set<std::string> covered = Elsewhere;
    for (const QStringList& row : this->Rows)
    {
      for (const QString& word : row)
      {
        covered.insert(word.toStdString());
      }
    }
    for (const vtkRelievoOption& option : scene::GetRenderCommand().Options)
    {
      const bool isOfStage = !option.Sets.empty() && !option.IsSwitch;
      if (covered.count(option.Name) == 0 && !option.OfOutputs && !isOfStage)
      {
        const std::vector<QStringList> rows = MakeRows(option);
        QVERIFY2(!rows.empty(), option.Name.c_str());
        this->Rows.insert(this->Rows.end(), rows.begin(), rows.end());
      }
    }
  }

  // One row after the other in one window.
  void options()
  {
    const std::vector<std::string> files = { this->WriteScene(), this->WriteOBJ(), "--size",
      Small };
    const QString points = QString::fromStdString(this->WritePoints());
    const QString image = QString::fromStdString(this->WriteImage());
    this->Open(files);
    for (const QStringList& row : this->Rows)
    {
      std::vector<std::string> own = files;
      if (row.contains("--shadows"))
      {
        own.insert(own.end(), { "--shadow-size", Texels });
      }
      if (!row.contains("--light") && !row.contains("--preset"))
      {
        own.insert(own.end(), { "--light", "sun:0.4,1,0.6" });
      }
      for (QString word : row)
      {
        own.push_back(word.replace("POINTS", points).replace("IMAGE", image).toStdString());
      }
      this->Window->GetDocument()->Set(scene::Settings::FromWords(own));
      this->WaitUntilRead();
      this->CompareAll(row.join(' ').toStdString());
    }
  }

  // Each value alone, and then the first other value of every parameter of the stage at once.
  void stages()
  {
    const std::string points = this->WritePoints();
    this->Open({ this->WriteScene(), this->WriteOBJ(), "--light", "sun:0.4,1,0.6", "--shadows",
      "map", "--shadow-size", Texels, "--lamps", points, "--fog", points + ",density=0.4",
      "--markers", points, "--stage", "display:layer=", "--size", Small });
    const scene::Settings before = this->Window->GetDocument()->Get();
    const vtkNew<vtkRelievoPass> frame;
    for (int i = 0; i < frame->GetNumberOfStages(); ++i)
    {
      this->CompareStage(frame->GetStage(i)->GetDescription(), before);
    }
  }

  // A row of the panel for each value of materials and environments; typed, it is as said in words.
  void surfaceValues()
  {
    const std::string image = this->WriteImage();
    const std::vector<std::string> words = { this->WriteScene(), this->WriteOBJ(), "--light",
      "sun:0.4,1,0.6", "--shadows", "map", "--shadow-size", Texels, "--normal-map", image,
      "--height-map", image + ",0.1", "--environment", image, "--reflectivity", "0.3,0", "--size",
      Small };
    this->Open(words);
    const scene::Settings before = this->Window->GetDocument()->Get();
    for (const vtkRelievoParameterList* list :
      { &look::GetMaterialValues(), &look::GetEnvironmentValues() })
    {
      for (vtkRelievoParameter parameter : list->Parameters)
      {
        const std::string name = parameter.Name;
        parameter.Default = look::GetSurfaceValue(before.Parse().Surface, name);
        auto* edit = this->Window->findChild<viewer::ParameterEdit*>(QString::fromStdString(name));
        QVERIFY2(edit && edit->isEnabled(), name.c_str());
        for (const std::string& value : GetValues(parameter))
        {
          const std::string what = name + "=" + value;
          Q_EMIT edit->edited(QString::fromStdString(value));
          const scene::Settings after = this->Window->GetDocument()->Get();
          QVERIFY2(after != before, what.c_str());
          QVERIFY2(look::GetSurfaceValue(after.Parse().Surface, name) == value, what.c_str());
          this->WaitUntilRead();
          this->Compare(what.c_str());
        }
      }
    }
  }

  // Settings without effect are removed, and their row is disabled with the reason.
  void idleSurfaceValues()
  {
    this->Open({ this->WriteScene(), "--height-map", this->WriteImage(), "--size", Small });
    auto* edit = this->Window->findChild<viewer::ParameterEdit*>("bisections");
    Q_EMIT edit->edited("3");
    QCOMPARE(this->Window->GetDocument()->Get().Get("--material"), std::string("bisections=3"));
    this->Change([](scene::Settings& settings) { settings.Set("--relief", "steep"); });
    QVERIFY(!this->Window->GetDocument()->Get().Has("--material"));
    QVERIFY(!edit->isEnabled());
    QVERIFY2(edit->toolTip().contains("Relief method is relief"), qPrintable(edit->toolTip()));
    this->Change([](scene::Settings& settings) { settings.Remove("--relief"); });
    QVERIFY(edit->isEnabled() && !edit->toolTip().contains("Has an effect"));
  }

  void layers()
  {
    const std::string points = this->WritePoints();
    this->Open({ this->WriteScene(), this->WriteOBJ(), "--light", "sun:0.4,1,0.6", "--lamps",
      points, "--fog", points, "--markers", points, "--size", Small });
    for (int i = 0; i < vtkRelievoLayerCatalogue::GetNumberOfLayers(); ++i)
    {
      const std::string given = vtkRelievoLayerCatalogue::GetLayerName(i);
      const std::string name = vtkRelievoLayerCatalogue::GetIsLayer(given) ? given : "shadow_0";
      this->Change(
        [&name](scene::Settings& settings) { settings.SetParameter("display", "layer", name); });
      this->Compare(name.c_str());
    }
  }
};

RELIEVO_TEST_CASE_APART(testViewerEvery)
{
  TestViewerEvery tests;
  return viewerTest::Run(tests, argc, argv);
}
}

#include "testViewerEvery.moc"
