// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What lies over the picture, at a place that follows the picture's size. It is the window's: no
 * picture that is saved has it.
 */
#ifndef Overlay_h
#define Overlay_h

#include <QWidget>

namespace viewer
{
class Overlay : public QWidget
{
  Q_OBJECT

public:
  explicit Overlay(QWidget* parent);

  /// Takes its place below another one at the parent's top, where that is seen.
  void PutBelow(Overlay* above);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

  /// Takes its place in the parent as large as that is now.
  virtual void Place() = 0;

  /// Where the room begins that those above it leave.
  int GetTop() const;

private:
  Overlay* Above = nullptr;
};
}

#endif
