// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Converts between colours on displays and words: R/G/B of linear light, or names and #rrggbb.
 */
#ifndef LinearColor_h
#define LinearColor_h

#include <QColor>
#include <QString>

namespace viewer
{
/// White for an invalid text. Light above the display's white is clamped.
QColor ReadLinearColor(const QString& text);

QString WriteLinearColor(const QColor& color);
}

#endif
