// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Apart.h"

#include "Errors.h"
#include "Messages.h"
#include "NumberLocale.h"
#include "Progress.h"
#include "ReadContext.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkRelievoReaderProcess.h"

#include <cstdint>
#include <new>
#include <vector>

namespace reading
{
namespace
{
enum class End : unsigned char
{
  Done,
  Usage,
  Work
};

struct Asked
{
  std::uintptr_t Work; // from Answer on: both are in this library, which lies anywhere in a process
  std::string Path;
  std::vector<std::string> Folders;
};

template <typename Visit>
void VisitFields(Asked& asked, Visit&& visit)
{
  visit(asked.Work, asked.Path, asked.Folders);
}

struct Made
{
  End Is = End::Done;
  std::string Error;
  std::vector<std::string> Notes, Warnings, Opened;
  vtkSmartPointer<vtkDataObject> Data;
};

template <typename Visit>
void VisitFields(Made& made, Visit&& visit)
{
  visit(made.Is, made.Error, made.Notes, made.Warnings, made.Opened, made.Data);
}

// Sends progress steps to the program.
class Steps : public ProgressListener
{
public:
  explicit Steps(const vtkRelievoReaderProcess::Say& say)
    : Tell(say)
  {
  }
  void Say(const std::string& what, double share) override { this->Tell(what, share); }
  bool IsStopped() override { return false; } // stopping ends the process instead

private:
  const vtkRelievoReaderProcess::Say& Tell;
};

// Runs in the process that reads the file.
void Answer(const Asked& asked, const vtkRelievoReaderProcess::Say& say, Made& made)
{
  const auto work =
    reinterpret_cast<ReadingWork>(reinterpret_cast<std::uintptr_t>(&Answer) + asked.Work);
  const Messages::Scope scope;
  const NumberLocale locale;
  Steps steps(say);
  Progress progress(&steps);
  ReadContext context(progress, asked.Folders);
  context.AddFile(asked.Path);
  try
  {
    made.Data = work(asked.Path, context);
  }
  catch (const UsageError& error)
  {
    made.Is = End::Usage;
    made.Error = error.what();
  }
  catch (const WorkError& error)
  {
    if (Messages::TellsOfMemory(error.what())) // VTK 9.1 continues after this, without data
    {
      throw std::bad_alloc();
    }
    made.Is = End::Work;
    made.Error = error.what();
  }
  made.Notes = context.TakeNotes();
  made.Warnings = context.TakeWarnings();
  for (const std::string& warning : Messages::TakeWarnings())
  {
    made.Warnings.push_back(warning);
  }
  made.Opened = context.GetFiles();
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadApart(
  ReadingWork work, const std::string& path, ReadContext& context)
{
  if (!vtkRelievoReaderProcess::IsThere())
  {
    return work(path, context);
  }
  Progress& progress = context.GetProgress();
  const std::string reading = "reading " + path;
  progress.Begin(reading);
  std::string step = reading;
  const auto show = [&](const std::string& what, double share) {
    context.DoMeanwhile();
    if (!what.empty() && what != step)
    {
      step = what;
      progress.Begin(what);
    }
    progress.Update(share);
    return !progress.IsStopped();
  };
  Made made;
  const std::string failure = vtkRelievoReaderProcess::Do<Answer>(
    Asked{ reinterpret_cast<std::uintptr_t>(work) - reinterpret_cast<std::uintptr_t>(&Answer), path,
      context.GetFolders() },
    show, made);
  progress.End();
  if (!failure.empty())
  {
    throw WorkError(path + ": the reader (" + GetReaderName(path) + ") " + failure);
  }
  for (const std::string& each : made.Opened)
  {
    context.AddFile(each);
  }
  for (const std::string& note : made.Notes)
  {
    context.Note(note);
  }
  for (const std::string& warning : made.Warnings)
  {
    context.Warn(warning);
  }
  if (made.Is == End::Usage)
  {
    throw UsageError(made.Error);
  }
  if (made.Is == End::Work)
  {
    throw WorkError(made.Error);
  }
  if (!made.Data)
  {
    throw WorkError(path + ": contains nothing to draw");
  }
  return made.Data;
}
}
