// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkRelievoImageFile says what is wrong with a file: missing, a folder, not to be opened, cut.
#include "Check.h"
#include "Session.h"

#include <vtkImageData.h>
#include <vtkImageReader2.h>
#include <vtkImageReader2Factory.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRelievoImageFile.h>
#include <vtkSmartPointer.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <unistd.h>

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
}

//------------------------------------------------------------------------------
int main()
{
  // The factory keeps its readers, unlike all that is watched from here.
  vtk::TakeSmartPointer(vtkImageReader2Factory::CreateImageReader2FromExtension(".png"));
  relievoTest::Session session;
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("relievo" + std::to_string(getpid()));
  fs::create_directory(folder);
  Refuses(folder / "none.png", "there is no such file");
  Refuses(folder, "it is a folder");

  const std::string good = folder / "good.png";
  WriteImage(good);
  std::string failure;
  RELIEVO_CHECK(vtkRelievoImageFile::Read(good, failure) && failure.empty());

  // An administrator may open any file: as somebody else, then.
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
