// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputGuard.h"

#include "Document.h"
#include "Panel.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDial>
#include <QGroupBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSlider>
#include <QTimer>

namespace viewer
{
namespace
{
bool IsTurnedByWheel(QWidget* widget)
{
  return qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QComboBox*>(widget) ||
    qobject_cast<QSlider*>(widget) || qobject_cast<QDial*>(widget);
}

bool IsInPanel(QWidget* widget)
{
  while (widget && !qobject_cast<Panel*>(widget))
  {
    widget = widget->parentWidget();
  }
  return widget != nullptr;
}

// Texts take their letters by themselves.
bool IsOwnKey(QWidget* widget, const QKeyEvent& event)
{
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
  {
    return false;
  }
  auto* group = qobject_cast<QGroupBox*>(widget);
  const bool box = qobject_cast<QComboBox*>(widget) != nullptr;
  const bool pressed = qobject_cast<QAbstractButton*>(widget) || (group && group->isCheckable());
  return (event.key() == Qt::Key_Space && (box || pressed)) ||
    (box && !event.text().isEmpty() && event.text()[0].isPrint());
}

// Texts undo what is typed; where nothing is, they have no use for the keys.
bool IsIdleUndo(QWidget* widget, QKeyEvent& event)
{
  if (auto* text = qobject_cast<QPlainTextEdit*>(widget))
  {
    return (event.matches(QKeySequence::Undo) && !text->document()->isUndoAvailable()) ||
      (event.matches(QKeySequence::Redo) && !text->document()->isRedoAvailable());
  }
  auto* line = qobject_cast<QLineEdit*>(widget);
  if (qobject_cast<QAbstractSpinBox*>(widget) || qobject_cast<QComboBox*>(widget))
  {
    line = widget->findChild<QLineEdit*>();
  }
  return line &&
    ((event.matches(QKeySequence::Undo) && !line->isUndoAvailable()) ||
      (event.matches(QKeySequence::Redo) && !line->isRedoAvailable()));
}
}

//------------------------------------------------------------------------------
InputGuard::InputGuard(Document* document, QObject* parent)
  : QObject(parent)
  , Edited(document)
{
  qApp->installEventFilter(this);
}

//------------------------------------------------------------------------------
bool InputGuard::eventFilter(QObject* watched, QEvent* event)
{
  auto* widget = qobject_cast<QWidget*>(watched);
  if (!widget)
  {
    return false;
  }
  switch (event->type())
  {
    case QEvent::Polish:
      if (IsTurnedByWheel(widget) && IsInPanel(widget))
      {
        widget->setFocusPolicy(Qt::StrongFocus); // the wheel gives none
      }
      return false;
    case QEvent::MouseButtonPress:
      this->Edited->BeginDrag();
      return false;
    case QEvent::MouseButtonRelease: // controls may change once more when they are let go
      QTimer::singleShot(0, this->Edited, [this] { this->Edited->EndDrag(); });
      return false;
    case QEvent::Wheel:
      if (IsTurnedByWheel(widget) && IsInPanel(widget) && !widget->hasFocus())
      {
        event->ignore(); // goes on to the panel
        return true;
      }
      return false;
    case QEvent::ShortcutOverride:
      if (IsIdleUndo(widget, *static_cast<QKeyEvent*>(event)))
      {
        event->ignore(); // the window undoes
        return true;
      }
      if (IsOwnKey(widget, *static_cast<QKeyEvent*>(event)))
      {
        event->accept();
        return true;
      }
      return false;
    default:
      return false;
  }
}
}
