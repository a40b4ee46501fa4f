// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Rows of labels and fields for a narrow dock.
 */
#ifndef Rows_h
#define Rows_h

class QFormLayout;
class QString;
class QWidget;

namespace relievoQt
{
/// The widget's layout, without margins.
QFormLayout* MakeRows(QWidget* parent);

/// Gives labels one width, so that fields of several parts line up.
void AddRow(QFormLayout* rows, const QString& title, QWidget* field);
}

#endif
