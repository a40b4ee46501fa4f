// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Light or dark controls, or those of the desktop.
 */
#ifndef Appearance_h
#define Appearance_h

class QMenu;

namespace viewer
{
/// Adds the choice to a menu, and applies the stored one.
void AddAppearance(QMenu* menu);
}

#endif
