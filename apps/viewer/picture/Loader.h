// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reads files in a thread of its own, one at a time, because readers' messages are collected
 * globally. A stopped reading ends soon, because its reader is another process; the next begins
 * after it.
 */
#ifndef Loader_h
#define Loader_h

#include "Frame.h"
#include "Progress.h"
#include "Scene.h"
#include "Settings.h"

#include <QObject>
#include <QString>

#include <atomic>
#include <thread>

namespace viewer
{
class Loader
  : public QObject
  , private reading::ProgressListener
{
  Q_OBJECT

public:
  explicit Loader(QObject* parent = nullptr);
  ~Loader() override;

  /// Returns at once; ended() follows. `pointsOnly`: reads only the points of lamps, fog and
  /// markers.
  void Start(const scene::Settings& settings, bool pointsOnly = false);

  /// Stops reading, without a signal. Returns at once.
  void Stop();

  bool IsReading() const { return this->Wanted; }

  /// Whether the thread runs, even for an unwanted result.
  bool IsBusy() const { return this->Thread.joinable(); }

  /// Moves out the result.
  scene::Scene TakeScene();
  scene::FramePoints TakePoints();

Q_SIGNALS:
  void progressed(const QString& what, int percent);

  /// IsBusy() has changed.
  void busyChanged();

  /// `trouble` is empty after success.
  void ended(const QString& trouble);

private:
  void Begin();
  void Read(const scene::Settings& settings, bool pointsOnly);
  void Say(const std::string& what, double share) override;
  bool IsStopped() override { return this->Stopped; }
  void End(const QString& trouble);

  std::thread Thread;
  std::atomic<bool> Stopped{ false };
  std::atomic<int> Percent{ -1 };
  bool Wanted = false;
  scene::Settings Asked;
  bool PointsOnly = false;
  scene::Scene Scene;
  scene::FramePoints Points;
};
}

#endif
