// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Overlay.h"

#include <QEvent>

namespace viewer
{
//------------------------------------------------------------------------------
Overlay::Overlay(QWidget* parent)
  : QWidget(parent)
{
  parent->installEventFilter(this);
}

//------------------------------------------------------------------------------
bool Overlay::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::Resize)
  {
    this->Place();
  }
  return this->QWidget::eventFilter(watched, event);
}
}
