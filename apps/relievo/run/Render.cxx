// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render.h"

#include "Messages.h"
#include "SceneWork.h"

#include "vtkNew.h"

#include <cstdio>

namespace cli
{
//------------------------------------------------------------------------------
void Render(const std::vector<std::string>& words)
{
  const scene::Messages::Scope scope;
  vtkNew<vtkRelievoScene> scene;
  SetWords(scene, words);
  {
    const SceneSteps steps(scene);
    const bool done = scene->Write();
    CheckDone(done, scene->GetFailure(), scene->GetFailureText());
  }
  if (!scene->GetCertificate().empty())
  {
    std::printf("relievo: certified shadows: %s\n", scene->GetCertificate().c_str());
  }
  PrintMessages(scene);
}
}
