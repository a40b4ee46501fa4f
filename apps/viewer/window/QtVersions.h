// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the viewer says differently to Qt 5 and to Qt 6.
 */
#ifndef QtVersions_h
#define QtVersions_h

#include <QCoreApplication>
#include <QDropEvent>

namespace viewer
{
// Pictures and controls of as many pixels as the screen has: Qt 6 does so by itself. Call it before
// the application is made.
inline void UseHighDpi()
{
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
}

// The keys that were held when something was dropped.
inline Qt::KeyboardModifiers GetModifiers(const QDropEvent& event)
{
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  return event.keyboardModifiers();
#else
  return event.modifiers();
#endif
}
}

#endif
