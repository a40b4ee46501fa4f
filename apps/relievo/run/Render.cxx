// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render.h"

#include "Errors.h"
#include "Messages.h"
#include "Progress.h"
#include "StandardError.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRelievoScene.h"
#include "vtkStringArray.h"

#include <cstdio>

namespace cli
{
namespace
{
// The scene's steps on the error output.
class Steps
{
public:
  explicit Steps(vtkRelievoScene* scene)
    : Scene(scene)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void* share) {
      static_cast<Steps*>(self)->Show(*static_cast<double*>(share));
    });
    this->Observer = scene->AddObserver(vtkCommand::ProgressEvent, command);
  }
  ~Steps() { this->Scene->RemoveObserver(this->Observer); }
  Steps(const Steps&) = delete;
  void operator=(const Steps&) = delete;

private:
  void Show(double share)
  {
    const std::string what = this->Scene->GetProgressText();
    if (what != this->What)
    {
      this->What = what;
      this->Shown.Begin(what);
    }
    this->Shown.Update(share);
  }

  vtkRelievoScene* Scene;
  unsigned long Observer;
  std::string What;
  scene::Progress Shown;
};

void Print(const char* before, vtkStringArray* lines)
{
  for (vtkIdType i = 0; i < lines->GetNumberOfValues(); ++i)
  {
    std::fprintf(scene::StandardError(), "relievo: %s%s\n", before, lines->GetValue(i).c_str());
  }
}
}

//------------------------------------------------------------------------------
void Render(const std::vector<std::string>& words)
{
  vtkNew<vtkStringArray> given;
  for (const std::string& word : words)
  {
    given->InsertNextValue(word);
  }
  const scene::Messages::Scope scope;
  vtkNew<vtkRelievoScene> scene;
  bool done = scene->SetWords(given);
  if (done)
  {
    const Steps steps(scene);
    done = scene->Write();
  }
  if (!done && scene->GetFailure() == vtkRelievoScene::USAGE_FAILURE)
  {
    throw scene::UsageError(scene->GetFailureText());
  }
  if (!done)
  {
    throw scene::WorkError(scene->GetFailureText());
  }
  if (!scene->GetCertificate().empty())
  {
    std::printf("relievo: certified shadows: %s\n", scene->GetCertificate().c_str());
  }
  Print("", scene->GetNotes());
  Print("warning: ", scene->GetWarnings());
}
}
