// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Buttons above the picture for frequent actions. Create the menu bar first.
 */
#ifndef ToolBar_h
#define ToolBar_h

class QMenu;

namespace viewer
{
class MainWindow;

/// Adds a menu entry that hides and shows the tool bar.
void AddToolBar(MainWindow* window, QMenu* view);
}

#endif
