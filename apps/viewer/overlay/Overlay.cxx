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
void Overlay::PutBelow(Overlay* above)
{
  this->Above = above;
  for (Overlay* each = above; each; each = each->Above)
  {
    each->installEventFilter(this);
  }
  this->Place();
}

//------------------------------------------------------------------------------
int Overlay::GetTop() const
{
  if (!this->Above)
  {
    return 0;
  }
  return this->Above->isHidden() ? this->Above->GetTop() : this->Above->geometry().bottom() + 1;
}

//------------------------------------------------------------------------------
bool Overlay::eventFilter(QObject* watched, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::Resize:
    case QEvent::Move:
    case QEvent::Show:
    case QEvent::Hide:
      this->Place();
      break;
    default:
      break;
  }
  return this->QWidget::eventFilter(watched, event);
}
}
