// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkRelievoEXRReader reads back files of vtkRelievoEXRWriter bit for bit.
#include "ImageTools.h"

#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoEXRReader.h"
#include "vtkRelievoEXRWriter.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageFlip.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkStringArray.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>
#include <string>

namespace testEXRRoundTrip
{
namespace
{
std::string File()
{
  return relievoTest::OutputFolder() + "/roundtrip.exr";
}

std::string WriteAndCompare(vtkImageData* image)
{
  if (!ioTest::Write(image, File()))
  {
    return "not written";
  }
  return ioTest::Difference(image, ioTest::Read(File()));
}

void CheckSame(vtkImageData* image, const std::string& what)
{
  const std::string difference = WriteAndCompare(image);
  RELIEVO_CHECK_THAT(difference.empty(), what + ": " + difference);
}

void TestCompressions()
{
  // Sizes that are no multiple of any number of lines packed together.
  const int sizes[][2] = { { 37, 61 }, { 1, 1 }, { 300, 1 }, { 1, 300 } };
  for (const auto& size : sizes)
  {
    auto image = ioTest::MakeLayers(size[0], size[1]);
    for (const char* name : { "none", "rle", "zips", "zip", "piz" })
    {
      vtkNew<vtkRelievoEXRWriter> writer;
      writer->SetInputData(image);
      writer->SetFileName(File().c_str());
      RELIEVO_CHECK(writer->SetCompressionByName(name));
      RELIEVO_CHECK(std::string(writer->GetCompressionName()) == name);
      RELIEVO_CHECK(writer->Write() == 1);
      const std::string difference = ioTest::Difference(image, ioTest::Read(File()));
      RELIEVO_CHECK_THAT(difference.empty(), std::string(name) + ": " + difference);
    }
  }
}

// Lossy compression leaves ids and depth alone; DWA takes normal.Y for a luminance, and we say so.
void TestLossyCompressions()
{
  auto image = ioTest::MakeLayers(64, 40);
  relievoTest::ExpectMessage expect("normal.Y, ");
  for (const char* name : { "b44", "b44a", "dwaa", "dwab" })
  {
    vtkNew<vtkRelievoEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(File().c_str());
    writer->SetCompressionByName(name);
    RELIEVO_CHECK(writer->Write() == 1);
    auto back = ioTest::Read(File());
    for (const char* array : { "depth", "range", "actor", "cell", "p", "stress.tensor", "ids" })
    {
      const std::string difference = ioTest::Difference(
        image->GetPointData()->GetArray(array), back->GetPointData()->GetArray(array));
      RELIEVO_CHECK_THAT(difference.empty(), std::string(name) + ": " + difference);
    }
  }
  RELIEVO_CHECK(expect.Count() == 2); // dwaa and dwab
}

// An infinity or NaN comes back as it was, or the file is refused; a finite number beyond those of
// a half is either kept or warned of.
void TestNotFinite()
{
  const double values[] = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e5 };
  const std::set<std::string> ofHalf = { "b44", "b44a" };
  const std::set<std::string> ofColor = { "dwaa", "dwab" };
  int refused = 0;
  for (const char* name :
    { "none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab" })
  {
    for (const char* array : { "depth", "normal", "color" })
    {
      for (const int type : { int(vtkRelievoEXRWriter::FLOAT), int(vtkRelievoEXRWriter::HALF) })
      {
        for (const double value : values)
        {
          const bool half = type == vtkRelievoEXRWriter::HALF;
          if (half && std::isfinite(value))
          {
            continue; // becomes infinite, with a warning of its own
          }
          const std::string which = std::string(name) + " of " + array;
          auto image = ioTest::MakeImage(40, 40);
          auto* layer = ioTest::AddArray(image, array, VTK_FLOAT, array[0] == 'd' ? 1 : 3,
            [&](int i, int) { return i % 7 == 0 ? value : 0.5; });
          const bool lossy =
            (ofHalf.count(name) && half) || (ofColor.count(name) && std::string(array) != "depth");
          ioTest::WriteBytes(File(), "older");
          vtkNew<vtkRelievoEXRWriter> writer;
          writer->SetInputData(image);
          writer->SetFileName(File().c_str());
          writer->SetCompressionByName(name);
          writer->SetPixelType(array, type);
          if (lossy && !std::isfinite(value))
          {
            relievoTest::ExpectMessage expect(
              "'" + std::string(array) + "' holds infinities or NaN");
            RELIEVO_CHECK_THAT(writer->Write() == 0, which);
            RELIEVO_CHECK_THAT(expect.Count() == 1, which);
            RELIEVO_CHECK_THAT(ioTest::Bytes(File()) == "older", which);
            ++refused;
            continue;
          }
          if (lossy)
          {
            relievoTest::ExpectMessage expect("are beyond 65504");
            RELIEVO_CHECK_THAT(writer->Write() == 1, which);
            RELIEVO_CHECK_THAT(expect.Count() == 1, which);
            continue;
          }
          RELIEVO_CHECK_THAT(writer->Write() == 1, which);
          auto back = ioTest::Read(File());
          for (vtkIdType i = 0; i < layer->GetNumberOfTuples(); ++i)
          {
            const double is = back->GetPointData()->GetArray(array)->GetComponent(i, 0);
            const double was = layer->GetComponent(i, 0);
            const bool kept = std::isnan(was) ? std::isnan(is)
              : std::isinf(was)               ? is == was
                                              : std::abs(is - was) < 1e-4 * was;
            RELIEVO_CHECK_THAT(kept, which);
          }
        }
      }
    }
  }
  RELIEVO_CHECK(refused == 2 * 3 * 3 + 2 * 2 * 2 * 3);
}

void TestFields()
{
  auto image = ioTest::MakeLayers(4, 3);
  ioTest::AddField(image, "exposure", { 0.1 });
  ioTest::AddField(image, "wind", { 0.1, 0.2, 0.3 });
  ioTest::AddStrings(image, "owner", { "somebody" });
  ioTest::AddStrings(image, "tags", { "a", "", "b c" });
  RELIEVO_CHECK(ioTest::Write(image, File()));
  auto back = ioTest::Read(File());
  for (const char* name :
    { "worldToCamera", "worldToNDC", "near", "far", "relievo:origin", "exposure", "wind" })
  {
    const std::string difference = ioTest::Difference(
      image->GetFieldData()->GetArray(name), back->GetFieldData()->GetArray(name));
    RELIEVO_CHECK_THAT(difference.empty(), difference);
  }
  for (const char* name : { "lights", "owner", "tags" })
  {
    vtkAbstractArray* a = image->GetFieldData()->GetAbstractArray(name);
    vtkAbstractArray* b = back->GetFieldData()->GetAbstractArray(name);
    bool same = a && b && a->GetNumberOfValues() == b->GetNumberOfValues();
    for (vtkIdType i = 0; same && i < a->GetNumberOfValues(); ++i)
    {
      same = a->GetVariantValue(i) == b->GetVariantValue(i);
    }
    RELIEVO_CHECK_THAT(same, std::string("the strings of ") + name);
  }
}

// Threads change neither the file nor the image. Last, because they remain.
void TestThreads()
{
  auto image = ioTest::MakeLayers(200, 150);
  std::string bytes[2];
  for (const int threads : { 0, 3 })
  {
    vtkNew<vtkRelievoEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(File().c_str());
    writer->SetNumberOfThreads(threads);
    RELIEVO_CHECK(writer->Write() == 1);
    bytes[threads > 0] = ioTest::Bytes(File());
    vtkNew<vtkRelievoEXRReader> reader;
    reader->SetFileName(File().c_str());
    reader->SetNumberOfThreads(threads);
    reader->Update();
    const std::string difference = ioTest::Difference(image, reader->GetOutput());
    RELIEVO_CHECK_THAT(difference.empty(), difference);
  }
  RELIEVO_CHECK(!bytes[0].empty() && bytes[0] == bytes[1]);
}

// Every float there is by its bits, as far as patterns go: signalling NaNs, denormals, -0.
void TestFloatBits()
{
  auto image = ioTest::MakeImage(64, 64);
  auto* array = vtkFloatArray::SafeDownCast(
    ioTest::AddArray(image, "bits", VTK_FLOAT, 1, [](int, int) { return 0; }));
  std::mt19937 random(1);
  for (int i = 0; i < 4096; ++i)
  {
    uint32_t bits = static_cast<uint32_t>(random());
    bits = i % 4 == 0 ? (bits & 0x807fffff) | 0x7f800000 : bits; // NaNs and infinities
    bits = i % 4 == 1 ? bits & 0x807fffff : bits;                // denormals and zeros
    std::memcpy(array->GetPointer(i), &bits, 4);
  }
  CheckSame(image, "float bits");
}

void TestBytes()
{
  auto image = ioTest::MakeImage(256, 1);
  ioTest::AddArray(
    image, "albedo", VTK_UNSIGNED_CHAR, 4, [](int i, int c) { return (i + c) % 256; });
  ioTest::AddArray(image, "color", VTK_UNSIGNED_CHAR, 3, [](int i, int) { return i; });
  for (const int type :
    { vtkRelievoEXRWriter::HALF, vtkRelievoEXRWriter::FLOAT, vtkRelievoEXRWriter::UINT })
  {
    vtkNew<vtkRelievoEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(File().c_str());
    writer->SetPixelType("albedo", type);
    writer->SetPixelType("color", type);
    RELIEVO_CHECK(writer->Write() == 1);
    const std::string difference = ioTest::Difference(image, ioTest::Read(File()));
    RELIEVO_CHECK_THAT(difference.empty(), difference);
  }
}

void TestIntegers()
{
  const int types[] = { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
    VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
    VTK_ID_TYPE };
  auto image = ioTest::MakeImage(8, 2);
  for (const int type : types)
  {
    auto probe = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    const double low = std::max(probe->GetDataTypeMin(), -2147483648.0);
    // 64-bit types that know a sign have the range of int in the file, others that of unsigned int.
    const double high = std::min(probe->GetDataTypeMax(), low < 0 ? 2147483647.0 : 4294967295.0);
    const double values[] = { low, high, low < 0 ? -1.0 : 0.0, 1, 0, high - 1, low + 1, 2 };
    ioTest::AddArray(image, std::string("int") + probe->GetDataTypeAsString(), type, 1,
      [&](int i, int) { return values[i % 8]; });
  }
  ioTest::AddArray(image, "many", VTK_SHORT, 5, [](int i, int c) { return i * c - 20; });
  ioTest::AddArray(image, "actor", VTK_ID_TYPE, 1, [](int i, int) { return i - 1; });
  CheckSame(image, "integers");
}

// position = origin + float, whatever the origin and the float, comes back exactly.
void TestPosition()
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_int_distribution<int> exponent(-12, 7);
  for (int round = 0; round < 200; ++round)
  {
    double origin[3];
    for (double& o : origin)
    {
      o = uniform(random) * std::pow(10.0, exponent(random));
    }
    origin[1] = round % 5 == 0 ? 0.0 : origin[1];
    const double scale = std::pow(10.0, exponent(random));
    auto image = ioTest::MakeImage(16, 16);
    ioTest::AddArray(image, "position", VTK_DOUBLE, 3, [&](int i, int c) {
      const double offset = static_cast<double>(static_cast<float>(scale * uniform(random)));
      return i % 8 == 0                            ? 0.0       // background
        : i % 8 == 1                               ? origin[c] // a surface at the origin
        : i % 8 == 2 && c == 1 && origin[1] == 0.0 ? -0.0
        : i % 8 == 3 && c == 0                     ? std::numeric_limits<double>::infinity()
                                                   : origin[c] + offset;
    });
    ioTest::AddField(image, "relievo:origin", { origin[0], origin[1], origin[2] });
    CheckSame(image, "position, round " + std::to_string(round));
  }
}

void TestPositionWithoutOrigin()
{
  // Floats lose nothing: the origin is 0 and the values are the same.
  auto small = ioTest::MakeImage(5, 5);
  ioTest::AddArray(small, "position", VTK_DOUBLE, 3, [](int i, int c) { return i * 0.25 - c; });
  CheckSame(small, "position that floats hold");
  auto floats = ioTest::MakeImage(5, 5);
  ioTest::AddArray(floats, "position", VTK_FLOAT, 3, [](int i, int c) { return i * 0.1 - c; });
  ioTest::AddField(floats, "relievo:origin", { 500000.1, 0.7, 3 });
  CheckSame(floats, "position of type float");

  // Far away an origin is chosen; the error is a float's relative to the scene's size, 25 here.
  auto large = ioTest::MakeImage(5, 5);
  ioTest::AddArray(large, "position", VTK_DOUBLE, 3,
    [](int i, int c) { return i == 0 ? 0.0 : 5e6 + i * 1.1 + 0.1 * c; });
  RELIEVO_CHECK(ioTest::Write(large, File()));
  auto back = ioTest::Read(File());
  double worst = 0;
  for (int i = 0; i < 25; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      worst = std::max(worst,
        std::abs(large->GetPointData()->GetArray("position")->GetComponent(i, c) -
          back->GetPointData()->GetArray("position")->GetComponent(i, c)));
    }
  }
  RELIEVO_CHECK_AT_MOST(worst, 14 * 6e-8, "position at 5e6 without an origin, absolute error");
  RELIEVO_CHECK(back->GetPointData()->GetArray("position")->GetComponent(0, 0) == 0);
}

void TestHalf()
{
  auto image = ioTest::MakeImage(8, 8);
  ioTest::AddArray(image, "depth", VTK_FLOAT, 1, [](int i, int) { return i * 0.125; }); // halfs
  ioTest::AddArray(image, "normal", VTK_FLOAT, 3, [](int i, int c) { return std::sin(i + c); });
  ioTest::AddArray(image, "cell", VTK_INT, 1, [](int i, int) { return i - 1; });
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(File().c_str());
  writer->SetPixelType("depth", vtkRelievoEXRWriter::HALF);
  writer->SetPixelType("normal.Y", vtkRelievoEXRWriter::HALF);
  writer->SetPixelType("cell", vtkRelievoEXRWriter::HALF);
  RELIEVO_CHECK(writer->Write() == 1);
  vtkNew<vtkRelievoEXRReader> reader;
  reader->SetFileName(File().c_str());
  reader->Update();
  vtkPointData* points = reader->GetOutput()->GetPointData();
  for (const char* exact : { "depth", "cell" })
  {
    const std::string difference =
      ioTest::Difference(image->GetPointData()->GetArray(exact), points->GetArray(exact));
    RELIEVO_CHECK_THAT(difference.empty(), difference);
  }
  double worst[3] = { 0, 0, 0 };
  for (int i = 0; i < 64; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      worst[c] = std::max(worst[c],
        std::abs(points->GetArray("normal")->GetComponent(i, c) -
          image->GetPointData()->GetArray("normal")->GetComponent(i, c)));
    }
  }
  RELIEVO_CHECK(worst[0] == 0 && worst[2] == 0 && worst[1] > 0);
  RELIEVO_CHECK_AT_MOST(worst[1], std::ldexp(1.0, -12), "normal.Y as half");
}

// Halfs end at 65504: the writer says so, and writes infinity.
void TestOverflow()
{
  auto image = ioTest::MakeImage(2, 1);
  ioTest::AddArray(image, "depth", VTK_FLOAT, 1, [](int i, int) { return i == 0 ? 1 : 70000; });
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(File().c_str());
  writer->SetPixelType("depth", vtkRelievoEXRWriter::HALF);
  {
    relievoTest::ExpectMessage expect("70000");
    RELIEVO_CHECK(writer->Write() == 1);
    RELIEVO_CHECK(expect.Count() == 1);
  }
  auto back = ioTest::Read(File());
  RELIEVO_CHECK(std::isinf(back->GetPointData()->GetArray("depth")->GetComponent(1, 0)));
}

void TestOtherArrays()
{
  // Component by component in memory, and an input that comes through a pipeline.
  auto image = ioTest::MakeImage(3, 4);
  vtkNew<vtkSOADataArrayTemplate<float>> array;
  array->SetName("soa");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(12);
  for (int i = 0; i < 36; ++i)
  {
    array->SetComponent(i / 3, i % 3, i * 0.3);
  }
  image->GetPointData()->AddArray(array);
  auto expected = ioTest::MakeImage(3, 4);
  ioTest::AddArray(expected, "soa", VTK_FLOAT, 3, [](int i, int c) { return (3 * i + c) * 0.3; });
  RELIEVO_CHECK(ioTest::Write(image, File()));
  std::string difference = ioTest::Difference(expected, ioTest::Read(File()));
  RELIEVO_CHECK_THAT(difference.empty(), difference);

  expected->GetPointData()->SetActiveScalars("soa");
  vtkNew<vtkImageFlip> flip;
  flip->SetInputData(expected);
  flip->SetFilteredAxis(1);
  vtkNew<vtkRelievoEXRWriter> writer;
  writer->SetInputConnection(flip->GetOutputPort());
  writer->SetFileName(File().c_str());
  RELIEVO_CHECK(writer->Write() == 1);
  difference = ioTest::Difference(flip->GetOutput(), ioTest::Read(File()));
  RELIEVO_CHECK_THAT(difference.empty(), difference);
  RELIEVO_CHECK(flip->GetOutput()->GetPointData()->GetArray("soa")->GetComponent(0, 0) > 8);
}

// The comparison itself sees one wrong bit.
void TestComparison()
{
  auto image = ioTest::MakeLayers(4, 4);
  RELIEVO_CHECK(ioTest::Write(image, File()));
  auto* normal = vtkFloatArray::SafeDownCast(image->GetPointData()->GetArray("normal"));
  normal->SetValue(17, std::nextafter(normal->GetValue(17), 9.0f));
  RELIEVO_CHECK(!ioTest::Difference(image, ioTest::Read(File())).empty());
}

// The camera belongs to the whole image: it is not cut into pieces.
void TestPieces()
{
  auto image = ioTest::MakeLayers(40, 30);
  RELIEVO_CHECK(ioTest::Write(image, File()));
  for (const int piece : { 0, 1, 2 })
  {
    vtkNew<vtkRelievoEXRReader> reader;
    reader->SetFileName(File().c_str());
    reader->UpdatePiece(piece, 3, 0);
    RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPoints() == (piece == 0 ? 1200 : 0));
    RELIEVO_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
  }
}
}

RELIEVO_TEST_CASE(testEXRRoundTrip)
{
  relievoTest::Session session;
  TestCompressions();
  TestLossyCompressions();
  TestNotFinite();
  TestFields();
  TestFloatBits();
  TestBytes();
  TestIntegers();
  TestPosition();
  TestPositionWithoutOrigin();
  TestHalf();
  TestOverflow();
  TestOtherArrays();
  TestComparison();
  TestThreads();
  TestPieces();
  return session.Result();
}
}
