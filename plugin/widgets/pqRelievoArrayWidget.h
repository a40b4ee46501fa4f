// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoArrayWidget
 * @brief A combo box of the point arrays of a representation's data, for properties that hold the
 * name of one (panel_widget "relievo_array").
 *
 * Lists the arrays with the number of components of the hint `<Array components="3"/>`, default 1.
 * Other names can be typed: for example of arrays that appear in a later time step. Empty: none.
 */
#ifndef pqRelievoArrayWidget_h
#define pqRelievoArrayWidget_h

#include "pqPropertyWidget.h"

class QComboBox;

class pqRelievoArrayWidget : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QString array READ GetArray WRITE SetArray NOTIFY arrayChanged)
  typedef pqPropertyWidget Superclass;

public:
  pqRelievoArrayWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqRelievoArrayWidget() override;

  ///@{
  /** The array's name. */
  QString GetArray() const { return this->Array; }
  void SetArray(const QString& array);
  ///@}

Q_SIGNALS:
  void arrayChanged();

private Q_SLOTS:
  void ListArrays();

private:
  Q_DISABLE_COPY(pqRelievoArrayWidget)

  QComboBox* Arrays;
  QString Array;
  int Components = 1; // required components
};

#endif
