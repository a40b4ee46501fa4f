// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Signs for buttons, in the colour of the controls' text, be they light or dark.
 */
#ifndef Icons_h
#define Icons_h

#include <QIcon>

namespace viewer
{
/// By the name of what it stands for, such as "open"; empty for a name that there is not.
QIcon MakeIcon(const QString& name);
}

#endif
