// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Differences between Qt 5 and Qt 6.
 */
#ifndef QtVersions_h
#define QtVersions_h

#include <QCoreApplication>
#include <QDropEvent>

namespace viewer
{
// Draws pictures and controls at the screen's full resolution, as Qt 6 does by default. Call it
// before creating the application.
inline void UseHighDpi()
{
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
#endif
}

// The modifier keys at a drop.
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
