// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoControls
 * @brief A section of the dock: state and settings of one part of Relievo in a view.
 *
 * Shows and edits the view's properties, and follows changes made elsewhere.
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

  /** The view to control; nullptr for none, or for one without Relievo. */
  virtual void SetView(pqView* view);

  /** A button that shows and hides the other controls, which are hidden at first. */
  static QToolButton* MakeFold(const QString& text, QWidget* rest, QWidget* parent);

public Q_SLOTS:
  /** Shows the view's values. */
  virtual void ShowState();

  /** Updates controls that depend on the view's picture: called after each picture. */
  virtual void ShowScene() {}

protected:
  QVariant Get(const char* name) const;
  bool IsOn(const char* name) const { return this->Get(name).toInt() != 0; }
  void Apply(const QString& label, const QVector<pqRelievoViewSettings::Change>& changes);

  /** Connects a number edit to one of the view's properties. */
  void Bind(relievoQt::Number* number, const char* property, const QString& label);

  /** Connects a combo box to one of the view's properties, whose values are the items' data. */
  void Bind(QComboBox* choice, const char* property, const QString& label);

  /** The style of a section's title. */
  static void MakeHead(QWidget* head);

  /** Indents controls below their switch. */
  static void Indent(QWidget* part);

  QPointer<pqView> View;
  vtkNew<vtkEventQtSlotConnect> Connector;

private:
  void Try(const char* property, double value);
  void Settle(const char* property, double value, const QString& label);

  QMap<relievoQt::Number*, const char*> Numbers;
  QMap<QComboBox*, const char*> Choices;
  QMap<QString, QVariant> Before; // values of properties before the drag of their sliders
};

#endif
