// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoViewWidget
 * @brief A combo box of the window's render views, for properties that hold one (panel_widget
 * "relievo_view").
 */
#ifndef pqRelievoViewWidget_h
#define pqRelievoViewWidget_h

#include "pqPropertyWidget.h"
#include "pqSMProxy.h" // for the property

class QComboBox;

class pqRelievoViewWidget : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(pqSMProxy chosen READ GetChosen WRITE SetChosen NOTIFY chosenChanged)
  typedef pqPropertyWidget Superclass;

public:
  pqRelievoViewWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqRelievoViewWidget() override;

  ///@{
  /** The selected view, or nullptr. */
  pqSMProxy GetChosen() const;
  void SetChosen(const pqSMProxy& view);
  ///@}

Q_SIGNALS:
  void chosenChanged();

private Q_SLOTS:
  void ListViews();

private:
  Q_DISABLE_COPY(pqRelievoViewWidget)

  QComboBox* Views;
  pqSMProxy Chosen;
};

#endif
