// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoImageFile reports the error in a file: missing, a folder, not to be opened, cut. From
// memory it reads the output of VTK's writers, and TGA if the name says so; colours of 16 bits and
// of light are those of the formulas. tests/python/testImageFiles.py has all kinds of each format.
#include "Check.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkBMPWriter.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkImageReader2Factory.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkRelievoImageFile.h>
#include <vtkSmartPointer.h>
#include <vtkTIFFWriter.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace testImageFile
{
namespace
{
void Refuses(const std::string& path, const std::string& says)
{
  std::string failure;
  const auto image = vtkRelievoImageFile::Read(path, failure);
  RELIEVO_CHECK_THAT(!image, path + " is read");
  RELIEVO_CHECK_THAT(failure.find(says) != std::string::npos, path + ": " + failure);
}

void WriteImage(const std::string& path)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(30, 20, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::memset(image->GetScalarPointer(), 100, 30 * 20 * 3);
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}

template <typename Writer>
std::string MakeBytes(vtkImageData* image)
{
  const std::string path = "written";
  vtkNew<Writer> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void Decodes(const std::string& bytes, const std::string& name, vtkImageData* expected, double most)
{
  std::string failure;
  const auto image = vtkRelievoImageFile::Decode(bytes.data(), bytes.size(), name, failure);
  if (!RELIEVO_CHECK_THAT(image && failure.empty(), name + ": " + failure))
  {
    return;
  }
  vtkDataArray* got = image->GetPointData()->GetScalars();
  vtkDataArray* known = expected->GetPointData()->GetScalars();
  RELIEVO_CHECK(got->GetDataType() == known->GetDataType());
  if (RELIEVO_CHECK(got->GetNumberOfValues() == known->GetNumberOfValues()))
  {
    double off = 0.;
    for (vtkIdType i = 0; i < got->GetNumberOfValues(); ++i)
    {
      off = std::max(
        off, std::abs(got->GetVariantValue(i).ToDouble() - known->GetVariantValue(i).ToDouble()));
    }
    RELIEVO_CHECK_AT_MOST(off, most, name + ": values");
  }
}

// Rows of a slope; of 8 or of 16 bits.
vtkSmartPointer<vtkImageData> MakeSlope(int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(16, 10, 1);
  image->AllocateScalars(type, 3);
  for (int i = 0; i < 16 * 10 * 3; ++i)
  {
    const int value = 20 + i % 48 + 9 * (i / 48);
    image->SetScalarComponentFromDouble(
      i / 3 % 16, i / 48, 0, i % 3, type == VTK_UNSIGNED_CHAR ? value : 257 * value);
  }
  return image;
}

void TestMemory()
{
  const auto bytes = MakeSlope(VTK_UNSIGNED_CHAR);
  const auto shorts = MakeSlope(VTK_UNSIGNED_SHORT);
  Decodes(MakeBytes<vtkPNGWriter>(bytes), "of PNG", bytes, 0.);
  Decodes(MakeBytes<vtkPNGWriter>(shorts), "of PNG, 16 bits", shorts, 0.);
  Decodes(MakeBytes<vtkBMPWriter>(bytes), "of BMP", bytes, 0.);
  Decodes(MakeBytes<vtkTIFFWriter>(bytes), "of TIFF", bytes, 0.);
  Decodes(MakeBytes<vtkJPEGWriter>(bytes), "of JPEG", bytes, 12.);
  std::string tga(18, '\0');
  tga[2] = 2;
  tga[12] = 16;
  tga[14] = 10;
  tga[16] = 24;
  const auto* texels = static_cast<const char*>(bytes->GetScalarPointer());
  for (int i = 0; i < 16 * 10; ++i)
  {
    tga += { texels[3 * i + 2], texels[3 * i + 1], texels[3 * i] };
  }
  for (const char* name : { "a.TGA", "image/x-tga", "tga" })
  {
    Decodes(tga, name, bytes, 0.);
  }
  std::string failure;
  RELIEVO_CHECK(!vtkRelievoImageFile::Decode(tga.data(), tga.size(), "a.png", failure));
  RELIEVO_CHECK(failure.find("its first bytes are of none") != std::string::npos);
  RELIEVO_CHECK(!vtkRelievoImageFile::Decode(tga.data(), 99, "a.tga", failure));
  RELIEVO_CHECK(failure.find("it ends too early") != std::string::npos);
  RELIEVO_CHECK(!vtkRelievoImageFile::Decode(nullptr, 0, "a.png", failure));
  RELIEVO_CHECK(failure.find("it is empty") != std::string::npos);
}

void TestColors()
{
  const auto bytes = MakeSlope(VTK_UNSIGNED_CHAR);
  RELIEVO_CHECK(vtkRelievoImageFile::ToColors(bytes) == bytes);
  const auto same = vtkRelievoImageFile::ToColors(MakeSlope(VTK_UNSIGNED_SHORT));
  vtkNew<vtkImageData> light;
  light->SetDimensions(4, 1, 1);
  light->AllocateScalars(VTK_FLOAT, 4);
  const double values[4] = { -1., 0.2158605, 1., 9. };
  for (int i = 0; i < 4; ++i)
  {
    for (int c = 0; c < 4; ++c)
    {
      light->SetScalarComponentFromDouble(i, 0, 0, c, values[i]);
    }
  }
  const auto shown = vtkRelievoImageFile::ToColors(light);
  const double encoded[4] = { 0., 128., 255., 255. }; // IEC 61966-2-1
  const double alphas[4] = { 0., 55., 255., 255. };
  for (int i = 0; i < 4; ++i)
  {
    RELIEVO_CHECK(shown->GetScalarComponentAsDouble(i, 0, 0, 0) == encoded[i]);
    RELIEVO_CHECK(shown->GetScalarComponentAsDouble(i, 0, 0, 3) == alphas[i]);
    RELIEVO_CHECK(same->GetScalarComponentAsDouble(i, 3, 0, 1) ==
      bytes->GetScalarComponentAsDouble(i, 3, 0, 1));
  }
  RELIEVO_CHECK(!vtkRelievoImageFile::IsCutOut(light) && !vtkRelievoImageFile::IsCutOut(bytes));
  for (int i = 0; i < 4; ++i)
  {
    light->SetScalarComponentFromDouble(i, 0, 0, 3, i % 2);
  }
  RELIEVO_CHECK(vtkRelievoImageFile::IsCutOut(light));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testImageFile)
{
  // The factory keeps its readers, unlike all that is watched from here.
  vtk::TakeSmartPointer(vtkImageReader2Factory::CreateImageReader2FromExtension(".png"));
  relievoTest::Session session;
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("relievo" + std::to_string(getpid()));
  fs::create_directory(folder);
  TestMemory();
  TestColors();
  Refuses(folder / "none.png", "there is no such file");
  Refuses(folder, "it is a folder");

  const std::string good = folder / "good.png";
  WriteImage(good);
  std::string failure;
  RELIEVO_CHECK(vtkRelievoImageFile::Read(good, failure) && failure.empty());

  // An administrator may open any file: so another user tries.
  const bool administrator = geteuid() == 0;
  for (const char* name : { "closed.png", "closed.exr", "closed.bmp" })
  {
    const std::string closed = folder / name;
    fs::copy_file(good, closed);
    fs::permissions(closed, fs::perms::none);
    RELIEVO_CHECK(!administrator || seteuid(65534) == 0);
    Refuses(closed, std::string("it cannot be opened: ") + std::strerror(EACCES));
    RELIEVO_CHECK(!administrator || seteuid(0) == 0);
  }

  const std::string cut = folder / "cut.png";
  fs::copy_file(good, cut);
  fs::resize_file(cut, fs::file_size(cut) / 2);
  Refuses(cut, "it ends too early");
  fs::remove_all(folder);
  return session.Result();
}
}
