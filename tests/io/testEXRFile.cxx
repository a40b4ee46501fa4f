// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of vtkRelievoEXRWriter, read by OpenEXR itself instead of our reader.
#include "ImageTools.h"

#include "Check.h"
#include "Session.h"
#include "TestCase.h"
#include "vtkRelievoEXRWriter.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <algorithm>
#include <cmath>

namespace testEXRFile
{
namespace
{
std::string File()
{
  return relievoTest::OutputFolder() + "/file.exr";
}

// A channel of the file, line by line from the top.
std::vector<float> Floats(Imf::InputFile& file, const char* channel)
{
  const Imath::Box2i window = file.header().dataWindow();
  const int width = window.max.x - window.min.x + 1;
  std::vector<float> pixels(width * (window.max.y - window.min.y + 1));
  Imf::FrameBuffer buffer;
  buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, pixels.data(), window));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return pixels;
}

std::vector<unsigned int> Uints(Imf::InputFile& file, const char* channel)
{
  const Imath::Box2i window = file.header().dataWindow();
  const int width = window.max.x - window.min.x + 1;
  std::vector<unsigned int> pixels(width * (window.max.y - window.min.y + 1));
  Imf::FrameBuffer buffer;
  buffer.insert(channel, Imf::Slice::Make(Imf::UINT, pixels.data(), window));
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  return pixels;
}

void TestChannels()
{
  RELIEVO_CHECK(ioTest::Write(ioTest::MakeLayers(5, 4), File()));
  Imf::InputFile file(File().c_str());
  std::string found;
  const char* const types[] = { "UINT", "HALF", "FLOAT" };
  const Imf::ChannelList& channels = file.header().channels();
  for (auto channel = channels.begin(); channel != channels.end(); ++channel)
  {
    found += std::string(channel.name()) + " " + types[channel.channel().type] + "\n";
  }
  const std::string expected = "A FLOAT\nB FLOAT\nG FLOAT\nR FLOAT\n"
                               "U velocity.X FLOAT\nU velocity.Y FLOAT\nU velocity.Z FLOAT\n"
                               "actor.id UINT\n"
                               "albedo.A HALF\nalbedo.B HALF\nalbedo.G HALF\nalbedo.R HALF\n"
                               "block.id UINT\ncell.id UINT\n"
                               "depth.Z FLOAT\n"
                               "geometric_normal.X FLOAT\ngeometric_normal.Y FLOAT\n"
                               "geometric_normal.Z FLOAT\n"
                               "ids.V UINT\nmask.V UINT\n"
                               "normal.X FLOAT\nnormal.Y FLOAT\nnormal.Z FLOAT\n"
                               "p.V FLOAT\n"
                               "position.X FLOAT\nposition.Y FLOAT\nposition.Z FLOAT\n"
                               "range.Z FLOAT\nshadow_0.V FLOAT\n"
                               "stress.tensor.0 FLOAT\nstress.tensor.1 FLOAT\n"
                               "stress.tensor.2 FLOAT\nstress.tensor.3 FLOAT\n"
                               "stress.tensor.4 FLOAT\nstress.tensor.5 FLOAT\n"
                               "uv.X FLOAT\nuv.Y FLOAT\n";
  RELIEVO_CHECK_THAT(found == expected, "channels are:\n" + found);
  RELIEVO_CHECK(file.header().compression() == Imf::ZIP_COMPRESSION);
  RELIEVO_CHECK(file.header().lineOrder() == Imf::INCREASING_Y);
  RELIEVO_CHECK(file.header().dataWindow() == Imath::Box2i(Imath::V2i(0, 0), Imath::V2i(4, 3)));
  RELIEVO_CHECK(file.header().displayWindow() == file.header().dataWindow());
}

// The first line of the file is the top of the picture, which is the last row of the VTK image.
void TestOrientation()
{
  const int width = 6;
  const int height = 40; // more than a chunk
  auto image = ioTest::MakeImage(width, height);
  ioTest::AddArray(
    image, "depth", VTK_FLOAT, 1, [&](int i, int) { return 1000 * (i / width) + i % width; });
  RELIEVO_CHECK(ioTest::Write(image, File()));
  Imf::InputFile file(File().c_str());
  const std::vector<float> lines = Floats(file, "depth.Z");
  RELIEVO_CHECK_NEAR(lines[0], 39000, 0, "upper left pixel");
  RELIEVO_CHECK_NEAR(lines[width - 1], 39005, 0, "upper right pixel");
  RELIEVO_CHECK_NEAR(lines[width * (height - 1)], 0, 0, "lower left pixel");
  bool all = true;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      all = all && lines[y * width + x] == 1000.0f * (height - 1 - y) + x;
    }
  }
  RELIEVO_CHECK(all);
}

void TestPixels()
{
  auto image = ioTest::MakeImage(4, 1);
  const double ids[] = { -1, 0, 7, 2147483647 };
  ioTest::AddArray(image, "actor", VTK_INT, 1, [&](int i, int) { return ids[i]; });
  ioTest::AddArray(image, "depth", VTK_FLOAT, 1,
    [](int i, int) { return i == 0 ? std::numeric_limits<double>::infinity() : i; });
  ioTest::AddArray(
    image, "albedo", VTK_UNSIGNED_CHAR, 3, [](int i, int c) { return i * 85 - (c == 1 && i > 0); });
  ioTest::AddArray(image, "position", VTK_DOUBLE, 3, [](int i, int c) {
    return i == 0 ? 0 : i == 1 ? 100.5 + c : 100.5 + c + 0.25 * i;
  });
  ioTest::AddField(image, "relievo:origin", { 100.5, 101.5, 102.5 });
  RELIEVO_CHECK(ioTest::Write(image, File()));
  Imf::InputFile file(File().c_str());

  const std::vector<unsigned int> actor = Uints(file, "actor.id");
  RELIEVO_CHECK((actor == std::vector<unsigned int>{ 0xffffffffu, 0, 7, 0x7fffffffu }));
  const std::vector<float> depth = Floats(file, "depth.Z");
  RELIEVO_CHECK(std::isinf(depth[0]) && depth[0] > 0 && depth[3] == 3);
  const std::vector<float> red = Floats(file, "albedo.R");
  const std::vector<float> green = Floats(file, "albedo.G");
  RELIEVO_CHECK(red[0] == 0 && red[3] == 1);
  RELIEVO_CHECK_NEAR(red[1], 85 / 255.0, std::ldexp(1.0, -13), "albedo.R of 85");
  RELIEVO_CHECK_NEAR(green[2], 169 / 255.0, std::ldexp(1.0, -12), "albedo.G of 169");
  // Relative to the origin; the background is zero (with a sign that marks it).
  const std::vector<float> x = Floats(file, "position.X");
  const std::vector<float> z = Floats(file, "position.Z");
  RELIEVO_CHECK(x[0] == 0 && std::signbit(x[0]));
  RELIEVO_CHECK(x[1] == 0 && !std::signbit(x[1]));
  RELIEVO_CHECK(x[2] == 0.5f && z[3] == 0.75f);
  const auto* origin = file.header().findTypedAttribute<Imf::V3dAttribute>("relievo:origin");
  RELIEVO_CHECK(origin && origin->value() == Imath::V3d(100.5, 101.5, 102.5));
}

// A point seen by a known camera: VTK's matrices of it are written out by hand here.
void TestCamera()
{
  // Camera at (1, 2, 3), axes as the world's: world to camera is a translation. View angle 90
  // degrees, aspect 1, near 1, far 11: clip = (x, y, -(12 z + 22) / 10, -z) of camera coordinates.
  const std::vector<double> camera = { 1, 0, 0, -1, 0, 1, 0, -2, 0, 0, 1, -3, 0, 0, 0, 1 };
  const std::vector<double> ndc = { 1, 0, 0, -1, 0, 1, 0, -2, 0, 0, -1.2, 3.6 - 2.2, 0, 0, -1, 3 };
  auto image = ioTest::MakeImage(2, 2);
  ioTest::AddArray(image, "depth", VTK_FLOAT, 1, [](int, int) { return 1; });
  ioTest::AddField(image, "worldToCamera", camera);
  ioTest::AddField(image, "worldToNDC", ndc);
  ioTest::AddField(image, "near", { 0.1 });
  ioTest::AddField(image, "far", { 11 });
  ioTest::AddField(image, "relievo:origin", { 5e5, 5e6, 0.1 });
  ioTest::AddStrings(image, "lights", { "sun {1}", "spot {2}" });
  RELIEVO_CHECK(ioTest::Write(image, File()));
  Imf::InputFile file(File().c_str());
  const Imf::Header& header = file.header();

  RELIEVO_CHECK(Imf::hasWorldToCamera(header) && Imf::hasWorldToNDC(header));
  // 4 to the right, 2 down and 10 ahead of the camera.
  const Imath::V3f world(5, 0, -7);
  const Imath::V3f seen = world * Imf::worldToCamera(header);
  RELIEVO_CHECK_NEAR(seen.x, 4, 1e-6, "x in OpenEXR's camera");
  RELIEVO_CHECK_NEAR(seen.y, -2, 1e-6, "y in OpenEXR's camera");
  RELIEVO_CHECK_NEAR(seen.z, 10, 1e-6, "z in OpenEXR's camera, which looks along +z");
  // Right of the middle by 4 in 10 half widths, below it by 2 in 10: y down, 0 to 1.
  const Imath::V3f picture = world * Imf::worldToNDC(header);
  RELIEVO_CHECK_NEAR(picture.x, 0.7, 1e-6, "x in OpenEXR's NDC");
  RELIEVO_CHECK_NEAR(picture.y, 0.6, 1e-6, "y in OpenEXR's NDC");

  const auto* exact = header.findTypedAttribute<Imf::M44dAttribute>("relievo:worldToNDC");
  RELIEVO_CHECK(exact && std::equal(ndc.begin(), ndc.end(), exact->value()[0]));
  const auto* near = header.findTypedAttribute<Imf::FloatAttribute>("near");
  const auto* exactNear = header.findTypedAttribute<Imf::DoubleAttribute>("relievo:near");
  RELIEVO_CHECK(near && near->value() == 0.1f && exactNear && exactNear->value() == 0.1);
  RELIEVO_CHECK(header.findTypedAttribute<Imf::FloatAttribute>("far")->value() == 11.0f);
  const auto* origin = header.findTypedAttribute<Imf::V3dAttribute>("relievo:origin");
  RELIEVO_CHECK(origin && origin->value() == Imath::V3d(5e5, 5e6, 0.1));
  const auto* light = header.findTypedAttribute<Imf::StringAttribute>("relievo:light_1");
  RELIEVO_CHECK(light && light->value() == "spot {2}");
  RELIEVO_CHECK(header.find("relievo:light_2") == header.end());
}

void TestChoices()
{
  auto image = ioTest::MakeImage(3, 3);
  ioTest::AddArray(image, "normal", VTK_FLOAT, 3, [](int i, int c) { return i + c; });
  ioTest::AddArray(image, "cell", VTK_INT, 1, [](int i, int) { return i; });
  ioTest::AddField(image, "title", { 3 });
  const char* const names[] = { "none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa",
    "dwab" };
  relievoTest::ExpectMessage expect("normal.Y"); // of DWA
  for (int i = 0; i < 10; ++i)
  {
    vtkNew<vtkRelievoEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(File().c_str());
    writer->SetCompression(i);
    RELIEVO_CHECK(std::string(writer->GetCompressionName()) == names[i]);
    writer->SetPixelType("normal", vtkRelievoEXRWriter::HALF);
    writer->SetPixelType("normal.Z", vtkRelievoEXRWriter::FLOAT);
    writer->SetStringAttribute("title", "a picture"); // before the field data's number
    writer->SetDoubleAttribute("exposure", 0.1);
    RELIEVO_CHECK(writer->GetPixelType("normal") == vtkRelievoEXRWriter::HALF);
    RELIEVO_CHECK(writer->GetPixelType("cell") == -1);
    RELIEVO_CHECK(writer->Write() == 1);
    Imf::InputFile file(File().c_str());
    const Imf::Header& header = file.header();
    RELIEVO_CHECK(header.compression() == static_cast<Imf::Compression>(i));
    RELIEVO_CHECK(header.channels()["normal.X"].type == Imf::HALF);
    RELIEVO_CHECK(header.channels()["normal.Z"].type == Imf::FLOAT);
    RELIEVO_CHECK(header.channels()["cell.id"].type == Imf::UINT);
    const auto* title = header.findTypedAttribute<Imf::StringAttribute>("title");
    RELIEVO_CHECK(title && title->value() == "a picture");
    const auto* exposure = header.findTypedAttribute<Imf::DoubleAttribute>("exposure");
    RELIEVO_CHECK(exposure && exposure->value() == 0.1);
  }
}

// A picture that is written twice gives the same bytes.
void TestSameBytes()
{
  auto image = ioTest::MakeLayers(33, 20);
  RELIEVO_CHECK(ioTest::Write(image, File()));
  const std::string first = ioTest::Bytes(File());
  RELIEVO_CHECK(ioTest::Write(image, File()));
  RELIEVO_CHECK(!first.empty() && first == ioTest::Bytes(File()));
}
}

RELIEVO_TEST_CASE(testEXRFile)
{
  relievoTest::Session session;
  TestChannels();
  TestOrientation();
  TestPixels();
  TestCamera();
  TestChoices();
  TestSameBytes();
  return session.Result();
}
}
