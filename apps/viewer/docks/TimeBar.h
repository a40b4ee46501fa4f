// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The time of animations, seen where something moves.
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

  /// Is hidden where nothing moves.
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
  int Played = 0; // as long as it plays, times are one edit
};
}

#endif
