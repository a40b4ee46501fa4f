// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Base of widgets over the picture that follow its size. Saved pictures do not contain them.
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

  /// Places it below another visible overlay at the parent's top.
  void PutBelow(Overlay* above);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

  /// Places it for the parent's present size.
  virtual void Place() = 0;

  /// The top of the free space below the overlays above it.
  int GetTop() const;

private:
  Overlay* Above = nullptr;
};
}

#endif
