// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Labels of stages and parameters, as the window writes its texts.
 */
#ifndef Labels_h
#define Labels_h

#include <QString>

namespace viewer
{
/// "Colored Shadows" as "Coloured shadows".
QString WriteLabel(const QString& label);
}

#endif
