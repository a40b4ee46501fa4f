// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Files that OpenEXR itself wrote, read by vtkRelievoEXRReader: kinds, windows, names, parts.
#include "ForeignFiles.h"
#include "ImageTools.h"

#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoEXRReader.h"

#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <algorithm>

namespace testEXRForeign
{
using Imath::Box2i;
using Imath::V2i;
using ioTest::MakeHeader;

namespace
{
const Box2i Window(V2i(0, 0), V2i(44, 36));

std::string File()
{
  return relievoTest::OutputFolder() + "/foreign.exr";
}

// Whether a component holds the formula's values of a channel, the top line in the last row.
bool Holds(vtkImageData* image, const char* name, int component, int channel, const Box2i& window)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  const int width = window.max.x - window.min.x + 1;
  const int height = window.max.y - window.min.y + 1;
  bool holds = array && array->GetNumberOfTuples() == width * height &&
    component < array->GetNumberOfComponents();
  for (int row = 0; holds && row < height; ++row)
  {
    for (int x = 0; holds && x < width; ++x)
    {
      holds = array->GetComponent(row * width + x, component) ==
        ioTest::Pixel(channel, window.min.x + x, window.max.y - row);
    }
  }
  return holds;
}

// Names, types and components of the point arrays: "depth float 1, ...".
std::string Arrays(vtkImageData* image)
{
  std::string text;
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = image->GetPointData()->GetArray(i);
    text += (i > 0 ? ", " : "") + std::string(array->GetName()) + " " +
      array->GetDataTypeAsString() + " " + std::to_string(array->GetNumberOfComponents());
  }
  return text;
}

void TestScanLines()
{
  for (const Imf::PixelType type : { Imf::UINT, Imf::HALF, Imf::FLOAT })
  {
    for (int c = 0; c < 6; ++c)
    {
      for (const Imf::LineOrder order : { Imf::INCREASING_Y, Imf::DECREASING_Y })
      {
        Imf::Header header =
          MakeHeader(Window, Window, { "Z", "a" }, type, static_cast<Imf::Compression>(c));
        header.lineOrder() = order;
        ioTest::WriteScanLines(File(), header);
        auto image = ioTest::Read(File());
        const std::string expected =
          type == Imf::UINT ? "Z unsigned int 1, a unsigned int 1" : "Z float 1, a float 1";
        RELIEVO_CHECK_THAT(Arrays(image) == expected, Arrays(image));
        RELIEVO_CHECK_THAT(Holds(image, "Z", 0, 0, Window) && Holds(image, "a", 0, 1, Window),
          "type " + std::to_string(type) + ", compression " + std::to_string(c));
      }
    }
  }
}

void TestTiles()
{
  for (const Imf::LevelMode mode : { Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS })
  {
    for (const Imf::LevelRoundingMode rounding : { Imf::ROUND_DOWN, Imf::ROUND_UP })
    {
      for (const int size : { 1, 16, 64 })
      {
        const Box2i window(V2i(-3, 5), V2i(41, 27));
        ioTest::WriteTiles(File(), MakeHeader(window, window, { "B", "G", "R" }, Imf::HALF), size,
          size == 1 ? 9 : size, mode, rounding);
        auto image = ioTest::Read(File());
        RELIEVO_CHECK(Arrays(image) == "color float 3");
        RELIEVO_CHECK_THAT(Holds(image, "color", 0, 2, window) &&
            Holds(image, "color", 1, 1, window) && Holds(image, "color", 2, 0, window),
          "tiles of " + std::to_string(size) + ", level mode " + std::to_string(mode));
      }
    }
  }
}

void TestWindows()
{
  const Box2i display(V2i(-10, -20), V2i(89, 79));
  const Box2i data(V2i(-12, 30), V2i(19, 85));
  ioTest::WriteScanLines(File(), MakeHeader(display, data, { "depth.Z" }));
  auto image = ioTest::Read(File());
  RELIEVO_CHECK(Holds(image, "depth", 0, 0, data));
  const int* extent = image->GetExtent();
  const double* origin = image->GetOrigin();
  RELIEVO_CHECK(extent[0] == 0 && extent[1] == 31 && extent[2] == 0 && extent[3] == 55);
  // Two pixels left of the display window, and below it by six: y counts up from its lower edge.
  RELIEVO_CHECK(origin[0] == -2 && origin[1] == -6 && image->GetSpacing()[0] == 1);
  vtkDataArray* windows = image->GetFieldData()->GetArray("dataWindow");
  RELIEVO_CHECK(windows && windows->GetComponent(0, 0) == -12 && windows->GetComponent(0, 3) == 85);

  // Written again, the windows are kept.
  RELIEVO_CHECK(ioTest::Write(image, File()));
  auto again = ioTest::Read(File());
  RELIEVO_CHECK(Holds(again, "depth", 0, 0, data) && again->GetOrigin()[1] == -6);
}

void TestNames()
{
  Imf::Header header = MakeHeader(Window, Window,
    { "R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "diffuse.R", "diffuse.G", "diffuse.B", "m.V",
      "uv.X", "uv.Y", "T.0", "T.1", "T.2", "T.3", "half.0", "half.1", "depth.Z", "foo.Z", "a.b.V",
      "left", "left.V", ".V", "odd." });
  header.channels().insert("cell.id", Imf::Channel(Imf::UINT));
  header.channels().insert("foo.id", Imf::Channel(Imf::UINT));
  header.channels().insert("block.id", Imf::Channel(Imf::FLOAT));
  header.channels().insert("mixed.X", Imf::Channel(Imf::FLOAT));
  header.channels().insert("mixed.Y", Imf::Channel(Imf::UINT));
  ioTest::WriteScanLines(File(), header);
  auto image = ioTest::Read(File());
  const std::string expected = "color float 4, N float 3, T float 4, a.b float 1, cell int 1, "
                               "depth float 1, diffuse float 3, m float 1, uv float 2, "
                               ".V float 1, Z float 1, block.id float 1, foo.Z float 1, "
                               "foo.id unsigned int 1, half.0 float 1, half.1 float 1, "
                               "left float 1, left.V float 1, "
                               "mixed.X float 1, mixed.Y unsigned int 1, odd. float 1";
  RELIEVO_CHECK_THAT(Arrays(image) == expected, "arrays are: " + Arrays(image));
  RELIEVO_CHECK(image->GetPointData()->GetScalars() == image->GetPointData()->GetArray("color"));
  // In the order of their names, ".V" is 0 and "A" is 1.
  RELIEVO_CHECK(Holds(image, "color", 3, 1, Window) && Holds(image, "color", 2, 2, Window));
  RELIEVO_CHECK(Holds(image, ".V", 0, 0, Window) && Holds(image, "color", 1, 3, Window));
}

void TestIds()
{
  Imf::Header header = MakeHeader(Window, Window, { "actor.id" }, Imf::UINT);
  ioTest::WriteScanLines(File(), header);
  auto image = ioTest::Read(File());
  RELIEVO_CHECK(Arrays(image) == "actor int 1");
  RELIEVO_CHECK(Holds(image, "actor", 0, 0, Window));
}

void TestSelection()
{
  ioTest::WriteScanLines(
    File(), MakeHeader(Window, Window, { "R", "G", "B", "depth.Z", "normal.X" }, Imf::HALF));
  vtkNew<vtkRelievoEXRReader> reader;
  reader->SetFileName(File().c_str());
  reader->UpdateInformation();
  RELIEVO_CHECK(reader->GetNumberOfChannels() == 5);
  RELIEVO_CHECK(std::string(reader->GetChannelName(3)) == "depth.Z");
  RELIEVO_CHECK(reader->GetChannelPixelType(3) == 1);
  RELIEVO_CHECK(!reader->GetChannelName(5) && !reader->GetChannelName(-1));
  RELIEVO_CHECK(reader->GetNumberOfLayers() == 3 && !reader->GetLayerName(3));
  reader->Update();
  RELIEVO_CHECK(Arrays(reader->GetOutput()) == "color float 3, depth float 1, normal.X float 1");
  reader->GetChannelSelection()->DisableAllArrays();
  reader->GetChannelSelection()->EnableArray("depth.Z");
  reader->Update();
  RELIEVO_CHECK(Arrays(reader->GetOutput()) == "depth float 1");
  RELIEVO_CHECK(Holds(reader->GetOutput(), "depth", 0, 3, Window));
  reader->GetChannelSelection()->EnableArray("G");
  reader->Update();
  RELIEVO_CHECK_THAT(
    Arrays(reader->GetOutput()) == "depth float 1, G float 1", Arrays(reader->GetOutput()));
  reader->GetChannelSelection()->DisableAllArrays();
  reader->Update();
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPoints() == 45 * 37);
  RELIEVO_CHECK(Arrays(reader->GetOutput()).empty() && reader->GetErrorCode() == 0);
}

void TestParts()
{
  Imf::Header tiled = MakeHeader(Window, Window, { "depth.Z", "R" }, Imf::HALF);
  tiled.setTileDescription(Imf::TileDescription(16, 16, Imf::MIPMAP_LEVELS));
  Imf::Header other =
    MakeHeader(Window, Box2i(V2i(2, 3), V2i(9, 20)), { "Z" }, Imf::FLOAT, Imf::PIZ_COMPRESSION);
  const Imf::Header color = MakeHeader(Window, Window, { "R", "G", "B" });

  ioTest::WriteParts(File(), { color, tiled });
  auto both = ioTest::Read(File());
  RELIEVO_CHECK_THAT(Arrays(both) == "color float 3, depth float 1, part1.R float 1", Arrays(both));
  RELIEVO_CHECK(Holds(both, "color", 0, 2, Window) && Holds(both, "part1.R", 0, 3, Window) &&
    Holds(both, "depth", 0, 4, Window));

  ioTest::WriteParts(File(), { color, other });
  vtkNew<vtkRelievoEXRReader> reader;
  reader->SetFileName(File().c_str());
  {
    relievoTest::ExpectMessage expect("part 1 ('part1') covers other pixels");
    reader->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  RELIEVO_CHECK(reader->GetErrorCode() == vtkErrorCode::FileFormatError);
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
  RELIEVO_CHECK(reader->GetNumberOfParts() == 2 && !reader->GetPartName(2));
  RELIEVO_CHECK(std::string(reader->GetPartName(1)) == "part1");
  RELIEVO_CHECK(std::string(reader->GetPartType(1)) == "scanlineimage");
  reader->SetPart(1);
  reader->Update();
  RELIEVO_CHECK(reader->GetErrorCode() == 0);
  RELIEVO_CHECK(Holds(reader->GetOutput(), "Z", 0, 3, other.dataWindow()));
  reader->SetPart(0);
  reader->Update();
  RELIEVO_CHECK(Arrays(reader->GetOutput()) == "color float 3");
  reader->SetPart(2);
  relievoTest::ExpectMessage expect("it has 2 part(s), but part 2 is asked for");
  reader->Update();
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
}

// Names of parts that differ only behind a zero byte are one name to VTK.
void TestPartNames()
{
  const Imf::Header header = MakeHeader(Window, Window, { "Z" });
  ioTest::WriteParts(File(), { header, header, header });
  std::string bytes = ioTest::Bytes(File());
  bytes[bytes.find("part1") + 2] = 0;
  bytes[bytes.find("part2") + 2] = 0;
  ioTest::WriteBytes(File(), bytes);
  auto image = ioTest::Read(File());
  RELIEVO_CHECK_THAT(Arrays(image) == "Z float 1, pa.Z float 1, pa.pa.Z float 1", Arrays(image));
  RELIEVO_CHECK(Holds(image, "pa.Z", 0, 1, Window) && Holds(image, "pa.pa.Z", 0, 2, Window));
}

void TestRefused()
{
  // Chroma of half resolution in both directions, as in luminance and chroma files.
  const Box2i even(V2i(0, 0), V2i(43, 35));
  Imf::Header header = MakeHeader(even, even, { "Y" }, Imf::HALF);
  header.channels().insert("RY", Imf::Channel(Imf::HALF, 2, 2));
  ioTest::WriteScanLines(File(), header);
  vtkNew<vtkRelievoEXRReader> reader;
  reader->SetFileName(File().c_str());
  {
    relievoTest::ExpectMessage expect("channel 'RY' is subsampled");
    reader->Update();
    RELIEVO_CHECK(expect.Count() == 1);
  }
  RELIEVO_CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
  reader->GetChannelSelection()->DisableArray("RY");
  reader->Update();
  RELIEVO_CHECK(Holds(reader->GetOutput(), "Y", 0, 1, even));

  ioTest::WriteDeep(File(), MakeHeader(Window, Window, { "Z" }));
  relievoTest::ExpectMessage expect("'deepscanline'");
  vtkNew<vtkRelievoEXRReader> deep;
  deep->SetFileName(File().c_str());
  deep->Update();
  RELIEVO_CHECK(expect.Count() == 1);
  RELIEVO_CHECK(deep->GetErrorCode() == vtkErrorCode::FileFormatError);
  RELIEVO_CHECK(deep->GetOutput()->GetNumberOfPoints() == 0);
}

// The standard camera of another program, in OpenEXR's convention, becomes VTK's.
void TestCamera()
{
  Imf::Header header = MakeHeader(Window, Window, { "Z" });
  // Looks along +x of the world from the origin, z up: right is -y.
  Imf::addWorldToCamera(header, Imath::M44f(0, 0, 1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1));
  Imf::addWorldToNDC(header, Imath::M44f(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16));
  header.insert("near", Imf::FloatAttribute(0.5f));
  header.insert("position", Imf::V3fAttribute({ 1, 2, 3 }));
  header.insert("owner", Imf::StringAttribute("somebody"));
  ioTest::WriteScanLines(File(), header);
  auto image = ioTest::Read(File());
  vtkFieldData* fields = image->GetFieldData();
  vtkDataArray* camera = fields->GetArray("worldToCamera");
  RELIEVO_CHECK(camera && camera->GetNumberOfComponents() == 16);
  // VTK: p' = M p, row by row; 3 ahead is z = -3, 1 to the left (+y) is x = -1.
  const double world[4] = { 3, 1, 2, 1 };
  const double expected[4] = { -1, 2, -3, 1 };
  for (int row = 0; row < 4; ++row)
  {
    double sum = 0;
    for (int c = 0; c < 4; ++c)
    {
      sum += camera->GetComponent(0, 4 * row + c) * world[c];
    }
    RELIEVO_CHECK_NEAR(sum, expected[row], 0, "row " + std::to_string(row));
  }
  // x = 2 x' - w, y = w - 2 y': from the first column of the row-vector matrix.
  vtkDataArray* ndc = fields->GetArray("worldToNDC");
  RELIEVO_CHECK(
    ndc && ndc->GetComponent(0, 0) == 2 * 1 - 4 && ndc->GetComponent(0, 4) == 4 - 2 * 2);
  RELIEVO_CHECK(ndc->GetComponent(0, 8) == 3 && ndc->GetComponent(0, 12) == 4);
  RELIEVO_CHECK(fields->GetArray("near")->GetComponent(0, 0) == 0.5);
  RELIEVO_CHECK(fields->GetArray("position")->GetComponent(0, 2) == 3);
  RELIEVO_CHECK(fields->GetAbstractArray("owner")->GetVariantValue(0).ToString() == "somebody");
}

// Progress rises to 1; the file name alone says whether a file can be read.
void TestManners()
{
  const Box2i large(V2i(0, 0), V2i(1999, 2999));
  ioTest::WriteScanLines(
    File(), MakeHeader(large, large, { "Z" }, Imf::FLOAT, Imf::ZIP_COMPRESSION));
  vtkNew<vtkRelievoEXRReader> reader;
  RELIEVO_CHECK(reader->CanReadFile(File().c_str()) == 1);
  RELIEVO_CHECK(reader->CanReadFile("/no/such/file.exr") == 0);
  RELIEVO_CHECK(reader->CanReadFile(nullptr) == 0);
  reader->SetFileName(File().c_str());
  reader->Update();
  RELIEVO_CHECK(reader->GetProgress() == 1.0);
  RELIEVO_CHECK(Holds(reader->GetOutput(), "Z", 0, 0, large));
}
}

RELIEVO_TEST_CASE(testEXRForeign)
{
  relievoTest::Session session;
  TestScanLines();
  TestTiles();
  TestWindows();
  TestNames();
  TestIds();
  TestSelection();
  TestParts();
  TestPartNames();
  TestRefused();
  TestCamera();
  TestManners();
  return session.Result();
}
}
