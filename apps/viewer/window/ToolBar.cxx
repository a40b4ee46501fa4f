// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ToolBar.h"

#include "Icons.h"
#include "MainWindow.h"

#include <QAction>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

namespace viewer
{
namespace
{
constexpr int IconSide = 20; // pixels

// The tool tip: the action's own, or else its text, with its key.
void SetTip(QAction* action)
{
  const QString text = QString(action->text()).remove('&').remove("...");
  const QString key = action->shortcut().toString(QKeySequence::NativeText);
  const QString more = action->toolTip() == text ? QString() : ": " + action->toolTip();
  action->setToolTip(text + (key.isEmpty() ? QString() : " (" + key + ")") + more);
}
}

//------------------------------------------------------------------------------
void AddToolBar(MainWindow* window, QMenu* view)
{
  auto* bar = new QToolBar("Tool bar", window);
  bar->setObjectName("tools");
  bar->setMovable(false);
  bar->setIconSize(QSize(IconSide, IconSide));
  window->addToolBar(Qt::TopToolBarArea, bar);
  for (const char* name : { "open", "savePicture", "copyPicture", "copyCommand", "", "undo", "redo",
         "", "fit", "views", "shadowsOn", "grid", "", "panels", "fullScreen" })
  {
    if (!*name)
    {
      bar->addSeparator();
    }
    else if (auto* menu = window->findChild<QMenu*>(name))
    {
      auto* button = new QToolButton(bar);
      button->setObjectName(QString(name) + "Button");
      button->setIcon(MakeIcon(name));
      button->setToolTip("View direction of the scene");
      button->setMenu(menu);
      button->setPopupMode(QToolButton::InstantPopup);
      bar->addWidget(button);
    }
    else if (auto* action = window->findChild<QAction*>(name))
    {
      action->setIcon(MakeIcon(name));
      action->setIconVisibleInMenu(false);
      SetTip(action);
      bar->addAction(action);
    }
  }
  QAction* shown = bar->toggleViewAction();
  shown->setText("&Tool bar");
  view->addAction(shown);
}
}
