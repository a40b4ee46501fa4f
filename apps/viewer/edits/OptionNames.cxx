// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionNames.h"

#include "Options.h"

#include <QRegularExpression>

#include <algorithm>

namespace viewer
{
namespace
{
// nullptr: no panel has the option.
const vtkRelievoOption* FindShown(const QString& name)
{
  const vtkRelievoOption* option = scene::GetRenderCommand().Find(name.toStdString());
  return option && !option->Panel.empty() ? option : nullptr;
}
}

//------------------------------------------------------------------------------
OptionName FindOptionName(const QString& option)
{
  const vtkRelievoOption* shown = FindShown(option);
  if (shown && option == "--lamps") // beside the lights of the list
  {
    return { "Lamps from data", QString::fromStdString(shown->Panel) };
  }
  return shown
    ? OptionName{ QString::fromStdString(shown->Label), QString::fromStdString(shown->Panel) }
    : OptionName();
}

//------------------------------------------------------------------------------
QString NameOptions(const QString& text)
{
  // Omits placeholders of values, which are in capitals.
  static const QRegularExpression spelled(
    "(?<![\\w/.-])(--[a-z][a-z-]*[a-z])(?![\\w.-])(?: ([A-Z]+)\\b| ([a-z]+)\\b)?");
  QString named;
  int end = 0;
  for (auto matches = spelled.globalMatch(text); matches.hasNext();)
  {
    const QRegularExpressionMatch match = matches.next();
    const vtkRelievoOption* option = FindShown(match.captured(1));
    if (!option)
    {
      continue;
    }
    const OptionName name = FindOptionName(match.captured(1));
    const QString value = match.captured(3);
    const std::vector<std::string>& words = option->Words;
    const bool known = std::find(words.begin(), words.end(), value.toStdString()) != words.end();
    named += text.mid(end, static_cast<int>(match.capturedStart()) - end) + QChar(0x201c) +
      name.Label + (known ? ": " + value : QString()) + QChar(0x201d) + " in " + name.Panel;
    const bool whole = known || !match.captured(2).isEmpty();
    end = static_cast<int>(whole ? match.capturedEnd() : match.capturedEnd(1));
  }
  return named + text.mid(end);
}
}
