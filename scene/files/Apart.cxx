// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Apart.h"

#include "Errors.h"
#include "Messages.h"
#include "NumberLocale.h"
#include "OpenedFiles.h"
#include "Progress.h"
#include "Readers.h"

#include "vtkDataObject.h"
#include "vtkRelievoDataBytes.h"
#include "vtkRelievoReaderProcess.h"

#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace scene
{
namespace
{
enum class End : unsigned char
{
  Done,
  Usage,
  Work
};

// The result's texts and lists, beside the data.
struct Said
{
  End Is = End::Done;
  std::string Wrong;
  std::vector<std::string> Notes, Warnings, Opened;
};

template <typename Visit>
void VisitFields(Said& said, Visit&& visit)
{
  auto& [is, wrong, notes, warnings, opened] = said;
  visit(is, wrong, notes, warnings, opened);
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

thread_local std::function<void()> Meanwhile;

// Runs in the process that reads the file.
void Answer(
  relievo::ByteReader& asked, const vtkRelievoReaderProcess::Say& say, relievo::ByteWriter& made)
{
  const auto work = reinterpret_cast<ReadingWork>(asked.Get<std::uintptr_t>());
  const auto path = asked.Get<std::string>();
  const auto folders = asked.Get<std::vector<std::string>>();
  Said said;
  vtkSmartPointer<vtkDataObject> data;
  {
    const Messages::Scope scope;
    const NumberLocale locale;
    const OpenedFiles listed(said.Opened);
    Steps steps(say);
    Progress progress(&steps);
    OpenedFiles::Add(path);
    try
    {
      data = work(path, folders, progress);
    }
    catch (const UsageError& error)
    {
      said.Is = End::Usage;
      said.Wrong = error.what();
    }
    catch (const WorkError& error)
    {
      if (Messages::TellsOfMemory(error.what())) // VTK 9.1 continues after this, without data
      {
        throw std::bad_alloc();
      }
      said.Is = End::Work;
      said.Wrong = error.what();
    }
    said.Notes = Messages::TakeNotes();
    said.Warnings = Messages::TakeWarnings();
  }
  made(said);
  relievo::PutData(made, data);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> ReadApart(ReadingWork work, const std::string& path,
  const std::vector<std::string>& folders, Progress& progress)
{
  if (!vtkRelievoReaderProcess::IsThere())
  {
    return work(path, folders, progress);
  }
  const std::string reading = "reading " + path;
  progress.Begin(reading);
  std::string step = reading;
  const auto show = [&](const std::string& what, double share) {
    if (const auto meanwhile = std::exchange(Meanwhile, nullptr))
    {
      meanwhile();
    }
    if (!what.empty() && what != step)
    {
      step = what;
      progress.Begin(what);
    }
    progress.Update(share);
    return !progress.IsStopped();
  };
  Said said;
  vtkSmartPointer<vtkDataObject> data;
  const std::string failure = vtkRelievoReaderProcess::Run(
    Answer,
    [&](
      relievo::ByteWriter& asked) { asked(reinterpret_cast<std::uintptr_t>(work), path, folders); },
    show,
    [&](relievo::ByteReader& made) {
      made(said);
      data = relievo::GetData(made);
    });
  progress.End();
  if (!failure.empty())
  {
    throw WorkError(path + ": the reader (" + GetReaderName(path) + ") " + failure);
  }
  for (const std::string& each : said.Opened)
  {
    OpenedFiles::Add(each);
  }
  for (const std::string& note : said.Notes)
  {
    Messages::Note(note);
  }
  for (const std::string& warning : said.Warnings)
  {
    Messages::Warn(warning);
  }
  if (said.Is == End::Usage)
  {
    throw UsageError(said.Wrong);
  }
  if (said.Is == End::Work)
  {
    throw WorkError(said.Wrong);
  }
  if (!data)
  {
    throw WorkError(path + ": contains nothing to draw");
  }
  return data;
}

//------------------------------------------------------------------------------
WhileReading::WhileReading(std::function<void()> work)
{
  Meanwhile = std::move(work);
}

//------------------------------------------------------------------------------
WhileReading::~WhileReading()
{
  Meanwhile = nullptr;
}
}
