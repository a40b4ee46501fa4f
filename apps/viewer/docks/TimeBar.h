// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The time of animations, visible if the scene has any.
 */
#ifndef TimeBar_h
#define TimeBar_h

#include "Document.h"

#include <QAction>
#include <QElapsedTimer>
#include <QTimer>
#include <QToolBar>

class QLabel;
class QSlider;

namespace viewer
{
class TimeBar : public QToolBar
{
  Q_OBJECT

public:
  explicit TimeBar(Document* document, QWidget* parent = nullptr);

  /// Hides the bar without animations.
  void ShowSettings();

  void Stop() { this->Playing->setChecked(false); }

private:
  void Play(bool on);
  void Step();
  void SetTime(double seconds);
  double GetTime() const;

  Document* Edited;
  QAction* Playing;
  QSlider* Slider;
  QLabel* Words;
  QTimer Next;
  QElapsedTimer Clock;
  int Played = 0; // groups the times of one playback into one edit
};
}

#endif
