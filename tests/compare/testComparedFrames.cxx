// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of unusual images and files: sizes, cameras, NaN, PNG, damaged files, other formats.
#include "BoxFrames.h"

#include "Check.h"
#include "Session.h"
#include "SrgbCurve.h"
#include "TestCase.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoFrameComparison.h"

#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

namespace testComparedFrames
{
namespace
{
using nlohmann::json;

std::string File(const std::string& name)
{
  return relievoTest::OutputFolder() + "/" + name;
}

json Compare(vtkImageData* a, vtkImageData* b)
{
  vtkNew<vtkRelievoFrameComparison> comparison;
  comparison->SetBaseline(a);
  comparison->SetFrame(b);
  RELIEVO_CHECK(comparison->Compare());
  const std::string text = comparison->GetText();
  RELIEVO_CHECK(std::count(text.begin(), text.end(), '\n') <= 24);
  return json::parse(comparison->GetJSON());
}

json CompareFiles(const std::string& a, const std::string& b)
{
  vtkNew<vtkRelievoFrameComparison> comparison;
  RELIEVO_CHECK(comparison->ReadBaseline(a.c_str()) && comparison->ReadFrame(b.c_str()));
  RELIEVO_CHECK(comparison->Compare());
  return json::parse(comparison->GetJSON());
}

void Write(vtkImageData* image, const std::string& name)
{
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetFileName(File(name).c_str());
  writer->SetInputData(image);
  RELIEVO_CHECK(writer->Write() == 1);
}

bool Cannot(const json& found, const std::string& cause)
{
  const json& all = found["cannot_be_detected"];
  return std::find(all.begin(), all.end(), cause) != all.end();
}

//------------------------------------------------------------------------------
void TestSizeAndCamera()
{
  const compareTest::Boxes boxes = compareTest::MakeBoxes();
  compareTest::Boxes other = boxes;
  other.Width = 161;
  const json size = Compare(compareTest::Draw(boxes), compareTest::Draw(other));
  RELIEVO_CHECK(size["alike"] == false && size["causes"].size() == 1 &&
    size["causes"][0]["cause"] == "size" && size["pixels"] == 0);
  other = boxes;
  other.Eye[0] += 1e-11;
  const json camera = Compare(compareTest::Draw(boxes), compareTest::Draw(other));
  RELIEVO_CHECK(camera["causes"].size() == 1 && camera["causes"][0]["cause"] == "camera");
  // Clipping distances follow the scene's bounds, so they are ignored.
  const vtkSmartPointer<vtkImageData> nearer = compareTest::Draw(boxes);
  nearer->GetFieldData()->GetArray("near")->SetTuple1(0, 1.5);
  vtkDataArray* projection = nearer->GetFieldData()->GetArray("worldToNDC");
  projection->SetTuple1(11, projection->GetTuple1(11) * 1.5);
  RELIEVO_CHECK(Compare(compareTest::Draw(boxes), nearer)["alike"] == true);
}

//------------------------------------------------------------------------------
void TestValues()
{
  const compareTest::Boxes boxes = compareTest::MakeBoxes();
  // NaN equals only NaN.
  const vtkSmartPointer<vtkImageData> a = compareTest::Draw(boxes);
  const vtkSmartPointer<vtkImageData> b = compareTest::Draw(boxes);
  compareTest::Fill(b, "color", 0, 3, 0, 1, std::numeric_limits<double>::quiet_NaN());
  RELIEVO_CHECK(Compare(a, b)["unexplained"] == 3);
  compareTest::Fill(a, "color", 0, 3, 0, 1, std::numeric_limits<double>::quiet_NaN());
  RELIEVO_CHECK(Compare(a, b)["alike"] == true);
  compareTest::Fill(b, "depth", 80, 82, 40, 41, std::numeric_limits<double>::quiet_NaN());
  const json depth = Compare(a, b);
  RELIEVO_CHECK_THAT(depth["alike"] == false && depth["pixels"] == 2, depth.dump());
  // An empty scene.
  compareTest::Boxes empty;
  RELIEVO_CHECK(Compare(compareTest::Draw(empty), compareTest::Draw(empty))["alike"] == true);
  const json all = Compare(compareTest::Draw(empty), compareTest::Draw(boxes));
  RELIEVO_CHECK(all["alike"] == false && all["unexplained"] == 0);
  // Smooth edges have colours between their neighbours' colours.
  const vtkSmartPointer<vtkImageData> smooth = compareTest::Draw(boxes);
  const vtkSmartPointer<vtkImageData> sharp = compareTest::Draw(boxes);
  vtkDataArray* actors = sharp->GetPointData()->GetArray("actor");
  vtkDataArray* colors = sharp->GetPointData()->GetArray("color");
  int mixed = 0;
  for (vtkIdType i = 40 * 160 + 1; i < 41 * 160 - 1; ++i)
  {
    if (actors->GetTuple1(i) != actors->GetTuple1(i + 1))
    {
      for (int c = 0; c < 4; ++c)
      {
        smooth->GetPointData()->GetArray("color")->SetComponent(
          i, c, 0.5 * (colors->GetComponent(i, c) + colors->GetComponent(i + 1, c)));
      }
      ++mixed;
    }
  }
  const json edges = Compare(sharp, smooth);
  RELIEVO_CHECK_THAT(
    mixed > 2 && edges["alike"] == true && edges["within_limits"]["edge"] == mixed, edges.dump());
}

//------------------------------------------------------------------------------
// With equal records, differences by rounding at borders are within the limits, others are not.
void TestBorders()
{
  compareTest::Boxes boxes = compareTest::MakeBoxes();
  boxes.Settings.emplace_back("shadows:soft_samples=24");
  const vtkSmartPointer<vtkImageData> a = compareTest::Draw(boxes);
  // Two coincident faces: another cell at the same depth, inside a face.
  vtkSmartPointer<vtkImageData> b = compareTest::Draw(boxes);
  compareTest::Fill(b, "cell", 90, 92, 50, 52, 9.);
  const json twins = Compare(a, b);
  RELIEVO_CHECK_THAT(twins["alike"] == true && twins["within_limits"]["edge"] == 4, twins.dump());
  // A hole through which a far surface is visible is a change, not rounding.
  compareTest::Fill(b, "depth", 88, 94, 48, 54, 40.);
  compareTest::Fill(b, "cell", 88, 94, 48, 54, 7.);
  const json hole = Compare(a, b);
  RELIEVO_CHECK_THAT(
    hole["alike"] == false && hole["pixels"] == 36 && hole["causes"][0]["cause"] == "shape",
    hole.dump());
  // A shadow's border may move by one pixel; light that leaks inside the shadow is a change.
  vtkDataArray* shadow = a->GetPointData()->GetArray("shadow_0");
  vtkDataArray* actor = a->GetPointData()->GetArray("actor");
  b = compareTest::Draw(boxes);
  vtkDataArray* moved = b->GetPointData()->GetArray("shadow_0");
  vtkIdType border = -1;
  for (vtkIdType i = 161; i < 160 * 119 - 1 && border < 0; ++i)
  {
    border = shadow->GetTuple1(i) == 0. && shadow->GetTuple1(i + 1) == 1. &&
        actor->GetTuple1(i) >= 0. && actor->GetTuple1(i + 1) >= 0.
      ? i
      : -1;
  }
  moved->SetTuple1(border, 1.);
  RELIEVO_CHECK(border > 0 && Compare(a, b)["alike"] == true);
  for (const vtkIdType other : { -161, -160, -159, -1, 0, 1, 159, 160, 161 })
  {
    moved->SetTuple1(50 * 160 + 90 + other, 0.5);
  }
  const json leak = Compare(a, b);
  RELIEVO_CHECK_THAT(
    leak["alike"] == false && leak["causes"][0]["cause"] == "shadow" && leak["pixels"] == 9,
    leak.dump());
  // Without records, a changed cell at a border may be a changed shape.
  boxes.HasRecord = false;
  const vtkSmartPointer<vtkImageData> c = compareTest::Draw(boxes);
  const vtkSmartPointer<vtkImageData> d = compareTest::Draw(boxes);
  compareTest::Fill(d, "cell", 90, 92, 50, 52, 9.);
  RELIEVO_CHECK(Compare(c, d)["causes"][0]["cause"] == "shape");
}

//------------------------------------------------------------------------------
void TestFiles()
{
  compareTest::Boxes boxes = compareTest::MakeBoxes();
  boxes.Overlays = { R"({"kind": "text", "text": "a \"b\" <c>"})" };
  Write(compareTest::Draw(boxes), "a.exr");
  compareTest::Boxes moved = boxes;
  moved.All[1].MovedBy = { 0.1, 0., 0. };
  Write(compareTest::Draw(moved), "b.exr");
  RELIEVO_CHECK(CompareFiles(File("a.exr"), File("a.exr"))["alike"] == true);
  const json found = CompareFiles(File("a.exr"), File("b.exr"));
  RELIEVO_CHECK(found["alike"] == false && found["unexplained"] == 0);
  const json inMemory = Compare(compareTest::Draw(boxes), compareTest::Draw(moved));
  RELIEVO_CHECK_THAT(found == inMemory, found.dump() + "\n" + inMemory.dump());

  // A file without a record: compared by its layers, with the causes that these cannot identify.
  compareTest::Boxes older = moved;
  older.HasRecord = false;
  Write(compareTest::Draw(older), "older.exr");
  const json old = CompareFiles(File("a.exr"), File("older.exr"));
  RELIEVO_CHECK(old["alike"] == false && old["causes"][0]["cause"] == "moved");
  RELIEVO_CHECK(Cannot(old, "overlay") && Cannot(old, "settings") && !Cannot(old, "moved"));
  // The first format, which has no volumes, and fewer values of materials.
  const vtkSmartPointer<vtkImageData> first = compareTest::Draw(boxes);
  first->GetFieldData()->GetArray("baseline_version")->SetTuple1(0, 1);
  first->GetFieldData()->RemoveArray("volumes");
  vtkStringArray* objects =
    vtkStringArray::SafeDownCast(first->GetFieldData()->GetAbstractArray("objects"));
  std::string wheel = objects->GetValue(1);
  wheel.replace(
    wheel.find(", \"point_size\""), wheel.find('}') - wheel.find(", \"point_size\""), "");
  objects->SetValue(1, wheel);
  const vtkSmartPointer<vtkImageData> present = compareTest::Draw(boxes);
  RELIEVO_CHECK(Compare(first, present)["alike"] == true);
  RELIEVO_CHECK(Compare(present, first)["alike"] == true);
  // The second format, where sums of volumes and glyphs had another meaning, which is no change.
  compareTest::Boxes volumes = boxes;
  volumes.Volumes = { R"({"visible": true, "data": "2"})" };
  const vtkSmartPointer<vtkImageData> third = compareTest::Draw(volumes);
  volumes.Volumes = { R"({"visible": true, "data": "9"})" };
  const vtkSmartPointer<vtkImageData> second = compareTest::Draw(volumes);
  RELIEVO_CHECK(Compare(second, third)["alike"] == false);
  second->GetFieldData()->GetArray("baseline_version")->SetTuple1(0, 2);
  RELIEVO_CHECK(Compare(second, third)["alike"] == true);
  RELIEVO_CHECK(Compare(third, second)["alike"] == true);
  // A newer format.
  const vtkSmartPointer<vtkImageData> future = compareTest::Draw(boxes);
  future->GetFieldData()->GetArray("baseline_version")->SetTuple1(0, 9);
  vtkNew<vtkRelievoFrameComparison> comparison;
  comparison->SetBaseline(compareTest::Draw(boxes));
  comparison->SetFrame(future);
  {
    relievoTest::ExpectMessage expect("the frame has the baseline format 9, expected at most 3");
    RELIEVO_CHECK(!comparison->Compare() && !comparison->GetAlike());
  }
  // An invalid record, and one with fewer objects than are visible.
  for (const char* text : { "{\"name\": 3}", "[", "" })
  {
    const vtkSmartPointer<vtkImageData> damaged = compareTest::Draw(boxes);
    vtkStringArray::SafeDownCast(damaged->GetFieldData()->GetAbstractArray("objects"))
      ->SetValue(2, text);
    comparison->SetFrame(damaged);
    relievoTest::ExpectMessage expect("record of object 2 that cannot be read");
    RELIEVO_CHECK(!comparison->Compare());
  }
  const vtkSmartPointer<vtkImageData> fewer = compareTest::Draw(boxes);
  vtkStringArray::SafeDownCast(fewer->GetFieldData()->GetAbstractArray("objects"))
    ->SetNumberOfValues(2);
  comparison->SetFrame(fewer);
  {
    relievoTest::ExpectMessage expect("but its record has 2 objects");
    RELIEVO_CHECK(!comparison->Compare());
  }
  // Truncated and missing files.
  std::ifstream whole(File("a.exr"), std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(whole)), std::istreambuf_iterator<char>());
  std::ofstream(File("cut.exr"), std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  for (const char* name : { "cut.exr", "missing.exr", "missing.png" })
  {
    relievoTest::ExpectMessage expect(name);
    RELIEVO_CHECK(!comparison->ReadFrame(File(name).c_str()));
    RELIEVO_CHECK(comparison->GetFailureText().find(name) != std::string::npos);
  }
  {
    relievoTest::ExpectMessage expect("the frame is missing");
    RELIEVO_CHECK(!comparison->Compare());
  }
}

//------------------------------------------------------------------------------
// Invalid records and layers, as in damaged files.
void TestDamaged()
{
  compareTest::Boxes boxes = compareTest::MakeBoxes();
  const vtkSmartPointer<vtkImageData> whole = compareTest::Draw(boxes);
  vtkNew<vtkRelievoFrameComparison> comparison;
  comparison->SetBaseline(whole);
  // Overlays of any kind are compared.
  compareTest::Boxes odd = boxes;
  odd.Overlays = { R"({"kind": 3})", "[1]", "7", "{" };
  const json overlays = Compare(whole, compareTest::Draw(odd));
  RELIEVO_CHECK_THAT(
    overlays["causes"].size() == 1 && overlays["causes"][0]["cause"] == "overlay", overlays.dump());
  // JSON that is nested deeply enough to overflow the stack when it is copied.
  const vtkSmartPointer<vtkImageData> deep = compareTest::Draw(boxes);
  vtkNew<vtkStringArray> volumes;
  volumes->SetName("volumes");
  volumes->InsertNextValue(
    R"({"data": )" + std::string(200000, '[') + std::string(200000, ']') + "}");
  deep->GetFieldData()->AddArray(volumes);
  RELIEVO_CHECK(!Compare(whole, deep).empty());
  // A portable baseline and another one.
  const vtkSmartPointer<vtkImageData> portable = compareTest::Draw(boxes);
  vtkNew<vtkIntArray> mark;
  mark->SetName("portable");
  mark->InsertNextValue(1);
  portable->GetFieldData()->AddArray(mark);
  comparison->SetFrame(portable);
  {
    relievoTest::ExpectMessage expect("the frame is portable, but the baseline is not");
    RELIEVO_CHECK(!comparison->Compare());
  }
  // An invalid format number.
  const vtkSmartPointer<vtkImageData> zeroth = compareTest::Draw(boxes);
  zeroth->GetFieldData()->GetArray("baseline_version")->SetTuple1(0, 0);
  comparison->SetFrame(zeroth);
  {
    relievoTest::ExpectMessage expect("the frame has the baseline format 0, expected at least 1");
    RELIEVO_CHECK(!comparison->Compare());
  }
  // A random actor number.
  boxes.HasRecord = false;
  const vtkSmartPointer<vtkImageData> many = compareTest::Draw(boxes);
  many->GetPointData()->GetArray("actor")->SetTuple1(100, std::numeric_limits<int>::max());
  comparison->SetFrame(many);
  {
    relievoTest::ExpectMessage expect("the frame shows actor 2147483647, expected at most 999999");
    RELIEVO_CHECK(!comparison->Compare());
  }
  // Ids with two components are ignored, and so are float ids that are no int.
  const vtkSmartPointer<vtkImageData> wide = compareTest::Draw(boxes);
  vtkNew<vtkIntArray> pairs;
  pairs->SetName("actor");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(wide->GetNumberOfPoints());
  pairs->Fill(1);
  wide->GetPointData()->AddArray(pairs);
  RELIEVO_CHECK(Cannot(Compare(wide, wide), "removed"));
  const vtkSmartPointer<vtkImageData> floats = compareTest::Draw(boxes);
  vtkNew<vtkFloatArray> ids;
  ids->DeepCopy(floats->GetPointData()->GetArray("actor"));
  ids->SetName("actor");
  ids->SetValue(0, std::numeric_limits<float>::quiet_NaN());
  ids->SetValue(1, 1e30f);
  floats->GetPointData()->AddArray(ids);
  RELIEVO_CHECK(Compare(floats, floats)["alike"] == true);
  // Records, and other cells, but no ids of actors.
  const vtkSmartPointer<vtkImageData> cells = compareTest::Draw(compareTest::MakeBoxes());
  cells->GetPointData()->RemoveArray("actor");
  compareTest::Fill(cells, "cell", 90, 92, 50, 52, 9.);
  RELIEVO_CHECK(Compare(whole, cells)["within_limits"]["edge"] == 4);
  // Control characters in names must not reach the terminal.
  compareTest::Boxes named = compareTest::MakeBoxes();
  named.All[1].Name = R"(wh\u001b[2J\nel)";
  comparison->SetBaseline(compareTest::Draw(named));
  named.All[1].MovedBy = { 0.1, 0., 0. };
  comparison->SetFrame(compareTest::Draw(named));
  RELIEVO_CHECK(comparison->Compare());
  RELIEVO_CHECK(comparison->GetText().find('\x1b') == std::string::npos);
  RELIEVO_CHECK_THAT(
    comparison->GetText().find("wh?[2J?el (actor 1)") != std::string::npos, comparison->GetText());
}

//------------------------------------------------------------------------------
// A frame with layers and its picture without layers: only the pictures are compared.
void TestUnequalSides()
{
  const compareTest::Boxes boxes = compareTest::MakeBoxes();
  const vtkSmartPointer<vtkImageData> layers = compareTest::Draw(boxes);
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(layers->GetDimensions());
  vtkNew<vtkFloatArray> color;
  color->DeepCopy(layers->GetPointData()->GetArray("color"));
  color->SetName("color");
  picture->GetPointData()->AddArray(color);
  for (const bool swaps : { false, true })
  {
    const json found = swaps ? Compare(picture, layers) : Compare(layers, picture);
    RELIEVO_CHECK_THAT(found["alike"] == true && found["pixels"] == 0, found.dump());
    RELIEVO_CHECK(Cannot(found, "moved") && Cannot(found, "shape") && Cannot(found, "camera"));
  }
  compareTest::Fill(picture, "color", 5, 15, 5, 6, 1.);
  RELIEVO_CHECK(Compare(layers, picture)["unexplained"] == 10);

  // Grey equals equal red, green and blue. Alpha counts only if both pictures have it.
  const auto fill = [](std::initializer_list<double> tuple) {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(4, 3, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, static_cast<int>(tuple.size()));
    for (vtkIdType i = 0; i < 12; ++i)
    {
      image->GetPointData()->GetScalars()->SetTuple(i, std::data(tuple));
    }
    return image;
  };
  RELIEVO_CHECK(Compare(fill({ 200. }), fill({ 200., 200., 200. }))["alike"] == true);
  RELIEVO_CHECK(Compare(fill({ 200. }), fill({ 200., 200., 100. }))["unexplained"] == 12);
  RELIEVO_CHECK(Compare(fill({ 200., 9. }), fill({ 200., 200., 200. }))["alike"] == true);
  RELIEVO_CHECK(Compare(fill({ 200., 9. }), fill({ 200., 200., 200., 9. }))["alike"] == true);
  RELIEVO_CHECK(Compare(fill({ 200., 9. }), fill({ 200., 200., 200., 90. }))["unexplained"] == 12);
}

//------------------------------------------------------------------------------
// Pixels nearer than the clipping distance are clipped, not hidden by another object.
void TestClipped()
{
  const compareTest::Boxes boxes = compareTest::MakeBoxes();
  compareTest::Boxes without = boxes;
  without.All[2].Visible = false;
  const vtkSmartPointer<vtkImageData> a = compareTest::Draw(boxes);
  const vtkSmartPointer<vtkImageData> b = compareTest::Draw(boxes);
  const vtkSmartPointer<vtkImageData> behind = compareTest::Draw(without);
  vtkDataArray* actor = a->GetPointData()->GetArray("actor");
  vtkDataArray* depth = a->GetPointData()->GetArray("depth");
  double range[2] = { std::numeric_limits<double>::infinity(), 0. };
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    if (actor->GetTuple1(i) == 2.)
    {
      range[0] = std::min(range[0], depth->GetTuple1(i));
      range[1] = std::max(range[1], depth->GetTuple1(i));
    }
  }
  const double near = 0.5 * (range[0] + range[1]);
  int gone = 0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    if (actor->GetTuple1(i) == 2. && depth->GetTuple1(i) < near)
    {
      for (const char* name : { "actor", "block", "cell", "depth", "normal", "albedo", "color" })
      {
        b->GetPointData()->GetArray(name)->SetTuple(i, i, behind->GetPointData()->GetArray(name));
      }
      ++gone;
    }
  }
  b->GetFieldData()->GetArray("near")->SetTuple1(0, near);
  const json found = Compare(a, b);
  const json& cause = found["causes"][0];
  RELIEVO_CHECK_THAT(gone > 100 && found["causes"].size() == 1 && cause["cause"] == "visibility" &&
      cause["name"] == "helmet" && cause["words"] == "visibility: clipped" &&
      cause["pixels"] == gone,
    found.dump());
}

//------------------------------------------------------------------------------
// Pictures of 8 bits that are stored as linear floats: all pairs of levels at the limit of 2.
void TestLevels()
{
  const auto make = [](int above) {
    vtkNew<vtkFloatArray> color;
    color->SetName("color");
    color->SetNumberOfComponents(3);
    color->SetNumberOfTuples(253);
    for (int level = 0; level < 253; ++level)
    {
      for (int c = 0; c < 3; ++c)
      {
        color->SetComponent(level, c, relievoTest::LinearFromSrgb((level + above) / 255.));
      }
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(253, 1, 1);
    image->GetPointData()->AddArray(color);
    return image;
  };
  const json two = Compare(make(0), make(2));
  RELIEVO_CHECK(two["alike"] == true && two["within_limits"]["rounding"] == 253);
  RELIEVO_CHECK(Compare(make(0), make(3))["unexplained"] == 253);
}

//------------------------------------------------------------------------------
void TestPNG()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(20, 10, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkDataArray* colors = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < 200; ++i)
  {
    colors->SetTuple3(i, double(i), 100., 255. - double(i));
  }
  const auto write = [&](const char* name) {
    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(File(name).c_str());
    writer->SetInputData(image);
    writer->Write();
  };
  write("a.png");
  for (vtkIdType i = 20; i < 30; ++i)
  {
    colors->SetComponent(i, 1, 102.);
    colors->SetComponent(i + 20, 1, 103.);
  }
  write("b.png");
  const json found = CompareFiles(File("a.png"), File("b.png"));
  RELIEVO_CHECK(found["alike"] == false && found["causes"].empty());
  RELIEVO_CHECK(found["unexplained"] == 10 && found["within_limits"]["rounding"] == 10);
  for (const char* cause : { "camera", "moved", "shape", "color", "light", "shadow", "overlay" })
  {
    RELIEVO_CHECK_THAT(Cannot(found, cause), cause);
  }
  // Larger and smaller limits.
  vtkNew<vtkRelievoFrameComparison> comparison;
  comparison->ReadBaseline(File("a.png").c_str());
  comparison->ReadFrame(File("b.png").c_str());
  comparison->SetColorLevels(3.);
  RELIEVO_CHECK(comparison->Compare() && comparison->GetAlike());
  comparison->SetColorLevels(0.);
  RELIEVO_CHECK(comparison->Compare() && comparison->GetNumberOfUnexplainedPixels() == 20);
}

//------------------------------------------------------------------------------
// A new cause needs a colour.
void TestColors()
{
  std::istringstream words(
    vtkRelievoFrameComparison::GetCauseWords() + ", unexplained, edge, rounding");
  for (std::string word; std::getline(words >> std::ws, word, ',');)
  {
    const std::string color = vtkRelievoFrameComparison::GetCauseColor(word.c_str());
    RELIEVO_CHECK_THAT(color.size() == 7 && color[0] == '#', word);
  }
  RELIEVO_CHECK(vtkRelievoFrameComparison::GetCauseColor("wheel").empty() &&
    vtkRelievoFrameComparison::GetCauseColor(nullptr).empty());
}
}

RELIEVO_TEST_CASE(testComparedFrames)
{
  relievoTest::Session session;
  TestSizeAndCamera();
  TestValues();
  TestBorders();
  TestFiles();
  TestDamaged();
  TestUnequalSides();
  TestClipped();
  TestLevels();
  TestPNG();
  TestColors();
  return session.Result();
}
}
