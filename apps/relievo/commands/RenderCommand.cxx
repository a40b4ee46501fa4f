// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "Messages.h"
#include "Options.h"
#include "SceneWork.h"

#include <cstdio>

namespace cli
{
namespace
{
class RenderCommand : public Command
{
public:
  RenderCommand()
    : Command("render", "", "")
  {
    this->Rows = scene::GetRenderCommand();
  }

  int Run(const std::vector<std::string>& words) override
  {
    const reading::Messages::Scope scope;
    vtkRelievoScene* scene = GetScene();
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
    return 0;
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeRender()
{
  return std::make_unique<RenderCommand>();
}
}
