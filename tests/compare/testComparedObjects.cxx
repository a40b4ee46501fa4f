// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Changes in a scene of boxes, each attributed to its cause and object, with and without a record.
#include "BoxFrames.h"

#include "Check.h"
#include "Session.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "vtkRelievoFrameComparison.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace testComparedObjects
{
namespace
{
using compareTest::Box;
using compareTest::Boxes;
using nlohmann::json;

json Compare(vtkImageData* a, vtkImageData* b)
{
  vtkNew<vtkRelievoFrameComparison> comparison;
  comparison->SetBaseline(a);
  comparison->SetFrame(b);
  RELIEVO_CHECK(comparison->Compare());
  const json found = json::parse(comparison->GetJSON());
  // Each different pixel is counted once, also in the image of causes.
  std::size_t sum = found["unexplained"].get<std::size_t>();
  for (const json& cause : found["causes"])
  {
    sum += cause["pixels"].get<std::size_t>();
  }
  RELIEVO_CHECK(sum == found["pixels"].get<std::size_t>());
  RELIEVO_CHECK(found["alike"].get<bool>() == comparison->GetAlike());
  if (vtkImageData* causes = comparison->GetCauses())
  {
    std::vector<std::size_t> counts(found["causes"].size(), 0);
    for (vtkIdType i = 0; i < causes->GetNumberOfPoints(); ++i)
    {
      const auto cause = static_cast<int>(causes->GetPointData()->GetScalars()->GetTuple1(i));
      RELIEVO_CHECK(cause < static_cast<int>(counts.size()));
      if (cause >= 0)
      {
        ++counts[static_cast<std::size_t>(cause)];
      }
    }
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
      RELIEVO_CHECK(counts[i] == found["causes"][i]["pixels"].get<std::size_t>());
    }
  }
  return found;
}

json Compare(const Boxes& a, const Boxes& b)
{
  return Compare(compareTest::Draw(a), compareTest::Draw(b));
}

// The entry with this cause and name; null if there is none.
json Find(const json& found, const std::string& cause, const std::string& name)
{
  for (const json& each : found["causes"])
  {
    if (each["cause"] == cause && each.value("name", "") == name)
    {
      return each;
    }
  }
  return json();
}

// Lists causes and names, sorted, as in "moved wheel, shadow key".
std::string List(const json& found)
{
  std::vector<std::string> all;
  for (const json& each : found["causes"])
  {
    all.push_back(each["cause"].get<std::string>() + " " + each.value("name", ""));
  }
  std::sort(all.begin(), all.end());
  std::string text;
  for (const std::string& each : all)
  {
    text += (text.empty() ? "" : ", ") + each;
  }
  return text;
}

void CheckList(const json& found, const std::string& expected, const std::string& what)
{
  RELIEVO_CHECK_THAT(List(found) == expected, what + ": " + found.dump());
  RELIEVO_CHECK_THAT(found["unexplained"] == 0, what + ": unexplained " + found.dump());
}

//------------------------------------------------------------------------------
void TestAlike()
{
  for (const bool record : { false, true })
  {
    Boxes boxes = compareTest::MakeBoxes();
    boxes.HasRecord = record;
    const json found = Compare(boxes, boxes);
    RELIEVO_CHECK(found["alike"] == true && found["pixels"] == 0);
    CheckList(found, "", "equal frames");
    // Reversed order, so that the numbers change.
    Boxes other = boxes;
    std::reverse(other.All.begin(), other.All.end());
    CheckList(Compare(boxes, other), "", "reversed order");
  }
  // All objects renamed, with the same meshes in the same places.
  const Boxes boxes = compareTest::MakeBoxes();
  Boxes renamed = boxes;
  for (Box& box : renamed.All)
  {
    box.Name += " of steel";
  }
  std::rotate(renamed.All.begin(), renamed.All.begin() + 1, renamed.All.end());
  CheckList(Compare(boxes, renamed), "", "renamed");
  // The only object replaced by another one: two of two differ.
  Boxes first = boxes, second = boxes;
  first.All.resize(1);
  second.All = { boxes.All[2] };
  vtkNew<vtkRelievoFrameComparison> comparison;
  comparison->SetBaseline(compareTest::Draw(first));
  comparison->SetFrame(compareTest::Draw(second));
  RELIEVO_CHECK(comparison->Compare());
  RELIEVO_CHECK_THAT(
    comparison->GetText().find(" 2 of 2 objects") != std::string::npos, comparison->GetText());
}

//------------------------------------------------------------------------------
void TestMoved()
{
  for (const bool record : { true, false })
  {
    Boxes before = compareTest::MakeBoxes();
    before.HasRecord = record;
    Boxes after = before;
    const compareTest::Vector by = { 0.02, 0.01, -0.03 };
    after.All[1].MovedBy = by;
    std::reverse(after.All.begin(), after.All.end());
    const json found = Compare(before, after);
    const std::string name = record ? "wheel" : "";
    RELIEVO_CHECK_THAT(!Find(found, "moved", name).is_null(), found.dump());
    const json moved = Find(found, "moved", name);
    RELIEVO_CHECK(moved["id"] == 1 && moved["kind"] == "actor");
    for (std::size_t i = 0; i < 3; ++i)
    {
      // Exact by the record; from the layers, accurate to a float's rounding of depths near 9.
      RELIEVO_CHECK_NEAR(moved["displacement"][i].get<double>(), by[i], record ? 1e-14 : 2e-5,
        record ? "displacement by the record" : "displacement by the layers");
    }
    // The largest shift of a pixel.
    RELIEVO_CHECK(moved["largest"].get<double>() > 0.3 && moved["largest"].get<double>() < 2.);
    CheckList(found,
      record ? "moved wheel, shadow fill, shadow key" : "moved , shadow fill, shadow key", "moved");
    RELIEVO_CHECK(found["pixels"].get<std::size_t>() +
        found["within_limits"]["edge"].get<std::size_t>() +
        found["within_limits"]["rounding"].get<std::size_t>() ==
      compareTest::CountDifferent(compareTest::Draw(before), [&] {
        Boxes sorted = after;
        std::reverse(sorted.All.begin(), sorted.All.end());
        return compareTest::Draw(sorted);
      }()));
  }
  // Moved points with an unchanged matrix.
  Boxes baked = compareTest::MakeBoxes();
  baked.All[1].Mesh = "elsewhere";
  baked.All[1].Center[0] += 0.04;
  const json points = Compare(compareTest::MakeBoxes(), baked);
  RELIEVO_CHECK_NEAR(Find(points, "moved", "wheel")["displacement"][0].get<double>(), 0.04, 1e-14,
    "displacement by points");
  // Moved by a twentieth of a pixel, which is invisible in the picture.
  const Boxes before = compareTest::MakeBoxes();
  Boxes little = before;
  little.HasRecord = false;
  Boxes shifted = little;
  const double pixel = 9.3 * 2. * std::tan(vtkMath::RadiansFromDegrees(15.)) / before.Height;
  shifted.All[2].MovedBy = { 0.05 * pixel, 0., 0. };
  const json found = Compare(little, shifted);
  RELIEVO_CHECK_THAT(!Find(found, "moved", "").is_null(), found.dump());
  RELIEVO_CHECK_NEAR(
    Find(found, "moved", "")["displacement"][0].get<double>(), 0.05 * pixel, 2e-5, "twentieth");
}

//------------------------------------------------------------------------------
void TestAddedAndRemoved()
{
  for (const bool record : { true, false })
  {
    Boxes before = compareTest::MakeBoxes();
    before.HasRecord = record;
    Boxes without = before;
    without.All.erase(without.All.begin() + 1);
    const std::string name = record ? "wheel" : "";
    const json removed = Compare(before, without);
    CheckList(removed, "removed " + name + ", shadow fill, shadow key", "removed");
    const json added = Compare(without, before);
    CheckList(added, "added " + name + ", shadow fill, shadow key", "added");
    RELIEVO_CHECK(removed["pixels"] == added["pixels"]);
    // All visible pixels of the wheel count as removed.
    std::size_t seen = 0;
    const vtkSmartPointer<vtkImageData> frame = compareTest::Draw(before);
    for (vtkIdType i = 0; i < frame->GetNumberOfPoints(); ++i)
    {
      seen += frame->GetPointData()->GetArray("actor")->GetTuple1(i) == 1. ? 1 : 0;
    }
    RELIEVO_CHECK(Find(removed, "removed", name)["pixels"].get<std::size_t>() == seen);
  }
  // A hidden object is not reported as removed, nor an uncovered one as added.
  Boxes before = compareTest::MakeBoxes();
  before.All.push_back({ "screen", { -1.2, 0.9, 0. }, { 0.5, 0.6, 0.05 } });
  before.HasRecord = false;
  Boxes after = before;
  after.All[4].MovedBy = { 1.6, -0.3, 0. }; // in front of the cup
  const json found = Compare(before, after);
  RELIEVO_CHECK_THAT(
    Find(found, "added", "").is_null() && Find(found, "removed", "").is_null(), found.dump());
  RELIEVO_CHECK_THAT(Find(found, "visibility", "").is_null(), found.dump());
  // An object switched off.
  Boxes hidden = compareTest::MakeBoxes();
  hidden.All[2].Visible = false;
  CheckList(Compare(compareTest::MakeBoxes(), hidden), "shadow fill, shadow key, visibility helmet",
    "hidden");
}

//------------------------------------------------------------------------------
void TestShape()
{
  for (const bool record : { true, false })
  {
    Boxes before = compareTest::MakeBoxes();
    before.HasRecord = record;
    before.All[2].Center[1] = 0.6; // above the floor, because an object on it could have sunk
    Boxes after = before;
    after.All[2].HalfSize[1] = 0.3; // lowers only the top
    after.All[2].Center[1] = 0.55;
    const json found = Compare(before, after);
    const json shape = Find(found, "shape", record ? "helmet" : "");
    RELIEVO_CHECK_THAT(!shape.is_null(), found.dump());
    RELIEVO_CHECK_THAT(Find(found, "moved", record ? "helmet" : "").is_null(), found.dump());
    // The helmet's top is cell 3.
    const std::vector<int> cells = shape["cells"].get<std::vector<int>>();
    RELIEVO_CHECK_THAT(std::find(cells.begin(), cells.end(), 3) != cells.end(), shape.dump());
    RELIEVO_CHECK(found["unexplained"] == 0);
  }
}

//------------------------------------------------------------------------------
void TestSurfaces()
{
  for (const bool record : { true, false })
  {
    Boxes before = compareTest::MakeBoxes();
    before.HasRecord = record;
    const std::string cup = record ? "cup" : "";
    Boxes recolored = before;
    recolored.All[3].Color[2] = 0.9 + 9. / 255.;
    const json color = Compare(before, recolored);
    CheckList(color, "color " + cup, "recoloured");
    RELIEVO_CHECK(Find(color, "color", cup)["largest"] == 9.0);
    // A difference of two levels is within the limits, and counted there.
    recolored.All[3].Color[2] = 0.9 + 2. / 255.;
    const json within = Compare(before, recolored);
    RELIEVO_CHECK_THAT(within["alike"] == true, within.dump());
    RELIEVO_CHECK(within["within_limits"]["rounding"].get<int>() > 100);
    Boxes values = before;
    values.All[3].Value = 1.001;
    const json array = Compare(before, values);
    CheckList(array, "array " + cup, "array");
    RELIEVO_CHECK(Find(array, "array", cup)["array"] == "pressure");
    // A turned normal.
    const vtkSmartPointer<vtkImageData> a = compareTest::Draw(before);
    const vtkSmartPointer<vtkImageData> b = compareTest::Draw(before);
    vtkDataArray* normals = b->GetPointData()->GetArray("normal");
    const vtkIdType middle = 40 * 160 + 80;
    const double* old = a->GetPointData()->GetArray("normal")->GetTuple(middle);
    const double angle = vtkMath::RadiansFromDegrees(0.5);
    normals->SetTuple3(middle, old[0] * std::cos(angle) + old[1] * std::sin(angle),
      old[1] * std::cos(angle) + old[2] * std::sin(angle),
      old[2] * std::cos(angle) + old[0] * std::sin(angle));
    const json normal = Compare(a, b);
    RELIEVO_CHECK_THAT(normal["causes"].size() == 1 && normal["causes"][0]["cause"] == "normal" &&
        normal["causes"][0]["pixels"] == 1,
      normal.dump());
    RELIEVO_CHECK_NEAR(normal["causes"][0]["largest"].get<double>(), 0.5, 1e-4, "angle");
  }
  // Highlights do not belong to the surface's colour; the record has the material.
  Boxes shiny = compareTest::MakeBoxes();
  shiny.All[3].Specular = 0.1;
  CheckList(Compare(compareTest::MakeBoxes(), shiny), "settings cup", "specular");
}

//------------------------------------------------------------------------------
void TestLights()
{
  const Boxes before = compareTest::MakeBoxes();
  Boxes dimmed = before;
  dimmed.Lamps[1].Intensity = 0.25;
  CheckList(Compare(before, dimmed), "light fill", "dimmed");
  Boxes moved = before;
  moved.Lamps[0].Direction = { 2.2, 5., 1.5 };
  const json light = Compare(before, moved);
  CheckList(light, "light key", "light moved");
  RELIEVO_CHECK(Find(light, "light", "key")["changed"] == "position");
  // Another order of the lights.
  Boxes swapped = before;
  std::swap(swapped.Lamps[0], swapped.Lamps[1]);
  CheckList(Compare(before, swapped), "", "lights in another order");
  // A change of only one light's shadow.
  const vtkSmartPointer<vtkImageData> a = compareTest::Draw(before);
  const vtkSmartPointer<vtkImageData> b = compareTest::Draw(before);
  std::size_t lit = 0;
  for (int x = 60; x < 70; ++x)
  {
    lit += a->GetPointData()->GetArray("shadow_1")->GetTuple1(30 * 160 + x) == 1. &&
        a->GetPointData()->GetArray("actor")->GetTuple1(30 * 160 + x) >= 0.
      ? 1
      : 0;
  }
  compareTest::Fill(b, "shadow_1", 60, 70, 30, 31, 0.);
  const json shadow = Compare(a, b);
  CheckList(shadow, "shadow fill", "shadow of one light");
  RELIEVO_CHECK(lit > 0 && shadow["pixels"] == lit);
  // Records of lights are compared even if no pixel changes.
  Boxes dark = before;
  dark.Lamps.push_back({ "off", { 0., 1., 0. }, 0. });
  CheckList(Compare(before, dark), "light off", "a light more");
}

//------------------------------------------------------------------------------
void TestPictureAlone()
{
  // A text over the floor.
  Boxes before = compareTest::MakeBoxes();
  Boxes after = before;
  after.Overlays = { R"({"kind": "text", "text": "12 %"})" };
  const vtkSmartPointer<vtkImageData> a = compareTest::Draw(before);
  vtkSmartPointer<vtkImageData> b = compareTest::Draw(after);
  compareTest::Fill(b, "color", 5, 25, 5, 12, 1.);
  const json text = Compare(a, b);
  CheckList(text, "overlay ", "text");
  RELIEVO_CHECK(text["pixels"] == 140);
  // Equal pixel changes without a recorded reason are unexplained.
  b = compareTest::Draw(before);
  compareTest::Fill(b, "color", 5, 25, 5, 12, 1.);
  const json unexplained = Compare(a, b);
  RELIEVO_CHECK(unexplained["unexplained"] == 140 && unexplained["causes"].empty());
  RELIEVO_CHECK(unexplained["alike"] == false);
  // Settings.
  after = before;
  after.Settings = { "background=1 1 1", "tone:operator=reinhard" };
  CheckList(Compare(before, after), "settings background, tone tone:operator", "settings");
  // A translucent object that moves is located by its bounding box.
  before.All.push_back({ "glass", { 0., 1., 0. }, { 0.2, 0.2, 0.2 } });
  before.All.back().Translucent = true;
  after = before;
  after.All.back().MovedBy = { 0.1, 0., 0. };
  b = compareTest::Draw(after);
  compareTest::Fill(b, "color", 76, 84, 71, 79, 0.7);
  const json glass = Compare(compareTest::Draw(before), b);
  RELIEVO_CHECK_THAT(Find(glass, "translucent", "glass")["pixels"] == 64, glass.dump());
}

//------------------------------------------------------------------------------
// Entries of records that explain differences outside the layers.
void TestRecords()
{
  const Boxes plain = compareTest::MakeBoxes();
  // The meshes of unnamed objects change: neither removed nor added.
  Boxes before = plain;
  for (Box& box : before.All)
  {
    box.Name.clear();
    box.Mesh = "box " + std::to_string(box.Center[0]);
    box.Cells = "6 " + std::to_string(box.Center[0]);
  }
  Boxes after = before;
  after.All[1].Cells = "5";
  CheckList(Compare(before, after), "shape ", "other cells");
  after.All[1].Mesh = "9 points";
  const json shape = Compare(before, after);
  CheckList(shape, "shape ", "other cells and points");
  RELIEVO_CHECK(shape["causes"][0]["id"] == 1);
  after.All[1].MovedBy = { 2., 0., 0. };
  RELIEVO_CHECK_THAT(List(Compare(before, after)).find("added") == 0, "another object elsewhere");
  // Bright light enlarges a level of the surface's colour.
  before = plain;
  before.Lamps[0].Intensity = 4.;
  after = before;
  after.All[1].Color[1] += 1. / 255.;
  const json color = Compare(before, after);
  CheckList(color, "color wheel", "a level of colour");
  RELIEVO_CHECK_THAT(color["pixels"] > 40, color.dump());
  // Recorded colours.
  before = plain;
  before.All[1].More = R"(, "color": [1, 0, 0])";
  after = before;
  after.All[1].More = R"(, "color": [1, 0.01, 0])";
  CheckList(Compare(before, after), "color wheel", "a recorded colour");
  CheckList(Compare(plain, after), "", "a colour in one record");
  // Clipping planes explain all pixels of their object, also at its edges.
  before = after = plain;
  before.All[1].More = R"(, "clipping": [[0, 0, 0, 1, 0, 0]])";
  after.All[1].More = R"(, "clipping": [])";
  after.All[1].Mesh = "0.3 0.4 0.2";
  before.All[1].Mesh = after.All[1].Mesh;
  after.All[1].HalfSize[1] += 0.02;
  const json clipped = Compare(before, after);
  RELIEVO_CHECK_THAT(Find(clipped, "visibility", "wheel")["pixels"] > 20, clipped.dump());
  RELIEVO_CHECK_THAT(Find(clipped, "shape", "wheel").is_null(), clipped.dump());
  // Sizes of points change the covered pixels.
  before.All[1].More = after.All[1].More = "";
  after.All[1].PointSize = 3.;
  const json points = Compare(before, after);
  RELIEVO_CHECK_THAT(Find(points, "settings", "wheel")["pixels"] > 20, points.dump());
  RELIEVO_CHECK_THAT(Find(points, "visibility", "wheel").is_null(), points.dump());
}

//------------------------------------------------------------------------------
// Volumes, each change with a cause of its own, at the pixels of the volume's box or layers.
void TestVolumes()
{
  Boxes before = compareTest::MakeBoxes();
  before.Volumes = {
    R"({"bounds": [-1, 1, 0, 1, -1, 1], "matrix": )"
    R"([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "points": "1", )"
    R"("array": "density", "data": "2", "colors": "3", "opacity": "4", "shading": "5", )"
    R"("visible": true, "clipping": []})"
  };
  const auto change = [&before](const std::string& from, const std::string& to) {
    Boxes after = before;
    after.Volumes[0].replace(after.Volumes[0].find(from), from.size(), to);
    const vtkSmartPointer<vtkImageData> frame = compareTest::Draw(after);
    compareTest::Fill(frame, "color", 76, 84, 71, 79, 0.7);
    return frame;
  };
  struct Case
  {
    std::string From, To, Cause, Words;
  };
  const Case cases[] = { { R"("data": "2")", R"("data": "9")", "array", "array density" },
    { R"("colors": "3")", R"("colors": "9")", "color", "color: colors" },
    { R"("opacity": "4")", R"("opacity": "9")", "color", "color: opacity" },
    { R"("shading": "5")", R"("shading": "9")", "settings", "settings: shading" },
    { R"("points": "1")", R"("points": "9")", "shape", "shape: points" },
    { R"("visible": true)", R"("visible": false)", "visibility", "hidden" },
    { R"("clipping": [])", R"("clipping": [[0, 0, 0, 1, 0, 0]])", "visibility",
      "visibility: clipping planes" },
    { R"([-1, 1, 0, 1, -1, 1], "matrix": [1, 0, 0, 0, )",
      R"([-0.5, 1.5, 0, 1, -1, 1], "matrix": [1, 0, 0, 0.5, )", "moved", "moved by (0.5, 0, 0)" },
    { R"("visible": true, "clipping": [])", R"("visible": false, "clipping": [[0, 0, 0, 1, 0, 0]])",
      "visibility", "hidden" },
    { R"([1, 0, 0, 0, 0, 1, 0, 0,)", R"([0, -1, 0, 0, 1, 0, 0, 0,)", "moved",
      "moved by (0, 0, 0), turned" },
    { R"([-1, 1, 0, 1, -1, 1], "matrix": [1, 0, 0, 0, )",
      R"([1, -1, 1, -1, 1, -1], "matrix": [1, 0, 0, 0.5, )", "moved", "moved" } };
  for (const Case& each : cases)
  {
    const json found = Compare(compareTest::Draw(before), change(each.From, each.To));
    CheckList(found, each.Cause + " ", each.To);
    RELIEVO_CHECK_THAT(found["causes"][0]["kind"] == "volume" &&
        found["causes"][0]["words"] == each.Words && found["pixels"] == 64,
      found.dump());
  }
  Boxes none = before;
  none.Volumes.clear();
  CheckList(Compare(before, none), "removed ", "a volume less");
  CheckList(Compare(none, before), "added ", "a volume more");
  // Volumes in another order are alike; of two, the layer of numbers tells which one differs.
  Boxes two = before;
  two.Volumes.push_back(two.Volumes[0]);
  two.Volumes[1].replace(two.Volumes[1].find("\"2\""), 3, "\"7\"");
  Boxes swapped = two;
  std::swap(swapped.Volumes[0], swapped.Volumes[1]);
  CheckList(Compare(two, swapped), "", "another order");
  Boxes both = two;
  for (std::string& volume : both.Volumes)
  {
    volume.replace(volume.find("\"3\""), 3, "\"9\"");
  }
  const auto draw = [](const Boxes& boxes, double opacity, double depth) {
    const vtkSmartPointer<vtkImageData> frame = compareTest::Draw(boxes);
    for (const char* name : { "volume", "volume_opacity", "volume_depth" })
    {
      const vtkSmartPointer<vtkDataArray> array = vtkSmartPointer<vtkDataArray>::Take(
        vtkDataArray::CreateDataArray(std::string(name) == "volume" ? VTK_INT : VTK_FLOAT));
      array->SetName(name);
      array->SetNumberOfTuples(frame->GetNumberOfPoints());
      frame->GetPointData()->AddArray(array);
    }
    compareTest::Fill(frame, "volume", 0, boxes.Width, 0, boxes.Height, -1.);
    compareTest::Fill(frame, "volume_opacity", 0, boxes.Width, 0, boxes.Height, 0.);
    compareTest::Fill(frame, "volume_depth", 0, boxes.Width, 0, boxes.Height,
      std::numeric_limits<double>::infinity());
    compareTest::Fill(frame, "volume", 70, 90, 60, 80, 1.);
    compareTest::Fill(frame, "volume_opacity", 70, 90, 60, 80, opacity);
    compareTest::Fill(frame, "volume_depth", 70, 90, 60, 80, depth);
    return frame;
  };
  const json second = Compare(draw(two, 0.5, 7.), draw(both, 0.6, 7.));
  RELIEVO_CHECK_THAT(second["pixels"] == 400 && second["unexplained"] == 0 &&
      second["causes"][0]["id"] == 1 && second["causes"][0]["pixels"] == 400,
    second.dump());
  // Rounding, another opacity and another depth without a record of a change.
  CheckList(Compare(draw(two, 0.5, 7.), draw(two, 0.505, 7.00001)), "", "rounding");
  CheckList(Compare(draw(two, 0.5, 7.), draw(two, 0.6, 7.)), "translucent ", "opacity");
  CheckList(Compare(draw(two, 0.5, 7.), draw(two, 0.5, 7.1)), "translucent ", "depth");
}

//------------------------------------------------------------------------------
// Blocks of composite data have attributes of their own, and points glyphs.
void TestBlocks()
{
  Boxes round = compareTest::MakeBoxes(), square = round;
  round.All[1].More = R"(, "glyphs": "1")";
  square.All[1].More = R"(, "glyphs": "2")";
  CheckList(Compare(round, square), "shape wheel", "other glyphs");
  CheckList(Compare(round, compareTest::MakeBoxes()), "", "glyphs in one record");

  const auto draw = [](const std::string& blocks) {
    Boxes boxes = compareTest::MakeBoxes();
    boxes.All[1].More = blocks.empty() ? "" : ", \"blocks\": " + blocks;
    return boxes;
  };
  const std::string hidden = R"([{"block": 3, "name": "hub", "visible": false}])";
  const auto words = [](const json& found) {
    return found["causes"].empty() ? std::string() : found["causes"][0]["words"].get<std::string>();
  };
  const json hides = Compare(draw("[]"), draw(hidden));
  CheckList(hides, "visibility wheel", "a hidden block");
  RELIEVO_CHECK_THAT(words(hides) == "visibility: block 3 (hub) hidden", hides.dump());
  RELIEVO_CHECK(words(Compare(draw(hidden), draw("[]"))) == "visibility: block 3 (hub) shown");
  CheckList(Compare(draw(hidden), draw(hidden)), "", "equal blocks");
  CheckList(Compare(draw(""), draw(hidden)), "", "a record without blocks");
  CheckList(
    Compare(draw("[]"), draw(R"([{"block": 2, "visible": true}])")), "", "an explicit default");
  CheckList(Compare(draw("[]"), draw(R"([{"block": 2, "color": [1, 0, 0]}])")), "color wheel",
    "a block's colour");
  const json opacity = Compare(draw("[]"), draw(R"([{"block": 2, "opacity": 0.5}])"));
  CheckList(opacity, "settings wheel", "a block's opacity");
  RELIEVO_CHECK_THAT(words(opacity) == "settings: opacity of blocks", opacity.dump());
  for (const char* damaged : { "7", "[7]", "{}", R"([{"block": "x"}])", R"([{"block": 1e99}])" })
  {
    CheckList(Compare(draw("[]"), draw(damaged)), "", damaged);
  }
}

//------------------------------------------------------------------------------
// Unnamed objects with new meshes are paired by the best of the boxes that overlap by half.
void TestNested()
{
  // Shells around one centre, recorded in another order.
  Boxes before = compareTest::MakeBoxes();
  const auto addShell = [](Boxes& boxes, double half, const std::string& mesh, double red) {
    boxes.All.push_back({ "", { 0., 0.5, 0. }, { half, half, half } });
    boxes.All.back().Mesh = boxes.All.back().Cells = mesh;
    boxes.All.back().More = R"(, "color": [)" + std::to_string(red) + ", 0, 0]";
  };
  Boxes after = before;
  addShell(before, 0.5, "1", 1.);
  addShell(before, 0.4, "2", 0.);
  addShell(after, 0.4, "3", 0.);
  addShell(after, 0.5, "4", 1.);
  CheckList(Compare(before, after), "shape , shape ", "nested shells");
  // A casing with many parts whose centres are nearer to its own.
  before = compareTest::MakeBoxes();
  before.Lamps.clear();
  after = before;
  addShell(before, 0.5, "1", 1.);
  for (int part = 0; part < 40; ++part)
  {
    for (const bool isBefore : { true, false })
    {
      Boxes& boxes = isBefore ? before : after;
      addShell(boxes, 0.001, std::to_string(100 * part + (isBefore ? 10 : 11)), 0.5);
      boxes.All.back().Center[0] = 0.003 * (part - 20);
    }
  }
  addShell(after, 0.5, "2", 1.);
  after.All.back().Center[0] = 0.1;
  const json found = Compare(before, after);
  RELIEVO_CHECK_THAT(found["causes"].size() == 41, found.dump());
  for (const json& each : found["causes"])
  {
    RELIEVO_CHECK_THAT(each["cause"] == "shape", each.dump());
  }
}

//------------------------------------------------------------------------------
// The linear light nearest to it that a picture of 8 bits can have.
double Quantize(double light)
{
  return relievoTest::LinearFromSrgb(std::round(255. * relievoTest::SrgbFromLinear(light)) / 255.);
}

// Adds levels of 255 to the picture in a rectangle.
void AddLevels(vtkImageData* frame, int x0, int x1, int y0, int y1, double levels)
{
  vtkDataArray* colors = frame->GetPointData()->GetArray("color");
  for (int y = y0; y < y1; ++y)
  {
    for (int x = x0; x < x1; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const vtkIdType i = y * frame->GetDimensions()[0] + x;
        const double shown = relievoTest::SrgbFromLinear(colors->GetComponent(i, c));
        colors->SetComponent(i, c, relievoTest::LinearFromSrgb(shown + levels / 255.));
      }
    }
  }
}

//------------------------------------------------------------------------------
// Normals of normal maps may be rounded to 8 bits, as their texels are, and lie between those
// around the pixel. The picture may differ by as much as it changes with the normals around.
void TestNormalMaps()
{
  Boxes boxes = compareTest::MakeBoxes();
  const auto draw = [&boxes](double slope) {
    const vtkSmartPointer<vtkImageData> frame = compareTest::Draw(boxes);
    vtkDataArray* normals = frame->GetPointData()->GetArray("normal");
    vtkDataArray* actors = frame->GetPointData()->GetArray("actor");
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      if (actors->GetTuple1(i) == 0.)
      {
        const double x = slope * double(i % boxes.Width % 4);
        normals->SetTuple3(i, x, std::sqrt(1. - x * x), 0.);
      }
    }
    return frame;
  };
  // Turns the normals of a block of the floor.
  const auto turn = [&boxes](vtkImageData* frame, int x0, int x1, double by) {
    vtkDataArray* normals = frame->GetPointData()->GetArray("normal");
    for (int y = 31; y < 34; ++y)
    {
      for (int x = x0; x < x1; ++x)
      {
        const double turned = normals->GetComponent(y * boxes.Width + x, 0) + by;
        normals->SetTuple3(y * boxes.Width + x, turned, std::sqrt(1. - turned * turned), 0.);
      }
    }
  };
  const double texel = 1. / 127.5;
  for (const bool isMapped : { false, true })
  {
    boxes.All[0].More = isMapped ? R"(, "normal_map": true, "normal_map_sum": "7")" : "";
    const vtkSmartPointer<vtkImageData> a = draw(0.), b = draw(0.);
    turn(b, 60, 80, 0.6 * texel);
    CheckList(Compare(a, b), isMapped ? "" : "normal floor", "rounded texels");
    turn(b, 60, 80, 1.9 * texel); // within the angle of a texel's three components
    const json turned = Compare(a, b);
    CheckList(turned, "normal floor", "turned texels");
    RELIEVO_CHECK_THAT(turned["pixels"] == 60, turned.dump());
  }
  // Slopes of one sign: a texel of the other sign is not between its neighbours.
  const vtkSmartPointer<vtkImageData> a = draw(texel), b = draw(texel);
  turn(b, 62, 63, -3.4 * texel);
  const json inverted = Compare(a, b);
  CheckList(inverted, "normal floor", "an inverted texel");
  RELIEVO_CHECK_THAT(inverted["pixels"] == 3, inverted.dump());
  // The picture changes by 4 levels from texel to texel, and so by 3 for rounded normals; other
  // differences are not theirs.
  for (const double levels : { 3., 12. })
  {
    vtkSmartPointer<vtkImageData> frames[2];
    for (int side = 0; side < 2; ++side)
    {
      frames[side] = draw(texel);
      for (int x = 56; x < 84; ++x)
      {
        AddLevels(frames[side], x, x + 1, 29, 36, 4. * (x % 4) - 6.);
      }
    }
    turn(frames[1], 60, 80, 0.7 * texel);
    AddLevels(frames[1], 60, 80, 31, 34, levels);
    CheckList(Compare(frames[0], frames[1]), levels > 4. ? "normal floor" : "",
      std::to_string(levels) + " levels");
  }
}

//------------------------------------------------------------------------------
// Tolerances for single samples, and for other numbers of samples.
void TestTolerances()
{
  Boxes boxes = compareTest::MakeBoxes();
  boxes.Settings.emplace_back("ambient:samples=16");
  for (const int samples : { 1, 3 })
  {
    vtkSmartPointer<vtkImageData> frames[2];
    for (vtkSmartPointer<vtkImageData>& frame : frames)
    {
      frame = compareTest::Draw(boxes);
      vtkNew<vtkFloatArray> array;
      array->SetName("ambient");
      array->SetNumberOfTuples(frame->GetNumberOfPoints());
      array->Fill(0.5);
      frame->GetPointData()->AddArray(array);
    }
    compareTest::Fill(frames[1], "ambient", 70, 71, 40, 41, 0.5 + samples / 16.);
    CheckList(Compare(frames[0], frames[1]), samples == 1 ? "" : "ambient ", "samples");
  }
  // A sample at each pixel changes the picture by a sample, and hides nothing else.
  for (const bool hasFault : { false, true })
  {
    vtkSmartPointer<vtkImageData> frames[2];
    for (int side = 0; side < 2; ++side)
    {
      frames[side] = compareTest::Draw(boxes);
      vtkNew<vtkFloatArray> array;
      array->SetName("ambient");
      array->SetNumberOfTuples(frames[side]->GetNumberOfPoints());
      array->Fill((8. + side) / 16.);
      frames[side]->GetPointData()->AddArray(array);
      vtkDataArray* colors = frames[side]->GetPointData()->GetArray("color");
      for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          const double light = colors->GetComponent(i, c) * array->GetValue(i);
          colors->SetComponent(i, c, Quantize(light));
        }
      }
    }
    if (hasFault)
    {
      AddLevels(frames[1], 60, 80, 30, 36, 12.);
    }
    const json found = Compare(frames[0], frames[1]);
    RELIEVO_CHECK_THAT(found["causes"].empty() && found["unexplained"] == (hasFault ? 120 : 0) &&
        found["within_limits"]["rounding"].get<int>() > 5000,
      found.dump());
  }
  // Each pixel of a fine mesh is at a border of cells, where values may be extrapolated by as much
  // as they change from pixel to pixel.
  for (const double levels : { 6., 16. })
  {
    boxes.Settings = { "multisamples=0" };
    vtkSmartPointer<vtkImageData> frames[2];
    for (vtkSmartPointer<vtkImageData>& frame : frames)
    {
      frame = compareTest::Draw(boxes);
      vtkDataArray* cells = frame->GetPointData()->GetArray("cell");
      for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
      {
        cells->SetTuple1(i, double(i));
      }
      for (int x = 20; x < 140; ++x)
      {
        AddLevels(frame, x, x + 1, 20, 30, x % 4 < 2 ? 0. : 3.);
      }
      boxes.Settings = { "multisamples=4" };
    }
    AddLevels(frames[1], 60, 62, 24, 25, levels);
    AddLevels(frames[1], 80, 81, 24, 25, -levels);   // a single pixel may be in a false shadow
    AddLevels(frames[1], 100, 101, 24, 25, levels);  // no shadow
    AddLevels(frames[0], 120, 121, 24, 25, -levels); // a cell at the pixel's centre, not at samples
    const json found = Compare(frames[0], frames[1]);
    RELIEVO_CHECK_THAT(found["unexplained"] == (levels > 10. ? 3 : 0), found.dump());
  }
  // Borders of cells and objects are mixtures in frames of several samples: other colours are not
  // theirs, and the inside is none.
  boxes.Settings = { "multisamples=0" };
  const vtkSmartPointer<vtkImageData> one = compareTest::Draw(boxes);
  vtkDataArray* cells = one->GetPointData()->GetArray("cell");
  vtkDataArray* colors = one->GetPointData()->GetArray("color");
  enum Kinds
  {
    Mixed,
    Wrong,
    Inside
  };
  for (const Kinds kind : { Mixed, Wrong, Inside })
  {
    boxes.Settings = { "multisamples=4" };
    const vtkSmartPointer<vtkImageData> four = compareTest::Draw(boxes);
    std::size_t count = 0;
    for (int y = 3; y < boxes.Height - 3; ++y)
    {
      for (int x = 3; x < boxes.Width - 3; ++x)
      {
        const vtkIdType at = y * boxes.Width + x;
        bool isUniform = true;
        for (int step = 0; step < 49; ++step)
        {
          isUniform = isUniform &&
            cells->GetTuple1((y + step / 7 - 3) * boxes.Width + x + step % 7 - 3) ==
              cells->GetTuple1(at);
        }
        if (kind == Inside ? !isUniform : cells->GetTuple1(at) == cells->GetTuple1(at + 1))
        {
          continue;
        }
        for (int c = 0; c < 3; ++c)
        {
          const double mixed =
            0.5 * (colors->GetComponent(at - 1, c) + colors->GetComponent(at + 1, c));
          four->GetPointData()->GetArray("color")->SetComponent(at, c,
            kind == Mixed      ? mixed
              : kind == Inside ? 0.9
              : c == 1         ? 0.9
                               : 0.);
        }
        ++count;
      }
    }
    const json found = Compare(one, four);
    const auto pixels = found["unexplained"].get<std::size_t>(); // fewer: at edges of shadows
    RELIEVO_CHECK_THAT(
      count > 50 && (kind == Mixed ? pixels == 0 : pixels > count / 2), found.dump());
  }
}

//------------------------------------------------------------------------------
// Layers of stages, each with a cause of its own.
void TestStages()
{
  const std::pair<const char*, const char*> stages[] = { { "light", "lamps" }, { "fog", "fog" },
    { "ambient", "ambient" }, { "marker", "markers" }, { "blend", "translucent" } };
  for (const auto& [layer, cause] : stages)
  {
    vtkSmartPointer<vtkImageData> frames[2];
    for (vtkSmartPointer<vtkImageData>& frame : frames)
    {
      frame = compareTest::Draw(compareTest::MakeBoxes());
      vtkNew<vtkFloatArray> array;
      array->SetName(layer);
      array->SetNumberOfComponents(3);
      array->SetNumberOfTuples(frame->GetNumberOfPoints());
      array->Fill(0.25);
      frame->GetPointData()->AddArray(array);
    }
    // One and a half levels are within the limits.
    compareTest::Fill(frames[1], layer, 5, 25, 5, 12, 0.25 + 1.5 / 255.);
    const json within = Compare(frames[0], frames[1]);
    RELIEVO_CHECK_THAT(
      within["alike"] == true && within["within_limits"]["rounding"] == 140, within.dump());
    compareTest::Fill(frames[1], layer, 5, 15, 5, 12, 0.5);
    const json found = Compare(frames[0], frames[1]);
    CheckList(found, std::string(cause) + " ", layer);
    RELIEVO_CHECK(found["pixels"] == 70 && found["within_limits"]["rounding"] == 70);
  }
}

//------------------------------------------------------------------------------
// Equal, unnamed objects that swap places are no change.
void TestSwarm()
{
  Boxes before;
  for (int i = 0; i < 1000; ++i)
  {
    const double x = -2.4 + 0.15 * (i % 33);
    const double z = -2.4 + 0.15 * (i / 33);
    before.All.push_back({ "", { x, 0., z }, { 0.05, 0.05, 0.05 } });
    before.All.back().Center = { 0., 0., 0. };
    before.All.back().MovedBy = { x, 0., z };
  }
  before.Width = 96;
  before.Height = 72;
  Boxes after = before;
  for (std::size_t i = 0; i < after.All.size(); ++i)
  {
    after.All[i].MovedBy = before.All[(i * 7 + 3) % 1000].MovedBy;
  }
  const json found = Compare(before, after);
  RELIEVO_CHECK_THAT(found["alike"] == true, List(found));
  after.All[500].MovedBy[1] += 0.05;
  const json one = Compare(before, after);
  RELIEVO_CHECK_THAT(one["causes"].size() == 1 && one["causes"][0]["cause"] == "moved", one.dump());
}

//------------------------------------------------------------------------------
// A thousand equal tiles, in another order and each two pixels farther to the right, found by what
// is seen of them.
void TestTiles()
{
  constexpr int Columns = 40, Rows = 25, Pitch = 6, Side = 4;
  Boxes boxes;
  boxes.Width = Columns * Pitch + 2;
  boxes.Height = Rows * Pitch;
  boxes.HasRecord = false;
  vtkSmartPointer<vtkImageData> frames[2];
  for (int side = 0; side < 2; ++side)
  {
    frames[side] = compareTest::Draw(boxes);
    for (int tile = 0; tile < Columns * Rows; ++tile)
    {
      const int number = side == 0 ? tile : (7 * tile + 3) % (Columns * Rows);
      const int x = tile % Columns * Pitch + 2 * side;
      const int y = tile / Columns * Pitch;
      compareTest::Fill(frames[side], "actor", x, x + Side, y, y + Side, number);
      compareTest::Fill(frames[side], "depth", x, x + Side, y, y + Side, 8.);
      for (int cell = 0; cell < 4; ++cell)
      {
        const int left = x + cell % 2 * 2;
        const int low = y + cell / 2 * 2;
        compareTest::Fill(frames[side], "cell", left, left + 2, low, low + 2, cell);
      }
    }
  }
  const json found = Compare(frames[0], frames[1]);
  const double shift =
    2. * 2. * std::tan(vtkMath::RadiansFromDegrees(0.5 * boxes.ViewAngle)) * 8. / boxes.Height;
  const auto isRight = [shift](const json& cause) {
    return cause["cause"] == "moved" &&
      std::abs(std::hypot(cause["displacement"][0].get<double>(),
                 cause["displacement"][1].get<double>(), cause["displacement"][2].get<double>()) -
        shift) < 0.01 * shift;
  };
  const auto right = std::count_if(found["causes"].begin(), found["causes"].end(), isRight);
  RELIEVO_CHECK_THAT(right == Columns * Rows && found["causes"].size() == Columns * Rows &&
      found["unexplained"] == 0,
    std::to_string(right) + ": " + found["causes"][0].dump());
}

//------------------------------------------------------------------------------
// A row of different parts that moves as a whole, by its own length: most parts have many others
// between their places before and after.
void TestRow()
{
  constexpr int Parts = 100, Width = 90, Pitch = 92;
  Boxes boxes;
  boxes.Width = 2 * Parts * Pitch + 2;
  boxes.Height = 11;
  boxes.HasRecord = false;
  vtkSmartPointer<vtkImageData> frames[2];
  for (int side = 0; side < 2; ++side)
  {
    frames[side] = compareTest::Draw(boxes);
    for (int part = 0; part < Parts; ++part)
    {
      const int number = side == 0 ? part : (7 * part + 3) % Parts;
      const int x = 1 + (part + side * Parts) * Pitch;
      compareTest::Fill(frames[side], "actor", x, x + Width, 1, 10, number);
      compareTest::Fill(frames[side], "depth", x, x + Width, 1, 10, 8.);
      const int borders[3] = { 18 + 6 * (part % 10), 18 + 6 * (part / 10), Width / 2 };
      for (int row = 0; row < 3; ++row)
      {
        const int y = 1 + 3 * row;
        compareTest::Fill(frames[side], "cell", x, x + borders[row], y, y + 3, 2 * row);
        compareTest::Fill(frames[side], "cell", x + borders[row], x + Width, y, y + 3, 2 * row + 1);
      }
    }
  }
  const json found = Compare(frames[0], frames[1]);
  const double pixel =
    2. * std::tan(vtkMath::RadiansFromDegrees(0.5 * boxes.ViewAngle)) * 8. / boxes.Height;
  const auto isRight = [pixel](const json& cause) {
    return cause["cause"] == "moved" &&
      std::abs(std::hypot(cause["displacement"][0].get<double>(),
                 cause["displacement"][1].get<double>(), cause["displacement"][2].get<double>()) -
        Parts * Pitch * pixel) < pixel;
  };
  const auto right = std::count_if(found["causes"].begin(), found["causes"].end(), isRight);
  RELIEVO_CHECK_THAT(
    right == Parts && found["causes"].size() == Parts, std::to_string(right) + ": " + List(found));
}
}

RELIEVO_TEST_CASE(testComparedObjects)
{
  relievoTest::Session session;
  TestAlike();
  TestMoved();
  TestAddedAndRemoved();
  TestShape();
  TestSurfaces();
  TestLights();
  TestPictureAlone();
  TestRecords();
  TestVolumes();
  TestBlocks();
  TestNested();
  TestNormalMaps();
  TestTolerances();
  TestStages();
  TestSwarm();
  TestTiles();
  TestRow();
  return session.Result();
}
}
