// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Icons for buttons, in the colour of the controls' text, light or dark.
 */
#ifndef Icons_h
#define Icons_h

#include <QIcon>

namespace viewer
{
/// By name, such as "open"; empty for an unknown name.
QIcon MakeIcon(const QString& name);
}

#endif
