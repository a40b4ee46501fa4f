// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class pqRelievoStageControls
 * @brief The dock's section for further stages of the frame: a switch each, and its parameters.
 *
 * Made from the view's properties, which are made from the stages' own descriptions: a new stage
 * needs nothing here. Hidden while there is none.
 */
#ifndef pqRelievoStageControls_h
#define pqRelievoStageControls_h

#include "pqRelievoControls.h"

class QVBoxLayout;
class pqProxyWidget;

class pqRelievoStageControls : public pqRelievoControls
{
  Q_OBJECT
  using Superclass = pqRelievoControls;

public:
  explicit pqRelievoStageControls(QWidget* parent = nullptr);

  void SetView(pqView* view) override;

private:
  QVBoxLayout* Rows;
  pqProxyWidget* Properties = nullptr; // of the view
};

#endif
