// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The window's size and place, and its panels', from one run of the program to the next.
#include "MainWindow.h"

#include "Messages.h"
#include "Options.h"
#include "PictureView.h"
#include "TimeBar.h"

#include <QScreen>
#include <QSettings>
#include <QStackedWidget>

#include <algorithm>

namespace viewer
{
//------------------------------------------------------------------------------
// The view takes the size, in pixels of the screen, or as much of it as the screen has room for.
void MainWindow::SetViewSize(const std::string& words)
{
  if (words.empty())
  {
    return;
  }
  Settings asked;
  asked.Set("--size", words);
  const std::array<int, 2> pixels = asked.Parse().Size;
  const bool fixed = this->isMaximized() || this->isFullScreen();
  const double ratio = this->Shown->effectiveDevicePixelRatio();
  const QSize frame = this->frameGeometry().size() - this->size();
  double share = 1.0;
  for (int i = 0; i < 3; ++i) // for panels may take another share of another window
  {
    const QSize panels = this->size() - this->Pages->size();
    const QSize room =
      fixed ? this->Pages->size() : this->screen()->availableSize() - frame - panels;
    share = std::min({ 1.0, room.width() * ratio / pixels[0], room.height() * ratio / pixels[1] });
    if (!fixed)
    {
      this->resize(panels +
        QSize(static_cast<int>(pixels[0] * share / ratio),
          static_cast<int>(pixels[1] * share / ratio)));
    }
  }
  if (share < 1.0)
  {
    cli::Messages::Note(
      "--size " + words + ": the screen has no room for so many pixels; the view is smaller");
  }
}

//------------------------------------------------------------------------------
void MainWindow::RestoreLayout()
{
  const QSettings kept;
  this->restoreGeometry(kept.value("geometry").toByteArray());
  this->restoreState(kept.value("state").toByteArray());
  this->Time->ShowSettings(); // where nothing moves there is none, whatever was seen before
  const QSize room = this->screen()->availableSize();
  if (!this->isMaximized() && !this->isFullScreen())
  {
    this->resize(this->size().boundedTo(room));
  }
}

//------------------------------------------------------------------------------
void MainWindow::KeepLayout()
{
  QSettings kept;
  kept.setValue("geometry", this->saveGeometry());
  kept.setValue("state", this->saveState());
}
}
