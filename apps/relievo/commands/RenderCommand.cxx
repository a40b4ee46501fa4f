// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"
#include "Command.h"
#include "Errors.h"
#include "FrameParts.h"
#include "Messages.h"
#include "Options.h"
#include "SceneWork.h"
#include "Values.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <algorithm>
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
    this->AddPartOption("frames");
    this->Rows.Options.back().OfOutputs = true;
  }

  int Run(const std::vector<std::string>& words) override
  {
    const reading::Messages::Scope scope;
    vtkRelievoScene* scene = GetScene();
    const std::vector<std::string> ofScene = this->TakePart(words);
    if (this->IsPart)
    {
      this->DrawPart(scene, ofScene);
      return 0;
    }
    SetWords(scene, ofScene);
    Write(scene);
    if (!scene->GetCertificate().empty())
    {
      std::printf("relievo: certified shadows: %s\n", scene->GetCertificate().c_str());
    }
    PrintMessages(scene);
    return 0;
  }

private:
  static void Write(vtkRelievoScene* scene)
  {
    const SceneSteps steps(scene);
    const bool done = scene->Write();
    CheckDone(done, scene->GetFailure(), scene->GetFailureText());
  }

  // The words without --part, which is taken.
  std::vector<std::string> TakePart(const std::vector<std::string>& words)
  {
    const auto isPart = [](const std::string& word) { return word.rfind("--part", 0) == 0; };
    if (std::none_of(words.begin(), words.end(), isPart))
    {
      return words;
    }
    std::vector<std::string> options, plain;
    words::SplitArguments(
      words, this->Rows,
      [&](const vtkRelievoOption& row, const std::string& value) {
        if (row.Name == "--part")
        {
          if (this->IsPart)
          {
            throw words::UsageError("--part: given twice, expected once");
          }
          row.Take(value);
          return;
        }
        options.push_back(row.IsFlag() ? row.Name : row.Name + "=" + value);
      },
      [&](const std::string& word) { plain.push_back(word); });
    options.emplace_back("--");
    options.insert(options.end(), plain.begin(), plain.end());
    return options;
  }

  void DrawPart(vtkRelievoScene* scene, std::vector<std::string> words)
  {
    const scene::RenderOptions options = scene::ParseOptions(words);
    const std::string folder = FrameParts::GetFolder(options);
    const std::string whole = words::Join(words, " ");
    // The film is made of all frames.
    words.erase(std::remove_if(words.begin(), std::find(words.begin(), words.end(), "--"),
                  [&options](const std::string& word) {
                    return word.rfind("--video=", 0) == 0 ||
                      (options.Motion.Path.empty() && word.rfind("--fps=", 0) == 0);
                  }),
      std::find(words.begin(), words.end(), "--"));
    SetWords(scene, words);
    std::vector<std::string> inputs;
    for (vtkIdType i = 0; i < scene->GetInputFiles()->GetNumberOfValues(); ++i)
    {
      inputs.push_back(scene->GetInputFiles()->GetValue(i));
    }
    FrameParts parts(folder);
    const std::vector<int> left = parts.Begin(whole, options, inputs, this->Part);
    vtkNew<vtkCallbackCommand> keep;
    keep->SetClientData(&parts);
    keep->SetCallback([](vtkObject*, unsigned long, void* of, void* frame) {
      static_cast<FrameParts*>(of)->Keep(*static_cast<int*>(frame));
    });
    scene->AddObserver(vtkRelievoScene::FrameEvent, keep);
    for (std::size_t i = 0; i < left.size();)
    {
      std::size_t next = i + 1;
      while (next < left.size() && left[next] == left[next - 1] + 1)
      {
        ++next;
      }
      scene->SetFrames(left[i], left[next - 1] + 1);
      Write(scene);
      PrintMessages(scene);
      i = next;
    }
    const std::string part = this->Part.GetText();
    if (left.empty())
    {
      std::printf("%s: %s is complete\n", folder.c_str(), part.c_str());
    }
    else
    {
      std::printf("%s: %s written, %zu frames; relievo merge %s checks all parts\n", folder.c_str(),
        part.c_str(), left.size(), folder.c_str());
    }
  }
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeRender()
{
  return std::make_unique<RenderCommand>();
}
}
