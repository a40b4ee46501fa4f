// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// relievo-fuzz-files: `relievo render` many times in one process, for fuzz.py and the tests of the
// command (tests/apps/cli.py), since starting a process for each picture would take most of the
// time. Each line of the standard input is a JSON list of the arguments of `relievo render`; each
// line of the output is an object with the `status` of the command, the lines that it would `say`,
// and the `certificate`.
#include "Display.h"
#include "Errors.h"
#include "Messages.h"
#include "Options.h"
#include "Outputs.h"
#include "StandardError.h"

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkRelievoScene.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <string>
#include <vector>

namespace
{
// The previous scene's window, which takes long to open, if the new scene sets its size. None if a
// lens sets the size, or OpenGL does not support it: the scene's own window is refused then.
vtkSmartPointer<vtkRenderWindow> Reuse(
  vtkSmartPointer<vtkRenderWindow> window, const std::vector<std::string>& words)
{
  const scene::RenderOptions options = scene::ParseOptions(words);
  if (!window || !options.Lens.empty())
  {
    return nullptr;
  }
  try
  {
    scene::CheckSize(window, options.Size, options.Size);
  }
  catch (const words::WorkError&)
  {
    return nullptr;
  }
  return window;
}

void Say(nlohmann::json& lines, const std::string& before, vtkStringArray* said)
{
  for (vtkIdType i = 0; i < said->GetNumberOfValues(); ++i)
  {
    lines.push_back(before + said->GetValue(i));
  }
}

nlohmann::json Render(const nlohmann::json& words, vtkSmartPointer<vtkRenderWindow>& window)
{
  vtkNew<vtkStringArray> given;
  for (const std::string& word : words.get<std::vector<std::string>>())
  {
    given->InsertNextValue(word);
  }
  vtkNew<vtkRelievoScene> scene;
  nlohmann::json lines = nlohmann::json::array();
  int status = 0;
  if (scene->SetWords(given))
  {
    scene->SetRenderWindow(Reuse(window, words));
    scene->Write();
    if (scene->GetRenderWindow())
    {
      window = scene->GetRenderWindow();
    }
  }
  if (scene->GetFailure() != vtkRelievoScene::NO_FAILURE)
  {
    status = scene->GetFailure() == vtkRelievoScene::USAGE_FAILURE ? 2 : 1;
    lines.push_back(scene->GetFailureText());
  }
  else
  {
    Say(lines, "", scene->GetNotes());
    Say(lines, "warning: ", scene->GetWarnings());
  }
  scene->SetRenderWindow(nullptr);
  try
  {
    reading::Messages::Check("");
  }
  catch (const words::WorkError&) // the failure, which is also an error event
  {
  }
  return { { "status", status }, { "say", lines }, { "certificate", scene->GetCertificate() } };
}
}

int main()
{
  reading::BeProgram();
  reading::Outputs::RemoveAtEnd();
  const reading::Messages::Scope scope;
  vtkSmartPointer<vtkRenderWindow> window;
  for (std::string line; std::getline(std::cin, line);)
  {
    // Names may not be UTF-8.
    std::cout << Render(nlohmann::json::parse(line), window)
                   .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)
              << std::endl;
  }
  return 0;
}
