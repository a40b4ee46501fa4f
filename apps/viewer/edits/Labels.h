// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Labels of stages and parameters in the window's spelling.
 */
#ifndef Labels_h
#define Labels_h

#include "vtkRelievoParameter.h"
#include "vtkRelievoParameterList.h"

#include <QString>

class QFormLayout;
class QWidget;

namespace viewer
{
/// Turns "Colored Shadows" into "Coloured shadows".
QString WriteLabel(const QString& label);

/// Explains why a stage did not run, in the viewer's terms; by the reason's code.
QString WriteReason(const QString& code, const QString& reason);

/// The condition of a value's effect: "Has an effect where Method is exact."
QString WriteCondition(
  const vtkRelievoParameterList& list, const vtkRelievoParameter::Condition& condition);

/// Disables a control without effect and its label, and puts the reason before its tool tip. Empty:
/// enabled.
void SetIdle(QWidget* edit, const QString& why);

/// Adds a row with the parameter's label and one tool tip for label and edit.
void AddParameterRow(QFormLayout* rows, const vtkRelievoParameter& parameter, QWidget* edit);
}

#endif
