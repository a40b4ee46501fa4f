// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneWork.h"

#include "Errors.h"
#include "Messages.h"
#include "StandardError.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <cstdio>

namespace cli
{
namespace
{
void Print(const char* before, const std::string& line)
{
  std::fprintf(reading::StandardError(), "relievo: %s%s\n", before, line.c_str());
}

void Print(const char* before, vtkStringArray* lines)
{
  for (vtkIdType i = 0; i < lines->GetNumberOfValues(); ++i)
  {
    Print(before, lines->GetValue(i));
  }
}
}

//------------------------------------------------------------------------------
SceneSteps::SceneSteps(vtkRelievoScene* scene)
  : Scene(scene)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long, void* self, void* share) {
    static_cast<SceneSteps*>(self)->Show(*static_cast<double*>(share));
  });
  this->Observer = scene->AddObserver(vtkCommand::ProgressEvent, command);
}

//------------------------------------------------------------------------------
SceneSteps::~SceneSteps()
{
  this->Scene->RemoveObserver(this->Observer);
}

//------------------------------------------------------------------------------
void SceneSteps::Show(double share)
{
  const std::string what = this->Scene->GetProgressText();
  if (what != this->What)
  {
    this->What = what;
    this->Shown.Begin(what);
  }
  this->Shown.Update(share);
}

//------------------------------------------------------------------------------
vtkRelievoScene* GetScene()
{
  static vtkRelievoScene* const scene = vtkRelievoScene::New(); // never deleted
  return scene;
}

//------------------------------------------------------------------------------
void CheckDone(bool done, int failure, const std::string& text)
{
  if (!done && failure == vtkRelievoScene::USAGE_FAILURE)
  {
    throw words::UsageError(text);
  }
  if (!done)
  {
    throw words::WorkError(text);
  }
}

//------------------------------------------------------------------------------
void SetWords(vtkRelievoScene* scene, const std::vector<std::string>& words)
{
  vtkNew<vtkStringArray> given;
  for (const std::string& word : words)
  {
    given->InsertNextValue(word);
  }
  const bool done = scene->SetWords(given);
  CheckDone(done, scene->GetFailure(), scene->GetFailureText());
}

//------------------------------------------------------------------------------
void PrintMessages(vtkRelievoScene* scene)
{
  Print("", scene->GetNotes());
  Print("warning: ", scene->GetWarnings());
}

//------------------------------------------------------------------------------
void PrintWarnings()
{
  for (const std::string& warning : reading::Messages::TakeWarnings())
  {
    Print("warning: ", warning);
  }
}
}
