// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// relievo-compare-images and the script behind update-baselines, run as by a user.
//   testImageTools PROGRAM CMAKE SCRIPT
#include "Check.h"
#include "ImageCompare.h"
#include "Session.h"
#include "TestCase.h"

#include <vtkImageData.h>

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/wait.h>

namespace testImageTools
{
namespace
{
std::string Folder;

// Exit status of a command; its output goes to `log` in the folder.
int Run(const std::string& command)
{
  const int status = std::system((command + " >'" + Folder + "/log' 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool LogHolds(const std::string& text)
{
  std::ifstream stream(Folder + "/log");
  const std::string log((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  return log.find(text) != std::string::npos;
}

std::string Write(const std::string& name, int width, int level)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, 10, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill(pixels, pixels + width * 10 * 3, static_cast<unsigned char>(level));
  const std::string path = Folder + "/" + name;
  RELIEVO_CHECK(relievoTest::WriteImage(path, image));
  return path;
}

void TestCommand(const std::string& program)
{
  const std::string a = Write("a.png", 20, 100);
  const std::string near = Write("near.png", 20, 104);
  const std::string far = Write("far.png", 20, 96 - 10);
  const std::string wide = Write("wide.png", 21, 100);
  std::ofstream(Folder + "/text.png") << "no picture";

  RELIEVO_CHECK(Run(program + " " + a + " " + a) == 0 && LogHolds("same"));
  RELIEVO_CHECK(Run(program + " " + a + " " + near) == 1 && LogHolds("mean 4/255"));
  RELIEVO_CHECK(Run(program + " " + a + " " + near + " --mean 4") == 0);
  RELIEVO_CHECK(Run(program + " " + a + " " + far + " --mean 255") == 1 && LogHolds("100 %"));
  RELIEVO_CHECK(Run(program + " " + a + " " + far + " --mean 255 --max-share 1") == 0);
  RELIEVO_CHECK(Run(program + " " + a + " " + far + " --mean 255 --threshold 14") == 0);
  RELIEVO_CHECK(Run(program + " " + a + " " + wide) == 1 && LogHolds("sizes differ"));
  RELIEVO_CHECK(Run(program + " " + a + " " + far + " --output " + Folder) == 1);
  RELIEVO_CHECK(vtksys::SystemTools::FileExists(Folder + "/a.difference.png", true));

  const auto refuses = [&](const std::string& words, const std::string& text) {
    return Run(program + " " + words) == 2 && LogHolds(text);
  };
  RELIEVO_CHECK(refuses(a, "two images are needed"));
  RELIEVO_CHECK(refuses(a + " " + Folder + "/none.png", "there is no file " + Folder));
  RELIEVO_CHECK(refuses(a + " " + Folder + "/text.png", "text.png is not a PNG image"));
  RELIEVO_CHECK(refuses(a + " " + a + " --mena 3", "unknown option '--mena'"));
  RELIEVO_CHECK(refuses(a + " " + a + " --mean", "lacks its value"));
  RELIEVO_CHECK(refuses(a + " " + a + " --mean 3x", "not '3x'"));
  RELIEVO_CHECK(refuses(a + " " + a + " --mean nan", "not 'nan'"));
  RELIEVO_CHECK(refuses(a + " " + a + " --max-share 1.5", "from 0 to 1"));
  RELIEVO_CHECK(Run(program + " --help") == 0 && LogHolds("usage:"));
}

void TestUpdate(const std::string& cmake, const std::string& script)
{
  const std::string from = Folder + "/from";
  const std::string to = Folder + "/to";
  vtksys::SystemTools::RemoveADirectory(to);
  vtksys::SystemTools::MakeDirectory(from + "/testOne");
  vtksys::SystemTools::MakeDirectory(from + "/testTwo");
  vtksys::SystemTools::MakeDirectory(to);
  std::ofstream(from + "/testOne/one.actual.png") << "1";
  std::ofstream(from + "/testOne/one.difference.png") << "d";
  std::ofstream(from + "/testTwo/two.actual.png") << "2";
  const std::string command = cmake + " -DFROM=" + from + " -DTO=" + to + " -P " + script;
  const auto there = [&](const char* name) {
    return vtksys::SystemTools::FileExists(to + "/" + name, true);
  };
  RELIEVO_CHECK(Run("RELIEVO_TESTS=Two " + command) == 0);
  RELIEVO_CHECK(there("two.png") && !there("one.png"));
  RELIEVO_CHECK(Run(command) == 0 && LogHolds("2 baseline(s) written"));
  RELIEVO_CHECK(there("one.png") && !there("one.difference.png"));
}
}

//------------------------------------------------------------------------------
RELIEVO_TEST_CASE(testImageTools)
{
  relievoTest::Session session;
  Folder = relievoTest::OutputFolder();
  if (RELIEVO_CHECK(argc == 4))
  {
    TestCommand(argv[1]);
    TestUpdate(argv[2], argv[3]);
  }
  return session.Result();
}
}
