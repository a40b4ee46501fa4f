// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws a slow sample of the picture in a thread of its own, so that the window responds meanwhile.
 * The view lends its OpenGL context to the thread, and uses neither OpenGL nor the scene until the
 * context is back.
 */
#ifndef SampleThread_h
#define SampleThread_h

#include <QThread>

class QVTKOpenGLNativeWidget;

namespace viewer
{
class SampleThread : public QThread
{
public:
  explicit SampleThread(QVTKOpenGLNativeWidget* view);

  /// Whether samples can be drawn in a thread.
  static bool IsPossible();

  /// Lends the context and returns at once; `finished` follows.
  void Lend();

  /// Waits for the sample, if the context is lent.
  void TakeBack();

  bool IsLent() const { return this->Lent; }

protected:
  void run() override;

private:
  QVTKOpenGLNativeWidget* View;
  bool Lent = false;
};
}

#endif
