// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// relievo-fuzz-files: `relievo render` many times in one process, for fuzz.py. Each line of the
// standard input is a JSON list of the words behind `relievo render`; each line of the output is an
// object with the `status` of the command and the lines that it would `say`.
#include "Errors.h"
#include "Messages.h"
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

namespace
{
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
  for (const nlohmann::json& word : words)
  {
    given->InsertNextValue(word.get<std::string>());
  }
  vtkNew<vtkRelievoScene> scene;
  nlohmann::json lines = nlohmann::json::array();
  int status = 0;
  if (scene->SetWords(given))
  {
    scene->SetRenderWindow(window);
    scene->Write();
    window = scene->GetRenderWindow(); // which takes long to open
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
    scene::Messages::Check("");
  }
  catch (const scene::WorkError&) // the failure, which is an error event, too
  {
  }
  return { { "status", status }, { "say", lines } };
}
}

int main()
{
  scene::BeProgram();
  scene::Outputs::RemoveAtEnd();
  const scene::Messages::Scope scope;
  vtkSmartPointer<vtkRenderWindow> window;
  for (std::string line; std::getline(std::cin, line);)
  {
    // Names may be no UTF-8.
    std::cout << Render(nlohmann::json::parse(line), window)
                   .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)
              << std::endl;
  }
  return 0;
}
