// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"
#include "DatasetParts.h"
#include "Errors.h"
#include "FrameParts.h"
#include "MeshParts.h"
#include "Messages.h"
#include "Progress.h"
#include "Values.h"

#include <cstdio>
#include <filesystem>

namespace cli
{
namespace
{
// A command about the folder in which the parts of a piece of work are.
class FolderCommand : public Command
{
public:
  enum Work
  {
    Merge,
    Verify,
    Status
  };

  FolderCommand(const std::string& name, Work work, const std::string& about)
    : Command(name, "DIR", about)
    , Kind(work)
  {
    this->Rows.Files = "/";
  }

  int Run(const std::vector<std::string>& words) override
  {
    this->Take(words);
    if (this->Names.size() != 1)
    {
      throw words::UsageError(
        this->Rows.Name + ": got " + std::to_string(this->Names.size()) + " folders, expected one");
    }
    std::string folder = this->Names.front();
    while (folder.size() > 1 && folder.back() == '/')
    {
      folder.pop_back();
    }
    std::error_code trouble;
    if (std::filesystem::path(folder).extension() != MeshParts::GetFolder(""))
    {
      folder =
        std::filesystem::weakly_canonical(folder, trouble).string(); // of "." and "x.parts/."
    }
    const bool isDataset =
      std::filesystem::exists(folder + "/" + dataset::DatasetSettings, trouble);
    const bool isFrames =
      !isDataset && std::filesystem::exists(folder + "/" + FrameParts::Settings, trouble);
    if (!isDataset && !isFrames &&
      !std::filesystem::exists(folder + "/" + MeshParts::Settings, trouble))
    {
      throw words::UsageError(folder + ": has neither " + dataset::DatasetSettings + ", " +
        FrameParts::Settings + " nor " + MeshParts::Settings +
        "; expected a folder that relievo dataset, render, sun, viewshed or visible has begun");
    }
    if (!isDataset && !isFrames &&
      std::filesystem::path(folder).extension() != MeshParts::GetFolder(""))
    {
      throw words::UsageError(folder + ": expected a folder FILE" + MeshParts::GetFolder("") +
        ", whose name says which FILE merge writes");
    }
    const reading::Messages::Scope scope;
    if (this->Kind == Merge)
    {
      return MergeParts(folder, isDataset, isFrames);
    }
    const auto check =
      this->Kind == Status ? dataset::WorkCheck::Records : dataset::WorkCheck::Files;
    const dataset::WorkState state = isDataset ? dataset::VerifyDataset(folder, check)
      : isFrames                               ? FrameParts(folder).Verify(check)
                                               : MeshParts(folder).Verify(check);
    if (this->Kind == Status)
    {
      std::fputs(dataset::PartProgress::GetText(folder).c_str(), stdout);
    }
    std::fputs(state.GetText(folder).c_str(), stdout);
    constexpr int different = 3; // as of relievo compare
    return this->Kind == Status || state.IsWhole() ? 0 : different;
  }

private:
  static int MergeParts(const std::string& folder, bool isDataset, bool isFrames)
  {
    reading::Progress progress;
    if (isDataset)
    {
      dataset::MergeDataset(folder);
      std::printf("%s: its indices are written\n", folder.c_str());
    }
    else if (isFrames)
    {
      std::printf("%s\n", FrameParts(folder).Merge().c_str());
    }
    else
    {
      const std::string file = MeshParts(folder).Merge(progress);
      progress.End();
      std::printf("%s: written from all parts\n", file.c_str());
    }
    return 0;
  }

  Work Kind;
};
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeMerge()
{
  return std::make_unique<FolderCommand>("merge", FolderCommand::Merge,
    "merge joins the parts that processes have written to DIR with --part: the result is that of a "
    "single process, byte for byte. It writes the indices of a data set, the film of frames, or "
    "from FILE.parts the FILE.");
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeVerify()
{
  return std::make_unique<FolderCommand>("verify", FolderCommand::Verify,
    "verify checks DIR, a data set or FILE.parts, and changes nothing: it lists items that are "
    "missing, "
    "damaged (by hashes), or written by another version. Exit status: 0 if it is whole, otherwise "
    "3.");
}

//------------------------------------------------------------------------------
std::unique_ptr<Command> MakeStatus()
{
  return std::make_unique<FolderCommand>("status", FolderCommand::Status,
    "status prints how far the parts in DIR are, how fast, and how long they will take.");
}
}
