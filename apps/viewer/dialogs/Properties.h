// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The contents of the files, in a window that stays open beside the picture.
 */
#ifndef Properties_h
#define Properties_h

#include <QString>

class QWidget;

namespace viewer
{
/// Creates one window per parent and reuses it with a new text.
void ShowProperties(QWidget* parent, const QString& html);

/// Whether the window is visible.
bool AreShown(QWidget* parent);
}

#endif
