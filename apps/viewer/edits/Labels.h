// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Labels of stages and parameters, as the window writes its texts.
 */
#ifndef Labels_h
#define Labels_h

#include "vtkRelievoParameterList.h"

#include <QString>

class QFormLayout;
class QWidget;

namespace viewer
{
/// "Colored Shadows" as "Coloured shadows".
QString WriteLabel(const QString& label);

/// Why a stage did nothing, in the viewer's words; by the code of the reason.
QString WriteReason(const QString& code, const QString& reason);

/// When a value has an effect: "Has an effect where Method is exact."
QString WriteCondition(
  const vtkRelievoParameterList& list, const vtkRelievoParameter::Condition& condition);

/// A control that has no effect now is disabled, its label with it, and says why before its tool
/// tip. Empty: it has one.
void SetIdle(QWidget* edit, const QString& why);

/// A row with the parameter's label, and the edit's tool tip for both.
void AddParameterRow(QFormLayout* rows, const vtkRelievoParameter& parameter, QWidget* edit);
}

#endif
