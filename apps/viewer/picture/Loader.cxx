// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Loader.h"

#include "Errors.h"
#include "Messages.h"
#include "Options.h"
#include "ReadContext.h"

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
void Loader::Start(const scene::Settings& settings, bool pointsOnly)
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
  if (!this->Thread.joinable()) // otherwise the thread still writes them
  {
    this->Scene = scene::Scene();
    this->Points = scene::FramePoints();
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
  Q_EMIT this->busyChanged();
}

//------------------------------------------------------------------------------
void Loader::Read(const scene::Settings& settings, bool pointsOnly)
{
  QString trouble;
  try
  {
    const scene::RenderOptions options = settings.Parse();
    scene::CheckInputs(options);
    reading::Progress progress(this);
    reading::ReadContext context(progress, options.AllowedFolders);
    if (!pointsOnly)
    {
      this->Scene = scene::ReadScene(options, context);
    }
    this->Points = scene::ReadFramePoints(options, context);
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
  Q_EMIT this->busyChanged();
  if (!this->Stopped)
  {
    this->Wanted = false;
    Q_EMIT this->ended(trouble);
    return;
  }
  this->Scene = scene::Scene();
  this->Points = scene::FramePoints();
  reading::Messages::TakeNotes();
  reading::Messages::TakeWarnings();
  try
  {
    reading::Messages::Check("");
  }
  catch (const words::WorkError&) // the result is not wanted any more
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
scene::Scene Loader::TakeScene()
{
  scene::Scene scene = this->Scene;
  this->Scene = scene::Scene();
  return scene;
}

//------------------------------------------------------------------------------
scene::FramePoints Loader::TakePoints()
{
  scene::FramePoints points = this->Points;
  this->Points = scene::FramePoints();
  return points;
}
}
