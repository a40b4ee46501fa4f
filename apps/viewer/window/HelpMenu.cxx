// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HelpMenu.h"

#include "MainWindow.h"
#include "Version.h"

#include <QAction>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QVBoxLayout>

namespace viewer
{
namespace
{
QString WriteKey(const QString& key, const QString& text)
{
  return "<tr><td><b>" + key.toHtmlEscaped() + "</b>&nbsp;&nbsp;&nbsp;</td><td>" +
    text.toHtmlEscaped() + "</td></tr>";
}

QString WriteKeysOf(const QMenu* menu, const QString& before)
{
  QString rows;
  for (const QAction* action : menu->actions())
  {
    const QString text =
      before + QString(action->text()).section(':', 0, 0).remove('&').remove("...");
    if (action->menu())
    {
      rows += WriteKeysOf(action->menu(), text + " ");
    }
    else if (!action->shortcut().isEmpty())
    {
      rows += WriteKey(action->shortcut().toString(QKeySequence::NativeText), text);
    }
  }
  return rows;
}

QString WriteKeys(MainWindow* window)
{
  QString rows;
  for (const QAction* menu : window->menuBar()->actions())
  {
    rows += WriteKeysOf(menu->menu(), "");
  }
  return "<table>" + WriteKey("Left button, arrows", "turns") +
    WriteKey("Middle button, Shift and arrows", "moves") +
    WriteKey("Right button, wheel, + and -", "zooms") + WriteKey("Space", "Plays the animation") +
    rows + WriteKey("B, held", "Baseline, in a comparison") + "</table>";
}

//------------------------------------------------------------------------------
// A single sheet, toggled by its key.
void SwitchKeys(MainWindow* window)
{
  auto* sheet = window->findChild<QDialog*>("keys");
  if (!sheet)
  {
    sheet = new QDialog(window);
    sheet->setObjectName("keys");
    sheet->setWindowTitle("Keys");
    auto* words = new QLabel(WriteKeys(window), sheet);
    words->setObjectName("sheet");
    (new QVBoxLayout(sheet))->addWidget(words);
    auto* again = new QAction(sheet); // the window's key does not work in the sheet
    again->setShortcut(QKeySequence("H"));
    sheet->addAction(again);
    QObject::connect(again, &QAction::triggered, sheet, &QDialog::hide);
  }
  sheet->setVisible(!sheet->isVisible());
}
}

//------------------------------------------------------------------------------
void AddHelpMenu(MainWindow* window)
{
  QMenu* menu = window->menuBar()->addMenu("&Help");
  QAction* keys = menu->addAction("&Keys");
  keys->setObjectName("showKeys");
  keys->setShortcut(QKeySequence("H"));
  QObject::connect(keys, &QAction::triggered, window, [window] { SwitchKeys(window); });
  QAction* about = menu->addAction("&About Relievo");
  about->setObjectName("about");
  QObject::connect(about, &QAction::triggered, window, [window] {
    QMessageBox::about(window, "About Relievo", QString::fromStdString(scene::DescribeVersions()));
  });
}
}
