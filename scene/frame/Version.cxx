// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Version.h"

#include "Display.h"
#include "Errors.h"
#include "Messages.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRelievoLayersStage.h"
#include "vtkRenderWindow.h"
#include "vtkVersion.h"

#include <sstream>

namespace scene
{
namespace
{
// The value of "OpenGL NAME string:  VALUE" in VTK's report.
std::string Find(const std::string& report, const std::string& name)
{
  const std::string key = "OpenGL " + name + " string:";
  const std::string::size_type at = report.find(key);
  if (at == std::string::npos)
  {
    return "unknown";
  }
  const std::string::size_type begin = report.find_first_not_of(' ', at + key.size());
  return report.substr(begin, report.find('\n', begin) - begin);
}

//------------------------------------------------------------------------------
// OpenGL's own strings, and properties found by tests: a line each.
std::string DescribeOpenGL()
{
  vtkNew<vtkRenderWindow> any;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(any);
  if (!window)
  {
    return std::string("OpenGL unknown: VTK draws in a ") + any->GetClassName() + "\n";
  }
  try
  {
    CheckDisplay(window);
    window->SetOffScreenRendering(1);
    window->SetSize(1, 1);
    window->Initialize();
    Messages::Check("OpenGL");
  }
  catch (const WorkError& error)
  {
    return std::string("OpenGL unknown: ") + error.what() + "\n";
  }
  const std::string report = window->ReportCapabilities();
  std::ostringstream lines;
  lines << "OpenGL " << Find(report, "version") << "\n";
  lines << "  vendor " << Find(report, "vendor") << "\n";
  lines << "  renderer " << Find(report, "renderer") << "\n";
  lines << "  numbers of primitives " << vtkRelievoLayersStage::ProbePrimitiveIds(window) << "\n";
  return lines.str();
}
}

//------------------------------------------------------------------------------
std::string DescribeVersions()
{
  const Messages::Scope scope;
  std::ostringstream lines;
  lines << "relievo " << RELIEVO_VERSION << "\n";
  lines << "VTK " << vtkVersion::GetVTKVersion() << "\n";
  lines << DescribeOpenGL();
  return lines.str();
}

//------------------------------------------------------------------------------
std::vector<std::string> ListVersions(vtkRenderWindow* window)
{
  const std::string report = window->ReportCapabilities();
  return { std::string("relievo ") + RELIEVO_VERSION,
    std::string("VTK ") + vtkVersion::GetVTKVersion(),
    "OpenGL " + Find(report, "renderer") + ", " + Find(report, "version") };
}
}
