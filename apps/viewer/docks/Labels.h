// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Labels of stages and parameters, as the window writes its texts.
 */
#ifndef Labels_h
#define Labels_h

#include <QString>

class QFormLayout;
class QLabel;
class QWidget;
struct vtkRelievoParameter;

namespace viewer
{
/// "Colored Shadows" as "Coloured shadows".
QString WriteLabel(const QString& label);

/// Why a stage did nothing, in the viewer's words; by the code of the reason.
QString WriteReason(const QString& code, const QString& reason);

/// A parameter's choice, such as "reinhard rgb" for "reinhard_rgb".
QString WriteChoice(const QString& choice);

/// A row with the parameter's label, and the edit's tool tip for both. Returns the label.
QLabel* AddParameterRow(QFormLayout* rows, const vtkRelievoParameter& parameter, QWidget* edit);
}

#endif
