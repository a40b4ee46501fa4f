// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Labels.h"

#include <QStringList>

namespace viewer
{
//------------------------------------------------------------------------------
QString WriteLabel(const QString& label)
{
  QStringList words = label.split(' ');
  for (int i = 0; i < words.size(); ++i)
  {
    QString& word = words[i];
    word.replace("Color", "Colour").replace("color", "colour");
    const bool name = word.size() < 2 || word.mid(1) != word.mid(1).toLower(); // such as "GPU"
    word = i == 0 || name ? word : word.toLower();
  }
  return words.join(' ');
}
}
