// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Appearance.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QSettings>
#include <QStyle>
#include <QStyleOption>

namespace viewer
{
namespace
{
const char* const SettingsKey = "appearance"; // of QSettings: the name of the choice's action

//------------------------------------------------------------------------------
QPalette MakePalette(int window, int field, int text, const QColor& link)
{
  const auto grey = [](int level) { return QColor(level, level, level); };
  QPalette palette(grey(window)); // includes edges, buttons and shades
  for (const QPalette::ColorRole role :
    { QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText })
  {
    palette.setColor(role, grey(text));
    palette.setColor(QPalette::Disabled, role, grey((text + window) / 2));
  }
  palette.setColor(QPalette::Base, grey(field));
  palette.setColor(QPalette::AlternateBase, grey((field + window) / 2));
  palette.setColor(QPalette::ToolTipBase, grey(field));
  palette.setColor(QPalette::PlaceholderText, grey((text + field) / 2));
  palette.setColor(QPalette::Highlight, QColor(48, 140, 198));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, link);
  palette.setColor(QPalette::LinkVisited, link);
  return palette;
}

//------------------------------------------------------------------------------
// The style draws a box's frame darker than the window, which is invisible in dark mode.
class BoxesInDark : public QProxyStyle
{
public:
  BoxesInDark()
    : QProxyStyle("Fusion")
  {
  }

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
    const QWidget* widget) const override
  {
    this->QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element == PE_IndicatorCheckBox)
    {
      const bool enabled = option->state.testFlag(State_Enabled);
      painter->setPen(option->palette.color(
        enabled ? QPalette::Normal : QPalette::Disabled, QPalette::WindowText));
      painter->setBrush(Qt::NoBrush);
      painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    }
  }
};

//------------------------------------------------------------------------------
void Make(const QString& name)
{
  static const QString desktops = QApplication::style()->objectName();
  const bool light = name == "light";
  const bool dark = name == "dark";
  if (dark)
  {
    QApplication::setStyle(new BoxesInDark);
  }
  else
  {
    QApplication::setStyle(light ? "Fusion" : desktops); // other styles may have own colours
  }
  QApplication::setPalette(dark ? MakePalette(50, 35, 230, QColor(100, 180, 255))
      : light                   ? MakePalette(239, 255, 0, QColor(0, 90, 200))
                                : QPalette());
}
}

//------------------------------------------------------------------------------
void AddAppearance(QMenu* menu)
{
  auto* group = new QActionGroup(menu);
  const QString kept = QSettings().value(SettingsKey, "desktop").toString();
  for (const char* text : { "As the &desktop", "&Light", "Dar&k" })
  {
    QAction* action = menu->addAction(text);
    action->setObjectName(QString(text).remove('&').section(' ', -1).toLower());
    action->setCheckable(true);
    action->setChecked(action->objectName() == kept);
    group->addAction(action);
  }
  if (kept != "desktop")
  {
    Make(kept);
  }
  QObject::connect(group, &QActionGroup::triggered, menu, [](QAction* action) {
    Make(action->objectName());
    QSettings().setValue(SettingsKey, action->objectName());
  });
}
}
