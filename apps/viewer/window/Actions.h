// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The window's menus and keys.
 */
#ifndef Actions_h
#define Actions_h

namespace viewer
{
class RecentFiles;
class MainWindow;

void AddActions(MainWindow* window, RecentFiles* recent);
}

#endif
