// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is wanted most, as buttons above the picture. The menu bar's actions must be there already.
 */
#ifndef ToolBar_h
#define ToolBar_h

class QMenu;

namespace viewer
{
class MainWindow;

/// The menu gets an entry that hides and shows it.
void AddToolBar(MainWindow* window, QMenu* view);
}

#endif
