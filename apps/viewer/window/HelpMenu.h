// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The menu of help: a sheet of the keys, made from the window's actions, and what draws here.
 */
#ifndef HelpMenu_h
#define HelpMenu_h

namespace viewer
{
class MainWindow;

/// After all other menus, whose keys the sheet lists.
void AddHelpMenu(MainWindow* window);
}

#endif
