// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LinearColor.h"

#include <vtkRelievoColorWords.h>

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace viewer
{
//------------------------------------------------------------------------------
// The sRGB transfer function, IEC 61966-2-1.
QColor ReadLinearColor(const QString& text)
{
  double named[3];
  if (relievo::ReadColor(text.toStdString(), named)) // values as on displays
  {
    return QColor::fromRgbF(named[0], named[1], named[2]);
  }
  const QStringList parts = QString(text).replace(',', '/').split('/');
  int shown[3] = { 255, 255, 255 };
  for (int i = 0; i < 3 && parts.size() == 3; ++i)
  {
    const double light = std::min(std::max(parts[i].toDouble(), 0.0), 1.0);
    shown[i] = static_cast<int>(std::lround(
      255.0 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055)));
  }
  return QColor(shown[0], shown[1], shown[2]);
}

//------------------------------------------------------------------------------
QString WriteLinearColor(const QColor& color)
{
  const int bytes[3] = { color.red(), color.green(), color.blue() };
  QStringList words;
  for (const int byte : bytes)
  {
    const double shown = byte / 255.0;
    const double light = shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
    words += QString::number(light, 'g', 4); // precise enough for 8 bits
  }
  return words.join('/');
}
}
