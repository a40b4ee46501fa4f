// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "InputGuard.h"

#include "Document.h"
#include "Panel.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDial>
#include <QGroupBox>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
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

// The control that a widget belongs to, such as the spin box of a line edit.
QWidget* FindTurned(QWidget* widget)
{
  while (widget && !IsTurnedByWheel(widget))
  {
    widget = widget->isWindow() ? nullptr : widget->parentWidget();
  }
  return widget;
}

bool IsTurningKey(QWidget* control, const QKeyEvent& event)
{
  switch (event.key())
  {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
      return qobject_cast<QAbstractSlider*>(control) != nullptr;
    default:
      return false;
  }
}

bool IsModifier(const QKeyEvent& event)
{
  return event.key() == Qt::Key_Shift || event.key() == Qt::Key_Control ||
    event.key() == Qt::Key_Alt || event.key() == Qt::Key_Meta;
}

bool IsInPanel(QWidget* widget)
{
  while (widget && !qobject_cast<Panel*>(widget))
  {
    widget = widget->parentWidget();
  }
  return widget != nullptr;
}

// Text fields handle letters themselves.
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

// Tables copy their current cell, labels their selected text. Text fields handle the key anyway.
bool IsOwnCopy(QWidget* widget, const QKeyEvent& event)
{
  auto* view = qobject_cast<QAbstractItemView*>(widget);
  auto* label = qobject_cast<QLabel*>(widget);
  return event.matches(QKeySequence::Copy) &&
    ((view && view->selectionModel() && view->selectionModel()->hasSelection()) ||
      (label && label->hasSelectedText()));
}

// Text fields undo typing; without any, they ignore the keys.
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
        widget->setFocusPolicy(Qt::StrongFocus); // no focus by the wheel
      }
      return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick: // the second press of two
      this->Held = true;
      this->Turned = nullptr;
      this->Edit = this->Edited->BeginEdit();
      return false;
    case QEvent::MouseButtonRelease:
    {
      // Controls may change once more after release, by a timer.
      this->Held = false;
      const auto end = [this, edit = this->Edit] { this->Edited->EndEdit(edit); };
      QTimer::singleShot(
        0, this->Edited, [this, end] { QTimer::singleShot(0, this->Edited, end); });
      return false;
    }
    case QEvent::Wheel:
      if (IsTurnedByWheel(widget) && IsInPanel(widget) && !widget->hasFocus())
      {
        event->ignore(); // passed on to the panel
        return true;
      }
      this->Turn(FindTurned(widget));
      return false;
    case QEvent::FocusOut:
      if (widget == this->Turned)
      {
        this->Stop();
      }
      return false;
    case QEvent::KeyPress:
      this->TakeKey(*static_cast<QKeyEvent*>(event));
      return false;
    case QEvent::ShortcutOverride: // the only one of keys that are shortcuts
      this->TakeKey(*static_cast<QKeyEvent*>(event));
      if (IsIdleUndo(widget, *static_cast<QKeyEvent*>(event)))
      {
        event->ignore(); // the window undoes
        return true;
      }
      if (IsOwnKey(widget, *static_cast<QKeyEvent*>(event)) ||
        IsOwnCopy(widget, *static_cast<QKeyEvent*>(event)))
      {
        event->accept();
        return true;
      }
      return false;
    default:
      return false;
  }
}

//------------------------------------------------------------------------------
// Parents receive the same key again if a control ignores it.
void InputGuard::TakeKey(const QKeyEvent& key)
{
  QWidget* control = FindTurned(QApplication::focusWidget());
  if (!IsModifier(key))
  {
    this->Turn(control && IsTurningKey(control, key) ? control : nullptr);
  }
}

//------------------------------------------------------------------------------
// Any other action ends the edit.
void InputGuard::Turn(QWidget* control)
{
  if (!control)
  {
    this->Stop();
  }
  else if (!this->Held && this->Turned != control)
  {
    this->Turned = control;
    this->Edit = this->Edited->BeginEdit();
  }
}

//------------------------------------------------------------------------------
void InputGuard::Stop()
{
  if (!this->Held)
  {
    this->Turned = nullptr;
    this->Edited->EndEdit(this->Edit);
  }
}
}
