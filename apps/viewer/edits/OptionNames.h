// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Replaces options in messages by the names of their controls, because users of the window do not
 * type options.
 */
#ifndef OptionNames_h
#define OptionNames_h

#include <QString>
#include <QStringList>

namespace viewer
{
/// The control of an option.
struct OptionName
{
  QString Label; ///< of the control, or of its group
  QString Panel; ///< title; empty: no control for the option
};

OptionName FindOptionName(const QString& option);

/// The text with replaced names: "--image box" becomes "Images: box" in quotes, followed by "in
/// Scene". Options without a control stay unchanged.
QString NameOptions(const QString& text);
}

#endif
