// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Labels of stages and parameters, and amounts, as the window writes its texts.
 */
#ifndef Labels_h
#define Labels_h

#include <QString>

namespace viewer
{
/// "Colored Shadows" as "Coloured shadows".
QString WriteLabel(const QString& label);

/// "14.73 MiB".
QString WriteBytes(double bytes);
}

#endif
