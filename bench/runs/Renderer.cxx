// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Renderer.h"

#include "vtkRelievoSoftwareOpenGL.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <fstream>
#include <iostream>

namespace relievoBench
{
namespace
{
constexpr char Software[] = "software OpenGL";

std::string PathIn(const std::string& folder)
{
  return folder + "/renderer.txt";
}
}

//------------------------------------------------------------------------------
bool WriteRenderer(const std::string& folder)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(1, 1);
  window->Render();
  std::ofstream file(PathIn(folder), std::ios::binary);
  file << (vtkRelievoIsSoftwareOpenGL() ? Software : FindRenderer(window->ReportCapabilities()))
       << "\n";
  file.close();
  if (!file)
  {
    std::cerr << "relievo: bench: cannot write " << PathIn(folder) << "\n";
  }
  return static_cast<bool>(file);
}

//------------------------------------------------------------------------------
std::string ReadRenderer(const std::string& folder)
{
  std::string name;
  std::ifstream file(PathIn(folder));
  std::getline(file, name);
  return name.empty() ? Software : name;
}

//------------------------------------------------------------------------------
std::string FindRenderer(const std::string& report)
{
  const std::string key = "OpenGL renderer string:";
  const std::size_t at = report.find(key);
  if (at == std::string::npos)
  {
    return {};
  }
  const std::size_t end = report.find('\n', at);
  const std::size_t begin = report.find_first_not_of(' ', at + key.size());
  return begin < end ? report.substr(begin, end - begin) : std::string();
}
}
