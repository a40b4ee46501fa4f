// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Options of the command by the names of their controls, for messages: what is said of a picture
 * names options, which nobody typed in the window.
 */
#ifndef OptionNames_h
#define OptionNames_h

#include <QString>
#include <QStringList>

namespace viewer
{
/// Where the window has an option.
struct OptionName
{
  QString Label; ///< of the control, or of its group
  QString Panel; ///< the title; empty: no control has the option
};

OptionName FindOptionName(const QString& option);

/// The text with such names: "--image box" as "Images: box" in quotes, with "in Scene" behind it.
/// Options without a control stay as they are.
QString NameOptions(const QString& text);
}

#endif
