// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the files hold, in a window of its own that stays beside the picture.
 */
#ifndef Properties_h
#define Properties_h

#include <QString>

class QWidget;

namespace viewer
{
/// One for each parent, which is shown again with another text.
void ShowProperties(QWidget* parent, const QString& html);

/// Whether it is seen.
bool AreShown(QWidget* parent);
}

#endif
