// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colours as screens show them, and as words: R/G/B of linear light, or names and #rrggbb.
 */
#ifndef LinearColor_h
#define LinearColor_h

#include <QColor>
#include <QString>

namespace viewer
{
/// White for a text that is no such colour. What is brighter than the screen is cut off.
QColor ReadLinearColor(const QString& text);

QString WriteLinearColor(const QColor& color);
}

#endif
