// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "Errors.h"
#include "StandardError.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkObject.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace reading
{
namespace
{
constexpr std::chrono::milliseconds TerminalPause(100);
constexpr std::chrono::seconds LogSilence(2);
constexpr std::chrono::seconds LogPause(5);
}

//------------------------------------------------------------------------------
Progress::Progress(ProgressListener* listener)
  : Listener(listener)
  , OnTerminal(!listener && isatty(fileno(StandardError())) != 0)
{
}

//------------------------------------------------------------------------------
Progress::~Progress()
{
  this->End();
}

//------------------------------------------------------------------------------
void Progress::Begin(const std::string& what)
{
  this->End();
  if (this->IsStopped())
  {
    throw WorkError(what + ": stopped");
  }
  this->What = what;
  this->Began = Clock::now();
  this->LastShown = Clock::time_point();
  if (this->OnTerminal || this->Listener)
  {
    this->Update(0.0);
  }
}

//------------------------------------------------------------------------------
void Progress::Update(double share)
{
  if (this->Listener)
  {
    this->Listener->Say(this->What, std::clamp(share, 0.0, 1.0));
    return;
  }
  const Clock::time_point now = Clock::now();
  const bool due = this->OnTerminal
    ? now - this->LastShown >= TerminalPause
    : now - this->Began >= LogSilence && now - this->LastShown >= LogPause;
  if (this->What.empty() || !due)
  {
    return;
  }
  const int percent = static_cast<int>(std::lround(100.0 * std::clamp(share, 0.0, 1.0)));
  std::fprintf(StandardError(),
    this->OnTerminal ? "\r\033[Krelievo: %s %d %%" : "relievo: %s %d %%\n", this->What.c_str(),
    percent);
  this->LastShown = now;
  this->Shown = true;
}

//------------------------------------------------------------------------------
bool Progress::IsStopped()
{
  return this->Listener && this->Listener->IsStopped();
}

//------------------------------------------------------------------------------
void Progress::End()
{
  if (this->Shown && this->OnTerminal)
  {
    std::fputs("\r\033[K", StandardError());
  }
  this->Shown = false;
  this->What.clear();
}

//------------------------------------------------------------------------------
void Progress::Observe(vtkObject* algorithm)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject* caller, unsigned long, void* client, void* share) {
    auto* self = static_cast<Progress*>(client);
    if (share)
    {
      self->Update(*static_cast<double*>(share));
    }
    vtkAlgorithm* working = vtkAlgorithm::SafeDownCast(caller);
    if (working && self->IsStopped())
    {
      working->SetAbortExecute(1);
    }
  });
  algorithm->AddObserver(vtkCommand::ProgressEvent, command);
}
}
