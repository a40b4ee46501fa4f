// SPDX-FileCopyrightText: Copyright (c) The Relievo authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionEdits.h"

#include "Number.h"
#include "OptionNames.h"
#include "Options.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSignalBlocker>

namespace viewer
{
//------------------------------------------------------------------------------
void SetOption(scene::Settings& settings, const char* option, const std::string& value)
{
  value.empty() ? settings.Remove(option) : settings.Set(option, value);
}

//------------------------------------------------------------------------------
QComboBox* AddChoice(Document* document, QFormLayout* rows, const char* option,
  const QString& first, const QString& help, const std::map<std::string, QString>& labels)
{
  auto* box = new QComboBox(rows->parentWidget());
  box->setObjectName(QString(option).remove('-'));
  box->setToolTip(help);
  box->addItem(first, "");
  for (const std::string& word : scene::GetRenderCommand().Find(option)->Words)
  {
    const QString data = QString::fromStdString(word);
    const auto label = labels.find(word);
    if (data != first)
    {
      box->addItem(label == labels.end() ? data : label->second, data);
    }
  }
  rows->addRow(FindOptionName(option).Label, box);
  QObject::connect(box, static_cast<void (QComboBox::*)(int)>(&QComboBox::currentIndexChanged),
    document, [document, box, option] {
      document->Change([&](scene::Settings& settings) {
        SetOption(settings, option, box->currentData().toString().toStdString());
      });
    });
  return box;
}

//------------------------------------------------------------------------------
void ShowChoice(QComboBox* box, const scene::Settings& settings, const char* option)
{
  const QSignalBlocker quiet(box);
  const QString words = QString::fromStdString(settings.Get(option));
  if (box->findData(words) < 0)
  {
    box->addItem(words, words);
  }
  box->setCurrentIndex(box->findData(words));
}

//------------------------------------------------------------------------------
QCheckBox* MakeFlag(Document* document, const char* option, QWidget* parent)
{
  auto* box = new QCheckBox(FindOptionName(option).Label, parent);
  box->setObjectName(QString(option).remove('-'));
  QObject::connect(box, &QCheckBox::toggled, document, [document, option](bool on) {
    document->Change(
      [&](scene::Settings& settings) { on ? settings.Set(option, "") : settings.Remove(option); });
  });
  return box;
}

//------------------------------------------------------------------------------
relievoQt::Number* MakeNumber(const char* option, double step, int decimals, QWidget* parent)
{
  const vtkRelievoOption::Bounds& range = scene::GetRenderCommand().Find(option)->Range;
  const double inset = range.Open ? step : 0.0;
  return new relievoQt::Number(range.Least + inset, range.Most - inset, step, decimals, parent);
}

//------------------------------------------------------------------------------
void ShowFlag(QCheckBox* box, const scene::Settings& settings, const char* option)
{
  const QSignalBlocker quiet(box);
  box->setChecked(settings.Has(option));
}
}
