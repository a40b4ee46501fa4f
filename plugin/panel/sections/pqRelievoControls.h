// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoControls
 * @brief A section of the dock: what one part of Relievo does in a view, and its switches.
 *
 * Shows the values of the view's properties whenever they change, by whomever, and changes them.
 */
#ifndef pqRelievoControls_h
#define pqRelievoControls_h

#include "pqRelievoViewSettings.h"
#include "pqView.h"

#include <QMap>
#include <QPointer>
#include <QWidget>

#include "vtkEventQtSlotConnect.h"
#include "vtkNew.h"

namespace relievoQt
{
class Number;
}

class QComboBox;
class QToolButton;

class pqRelievoControls : public QWidget
{
  Q_OBJECT
  using Superclass = QWidget;

public:
  explicit pqRelievoControls(QWidget* parent = nullptr);

  /** The view that is controlled; nullptr for none, or one without Relievo. */
  virtual void SetView(pqView* view);

  /** A button that shows and hides the rest, which is hidden at first. */
  static QToolButton* MakeFold(const QString& text, QWidget* rest, QWidget* parent);

public Q_SLOTS:
  /** Shows the view's values. */
  virtual void ShowState();

  /** Shows what depends on what the view shows: after each of its pictures. */
  virtual void ShowScene() {}

protected:
  QVariant Get(const char* name) const;
  bool IsOn(const char* name) const { return this->Get(name).toInt() != 0; }
  void Apply(const QString& label, const QVector<pqRelievoViewSettings::Change>& changes);

  /** Has a number set one of the view's properties, and show it. */
  void Bind(relievoQt::Number* number, const char* property, const QString& label);

  /** Has a choice set one of the view's properties to the data of an item, and show it. */
  void Bind(QComboBox* choice, const char* property, const QString& label);

  /** The look of a section's head. */
  static void MakeHead(QWidget* head);

  /** Controls below what switches them. */
  static void Indent(QWidget* part);

  QPointer<pqView> View;
  vtkNew<vtkEventQtSlotConnect> Connector;

private:
  void Try(const char* property, double value);
  void Settle(const char* property, double value, const QString& label);

  QMap<relievoQt::Number*, const char*> Numbers;
  QMap<QComboBox*, const char*> Choices;
  QMap<QString, QVariant> Before; // of properties whose sliders are dragged
};

#endif
