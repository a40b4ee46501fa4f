// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PanelSwitch.h"

#include "Panel.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>

#include <algorithm>

namespace viewer
{
namespace
{
constexpr double MostShare = 0.3; // of the window's width, for panels

bool IsNarrow(const QMainWindow* window)
{
  int width = 0;
  for (const Panel* panel : window->findChildren<Panel*>())
  {
    width = std::max(width, panel->minimumWidth());
  }
  return width > MostShare * window->width();
}
}

//------------------------------------------------------------------------------
PanelSwitch::PanelSwitch(QMainWindow* window)
  : QObject(window)
  , Window(window)
{
  auto* action = new QAction("Pane&ls", this);
  action->setObjectName("panels");
  action->setShortcut(QKeySequence("F9"));
  action->setToolTip("Hides the panels, or shows them; small windows begin without");
  QObject::connect(action, &QAction::triggered, this, &PanelSwitch::Toggle);
  window->installEventFilter(this);
}

//------------------------------------------------------------------------------
QList<QDockWidget*> PanelSwitch::FindDocked() const
{
  QList<QDockWidget*> docked;
  for (QDockWidget* dock : this->Window->findChildren<QDockWidget*>())
  {
    if (!dock->isHidden() && !dock->isFloating())
    {
      docked += dock;
    }
  }
  return docked;
}

//------------------------------------------------------------------------------
void PanelSwitch::Hide()
{
  if (!this->ByItself) // otherwise the user has shown some again
  {
    this->Hidden.clear();
  }
  this->Top = nullptr;
  for (QDockWidget* dock : this->FindDocked())
  {
    if (!this->Hidden.contains(dock))
    {
      this->Hidden += dock;
    }
    if (!dock->visibleRegion().isEmpty())
    {
      this->Top = dock;
    }
  }
  if (!this->Top && !this->Hidden.isEmpty()) // nothing is painted yet
  {
    this->Top = this->Hidden.last(); // raised last
  }
  for (QDockWidget* dock : this->Hidden)
  {
    dock->hide();
  }
}

//------------------------------------------------------------------------------
void PanelSwitch::Show()
{
  const bool none = this->FindDocked().isEmpty();
  if (this->Hidden.isEmpty()) // the user closed them one by one, or in the last run
  {
    for (QDockWidget* dock : this->Window->findChildren<QDockWidget*>())
    {
      if (!dock->isFloating() && dock->objectName() != "comparison") // there may be none
      {
        this->Hidden += dock;
      }
    }
  }
  for (QDockWidget* dock : this->Hidden)
  {
    if (dock)
    {
      dock->show();
    }
  }
  if (this->Top && none)
  {
    this->Top->raise();
  }
  this->ByItself = false;
}

//------------------------------------------------------------------------------
void PanelSwitch::Toggle()
{
  this->FindDocked().isEmpty() ? this->Show() : this->Hide();
  this->ByItself = false;
}

//------------------------------------------------------------------------------
void PanelSwitch::Open()
{
  if (this->ByItself)
  {
    this->Show();
  }
}

//------------------------------------------------------------------------------
bool PanelSwitch::eventFilter(QObject*, QEvent* event)
{
  if (event->type() == QEvent::Resize && IsNarrow(this->Window) != this->Narrow)
  {
    this->Narrow = !this->Narrow;
    if (!this->Narrow)
    {
      this->Open();
    }
    else if (!this->FindDocked().isEmpty())
    {
      this->Hide();
      this->ByItself = true;
    }
  }
  return false;
}
}
