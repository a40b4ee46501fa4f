// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Loader.h"

#include "Errors.h"
#include "Messages.h"
#include "Options.h"

#include <cmath>
#include <exception>

namespace viewer
{
//------------------------------------------------------------------------------
Loader::Loader(QObject* parent)
  : QObject(parent)
{
}

//------------------------------------------------------------------------------
Loader::~Loader()
{
  this->Stop();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

//------------------------------------------------------------------------------
void Loader::Start(const Settings& settings, bool pointsOnly)
{
  this->Stop();
  this->Asked = settings;
  this->PointsOnly = pointsOnly;
  this->Wanted = true;
  if (!this->Thread.joinable())
  {
    this->Begin();
  }
}

//------------------------------------------------------------------------------
void Loader::Stop()
{
  this->Wanted = false;
  this->Stopped = true;
  if (!this->Thread.joinable()) // which else still writes them
  {
    this->Scene = cli::Scene();
    this->Points = cli::FramePoints();
  }
}

//------------------------------------------------------------------------------
void Loader::Begin()
{
  this->Stopped = false;
  this->Percent = -1;
  this->Thread = std::thread([this, settings = this->Asked, pointsOnly = this->PointsOnly] {
    this->Read(settings, pointsOnly);
  });
}

//------------------------------------------------------------------------------
void Loader::Read(const Settings& settings, bool pointsOnly)
{
  QString trouble;
  try
  {
    const cli::RenderOptions options = settings.Parse();
    cli::CheckInputs(options);
    cli::Progress progress(this);
    if (!pointsOnly)
    {
      this->Scene = cli::ReadScene(options, progress);
    }
    this->Points = cli::ReadFramePoints(options, progress);
  }
  catch (const std::bad_alloc&)
  {
    trouble = "There is not enough memory to read this.";
  }
  catch (const std::exception& error)
  {
    trouble = QString::fromStdString(error.what());
  }
  QMetaObject::invokeMethod(
    this, [this, trouble] { this->End(trouble); }, Qt::QueuedConnection);
}

//------------------------------------------------------------------------------
void Loader::End(const QString& trouble)
{
  this->Thread.join();
  if (!this->Stopped)
  {
    this->Wanted = false;
    Q_EMIT this->ended(trouble);
    return;
  }
  this->Scene = cli::Scene();
  this->Points = cli::FramePoints();
  cli::Messages::TakeNotes();
  cli::Messages::TakeWarnings();
  try
  {
    cli::Messages::Check("");
  }
  catch (const cli::WorkError&) // of what nobody waits for
  {
  }
  if (this->Wanted)
  {
    this->Begin();
  }
}

//------------------------------------------------------------------------------
void Loader::Say(const std::string& what, double share)
{
  const int percent = static_cast<int>(std::lround(100.0 * share));
  if (this->Percent.exchange(percent) != percent && !this->Stopped)
  {
    Q_EMIT this->progressed(QString::fromStdString(what), percent);
  }
}

//------------------------------------------------------------------------------
cli::Scene Loader::TakeScene()
{
  cli::Scene scene = this->Scene;
  this->Scene = cli::Scene();
  return scene;
}

//------------------------------------------------------------------------------
cli::FramePoints Loader::TakePoints()
{
  cli::FramePoints points = this->Points;
  this->Points = cli::FramePoints();
  return points;
}
}
