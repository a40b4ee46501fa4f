// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Damaged baselines, in files and in memory, are compared or refused with a reason.
//   testDamagedBaselines [long | SEED]
#include "BoxFrames.h"

#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoComparisonReport.h"
#include "vtkRelievoEXRWriter.h"
#include "vtkRelievoFrameComparison.h"

#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <random>
#include <sys/resource.h>

namespace testDamagedBaselines
{
namespace
{
using nlohmann::json;

constexpr int Usual = 400, Many = 20000; // baselines
constexpr long MostMemory = 1024;        // MiB

class Chance
{
public:
  explicit Chance(int seed)
    : Random(static_cast<unsigned>(seed))
  {
  }
  // A number below a limit.
  std::size_t Below(std::size_t limit) { return this->Random() % std::max<std::size_t>(1, limit); }
  template <typename T>
  const T& Of(const std::vector<T>& all)
  {
    return all[this->Below(all.size())];
  }

private:
  std::mt19937 Random;
};

// The size of an OpenEXR file's header: names, types, sizes and values of attributes.
std::size_t GetHeaderSize(const std::string& bytes)
{
  std::size_t at = 8;
  while (bytes[at] != '\0')
  {
    at = bytes.find('\0', at) + 1;
    at = bytes.find('\0', at) + 1;
    std::int32_t size = 0;
    std::memcpy(&size, bytes.data() + at, 4);
    at += 4 + static_cast<std::size_t>(size);
  }
  return at + 1;
}

//------------------------------------------------------------------------------
std::string DamageFile(std::string bytes, std::size_t header, Chance& chance, bool& mustFail)
{
  static const std::vector<std::uint32_t> counts = { 0x7fffffffU, 0xffffffffU, 0x80000000U,
    0x01000000U, 0x00010000U, 0U };
  static const std::string signs = "{}[]\",:0123456789eE-.ntf\\\0 "; // of JSON
  switch (chance.Below(5))
  {
    case 0:
      mustFail = true;
      return bytes.substr(0, chance.Below(bytes.size()));
    case 1: // bits of the header
      for (std::size_t i = 0; i <= chance.Below(8); ++i)
      {
        char& byte = bytes[chance.Below(header)];
        byte = static_cast<char>(byte ^ (1 << chance.Below(8)));
      }
      return bytes;
    case 2: // bits of the whole file
      for (std::size_t i = 0; i <= chance.Below(8); ++i)
      {
        char& byte = bytes[chance.Below(bytes.size())];
        byte = static_cast<char>(byte ^ (1 << chance.Below(8)));
      }
      return bytes;
    case 3: // the record's text
    {
      const std::size_t from = bytes.find("baseline_version");
      const std::size_t begin = std::min(from, header);
      for (std::size_t i = 0; i <= chance.Below(6); ++i)
      {
        bytes[begin + chance.Below(header - begin)] = signs[chance.Below(signs.size())];
      }
      return bytes;
    }
    default: // counts
      std::memcpy(&bytes[chance.Below(header - 4)], &chance.Of(counts), 4);
      return bytes;
  }
}

//------------------------------------------------------------------------------
// A JSON value of any type.
json MakeValue(Chance& chance)
{
  static const std::vector<json> values = { nullptr, true, -1, 0, 1e308, -1e308, 1e-320,
    std::numeric_limits<std::uint64_t>::max(), "", "12 abc", std::string(70000, 'x'), json::array(),
    json::object(), json::array({ 1, "2", nullptr }), json({ { "name", 3 } }),
    json::array({ 1e308, -1e308, 1e308 }) };
  return chance.Of(values);
}

// Replaces, removes or adds a random value in JSON.
void DamageJSON(json& value, Chance& chance)
{
  if ((value.is_object() || value.is_array()) && !value.empty() && chance.Below(5) > 0)
  {
    auto at = value.begin();
    std::advance(at, chance.Below(value.size()));
    if (chance.Below(6) == 0)
    {
      value.erase(at);
      return;
    }
    DamageJSON(*at, chance);
    return;
  }
  value = MakeValue(chance);
}

// A number for an array of a type; whole numbers are small.
double MakeNumber(int type, Chance& chance)
{
  static const std::vector<double> values = { 0., -1., 1., 3., 1e9, -1e9, 1e30,
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() };
  const double value = chance.Of(values);
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  const double least = type == VTK_UNSIGNED_CHAR ? 0. : -1e9;
  const double most = type == VTK_UNSIGNED_CHAR ? 255. : 1e9;
  // Conversions of larger numbers to whole ones, and of finite ones to float, are undefined.
  const bool fits =
    isReal ? !std::isfinite(value) || std::abs(value) < 1e38 : value >= least && value <= most;
  return fits ? value : 7.;
}

vtkSmartPointer<vtkAbstractArray> MakeArray(vtkIdType tuples, Chance& chance)
{
  if (chance.Below(4) == 0)
  {
    auto strings = vtkSmartPointer<vtkStringArray>::New();
    for (std::size_t i = 0; i < chance.Below(6); ++i)
    {
      strings->InsertNextValue(MakeValue(chance).dump());
    }
    return strings;
  }
  const vtkSmartPointer<vtkDataArray> numbers = vtkDataArray::CreateDataArray(chance.Of(
    std::vector<int>{ VTK_INT, VTK_FLOAT, VTK_DOUBLE, VTK_UNSIGNED_CHAR, VTK_LONG_LONG }));
  numbers->UnRegister(nullptr);
  numbers->SetNumberOfComponents(static_cast<int>(1 + chance.Below(12)));
  numbers->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
    {
      numbers->SetComponent(i, c, MakeNumber(numbers->GetDataType(), chance));
    }
  }
  return numbers;
}

void DamageImage(vtkImageData* image, Chance& chance)
{
  vtkFieldData* field = image->GetFieldData();
  vtkPointData* points = image->GetPointData();
  switch (chance.Below(4))
  {
    case 0: // a record of another type
    case 1: // a layer of another type
    {
      vtkFieldData* data = chance.Below(2) == 0 ? field : points;
      vtkAbstractArray* old = data->GetAbstractArray(
        static_cast<int>(chance.Below(std::size_t(data->GetNumberOfArrays()))));
      if (!old) // none is left
      {
        return;
      }
      const std::string name = old->GetName();
      data->RemoveArray(name.c_str());
      if (chance.Below(4) > 0)
      {
        const vtkIdType count = data == points && chance.Below(3) > 0 ? image->GetNumberOfPoints()
                                                                      : vtkIdType(chance.Below(40));
        const vtkSmartPointer<vtkAbstractArray> array = MakeArray(count, chance);
        array->SetName(name.c_str());
        data->AddArray(array);
      }
      return;
    }
    case 2: // values of a layer
    {
      vtkDataArray* array =
        points->GetArray(static_cast<int>(chance.Below(std::size_t(points->GetNumberOfArrays()))));
      const vtkIdType count = array ? array->GetNumberOfTuples() : 0;
      for (vtkIdType i = 0; i < std::min<vtkIdType>(count, 50); ++i)
      {
        const auto place = vtkIdType(chance.Below(std::size_t(count)));
        array->SetComponent(place, 0, MakeNumber(array->GetDataType(), chance));
      }
      return;
    }
    default: // a value of the record
    {
      const std::vector<const char*> names = { "objects", "volumes", "overlays", "lights",
        "settings", "versions" };
      auto* array = vtkStringArray::SafeDownCast(field->GetAbstractArray(chance.Of(names)));
      for (std::size_t i = 0; i <= chance.Below(4) && array && array->GetNumberOfValues() > 0; ++i)
      {
        const auto place = vtkIdType(chance.Below(std::size_t(array->GetNumberOfValues())));
        json value = json::parse(array->GetValue(place), nullptr, false);
        value.is_discarded() ? void(value = MakeValue(chance)) : DamageJSON(value, chance);
        array->SetValue(place, value.dump());
      }
    }
  }
}

//------------------------------------------------------------------------------
compareTest::Boxes MakeBoxes()
{
  compareTest::Boxes boxes = compareTest::MakeBoxes();
  boxes.Width = 40;
  boxes.Height = 30;
  boxes.All[3].Translucent = true;
  boxes.All[1].More =
    R"(, "color": [1, 0, 0], "clipping": [[0, 0, 0, 1, 0, 0]], "normal_map": true, "glyphs": "1",)"
    R"( "blocks": [{"block": 1, "name": "hub", "visible": false, "color": [1, 0, 0]}])";
  boxes.Overlays = { R"({"kind": "text", "text": "12 %", "place": [0, 0, 1, 1]})" };
  boxes.Volumes = {
    R"({"visible": true, "array": "a", "data": "1", "matrix": [1], "bounds": [0, 1, 0, 1, 0, 1]})"
  };
  boxes.Settings.insert(boxes.Settings.end(), { "multisamples=4", "ambient:samples=16" });
  return boxes;
}

// Compares a damaged frame with the whole one, in both roles. Returns how many comparisons refused.
int CompareDamaged(vtkImageData* damaged, vtkImageData* whole)
{
  int refused = 0;
  for (const bool isBaseline : { true, false })
  {
    vtkNew<vtkRelievoFrameComparison> comparison;
    const vtkNew<vtkCallbackCommand> silent;
    comparison->AddObserver(vtkCommand::ErrorEvent, silent);
    comparison->SetBaseline(isBaseline ? damaged : whole);
    comparison->SetFrame(isBaseline ? whole : damaged);
    if (!comparison->Compare())
    {
      RELIEVO_CHECK(!comparison->GetFailureText().empty() && !comparison->GetAlike());
      ++refused;
      continue;
    }
    RELIEVO_CHECK(json::parse(comparison->GetJSON())["size"].size() == 2);
    RELIEVO_CHECK(!comparison->GetText().empty());
    vtkNew<vtkRelievoComparisonReport> report;
    report->Add("damaged", comparison);
    RELIEVO_CHECK(report->GetHTML().size() > 1000 && !report->GetMarkdown().empty());
  }
  return refused;
}

//------------------------------------------------------------------------------
// Compares damaged baselines, and returns how many comparisons were refused.
int CompareAll(int first, int count)
{
  const vtkSmartPointer<vtkImageData> whole = compareTest::Draw(MakeBoxes());
  const std::string path = relievoTest::OutputFolder() + "/damaged.exr";
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(whole);
  RELIEVO_CHECK(writer->Write() == 1);
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes(
    (std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::size_t header = GetHeaderSize(bytes);
  int refused = 0;
  for (int seed = first; seed < first + count; ++seed)
  {
    const int failures = relievoTest::NumberOfFailures();
    Chance chance(seed);
    if (seed % 2 == 0)
    {
      bool mustFail = false;
      std::ofstream(path, std::ios::binary) << DamageFile(bytes, header, chance, mustFail);
      vtkNew<vtkRelievoFrameComparison> comparison;
      const vtkNew<vtkCallbackCommand> silent;
      comparison->AddObserver(vtkCommand::ErrorEvent, silent);
      if (comparison->ReadFrame(path.c_str()))
      {
        RELIEVO_CHECK(!mustFail);
        refused += CompareDamaged(comparison->GetFrame(), whole);
      }
      else
      {
        RELIEVO_CHECK(comparison->GetFailureText().find("damaged.exr") != std::string::npos);
        ++refused;
      }
    }
    else
    {
      const vtkSmartPointer<vtkImageData> damaged = compareTest::Draw(MakeBoxes());
      for (std::size_t i = 0; i <= chance.Below(3); ++i)
      {
        DamageImage(damaged, chance);
      }
      refused += CompareDamaged(damaged, whole);
    }
    if (relievoTest::NumberOfFailures() != failures)
    {
      std::cerr << "seed " << seed << "\n";
    }
  }
  return refused;
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testDamagedBaselines)
{
  setenv("RELIEVO_READ_HERE", "1", 1); // crashes of the reader are to be seen
  relievoTest::Session session;
  const bool isLong = relievoTest::IsLong(argc, argv);
  const bool isOne = argc > 1 && !isLong;
  const int count = isOne ? 1 : isLong ? Many : Usual;
  const int refused = CompareAll(isOne ? std::atoi(argv[1]) : 0, count);
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  RELIEVO_CHECK_AT_MOST(used.ru_maxrss / 1024, MostMemory, "MiB of memory");
  RELIEVO_CHECK_THAT(isOne || refused > count / 8, std::to_string(refused) + " refused");
  return session.Result();
}
}
