// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The help menu: a sheet of the keys, made from the window's actions, and the versions.
 */
#ifndef HelpMenu_h
#define HelpMenu_h

namespace viewer
{
class MainWindow;

/// Call after creating all other menus, whose keys the sheet lists.
void AddHelpMenu(MainWindow* window);
}

#endif
